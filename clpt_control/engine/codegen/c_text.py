"""C99 text of a program: the same loops and numbers as its machine code.

    static void rates_(double t, const double *x, const double *u, const double *p, ...)
    { const double v0 = x[0] - p[3]; for (int i0 = 0; i0 < 50; i0++) { ... } }

The diagram is printed without preparation for a whole run and without locked decisions.  The inputs
are one array.  Intervals and jumps, which an integrator sets, are another array, `kept`.
"""

from collections.abc import Callable, Iterator
from itertools import chain
from math import copysign, inf, isnan
from typing import Any

import numpy as np

from ...base.errors import BlockError
from ...base.html import asset
from ..record.graph import deep
from ..record.operations import CONDITIONS, TABLE
from .diagram_record import DiagramRecord, Form, Layout
from .fused_expressions import Components, Loops, Write
from .loop_nests import Body, Element, Key, LoopPrinter
from .plan import Nest, Planner
from .switching_conditions import Port

SIGNATURE = (
    "double t, const double *x, const double *u, const double *p, const double *kept"
)
ARRAYS = {
    "X": "x",
    "U": "u",
    "P": "p",
    "I": "kept",
    "T": "T_",
    "K": "K_",
    "W": "w",
    "D": "out",
}
FUNCTIONS = asset("numpy.c").split("\n\n")
HELPERS = {one.split()[2].partition("(")[0]: one.strip() for one in FUNCTIONS}


class CRecord(DiagramRecord):
    """A diagram whose inputs are an array, and whose intervals and jumps another."""

    def __init__(self, wiring: Any, layout: Layout):
        # places in P
        self.set_by_integrator = [*layout.intervals.values(), *layout.jumps.values()]
        super().__init__(wiring, layout, Form(locking=False))
        systems = [node.system for node in wiring.nodes]
        guarded = [k for k, system in enumerate(systems) if system.guard is not None]
        # distances of guards at which states jump, by block
        self.levels = {
            k: guard.now
            for k, guard in zip(guarded, self.guards, strict=True)
            if systems[k].jumps_at_level
        }

    def _inputs(self) -> int:
        return self.load("U", 0, (self.wiring.ninputs,))

    def load(self, array: str, offset: int, shape: tuple) -> int:
        """Return the numbers of an array from a place."""
        if array == "P" and offset in self.set_by_integrator:
            return super().load("I", self.set_by_integrator.index(offset), shape)
        if array == "P":
            offset = self.place(offset)
        return super().load(array, offset, shape)

    def place(self, offset: int) -> int:
        """Return the place in `p` of a parameter in P."""
        return offset - sum(setting < offset for setting in self.set_by_integrator)


class CProgram:
    """The functions of a diagram, and what they share."""

    def __init__(self, record: CRecord, signals: int):
        self.components = Components(record, signals)
        self.helpers: dict[str, None] = {}
        ports = {"rates": (record.rates, "D"), "signals": (record.signals, "W")}
        if record.layout.jumps:
            ports["jump"] = record.leaps, "D"
        if record.levels:
            levels = [
                Port(j, (), (), ref) for j, ref in enumerate(record.levels.values())
            ]
            ports["levels"] = levels, "D"
        with deep():
            writes = {
                name: self.components.writes(*arguments)
                for name, arguments in ports.items()
            }
            plan = Planner(self.components)
            self.functions = {
                name: CPrinter(self, plan.nests(items)).text
                for name, items in writes.items()
            }

    def function(self, name: str) -> str:
        """Return one function; `signals` writes into `w`, its argument, the others into `out`."""
        text = self.functions[name]
        into = "w" if name == "signals" else "out"
        room = ""
        if into == "out" and "w[" in text:
            room = f"    double w[{self.components.room}];\n"
        unused = "".join(f" (void){name};" for name in (*"txup", "kept", into))
        return f"static void {name}_({SIGNATURE}, double *{into}) {{\n   {unused}\n{room}{text}}}\n"

    def shared(self, T: Any) -> Iterator[str]:
        """Yield the functions that C does not have, and arrays of numbers."""
        for name in self.helpers:
            yield f"{HELPERS[name]}\n"
        text = "".join(self.functions.values())
        tables = np.concatenate([T, *self.components.tables])
        for array, values in (("T_", tables), ("K_", self.components.constants)):
            if array in text:
                numbers = ", ".join(map(c_number, values))
                yield f"static const double {array}[] = {{{numbers}}};\n"


def c_number(value: float) -> str:
    """Return a number as C writes it, to the last bit."""
    if isnan(value):
        return "NAN"
    text = "INFINITY" if abs(value) == inf else repr(abs(float(value)))
    return f"(-{text})" if copysign(1.0, value) < 0 else text


class CPrinter(LoopPrinter):
    """Printer of the nests of one function."""

    def __init__(self, program: CProgram, nests: tuple[Nest, ...]):
        super().__init__(program.components.all, {})
        self.program = program
        self.lines: list[
            list[str]
        ] = []  # lines in order; a list for values to come in each loop
        self.values: dict[int, list[str]] = {}  # lists for values inside so many loops
        self.depth = 0
        for nest in nests:
            self.print_nest(nest)
        self.text = "".join(chain(*self.lines))

    def begin_body(self, depth: int) -> None:
        """Begin the statements inside `depth` loops."""
        self.depth = depth
        self.values[depth] = []
        self.lines.append(self.values[depth])

    def insert(self, depth: int, key: Key, printer: Callable[[], str]) -> str:
        """Print a value at the beginning of the statements inside `depth` loops."""
        component, loops, _ = key
        text = printer()
        if self.location(component) is not None:
            return text
        suffix = "".join(f"_{loop}" for loop in loops)
        name = f"v{component}{suffix}"
        kind = "int" if self.components[component].name in CONDITIONS else "double"
        self.values[depth].append(indented(depth, f"const {kind} {name} = {text};"))
        return name

    def statement(self, text: str) -> None:
        """Print a statement."""
        self.lines.append([indented(self.depth, text)])

    def print_loop(self, depth: int, body: Body, totals: list[Write]) -> list[str]:
        """Print the loop inside `depth` others; return the sums after it."""
        count = self.current_nest.lengths[depth]
        index = f"i{depth}"
        sums = [f"s{total.saves}" for total in totals]
        for name in sums:
            self.statement(f"double {name} = 0.0;")
        self.statement(f"for (int {index} = 0; {index} < {count}; {index}++) {{")
        body(index, sums)
        self.depth = depth
        self.statement("}")
        return sums

    def add(self, total: str, value: str) -> str:
        """Add a value to a sum."""
        self.statement(f"{total} += {value};")
        return total

    def load(self, element: Element) -> str:
        """Return an element of an array."""
        array, offset, steps, _ = element
        if array == "t":
            return "t"
        terms = [
            index if stride == 1 else f"{stride} * {index}" for index, stride in steps
        ]
        if offset or not terms:
            terms.insert(0, str(offset))
        return f"{ARRAYS[array]}[{' + '.join(terms)}]"

    def store(self, value: str, element: Element) -> None:
        """Write an element of an array."""
        self.statement(f"{self.load(element)} = {value};")

    def number(self, value: float, vectorized: bool) -> str:
        """Return a constant."""
        return c_number(value)

    def operation(self, name: str, loops: Loops, values: list[str]) -> str:
        """Return an operation on its arguments."""
        symbol = TABLE[name].c
        if symbol.isidentifier():
            return self.call(symbol, values)
        if symbol == "?:":
            return "{} ? {} : {}".format(*values)
        if len(values) == 1:
            return f"{symbol}{values[0]}"
        return f" {symbol} ".join(values)

    def row_operation(self, name: str, row: tuple, values: list[str]) -> str:
        """Return an operation on a row."""
        array, offset, stride, count = row
        address = f"{ARRAYS[array]} + {offset}"
        arguments = [address, str(stride), str(count), *values]
        return self.call(TABLE[name].c, arguments)

    def call(self, function: str, arguments: list[str]) -> str:
        """Return a call of a function, of the C library or of `numpy.c`."""
        if function.endswith("_"):
            if function not in HELPERS:
                raise BlockError(f"{function}: is not in data/numpy.c. Write it in C99")
            self.program.helpers[function] = None
        return f"{function}({', '.join(arguments)})"


def indented(depth: int, text: str) -> str:
    """Return a line inside `depth` loops."""
    return "    " * (1 + depth) + text + "\n"
