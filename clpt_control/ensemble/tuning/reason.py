"""Why a law was chosen, in a sentence with its numbers.

What the track shows: a parameter error of length 1 is a flow of rms (kappa_1/T)^(1/2) at least
along a window T, kappa_1 being the smallest eigenvalue of the joint Gramian over it.
"""

from typing import Any

import numpy as np

from ...scenario.experiment import Scenario
from ...theory.designing.tracks import Tracks
from .candidates import Candidate
from .scores import Score

HIDDEN = 1e-3  # a track that shows less of an error hides it


def seen(scenario: Scenario) -> dict[str, Any]:
    """Return the smallest eigenvalue over the second cycle, in the scenario's flow."""
    end = scenario.run.duration
    window = min(scenario.cycle, end)
    start = max(0.0, min(scenario.cycle, end - window))
    least, _ = Tracks(scenario, (window, start), end, 3, 1e-8)(scenario.waypoints[None])
    return {"window": window, "start": start, "smallest_eigenvalue": float(least.min())}


def listed(one: Score) -> dict[str, Any]:
    """Return a score ready for JSON; None for what is infinite."""
    made = one.candidate
    values = {"error": one.error, "error_95": one.error_95, "clpe_rms": one.clpe}
    values |= {"learning_time": one.time, "score": one.score}
    return {
        "law": made.law,
        "gain": made.gain,
        "held": made.held,
        "filter": made.filter,
        **{key: value if np.isfinite(value) else None for key, value in values.items()},
        "failed": one.failed,
    }


def because(report: dict[str, Any]) -> str:
    """Return in a sentence why the choice was made, with its numbers."""
    unit, time = report["units"]["length"], report["units"]["time"]
    speed, chosen, own = f"{unit}/{time}", report["chosen"], report["own"]
    named = Candidate(chosen["law"], chosen["gain"], chosen["held"], chosen["filter"], {}).text
    least = report["smallest_eigenvalue"]
    share = (least / report["window"]) ** 0.5
    shows = "shows every parameter" if share > HIDDEN else "hides some parameters"
    strange, noise = report["unmodelled"], report["noise"]
    flow = f"unmodelled flow of {strange:.3g} {speed}" if strange else "no unmodelled flow"
    fixes = f"positions with noise of {noise:.3g} {unit}" if noise else "exact positions"
    soon = chosen["learning_time"]
    came = "does not fall to a tenth" if soon is None else f"is a tenth after {soon:.4g} {time}"
    first = "" if report["as_good"] == 1 else f"the quickest of {report['as_good']} as good, "
    beside = ""
    if own is not None and own["error"] is not None:
        beside = f"; {own['law']} ends at {own['error']:.2g} {speed}, {own['clpe_rms']:.2g} {unit}"
    return (
        f"{named}: {first}because the track {shows} (smallest eigenvalue {least:.3g} over "
        f"{report['window']:g} {time}: {share:.1g} of an error is seen), and with {flow} and "
        f"{fixes} the error of {report['members']} drawn flows, in the middle, {came} and ends at "
        f"{chosen['error']:.2g} {speed}, CLPE rms at {chosen['clpe_rms']:.2g} {unit}{beside}"
    )
