"""The unmodelled flow Delta(t) of Eq. (32).

    F_R = theta phi(x, t) + Delta(t)              Eq. (32)

    constant   Delta = a
    sine       Delta = a sin(2 pi t / T)
    square     Delta = +a on the first half period, -a on the second
    noise      Delta = a * n, n standard normal, constant for T

a is the amplitude of each axis (length per time), T the period (time).  The noise is a hash of
(seed, interval, axis).  It has no state, so it can be computed at any time, in any order.

Ports: none -> delta[2] (length per time).
"""

from collections.abc import Sequence

import numpy as np

from ...base.random_numbers import normal
from ...engine.model.block import Block
from ...engine.model.declaration import Each
from .ports import paper_block

AXES = np.arange(2.0)


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

    For noise the amplitude is the standard deviation, and the seed is an integer.
    """
    output, breakpoints = KINDS[kind]
    parameters = {"amplitude": amplitude, "period": period, "seed": seed}
    return paper_block(
        "disturbance",
        "-> delta",
        parameters,
        output=output,
        opaque=True,
        breakpoints=breakpoints,
    )
