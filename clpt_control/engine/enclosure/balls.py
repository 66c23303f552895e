"""Balls: sets of real numbers |x - c| <= r, as two arrays of doubles.

Results contain every result of exact arithmetic on members.  Nothing depends on the rounding mode:
each radius takes in a bound of the rounding errors of its centre, and is itself rounded up by a
factor (Rump 1999, Fast and parallel interval arithmetic; Higham 2002, section 3.1).  Functions such
as sin are computed by mpmath with 30 more bits and rounded outwards, never by the C library.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from math import inf, isfinite, nextafter, pi
from typing import Any

import numpy as np
from mpmath import libmp
from numpy import ndarray

UNIT = 2.0**-52  # twice the relative error of one operation
GROWTH = 1.0 + 2.0**-44  # of a radius, for the rounding of up to 200 operations
TINY = 2.0**-500  # more than the errors of results that underflow
BITS = 83
Interval = tuple[float, float]


class Undecided(ArithmeticError):
    """A set that reaches where an operation has no single smooth form."""


class Switching(Undecided):
    """A set that reaches a switch, or the root of 0, where rates have bounds but no series."""


@dataclass(slots=True)
class Ball:
    """Centres and radii, of one shape."""

    c: ndarray
    r: ndarray

    def __iter__(self) -> Iterator[ndarray]:
        yield self.c
        yield self.r

    def __getitem__(self, index: Any) -> "Ball":
        return Ball(self.c[index], self.r[index])

    @property
    def size(self) -> ndarray:
        """Return upper bounds of the absolute values."""
        return (np.abs(self.c) + self.r) * GROWTH

    @property
    def lower(self) -> ndarray:
        """Return lower bounds; the number itself of a point."""
        return np.where(self.r == 0, self.c, np.nextafter(self.c - self.r, -np.inf))

    @property
    def upper(self) -> ndarray:
        """Return upper bounds; the number itself of a point."""
        return np.where(self.r == 0, self.c, np.nextafter(self.c + self.r, np.inf))


def exact(numbers: Any) -> Ball:
    """Return doubles as balls."""
    c = np.asarray(numbers, dtype=float)
    return Ball(c, np.zeros(c.shape))


def around(radii: Any) -> Ball:
    """Return balls around 0."""
    r = np.asarray(radii, dtype=float)
    return Ball(np.zeros(r.shape), r)


def between(lower: Any, upper: Any) -> Ball:
    """Return balls that contain intervals; numbers that agree are points."""
    lower, upper = np.asarray(lower, dtype=float), np.asarray(upper, dtype=float)
    c = 0.5 * lower + 0.5 * upper
    r = np.maximum(upper - c, c - lower)
    r = np.where(lower == upper, 0.0, np.nextafter(r, np.inf))
    return Ball(np.where(lower == upper, lower, c), r)


def within(box: Ball, other: Ball | None) -> Ball:
    """Return the part of a box that another one has, too."""
    if other is None:
        return box
    return between(np.fmax(box.lower, other.lower), np.fmin(box.upper, other.upper))


def around_both(box: Ball, x: Ball) -> Ball:
    """Return a box around two."""
    low, high = np.minimum(box.lower, x.lower), np.maximum(box.upper, x.upper)
    return between(low, high)


def middle(low: float, high: float) -> Interval:
    """Return centre and radius of one interval, those of `between`."""
    if low == high:
        return low, 0.0
    c = 0.5 * low + 0.5 * high
    return c, nextafter(max(high - c, c - low), inf)


def rounded(c: ndarray, r: ndarray, count: int = 1) -> Ball:
    """Return a ball whose centre is a sum of `count` numbers of sizes that `r` has."""
    return Ball(c, r * (GROWTH + 2 * count * UNIT) + TINY)


def add(a: Ball, b: Ball) -> Ball:
    """Return the sum."""
    c = a.c + b.c
    return rounded(c, a.r + b.r + UNIT * np.abs(c))


def mul(a: Ball, b: Ball) -> Ball:
    """Return the product."""
    c, size = a.c * b.c, np.abs(b.c)
    return rounded(c, np.abs(a.c) * (b.r + UNIT * size) + a.r * (size + b.r))


def matrix(a: Ball, b: Ball) -> Ball:
    """Return the product of matrices, or of a matrix and a vector."""
    n, size = a.c.shape[-1], np.abs(b.c)
    r = np.abs(a.c) @ (b.r + (n + 1) * UNIT * size) + a.r @ (size + b.r)
    return rounded(a.c @ b.c, r, n)


def total(terms: Ball) -> Ball:
    """Return sums of rows, from the last term on."""
    partial = np.cumsum(terms.c[:, ::-1], axis=1)
    r = np.sum(terms.r, axis=1) + UNIT * np.sum(np.abs(partial), axis=1)
    return rounded(partial[:, -1], r, terms.c.shape[1])


# --- functions -----------------------------------------------------------------------------


def rising(function: Any) -> Any:
    """Return a function that rises, of a raw interval."""
    return lambda interval, bits: [function(end, bits) for end in interval]


def logistic(a: Any, bits: int) -> Any:
    """Return 1 / (1 + exp(-a)) of a raw number."""
    power = libmp.mpf_exp(libmp.mpf_neg(a), bits)
    return libmp.mpf_rdiv_int(1, libmp.mpf_add(libmp.fone, power, bits), bits)


def angle(a: Any, b: Any, bits: int) -> Any:
    """Return the ends of atan2, which rises or falls along each edge beside its jump."""
    ends = [libmp.mpf_atan2(y, x, bits) for y in a for x in b]
    return min(ends, key=libmp.to_float), max(ends, key=libmp.to_float)


# functions of raw intervals of mpmath, and bits
FUNCTIONS: dict[str, Any] = {
    "exp": libmp.mpi_exp,
    "log": libmp.mpi_log,
    "atan": libmp.mpi_atan,
    "atan2": angle,
    "sin": libmp.mpi_sin,
    "cos": libmp.mpi_cos,
    "sqrt": libmp.mpi_sqrt,
    "tanh": rising(libmp.mpf_tanh),
    "logistic": rising(logistic),
}
TURN = nextafter(-pi, -inf), nextafter(pi, inf)  # of atan2 on both sides of its jump


@lru_cache(10_000)
def function(name: str, loose: bool, *ends: Interval) -> Interval:
    """Return bounds of a function's values; those of mpmath have 30 more bits."""
    low, high = ends[0]
    why = ""
    if name in ("sqrt", "log") and not low > 0.0:
        why = "the argument of a root or a logarithm may be 0 or less"
    if name == "atan2" and low <= 0.0 <= high and ends[1][0] <= 0.0:
        why = "the angle of atan2 may jump by a turn"
        if loose:
            return TURN
    if why and name != "log" and not loose:
        raise Switching(why)
    if why and (name == "log" or low < 0.0):
        raise Undecided(why)
    raw = [tuple(map(libmp.from_float, end)) for end in ends]
    below, above = (
        libmp.to_float(end, strict=False) for end in FUNCTIONS[name](*raw, BITS)
    )
    if not isfinite(above):
        raise Undecided(f"{name} of {high:.6g} is not finite")
    return nextafter(below, -inf), nextafter(above, inf)
