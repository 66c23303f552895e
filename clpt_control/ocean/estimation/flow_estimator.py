"""Learning of the flow from the fixes of a vehicle, one by one: recorded or live.

A leg lies between two fixes.  At its end the position error is a regression,

    y = fix - z = (theta - theta_hat) m + n,    n ~ N(0, r^2 I)

with z and m of `leg_track`, integrated along the prediction with y drawn in evenly, so that the
track ends at the fix.  Least squares moves theta_hat (`least_squares_step` of the law
fix-regression; Ljung 1999, section 11.2).  Laws with this regression differ in P between the fixes
(`Law.between_fixes`): `kalman-flow` adds its random walk, `least-squares` forgets.  r is that of
`fix_settings`.

A stretch that is shorter than the vehicle's greatest speed would make it may have been bent: its
way is off by b = ((V T)^2 - d^2)^(1/2)/2 at most, which adds (T 0.25 m/s min(b/width, 1))^2 to r^2.

A fix outside its 99.9 % region has its r multiplied by its squared distance over that of the
region, so that it teaches less.  Standard errors and regions are scaled by the position errors so
far: with n legs, N functions and the weighted sum of squares S that theta_hat leaves, r is
multiplied by c,

    c^2 = (S + 4)/(2 max(n - N, 0) + 4)

Outside: m, m/s, s since 1970 UTC and degrees; inside: units of the scenario.
"""

import copy
from dataclasses import asdict, dataclass
from math import hypot
from typing import Any, NamedTuple

import numpy as np

from ...base.arguments import OrNaN, public
from ...base.errors import DataError
from ...base.geodesy import displacement, is_place
from ...paper.laws.memory_laws import least_squares_step
from ...paper.scenario.experiment import Scenario
from .fix_model import CHI_SQUARED, FAR
from .fix_settings import FixSettings, LocalFrame
from .leg_track import Leg, LegTrack

UNKNOWN = 0.01  # share of a leg of which the displacement may be unknown
LEAST_UNKNOWN = 5.0  # s
BENT = 0.25  # m/s, flow that a bent way changes by, a width away
PRIOR_ERRORS = 4.0  # weight of r as it is set, in position errors on an axis
EARLIER = 1e-3  # s by which a time may be before the last one, by rounding


class Ahead(NamedTuple):
    """A forecast of a fix.

    Attributes
    ----------
    time, latitude, longitude : float
        s since 1970 UTC, degrees.
    radius : float
        Radius of the region that contains the fix with probability `LEVEL`, m.
    """

    time: float
    latitude: float
    longitude: float
    radius: float


@dataclass(frozen=True)
class Learned:
    """Results of one fix.

    Attributes
    ----------
    time, latitude, longitude : float
        Of the fix: s since 1970 UTC, degrees.
    flow_parameters : ndarray, shape (2, N)
        Estimate of theta after the fix, m/s.
    standard_error : ndarray, shape (N,)
        Of each parameter on both axes, m/s.
    flow : tuple of float
        Learned flow at the fix, m/s to the east and to the north.
    forecast : Ahead or None
        Forecast of this fix before it was learned; None for a fix that begins a leg.
    error_east, error_north : float
        Fix less forecast, m; NaN for a fix that begins a leg.
    note : str
        A remark in plain words, or empty.
    """

    time: float
    latitude: float
    longitude: float
    flow_parameters: np.ndarray
    standard_error: np.ndarray
    flow: tuple[float, float]
    forecast: Ahead | None = None
    error_east: float = np.nan
    error_north: float = np.nan
    note: str = ""

    @property
    def error(self) -> float:
        """Length of the position error, m; NaN for a fix that begins a leg."""
        return hypot(self.error_east, self.error_north)

    @property
    def inside(self) -> bool:
        """True if the fix lies in the region of its forecast."""
        return self.forecast is not None and self.error <= self.forecast.radius


@public
class FlowEstimator:
    """Learner of the flow, fed fix by fix.

    Parameters
    ----------
    scenario : Scenario
        Basis functions and law for fixes: ``fix-regression``, ``kalman-flow`` or
        ``least-squares``. The tables `flow`, `vehicle`, `reference` and `run` may be left out.

    Attributes
    ----------
    legs : int
        Number of legs that were learned.

    Raises
    ------
    ScenarioError
        If the law does not learn from recorded fixes.
    DataError
        If a time is earlier than the last one, or a number is not finite.

    Examples
    --------
    A vehicle that drifts in a current of 0.2 m/s to the east for an hour:

    >>> import clpt_control as clpt
    >>> basis = {"kernel": "gaussian", "centers": [[0, 0]], "widths": [1e5]}
    >>> basis["constituents"] = ["steady"]
    >>> scenario = clpt.Scenario(basis=basis, learning={"law": "fix-regression"})
    >>> estimator = clpt.currents.FlowEstimator(scenario)
    >>> first = estimator.fix(0.0, 0.0, 8.0)
    >>> estimator.move(3600.0, 0.0, 0.0)
    >>> learned = estimator.fix(3600.0, 0.0, 8.0 + 720 / 111319.5)
    >>> round(learned.error), learned.flow_parameters.round(2).tolist()
    (720, [[0.2], [0.0]])
    """

    def __init__(self, scenario: Scenario) -> None:
        self.scenario = scenario
        self.settings = FixSettings(scenario)
        self.frame: LocalFrame | None = None
        self.leg: Leg | None = None
        self.legs = 0
        self.squares = 0.0  # of position errors over their standard deviation
        self.fastest = 0.0  # speed through the water, length per time
        self.theta = self.settings.theta.copy()
        self.P = np.diag(self.settings.prior**2)
        basis = scenario.basis_block("z")
        self._track = LegTrack(basis, scenario.basis.widths, scenario.periods)

    def __repr__(self) -> str:
        name = self.scenario.learning.law
        return f"<FlowEstimator: {name}, {self.scenario.basis.N} functions, {self.legs} legs>"

    # --- feeding --------------------------------------------------------------------------------

    @public
    def fix(self, time: OrNaN, latitude: OrNaN, longitude: OrNaN) -> Learned:
        """Learn from a fix.

        A fix after a time of unknown displacement through the water begins a leg and teaches
        nothing.

        Parameters
        ----------
        time, latitude, longitude : float
            s since 1970 UTC, degrees.

        Returns
        -------
        Learned
            Error of the forecast, parameters, flow at the fix.
        """
        self._check_time(time)
        if not is_place(latitude, longitude):
            raise DataError(
                f"fix at {latitude}, {longitude}: must be latitude and longitude, degrees"
            )
        if self.frame is None:
            origin = self.scenario.origin or (latitude, longitude)
            self.frame = LocalFrame(time, origin, self.scenario.units)
        t = self.frame.own_time(time)
        place = self.frame.point(latitude, longitude)
        results: dict[str, Any] = {}
        if self.leg is not None:
            note = self._unknown(t)
            if not note:
                self.leg.add(t, np.zeros(2), self._track.size)
                ahead = self.forecast([])
                note = self._learn(place)
                predicted = ahead.latitude, ahead.longitude
                east, north = displacement(*predicted, latitude, longitude)
                results = {"forecast": ahead, "error_east": east, "error_north": north}
            results["note"] = note
        self.leg = Leg(t, [float(x) for x in place], t)
        return Learned(
            *(time, latitude, longitude),
            self.flow_parameters,
            self.standard_error,
            self.flow(time, latitude, longitude),
            **results,
        )

    @public
    def move(self, time: OrNaN, east: OrNaN, north: OrNaN) -> None:
        """Move the prediction by a straight stretch through the water.

        Parameters
        ----------
        time : float
            End of the stretch, s since 1970 UTC; it begins at the end of the last one, or at
            the last fix.
        east, north : float
            Displacement through the water, m; 0 for a drifter.
        """
        self._check_time(time)
        if not np.isfinite(east) or not np.isfinite(north):
            raise DataError(
                f"displacement {east}, {north}: must be finite numbers of metres"
            )
        frame, leg = self.under_way
        t = frame.own_time(time)
        leg.known += t - leg.time
        moved = frame.displacement(np.array(leg.place), east, north)
        if t > leg.time:
            speed = float(np.hypot(*moved)) / (t - leg.time)
            self.fastest = max(self.fastest, speed)
        leg.add(t, moved, self._track.size)

    @public
    def flow(
        self, time: OrNaN, latitude: OrNaN, longitude: OrNaN
    ) -> tuple[float, float]:
        """Return the learned flow at a time and place.

        Parameters
        ----------
        time, latitude, longitude : float
            s since 1970 UTC, degrees.

        Returns
        -------
        tuple of float
            m/s to the east and to the north.
        """
        frame, _ = self.under_way
        point = frame.point(latitude, longitude)
        phi = self._track.phi(frame.own_time(time), point)
        return frame.velocity(point, self.theta @ phi)

    @public
    def forecast(self, stretches: list[tuple[OrNaN, OrNaN, OrNaN]]) -> Ahead:
        """Forecast the next fix.

        Parameters
        ----------
        stretches : list of tuple
            Time at the end (s since 1970 UTC), displacement through the water to the east and to
            the north (m) of each stretch that is planned from now on.

        Returns
        -------
        Ahead
            Time and place, and the radius of its region.
        """
        frame, now = self.under_way
        self.leg = copy.deepcopy(now)
        try:
            for time, east, north in stretches:
                self.move(time, east, north)
            leg = self.leg
        finally:
            self.leg = now
        z, m = self._track.end(leg, self.theta)
        radius = float(np.sqrt(CHI_SQUARED * self._variance(leg, m)))
        return Ahead(frame.date(leg.time), *frame.position(z), radius * frame.metres)

    # --- results --------------------------------------------------------------------------------

    @property
    def scale(self) -> float:
        """Factor c on the noise, by the position errors so far."""
        free = self.settings.prior > 0
        moved = (self.theta - self.settings.theta)[:, free] / self.settings.prior[free]
        left = max(self.squares - float(np.sum(moved**2)), 0.0)
        count = 2 * max(self.legs - int(np.sum(free)), 0)
        return float(np.sqrt((left + PRIOR_ERRORS) / (count + PRIOR_ERRORS)))

    @property
    def covariance(self) -> np.ndarray:
        """Covariance of each row of theta, (N, N), scenario's units."""
        free = self.settings.prior > 0
        sd = np.where(free, self.settings.prior, 1.0)
        # of the prior's variance, the share that is left along each axis
        share, axes = np.linalg.eigh(self.P / np.outer(sd, sd))
        share = np.clip(share, 1e-300, 1.0)
        square = self.scale**2
        scaled = square * share / (square * share + 1 - share)
        return (axes * scaled) @ axes.T * np.outer(sd * free, sd * free)

    @property
    def standard_error(self) -> np.ndarray:
        """Standard error of each flow parameter on both axes, (N,), m/s."""
        return np.sqrt(np.maximum(np.diag(self.covariance), 0.0)) * self.settings.speed

    @property
    def flow_parameters(self) -> np.ndarray:
        """Estimate of theta, (2, N), m/s."""
        return self.theta * self.settings.speed

    @property
    def time(self) -> float:
        """Time of the last fix or stretch, s since 1970 UTC; -inf before."""
        if self.frame is None or self.leg is None:
            return -np.inf
        return self.frame.date(self.leg.time)

    @property
    def under_way(self) -> tuple[LocalFrame, Leg]:
        """The frame, and the leg since the last fix."""
        if self.frame is None or self.leg is None:
            raise DataError("no fix yet. Give a fix first")
        return self.frame, self.leg

    # --- state ----------------------------------------------------------------------------------

    @property
    def state(self) -> dict[str, Any]:
        """State as numbers and lists, which JSON writes without loss."""
        return {
            "frame": self.frame and [self.frame.time, *self.frame.place],
            "leg": self.leg and asdict(self.leg),
            "legs": self.legs,
            "squares": self.squares,
            "fastest": self.fastest,
            "theta": self.theta.tolist(),
            "P": self.P.tolist(),
        }

    @state.setter
    def state(self, state: dict[str, Any]) -> None:
        frame, leg = state["frame"], state["leg"]
        self.frame = frame and LocalFrame(
            frame[0], (frame[1], frame[2]), self.scenario.units
        )
        self.leg = leg and Leg(**leg)
        self.legs, self.squares = state["legs"], state["squares"]
        self.fastest = state["fastest"]
        self.theta, self.P = np.array(state["theta"]), np.array(state["P"])

    # --- one leg --------------------------------------------------------------------------------

    def _unknown(self, t: float) -> str:
        """Return why a fix begins a leg instead of ending one, or an empty text."""
        frame, leg = self.under_way
        duration = t - leg.start
        if duration <= 0:
            return "at the time of the last fix"
        unknown = duration - leg.known
        if unknown <= max(UNKNOWN * duration, LEAST_UNKNOWN / frame.seconds):
            return ""
        return (
            f"begins a leg: the displacement through the water in the "
            f"{unknown * frame.seconds:.0f} s before it is not known"
        )

    def _bend(self, leg: Leg) -> float:
        """Return the error of a way that may have been bent, length."""
        return self._track.bend(leg, self.fastest) * BENT / self.settings.speed

    def _variance(self, leg: Leg, m: np.ndarray) -> float:
        """Return the variance of a position error on each axis, length squared."""
        noise = self.scale * self.settings.noise_of(leg.time - leg.start)
        bend = self._bend(leg)
        return float(noise**2 + bend**2 + m @ self.covariance @ m)

    def _learn(self, place: np.ndarray) -> str:
        """Move theta and P by the fix at the end of the leg; return a remark."""
        _, leg = self.under_way
        duration = leg.time - leg.start
        z, m = self._track.end(leg, self.theta)
        off = place - z
        beyond = float(off @ off) / self._variance(leg, m) / FAR
        # the track as the fix corrects it
        drift = off / duration
        z, m = self._track.end(leg, self.theta, drift)
        z = z - off
        between_fixes = self.scenario.learning.row.between_fixes
        assert between_fixes is not None
        P = between_fixes(self.P, duration, self.settings.p)
        bend = self._bend(leg)
        noise = float(np.hypot(self.settings.noise_of(duration), bend))
        y = place - z
        distance = float(y @ y) / float(noise**2 + m @ P @ m)
        is_far = self.legs > 0 and beyond > 1
        r = noise * beyond if is_far else noise
        change, self.P = least_squares_step(P, m, y, r)
        self.theta = self.theta + change
        self.legs += 1
        self.squares += min(distance, 2 * FAR)
        if not is_far:
            return ""
        return f"lies outside the 99.9 % region of its forecast and counts {1 / beyond**2:.2g}-fold"

    def _check_time(self, time: float) -> None:
        if not np.isfinite(time):
            raise DataError(f"time {time}: must be finite")
        if time < self.time - EARLIER:
            raise DataError(
                f"time {time:.15g}: is before the last one, {self.time:.15g}. Give lines in the "
                "order of time"
            )
