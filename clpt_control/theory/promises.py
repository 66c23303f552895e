"""What the laws promise: predicates with their conditions, each checked along a run.

A row of the table names its `promises`; here stand their words, conditions and predicates.  The
number that a predicate returns is above 1 where a run breaks the promise.  They are V' integrated
over a time:

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
class LawRun:
    """A run of a scenario, along which the promises of its law are checked."""

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
        return (
            self.run.flow_parameters_estimate.values - self.run.flow_parameters.values
        )

    def state(self, name: str) -> np.ndarray:
        """A matrix of the law, shape (time, n, n)."""
        own = [
            str(label).startswith(f"adaptation_{name}[")
            for label in self.run.state.values
        ]
        n = int(np.sqrt(np.count_nonzero(own)))
        return self.run.states.values[:, own].reshape(-1, n, n)

    def share(self, e: np.ndarray, allowed: float) -> float:
        """The integral of e^T KD e over what is allowed."""
        return self.integral(e, self.KD) / (QUADRATURE * allowed + FLOOR)

    def integral(self, values: np.ndarray, weights: np.ndarray) -> float:
        """The integral of sum weights values^2."""
        return float(
            np.trapezoid(np.sum(weights * values**2, axis=1), self.run.time.values)
        )


def rise(values: np.ndarray) -> float:
    """Return the largest ratio of a value to an earlier one."""
    values = values.reshape(len(values), -1)
    floor = FLOOR * np.max(values[0]) + FLOOR**2
    return float(np.max((values + floor) / (np.minimum.accumulate(values) + floor)))


def mean_square(along: LawRun) -> float:
    """Return int e^T KD e over 2 V(0) + int d^T KD^-1 d."""
    run, theta_hat = along.run, along.run.flow_parameters_estimate.values
    known = flow_velocity(
        along.scenario, run.position.values, run.time.values, theta_hat
    )
    unknown = along.integral(run.true_flow.values - known, 1 / along.KD)
    return along.share(run.clpe.values, 2 * along.V[0] + unknown)


def pace(along: LawRun) -> np.ndarray:
    """Return r, per time: the least of KD and of the rates at which the memories pull."""
    p, matrices = along.p, along.row.semidefinite
    pulls = [
        p.memory_gain * along.state(name) for name in matrices if name in ("Q", "S")
    ]
    roots = np.sqrt([p.get("gain_K", 0.0), p.get("gain_Gamma", 0.0)])
    gains = [name for name in matrices if name in ("Q_1", "Q_2") and np.all(roots > 0)]
    pulls += [np.outer(roots, roots) * along.state(name) for name in gains]
    least = [np.linalg.eigvalsh(M)[:, 0] for M in pulls]
    return np.minimum(np.min(least, axis=0), np.min(along.KD))


def exponential(along: LawRun) -> float:
    """Return the largest ratio of V to the bound that r has promised since an earlier time."""
    every = max(1, len(along.V) // STEPS)
    t, V, r = along.run.time.values[::every], along.V[::every], pace(along)[::every]
    since = np.maximum(t - t[:, None], 0.0)  # a row for each earlier time
    promised = V[:, None] * np.exp(-2 * np.maximum(r, 0.0)[:, None] * since)
    floor = FLOOR * V[0] + FLOOR**2
    return float(np.max(np.triu((V + floor) / (promised + floor))))


def level(along: LawRun) -> float:
    """Return the largest V over that of V(0) and the level of the disturbance."""
    largest = largest_disturbance(along.scenario)
    bound = along.row.level(along.p, truth_of(along.scenario), largest)
    return float(np.max(along.V) / max(along.V[0] + FLOOR, bound))


def balls(along: LawRun) -> float:
    """Return the largest norm of alpha, K or Gamma over what it may have."""
    limits = (
        along.p.largest_flow,
        along.p.largest_feedback,
        along.p.largest_feedforward,
    )
    found = []
    for name, M in zip(
        ("alpha", "feedback_gain", "feedforward_gain"), limits, strict=True
    ):
        norms = np.linalg.norm(along.run[name].values.reshape(len(along.V), -1), axis=1)
        found.append(np.max(norms) / max((1 + along.p.layer) * M, norms[0]))
    return float(max(found))


def estimate(along: LawRun) -> float:
    """Return the rise of tr(d P^-1 d^T)."""
    d = np.swapaxes(along.off, 1, 2)
    return rise(np.sum(d * np.linalg.solve(along.state("P"), d), axis=(1, 2)))


def readout(along: LawRun) -> float:
    """Return the error of the readout, where it is one, over what rounding leaves."""
    run, theta = along.run, along.run.flow_parameters.values
    read = run.error_left.values <= 1 - along.p.margin
    off = np.abs(run.flow_parameters_readout.values[read] - theta)
    return float(
        np.max(off, initial=0.0) / (EXACT * np.max(np.abs([theta, along.off[0]])))
    )


CHECKS: dict[
    str, tuple[str, Callable[[LawRun], float]]
] = {  # words; above 1 where it is broken
    "falls": ("V never rises", lambda along: rise(along.V)),
    "settles": (
        "CLPE goes to zero, its weighed square integral at most V(0)",
        lambda along: along.share(along.run.clpe.values, along.V[0]),
    ),
    "mean square": (
        "in the mean CLPE is at most the flow that the law does not know, over KD",
        mean_square,
    ),
    "zone": (
        "CLPE comes to the zone",
        lambda along: along.share(
            beyond(along.run.clpe.values, along.p.zone), along.V[0]
        ),
    ),
    "exponential": (
        "V falls exponentially, at the rate that the memories have reached, for good",
        exponential,
    ),
    "level": ("V never rises above a level", level),
    "balls": ("what is learned stays within the limits", balls),
    "shrinks": (
        "each parameter's error only shrinks",
        lambda along: rise(abs(along.off)),
    ),
    "estimate": (
        "the error of the estimate, over its covariance, never rises",
        estimate,
    ),
    "readout": ("the readout is theta", readout),
}


def true_or_adapted(scenario: Scenario) -> bool:
    """Return whether K and Gamma adapt, or are the vehicle's own."""
    learning, car = scenario.learning, scenario.vehicle
    true = (learning.feedback, learning.feedforward) == (car.feedback, car.feedforward)
    return learning.adapt_gains or learning.row.at_fixes or true


def exact(scenario: Scenario) -> bool:
    """Return whether positions are exact, and z(0) where it counts as a fix."""
    fixes, learning = scenario.localization, scenario.learning
    begins = learning.position == scenario.vehicle.position or not learning.row.at_fixes
    return begins and (fixes is None or fixes.noise == 0)


def within(scenario: Scenario) -> bool:
    """Return whether the truth lies within the limits."""
    return not LawRun(scenario).row.doubt(LawRun(scenario).p, truth_of(scenario))


def small(scenario: Scenario) -> bool:
    """Return whether the disturbance is at most KD times the zone."""
    law, delta = LawRun(scenario), scenario.flow.disturbance
    below = delta is None or np.all(np.abs(delta.amplitude) <= law.KD * law.p.zone)
    return bool(bounded(scenario) and below)


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


def what_it_promises(row: Law) -> str:
    """Return all that a law promises, without the conditions."""
    return "; ".join(CHECKS[promise.what][0] for promise in row.promises)


def promises_in_words(row: Law) -> dict[str, str]:
    """Return each promise of a law in words, with its conditions."""
    return {
        promise.what: CHECKS[promise.what][0]
        + (", where: " if promise.where else "")
        + "; ".join(CONDITIONS[name][0] for name in promise.where)
        for promise in row.promises
    }


def largest_disturbance(scenario: Scenario) -> float:
    """Return the largest |Delta| of a scenario, length per time."""
    delta = scenario.flow.disturbance
    return 0.0 if delta is None else float(np.hypot(*delta.amplitude))


def truth_of(scenario: Scenario) -> Truth:
    """Return theta, KD and GammaD of a scenario."""
    car = scenario.vehicle
    return Truth(
        *map(np.array, (scenario.flow.parameters, car.feedback, car.feedforward))
    )


def checked_promises(scenario: Scenario, **solver: Any) -> dict[str, float]:
    """Run a scenario; return each promise of its law whose conditions hold, above 1 if broken."""
    wanted = [
        promise.what
        for promise in scenario.learning.row.promises
        if all(CONDITIONS[name][1](scenario) for name in promise.where)
    ]
    if not wanted:
        return {}
    along = LawRun(scenario, simulate(scenario, **solver))
    return {what: CHECKS[what][1](along) for what in wanted}
