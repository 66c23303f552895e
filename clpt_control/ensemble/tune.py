"""Choose law, gains and filter by an ensemble of flows that nobody was told.

Of the candidates whose runs all reach the end, those count as equal whose score (`scores`) is
within a fifth of the best; the quickest of them is taken, then the one with the better score.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arguments import public
from ..blocks.laws.table import LAWS
from ..errors import ClptError, ScenarioError, needed
from ..scenario.experiment import Scenario
from .candidates import Candidate, Unknown, about, as_they_come, belief, laws_to_try, unknown_of
from .members import check_method
from .scores import Score, because, listed, score_of, seen

NEAR = 1.2  # times the best score: as good
FINALISTS = 3  # laws whose gain and filter are varied
OWN = "as it is"  # the scenario's own learning, beside the candidates


@dataclass(frozen=True)
class Tuned:
    """What `tune_law` chose."""

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
    check_method(scenario)
    names = tuple([laws] if isinstance(laws, str) else laws)
    for name in names:
        if name not in LAWS:
            raise ScenarioError(f"laws: '{name}' is no law; `clpt laws` lists them")
    for word, value, least, most in (("members", members, 3, 10**5), ("seed", seed, 0, 2**31)):
        if not isinstance(value, int) or not least <= value <= most:
            raise ScenarioError(f"{word} = {value}: must be a whole number, {least} to {most}")
    needed("zarr")
    unknown = unknown_of(scenario, prior, unmodelled, members)
    tried, skipped = laws_to_try(names)
    if not tried:
        raise ScenarioError(f"laws: none of {', '.join(names)} learns the flow; name another")
    report = progress or (lambda share: None)
    scores: list[Score] = []

    def score(one: Candidate) -> None:
        try:
            scores.append(score_of(unknown, one, members, seed))
        except ClptError as error:
            skipped[one.text] = str(error).removeprefix("scenario: ")

    for k, law in enumerate(tried):
        report(0.5 * k / len(tried))
        try:
            both = list(as_they_come(scenario, law))
        except ClptError as error:
            skipped[law.name] = str(error).removeprefix("scenario: ")
            continue
        for one in both:
            score(one)
    finalists = _best_of_each_law(scores)[:FINALISTS]
    grid = [
        one
        for best in finalists
        for one in about(scenario, LAWS[best.candidate.law], best.candidate.held)
    ]
    for k, one in enumerate(grid):
        report(0.5 + 0.5 * k / len(grid))
        score(one)
    best = ranked(scores)
    if not best:
        reasons = "; ".join(f"{name}: {why}" for name, why in list(skipped.items())[:2])
        raise ScenarioError(
            f"no candidate reaches the end of its runs{': ' if reasons else ''}{reasons}; give a "
            "smaller prior or a shorter run"
        )
    own = None if scenario.learning.row.given_estimate else _own(unknown, scenario, members, seed)
    report(1.0)
    chosen = best[0]
    failed = sorted((one for one in scores if one.failed), key=lambda one: one.candidate.text)
    found: dict[str, Any] = {
        "title": scenario.title,
        "units": scenario.units.model_dump(),
        "members": members,
        "seed": seed,
        "prior": unknown.prior,
        "belief": belief(scenario).tolist(),
        "unmodelled": unknown.unmodelled,
        "noise": unknown.noise,
        **seen(unknown.scenario),
        "chosen": listed(chosen),
        "as_good": as_good(best),
        "own": None if own is None else listed(own),
        "candidates": [listed(one) for one in (*best, *failed)],
        "skipped": skipped,
    }
    found["because"] = because(found)
    return Tuned(scenario.with_values(chosen.candidate.values), found)


def ranked(scores: list[Score]) -> list[Score]:
    """Return scores without a failed member, the one to take first."""
    whole = [one for one in scores if not one.failed and np.isfinite(one.score)]
    if not whole:
        return []
    enough = _enough(whole)
    return sorted(
        whole,
        key=lambda one: (
            one.score > enough,
            one.time if one.score <= enough else 0.0,
            one.score,
            one.error * one.clpe,
        ),
    )


def as_good(best: list[Score]) -> int:
    """Return how many of ranked scores count as equal to the best."""
    enough = _enough(best)
    return sum(one.score <= enough for one in best)


def _enough(scores: list[Score]) -> float:
    """Return the score up to which candidates count as equal."""
    return NEAR * min(one.score for one in scores)


def _best_of_each_law(scores: list[Score]) -> list[Score]:
    found: dict[str, Score] = {}
    for one in ranked(scores):
        found.setdefault(one.candidate.law, one)
    return list(found.values())


def _own(unknown: Unknown, scenario: Scenario, members: int, seed: int) -> Score | None:
    """Return the score of the scenario's own learning."""
    learning = scenario.learning
    gains = learning.used_gains
    own = Candidate(f"{learning.law}, {OWN}", gains.parameters, not learning.adapt_gains, None, {})
    try:
        return score_of(unknown, own, members, seed)
    except ClptError:
        return None
