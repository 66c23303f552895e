"""The words a block's equations may use beside arithmetic and `math`.

Each word has one meaning, written here in Python; machine code and SymPy have
it from the record (`native.elementary`, `blocks.symbolic`).  There is no `if`
among them: a choice is `where`, so that the same line can be recorded once and
run in SIMD lanes.  A number that is not a number (NaN) stays one.
"""

import math
from collections.abc import Callable


def where(condition, a, b):
    """Return `a` where the condition holds, else `b`.

    Examples
    --------
    >>> where(2.0 > 1.0, 10.0, 20.0)
    10.0
    """
    return a if condition else b


def minimum(a, b):
    """Return the smaller of two numbers.

    Examples
    --------
    >>> minimum(2.0, 3.0)
    2.0
    """
    return a if a < b or a != a else b


def maximum(a, b):
    """Return the larger of two numbers.

    Examples
    --------
    >>> maximum(2.0, 3.0)
    3.0
    """
    return a if a > b or a != a else b


def clip(value, low, high):
    """Limit a number to the interval [low, high].

    Examples
    --------
    >>> clip(5.0, -1.0, 1.0)
    1.0
    """
    return low if value < low else (high if value > high else value)


def sign(value):
    """Return the sign of a number: -1.0, 0.0 or 1.0.

    Examples
    --------
    >>> sign(-3.0)
    -1.0
    """
    return 1.0 if value > 0 else (-1.0 if value < 0 else 0.0 * value)


def floor(value):
    """Return the largest whole number not above `value`, as a float.

    Examples
    --------
    >>> floor(2.7)
    2.0
    """
    return float(math.floor(value))


def lookup(table, index):
    """Read an array at a whole number, from the end where negative.

    The number is a float; what it has behind the point is left out.

    Examples
    --------
    >>> lookup([3.0, 5.0, 7.0], 1.0)
    5.0
    """
    return table[int(index)]


WORDS: dict[str, Callable] = {
    word.__name__: word for word in (where, minimum, maximum, clip, sign, floor, lookup)
}

MATH = frozenset(
    {
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
    }
)  # the names of `math` that every reading knows
