"""Samples of a file in seconds since 1970, metres and metres per second.

Files of different makers give the same sample as seconds since 1970 or as
nanoseconds since the first of them, a depth as m or cm, a speed as cm/s or
m s-1; a variable without units is taken as s, m or m/s.
"""

import re
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..currents.cf import decoded
from ..errors import DataError
from ..units import length_in_metres, speed_in_metres_per_second, time_in_seconds
from .samples import values

if TYPE_CHECKING:
    import xarray

NOT_A_TIME = -(2.0**63)  # smallest integer of 64 bits: how a missing time is stored


def seconds(data: "xarray.Dataset", name: str, path: Path) -> np.ndarray:
    """Return times as seconds since 1970 UTC.

    Parameters
    ----------
    data : xarray.Dataset
        With times as numbers.
    name : str
        Of the variable, shape (n,).
    path : Path
        The file's name, for messages.

    Returns
    -------
    ndarray, shape (n,)
        s; NaN where missing.

    Raises
    ------
    DataError
        If its units are no time since a date.

    Examples
    --------
    >>> import xarray
    >>> units = {"units": "nanoseconds since 2010-07-29 13:31:04"}
    >>> data = xarray.Dataset({"TIME": ("n", np.array([0, 234_000_000_000]), units)})
    >>> seconds(data, "TIME", Path("mission.nc")) - 1280410264.0
    array([  0., 234.])
    """
    numbers = values(data, name)
    units = str(data[name].attrs.get("units", ""))
    numbers = np.where(numbers == NOT_A_TIME, np.nan, numbers)
    if " since " not in units:
        return numbers
    since = re.sub(r"\s*(UTC|GMT)\s*$", "", units.partition(" since ")[2].strip())
    first = decoded(np.zeros(1), f"seconds since {since}")
    if first is None or first.dtype.kind != "M":
        raise DataError(
            f"{path}: {name} is in '{units}'; must be such as 'seconds since 1970-01-01 00:00:00'"
        )
    epoch = (first[0] - np.datetime64("1970-01-01")) / np.timedelta64(1, "s")
    return epoch + time_in_seconds(units, f"{path}: {name}") * numbers


def metres(data: "xarray.Dataset", name: str, path: Path) -> np.ndarray:
    """Return lengths in metres, depths positive down.

    Parameters
    ----------
    data : xarray.Dataset
        The file.
    name : str
        Of the variable, shape (n,).
    path : Path
        The file's name, for messages.

    Returns
    -------
    ndarray, shape (n,)
        m; NaN where missing.

    Raises
    ------
    DataError
        If its units are no length.

    Examples
    --------
    >>> import xarray
    >>> data = xarray.Dataset({"eng_depth": ("n", [150.0], {"units": "cm"})})
    >>> metres(data, "eng_depth", Path("p0010001.nc"))
    array([1.5])
    """
    units = str(data[name].attrs.get("units", "")).strip() or "m"
    size = length_in_metres(units, f"{path}: {name}")
    up = str(data[name].attrs.get("positive", "")).lower() == "up"
    return values(data, name) * (-size if up else size)


def metres_per_second(data: "xarray.Dataset", name: str, path: Path) -> np.ndarray:
    """Return speeds in metres per second.

    Parameters
    ----------
    data : xarray.Dataset
        The file.
    name : str
        Of the variable, shape (n,).
    path : Path
        The file's name, for messages.

    Returns
    -------
    ndarray, shape (n,)
        m/s; NaN where missing.

    Raises
    ------
    DataError
        If its units are no speed.
    """
    units = str(data[name].attrs.get("units", "")).strip() or "m/s"
    return values(data, name) * speed_in_metres_per_second(units, f"{path}: {name}")
