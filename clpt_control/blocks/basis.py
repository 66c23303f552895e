"""Flow basis functions, Eq. (5).

    phi_i(x, t) = spatial kernel(|x - c_i|, sigma_i) * cos(omega_i t + phase_i)

The exponent of Eq. (5) is printed ambiguously; each reading is a kernel, with
d = |x - c_i| and s = sigma_i:

    "exponential"     exp(-d / (2 s))
    "gaussian"        exp(-d^2 / (2 s^2))
    "gaussian-sigma"  exp(-d^2 / s)

A steady function has omega_i = 0; a sine is phase_i = -pi/2.
"""

import math
from typing import NamedTuple

import numpy as np

from .block import Block


class BasisParameters(NamedTuple):
    """Centres, widths and tides of N flow basis functions.

    Attributes
    ----------
    N : int
        Number of basis functions.
    centers : ndarray, shape (N, 2)
        Centres c_i, length.
    widths : ndarray, shape (N,)
        Widths sigma_i, length.
    frequencies : ndarray, shape (N,)
        Angular frequencies omega_i, rad per time; 0 is steady.
    phases : ndarray, shape (N,)
        Phases, rad.
    """

    N: int
    centers: np.ndarray
    widths: np.ndarray
    frequencies: np.ndarray
    phases: np.ndarray


def squared_distance(x, p, i):
    """|x - c_i|^2, length squared."""
    return (x[0] - p.centers[i, 0]) ** 2 + (x[1] - p.centers[i, 1]) ** 2


def tide(t, p, i):
    """cos(omega_i t + phase_i), the temporal factor of Eq. (5)."""
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
    """Make the block phi(position, t) of Eq. (5).

    Ports: `position`[2] (length) -> phi_`position`[N] (no unit).

    Parameters
    ----------
    name : str
        ``"basis_x"`` at the vehicle, ``"basis_z"`` at its prediction.
    position : str
        Label of the position signal, ``"x"`` or ``"z"``.
    kernel : str
        ``"exponential"``, ``"gaussian"`` or ``"gaussian-sigma"``.
    parameters : BasisParameters
        Centres, widths, frequencies and phases.

    Returns
    -------
    Block
        A static block with feedthrough.

    Raises
    ------
    KeyError
        If the kernel is unknown.

    Examples
    --------
    >>> p = BasisParameters(1, np.zeros((1, 2)), np.ones(1), np.zeros(1), np.zeros(1))
    >>> block = flow_basis("basis_x", "x", "gaussian", p)
    >>> float(block.output(0, [], [0, 0])[0])
    1.0
    """
    return Block(
        name,
        output=KERNELS[kernel],
        inputs={position: 2},
        outputs={f"phi_{position}": parameters.N},
        parameters=parameters,
    )
