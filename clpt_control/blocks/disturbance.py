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

from collections.abc import Sequence

import numpy as np

from ..equations.block import Block
from ..equations.declaration import Each
from .ports import paper_block

MODULUS = 67108859.0  # the largest prime below 2^26: products stay exact in a double
AXES = np.arange(2.0)


def remainder(a):
    """Return a mod MODULUS, exact for 0 <= a < 2^53."""
    return a - MODULUS * np.floor(a / MODULUS)


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
    """Return standard normal numbers of the hash, as Box and Muller."""
    radius = np.sqrt(-2 * np.log(hash_fraction(seed, k, axis, 0)))
    return radius * np.cos(2 * np.pi * hash_fraction(seed, k, axis, 1))


def constant(t, x, u, p):
    """Delta = a, Eq. (32)."""
    return p.amplitude


def sine(t, x, u, p):
    """Delta = a sin(2 pi t / T), Eq. (32)."""
    return p.amplitude * np.sin(2 * np.pi * t / p.period)


def square(t, x, u, p):
    """Delta = a, then -a, each half a period, Eq. (32)."""
    return p.amplitude * (1 - 2 * (p.interval % 2))


def noise(t, x, u, p):
    """Delta = a n(interval), Eq. (32)."""
    return p.amplitude * normal(p.seed, p.interval, AXES)


KINDS = {
    "constant": (constant, None),
    "sine": (sine, None),
    "square": (square, Each("period", 0.5)),
    "noise": (noise, Each("period")),
}


def disturbance(
    kind: str, amplitude: Sequence[float], period: float = 1.0, seed: float = 0.0
) -> Block:
    """Make the disturbance, Delta of Eq. (32): amplitude of each axis, period in time.

    Of noise the amplitude is the standard deviation, and the seed is a whole number.
    """
    output, breakpoints = KINDS[kind]
    given = {"amplitude": amplitude, "period": period, "seed": seed}
    return paper_block(
        "disturbance", "-> delta", given, output=output, opaque=True, breakpoints=breakpoints
    )
