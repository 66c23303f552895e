"""The error system along a trajectory: its matrix A and its transition matrix, of Eq. (28).

    [e_i, eta_i]' = A_i(t) [e_i, eta_i],    A_i = [[-k, w^T], [-gamma w, 0]],    k = KD_i
    eta_i = [theta_i + alpha_i, K_i - KD_i, GammaD_i - Gamma_i],    w of Eq. (31)

A is read off `error_system` and `parameter_system`: their functions are linear in (e, eta), so
a call on a unit vector yields a column, and one on e = (1, 1) yields w.  The two axes do not
meet.  Phi is found by collocation at the Gauss-Legendre nodes of each piece of length h, the
implicit Runge-Kutta method of order 2 NODES.  Within a piece eta moves along the w at the nodes,
the rows of W, so that only e at the nodes, E, is to be solved for; with G = W W^T and the
method's a, b, entries of a and G multiplied one by one in a*G,

    (I + h k a + gamma h^2 a (a*G)) E = e + h a W eta
    e   -> e + h b (W eta - k E - gamma h (a*G) E)
    eta -> eta - gamma h sum_j b_j w_j E_j
"""

from collections.abc import Callable
from functools import cache

import numpy as np

from ...arguments import numbers, public
from ...blocks.clpe import error_system, parameter_system
from ...equations.at_many import on_arrays
from ...errors import ArgumentError


@public
def error_matrices(
    phi: np.ndarray, z: np.ndarray, zc: np.ndarray, KD: np.ndarray, gain: float
) -> np.ndarray:
    """Read A(t) of Eq. (28), axis by axis, off the blocks.

    Parameters
    ----------
    phi : ndarray, shape (..., N)
        Basis functions at the vehicle.
    z, zc : ndarray, shape (..., 2)
        Predicted and desired position, length.
    KD : array_like, shape (2,)
        Feedback gains, per time.
    gain : float
        Adaptation gain gamma; 0 leaves the parameters at rest.

    Returns
    -------
    ndarray, shape (2, ..., N + 3, N + 3)
        Axis first; the states are e_i and that axis's N + 2 of eta.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> phi, z, zc = np.array([0.5]), np.array([2, 2]), np.array([3, 3])
    >>> clpt.theory.error_matrices(phi, z, zc, [1, 1], 2.0)[0]
    array([[-1. ,  0.5,  2. ,  3. ],
           [-1. ,  0. ,  0. ,  0. ],
           [-4. ,  0. ,  0. ,  0. ],
           [-6. ,  0. ,  0. ,  0. ]])
    """
    phi, KD = numbers("phi", phi, None), numbers("KD", KD, 2)
    z, zc = numbers("z", z, 2), numbers("zc", zc, 2)
    N, shape = phi.shape[-1], phi.shape[:-1]
    for name, value in (("z", z), ("zc", zc)):
        if value.shape[:-1] != shape:
            raise ArgumentError(
                f"{name}: has shape {value.shape}; must be {(*shape, 2)}, as phi is"
            )
    rates = _error_rates(phi, z, zc, KD, gain)
    A = np.empty((2, *shape, N + 3, N + 3))
    for axis, states in enumerate(axis_states(N)):
        for column, state in enumerate(states):
            unit = np.zeros((2 * N + 6, *shape))
            unit[state] = 1.0
            A[axis, ..., column] = np.moveaxis(rates(unit)[states], 0, -1)
    return A + 0.0  # without -0


def regressors(phi: np.ndarray, z: np.ndarray, zc: np.ndarray) -> np.ndarray:
    """Return w of Eq. (31) off the blocks, eta' = -w e for gamma = 1: (2, ..., N + 2)."""
    N, shape = phi.shape[-1], phi.shape[:-1]
    unit = np.zeros((2 * N + 6, *shape))
    unit[:2] = 1.0
    rates = _error_rates(phi, z, zc, np.ones(2), 1.0)(unit)
    return -np.stack([np.moveaxis(rates[states[1:]], 0, -1) for states in axis_states(N)])


def _error_rates(
    phi: np.ndarray, z: np.ndarray, zc: np.ndarray, KD: np.ndarray, gain: float
) -> Callable[[np.ndarray], np.ndarray]:
    """Return the blocks' function (e, eta) -> (e, eta)', both (2N + 6, ...)."""
    N = phi.shape[-1]
    blocks = error_system(N, KD), parameter_system(N, float(gain))
    inputs = {name: np.moveaxis(v, -1, 0) for name, v in (("phi_x", phi), ("z", z), ("zc", zc))}

    def rates(X: np.ndarray) -> np.ndarray:
        parts = np.split(X, np.cumsum([2, 2 * N, 2]))
        ports = {**inputs, **dict(zip(("e", "eta", "eta_3", "eta_4"), parts, strict=True))}
        derivatives = []
        for block in blocks:
            x, u = (
                np.concatenate([ports[port] for port in names])
                for names in (block.state_ports, block.input_ports)
            )
            derivatives.append(on_arrays(block, "update", 0.0, x, u))
        return np.concatenate(derivatives)

    return rates


def axis_states(N: int) -> list[list[int]]:
    """Return the places in (e, eta) of e_i and that axis's N + 2 of eta, i = 0, 1."""
    return [[i, *range(2 + i * N, 2 + (i + 1) * N), 2 + 2 * N + i, 4 + 2 * N + i] for i in range(2)]


@cache
def collocation(nodes: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the Gauss method's a (nodes, nodes) and b (nodes,) on a step of length 1."""
    legendre = np.polynomial.legendre
    c, weight = legendre.leggauss(nodes)
    P = legendre.legvander(c, nodes)
    integrals = np.empty((nodes, nodes))  # of P_j from -1 to each node
    integrals[:, 0] = c + 1
    for j in range(1, nodes):
        integrals[:, j] = (P[:, j + 1] - P[:, j - 1]) / (2 * j + 1)
    coefficients = (np.arange(nodes)[:, None] + 0.5) * P[:, :nodes].T * weight
    return integrals @ coefficients / 2, weight / 2


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
