"""Magnetic variation: how far a compass points from true north, by IGRF.

    D = atan2(B_east, B_north), degrees, positive east

of the International Geomagnetic Reference Field, 14th generation (IAGA, 2024), whose
coefficients `ppigrf` carries: epochs of five years from 1900, between which the
field is linear in time.  Good to about half a degree at sea; near the magnetic poles
no compass is of use.
"""

from dataclasses import replace
from datetime import UTC, datetime

import numpy as np

from ..errors import needed
from .dives import Dive
from .dives import make_dive as make_dive

FIRST, LAST = 1900, 2030  # years of IGRF-14
EPOCH = 5  # years
NEAREST = 89.9  # degrees: at a pole itself there is no north


def variation(
    time: np.ndarray | float, lat: np.ndarray | float, lon: np.ndarray | float
) -> np.ndarray:
    """Return the variation at times (s since 1970 UTC) and places (degrees), shape (n,).

    Degrees east; NaN outside the years that IGRF covers, or where anything is not finite.

    >>> variation(1.0963e9, 66.9, -57.1).round(1).tolist()  # Labrador Sea, September 2004
    [-36.9]
    >>> variation(4.0e9, 66.9, -57.1).tolist()  # the year 2096
    [nan]
    """
    columns = np.broadcast_arrays(*(np.atleast_1d(np.asarray(a, float)) for a in (time, lat, lon)))
    time, lat, lon = (column.ravel() for column in columns)
    found = np.full(time.shape, np.nan)
    edges = [datetime(year, 1, 1, tzinfo=UTC).timestamp() for year in range(FIRST, LAST + 1, EPOCH)]
    good = np.isfinite(lat) & np.isfinite(lon) & (time >= edges[0]) & (time <= edges[-1])
    epoch = np.searchsorted(edges[1:-1], time, side="right")
    for k in np.unique(epoch[good]):
        rows = np.flatnonzero(good & (epoch == k))
        share = (time[rows] - edges[k]) / (edges[k + 1] - edges[k])
        found[rows] = _declination(FIRST + EPOCH * int(k), share, lat[rows], lon[rows])
    return found


def _declination(year: int, share: np.ndarray, lat: np.ndarray, lon: np.ndarray) -> np.ndarray:
    """Return D at places (n,), each at a share of the epoch that begins with a year."""
    igrf = needed("ppigrf").igrf  # it reads pandas
    ends = [datetime(year, 1, 1), datetime(year + EPOCH, 1, 1)]
    east, north, _ = igrf(lon, np.clip(lat, -NEAREST, NEAREST), 0.0, ends)
    east, north = ((1 - share) * b[0] + share * b[1] for b in (east, north))
    return np.degrees(np.arctan2(east, north))


def turned(dive: Dive, degrees: float) -> Dive:
    """Turn dead reckoning that was made of a magnetic heading by another variation, degrees east.

    A heading h + a moves (sin, cos) clockwise by a; other dead reckoning stays.

    >>> fixes = (0.0, 0.0, 8.0), (9000.0, 0.0, 8.0)
    >>> round(turned(make_dive(1, *fixes, (0.0, 100.0), turned=0.0), 90.0).dr_east)
    100
    """
    if dive.turned is None:
        return dive
    angle = np.radians(degrees - dive.turned)
    turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    east, north = turn @ (dive.dr_east, dive.dr_north)
    track = dive.track and (dive.track[0], *(turn @ np.stack(dive.track[1:])))
    return replace(
        dive,
        dr_east=float(east),
        dr_north=float(north),
        track=track,
        turned=degrees,
        magvar=degrees,
        notes=(*dive.notes, f"--variation: turned by {degrees:g} degrees instead"),
    )
