"""What a run achieved, of what it carries: nothing is run again.

`clpt run` and `clpt paper` leave their figures in the run, mean squares over 2000 samples a cycle.
Of another run they are those of its own samples.
"""

import json
from typing import TYPE_CHECKING, Any

import numpy as np

from ..scenario.experiment import Scenario
from ..simulation.report import SUMMARY, gain_error, parameter_error

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
    if isinstance(found, dict) and found.get("end") == end:
        return {**found, "of_samples": False}
    size = np.hypot(*run.clpe.values.T)
    times, cycle = run.time.values, scenario.cycle
    count = int(np.floor(end / cycle * (1 + 1e-12)))
    rounds = [size[(times >= k * cycle) & (times < (k + 1) * cycle)] for k in range(count)]
    last = run.isel(time=-1)
    key = f"{end:g}"
    numbers: dict[str, Any] = {
        "of_samples": True,
        "end": end,
        "clpe_rms_per_cycle": [_rms(one) for one in rounds if len(one)],
        "clpe_rms": _rms(size),
        "clpe_rms_last_quarter": _rms(size[times >= times[0] + 0.75 * (end - times[0])]),
        "max_gain_error": {key: gain_error(scenario, last)},
    }
    if "flow_parameters" in run:
        numbers["max_flow_parameter_error"] = {key: parameter_error(scenario, last)}
    if scenario.flow.field is not None:
        from ..simulation.flows import explained_variance

        numbers["explained_variance"] = explained_variance(scenario, run)
    return numbers


def _rms(values: np.ndarray) -> float:
    return float(np.sqrt(np.mean(values**2)))


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
