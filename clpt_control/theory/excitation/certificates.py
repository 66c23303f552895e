"""Decay of V over a window: its exact drop, and the half-life of the errors.

Axis by axis, with k = KD_i, w the joint regressor and S = diag(1, I/sqrt(gamma)),

    exact       V(t+T) / V(t) <= |S Phi(t+T, t) S^-1|^2, attained
    drop        1 - that = smallest eigenvalue of 2 k S^-1 (int Phi_e^T Phi_e) S^-1, from
                V' = -k e^2, Eq. (25), with all its digits; Phi_e is the row of e

A loop with another error system (`error_system`) has Phi in coordinates in which V is half the sum
of squares.  In windows with one w the norm of the errors, the root of V, falls as |Phi^m|.

`propagate` computes Phi, `Certificate.ultimate_bound` the bound of Theorem 3.4, corrected.
"""

from bisect import bisect_left
from dataclasses import dataclass
from functools import reduce
from typing import Any

import numpy as np
from numpy.polynomial import legendre
from scipy.linalg import expm

from ...base.errors import DataError, ScenarioError
from ...base.units import at_most, finite_or_none
from ...paper.scenario.experiment import Scenario
from .regressor import COEFFICIENTS, NODE, NODES, WEIGHT, eigenvalues_of, scale_of

TURN = 10.0  # radians that e and eta may turn within a piece
MAX_PIECES = 20000
WINDOWS = 8  # of a half-life at most
ROUNDING = 1e-14  # of |Phi|
MAX_POWER = 10**15  # of Phi
MAX_CHANGE = 0.5  # of |Phi| with fewer times
# a of the Gauss method on a step of length 1: integrals of P_j from -1 to each node, halved
INTEGRALS = legendre.legval(NODE, legendre.legint(np.eye(NODES), lbnd=-1)).T
COLLOCATION = INTEGRALS @ COEFFICIENTS / 2


@dataclass(frozen=True)
class Certificate:
    """Decay of V over one window for one trajectory, axes ``"x1"`` and ``"x2"``."""

    start: float  # of the window, units.time
    window: float  # its length
    # axis -> exact 1 - V(t+T)/V(t) at worst
    drops: dict[str, float]
    # Delta, or a flow that theta phi does not span, adds to V'
    disturbed: bool
    # axis -> number of directions in which errors fall to a tenth within the run
    learned: dict[str, int]
    time_to_tenth: float | None  # of the norm of all errors; None: never
    half_life: float | None  # of this norm, if the window repeats; None: not excited
    overshoot: float  # norm / (first norm / 2^(t/half_life)), at most

    def __repr__(self) -> str:
        span = f"t = {self.start:g} to {self.start + self.window:g}"
        but = ", but for what the disturbance adds" if self.disturbed else ""
        share = at_most(self.contraction, 6)
        return f"<Certificate: V falls to {share} of itself at worst, {span}{but}>"

    @property
    def contraction(self) -> float:
        """Exact V(t+T)/V(t) at worst, over both axes."""
        return 1 - self.drop

    @property
    def drop(self) -> float:
        """Exact 1 - V(t+T)/V(t) at worst, over both axes."""
        return min(self.drops.values())

    def ultimate_bound(self, largest_disturbance: float) -> float:
        """Return the bound on limsup |e| under a disturbance, if every window drops like this.

        `largest_disturbance` is sup |Delta|.
        """
        if self.drop <= 0:
            return np.inf
        # v = sqrt(2 V) rises by T Dmax within a window and is multiplied by sqrt(1 - rho);
        # 1 - sqrt(1 - rho) = rho/(1 + sqrt(1 - rho)) keeps the digits of a small rho
        windows = 1 + (1 + np.sqrt(self.contraction)) / self.drop
        return float(self.window * largest_disturbance * windows)


def halving_text(bound: Any, unit: str) -> str:
    """Return the half-life of errors of a bound, and their overshoot."""
    half_life = f"{at_most(bound.half_life)} {unit}".rstrip()
    factor = at_most(bound.overshoot)
    return f"errors of parameters halve at least every {half_life}, but for a factor {factor},"


def refuse_turns(turns: float) -> None:
    """Raise an error for a window in which e and eta turn too many radians."""
    if turns > MAX_PIECES * TURN:
        raise ScenarioError(
            f"e and eta turn {turns:.3g} rad in a window, too many to compute. Give a shorter one, "
            "waypoints nearer to 0, or smaller gains"
        )


def finely(w: np.ndarray, weights: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return w (..., pieces, nodes, n) and weights of pieces that turn e and eta by at most TURN.

    w includes the roots of the gains.  Each piece is divided evenly; w is interpolated by the
    polynomial through its nodes.
    """
    largest = np.sqrt(np.max(np.sum(w**2, axis=-1), initial=0.0))
    turns = largest * weights.sum(axis=1)
    refuse_turns(turns.sum())
    division = int(np.ceil(max(1.0, turns.max() / TURN)))
    fine_node = (2 * np.arange(division)[:, None] + 1 + NODE) / division - 1
    interpolation = legendre.legvander(fine_node, NODES - 1) @ COEFFICIENTS
    w = interpolation @ w[..., None, :, :]
    w = w.reshape(*w.shape[:-4], -1, NODES, w.shape[-1])
    return w, np.repeat(weights / division, division, axis=0)


def propagate(
    w: np.ndarray, k: np.ndarray, lengths: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the row of e in Phi at the nodes, (..., pieces, nodes, n + 1), and Phi at the end.

    w (..., pieces, nodes, n) is given at the Gauss-Legendre nodes of pieces with these lengths
    (pieces,) and with the roots of the gains; k (...) is the feedback gain; Phi = I at the start.
    The implicit Runge-Kutta method of order 2 NODES is reduced to e at the nodes, E, because eta
    moves along w; with G = W W^T, entries of a and G multiplied one by one in a*G, on a piece of
    length h

        (I + h k a + h^2 a (a*G)) E = e + h a W eta
        e   -> e + h b (W eta - k E - h (a*G) E)
        eta -> eta - h sum_j b_j w_j E_j
    """
    *batch, count, _, n = w.shape
    k = np.asarray(k)[..., None, None]
    rows = np.empty((*batch, count, NODES, n + 1))
    end = np.broadcast_to(np.eye(n + 1), (*batch, n + 1, n + 1)).copy()
    e, eta = end[..., :1, :], end[..., 1:, :]
    identity, a, b = np.eye(NODES), COLLOCATION, WEIGHT / 2
    for j in range(count):
        h = lengths[j]
        W = w[..., j, :, :]
        forcing = W @ eta
        damping = k * identity + h * a * (W @ W.mT)
        system = identity + h * a @ damping
        E = np.linalg.solve(system, e + h * a @ forcing)
        e += h * b[None] @ (forcing - damping @ E)
        eta -= h * (W.mT * b) @ E
        rows[..., j, :, :] = E
    return rows, end


def worst_drop(
    w: np.ndarray, k: np.ndarray, gains: np.ndarray, weights: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the drop of V by a linear law with a gain for each of w (..., n), and Phi.

    w_j is scaled by the root of gamma_j, the parameter error by its inverse; the gain is then 1.
    A parameter without a gain does not adapt.
    """
    w, weights = finely(w @ scale_of(gains), weights)
    rows, transition = propagate(w, k, weights.sum(axis=1))
    return 2 * k * eigenvalues_of(rows, weights)[..., 0], transition


def refuse_unproved(scenario: Scenario) -> None:
    """Raise an error for terms in V' that the theorems do not have."""
    learning, fixes = scenario.learning, scenario.localization
    limited = scenario.vehicle.max_speed is not None
    refused = {
        "localization.noise": fixes is not None and fixes.noise > 0,
        "learning.gain = 0": learning.gain == 0,
        "learning.sample": learning.sample is not None,
        "learning.hedging = false": limited and not scenario.hedged,
    }
    for setting, present in refused.items():
        if present:
            raise ScenarioError(
                f"no certificate: {setting} changes V' of the theorems. Leave it out"
            )
    for name in ("feedback", "feedforward"):
        fixed = getattr(learning.used_gains, name) == 0
        if fixed and getattr(learning, name) != getattr(scenario.vehicle, name):
            raise ScenarioError(
                f"no certificate: learning.{name} is fixed and differs from "
                f"vehicle.{name}, so CLPE "
                "does not vanish. Fix it at the vehicle's value"
            )


def _of_paper(excitation: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return the drop of each axis of one of the paper's two laws, and Phi, (1, axes, n, n)."""
    scenario = excitation.scenario
    if scenario is None:
        raise DataError(
            "no certificate: it is for the run of one scenario, or of=verdict. A team and signals "
            "have Gramians only"
        )
    law, gains = scenario.learning.law, excitation.gains
    if excitation.python_parts or law not in ("learned-flow", "known-flow"):
        raise ScenarioError(
            "no certificate: it is for the paper's two laws. The run has "
            f"{excitation.python_parts or f'the law {law}'}"
        )
    refuse_unproved(scenario)
    if not gains.any():
        raise ScenarioError("no certificate: the law adapts no parameter")
    feedback = np.array(excitation.feedback)
    drop, Phi = worst_drop(excitation.w, feedback, gains, excitation.weights)
    return drop, Phi[None]


def _of_errors(excitation: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return the drop of an error system along a recorded run, and Phi, (4, 1, n, n).

    W is its mean between times: of all, of the samples, of every second one, and of the others.  A
    jump between samples moves to and fro by half a step, as far as it may be off.
    """
    form, cuts = excitation.form, excitation.cuts
    m, n = form.W.shape
    ends = form.left @ excitation.w.reshape(-1, 2, m, n) @ form.right
    W = np.append(ends[:, 0], ends[-1:, 1], axis=0)

    def chain(first: int, step: int) -> list[np.ndarray]:
        at = np.unique([0, *range(first, len(W), step), len(W) - 1])
        mean = (W[at[1:]] + W[at[:-1]]) / 2
        rates = np.zeros((len(mean), m + n, m + n))
        rates[:, :m, :m] = form.scaled_A
        rates[:, :m, m:], rates[:, m:, :m] = mean, -mean.mT
        steps = expm(np.diff(cuts[at])[:, None, None] * rates)
        return [reduce(np.matmul, steps[::-1])]

    # all points, one of which is inside each step; the samples; every second one, from either
    steps = (0, 1), (0, 2), (0, 4), (2, 4)
    Phi = np.array([chain(*step) for step in steps])
    if np.any(change_of(Phi) > MAX_CHANGE * np.linalg.norm(Phi[0], 2, axis=(1, 2))):
        raise DataError(
            "no certificate: the samples are too far apart. Give a run with more times"
        )
    return 1 - np.minimum(1, worsened(Phi)[:, 0]) ** 2, Phi


def change_of(Phi: np.ndarray) -> np.ndarray:
    """Return the largest norm of a change from the first of Phi to another, of each axis."""
    return np.linalg.norm(Phi - Phi[0], 2, axis=(2, 3)).max(axis=0)


def worsened(Phi: np.ndarray) -> np.ndarray:
    """Return the singular values of the first of Phi, (axes, n), and more by any change of it."""
    return np.linalg.svd(Phi[0], compute_uv=False) + change_of(Phi)[:, None]


def certificate(excitation: Any) -> Certificate:
    """Certify the decay of V over the window of a joint regressor.

    All parameters of the learned-flow law adapt, and K and Gamma of the known-flow law.  Gains that
    are fixed are those of the vehicle.

    >>> import clpt_control as clpt
    >>> found = certificate(clpt.gramian(clpt.paper_scenario(), 60.0, 0.0))
    >>> 0 < found.drop < 1
    True
    """
    form, flow = excitation.form, excitation.scenario and excitation.scenario.flow
    span = excitation.window
    drop, Phi = (_of_errors if form else _of_paper)(excitation)
    # Phi^windows from e = 0: its small singular values are the directions that are learned
    windows = int(max(1.0, excitation.run_length / span * (1 + 1e-12)))
    power = np.linalg.matrix_power(Phi, windows)[..., form.W.rows if form else 1 :]
    remaining = worsened(power)
    learned = np.sum(remaining <= 0.1, axis=-1)
    drops, counts = (
        dict(zip(excitation.names, values.tolist(), strict=True))
        for values in (drop, learned)
    )
    falls = np.inf, 1.0, np.inf
    if not any(excitation.idle.values()):
        falls = falls_of(Phi, drop, span)
    half_life, overshoot, time = falls
    return Certificate(
        excitation.start,
        span,
        drops,
        bool(flow) and (flow.disturbance is not None or flow.parameters is None),
        counts,
        finite_or_none(time),
        finite_or_none(half_life),
        overshoot,
    )


def falls_of(
    Phi: np.ndarray, drop: np.ndarray, window: float
) -> tuple[float, float, float]:
    """Return H, c, and the time to a tenth, of errors that are at most c 2^(-t/H) of the first.

    |Phi^m| is computed for `WINDOWS` windows, of which the best is used, and for the least m at
    which it is a tenth.
    """

    def norm(m: int) -> float:
        norms = worsened(np.linalg.matrix_power(Phi, m))[:, 0]
        by_drop = np.exp(m / 2 * np.log1p(-np.minimum(drop, 1 - ROUNDING)))
        return float(np.minimum(norms + m * ROUNDING, by_drop).max())

    norms = np.array([norm(m) for m in range(WINDOWS + 1)])
    times = window * np.arange(1, WINDOWS + 1)
    best = np.max(-np.log2(norms[1:]) / times)
    # within a window errors are at most those at its start
    overshoot = np.max(2 ** (best * times) * norms[:-1])
    m = bisect_left(range(MAX_POWER), -0.1, key=lambda m: -norm(m))
    with np.errstate(divide="ignore"):
        half_life = 1 / best
    by_half_life = half_life * np.log2(10 * overshoot)
    return half_life, overshoot, min(window * m, by_half_life)
