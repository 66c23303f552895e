"""A closed loop on the paper's symbols: for its own N, and as arrays for every N.

`SymbolicLoop` has the elements of arrays, expressions each.  `ArrayLoop` is what the theorems are
written on: the blocks' records, joined at the diagram's own wires.  A claim about it is made of its
signals, states, parameters and rates as NumPy's arrays are: ``-np.sum(KD * e**2)``; `elements`
reads what comes of it, for every N where sizes are open.  Sources of time and tables are inputs of
the diagram: what is proved then holds for all of them.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import cache, cached_property, partial
from math import prod
from typing import Any, NamedTuple

import control
import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ...base.errors import DiagramError
from ...engine.diagram.merged_record import TapeRecord
from ...engine.diagram.symbol_names import TIME
from ...engine.diagram.symbolic_equations import Equations, on_symbols
from ...engine.diagram.wiring import Node, Wiring, wiring_of
from ...engine.model.declaration import Parameters
from ...engine.record.derivative import Direction
from ...engine.record.graph import Shape
from ...engine.record.scalar_graph import Index
from ...engine.record.symbolic import LONG, extent
from ...engine.trace.arrays import Tape, operand
from .every_n import EveryN
from .facts import NUMPY_OF, along, is_input
from .paper_symbols import PaperNames, parameter_symbol, undefined

NO_VALUE = (sympy.zoo, sympy.nan, sympy.oo, -sympy.oo, sympy.I)


@dataclass
class SymbolicLoop(Equations):
    """A diagram's equations on the paper's symbols.

    A state that is no port of the diagram stands under ``"block:port"``.
    """

    diagram: Any = None

    def derivative(self, expression: Any) -> sympy.Expr:
        """Differentiate an expression along the equations, words with kinks as well."""
        return along(sympy.sympify(expression), {TIME: sympy.Integer(1), **self.motion})


def symbolic_loop(
    diagram: control.NonlinearIOSystem, opaque: Iterable[str] = (), jumps: bool = False
) -> SymbolicLoop:
    """Read a diagram's equations on symbols; blocks named in `opaque` stay undefined.

    States that jump are refused unless `jumps`: the caller then checks what V does there.
    """
    refuse_unproved(wiring_of(diagram), jumps)
    loop = on_symbols(diagram, PaperNames, opaque, no_value)
    refuse_names(diagram.name, {*loop.states, *loop.inputs})
    refuse_pinned(loop.pinned)
    return SymbolicLoop(**vars(loop), diagram=diagram)


class Point(NamedTuple):
    """Where the blocks are called: ``diagram.dynamics(*point)``."""

    t: float
    x: np.ndarray  # states of the diagram
    u: np.ndarray  # its inputs


def flat(parameters: Any) -> list[Any]:
    """Return the symbols of a block's parameters, one after the other."""
    return [
        symbol
        for field in parameters
        for symbol in np.ravel(np.asarray(field, dtype=object))
    ]


def equated(
    ports: Mapping[str, np.ndarray], values: Mapping[str, Any]
) -> dict[Any, sympy.Expr]:
    """Return the symbols of some ports -> what they are, element by element."""
    return {
        symbol: sympy.sympify(value)
        for port, own in values.items()
        for symbol, value in zip(ports[port].flat, np.ravel(own), strict=True)
    }


def refuse_names(name: str, names: Iterable[str]) -> None:
    """Refuse a state, a signal or a parameter that is called as time or a function is."""
    for reserved in sorted({"t", "Abs", *NUMPY_OF} & {*names}):
        raise DiagramError(
            f"{name}: has a {reserved}, as time or a function is called; rename it"
        )


def refuse_no_value(loop: SymbolicLoop, name: str) -> None:
    """Refuse equations that have no value whatever the states are."""
    ports = *loop.rates.values(), *loop.signals.values()
    if any(one.has(*NO_VALUE) for port in ports for one in port.flat):
        raise DiagramError(
            f"{name}: with the parameters as they are its equations have no value"
            + (f" ({loop.undefined[0]})" if loop.undefined else "")
        )


class Numbers:
    """Expressions as numbers at points."""

    def __init__(self, *expressions: sympy.Expr):
        self.expressions, whole = expressions, sympy.Tuple(*expressions)
        applied = whole.atoms(AppliedUndef)
        inputs = set(filter(is_input, applied))
        words = {str(f.func) for f in applied - inputs} - NUMPY_OF.keys()
        if whole.has(sympy.Derivative) or words:
            unknown = ", ".join(sorted(words)) or "a derivative of an input"
            raise DiagramError(f"{unknown} has no numbers, so V' cannot be compared")
        self.symbols = sorted(whole.free_symbols - {TIME}, key=str) + sorted(
            inputs, key=str
        )
        self.symbols += [TIME] if whole.has(TIME) else []

    def at(self, known: Mapping[Any, Any], count: int) -> np.ndarray:
        """Return the numbers of the expressions, (expressions, count), of those of symbols."""
        numbers = {s: known[s] for s in self.symbols}

        def number(e: sympy.Expr) -> Any:
            if e not in numbers:
                numbers[e] = _of_parts(e, [number(a) for a in e.args])
            return numbers[e]

        with np.errstate(all="ignore"):
            found = np.array(
                [np.broadcast_to(number(e), count) for e in self.expressions]
            )
        return found.astype(float)


def _of_parts(e: sympy.Expr, of: list[Any]) -> Any:
    """Return the number of an expression of those of its arguments."""
    if e.is_Add or e.is_Mul:
        return sum(of) if e.is_Add else prod(of)
    return (
        of[0] ** of[1]
        if e.is_Pow
        else _function(e if e.is_Atom else e.func, len(of))(*of)
    )


@cache
def _function(word: Any, count: int) -> Callable[..., Any]:
    """Return a word of SymPy's, or of the records', as a function of arrays, or a number."""
    if not count:
        return partial(np.float64, float(word))
    own = sympy.symbols(f"a_:{count}", real=True)
    return sympy.lambdify(own, word(*own), [NUMPY_OF, "scipy", "numpy"])


# --- for every N -------------------------------------------------------------------------------


DEEPEST = 30  # levels of an expression
Known = Callable[[sympy.Expr, Index], Any]


class ArrayLoop:
    """A diagram's equations as arrays, by port.

    A state that is no port of the diagram stands under ``"block:port"``.  Sizes that have names
    stay open.  `known` gives what stands for a parameter's element.
    """

    def __init__(
        self,
        diagram: control.NonlinearIOSystem,
        known: Known = lambda symbol, index: symbol,
    ):
        wiring = wiring_of(diagram)
        refuse_unproved(wiring, jumps=False)
        self.diagram = diagram
        self.tape, self.known, self.names = Tape(), known, PaperNames(wiring, ())
        self.values: dict[str, Any] = {}  # of parameters
        self.declared: dict[str, Shape] = {}
        self.states: dict[str, Any] = {}
        found = TapeRecord(diagram, wiring, self._leaf, self._input, self.tape)
        refuse_pinned(found.pinned)
        self.inputs = found.external
        self.signals = {port: value for (_, port), value in found.signals.items()}
        of = {node.name: node.system.name for node in wiring.nodes}
        self.rates = {
            self.names.states[of[node], port]: value
            for (node, port), value in found.rates.items()
        }
        self.parameters: dict[str, Parameters] = {}  # block -> arrays
        for one in wiring.nodes:
            fields = one.system.parameters._asdict()
            for field, shape in found.fields[one.name].items():
                if not isinstance(fields[field], int):
                    fields[field] = self._leaf("p", one, field, shape)
            self.parameters[one.system.name] = Parameters(**fields)
        self.undefined_so_far: list[str] = []  # in what was read

        def watch(place: int, name: str, arguments: tuple) -> None:
            owner = found.owners.get(place)
            if owner and (sentence := no_value(owner, name, arguments)):
                self.undefined_so_far.append(f"{owner} {sentence}")

        self.elements = EveryN(self.tape.operations, self._element, watch)

    @property
    def undefined(self) -> list[str]:
        """Where there may be no value, in sentences; reads everything."""
        for value in (*self.signals.values(), *self.rates.values()):
            self.elements.of(value)
        return self.undefined_so_far

    def derivative(self, value: Any) -> Any:
        """Return the time derivative along the equations, as an array.

        That of an input is an input of its own.
        """
        return self._direction.of(value)

    def read(self, value: Any) -> list[Any]:
        """Return a value's elements on symbols, row by row."""
        return list(np.ravel(self.elements.of(value)))

    def direction(self, state: str) -> Any:
        """Return a direction of a state, any one, as an array of its shape."""
        return self.tape.add("leaf", (), self.states[state].shape, ("d", state))

    @cached_property
    def _direction(self) -> Direction:
        along: dict[Any, Any] = {
            operand(s): self.rates[name] for name, s in self.states.items()
        }
        for k, operation in enumerate(self.tape.operations):
            if operation.kind == "leaf" and operation.at[0] == "u":
                along[k] = self.tape.add(
                    "leaf", (), operation.shape, ("u'", operation.at[1])
                )
            elif operation.kind == "leaf" and operation.at[0] == "t":
                along[k] = 1.0
        return Direction(self.tape, along, smooth=True)

    # --- the leaves, by the paper's names ----------------------------------------------------

    def _leaf(self, group: str, node: Node, name: str, shape: Shape) -> Any:
        """Return a state or a parameter of a block."""
        block = node.system
        if group == "p":
            known = self.names.fields[block.name, name]
            self.values[known] = getattr(block.parameters, name)
            return self.tape.add("leaf", (), shape, ("p", known))
        state = self.names.states[block.name, name]
        self.declared[state] = block.declared["states"][name]
        return self.states.setdefault(
            state, self.tape.add("leaf", (), shape, ("x", state))
        )

    def _input(self, port: str, shape: Shape, declared: Shape) -> Any:
        self.declared[port] = declared
        return self.tape.add("leaf", (), shape, ("u", port))

    def _element(self, at: tuple, shape: Shape, index: Index) -> Any:
        """Return the symbol of an element, or what is known of it."""
        group, name = at
        if group == "t":
            return TIME
        if group == "p":
            return self.known(parameter_symbol(name, self.values[name], index), index)
        port = (
            ("d " if group == "d" else "") + name + ("'" if group.endswith("'") else "")
        )
        element = self.names.element(port, shape, self.declared[name], index)
        return sympy.Symbol(element, real=True)


def no_value(owner: str, name: str, arguments: tuple) -> str | None:
    """Return where an operation may have no value; refuse what is too long to be judged."""
    sizes = [extent(a) for a in arguments if isinstance(a, sympy.Basic)]
    if any(parts > LONG or levels > DEEPEST for parts, levels in sizes):
        raise DiagramError(
            f"{owner} has more than {LONG} parts or {DEEPEST} levels on "
            "symbols, too long to prove anything of; make it simpler or its N smaller"
        )
    return undefined(name, arguments)


def refuse_pinned(pinned: Iterable[tuple[str, str]]) -> None:
    """Refuse parameters on whose values the equations depend, as by an `if`."""
    for name, own in sorted(pinned):
        raise DiagramError(
            f"{name}: asks for the value of its parameter {own}, as an `if` does, so nothing would "
            f"be proved of other values; write np.where, or give {own} as a whole number"
        )


def refuse_unproved(wiring: Wiring, jumps: bool) -> None:
    """Refuse discrete time, blocks that sample, and jumps unless `jumps`: no proof is of them."""
    blocks = [node.system for node in wiring.nodes]
    name = next(
        (block.name for block in blocks if block.first_held is not None or wiring.dt),
        None,
    )
    if name is not None:
        raise DiagramError(
            f"{name}: is of discrete time, and proofs speak of continuous time alone; prove the "
            "design that it was sampled from"
        )
    for block in blocks if not jumps else ():
        if block.jump_function is not None:
            raise DiagramError(
                f"{block.name}: its states jump, and this proof speaks of no jumps; prove the "
                "block without its `jump`"
            )
