"""The Python reading, which python-control runs: a block's own code on IEEE numbers.

Python raises an exception where a function leaves its domain (`math.log(0.0)`)
or a number its range (`math.exp(1e3)`); machine code goes on with infinity or
NaN.  Here Python goes on too, so that every reading gives the same: `math` and
the words return IEEE numbers, and the integrator names what is not finite.
The sine of an angle beyond 2^50, which means nothing, is NaN in every reading.
"""

import math
from collections.abc import Callable
from functools import lru_cache
from types import FunctionType
from typing import Any

import numpy as np

from .functions import fingerprint, substituted
from .words import MATH, WORDS

COMPUTED = (np.floating, np.bool_)  # what signals and parameters are, and no constant is
MOST_ANGLE = 2.0**50  # rad; beyond it doubles are a quarter apart and an angle means nothing

IEEE = {
    "asin": "arcsin",
    "acos": "arccos",
    "atan": "arctan",
    "atan2": "arctan2",
    "pow": "power",
    "asinh": "arcsinh",
    "acosh": "arccosh",
    "atanh": "arctanh",
}


def in_ieee(function: Any) -> Callable:
    """Return equations as code on IEEE numbers, to be called with NumPy's floats and arrays."""
    return _in_ieee(function, fingerprint(function))


@lru_cache(maxsize=1024)
def _in_ieee(function: FunctionType, code: tuple) -> Callable:
    return substituted(function, SUBSTITUTES)


def _word(name: str, exact: Callable) -> Callable:
    """Return a word that gives IEEE's value where Python raises an exception.

    What it does with constants alone is Python's own.
    """
    ieee, float64 = getattr(np, IEEE.get(name, name), None), np.float64

    def word(a: Any, *more: Any) -> Any:
        if type(a) is not float64 and not any(isinstance(b, COMPUTED) for b in (a, *more)):
            return exact(a, *more)
        try:
            return float64(exact(a, *more))
        except (ValueError, OverflowError, ZeroDivisionError):
            return float64(np.nan if ieee is None else ieee(a, *more))

    return word


def _circular(exact: Callable) -> Callable:
    float64 = np.float64

    def word(angle: Any) -> Any:
        if type(angle) is not float64 and not isinstance(angle, COMPUTED):
            return exact(angle)
        return float64(exact(angle) if -MOST_ANGLE < angle < MOST_ANGLE else np.nan)

    return word


def _where(condition: Any, a: Any, b: Any) -> Any:
    chosen = a if condition else b
    return np.float64(chosen) if isinstance(condition, np.bool_) else chosen


def _lookup(table: Any, index: Any) -> Any:
    if not isinstance(index, np.floating):
        return table[int(index)]
    whole = int(index) if -len(table) - 1 < index < len(table) else -len(table) - 1
    return np.float64(table[whole] if whole >= -len(table) else np.nan)


class _Math:
    def __init__(self) -> None:
        for name in MATH:
            value = getattr(math, name)
            setattr(self, name, _word(name, value) if callable(value) else value)
        self.sin, self.cos, self.tan = map(_circular, (math.sin, math.cos, math.tan))


SUBSTITUTES: dict[str, Any] = {
    **{name: _word(name, word) for name, word in WORDS.items()},
    "where": _where,
    "lookup": _lookup,
    "math": _Math(),
    "int": _word("trunc", int),
    "float": _word("float64", float),
}
