"""Forecast of the next surfacing: place and time.

It is the forecast of a dive not yet flown,

    z(T) = last fix + drift at the surface + d + forecast of the miss

d is the displacement through the water and T the duration of the dive, as planned, as aimed or as
`DiveStatistics` expects.  The ellipse and the time are for 90 %: of the miss, of the drift, of the
scatter of d and T (d by the learned speed and compass), as wide as their own record asks.

Hours are counted from now: from the clock where it is at most `RECENT` after the end of the
last dive, else from that end, as for a record of years ago.
"""

import time
from dataclasses import dataclass
from math import nan
from statistics import NormalDist
from typing import Any

import numpy as np

from ...base.errors import ScenarioError
from ...base.geodesy import displacement
from ...base.units import seconds_since_1970
from ..estimation.fix_model import LEVEL
from ..gliders.dives import Dive, Fix
from ..gliders.usable_dives import FASTEST
from .dive_statistics import CHI_SQUARED, REPEATED, Guess
from .geographic import clock, in_minutes, placed, utc, vector
from .quality_flags import squared_distance

NORMAL = NormalDist().inv_cdf((1.0 + LEVEL) / 2.0)  # standard deviations
SHORTEST, LONGEST = 1.0, 30 * 86400.0  # s, of a plan
RECENT = 30 * 86400.0  # s; a record whose last dive ended earlier is old
CLOCK, LAST_END = "clock", "end of the last dive"
# as `ellipse` has them
ELLIPSE = ("ellipse_long", "ellipse_short", "ellipse_bearing")


def ellipse(covariance: np.ndarray) -> tuple[float, float, float]:
    """Return half axes of the 90 % ellipse (m) and the bearing of the long one (degrees).

    The covariance (2, 2) is east and north, m^2; the bearing clockwise from north, 0 to 180.
    """
    size, axes = np.linalg.eigh(covariance)
    short, long = np.sqrt(CHI_SQUARED * size)
    bearing = np.degrees(np.arctan2(axes[0, 1], axes[1, 1])) % 180.0
    return float(long), float(short), float(bearing)


@dataclass(frozen=True)
class NextDive:
    """A forecast surfacing: latitude and longitude in degrees.

    `plan` is a dive from where it should begin, without an end; `forecast` (2,), m, is of its fix
    less dead reckoning; `covariance` (2, 2), m^2, of the place, whose 90 % ellipse is as wide as
    the record asks; the time holds 90 % within `time_half_width`, s; `fix` is where and when the
    vehicle surfaced last; `basis` is what the dive is guessed by; `plan_in_files` says that the
    last file has a course for the dive.
    """

    plan: Dive
    forecast: np.ndarray
    covariance: np.ndarray
    latitude: float
    longitude: float
    fix: Fix = (nan, nan, nan)
    time_half_width: float = nan
    basis: str = REPEATED
    plan_in_files: bool = False

    def __repr__(self) -> str:
        when = f"{clock(utc(self.plan.t_gpse))} +- {self.time_half_width / 60:.0f} min"
        return f"<NextDive: up {when} at {in_minutes(self.latitude, self.longitude)}>"

    def now(self) -> tuple[float, str]:
        """Return now, s since 1970, and which: the clock, or the end of a dive not just ended."""
        now, end = time.time(), self.fix[0]
        return (now, CLOCK) if 0.0 <= now - end <= RECENT else (end, LAST_END)

    def holds(self, dive: Dive) -> tuple[bool, bool]:
        """Return whether the end of the dive is inside the ellipse, and within the time."""
        away = np.array(displacement(self.latitude, self.longitude, *dive.end))
        inside = squared_distance(away, np.zeros(2), self.covariance) <= CHI_SQUARED
        return inside, abs(dive.t_gpse - self.plan.t_gpse) <= self.time_half_width

    def as_dict(self) -> dict[str, Any]:
        """Return the forecast by name, for JSON: degrees, m and s."""
        now, clock_name = self.now()
        return {
            "time": utc(self.plan.t_gpse),
            "time_half_width": self.time_half_width,
            "now": utc(now),
            "now_is": clock_name,
            "hours_from_now": (self.plan.t_gpse - now) / 3600,
            "surface_time": self.plan.t_gps2 - self.fix[0],
            **placed("from_", *self.fix[1:]),
            **placed("start_", *self.plan.start),
            "basis": self.basis,
            "plan_in_files": self.plan_in_files,
            "duration": self.plan.duration,
            **vector("dr_", *self.plan.through_water),
            **placed("", self.latitude, self.longitude),
            "place": in_minutes(self.latitude, self.longitude),
            **dict(zip(ELLIPSE, ellipse(self.covariance), strict=True)),
            "why_uncovered": self.plan.uncovered,
        }


def unflown(last: Dive, start: Fix, guess: Guess) -> Dive:
    """Return a dive without an end, straight and at constant speed."""
    east, north = map(float, guess.way)
    end, no = start[0] + guess.duration, (nan, nan, nan, nan)
    return Dive(
        last.number + 1, *start, end, *no, east, north, depth_max=last.depth_max
    )


def overdue_times(ahead: dict[str, Any], end: str) -> tuple[float, float]:
    """Return from when until when a vehicle is overdue, s since 1970.

    `ahead` is `NextDive.as_dict`, `end` the end of the last dive.
    """
    late = seconds_since_1970(ahead["time"]) + ahead["time_half_width"]
    return late, seconds_since_1970(end) + RECENT


def check_flown(speed: float, duration: float) -> None:
    """Refuse a speed through the water (m/s) or a duration (s) that no dive can have."""
    if not (SHORTEST <= duration <= LONGEST and 0 <= speed <= FASTEST):
        raise ScenarioError(
            f"a dive of {duration / 3600:g} hours at {speed:.4g} m/s through the water: give "
            f"{SHORTEST:g} s to {LONGEST / 3600:g} hours and at most {FASTEST:g} m/s"
        )
