"""The words a block's equations may use beside arithmetic and `math`.

Each word has one meaning and several readings: the Python function here (which
Numba compiles as it stands) and the SymPy form in `SYMBOLIC`.  There is no
`if` among them: a choice is `where`, so that the same line can be traced on
symbols, compiled, and run in SIMD lanes.
"""

import math
from collections.abc import Callable
from typing import Any


def where(condition, a, b):
    """Give `a` where the condition holds, else `b`.

    Both values are computed, so both must be finite.

    Examples
    --------
    >>> where(2.0 > 1.0, 10.0, 20.0)
    10.0
    """
    return a if condition else b


def minimum(a, b):
    """Give the smaller of two numbers.

    Examples
    --------
    >>> minimum(2.0, 3.0)
    2.0
    """
    return a if a < b else b


def maximum(a, b):
    """Give the larger of two numbers.

    Examples
    --------
    >>> maximum(2.0, 3.0)
    3.0
    """
    return a if a > b else b


def clip(value, low, high):
    """Limit a number to the interval [low, high].

    Examples
    --------
    >>> clip(5.0, -1.0, 1.0)
    1.0
    """
    return low if value < low else (high if value > high else value)


def sign(value):
    """Give the sign of a number: -1.0, 0.0 or 1.0.

    Examples
    --------
    >>> sign(-3.0)
    -1.0
    """
    return 1.0 if value > 0 else (-1.0 if value < 0 else 0.0)


def floor(value):
    """Give the largest whole number not above `value`, as a float.

    Examples
    --------
    >>> floor(2.7)
    2.0
    """
    return float(math.floor(value))


def lookup(table, index):
    """Read a flat table at a whole number given as a float.

    Examples
    --------
    >>> lookup([3.0, 5.0, 7.0], 1.0)
    5.0
    """
    return table[int(index)]


WORDS: dict[str, Callable] = {
    word.__name__: word for word in (where, minimum, maximum, clip, sign, floor, lookup)
}


def _symbolic_lookup(table, index):
    import sympy

    if getattr(index, "is_Integer", False) or isinstance(index, int | float):
        return table[int(index)]
    return sympy.Function("lookup")(index)


def _symbolic_words() -> dict[str, Any]:
    import sympy

    return {
        "where": lambda condition, a, b: sympy.Piecewise((a, condition), (b, True)),
        "minimum": sympy.Min,
        "maximum": sympy.Max,
        "clip": lambda value, low, high: sympy.Min(sympy.Max(value, low), high),
        "sign": sympy.sign,
        "floor": sympy.floor,
        "lookup": _symbolic_lookup,
    }


MATH = frozenset(
    [
        "pi",
        "e",
        "tau",
        "exp",
        "log",
        "sqrt",
        "sin",
        "cos",
        "tan",
        "asin",
        "acos",
        "atan",
        "atan2",
        "sinh",
        "cosh",
        "tanh",
        "asinh",
        "acosh",
        "atanh",
        "fabs",
        "hypot",
        "log1p",
        "expm1",
        "log2",
        "log10",
        "pow",
        "degrees",
        "radians",
        "erf",
        "erfc",
        "ceil",
    ]
)  # the names of `math` that all readers know


class SymbolicMath:
    """The `math` module as SymPy reads it: `math.exp` is `sympy.exp`.

    Names that SymPy spells otherwise are translated; the rest are the same.

    Examples
    --------
    >>> import sympy
    >>> SymbolicMath().fabs(sympy.Symbol("s", positive=True))
    s
    """

    def __getattr__(self, name: str) -> Any:
        """Find the SymPy function behind a name of `math`."""
        import sympy

        if name not in MATH:
            raise AttributeError(f"math.{name} has no reading on symbols")
        translated = {
            "e": sympy.E,
            "tau": 2 * sympy.pi,
            "fabs": sympy.Abs,
            "ceil": sympy.ceiling,
            "hypot": lambda a, b: sympy.sqrt(a**2 + b**2),
            "log1p": lambda a: sympy.log(1 + a),
            "expm1": lambda a: sympy.exp(a) - 1,
            "log2": lambda a: sympy.log(a) / sympy.log(2),
            "log10": lambda a: sympy.log(a) / sympy.log(10),
            "pow": lambda a, b: a**b,
            "degrees": lambda a: a * 180 / sympy.pi,
            "radians": lambda a: a * sympy.pi / 180,
        }
        return translated[name] if name in translated else getattr(sympy, name)


def symbolic_substitutes() -> dict[str, Any]:
    """Give what each word, and `math`, means on symbols."""
    return {**_symbolic_words(), "math": SymbolicMath()}
