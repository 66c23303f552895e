"""Tables in equations.

A table is a row of numbers read at a place (`lookup`), np.interp, or one of the interpolators of
SciPy that python-control's gain schedules are made of.  A place in a table is how many of its inner
points are not above x; `pick` takes what stands there.
"""

from collections.abc import Callable
from functools import cache, reduce
from operator import add, and_
from typing import Any

import numpy as np

from ...arguments import brief, public
from ...errors import ArgumentError
from ..record.graph import picked
from .arrays import Array, Tape, Unread, numbers_of, operand
from .elementwise import boxed, constant, lifted, where


@public
def lookup(table: Any, index: Any) -> Any:
    """Return a row's number at a whole place; NaN outside.

    Parameters
    ----------
    table : array_like, shape (n,)
        Numbers.
    index : float or array_like
        A place, cut to a whole number; a negative one counts from the end.

    Returns
    -------
    float or ndarray
        One number for each place.

    Examples
    --------
    >>> lookup([3.0, 5.0, 7.0], 1.0)
    np.float64(5.0)
    """
    if (tape := next((a._tape for a in (table, index) if isinstance(a, Array)), None)) is None:
        try:
            return picked(np.asarray(table, dtype=float), np.asarray(index, dtype=float))[()]
        except (TypeError, ValueError):
            raise ArgumentError(
                f"lookup: table = {brief(table)}, index = {brief(index)}: must be a row of numbers "
                "and a place"
            ) from None
    table = lifted(tape, table)
    return tape.add("pick", [operand(table), operand(index)], getattr(index, "shape", ()))


# --- np.interp ---------------------------------------------------------------------------------


SMOOTH = 3e-9  # of the largest number: a smaller difference of a table and a curve is none
MOST = 64  # simplices, or points in more than one dimension


def place_in(points: Any, x: Any, side: Any = "right", joints: str = "jumps") -> Any:
    """Return how many of the sorted points are not above x, as np.searchsorted does.

    It is found by bisection.  What is read there has `joints` at the points: "jumps", "kinks", or
    "smooth" ones, of which no integrator need know.
    """
    points = np.asarray(points, dtype=float)
    if not isinstance(x, Array):
        return float(np.searchsorted(points, x, side))
    row = constant(x._tape, points)
    new = x._tape.add("search", (operand(row), operand(x)), x.shape, (side, joints))
    new._whole = True
    return new


def pieces(xs: Any, rows: Any, x: Any, side: str = "right") -> Any:
    """Return the polynomial of the piece that x lies in; the outer ones go on."""
    k = place_in(xs[1:-1], x, side, joints_of(xs, rows))
    s = x - lookup(xs, k)
    return reduce(lambda v, w: v * s + w, [lookup(row, k) for row in rows])


def joints_of(xs: np.ndarray, rows: Any) -> str:
    """Return whether neighbouring polynomials jump, bend, or are one curve but for rounding.

    The curve that two of them stand for differs from them by an eighth of what separates them at
    the end of the second.
    """
    apart = np.diff(xs)
    size = np.max(np.abs(rows[-1]), initial=0.0)
    lines = [row[:-1] for row in rows]
    ends = reduce(lambda v, w: v * apart[:-1] + w, lines)
    if not np.allclose(ends, rows[-1][1:], 1e-12, 1e-12 * size):
        return "jumps"
    further = reduce(lambda v, w: v * (apart[:-1] + apart[1:]) + w, lines)
    nexts = reduce(lambda v, w: v * apart[1:] + w, [row[1:] for row in rows])
    return "smooth" if np.all(np.abs(further - nexts) <= 8.0 * SMOOTH * size) else "kinks"


def slopes(xs: np.ndarray, ys: Any) -> Any:
    """Return the slopes of straight lines between points; 0 between two of one place."""
    apart = np.diff(xs).reshape(-1, *[1] * (ys.ndim - 1))
    return (ys[1:] - ys[:-1]) / np.where(apart > 0.0, apart, np.inf)


def searched(points: Any, x: Any, side: str = "left", **more: Any) -> Any:
    """Return np.searchsorted(points, x)."""
    return place_in(increasing(points, "np.searchsorted"), x, side)


def increasing(points: Any, name: str) -> np.ndarray:
    """Return points as numbers; refuse to look among others than increasing ones."""
    points = np.asarray(points, dtype=float)
    if np.any(np.diff(points) < 0.0):
        raise Unread(f"{name} of points that do not increase")
    return points


def interpolated(
    x: Any, xp: Any, fp: Any, left: Any = None, right: Any = None, period: Any = None
) -> Any:
    """Return np.interp(x, xp, fp), its constant ends as two more straight lines."""
    known = numbers_of(fp) if isinstance(fp, Array) else np.asarray(fp, dtype=float)
    ys = fp if known is None else known
    if period is not None:
        order = np.argsort(xp := np.asarray(xp, dtype=float) % period)
        xp, ys, x = xp[order], ys[order], np.remainder(x, period)
        xp = np.concatenate([xp[-1:] - period, xp, xp[:1] + period])
        ys = np.concatenate([ys[-1:], ys, ys[:1]])
    xp = increasing(xp, "np.interp")
    inner = "kinks" if isinstance(ys, Array) else joints_of(xp, [slopes(xp, ys), ys[:-1]])
    k = place_in(xp, x, joints=inner if left is None else "jumps")
    first = ys[:1] if left is None else np.full(1, float(left))
    flat = np.zeros(1)
    slope = lookup(np.concatenate([flat, slopes(xp, ys), flat]), k)
    values = slope * (x - lookup(np.append(xp[:1], xp), k)) + lookup(np.concatenate([first, ys]), k)
    return outside(values, x, xp, None, right)


def outside(values: Any, x: Any, xs: np.ndarray, below: Any, above: Any) -> Any:
    """Return values, with others below and above the points where these are given."""
    if above is not None:
        values = where(np.greater(x, xs[-1]), above, values)
    return values if below is None else where(np.less(x, xs[0]), below, values)


# --- SciPy's ------------------------------------------------------------------------------------


def of_pieces(
    xs: np.ndarray, c: np.ndarray, ends: Any, side: str = "right", domain: Any = None
) -> Callable:
    """Return polynomials between points as a function of signals: c by power, piece, column."""
    tail, edges = c.shape[2:], xs if domain is None else domain
    columns = np.moveaxis(c.reshape(*c.shape[:2], -1), 2, 0)

    def table(tape: Tape, x: Any) -> Any:
        x = lifted(tape, x)
        values = [outside(pieces(xs, rows, x, side), x, edges, *ends) for rows in columns]
        if not tail:
            return values[0]
        return np.moveaxis(np.stack(values), 0, -1).reshape((*x.shape, *tail))

    return table


STEPS: dict[str, Callable] = {  # where interp1d of a kind steps from one value to the next
    **dict.fromkeys(("nearest", "nearest-up"), lambda xs: (xs[1:] + xs[:-1]) / 2.0),
    "next": lambda xs: xs[:-1],
    **dict.fromkeys(("previous", "zero"), lambda xs: xs[1:]),
}


def of_interp1d(f: Any) -> Callable:
    """Return scipy.interpolate.interp1d as a function of signals."""
    from scipy.interpolate import PPoly

    xs, ys = np.asarray(f.x, dtype=float), np.moveaxis(np.asarray(f.y, dtype=float), f.axis, 0)
    ends: Any = (None, None)
    if not f._extrapolate:
        fill = f.fill_value if isinstance(f.fill_value, tuple) else (f.fill_value,) * 2
        if any(np.size(one) > 1 for one in fill):
            raise Unread("scipy's interp1d with a fill_value for each column")
        ends = [np.nan if f.bounds_error else float(np.ravel(one)[0]) for one in fill]
    if f._kind == "linear":
        return of_pieces(xs, np.stack([slopes(xs, ys), ys[:-1]]), ends, "left")
    if f._kind == "spline":
        of = [PPoly.from_spline((f._spline.t, c, f._spline.k)) for c in f._spline.c.T]
        c = np.stack([one.c for one in of], axis=-1)
        return of_pieces(of[0].x, c.reshape(*c.shape[:2], *ys.shape[1:]), ends, domain=xs)
    side = "right" if f._kind in ("previous", "zero", "nearest-up") else "left"
    return of_pieces(np.array([0.0, *STEPS[f._kind](xs), 0.0]), ys[None], ends, side, xs)


def of_polynomials(f: Any) -> Callable:
    """Return a piecewise polynomial of SciPy, such as CubicSpline, as a function of signals."""
    xs = np.asarray(f.x, dtype=float)
    if f.c.dtype.kind != "f" or f.axis:
        raise Unread(f"scipy's {type(f).__name__} of complex numbers, or along another axis")
    ends = (None, None) if f.extrapolate else (np.nan, np.nan)

    def table(tape: Tape, x: Any, nu: int = 0) -> Any:
        if f.extrapolate == "periodic":
            x = xs[0] + (lifted(tape, x) - xs[0]) % (xs[-1] - xs[0])
        return of_pieces(xs, f.derivative(nu).c if nu else f.c, ends)(tape, x)

    return table


def of_grid(f: Any) -> Callable:
    """Return scipy.interpolate.RegularGridInterpolator as a function of signals."""
    grid, ys = [np.asarray(one, dtype=float) for one in f.grid], np.asarray(f.values)
    if f.method != "linear" or ys.ndim != len(grid) or ys.dtype.kind not in "fiu":
        raise Unread("scipy's RegularGridInterpolator that is not linear, or of several columns")
    ends = np.nan if f.bounds_error else f.fill_value

    def table(tape: Tape, given: Any) -> Any:
        x = lifted(tape, list(given) if isinstance(given, tuple) else given)
        if isinstance(given, tuple):  # of one array along each axis
            x = np.moveaxis(x, 0, -1)
        elif x.ndim < 2:
            x = x.reshape(-1, len(grid))
        total: Any = 0.0
        along = [x[..., k] for k in range(len(grid))]
        places = [
            place_in(xs[1:-1], own, joints="kinks") for xs, own in zip(grid, along, strict=True)
        ]
        for corner in np.ndindex(*[2] * len(grid)):
            place: Any = 0.0
            share: Any = 1.0
            for xs, own, k, upper in zip(grid, along, places, corner, strict=True):
                part = (own - lookup(xs, k)) / lookup(np.diff(xs), k)
                share = share * (part if upper else 1.0 - part)
                place = place * len(xs) + k + upper
            total = total + lookup(ys.ravel(), place) * share
        for xs, own in zip(grid, along, strict=True):
            total = outside(total, own, xs, ends, ends)
        return total

    return table


def point(tape: Tape, *x: Any) -> Any:
    """Return coordinates, given one by one or as a vector, as a vector."""
    return lifted(tape, x[0] if len(x) == 1 else list(x)).reshape(-1)


def of_simplices(f: Any) -> Callable:
    """Return scipy.interpolate.LinearNDInterpolator as a function of signals; NaN outside."""
    corners, tail = f.tri.simplices, tuple(f.values_shape)
    ys = np.asarray(f.values, dtype=float).reshape(len(f.values), *tail)
    if len(corners) > MOST or f.scale is not None:
        raise Unread(f"scipy's LinearNDInterpolator of more than {MOST} simplices, or rescaled")

    def table(tape: Tape, *given: Any) -> Any:
        x = point(tape, *given)
        values: Any = np.full(tail, f.fill_value) if tail else float(f.fill_value)
        for own, inverse in zip(corners[::-1], f.tri.transform[::-1], strict=True):
            shares = [row @ (x - inverse[-1]) for row in inverse[:-1]]
            shares.append(1.0 - reduce(add, shares))
            inside = reduce(and_, [share >= -1e-12 for share in shares])
            value = reduce(add, [share * ys[k] for share, k in zip(shares, own, strict=True)])
            values = where(inside, value, values)
        return values[None]

    return table


def of_nearest(f: Any) -> Callable:
    """Return scipy.interpolate.NearestNDInterpolator as a function of signals."""
    points, ys = np.asarray(f.tree.data, dtype=float), np.asarray(f.values, dtype=float)
    if len(points) > MOST or f.scale is not None:
        raise Unread(f"scipy's NearestNDInterpolator of more than {MOST} points, or rescaled")

    def table(tape: Tape, *given: Any) -> Any:
        x = point(tape, *given)
        near, values = np.sum((x - points[0]) ** 2), ys[0]
        for one, y in zip(points[1:], ys[1:], strict=True):
            distance = np.sum((x - one) ** 2)
            closer = distance < near
            near, values = where(closer, distance, near), where(closer, y, values)
        return values[None]

    return table


POLYNOMIALS = ("CubicSpline", "PchipInterpolator", "Akima1DInterpolator", "PPoly")
TABLES: dict[str, Callable[[Any], Callable]] = {
    "interp1d": of_interp1d,
    **dict.fromkeys(POLYNOMIALS, of_polynomials),
    "RegularGridInterpolator": of_grid,
    "LinearNDInterpolator": of_simplices,
    "NearestNDInterpolator": of_nearest,
}


def is_table(value: Any) -> bool:
    """Return whether a value is one of SciPy's interpolators."""
    kind = type(value)
    return kind.__name__ in TABLES and kind.__module__.startswith("scipy.interpolate.")


def function_of(value: Any) -> Callable | None:
    """Return an interpolator as a function of signals; None for any other value."""
    if not is_table(value):
        return None
    table = cache(lambda: TABLES[type(value).__name__](value))
    return lambda tape, *x, **more: boxed(tape, table()(tape, *x, **more))
