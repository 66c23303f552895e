"""Traversal of loop nests, shared by the printers of LLVM (`llvm_text`) and C (`c_text`).

A nest is a set of loops around statements (`plan.Nest`).  A value is printed when it is first used,
at the beginning of the innermost loop on which it depends, and once for each loop index.
"""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from .fused_expressions import Component, Loops, Write, row_strides
from .plan import Nest

# operation -> argument that is a row
ROW_ARGUMENT = {"pick": 1, "search": 1, "argmin": 0}
NO_LOOP = -1
# prints an iteration: index, sums before it -> sums after it
Body = Callable[[Any, list], list]
Printer = Callable[..., Any]
Location = tuple[str, int, tuple[int, ...]]  # array, offset, stride of each axis
# component, loops of its axes, for eight iterations
Key = tuple[int, Loops, bool]


class Element(NamedTuple):
    """Element of an array: array[offset + sum of index * stride]."""

    array: str
    offset: int
    terms: Sequence[tuple[Any, int]]  # index and stride of each loop
    apart: int | None = None  # stride of eight iterations at once


class LoopPrinter:
    """Printer of loop nests; a subclass prints the single statements of a language.

    `vector_loop` is the loop of the current nest that does eight iterations at once.
    """

    vector_loop = NO_LOOP
    # methods of a subclass, which print
    begin_body: Printer  # beginning of statements inside `depth` loops
    # the loop inside `depth` others, of a body, with its sums; returns the sums after it
    print_loop: Printer
    # a value at the beginning of the statements inside `depth` loops: depth, key, printer
    insert: Printer
    add: Printer  # a sum with one more value: total, value
    load: Printer  # an element of an array
    store: Printer  # a value into an element: value, element
    number: Printer  # a constant: value, for eight iterations or one
    operation: Printer  # name, loops, values
    # an operation on a row: name, (array, offset, stride, count), values
    row_operation: Printer

    def __init__(self, components: Sequence[Component], prepared: dict[int, int]):
        self.components = components
        self.prepared = prepared
        self.saved: dict[
            int, int
        ] = {}  # component -> its offset in W, once it is written
        self.outside: dict[Key, Any] = {}  # values outside all loops, of all nests
        self.scopes: list[
            dict[Key, Any]
        ] = []  # values inside so many loops of the current nest

    # --- statements of a language -----------------------------------------------------------

    def broadcast(self, scalar):
        """Return one number for each of eight iterations."""
        return scalar

    # --- nests --------------------------------------------------------------------------------

    def print_nest(self, nest: Nest) -> None:
        """Print a nest of loops, or statements outside all loops."""
        self.current_nest = nest
        depth = len(nest.lengths)
        self.indices: list[Any] = [None] * depth
        self.scopes = [{} for _ in range(depth + 1)]
        self.print_level(0, [])
        for item in nest.items:
            if item.saves >= 0 and item.strides:
                self.saved[item.saves] = item.first

    def print_level(self, depth: int, sums: list) -> list:
        """Print the statements inside `depth` loops; return the sums of the innermost loop."""
        lengths = self.current_nest.lengths
        self.scopes[depth] = {}
        self.begin_body(depth)
        if depth == len(lengths):
            return self.print_items(sums)

        def body(index: Any, sums: list) -> list:
            self.indices[depth] = index
            return self.print_level(depth + 1, sums)

        is_innermost = depth + 1 == len(lengths)
        totals = [
            item for item in self.current_nest.items if item.summed and is_innermost
        ]
        values = self.print_loop(depth, body, totals)
        for total, value in zip(totals, values, strict=True):
            if depth:
                self.write(value, total)
            else:
                self.outside[total.saves, (), False] = value
        return []

    def print_items(self, sums: list) -> list:
        """Print the writes of one iteration of all loops; return the sums with its summands."""
        loops = tuple(range(len(self.current_nest.lengths)))
        items = self.current_nest.items
        vectorized = self.vector_loop >= 0
        values = [self.argument(item.value, loops, vectorized) for item in items]
        totals = iter(sums)
        new_sums = []
        for item, value in zip(items, values, strict=True):
            if item.summed:
                total = self.add(next(totals), value)
                new_sums.append(total)
            else:
                self.write(value, item)
        return new_sums

    def write(self, value: Any, item: Write) -> None:
        """Write a value, in an iteration of the innermost loop or after it."""
        loops = range(len(item.strides))
        location = item.array, item.first, item.strides
        self.store(value, self.element(location, loops, self.vector_loop in loops))

    # --- values -------------------------------------------------------------------------------

    def element(
        self, location: Location, loops: Sequence[int], vectorized: bool
    ) -> Element:
        """Return an element, in an iteration of some loops."""
        array, offset, strides = location
        steps = [*zip(loops, strides, strict=True)]
        terms = [(self.indices[loop], stride) for loop, stride in steps]
        apart = sum(stride for loop, stride in steps if loop == self.vector_loop)
        return Element(array, offset, terms, apart if vectorized else None)

    def argument(self, argument: Any, loops: Loops, vectorized: bool) -> Any:
        """Return an argument: a constant or a computed value."""
        if type(argument) is not tuple:
            return self.number(argument, vectorized)
        component, axes = argument
        component_loops = tuple([loops[k] for k in axes])
        return self.value(component, component_loops, vectorized)

    def value(self, component: int, loops: Loops, vectorized: bool = False) -> Any:
        """Return the value of a component; print it if it is new."""
        key = component, loops, vectorized
        depth = max(loops, default=-1) + 1
        scope = self.scopes[depth] if depth or vectorized else self.outside
        if key not in scope:
            printer = self.printer(*key)
            scope[key] = self.insert(depth, key, printer)
        return scope[key]

    def printer(self, component: int, loops: Loops, vectorized: bool) -> Callable:
        """Return a function that prints a value; the arguments of the value are printed first."""
        if vectorized and self.vector_loop not in loops:
            scalar = self.value(component, loops)
            return lambda: self.broadcast(scalar)
        location = self.location(component)
        if location is not None:
            return lambda: self.load(self.element(location, loops, vectorized))
        name, arguments, _ = self.components[component]
        row_position = ROW_ARGUMENT.get(name)
        values = [
            self.argument(argument, loops, vectorized)
            for position, argument in enumerate(arguments)
            if position != row_position
        ]
        if row_position is None:
            return lambda: self.operation(name, loops, values)
        table, _ = arguments[row_position]
        row = self.components[table].arguments[:4]
        return lambda: self.row_operation(name, row, values)

    def location(self, component: int) -> Location | None:
        """Return the location of a component that is read; None if it is computed."""
        name, arguments, lengths = self.components[component]
        if component in self.prepared:
            return "P", self.prepared[component], row_strides(lengths)
        if component in self.saved:
            return "W", self.saved[component], row_strides(lengths)
        return arguments[:3] if name == "load" else None
