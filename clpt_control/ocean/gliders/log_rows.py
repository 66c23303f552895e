"""Rows of a vehicle's log in their order: the screen that they pass.

A row has a time and parts: a fix, the course and speed that hold until the next row, or the
displacement since the row before.  These are left out, each with its reason:

    a row that is not in the order of time, as most rows are
    a row at the time of the last one, unless it adds a fix, or another course and speed
    a fix at 0 N 0 E, or that is no place on Earth
    a stretch above 5 m/s through the water, or of unknown speed: the motion until then is unknown

After a motion that is left out, and was not read before, the motion is unknown until the next one.
"""

from dataclasses import dataclass, field
from math import hypot, isfinite, nan
from typing import NamedTuple

from ...base.units import iso
from .dives import FASTEST, STEERING, STRETCH, Pair, is_fix, velocity_of
from .usable_dives import LATEST, LONGEST, misread

NOT_GIVEN, NOT_MOVED = "no course and speed", "no displacement"
STAYS = f"{NOT_GIVEN} before it", f"{NOT_MOVED} before it"  # ends of their reasons
ROUNDING = 1.0 + 1e-9
REPEATED = 100  # rows that a logger may write again
DEG_E7 = 1e6  # a larger number of a place is in units of 1e-7 degrees


class Reading(NamedTuple):
    """Parts of a row that count: displacement since the row before (m) and fix (degrees).

    `moved` is None where it is not known, of which `unknown` has the reason; `skipped` has the
    reason for which the row, or a part of it, is left out, and `cure` what to do.
    """

    moved: Pair | None = None
    fix: Pair | None = None
    unknown: str = ""
    skipped: str = ""
    is_taken: bool = True
    cure: str = ""


@dataclass
class LogRows:
    """Reader of rows: the time of the last one, its fix, and the velocity since."""

    time: float = nan  # s since 1970 UTC
    velocity: Pair = (nan, nan)  # m/s to the east and north
    unknown: str = NOT_GIVEN  # why the velocity is not known
    had_fix: bool = False  # whether a row at this time had one
    lost: str = ""  # why a row before the next one is not known
    dropped: int = 0  # fixes at the time of another
    recent: list[str] = field(default_factory=list)  # motions that were read

    def read(
        self,
        time: float,
        fix: Pair | None,
        steering: Pair | None,
        stretch: Pair | None,
        in_order: bool,
    ) -> Reading:
        """Read a row: fix (degrees), course and speed (degrees, m/s), displacement (m).

        None is a part that the row has not, NaN an unknown one. All rows of a log have the same
        parts, but the fix.
        """
        has_fix = fix is not None
        has_motion = steering is not None or stretch is not None
        motion = repr((time, steering, stretch))
        is_new = has_motion and motion not in self.recent
        adds = (has_fix and not self.had_fix) or (steering is not None and is_new)
        fault = time_fault(time)
        cure = ""
        if not fault and not (in_order and (adds or time != self.time)):
            fault = f"dated {iso(time)}, not later than the row before or after rows behind it"
            cure = ". Sort the rows by time, each with its own"
        if fault:
            if is_new:
                self.lost = "a motion is left out"
            return Reading(skipped=fault, is_taken=False, cure=cure)
        if fix is not None and (fault := place_fault(*fix)):
            fix = None
            if not has_motion:
                return Reading(skipped=fault, is_taken=False)
        if time == self.time and self.had_fix and fix is not None:
            self.dropped += 1
            fix = None
        moved, unknown = self._moved(time, stretch)
        if self.lost:
            moved = None
            unknown = self.lost
            self.velocity = (nan, nan)
            self.unknown = self.lost
        self.lost = ""
        self.recent = [*self.recent[1 - REPEATED :], motion]
        if steering is not None:
            self.velocity = velocity_of(*steering)
            self.unknown = _half(steering, STEERING) or NOT_GIVEN
        self.had_fix = has_fix or (time == self.time and self.had_fix)
        self.time = time
        return Reading(moved, fix, unknown, fault)

    def _moved(self, time: float, stretch: Pair | None) -> tuple[Pair | None, str]:
        """Return the displacement since the row before, or why it is not known."""
        span = time - self.time
        if not isfinite(span) or (span == 0.0 and stretch is None):
            return None, ""
        if span > LONGEST:
            return None, f"{span / 86400:.0f} days without a row"
        if stretch is None:
            east, north = self.velocity
            moved = east * span, north * span
            unknown = self.unknown
        else:
            moved = stretch
            unknown = _half(stretch, STRETCH) or NOT_MOVED
        speed = hypot(*moved) / span if span > 0.0 else 0.0
        if not isfinite(speed):
            return None, unknown
        if speed > FASTEST * ROUNDING:
            return None, (
                f"{speed:.3g} m/s through the water; at most {FASTEST:g} m/s can be. Are speeds in "
                "knots or km/h? Give m/s, or the unit: speed (kn). Are displacements since the "
                "last fix? Give those since the row"
            )
        return moved, ""


def _half(pair: Pair, names: tuple[str, str]) -> str:
    """Return that one number of a pair is missing, empty if none or both are."""
    is_half = isfinite(pair[0]) != isfinite(pair[1])
    return f"one of {' and '.join(names)} is missing" if is_half else ""


def time_fault(time: float) -> str:
    """Return why a time cannot be, empty where it can.

    >>> time_fault(1.7e12)
    'time 1700000000000 looks like milliseconds since 1970. Give seconds, or name it time (ms)'
    """
    for unit, name, size in (("milliseconds", "ms", 1e3), ("microseconds", "us", 1e6)):
        if 1e9 < time / size < LATEST:
            return (
                f"time {time:.15g} looks like {unit} since 1970. Give seconds, or name it time "
                f"({name})"
            )
    if 0.0 <= time < LATEST:
        return ""
    return f"time {time:.15g}: must be from 1970 to {iso(LATEST)[:4]}"


def place_fault(latitude: float, longitude: float) -> str:
    """Return why a place is no fix, empty where it can be one.

    >>> place_fault(0.0, 0.0), place_fault(36.7, -122.1)
    ('0 N 0 E: a receiver without a fix', '')
    """
    if is_fix(latitude, longitude):
        return ""
    if latitude == longitude == 0.0:
        return "0 N 0 E: a receiver without a fix"
    if not (isfinite(latitude) and isfinite(longitude)):
        return "no fix: has one of latitude and longitude. Give both"
    if max(abs(latitude), abs(longitude)) > DEG_E7:
        cure = "looks like 1e-7 degrees. Give degrees, or name them latitude (degE7)"
    else:
        cure = misread(latitude, longitude) or "must be degrees"
    return f"latitude {latitude:g}, longitude {longitude:g}: {cure}"
