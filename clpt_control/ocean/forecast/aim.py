"""Aiming: the heading by which current and errors of the vehicle lead to a waypoint.

A dive of duration T ends, from its start, at w + c: c is what the forecast current does,
tides at that time with it, and w the way through the water,

    w = (I + M) d,   I + M = f [[cos psi, sin psi], [-sin psi, cos psi]],   |d| <= D = V T,

d as the vehicle reckons it, f its speed factor and psi its compass error.  So |w| <= s = f D.
For a waypoint at g from the start:

1. |g - c| <= s: the dive ends there, by w = g - c.
2. Else the vehicle keeps to the line, as in the triangle of currents, and is there after
   tau dives, the least root above 0 of  |g - tau c| = tau s,  by  w = g / tau - c.  The angle
   between w and the line has the sine (current across the line) / s.
3. No such root: it cannot be made against this current.  w along g - c ends the dive as near
   as can be.

Roots below 1 only say that the current carries it past: then the dive must be shorter.
Where c depends on the way, as with gaussians and flow models, d and c are found by iteration.
"""

from collections.abc import Sequence
from math import ceil, hypot, sqrt
from statistics import median
from typing import Any

import numpy as np

from ...base.arguments import public
from ...base.errors import ScenarioError
from ...base.geodesy import angle_near, displacement, distance, is_place
from ...base.units import finite_or_none
from ..gliders.dives import Fix
from ..gliders.samples import variation as igrf
from .surfacing import NextDive, check_flown, ellipse
from .table_rows import (
    AGAINST,
    REACHED,
    UNDER_WAY,
    Place,
    Row,
    against,
    clock,
    compass,
    direction,
    ellipse_words,
    heading_words,
    in_minutes,
    place,
    placed,
    utc,
    vector,
)

YEAR = 365 * 24.0  # hours
DIVES = 5  # the last ones, of which speed and duration are the medians
ARRIVED = 1000.0  # m; a vehicle this close to a waypoint goes on to the next one
ITERATIONS, CLOSE = 20, 1.0  # of d and c, and m by which the last may change c


class Aim:
    """Steering of a dive to a waypoint: lengths in m, angles in degrees from true north.

    `ahead` is the dive as forecast when it is steered so; `bearing` and `distance` are of the
    waypoint from its start, `heading` what to command, None to stay in place, `crab` heading less
    bearing. `through_water` of the `through_water_full` that speed and time allow is to be flown,
    as the vehicle reckons it; `made_good` is how much nearer to the waypoint the dive should end,
    `left` how far from it. `dives` is how many such dives it takes, `hours` how long with the stays
    between them, None where the waypoint cannot be made; `current` east and north and
    `speed_expected` through the water are what is expected, m/s. The magnetic variation is None
    where it is not known.
    """

    def __init__(
        self,
        ahead: NextDive,
        target: Place,
        V: float,
        T: float,
        c: np.ndarray,
        s: float,
        state: str,
        tau: float | None,
        stay: float,
    ):
        """Work out how a dive is steered that was planned as T s at V m/s, in what carries it c.

        It goes s through the water, and with stays between them tau of it reach the target.
        """
        plan = ahead.plan
        self.ahead = ahead
        self.target = target
        g = displacement(*plan.start, *target)
        self.distance = hypot(*g)
        self.bearing = direction(*g)
        self.heading = direction(*plan.through_water)
        self.crab: float | None = None
        if self.heading is not None and self.bearing is not None:
            self.crab = angle_near(self.heading - self.bearing, 0.0)
        self.speed = V
        self.speed_expected = s / T
        self.current = float(c[0]) / T, float(c[1]) / T
        self.through_water = hypot(*plan.through_water)
        self.through_water_full = V * T
        self.left = distance(ahead.latitude, ahead.longitude, *target)
        self.made_good = self.distance - self.left
        self.state = state
        self.dives = tau
        self.hours = tau
        if tau is not None:
            self.hours = (tau * plan.duration + (ceil(tau) - 1) * stay) / 3600
        self.magnetic_variation: float | None = None
        self.heading_magnetic: float | None = None

    def __repr__(self) -> str:
        return f"<Aim: {aim_sentence(self.as_dict())}>"

    def as_dict(self) -> Row:
        """Return all by name, for JSON; `expected_miss` is rms, from where the dive should end."""
        plan = self.ahead.plan
        fields = dict(vars(self))
        del fields["ahead"], fields["target"]
        return {
            **placed("", *self.target),
            "place": in_minutes(*self.target),
            **placed("from_", *plan.start),
            "start": utc(plan.t_gps2),
            "duration": plan.duration,
            "end": utc(plan.t_gpse),
            **placed("end_", self.ahead.latitude, self.ahead.longitude),
            **vector("current_", *fields.pop("current")),
            "expected_miss": sqrt(float(np.trace(self.ahead.covariance))),
            **ellipse(self.ahead.covariance),
            **fields,
        }


def triangle(
    g: np.ndarray, c: np.ndarray, s: float
) -> tuple[np.ndarray, str, float | None]:
    """Return the way through the water w (2,), how it ends, and tau; all in m on a plane.

    >>> w, state, tau = triangle(np.array([0.0, 8000.0]), np.array([1500.0, 0.0]), 2500.0)
    >>> w.round(), state, round(tau, 9)  # across the line 1500 of 2500 m: 2000 m a dive
    (array([-1500.,  2000.]), 'under way', 4.0)
    """
    remaining = g - c
    if hypot(*remaining) <= s:
        return remaining, REACHED, 1.0
    tau = _dives(g, c, s)
    if tau is None:
        return s * remaining / hypot(*remaining), AGAINST, None
    return g / tau - c, UNDER_WAY, tau


def _dives(g: np.ndarray, c: np.ndarray, s: float) -> float | None:
    """Return the least tau > 0 of |g - tau c| = tau s; None where there is none."""
    # a tau^2 - 2 b tau + k = 0
    a = float(c @ c) - s * s
    b = float(g @ c)
    k = float(g @ g)
    under = b * b - a * k
    if under < 0 or (a >= 0 and b <= 0):
        return None
    root = sqrt(under)
    # without a difference of like numbers
    return k / (b + root) if b > 0 else (b - root) / a


def checked_target(lat: float, lon: float) -> Place:
    """Return a waypoint, or refuse what is no place."""
    if is_place(lat, lon):
        return lat, lon
    raise ScenarioError(
        f"--aim {lat:g} {lon:g}: must be a latitude from -90 to 90 and a longitude from -360 to "
        "360, in decimal degrees (43 04.27 S is -43.0712)"
    )


def aim_sentence(leg: Row) -> str:
    """Return the sentence on `Aim.as_dict`."""
    text = f"aim at {place(leg['latitude'], leg['longitude'])}, "
    made_good = leg["made_good"]
    if leg["bearing"] is not None:
        text += f"{leg['distance'] / 1000:.1f} km to {compass(leg['bearing'])}: "
    if leg["state"] == AGAINST:
        text += f"{against(leg)}; best "
    text += heading_words(leg)
    if leg["crab"] is not None:
        text += f", crab {leg['crab']:+z.0f}"
    full = f"{leg['through_water_full']:.0f} m"
    if leg["state"] == REACHED:
        through_water = f"{leg['through_water']:.0f} of {full} through the water"
        text += f", {through_water}; there at {clock(leg['end'])}"
    else:
        text += (
            f", {made_good:.0f} m made good of {full}"
            if made_good >= 0
            else f", {-made_good:.0f} m are lost"
        )
        text += f", then {leg['left'] / 1000:.1f} km"
    if leg["state"] == UNDER_WAY:
        text += f"; there in {leg['dives']:.1f} dives, {leg['hours']:.0f} h"
    error = f"expected position error {leg['expected_miss']:.0f} m"
    return f"{text}; {error}, {ellipse_words(leg)}"


@public
def aims(
    self: Any,
    targets: Sequence[Place],
    speed: float | None = None,
    duration: float | None = None,
    variation: float | None = None,
    start: tuple[float, float, float] | None = None,
) -> list[Aim]:
    """Aim at waypoints in their order, leg by leg.

    Parameters
    ----------
    targets : sequence of tuple of float
        Latitudes and longitudes, degrees.
    speed : float, optional
        Through the water, m/s, as the vehicle reckons it: the learned factor is
        put on it.  By default the median of the last five dives.
    duration : float, optional
        Of a dive, s; by default the median of the last five.
    variation : float, optional
        Magnetic, degrees east; by default the last dive's own, else IGRF's.
    start : tuple of float, optional
        Time (s since 1970), latitude and longitude where the dive begins; by default where
        the replay expects it.

    Returns
    -------
    list of Aim
        The first is how to steer the next dive; each other one starts at the
        waypoint before it, when that is reached.  None follows one that cannot
        be made, or takes more than a year.

    Raises
    ------
    ScenarioError
        If a waypoint is no place, or no vehicle can have speed and duration.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> replay = clpt.replay.replay_dives(clpt.gliders.sample_dives())
    >>> leg = replay.aims([(-42.5, 8.0)])[0]
    >>> leg.state, leg.heading < leg.bearing  # against a current to the east: to the left of it
    ('under way', True)
    """
    targets = [checked_target(*point) for point in targets]
    V, T = usual(self, speed, duration)
    last = self.steps[-1].dive
    start_fix = self.start()
    if start is not None:
        start_fix = start[0], *checked_target(*start[1:])
    legs = []
    for target in targets:
        leg = aim(self, start_fix, target, V, T)
        stated = (finite_or_none(value) for value in (variation, last.magvar))
        east = next((value for value in stated if value is not None), None)
        east = finite_or_none(igrf(*start_fix)) if east is None else east
        if leg.heading is not None and east is not None:
            leg.magnetic_variation = east
            leg.heading_magnetic = (leg.heading - east) % 360.0
        legs.append(leg)
        if leg.hours is None or leg.hours > YEAR:
            break
        took = max(3600.0 * leg.hours, leg.ahead.plan.duration)
        start_fix = (start_fix[0] + took + self.dive_statistics.stay()[0], *target)
    return legs


def usual(
    replay: Any, speed: float | None, duration: float | None
) -> tuple[float, float]:
    """Return the speed, m/s, and the duration, s, of a dive: as given, else as of the last ones."""
    dives = [step.dive for step in replay.steps[-DIVES:]]
    reckoned = float(median(hypot(*d.through_water) / d.duration for d in dives))
    V = reckoned if speed is None else speed
    if V == 0.0:
        raise ScenarioError(
            "--aim: 0 m/s, given or of the last dives, reaches no waypoint. Give --speed"
        )
    T = float(median(dive.duration for dive in dives)) if duration is None else duration
    check_flown(V, T)
    return V, T


def aim(
    replay: Any, start: Fix, target: Place, V: float, T: float, shorten: bool = True
) -> Aim:
    """Aim a dive of T s at V m/s from a start at a waypoint; a shorter one, if that must be."""
    g = np.array(displacement(*start[1:], *target))
    response = replay.steps[-1].response  # I + M
    full = V * T
    s = hypot(*response[0]) * V * T
    d = full * g / max(hypot(*g), 1e-9)
    c = np.full(2, np.inf)
    for _ in range(ITERATIONS):
        ahead = replay.surfacing(
            replay.dive_statistics.guess_of((float(d[0]), float(d[1])), T), start
        )
        before, c = c, ahead.forecast + d - response @ d
        w, state, tau = triangle(g, c, s)
        if hypot(*(c - before)) < CLOSE:
            break
        d = np.linalg.solve(response, w)
    if state == UNDER_WAY and tau is not None and tau < 1.0 and shorten:
        middle = float(g @ c) / (float(c @ c) - s * s)  # of two roots, both below 1
        return aim(replay, start, target, V, T * middle, shorten=False)
    # as it was forecast, whether or not c came to rest
    return Aim(ahead, target, V, T, c, s, state, tau, replay.dive_statistics.stay()[0])
