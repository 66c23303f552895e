"""Print the nests of a program as C99: the same loops and numbers as machine code has.

    static void rates_(double t, const double *x, const double *u, const double *p, ...)
    { const double v0 = x[0] - p[3]; for (int i0 = 0; i0 < 50; i0++) { ... } }

A diagram is printed as it was written: nothing is prepared for a whole run, and no decision is
locked.  Inputs are an array, numbers that an integrator keeps (intervals, jumps) another.
"""

from collections.abc import Iterator
from math import copysign, inf, isnan
from typing import Any

from ..equations.arrays import CONDITIONS
from ..errors import Uncompiled
from .components import Components, deep, rows
from .diagram_record import DiagramRecord, Layout
from .plan import Nest, Planner

GIVEN = "double t, const double *x, const double *u, const double *p, const double *kept"
ARRAYS = {"X": "x", "U": "u", "P": "p", "I": "kept", "T": "T_", "K": "K_", "W": "w", "D": "out"}
INFIX = {
    **{"add": "+", "sub": "-", "mul": "*", "div": "/", "and": "&&", "or": "||"},
    **{"lt": "<", "le": "<=", "gt": ">", "ge": ">=", "eq": "==", "ne": "!="},
}
PREFIX = {"neg": "-", "not": "!"}
OF_MATH = frozenset(
    (
        *("exp", "expm1", "log", "log1p", "log2", "log10", "sqrt", "fabs", "floor", "ceil"),
        *("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "hypot", "pow", "trunc"),
        *("sinh", "cosh", "tanh", "asinh", "acosh", "atanh", "erf", "erfc"),
    )
)
OWN = {  # what NumPy has and C has not, or otherwise
    "minimum": "(double a, double b) { return a < b || isnan(a) ? a : b; }",
    "maximum": "(double a, double b) { return a > b || isnan(a) ? a : b; }",
    "sign": "(double a) { return a > 0.0 ? 1.0 : a < 0.0 ? -1.0 : 0.0 * a + 0.0; }",
    "mod": """(double a, double b) {
    const double left = fmod(a, b);
    if (left == 0.0) return copysign(0.0, b);
    return (left < 0.0) != (b < 0.0) ? left + b : left;
}""",
    "floordiv": """(double a, double b) {
    const double left = fmod(a, b);
    double ratio = (a - left) / b, whole;
    if (b == 0.0) return a / b;
    if (left != 0.0 && (left < 0.0) != (b < 0.0)) ratio -= 1.0;
    whole = floor(ratio);
    return ratio - whole > 0.5 ? whole + 1.0 : whole;
}""",
    "lookup": """(const double *row, int stride, int count, double place) {
    double whole = trunc(place);
    if (whole < 0.0) whole += count;
    return whole >= 0.0 && whole < count ? row[stride * (int)whole] : NAN;
}""",
}


class Record(DiagramRecord):
    """A diagram whose inputs are an array, and whose intervals and jumps another."""

    def __init__(self, wiring: Any, layout: Layout):
        self.kept = [*layout.intervals.values(), *layout.jumps.values()]  # places in P
        super().__init__(wiring, layout, locking=False)

    def _inputs(self) -> int:
        return self.load("U", 0, (self.wiring.ninputs,))

    def load(self, array: str, first: int, shape: tuple) -> int:
        """Return the numbers of an array from a place."""
        if array == "P" and first in self.kept:
            return super().load("I", self.kept.index(first), shape)
        return super().load(array, self.place(first) if array == "P" else first, shape)

    def place(self, first: int) -> int:
        """Return where a parameter of P stands among those that are given."""
        return first - sum(one < first for one in self.kept)


class Program:
    """The functions of a diagram, and what they share."""

    def __init__(self, record: Record, signals: int):
        self.made = Components(record, signals)
        self.helpers: dict[str, None] = {}
        ports = {"rates": (record.rates, "D"), "signals": (record.signals, "W")}
        if record.layout.jumps:
            ports["jump"] = record.leaps, "D"
        with deep():
            writes = {name: self.made.writes(*own) for name, own in ports.items()}
            plan = Planner(self.made)
            nests = {name: plan.nests(own) for name, own in writes.items()}
            self.functions = {name: _Function(self, own).text for name, own in nests.items()}

    def function(self, name: str) -> str:
        """Return one function; `signals` fills what it is given as room, the others `out`."""
        text, into = self.functions[name], "w" if name == "signals" else "out"
        room = f"    double w[{self.made.room}];\n" if into == "out" and "w[" in text else ""
        given = (one.split()[-1].strip("*") for one in [*GIVEN.split(","), into])
        unused = "".join(f" (void){one};" for one in given)
        return f"static void {name}_({GIVEN}, double *{into}) {{\n   {unused}\n{room}{text}}}\n"

    def shared(self, T: Any) -> Iterator[str]:
        """Yield the functions that C has not, and arrays of numbers."""
        for name in self.helpers:
            yield f"static double {name}_{OWN[name]}\n"
        text = "".join(self.functions.values())
        for array, values in (("T_", T), ("K_", self.made.constants)):
            if array in text:
                yield f"static const double {array}[] = {{{', '.join(map(number, values))}}};\n"


def number(value: float) -> str:
    """Return a number as C writes it, to the last bit."""
    if isnan(value):
        return "NAN"
    text = "INFINITY" if abs(value) == inf else repr(abs(float(value)))
    return f"(-{text})" if copysign(1.0, value) < 0 else text


class _Function:
    """A function's nests, printed one after the other."""

    def __init__(self, program: Program, nests: tuple[Nest, ...]):
        self.program, self.all = program, program.made.all
        self.saved: dict[int, int] = {}  # what lies in `w` by now
        self.numbers: dict[Any, str] = {}  # what is outside all loops
        self.text = "".join(line for nest in nests for line in self.nest(nest))

    def nest(self, nest: Nest) -> Iterator[str]:
        """Yield the lines of a nest of loops."""
        depth = len(nest.lengths)
        self.heads: list[list[str]] = [[] for _ in range(depth + 1)]
        self.known: list[dict[Any, str]] = [self.numbers, *({} for _ in range(depth))]
        turns, sums, after = tuple(range(depth)), dict[int, str](), list[str]()
        own: list[str] = []
        for item in nest.items:
            value = self.argument(item.value, turns)
            if item.summed:
                c = item.saves
                sums[c] = f"s{c}"
                own.append(f"s{c} += {value};")
                if item.strides:
                    place = self.at(item.array, item.first, turns[:-1], item.strides)
                    after.append(f"{place} = s{c};")
            else:
                own.append(f"{self.at(item.array, item.first, turns, item.strides)} = {value};")
        before = [f"double {name} = 0.0;" for name in sums.values()]
        for d, (lines, n) in enumerate(zip(self.heads, nest.lengths, strict=False)):
            if d == depth - 1:
                lines = [*lines, *before]
            yield from self.indented(d, lines)
            yield from self.indented(d, [f"for (int i{d} = 0; i{d} < {n}; i{d}++) {{"])
        yield from self.indented(depth, [*self.heads[depth], *own])
        for d in reversed(range(depth)):
            yield from self.indented(d, ["}", *(after if d == depth - 1 else ())])
        for item in nest.items:
            if item.saves >= 0 and item.strides:
                self.saved[item.saves] = item.first
        self.numbers |= {(c, ()): name for c, name in sums.items() if not self.all[c].lengths}

    def indented(self, depth: int, lines: list[str]) -> Iterator[str]:
        """Yield lines within so many loops."""
        return ("    " * (1 + depth) + line + "\n" for line in lines)

    def at(self, array: str, first: int, turns: tuple[int, ...], strides: tuple[int, ...]) -> str:
        """Return an element of an array."""
        if array == "t":
            return "t"
        moves = [f"{s} * i{k}" if s != 1 else f"i{k}" for k, s in zip(turns, strides, strict=True)]
        place = " + ".join([*([str(first)] if first or not moves else []), *moves])
        return f"{ARRAYS[array]}[{place}]"

    def argument(self, a: Any, turns: tuple[int, ...]) -> str:
        """Return an argument: a constant, or what is computed."""
        if type(a) is not tuple:
            return number(a)
        return self.value(a[0], tuple([turns[k] for k in a[1]]))

    def value(self, c: int, turns: tuple[int, ...]) -> str:
        """Return a value, printed where the innermost of its loops begins a turn."""
        depth = max(turns, default=-1) + 1
        name, arguments, lengths = self.all[c]
        if c in self.saved:
            return self.at("W", self.saved[c], turns, rows(lengths))
        if name == "load":
            return self.at(arguments[0], arguments[1], turns, arguments[2])
        known = self.known[depth]
        if (c, turns) not in known:
            own = self.called(name, arguments, turns)
            known[c, turns] = f"v{c}" + "".join(f"_{k}" for k in turns)
            kind = "int" if name in CONDITIONS else "double"
            self.heads[depth].append(f"const {kind} {known[c, turns]} = {own};")
        return known[c, turns]

    def called(self, name: str, arguments: tuple, turns: tuple[int, ...]) -> str:
        """Return an operation of arguments."""
        if name in OWN:
            self.program.helpers[name] = None
        if name == "lookup":
            array, first, stride, count, *_ = self.all[arguments[1][0]].arguments
            place = self.argument(arguments[0], turns)
            return f"lookup_({ARRAYS[array]} + {first}, {stride}, {count}, {place})"
        given = [self.argument(a, turns) for a in arguments]
        if name in INFIX:
            return f" {INFIX[name]} ".join(given)
        if name in PREFIX:
            return f"{PREFIX[name]}{given[0]}"
        if name == "where":
            return "{} ? {} : {}".format(*given)
        if name not in OWN and name not in OF_MATH:
            raise Uncompiled(f"`{name}` has no C")
        return f"{name}{'_' if name in OWN else ''}({', '.join(given)})"
