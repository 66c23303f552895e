"""Choose law, gains and filter by an ensemble of flows that nobody was told.

missed   median of the largest flow-parameter error at the end, over that at the start
astray   median CLPE rms over the last cycle, over prior/k, how far a flow of that size drives
score    (missed astray)^(1/2);  time: median until the error stays below a tenth of the first

Of the candidates whose runs all reach the end, those count as equal whose score is within a
fifth of the best; the quickest of them is taken, then the one with the better score.

What the track shows: a parameter error of length 1 is a flow of rms (kappa_1/T)^(1/2) at least
along a window T, kappa_1 being the smallest eigenvalue of the joint Gramian over it.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from ..base.arguments import public
from ..base.errors import ClptError, ScenarioError, needed
from ..base.units import known
from ..paper.laws.law import Law
from ..paper.laws.table import LAWS
from ..paper.scenario.experiment import Scenario
from ..theory.design.track_design import time_below
from ..theory.design.waypoint_tracks import Tracks
from ..theory.excitation.regressor import checked_window
from .candidates import (
    Candidate,
    Unknown,
    belief,
    candidate,
    factors_of,
    laws_to_try,
    unknown_of,
)
from .run import run_ensemble

NEAR = 1.2  # times the best score: as good
FINALISTS = 3  # laws whose gain and filter are varied
ENOUGH = 1e-3  # less needs not be
TENTH = 0.1  # of the first error: it ends the learning time
MARKS = 200  # times at which errors are looked at
HIDDEN = 1e-3  # a track that shows less of an error hides it


class Score(NamedTuple):
    """Score of one candidate over the members."""

    candidate: Candidate
    error: (
        float  # median of the largest flow-parameter error at the end, length per time
    )
    error_95: float  # 95 % of the members are below
    clpe_rms: float  # median CLPE rms over the last cycle, length
    learning_time: float  # median learning time; inf: not within the run
    score: float
    failed: int  # members that did not reach the end


@dataclass(frozen=True)
class Tuned:
    """Result of `tune_law`."""

    scenario: Scenario  # the given one with the law, gains and filter chosen
    report: dict[str, Any]  # ready for JSON


@public
def tune_law(
    scenario: Scenario,
    *,
    members: int = 24,
    prior: float | None = None,
    unmodelled: float | None = None,
    laws: Iterable[str] = (),
    seed: int = 0,
    progress: Callable[[float], None] | None = None,
) -> Tuned:
    """Choose law, gains and filter for a flow that is not known.

    Flow parameters are drawn about what the learner believes, the scenario's noise anew for each
    draw, and every candidate runs on the same draws. The scenario's own theta or field is taken
    out first.

    Parameters
    ----------
    scenario : Scenario
        Vehicle, track, basis, disturbance and noise to expect.
    members : int, optional
        How many flows are drawn.
    prior : float, optional
        Standard deviation of each flow parameter, length per time; 0.3 k R without, k the mean
        feedback and R the reach of the track.
    unmodelled : float, optional
        Rms of a flow beside the basis, length per time, held for a dwell; the scenario's
        disturbance without.
    laws : iterable of str, optional
        Laws to compare; all of the table without.
    seed : int, optional
        Of the draws.
    progress : callable, optional
        Called with the share of the work done.

    Returns
    -------
    Tuned
        `scenario` with the choice, and `report`: candidates by rank, `chosen`, `because`.

    Raises
    ------
    ScenarioError
        If an argument is not allowed or no candidate reaches the end of its runs.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 40})
    >>> tuned = clpt.ensemble.tune_law(scenario, members=4, laws=["learned-flow", "sigma"])
    >>> tuned.report["chosen"]["law"] in ("learned-flow", "sigma")
    True
    """
    if scenario.learning.row.at_fixes:
        raise ScenarioError(
            f'learning.law = "{scenario.learning.law}": is the only law that learns at fixes; '
            "nothing is to choose, and its settings vary in an ensemble"
        )
    names = tuple(laws)
    for name in names:
        if name not in LAWS:
            raise ScenarioError(f"laws: '{name}' is no law; `clpt laws` lists them")
    for word, value, least, most in (
        ("members", members, 3, 10**5),
        ("seed", seed, 0, 2**31),
    ):
        if not least <= value <= most:
            raise ScenarioError(
                f"{word} = {value}: must be a whole number, {least} to {most}"
            )
    needed("zarr")
    unknown = unknown_of(scenario, prior, unmodelled, members)
    tried, skipped = laws_to_try(names)
    if not tried:
        raise ScenarioError(
            f"laws: none of {', '.join(names)} learns the flow; name another"
        )
    report = progress or (lambda share: None)
    scores: list[Score] = []

    def score(law: Law, held: bool, *factors: float) -> None:
        name = law.name
        try:
            one = candidate(scenario, law, held, *factors)
            name = one.text
            scores.append(score_of(unknown, one, members, seed))
        except ClptError as error:
            skipped[name] = str(error).removeprefix("scenario: ")

    for k, law in enumerate(tried):
        report(0.5 * k / len(tried))
        for held in (False, True):
            score(law, held)
    finalists: dict[str, Candidate] = {}  # the best of each law
    for each in ranked(scores):
        finalists.setdefault(each.candidate.law, each.candidate)
    few = list(finalists.values())[:FINALISTS]
    grid = [(best, factors) for best in few for factors in factors_of(best)]
    for k, (best, factors) in enumerate(grid):
        report(0.5 + 0.5 * k / len(grid))
        score(LAWS[best.law], best.held, *factors)
    order = ranked(scores)
    if not order:
        reasons = "; ".join(f"{name}: {why}" for name, why in list(skipped.items())[:2])
        raise ScenarioError(
            f"no candidate reaches the end of its runs{': ' if reasons else ''}{reasons}; give a "
            "smaller prior or a shorter run"
        )
    report(1.0)
    chosen, enough = order[0], NEAR * min(one.score for one in order)
    failed = sorted(
        (one for one in scores if one.failed), key=lambda one: one.candidate.text
    )
    summary = {
        "title": scenario.title,
        "units": scenario.units.model_dump(),
        "members": members,
        "seed": seed,
        "prior": unknown.prior,
        "belief": belief(scenario).tolist(),
        "unmodelled": unknown.unmodelled,
        "noise": unknown.noise,
        **excitation_of_track(unknown.scenario),
        "chosen": as_json(chosen),
        "as_good": sum(one.score <= enough for one in order),
        "candidates": [as_json(one) for one in (*order, *failed)],
        "skipped": skipped,
    }
    summary["because"] = because(summary, chosen.candidate.text)
    return Tuned(scenario.with_values(chosen.candidate.values), summary)


def ranked(scores: list[Score]) -> list[Score]:
    """Return scores without a failed member, the one to take first."""
    whole = [one for one in scores if not one.failed and np.isfinite(one.score)]
    enough = NEAR * min((one.score for one in whole), default=0.0)

    def place(one: Score) -> tuple[Any, ...]:
        near = one.score <= enough
        time = one.learning_time if near else 0.0
        return not near, time, one.score, one.error * one.clpe_rms

    return sorted(whole, key=place)


# --- how well a candidate learns flows that it was not told: medians over an ensemble ------------


def score_of(unknown: Unknown, candidate: Candidate, members: int, seed: int) -> Score:
    """Run a candidate on flows that are drawn, the same for every candidate."""
    scenario = unknown.scenario.with_values(candidate.values)
    marks = np.linspace(0.0, scenario.run.duration, MARKS + 1)
    data = run_ensemble(
        scenario, unknown.varies, members, seed=seed, times=marks.tolist()
    )
    failed = int(np.sum(data["status"].values != 1))
    error = data["flow_parameter_error"].values
    cycles = data["clpe_rms"].values
    clpe = cycles[:, -1] if cycles.shape[1] else data["clpe_rms_whole"].values
    last = np.where(np.isfinite(error[:, -1]), error[:, -1], np.inf)
    astray = np.where(np.isfinite(clpe), clpe, np.inf)
    times = [time_below(data["mark"].values, row, TENTH * row[0]) for row in error]
    k = float(np.mean(scenario.vehicle.feedback))
    middle, rms = _middle(last), _middle(astray)
    shares = (middle / max(_middle(error[:, 0]), 1e-300), rms * k / unknown.prior)
    return Score(
        candidate,
        middle,
        _middle(last, 0.95),
        rms,
        _middle(np.array([np.inf if one is None else one for one in times])),
        float(np.sqrt(np.prod(np.maximum(shares, ENOUGH)))),
        failed,
    )


def _middle(values: np.ndarray, share: float = 0.5) -> float:
    """Return a quantile of values that may be infinite."""
    return float(
        np.sort(values)[min(len(values) - 1, int(np.ceil(share * len(values)) - 1))]
    )


# --- why a law was chosen -------------------------------------------------------------------------


def excitation_of_track(scenario: Scenario) -> dict[str, Any]:
    """Return the smallest eigenvalue over the second cycle, in the scenario's flow."""
    window, start = span = checked_window(scenario, None, None)
    least, _ = Tracks(scenario, span, scenario.run.duration, 3, 1e-8)(
        scenario.waypoints[None]
    )
    return {"window": window, "start": start, "smallest_eigenvalue": float(least.min())}


def as_json(one: Score) -> dict[str, Any]:
    """Return a score ready for JSON; None for what is infinite."""
    values = one.candidate._asdict() | one._asdict()
    return {k: known(v) for k, v in values.items() if k not in ("values", "candidate")}


def because(report: dict[str, Any], named: str) -> str:
    """Return in a sentence why the choice was made, with its numbers."""
    unit, time = report["units"]["length"], report["units"]["time"]
    speed, chosen = f"{unit}/{time}", report["chosen"]
    least = report["smallest_eigenvalue"]
    share = (least / report["window"]) ** 0.5
    shows = "shows every parameter" if share > HIDDEN else "hides some parameters"
    strange, noise = report["unmodelled"], report["noise"]
    flow = (
        f"unmodelled flow of {strange:.3g} {speed}" if strange else "no unmodelled flow"
    )
    fixes = (
        f"positions with noise of {noise:.3g} {unit}" if noise else "exact positions"
    )
    soon = chosen["learning_time"]
    came = (
        "does not fall to a tenth"
        if soon is None
        else f"is a tenth after {soon:.4g} {time}"
    )
    first = (
        ""
        if report["as_good"] == 1
        else f"the quickest of {report['as_good']} as good, "
    )
    return (
        f"{named}: {first}because the track {shows} (smallest eigenvalue {least:.3g} over "
        f"{report['window']:g} {time}: {share:.1g} of an error is seen), and with {flow} and "
        f"{fixes} the error of {report['members']} drawn flows, in the middle, {came} and ends at "
        f"{chosen['error']:.2g} {speed}, CLPE rms at {chosen['clpe_rms']:.2g} {unit}"
    )
