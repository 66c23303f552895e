"""The error system along a trajectory: its matrix A and its transition matrix, of Eq. (28).

    [e_i, eta_i]' = A_i(t) [e_i, eta_i],    A_i = [[-k, w^T], [-gamma w, 0]],    k = KD_i
    eta_i = [theta_i + alpha_i, K_i - KD_i, GammaD_i - Gamma_i],    w of Eq. (31)

It is what the blocks `error_system` and `parameter_system` are, whose two axes do not meet; a test
asks that.  Phi is found by collocation at the Gauss-Legendre nodes of each piece of length h, the
implicit Runge-Kutta method of order 2 NODES.  Within a piece eta moves along the w at the nodes,
the rows of W, so that only e at the nodes, E, is to be solved for; with G = W W^T and the
method's a, b, entries of a and G multiplied one by one in a*G,

    (I + h k a + gamma h^2 a (a*G)) E = e + h a W eta
    e   -> e + h b (W eta - k E - gamma h (a*G) E)
    eta -> eta - gamma h sum_j b_j w_j E_j
"""

from functools import cache

import numpy as np

from ...arguments import numbers, public
from ...errors import ArgumentError


@public
def error_matrices(
    phi: np.ndarray, z: np.ndarray, zc: np.ndarray, KD: np.ndarray, gain: float
) -> np.ndarray:
    """Return A(t) of Eq. (28), axis by axis.

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
    w = regressors(phi, z, zc)
    A = np.zeros((*w.shape[:-1], N + 3, N + 3))
    A[..., 0, 0] = -KD.reshape(2, *[1] * len(shape))
    A[..., 0, 1:] = w
    A[..., 1:, 0] = -gain * w
    return A + 0.0  # without -0


def regressors(phi: np.ndarray, z: np.ndarray, zc: np.ndarray) -> np.ndarray:
    """Return w of Eq. (31), axis first, (2, ..., N + 2)."""
    return np.stack([np.concatenate([phi, z[..., [i]], zc[..., [i]]], axis=-1) for i in (0, 1)])


@cache
def collocation(nodes: int) -> tuple[np.ndarray, np.ndarray]:
    """Return the Gauss method's a (nodes, nodes) and b (nodes,) on a step of length 1."""
    legendre = np.polynomial.legendre
    c, weight = legendre.leggauss(nodes)
    integrals = legendre.legval(c, legendre.legint(np.eye(nodes), lbnd=-1))  # of P_j to each node
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
