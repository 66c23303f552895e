"""Print the nests of a program as C99: the same loops and numbers as machine code has.

    static void rates_(double t, const double *x, const double *u, const double *p, ...)
    { const double v0 = x[0] - p[3]; for (int i0 = 0; i0 < 50; i0++) { ... } }

A diagram is printed as it was written: nothing is prepared for a whole run, and no decision is
locked.  Inputs are one array.  Intervals and jumps, which an integrator sets, are another, `kept`.
"""

from collections.abc import Iterator
from importlib import resources
from math import copysign, inf, isnan
from typing import Any

import numpy as np

from ..record.graph import deep
from ..trace.arrays import CONDITIONS
from .diagram_record import DiagramRecord, Layout
from .fused_expressions import Components, row_strides
from .loop_nests import ROWS
from .plan import Nest, Planner

SIGNATURE = "double t, const double *x, const double *u, const double *p, const double *kept"
ARRAYS = {"X": "x", "U": "u", "P": "p", "I": "kept", "T": "T_", "K": "K_", "W": "w", "D": "out"}
INFIX = {
    **{"add": "+", "sub": "-", "mul": "*", "div": "/", "and": "&&", "or": "||"},
    **{"lt": "<", "le": "<=", "gt": ">", "ge": ">=", "eq": "==", "ne": "!="},
}
PREFIX = {"neg": "-", "not": "!"}
FUNCTIONS = (resources.files("clpt_control.data") / "numpy.c").read_text("utf-8").split("\n\n")
HELPERS = {one.split()[2].partition("_(")[0]: one.strip() for one in FUNCTIONS}


class CRecord(DiagramRecord):
    """A diagram whose inputs are an array, and whose intervals and jumps another."""

    def __init__(self, wiring: Any, layout: Layout):
        self.set_by_integrator = [*layout.intervals.values(), *layout.jumps.values()]  # places in P
        super().__init__(wiring, layout, "free")

    def _inputs(self) -> int:
        return self.load("U", 0, (self.wiring.ninputs,))

    def load(self, array: str, first: int, shape: tuple) -> int:
        """Return the numbers of an array from a place."""
        if array == "P" and first in self.set_by_integrator:
            return super().load("I", self.set_by_integrator.index(first), shape)
        return super().load(array, self.place(first) if array == "P" else first, shape)

    def place(self, first: int) -> int:
        """Return the place in `p` of a parameter in P."""
        return first - sum(one < first for one in self.set_by_integrator)


class CProgram:
    """The functions of a diagram, and what they share."""

    def __init__(self, record: CRecord, signals: int):
        self.components = Components(record, signals)
        self.helpers: dict[str, None] = {}
        ports = {"rates": (record.rates, "D"), "signals": (record.signals, "W")}
        if record.layout.jumps:
            ports["jump"] = record.leaps, "D"
        with deep():
            writes = {name: self.components.writes(*own) for name, own in ports.items()}
            plan = Planner(self.components)
            nests = {name: plan.nests(own) for name, own in writes.items()}
            self.functions = {name: _Function(self, own).text for name, own in nests.items()}

    def function(self, name: str) -> str:
        """Return one function; `signals` writes into `w`, its argument, the others into `out`."""
        text, into = self.functions[name], "w" if name == "signals" else "out"
        room = f"    double w[{self.components.room}];\n" if into == "out" and "w[" in text else ""
        names = (one.split()[-1].strip("*") for one in [*SIGNATURE.split(","), into])
        unused = "".join(f" (void){one};" for one in names)
        return f"static void {name}_({SIGNATURE}, double *{into}) {{\n   {unused}\n{room}{text}}}\n"

    def shared(self, T: Any) -> Iterator[str]:
        """Yield the functions that C does not have, and arrays of numbers."""
        for name in self.helpers:
            yield f"{HELPERS[name]}\n"
        text = "".join(self.functions.values())
        tables = np.concatenate([T, *self.components.tables])
        for array, values in (("T_", tables), ("K_", self.components.constants)):
            if array in text:
                yield f"static const double {array}[] = {{{', '.join(map(c_number, values))}}};\n"


def c_number(value: float) -> str:
    """Return a number as C writes it, to the last bit."""
    if isnan(value):
        return "NAN"
    text = "INFINITY" if abs(value) == inf else repr(abs(float(value)))
    return f"(-{text})" if copysign(1.0, value) < 0 else text


class _Function:
    """A function's nests, printed one after the other."""

    def __init__(self, program: CProgram, nests: tuple[Nest, ...]):
        self.program, self.all = program, program.components.all
        self.saved: dict[int, int] = {}  # component -> its place in `w`, once it is written
        self.numbers: dict[Any, str] = {}  # values outside all loops
        self.text = "".join(line for nest in nests for line in self.nest(nest))

    def nest(self, nest: Nest) -> Iterator[str]:
        """Yield the lines of a nest of loops."""
        depth = len(nest.lengths)
        self.heads: list[list[str]] = [[] for _ in range(depth + 1)]
        self.known: list[dict[Any, str]] = [self.numbers, *({} for _ in range(depth))]
        loops, sums, after = tuple(range(depth)), dict[int, str](), list[str]()
        body: list[str] = []
        for item in nest.items:
            value = self.argument(item.value, loops)
            if item.summed:
                c = item.saves
                sums[c] = f"s{c}"
                body.append(f"s{c} += {value};")
                if item.strides:
                    place = self.at(item.array, item.first, loops[:-1], item.strides)
                    after.append(f"{place} = s{c};")
            else:
                body.append(f"{self.at(item.array, item.first, loops, item.strides)} = {value};")
        before = [f"double {name} = 0.0;" for name in sums.values()]
        for d, (lines, n) in enumerate(zip(self.heads, nest.lengths, strict=False)):
            if d == depth - 1:
                lines = [*lines, *before]
            yield from self.indented(d, lines)
            yield from self.indented(d, [f"for (int i{d} = 0; i{d} < {n}; i{d}++) {{"])
        yield from self.indented(depth, [*self.heads[depth], *body])
        for d in reversed(range(depth)):
            yield from self.indented(d, ["}", *(after if d == depth - 1 else ())])
        for item in nest.items:
            if item.saves >= 0 and item.strides:
                self.saved[item.saves] = item.first
        self.numbers |= {(c, ()): name for c, name in sums.items() if not self.all[c].lengths}

    def indented(self, depth: int, lines: list[str]) -> Iterator[str]:
        """Yield lines within so many loops."""
        return ("    " * (1 + depth) + line + "\n" for line in lines)

    def at(self, array: str, first: int, loops: tuple[int, ...], strides: tuple[int, ...]) -> str:
        """Return an element of an array, in an iteration of these loops."""
        if array == "t":
            return "t"
        moves = [f"{s} * i{k}" if s != 1 else f"i{k}" for k, s in zip(loops, strides, strict=True)]
        place = " + ".join([*([str(first)] if first or not moves else []), *moves])
        return f"{ARRAYS[array]}[{place}]"

    def argument(self, a: Any, loops: tuple[int, ...]) -> str:
        """Return an argument: a constant, or a computed value."""
        if type(a) is not tuple:
            return c_number(a)
        return self.value(a[0], tuple([loops[k] for k in a[1]]))

    def value(self, c: int, loops: tuple[int, ...]) -> str:
        """Return a value, which is printed at the beginning of the innermost of its loops."""
        depth = max(loops, default=-1) + 1
        name, arguments, lengths = self.all[c]
        if c in self.saved:
            return self.at("W", self.saved[c], loops, row_strides(lengths))
        if name == "load":
            return self.at(arguments[0], arguments[1], loops, arguments[2])
        known = self.known[depth]
        if (c, loops) not in known:
            text = self.operation(name, arguments, loops)
            known[c, loops] = f"v{c}" + "".join(f"_{k}" for k in loops)
            kind = "int" if name in CONDITIONS else "double"
            self.heads[depth].append(f"const {kind} {known[c, loops]} = {text};")
        return known[c, loops]

    def operation(self, name: str, arguments: tuple, loops: tuple[int, ...]) -> str:
        """Return an operation on its arguments."""
        if name in HELPERS:
            self.program.helpers[name] = None
        if name in ROWS:
            array, first, stride, count, *_ = self.all[arguments[ROWS[name]][0]].arguments
            rest = [one for k, one in enumerate(arguments) if k != ROWS[name]]
            more = "".join(f", {self.argument(one, loops)}" for one in rest)
            return f"{name}_({ARRAYS[array]} + {first}, {stride}, {count}{more})"
        values = [self.argument(a, loops) for a in arguments]
        if name in INFIX:
            return f" {INFIX[name]} ".join(values)
        if name in PREFIX:
            return f"{PREFIX[name]}{values[0]}"
        if name == "where":
            return "{} ? {} : {}".format(*values)
        return f"{name}{'_' if name in HELPERS else ''}({', '.join(values)})"
