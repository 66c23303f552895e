"""Samples of a dive: numbers of a file, gaps filled, steps summed to a track."""

from math import nan
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import xarray


def values(data: "xarray.Dataset", name: str) -> np.ndarray:
    """Give a variable as floats, NaN where it is no number."""
    raw = np.atleast_1d(data[name].values)
    if raw.dtype.kind in "iufb":
        return raw.astype(float)
    numbers = np.full(raw.shape, nan)
    for place, item in np.ndenumerate(raw):
        try:
            numbers[place] = float(item)
        except (TypeError, ValueError):
            continue
    return numbers


def scalar(data: "xarray.Dataset", name: str) -> float | None:
    """Give a single finite number, or None."""
    if name not in data.variables:
        return None
    found = values(data, name)
    return float(found.flat[0]) if found.size and np.isfinite(found.flat[0]) else None


def fill(time: np.ndarray, steps: np.ndarray, bad: np.ndarray) -> np.ndarray:
    """Fill single steps by the speed of their neighbours.

    Parameters
    ----------
    time : ndarray
        Increasing, s.
    steps : ndarray
        Way since the sample before, m.
    bad : ndarray of bool
        Which to fill; not all.

    Returns
    -------
    ndarray
        speed * (time since the sample before) where bad, as it was elsewhere.

    Examples
    --------
    >>> time = np.array([0.0, 10.0, 20.0, 40.0])
    >>> fill(time, np.array([0.0, 2.0, np.nan, 8.0]), np.array([False, False, True, False]))
    array([0. , 2. , 2.66..., 8. ])
    """
    since = np.diff(time, prepend=time[0])
    good = ~bad & (since > 0)
    speed = np.interp(time, time[good], steps[good] / since[good]) if good.any() else 0 * time
    return np.where(bad, speed * since, steps)


def track_of(
    since: np.ndarray, east: np.ndarray, north: np.ndarray, duration: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Sum steps to a track from fix to fix.

    Parameters
    ----------
    since : ndarray
        Time since the fix before the dive, s.
    east, north : ndarray
        Way since the sample before, m.
    duration : float
        Time of the fix after the dive, s.

    Returns
    -------
    tuple of ndarray
        Time, east and north; begins at 0 and ends at `duration` at rest.
    """
    east, north = np.cumsum(east), np.cumsum(north)
    if since[0] > 0:
        since, east, north = (np.concatenate([[0.0], a]) for a in (since, east, north))
    if since[-1] < duration:
        since, east, north = (
            np.concatenate([a, [last]])
            for a, last in ((since, duration), (east, east[-1]), (north, north[-1]))
        )
    return since, east, north
