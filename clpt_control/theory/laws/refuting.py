"""Search for a run that breaks a promise of a law.

A scenario is sampled from a point of the unit cube: start, track, flow and disturbance, gains and
settings of the law.  Half of the points are uniform, half are near the point whose run came
closest to breaking a promise.  A scenario counts as a refutation only if the promise is broken with
the tightest tolerances too.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...base.arguments import Positive, Seed, public
from ...base.errors import ScenarioError, SimulationError
from ...paper.blocks.disturbance import KINDS
from ...paper.laws.table import LAWS
from ...paper.scenario.experiment import Scenario
from ...paper.scenario.file import paper_scenario
from .promises import UNIFORM, checked_promises, promises_in_words

BROKEN = 1.001
NUMBERS = 120  # of a point; more than a scenario uses
SPREAD = 0.1  # of the numbers near a point
CHANGED = 0.3  # share of the numbers that change near a point
NEAR_0 = 1e-3  # a start at 0 is a non-smooth point of some laws
SAMPLES = 400
RUNS = 5  # in a second of the budget, about; the clock is not read
RESOLVED = 0.02  # longest time between samples
TOLERANCES = {"rtol": 1e-9, "atol": 1e-12}
TIGHT = {"rtol": 1e-12, "atol": 1e-14}


@dataclass(frozen=True)
class Search:
    """Result of `refute`.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> found = clpt.refute("known-flow", budget=1.0)
    >>> found.law, found.scenario is None, found.runs > 0
    ('known-flow', True, True)
    """

    law: str
    status: str  # "refuted" or "not refuted"
    broken: str  # the broken promise with its conditions, or ""
    scenario: Scenario | None  # repeats the refutation
    closest: dict[str, float]  # largest ratio of each promise; above 1 it is broken
    runs: int

    def __repr__(self) -> str:
        ending = f"; {self.broken}" if self.broken else ""
        return f"<Search of {self.law}: {self.status} in {self.runs} runs{ending}>"


@public
def refute(
    law: str,
    *,
    budget: Positive = 60.0,
    seed: Seed = 0,
    progress: Callable[[float], None] | None = None,
) -> Search:
    """Search for a run that breaks a promise of a law.

    Starts, tracks, gains, flows and disturbances are sampled, also near runs that came close to
    breaking a promise. Only promises whose conditions a scenario meets are checked along its run.

    Parameters
    ----------
    law : str
        A law of the table.
    budget : float, optional
        About the seconds of the search: five runs each, so that a search can be repeated.
    seed : int, optional
        Of the search.
    progress : callable, optional
        Called with the share of the runs that are done.

    Returns
    -------
    Search
        `status` is "refuted" with the `scenario` that repeats it, or "not refuted", which proves
        nothing; `closest` has the largest ratios.

    Raises
    ------
    ScenarioError
        If the law is not of the table.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> clpt.refute("learned-flow", budget=2.0).status
    'not refuted'
    """
    if law not in LAWS:
        raise ScenarioError(f"law: '{law}' is not a law. List the laws with: clpt laws")
    random, runs = np.random.default_rng(seed), 0
    best: dict[str, tuple[float, np.ndarray]] = {}
    refutation: Scenario | None = None
    broken = ""
    count = math.ceil(RUNS * budget)
    for tries in range(count):
        if refutation is not None:
            break
        if progress is not None:
            progress(tries / count)
        # Step 1: sample a point
        point = random.random(NUMBERS)
        if best and random.random() < 0.5:
            _, center = best[str(random.choice(sorted(best)))]
            change = random.normal(0, SPREAD, NUMBERS)
            change *= random.random(NUMBERS) < CHANGED
            point = np.clip(center + change, 0.0, 1 - 1e-12)
        # Step 2: run its scenario
        scenario = drawn(law, point)
        ratios = _run(scenario, TOLERANCES)
        runs += bool(ratios)
        # Step 3: repeat a run that breaks a promise with tight tolerances
        for promise, ratio in ratios.items():
            if ratio > BROKEN and refutation is None:
                again = _run(scenario, TIGHT).get(promise, 0.0)
                if lasts(ratio, again):
                    refutation = scenario
                    broken = promises_in_words(LAWS[law])[promise]
                ratio = min(ratio, again if refutation is not None else 1.0)
            if promise not in best or ratio > best[promise][0]:
                best[promise] = ratio, point
    closest = {promise: ratio for promise, (ratio, _) in best.items()}
    status = "not refuted" if refutation is None else "refuted"
    return Search(law, status, broken, refutation, closest, runs)


def lasts(ratio: float, again: float) -> bool:
    """Return True if a tighter solver does not halve the violation of a promise."""
    return again > BROKEN and again - 1.0 >= 0.5 * (ratio - 1.0)


def _run(scenario: Scenario, tolerances: dict[str, float]) -> dict[str, float]:
    """Return the ratio of each promise in a run, or {} for a run that fails."""
    try:
        return checked_promises(scenario, **tolerances)
    except SimulationError:
        return {}


class CubeNumbers:
    """Iterator over the numbers of a point of the unit cube, scaled to ranges."""

    def __init__(self, point: np.ndarray):
        self.numbers = iter(point)

    def uniform(self, low: float, high: float, *shape: int) -> np.ndarray:
        """Return numbers between two."""
        shares = [next(self.numbers) for _ in range(int(np.prod(shape)))]
        return low + (high - low) * np.reshape(shares, shape)

    def log_uniform(self, low: float, high: float, *shape: int) -> np.ndarray:
        """Return positive numbers between two, uniform on a logarithmic scale."""
        return np.exp(self.uniform(np.log(low), np.log(high), *shape))

    def choice(self, *options: Any) -> Any:
        """Return one of several options."""
        return options[int(next(self.numbers) * len(options))]


def drawn(law: str, point: np.ndarray) -> Scenario:
    """Return the scenario of a point, with a law of the table."""
    row, draw = LAWS[law], CubeNumbers(point)
    # Step 1: vehicle, track, basis and flow; the order of the numbers is fixed
    N, count = draw.choice(1, 2, 3), draw.choice(1, 2, 3, 4, 5, 6)
    KD, GammaD = draw.log_uniform(0.3, 3, 2), draw.uniform(0, 4, 2)
    dwell, duration = draw.log_uniform(1, 20), draw.log_uniform(10, 300)
    waypoints = draw.uniform(-4, 4, 6, 2)[:count]
    if draw.choice(True, False):  # one round, then the last waypoint
        rest = np.tile(waypoints[-1], (int(duration / dwell), 1))
        waypoints = np.vstack([waypoints, rest])
    widths = draw.log_uniform(1, 10, 3) * draw.choice(1, 1, 1, 2 * UNIFORM)
    periods = [draw.choice(np.inf, draw.log_uniform(5, 50)) for _ in range(3)]
    theta, start, alpha_M = draw.uniform(-1.5, 1.5, 3, 2, 3)[..., :N]
    positions = draw.uniform(-3, 3, 2, 2)
    kind = draw.choice(None, None, None, None, *KINDS)
    amplitude = draw.log_uniform(1e-3, 1, 2)
    period = draw.log_uniform(1, 50)
    values: dict[str, Any] = {
        "basis.centers": draw.uniform(-5, 5, 3, 2)[:N],
        "basis.widths": widths[:N],
        "basis.periods": np.array(periods[:N]),
        "basis.phases": None,
        "flow.parameters": theta,
        "model.parameters": alpha_M * draw.choice(0, 1),
        "vehicle.feedback": KD,
        "vehicle.feedforward": GammaD,
        "vehicle.position": positions[0],
        "reference.kind": "waypoints",
        "reference.points": waypoints,
        "reference.dwell": dwell,
        "run.duration": duration,
        "run.output_step": min(RESOLVED, duration / SAMPLES),
    }
    if kind is not None:
        values["flow.disturbance.kind"] = kind
        values["flow.disturbance.amplitude"] = amplitude
        if KINDS[kind].keys.get("period"):
            values["flow.disturbance.period"] = period
    # Step 2: the learner
    learning: dict[str, Any] = {"law": law, "position": positions[draw.choice(0, 1)]}
    gains = draw.log_uniform(0.05, 20), *draw.log_uniform(0.02, 5, 2)
    adapts = draw.choice(True, False)
    start_gains = draw.uniform(0, 3, 2, 2) * draw.choice(NEAR_0, 1)
    noise = draw.choice(0, 0, 0, 0.02)
    if row.at_fixes:
        values["localization"] = {"interval": dwell / 3, "noise": noise}
    else:
        feedback, feedforward = start_gains if adapts else (KD, GammaD)
        learning |= {"feedback": feedback, "feedforward": feedforward}
        learning["adapt_gains"] = adapts
        names = ("parameters", "feedback", "feedforward")
        uses = zip(names, gains, (row.alpha_by_gain, adapts, adapts), strict=True)
        learning["gains"] = {name: gain for name, gain, used in uses if used} or None
        if noise:
            values["localization"] = {"noise": noise, "noise_period": 1.0}
    if row.given_estimate:
        learning["theta_estimate"] = start
    elif not row.alpha_is_constant:
        learning["parameters"] = start * draw.choice(NEAR_0, 1)
    scenario = paper_scenario().with_values({**values, "learning": learning})
    # Step 3: some of the law's settings
    settings = {
        key: _setting(setting, scenario, key, draw)
        for key, setting in row.settings.items()
        if setting.allowed != "row" and draw.choice(True, False)
    }
    return scenario.with_values({f"learning.{row.table}": settings} if settings else {})


def _setting(setting: Any, scenario: Scenario, key: str, draw: CubeNumbers) -> float:
    """Return a share of 1, or 0.1 to 10 times the default of a law's setting."""
    if setting.allowed in ("below 1", "at most 1"):
        return float(draw.uniform(0.02, 0.98))
    default = float(setting.of(scenario.known_to_law, key))
    return float(draw.log_uniform(0.1, 10)) * default
