"""Dives that can be used, and why the others cannot.

A dive needs both fixes, a time and a place each, in their order, and a finite
displacement through the water; no speed that follows from them may be above 5 m/s.
An end fix with exactly the place of the start fix is the start fix repeated, so it is no fix.
Times are those of the years 1970 to 2200.

Between two dives a vehicle drifts at the surface, or makes dives that are not known.  A dive that
starts further than

    max(5 m/s * time between them, `ASTRAY`)

from both fixes of the one before is of another vehicle.  What is less far, and yet further than it
can be, tells of a wrong fix, which costs no dive: a replay judges it (`forecast.quality_control`).

A record ends at a break of more than a day, or where the next dive starts beyond

    2 m/s * time between them + 5 km

(`_reaches`), which no current carries a vehicle.  Only the last record is used, because currents
and errors that were learned in one record are wrong in another.
"""

import re
from collections.abc import Iterable, Sequence
from itertools import pairwise
from math import hypot, isfinite
from operator import attrgetter

import numpy as np

from ...base.errors import DataError
from ...base.geodesy import displacement, distance, is_place
from ...base.units import DAY, iso, seconds_since_1970
from .dive_fields import FILLS, NUMBERS
from .dives import FASTEST, Dive, DivesAndSkipped, Fix, Skipped, is_fix, noted
from .samples import degrees

LEAST_DURATION = 1000.0  # s: shelf gliders dive for half an hour, trials for minutes
LAST_YEAR = 2200
LATEST = seconds_since_1970(f"{LAST_YEAR}-01-01")
# in one second
SMALLER = {"milliseconds": 1e3, "microseconds": 1e6, "nanoseconds": 1e9}
LONGER = {"days": DAY, "hours": 3600.0, "minutes": 60.0}  # s
FIRST_GLIDERS = seconds_since_1970("1990-01-01")
LONGEST = 30 * DAY  # s of a dive
FEW = 3  # dives that may all be wrong
OVERLAP = 60.0  # s that neighbours may share by rounding
MISSION = 1000  # dives: a larger step in the numbers is another mission
SHARE = 0.5  # of the shorter neighbour's time: a missing dive takes more; some number surfacings
OWN = "replay each on its own"
ASTRAY = 50e3  # m that a fix may be off, however short the time
COPY = 10.0  # m: ends of copies of a dive differ by rounding
DRIFT = 2.0  # m/s, fastest at the surface
CURRENT = 1.0  # m/s, fastest over a whole dive
NEAR = 5e3  # m: within it a dive continues the record; the largest step of real records is 2.4 km
ROLLOVER = 1024 * 7 * DAY  # s: a GPS receiver counts weeks to 1024, then begins again
MISSION_LENGTH = 400 * DAY  # s: longest mission across a rollover that is looked for
REGION = 1000e3  # m: places of one mission about a rollover
NO_WAY = (
    "the displacement through the water is exactly 0. Unless it drifts, check "
    "the units and signs of depth, pitch and speed in its files"
)
ADD_WEEKS = f"add 1024 weeks, {ROLLOVER:.0f} s, to each early time"


def usable(
    dives: Iterable[Dive], least_duration: float = LEAST_DURATION
) -> DivesAndSkipped:
    """Sort dives by time and leave out those that cannot be used.

    Returns used dives by time, and the others, each with its reason.  Whether a dive is used
    depends on earlier ends, and on later dives only if one of them begins a new record.

    >>> from clpt_control.ocean.gliders.dives import make_dive
    >>> fixes = (0.0, -43.0, 8.0), (9000.0, -43.0, 8.01)
    >>> dives = [make_dive(7, *fixes, (500.0, 0.0)), make_dive(8, *fixes, (float("nan"), 0.0))]
    >>> used, skipped = usable(dives)
    >>> [dive.number for dive in used], skipped[0].dive, skipped[0].why
    ([7], 8, 'the displacement through the water is not finite: a value is missing or means none')
    """
    fit = []
    skipped = []
    latest = -np.inf
    dives = list(dives)
    check_one_vehicle(dives)
    _check_speeds(dives)
    repeated = _with_a_repeated_start(dives)
    for dive in dives:
        why = _fault(dive, least_duration)
        if not why and id(dive) in repeated:
            why = (
                "no fix before the dive: its place is exactly that before the last dive"
            )
        if why:
            skipped.append(Skipped(dive.number, "; ".join((why, *dive.notes))))
            continue
        if dive.t_gpse < latest:
            dive = noted(dive, "came after a later dive, sorted by time")
        latest = max(latest, dive.t_gpse)
        fit.append(dive)
    ordered = sorted(fit, key=_by_time)
    check_weeks(ordered)
    used = ordered[:1]
    astray = None
    for dive in ordered[1:]:
        before = used[-1]
        overlap = _overlap(dive, before)
        too_far = _too_far(dive, before)
        if overlap or (too_far and not (astray and _reaches(dive, astray))):
            skipped.append(Skipped(dive.number, overlap or too_far))
            astray = None if overlap else dive
            continue
        astray = None
        if break_before := _break_before(dive, before):
            why = f"of an earlier record: dive {dive.number} begins a new one, {break_before}"
            skipped += [
                Skipped(dive_before.number, f"{why}; {OWN}") for dive_before in used
            ]
            used = [noted(dive, f"begins a new record, {break_before}")]
            continue
        missing = dive.number - before.number - 1
        if 0 < missing < MISSION and not follows(dive, before):
            dive = noted(dive, f"{missing} dive(s) missing after dive {before.number}")
        used.append(dive)
    used = [dive if any(dive.through_water) else noted(dive, NO_WAY) for dive in used]
    return used, skipped


def last_fix(dives: Iterable[Dive], last: Dive) -> Fix:
    """Return the end of the last used dive, or a later end within reach of a dive without use."""

    def is_later(dive: Dive) -> bool:
        since = dive.t_gpse - last.t_gpse
        is_at_once = dive.t_gps2 < last.t_gpse - OVERLAP
        return (
            0.0 < since <= DAY
            and not (is_at_once or dive.t_gps2 >= dive.t_gpse or dive.end == dive.start)
            and not _fix_fault("after", dive.t_gpse, *dive.end)
            and distance(*last.end, *dive.end) <= DRIFT * since + NEAR
        )

    later = [(dive.t_gpse, *dive.end) for dive in dives if is_later(dive)]
    return max(later, default=(last.t_gpse, *last.end))


def check_one_vehicle(dives: Iterable[Dive]) -> None:
    """Refuse dives of several vehicles; case and punctuation of a name do not count."""
    names = {
        re.sub(r"[\W_]", "", dive.vehicle).casefold(): dive.vehicle
        for dive in dives
        if dive.vehicle
    }
    if len(names) > 1:
        listing = ", ".join(sorted(names.values()))
        raise DataError(
            f"{listing}: are {len(names)} vehicles in one replay. Give the files of one, or "
            "clpt watch FOLDER --fleet, which replays each vehicle of a folder on its own"
        )


def _check_speeds(dives: Sequence[Dive]) -> None:
    """Refuse dives of which most move faster through the water than any vehicle."""
    fast = [d for d in dives if hypot(*d.through_water) > FASTEST * d.duration > 0.0]
    if len(fast) > max(FEW, len(dives) / 2):
        by_dac = any("dac_east" in note for note in fast[0].notes)
        columns = "dac_east, dac_north" if by_dac else "dr_east_m, dr_north_m"
        raise DataError(
            f"{len(fast)} of {len(dives)} legs move more than {FASTEST:g} m/s through the water: "
            f"check the unit of {columns}, {'m/s, not cm/s' if by_dac else 'm'}, and the times"
        )


def check_weeks(dives: Iterable[Dive]) -> None:
    """Refuse dives, by time, of which some are dated about 1024 weeks before the others.

    Dates go back so far when a receiver's count of GPS weeks begins again.
    """
    for early, dive in pairwise(dives):
        off = abs(dive.t_gps2 - early.t_gpse - ROLLOVER)
        in_one_region = distance(*early.end, *dive.start) < REGION
        if off < MISSION_LENGTH and in_one_region:
            dated = [f"dive {d.number} of {iso(d.t_gpse)[:10]}" for d in (early, dive)]
            raise DataError(
                f"{' and '.join(dated)}: are in one region about 1024 weeks apart, as if the "
                f"GPS week had begun again; {ADD_WEEKS}, or {OWN} if these are two missions"
            )


def follows(dive: Dive, before: Dive) -> bool:
    """Return whether a dive is the next one, by numbers and times."""
    since = dive.t_gps2 - before.t_gpse
    return dive.number == before.number + 1 or since <= SHARE * min(
        dive.duration, before.duration
    )


def _fault(dive: Dive, least_duration: float) -> str:
    """Return why a dive alone cannot be used, empty where it can."""
    if not abs(dive.number) < NUMBERS:
        return (
            f"its number is {dive.number:.6g}; must be a whole number below {NUMBERS}"
        )
    why = _fix_fault("before", dive.t_gps2, *dive.start)
    why = why or _fix_fault("after", dive.t_gpse, *dive.end)
    if why:
        return why
    if abs(dive.duration + ROLLOVER) < MISSION_LENGTH:
        return f"the fix after the dive is 1024 weeks before its start: {ADD_WEEKS}"
    if dive.duration <= 0:
        return f"the fix after the dive is {-dive.duration:.0f} s before its start: swapped times"
    if dive.end == dive.start:
        return "no fix after the dive: its place is exactly that of the fix before the dive"
    if not (isfinite(dive.dr_east) and isfinite(dive.dr_north)):
        return "the displacement through the water is not finite: a value is missing or means none"
    if dive.dr_east == dive.dr_north and -abs(dive.dr_east) in FILLS:
        return f"the displacement through the water is {dive.dr_east:g} m twice, a fill value"
    if not dive.duration > least_duration:
        if unit := _longer_unit(dive, least_duration):
            return (
                f"its times {dive.t_gps2:.10g} and {dive.t_gpse:.10g} look like {unit} since "
                "1970; must be seconds since 1970 UTC, or dates such as 2016-01-31T22:04:50Z"
            )
        least = f"{least_duration:g} s (--least-duration)"
        return f"lasts {dive.duration:.6g} s; must last longer than {least}"
    for name, length in (
        ("between the fixes", hypot(*dive.over_ground)),
        ("through the water", hypot(*dive.through_water)),
    ):
        if length > FASTEST * dive.duration:
            return (
                f"the displacement {name} is {length / 1000:.4g} km, "
                f"{length / dive.duration:.3g} m/s; at most {FASTEST:g} m/s can be"
            )
    return ""


def _longer_unit(dive: Dive, least_duration: float) -> str:
    """Return the unit longer than s in which the times of a short dive are, empty if none is.

    >>> from clpt_control.ocean.gliders.dives import make_dive
    >>> fixes = (18518.5, 40.0, 8.0), (18518.65, 40.0, 8.1)
    >>> _longer_unit(make_dive(1, *fixes, (0.0, 0.0)), 1000.0)
    'days'
    """
    for unit, size in LONGER.items():
        is_recent = FIRST_GLIDERS < size * dive.t_gps2 < LATEST
        if is_recent and least_duration < size * dive.duration < LONGEST:
            return unit
    return ""


def _with_a_repeated_start(dives: list[Dive]) -> set[int]:
    """Return the ids of dives with the start fix of the dive before, which also ends there.

    The receiver then had no fix between the two dives.
    """
    timed = sorted(
        (dive for dive in dives if isfinite(dive.t_gps2)), key=attrgetter("t_gps2")
    )
    return {
        id(dive)
        for before, dive in pairwise(timed)
        if dive.t_gps2 >= before.t_gpse and before.start == before.end == dive.start
    }


def _fix_fault(name: str, time: float, lat: float, lon: float) -> str:
    """Return what is wrong with one fix, empty where it is good."""
    if why := misread(lat, lon):
        return (
            f"the fix {name} the dive is at latitude {lat:g}, longitude {lon:g}: {why}"
        )
    is_time = 0.0 <= time < LATEST
    if not (isfinite(time) and is_fix(lat, lon)):
        when = iso(time) if is_time else f"{time:g}"
        return (
            f"no fix {name} the dive (time {when}, latitude {lat:g}, longitude {lon:g})"
        )
    if is_time:
        return ""
    years = f"must be from 1970 to {LAST_YEAR}"
    return f"the fix {name} the dive is at {time:.10g} s since 1970; {years}"


def misread(lat: float, lon: float) -> str:
    """Return how a place looks if it is swapped, or in degrees and minutes; empty if it is none.

    >>> misread(5141.048, -12818.018)
    'looks like ddmm.mmm, degrees and minutes. Give decimal degrees, 51.684133 -128.300300'
    >>> misread(-128.3, 51.68)
    'latitude must be from -90 to 90. Are latitude and longitude swapped?'
    >>> misread(51.68, -128.3), misread(199.0, 8.0)
    ('', '')
    """
    if 90.0 < abs(lat) <= 180.0 and abs(lon) <= 90.0:
        return "latitude must be from -90 to 90. Are latitude and longitude swapped?"
    if not (abs(lat) > 360.0 or (abs(lat) > 90.0 and abs(lon) > 360.0)):
        return ""
    in_degrees = degrees(np.array([lat, lon])).tolist()
    if not (is_place(*in_degrees) and abs(in_degrees[1]) <= 180.0):
        return ""
    return (
        "looks like ddmm.mmm, degrees and minutes. Give decimal degrees, "
        f"{in_degrees[0]:.6f} {in_degrees[1]:.6f}"
    )


def _by_time(dive: Dive) -> tuple:
    """Return the key that puts dives in one order: end, start, number, then all else."""
    order = dive.t_gpse, dive.t_gps2, dive.number
    return (*order, *dive.through_water, dive.track is None, repr(vars(dive)))


def _overlap(dive: Dive, before: Dive) -> str:
    """Return how a dive overlaps one that is used and ended before it, empty where not."""
    if dive.t_gps2 >= before.t_gpse - OVERLAP:
        return ""
    if (dive.t_gps2, dive.t_gpse) == (before.t_gps2, before.t_gpse):
        return f"duplicate of dive {before.number}, which is used"
    return (
        f"overlaps dive {before.number}, which is used: starts "
        f"{before.t_gpse - dive.t_gps2:.0f} s before that ends"
    )


def is_other_at_once(dive: Dive, other: Dive) -> bool:
    """Return whether the next dive by start time starts during a dive, and is no copy of it."""
    separation = distance(*dive.end, *other.end)
    is_copy = abs(dive.t_gpse - other.t_gpse) < OVERLAP and separation < COPY
    return other.t_gps2 < dive.t_gpse - OVERLAP and not is_copy


def _break_before(dive: Dive, before: Dive) -> str:
    """Return how a dive begins a new record after the one before, empty where it does not."""
    since = dive.t_gps2 - before.t_gpse
    if since <= DAY and _reaches(dive, before):
        return ""
    separation = distance(*before.end, *dive.start)
    return (
        f"{separation / 1000:.1f} km and {max(since, 0.0) / 3600:.1f} h from the end of "
        f"dive {before.number}"
    )


def _reaches(dive: Dive, before: Dive) -> bool:
    """Return whether a vehicle can come from one dive to the next, which does not overlap it.

    By the fixes between the two dives, or by dead reckoning past one of them, which may be wrong.
    """
    since = dive.t_gps2 - before.t_gpse

    def carried(
        flown: Dive, begin: tuple[float, float], stop: tuple[float, float]
    ) -> bool:
        east, north = displacement(*begin, *stop)
        off = hypot(east - flown.dr_east, north - flown.dr_north)
        return off <= CURRENT * (since + flown.duration) + NEAR

    return since >= -OVERLAP and (
        distance(*before.end, *dive.start) <= DRIFT * max(since, 0.0) + NEAR
        or carried(before, before.start, dive.start)
        or carried(dive, before.end, dive.end)
    )


def _too_far(dive: Dive, before: Dive) -> str:
    """Return how far from both fixes of the one before a dive starts, empty where it can.

    Also empty after a day, when another record begins.
    """
    since = dive.t_gps2 - before.t_gpse
    start = dive.start
    separation = distance(*before.end, *start)
    most = max(FASTEST * since, ASTRAY)
    if since > DAY or min(separation, distance(*before.start, *start)) <= most:
        return ""
    return (
        f"starts {separation / 1000:.0f} km from where dive {before.number} ended "
        f"{max(since, 0.0) / 3600:.1f} h before; another vehicle? {OWN}"
    )
