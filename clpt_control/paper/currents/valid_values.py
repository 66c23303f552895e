"""Numbers of a current: valid ranges, undeclared fill values and units.

Values outside `valid_range`, or `valid_min` to `valid_max`, are gaps.  In a packed variable
these attributes are packed integers if they are integers, and otherwise in the variable's units
(NetCDF User's Guide, appendix A).  A speed that no sea has is refused.
"""

from collections.abc import Sequence

import numpy as np
import xarray

from ...base.errors import DataError
from ...base.units import speed_in_metres_per_second

FASTEST = 9.9  # m/s; the sea is slower, a fill value taken as data, 999 cm/s, is not
FAR = 0.3  # of the range of all other values: distance of a fill value from them
DISTINCT = 8  # other values, by which a fill value is recognized


def numbers_of(variable: xarray.DataArray) -> np.ndarray:
    """Return a variable's values as floats; characters and ragged rows are refused."""
    # where rows are ragged, the variable says numbers and these do not
    values = variable.values
    if values.dtype.kind not in "iuf":
        raise DataError(f"{variable.name} has the type {values.dtype}; must be numbers")
    return values.astype(float)


def mark_gaps(u: np.ndarray, v: np.ndarray, names: Sequence[str], nothing: str) -> None:
    """Set both components of a current, m/s, to NaN where one is missing.

    Gaps alone are refused, which `nothing` says, and a speed that no sea has.
    """
    gap = ~(np.isfinite(u) & np.isfinite(v))
    if gap.all():
        raise DataError(nothing)
    u[gap] = v[gap] = np.nan
    for name, values in zip(names, (u, v), strict=True):
        most = np.nanmax(np.abs(values))
        if most > FASTEST:
            raise DataError(
                f"{name} reaches {most:.4g} m/s: check its units and fill value"
            )
        check_fill_value(values, name)


def check_fill_value(values: np.ndarray, name: str) -> None:
    """Refuse a number that returns exactly, at the end of all values and far from them.

    It is taken for a fill value that the file does not declare.  Zeros are exempt: they are land.

    >>> check_fill_value(np.append(np.linspace(-0.3, 0.4, 20), [9.0] * 3), "u (m/s)")
    Traceback (most recent call last):
    clpt_control.DataError: u (m/s) is exactly 9 at 3 of 23 places, ...
    """
    finite = values[np.isfinite(values)]
    if not finite.size:
        return
    for end, sign in ((finite.max(), 1.0), (finite.min(), -1.0)):
        others = finite[finite != end]
        count = finite.size - others.size
        if end == 0.0 or count < 2 or np.unique(others[:10000]).size < DISTINCT:
            continue
        distance = sign * end - (sign * others).max()
        if distance > (FAR if count > 2 else 1.0) * np.ptp(others):
            raise DataError(
                f"{name} is exactly {end:.6g} at {count} of {finite.size} places, far from all "
                "other values: a fill value. Leave these values empty, or declare it as _FillValue"
            )


def speed_unit(stated: str | None, units: str | None, name: str, cure: str) -> float:
    """Return in m/s the unit that a file states of a speed, or `units` where it states none."""
    if not (stated_or_given := stated or units):
        raise DataError(f"{name} has no units. {cure}")
    size = speed_in_metres_per_second(stated_or_given, name)
    if (
        stated
        and units
        and speed_in_metres_per_second(units, "units=, --units") != size
    ):
        raise DataError(
            f"{name} is in '{stated}'; units = '{units}' is for a file without"
        )
    return size


def in_valid_range(
    values: xarray.DataArray, numbers: np.ndarray, name: str
) -> np.ndarray:
    """Return numbers, NaN outside the valid range of their variable."""
    attributes, packing = values.attrs, values.encoding
    bounds = np.array([-np.inf, np.inf])
    for key, limits in (
        ("valid_range", [0, 1]),
        ("valid_min", [0]),
        ("valid_max", [1]),
    ):
        if key not in attributes:
            continue
        stated = np.atleast_1d(attributes[key])
        if stated.dtype.kind not in "iuf" or stated.size != len(limits):
            raise DataError(
                f"{name}: {key} is {attributes[key]!r}; must be a number each"
            )
        packed = np.dtype(packing.get("dtype", float)).kind in "iu"
        if packed and stated.dtype.kind in "iu":
            stated = stated * float(packing.get("scale_factor", 1.0))
            stated = stated + float(packing.get("add_offset", 0.0))
        bounds[limits] = stated
    low, high = bounds
    with np.errstate(invalid="ignore"):
        outside = (numbers < low) | (numbers > high)
    if 2 * outside.sum() > np.isfinite(numbers).sum():
        raise DataError(
            f"{name} has {outside.sum()} values outside its valid range, {low:g} to {high:g}: "
            "correct valid_range (valid_min, valid_max) or the values"
        )
    return np.where(outside, np.nan, numbers)
