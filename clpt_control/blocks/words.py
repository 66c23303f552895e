"""The words a block's equations may use, with arithmetic and `math`.

Each word has one meaning, written here in Python; machine code and SymPy take it
from the record (`native.elementary`, `blocks.symbolic`).  There is no `if` among
them: a choice is `where`, so that a line is recorded once and runs in SIMD lanes.
NaN stays NaN.
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
    """Return an array's entry at an index, a float cut to a whole number.

    A negative index counts from the end.

    Examples
    --------
    >>> lookup([3.0, 5.0, 7.0], 1.0)
    5.0
    """
    return table[int(index)]


WORDS: dict[str, Callable] = {
    word.__name__: word for word in (where, minimum, maximum, clip, sign, floor, lookup)
}

MATH = frozenset(  # the names of `math` that every reading knows
    (
        *("pi", "e", "tau", "exp", "expm1", "log", "log1p", "log2", "log10", "sqrt", "pow"),
        *("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "degrees", "radians"),
        *("sinh", "cosh", "tanh", "asinh", "acosh", "atanh"),
        *("fabs", "hypot", "erf", "erfc", "ceil"),
    )
)
