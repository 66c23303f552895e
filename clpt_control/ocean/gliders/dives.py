"""A dive of a glider: two fixes and the displacement through the water between them.

A vehicle that dives knows where it is at the last fix before the dive (GPS2)
and at the first one after it (GPSE).  Between them it moves through the water
by its dead reckoning; what is left,

    miss = (displacement between the fixes) - (displacement through the water),

is its CLPE without a flow model, and miss / duration the current averaged over
the dive, as gliders report it (D. L. Rudnick, J. T. Sherman, A. P. Wu,
"Depth-average velocity from Spray underwater gliders", J. Atmos. Oceanic
Technol. 35, 1665-1673, 2018).  Displacements are WGS84 geodesics by
`pyproj.Geod`, resolved east and north at the start fix.

The depth-averaged current c that a file reports should be

    c = miss / duration,

an independent check that fixes and dead reckoning were read as they were meant.
Seaglider basestations to version 2 compute it with 1852 m to a minute of latitude
and the time of flight, which differs from ours by up to 0.5 % of the displacement
between the fixes and by the minutes at the surface: some 2 mm/s, five at most in
sound dives that were tried.  More says that the samples in the file are not all
that its current was made of.

In a file a dive lies between two fixes, far enough apart in time, with a time under water between
them.

Columns of a vehicle's log: `latitude`, `longitude` (degrees) are a
fix; `course` (degrees from true north) and `speed` (m/s) are the motion through the water until the
next row, `dr_east_m` and `dr_north_m` its displacement since the row before (m).  Robots have `yaw`
(rad anticlockwise from east, REP 103 of ROS) for `course`, or `v_east` and `v_north` (m/s).
"""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from math import cos, hypot, inf, nan, radians, sin
from typing import Any, NamedTuple

import numpy as np

from ...base.arguments import OrNaN, public
from ...base.geodesy import direction, displacement, is_place
from ...base.units import finite_or_none
from .dive_fields import (
    EAST,
    EPOCH,
    HEADINGS,
    MOMENT,
    NAME,
    NORTH,
    SIZES,
    TEXT,
    TIME,
    VARIATIONS,
    WHOLE,
    optional,
    required,
    rows_of,
)

Fix = tuple[OrNaN, OrNaN, OrNaN]  # s since 1970 UTC, degrees north, degrees east
Pair = tuple[float, float]
Track = tuple[np.ndarray, np.ndarray, np.ndarray]  # s since the fix, m east, m north
PLACE = ("latitude", "longitude")
STEERING = ("course", "speed")
STRETCH = ("dr_east_m", "dr_north_m")
YAW = ("yaw", "speed")
VELOCITY = ("v_east", "v_north")
# m/s by which a file's own current may be off
MENTIONED, CONTRADICTS = 0.01, 0.03
LEAST_DEPTH = 5.0  # m that a dive reaches
FASTEST = 5.0  # m/s: no current and no glider is faster, so a fix or a sum is wrong
# of a dive: first of the stay before it, before, after it
Three = tuple[Fix | None, Fix, Fix]
LEAST_GAP = 300.0  # s between two fixes with a dive between them


class ThroughWater(NamedTuple):
    """Displacement east and north (m), NaN where it is not known, its track, notes."""

    total: Pair = (nan, nan)
    track: Track | None = None
    notes: Sequence[str] = ()
    turned: float | None = None  # by which a magnetic heading was turned, degrees east


@public
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
    turned : float or None
        Variation by which a magnetic heading was turned to make the dead reckoning, degrees
        east; None where it is the file's own, or of a true heading.
    doubt : float
        Standard error of the displacement between fixes that disagree with a neighbour's, m.
    model_east, model_north : float or None
        Displacement that a chosen flow model gives the vehicle, m (`flow_models`).
    uncovered : str or None
        Why that model says nothing of the dive.
    next_course : float or None
        Course of the next dive by the plan in this one's file, degrees clockwise from true north.
    vehicle : str or None
        Its name, as the file has it.
    kind : str or None
        Seaglider, Slocum or SeaExplorer, where its files say so.
    track : tuple of ndarray or None
        Time since `t_gps2` (s), displacement east and north through the water (m).
    notes : tuple of str
        What was repaired or looks odd, in plain words.

    Examples
    --------
    >>> dive = Dive(1, 0.0, 0.0, 8.0, 9000.0, 0.0, 8.1, 11132.0, 0.0, 9332.0, 0.0)
    >>> dive.miss_east / dive.duration  # m/s
    0.2
    >>> dive
    <Dive 1: 2.50 h, miss 1800 m east, 0 m north>
    """

    number: int = required("1", WHOLE, header="dive", result="dive")
    t_gps2: OrNaN = required(EPOCH, TIME, result="start_time")
    lat_gps2: OrNaN = required(NORTH, result="start_latitude")
    lon_gps2: OrNaN = required(EAST, result="start_longitude")
    t_gpse: OrNaN = required(EPOCH, TIME, result="end_time")
    lat_gpse: OrNaN = required(NORTH, result="end_latitude")
    lon_gpse: OrNaN = required(EAST, result="end_longitude")
    gps_east: OrNaN = required("m", None, header="gps_east_m")
    gps_north: OrNaN = required("m", None, header="gps_north_m")
    dr_east: OrNaN = required("m", header="dr_east_m")
    dr_north: OrNaN = required("m", header="dr_north_m")
    t_gps1: OrNaN | None = optional(EPOCH, TIME, result="first_fix_time")
    lat_gps1: OrNaN | None = optional(NORTH, result="first_fix_latitude")
    lon_gps1: OrNaN | None = optional(EAST, result="first_fix_longitude")
    dac_east: OrNaN | None = optional("m s-1", result="file_current_east")
    dac_north: OrNaN | None = optional("m s-1", result="file_current_north")
    dac_qc: OrNaN | None = optional("1")
    magvar: OrNaN | None = optional("degrees", limits=VARIATIONS)
    depth_max: OrNaN | None = optional("m")
    turned: OrNaN | None = optional("degrees", limits=VARIATIONS)
    doubt: OrNaN = optional("m", limits=SIZES, default=0.0)
    model_east: OrNaN | None = optional("m", result="flow_model_east")
    model_north: OrNaN | None = optional("m", result="flow_model_north")
    next_course: OrNaN | None = optional("degrees", limits=HEADINGS)
    vehicle: str | None = optional("", NAME, result="", compare=False)
    kind: str | None = optional("", NAME, result="", compare=False)
    uncovered: str | None = optional("", TEXT, result="", compare=False)
    track: Track | None = field(default=None, compare=False, repr=False)
    notes: tuple[str, ...] = field(default=(), compare=False)

    def __repr__(self) -> str:
        vehicle = f" of {self.vehicle}" if self.vehicle else ""
        return (
            f"<Dive {self.number}{vehicle}: {self.duration / 3600:.2f} h, miss "
            f"{self.miss_east:.0f} m east, {self.miss_north:.0f} m north>"
        )

    @property
    def duration(self) -> float:
        """Time between the two fixes, s."""
        return self.t_gpse - self.t_gps2

    @property
    def start(self) -> Pair:
        """Place of the last fix before the dive, degrees north and east."""
        return self.lat_gps2, self.lon_gps2

    @property
    def end(self) -> Pair:
        """Place of the first fix after the dive, degrees north and east."""
        return self.lat_gpse, self.lon_gpse

    @property
    def over_ground(self) -> Pair:
        """Displacement between the two fixes, east and north, m."""
        return self.gps_east, self.gps_north

    @property
    def through_water(self) -> Pair:
        """Dead-reckoned displacement, east and north, m."""
        return self.dr_east, self.dr_north

    @property
    def mid_time(self) -> float:
        """Middle of the dive, s since 1970 UTC."""
        return 0.5 * (self.t_gps2 + self.t_gpse)

    @property
    def miss(self) -> np.ndarray:
        """Position error of the dead reckoning, east and north, m."""
        return np.array([self.miss_east, self.miss_north])

    @property
    def miss_east(self) -> float:
        """Position error to the east of the dead reckoning, m."""
        return self.gps_east - self.dr_east

    @property
    def miss_north(self) -> float:
        """Position error to the north of the dead reckoning, m."""
        return self.gps_north - self.dr_north

    @property
    def dac_difference(self) -> float:
        """Miss over duration less the file's current, m/s; or NaN."""
        if self.dac_east is None or self.dac_north is None or not self.duration > 0:
            return nan
        current = self.dac_east, self.dac_north
        return float(np.hypot(*(self.miss / self.duration - current)))


FIELDS = rows_of(Dive)
COLUMNS = {row.header: row for row in (*FIELDS, *MOMENT)}


@public
def make_dive(
    number: int,
    start: Fix,
    end: Fix,
    through_water: tuple[OrNaN, OrNaN],
    **optional: Any,
) -> Dive:
    """Make a dive of its fixes and its displacement through water.

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

    Examples
    --------
    >>> dive = make_dive(1, (0.0, 0.0, 8.0), (9000.0, 0.0, 8.1), (9332.0, 0.0))
    >>> round(dive.gps_east), round(dive.miss_east)
    (11132, 1800)
    """
    return Dive(
        number,
        *start,
        *end,
        *displacement(*start[1:], *end[1:]),
        *through_water,
        **optional,
    )


@public
@dataclass(frozen=True)
class Skipped:
    """A dive that is not used, or a file or line that holds none: its number, if known, and why."""

    dive: int | None
    why: str


DivesOrSkipped = list[Dive | Skipped]  # of a file, in its order
DivesAndSkipped = tuple[list[Dive], list[Skipped]]


def is_fix(lat: Any, lon: Any) -> Any:
    """Return whether degrees can be a fix; receivers without one give 0 N 0 E."""
    return is_place(lat, lon) & ((lat != 0.0) | (lon != 0.0))


def cut_dives(fixes: Sequence[Fix], wet: np.ndarray | None) -> list[Three]:
    """Return the fixes of each dive: `LEAST_GAP` apart, with a time under water between.

    Fixes and times under water, `wet`, are in order; with None for these any gap is a dive.
    After a dive, a fix with exactly the place of the one before it is that one repeated: it is
    left out, and the dive goes on to the first new place.

    >>> up = [(0.0, 43.0, 8.0), (60.0, 43.0, 8.0), (7200.0, 43.0, 8.1), (9000.0, 43.0, 8.1)]
    >>> cut_dives(up, np.array([600.0])) == [tuple(up[:3])]
    True
    """

    def is_dive(start: Fix, end: Fix) -> bool:
        under = (
            1
            if wet is None
            else np.ptp(np.searchsorted(wet, (start[0], end[0]), "right"))
        )
        return end[0] - start[0] > LEAST_GAP and bool(under > 0)

    new = [*fixes[:1]]
    for fix in fixes[1:]:
        repeats = fix[1:] == new[-1][1:] and is_dive(new[-1], fix)
        if not repeats:
            new.append(fix)
    dives = []
    surfaced = 0  # first fix since the dive before
    for k, (start, end) in enumerate(pairwise(new)):
        if is_dive(start, end):
            dives.append((new[surfaced] if k > surfaced else None, start, end))
            surfaced = k + 1
    return dives


def usual_surfacing(dives: Sequence[Three]) -> float:
    """Return how long a vehicle usually stays up, from its first to its last fix, s.

    At least `LEAST_GAP`.

    >>> fixes = [(time, 43.0, 8.0) for time in (0.0, 900.0, 8000.0)]
    >>> usual_surfacing([tuple(fixes)]), usual_surfacing([(None, *fixes[1:])])
    (900.0, 300.0)
    """
    stays = [start[0] - first[0] for first, start, _ in dives if first is not None]
    return max(LEAST_GAP, float(np.median(stays or [0.0])))


def planned_course(
    fix: Fix, target: Sequence[float], reached: float = 0.0
) -> float | None:
    """Return the course of the next dive towards a target, degrees.

    None where it is not known, or the fix after the dive is within `reached`, m, of the target.

    >>> fix = (0.0, -43.0, 8.0)
    >>> planned_course(fix, (-42.0, 8.0)), planned_course(fix, (-43.001, 8.0), 1000.0)
    (0.0, None)
    """
    if not (is_place(*target) and is_fix(*fix[1:])):
        return None
    east, north = displacement(*fix[1:], *target)
    return None if hypot(east, north) <= reached else direction(east, north)


def fixes_in(time: np.ndarray, lat: np.ndarray, lon: np.ndarray) -> list[Fix]:
    """Return the fixes of columns, of rows that can be one."""
    good = is_fix(lat, lon)
    return list(
        zip(*(column[good].tolist() for column in (time, lat, lon)), strict=True)
    )


def dive_between(
    number: int, fixes: Three, through: ThroughWater, **optional: Any
) -> Dive:
    """Make a dive, NaN as None; note where miss / duration is 10 mm/s off the file's own current.

    >>> fixes = None, (1e9, -43.0, 8.0), (1e9 + 9000, -43.0, 8.0)
    >>> through = ThroughWater((0.0, 450.0))
    >>> dive_between(1, fixes, through, dac_east=0.0, dac_north=-0.05).notes
    ()
    >>> dive_between(1, fixes, through, dac_east=0.03, dac_north=-0.05).notes
    ("position error over duration differs by 30 mm/s from the file's depth-averaged current",)
    """
    gps1 = dict(
        zip(("t_gps1", "lat_gps1", "lon_gps1"), fixes[0] or (None,) * 3, strict=True)
    )
    fields = {"track": through.track, "turned": through.turned, **gps1}
    fields |= finite_or_none(optional)
    return with_dac_note(make_dive(number, fixes[1], fixes[2], through.total, **fields))


def with_dac_note(dive: Dive) -> Dive:
    """Return a dive with a note if miss / duration is 10 mm/s off the file's own current."""
    difference = dive.dac_difference
    if not MENTIONED < difference < inf:
        return dive
    note = (
        f"position error over duration differs by {1e3 * difference:.0f} mm/s from the file's "
        "depth-averaged current"
    )
    return noted(dive, note)


def noted(dive: Dive, note: str) -> Dive:
    """Return a dive with a note, which stands there once."""
    return dive if note in dive.notes else replace(dive, notes=(*dive.notes, note))


def without_current(start: Fix, end: Fix, current: Pair) -> Pair:
    """Return the displacement through the water that a depth-averaged current (m/s) leaves, m."""
    east, north = displacement(*start[1:], *end[1:])
    duration = end[0] - start[0]
    return east - current[0] * duration, north - current[1] * duration


def reckoned(dive: Dive) -> Track:
    """Return dead reckoning: time since the fix before the dive (s), east and north (m).

    A straight line at constant speed where the dive has no track; its end fix is not read.
    """
    if dive.track is not None:
        return dive.track
    ends = np.array([[0.0, dive.duration], [0.0, dive.dr_east], [0.0, dive.dr_north]])
    return ends[0], ends[1], ends[2]


def velocity_of(course: float, speed: float) -> Pair:
    """Return the velocity to the east and to the north, m/s; NaN if it is not known.

    >>> velocity_of(90.0, 1.0)[0]
    1.0
    """
    if speed == 0:
        return 0.0, 0.0
    return speed * sin(radians(course)), speed * cos(radians(course))
