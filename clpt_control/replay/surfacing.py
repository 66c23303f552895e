"""Where a vehicle will surface next: the forecast of a dive not yet flown.

    z(T) = last fix + d + forecast of the miss

d is the planned displacement through the water and T its duration; by default both are
those of the last dive.  The vehicle starts where it surfaced last: its drift at
the surface is not known yet.  It stays up as long as it did between earlier dives,
by the median.

Hours are counted from now: from the clock where it is at most `RECENT` after the end of the
last dive, else from that end, as for a record of years ago.
"""

import time
from dataclasses import dataclass, replace
from math import hypot, isfinite, nan
from typing import Any

import numpy as np

from ..arguments import public
from ..errors import ScenarioError
from ..geodesy import place_from
from ..gliders.dives import Dive, Fix
from ..gliders.usable_dives import FASTEST
from .flow_models import carried, why_uncovered
from .outcome import at_the_surface
from .replay import ELLIPSE, Replay, ellipse
from .wording import in_minutes, utc

LONGEST = 30 * 86400.0  # s, of a plan
RECENT = 30 * 86400.0  # s; who heard nothing for longer looks at an old record
CLOCK, LAST_END = "clock", "end of the last dive"


@dataclass(frozen=True)
class NextDive:
    """A forecast surfacing: latitude and longitude in degrees.

    `plan` is a dive from the last fix without an end; `forecast` (2,), m, and `covariance` (2, 2),
    m^2, are of its fix less dead reckoning; `flow_model_covers` is None where none is given;
    `up` is when the vehicle surfaced last, s since 1970.
    """

    plan: Dive
    forecast: np.ndarray
    covariance: np.ndarray
    latitude: float
    longitude: float
    flow_model_covers: bool | None = None
    up: float = nan

    def now(self) -> tuple[float, str]:
        """Return the time that hours are counted from, s since 1970, and which it is."""
        return now_after(self.up)

    def as_dict(self) -> dict[str, Any]:
        """Return the forecast by name, for JSON: degrees, m and s."""
        now, which = self.now()
        return {
            "time": utc(self.plan.t_gpse),
            "now": utc(now),
            "now_is": which,
            "hours_from_now": (self.plan.t_gpse - now) / 3600,
            "surface_time": self.plan.t_gps2 - self.up,
            "from_latitude": self.plan.lat_gps2,
            "from_longitude": self.plan.lon_gps2,
            "duration": self.plan.duration,
            "dr_east": self.plan.dr_east,
            "dr_north": self.plan.dr_north,
            "latitude": self.latitude,
            "longitude": self.longitude,
            "place": in_minutes(self.latitude, self.longitude),
            **dict(zip(ELLIPSE, ellipse(self.covariance), strict=True)),
            "flow_model_covers": self.flow_model_covers,
            "why_uncovered": why_uncovered(self.plan) or None,
        }


def now_after(end: float) -> tuple[float, str]:
    """Return now, s since 1970, and which: the clock, or the end of a dive long ago or to come."""
    now = time.time()
    return (now, CLOCK) if 0.0 <= now - end <= RECENT else (end, LAST_END)


def check_plan(duration: float, through_water: tuple[float, float]) -> None:
    """Refuse a plan that no dive can follow: duration in s, displacement through the water in m."""
    east, north = through_water
    size = hypot(east, north)
    given = f"next dive of {duration / 3600:g} hours and {east:g} m east, {north:g} m north"
    if not (isfinite(duration) and duration > 0 and isfinite(size)):
        raise ScenarioError(f"{given}: must be finite, its duration above 0")
    if duration > LONGEST:
        raise ScenarioError(
            f"{given}: must last at most {LONGEST / 3600:g} hours (30 days); give hours, not "
            "seconds"
        )
    if size > FASTEST * duration:
        raise ScenarioError(
            f"{given}: is {size / duration:.4g} m/s through the water; at most {FASTEST:g} m/s can "
            "be; give hours and m"
        )


@public
def next_dive(
    replay: Replay, duration: float | None = None, through_water: tuple[float, float] | None = None
) -> NextDive:
    """Forecast the surfacing of the next dive.

    Parameters
    ----------
    replay : Replay
        With one dive at least.
    duration : float, optional
        Of the next dive, s; by default that of the last.
    through_water : tuple of float, optional
        Planned displacement, east and north, m; by default that of the last
        dive.

    Returns
    -------
    NextDive

    Raises
    ------
    ScenarioError
        If a plan is given that no dive can follow.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> replay = clpt.replay.replay_dives(clpt.gliders.usable(clpt.gliders.sample_dives())[0])
    >>> found = clpt.replay.next_dive(replay, 18000.0, (0.0, 3000.0))
    >>> -42.93 < found.latitude < -42.89
    True
    """
    last = replay.steps[-1].dive
    T = last.duration if duration is None else duration
    east, north = (last.dr_east, last.dr_north) if through_water is None else through_water
    if duration is not None or through_water is not None:
        check_plan(T, (east, north))
    track = _like(last, T, east, north) if through_water is None else None
    return forecast_dive(replay, next_start(replay), T, (east, north), track)


def next_start(replay: Replay) -> Fix:
    """Return when and where the next dive begins: s since 1970, degrees."""
    last = replay.steps[-1].dive
    surface = at_the_surface([step.dive for step in replay.steps])
    return last.t_gpse + surface, last.lat_gpse, last.lon_gpse


def forecast_dive(
    replay: Replay, start: Fix, T: float, through_water: tuple[float, float], track: Any = None
) -> NextDive:
    """Forecast the end of a dive of T s and a displacement through the water, m, from a start."""
    last = replay.steps[-1].dive
    plan = Dive(
        last.number + 1,
        *start,
        start[0] + T,
        *(nan, nan, nan, nan),
        *through_water,
        depth_max=last.depth_max,
        track=track,
    )
    covers = None
    if replay.flow_model is not None:
        plan = carried(plan, replay.flow_model)
        covers = plan.model_east is not None
    mean, covariance = replay.forecast(plan)
    way = through_water[0] + mean[0], through_water[1] + mean[1]
    place = place_from(*start[1:], *way)
    return NextDive(replace(plan, track=None), mean, covariance, *place, covers, last.t_gpse)


def _like(last: Dive, T: float, east: float, north: float) -> tuple | None:
    """Return the last dive's track, stretched in time to the next one."""
    if last.track is None:
        return None
    time, *through_water = last.track
    return (time * (T / last.duration), *through_water)
