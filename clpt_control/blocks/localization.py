"""Localization: the position that the vehicle reads is the true one with noise.

    x_m = x + s n(j, axis),    j T <= t < (j + 1) T

s is the standard deviation of each axis (length), n standard normal, held for T (time).  The
noise is a hash of (seed, j, axis), as that of the disturbance but with numbers of its own: one
seed may serve both.  Whatever reads x in the diagram then reads x_m, by the same name; the
true position is the port `x_true`, which the true flow alone reads.

Ports: x_true[2] (length) -> x[2] (length), x_m.
"""

from typing import NamedTuple

import numpy as np

from .block import Block
from .disturbance import normal
from .reference import multiples

TRUE = "x_true"  # the port of the true position
FIRST_AXIS = 2  # of the hash; the disturbance has 0 and 1


class MeasurementParameters(NamedTuple):
    """Size and timing of the noise on the position."""

    noise: float  # standard deviation s of each axis, length
    period: float  # how long it is held, time
    seed: float = 0.0  # a whole number
    interval: float = -1.0  # its number j, kept by the integrator; -1: found from t


def position_noise(p, axis):
    """Return the noise of one axis in interval j, length."""
    return p.noise * normal(p.seed, p.interval, FIRST_AXIS + axis)


def measured(t, x, u, p, y):
    """x_m = x + s n(j, axis), read as x by Eqs. (7), (10): u = x_true[2], y = x[2] (length)."""
    for i in range(2):
        y[i] = u[i] + position_noise(p, i)


def periods(p: MeasurementParameters, t0: float, t1: float) -> np.ndarray:
    """Return the times in (t0, t1] where the noise changes."""
    return multiples(p.period, t0, t1)


def measurement(parameters: MeasurementParameters) -> Block:
    """Make the block of the measured position."""
    return Block(
        "measurement",
        output=measured,
        inputs={"x_true": 2},
        outputs={"x": 2},
        parameters=parameters,
        opaque=True,
        breakpoints=periods,
    )
