"""How far rounding alone can take one reading of a diagram from another.

A block's record is run on numbers that carry, beside their value,

    size    the sum of the absolute values of the terms that they are made of
    error   a bound on what rounding makes of them, in whatever order sums are taken

    a + b:  error(a) + error(b) + EPS (size(a) + size(b)),    size(a) + size(b)

Python adds one term after the other, machine code eight sums side by side, and SymPy makes
320 a of the sum of 320 a: none is nearer to the truth, and what a sum feeds feels it.
"""

from functools import reduce
from itertools import product
from typing import Any, NamedTuple

import numpy as np

from clpt_control.equations.elements import Elements
from clpt_control.equations.ports import places
from clpt_control.equations.record import OPERATIONS, picked
from clpt_control.native.python_diagram import PythonDiagram

EPS = 2.0**-52
ULPS = 8  # by which functions of two libraries may differ
CONDITIONS = {"lt", "le", "gt", "ge", "and", "or", "not"}


class Rounded(NamedTuple):
    """A number that was rounded."""

    value: Any
    size: Any
    error: Any


class Truth(NamedTuple):
    """A comparison, and whether rounding could turn it."""

    value: bool
    sure: bool


def exact(number: Any) -> Rounded:
    return Rounded(number, abs(number), 0.0)


def rounded(number: Any) -> Any:
    return number if isinstance(number, Rounded | Truth) else exact(np.float64(number))


def added(a: Rounded, b: Rounded, value: Any) -> Rounded:
    size = a.size + b.size
    return Rounded(value, size, a.error + b.error + EPS * size)


def multiplied(a: Rounded, b: Rounded) -> Rounded:
    size = a.size * b.size
    error = a.error * b.size + b.error * a.size + a.error * b.error
    return Rounded(a.value * b.value, size, error + EPS * size)


def spread(function: Any, value: Any, arguments: list[Rounded]) -> Any:
    """Return how far a function moves where its arguments move by their errors."""
    ends = product(*((a.value - a.error, a.value, a.value + a.error) for a in arguments))
    moved = np.array([function(*end) for end in ends], dtype=float)
    return np.abs(moved - value)[np.isfinite(moved)].max(initial=0.0)


def apply(name: str, *arguments: Any) -> Any:
    """Run one operation of a record."""
    given = [rounded(a) for a in arguments]
    function = OPERATIONS[name]
    value = function(*(a.value for a in given))
    if name in CONDITIONS:
        if isinstance(given[0], Truth):
            return Truth(bool(value), all(a.sure for a in given))
        a, b = given
        return Truth(bool(value), bool(abs(a.value - b.value) > a.error + b.error))
    if name == "where":
        condition, a, b = given
        taken = a if condition.value else b
        both = max(a.error, b.error) + abs(a.value - b.value)
        return taken if condition.sure else Rounded(value, max(a.size, b.size), both)
    if name in ("add", "sub"):
        return added(*given, value)
    if name == "mul":
        return multiplied(*given)
    if name == "neg":
        return given[0]._replace(value=value)
    size = abs(value)
    if name == "div" and given[1].value:
        size = given[0].size / abs(given[1].value)
    return Rounded(value, size, spread(function, value, given) + ULPS * EPS * size)


def looked_up(numbers: Any, index: Rounded) -> Rounded:
    """Return one of some rounded numbers, at an index that may be another by rounding."""
    values, sizes, errors = (np.array(column, dtype=float) for column in zip(*numbers, strict=True))
    value = picked(values, index.value)
    moved = spread(lambda at: picked(values, at), value, [index])
    return Rounded(value, sizes.max(), moved + errors.max())


class OfBlock(Elements):
    """The elements of a block's record, rounded."""

    def __init__(self, block: Any, role: str, p: Any, t: float, x: list, u: list):
        super().__init__(block.array_record(role).operations, block.sizes)
        self.given = {"x": (places(block.state_shapes), x), "u": (places(block.input_shapes), u)}
        self.t, self.p = t, p

    def number(self, value: float) -> Rounded:
        """Return a number that is exact."""
        return exact(np.float64(value))

    def leaf(self, at: Any, shape: Any, index: Any) -> Rounded:
        """Return what was given."""
        group, name = at
        if group in self.given:
            where, values = self.given[group]
            part, own = where[name]
            return values[part][int(np.ravel_multi_index(index, own)) if own else 0]
        return exact(
            np.float64(self.t if group == "t" else np.asarray(getattr(self.p, name))[index])
        )

    def apply(self, ref: int, kind: str, arguments: tuple) -> Any:
        """Run one operation."""
        if kind == "sum":
            return reduce(lambda a, b: apply("add", a, b), arguments)
        if kind == "pick":
            return looked_up(list(arguments[1:]), arguments[0])
        if kind in ("eq", "ne"):
            same = apply("and", apply("le", *arguments), apply("ge", *arguments))
            return same if kind == "eq" else apply("not", same)
        return apply(kind, *arguments)


@np.errstate(all="ignore")
def rounding_of(diagram: Any, t: float, x: Any, u: Any) -> np.ndarray:
    """Return bounds on the errors of rates, outputs, and states after all jumps."""
    sweep = PythonDiagram(diagram).sweep
    wiring = sweep.wiring
    outside = [exact(np.float64(value)) for value in u]
    states = [exact(np.float64(value)) for value in x]
    signals = [exact(np.float64(0.0))] * wiring.nodes[-1].outputs.stop
    rates, after = list(states), list(states)

    def fed(node: Any) -> list[Rounded]:
        found = [exact(np.float64(0.0))] * (node.inputs.stop - node.inputs.start)
        for wire in node.wires:
            for j in range(wire.size):
                source = (outside if wire.external else signals)[wire.source + j]
                term = multiplied(exact(wire.gain), source)
                one = found[wire.to + j]
                found[wire.to + j] = added(one, term, one.value + term.value)
        return found

    def run(role: str, k: int) -> list[Rounded]:
        node = wiring.nodes[k]
        p = node.system.parameters_at(t, sweep.parameters[k])
        record = OfBlock(node.system, role, p, t, states[node.states], fed(node))
        return record.outputs(node.system.array_record(role))

    for k in wiring.order:
        signals[wiring.nodes[k].outputs] = run("output", k)
    for k, node in enumerate(wiring.nodes):
        if node.system.nstates:
            rates[node.states] = run("update", k)
    for k in sweep.jumping:
        after[wiring.nodes[k].states] = run("jump", k)
    outputs = []
    output_map = wiring.output_map
    for row in output_map if isinstance(output_map, np.ndarray) else output_map.toarray():
        total = exact(np.float64(0.0))
        for gain, source in zip(row, [*signals, *outside], strict=True):
            if gain:
                term = multiplied(exact(gain), source)
                total = added(total, term, total.value + term.value)
        outputs.append(total)
    return np.array([one.error for one in (*rates, *outputs, *after)], dtype=float)
