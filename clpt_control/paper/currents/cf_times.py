"""Times of a NetCDF file, as dates.

Times of means are the middles of their intervals, which the bounds of the time give (CF 7.1).
The interval counts unless `cell_methods` says that values are of a point in time (CF 7.3).
"""

import re
import warnings

import numpy as np
import xarray
from xarray.coders import CFDatetimeCoder

from ...base.errors import DataError
from .flags import said
from .valid_values import numbers_of

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
UTC = {"utc", "gmt", "z", "t"}  # t is that of ISO 8601
FIRST_YEAR = 1950  # earlier times of ocean data look like integers that overflowed
OVERFLOW = np.timedelta64(
    36525, "D"
)  # a step of 100 years is that of an integer that overflowed
SINCE_A_DATE = re.compile(r"\s*(\w+)\s+since\s+(\d+-\d+-\d+.*)", re.IGNORECASE)


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
    least: int,
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
