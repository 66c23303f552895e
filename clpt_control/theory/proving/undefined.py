"""Where equations have a value: no division by what may be zero, no root of what may be less.

SymPy cancels z z/z to z; the equations that run give NaN at z = 0.  So every operation
of a record that has no value somewhere is checked: can it come there?
"""

from collections.abc import Callable
from functools import lru_cache

import sympy

from .quadratic_forms import positive_maximum

DEEPEST = 12  # levels of operations; deeper ones would take SymPy too long


@lru_cache(maxsize=100_000)
def extent(expression: sympy.Basic) -> tuple[int, int]:
    """Return how many parts an expression has, written out, and how many levels."""
    parts = [extent(part) for part in expression.args]
    return 1 + sum(size for size, _ in parts), 1 + max((depth for _, depth in parts), default=0)


def _parameters(expression: sympy.Expr) -> bool:
    return all("." in symbol.name for symbol in expression.free_symbols)


def _nonzero(b: sympy.Expr) -> bool:
    """Return whether a divisor is known not to be zero; maximum(a, b) is not where b > 0."""
    return bool(b.is_nonzero) or positive_maximum(b)


def _not_huge(a: sympy.Expr) -> bool:
    """Return whether exp(a) stays a number; parameters are what their block makes of them."""
    return bool(a.is_nonpositive) or _parameters(a)


def _power(base: sympy.Expr, exponent: sympy.Expr) -> bool:
    integer = bool(exponent.is_integer)
    return bool(
        (integer and (exponent.is_nonnegative or base.is_nonzero))
        or base.is_positive
        or (base.is_nonnegative and exponent.is_positive)
    )


# operation -> (what must hold, as a sentence, whether it is known to)
DEMANDS: dict[str, tuple[str, Callable[..., bool]]] = {
    "div": ("divides by {1}, which may be zero", lambda a, b: _nonzero(b)),
    "mod": ("takes the remainder by {1}, which may be zero", lambda a, b: _nonzero(b)),
    "floordiv": ("divides by {1}, which may be zero", lambda a, b: _nonzero(b)),
    "pow": ("raises {0} to the power {1}, which may have no value", _power),
    "sqrt": ("takes the root of {0}, which may be negative", lambda a: bool(a.is_nonnegative)),
    "log1p": ("takes log(1 + {0}), which may have no value", lambda a: bool((1 + a).is_positive)),
    "tan": ("takes the tangent of {0}, which may have no value", lambda a: False),
    "atanh": (
        "takes atanh of {0}, which may have no value",
        lambda a: bool((1 - a**2).is_positive),
    ),
    "acosh": (
        "takes acosh of {0}, which may have no value",
        lambda a: bool((a - 1).is_nonnegative),
    ),
    **dict.fromkeys(("exp", "expm1"), ("takes exp of {0}, which may be too large", _not_huge)),
    **dict.fromkeys(
        ("sinh", "cosh"), ("takes sinh or cosh of {0}, which may be too large", _parameters)
    ),
    **dict.fromkeys(
        ("log", "log2", "log10"),
        ("takes the logarithm of {0}, which may have no value", lambda a: bool(a.is_positive)),
    ),
    **dict.fromkeys(
        ("asin", "acos"),
        ("takes an angle of {0}, which may have none", lambda a: bool((1 - a**2).is_nonnegative)),
    ),
}


def undefined(name: str, arguments: tuple) -> str | None:
    """Return what may have no value, such as "divides by z, which may be zero", or None.

    `name` is an operation of a record, the arguments are expressions.
    """
    if name not in DEMANDS:
        return None
    sentence, known = DEMANDS[name]
    arguments = tuple(map(sympy.sympify, arguments))
    if name == "div" and positive_maximum(arguments[1]):
        return None
    shallow = all(extent(a)[1] <= DEEPEST for a in arguments)
    return None if shallow and known(*arguments) else sentence.format(*arguments)
