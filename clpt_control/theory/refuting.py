"""Search for a run that breaks what a law promises.

A scenario is drawn from a point of the unit cube: start, track (or a round and then rest), flow and
what is beside it, gains, settings of the law.  Half of the points are drawn anew, half near the
point that came closest to breaking a promise.  The answer is a scenario that breaks one, with the
tightest tolerances as well.
"""

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..arguments import Positive, Seed, public
from ..blocks.laws.table import LAWS
from ..errors import ScenarioError, SimulationError
from ..scenario.experiment import Scenario
from ..scenario.file import paper_scenario
from .promises import UNIFORM, checked_promises, promises_in_words

BROKEN = 1.001
NUMBERS = 120  # of a point; more than a draw takes
NEAR = 0.1  # how far a point near another lies, in some of its numbers
NEAR_0 = 1e-3  # a start at 0 itself is on the kink of some laws
SHARE = 0.3  # of its numbers that change
SAMPLES = 400
LONGEST = 1.0  # seconds of the processor, a run
RESOLVED = 0.02  # time between samples, at most
TOLERANCES = {"rtol": 1e-9, "atol": 1e-12}
TIGHT = {"rtol": 1e-12, "atol": 1e-14}


@dataclass(frozen=True)
class Search:
    """What `refute` found.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> found = clpt.refute("known-flow", budget=1.0)
    >>> found.law, found.scenario is None, found.runs > 0
    ('known-flow', True, True)
    """

    law: str
    status: str  # "refuted" or "not refuted"
    broken: str  # the promise that is broken and its conditions, or nothing
    scenario: Scenario | None  # repeats it
    # promise -> the largest ratio of all runs; above 1 it is broken
    closest: dict[str, float]
    runs: int
    seconds: float

    def __repr__(self) -> str:
        said = f"; {self.broken}" if self.broken else ""
        return f"<Search of {self.law}: {self.status} in {self.runs} runs{said}>"


@public
def refute(
    law: str,
    *,
    budget: Positive = 60.0,
    seed: Seed = 0,
    progress: Callable[[float], None] | None = None,
) -> Search:
    """Search for a run that breaks a promise of a law.

    Starts, tracks, gains, flows and disturbances are drawn, and searched further where a run came
    close. Only promises whose conditions a scenario meets are checked along its run.

    Parameters
    ----------
    law : str
        A law of the table.
    budget : float, optional
        Seconds to search for.
    seed : int, optional
        Of the search.
    progress : callable, optional
        Called with the share of the budget that is used.

    Returns
    -------
    Search
        `status` "refuted" with the `scenario` that repeats it, or "not refuted", which proves
        nothing, and how close runs came.

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
        raise ScenarioError(f"law: '{law}' is no law; `clpt laws` lists them")
    random, began, runs = np.random.default_rng(seed), time.monotonic(), 0
    best: dict[str, tuple[float, np.ndarray]] = {}
    found: Scenario | None = None
    broken = ""
    while (used := time.monotonic() - began) < budget and found is None:
        if progress is not None:
            progress(used / budget)
        point = random.random(NUMBERS)
        if best and random.random() < 0.5:
            _, near = best[str(random.choice(sorted(best)))]
            moved = random.normal(0, NEAR, NUMBERS) * (random.random(NUMBERS) < SHARE)
            point = np.clip(near + moved, 0.0, 1 - 1e-12)
        scenario = drawn(law, point)
        ratios = _run(scenario, TOLERANCES)
        runs += bool(ratios)
        for what, value in ratios.items():
            if value > BROKEN and found is None:
                again = _run(scenario, TIGHT).get(what, 0.0)
                if lasts(value, again):
                    found, broken = scenario, promises_in_words(LAWS[law])[what]
                value = min(value, again if found is not None else 1.0)
            if what not in best or value > best[what][0]:
                best[what] = value, point
    closest = {what: value for what, (value, _) in best.items()}
    status = "not refuted" if found is None else "refuted"
    return Search(law, status, broken, found, closest, runs, time.monotonic() - began)


def lasts(value: float, again: float) -> bool:
    """Return whether the law breaks a promise, not the solver, whose error would get smaller."""
    return again > BROKEN and again - 1.0 >= 0.5 * (value - 1.0)


def _run(scenario: Scenario, tolerances: dict[str, float]) -> dict[str, float]:
    """Return each promise's ratio in a run; nothing of one that cannot go on or takes too long."""
    calls: list[float] = []  # when `patience` was called, seconds of the processor

    def patience(t: float) -> None:
        calls.append(time.process_time())
        if calls[-1] - calls[0] > LONGEST:
            raise SimulationError("this takes too long")

    try:
        return checked_promises(scenario, progress=patience, **tolerances)
    except SimulationError:
        return {}


class CubeNumbers:
    """Numbers of a point of the unit cube, taken one after the other."""

    def __init__(self, point: np.ndarray):
        self.rest: Iterator[float] = iter(point)

    def between(self, low: float, high: float, *shape: int) -> np.ndarray:
        """Return numbers between two."""
        flat = [
            low + (high - low) * next(self.rest) for _ in range(int(np.prod(shape)))
        ]
        return np.reshape(flat, shape)

    def scaled(self, low: float, high: float, *shape: int) -> np.ndarray:
        """Return positive numbers of any size between two."""
        return np.exp(self.between(np.log(low), np.log(high), *shape))

    def one_of(self, *options: Any) -> Any:
        """Return one of some options."""
        return options[int(next(self.rest) * len(options))]


def drawn(law: str, point: np.ndarray) -> Scenario:
    """Return the scenario of a point, with a law of the table."""
    row, draw = LAWS[law], CubeNumbers(point)
    N, count = draw.one_of(1, 2, 3), draw.one_of(1, 2, 3, 4, 5, 6)
    KD, GammaD = draw.scaled(0.3, 3, 2), draw.between(0, 4, 2)
    dwell, duration = float(draw.scaled(1, 20)), float(draw.scaled(10, 300))
    points = draw.between(-4, 4, 6, 2)[:count]
    if draw.one_of(True, False):  # a round, and then rest
        points = np.vstack([points, np.tile(points[-1], (int(duration / dwell), 1))])
    widths = draw.scaled(1, 10, 3) * draw.one_of(1, 1, 1, 2 * UNIFORM)
    periods = [draw.one_of(np.inf, float(draw.scaled(5, 50))) for _ in range(3)]
    theta, start, alpha_M = draw.between(-1.5, 1.5, 3, 2, 3)[..., :N]
    places = draw.between(-3, 3, 2, 2)
    kind = draw.one_of(None, None, None, None, "constant", "sine", "square", "noise")
    strength, period = draw.scaled(1e-3, 1, 2), float(draw.scaled(1, 50))
    values: dict[str, Any] = {
        "basis": {
            "kernel": "exponential",
            "centers": draw.between(-5, 5, 3, 2)[:N].tolist(),
            "widths": widths[:N].tolist(),
            "periods": periods[:N],
        },
        "flow.parameters": theta.tolist(),
        "model.parameters": (alpha_M * draw.one_of(0, 1)).tolist(),
        "vehicle": {"feedback": KD.tolist(), "feedforward": GammaD.tolist()},
        "vehicle.position": places[0].tolist(),
        "reference": {"kind": "waypoints", "points": points.tolist(), "dwell": dwell},
        "run.duration": duration,
        "run.output_step": min(RESOLVED, duration / SAMPLES),
    }
    if kind is not None:
        delta = {"kind": kind, "amplitude": strength.tolist()}
        values["flow.disturbance"] = delta | (
            {} if kind == "constant" else {"period": period}
        )
    learning: dict[str, Any] = {
        "law": law,
        "position": places[draw.one_of(0, 1)].tolist(),
    }
    gains = [float(draw.scaled(0.05, 20)), *draw.scaled(0.02, 5, 2).tolist()]
    adapts, first = (
        draw.one_of(True, False),
        draw.between(0, 3, 2, 2) * draw.one_of(NEAR_0, 1),
    )
    noise = draw.one_of(0, 0, 0, 0.02)
    if row.at_fixes:
        values["localization"] = {"interval": dwell / 3, "noise": noise}
    else:
        first = first if adapts else np.array([KD, GammaD])
        learning |= {
            "adapt_gains": adapts,
            "feedback": first[0],
            "feedforward": first[1],
        }
        needed = [row.alpha_by_gain, adapts, adapts]
        keys = zip(
            ("parameters", "feedback", "feedforward"), gains, needed, strict=True
        )
        learning["gains"] = {key: gain for key, gain, wanted in keys if wanted} or None
        if noise:
            values["localization"] = {"noise": noise, "noise_period": 1.0}
    if row.given_estimate:
        learning["theta_estimate"] = start.tolist()
    elif not row.alpha_is_constant:
        learning["parameters"] = (start * draw.one_of(NEAR_0, 1)).tolist()
    scenario = paper_scenario().with_values({**values, "learning": learning})
    table = {
        key: _setting(one, scenario, key, draw)
        for key, one in row.settings.items()
        if one.allowed != "row" and draw.one_of(True, False)
    }
    return scenario.with_values({f"learning.{row.table}": table}) if table else scenario


def _setting(one: Any, scenario: Scenario, key: str, draw: CubeNumbers) -> float:
    """Return a value of a law's own setting: any share of 1, or up to ten times the usual."""
    if one.allowed in ("below 1", "at most 1"):
        return float(draw.between(0.02, 0.98))
    usual = one.of(scenario.known_to_law, key)
    return float(draw.scaled(0.1, 10)) * float(usual)
