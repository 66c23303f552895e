"""How well a candidate learns flows that it was not told: medians over an ensemble.

missed   median of the largest flow-parameter error at the end, over the prior
astray   median CLPE rms over the last cycle, over prior/k, how far a flow of that size drives
score    missed + astray;  time: median until the error stays below a tenth of the prior

What the track shows: a parameter error of length 1 is a flow of rms (kappa_1/T)^(1/2) at least
along a window T, kappa_1 being the smallest eigenvalue of the joint Gramian over it.
"""

from typing import Any, NamedTuple

import numpy as np

from ..scenario.experiment import Scenario
from ..theory.designing.tracks import Tracks
from .candidates import Candidate, Unknown
from .run import run_ensemble

ENOUGH = 1e-3  # less needs not be
TENTH = 0.1  # of the first error: it ends the learning time
MARKS = 200  # times at which errors are looked at
SAMPLES = 200  # a cycle
HIDDEN = 1e-3  # a track that shows less of an error hides it


class Score(NamedTuple):
    """What one candidate reached over the members."""

    candidate: Candidate
    error: float  # median of the largest flow-parameter error at the end, length per time
    error_95: float  # 95 % of the members are below
    clpe: float  # median CLPE rms over the last cycle, length
    time: float  # median learning time; inf: not within the run
    score: float
    failed: int  # members that did not reach the end


def score_of(unknown: Unknown, candidate: Candidate, members: int, seed: int) -> Score:
    """Run a candidate on flows that are drawn, the same for every candidate."""
    scenario = unknown.scenario.with_values(candidate.values)
    marks = np.linspace(0.0, scenario.run.duration, MARKS + 1)
    data = run_ensemble(
        scenario, unknown.varies, members, seed=seed, samples=SAMPLES, times=marks.tolist()
    )
    failed = int(np.sum(data["status"].values != 1))
    error = data["flow_parameter_error"].values
    cycles = data["clpe_rms"].values
    clpe = cycles[:, -1] if cycles.shape[1] else data["clpe_rms_whole"].values
    last = np.where(np.isfinite(error[:, -1]), error[:, -1], np.inf)
    astray = np.where(np.isfinite(clpe), clpe, np.inf)
    times = [_below(data["mark"].values, row, TENTH * row[0]) for row in error]
    k = float(np.mean(scenario.vehicle.feedback))
    middle, rms = _middle(last), _middle(astray)
    shares = (middle / max(_middle(error[:, 0]), 1e-300), rms * k / unknown.prior)
    return Score(
        candidate,
        middle,
        _middle(last, 0.95),
        rms,
        _middle(np.array(times)),
        float(np.sqrt(np.prod(np.maximum(shares, ENOUGH)))),
        failed,
    )


def _middle(values: np.ndarray, share: float = 0.5) -> float:
    """Return a quantile of values that may be infinite."""
    return float(np.sort(values)[min(len(values) - 1, int(np.ceil(share * len(values)) - 1))])


def _below(times: np.ndarray, values: np.ndarray, level: float) -> float:
    """Return the first mark from which on all values are at most a level, or inf."""
    above = np.flatnonzero(~(values <= level))
    if not len(above):
        return float(times[0])
    return float(times[above[-1] + 1]) if above[-1] < len(times) - 1 else np.inf


# --- why a law was chosen -------------------------------------------------------------------------


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
