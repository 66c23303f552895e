"""Equations of a closed loop for Coq, for every N, read from the records of the blocks that run.

Sums over the N basis functions stay as they are in the record.  This is the only file of `coq`
that reads the package's own proofs.
"""

import re
from typing import Any, NamedTuple

import numpy as np
import sympy
from sympy import Expr, sympify

from ...base.errors import DiagramError
from ...engine.diagram.interconnection import Diagram
from ...engine.record.scalar_graph import Index
from ...paper.laws.table import LAWS
from ..algebra.decided import decided
from ..algebra.every_n import SUM, EveryN, index_symbol
from ..laws.fixes import loop_at_fixes
from ..laws.theorem_loop import WIRED, law_and_V, law_loop
from ..proofs.symbolic_loop import ArrayLoop

# operations with conditions that are not written; SymPy may cancel them: exp(log(x)) is x
NOT_WRITTEN = re.compile(
    "floordiv|mod|log(2|10|1p)?|tan|asin|acosh?|atanh|pick"
).fullmatch


class Equations(NamedTuple):
    """States with their rates, inputs, V, and the conditions of the record."""

    rates: dict[Expr, Expr]
    inputs: list[Expr]
    V: Expr
    conditions: list[tuple[Expr, str]]  # such as (x, "<> 0")
    jumps: dict[Expr, Expr]  # states after a fix, with their values before it


class Sums(EveryN):
    """Elements for every N, with sums as they are in the record, and numbers compared."""

    prefix = "k"

    def apply(self, ref: int, kind: str, arguments: tuple) -> Any:
        """Return the expression of an operation."""
        applied = super().apply(ref, kind, arguments)
        is_known = kind in ("gt", "where") and arguments[0].is_number
        return decided(applied) if is_known else applied

    @staticmethod
    def summed(summand: Any, name: str, size: str) -> Any:
        """Return a sum that is not expanded."""
        if summand == 0:
            return sympy.S.Zero
        return SUM(summand, index_symbol(name), sympy.Symbol(size))


def loop_of_law(name: str) -> Diagram:
    """Wire the closed loop of a law of the table with its V."""
    law = LAWS[name]
    if law.at_fixes:
        return loop_at_fixes(law, WIRED)
    return law_loop(law, *law_and_V(law, WIRED))


def equations_of(diagram: Diagram) -> Equations:
    """Read the equations of a closed loop with V, for every N."""
    loop = ArrayLoop(diagram, jumps=True)
    conditions: dict[tuple[Expr, str], None] = {}

    def leaf(key: tuple[str, str], shape: Any, index: Index) -> Any:
        group, name = key
        if name.endswith(".interval"):
            return 1  # read where fixes arrive late alone
        law_name = name.replace("lyapunov.", "adaptation.")
        # V has the parameters of the law: those of equal values are one symbol
        if group == "p" and law_name in loop.values:
            value = loop.values[law_name]
            if np.all(np.equal(loop.values[name], value)):
                key, index = (group, law_name), index[: np.ndim(value)]
        return loop.elements.leaf_symbol(key, shape, index)

    def watch(row: int, kind: str, arguments: tuple) -> None:
        begin, last = sympify(arguments[0]), sympify(arguments[-1])
        if NOT_WRITTEN(kind) and (begin.free_symbols or last.free_symbols):
            raise DiagramError(f"{kind}({begin}): has no form in Coq here. Replace it")
        is_power = kind == "pow"
        if kind == "sqrt" or (is_power and not last.is_integer):
            conditions[begin, ">= 0"] = None
        if kind == "div" or (is_power and last.is_negative):
            conditions[last if kind == "div" else begin, "<> 0"] = None

    elements = Sums(loop.tape.operations, leaf, watch)

    def read(value: Any) -> list[Expr]:
        return list(np.ravel(elements.of(value)))

    rates: dict[Expr, Expr] = {}
    jumps: dict[Expr, Expr] = {}
    for name, state in loop.states.items():
        rates.update(zip(read(state), read(loop.rates[name]), strict=True))
        after = read(loop.jumps.get(name, state))
        jumps.update(zip(read(state), after, strict=True))
    inputs = [symbol for port in loop.inputs.values() for symbol in read(port)]
    V = read(loop.signals["V"])[0]
    with_symbols = [c for c in conditions if c[0].free_symbols]
    return Equations(rates, inputs, V, with_symbols, jumps if loop.jumps else {})
