"""Tables in equations: `lookup`, np.interp, and interpolators of SciPy.

    index = search(points, x)        number of inner points that are not above x, by bisection
    value = c[0][index] s + c[1][index],    s = x - points[index]

python-control's gain schedules use SciPy's LinearNDInterpolator and NearestNDInterpolator.  Other
interpolators run in Python.
"""

from collections.abc import Callable
from functools import cache, reduce
from math import factorial
from operator import add
from typing import Any

import numpy as np

from ...base.arguments import brief, public
from ...base.errors import ArgumentError
from ..record.graph import picked, reached
from ..record.unread import Unread
from .arrays import Array, Tape, numbers_of, operand
from .elementwise import boxed, lifted, where

SMOOTH = 3e-9  # relative to the largest number: smaller differences of polynomials are rounding
MOST = 64  # simplices, or points in more than one dimension
Table = Callable[..., Any]  # tape, signals -> values


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
    tape = next((a._tape for a in (table, index) if isinstance(a, Array)), None)
    if tape is None:
        try:
            return picked(
                np.asarray(table, dtype=float), np.asarray(index, dtype=float)
            )[()]
        except (TypeError, ValueError):
            raise ArgumentError(
                f"lookup: table = {brief(table)}, index = {brief(index)}: must be a row of numbers "
                "and a place"
            ) from None
    row = lifted(tape, table)
    return tape.add("pick", [operand(row), operand(index)], getattr(index, "shape", ()))


# --- search, and piecewise polynomials -----------------------------------------------------------


def place_in(points: Any, x: Any, side: Any = "right", joints: str = "jumps") -> Any:
    """Return np.searchsorted(points, x, side).

    Values read at this index have `joints` at the points: "jumps", "kinks", or "smooth" ones, which
    need no event of the integrator.
    """
    if not isinstance(x, Array):
        return float(np.searchsorted(points, x, side))
    row = lifted(x._tape, points)
    index = x._tape.add("search", (operand(row), operand(x)), x.shape, (side, joints))
    index._whole = True
    return index


def searched(points: Any, x: Any, side: str = "left", **options: Any) -> Any:
    """Return np.searchsorted(points, x, side)."""
    return place_in(_increasing(points, "np.searchsorted"), x, side)


def _increasing(points: Any, name: str) -> np.ndarray:
    """Return points as numbers; refuse points that do not increase."""
    points = np.asarray(points, dtype=float)
    if np.any(np.diff(points) < 0.0):
        raise Unread(f"{name} of points that do not increase")
    return points


def _horner(coefficients, s):
    return reduce(lambda value, c: value * s + c, coefficients)


def _polynomial(
    points: Any, coefficients: Any, x: Any, side: str = "right", joints: str = ""
) -> Any:
    """Return a piecewise polynomial at x; its first and last piece extend to infinity."""
    joints = joints or joints_of(points, coefficients)
    index = place_in(points[1:-1], x, side, joints)
    s = x - lookup(points, index)
    return _horner([lookup(row, index) for row in coefficients], s)


def joints_of(points: np.ndarray, coefficients: Any) -> str:
    """Return "jumps", "kinks" or "smooth": a piecewise polynomial at its inner points.

    Two neighbouring pieces are one smooth curve, except for rounding, if they agree at the end of
    the second piece too.  The curve differs from both by an eighth of their distance there.
    """
    steps = np.diff(points)
    size = np.max(np.abs(coefficients[-1]), initial=0.0)
    before = [row[:-1] for row in coefficients]
    after = [row[1:] for row in coefficients]
    if not np.allclose(
        _horner(before, steps[:-1]), coefficients[-1][1:], 1e-12, 1e-12 * size
    ):
        return "jumps"
    distance = _horner(before, steps[:-1] + steps[1:]) - _horner(after, steps[1:])
    return "smooth" if np.all(np.abs(distance) <= 8.0 * SMOOTH * size) else "kinks"


def _slopes(points: np.ndarray, values: Any) -> Any:
    """Return the slopes of straight lines between points; 0 between two equal points."""
    steps = np.diff(points).reshape(-1, *[1] * (values.ndim - 1))
    if isinstance(steps, Array):
        return np.diff(values) / steps
    return (values[1:] - values[:-1]) / np.where(steps > 0.0, steps, np.inf)


def _outside(values: Any, x: Any, points: np.ndarray, below: Any, above: Any) -> Any:
    """Return values, replaced below and above the points unless `below` or `above` is None."""
    if above is not None:
        values = where(np.greater(x, points[-1]), above, values)
    return values if below is None else where(np.less(x, points[0]), below, values)


def interpolated(x, xp, fp, left=None, right=None, period=None):
    """Return np.interp(x, xp, fp); its constant ends are two more straight lines."""
    xp, values = _with_numbers(xp), _with_numbers(fp)
    if period is not None:
        xp = np.asarray(xp, dtype=float) % period
        order = np.argsort(xp)
        xp = xp[order]
        values = values[order]
        x = np.remainder(x, period)
        xp = np.concatenate([xp[-1:] - period, xp, xp[:1] + period])
        values = np.concatenate([values[-1:], values, values[:1]])
    if not (isinstance(xp, Array) and isinstance(x, Array) and _may_vary(xp, x)):
        xp = _increasing(xp, "np.interp")
    slopes = _slopes(xp, values)
    are_numbers = not isinstance(xp, Array) and not isinstance(values, Array)
    joints = joints_of(xp, [slopes, values[:-1]]) if are_numbers else "kinks"
    flat = np.zeros(1)
    below = values[:1] if left is None else np.full(1, float(left))
    lines = np.concatenate([flat, slopes, flat]), np.concatenate([below, values])
    points = np.concatenate([xp[:1], xp, xp[-1:]])
    value = _polynomial(points, lines, x, joints=joints if left is None else "jumps")
    return _outside(value, x, xp, None, right)


def _with_numbers(array: Any) -> Any:
    """Return a constant array as numbers, signals as they are."""
    if not isinstance(array, Array):
        return np.asarray(array, dtype=float)
    numbers = numbers_of(array)
    return array if numbers is None else numbers


def _may_vary(points: Array, x: Array) -> bool:
    """Return whether points are parameters, and x is more than time, which stops at numbers."""
    tape = x._tape
    lines = [tape.operations[k] for k in reached(tape.operations, [operand(x)])]
    groups = {line.at[0] for line in lines if line.kind == "leaf"}
    return not tape.free[operand(points)] and not groups.isdisjoint("xu")


# --- SciPy's interpolators -----------------------------------------------------------------------


def _of_pieces(
    points: np.ndarray,
    c: np.ndarray,
    ends: tuple[Any, Any],
    side: str = "right",
    axis: int = 0,
) -> Table:
    """Return a piecewise polynomial: coefficients c by power, piece and column."""
    shape = c.shape[2:]
    columns = np.moveaxis(c.reshape(*c.shape[:2], -1), 2, 0)
    below, above = (np.broadcast_to(np.ravel(end), len(columns)) for end in ends)

    def table(tape: Tape, x: Any) -> Any:
        x = lifted(tape, x)
        values = [
            _outside(_polynomial(points, column, x, side), x, points, *limits)
            for column, *limits in zip(columns, below, above, strict=True)
        ]
        rows = np.stack(values, -1).reshape((*x.shape, *shape))
        return np.moveaxis(rows, range(x.ndim), range(axis, axis + x.ndim))

    return table


def _of_interp1d(f: Any) -> Table:
    """Return scipy.interpolate.interp1d as a function of signals."""
    points = np.asarray(f.x, dtype=float)
    values = np.moveaxis(np.asarray(f.y, dtype=float), f.axis, 0)
    if f._extrapolate or f.bounds_error:
        ends = (None if f._extrapolate else np.nan,) * 2
    else:
        ends = f._fill_value_below, f._fill_value_above
    side = "left" if f._kind in ("linear", "nearest", "next") else "right"
    if f._kind == "linear":
        c = np.stack([_slopes(points, values), values[:-1]])
    elif f._kind == "spline":
        t, _, k = f._spline.tck
        points = t[k : len(t) - k]
        powers = [
            f._spline(points[:-1], order) / factorial(order)
            for order in range(k, -1, -1)
        ]
        c = np.reshape(powers, (k + 1, -1, *values.shape[1:]))
    else:
        inner = points[:-1] if f._kind == "next" else points[1:]
        inner = getattr(f, "x_bds", inner)  # of the nearest point
        points = np.array([points[0], *inner, points[-1]])
        c = values[None]
    return _of_pieces(points, c, ends, side, f.axis)


def _of_polynomials(f: Any) -> Table:
    """Return a piecewise polynomial of SciPy, such as CubicSpline, as a function of signals."""
    name = type(f).__name__
    if f.c.dtype.kind != "f":
        raise Unread(f"scipy's {name} of complex numbers")
    if f.extrapolate == "periodic":
        raise Unread(
            f"scipy's {name} that is periodic. Use the remainder of its argument"
        )
    ends = (None if f.extrapolate else np.nan,) * 2
    table = _of_pieces(np.asarray(f.x, float), f.c, ends, axis=f.axis)
    return lambda tape, x, nu=0: (_of_polynomials(f.derivative(nu)) if nu else table)(
        tape, x
    )


def _points(tape: Tape, count: int, *coordinates: Any) -> Any:
    """Return points; the last axis has their coordinates, which may be in a tuple."""
    point = coordinates[0] if len(coordinates) == 1 else coordinates
    if isinstance(point, tuple):
        return np.moveaxis(lifted(tape, list(point)), 0, -1)
    x = lifted(tape, point)
    return x if x.ndim > 1 else x.reshape(-1, count)


def _of_grid(f: Any) -> Table:
    """Return scipy.interpolate.RegularGridInterpolator as a function of signals."""
    grid = [np.asarray(points, dtype=float) for points in f.grid]
    values = np.asarray(f.values)
    if (
        f.method != "linear"
        or values.ndim != len(grid)
        or values.dtype.kind not in "fiu"
    ):
        raise Unread(
            "scipy's RegularGridInterpolator that is not linear, or of several columns"
        )
    end = np.nan if f.bounds_error else f.fill_value

    def table(tape: Tape, *coordinates: Any) -> Any:
        x = _points(tape, len(grid), *coordinates)
        # the value is a weighted mean of the corners of the cell
        corners = [(1.0, 0.0)]  # weight and offset in the values
        for k, points in enumerate(grid):
            index = place_in(points[1:-1], x[..., k], joints="kinks")
            step = lookup(np.diff(points), index)
            share = (x[..., k] - lookup(points, index)) / step
            corners = [
                (weight * portion, offset * len(points) + index + upper)
                for weight, offset in corners
                for upper, portion in enumerate((1.0 - share, share))
            ]
        total = reduce(
            add, [lookup(values.ravel(), offset) * weight for weight, offset in corners]
        )
        for k, points in enumerate(grid):
            total = _outside(total, x[..., k], points, end, end)
        return total

    return table


def _of_scattered(f: Any, count: int, cells: str, value_at: Callable) -> Table:
    """Return an interpolator of scattered points by its value at a vector."""
    if count > MOST or f.scale is not None:
        raise Unread(
            f"scipy's {type(f).__name__} of more than {MOST} {cells}, or rescaled"
        )

    def table(tape: Tape, *coordinates: Any) -> Any:
        x = _points(tape, f.points.shape[1], *coordinates)
        values = value_at(x.reshape(-1))
        return np.reshape(values, (*x.shape[:-1], *np.shape(values)))

    return table


def _of_simplices(f: Any) -> Table:
    """Return scipy.interpolate.LinearNDInterpolator as a function of signals."""
    ys = np.asarray(f.values, dtype=float).reshape(-1, *f.values_shape)

    def value_at(x: Any) -> Any:
        value = np.full(f.values_shape, f.fill_value)[()]
        cells = zip(f.tri.simplices[::-1], f.tri.transform[::-1], strict=True)
        for corners, inverse in cells:
            weights = inverse[:-1] @ (x - inverse[-1])
            weights = np.append(weights, 1.0 - np.sum(weights))
            value = where(
                np.all(weights >= -1e-12), np.tensordot(weights, ys[corners], 1), value
            )
        return value

    return _of_scattered(f, len(f.tri.simplices), "simplices", value_at)


def _of_nearest(f: Any) -> Table:
    """Return scipy.interpolate.NearestNDInterpolator as a function of signals."""

    def value_at(x: Any) -> Any:
        nearest = np.argmin(np.sum((x - f.points) ** 2, axis=-1))
        return lifted(x._tape, np.asarray(f.values, dtype=float))[nearest]

    return _of_scattered(f, len(f.points), "points", value_at)


TABLES: dict[str, Callable[[Any], Table]] = {
    "interp1d": _of_interp1d,
    "Akima1DInterpolator": _of_polynomials,
    "CubicHermiteSpline": _of_polynomials,
    "CubicSpline": _of_polynomials,
    "PPoly": _of_polynomials,
    "PchipInterpolator": _of_polynomials,
    "RegularGridInterpolator": _of_grid,
    "LinearNDInterpolator": _of_simplices,
    "NearestNDInterpolator": _of_nearest,
}


def is_table(value: Any) -> bool:
    """Return whether a value is one of SciPy's interpolators."""
    kind = type(value)
    return kind.__name__ in TABLES and kind.__module__.startswith("scipy.interpolate.")


def function_of(value: Any) -> Table | None:
    """Return an interpolator as a function of signals; None for any other value."""
    if not is_table(value):
        return None
    table = cache(lambda: TABLES[type(value).__name__](value))
    return lambda tape, *x, **options: boxed(tape, table()(tape, *x, **options))
