"""Dives of a glider: two fixes and the way through the water between them.

A vehicle that dives knows where it is at the last fix before the dive (GPS2)
and at the first one after it (GPSE).  Between them it moves through the water
by its dead reckoning; what is left,

    miss = (displacement between the fixes) - (displacement through the water),

is its CLPE without a flow model, and miss / duration the current averaged over
the dive, as gliders report it (D. L. Rudnick, J. T. Sherman, A. P. Wu,
"Depth-average velocity from Spray underwater gliders", J. Atmos. Oceanic
Technol. 35, 1665-1673, 2018).  Displacements are WGS84 geodesics by
`pyproj.Geod`, resolved east and north at the start fix.

`usable` is the one place where dives are refused, each with its reason
(`dive_faults`, `dive_order`).
"""

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ...geodesy import displacement
from .dive_faults import fault_of
from .dive_order import ANOTHER, NEAR, by_time, overlap, too_far

Fix = tuple[float, float, float]  # s since 1970 UTC, degrees north, degrees east

LEAST_DURATION = 4000.0  # s


@dataclass(frozen=True)
class Dive:
    """One dive; what is not known is NaN, or None if optional.

    Attributes
    ----------
    number : int
        The vehicle's own number of the dive.
    t_gps2, lat_gps2, lon_gps2 : float
        Last fix before the dive: s since 1970 UTC, degrees north and east.
    t_gpse, lat_gpse, lon_gpse : float
        First fix after it.
    gps_east, gps_north : float
        Displacement between the two fixes, m.
    dr_east, dr_north : float
        Dead-reckoned displacement through the water, m.
    t_gps1, lat_gps1, lon_gps1 : float or None
        First fix of the surfacing before the dive.
    dac_east, dac_north : float or None
        Depth-averaged current in the file, m/s.
    dac_qc : float or None
        Its quality flag, as the file has it.
    magvar : float or None
        Magnetic variation, degrees east.
    depth_max : float or None
        Greatest depth, m.
    model_east, model_north : float or None
        Way that a chosen flow model carries the vehicle, m (`flow_models`).
    track : tuple of ndarray or None
        Time since `t_gps2` (s), way east and north through the water (m).
    notes : tuple of str
        What was repaired or looks odd, in plain words.
    """

    number: int
    t_gps2: float
    lat_gps2: float
    lon_gps2: float
    t_gpse: float
    lat_gpse: float
    lon_gpse: float
    gps_east: float
    gps_north: float
    dr_east: float
    dr_north: float
    t_gps1: float | None = None
    lat_gps1: float | None = None
    lon_gps1: float | None = None
    dac_east: float | None = None
    dac_north: float | None = None
    dac_qc: float | None = None
    magvar: float | None = None
    depth_max: float | None = None
    model_east: float | None = None
    model_north: float | None = None
    track: tuple[np.ndarray, np.ndarray, np.ndarray] | None = field(
        default=None, compare=False, repr=False
    )
    notes: tuple[str, ...] = field(default=(), compare=False)

    @property
    def duration(self) -> float:
        """Time between the two fixes, s."""
        return self.t_gpse - self.t_gps2

    @property
    def miss_east(self) -> float:
        """How far east of its dead reckoning the vehicle surfaced, m."""
        return self.gps_east - self.dr_east

    @property
    def miss_north(self) -> float:
        """How far north of its dead reckoning the vehicle surfaced, m."""
        return self.gps_north - self.dr_north


@dataclass(frozen=True)
class Skipped:
    """A dive that is not used, or a file or line that holds none.

    Attributes
    ----------
    dive : int or None
        Its number, where it is known.
    why : str
        The reason, in plain words.
    """

    dive: int | None
    why: str


def make_dive(
    number: int, start: Fix, end: Fix, through_water: tuple[float, float], **optional: Any
) -> Dive:
    """Make a dive of its fixes and its way through the water.

    Parameters
    ----------
    number : int
        The vehicle's own number of the dive.
    start, end : tuple of float
        Time (s since 1970 UTC), latitude and longitude (degrees) of a fix.
    through_water : tuple of float
        East and north, m.
    **optional : float, tuple or None
        Other fields of `Dive`.

    Returns
    -------
    Dive
        With the displacement between the fixes.
    """
    return Dive(
        number, *start, *end, *displacement(*start[1:], *end[1:]), *through_water, **optional
    )


def usable(
    dives: Iterable[Dive], least_duration: float = LEAST_DURATION
) -> tuple[list[Dive], list[Skipped]]:
    """Sort dives by time and leave out those that cannot be used.

    A dive is used when it has both fixes in their order and in the years 1970
    to 2200, finite dead reckoning, lasts longer than `least_duration`, needs no
    speed above 5 m/s, does not overlap one that ended before it, and starts where
    a vehicle can have got to from the end of the used dive before.  Where the
    latter is not so for two dives running that follow one another, the fix of the
    used one is taken as wrong: the first of the two stays left out, and dives
    are used from the second on.  Whether a dive is used depends on earlier ends
    only, so a later dive never changes it.

    Parameters
    ----------
    dives : iterable of Dive
        In any order.
    least_duration : float
        Longest duration that is too short, s.

    Returns
    -------
    used : list of Dive
        By time; gaps in the numbers and a changed order stand in `notes`.
    skipped : list of Skipped
        The others, each with its reason.

    Examples
    --------
    >>> fixes = (0.0, -43.0, 8.0), (9000.0, -43.0, 8.01)
    >>> dives = [make_dive(7, *fixes, (500.0, 0.0)), make_dive(8, *fixes, (float("nan"), 0.0))]
    >>> used, skipped = usable(dives)
    >>> [dive.number for dive in used], skipped[0].dive, skipped[0].why
    ([7], 8, 'the displacement through the water is not finite')
    """
    fit, skipped, latest = [], [], -np.inf
    for dive in dives:
        why = fault_of(dive, least_duration)
        if why:
            skipped.append(Skipped(dive.number, "; ".join((why, *dive.notes))))
            continue
        if dive.t_gpse < latest:
            dive = _noted(dive, "came after a later dive, sorted by time")
        latest = max(latest, dive.t_gpse)
        fit.append(dive)
    used: list[Dive] = []
    stray: Dive | None = None  # the last one, if it starts too far from the used one
    for dive in sorted(fit, key=by_time):
        before = used[-1] if used else None
        if before is None:
            used.append(dive)
            continue
        why = overlap(dive, before)
        if why:
            skipped.append(Skipped(dive.number, why))
            continue
        why = too_far(dive, before)
        if why and (stray is None or overlap(dive, stray) or too_far(dive, stray)):
            skipped.append(Skipped(dive.number, f"{why}; {ANOTHER}"))
            stray = dive
            continue
        if why and stray is not None:
            dive = _noted(dive, f"{why}, but follows dive {stray.number}, which was left out: used")
        elif odd := too_far(dive, before, NEAR):
            dive = _noted(dive, odd)
        stray = None
        missing = dive.number - before.number - 1
        if missing > 0:
            dive = _noted(dive, f"{missing} dive(s) missing after dive {before.number}")
        used.append(dive)
    return used, skipped


def _noted(dive: Dive, note: str) -> Dive:
    return dive if note in dive.notes else replace(dive, notes=(*dive.notes, note))
