"""The closed loop on symbols for its own N, and numbers for its symbols.

The elements of its arrays are expressions each.  Random points and parameters have wide ranges,
zeros and kinks; a parameter keeps its sign, and one that is zero stays zero.
"""

from collections.abc import Callable, Iterable, Mapping
from functools import cache, partial
from math import prod
from typing import Any, NamedTuple

import control
import numpy as np
import sympy

from ...diagrams.on_symbols import Equations, on_symbols
from ...diagrams.symbol_names import TIME, Names
from ...diagrams.wiring import Node, Wiring, wiring_of
from ...equations.record import Shape
from ...errors import DiagramError
from .array_loop import no_value, refuse_pinned, refuse_unproved
from .proof import Step, exact
from .symbols import element_name, parameter_names, parameter_symbol, state_names
from .words import NUMBERS_OF, along, faster_than_linear, is_input

TRIED = 500  # points at which a sign is looked at before it is proved
SMALL = 1e-6  # of the largest value there; less may be rounding
NO_VALUE = (sympy.zoo, sympy.nan, sympy.oo, -sympy.oo, sympy.I)


class SymbolicLoop(Equations):
    """A diagram's equations on the paper's symbols.

    A state that is no port of the diagram stands under ``"block:port"``.
    """

    def derivative(self, expression: Any) -> sympy.Expr:
        """Differentiate an expression along the equations, words with kinks as well."""
        return along(sympy.sympify(expression), {TIME: sympy.Integer(1), **self.motion})

    def existing(self, others: list[str], known: Mapping[Any, sympy.Expr]) -> Step:
        """Return the step that states, by port, exist for all times where all others are bounded.

        `known` is what symbols are.
        """
        moves = {f"{port}'": self.rates[port] for port in others}
        moves |= {
            f"{s} after a jump": new
            for jump in self.jumps.values()
            for s, new in jump.items()
            if any(s in self.states[port] for port in others)
        }
        at = {what: [m.xreplace(known) for m in np.ravel(one)] for what, one in moves.items()}
        detail = faster_than_linear(at, {port: self.states[port] for port in others})
        claim = f"{', '.join(others) or 'no state'}: not in V, may grow, and exist for all t"
        return exact(claim, not detail, detail)


class PaperNames(Names):
    """What the paper calls ports and parameters, as in the reading for every N."""

    def __init__(self, wiring: Wiring, inputs: Iterable[str]):
        blocks = [node.system for node in wiring.nodes]
        self.fields, self.states = parameter_names(blocks), state_names(blocks)

    def port(self, node: Node, group: str, kind: str) -> str:
        """Return what a port or a parameter is called."""
        known = {"state": self.states, "parameter": self.fields}.get(kind, {})
        return known.get((node.system.name, group), group)

    def block(self, node: Node) -> str:
        """Return a block's own name."""
        return node.system.name

    def element(self, port: str, shape: Shape, declared: Shape, index: tuple) -> str:
        """Return x_1, alpha_1[2]."""
        return element_name(port, declared, index)

    def parameter(self, node: Node, name: str, value: np.ndarray, index: tuple) -> sympy.Expr:
        """Return a symbol of the sign that all values have."""
        return parameter_symbol(self.port(node, name, "parameter"), value, index)


def symbolic_loop(
    diagram: control.NonlinearIOSystem, opaque: Iterable[str] = (), jumps: bool = False
) -> SymbolicLoop:
    """Read a diagram's equations on symbols; blocks named in `opaque` stay undefined.

    States that jump are refused unless `jumps`: the caller then checks what V does there.
    """
    refuse_unproved(wiring_of(diagram), jumps)
    loop = on_symbols(diagram, PaperNames, opaque, no_value)
    refuse_pinned(loop.pinned)
    return SymbolicLoop(**vars(loop))


class Point(NamedTuple):
    """Where the blocks are called: ``diagram.dynamics(*point)``."""

    t: float
    x: np.ndarray  # states of the diagram
    u: np.ndarray  # its inputs
    params: dict[str, Any]  # call-time parameters, ``{"block.field": value}``


def flat(parameters: Any) -> list[Any]:
    """Return the symbols of a block's parameters, one after the other."""
    return [symbol for field in parameters for symbol in np.ravel(np.asarray(field, dtype=object))]


def equated(ports: Mapping[str, np.ndarray], values: Mapping[str, Any]) -> dict[Any, sympy.Expr]:
    """Return the symbols of some ports -> what they are, element by element."""
    return {
        symbol: sympy.sympify(value)
        for port, own in values.items()
        for symbol, value in zip(ports[port].flat, np.ravel(own), strict=True)
    }


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
        applied = whole.atoms(sympy.core.function.AppliedUndef)
        inputs = list(filter(is_input, applied))
        words = {str(f.func) for f in applied} - {str(f.func) for f in inputs}
        if whole.has(sympy.Derivative) or words - set(NUMBERS_OF):
            unknown = ", ".join(sorted(words - set(NUMBERS_OF))) or "a derivative of an input"
            raise DiagramError(f"{unknown} has no numbers, so V' cannot be compared")
        self.symbols = sorted(whole.free_symbols - {TIME}, key=str) + sorted(inputs, key=str)
        self.symbols += [TIME] if whole.has(TIME) else []

    def at(self, known: Mapping[Any, Any], count: int) -> np.ndarray:
        """Return the numbers of the expressions, (expressions, count), of those of symbols."""
        numbers = {s: known[s] for s in self.symbols}

        def number(e: sympy.Expr) -> Any:
            if e not in numbers:
                numbers[e] = _of_parts(e, [number(a) for a in e.args])
            return numbers[e]

        with np.errstate(all="ignore"):
            found = np.array([np.broadcast_to(number(e), count) for e in self.expressions])
        if np.iscomplexobj(found):  # as of a root or a logarithm of SymPy's own
            found = np.where(found.imag == 0.0, found.real, np.nan)
        return found.astype(float)


def _of_parts(e: sympy.Expr, of: list[Any]) -> Any:
    """Return the number of an expression of those of its arguments."""
    if e.is_Add or e.is_Mul:
        return sum(of) if e.is_Add else prod(of)
    return of[0] ** of[1] if e.is_Pow else _function(e if e.is_Atom else e.func, len(of))(*of)


@cache
def _function(word: Any, count: int) -> Callable[..., Any]:
    """Return a word of SymPy's, or of the records', as a function of arrays, or a number."""
    if not count:
        return partial(np.float64, float(word))
    own = sympy.symbols(f"a_:{count}", real=True)
    return sympy.lambdify(own, word(*own), [NUMBERS_OF, "scipy", "numpy"])


def positive_somewhere(expression: sympy.Expr) -> bool:
    """Return whether an expression is positive at a random point: no proof is tried then.

    Slopes of inputs may be anything.
    """
    slopes = {d: sympy.Dummy(real=True) for d in expression.atoms(sympy.Derivative)}
    try:
        numbers = Numbers(expression.xreplace(slopes))
    except DiagramError:
        return False
    random = np.random.default_rng(0)
    drawn = random.standard_normal((len(numbers.symbols), TRIED))
    drawn *= 10.0 ** random.uniform(-1, 1, (1, TRIED))
    for row, s in zip(drawn, numbers.symbols, strict=True):
        if s.is_nonnegative or s.is_nonpositive or s == TIME:
            row[:] = np.abs(row) * (-1 if s.is_nonpositive else 1)
    (values,) = numbers.at(dict(zip(numbers.symbols, drawn, strict=True)), TRIED)
    values = values[np.isfinite(values)]
    return bool(values.size and values.max() > SMALL * np.abs(values).max())
