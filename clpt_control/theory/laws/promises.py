"""Promises of the laws as predicates with conditions, checked along runs.

A row of the table names its `promises`; this module has their words, conditions and predicates.
A predicate returns a ratio that is above 1 if a run breaks the promise:

    falls          V(t) <= V(s), s <= t
    settles        int e^T KD e <= V(0), so CLPE goes to zero
    mean square    int e^T KD e <= 2 V(0) + int d^T KD^-1 d,    d = F - theta_hat phi
    zone           int D^T KD D <= V(0), D = e - clip(e, -zone, zone)
    exponential    V(t) <= V(s) exp(-2 r(s) (t - s)), r the least of KD and of the pull
    level, balls   V(t) <= max(V(0), level); norms <= (1 + layer) times their limits
    shrinks        |eta_ik(t)| <= |eta_ik(s)|;  estimate: tr(d P^-1 d^T) does not rise
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ...paper.laws.law import Law, Truth
from ...paper.laws.robust import outside_zone
from ...paper.scenario.experiment import Scenario
from ...simulation.flows import flow_velocity
from ...simulation.integrate import simulate

FLOOR = 1e-9  # share of the initial value: error of the solver
QUADRATURE = 1.02  # largest ratio of a sum over samples to the integral
EXACT = 1e-5  # of the largest parameter
STEPS = 60  # times that are compared in pairs
UNIFORM = 1e8  # times the reach: width of a function that is constant


@dataclass(frozen=True)
class LawRun:
    """A run of a scenario with the quantities that promises refer to."""

    scenario: Scenario
    run: Any = None

    @cached_property
    def p(self) -> Any:
        """Parameters of the law."""
        return self.row.parameters_of(self.scenario.known_to_law)

    @property
    def row(self) -> Any:
        """Row of the law in the table."""
        return self.scenario.learning.row

    @property
    def V(self) -> np.ndarray:
        """V along the run."""
        return self.run.lyapunov.values

    @property
    def e(self) -> np.ndarray:
        """CLPE along the run, shape (time, 2)."""
        return self.run.clpe.values

    @property
    def KD(self) -> np.ndarray:
        """Feedback gains of the vehicle."""
        return np.array(self.scenario.vehicle.feedback)

    @property
    def estimate(self) -> np.ndarray:
        """theta_hat along the run, shape (time, 2, N)."""
        return self.run.flow_parameters_estimate.values

    @property
    def error(self) -> np.ndarray:
        """theta_hat - theta along the run, shape (time, 2, N)."""
        return self.estimate - self.run.flow_parameters.values

    def state(self, name: str) -> np.ndarray:
        """Return a matrix of the law, shape (time, n, n)."""
        columns = self.run.state.str.startswith(f"adaptation_{name}[").values
        n = int(np.sqrt(np.count_nonzero(columns)))
        return self.run.states.values[:, columns].reshape(-1, n, n)

    def square_integral(self, values: np.ndarray, weights: np.ndarray) -> float:
        """Return the integral of sum weights values^2."""
        integrand = np.sum(weights * values**2, axis=1)
        return float(np.trapezoid(integrand, self.run.time.values))

    def dissipation(self, e: np.ndarray, allowed: float) -> float:
        """Return the integral of e^T KD e over the allowed one."""
        return self.square_integral(e, self.KD) / (QUADRATURE * allowed + FLOOR)


def rise(values: np.ndarray) -> float:
    """Return the largest ratio of a value to an earlier one."""
    values = values.reshape(len(values), -1)
    floor = FLOOR * np.max(values[0]) + FLOOR**2
    smallest = np.minimum.accumulate(values)
    return float(np.max((values + floor) / (smallest + floor)))


def mean_square(law: LawRun) -> float:
    """Return int e^T KD e over 2 V(0) + int d^T KD^-1 d."""
    run = law.run
    positions, times = run.position.values, run.time.values
    modelled = flow_velocity(law.scenario, positions, times, law.estimate)
    unmodelled = law.square_integral(run.true_flow.values - modelled, 1 / law.KD)
    return law.dissipation(law.e, 2 * law.V[0] + unmodelled)


def decay_rate(law: LawRun) -> np.ndarray:
    """Return r, per time: the least of KD and of the rates of the memories."""
    p, matrices = law.p, law.row.semidefinite
    memories = [
        p.memory_gain * law.state(name) for name in matrices if name in ("Q", "S")
    ]
    roots = np.sqrt([p.get("gain_K", 0.0), p.get("gain_Gamma", 0.0)])
    if np.all(roots > 0):
        weights = np.outer(roots, roots)
        gains = [name for name in matrices if name in ("Q_1", "Q_2")]
        memories += [weights * law.state(name) for name in gains]
    least = [np.linalg.eigvalsh(M)[:, 0] for M in memories]
    return np.minimum(np.min(least, axis=0), np.min(law.KD))


def exponential(law: LawRun) -> float:
    """Return the largest ratio of V to the bound from an earlier time and its r."""
    every = max(1, len(law.V) // STEPS)
    t, V = law.run.time.values[::every], law.V[::every]
    rate = np.maximum(decay_rate(law)[::every], 0.0)
    elapsed = np.maximum(t - t[:, None], 0.0)  # a row for each earlier time
    bound = V[:, None] * np.exp(-2 * rate[:, None] * elapsed)
    floor = FLOOR * V[0] + FLOOR**2
    return float(np.max(np.triu((V + floor) / (bound + floor))))


def level(law: LawRun) -> float:
    """Return the largest V over that of V(0) and the level of the disturbance."""
    largest = largest_disturbance(law.scenario)
    bound = law.row.level(law.p, truth_of(law.scenario), largest)
    return float(np.max(law.V) / max(law.V[0] + FLOOR, bound))


def balls(law: LawRun) -> float:
    """Return the largest norm of alpha, K or Gamma over its limit."""
    limits = {
        "alpha": law.p.largest_flow,
        "feedback_gain": law.p.largest_feedback,
        "feedforward_gain": law.p.largest_feedforward,
    }
    ratios = []
    for name, limit in limits.items():
        norms = np.linalg.norm(law.run[name].values.reshape(len(law.V), -1), axis=1)
        ratios.append(np.max(norms) / max((1 + law.p.layer) * limit, norms[0]))
    return float(max(ratios))


def estimate(law: LawRun) -> float:
    """Return the rise of tr(d P^-1 d^T)."""
    d = np.swapaxes(law.error, 1, 2)
    return rise(np.sum(d * np.linalg.solve(law.state("P"), d), axis=(1, 2)))


def readout(law: LawRun) -> float:
    """Return the error of the valid readouts over the rounding error."""
    theta = law.run.flow_parameters.values
    valid = law.run.error_left.values <= 1 - law.p.margin
    error = np.abs(law.run.flow_parameters_readout.values[valid] - theta)
    size = np.max(np.abs([theta, law.error[0]]))
    return float(np.max(error, initial=0.0) / (EXACT * size))


# words and predicate by name
CHECKS: dict[str, tuple[str, Callable[[LawRun], float]]] = {
    "falls": ("V never rises", lambda law: rise(law.V)),
    "settles": (
        "CLPE goes to zero, its weighed square integral at most V(0)",
        lambda law: law.dissipation(law.e, law.V[0]),
    ),
    "mean square": (
        "in the mean CLPE is at most the flow that the law does not know, over KD",
        mean_square,
    ),
    "zone": (
        "CLPE comes to the zone",
        lambda law: law.dissipation(outside_zone(law.e, law.p.zone), law.V[0]),
    ),
    "exponential": (
        "V falls exponentially, at the rate that the memories have reached, for good",
        exponential,
    ),
    "level": ("V never rises above a level", level),
    "balls": ("what is learned stays within the limits", balls),
    "shrinks": (
        "each parameter's error only shrinks",
        lambda law: rise(abs(law.error)),
    ),
    "estimate": (
        "the error of the estimate, over its covariance, never rises",
        estimate,
    ),
    "readout": ("the readout is theta", readout),
}


def true_or_adapted(scenario: Scenario) -> bool:
    """Return True if K and Gamma adapt or are the vehicle's own."""
    learning, vehicle = scenario.learning, scenario.vehicle
    gains = learning.feedback, learning.feedforward
    true = gains == (vehicle.feedback, vehicle.feedforward)
    return learning.adapt_gains or learning.row.at_fixes or true


def exact_positions(scenario: Scenario) -> bool:
    """Return True if positions are exact, also z(0) if it is a fix."""
    fixes, learning = scenario.localization, scenario.learning
    true_start = learning.position == scenario.vehicle.position
    exact = fixes is None or fixes.noise == 0
    return exact and (true_start or not learning.row.at_fixes)


def truth_within_limits(scenario: Scenario) -> bool:
    """Return True if the truth lies within the limits."""
    law = LawRun(scenario)
    return not law.row.doubt(law.p, truth_of(scenario))


def small_disturbance(scenario: Scenario) -> bool:
    """Return True if the disturbance is at most KD times the zone."""
    law, delta = LawRun(scenario), scenario.flow.disturbance
    small = delta is None or np.all(np.abs(delta.amplitude) <= law.KD * law.p.zone)
    return bool(bounded(scenario) and small)


def bounded(scenario: Scenario) -> bool:
    """Return True if the disturbance has a bound."""
    delta = scenario.flow.disturbance
    return scenario.flow.parameters is not None and (delta is None or delta.row.bounded)


CONDITIONS: dict[str, tuple[str, Callable[[Scenario], bool]]] = {
    "spanned": (
        "the functions span the flow",
        lambda scenario: bounded(scenario) and scenario.flow.disturbance is None,
    ),
    "exact": ("positions are exact (at fixes z(0) too)", exact_positions),
    "true": ("K and Gamma adapt, or are held at the vehicle's own", true_or_adapted),
    "within": ("the truth lies within the limits", truth_within_limits),
    "small": ("the disturbance is at most KD times the zone", small_disturbance),
    "bounded": ("the disturbance is bounded", bounded),
    "uniform": (
        "phi at the prediction is phi at the vehicle",
        lambda scenario: min(scenario.basis.widths) >= UNIFORM,
    ),
}


def what_it_promises(row: Law) -> str:
    """Return the promises of a law without conditions."""
    return "; ".join(CHECKS[promise.claim][0] for promise in row.promises)


def promises_in_words(row: Law) -> dict[str, str]:
    """Return each promise of a law as text, with its conditions."""
    texts = {}
    for promise in row.promises:
        conditions = "; ".join(CONDITIONS[name][0] for name in promise.conditions)
        words = CHECKS[promise.claim][0]
        texts[promise.claim] = f"{words}, where: {conditions}" if conditions else words
    return texts


def largest_disturbance(scenario: Scenario) -> float:
    """Return the largest |Delta| of a scenario, length per time."""
    delta = scenario.flow.disturbance
    return 0.0 if delta is None else float(np.hypot(*delta.amplitude))


def truth_of(scenario: Scenario) -> Truth:
    """Return theta, KD and GammaD of a scenario."""
    vehicle = scenario.vehicle
    values = scenario.flow.parameters, vehicle.feedback, vehicle.feedforward
    return Truth(*map(np.array, values))


def checked_promises(scenario: Scenario, **solver: Any) -> dict[str, float]:
    """Return the ratio of each promise whose conditions a scenario meets, above 1 if broken."""
    names = [
        promise.claim
        for promise in scenario.learning.row.promises
        if all(CONDITIONS[condition][1](scenario) for condition in promise.conditions)
    ]
    if not names:
        return {}
    law = LawRun(scenario, simulate(scenario, **solver))
    return {name: CHECKS[name][1](law) for name in names}
