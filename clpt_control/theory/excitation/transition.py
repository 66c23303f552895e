"""The transition matrix of the error system, Eq. (28), from its blocks.

    [e_i, eta_i]' = A_i(t) [e_i, eta_i]
    eta_i = [theta_i + alpha_i, K_i - KD_i, GammaD_i - Gamma_i]

A is read off `error_system` and `parameter_system`: their functions are linear
in (e, eta), so a call on a unit vector gives a column.  The two axes do not
meet.  Phi(s, t) is found by collocation at the Gauss-Legendre nodes of each
piece, the implicit Runge-Kutta method of order 2 NODES,

    Y_j = I + h sum_l a_jl A_l Y_l,    Phi = I + h sum_l b_l A_l Y_l.
"""

from functools import cache

import numpy as np

from ...blocks.error_system import (
    ErrorSystemParameters,
    ParameterSystemParameters,
    error_system,
    parameter_system,
)


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
    N, shape = phi.shape[-1], phi.shape[:-1]
    blocks = (
        error_system(ErrorSystemParameters(N, np.asarray(KD, dtype=float))),
        parameter_system(ParameterSystemParameters(N, float(gain))),
    )
    equations = [(block, block.update_function) for block in blocks if block.update_function]
    given = {
        "phi_x": np.moveaxis(phi, -1, 0),
        "z": np.moveaxis(z, -1, 0),
        "zc": np.moveaxis(zc, -1, 0),
    }
    A = np.empty((2, *shape, N + 3, N + 3))
    rates = np.empty((2 * N + 6, *shape))
    for axis, own in enumerate(axis_states(N)):
        for column, state in enumerate(own):
            unit = np.zeros((2 * N + 6, *shape))
            unit[state] = 1.0
            ports = {**given, "e": unit[:2], "eta": unit[2:]}
            row = 0
            for block, rate in equations:
                u = np.concatenate([ports[port] for port in block.input_ports])
                x = np.concatenate([ports[port] for port in block.state_ports])
                rate(0.0, x, u, block.parameters, rates[row : row + len(x)])
                row += len(x)
            A[axis, ..., column] = np.moveaxis(rates[own], 0, -1)
    return A + 0.0  # without -0


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


def propagate(A: np.ndarray, lengths: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return Phi at the nodes and at the end, Phi = I at the start.

    A has the shape (..., pieces, nodes, n, n) and holds Gauss-Legendre nodes; so has the first
    result.  Phi at the end is (..., n, n); lengths (pieces,) are times.
    """
    *batch, pieces, nodes, n, _ = A.shape
    a, b = collocation(nodes)
    at_nodes = np.empty((*batch, pieces, nodes, n, n))
    end = np.broadcast_to(np.eye(n), (*batch, n, n)).copy()
    for k in range(pieces):
        here = lengths[k] * A[..., k, :, :, :]
        # the block (j, l) of the system is delta_jl I - h a_jl A_l
        system = -np.einsum("jl,...lpq->...jplq", a, here).reshape(*batch, nodes * n, nodes * n)
        system += np.eye(nodes * n)
        ones = np.broadcast_to(np.tile(np.eye(n), (nodes, 1)), (*batch, nodes * n, n))
        inner = np.linalg.solve(system, ones).reshape(*batch, nodes, n, n)
        at_nodes[..., k, :, :, :] = inner @ end[..., None, :, :]
        end = end + np.einsum("l,...lpq,...lqr->...pr", b, here, at_nodes[..., k, :, :, :])
    return at_nodes, end
