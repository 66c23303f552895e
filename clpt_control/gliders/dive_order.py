"""Which dives can follow one another: no overlap, and no way that is too long.

Between two dives a vehicle drifts at the surface, or dives that are not known,
from the fix at the end of the one (GPSE) to the last fix before the other (GPS2).
That way is at most

    max(5 m/s * time between them, `ASTRAY`);

a longer one says that one of the fixes is wrong or that the dives are of two
vehicles.  One that is longer than 5 m/s allow and than `NEAR` is noted.
"""

from math import hypot
from typing import TYPE_CHECKING

from ..geodesy import displacement
from .dive_faults import FASTEST

if TYPE_CHECKING:
    from .dives import Dive

OVERLAP = 60.0  # s that neighbours may share by rounding
ANOTHER = "another vehicle? replay each on its own"
NEAR, ASTRAY = 5e3, 50e3  # m: ways that are noted, and refused, however short the time


def by_time(dive: "Dive") -> tuple:
    """Return the key that puts dives in one order.

    Parameters
    ----------
    dive : Dive
        With finite times and way.

    Returns
    -------
    tuple
        Its end, its start, number, way through the water, whether it has a
        track, and then all else.
    """
    way = (dive.dr_east, dive.dr_north)
    return (dive.t_gpse, dive.t_gps2, dive.number, *way, dive.track is None, repr(dive))


def overlap(dive: "Dive", before: "Dive") -> str:
    """Say how a dive overlaps one that ended before it.

    Parameters
    ----------
    dive : Dive
        The later one by its end.
    before : Dive
        One that is used.

    Returns
    -------
    str
        Empty where it does not.
    """
    if dive.t_gps2 >= before.t_gpse - OVERLAP:
        return ""
    if (dive.t_gps2, dive.t_gpse) != (before.t_gps2, before.t_gpse):
        apart = _between(dive.lat_gps2, dive.lon_gps2, before.lat_gps2, before.lon_gps2)
        other = apart > max(FASTEST * abs(dive.t_gps2 - before.t_gps2), ASTRAY)
        return (
            f"overlaps dive {before.number}, which is used: starts "
            f"{before.t_gpse - dive.t_gps2:.0f} s before that ends"
            f"{f' and {apart / 1000:.0f} km from where it started; {ANOTHER}' if other else ''}"
        )
    fixes = max(
        _between(dive.lat_gps2, dive.lon_gps2, before.lat_gps2, before.lon_gps2),
        _between(dive.lat_gpse, dive.lon_gpse, before.lat_gpse, before.lon_gpse),
    )
    if fixes > 0:
        return f"duplicate of dive {before.number}, which is used, with other fixes ({_far(fixes)})"
    way = hypot(dive.dr_east - before.dr_east, dive.dr_north - before.dr_north)
    if way > 0:
        return (
            f"duplicate of dive {before.number}, which is used, with another displacement through "
            f"the water ({_far(way)})"
        )
    return f"duplicate: has the times of dive {before.number}, which is used"


def too_far(dive: "Dive", before: "Dive", least: float | None = None) -> str:
    """Say how far from a dive's end another one starts, if too far.

    Parameters
    ----------
    dive : Dive
        The later one.
    before : Dive
        The one before it.
    least : float, optional
        Shorter ways are not too far, m; by default `ASTRAY`.

    Returns
    -------
    str
        Empty where a vehicle can have got there.
    """
    since = dive.t_gps2 - before.t_gpse
    way = _between(before.lat_gpse, before.lon_gpse, dive.lat_gps2, dive.lon_gps2)
    if way <= max(FASTEST * since, ASTRAY if least is None else least):
        return ""
    return (
        f"starts {way / 1000:.0f} km from where dive {before.number} ended "
        f"{max(since, 0.0) / 3600:.1f} h before"
    )


def _between(lat1: float, lon1: float, lat2: float, lon2: float) -> float:
    return hypot(*displacement(lat1, lon1, lat2, lon2))


def _far(way: float) -> str:
    return f"{way:.3g} m apart" if way < 1000 else f"{way / 1000:.3g} km apart"
