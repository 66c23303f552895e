"""A record on NumPy's numbers: what it computes, in the order in which it was written."""

from collections.abc import Callable
from math import erf, erfc
from typing import Any

import numpy as np

MOST_ANGLE = 2.0**50  # rad; beyond it doubles are a quarter apart and an angle means nothing

UFUNCS: dict[Any, str] = {
    np.add: "add",
    np.subtract: "sub",
    np.multiply: "mul",
    np.true_divide: "div",
    np.floor_divide: "floordiv",
    np.remainder: "mod",
    np.power: "pow",
    np.float_power: "pow",
    np.negative: "neg",
    np.absolute: "fabs",
    np.less: "lt",
    np.less_equal: "le",
    np.greater: "gt",
    np.greater_equal: "ge",
    np.equal: "eq",
    np.not_equal: "ne",
    np.logical_and: "and",
    np.logical_or: "or",
    np.logical_not: "not",
    np.bitwise_and: "and",
    np.bitwise_or: "or",
    np.invert: "not",
    np.arctan2: "atan2",
    np.arcsin: "asin",
    np.arccos: "acos",
    np.arctan: "atan",
    np.arcsinh: "asinh",
    np.arccosh: "acosh",
    np.arctanh: "atanh",
    **{
        getattr(np, name): name
        for name in (
            *("exp", "expm1", "log", "log1p", "log2", "log10", "sqrt", "sin", "cos", "tan"),
            *("sinh", "cosh", "tanh", "fabs", "hypot", "minimum", "maximum", "sign"),
            *("floor", "ceil", "trunc"),
        )
    },
}
OPERATIONS: dict[str, Callable[..., Any]] = {
    **{name: ufunc for ufunc, name in UFUNCS.items()},
    "and": np.logical_and,
    "or": np.logical_or,
    "not": np.logical_not,
    "pow": np.power,
    "where": np.where,
    "erf": np.vectorize(erf, otypes=[float]),
    "erfc": np.vectorize(erfc, otypes=[float]),
    "fabs": np.fabs,
}


def viewed(array: np.ndarray, mapped: tuple, shape: tuple[int, ...]) -> np.ndarray:
    """Return a view: what `mapped` says of each axis of an array."""
    strides = [0] * len(shape)
    first = 0
    for m, stride in zip(mapped, array.strides, strict=True):
        if isinstance(m, int):
            first += m * stride
        else:
            strides[m[0]] += m[2] * stride
            first += m[1] * stride
    if 0 in shape:
        return np.zeros(shape)
    flat = np.ndarray(shape, float, array, first, strides) if array.dtype == float else None
    if flat is None:
        return viewed(array.astype(float), mapped, shape) != 0.0
    return flat


def picked(numbers: np.ndarray, index: Any) -> np.ndarray:
    """Return numbers of a row at whole places; NaN outside."""
    if not len(numbers):
        return np.full(np.shape(index), np.nan)
    whole = np.trunc(index)
    whole = np.where(whole < 0, whole + len(numbers), whole)
    inside = (whole >= 0) & (whole < len(numbers))
    return np.where(inside, numbers[np.where(inside, whole, 0).astype(int)], np.nan)


def sized(shape: tuple[Any, ...], sizes: dict[str, int]) -> tuple[int, ...]:
    """Return a shape with its open sizes filled in."""
    return tuple(n if isinstance(n, int) else sizes[n] for n in shape)


def computed(
    record: Any, leaf: Callable[[str, str], Any], sizes: dict[str, int]
) -> list[np.ndarray]:
    """Compute the outputs of a record; `leaf` gives the array of a group and name."""
    values: list[np.ndarray] = []
    with np.errstate(all="ignore"):
        for kind, arguments, shape, at in record.operations:
            own: list[Any] = [values[a] if type(a) is int else np.float64(a) for a in arguments]
            value: Any
            if kind == "leaf":
                value = np.asarray(leaf(*at))
            elif kind == "constant":
                value = np.frombuffer(at).reshape(shape)
            elif kind == "sum":
                value = np.sum(own[0], axis=at)
            elif kind == "view":
                value = viewed(np.asarray(own[0]), at, sized(shape, sizes))
            elif kind == "stack":
                value = np.stack([np.asarray(a) for a in own])
            elif kind == "join":
                value = np.concatenate(own)
            elif kind == "pick":
                value = picked(*own)
            elif kind in ("opaque", "fill"):
                value = own[0]
            else:
                if kind in ("sin", "cos", "tan"):
                    own = [np.where(np.abs(own[0]) < MOST_ANGLE, own[0], np.nan)]
                value = OPERATIONS[kind](*own)
            values.append(np.broadcast_to(value, sized(shape, sizes)))
    found = zip(record.outputs, record.shapes, strict=True)
    return [
        np.broadcast_to(values[r] if type(r) is int else r, sized(shape, sizes)).astype(float)
        for r, shape in found
    ]
