"""Fuse an interconnected diagram into one function of numbers.

Blocks are read in the order of the wiring, each output and update once, into
flat code over x (states), P (parameters) and T (shared tables):

    derivative(t, X, P, T, W, D)      D = dx/dt
    signals(t, X, P, T, W)            W = all block outputs
    margin(t, X, P, T, W)             least distance to a guard's edge
    prepare(P, T)                     what depends on parameters alone

Small diagrams unroll into named numbers, so that the compiler keeps them in
registers and finds what is computed twice; large ones keep loops over the basis
functions and the array W.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import control

from ..blocks import Block
from ..blocks.ports import states_as_outputs
from ..errors import DiagramError
from ..wiring import Node, Wiring, read
from .layout import Layout, lay_out
from .reader import FunctionReader, Lines, Prepared, Unreadable
from .values import Code, View, combined, text

SMALL = 16  # largest port of a diagram that is unrolled whole


@dataclass(frozen=True)
class Fused:
    """A diagram as flat code.

    Attributes
    ----------
    wiring : Wiring
        Its blocks and wires.
    layout : Layout
        Where parameters lie; inputs of the diagram come last in P.
    source : str
        Text of the functions derivative, signals and margin.
    nstates, nsignals, ninputs : int
        Sizes.
    ramp : int
        Offset in P of the inputs: time of the last sample, then values, slopes.
    size : int
        Length of P with the inputs and what is prepared for a piece of time.
    guarded : bool
        Whether a block has a guard.
    """

    wiring: Wiring
    layout: Layout
    source: str
    nstates: int
    nsignals: int
    ninputs: int
    ramp: int
    size: int
    guarded: bool


def fuse(diagram: control.NonlinearIOSystem, parameters: Sequence[Any] | None = None) -> Fused:
    """Read a diagram into flat code.

    Parameters
    ----------
    diagram : control.NonlinearIOSystem
        Blocks, wired; nested diagrams included.
    parameters : sequence of NamedTuple, optional
        One for each block in the order of the wiring; the blocks' own.

    Returns
    -------
    Fused
        Code and the places of its numbers.

    Raises
    ------
    DiagramError
        If a system is no block, or blocks feed each other in a circle.
    Unreadable
        If a block's equations cannot be flattened.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> fused = fuse(clpt.closed_loop(clpt.paper_scenario()))
    >>> fused.nstates, fused.source.startswith("def derivative")
    (14, True)
    """
    wiring = read(diagram)
    for node in wiring.nodes:
        if not isinstance(node.system, Block):
            raise DiagramError(f"{node.name} is no block and cannot be compiled")
    if parameters is None:
        parameters = [node.system.parameters for node in wiring.nodes]
    layout = lay_out(wiring, parameters)
    ramp = len(layout.P)
    ninputs = diagram.ninputs or 0
    nstates = wiring.nodes[-1].states.stop
    nsignals = wiring.nodes[-1].outputs.stop
    largest = max((size for node in wiring.nodes for size in node.system.output_ports.values()),
                  default=0)  # fmt: skip
    unroll = 64 if largest <= SMALL else 0
    guarded = any(node.system.guard is not None for node in wiring.nodes)
    ready = Prepared(ramp + 1 + 2 * ninputs)
    parts = []
    for kind in ("derivative", "signals", "margin"):
        writer = _Writer(wiring, parameters, layout, ramp, ninputs, unroll, kind, ready)
        parts.append(writer.function())
    parts.append(ready.function())
    size = ready.first + len(ready.places)
    return Fused(
        wiring, layout, "\n\n".join(parts), nstates, nsignals, ninputs, ramp, size, guarded
    )


HEADS = {
    "derivative": "def derivative(t, X, P, T, W, D):",
    "signals": "def signals(t, X, P, T, W):",
    "margin": "def margin(t, X, P, T, W):",
}


class _Writer:
    """Write one of the functions."""

    def __init__(self, wiring: Wiring, parameters: Sequence[Any], layout: Layout, ramp: int,
                 ninputs: int, unroll: int, kind: str, ready: Prepared):  # fmt: skip
        self.wiring, self.parameters, self.layout = wiring, parameters, layout
        self.ramp, self.ninputs, self.unroll, self.kind = ramp, ninputs, unroll, kind
        self.lines = Lines(ready)
        self.named: dict[int, Any] = {}  # signal -> value, where loops are unrolled
        self.states: dict[int, Any] = {}
        self.rates: dict[int, Any] = {}
        self.aliases: list[tuple[int, int, int]] = []  # outputs that are states

    def function(self) -> str:
        """Give the text of the function."""
        for k in self.wiring.order:
            node = self.wiring.nodes[k]
            if node.system.output_function is states_as_outputs:
                shift = node.states.start - node.outputs.start
                self.aliases.append((node.outputs.start, node.outputs.stop, shift))
                continue
            self.run(node.system.output_function, k, node, self.outputs(node))
        if self.kind == "derivative":
            for k, node in enumerate(self.wiring.nodes):
                if node.system.update_function is not None:
                    self.run(node.system.update_function, k, node, self.derivatives(node))
            for place, value in sorted(self.rates.items()):
                self.lines.add(f"D[{place}] = {text(value)}")
        elif self.kind == "signals":
            for place, value in sorted(self.named.items()):
                self.lines.add(f"W[{place}] = {text(value)}")
            for start, stop, shift in self.aliases:
                self.lines.add(f"for i in range({start}, {stop}):")
                self.lines.add(f"    W[i] = X[i + {shift}]")
        else:
            self.guards()
        return "\n".join([HEADS[self.kind], *(self.lines.lines or ["    pass"])])

    def run(self, function: Any, k: int, node: Node, out: View) -> Any:
        """Read one function of a block."""
        reader = FunctionReader(self.lines, self.unroll)
        x = View(self.state, None, node.states.start, node.system.nstates)
        return reader.run(function, [Code("t"), x, self.inputs(node), _Parameters(self, k), out])

    def guards(self) -> None:
        """Give the least distance of all guards, 1 where there is none."""
        least: Any = 1.0
        for k, node in enumerate(self.wiring.nodes):
            guard = node.system.guard
            if guard is None:
                continue
            found: dict[int, Any] = {}
            out = View(found.__getitem__, found.__setitem__, 0, 1)
            self.run(guard.distance, k, node, out)
            least = Code(f"minimum({text(least)}, {text(found[0])})")
        self.lines.add(f"return {text(least)}")

    # --- the arrays that code speaks of ---------------------------------------------------

    def state(self, place: Any) -> Any:
        if isinstance(place, Code):
            return Code(f"X[{text(place)}]")
        if not self.unroll:
            return Code(self.lines.steady(f"X[{place}]"))
        if place not in self.states:
            name = self.lines.fresh()
            self.lines.add(f"{name} = X[{place}]")
            self.states[place] = Code(name)
        return self.states[place]

    def keep(self, value: Any) -> Any:
        """Give a value a name."""
        if isinstance(value, Code) and not value.simple:
            name = self.lines.fresh()
            self.lines.add(f"{name} = {value.text}")
            return Code(name)
        return value

    def outputs(self, node: Node) -> View:
        def read_one(place: Any) -> Any:
            return self.named[place] if place in self.named else Code(f"W[{text(place)}]")

        def write_one(place: Any, value: Any) -> None:
            if self.unroll and isinstance(place, int):
                self.named[place] = self.keep(value)
            else:
                self.lines.add(f"W[{text(place)}] = {text(value)}")

        return View(read_one, write_one, node.outputs.start, node.system.noutputs)

    def derivatives(self, node: Node) -> View:
        def read_one(place: Any) -> Any:
            return self.rates[place]

        def write_one(place: Any, value: Any) -> None:
            if self.unroll and isinstance(place, int):
                self.rates[place] = self.keep(value)
            else:
                self.lines.add(f"D[{text(place)}] = {text(value)}")

        return View(read_one, write_one, node.states.start, node.system.nstates)

    def signal(self, place: int) -> Any:
        for start, stop, shift in self.aliases:
            if start <= place < stop:
                return self.state(place + shift)
        if place in self.named:
            return self.named[place]
        return Code(self.lines.steady(f"W[{place}]"))

    def external(self, place: int) -> Code:
        """A diagram's input: straight between its samples."""
        value, slope = self.ramp + 1 + place, self.ramp + 1 + self.ninputs + place
        return Code(f"(P[{value}] + (t - P[{self.ramp}]) * P[{slope}])")

    def inputs(self, node: Node) -> View:
        sources: list[list[tuple[float, bool, int]]] = [[] for _ in range(node.system.ninputs)]
        for wire in node.wires:
            for j in range(wire.size):
                sources[wire.to + j].append((wire.gain, wire.external, wire.source + j))

        def read_one(place: Any) -> Any:
            if isinstance(place, int):
                total: Any = 0.0
                for gain, outside, source in sources[place]:
                    value = self.external(source) if outside else self.signal(source)
                    gained = value if gain == 1.0 else combined(gain, "*", value)
                    total = combined(total, "+", gained)
                return total
            start = _constant_part(place.text)
            run = sources[start]
            if len(run) != 1 or run[0][0] != 1.0 or run[0][1]:
                raise Unreadable(f"{node.name}: a loop over inputs that are sums or from outside")
            first = run[0][2]
            for begin, stop, shift in self.aliases:
                if begin <= first < stop:
                    return Code(f"X[{first + shift - start} + {place.text}]")
            return Code(f"W[{first - start} + {place.text}]")

        return View(read_one, None, 0, node.system.ninputs)


def _constant_part(code: str) -> int:
    """Give what an index is at the first turn of its loop."""
    import re

    return int(eval(re.sub(r"v\d+", "0", code), {"__builtins__": {}}))


class _Parameters:
    """A block's parameters as code: numbers known, the rest in P or T."""

    def __init__(self, writer: _Writer, k: int):
        self._writer, self._k = writer, k

    def __getattr__(self, name: str) -> Any:
        value = getattr(self._writer.parameters[self._k], name)
        if isinstance(value, int):
            return value
        place = self._writer.layout.places[(self._k, name)]
        lines = self._writer.lines
        if not place.shape:
            return Code(lines.steady(f"{place.array}[{place.offset}]"))

        def read_one(index: Any) -> Any:
            one = f"{place.array}[{text(index)}]"
            return Code(lines.steady(one) if isinstance(index, int) else one)

        size = 1
        for side in place.shape:
            size *= side
        return View(read_one, None, place.offset, size, place.shape, (place.array, place.offset))
