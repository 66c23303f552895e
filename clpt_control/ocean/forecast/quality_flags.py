"""Quality flags: a fix that contradicts the next one is marked as doubtful.

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

from ...base.geodesy import displacement, distance
from ..estimation.dive import Dive, miss
from ..estimation.fix_model import FixModel
from ..gliders.usable_dives import FASTEST

MARGIN = 300.0  # m: two fixes, a poor one among them, and how long a stay is rounded
SAME_STAY = 3600.0  # s: longer, other dives may lie between


def doubt_one_fix(
    before: Dive, dive: Dive, forecast: tuple[np.ndarray, np.ndarray], model: FixModel
) -> tuple[Dive, Dive]:
    """Return both dives, of two fixes that disagree the wrong one doubted; else the same ones.

    The forecast is that of the end of the one before: mean (2,), m, and covariance (2, 2), m^2.
    """
    separation = distance(
        before.lat_gpse, before.lon_gpse, dive.lat_gps2, dive.lon_gps2
    )
    since = max(dive.t_gps2 - before.t_gpse, 0.0)
    if not separation > FASTEST * since + MARGIN:  # as far as a vehicle may drift
        return before, dive
    start_displacement = displacement(
        before.lat_gps2, before.lon_gps2, dive.lat_gps2, dive.lon_gps2
    )
    start = np.array(start_displacement) - (before.dr_east, before.dr_north)
    mean, covariance = forecast
    end_off, start_off = (
        float(off @ np.linalg.solve(covariance, off))
        for off in (miss(before) - mean, start - mean)
    )
    jump = f"{separation / 1000:.1f} km in {since / 60:.0f} min"
    if start_off >= end_off:
        note = f"starts {jump} from where dive {before.number} ended: counts little"
        return before, _doubted(dive, separation, note)
    note = f"the fix at its end is {jump} from where dive {dive.number} starts"
    if since > SAME_STAY:
        return _doubted(before, separation, f"{note}: counts little"), dive
    drift = model.priors.current * since
    settled = _doubted(
        before, drift, f"{note}, and off its forecast: that start is taken instead"
    )
    lat, lon = dive.lat_gps2, dive.lon_gps2
    east, north = start_displacement
    return replace(
        settled, lat_gpse=lat, lon_gpse=lon, gps_east=east, gps_north=north
    ), dive


def _doubted(dive: Dive, doubt: float, note: str) -> Dive:
    return replace(dive, doubt=hypot(dive.doubt, doubt), notes=(*dive.notes, note))
