"""Read times of a NetCDF file: numbers since a date, in a calendar (CF 4.4).

`hours_since_first` takes any calendar, for a current alone has no need of real
dates; a dive and a tide have, and `check_calendar` says so.
"""

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..errors import DataError
from .gridded import numbers_of

if TYPE_CHECKING:
    import xarray

KNOWN = (
    "standard",
    "gregorian",
    "proleptic_gregorian",
    "julian",
    "noleap",
    "365_day",
    "all_leap",
    "366_day",
    "360_day",
)
CALENDARS = ("standard", "gregorian", "proleptic_gregorian")  # of real dates


def check_calendar(when: "xarray.DataArray", path: Path) -> None:
    """Refuse times that are no real dates.

    Parameters
    ----------
    when : xarray.DataArray
        Times as numbers.
    path : Path
        The file's name, for the message.

    Raises
    ------
    DataError
        If their calendar is another one, such as of 360 days.
    """
    calendar = str(when.attrs.get("calendar", "standard"))
    if calendar.lower() not in CALENDARS:
        raise DataError(
            f"{path}: {when.name} has the calendar '{calendar}'; must be one of real dates: "
            f"{', '.join(CALENDARS)}"
        )


def hours_since_first(when: "xarray.DataArray", path: Path) -> tuple[np.ndarray, str]:
    """Return hours since the earliest step, and that step as ISO text.

    Parameters
    ----------
    when : xarray.DataArray, shape (nt,)
        Times as numbers, with units such as "hours since 2019-01-01".
    path : Path
        The file's name, for messages.

    Returns
    -------
    hours : ndarray, shape (nt,)
        In the file's order.
    start : str
        The earliest step.

    Raises
    ------
    DataError
        If there are fewer than two steps or the unit cannot be read.
    """
    import cftime

    unit = str(when.attrs.get("units", ""))
    calendar = str(when.attrs.get("calendar", "standard"))
    if len(when) < 2:
        raise DataError(f"{path}: {when.name} has {len(when)} step; at least 2 are needed")
    numbers_of(when, f"{path}: {when.name}")
    if calendar.lower() not in KNOWN:
        raise DataError(
            f"{path}: {when.name} has the calendar '{calendar}'; must be one of {', '.join(KNOWN)}"
        )
    if not np.all(np.isfinite(when.values)):
        raise DataError(f"{path}: {when.name} has values that are not finite")
    try:
        dates = cftime.num2date(when.values, unit, calendar=calendar)
    except (ValueError, TypeError, OverflowError):
        raise DataError(
            f"{path}: {when.name} has units '{unit}'; must be such as "
            "'hours since 2019-01-01 00:00:00'"
        ) from None
    first = min(dates)
    hours = np.array([(date - first).total_seconds() / 3600.0 for date in dates])
    return hours, str(first.isoformat())
