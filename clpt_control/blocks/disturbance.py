"""The unmodelled flow Delta(t) of Eq. (32).

    F_R = theta phi(x, t) + Delta(t)              Eq. (32)

    constant   Delta = a
    sine       Delta = a sin(2 pi t / T)
    square     Delta = +a on the first half period, -a on the second
    noise      Delta = a * n, n standard normal, held for T

a is the amplitude of each axis (length per time), T the period (time).  The
noise is a hash of (seed, interval, axis): it has no state, so it can be computed
at any time, in any order.

Ports: none -> delta[2] (length per time).
"""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..equations.block import Block
from .reference import multiples
from .words import floor

MODULUS = 67108859.0  # the largest prime below 2^26: products stay exact in a double


class DisturbanceParameters(NamedTuple):
    """Size and timing of a disturbance."""

    amplitude: np.ndarray  # shape (2,), length per time; of noise the standard deviation
    period: float  # or how long noise is held, time
    seed: float = 0.0  # of the noise, a whole number
    interval: float = -1.0  # its number, kept by the integrator; -1: found from t


def remainder(a):
    """Return a mod MODULUS, exact for 0 <= a < 2^53."""
    return a - MODULUS * floor(a / MODULUS)


def hash_fraction(seed, k, axis, stream):
    """Return a fraction in (0, 1), the hash of four whole numbers.

    Rounds of h -> h^2 + c h + key modulo a prime, in exact double arithmetic.
    """
    h = remainder(remainder(seed) + 40503.0)
    which = axis * 2.0 + stream
    for i in range(4):
        h = remainder(h * h + 1299709.0 + 15485863.0 * i)
        h = h * 31415821.0 + remainder(k) * (2.0 * i + 3.0) + which * (7919.0 + 104729.0 * i)
        h = remainder(h)
    return (h + 0.5) / MODULUS


def normal(seed, k, axis):
    """Return a standard normal number of the hash, as Box and Muller."""
    radius = math.sqrt(-2 * math.log(hash_fraction(seed, k, axis, 0)))
    return radius * math.cos(2 * math.pi * hash_fraction(seed, k, axis, 1))


def constant(t, x, u, p, y):
    """Delta = a, Eq. (32): no inputs, y = delta[2] (length per time)."""
    for i in range(2):
        y[i] = p.amplitude[i]


def sine(t, x, u, p, y):
    """Delta = a sin(2 pi t / T), Eq. (32): no inputs, y = delta[2] (length per time)."""
    for i in range(2):
        y[i] = p.amplitude[i] * math.sin(2 * math.pi * t / p.period)


def square(t, x, u, p, y):
    """Delta = a, then -a, each half a period, Eq. (32): y = delta[2] (length per time)."""
    for i in range(2):
        y[i] = p.amplitude[i] * (1 - 2 * (p.interval % 2))


def noise(t, x, u, p, y):
    """Delta = a n(interval), Eq. (32): y = delta[2] (length per time)."""
    for i in range(2):
        y[i] = p.amplitude[i] * normal(p.seed, p.interval, i)


def half_periods(p: DisturbanceParameters, t0: float, t1: float) -> np.ndarray:
    """Return the times in (t0, t1] where the square wave turns."""
    return multiples(0.5 * p.period, t0, t1)


def periods(p: DisturbanceParameters, t0: float, t1: float) -> np.ndarray:
    """Return the times in (t0, t1] where the noise changes."""
    return multiples(p.period, t0, t1)


KINDS = {
    "constant": (constant, None),
    "sine": (sine, None),
    "square": (square, half_periods),
    "noise": (noise, periods),
}


def disturbance(
    kind: str, amplitude: Sequence[float], period: float = 1.0, seed: float = 0.0
) -> Block:
    """Make the disturbance, Delta of Eq. (32): amplitude of each axis, period in time."""
    output, breakpoints = KINDS[kind]
    return Block(
        "disturbance",
        output=output,
        outputs={"delta": 2},
        parameters=DisturbanceParameters(np.asarray(amplitude, dtype=float), period, seed),
        feedthrough=False,
        opaque=True,
        breakpoints=breakpoints,
    )
