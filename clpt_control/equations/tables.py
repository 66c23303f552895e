"""Tables: np.interp, and interpolators that SciPy and python-control's gain schedules are made of.

A place in a table is how many of its inner points are not above x; `pick` takes what stands there.
"""

from collections.abc import Callable
from functools import reduce
from typing import Any

import numpy as np

from .arrays import Array, Unread, constant, elementwise, lifted, numbers_of, operand, where

MOST = 64  # simplices, or points in more than one dimension


def picked(row: np.ndarray, place: Array) -> Any:
    """Return what stands in a row of numbers at a place."""
    table = constant(place.tape, np.asarray(row, dtype=float))
    return place.tape.add("pick", (operand(table), place.ref), place.shape)


def place_in(points: np.ndarray, x: Array, side: str = "right") -> Any:
    """Return how many of the sorted points are not above x, as np.searchsorted does."""
    at_least = elementwise("ge" if side == "right" else "gt", x[..., None], lifted(x.tape, points))
    ones = elementwise("where", at_least, 1.0, 0.0)
    return x.tape.add("sum", (ones.ref,), x.shape, x.ndim)


def known(value: Any) -> Any:
    """Return an array that depends on nothing as numbers, another as it is."""
    numbers = numbers_of(value) if isinstance(value, Array) else None
    return value if numbers is None else numbers


def interpolated(x: Any, xp: Any, fp: Any, left: Any = None, right: Any = None) -> Any:
    """Return np.interp(x, xp, fp)."""
    xp, fp = known(xp), known(fp)
    if not isinstance(x, Array) or isinstance(xp, Array):
        raise Unread("np.interp of points that are signals")
    xp = np.asarray(xp, dtype=float)
    if isinstance(fp, Array):
        shares = [np.interp(xp, xp, unit) for unit in np.eye(len(xp))]
        return sum(fp[k] * interpolated(x, xp, share) for k, share in enumerate(shares))
    fp = np.asarray(fp, dtype=float)
    if len(xp) > 1:
        k, slopes = place_in(xp[1:-1], x), np.diff(fp) / np.diff(xp)
        between = picked(slopes, k) * (x - picked(xp, k)) + picked(fp, k)
    else:
        between = lifted(x.tape, np.full(x.shape, fp[0])) if x.shape else fp[0]
    above = where(elementwise("ge", x, xp[-1]), fp[-1], between)
    if right is not None:
        above = where(elementwise("gt", x, xp[-1]), right, above)
    return where(elementwise("lt", x, xp[0]), fp[0] if left is None else left, above)


def of_interp1d(f: Any) -> Callable:
    """Return scipy.interpolate.interp1d as a function of signals."""
    xs, kind = np.asarray(f.x, dtype=float), f._kind
    ys = np.moveaxis(np.asarray(f.y, dtype=float), f.axis, 0).reshape(len(xs), -1)
    shape = np.moveaxis(np.asarray(f.y), f.axis, 0).shape[1:]
    if kind not in ("linear", "nearest", "previous", "next", "zero"):
        raise Unread(f"scipy's interp1d of kind {kind!r}")
    fills: list[float | None] = [None, None]
    if not f._extrapolate:
        given = f.fill_value if isinstance(f.fill_value, tuple) else (f.fill_value,) * 2
        fills = [np.nan if f.bounds_error else float(np.ravel(one)[0]) for one in given]

    def column(x: Array, y: np.ndarray) -> Any:
        if kind == "linear":
            k = place_in(xs[1:-1], x, "left")
            slopes = np.diff(y) / np.diff(xs)
            found = picked(slopes, k) * (x - picked(xs, k)) + picked(y, k)
        elif kind == "nearest":
            found = picked(y, place_in((xs[1:] + xs[:-1]) / 2.0, x, "left"))
        elif kind == "next":
            found = picked(y, place_in(xs[:-1], x, "left"))
        else:
            found = picked(y, place_in(xs[1:], x))
        for name, edge, fill in (("lt", xs[0], fills[0]), ("gt", xs[-1], fills[1])):
            if fill is not None:
                found = where(elementwise(name, x, edge), fill, found)
        return found

    def table(x: Any) -> Any:
        tape = _tape_in(x)
        if tape is None:
            return f(np.asarray(x, dtype=float))
        x = lifted(tape, x)
        own = [column(x, y) for y in ys.T]
        found = np.stack(own).T if shape else own[0]
        return found.reshape((*x.shape, *shape)) if len(shape) > 1 else found

    return table


def _tape_in(x: Any) -> Any:
    from .opened import tape_of

    return tape_of([x])


def of_polynomials(f: Any) -> Callable:
    """Return a piecewise polynomial of SciPy, such as CubicSpline, as a function of signals."""
    coefficients, xs = np.asarray(f.c), np.asarray(f.x, dtype=float)
    if coefficients.ndim != 2 or coefficients.dtype.kind != "f" or f.extrapolate == "periodic":
        raise Unread(f"scipy's {type(f).__name__} of several columns, or a periodic one")

    def table(x: Any, *more: Any, **named: Any) -> Any:
        tape = _tape_in(x)
        if tape is None or more or named:
            return f(x, *more, **named)
        x = lifted(tape, x)
        k = place_in(xs[1:-1], x)
        s = x - picked(xs, k)
        found = reduce(lambda v, w: v * s + w, [picked(row, k) for row in coefficients])
        outside = (x < xs[0]) | (x > xs[-1])
        return found if f.extrapolate else where(outside, np.nan, found)

    return table


def of_simplices(f: Any) -> Callable:
    """Return scipy.interpolate.LinearNDInterpolator as a function of signals; NaN outside."""
    mesh, tail = f.tri, tuple(f.values_shape)
    transforms = mesh.transform
    ys = np.asarray(f.values, dtype=float).reshape(len(f.values), *tail)
    count, corners = mesh.simplices.shape
    if count > MOST:
        raise Unread(f"scipy's LinearNDInterpolator of more than {MOST} simplices")

    def table(*x: Any) -> Any:
        tape = _tape_in(x)
        if tape is None:
            return f(*x)
        x = lifted(tape, x[0] if len(x) == 1 else list(x)).reshape(-1)
        found: Any = np.full(tail, np.nan) if tail else np.nan
        for k in range(count - 1, -1, -1):
            inverse = transforms[k]
            shares = [inverse[d] @ (x - inverse[-1]) for d in range(len(inverse) - 1)]
            shares.append(1.0 - reduce(lambda v, w: v + w, shares))
            inside = reduce(lambda v, w: v & w, [share >= -1e-12 for share in shares])
            value = reduce(
                lambda v, w: v + w,
                [shares[j] * ys[mesh.simplices[k, j]] for j in range(corners)],
            )
            found = where(inside, value, found)
        return found[None]

    return table


def of_nearest(f: Any) -> Callable:
    """Return scipy.interpolate.NearestNDInterpolator as a function of signals."""
    points, ys = np.asarray(f.tree.data, dtype=float), np.asarray(f.values, dtype=float)
    if len(points) > MOST:
        raise Unread(f"scipy's NearestNDInterpolator of more than {MOST} points")

    def table(*x: Any) -> Any:
        tape = _tape_in(x)
        if tape is None:
            return f(*x)
        x = lifted(tape, x[0] if len(x) == 1 else list(x)).reshape(-1)
        near = np.sum((x - points[0]) ** 2)
        found: Any = ys[0]
        for point, y in zip(points[1:], ys[1:], strict=True):
            distance = np.sum((x - point) ** 2)
            closer = distance < near
            near, found = where(closer, distance, near), where(closer, y, found)
        return found[None]

    return table


TABLES: dict[str, Callable[[Any], Callable]] = {
    "scipy.interpolate._interpolate.interp1d": of_interp1d,
    "scipy.interpolate._cubic.CubicSpline": of_polynomials,
    "scipy.interpolate._cubic.PchipInterpolator": of_polynomials,
    "scipy.interpolate._cubic.Akima1DInterpolator": of_polynomials,
    "scipy.interpolate._interpolate.PPoly": of_polynomials,
    "scipy.interpolate._interpnd.LinearNDInterpolator": of_simplices,
    "scipy.interpolate.interpnd.LinearNDInterpolator": of_simplices,
    "scipy.interpolate._ndgriddata.NearestNDInterpolator": of_nearest,
}


def table_of(value: Any) -> Callable | None:
    """Return an interpolator as a function of signals; None for what is none."""
    kind = type(value)
    made = TABLES.get(f"{kind.__module__}.{kind.__name__}")
    return None if made is None else made(value)
