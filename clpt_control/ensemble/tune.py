"""Choice of law, gains and filter by an ensemble of sampled flows.

missed   median of the largest flow-parameter error at the end, relative to that at the start
astray   median CLPE rms over the last cycle, relative to prior/k, the drift by a flow of that size
score    (missed astray)^(1/2);  time: median until the error stays below a tenth of its start

Only candidates whose runs all reach the end are compared.  Scores within a fifth of the best are
equally good; of these the fastest candidate is chosen, then the one with the better score.

Identifiability on the track: a parameter error of length 1 is a flow of rms (kappa_1/T)^(1/2) at
least along a window T, where kappa_1 is the smallest eigenvalue of the joint Gramian over T.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from ..base.arguments import check_known, public
from ..base.errors import ClptError, ScenarioError
from ..base.units import finite_or_none
from ..paper.laws.law import Law
from ..paper.laws.table import LAWS
from ..paper.scenario.experiment import Scenario
from ..theory.design.track_design import time_below
from ..theory.design.waypoint_tracks import Tracks
from ..theory.excitation.regressor import checked_window
from .candidates import (
    LawDesign,
    Unknown,
    belief,
    candidate,
    factors_of,
    laws_to_try,
    unknown_of,
)
from .run import run_ensemble

NEAR = 1.2  # times the best score: equally good
FINALISTS = 3  # laws whose gain and filter are varied
ENOUGH = 1e-3  # smaller missed or astray is not better
TENTH = 0.1  # share of the initial error that ends the learning time
MARKS = 200  # times of errors
HIDDEN = (
    1e-3  # smaller share of an error that is visible: the track hides the parameter
)


class Score(NamedTuple):
    """Score of one candidate over the members."""

    candidate: LawDesign
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

    Flow parameters are sampled about the learner's initial estimate, with new noise for each
    sample, and every candidate runs on the same samples. The scenario's theta or field is not used.

    Parameters
    ----------
    scenario : Scenario
        Vehicle, track, basis, disturbance and noise to expect.
    members : int, optional
        Number of sampled flows.
    prior : float, optional
        Standard deviation of each flow parameter, length per time. Default: 0.3 k R, k the mean
        feedback and R the reach of the track.
    unmodelled : float, optional
        Rms of a flow outside the basis, length per time, constant for a dwell. Default: the
        scenario's disturbance.
    laws : iterable of str, optional
        Laws to compare. Default: all laws.
    seed : int, optional
        Seed of the samples.
    progress : callable, optional
        Called with the completed share of the work.

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
    >>> tuned = clpt.tune_law(scenario, members=4, laws=["learned-flow", "sigma"])
    >>> tuned.report["chosen"]["law"] in ("learned-flow", "sigma")
    True
    """
    if scenario.learning.row.at_fixes:
        raise ScenarioError(
            f'learning.law = "{scenario.learning.law}": is the only law that learns at fixes; '
            "nothing is to choose, and its settings vary in an ensemble"
        )
    names = tuple(laws)
    check_known("laws", names, LAWS)
    for word, value, least, most in (
        ("members", members, 3, 10**5),
        ("seed", seed, 0, 2**31),
    ):
        if not least <= value <= most:
            raise ScenarioError(
                f"{word} = {value}: must be a whole number, {least} to {most}"
            )
    unknown = unknown_of(scenario, prior, unmodelled, members)
    tested, skipped = laws_to_try(names)
    if not tested:
        raise ScenarioError(
            f"laws: none of {', '.join(names)} learns the flow. Name another"
        )
    report = progress or (lambda share: None)
    scores = []

    def test(law: Law, gains_fixed: bool, *factors: float) -> None:
        name = law.name
        try:
            design = candidate(scenario, law, gains_fixed, *factors)
            name = design.text
            scores.append(score_of(unknown, design, members, seed))
        except ClptError as error:
            skipped[name] = str(error).removeprefix("scenario: ")

    # 1. each law with its defaults
    for k, law in enumerate(tested):
        report(0.5 * k / len(tested))
        for gains_fixed in (False, True):
            test(law, gains_fixed)
    # 2. the best laws on a grid of gains and filters
    finalists: dict[str, LawDesign] = {}  # the best of each law
    for score in ranked(scores):
        finalists.setdefault(score.candidate.law, score.candidate)
    best_few = list(finalists.values())[:FINALISTS]
    grid = [(best, factors) for best in best_few for factors in factors_of(best)]
    for k, (best, factors) in enumerate(grid):
        report(0.5 + 0.5 * k / len(grid))
        test(LAWS[best.law], best.held, *factors)
    # 3. the choice
    order = ranked(scores)
    if not order:
        reasons = "; ".join(f"{name}: {why}" for name, why in list(skipped.items())[:2])
        raise ScenarioError(
            f"no candidate reaches the end of its runs{': ' if reasons else ''}{reasons}. Give a "
            "smaller prior or a shorter run"
        )
    report(1.0)
    chosen = order[0]
    enough = NEAR * min(score.score for score in order)
    failed = [score for score in scores if score.failed]
    failed.sort(key=lambda score: score.candidate.text)
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
        "as_good": sum(score.score <= enough for score in order),
        "candidates": [as_json(score) for score in (*order, *failed)],
        "skipped": skipped,
    }
    summary["because"] = because(summary, chosen.candidate.text)
    return Tuned(scenario.with_values(chosen.candidate.values), summary)


def ranked(scores: list[Score]) -> list[Score]:
    """Return the scores without failed members, best first."""
    finished = [
        score for score in scores if not score.failed and np.isfinite(score.score)
    ]
    enough = NEAR * min((score.score for score in finished), default=0.0)

    def sort_key(score: Score) -> tuple[Any, ...]:
        is_good = score.score <= enough
        time = score.learning_time if is_good else 0.0
        return not is_good, time, score.score, score.error * score.clpe_rms

    return sorted(finished, key=sort_key)


# --- score of a candidate: medians over an ensemble ----------------------------------------------


def score_of(unknown: Unknown, candidate: LawDesign, members: int, seed: int) -> Score:
    """Run a candidate on the sampled flows, the same for every candidate, and return its score."""
    scenario = unknown.scenario.with_values(candidate.values)
    marks = np.linspace(0.0, scenario.run.duration, MARKS + 1)
    data = run_ensemble(
        scenario, unknown.varies, members, seed=seed, times=marks.tolist()
    )
    failed = int(np.sum(data["status"].values != 1))
    error = data["flow_parameter_error"].values
    cycles = data["clpe_rms"].values
    clpe = cycles[:, -1] if cycles.shape[1] else data["clpe_rms_whole"].values
    final_error = np.where(np.isfinite(error[:, -1]), error[:, -1], np.inf)
    final_clpe = np.where(np.isfinite(clpe), clpe, np.inf)
    times = [time_below(data["mark"].values, row, TENTH * row[0]) for row in error]
    k = float(np.mean(scenario.vehicle.feedback))
    error_median, rms = _quantile(final_error), _quantile(final_clpe)
    shares = (
        error_median / max(_quantile(error[:, 0]), 1e-300),
        rms * k / unknown.prior,
    )
    return Score(
        candidate,
        error_median,
        _quantile(final_error, 0.95),
        rms,
        _quantile([np.inf if time is None else time for time in times]),
        float(np.sqrt(np.prod(np.maximum(shares, ENOUGH)))),
        failed,
    )


def _quantile(values: Any, share: float = 0.5) -> float:
    """Return a quantile of values that may be infinite."""
    return float(np.quantile(values, share, method="inverted_cdf"))


# --- report ---------------------------------------------------------------------------------------


def excitation_of_track(scenario: Scenario) -> dict[str, Any]:
    """Return the smallest eigenvalue over the second cycle, in the scenario's flow."""
    window, start = span = checked_window(scenario, None, None)
    tracks = Tracks(scenario, span, scenario.run.duration, 3, 1e-8)
    least, _ = tracks(scenario.waypoints[None])
    return {"window": window, "start": start, "smallest_eigenvalue": float(least.min())}


def as_json(score: Score) -> dict[str, Any]:
    """Return a score as JSON values; None for infinite numbers."""
    values = score.candidate._asdict() | score._asdict()
    return {
        k: finite_or_none(v)
        for k, v in values.items()
        if k not in ("values", "candidate")
    }


def because(report: dict[str, Any], named: str) -> str:
    """Return a sentence on the reasons for the choice, with its numbers."""
    unit, time = report["units"]["length"], report["units"]["time"]
    speed, chosen = f"{unit}/{time}", report["chosen"]
    least = report["smallest_eigenvalue"]
    share = (least / report["window"]) ** 0.5
    shows = "shows every parameter" if share > HIDDEN else "hides some parameters"
    unmodelled, noise = report["unmodelled"], report["noise"]
    flow = (
        f"unmodelled flow of {unmodelled:.3g} {speed}"
        if unmodelled
        else "no unmodelled flow"
    )
    fixes = (
        f"positions with noise of {noise:.3g} {unit}" if noise else "exact positions"
    )
    learning_time = chosen["learning_time"]
    falls = (
        "does not fall to a tenth"
        if learning_time is None
        else f"is a tenth after {learning_time:.4g} {time}"
    )
    quickest = (
        ""
        if report["as_good"] == 1
        else f"the quickest of {report['as_good']} as good, "
    )
    return (
        f"{named}: {quickest}because the track {shows} (smallest eigenvalue {least:.3g} over "
        f"{report['window']:g} {time}: {share:.1g} of an error is seen), and with {flow} and "
        f"{fixes} the error of {report['members']} drawn flows, in the middle, {falls} and ends at "
        f"{chosen['error']:.2g} {speed}, CLPE rms at {chosen['clpe_rms']:.2g} {unit}"
    )
