"""The record of a block's equations, from which every other reading is made.

Each operation on a signal, parameter or the time is written down, in single assignment:

    v0 = t    v1 = x[0]    v2 = u[0]    v3 = p.gain[0]    v4 = mul(v3, v2)

An operation is a tuple of a name and arguments.  An argument is a value (int: its
place in the list), a constant (float), or a tuple with more.

    ("t",)  ("x", i)  ("u", i)  ("p", field, k)      leaves
    ("add", 4, 2.0)  ("where", 5, 2, 3)              arithmetic, words, functions of `math`
    ("table", index, (field, first, stride, count))  `lookup` in a parameter
    ("pick", index, a, b, ...)                       `lookup` in other numbers
    ("opaque", (name, ...), value, ...)              `value`; SymPy reads a function of the rest

Where a loop begins, turns and ends is marked; nothing else is kept of it.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

LEAVES = frozenset({"t", "x", "u", "p"})
Ref = int | float


@dataclass(frozen=True, eq=False)
class Record:
    """What a function did, in single assignment."""

    operations: tuple[tuple, ...]  # name and arguments
    outputs: tuple[Ref, ...]  # what the last argument holds at the end, value or constant
    marks: tuple[tuple[int, str], ...] = ()  # before an operation, "enter", "turn" or "leave"

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

    def without_opaque(self) -> "Record":
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
        return Record(tuple(operations), tuple(map(same, self.outputs)), self.marks)

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
