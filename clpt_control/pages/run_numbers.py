"""What a run achieved, of what it carries: nothing is run again.

`clpt run` and `clpt paper` leave their figures in the run, mean squares over 2000 samples a cycle.
Of another run they are those of its own samples.
"""

import json
from typing import TYPE_CHECKING, Any

import numpy as np

from ..scenario.experiment import Scenario
from ..simulation.report import SUMMARY, clpe_of_samples, errors

if TYPE_CHECKING:
    import xarray


MOST_SAMPLES = 6000  # in a figure


def numbers_of(run: "xarray.Dataset", scenario: Scenario) -> dict[str, Any]:
    """Return a run's figures by the names of `run_and_report`; `of_samples` if they are less."""
    try:
        found = json.loads(str(run.attrs.get(SUMMARY, "null")))
    except ValueError:
        found = None
    end = float(run.time[-1])
    known = isinstance(found, dict) and found.get("end") == end
    if known and f"{end:g}" in found.get("max_gain_error", {}):
        return {**found, "of_samples": False}
    at = {f"{end:g}": run.isel(time=-1)}
    clpe = clpe_of_samples(scenario, run)
    return {"of_samples": True, "end": end, **clpe, **errors(scenario, run, at)}


def shown_samples(run: "xarray.Dataset") -> "tuple[xarray.Dataset, str]":
    """Return as many samples of a run as a figure shows, and a sentence if they are not all."""
    count = run.sizes["time"]
    step = -(-count // MOST_SAMPLES)
    if step == 1:
        return run, ""
    few = run.isel(time=np.unique([*range(0, count, step), count - 1]))
    few.encoding.update(run.encoding)
    return few, f" Drawn from 1 in {step} of {count} samples."


def at_end(by_time: dict[str, float]) -> float:
    """Return the last of values by time."""
    return list(by_time.values())[-1]
