"""How fast V must fall over a window: exactly, and guaranteed.

Axis by axis, with k = KD_i, w the joint regressor and S = diag(1, I/sqrt(gamma)),

    exact       V(t+T) / V(t) <= |S Phi(t+T, t) S^-1|^2, attained
    drop        1 - that = smallest eigenvalue of 2 k S^-1 (int Phi_e^T Phi_e) S^-1,
                from V' = -k e^2, Eq. (25); Phi_e is the row of e, and no digits are lost
    guaranteed  rho = k min(1, gamma) lambda_min(G) / (1 + q^2),  q = gamma wbar^2 T / k,
                G = int R^T R,  R(s) = [e^{-k (s-t)}, (int_t^s e^{-k (s-r)} w(r) dr)^T]
    sharper     2 k lambda_min(S^-1 G S^-1) / (1 + q)^2,  q = gamma int |w|^2 / (sqrt(2) k)

Why: R x_0 = e + gamma F, F(s) = int_t^s e^{-k (s-r)} w^T(r) int_t^r w e, and
|F| <= |e| wbar^2 T/k, or |e| int |w|^2 / (sqrt(2) k), in L2, so that
x_0^T G x_0 <= (1 + q)^2 int e^2 <= 2 (1 + q^2) int e^2, while V falls by k int e^2.
R is the row of e in Phi where adaptation rests (gamma = 0): the output injection
of Theorem 3.3.  V is the sum over axes, so the worst axis counts.  wbar is the
largest |w| at the nodes; `sharper` needs no such bound.
"""

from dataclasses import dataclass

import numpy as np

from ...errors import ScenarioError
from .recorded import Source
from .regressor import Regressor, joint_regressor
from .transition import error_matrices, propagate

TURN = 10.0  # radians that e and eta may turn within a piece
MOST = 20000  # pieces


@dataclass(frozen=True)
class Certificate:
    """What one window does to V, for one trajectory.

    Attributes
    ----------
    start, window : float
        The window [start, start + window], units.time.
    trajectory : str
        Which trajectory w was taken from: w holds z, which depends on the learner.
    transition : dict
        ``"x1"`` and ``"x2"`` -> Phi(t+T, t) of (e_i, eta_i); its eigenvalues
        are Floquet multipliers where w has the period T.
    contractions, drops, rhos, sharper : dict
        By axis: exact V(t+T)/V(t) at worst, 1 less that with all its digits,
        the guaranteed drop rho, and a sharper guaranteed drop.
    """

    start: float
    window: float
    trajectory: str
    transition: dict[str, np.ndarray]
    contractions: dict[str, float]
    drops: dict[str, float]
    rhos: dict[str, float]
    sharper: dict[str, float]

    @property
    def contraction(self) -> float:
        """Exact V(t+T)/V(t) at worst, over both axes."""
        return max(self.contractions.values())

    @property
    def drop(self) -> float:
        """Exact 1 - V(t+T)/V(t) at worst, over both axes."""
        return min(self.drops.values())

    @property
    def rho(self) -> float:
        """Guaranteed: V(t+T) <= (1 - rho) V(t)."""
        return min(self.rhos.values())


def window_drops(
    phi: np.ndarray,
    z: np.ndarray,
    zc: np.ndarray,
    weights: np.ndarray,
    KD: np.ndarray,
    gain: float,
    adapted: slice = slice(None),
) -> dict[str, np.ndarray]:
    """Measure what a window does to V, axis by axis.

    Parameters
    ----------
    phi : ndarray, shape (..., pieces, nodes, N)
        Basis functions at Gauss-Legendre nodes, whatever trajectory they are from.
    z, zc : ndarray, shape (..., pieces, nodes, 2)
        Predicted and desired position, length.
    weights : ndarray, shape (pieces, nodes)
        Quadrature weights, time.
    KD : array_like, shape (2,)
        Feedback gains, per time.
    gain : float
        Adaptation gain gamma > 0.
    adapted : slice, optional
        Which of the N + 2 parameters adapt; all of them.

    Returns
    -------
    dict
        ``contraction``, ``drop``, ``rho``, ``sharper``, each shape (2, ...),
        and ``transition``, shape (2, ..., n, n); axis first.

    Examples
    --------
    >>> w = np.ones((1, 16, 1))
    >>> weights = np.polynomial.legendre.leggauss(16)[1][None] / 2
    >>> found = window_drops(w, w.repeat(2, -1), w.repeat(2, -1), weights, [1, 1], 0.5)
    >>> bool(np.all(found["rho"] <= found["drop"]))
    True
    """
    KD, lengths = np.asarray(KD, dtype=float), weights.sum(1)
    kept = np.concatenate([[0], 1 + np.arange(phi.shape[-1] + 2)[adapted]])
    moving, resting = (
        error_matrices(phi, z, zc, KD, g)[..., kept[:, None], kept] for g in (gain, 0.0)
    )
    w, root = resting[..., 0, 1:], np.sqrt(weights)[..., None]
    inside, transition = propagate(moving, lengths)
    filtered, _ = propagate(resting, lengths)
    scale = np.concatenate([[1.0], np.full(len(kept) - 1, gain**-0.5)])  # the diagonal of S

    def least(rows: np.ndarray) -> np.ndarray:
        """Smallest eigenvalue of the Gramian of rows."""
        flat = (root * rows).reshape(*rows.shape[:-3], -1, rows.shape[-1])
        return np.linalg.svd(flat, compute_uv=False)[..., -1] ** 2

    size = np.sum(w**2, axis=-1)
    k = KD.reshape(2, *[1] * (size.ndim - 3))
    q = gain * size.max((-1, -2)) * lengths.sum() / k
    q_sharper = gain * np.sum(weights * size, (-1, -2)) / (np.sqrt(2) * k)
    R = filtered[..., 0, :]
    norm = np.linalg.norm(transition * (scale[:, None] / scale), 2, axis=(-2, -1))
    return {
        "contraction": np.minimum(norm**2, 1.0),  # V never grows: V' = -k e^2
        "drop": 2 * k * least(inside[..., 0, :] / scale),
        "rho": k * min(1.0, gain) * least(R) / (1 + q**2),
        "sharper": 2 * k * least(R / scale) / (1 + q_sharper) ** 2,
        "transition": transition,
    }


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
        For that trajectory.

    Raises
    ------
    ScenarioError
        If the window does not fit into the run or holds too many turns.
    DataError
        If the dataset is no run.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> found = certificate(clpt.paper_scenario(), 60.0, 0.0)
    >>> 0 < found.rho < found.drop < 1
    True
    """
    along = source if isinstance(source, Regressor) else joint_regressor(source, window, start)
    scenario, gain = along.scenario, along.scenario.learning.gain
    turn = np.sqrt(gain * np.max(np.sum(along.w**2, -1)))
    if np.max(np.diff(along.cuts)) * turn > TURN:
        span = along.cuts[-1] - along.cuts[0]
        if span * turn / TURN > MOST:
            raise ScenarioError(
                f"window {span:g}: e and eta turn {span * turn:.3g} rad in it, too many to follow; "
                f"a window up to {MOST * TURN / turn:.3g} {scenario.units.time} can be certified"
            )
        along = _refined(along, TURN / turn)
    adapted = slice(scenario.basis.N if scenario.learning.law == "known-flow" else 0, None)
    found = window_drops(
        along.phi,
        along.z,
        along.zc,
        along.weights,
        np.array(scenario.vehicle.feedback),
        gain,
        adapted,
    )
    axes = ("x1", "x2")
    return Certificate(
        float(along.cuts[0]),
        float(along.cuts[-1] - along.cuts[0]),
        along.trajectory,
        dict(zip(axes, found["transition"], strict=True)),
        *(
            dict(zip(axes, map(float, found[name]), strict=True))
            for name in ("contraction", "drop", "rho", "sharper")
        ),
    )


def _refined(along: Regressor, longest: float) -> Regressor:
    """Cut the pieces shorter; w between nodes is the polynomial through them."""
    from scipy.interpolate import BarycentricInterpolator

    nodes = along.times.shape[1]
    node, weight = np.polynomial.legendre.leggauss(nodes)
    cuts = [along.cuts[:1]]
    parts: list[list[np.ndarray]] = [[], [], [], [], []]
    for k, (a, b) in enumerate(zip(along.cuts[:-1], along.cuts[1:], strict=True)):
        edges = np.linspace(a, b, int(np.ceil((b - a) / longest)) + 1)
        cuts.append(edges[1:])
        half = np.diff(edges)[:, None] / 2
        times = edges[:-1, None] + half * (1 + node)
        parts[0].append(times)
        parts[1].append(half * weight)
        inside = 2 * (times - a) / (b - a) - 1
        for part, values in zip(parts[2:], (along.phi, along.z, along.zc), strict=True):
            part.append(BarycentricInterpolator(node, values[k])(inside))
    times, weights, phi, z, zc = (np.concatenate(part) for part in parts)
    return Regressor(
        along.scenario, along.trajectory, np.concatenate(cuts), times, weights, phi, z, zc
    )
