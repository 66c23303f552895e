"""Table of operations: one row for each elementwise operation, read by every backend.

Whole-array operations (`sum`, `view`, `stack`, ...) are in `graph`.  The last rows, on a row of
numbers, have no NumPy function: their values are computed by `graph.picked` and `graph.searched`.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from enum import IntEnum
from functools import partial
from math import copysign, erf, erfc, gamma, inf, nan, pi, sqrt
from typing import Any, NamedTuple

import numpy as np

# rad; beyond it doubles are a quarter apart and an angle means nothing
MOST_ANGLE = 2.0**50
Slope = Callable[..., Any]


class Smoothness(IntEnum):
    """Smoothness of an operation, from smooth to piecewise constant."""

    SMOOTH = 0
    FOLDS = 1  # smooth, but the inverse of a circular function bends: asin(sin(a))
    KINK = 2  # continuous, the slope jumps
    JUMP = 3  # jumps, with a slope between jumps
    STEP = 4  # constant between jumps


SMOOTH, FOLDS, KINK, JUMP, STEP = Smoothness


class Recurrence(NamedTuple):
    """Coefficient k of the series of an operation's result f, from those of its operands.

        f_k = (sum of signs times arguments_k - sum over j of u_j v_(k - j)) / (factor d_0)

    u, v and d are operands: 0 and 1 are the arguments, -1 is the result.
    The second sum, for j from `first` to k - `last`, is positive where there are no signs.  It has
    no coefficients of f that are not known before.  Without a row, smooth operations have

        f_k = sum over the arguments a of sum over j > 0 of j/k a_j slope_(k - j)

    (Jorba and Zou 2005, Experimental Mathematics 14).
    """

    signs: tuple[int, ...] = ()
    products: tuple[int, int] | None = None  # u and v
    first: int = 0
    last: int = 0
    divisor: int | None = None
    factor: float = 1.0


@dataclass(frozen=True)
class Row:
    """Facts about one operation.

    numpy : function on numbers.
    slopes : derivative by each argument, a function of the arguments and of the result f.
    chosen : comparison a, b that says whether the slope is that of a; otherwise that of b.
    sympy : name in SymPy, or function of SymPy and the arguments. Without, smooth operations have
        the same name there, and others are undefined functions, so a proof holds for any.
    exact : whether the SymPy expression has all digits and the whole range; tests do not compare
        one that has not.
    llvm : instruction, comparison or intrinsic; "libm", a function of the C library; "inline" or
        "function", a function of `codegen.elementary`, printed in place or once.
    c : operator, or function: of math.h, or with "_" at its end of `data/numpy.c`.
    smoothness : where the operation has kinks and jumps.
    decisions : comparisons and whole numbers that locate the kinks and jumps.
    signed_zero : whether -0.0 and 0.0 give different results.
    whole : whether whole numbers give a whole number.
    on_truths : operation in its place on truth values.
    operator : whether Python writes it with an operator, or as abs.
    raises : whether the operator of Python raises an error for some floats.
    traced : NumPy functions that are traced as the operation, if not `numpy` alone.
    series : recurrence of the coefficients of a Taylor series, if it is not that of the slopes.
    """

    numpy: Any = None
    slopes: tuple[Slope, ...] = ()
    chosen: Any = None
    sympy: Any = None
    exact: bool = True
    llvm: str = "function"
    c: str = field(kw_only=True)
    smoothness: Smoothness = SMOOTH
    decisions: tuple[str, ...] = ()
    signed_zero: bool = False
    whole: bool = False
    on_truths: str = ""
    operator: bool = False
    raises: bool = False
    traced: tuple[np.ufunc, ...] = ()
    series: Recurrence | None = None


def _circular(ufunc: np.ufunc, slope: Slope) -> Row:
    """Return the row of a circular function; it is NaN for angles that mean nothing."""

    def function(a):
        return ufunc(np.where(np.abs(a) < MOST_ANGLE, a, np.nan))

    return Row(function, (slope,), c=ufunc.__name__, traced=(ufunc,))


def _comparison(ufunc: np.ufunc, symbol: str, *decisions: str) -> Row:
    """Return the row of a comparison."""
    llvm = f"compare {symbol}"
    return Row(
        ufunc, llvm=llvm, c=symbol, smoothness=STEP, decisions=decisions, operator=True
    )


def _logical(ufunc: np.ufunc, llvm: str, symbol: str) -> Row:
    """Return the row of an operation on truth values."""
    return Row(ufunc, sympy=llvm, llvm=llvm, c=symbol, smoothness=STEP, operator=True)


def _rounding(ufunc: np.ufunc, name: str) -> Row:
    """Return the row of a function whose values are whole numbers."""
    return Row(ufunc, c=name, llvm="inline", smoothness=STEP, decisions=(name,))


def _gamma(a):
    """Return the gamma function as C does: no error at poles and beyond the largest number."""
    try:
        return gamma(a)
    except OverflowError:
        return inf
    except ValueError:
        return copysign(inf, a) if a == 0 else nan


def _digamma(a):
    """Return the logarithmic derivative of the gamma function (Abramowitz, Stegun: 6.3.18)."""
    is_left = a < 0.5
    v = np.where(is_left, 1.0 - a, a)
    y = v + 8.0
    w = 1.0 / (y * y)
    series = w * (1 / 12 - w * (1 / 120 - w * (1 / 252 - w * (1 / 240 - w / 132))))
    value = np.log(y) - 0.5 / y - series - sum(1.0 / (v + k) for k in range(8))
    return np.where(is_left, value - pi / np.tan(pi * a), value)


# rows of operators of Python that keep whole numbers, and of functions of the C library
_arithmetic = partial(Row, whole=True, operator=True)
_libm = partial(Row, llvm="libm")

TABLE: dict[str, Row] = {
    # arithmetic
    "add": _arithmetic(
        np.add,
        (lambda a, b, f: 1.0, lambda a, b, f: 1.0),
        sympy=lambda s, a, b: a + b,
        llvm="fadd",
        c="+",
        series=Recurrence((1, 1)),
    ),
    "sub": _arithmetic(
        np.subtract,
        (lambda a, b, f: 1.0, lambda a, b, f: -1.0),
        sympy=lambda s, a, b: a - b,
        llvm="fsub",
        c="-",
        series=Recurrence((1, -1)),
    ),
    "mul": _arithmetic(
        np.multiply,
        (lambda a, b, f: b, lambda a, b, f: a),
        sympy=lambda s, a, b: a * b,
        llvm="fmul",
        c="*",
        on_truths="and",
        series=Recurrence((), (0, 1)),
    ),
    "div": Row(
        np.true_divide,
        (lambda a, b, f: 1.0 / b, lambda a, b, f: -1.0 * f / b),
        sympy=lambda s, a, b: a / b,
        llvm="fdiv",
        c="/",
        signed_zero=True,
        operator=True,
        raises=True,
        series=Recurrence((1,), (-1, 1), last=1, divisor=1),
    ),
    "floordiv": _arithmetic(
        np.floor_divide,
        smoothness=STEP,
        decisions=("floordiv",),
        signed_zero=True,
        raises=True,
        c="floordiv_",
    ),
    "mod": _arithmetic(
        np.remainder,
        (lambda a, b, f: 1.0, lambda a, b, f: -np.floor(a / b)),
        smoothness=JUMP,
        decisions=("floordiv",),
        signed_zero=True,
        raises=True,
        c="mod_",
    ),
    "pow": _arithmetic(
        np.pow,
        (lambda a, b, f: b * a ** (b - 1.0), lambda a, b, f: f * np.log(a)),
        sympy=lambda s, a, b: a**b,
        signed_zero=True,
        raises=True,
        traced=(np.pow, np.float_power),
        c="pow",
    ),
    "neg": _arithmetic(
        np.negative,
        (lambda a, f: -1.0,),
        sympy=lambda s, a: -a,
        llvm="fneg",
        c="-",
        series=Recurrence((-1,)),
    ),
    "fabs": _arithmetic(
        np.absolute,
        (lambda a, f: np.where(a < 0.0, -1.0, 1.0),),
        sympy="Abs",
        llvm="intrinsic fabs",
        smoothness=KINK,
        decisions=("ge",),
        c="fabs",
    ),
    # comparisons and choices
    "lt": _comparison(np.less, "<", "lt"),
    "le": _comparison(np.less_equal, "<=", "le"),
    "gt": _comparison(np.greater, ">", "gt"),
    "ge": _comparison(np.greater_equal, ">=", "ge"),
    "eq": _comparison(np.equal, "=="),
    "ne": _comparison(np.not_equal, "!="),
    "and": _logical(np.logical_and, "and_", "&&"),
    "or": _logical(np.logical_or, "or_", "||"),
    "not": _logical(np.logical_not, "not_", "!"),
    "where": Row(np.where, llvm="select", c="?:", smoothness=KINK, whole=True),
    "minimum": Row(
        np.minimum,
        chosen=np.less_equal,
        llvm="inline",
        smoothness=KINK,
        decisions=("lt",),
        whole=True,
        on_truths="and",
        c="minimum_",
    ),
    "maximum": Row(
        np.maximum,
        chosen=np.greater_equal,
        llvm="inline",
        smoothness=KINK,
        decisions=("gt",),
        whole=True,
        on_truths="or",
        c="maximum_",
    ),
    "sign": Row(
        np.sign,
        llvm="inline",
        smoothness=STEP,
        decisions=("gt", "lt"),
        whole=True,
        c="sign_",
    ),
    "floor": _rounding(np.floor, "floor"),
    "ceil": _rounding(np.ceil, "ceil"),
    "trunc": _rounding(np.trunc, "trunc"),
    # powers and logarithms
    "sqrt": Row(
        np.sqrt,
        (lambda a, f: 1.0 / (2.0 * f),),
        llvm="intrinsic sqrt",
        c="sqrt",
        series=Recurrence((1,), (-1, -1), 1, 1, divisor=-1, factor=2.0),
    ),
    "hypot": Row(
        np.hypot,
        (lambda a, b, f: a / f, lambda a, b, f: b / f),
        sympy=lambda s, a, b: s.sqrt(a**2 + b**2),
        exact=False,
        c="hypot",
    ),
    "exp": Row(np.exp, (lambda a, f: f,), c="exp"),
    "expm1": Row(
        np.expm1,
        (lambda a, f: f + 1.0,),
        sympy=lambda s, a: s.exp(a) - 1,
        exact=False,
        c="expm1",
    ),
    "log": Row(np.log, (lambda a, f: 1.0 / a,), c="log"),
    "log1p": _libm(
        np.log1p,
        (lambda a, f: 1.0 / (1.0 + a),),
        sympy=lambda s, a: s.log(1 + a),
        exact=False,
        c="log1p",
    ),
    "log2": _libm(
        np.log2,
        (lambda a, f: 1.0 / (a * np.log(2.0)),),
        sympy=lambda s, a: s.log(a) / s.log(2),
        c="log2",
    ),
    "log10": _libm(
        np.log10,
        (lambda a, f: 1.0 / (a * np.log(10.0)),),
        sympy=lambda s, a: s.log(a) / s.log(10),
        c="log10",
    ),
    # circular functions
    "sin": _circular(np.sin, lambda a, f: np.cos(a)),
    "cos": _circular(np.cos, lambda a, f: -np.sin(a)),
    "tan": _circular(np.tan, lambda a, f: 1.0 + f * f),
    "asin": Row(
        np.asin, (lambda a, f: 1.0 / np.sqrt(1.0 - a * a),), smoothness=FOLDS, c="asin"
    ),
    "acos": Row(
        np.acos, (lambda a, f: -1.0 / np.sqrt(1.0 - a * a),), smoothness=FOLDS, c="acos"
    ),
    "atan": Row(
        np.atan, (lambda a, f: 1.0 / (1.0 + a * a),), smoothness=FOLDS, c="atan"
    ),
    "atan2": Row(
        np.atan2,
        (lambda a, b, f: b / (a * a + b * b), lambda a, b, f: -a / (a * a + b * b)),
        sympy="atan2",
        smoothness=JUMP,
        decisions=("lt",),
        signed_zero=True,
        c="atan2",
    ),
    # hyperbolic functions and the error function
    "sinh": _libm(np.sinh, (lambda a, f: np.cosh(a),), c="sinh"),
    "cosh": _libm(np.cosh, (lambda a, f: np.sinh(a),), c="cosh"),
    "tanh": Row(np.tanh, (lambda a, f: 1.0 - f * f,), c="tanh"),
    "asinh": _libm(np.asinh, (lambda a, f: 1.0 / np.sqrt(1.0 + a * a),), c="asinh"),
    "acosh": _libm(np.acosh, (lambda a, f: 1.0 / np.sqrt(a * a - 1.0),), c="acosh"),
    "atanh": _libm(np.atanh, (lambda a, f: 1.0 / (1.0 - a * a),), c="atanh"),
    "erf": _libm(
        np.vectorize(erf, otypes=[float]),
        (lambda a, f: 2.0 / sqrt(pi) * np.exp(-a * a),),
        c="erf",
    ),
    "tgamma": _libm(
        np.vectorize(_gamma, otypes=[float]),
        (lambda a, f: f * _digamma(a),),
        sympy="gamma",
        c="tgamma",
    ),
    "erfc": _libm(
        np.vectorize(erfc, otypes=[float]),
        (lambda a, f: -2.0 / sqrt(pi) * np.exp(-a * a),),
        c="erfc",
    ),
    # a number in a row, the position of a number in a sorted row, the position of the least number
    "pick": Row(smoothness=JUMP, decisions=("trunc",), c="pick_"),
    "search": Row(smoothness=STEP, decisions=("search",), c="search_"),
    "argmin": Row(smoothness=STEP, decisions=("argmin",), c="argmin_"),
}

NO_ROW = Row(c="")  # of an operation on whole arrays, or of machine code alone
# name -> function on numbers
ELEMENTWISE: dict[str, Callable[..., Any]] = {
    name: row.numpy for name, row in TABLE.items() if row.numpy is not None
}
# NumPy's ufunc -> name of the operation as which it is traced
UFUNCS: dict[Any, str] = {
    ufunc: name
    for name, row in TABLE.items()
    for ufunc in row.traced or (row.numpy,)
    if isinstance(ufunc, np.ufunc)
}


def named(fact: Callable[[Row], Any]) -> frozenset[str]:
    """Return the names of the operations for which a fact holds."""
    return frozenset(name for name, row in TABLE.items() if fact(row))


COMPARISONS = named(lambda row: row.llvm.startswith("compare"))
LOGICAL = frozenset({"and", "or", "not"})  # of truth values
CONDITIONS = LOGICAL | COMPARISONS  # truth values
ON_ROWS = named(lambda row: row.numpy is None)  # the first argument is a row of numbers
STEPS = named(lambda row: row.smoothness == STEP)
