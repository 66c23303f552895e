"""Fixes that disagree: the end of a dive, and the start of the next one.

At the surface a vehicle drifts, so the next dive starts at most

    5 m/s * (time between the fixes) + 300 m

from where the last one ended; more says that one of the two fixes is wrong.  It is the
one that lies further, by the covariance P of its forecast m,

    (y - m)^T P^-1 (y - m),

from where the last dive was forecast to end.  If that is the end, the start of the next
dive, within an hour the place of the same surfacing, stands for it, and what a
current of the prior moves the vehicle in that time is its doubt; later than that it
counts by how far off it is.  If it is the start, as when a boat has moved the vehicle,
the next dive counts by how far off it is.  The variance of a miss is then

    FIX^2 + doubt^2 + (s T)^2.

The start of a dive is known before it is forecast, so nothing later is read.
"""

from dataclasses import replace
from math import hypot

import numpy as np

from ..estimation.dive import miss
from ..estimation.fix_model import FixModel
from ..geodesy import displacement
from ..gliders.dives import Dive
from ..gliders.usable_dives import FASTEST

MARGIN = 300.0  # m: two fixes, a poor one among them, and how long a stay is rounded
SAME_STAY = 3600.0  # s: longer, other dives may lie between


def disagreement(before: Dive, dive: Dive) -> float:
    """Return how far a dive starts from where the one before ended, m; 0 where it can.

    >>> from clpt_control.gliders.dives import make_dive
    >>> one = make_dive(1, (0.0, 40.0, 8.0), (9000.0, 40.0, 8.0), (0.0, 0.0))
    >>> two = make_dive(2, (9060.0, 40.01, 8.0), (18000.0, 40.01, 8.0), (0.0, 0.0))
    >>> round(disagreement(one, two)), disagreement(one, replace(two, t_gps2=9300.0))
    (1110, 0.0)
    """
    apart = hypot(*displacement(before.lat_gpse, before.lon_gpse, dive.lat_gps2, dive.lon_gps2))
    return apart if apart > FASTEST * max(_between(before, dive), 0.0) + MARGIN else 0.0


def weighed(
    before: Dive, dive: Dive, forecast: tuple[np.ndarray, np.ndarray], model: FixModel
) -> tuple[Dive, Dive]:
    """Return both dives, of two fixes that disagree the wrong one doubted; else the same ones.

    The forecast is that of the end of the one before: mean (2,), m, and covariance (2, 2), m^2.
    """
    apart = disagreement(before, dive)
    if not apart:
        return before, dive
    since = max(_between(before, dive), 0.0)
    there = displacement(before.lat_gps2, before.lon_gps2, dive.lat_gps2, dive.lon_gps2)
    start = np.array(there) - (before.dr_east, before.dr_north)
    mean, covariance = forecast
    end_off, start_off = (
        float(off @ np.linalg.solve(covariance, off)) for off in (miss(before) - mean, start - mean)
    )
    said = f"{apart / 1000:.1f} km in {since / 60:.0f} min"
    if start_off >= end_off:
        note = f"starts {said} from where dive {before.number} ended: counts little"
        return before, _doubted(dive, apart, note)
    note = f"the fix at its end is {said} from where dive {dive.number} starts"
    if since > SAME_STAY:
        return _doubted(before, apart, f"{note}: counts little"), dive
    drift = model.priors.current * since
    settled = _doubted(before, drift, f"{note}, and off its forecast: that start is taken instead")
    lat, lon = dive.lat_gps2, dive.lon_gps2
    return (
        replace(settled, lat_gpse=lat, lon_gpse=lon, gps_east=there[0], gps_north=there[1]),
        dive,
    )


def _between(before: Dive, dive: Dive) -> float:
    return dive.t_gps2 - before.t_gpse


def _doubted(dive: Dive, doubt: float, note: str) -> Dive:
    return replace(dive, doubt=hypot(dive.doubt, doubt), notes=(*dive.notes, note))
