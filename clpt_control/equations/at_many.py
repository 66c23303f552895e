"""A record on NumPy's arrays: the same equations at many times and places at once."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..arguments import numbers, public
from ..errors import ArgumentError
from .block import Block
from .numbers import MOST_ANGLE
from .scalars import Scalars


def on_arrays(record: Scalars, t: Any, x: Any, u: Any, p: Any) -> np.ndarray:
    """Run a record on arrays: n times, for each state and input a number or n; shape (size, n)."""
    t = np.asarray(t, dtype=float)
    flat: dict[str, np.ndarray] = {}

    def field(name: str) -> np.ndarray:
        if name not in flat:
            flat[name] = np.ravel(np.asarray(getattr(p, name), dtype=float))
        return flat[name]

    def leaf(name: str, *where: Any) -> Any:
        if name == "t":
            return t
        if name == "p":
            return field(where[0])[where[1]]
        return np.asarray((x if name == "x" else u)[where[0]], dtype=float)

    def apply(name: str, *arguments: Any) -> Any:
        if name == "table":
            which, first, stride, count = arguments[1]
            numbers = field(which)[first + stride * np.arange(count)]
            return picked(numbers, arguments[0])
        return OPERATIONS[name](*arguments)

    with np.errstate(all="ignore"):
        found = record.replay(leaf, apply)
    return np.array([np.broadcast_to(value, t.shape) for value in found], dtype=float)


@public
def evaluate(block: Block, times: ArrayLike, inputs: ArrayLike) -> np.ndarray:
    """Compute a static block's outputs at many times and inputs.

    Parameters
    ----------
    block : Block
        Without states, such as ``basis_x``, Eq. (5), or ``true_flow`` of a gridded field.
    times : array_like, shape (n,) or a number
        In the block's unit.
    inputs : array_like, shape (n, ninputs)
        Such as places, in the block's unit.

    Returns
    -------
    ndarray, shape (n, noutputs)
        One row per sample.

    Examples
    --------
    >>> from clpt_control.blocks.basis import flow_basis
    >>> p = np.zeros((1, 2)), np.ones(1), np.zeros(1), np.zeros(1)
    >>> evaluate(flow_basis("basis_x", "x", "gaussian", *p), [0, 5], [[0, 0], [1, 1]]).round(3)
    array([[1.   ],
           [0.368]])
    """
    given = np.atleast_2d(numbers("inputs", inputs, block.ninputs))
    at = numbers("times", times)
    if given.ndim > 2 or at.shape not in ((), (1,), given.shape[:1]):
        raise ArgumentError(
            f"evaluate: times has shape {at.shape}, inputs {given.shape}; must be a time, or n of "
            f"them, and (n, {block.ninputs})"
        )
    at = np.broadcast_to(at, len(given))
    return on_arrays(block.output_record, at, (), given.T, block.parameters).T


def picked(numbers: np.ndarray, index: Any) -> Any:
    """Return numbers at whole places; NaN outside."""
    whole = np.trunc(index)
    whole = np.where(whole < 0, whole + len(numbers), whole)
    inside = (whole >= 0) & (whole < len(numbers))
    at = np.where(inside, whole, 0).astype(int)
    found = numbers[at] if numbers.ndim == 1 else np.take_along_axis(numbers, at[None], 0)[0]
    return np.where(inside, found, np.nan)


def _circular(function: Callable) -> Callable:
    return lambda a: function(np.where(np.abs(a) < MOST_ANGLE, a, np.nan))


def _sign(a: Any) -> Any:
    return np.where(a > 0, 1.0, np.where(a < 0, -1.0, 0.0 * a))


def _each(name: str) -> Callable:
    from math import erf, erfc

    return np.vectorize({"erf": erf, "erfc": erfc}[name], otypes=[float])


OPERATIONS: dict[str, Callable[..., Any]] = {
    "add": np.add,
    "sub": np.subtract,
    "mul": np.multiply,
    "div": np.divide,
    "mod": np.mod,
    "floordiv": np.floor_divide,
    "pow": np.power,
    "neg": np.negative,
    "lt": np.less,
    "le": np.less_equal,
    "gt": np.greater,
    "ge": np.greater_equal,
    "and": np.logical_and,
    "or": np.logical_or,
    "not": np.logical_not,
    "where": np.where,
    "minimum": lambda a, b: np.where((a < b) | (a != a), a, b),
    "maximum": lambda a, b: np.where((a > b) | (a != a), a, b),
    "clip": lambda a, low, high: np.where(a < low, low, np.where(a > high, high, a)),
    "sign": _sign,
    "floor": lambda a: np.floor(a) + 0.0,  # a whole number has no -0
    "trunc": lambda a: np.trunc(a) + 0.0,
    "ceil": lambda a: np.ceil(a) + 0.0,
    "pick": lambda index, *numbers: picked(np.array(np.broadcast_arrays(*numbers)), index),
    "opaque": lambda identity, value, *arguments: value,
    "erf": _each("erf"),
    "erfc": _each("erfc"),
    "sin": _circular(np.sin),
    "cos": _circular(np.cos),
    "tan": _circular(np.tan),
    **{
        name: getattr(np, name)
        for name in (
            *("exp", "expm1", "log", "log1p", "log2", "log10", "sqrt"),
            *("sinh", "cosh", "tanh", "fabs", "hypot"),
        )
    },
    **{
        name: getattr(np, f"arc{name[1:]}")
        for name in ("asin", "acos", "atan", "atan2", "asinh", "acosh", "atanh")
    },
}
