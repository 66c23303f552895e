"""Noise: inputs that change at any time within bounds, on sets.

    x' = f(x, w),   w(t) within W,      against a run with the middle c of W:  y' = f(y, c)

`moved_apart` bounds |x - y| by slopes (Kapela and Zgliczynski 2009, Discrete and Continuous
Dynamical Systems B 11).  `walls` bounds each state alone: the least state of all falls at most at
the least rate that any run has near it (Mueller 1927).  W has the `sources` of a program: functions
of inputs alone.
"""

from collections.abc import Callable
from itertools import product
from typing import NamedTuple

import numpy as np
from numpy import ndarray

from . import balls
from .balls import Ball, Undecided, between, exact, matrix
from .set_series import SetSeries

PARTS = 256  # of the ranges of inputs
REACH = 1e-300  # least width of a box that holds runs


class InputNoise(NamedTuple):
    """Distances of inputs from their middles, joined by lines between samples."""

    places: list[int]  # in P
    times: ndarray
    radii: ndarray  # (inputs, times)

    def largest(self, begin: float, end: float) -> ndarray:
        """Return the largest distances within an interval."""
        first = max(int(self.times.searchsorted(begin, "right")) - 1, 0)
        last = max(int(self.times.searchsorted(end)), first)
        return np.max(self.radii[:, first : last + 1], axis=1, initial=0.0)


def sources(
    series: SetSeries, t: float, P: Ball, places: list[int], radii: ndarray
) -> Ball:
    """Return intervals of functions of inputs, from parts of the ranges of these."""
    known = series.program.known
    read = [k for k, place in enumerate(places) if ("P", place) in known]
    plain = {known["P", places[k]] for k in read}
    parts = 1 if plain.issuperset(series.results.tolist()) else PARTS
    count = int(parts ** (1.0 / max(len(read), 1)))
    wide = Ball(P.c.copy(), P.r.copy())
    found = []
    for part in product(range(count), repeat=len(read)):
        for k, i in zip(read, part, strict=True):
            shares = 2.0 * np.array([i, i + 1]) / count - 1.0
            ends = np.nextafter(P.c[places[k]] + radii[k] * shares, [-np.inf, np.inf])
            wide.c[places[k]], wide.r[places[k]] = between(*ends)
        values = series.evaluate(exact(t), exact([]), wide, loose=True)[:, 0, 0]
        found.append([values.lower, values.upper])
    return between(np.min(found, axis=0)[0], np.max(found, axis=0)[1])


def moved_apart(d: ndarray, J: ndarray, sizes: ndarray, h: float) -> ndarray:
    """Return how far two runs from one state are apart after a time.

    Their rates differ by d at one state.  |x - y| is at most the integral of exp(J (h - s)) d, J a
    bound of the Jacobian, with its signs on the diagonal.  States are in units of about their
    sizes, powers of 2, so that nothing is rounded.
    """
    units = 2.0 ** np.round(np.log2(sizes))
    d, J = d / units, J * units / units[:, None]
    if not h * np.max(np.sum(np.abs(J), axis=1)) < 2.0:
        raise Undecided("a step is too long for its noise")
    term = total = balls.mul(exact(d), exact(h))
    for k in range(2, 40):
        scale = between(np.nextafter(h / k, 0.0), np.nextafter(h / k, np.inf))
        term = balls.mul(matrix(exact(J), term), scale)
        total = balls.add(total, term)
        if k > 4 and np.max(term.c) < balls.UNIT * np.max(total.c):
            break
    far = (total.upper + 2.0 * np.max(term.size)) * balls.GROWTH + balls.TINY
    return far * units + REACH


def walls(
    rates: Callable[[Ball], Ball], box: Ball, B: Ball, h: float
) -> Callable[[Ball], Ball]:
    """Return boxes of all runs from a box by times, B a box that they do not leave until h.

    A run that passes a wall l + s r, 0 <= s <= h, is beside it just before and after: not if r is
    at most all rates of its state in a slab around the wall.
    """
    far = (rates(B).size * h * balls.GROWTH).tolist()
    faces = (1.0, box.lower, B.lower), (-1.0, box.upper, B.upper)
    ends = [
        [
            _wall(rates, B, i, sign, h, (begin[i], last[i], far[i]))
            for i in range(len(far))
        ]
        for sign, begin, last in faces
    ]

    def at(time: Ball) -> Ball:
        low, high = (
            balls.add(exact(end), balls.mul(exact(speed), time))
            for end, speed in (zip(*face, strict=True) for face in ends)
        )
        return between(np.maximum(low.lower, B.lower), np.minimum(high.upper, B.upper))

    return at


def _wall(
    rates: Callable[[Ball], Ball],
    B: Ball,
    i: int,
    sign: float,
    h: float,
    face: tuple[float, float, float],
) -> tuple[float, float]:
    """Return where the wall of a state begins, and its speed; the sign of a lower one is 1."""
    begin, last, far = face

    def speed(low: float, high: float) -> float:
        """Return a speed below all rates inwards, from `begin` + low to `begin` + high."""
        slab = Ball(B.c.copy(), B.r.copy())
        room = REACH + balls.UNIT * (abs(begin) + abs(low) + abs(high))
        ends = sorted(begin + sign * np.array([low - room, high + room]))
        inner = max(ends[0], B.lower[i]), min(ends[1], B.upper[i])
        slab.c[i], slab.r[i] = between(min(inner), max(inner))
        rate = rates(slab)[i]
        return float(rate.lower if sign > 0.0 else -rate.upper)

    try:
        # 1. no rate is faster than from the face to `far`
        slow = speed(-far, far)
        # 2. the slab that the wall itself passes, if its speed is about that at its beginning
        guess = speed(0.0, 0.0)
        found = speed(h * min(slow, 0.0), h * max(guess, 0.0))
    except Undecided:
        return last, 0.0
    return begin, sign * max(slow, min(found, guess))
