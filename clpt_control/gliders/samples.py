"""Samples of a dive: numbers of a file, gaps filled, steps summed to a track.

A step is the way since the sample before, so a track is their running sum, from
rest at the fix before the dive to rest at the fix after it.  Times are s, ways m.
"""

from math import nan
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import xarray

SURFACE = 20.0  # m: a vehicle last seen above needs no samples until its fix
LARGEST_HOLE = 0.1  # share of a dive that may be without samples under water
DEEPEST = 12000.0  # m: no sea is deeper


def values(data: "xarray.Dataset", name: str) -> np.ndarray:
    """Return a variable as floats, NaN where it is no number."""
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
    """Return a single finite number, or None."""
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


def hole_under_water(since: np.ndarray, depth: np.ndarray, duration: float) -> str:
    """Say where a dive lacks too many samples for a sum.

    At the surface, before its first sample and after its last, a vehicle has no
    way through the water to sum; a part of the dive that is missing is another
    thing.

    Parameters
    ----------
    since : ndarray
        Increasing times of the samples since the fix before the dive, s.
    depth : ndarray
        Of the samples, m; NaN where not known, which counts as deep.
    duration : float
        Time of the fix after the dive, s.

    Returns
    -------
    str
        Empty where no hole under water is longer than a tenth of the dive.

    Examples
    --------
    >>> since = np.array([50.0, 400.0, 800.0])
    >>> hole_under_water(since, np.array([1.0, 90.0, 3.0]), 4000.0)
    ''
    >>> hole_under_water(since, np.array([1.0, 40.0, 90.0]), 4000.0)
    'no samples for 3200 s of 4000 s, from 90 m depth on'
    """
    times = np.concatenate([[0.0], since, [duration]])
    depths = np.concatenate([[0.0], depth, [0.0]])
    holes = np.diff(times)
    surface = np.maximum(depths[:-1], depths[1:]) <= SURFACE  # False where not known
    holes[surface] = 0.0
    longest = int(np.argmax(holes))
    if not holes[longest] > LARGEST_HOLE * duration:
        return ""
    said = f"no samples for {holes[longest]:.0f} s of {duration:.0f} s"
    return f"{said}, from {depths[longest]:.0f} m depth on" if depths[longest] > SURFACE else said


def deepest(depth: np.ndarray) -> float | None:
    """Return the greatest depth of samples, m, or None.

    Parameters
    ----------
    depth : ndarray
        m, positive down.

    Returns
    -------
    float or None
        None where no sample is a depth of the sea.

    Examples
    --------
    >>> deepest(np.array([1.0, 985.5, 9.97e36, np.nan]))
    985.5
    """
    known = depth[np.isfinite(depth) & (depth > 0) & (depth < DEEPEST)]
    return float(known.max()) if known.size else None
