"""Functions of a diagram on sets: its record as recurrences between single numbers.

Each element of the record's arrays is a value of its own.  An operation with a recurrence in the
table of operations is a line of machine code (`ball_series`); functions, whose first coefficient
comes from `balls`, and decisions are steps of Python between lines (`set_series`).  Values that
depend on inputs with a noise alone are a program of their own: its results are the `sources` of
noise, intervals to what reads them.
"""

from collections.abc import Callable, Collection, Mapping, Sequence
from copy import copy
from functools import partial, reduce
from itertools import accumulate, compress
from typing import Any, NamedTuple

import numpy as np

from ...base.errors import Uncompiled
from ..codegen.diagram_record import DiagramRecord
from ..codegen.fused_expressions import whole_power
from ..codegen.series import Node
from ..record.graph import deep
from ..record.operations import COMPARISONS, STEPS, TABLE, Recurrence, Row
from ..record.scalar_graph import Elements, Index
from .ball_series import RESULT
from .ball_series import V as SLOPE
from .balls import FUNCTIONS

MOST_WHOLE = 64  # power that is a product


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
    "tan": lambda a: np.sin(a) / np.cos(a),
    "asin": lambda a: np.atan(a / np.sqrt(1.0 - a * a)),
    "acos": lambda a: 2.0 * np.atan(np.sqrt((1.0 - a) / (1.0 + a))),
    "sinh": lambda a: 0.5 * (np.exp(a) - np.exp(-a)),
    "cosh": lambda a: 0.5 * (np.exp(a) + np.exp(-a)),
    "log2": lambda a: np.log(a) / np.log(2.0),
    "log10": lambda a: np.log(a) / np.log(10.0),
    "eq": lambda a, b: np.logical_and(a <= b, a >= b),
    "ne": lambda a, b: np.logical_or(a < b, a > b),
    "pow": power,
}
CHOICES = ("where", "pick", "mod", "minimum", "maximum", "fabs")
DECIDED = STEPS - {"argmin", "floordiv"}
ROWS = {**TABLE, "logistic": Row(slopes=(lambda a, f: f - f * f,), c="")}
NONE: tuple[str, tuple[int, ...], Any] = (
    "",
    (),
    None,
)  # of a value that no operation has made


class Step(NamedTuple):
    """A function or decision: Python computes the first coefficient."""

    line: int
    kind: str
    operands: tuple[int, ...]
    result: int
    at: Any
    rest: int = -1  # what a line in the place of a decision leaves


class SetProgram(Elements):
    """Values of a diagram, such as its rates, as recurrences between numbers.

    `x` has the values of the states, `results` those of the ports.  `fixed` has the numbers of P
    that never change; inputs at the `noisy` places of P have a noise.
    """

    def __init__(
        self,
        record: DiagramRecord,
        ports: list[Any],
        n: int,
        fixed: Mapping[int, float],
        noisy: Collection[int],
    ):
        super().__init__(record.entries)
        self.T, self.fixed, self.noisy_places = record.layout.T, fixed, noisy
        self.known: dict[Any, int] = {}  # of loads and operations
        self.made: dict[int, Any] = {}  # operations by their results
        self.constants: dict[float, int] = {}
        self.number_of: dict[int, float] = {}
        self.still: list[int] = []  # 1 if a value does not change in time
        self.positive: list[bool] = []  # never below 0 by the way it is computed
        self.whole: list[bool] = []  # always a whole number
        self.noisy: list[bool] = []  # a function of inputs with a noise alone
        self.sources: dict[
            int, int
        ] = {}  # noisy values, and the intervals in their place
        self.lines: list[tuple[list[int], list[float]]] = []
        self.steps: list[Step] = []
        self.x = [self.load("X", k) for k in range(n)]
        self.time = self.load("t", 0)
        self.one = self.number(1.0)
        self.begin = self.load("P", len(record.layout.P))  # of a segment of inputs
        places = {}
        with deep():
            for port in ports:
                for k, index in enumerate(np.ndindex(port.shape), port.first):
                    places[k] = self.at(port.ref, index)
        self.results = [self.interval_of(places[k]) for k in range(len(places))]

    def connect(self, record: DiagramRecord) -> None:
        """Put the diagram's outputs, sums of signals and inputs, in the place of the signals."""
        outputs = []
        for row in record.wiring.outputs:
            terms = []
            for k, gain in row.items():
                term = self.results[k] if k >= 0 else self.at(record.inputs[0], (~k,))
                terms.append(term if gain == 1.0 else self.new("mul", term, gain))
            outputs.append(self.interval_of(self.sum(terms or [self.number(0.0)])))
        self.results = outputs

    @property
    def reads_time(self) -> bool:
        """Return whether a value depends on time, but by states and inputs."""
        places = ({*line[1:5], line[7]} for line, _ in self.lines)
        read = {k for line in places if self.begin not in line for k in line}
        return self.time in read.union(self.results, *(s.operands for s in self.steps))

    # --- elements -----------------------------------------------------------------------------

    def needed(self) -> tuple[list[Any], list[Step]]:
        """Return the lines and the steps that results read."""
        reads = dict[int, set[int]]()
        for line, _ in self.lines:
            reads.setdefault(line[RESULT], set()).update(line[1:5], line[7:8])
        for step in self.steps:
            reads.setdefault(step.result, set()).update(step.operands)
        left, read = [*self.results], {-1}
        while left:
            if (value := left.pop()) not in read:
                read.add(value)
                left += reads.get(value, ())
        are_read = [line[RESULT] in read for line, _ in self.lines]
        places = [0, *accumulate(map(int, are_read))]
        steps = [
            s._replace(line=places[s.line]) for s in self.steps if s.result in read
        ]
        return [*compress(self.lines, are_read)], steps

    def of_inputs(self) -> "SetProgram":
        """Return the program of the sources of noise."""
        part = copy(self)
        part.results, part.x, part.sources = [*self.sources], [], {}
        return part

    def value(
        self,
        still: bool,
        positive: bool = False,
        whole: bool = False,
        noisy: bool = False,
    ) -> int:
        """Return a new value."""
        self.still.append(int(still))
        self.positive.append(positive)
        self.whole.append(whole)
        self.noisy.append(noisy)
        return len(self.still) - 1

    def number(self, value: float) -> int:
        """Return a constant."""
        if value not in self.constants:
            slot = self.value(True, value >= 0.0, value % 1.0 == 0.0)
            self.constants[value], self.number_of[slot] = slot, value
        return self.constants[value]

    def interval_of(self, value: int) -> int:
        """Return the interval in the place of a noisy value, other values as they are."""
        if not self.noisy[value]:
            return value
        if value not in self.sources:
            facts = self.positive[value], self.whole[value]
            self.sources[value] = self.value(True, *facts)
        return self.sources[value]

    def load(self, array: str, offset: int) -> int:
        """Return the value of an element of an array."""
        if array == "T":
            return self.number(float(self.T[offset]))
        if array == "P" and offset in self.fixed:
            return self.number(float(self.fixed[offset]))
        key = array, offset
        if key not in self.known:
            is_noisy = array == "P" and offset in self.noisy_places
            self.known[key] = self.value(array == "P", noisy=is_noisy)
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
            return self.new(kind, *arguments, *self.all_of(rows[0]), at=at)
        return self.new(kind, *arguments)

    def sum(self, terms: Sequence[int]) -> int:
        """Return the sum of values, from the first on."""
        return reduce(partial(self.new, "add"), terms)

    # --- operations ---------------------------------------------------------------------------

    def new(self, kind: str, *arguments: Any, at: Any = None) -> int:
        """Return the value of an operation; an equal one is the same."""
        operands = tuple(self.number(a) if type(a) is float else a for a in arguments)
        noisy = [self.noisy[a] for a in operands]
        are_alone = all(self.noisy[a] or a in self.number_of for a in operands)
        if any(noisy) and not are_alone:
            if kind == "div" and noisy[1]:
                return self.new("mul", operands[0], self.new("div", 1.0, operands[1]))
            operands = tuple(map(self.interval_of, operands))
        key = kind, operands, at
        if key not in self.known:
            self._write(key)
        return self.known[key]

    def _write(self, key: tuple[str, tuple[int, ...], Any]) -> None:
        """Write an operation: others in its place, a recurrence, a function, or a decision."""
        kind, operands, _ = key
        nodes: list[Any] = [Node(self, a) for a in operands]  # type: ignore[arg-type]
        if kind == "pow":
            nodes[1] = self.number_of.get(operands[1], nodes[1])
        row = ROWS[kind]
        if kind in COMPARISONS and operands[0] == operands[1]:
            self.known[key] = self.number(float(row.numpy(0.0, 0.0)))
            return
        if (equal := self._equal(kind, operands)) is not None:
            self.known[key] = equal
            return
        others = REPLACED.get(kind)
        if not row.exact:
            others = partial(row.sympy, np)
        if others is not None:
            self.known[key] = others(*nodes).argument
            return
        if not (kind in {*CHOICES, *DECIDED, *FUNCTIONS} or row.series):
            raise Uncompiled(f"has the operation {kind}")
        self._write_line(key, nodes, row)

    def _equal(self, kind: str, operands: tuple[int, ...]) -> int | None:
        """Return a value that is equal and has tighter bounds, if there is one."""
        made, numbers = self.made, self.number_of
        if kind == "mul" and 0.0 in (pair := [*map(numbers.get, operands)]):
            # the line of an input that does not change
            other = operands[1 - pair.index(0.0)]
            is_line = made.get(other, NONE)[:2] == ("sub", (self.time, self.begin))
            return self.number(0.0) if is_line else None
        # a / (1 + exp(-b)), whose exponential may be too large
        name, terms, _ = made.get(operands[-1], NONE) if kind == "div" else NONE
        for one, power in (terms, terms[::-1]) if name == "add" else ():
            if numbers.get(one) == 1.0 and made.get(power, NONE)[0] == "exp":
                value = self.new("logistic", self.new("neg", *made[power][1]))
                return self.new("mul", operands[0], value)
        return None

    def _write_line(self, key: Any, nodes: list[Any], row: Row) -> None:
        """Write a line or a step, or both, of an operation."""
        kind, operands, at = key
        # 1. facts
        is_step, is_chosen = kind in DECIDED, kind in CHOICES
        signs = [self.positive[a] for a in operands]
        is_square = kind == "mul" and operands[0] == operands[1]
        positive = kind in ("exp", "sqrt", "logistic", "fabs") or is_square
        positive |= (kind in ("add", "mul") and all(signs)) or (
            kind == "maximum" and any(signs)
        )
        still = is_step or all(self.still[a] for a in operands)
        whole = is_step or (row.whole and all(self.whole[a] for a in operands))
        noisy = any(self.noisy[a] for a in operands)
        result = self.known[key] = self.value(still, positive, whole, noisy)
        self.made[result] = key
        lines, steps = self.lines, self.steps
        # 2. terms of a function of two numbers, whose slopes do not read the result
        terms = []
        if kind == "atan2":
            for a, slope in zip(operands, row.slopes, strict=True):
                outer = slope(*nodes, None).argument
                terms.append(self.value(still, noisy=noisy))
                lines.append(by_slope(terms[-1], a, outer))
        # 3. what Python does
        table = self.table(*operands) if kind == "add" else None
        has_rest = is_chosen or table is not None or kind in ("sqrt", "atan2")
        rest = self.value(True) if has_rest else -1
        if is_step or is_chosen or kind in FUNCTIONS:
            steps.append(Step(len(lines), kind, operands, result, at, rest))
        elif table is not None:
            steps.append(Step(len(lines), "interp", table[0], result, table[1], rest))
        # 4. the line
        if is_chosen:
            lines.append(line(Recurrence((1,)), result, operands))
        elif terms or row.series:
            series = row.series or Recurrence((1, 1))
            lines.append(line(series, result, terms or operands))
        elif not is_step:
            recurrence = by_slope(result, operands[0], -1)
            lines.append(recurrence)
            # the slope reads the result
            outer = row.slopes[0](*nodes, Node(self, result))  # type: ignore[arg-type]
            recurrence[0][SLOPE] = outer.argument

    def table(self, product: int, value: int) -> Any:
        """Return x and its place, and rows, of straight lines between the points of a table.

        These are three picks at one place: slope (x - point) + value.
        """

        def made(slot: int) -> Any:
            return self.made.get(slot, NONE)

        name, factors, _ = made(product)
        if name != "mul" or made(factors[1])[0] != "sub":
            return None
        x, point = made(factors[1])[1]
        picks = [made(slot) for slot in (point, factors[0], value)]
        places = {pick[1][:1] for pick in picks if pick[0] == "pick"}
        if len(places) != 1 or any(pick[0] != "pick" for pick in picks):
            return None
        place = picks[0][1][0]
        name, (of, *joints), _ = (
            made(place) if made(place)[0] == "search" else ("", (-1,), 0)
        )
        if of != x:
            return None
        return (x, place), (joints, *([*pick[1][1:]] for pick in picks))


def by_slope(result: int, operand: int, slope: int) -> tuple[list[int], list[float]]:
    """Return the recurrence of a function, or of a term of one, by its slope."""
    return [result, -1, -1, operand, slope, 1, 0, -1, 1], [0.0, 0.0, 1.0, 1.0]


def line(
    row: Recurrence, result: int, operands: Sequence[int]
) -> tuple[list[int], list[float]]:
    """Return a recurrence of the table of operations."""
    values = *operands, result
    signs = (*row.signs, 0, 0)[:2]
    left, right = (values[k] if signs[k] else -1 for k in (0, 1))
    u, v = (-1, -1) if row.products is None else (values[k] for k in row.products)
    divisor = -1 if row.divisor is None else values[row.divisor]
    return (
        [result, left, right, u, v, row.first, row.last, divisor, 0],
        [*signs, -1.0 if row.signs else 1.0, row.factor],
    )
