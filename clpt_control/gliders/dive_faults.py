"""Why a dive alone cannot be used: its number, fixes, times and speeds.

A dive needs both fixes, a time and a place each, in their order, and a finite
way through the water; no speed that it says may be above 5 m/s.  Times are those
of the years 1970 to 2200 (`nodal.YEARS`, where tides end too): what lies outside
is most often in another unit, which is named where it would bring the time there.
"""

from datetime import UTC, datetime
from math import hypot, isfinite
from typing import TYPE_CHECKING

from ..currents.nodal import YEARS
from ..geodesy import is_place

if TYPE_CHECKING:
    from .dives import Dive

FASTEST = 5.0  # m/s: no current and no glider is faster, so a fix or a sum is wrong
NUMBERS = 2**31  # dive numbers are smaller, as files keep them in 32 bits
LATEST = datetime(YEARS[1], 1, 1, tzinfo=UTC).timestamp()  # s since 1970
DAY = 86400.0  # s
SMALLER = {"milliseconds": 1e3, "microseconds": 1e6, "nanoseconds": 1e9}  # in one second


def whole_number(value: float | str | None) -> int | None:
    """Return the number of a dive, or None where it is none.

    Parameters
    ----------
    value : float, str or None
        As a file has it.

    Returns
    -------
    int or None
        A whole number below 2147483648 in size.

    Examples
    --------
    >>> whole_number("7"), whole_number(7.5), whole_number("1e10"), whole_number("x")
    (7, None, None, None)
    """
    try:
        number = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        return None
    return int(number) if number.is_integer() and abs(number) < NUMBERS else None


def fault_of(dive: "Dive", least_duration: float) -> str:
    """Say why a dive alone cannot be used.

    Parameters
    ----------
    dive : Dive
        Any.
    least_duration : float
        Longest duration that is too short, s.

    Returns
    -------
    str
        Empty where it can.
    """
    if not abs(dive.number) < NUMBERS:
        return f"its number is {dive.number:.6g}; must be a whole number below {NUMBERS}"
    why = _fix_fault("before", dive.t_gps2, dive.lat_gps2, dive.lon_gps2)
    why = why or _fix_fault("after", dive.t_gpse, dive.lat_gpse, dive.lon_gpse)
    if why:
        return why
    if dive.duration <= 0:
        return f"the fix after the dive is {-dive.duration:.0f} s before its start: swapped times"
    if not (isfinite(dive.dr_east) and isfinite(dive.dr_north)):
        return "the displacement through the water is not finite"
    if not dive.duration > least_duration:
        days = dive.t_gpse < LATEST / DAY and dive.duration * DAY > least_duration
        lasts = f"{dive.duration:.0f}" if dive.duration > 10 else f"{dive.duration:.2g}"
        return (
            f"lasts {lasts} s; must last longer than {least_duration:g} s"
            f"{': its times look like days, give seconds since 1970' if days else ''}"
        )
    for name, way in (
        ("the way between the fixes", hypot(dive.gps_east, dive.gps_north)),
        ("the way through the water", hypot(dive.dr_east, dive.dr_north)),
    ):
        if way > FASTEST * dive.duration:
            return (
                f"{name} is {way / 1000:.4g} km, {way / dive.duration:.3g} m/s; "
                f"at most {FASTEST:g} m/s can be"
            )
    return ""


def _fix_fault(name: str, time: float, lat: float, lon: float) -> str:
    """Say what is wrong with one fix; empty where it is good."""
    if isfinite(time) and isfinite(lat) and isfinite(lon):
        if 90.0 < abs(lat) <= 360.0 and abs(lon) <= 360.0:
            swapped = ": swapped with the longitude?" if abs(lon) <= 90.0 else ""
            return (
                f"the fix {name} the dive has the latitude {lat:g}, which is none; "
                f"must be -90 to 90{swapped}"
            )
        if abs(lat) <= 90.0 and 360.0 < abs(lon) <= 720.0:
            return f"the fix {name} the dive has the longitude {lon:g}; must be -360 to 360"
    if not (isfinite(time) and is_place(lat, lon)):
        return f"no fix {name} the dive (time {time:g}, latitude {lat:g}, longitude {lon:g})"
    if lat == lon == 0.0:
        return f"no fix {name} the dive: 0 N 0 E is what a receiver without a fix gives"
    if 0.0 <= time < LATEST:
        return ""
    unit = next((unit for unit, size in SMALLER.items() if 0.0 < time / size < LATEST), "")
    return (
        f"the fix {name} the dive is at {time:.10g} s since 1970; must be from 1970 to {YEARS[1]}"
        f"{f': it looks like {unit}, give seconds' if unit else ''}"
    )
