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

from typing import Any

import numpy as np

from ..equations.block import Block


def error(t, x, u, p):
    """e' = -KD e + W^T eta, Eq. (27)."""
    N = len(u.phi_x)
    flow, feedback, feedforward = u.eta[: 2 * N].reshape(2, N), u.eta[-4:-2], u.eta[-2:]
    return -p.KD * x.e + flow @ u.phi_x + u.z * feedback + u.zc * feedforward


def parameter(t, x, u, p):
    """eta' = -gamma W e, the lower rows of Eq. (28)."""
    We = (np.outer(u.e, u.phi_x).ravel(), u.z * u.e, u.zc * u.e)
    return -p.gain * np.concatenate(We)


def error_system(N: int, KD: Any) -> Block:
    """Make the error system, Eq. (27); the gains KD are per time."""
    return Block(
        "error_system",
        update=error,
        inputs={"phi_x": N, "z": 2, "zc": 2, "eta": 2 * N + 4},
        states={"e": 2},
        parameters={"KD": KD},
    )


def parameter_system(N: int, gain: float) -> Block:
    """Make the parameter system, the lower rows of Eq. (28), with the gain gamma."""
    return Block(
        "parameter_system",
        update=parameter,
        inputs={"e": 2, "phi_x": N, "z": 2, "zc": 2},
        states={"eta": 2 * N + 4},
        parameters={"gain": gain},
    )
