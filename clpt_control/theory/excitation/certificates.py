"""How fast V must fall over a window: exactly, and guaranteed.

Axis by axis, with k = KD_i, w the joint regressor and S = diag(1, I/sqrt(gamma)),

    exact       V(t+T) / V(t) <= |S Phi(t+T, t) S^-1|^2, attained
    drop        1 - that = smallest eigenvalue of 2 k S^-1 (int Phi_e^T Phi_e) S^-1,
                from V' = -k e^2, Eq. (25); Phi_e is the row of e, and no digits are lost
    guaranteed  rho = k min(1, gamma) lambda_min(G) / (1 + q^2),  q = gamma wbar^2 T / k,
                G = int R^T R,  R(s) = [e^{-k (s-t)}, (int_t^s e^{-k (s-r)} w(r) dr)^T]

Why: R x_0 = e + gamma F, F(s) = int_t^s e^{-k (s-r)} w^T(r) int_t^r w e, and
|F| <= |e| wbar^2 T/k in L2, so that x_0^T G x_0 <= (1 + q)^2 int e^2 <= 2 (1 + q^2) int e^2,
while V falls by k int e^2.  R is the row of e in Phi where adaptation rests (gamma = 0): the
output injection of Theorem 3.3.  V is the sum over axes, so the worst axis counts.  wbar is the
largest |w| at the nodes.

From the drop of V over a window follow bounds under a disturbance, and times:

    limsup |e| <= T Dmax (1 + 1/(1 - sqrt(1 - rho)))              Theorem 3.4, corrected
    |eta(t + n T)| <= sqrt(2 gamma V(t)) (1 - drop)^{n/2}         from V, Eq. (24)

The first holds because v = sqrt(2 V) obeys v' <= |Delta| beside the linear
part: from window to window v <= sqrt(1 - rho) v + T Dmax, and within a window v
grows by T Dmax at most.  It asks that w does not depend on Delta.

Phi is found by collocation at the Gauss-Legendre nodes of each piece of length h, the implicit
Runge-Kutta method of order 2 NODES.  Within a piece eta moves along the w at the nodes, the rows of
W, so that only e at the nodes, E, is to be solved for; with G = W W^T and the method's a, b,
entries of a and G multiplied one by one in a*G,

    (I + h k a + gamma h^2 a (a*G)) E = e + h a W eta
    e   -> e + h b (W eta - k E - gamma h (a*G) E)
    eta -> eta - gamma h sum_j b_j w_j E_j
"""

from dataclasses import dataclass
from functools import cache

import numpy as np

from ...arguments import public
from ...errors import ScenarioError
from ...scenario.experiment import Scenario
from .regressor import Regressor, Source, joint_regressor

TURN = 10.0  # radians that e and eta may turn within a piece
MOST = 20000  # pieces


@dataclass(frozen=True)
class Certificate:
    """What one window does to V, for one trajectory, axes ``"x1"`` and ``"x2"``."""

    start: float  # of the window, units.time
    window: float  # its length
    trajectory: str  # that w was taken from: w holds z, which depends on the learner
    # axis -> exact 1 - V(t+T)/V(t) at worst, with all its digits
    drops: dict[str, float]
    rhos: dict[str, float]  # axis -> the guaranteed drop
    # whether Delta, or a flow beside theta phi, adds to V' as well
    disturbed: bool = False

    def __repr__(self) -> str:
        worst = f"V falls to {self.contraction:.6g} of itself at worst"
        when = f"t = {self.start:g} to {self.start + self.window:g}"
        but = ", but for what the disturbance adds" if self.disturbed else ""
        return f"<Certificate: {worst}, {when}{but}>"

    @property
    def contraction(self) -> float:
        """Exact V(t+T)/V(t) at worst, over both axes."""
        return 1 - self.drop

    @property
    def drop(self) -> float:
        """Exact 1 - V(t+T)/V(t) at worst, over both axes."""
        return min(self.drops.values())

    @property
    def rho(self) -> float:
        """Guaranteed: V(t+T) <= (1 - rho) V(t)."""
        return min(self.rhos.values())


def smallest_eigenvalue(rows: np.ndarray, weights: np.ndarray) -> np.ndarray:
    """Return the smallest eigenvalue of the Gramian of rows, 0 where they are too few."""
    flat = np.sqrt(weights)[..., None] * rows
    flat = flat.reshape(*rows.shape[:-3], -1, rows.shape[-1])
    if flat.shape[-2] < flat.shape[-1]:
        return np.zeros(flat.shape[:-2])
    return np.linalg.svd(flat, compute_uv=False)[..., -1] ** 2


def gains_of_w(scenario: Scenario) -> np.ndarray:
    """Return the N + 2 gains with which a law adapts the parameter beside each of w; 0: held."""
    learning, gains = scenario.learning, scenario.learning.used_gains
    flow = 0.0 if learning.row.given_estimate else gains.parameters
    return np.array([*[flow] * scenario.basis.N, gains.feedback, gains.feedforward])


def refuse_turns(turns: float) -> None:
    """Refuse a window in which e and eta turn so many radians that they cannot be followed."""
    if turns > MOST * TURN:
        raise ScenarioError(
            f"e and eta turn {turns:.3g} rad in a window, too many to follow; give a shorter one, "
            "waypoints nearer to 0, or smaller gains"
        )


def finely(w: np.ndarray, weights: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return w (..., pieces, nodes, n) and weights of pieces in which e and eta turn at most TURN.

    A gain of 1 is in w.  Pieces are cut evenly; w is the polynomial through its nodes.
    """
    turns = np.sqrt(np.max(np.sum(w**2, axis=-1), initial=0.0)) * weights.sum(axis=1)
    refuse_turns(turns.sum())
    parts, (pieces, nodes) = int(np.ceil(max(1.0, turns.max() / TURN))), weights.shape
    node = np.polynomial.legendre.leggauss(nodes)[0]
    basis = np.polynomial.legendre.legvander
    fine = (2 * np.arange(parts)[:, None] + 1 + node) / parts - 1
    between = basis(fine, nodes - 1) @ np.linalg.inv(basis(node, nodes - 1))
    w = (between @ w[..., None, :, :]).reshape(
        *w.shape[:-3], pieces * parts, nodes, w.shape[-1]
    )
    return w, np.repeat(weights / parts, parts, axis=0)


@cache
def collocation(nodes: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the Gauss method's a (nodes, nodes) and b (nodes,) on a step of length 1."""
    legendre = np.polynomial.legendre
    c, weight = legendre.leggauss(nodes)
    # of P_j to each node
    integrals = legendre.legval(c, legendre.legint(np.eye(nodes), lbnd=-1))
    a = integrals.T @ np.linalg.inv(legendre.legvander(c, nodes - 1))
    return a / 2, weight / 2


def propagate(
    w: np.ndarray, k: np.ndarray, gain: float, lengths: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the row of e in Phi at the nodes, (..., pieces, nodes, n + 1), and Phi at the end.

    w (..., pieces, nodes, n) stands at the Gauss-Legendre nodes of pieces with these lengths
    (pieces,), k (...) is the feedback gain; Phi = I at the start.
    """
    *batch, pieces, nodes, n = w.shape
    a, b = collocation(nodes)
    k = np.asarray(k)[..., None, None]
    rows = np.empty((*batch, pieces, nodes, n + 1))
    end = np.broadcast_to(np.eye(n + 1), (*batch, n + 1, n + 1)).copy()
    e, eta = end[..., :1, :], end[..., 1:, :]
    for piece in range(pieces):
        h, W = lengths[piece], w[..., piece, :, :]
        Wt = np.swapaxes(W, -1, -2)
        fed_back, pushed = gain * h * a * (W @ Wt), W @ eta
        system = np.eye(nodes) + h * a @ (k * np.eye(nodes) + fed_back)
        E = np.linalg.solve(system, e + h * a @ pushed)
        e += h * b[None] @ (pushed - k * E - fed_back @ E)
        eta -= gain * h * (Wt * b) @ E
        rows[..., piece, :, :] = E
    return rows, end


def worst_drop(
    w: np.ndarray, k: np.ndarray, gains: np.ndarray, weights: np.ndarray
) -> np.ndarray:
    """Return the drop of V over a window by a linear law with a gain for each of w (..., n).

    With w_j times the root of gamma_j, and the error of parameter j over it, one gain of 1 remains;
    what has no gain does not adapt.
    """
    adapted = gains > 0
    w, weights = finely(np.sqrt(gains[adapted]) * w[..., adapted], weights)
    rows, _ = propagate(w, k, 1.0, weights.sum(axis=1))
    return 2 * k * smallest_eigenvalue(rows, weights)


def window_drops(
    w: np.ndarray, weights: np.ndarray, KD: np.ndarray, gain: float
) -> tuple[np.ndarray, np.ndarray]:
    """Return the drop of V over a window, exact and guaranteed, each (2, ...), axis first.

    w (2, ..., pieces, nodes, n), of what adapts, stands at Gauss-Legendre nodes with weights
    (pieces, nodes).
    """
    k = np.asarray(KD, dtype=float).reshape(2, *[1] * (w.ndim - 4))
    drop = worst_drop(w, k, np.full(w.shape[-1], gain), weights)
    lengths = weights.sum(axis=1)
    filtered, _ = propagate(w, k, 0.0, lengths)
    q = gain * np.sum(w**2, axis=-1).max((-1, -2)) * lengths.sum() / k
    return drop, k * min(1.0, gain) * smallest_eigenvalue(filtered, weights) / (
        1 + q**2
    )


def refuse_unproved(scenario: Scenario) -> None:
    """Refuse what adds to V' beside the theorems' own terms."""
    learning, fixes = scenario.learning, scenario.localization
    limited = scenario.vehicle.max_speed is not None
    refused = {
        "localization.noise": fixes is not None and fixes.noise > 0,
        "learning.gain = 0": learning.gain == 0,
        "learning.sample": learning.sample is not None,
        "learning.hedging = false": limited and not scenario.hedged,
    }
    if why := next((why for why, holds in refused.items() if holds), ""):
        raise ScenarioError(
            f"no certificate: {why} changes V' of the theorems; leave it out"
        )


@public
def certificate(
    source: Source | Regressor, window: float | None = None, start: float | None = None
) -> Certificate:
    """Certify the decay of V over one window of a run.

    For the learned-flow law all parameters adapt, for the known-flow law K and
    Gamma alone.

    Parameters
    ----------
    source : Scenario, xarray.Dataset or Regressor
        A scenario is run from its own initial values; a run is read.
    window, start : float, optional
        Length and start, units.time; by default the second cycle.

    Returns
    -------
    Certificate
        For that trajectory: `contraction`, the exact V(t+T)/V(t) at worst, `drop`, 1 less that
        with all its digits, and `rho`, a guaranteed drop. With a
        disturbance (`disturbed`) all of it is said of the learner without; see `ultimate_bound`.

    Raises
    ------
    ScenarioError
        If the window does not fit into the run or holds too many turns, or the law is not
        one of the paper's, or the speed is limited without hedging.
    DataError
        If the dataset is no run.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> found = clpt.theory.certificate(clpt.paper_scenario(), 60.0, 0.0)
    >>> 0 < found.rho < found.drop < 1
    True
    """
    along = (
        source
        if isinstance(source, Regressor)
        else joint_regressor(source, window, start)
    )
    scenario, gains = along.scenario, along.scenario.learning.used_gains
    law = scenario.learning.law
    if along.python_parts or law not in ("learned-flow", "known-flow") or not gains.one:
        raise ScenarioError(
            "no certificate: it is of the paper's two laws with one gain for all, the run has "
            f"{along.python_parts or f'the law {law}'}"
            + ("" if gains.one else " with a gain each")
        )
    refuse_unproved(scenario)
    adapted = slice(
        scenario.basis.N if scenario.learning.row.given_estimate else 0, None
    )
    w, KD = along.w[..., adapted], np.array(scenario.vehicle.feedback)
    found = window_drops(w, along.weights, KD, gains.parameters)
    drops, rhos = (dict(zip(("x1", "x2"), one.tolist(), strict=True)) for one in found)
    first, last = along.cuts[[0, -1]].tolist()
    disturbed = scenario.flow.disturbance is not None or scenario.flow.field is not None
    return Certificate(first, last - first, along.trajectory, drops, rhos, disturbed)


@public
def ultimate_bound(window: float, largest_disturbance: float, drop: float) -> float:
    """Bound ``|e|`` in the long run under a disturbance.

    Parameters
    ----------
    window : float
        Length T of the windows, time.
    largest_disturbance : float
        Dmax = sup ``|Delta|``, Euclidean norm, length per time.
    drop : float
        rho, or the exact drop, of every window, in [0, 1].

    Returns
    -------
    float
        The bound on limsup ``|e|``, length; inf where the drop is zero.

    Raises
    ------
    ScenarioError
        If the drop is not in [0, 1].

    Examples
    --------
    >>> import clpt_control as clpt
    >>> round(clpt.theory.ultimate_bound(2.0, 0.5, 0.75), 12)
    3.0
    """
    if not 0 <= drop <= 1:
        raise ScenarioError(f"drop = {drop:g}: must lie in [0, 1]")
    if drop == 0:
        return float("inf")
    # 1 - sqrt(1 - rho) = rho/(1 + sqrt(1 - rho)) keeps the digits of a small rho
    return float(window * largest_disturbance * (1 + (1 + np.sqrt(1 - drop)) / drop))


def time_to_tenth(window: float, drop: float) -> float:
    """Return the time until |eta| must be a tenth: whole windows of this drop; inf for none."""
    with np.errstate(divide="ignore"):
        windows = 2 * np.log(0.1) / np.log1p(-np.float64(drop))
    return float(window * max(1.0, np.ceil(windows * (1 - 1e-12))))
