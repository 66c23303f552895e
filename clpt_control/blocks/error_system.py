"""The error system, Eq. (27), and the parameter system of Eq. (28).

    e'   = -KD e + W^T eta                        Eq. (27)
    eta' = -gamma W e                             Eq. (28), lower rows

with, axis by axis, eta = [theta + alpha (row by row), K - KD, GammaD - Gamma]
and the regressor W whose column i holds phi(x) in row block i, z_i and zc_i.
The print of Eq. (27) has x where Eqs. (28) and (31) need z, and the lower rows
of A in Eq. (28) lack their transposes; the corrected forms stand here.

Ports: phi_x[N], z[2], zc[2] (length), eta[2N+4] -> e[2] (length), a state;
e[2], phi_x[N], z[2], zc[2] -> eta[2N+4], a state.
"""

from typing import NamedTuple

import numpy as np

from ..equations.block import Block


class ErrorSystemParameters(NamedTuple):
    """Parameters of the error system."""

    N: int  # number of basis functions
    KD: np.ndarray  # shape (2,), feedback gains of the vehicle, per time


class ParameterSystemParameters(NamedTuple):
    """Parameters of the parameter system."""

    N: int  # number of basis functions
    gain: float  # gamma > 0


def error(t, x, u, p, dx):
    """e' = -KD e + W^T eta, Eq. (27).

    u = phi_x[N], z[2], zc[2] (length), eta[2N+4]; state e[2] (length).
    """
    n = p.N
    phi, z, zc, eta = u[0:n], u[n : n + 2], u[n + 2 : n + 4], u[n + 4 : 3 * n + 8]
    for i in range(2):
        flow = 0.0
        for k in range(n):
            flow += phi[k] * eta[i * n + k]
        dx[i] = -p.KD[i] * x[i] + flow + z[i] * eta[2 * n + i] + zc[i] * eta[2 * n + 2 + i]


def parameter(t, x, u, p, dx):
    """eta' = -gamma W e, the lower rows of Eq. (28).

    u = e[2] (length), phi_x[N], z[2], zc[2] (length); state eta[2N+4].
    """
    n = p.N
    e, phi, z, zc = u[0:2], u[2 : 2 + n], u[2 + n : 4 + n], u[4 + n : 6 + n]
    for i in range(2):
        for k in range(n):
            dx[i * n + k] = -p.gain * phi[k] * e[i]
        dx[2 * n + i] = -p.gain * z[i] * e[i]
        dx[2 * n + 2 + i] = -p.gain * zc[i] * e[i]


def error_system(parameters: ErrorSystemParameters) -> Block:
    """Make the error system, Eq. (27)."""
    N = parameters.N
    return Block(
        "error_system",
        update=error,
        inputs={"phi_x": N, "z": 2, "zc": 2, "eta": 2 * N + 4},
        states={"e": 2},
        parameters=parameters,
    )


def parameter_system(parameters: ParameterSystemParameters) -> Block:
    """Make the parameter system, the lower rows of Eq. (28)."""
    N = parameters.N
    return Block(
        "parameter_system",
        update=parameter,
        inputs={"e": 2, "phi_x": N, "z": 2, "zc": 2},
        states={"eta": 2 * N + 4},
        parameters=parameters,
    )
