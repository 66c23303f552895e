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

from typing import Any

import numpy as np

from ..equations.block import Block


def squared_distance(u, p):
    """Return |x - c_i|^2, length squared; the position is the one input."""
    return np.sum((u[:2] - p.centers) ** 2, axis=1)


def tide(t, p):
    """Return cos(omega_i t + phase_i), the temporal factor of Eq. (5)."""
    return np.cos(p.frequencies * t + p.phases)


def exponential(t, x, u, p):
    """phi_i = exp(-d/(2 s)) tide, Eq. (5)."""
    return np.exp(-np.sqrt(squared_distance(u, p)) / (2 * p.widths)) * tide(t, p)


def gaussian(t, x, u, p):
    """phi_i = exp(-d^2/(2 s^2)) tide, Eq. (5)."""
    return np.exp(-squared_distance(u, p) / (2 * p.widths**2)) * tide(t, p)


def gaussian_sigma(t, x, u, p):
    """phi_i = exp(-d^2/s) tide, Eq. (5)."""
    return np.exp(-squared_distance(u, p) / p.widths) * tide(t, p)


KERNELS = {"exponential": exponential, "gaussian": gaussian, "gaussian-sigma": gaussian_sigma}


def flow_basis(
    name: str, position: str, kernel: str, centers: Any, widths: Any, frequencies: Any, phases: Any
) -> Block:
    """Make the block phi of Eq. (5) at ``"x"``, the vehicle, or ``"z"``, its prediction.

    Centres of shape (N, 2) and widths are lengths, frequencies rad per time, phases rad.
    """
    return Block(
        name,
        output=KERNELS[kernel],
        inputs={position: 2},
        outputs={f"phi_{position}": "N"},
        parameters={
            "centers": centers,
            "widths": widths,
            "frequencies": frequencies,
            "phases": phases,
        },
        shapes={"centers": ("N", 2), "widths": "N", "frequencies": "N", "phases": "N"},
    )
