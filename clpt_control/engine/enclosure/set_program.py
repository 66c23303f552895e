"""Functions of a diagram on sets: its record as recurrences between single numbers.

Each element of the record's arrays is a value of its own.  An operation with a recurrence in the
table of operations is a line of machine code (`ball_series`); functions, whose first coefficient
comes from `balls`, and decisions are steps of Python between lines.  A decision that is the same
for all members of a set chooses a value; otherwise `Switching` ends the series.  With `loose`,
values of order 0 take in both sides of a switch and roots at 0.
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import partial, reduce
from itertools import product
from math import inf, isfinite, nan, nextafter
from typing import Any, NamedTuple

import numpy as np

from ...base.errors import Uncompiled
from ..codegen.diagram_record import DiagramRecord
from ..codegen.fused_expressions import whole_power
from ..codegen.machine import address_of, compiled_series, numbers_of
from ..codegen.series import Node
from ..record.graph import deep
from ..record.operations import COMPARISONS, LOGICAL, STEPS, TABLE, Recurrence
from ..record.scalar_graph import Elements, Index
from . import balls
from .ball_series import LEFT
from .balls import FUNCTIONS, Ball, Interval, Switching, Undecided

MOST_WHOLE = 64  # power that is a product
UNBOUNDED = "a divisor may be 0, or a value has no bound"


def power(a: Any, exponent: Any) -> Any:
    """Return a power as products where it is whole, a root, or by the exponential function."""
    if type(exponent) is not float:
        return np.exp(exponent * np.log(a))
    whole = abs(exponent)
    if exponent == 0.0:
        return 0.0 * a + 1.0
    if whole == 0.5:
        value = np.sqrt(a)
    elif whole.is_integer() and whole <= MOST_WHOLE:
        value = whole_power(lambda left, right: left * right, a, int(whole))
    elif (2.0 * whole).is_integer() and whole <= MOST_WHOLE:
        value = power(a, whole - 0.5) * np.sqrt(a)
    else:
        value = np.exp(whole * np.log(a))
    return value if exponent > 0.0 else 1.0 / value


# operations in the place of others, equal in exact arithmetic
REPLACED: dict[str, Callable[..., Any]] = {
    "fabs": lambda a: np.maximum(np.maximum(a, -a), 0.0),
    "tan": lambda a: np.sin(a) / np.cos(a),
    "asin": lambda a: np.atan(a / np.sqrt(1.0 - a * a)),
    "acos": lambda a: 2.0 * np.atan(np.sqrt((1.0 - a) / (1.0 + a))),
    "atan2": lambda a, b: 2.0 * np.atan(a / (np.sqrt(a * a + b * b) + b)),
    "sinh": lambda a: 0.5 * (np.exp(a) - np.exp(-a)),
    "cosh": lambda a: 0.5 * (np.exp(a) + np.exp(-a)),
    "tanh": lambda a: 1.0 - 2.0 / (np.exp(2.0 * a) + 1.0),
    "log2": lambda a: np.log(a) / np.log(2.0),
    "log10": lambda a: np.log(a) / np.log(10.0),
    "eq": lambda a, b: np.logical_and(a <= b, a >= b),
    "ne": lambda a, b: np.logical_or(a < b, a > b),
    "pow": power,
}
CHOICES = ("where", "pick", "mod", "minimum", "maximum")
DECIDED = STEPS - {"argmin", "floordiv"}


class Step(NamedTuple):
    """A function or decision: Python computes the first coefficient."""

    line: int
    kind: str
    operands: tuple[int, ...]
    result: int
    at: Any


class SetProgram(Elements):
    """Values of a diagram, such as its rates, as recurrences between numbers.

    `x` has the values of the states, `results` those of the ports.
    """

    def __init__(self, record: DiagramRecord, ports: list[Any], n: int):
        super().__init__(record.entries)
        self.T = record.layout.T
        self.known: dict[Any, int] = {}  # of loads and operations
        self.constants: dict[float, int] = {}
        self.still: list[int] = []  # 1 if a value does not change in time
        self.positive: list[bool] = []  # never below 0 by the way it is computed
        self.lines: list[tuple[list[int], list[float]]] = []
        self.steps: list[Step] = []
        self.x = [self.load("X", k) for k in range(n)]
        self.time = self.load("t", 0)
        self.begin = self.load("P", len(record.layout.P))  # of a segment of inputs
        places = {}
        with deep():
            for port in ports:
                for k, index in enumerate(np.ndindex(port.shape), port.first):
                    places[k] = self.at(port.ref, index)
        self.results = [places[k] for k in range(len(places))]

    def connect(self, record: DiagramRecord) -> None:
        """Put the diagram's outputs, sums of signals and inputs, in the place of the signals."""
        outputs = []
        for row in record.wiring.outputs:
            terms = []
            for k, gain in row.items():
                term = self.results[k] if k >= 0 else self.at(record.inputs[0], (~k,))
                terms.append(term if gain == 1.0 else self.new("mul", term, gain))
            outputs.append(self.sum(terms or [self.number(0.0)]))
        self.results = outputs

    @property
    def reads_time(self) -> bool:
        """Return whether a value depends on time, but by states and inputs."""
        places = ({*line[1:5], line[7]} for line, _ in self.lines)
        read = {k for line in places if self.begin not in line for k in line}
        return self.time in read.union(self.results, *(s.operands for s in self.steps))

    # --- elements -----------------------------------------------------------------------------

    def value(self, still: bool, positive: bool = False) -> int:
        """Return a new value."""
        self.still.append(int(still))
        self.positive.append(positive)
        return len(self.still) - 1

    def number(self, value: float) -> int:
        """Return a constant."""
        if value not in self.constants:
            self.constants[value] = self.value(True, value >= 0.0)
        return self.constants[value]

    def load(self, array: str, offset: int) -> int:
        """Return the value of an element of an array."""
        if array == "T":
            return self.number(float(self.T[offset]))
        key = array, offset
        if key not in self.known:
            self.known[key] = self.value(array == "P")
        return self.known[key]

    def _element(self, ref: int, index: Index) -> int:
        kind, arguments, shape, at = self.operations[ref]
        if kind == "load":
            array, first = at
            inner = int(np.ravel_multi_index(index, shape)) if shape else 0
            return self.load(array, first + inner)
        if kind == "sum":
            return self._sum(ref, arguments[0], at[0], index)
        return super()._element(ref, index)

    def apply(self, ref: int, kind: str, arguments: tuple[int, ...]) -> int:
        """Write an operation on elements."""
        _, rows, _, at = self.operations[ref]
        if kind == "sum":
            return self.sum(arguments)
        if kind == "search":
            return self.new(kind, *arguments, *self.all_of(rows[0]), at=at[0])
        return self.new(kind, *arguments)

    def sum(self, terms: Sequence[int]) -> int:
        """Return the sum of values, from the first on."""
        return reduce(partial(self.new, "add"), terms)

    # --- operations ---------------------------------------------------------------------------

    def new(self, kind: str, *arguments: Any, at: Any = None) -> int:
        """Return the value of an operation; an equal one is the same."""
        operands = tuple(self.number(a) if type(a) is float else a for a in arguments)
        key = kind, operands, at
        if key not in self.known:
            self._write(key)
        return self.known[key]

    def _write(self, key: tuple[str, tuple[int, ...], Any]) -> None:
        """Write an operation: others in its place, a recurrence, a function, or a decision."""
        kind, operands, at = key
        nodes: list[Any] = [Node(self, a) for a in operands]  # type: ignore[arg-type]
        if kind == "pow":
            numbers = {slot: number for number, slot in self.constants.items()}
            nodes[1] = numbers.get(operands[1], nodes[1])
        row = TABLE[kind]
        if kind in COMPARISONS and operands[0] == operands[1]:
            self.known[key] = self.number(float(row.numpy(0.0, 0.0)))
            return
        others = REPLACED.get(kind)
        if not row.exact:
            others = partial(row.sympy, np)
        if others is not None:
            self.known[key] = others(*nodes).argument
            return
        is_step, is_chosen = kind in DECIDED, kind in CHOICES
        if not (is_step or is_chosen or row.series or kind in FUNCTIONS):
            raise Uncompiled(f"has the operation {kind}")
        signs = [self.positive[a] for a in operands]
        is_square = kind == "mul" and operands[0] == operands[1]
        positive = kind in ("exp", "sqrt") or is_square
        positive |= (kind in ("add", "mul") and all(signs)) or (
            kind == "maximum" and any(signs)
        )
        still = is_step or all(self.still[a] for a in operands)
        result = self.known[key] = self.value(still, positive)
        if is_step or is_chosen or kind in FUNCTIONS:
            self.steps.append(Step(len(self.lines), kind, operands, result, at))
        if is_chosen:
            self.line(Recurrence((1,)), result, operands)
        elif row.series is not None:
            self.line(row.series, result, operands)
        elif not is_step:
            slope = [result, -1, -1, operands[0], -1, 1, 0, -1, 1]
            self.lines.append((slope, [0.0, 0.0, 1.0, 1.0]))
            slope[4] = row.slopes[0](*nodes, Node(self, result)).argument  # type: ignore[arg-type]

    def line(self, row: Recurrence, result: int, operands: tuple[int, ...]) -> None:
        """Write a recurrence."""
        values = *operands, result
        signs = (*row.signs, 0, 0)[:2]
        left, right = (values[k] if signs[k] else -1 for k in (0, 1))
        u, v = (-1, -1) if row.products is None else (values[k] for k in row.products)
        divisor = -1 if row.divisor is None else values[row.divisor]
        self.lines.append(
            (
                [result, left, right, u, v, row.first, row.last, divisor, 0],
                [*signs, -1.0 if row.signs else 1.0, row.factor],
            )
        )


class SetSeries:
    """Coefficients of a program up to an order, with derivatives along values of x and P.

    Arrays are those of `ball_series`; they are written anew by each evaluation.  A result without
    bounds is an error, or NaN alone if results stand `apart`.
    """

    def __init__(self, program: SetProgram, order: int, along: Any = ()):
        self.program, self.order, self.width = program, order, 1 + len(along)
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
        whole = [line for line, _ in program.lines]
        self.whole = np.array(whole, dtype=np.int64).reshape(-1, 9)
        real = np.array([line for _, line in program.lines]).reshape(-1, 4)
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

    def evaluate(self, t: Ball, x: Ball, P: Ball, loose: bool = False) -> Ball:
        """Return coefficients of states, or first ones of outputs: (n, order + 1, width)."""
        program, count = self.program, len(self.whole)
        width = 1 if loose else self.width
        # 1. order 0 of what is given
        self.put(program.time, t)
        self.put(program.x, x)
        self.put(self.of_P, P[self.offsets])
        # 2. order 0 of the others
        done = 0
        self.why.clear()
        for step in program.steps:
            self.machine(done, step.line, 0, 0, 0, 1)
            try:
                done = step.line + self.take(step, loose)
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
        ends = [self.bounds(slot, TABLE[kind].chosen) for slot in operands]
        if kind in FUNCTIONS:
            if loose and self.program.positive[operands[0]]:
                ends = [(max(ends[0][0], 0.0), ends[0][1])]
            self.put(result, balls.middle(*balls.function(kind, *ends[0], loose)))
            return 1
        choices, (low, high) = decided(step, ends)
        is_decided = len(choices) == 1 if kind in CHOICES else low == high
        if not is_decided:
            if not loose:
                raise Switching("a kink, a jump or a condition switches")
            self.jumps |= kind not in ("minimum", "maximum")
        if is_decided and kind in CHOICES:
            self.whole[line, LEFT] = operands[choices[0]]
            if kind != "mod":
                return 0
        self.put(result, balls.middle(low, high))
        return int(kind in CHOICES)


def decided(step: Step, ends: list[Interval]) -> tuple[list[int], Interval]:
    """Return the operands that members of a set choose, and bounds of the results."""
    kind, first = step.kind, ends[0]
    choices: list[int] = []
    if kind == "mod":
        return remainder(first, ends[1])
    if kind == "search":
        row = [low for low, high in ends[1:] if low == high]
        if len(row) < len(ends) - 1:
            raise Undecided("a table changes")
        low, high = (float(np.searchsorted(row, end, step.at)) for end in first)
        return choices, (low, high)
    if kind == "pick":
        count, place = len(ends) - 1, int(first[0])
        if place != int(first[1]) or not -count <= place < count:
            raise Undecided("a place in a table is not known")
        choices = [1 + place % count]
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
