"""Decay of V over a window: its exact drop, and the half-life of the errors.

Axis by axis, with k = KD_i, w the joint regressor and S = diag(1, I/sqrt(gamma)),

    exact       V(t+T) / V(t) <= |S Phi(t+T, t) S^-1|^2, attained
    drop        1 - that = smallest eigenvalue of 2 k S^-1 (int Phi_e^T Phi_e) S^-1, from
                V' = -k e^2, Eq. (25), with all its digits; Phi_e is the row of e

A loop with another error system (`error_system`) has Phi in coordinates in which V is half the sum
of squares.  In windows with one w the norm of the errors, the root of V, falls as |Phi^m|.

`transitions` computes Phi, `Certificate.ultimate_bound` the bound of Theorem 3.4, corrected.
"""

from bisect import bisect_left
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.polynomial import legendre

from ...base.errors import DataError, ScenarioError
from ...base.units import at_most, finite_or_none
from ...paper.scenario.experiment import Scenario
from .regressor import COEFFICIENTS, NODE, NODES, eigenvalues_of, scale_of
from .transitions import propagate

TURN = 10.0  # radians that e and eta may turn within a piece
MAX_PIECES = 20000
WINDOWS = 8  # of a half-life at most
ROUNDING = 1e-14  # of |Phi|
MAX_POWER = 10**15  # of Phi
MAX_CHANGE = 0.5  # of |Phi|, in finer pieces


@dataclass(frozen=True)
class Certificate:
    """Decay of V over one window for one trajectory, axes ``"x1"`` and ``"x2"``."""

    start: float  # of the window, units.time
    window: float  # its length
    # axis -> exact 1 - V(t+T)/V(t) at worst
    drops: dict[str, float]
    # Delta, a flow that theta phi does not span, or a held estimate adds to V'
    disturbed: bool
    # axis -> number of directions in which errors fall to a tenth within the run
    learned: dict[str, int]
    time_to_tenth: float | None  # of the root of V; None: never
    half_life: (
        float | None
    )  # of the root of V, if the window repeats; None: not excited
    overshoot: float  # root of V / (the first / 2^(t/half_life)), at most

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


def worst_drop(
    w: np.ndarray, k: np.ndarray, gains: np.ndarray, weights: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the drop of V by a linear law with a gain for each of w (..., n), and Phi.

    w_j is scaled by the root of gamma_j, the parameter error by its inverse; the gain is then 1.
    A parameter without a gain does not adapt.
    """
    w, weights = finely(w @ scale_of(gains), weights)
    return _drop_along(w[..., None, :], -np.asarray(k)[..., None, None], weights)


def _drop_along(
    W: np.ndarray, A: np.ndarray, weights: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the drop of V along W (..., pieces, nodes, m, n) in its coordinates, and Phi."""
    rows, transition = propagate(W, A, weights.sum(axis=1))
    # V' = -e^T Q e / 2, with Q = U^T U
    values, vectors = np.linalg.eigh(-A - A.mT)
    U = np.sqrt(np.maximum(values, 0))[..., None] * vectors.mT
    losses = U[..., None, None, :, :] @ rows.reshape(*W.shape[:-1], -1)
    losses = losses.reshape(rows.shape)
    weights = np.repeat(weights, W.shape[-2], axis=1)
    return eigenvalues_of(losses, weights)[..., 0], transition


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


def refuse_uncertified(excitation: Any) -> None:
    """Raise an error for errors that have no V' of the theorems, or of a verdict."""
    scenario = excitation.scenario
    if excitation.form:
        return
    if scenario is None:
        raise DataError(
            "no certificate: it is for the run of one scenario, or of=verdict. A team and signals "
            "have Gramians only"
        )
    law = scenario.learning.law
    if excitation.python_parts or law not in ("learned-flow", "known-flow"):
        raise ScenarioError(
            "no certificate: it is for the paper's two laws. The run has "
            f"{excitation.python_parts or f'the law {law}'}"
        )
    refuse_unproved(scenario)
    if not excitation.gains.any():
        raise ScenarioError("no certificate: the law adapts no parameter")


def drop_of(excitation: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return the drop of each axis over a window, and Phi, (axes, N, N)."""
    refuse_uncertified(excitation)
    form, weights = excitation.form, excitation.weights
    if form:
        by_rows = weights[:, :: form.W.rows]
        return _drop_along(excitation.scaled_W, form.scaled_A[None], by_rows)
    feedback = excitation.scenario.vehicle.feedback
    return worst_drop(excitation.w, feedback, excitation.gains, weights)


def _is_disturbed(excitation: Any) -> bool:
    """Return whether V' has e times a flow that the adapted parameters cannot follow.

    e' = -KD e + w^T eta + Delta + (theta - estimate) phi, the last where the estimate is held.
    """
    scenario = excitation.scenario
    if excitation.form:
        return False
    flow, learning = scenario.flow, scenario.learning
    if flow.disturbance is not None or flow.parameters is None:
        return True
    estimate = np.negative(scenario.learning_parameters)
    if learning.row.given_estimate:
        estimate = np.array(learning.theta_estimate or scenario.model_parameters)
    is_held = not excitation.gains[: scenario.basis.N].any()
    return is_held and not np.array_equal(flow.parameters, estimate)


def worsened(Phi: np.ndarray, by: Any) -> np.ndarray:
    """Return the singular values of Phi (axes, n, n), and more by what it may change."""
    return np.linalg.svd(Phi, compute_uv=False) + by


def certificate(excitation: Any) -> Certificate:
    """Certify the decay of V over the window of a joint regressor.

    All parameters of the learned-flow law adapt, and K and Gamma of the known-flow law.  Gains that
    are fixed are those of the vehicle.

    >>> import clpt_control as clpt
    >>> found = certificate(clpt.gramian(clpt.paper_scenario(), 60.0, 0.0))
    >>> 0 < found.drop < 1
    True
    """
    exact = excitation.exact
    form, span, settled = exact.form, exact.window, exact.change
    drop, Phi = drop_of(exact)
    if np.any(settled > MAX_CHANGE * np.linalg.norm(Phi, 2, axis=(1, 2))):
        raise DataError(
            "no certificate: W or e changes too fast in the window to be computed. Give a shorter "
            "window"
        )
    drop = np.maximum(drop - settled * (2 + settled), 0)
    # Phi^windows from e = 0: its small singular values are the directions that are learned
    windows = int(max(1.0, excitation.run_length / span * (1 + 1e-12)))
    power = np.linalg.matrix_power(Phi, windows)[..., form.W.rows if form else 1 :]
    learned = np.sum(worsened(power, windows * settled) <= 0.1, axis=-1)
    drops, counts = (
        dict(zip(excitation.names, values.tolist(), strict=True))
        for values in (drop, learned)
    )
    falls = np.inf, 1.0, np.inf
    if not any(excitation.idle.values()):
        falls = falls_of(Phi, drop, span, settled)
    half_life, overshoot, time = falls
    return Certificate(
        excitation.start,
        span,
        drops,
        _is_disturbed(excitation),
        counts,
        finite_or_none(time),
        finite_or_none(half_life),
        overshoot,
    )


def falls_of(
    Phi: np.ndarray, drop: np.ndarray, window: float, settled: float
) -> tuple[float, float, float]:
    """Return H, c, and the time to a tenth, of a root of V that is at most c 2^(-t/H) of the first.

    |Phi^m| is computed for `WINDOWS` windows, of which the best is used, and for the least m at
    which it is a tenth.
    """
    largest = np.minimum(1, worsened(Phi, settled)[:, :1])

    def norm(m: int) -> float:
        off = m * (ROUNDING + settled * largest ** max(0, m - 1))
        norms = worsened(np.linalg.matrix_power(Phi, m), off)[:, 0]
        by_drop = np.exp(m / 2 * np.log1p(-np.minimum(drop, 1 - ROUNDING)))
        return float(np.minimum(norms, by_drop).max())

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
