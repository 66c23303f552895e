"""Promises of laws as predicates, which tests check along runs.

A row of the table of laws names its promises and their conditions.  A predicate returns a ratio
that is above 1 if a run breaks the promise:

    falls          V(t) <= V(s), s <= t
    settles        int e^T KD e <= V(0), so CLPE goes to zero
    mean square    int e^T KD e <= 2 V(0) + int d^T KD^-1 d,    d = F - theta_hat phi
    zone           int D^T KD D <= V(0), D = e - clip(e, -zone, zone)
    exponential    V(t) <= V(s) exp(-2 r(s) (t - s)), r the least of KD and of the pull
    level, balls   V(t) <= max(V(0), level); norms <= (1 + layer) times their limits
    shrinks        |eta_ik(t)| <= |eta_ik(s)|;  estimate: tr(d P^-1 d^T) does not rise
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from drawn_scenarios import NUMBERS, UNIFORM, drawn
from levels_of_laws import LEVELS

import clpt_control as clpt
from clpt_control.theory.laws.promises import largest_disturbance, truth_of

BROKEN = 1.001
TOLERANCES = {"rtol": 1e-9, "atol": 1e-12}
TIGHT = {"rtol": 1e-12, "atol": 1e-14}
FLOOR = 1e-9  # share of the initial value: error of the solver
QUADRATURE = 1.02  # largest ratio of a sum over samples to the integral
EXACT = 1e-5  # of the largest parameter
STEPS = 60  # times that are compared in pairs


@dataclass(frozen=True)
class LawRun:
    """A run of a scenario with the quantities that promises refer to."""

    scenario: clpt.Scenario
    run: Any = None

    @cached_property
    def p(self):
        """Parameters of the law."""
        return self.row.parameters_of(self.scenario.known_to_law)

    @property
    def row(self):
        """Row of the law in the table."""
        return self.scenario.learning.row

    @property
    def V(self):
        """V along the run."""
        return self.run.lyapunov.values

    @property
    def e(self):
        """CLPE along the run, shape (time, 2)."""
        return self.run.clpe.values

    @property
    def KD(self):
        """Feedback gains of the vehicle."""
        return np.array(self.scenario.vehicle.feedback)

    @property
    def estimate(self):
        """theta_hat along the run, shape (time, 2, N)."""
        return self.run.flow_parameters_estimate.values

    @property
    def error(self):
        """theta_hat - theta along the run, shape (time, 2, N)."""
        return self.estimate - self.run.flow_parameters.values

    def state(self, name):
        """Return a matrix of the law, shape (time, n, n)."""
        columns = self.run.state.str.match(rf"adaptation_{name}(\[|$)").values
        n = int(np.sqrt(np.count_nonzero(columns)))
        return self.run.states.values[:, columns].reshape(-1, n, n)

    def square_integral(self, values, weights):
        """Return the integral of sum weights values^2."""
        integrand = np.sum(weights * values**2, axis=1)
        return float(np.trapezoid(integrand, self.run.time.values))

    def dissipation(self, e, allowed):
        """Return the integral of e^T KD e over the allowed one."""
        return self.square_integral(e, self.KD) / (QUADRATURE * allowed + FLOOR)


def rise(values):
    """Return the largest ratio of a value to an earlier one."""
    values = values.reshape(len(values), -1)
    floor = FLOOR * np.max(values[0]) + FLOOR**2
    smallest = np.minimum.accumulate(values)
    return float(np.max((values + floor) / (smallest + floor)))


def mean_square(law):
    """Return int e^T KD e over 2 V(0) + int d^T KD^-1 d."""
    run = law.run
    positions, times = run.position.values, run.time.values
    modelled = clpt.currents.flow_velocity(law.scenario, positions, times, law.estimate)
    unmodelled = law.square_integral(run.true_flow.values - modelled, 1 / law.KD)
    return law.dissipation(law.e, 2 * law.V[0] + unmodelled)


def zone(law):
    """Return the integral of D^T KD D over V(0)."""
    e, width = law.e, law.p.zone
    return law.dissipation(e - np.clip(e, -width, width), law.V[0])


def decay_rate(law):
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


def exponential(law):
    """Return the largest ratio of V to the bound from an earlier time and its r."""
    every = max(1, len(law.V) // STEPS)
    t, V = law.run.time.values[::every], law.V[::every]
    rate = np.maximum(decay_rate(law)[::every], 0.0)
    elapsed = np.maximum(t - t[:, None], 0.0)  # a row for each earlier time
    bound = V[:, None] * np.exp(-2 * rate[:, None] * elapsed)
    floor = FLOOR * V[0] + FLOOR**2
    return float(np.max(np.triu((V + floor) / (bound + floor))))


def level(law):
    """Return the largest V over that of V(0) and the level of the disturbance."""
    largest = largest_disturbance(law.scenario)
    bound = LEVELS[law.row.name](law.p, truth_of(law.scenario), largest)
    return float(np.max(law.V) / max(law.V[0] + FLOOR, bound))


def balls(law):
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


def estimate(law):
    """Return the rise of tr(d P^-1 d^T)."""
    d = np.swapaxes(law.error, 1, 2)
    return rise(np.sum(d * np.linalg.solve(law.state("P"), d), axis=(1, 2)))


def readout(law):
    """Return the error of the valid readouts over the rounding error."""
    theta = law.run.flow_parameters.values
    valid = law.run.error_left.values <= 1 - law.p.margin
    error = np.abs(law.run.flow_parameters_readout.values[valid] - theta)
    size = np.max(np.abs([theta, law.error[0]]))
    return float(np.max(error, initial=0.0) / (EXACT * size))


CHECKS = {  # by the claim of a promise
    "falls": lambda law: rise(law.V),
    "settles": lambda law: law.dissipation(law.e, law.V[0]),
    "mean square": mean_square,
    "zone": zone,
    "exponential": exponential,
    "level": level,
    "balls": balls,
    "shrinks": lambda law: rise(abs(law.error)),
    "estimate": estimate,
    "readout": readout,
}


def true_or_adapted(scenario):
    """Return True if K and Gamma adapt or are the vehicle's own."""
    learning, vehicle = scenario.learning, scenario.vehicle
    gains = learning.feedback, learning.feedforward
    true = gains == (vehicle.feedback, vehicle.feedforward)
    return learning.adapt_gains or learning.row.at_fixes or true


def exact_positions(scenario):
    """Return True if positions are exact, also z(0) if it is a fix."""
    fixes, learning = scenario.localization, scenario.learning
    true_start = learning.position == scenario.vehicle.position
    exact = fixes is None or fixes.noise == 0
    return exact and (true_start or not learning.row.at_fixes)


def truth_within_limits(scenario):
    """Return True if the truth lies within the limits."""
    law = LawRun(scenario)
    return not law.row.doubt(law.p, truth_of(scenario))


def small_disturbance(scenario):
    """Return True if the disturbance is at most KD times the zone."""
    law, delta = LawRun(scenario), scenario.flow.disturbance
    small = delta is None or np.all(np.abs(delta.amplitude) <= law.KD * law.p.zone)
    return bool(bounded(scenario) and small)


def bounded(scenario):
    """Return True if the disturbance has a bound."""
    delta = scenario.flow.disturbance
    return scenario.flow.parameters is not None and (delta is None or delta.row.bounded)


CONDITIONS = {  # by the name that a promise has
    "spanned": lambda scenario: bounded(scenario) and scenario.flow.disturbance is None,
    "exact": exact_positions,
    "true": true_or_adapted,
    "within": truth_within_limits,
    "small": small_disturbance,
    "bounded": bounded,
    "uniform": lambda scenario: scenario.basis.lengths.min() >= UNIFORM,
}


def checked_promises(scenario, **solver):
    """Return the ratio of each promise whose conditions a scenario meets, above 1 if broken."""
    names = [
        promise.claim
        for promise in scenario.learning.row.promises
        if all(CONDITIONS[condition](scenario) for condition in promise.conditions)
    ]
    if not names:
        return {}
    law = LawRun(scenario, clpt.simulate(scenario, **solver))
    return {name: CHECKS[name](law) for name in names}


def ratios_of(scenario):
    """Return the ratio of each promise; one above 1 is that of a run with tight tolerances.

    A run that fails has no ratios.
    """
    try:
        ratios = checked_promises(scenario, **TOLERANCES)
        if max(ratios.values(), default=0.0) <= BROKEN:
            return ratios
        return checked_promises(scenario, **TIGHT)
    except clpt.SimulationError:
        return {}


def drawn_ratios(law, count, seed=0):
    """Yield drawn scenarios of a law, and the ratios of their promises."""
    random = np.random.default_rng(seed)
    for point in random.random((count, NUMBERS)):
        scenario = drawn(law, point)
        yield scenario, ratios_of(scenario)


def first_broken(law, count, seed=0):
    """Return the first drawn scenario that breaks a promise, and its ratios, or (None, {})."""
    for scenario, ratios in drawn_ratios(law, count, seed):
        if max(ratios.values(), default=0.0) > BROKEN:
            return scenario, ratios
    return None, {}
