"""Tables in equations: `lookup`, np.interp, and interpolators of SciPy.

    index = search(points, x)        number of inner points that are not above x, by bisection
    value = c[0][index] s + c[1][index],    s = x - points[index]

python-control's gain schedules use SciPy's LinearNDInterpolator and NearestNDInterpolator.  Other
interpolators run in Python.
"""

from collections.abc import Callable
from functools import cache, reduce
from operator import add, and_
from typing import Any

import numpy as np

from ...base.arguments import brief, public
from ...base.errors import ArgumentError
from ..record.graph import picked
from .arrays import Array, Tape, Unread, numbers_of, operand
from .elementwise import boxed, constant, lifted, where

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
    points = np.asarray(points, dtype=float)
    if not isinstance(x, Array):
        return float(np.searchsorted(points, x, side))
    row = constant(x._tape, points)
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


def _polynomial(points: Any, coefficients: Any, x: Any, side: str = "right") -> Any:
    """Return a piecewise polynomial at x; its first and last piece extend to infinity."""
    index = place_in(points[1:-1], x, side, joints_of(points, coefficients))
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
    return (values[1:] - values[:-1]) / np.where(steps > 0.0, steps, np.inf)


def _outside(values: Any, x: Any, points: np.ndarray, below: Any, above: Any) -> Any:
    """Return values, replaced below and above the points unless `below` or `above` is None."""
    if above is not None:
        values = where(np.greater(x, points[-1]), above, values)
    return values if below is None else where(np.less(x, points[0]), below, values)


def interpolated(x, xp, fp, left=None, right=None, period=None):
    """Return np.interp(x, xp, fp); its constant ends are two more straight lines."""
    numbers = numbers_of(fp) if isinstance(fp, Array) else np.asarray(fp, dtype=float)
    values = fp if numbers is None else numbers
    if period is not None:
        xp = np.asarray(xp, dtype=float) % period
        order = np.argsort(xp)
        xp = xp[order]
        values = values[order]
        x = np.remainder(x, period)
        xp = np.concatenate([xp[-1:] - period, xp, xp[:1] + period])
        values = np.concatenate([values[-1:], values, values[:1]])
    xp = _increasing(xp, "np.interp")
    slopes = _slopes(xp, values)
    joints = (
        "kinks" if isinstance(values, Array) else joints_of(xp, [slopes, values[:-1]])
    )
    index = place_in(xp, x, joints=joints if left is None else "jumps")
    flat = np.zeros(1)
    slope = lookup(np.concatenate([flat, slopes, flat]), index)
    start = lookup(np.append(xp[:1], xp), index)
    below = values[:1] if left is None else np.full(1, float(left))
    value = slope * (x - start) + lookup(np.concatenate([below, values]), index)
    return _outside(value, x, xp, None, right)


# --- SciPy's interpolators -----------------------------------------------------------------------


def _of_pieces(
    points: np.ndarray,
    c: np.ndarray,
    ends: Any,
    side: str = "right",
    domain: Any = None,
) -> Table:
    """Return a piecewise polynomial: coefficients c by power, piece and column."""
    columns = np.moveaxis(c.reshape(*c.shape[:2], -1), 2, 0)
    shape = c.shape[2:]
    limits = points if domain is None else domain

    def table(tape: Tape, x: Any) -> Any:
        x = lifted(tape, x)
        values = [
            _outside(_polynomial(points, column, x, side), x, limits, *ends)
            for column in columns
        ]
        if not shape:
            return values[0]
        return np.moveaxis(np.stack(values), 0, -1).reshape((*x.shape, *shape))

    return table


STEPS: dict[
    str, Callable
] = {  # points at which interp1d of a kind steps to the next value
    **dict.fromkeys(
        ("nearest", "nearest-up"), lambda points: (points[1:] + points[:-1]) / 2.0
    ),
    "next": lambda points: points[:-1],
    **dict.fromkeys(("previous", "zero"), lambda points: points[1:]),
}


def _of_interp1d(f: Any) -> Table:
    """Return scipy.interpolate.interp1d as a function of signals."""
    from scipy.interpolate import PPoly

    points = np.asarray(f.x, dtype=float)
    values = np.moveaxis(np.asarray(f.y, dtype=float), f.axis, 0)
    ends: Any = (None, None)
    if not f._extrapolate:
        fill = f.fill_value if isinstance(f.fill_value, tuple) else (f.fill_value,) * 2
        if any(np.size(value) > 1 for value in fill):
            raise Unread("scipy's interp1d with a fill_value for each column")
        ends = [
            np.nan if f.bounds_error else float(np.ravel(value)[0]) for value in fill
        ]
    if f._kind == "linear":
        return _of_pieces(
            points, np.stack([_slopes(points, values), values[:-1]]), ends, "left"
        )
    if f._kind == "spline":
        t = f._spline.t
        k = f._spline.k
        splines = [PPoly.from_spline((t, column, k)) for column in f._spline.c.T]
        c = np.stack([spline.c for spline in splines], axis=-1)
        c = c.reshape(*c.shape[:2], *values.shape[1:])
        return _of_pieces(splines[0].x, c, ends, domain=points)
    steps = np.array([0.0, *STEPS[f._kind](points), 0.0])
    side = "right" if f._kind in ("previous", "zero", "nearest-up") else "left"
    return _of_pieces(steps, values[None], ends, side, points)


def _of_polynomials(f: Any) -> Table:
    """Return a piecewise polynomial of SciPy, such as CubicSpline, as a function of signals."""
    name = type(f).__name__
    if f.c.dtype.kind != "f" or f.axis:
        raise Unread(f"scipy's {name} of complex numbers, or along another axis")
    if f.extrapolate == "periodic":
        raise Unread(
            f"scipy's {name} that is periodic. Use the remainder of its argument"
        )
    table = _of_pieces(
        np.asarray(f.x, float), f.c, (None if f.extrapolate else np.nan,) * 2
    )

    def of_values(tape: Tape, x: Any, nu: int = 0) -> Any:
        if nu:
            raise Unread(
                f"derivatives of scipy's {name}. Call its `derivative` before the run"
            )
        return table(tape, x)

    return of_values


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

    def table(tape: Tape, arguments: Any) -> Any:
        # the coordinates of a point are the last axis
        x = lifted(tape, list(arguments) if isinstance(arguments, tuple) else arguments)
        if isinstance(arguments, tuple):
            x = np.moveaxis(x, 0, -1)
        elif x.ndim < 2:
            x = x.reshape(-1, len(grid))
        axes = [(points, x[..., k]) for k, points in enumerate(grid)]
        indices = [
            place_in(points[1:-1], coordinate, joints="kinks")
            for points, coordinate in axes
        ]
        # the value is a weighted mean of the corners of the cell
        total: Any = 0.0
        for corner in np.ndindex(*[2] * len(grid)):
            position: Any = 0.0
            weight: Any = 1.0
            for (points, coordinate), index, upper in zip(
                axes, indices, corner, strict=True
            ):
                fraction = (coordinate - lookup(points, index)) / lookup(
                    np.diff(points), index
                )
                weight = weight * (fraction if upper else 1.0 - fraction)
                position = position * len(points) + index + upper
            total = total + lookup(values.ravel(), position) * weight
        for points, coordinate in axes:
            total = _outside(total, coordinate, points, end, end)
        return total

    return table


def _vector(tape: Tape, *x: Any) -> Any:
    """Return coordinates, given one by one or as a vector, as a vector."""
    return lifted(tape, x[0] if len(x) == 1 else list(x)).reshape(-1)


def _of_simplices(f: Any) -> Table:
    """Return scipy.interpolate.LinearNDInterpolator as a function of signals; NaN outside."""
    simplices = f.tri.simplices
    shape = tuple(f.values_shape)
    ys = np.asarray(f.values, dtype=float).reshape(len(f.values), *shape)
    if len(simplices) > MOST or f.scale is not None:
        raise Unread(
            f"scipy's LinearNDInterpolator of more than {MOST} simplices, or rescaled"
        )

    def table(tape: Tape, *coordinates: Any) -> Any:
        x = _vector(tape, *coordinates)
        values: Any = np.full(shape, f.fill_value) if shape else float(f.fill_value)
        for corners, inverse in zip(
            simplices[::-1], f.tri.transform[::-1], strict=True
        ):
            weights = [row @ (x - inverse[-1]) for row in inverse[:-1]]
            weights.append(1.0 - reduce(add, weights))
            inside = reduce(and_, [weight >= -1e-12 for weight in weights])
            terms = [weight * ys[k] for weight, k in zip(weights, corners, strict=True)]
            values = where(inside, reduce(add, terms), values)
        return values[None]

    return table


def _of_nearest(f: Any) -> Table:
    """Return scipy.interpolate.NearestNDInterpolator as a function of signals."""
    points = np.asarray(f.tree.data, dtype=float)
    ys = np.asarray(f.values, dtype=float)
    if len(points) > MOST or f.scale is not None:
        raise Unread(
            f"scipy's NearestNDInterpolator of more than {MOST} points, or rescaled"
        )

    def table(tape: Tape, *coordinates: Any) -> Any:
        x = _vector(tape, *coordinates)
        least = np.sum((x - points[0]) ** 2)
        values = ys[0]
        for point, y in zip(points[1:], ys[1:], strict=True):
            distance = np.sum((x - point) ** 2)
            is_nearer = distance < least
            least = where(is_nearer, distance, least)
            values = where(is_nearer, y, values)
        return values[None]

    return table


TABLES: dict[str, Callable[[Any], Table]] = {
    "interp1d": _of_interp1d,
    "Akima1DInterpolator": _of_polynomials,
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
