"""The scalars reading of a record: every element apart, in single assignment.

    v0 = t    v1 = x[0]    v2 = u[0]    v3 = p.gain[0]    v4 = mul(v3, v2)

An operation is a tuple of a name and arguments.  An argument is a value (int: its
place in the list), a constant (float), or a tuple with more.

    ("t",)  ("x", i)  ("u", i)  ("p", field, k)      leaves
    ("add", 4, 2.0)  ("where", 5, 2, 3)              arithmetic, words, functions of `math`
    ("table", index, (field, first, stride, count))  `lookup` in a parameter
    ("pick", index, a, b, ...)                       `lookup` in other numbers
    ("opaque", (name, ...), value, ...)              `value`; SymPy reads a function of the rest

"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import copysign, prod
from typing import Any

import numpy as np

from .arrays import Unread
from .numbers import sized
from .record import Record, Shape

LEAVES = frozenset({"t", "x", "u", "p"})
MOST_AT_ONCE = 256  # elements of an array that are computed whether they are used or not
MOST = 300_000  # operations; more are given up
Ref = Any  # int: the place of a value; float: a constant


@dataclass(frozen=True, eq=False)
class Scalars:
    """What a function did, in single assignment."""

    operations: tuple[tuple, ...]  # name and arguments
    outputs: tuple[Ref, ...]  # what the last argument holds at the end, value or constant

    def replay(self, leaf: Callable[..., Any], apply: Callable[..., Any]) -> list[Any]:
        """Run the record on numbers of another kind: ``leaf("x", 0)``, ``apply("add", a, b)``."""
        values: list[Any] = []
        for name, *arguments in self.operations:
            if name in LEAVES:
                values.append(leaf(name, *arguments))
            else:
                given = [values[a] if type(a) is int else a for a in arguments]
                values.append(apply(name, *given))
        return [values[ref] if type(ref) is int else ref for ref in self.outputs]

    def reads_inputs(self) -> bool:
        """Return whether an output depends on an input."""
        reached = {ref for ref in self.outputs if type(ref) is int}
        for k in range(len(self.operations) - 1, -1, -1):
            if k in reached and self.operations[k][0] not in LEAVES:
                reached.update(a for a in self.operations[k][1:] if type(a) is int)
        return any(self.operations[k][0] == "u" for k in reached)

    def inputs_of_outputs(self) -> list[set[int]]:
        """Return for each output the inputs that it depends on."""
        found: list[set[int]] = []
        for name, *arguments in self.operations:
            if name in LEAVES:
                found.append({arguments[0]} if name == "u" else set())
            else:
                found.append(set().union(*(found[a] for a in arguments if type(a) is int)))
        return [found[ref] if type(ref) is int else set() for ref in self.outputs]

    def without_opaque(self) -> "Scalars":
        """Return the record with opaque helpers replaced by what they compute."""
        behind: dict[int, Ref] = {}
        operations: list[tuple] = []

        def same(a: Any) -> Any:
            return behind.get(a, a) if type(a) is int else a

        for k, (name, *arguments) in enumerate(self.operations):
            given = arguments if name in LEAVES else map(same, arguments)
            operation = (name, *given)
            if name == "opaque":
                behind[k] = operation[2]
                operation = ("t",)  # keeps the place and is not read
            operations.append(operation)
        return Scalars(tuple(operations), tuple(map(same, self.outputs)))

    def __str__(self) -> str:
        def shown(a: Any) -> str:
            return f"v{a}" if type(a) is int else repr(a)

        def line(name: str, arguments: tuple) -> str:
            if name == "t":
                return "t"
            if name == "p":
                return f"p.{arguments[0]}[{arguments[1]}]"
            if name in LEAVES:
                return f"{name}[{arguments[0]}]"
            return f"{name}({', '.join(map(shown, arguments))})"

        lines = [f"v{k} = {line(o[0], o[1:])}" for k, o in enumerate(self.operations)]
        return "\n".join(lines + [f"out[{k}] = {shown(r)}" for k, r in enumerate(self.outputs)])


class _Lowered:
    """The elements of a record's arrays, each computed once."""

    def __init__(self, record: Record, sizes: Mapping[str, int], first: Mapping[tuple, int]):
        self.lines, self.first = record.operations, first
        self.shapes = [sized(o.shape, dict(sizes)) for o in record.operations]
        self.operations: list[tuple] = []
        self.places: dict[tuple, int] = {}
        self.found: dict[tuple, Ref] = {}

    def add(self, *operation: Any) -> int:
        key = tuple((a, copysign(1.0, a), "float") if type(a) is float else a for a in operation)
        if key not in self.places:
            self.places[key] = len(self.operations)
            self.operations.append(operation)
            if len(self.operations) > MOST:
                raise Unread(f"takes more than {MOST} operations on single numbers")
        return self.places[key]

    def at(self, ref: Ref, index: tuple[int, ...]) -> Ref:
        """Return an element of a value; a shorter one is broadcast."""
        if type(ref) is float:
            return ref
        shape = self.shapes[ref]
        index = index[len(index) - len(shape) :]
        index = tuple(0 if n == 1 else k for k, n in zip(index, shape, strict=True))
        if (ref, index) not in self.found:
            self.found[ref, index] = self.element(ref, index)
        return self.found[ref, index]

    def element(self, ref: int, index: tuple[int, ...]) -> Ref:
        kind, arguments, _, at = self.lines[ref]
        shape = self.shapes[ref]
        if kind == "leaf":
            group, name = at
            if group == "t":
                return self.add("t")
            k = int(np.ravel_multi_index(index, shape)) if shape else 0
            return self.add("p", name, k) if group == "p" else self.add(group, self.first[at] + k)
        if kind == "constant":
            return float(np.frombuffer(at).reshape(shape)[index])
        if kind == "view":
            source = tuple(m if isinstance(m, int) else m[1] + m[2] * index[m[0]] for m in at)
            return self.at(arguments[0], source)
        if kind == "fill":
            return self.at(arguments[0], ())
        if kind == "stack":
            return self.at(arguments[index[0]], index[1:])
        if kind == "join":
            k, part = index[0], 0
            while k >= (n := self.shapes[arguments[part]][0]):
                k, part = k - n, part + 1
            return self.at(arguments[part], (k, *index[1:]))
        if kind == "sum":
            return self.summed(arguments[0], at, index)
        if kind == "pick":
            return self.picked(arguments[0], arguments[1], index)
        if kind == "opaque":
            given = [self.at(a, k) for a in arguments[1:] for k in self.indices(a)]
            number = int(np.ravel_multi_index(index, shape)) if shape else 0
            return self.add("opaque", (*at, number), self.at(arguments[0], index), *given)
        return self.calculated(kind, *(self.at(a, index) for a in arguments))

    def indices(self, ref: Ref) -> Any:
        return np.ndindex(self.shapes[ref]) if type(ref) is int else [()]

    def summed(self, array: Any, axis: int, index: tuple[int, ...]) -> Ref:
        total: Ref | None = None
        for k in range(self.shapes[array][axis]):
            one = self.at(array, (*index[:axis], k, *index[axis:]))
            total = one if total is None else self.calculated("add", total, one)
        return 0.0 if total is None else total

    def picked(self, table: Any, index: Ref, place: tuple[int, ...]) -> Ref:
        whole, count = self.at(index, place), self.shapes[table][0]
        source, mapped = table, ((0, 0, 1),)
        if self.lines[table].kind == "view":
            source, mapped = self.lines[table].arguments[0], self.lines[table].at
        if self.lines[source].kind != "leaf" or self.lines[source].at[0] != "p":
            return self.add("pick", whole, *(self.at(table, (k,)) for k in range(count)))
        shape = self.shapes[source]
        strides = [prod(shape[d + 1 :]) for d in range(len(shape))]
        pairs = [(m, 0) if isinstance(m, int) else m[1:] for m in mapped]
        first = sum(start * n for (start, _), n in zip(pairs, strides, strict=True))
        stride = sum(step * n for (_, step), n in zip(pairs, strides, strict=True))
        return self.add("table", whole, (self.lines[source].at[1], first, stride, count))

    def calculated(self, kind: str, *a: Ref) -> Ref:
        if kind in ("eq", "ne"):
            same = self.add("and", self.add("le", *a), self.add("ge", *a))
            return same if kind == "eq" else self.add("not", same)
        if kind == "pow" and a[1] in (2.0, 3.0, 4.0):
            square = self.add("mul", a[0], a[0])
            return square if a[1] == 2.0 else self.add("mul", square, a[0] if a[1] == 3 else square)
        if kind == "pow" and a[1] == 0.5:
            return self.add("sqrt", a[0])
        if kind == "sign":
            return self.add("add", self.add("sign", *a), 0.0)
        return self.add(kind, *a)


def scalars_of(
    record: Record,
    sizes: Mapping[str, int],
    states: Mapping[str, Shape],
    inputs: Mapping[str, Shape],
) -> Scalars:
    """Return the scalars reading of a record; outputs of all ports stand in a row."""
    first: dict[tuple, int] = {}
    for group, shapes in (("x", states), ("u", inputs)):
        at = 0
        for port, shape in shapes.items():
            first[group, port] = at
            at += prod(shape)
    lowered = _Lowered(record, sizes, first)
    for k, shape in enumerate(lowered.shapes):  # in order, so that nothing calls itself deep
        if prod(shape) <= MOST_AT_ONCE:
            for index in np.ndindex(shape):
                lowered.at(k, index)
    outputs: list[Ref] = []
    for ref, shape in zip(record.outputs, record.shapes, strict=True):
        outputs += [lowered.at(ref, index) for index in np.ndindex(sized(shape, dict(sizes)))]
    return _compact(lowered.operations, outputs)


def _compact(operations: list[tuple], outputs: list[Ref]) -> Scalars:
    """Return what outputs depend on."""
    used = {ref for ref in outputs if type(ref) is int}
    for k in range(len(operations) - 1, -1, -1):
        if k in used and operations[k][0] not in LEAVES:
            used.update(a for a in operations[k][1:] if type(a) is int)
    place = {old: new for new, old in enumerate(sorted(used))}

    def moved(arguments: Any) -> Any:
        return (place[a] if type(a) is int else a for a in arguments)

    lines = (operations[k] for k in sorted(used))
    kept = (o if o[0] in LEAVES else (o[0], *moved(o[1:])) for o in lines)
    return Scalars(tuple(kept), tuple(moved(outputs)))
