"""What the laws promise: predicates with their conditions, each asked along a run.

A row of the table names its `promises`; here stand their words, conditions and predicates.  What a
predicate gives is above 1 where a run breaks the promise.  They are what is left of V' over a time:

    falls          V(t) <= V(s), s <= t
    settles        int e^T KD e <= V(0), so CLPE goes to zero
    mean square    int e^T KD e <= 2 V(0) + int d^T KD^-1 d,    d = F - theta_hat phi
    zone           int D^T KD D <= V(0), D = e - clip(e, -zone, zone)
    exponential    V(t) <= V(s) exp(-2 r(s) (t - s)), r the least of KD and of the pull
    level          V(t) <= max(V(0), level) under a bounded disturbance
    balls          norms stay below (1 + layer) times their limits, or where they started
    shrinks        |eta_ik(t)| <= |eta_ik(s)|
    estimate       tr(d P^-1 d^T), d = theta_hat - theta, never rises
    readout        the readout is theta where w <= 1 - margin
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..blocks.laws.known import Truth
from ..blocks.laws.law import Law
from ..scenario.experiment import Scenario
from ..simulation.flows import flow_velocity
from ..simulation.integrate import simulate

if TYPE_CHECKING:
    import xarray

FLOOR = 1e-9  # of what a value started at: what the solver leaves
QUADRATURE = 1.02  # what sums over samples may be beside integrals
EXACT = 1e-5  # of the largest parameter
STEPS = 60  # pairs of times
UNIFORM = 1e8  # times the reach: widths of functions that are the same everywhere


@dataclass(frozen=True)
class Asked:
    """A run of a scenario, to be asked for promises."""

    scenario: Scenario
    run: "xarray.Dataset"

    @cached_property
    def p(self) -> Any:
        """The law's parameters."""
        return self.row.parameters_of(self.scenario.known_to_law)

    @property
    def row(self) -> Any:
        """The law's row."""
        return self.scenario.learning.row

    @property
    def V(self) -> np.ndarray:
        """V along the run."""
        return self.run.lyapunov.values

    @property
    def KD(self) -> np.ndarray:
        """The vehicle's feedback gains."""
        return np.array(self.scenario.vehicle.feedback)

    @property
    def off(self) -> np.ndarray:
        """theta_hat - theta, shape (time, 2, N)."""
        return self.run.flow_parameters_estimate.values - self.run.flow_parameters.values

    def state(self, name: str) -> np.ndarray:
        """A matrix of the law, shape (time, n, n)."""
        at = [str(label).startswith(f"adaptation_{name}[") for label in self.run.state.values]
        n = int(np.sqrt(np.count_nonzero(at)))
        return self.run.states.values[:, at].reshape(-1, n, n)

    def integral(self, values: np.ndarray, weights: np.ndarray) -> float:
        """The integral of sum weights values^2."""
        return float(np.trapezoid(np.sum(weights * values**2, axis=1), self.run.time.values))


def rise(values: np.ndarray) -> float:
    """Return how many times as large values become as they were before, at most."""
    values = values.reshape(len(values), -1)
    floor = FLOOR * np.max(values[0]) + FLOOR**2
    return float(np.max((values + floor) / (np.minimum.accumulate(values) + floor)))


def settles(asked: Asked) -> float:
    """Return int e^T KD e over V(0)."""
    taken = asked.integral(asked.run.clpe.values, asked.KD)
    return taken / (QUADRATURE * asked.V[0] + FLOOR)


def mean_square(asked: Asked) -> float:
    """Return int e^T KD e over 2 V(0) + int d^T KD^-1 d."""
    run = asked.run
    theta_hat = run.flow_parameters_estimate.values
    known = flow_velocity(asked.scenario, run.position.values, run.time.values, theta_hat)
    unknown = asked.integral(run.true_flow.values - known, 1 / asked.KD)
    return asked.integral(run.clpe.values, asked.KD) / (
        QUADRATURE * (2 * asked.V[0] + unknown) + FLOOR
    )


def zone(asked: Asked) -> float:
    """Return int D^T KD D over V(0)."""
    e = asked.run.clpe.values
    beyond = e - np.clip(e, -asked.p.zone, asked.p.zone)
    return asked.integral(beyond, asked.KD) / (QUADRATURE * asked.V[0] + FLOOR)


def pace(asked: Asked) -> np.ndarray:
    """Return r: the least of KD and of what the memories pull each parameter by, per time."""
    p, cones = asked.p, asked.row.cones
    pulls = [p.memory_gain * asked.state(name) for name in cones if name in ("Q", "S")]
    roots = np.sqrt([p.get("gain_K", 0.0), p.get("gain_Gamma", 0.0)])
    gains = [name for name in cones if name in ("Q_1", "Q_2") and np.all(roots > 0)]
    pulls += [np.outer(roots, roots) * asked.state(name) for name in gains]
    least = [np.linalg.eigvalsh(M)[:, 0] for M in pulls]
    return np.minimum(np.min(least, axis=0), np.min(asked.KD))


def exponential(asked: Asked) -> float:
    """Return how many times as large V is as what r has promised since an earlier time."""
    every = max(1, len(asked.V) // STEPS)
    t, V, r = asked.run.time.values[::every], asked.V[::every], pace(asked)[::every]
    since = np.maximum(t - t[:, None], 0.0)  # a row for each earlier time
    promised = V[:, None] * np.exp(-2 * np.maximum(r, 0.0)[:, None] * since)
    floor = FLOOR * V[0] + FLOOR**2
    return float(np.max(np.triu((V + floor) / (promised + floor))))


def level(asked: Asked) -> float:
    """Return the largest V over that of V(0) and the level of the disturbance."""
    delta = asked.scenario.flow.disturbance
    largest = 0.0 if delta is None else float(np.hypot(*delta.amplitude))
    bound = asked.row.level(asked.p, truth_of(asked.scenario), largest)
    return float(np.max(asked.V) / max(asked.V[0] + FLOOR, bound))


def balls(asked: Asked) -> float:
    """Return the largest norm of alpha, K or Gamma over what it may have."""
    limits = (asked.p.largest_flow, asked.p.largest_feedback, asked.p.largest_feedforward)
    found = []
    for name, M in zip(("alpha", "feedback_gain", "feedforward_gain"), limits, strict=True):
        norms = np.linalg.norm(asked.run[name].values.reshape(len(asked.V), -1), axis=1)
        found.append(np.max(norms) / max((1 + asked.p.layer) * M, norms[0]))
    return float(max(found))


def estimate(asked: Asked) -> float:
    """Return the rise of tr(d P^-1 d^T)."""
    d = np.swapaxes(asked.off, 1, 2)
    return rise(np.sum(d * np.linalg.solve(asked.state("P"), d), axis=(1, 2)))


def readout(asked: Asked) -> float:
    """Return the error of the readout, where it is one, over what rounding leaves."""
    run, theta = asked.run, asked.run.flow_parameters.values
    read = run.error_left.values <= 1 - asked.p.margin
    off = np.abs(run.flow_parameters_readout.values[read] - theta)
    return float(np.max(off, initial=0.0) / (EXACT * np.max(np.abs([theta, asked.off[0]]))))


class Check(NamedTuple):
    """A predicate."""

    words: str
    of: Callable[[Asked], float]  # above 1 where it is broken


CHECKS = {
    "falls": Check("V never rises", lambda asked: rise(asked.V)),
    "settles": Check("CLPE goes to zero, its weighed square integral at most V(0)", settles),
    "mean square": Check(
        "in the mean CLPE is at most the flow that the law does not know, over KD", mean_square
    ),
    "zone": Check("CLPE comes to the zone", zone),
    "exponential": Check(
        "V falls exponentially, at the rate that the memories have reached, for good", exponential
    ),
    "level": Check("V never rises above a level", level),
    "balls": Check("what is learned stays within the limits", balls),
    "shrinks": Check("each parameter's error only shrinks", lambda asked: rise(abs(asked.off))),
    "estimate": Check("the error of the estimate, over its covariance, never rises", estimate),
    "readout": Check("the readout is theta", readout),
}


def _within(scenario: Scenario) -> bool:
    p = scenario.learning.row.parameters_of(scenario.known_to_law)
    return not scenario.learning.row.doubt(p, truth_of(scenario))


def _small(scenario: Scenario) -> bool:
    p, delta = scenario.learning.row.parameters_of(scenario.known_to_law), scenario.flow.disturbance
    largest = np.zeros(2) if delta is None else np.abs(delta.amplitude)
    return bool(np.all(largest <= np.array(scenario.vehicle.feedback) * p.zone))


def _exact(scenario: Scenario) -> bool:
    seen, row = scenario.localization, scenario.learning.row
    begins = scenario.learning.position == scenario.vehicle.position
    return (seen is None or seen.noise == 0) and (begins or not row.at_fixes)


class Condition(NamedTuple):
    """What a scenario must be for a promise."""

    words: str
    of: Callable[[Scenario], bool]


CONDITIONS = {
    "spanned": Condition(
        "the functions span the flow",
        lambda scenario: scenario.flow.field is None and scenario.flow.disturbance is None,
    ),
    "exact": Condition("positions are exact (at fixes z(0) too)", _exact),
    "true": Condition(
        "K and Gamma adapt, or are held at the vehicle's own",
        lambda scenario: (
            scenario.learning.adapt_gains
            or scenario.learning.row.at_fixes
            or np.array_equal(
                (scenario.learning.feedback, scenario.learning.feedforward),
                (scenario.vehicle.feedback, scenario.vehicle.feedforward),
            )
        ),
    ),
    "within": Condition("the truth lies within the limits", _within),
    "small": Condition("the disturbance is at most KD times the zone", _small),
    "bounded": Condition(
        "the disturbance is bounded",
        lambda scenario: (
            scenario.flow.field is None
            and (scenario.flow.disturbance is None or scenario.flow.disturbance.kind != "noise")
        ),
    ),
    "uniform": Condition(
        "phi at the prediction is phi at the vehicle",
        lambda scenario: min(scenario.basis.widths) >= UNIFORM,
    ),
}


def words_of(row: Law) -> dict[str, str]:
    """Return each promise of a law in words, with its conditions."""
    return {
        promise.what: CHECKS[promise.what].words
        + (", where: " if promise.where else "")
        + "; ".join(CONDITIONS[name].words for name in promise.where)
        for promise in row.promises
    }


def truth_of(scenario: Scenario) -> Truth:
    """Return what V measures the distance to."""
    car = scenario.vehicle
    return Truth(*map(np.array, (scenario.flow.parameters, car.feedback, car.feedforward)))


def kept(scenario: Scenario, **solver: Any) -> dict[str, float]:
    """Run a scenario; return each promise of its law whose conditions hold, above 1 if broken."""
    wanted = [
        promise.what
        for promise in scenario.learning.row.promises
        if all(CONDITIONS[name].of(scenario) for name in promise.where)
    ]
    if not wanted:
        return {}
    asked = Asked(scenario, simulate(scenario, **solver))
    return {what: CHECKS[what].of(asked) for what in wanted}
