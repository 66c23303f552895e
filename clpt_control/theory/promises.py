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
from typing import Any

import numpy as np

from ..blocks.laws.law import Law, Truth
from ..blocks.laws.robust import beyond
from ..scenario.experiment import Scenario
from ..simulation.flows import flow_velocity
from ..simulation.integrate import simulate

FLOOR = 1e-9  # of what a value started at: what the solver leaves
QUADRATURE = 1.02  # what sums over samples may be beside integrals
EXACT = 1e-5  # of the largest parameter
STEPS = 60  # pairs of times
UNIFORM = 1e8  # times the reach: widths of functions that are the same everywhere


@dataclass(frozen=True)
class Asked:
    """A run of a scenario, to be asked for promises."""

    scenario: Scenario
    run: Any = None

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

    def share(self, e: np.ndarray, allowed: float) -> float:
        """The integral of e^T KD e over what is allowed."""
        return self.integral(e, self.KD) / (QUADRATURE * allowed + FLOOR)

    def integral(self, values: np.ndarray, weights: np.ndarray) -> float:
        """The integral of sum weights values^2."""
        return float(np.trapezoid(np.sum(weights * values**2, axis=1), self.run.time.values))


def rise(values: np.ndarray) -> float:
    """Return how many times as large values become as they were before, at most."""
    values = values.reshape(len(values), -1)
    floor = FLOOR * np.max(values[0]) + FLOOR**2
    return float(np.max((values + floor) / (np.minimum.accumulate(values) + floor)))


def mean_square(asked: Asked) -> float:
    """Return int e^T KD e over 2 V(0) + int d^T KD^-1 d."""
    run, theta_hat = asked.run, asked.run.flow_parameters_estimate.values
    known = flow_velocity(asked.scenario, run.position.values, run.time.values, theta_hat)
    unknown = asked.integral(run.true_flow.values - known, 1 / asked.KD)
    return asked.share(run.clpe.values, 2 * asked.V[0] + unknown)


def pace(asked: Asked) -> np.ndarray:
    """Return r: the least of KD and of what the memories pull each parameter by, per time."""
    p, cones = asked.p, asked.row.semidefinite
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


CHECKS: dict[str, tuple[str, Callable[[Asked], float]]] = {  # words; above 1 where it is broken
    "falls": ("V never rises", lambda asked: rise(asked.V)),
    "settles": (
        "CLPE goes to zero, its weighed square integral at most V(0)",
        lambda asked: asked.share(asked.run.clpe.values, asked.V[0]),
    ),
    "mean square": (
        "in the mean CLPE is at most the flow that the law does not know, over KD",
        mean_square,
    ),
    "zone": (
        "CLPE comes to the zone",
        lambda asked: asked.share(beyond(asked.run.clpe.values, asked.p.zone), asked.V[0]),
    ),
    "exponential": (
        "V falls exponentially, at the rate that the memories have reached, for good",
        exponential,
    ),
    "level": ("V never rises above a level", level),
    "balls": ("what is learned stays within the limits", balls),
    "shrinks": ("each parameter's error only shrinks", lambda asked: rise(abs(asked.off))),
    "estimate": ("the error of the estimate, over its covariance, never rises", estimate),
    "readout": ("the readout is theta", readout),
}


def true_or_adapted(scenario: Scenario) -> bool:
    """Return whether K and Gamma adapt, or are the vehicle's own."""
    own, car = scenario.learning, scenario.vehicle
    held = (own.feedback, own.feedforward) == (car.feedback, car.feedforward)
    return own.adapt_gains or own.row.at_fixes or held


def exact(scenario: Scenario) -> bool:
    """Return whether positions are exact, and z(0) where it counts as a fix."""
    seen, own = scenario.localization, scenario.learning
    begins = own.position == scenario.vehicle.position or not own.row.at_fixes
    return begins and (seen is None or seen.noise == 0)


def within(scenario: Scenario) -> bool:
    """Return whether the truth lies within the limits."""
    return not Asked(scenario).row.doubt(Asked(scenario).p, truth_of(scenario))


def small(scenario: Scenario) -> bool:
    """Return whether the disturbance is at most KD times the zone."""
    asked, delta = Asked(scenario), scenario.flow.disturbance
    least = delta is None or np.all(np.abs(delta.amplitude) <= asked.KD * asked.p.zone)
    return bool(bounded(scenario) and least)


def bounded(scenario: Scenario) -> bool:
    """Return whether the disturbance has a bound."""
    delta = scenario.flow.disturbance
    return scenario.flow.field is None and (delta is None or delta.kind != "noise")


CONDITIONS: dict[str, tuple[str, Callable[[Scenario], bool]]] = {
    "spanned": (
        "the functions span the flow",
        lambda scenario: bounded(scenario) and scenario.flow.disturbance is None,
    ),
    "exact": ("positions are exact (at fixes z(0) too)", exact),
    "true": ("K and Gamma adapt, or are held at the vehicle's own", true_or_adapted),
    "within": ("the truth lies within the limits", within),
    "small": ("the disturbance is at most KD times the zone", small),
    "bounded": ("the disturbance is bounded", bounded),
    "uniform": (
        "phi at the prediction is phi at the vehicle",
        lambda scenario: min(scenario.basis.widths) >= UNIFORM,
    ),
}


def words_of(row: Law) -> dict[str, str]:
    """Return each promise of a law in words, with its conditions."""
    return {
        promise.what: CHECKS[promise.what][0]
        + (", where: " if promise.where else "")
        + "; ".join(CONDITIONS[name][0] for name in promise.where)
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
        if all(CONDITIONS[name][1](scenario) for name in promise.where)
    ]
    if not wanted:
        return {}
    asked = Asked(scenario, simulate(scenario, **solver))
    return {what: CHECKS[what][1](asked) for what in wanted}
