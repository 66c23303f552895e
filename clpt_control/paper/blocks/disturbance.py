"""The unmodelled flow Delta(t) of Eq. (32).

    F_R = theta phi(x, t) + Delta(t)              Eq. (32)

    constant   Delta = a
    sine       Delta = a sin(2 pi t / T)
    square     Delta = +a on the first half period, -a on the second
    noise      Delta = a * n, n standard normal, constant for T

a is the amplitude of each axis (length per time), T the period (time).  The noise is a hash of
(seed, interval, axis).  It has no state, so it can be computed at any time, in any order.

A kind is one row of `KINDS`.  Scenarios, `certify` and ensembles read the row.

Ports: none -> delta[2] (length per time).
"""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

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


class DisturbanceKind(NamedTuple):
    """A kind of disturbance; every field is required."""

    function: Callable[..., Any]  # Delta, as a function of (t, x, u, p)
    breakpoints: Each | None  # times at which Delta jumps
    keys: dict[str, bool]  # keys of a scenario besides the amplitude; True if required
    bounded: bool  # True if |Delta_i| <= a_i at all times
    random: bool  # True if Delta depends on the seed
    rms: float  # root mean square of Delta_i over a_i, in the long run


PERIOD = {"period": True}
KINDS = {
    "constant": DisturbanceKind(
        constant, None, {"period": False}, bounded=True, random=False, rms=1.0
    ),
    "sine": DisturbanceKind(
        sine, None, PERIOD, bounded=True, random=False, rms=0.5**0.5
    ),
    "square": DisturbanceKind(
        square, Each("period", 0.5), PERIOD, bounded=True, random=False, rms=1.0
    ),
    "noise": DisturbanceKind(
        noise,
        Each("period"),
        PERIOD | {"seed": False},
        bounded=False,
        random=True,
        rms=1.0,
    ),
}


def disturbance(
    kind: str, amplitude: Sequence[float], period: float = 1.0, seed: float = 0.0
) -> Block:
    """Make the disturbance, Delta of Eq. (32): amplitude of each axis, period in time.

    For noise the amplitude is the standard deviation, and the seed is an integer.
    """
    row = KINDS[kind]
    parameters = {"amplitude": amplitude, "period": period, "seed": seed}
    return paper_block(
        "disturbance",
        "-> delta",
        parameters,
        output=row.function,
        opaque=True,
        breakpoints=row.breakpoints,
    )
