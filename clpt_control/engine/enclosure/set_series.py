"""Evaluation of a program on balls, and the decisions that members of a set take.

A decision that is the same for all members of a set chooses a value; otherwise `Switching` ends the
series.  With `loose`, values of order 0 take in both sides of a switch and roots at 0, and the line
of each decision is noted; where such lines are `held`, they stand in the place of the decisions.
"""

from math import ceil, floor, inf, isfinite, nan, nextafter
from typing import Any

import numpy as np

from ..codegen.machine import address_of, compiled_series, numbers_of
from . import balls
from .ball_series import LEFT
from .balls import FUNCTIONS, Ball, Interval, Switching, Undecided, exact
from .set_program import CHOICES, DECIDED, ROWS, SetProgram, Step
from .sides import GRID, KINKS, Line, below_root, chosen, decided, line_of

STEEP = 16.0  # greatest over least of numbers whose roots have a line
NO_TERM = -1, 0.0
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
        self.lines: dict[int, Line] = {}  # of decisions, by the last loose evaluation
        self.held: dict[int, Line] = {}  # in the place of decisions
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
        self.real, self.plain = real, (self.whole.copy(), real.copy())
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

        Sources of noise are at their middles, or intervals if the values are `noisy`; so is what
        lines that are held leave of decisions.
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
        self.whole[:], self.real[:] = self.plain
        if loose:
            self.lines = {}
        for step in self.steps:
            self.machine(done, step.line, 0, 0, 0, 1)
            try:
                done = step.line + self.take(step, loose, noisy)
            except Undecided as error:
                self.why[step.result] = str(error)
                if not self.apart:
                    raise
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

    def take(self, step: Step, loose: bool, noisy: bool) -> int:
        """Compute a function, or decide; return how many lines are done."""
        # 1. what is held, tables and functions
        if step.result in self.held and not loose:
            return self.hold(step, self.held[step.result], noisy)
        if step.kind == "interp":
            return self.interpolate(step, loose)
        kind, operands, result = step.kind, step.operands, step.result
        program = self.program
        ends = [self.bounds(slot, ROWS[kind].chosen) for slot in operands]
        if kind in FUNCTIONS:
            if loose and program.positive[operands[0]]:
                ends[0] = max(ends[0][0], 0.0), ends[0][1]
            value = balls.function(kind, loose, *ends)
            self.jumps |= value == balls.TURN
            if value == balls.TURN:
                self.lines[result] = Line((), value)
            elif loose and kind == "sqrt" and STEEP * ends[0][0] <= ends[0][1]:
                self.lines[result] = below_root(ends[0], value)
            self.put(result, balls.middle(*value))
            return 1
        # 2. which sides members are on
        whole = [program.whole[slot] for slot in operands]
        choices, value = decided(step, ends, whole[0])
        is_choice = kind in CHOICES
        is_decided = len(choices) == 1 if is_choice else value[0] == value[1]
        if loose:
            self.lines[result] = line_of(step, ends, choices, value)
        elif not is_decided:
            raise Switching("a kink, a jump or a condition switches")
        if not is_decided:
            is_kink = kind == "search" and step.at[1] != "jumps"
            is_kink |= kind == "pick" and whole[0]  # it jumps where its place does
            self.jumps |= not (is_kink or kind in KINKS)
        # 3. the value
        elif is_choice:
            self.hold(step, chosen(step, ends, choices), False)
            if kind != "mod":
                return 0
        if not is_choice:
            return self.hold(step, Line((), value), True)
        self.put(result, balls.middle(*value))
        return 1

    def hold(self, step: Step, line: Line, noisy: bool) -> int:
        """Put a line in the place of a decision; return how many lines are done."""
        c, r = balls.middle(*line.rest)
        rest = step.rest if step.rest >= 0 else step.result
        self.put(rest, (c, r if noisy else 0.0))
        if self.noise:
            self.R[rest, 0, -1] = r
        if rest != step.result:
            (a, of_a), (b, of_b) = (*line.terms, NO_TERM, NO_TERM)[:2]
            slots = [step.operands[k] if k >= 0 else -1 for k in (a, b)]
            product = (rest, self.program.one) if c or r else (-1, -1)
            self.whole[step.line, LEFT:] = *slots, *product, 0, 0, -1, 0
            self.real[step.line] = of_a, of_b, 1.0, 1.0
        return 0

    def interpolate(self, step: Step, loose: bool) -> int:
        """Compute straight lines of a table on all pieces that a set meets."""
        x, place = (self.bounds(slot, None) for slot in step.operands)
        if not loose or place[0] == place[1]:
            return 0  # the lines of one piece
        rows = [Ball(self.C[row, 0, 0], self.R[row, 0, 0]) for row in step.at]
        joints, *of_pieces = rows
        first, last = ceil(place[0]), floor(place[1])
        edges = np.array([x[0], *joints.c[first:last], x[1]])
        point, slope, value = (row[first : last + 1] for row in of_pieces)

        def above(factor: float) -> Ball:
            """Return the table less a line, at the ends of its pieces."""
            ends = exact(np.array([edges[:-1], edges[1:]]))
            s = balls.add(ends, Ball(-point.c, point.r))
            y = balls.add(balls.mul(slope, s), value)
            return balls.add(y, balls.mul(exact(-factor), ends))

        y = above(0.0)
        factor = float(round(GRID * (y.c[1, -1] - y.c[0, 0]) / (x[1] - x[0])) / GRID)
        rest = above(factor)
        bounds = [(float(np.min(a.lower)), float(np.max(a.upper))) for a in (y, rest)]
        self.lines[step.result] = Line(((0, factor),), bounds[1])
        self.put(step.result, balls.middle(*bounds[0]))
        return 1
