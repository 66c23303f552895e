"""The gains with which an adaptive law adapts, read off its equations.

    alpha' = -gain e phi + rest,    K' = -gain z e + rest,    Gamma' = gain zc e + rest

V of Eq. (24) weighs each error by the inverse of its gain, so that the terms with e cancel.
"""

from typing import Any

import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ...diagrams.interconnection import connect
from ...equations.block import Block
from ...errors import DiagramError
from .array_loop import TIME
from .quadratic_forms import tidied
from .random_points import own_numbers
from .symbolic_loop import SymbolicLoop, symbolic_loop


def law_alone(law: Block) -> SymbolicLoop:
    """Return a law on symbols, all that feeds it an input."""
    return symbolic_loop(connect([law], external=list(law.input_ports)), jumps=True)


def own_values(loop: SymbolicLoop, blocks: list[Block]) -> dict[Any, sympy.Rational]:
    """Return parameter -> the number it has, of the blocks of a loop."""
    return {
        symbol: sympy.nsimplify(value, rational=True)
        for block in blocks
        for symbol, value in own_numbers(loop, block).items()
    }


def law_gains(law: Block, N: int) -> tuple[list[sympy.Expr], bool]:
    """Return the gains with which a law adapts alpha, K and Gamma, and whether V fits it.

    For alpha, row by row, K and Gamma they are the factors of -e phi, -e z and e zc in the rates,
    without their sign, in the symbols of the law's parameters; 1 where there is none.  V fits
    where each that is not held has one, and a V of squares can judge what is beside it; else V
    is no more than a guess, and refutes nothing.
    """
    loop = law_alone(law)
    values = own_values(loop, [law])
    refuse_no_value(loop, law.name)
    nothing = np.zeros(2 * N, dtype=object)
    e, apart = np.array([sympy.Function(f"e_{i}", real=True)(TIME) for i in (1, 2)]), {}
    if {"x", "z"} <= set(loop.inputs):  # e may be written x - z
        apart = dict(zip(loop.inputs["x"], e + loop.inputs["z"], strict=True))
    gains: list[sympy.Expr] = []
    rests: dict[sympy.Expr, sympy.Expr] = {}
    fitted = True
    for port, signal, size in (("alpha", "phi_x", N), ("K", "z", 1), ("Gamma", "zc", 1)):
        with_ = loop.inputs.get(signal, nothing)
        states = np.ravel(loop.states.get(port, nothing[: 2 * size]))
        for j, state in enumerate(states):
            i, k = (divmod(j, N)) if port == "alpha" else (j, j)
            product, rate = e[i] * with_[k], sympy.Integer(0)
            if state != 0:
                rate = tidied(loop.motion[state].xreplace(apart))
            factor = _factor(rate, product, set(values)) if product != 0 else product
            number = sympy.sympify(factor).xreplace(values)
            positive, negative = number.is_positive, number.is_negative
            fitted &= bool(positive or negative or rate == 0)
            gains.append(factor if positive else -factor if negative else sympy.Integer(1))
            rests[state] = sympy.expand(rate - factor * product) / gains[-1]
    rests.pop(sympy.Integer(0), None)
    given = [s for port, symbols in loop.inputs.items() if port != "e" for s in symbols.flat]
    held = {s: sympy.Dummy(real=True) for s in given}
    rests = {s: rest.xreplace(held) for s, rest in rests.items()}
    return gains, fitted and _judged_by_squares(rests, {*values, *held.values()})


def refuse_no_value(loop: SymbolicLoop, name: str) -> None:
    """Refuse equations that have no value whatever the states are."""
    none = (sympy.zoo, sympy.nan, sympy.oo, -sympy.oo, sympy.I)
    if any(
        one.has(*none)
        for ports in (loop.rates, loop.signals)
        for port in ports.values()
        for one in port.flat
    ):
        raise DiagramError(
            f"{name}: with the parameters as they are its equations have no value"
            + (f" ({loop.undefined[0]})" if loop.undefined else "")
        )


def _judged_by_squares(rests: dict, known: set) -> bool:
    """Return whether a V of squares can judge what a law has beside its gains.

    It cannot where that holds e or time, as gains that change do, or states of the law's
    own, which need not come to every value, or where it weighs the errors in another way.
    """
    if any(rest.free_symbols - set(rests) - known for rest in rests.values()):
        return False
    slopes = {(a, b): sympy.diff(rest, b) for a, rest in rests.items() for b in rests}
    return all(sympy.expand(slope - slopes[b, a]) == 0 for (a, b), slope in slopes.items())


def _factor(rate: sympy.Expr, product: sympy.Expr, parameters: set) -> sympy.Expr:
    terms = (term / product for term in sympy.Add.make_args(rate))
    return sympy.Add(
        *(q for q in terms if not q.atoms(AppliedUndef) and q.free_symbols <= parameters)
    )
