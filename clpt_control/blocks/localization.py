"""Localization: a position read with noise, at all times or at fixes.

    x_m = x + s n(j, axis),    j T <= t < (j + 1) T

s is the standard deviation of each axis (length), n standard normal, held for T (time).  The
noise is a hash of (seed, j, axis), as that of the disturbance but with numbers of its own: one
seed may serve both.

`measurement`, at all times: whatever reads x in the diagram then reads x_m, by the same name; the
true position is the port `x_true`, which the true flow alone reads.

`fixes`, each T: fix j is x_m at t = j T, j = 1, 2, ...; it is missing with a probability, by the
same hash.  Between fixes nobody reads these ports.

Ports: x_true[2] (length) -> x[2] (length), x_m; x[2] -> fix[2] (length), taken[1] (1 or 0).
"""

from typing import NamedTuple

import numpy as np

from ..equations.block import Block
from .disturbance import hash_fraction, normal
from .reference import multiples
from .words import where

TRUE = "x_true"  # the port of the true position
MISSING = 4  # the number of dropouts in the hash
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


class FixParameters(NamedTuple):
    """When fixes are, how exact, and how often one is missing."""

    noise: float  # standard deviation s of each axis, length
    between: float  # T, time from one fix to the next
    dropouts: float  # probability that a fix is missing, no unit
    seed: float = 0.0  # a whole number
    interval: float = -1.0  # the number j of the last fix, kept by the integrator


def fix(t, x, u, p, y):
    """x_m = x + s n(j, axis), and whether fix j is taken: u = x[2], y = fix[2] (length), taken[1].

    It is of Eq. (1) at the times of fixes, and missing where the hash is below the probability.
    """
    for i in range(2):
        y[i] = u[i] + position_noise(p, i)
    y[2] = where(hash_fraction(p.seed, p.interval, MISSING, 0) < p.dropouts, 0.0, 1.0)


def fix_times(p: FixParameters, t0: float, t1: float) -> np.ndarray:
    """Return the times of fixes in (t0, t1]."""
    return multiples(p.between, t0, t1)


def fixes(parameters: FixParameters) -> Block:
    """Make the block of the fixes."""
    return Block(
        "fixes",
        output=fix,
        inputs={"x": 2},
        outputs={"fix": 2, "taken": 1},
        parameters=parameters,
        opaque=True,
        breakpoints=fix_times,
    )


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
