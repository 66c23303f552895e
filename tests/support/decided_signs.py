"""Signs that proofs decide, of expressions that a test writes as text."""

import sympy

from clpt_control.engine.diagram.symbol_names import TIME
from clpt_control.theory.algebra.decide import never_positive
from clpt_control.theory.algebra.decided import decided
from clpt_control.theory.algebra.exact import normal_form

__all__ = ["LETTERS", "expression_of", "is_never_positive"]

LETTERS = "xyzrabkt"
POSITIVE = {*sympy.symbols("a b k", positive=True)}
FUNCTIONS = [
    "inside",
    "gt",
    "ge",
    "lt",
    "le",
    "and_",
    "or_",
    "not_",
    "where",
    "maximum",
    "minimum",
    "clip",
]
NAMES = {
    **{name: sympy.Symbol(name, real=True) for name in "xyzr"},
    **{str(symbol): symbol for symbol in POSITIVE},
    **{name: sympy.Function(name, real=True) for name in FUNCTIONS},
    "u": sympy.Function("u", real=True)(TIME),
    "t": TIME,
}


def expression_of(text):
    """Return the SymPy expression of a text, in real letters and positive a, b, k."""
    return sympy.sympify(text, NAMES)


def is_never_positive(text):
    """Return whether the prover shows that an expression is never positive."""
    return never_positive(normal_form(decided(expression_of(text))), POSITIVE)
