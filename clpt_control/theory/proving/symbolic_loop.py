"""The closed loop on symbols for its own N: the elements of its arrays, each an expression."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations
from typing import Any

import control
import numpy as np
import sympy

from ...diagrams.joined import open_sizes
from ...diagrams.wiring import wiring_of
from ...equations.declaration import Parameters, parameters_of
from .array_loop import TIME, array_loop


@dataclass
class SymbolicLoop:
    """A diagram's equations on symbols, ports as ndarrays of their shapes.

    A state that is no port of the diagram stands under ``"block:port"``.
    """

    states: dict[str, np.ndarray]  # symbols
    signals: dict[str, np.ndarray]  # expressions
    rates: dict[str, np.ndarray]  # time derivatives of the states
    jumps: dict[str, dict]  # block -> symbol: what it jumps to
    inputs: dict[str, np.ndarray]  # functions of time
    parameters: dict[str, Any]  # block -> arrays of symbols
    N: int | None  # number of basis functions, where the blocks have one
    undefined: list[str]  # where there may be no value, sentences

    def derivative(self, expression: sympy.Expr) -> sympy.Expr:
        """Differentiate an expression of the states along the equations.

        Opaque functions and inputs are differentiated in time as well.
        """
        known: dict[Any, sympy.Expr] = {TIME: sympy.Integer(1), **self.motion}

        def along(e: sympy.Expr) -> sympy.Expr:
            if e not in known:
                known[e] = slope(e)
            return known[e]

        def slope(e: sympy.Expr) -> sympy.Expr:
            if e.is_Atom:
                return sympy.Integer(0)
            if e.is_Add:
                return sympy.Add(*map(along, e.args))
            if e.is_Mul:
                rest = (sympy.Mul(*e.args[:k], *e.args[k + 1 :]) for k in range(len(e.args)))
                return sympy.Add(*(along(a) * b for a, b in zip(e.args, rest, strict=True)))
            if e.is_Pow and e.exp.is_Number:
                return e.exp * e.base ** (e.exp - 1) * along(e.base)
            return sympy.Add(*(sympy.diff(e, s) * along(s) for s in e.free_symbols))

        return along(expression)

    @cached_property
    def motion(self) -> dict[Any, sympy.Expr]:
        """State's symbol -> its rate, in the diagram's order."""
        return {
            s: rate
            for port, own in self.states.items()
            for s, rate in zip(own.flat, self.rates[port].flat, strict=True)
        }

    def jumps_at_once(self) -> Iterator[dict[Any, Any]]:
        """Return state -> what it jumps to, for every set of blocks that may jump at once."""
        for count in range(1, len(self.jumps) + 1):
            for together in combinations(self.jumps.values(), count):
                yield {s: new for one in together for s, new in one.items()}


def symbolic_loop(
    diagram: control.NonlinearIOSystem, opaque: Iterable[str] = (), jumps: bool = False
) -> SymbolicLoop:
    """Read a diagram's equations on symbols; blocks named in `opaque` stay undefined.

    States that jump are refused unless `jumps`: the caller then judges what V does there.
    """
    loop = array_loop(diagram, opaque, jumps, closed=True)

    def read(value: Any) -> Any:
        if isinstance(value, dict):
            return {name: read(own) for name, own in value.items()}
        if isinstance(value, Parameters):
            return parameters_of(read(value._asdict()))
        return value if isinstance(value, int) else loop.elements.of(value)

    states, rates = read(loop.states), read(loop.rates)
    jumps_of = {
        block: {s: new for p in own for s, new in zip(states[p].flat, own[p].flat, strict=True)}
        for block, own in read(loop.jumps).items()
    }
    return SymbolicLoop(
        states,
        read(loop.signals),
        rates,
        jumps_of,
        read(loop.inputs),
        read(loop.parameters),
        open_sizes(wiring_of(diagram)).get("N"),
        loop.undefined,
    )
