"""Find velocities, coordinates, times and units in a NetCDF file.

Names follow the CF standard name table (cfconventions.org); a file without
standard names is read by the names that are common in practice.

Values outside `valid_range`, or `valid_min` to `valid_max`, are gaps.  In a packed variable
these attributes are packed integers if they are integers, and otherwise in the variable's units
(NetCDF User's Guide, appendix A).  A speed that no sea has is refused.

Times of means are the middles of their intervals, which the bounds of the time give (CF 7.1).
The interval counts unless `cell_methods` says that values are of a point in time (CF 7.3).
"""

import re
import warnings
from collections.abc import Sequence
from typing import Any

import numpy as np
import xarray
from xarray.coders import CFDatetimeCoder

from ...base.errors import DataError
from ...base.units import length_in_metres, speed_in_metres_per_second
from .flags import number as number
from .flags import said as said
from .flags import without_flagged

VELOCITY = {
    "eastward": (
        ("eastward_sea_water_velocity", "surface_eastward_sea_water_velocity"),
        (
            "u_eastward",  # ROMS, beside u along the axes of its grid
            *(
                "u",
                "water_u",
                "uo",
                "u_velocity",
                "ucur",
                "u_current",
                "u_east",
                "usurf",
            ),
            "ua",  # FVCOM
        ),
    ),
    "northward": (
        ("northward_sea_water_velocity", "surface_northward_sea_water_velocity"),
        (
            "v_northward",
            *(
                "v",
                "water_v",
                "vo",
                "v_velocity",
                "vcur",
                "v_current",
                "v_north",
                "vsurf",
            ),
            "va",
        ),
    ),
}
AXES = {
    "latitude": (
        ("latitude",),
        ("lat", "latitude", "nav_lat", "y_lat", "lat_rho", "lat_u", "latc"),
    ),
    "longitude": (
        ("longitude",),
        ("lon", "longitude", "nav_lon", "x_lon", "lon_rho", "lon_u", "lonc"),
    ),
    "time": (("time",), ("time", "t", "ocean_time", "mtime")),
}
AXIS_NAMES = {name for _, names in AXES.values() for name in names}
HEIGHTS = ("altitude", "height")
DEPTHS = (*HEIGHTS, "depth", "ocean_s_coordinate")
DEPTH_NAMES = (
    "depth",
    "z",
    "lev",
    "level",
    "altitude",
    "s_rho",
    "deptht",
    "depthu",
    "sigma",
    "siglay",
    "height_above_sensor",  # IMOS
)
CURE = (
    "regrid it to latitudes and longitudes, by cdo remapbil or xESMF, and turn u and v to east and "
    "north first: on such a grid they may lie along its own axes"
)
PROJECTED = ("projection_x_coordinate", "projection_y_coordinate")
FASTEST = 9.9  # m/s; the sea is slower, a fill value taken as data, 999 cm/s, is not
ARTIFICIAL = ("noleap", "365_day", "all_leap", "366_day", "360_day", "none")
NO_CURRENT = (
    "maximum",
    "minimum",
    "range",
    "standard_deviation",
    "sum",
    "sum_of_squares",
    "variance",
)
GREGORIAN = (
    1582  # calendar reform: earlier, 'standard' and 'proleptic_gregorian' differ
)
FAR = 0.3  # of the range of all other values: distance of a fill value from them
DISTINCT = 8  # other values, by which a fill value is recognized
UTC = {"utc", "gmt", "z", "t"}  # t is that of ISO 8601
FIRST_YEAR = 1950  # earlier times of ocean data look like integers that overflowed
OVERFLOW = np.timedelta64(
    36525, "D"
)  # a step of 100 years is that of an integer that overflowed
SINCE_A_DATE = re.compile(r"\s*(\w+)\s+since\s+(\d+-\d+-\d+.*)", re.IGNORECASE)


def find_variable(data: xarray.Dataset, table: dict[str, Any], quantity: str) -> str:
    """Return the name of a variable of `VELOCITY` or `AXES`, by standard name and by name.

    One with both comes first, then one with the standard name, then one with the name; a wind is
    no current, whatever its name.
    """
    standard, names = table[quantity]
    named = {
        name: said(variable, "standard_name")
        for name, variable in data.variables.items()
    }
    by_standard = [name for name, variable in named.items() if variable in standard]
    by_name = [
        n
        for n, variable in named.items()
        if str(n).lower() in names and "wind" not in variable
    ]
    by_name.sort(key=lambda name: names.index(str(name).lower()))
    if candidates := [
        *(n for n in by_name if n in by_standard),
        *by_standard,
        *by_name,
    ]:
        return str(candidates[0])
    if table is AXES and any(variable in PROJECTED for variable in named.values()):
        raise DataError(f"has a projected grid, of x and y, and no {quantity}; {CURE}")
    kind = f"{quantity} velocity" if table is VELOCITY else quantity
    criteria = f"no standard_name '{standard[0]}' and none of {', '.join(names)}"
    remedy = ". Give --u and --v, or names=" if table is VELOCITY else ""
    raise DataError(
        f"no {kind}: {criteria} among {', '.join(map(str, data.variables))}{remedy}"
    )


def checked_name(data: xarray.Dataset, name: str) -> str:
    """Return the name of a variable that the user chose, or refuse an unknown one."""
    if name not in data.data_vars:
        raise DataError(
            f"no variable {name}; must be one of {', '.join(map(str, data.data_vars))}"
        )
    return name


def find_axis(data: xarray.Dataset, velocity: str, quantity: str) -> xarray.DataArray:
    """Return the coordinate, of one dimension that a velocity has, for a key of `AXES`.

    Of several times, such as `time` and `time1`, the one on a dimension of the velocity counts.
    """
    flow = data[velocity]
    if "mesh" in flow.attrs or "nele" in flow.dims:  # UGRID, FVCOM
        raise DataError(f"{velocity} {_dims(flow)} is on a triangular grid; {CURE}")
    name = find_variable(data, AXES, quantity)
    if quantity == "time" and not set(data[name].dims) & set(flow.dims):
        times = [
            dim for dim in flow.dims if dim in data and " since " in said(data[dim])
        ]
        name = str(times[0]) if times else name
    axis = data[name]
    if quantity == "time" and axis.ndim == 0:
        return axis.expand_dims(name)
    if quantity != "time" and axis.ndim == 2:
        raise DataError(
            f"{name} has the dimensions {_dims(axis)}: a curvilinear grid; {CURE}"
        )
    if axis.ndim != 1 or axis.dims[0] not in flow.dims:
        raise DataError(f"{name} is on {_dims(axis)}; must be on one of {_dims(flow)}")
    if quantity == "time":
        return axis
    if not axis.size:
        raise DataError(
            f"{name} has the length zero; must have at least one {quantity}"
        )
    most = 90.0 if quantity == "latitude" else 720.0
    degrees = numbers_of(axis)
    if not np.all(np.abs(degrees) <= most + 1e-6):  # also where not finite
        raise DataError(
            f"{name} reaches {np.abs(degrees).max():.6g}; must be a {quantity}, degrees"
        )
    return axis


def _dims(values: xarray.DataArray) -> str:
    return f"({', '.join(map(str, values.dims))})"


def is_depth(data: xarray.Dataset, dim: Any) -> bool:
    """Return whether a dimension has a coordinate that is a depth by its names."""
    if dim not in data.variables:
        return False
    by_standard = said(data[dim], "standard_name").startswith(DEPTHS)
    return str(dim).lower() in DEPTH_NAMES or by_standard


def depths_of(data: xarray.Dataset, dim: Any, in_metres: bool = True) -> np.ndarray:
    """Return depths of levels below the surface, m or in their unit.

    Heights above an instrument are subtracted from its depth; others from below are refused.
    """
    axis = data[dim]
    levels, unit = np.atleast_1d(numbers_of(axis)), said(axis)
    up = said(axis, "positive") == "up" or said(axis, "standard_name").startswith(
        HEIGHTS
    )
    if str(dim).lower() == "height_above_sensor":
        levels = _depth_of_sensor(data) - levels
    elif up and np.any(levels > 0):
        raise DataError(
            f"{axis.name} counts up from the sea floor; must be depths below water"
        )
    else:
        levels = np.abs(levels)
    if in_metres and (unit or not str(dim).lower().startswith(("depth", "z"))):
        return levels * length_in_metres(unit, str(dim))
    return levels


def _depth_of_sensor(data: xarray.Dataset) -> float:
    """Return the median depth of an instrument, m."""
    for name in map(str, data.variables):
        if name.lower() in ("depth", "nominal_depth"):
            return float(np.nanmedian(without_flagged(data, [name])[0]))
    raise DataError(
        "has heights above a sensor and no depth of the sensor. Write the variable DEPTH"
    )


def _level(data: xarray.Dataset, dim: Any, depth: float | None) -> tuple[int, str]:
    """Return the index of the level nearest the surface, or a depth in m, and a note on it."""
    depths = depths_of(data, dim, in_metres=depth is not None)
    away = np.where(depths >= 0, np.abs(depths - (depth or 0.0)), np.inf)
    level = int(
        np.argmin(away)
    )  # a level above water, or without a depth, is the last choice
    nearest = "the surface" if depth is None else f"{depth:g} m"
    unit = said(data[dim]).replace("1", "") if depth is None else "m"
    return level, (
        f"{dim} has {depths.size} levels: the level nearest {nearest} is read, "
        f"{depths[level]:.4g} {unit}".rstrip()
        + ". --depth (depth=) chooses by depth"
    )


def numbers_of(variable: xarray.DataArray) -> np.ndarray:
    """Return a variable's values as floats; characters and ragged rows are refused."""
    # where rows are ragged, the variable says numbers and these do not
    values = variable.values
    if values.dtype.kind not in "iuf":
        raise DataError(f"{variable.name} has the type {values.dtype}; must be numbers")
    return values.astype(float)


def decoded(
    numbers: np.ndarray, unit: str, calendar: str = "standard"
) -> np.ndarray | None:
    """Return dates of numbers such as hours since a date, by xarray, as datetime64 in ns.

    None where they are no dates, in calendars without real ones, such as of 360 days, and in years
    that ns cannot count.

    >>> decoded(np.array([36.0]), "hours since 2019-1-1")
    array(['2019-01-02T12:00:00.000000000'], dtype='datetime64[ns]')
    """
    matched = SINCE_A_DATE.fullmatch(unit)
    if matched is None:  # xarray would take 01/02/2019 too
        return None
    unit, since = matched.groups()
    # a bare date has no clock time that an offset could follow, and UTC+1 is read as UTC-1
    since = re.sub(r"^([\d-]+)\s+(?=[+-]\d)", r"\1 00:00 ", since)
    since = re.sub(r"\s*\b(?:UTC|GMT)\s*(?=[+-]\d)", " ", since, flags=re.IGNORECASE)
    zones = [
        zone for zone in re.findall(r"[A-Za-z_/]+", since) if zone.lower() not in UTC
    ]
    if zones:  # xarray leaves a zone's name out
        raise DataError(
            f"units '{matched[0]}' have the time zone {zones[0]}, whose offset is not known. Write "
            "UTC, or an offset such as -5:00"
        )
    unit = f"{unit} since {since}"  # xarray reads the word in small letters only
    variable = xarray.Variable("time", numbers, {"units": unit, "calendar": calendar})
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of years that ns cannot count
            dates = CFDatetimeCoder().decode(variable).values
    except (ValueError, TypeError, KeyError, OverflowError):
        return None
    return dates if dates.dtype.kind == "M" else None


def dates_of(
    data: xarray.Dataset,
    when: xarray.DataArray,
    velocity: str,
    notes: list[str],
    least: int = 2,
) -> np.ndarray:
    """Return the times of a velocity, to the nearest ms: of means the middles of intervals."""
    if len(when) < least:
        raise DataError(f"{when.name} has {len(when)} of the {least} required steps")
    _check_missing(when, ~np.isfinite(numbers_of(when)))
    numbers = when.values
    intervals = _intervals(data, when, velocity)
    if intervals is not None:
        numbers = intervals.mean(axis=1)
    dates = decoded(numbers, said(when), _calendar(when))
    if dates is None:
        raise DataError(
            f"{when.name} has units '{said(when)}' and the calendar '{_calendar(when)}'; must be "
            "such as 'hours since 2019-01-01 00:00:00', with real dates of the years 1678 to 2261"
        )
    _check_missing(when, np.isnat(dates))  # xarray writes NaT as the least integer
    steps = np.flatnonzero(np.abs(np.diff(dates)) > OVERFLOW)
    if steps.size:
        raise DataError(
            f"{when.name} goes from {dates[steps[0]]:.10} to {dates[steps[0] + 1]:.10} in one "
            "step: its integers overflowed. Write them as 64 bits"
        )
    years = dates.astype("M8[Y]").astype(int) + 1970
    if years.min() < FIRST_YEAR:
        notes.append(
            f"{when.name} is of the years {years.min()} to {years.max()}; if they are wrong, its "
            "integers overflowed: write them as 64 bits"
        )
    return (dates + np.timedelta64(500, "us")).astype("datetime64[ms]")


def _check_missing(when: xarray.DataArray, missing: np.ndarray) -> None:
    """Refuse times of which some are missing, with the remedy."""
    steps = np.flatnonzero(missing)
    if steps.size:
        raise DataError(
            f"{when.name} is not finite at {steps.size} of {len(when)} steps, first at step "
            f"{steps[0]} (from 0). Drop these steps, such as by xarray's "
            f"data.isel({when.dims[0]}=data.{when.name}.notnull())"
        )


def _calendar(when: xarray.DataArray) -> str:
    """Return the calendar of a time; one without real dates, or in doubt, is refused."""
    stated = when.attrs.get("calendar")
    calendar = "standard" if stated is None else str(stated).lower()
    if calendar in ARTIFICIAL:
        raise DataError(
            f"{when.name} has the calendar '{calendar}', whose dates are not real. Convert the "
            "file, such as by xarray's data.convert_calendar('standard', align_on='date')"
        )
    since = SINCE_A_DATE.fullmatch(said(when))
    if since and stated is None and int(since[2].split("-")[0]) < GREGORIAN:
        raise DataError(
            f"{when.name} has units '{said(when)}' and no calendar. Write the attribute calendar: "
            "'standard' or 'proleptic_gregorian', which differ by days before 1582"
        )
    return calendar


def _intervals(
    data: xarray.Dataset, when: xarray.DataArray, velocity: str
) -> np.ndarray | None:
    """Return the intervals of means over time, shape (n, 2), None for values at points in time."""
    method = _time_method(data[velocity], when)
    if method in NO_CURRENT:
        raise DataError(
            f"{velocity} has the cell_methods '{said(data[velocity], 'cell_methods')}'; must be "
            "currents, or their means over time"
        )
    if "climatology" in when.attrs:
        raise DataError(
            f"{when.name} has a climatology; must be the times of a current"
        )
    name = said(when, "bounds")
    if not name or name not in data or method == "point":
        return None
    units = said(data[name]) or said(when)
    intervals = np.sort(np.atleast_2d(numbers_of(data[name])), axis=-1)
    if intervals.shape != (len(when), 2) or units != said(when):
        raise DataError(
            f"{name}, the bounds of {when.name}, must have the shape ({len(when)}, 2) and its units"
        )
    start, end = intervals.T
    slack = 1e-3 * np.max(end - start)
    inside = (start - slack <= when.values) & (when.values <= end + slack)
    if not inside.all():  # also where not finite
        step = int(np.argmin(inside))
        raise DataError(
            f"{name} does not contain {when.name} at step {step} (from 0). Correct one of both"
        )
    return intervals


def _time_method(velocity: xarray.DataArray, when: xarray.DataArray) -> str:
    """Return the method by which a velocity represents its interval of time, '' if not stated.

    >>> time = xarray.DataArray([0.0], dims="time", name="time")
    >>> u = time.assign_attrs(cell_methods="area: mean time: point")
    >>> _time_method(u, time)
    'point'
    """
    methods = said(velocity, "cell_methods").lower()
    names = {"time", str(when.name).lower(), str(when.dims[0]).lower()}
    for axes, method in re.findall(r"((?:\w+:\s*)+)(\w+)", methods):
        if names & set(re.findall(r"\w+", axes)):
            return str(method)
    return ""


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
        distance = sign * (end - (sign * others).max() * sign)
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
    if stated and units and speed_in_metres_per_second(units, "--units") != size:
        raise DataError(
            f"{name} is in '{stated}'; units = '{units}' is for a file without"
        )
    return size


def velocity_values(
    data: xarray.Dataset,
    name: str,
    index: dict[Any, np.ndarray],
    units: str | None,
    notes: list[str],
    depth: float | None = None,
) -> np.ndarray:
    """Return a velocity in m/s, NaN where missing or flagged bad, at the `index` of each dimension.

    Of levels that are not among them the one nearest the surface, or nearest a depth (m), is taken.
    `units` are those of a variable that says none.  The level and the flags add to the notes.
    """
    values, levels = data[name], dict[Any, int]()
    cure = "Give --units, such as m/s, or write the attribute"
    size = speed_unit(said(values), units, name, cure)
    for dim in set(values.dims) - set(index):
        levels[dim] = 0
        if values.sizes[dim] != 1:
            if not is_depth(data, dim):
                raise DataError(
                    f"{name} has {values.sizes[dim]} {dim}. Choose one, --at LAT LON"
                )
            levels[dim], note = _level(data, dim, depth)
            notes.append(note)
    added = [dim for dim in index if dim not in values.dims]
    if any(dim not in data or data[dim].ndim for dim in added):
        raise DataError(
            f"{name} is on {_dims(values)}; must be on {', '.join(map(str, index))}"
        )

    def select(variable: xarray.DataArray) -> xarray.DataArray:
        variable = variable.isel(levels, missing_dims="ignore")
        return _in_one_block(
            variable, {d: index[d] for d in index if d in variable.dims}
        )

    try:
        chosen, flagged = without_flagged(
            data, [name, *_coordinates(data, name)], select
        )
    except (ValueError, TypeError):  # of letters that are to be scaled
        raise DataError(
            f"{name} has an entry that is not a number. Give numbers only"
        ) from None
    notes += flagged
    chosen = chosen.expand_dims(added).transpose(*index)
    numbers = numbers_of(chosen)
    return _in_valid_range(chosen, numbers, name) * size


def _coordinates(data: xarray.Dataset, name: str) -> list[str]:
    """Return the times, places and depths along dimensions of a velocity."""
    return [
        axis
        for axis in map(str, data.variables)
        if data[axis].ndim > 0
        and set(data[axis].dims) <= set(data[name].dims)
        and (axis.lower() in AXIS_NAMES or is_depth(data, axis))
    ]


def _in_valid_range(
    values: xarray.DataArray, numbers: np.ndarray, name: str
) -> np.ndarray:
    """Return numbers, NaN outside the valid range of their variable."""
    attributes, packing = values.attrs, values.encoding
    low, high = -np.inf, np.inf
    for key, limits in (
        ("valid_range", ("low", "high")),
        ("valid_min", ("low",)),
        ("valid_max", ("high",)),
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
        if "low" in limits:
            low = float(stated[0])
        if "high" in limits:
            high = float(stated[-1])
    with np.errstate(invalid="ignore"):
        outside = (numbers < low) | (numbers > high)
    if 2 * outside.sum() > np.isfinite(numbers).sum():
        raise DataError(
            f"{name} has {outside.sum()} values outside its valid range, {low:g} to {high:g}: "
            "correct valid_range (valid_min, valid_max) or the values"
        )
    return np.where(outside, np.nan, numbers)


def _in_one_block(
    values: xarray.DataArray, index: dict[Any, np.ndarray]
) -> xarray.DataArray:
    """Return values at the `index` of each dimension, read as the block that holds them.

    A library reads places one by one, and unpacks the whole part of a file for each of them.
    """
    block = values.isel(
        {
            dim: slice(positions.min(), positions.max() + 1)
            for dim, positions in index.items()
        }
    )
    return block.load().isel(
        {dim: positions - positions.min() for dim, positions in index.items()}
    )
