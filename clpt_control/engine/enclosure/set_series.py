"""Evaluation of a program on balls, and the decisions that members of a set take.

A decision that is the same for all members of a set chooses a value; otherwise `Switching` ends the
series.  With `loose`, values of order 0 take in both sides of a switch and roots at 0.
"""

from fractions import Fraction
from itertools import product
from math import ceil, floor, inf, isfinite, nan, nextafter
from typing import Any

import numpy as np

from ..codegen.machine import address_of, compiled_series, numbers_of
from ..record.operations import LOGICAL, TABLE
from . import balls
from .ball_series import LEFT
from .balls import FUNCTIONS, Ball, Interval, Switching, Undecided, between, exact
from .set_program import CHOICES, DECIDED, ROWS, SetProgram, Step

UNBOUNDED = "a divisor may be 0, or a value has no bound"


class SetSeries:
    """Coefficients of a program up to an order, with derivatives along values of x and P.

    Arrays are those of `ball_series`; they are written anew by each evaluation.  A result without
    bounds is an error, or NaN alone if results stand `apart`.  With `noise` the last column is
    what the sources of noise add to a value.
    """

    def __init__(
        self, program: SetProgram, order: int, along: Any = (), noise: bool = False
    ):
        self.program, self.order, self.noise = program, order, noise
        self.width = 1 + len(along) + noise
        self.apart = False
        # values that had no bounds in the last evaluation
        self.why: dict[int, str] = {}
        self.jumps = False  # whether members have been on both sides of a jump
        shape = len(program.still), order + 1, self.width
        self.C, self.R = C, _ = np.zeros(shape), np.zeros(shape)
        for number, slot in program.constants.items():
            C[slot, 0, 0] = number
        if order:
            C[program.time, 1, 0] = 1.0
        for e, key in enumerate(along, 1):
            if key in program.known:
                C[program.known[key], 0, e] = 1.0
        loads = [key for key in program.known if key[0] == "P"]
        self.offsets = [offset for _, offset in loads]
        self.of_P = [program.known[key] for key in loads]
        self.sources = [*program.sources.values()]
        self.of_sources = exact(np.zeros(len(self.sources)))  # their intervals
        lines, self.steps = program.needed()
        whole = [line for line, _ in lines]
        self.whole = np.array(whole, dtype=np.int64).reshape(-1, 9)
        real = np.array([line for _, line in lines]).reshape(-1, 4)
        self.results = np.array(program.x if order else program.results, dtype=np.int64)
        pairs = [program.x, program.results] if order else [[], []]
        states = np.array(pairs, dtype=np.int64).T.copy()
        still = np.array(program.still, dtype=np.int64)
        self.arrays = self.C, self.R, self.whole, real, states, still
        self.numbers = numbers_of(*self.arrays, *(0,) * 6)
        self.address = address_of(self.numbers)
        self.coefficients = compiled_series().coefficients

    def machine(self, *places: int) -> None:
        """Compute lines, orders and columns from the first to before the last."""
        self.numbers[-6:] = places
        self.coefficients(self.address)

    def put(self, slots: Any, value: Ball | Interval) -> None:
        """Write first coefficients."""
        self.C[slots, 0, 0], self.R[slots, 0, 0] = value

    def evaluate(
        self, t: Ball, x: Ball, P: Ball, loose: bool = False, noisy: bool = False
    ) -> Ball:
        """Return coefficients of states, or first ones of outputs: (n, order + 1, width).

        Sources of noise are at their middles, or intervals if the values are `noisy`.
        """
        program, count = self.program, len(self.whole)
        width = 1 if loose else self.width
        # 1. order 0 of what is given
        self.put(program.time, t)
        self.put(program.x, x)
        self.put(self.of_P, P[self.offsets])
        c, r = self.of_sources
        self.put(self.sources, Ball(c, r if noisy else 0.0 * r))
        if self.noise:
            self.R[self.sources, 0, -1] = r
        # 2. order 0 of the others
        done = 0
        self.why.clear()
        for step in self.steps:
            self.machine(done, step.line, 0, 0, 0, 1)
            try:
                done = step.line + (
                    self.interpolate if step.kind == "interp" else self.take
                )(step, loose)
            except Undecided as error:
                if not self.apart:
                    raise
                self.why[step.result] = str(error)
                self.C[step.result, 0, 0] = nan
                done = step.line + (step.kind not in DECIDED)
        self.machine(done, count, 0, 0, 0, 1)
        # 3. derivatives, and higher orders
        if width > 1:
            self.machine(0, count, 0, 0, 1, width)
        if self.order:
            self.machine(0, count, 1, self.order, 0, width)
        found = Ball(self.C[self.results, :, :width], self.R[self.results, :, :width])
        is_bounded = np.isfinite([*found]).all(axis=(0, 2, 3))
        if not (self.apart or is_bounded.all()):
            raise Undecided(UNBOUNDED)
        found.c[~is_bounded] = nan
        return found

    def reason(self, result: int) -> str:
        """Return why a result had no bounds in the last evaluation."""
        known = reversed(self.program.known.items())
        operands = {value: key[1] for key, value in known if len(key) == 3}
        values = [result]
        for value in values:
            if self.why.get(value, UNBOUNDED) != UNBOUNDED:
                return self.why[value]
            values += {*operands.get(value, ())}.difference(values)
        return UNBOUNDED

    # --- what Python does at order 0 ----------------------------------------------------------

    def bounds(self, slot: int, is_limit: Any) -> Interval:
        """Return bounds of a first coefficient; limits may be infinite."""
        c, r = float(self.C[slot, 0, 0]), float(self.R[slot, 0, 0])
        if not isfinite(c + r) and not (is_limit and r == 0.0 and c == c):
            raise Undecided(UNBOUNDED)
        return (nextafter(c - r, -inf), nextafter(c + r, inf)) if r else (c, c)

    def take(self, step: Step, loose: bool) -> int:
        """Compute a function, or decide; return how many lines are done."""
        line, kind, operands, result, _ = step
        program = self.program
        ends = [self.bounds(slot, ROWS[kind].chosen) for slot in operands]
        if kind in FUNCTIONS:
            if loose and program.positive[operands[0]]:
                ends[0] = max(ends[0][0], 0.0), ends[0][1]
            value = balls.function(kind, loose, *ends)
            self.jumps |= value == balls.TURN
            self.put(result, balls.middle(*value))
            return 1
        whole = [program.whole[slot] for slot in operands]
        choices, (low, high) = decided(step, ends, whole[0])
        is_decided = len(choices) == 1 if kind in CHOICES else low == high
        if not is_decided:
            if not loose:
                raise Switching("a kink, a jump or a condition switches")
            is_kink = kind == "search" and step.at[1] != "jumps"
            is_kink |= kind == "pick" and whole[0]  # it jumps where its place does
            self.jumps |= not (is_kink or kind in ("minimum", "maximum"))
        if is_decided and kind in CHOICES:
            self.whole[line, LEFT] = operands[choices[0]]
            if kind != "mod":
                return 0
        self.put(result, balls.middle(low, high))
        return int(kind in CHOICES)

    def interpolate(self, step: Step, loose: bool) -> int:
        """Compute straight lines of a table on all pieces that a set meets."""
        x, place = (self.bounds(slot, None) for slot in step.operands)
        if not loose or place[0] == place[1]:
            return 0  # the lines of one piece
        rows = [Ball(self.C[row, 0, 0], self.R[row, 0, 0]) for row in step.at]
        joints, *of_pieces = rows
        first, last = ceil(place[0]), floor(place[1])
        edges = [x[0], *joints.c[first:last], x[1]]
        point, slope, value = (row[first : last + 1] for row in of_pieces)
        s = balls.add(between(edges[:-1], edges[1:]), Ball(-point.c, point.r))
        y = balls.add(balls.mul(slope, s), value)
        self.put(step.result, balls.middle(np.min(y.lower), np.max(y.upper)))
        return 1


def decided(
    step: Step, ends: list[Interval], is_whole: bool
) -> tuple[list[int], Interval]:
    """Return the operands that members of a set choose, and bounds of the results."""
    kind, first = step.kind, ends[0]
    choices: list[int] = []
    if kind == "mod":
        return remainder(first, ends[1])
    if kind == "search":
        row = [low for low, high in ends[1:] if low == high]
        if len(row) < len(ends) - 1:
            raise Undecided("a table changes")
        low, high = (float(np.searchsorted(row, end, step.at[0])) for end in first)
        return choices, (low, high)
    if kind == "pick":
        count = len(ends) - 1
        start, stop = (ceil(first[0]), floor(first[1])) if is_whole else map(int, first)
        if not -count <= start <= stop < count:
            raise Undecided("a place may be outside of its table")
        choices = [1 + place % count for place in range(start, stop + 1)]
    elif kind == "where":
        low, high = truth(first)
        choices = [1] * (high > 0.0) + [2] * (low < 1.0)
    else:
        if kind in CHOICES:
            low, high = corners(TABLE[kind].chosen, ends)
            choices = [0] * (high > 0.0) + [1] * (low < 1.0)
        if kind in LOGICAL:
            ends = [truth(end) for end in ends]
        return choices, corners(TABLE[kind].numpy, ends)
    lows, highs = zip(*(ends[k] for k in choices), strict=True)
    return choices, (min(lows), max(highs))


def truth(of: Interval) -> Interval:
    """Return bounds, 0 or 1, of the truth of numbers; those of 0 or 1 may be rounded."""
    return float(not of[0] <= 0.0 <= of[1]), float(of != (0.0, 0.0))


def corners(function: Any, ends: list[Interval]) -> Interval:
    """Return bounds of a function that rises or falls along each argument, without rounding."""
    values = [float(function(*corner)) for corner in product(*ends)]
    return min(values), max(values)


def remainder(a: Interval, divisor: Interval) -> tuple[list[int], Interval]:
    """Return bounds of a remainder, whose slope is that of a between its jumps."""
    b = divisor[0]
    if b != divisor[1] or b == 0.0:
        raise Undecided("the divisor of a remainder may be 0 or change")
    low, high = (Fraction(end) % Fraction(b) for end in a)
    if high - low != Fraction(a[1]) - Fraction(a[0]):
        return [], (min(b, 0.0), max(b, 0.0))
    point = float(low)
    if low == high == point:
        return [0], (point, point)
    return [0], (nextafter(point, -inf), nextafter(float(high), inf))
