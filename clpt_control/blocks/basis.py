"""Flow basis functions, Eq. (5).

    phi_i(x, t) = spatial kernel(|x - c_i|, sigma_i) * cos(omega_i t + phase_i)

The exponent of Eq. (5) is printed ambiguously; each version is a kernel, with
d = |x - c_i| and s = sigma_i:

    "exponential"     exp(-d / (2 s))
    "gaussian"        exp(-d^2 / (2 s^2))
    "gaussian-sigma"  exp(-d^2 / s)

A steady function has omega_i = 0; a sine has phase_i = -pi/2.

Ports: x[2] -> phi_x[N], or z[2] -> phi_z[N] (positions: length; phi: no unit).
"""

import math
from typing import NamedTuple

import numpy as np

from ..equations.block import Block


class BasisParameters(NamedTuple):
    """Centres, widths and tides of N flow basis functions."""

    N: int  # number of basis functions
    centers: np.ndarray  # c_i, shape (N, 2), length
    widths: np.ndarray  # sigma_i, shape (N,), length
    frequencies: np.ndarray  # omega_i, shape (N,), rad per time; 0 is steady
    phases: np.ndarray  # shape (N,), rad


def squared_distance(x, p, i):
    """Return |x - c_i|^2, length squared."""
    return (x[0] - p.centers[i, 0]) ** 2 + (x[1] - p.centers[i, 1]) ** 2


def tide(t, p, i):
    """Return cos(omega_i t + phase_i), the temporal factor of Eq. (5)."""
    return math.cos(p.frequencies[i] * t + p.phases[i])


def exponential(t, x, u, p, y):
    """phi_i = exp(-d/(2 s)) tide, Eq. (5): u = x[2] or z[2], y = phi_x[N] or phi_z[N]."""
    for i in range(p.N):
        y[i] = math.exp(-math.sqrt(squared_distance(u, p, i)) / (2 * p.widths[i])) * tide(t, p, i)


def gaussian(t, x, u, p, y):
    """phi_i = exp(-d^2/(2 s^2)) tide, Eq. (5): u = x[2] or z[2], y = phi_x[N] or phi_z[N]."""
    for i in range(p.N):
        y[i] = math.exp(-squared_distance(u, p, i) / (2 * p.widths[i] ** 2)) * tide(t, p, i)


def gaussian_sigma(t, x, u, p, y):
    """phi_i = exp(-d^2/s) tide, Eq. (5): u = x[2] or z[2], y = phi_x[N] or phi_z[N]."""
    for i in range(p.N):
        y[i] = math.exp(-squared_distance(u, p, i) / p.widths[i]) * tide(t, p, i)


KERNELS = {"exponential": exponential, "gaussian": gaussian, "gaussian-sigma": gaussian_sigma}


def flow_basis(name: str, position: str, kernel: str, parameters: BasisParameters) -> Block:
    """Make the block phi of Eq. (5) at ``"x"``, the vehicle, or ``"z"``, its prediction."""
    return Block(
        name,
        output=KERNELS[kernel],
        inputs={position: 2},
        outputs={f"phi_{position}": parameters.N},
        parameters=parameters,
    )
