"""Learning of the flow from the fixes of a vehicle, one by one: recorded or live.

A leg lies between two fixes.  At its end the position error is a regression,

    y = fix - z = (theta - theta_hat) m + n,    n ~ N(0, r^2 I)

with z and m of `leg_track`, integrated along the prediction with y drawn in evenly, so that the
track ends at the fix.  Least squares moves theta_hat (`least_squares_step` of the law
fix-regression; Ljung 1999, section 11.2).  Laws with this regression differ in P between the fixes
(`Law.between_fixes`): `kalman-flow` adds its random walk, `least-squares` forgets.  r is that of
`fix_settings`.  Two terms are added to r^2:

- A stretch that is shorter than the vehicle's greatest speed would make it may have been bent: its
  way is off by b = ((V T)^2 - d^2)^(1/2)/2 at most, the term is (T 0.25 m/s min(b/width, 1))^2.
- The flow turns by `turn` rad along the leg (`LegTrack.turn`): (turn/2)^2 m^T P m.

The region of a forecast has a third one, of the flow where functions die out (`unspanned`).

Each fix divides each guess of what happened so far (`leg_guesses`); standard errors and regions are
those of the mixture of the guesses.

Outside: m, m/s, s since 1970 UTC and degrees; inside: units of the scenario.
"""

import copy
import json
from dataclasses import asdict, dataclass, replace
from functools import cached_property
from math import hypot
from pathlib import Path
from typing import Any
from zlib import crc32

import numpy as np

from ...base.arguments import OrNaN, Positive, finite, public
from ...base.errors import DataError
from ...base.files import write_file
from ...base.files.reading import read_text
from ...base.geodesy import check_place, displacement
from ...base.units import at_least
from ...paper.laws.fix_bound import UNMODELLED, LegRegressor
from ...paper.scenario.experiment import Scenario
from ...paper.scenario.file import scenario_from_text, scenario_to_text
from ..gliders.unmeasured import MINUTE, NO_FIX, is_held, question
from .fix_settings import FixSettings, LocalFrame, rotated
from .hypotheses import Hypotheses
from .lasting_scatter import Scatter
from .leg_guesses import KEPT, WALKS, Guess, LegGuesses, remarks, theta_of
from .leg_track import Ahead, Arrival, Leg, LegTrack, Regression, long_interval
from .wrong_units import COMPARED, wrong_motion

UNKNOWN = 0.01  # share of a leg of which the displacement may be unknown
LEAST_UNKNOWN = 5.0  # s
ARRAYS = ("theta", "P")  # of a guess
# of an estimator
PLAIN = [
    *("legs", "fastest", "turn", "told", "ways", "rows"),
    *("water", "fixes", "seen", "computed"),
]
SAME = 1e-6  # of a width, by which a track may be off for the same phi
EARLIER = 1e-3  # s by which a time may be before the last one, by rounding
# first words of a saved file, before its checksum
KIND, VERSION = "clpt-flow-estimator", "6"
ROWS, EACH = 60, 20  # last positions that are compared, and how often


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
    turn : float
        Angle by which the learned flow turns along the leg, rad.
    guaranteed : float
        Largest error of the learned flow at the fix, m/s, as by `FlowEstimator.guaranteed`.
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
    turn: float = 0.0
    guaranteed: float = np.inf

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
    shear : float, optional
        Largest shear of the true flow, 1/s, of `guaranteed`; what prior and widths allow.
    unmodelled : float, optional
        Largest flow that the functions do not express, errors of the motion included, m/s.

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

    def __init__(
        self,
        scenario: Scenario,
        shear: Positive | None = None,
        unmodelled: Positive = UNMODELLED,
    ) -> None:
        self.scenario = scenario
        self._limits = {"shear": shear, "unmodelled": unmodelled}
        self.settings = FixSettings(scenario, shear, unmodelled)
        self._guessing = LegGuesses(scenario, self.settings)
        # functions that are the same everywhere are by local east and north, and need no plane
        self.is_everywhere = scenario.basis.is_everywhere(scenario.units.length)
        self.settings.beside *= not self.is_everywhere
        self.track = LegTrack(scenario, self.settings)
        self._begin()

    is_screened = True  # for positions that repeat
    is_live = True  # and notes positions that look computed

    def _begin(self) -> None:
        """Know nothing."""
        self.frame: LocalFrame | None = None
        self.legs = 0
        self.fastest = 0.0  # speed through the water, length per time
        self.turn = 0.0  # of the flow along the last leg, rad
        self.guesses = self._guessing.first
        self.told: list[str] = []  # of each of the last fixes
        self.ways: list[list[float]] = []  # of the last legs, rows of `wrong_motion`
        self.fixes: list[list[float]] = []  # places of the last fixes that were learned
        # last positions: time, degrees, `water`
        self.rows: list[list[float]] = []
        self.water = [0.0, 0.0]  # m to the east and north, until now
        self.seen = 0  # positions
        self.computed = ""  # how the last positions look computed

    def __repr__(self) -> str:
        name = self.scenario.learning.law
        return f"<FlowEstimator: {name}, {self.scenario.basis.N} functions, {self.legs} legs>"

    # --- feeding --------------------------------------------------------------------------------

    @public
    def fix(self, time: OrNaN, latitude: OrNaN, longitude: OrNaN) -> Learned:
        """Learn from a fix.

        A fix after a time of unknown displacement through the water begins a leg and teaches
        nothing. A position that repeats exactly while the vehicle moves is no fix. Others are
        learned; a note says once if they follow from those around them.

        Parameters
        ----------
        time, latitude, longitude : float
            s since 1970 UTC, degrees.

        Returns
        -------
        Learned
            Error of the forecast, parameters, flow at the fix.
        """
        check_place(time, latitude, longitude)
        self._check_order(time)
        if self.frame is None:
            origin = self.scenario.origin or (latitude, longitude)
            self.frame = LocalFrame(time, origin, self.scenario.units)
        t = self.frame.own_time(time)
        leg = self.leg
        note = ""
        if self.is_screened and not (self.rows and time <= self.rows[-1][0]):
            is_known = leg is not None and not self._unknown(leg, t)
            is_fix, note = self._screened([time, latitude, longitude], is_known)
            if not is_fix:
                return self._learned(time, latitude, longitude, note=note)
        ended = [one for one in self._open() if not self._unknown(one, t)]
        if leg is not None and not ended and not self.legs:
            # the origin is the start of the first leg that is learned
            note = self._unknown(leg, t)
            self._begin()
            return replace(self.fix(time, latitude, longitude), note=note)
        place = self.frame.point(latitude, longitude)
        results: dict[str, Any] = {}
        for one in ended:
            one.add(t, 0.0, 0.0, self.track.size)
        if leg in ended:
            ahead = self.forecast([])
            predicted = ahead.latitude, ahead.longitude
            east, north = displacement(*predicted, latitude, longitude)
            results = {"forecast": ahead, "error_east": east, "error_north": north}
        elif leg is not None:
            results["note"] = self._unknown(leg, t)
        begins_again = Leg(t, place.tolist(), t)
        if begins_again not in self._open():
            results |= self._learn(begins_again, leg)
        if self.is_everywhere:
            self._recentre(begins_again, latitude, longitude)
        learned = self._learned(time, latitude, longitude, **results)
        begins_again.flow = learned.flow[0] / self.settings.speed
        return replace(learned, note="; ".join(filter(None, (note, learned.note))))

    @public
    def move(self, time: OrNaN, east: OrNaN, north: OrNaN) -> None:
        """Move the prediction by a straight stretch through the water.

        If a displacement is not known, leave out `move` until the next fix, which then begins a
        leg.

        Parameters
        ----------
        time : float
            End of the stretch, s since 1970 UTC; it begins at the end of the last one, or at
            the last fix.
        east, north : float
            Displacement through the water, m; 0 for a drifter.
        """
        check_place(time)
        self._check_order(time)
        finite("displacement (m)", [east, north])
        move_through(self, np.array([[time, east, north]]))

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
        check_place(time, latitude, longitude)
        return flow_by(self, self.theta, time, latitude, longitude)

    @public
    def guaranteed(self, time: OrNaN, latitude: OrNaN, longitude: OrNaN) -> float:
        """Return the largest error of the flow at a time and place.

        Of the flow that the functions express, for every constant theta within one prior of
        theta_hat(0), if the shear of the flow, the unmodelled flow and the noise of fixes
        (three standard deviations) keep their limits, and the fixes taken as right are right.

        Parameters
        ----------
        time, latitude, longitude : float
            s since 1970 UTC, degrees.

        Returns
        -------
        float
            m/s; inf where nothing is guaranteed that the prior does not say, and with
            ``kalman-flow``, whose flow changes.
        """
        check_place(time, latitude, longitude)
        frame, likely = self._frame_at(latitude, longitude), self.guesses.states[0]
        if self.scenario.learning.law == WALKS or not np.isfinite(likely.level):
            return np.inf
        point = frame.point(latitude, longitude)
        phi = self.track.phi(frame.own_time(time), point)
        before = np.linalg.norm(self.settings.prior * phi)
        of_guess = np.sqrt(likely.level * (phi @ likely.P @ phi))
        error = of_guess + np.linalg.norm((self.theta - likely.theta) @ phi)
        return float(error * self.settings.speed) if error < before else np.inf

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
        if not len(stretches):
            return self._ahead()
        ahead = copy.copy(self)
        ahead.state = self.state
        for time, east, north in stretches:
            ahead.move(time, east, north)
        return ahead._ahead()

    def _ahead(self) -> Ahead:
        """Forecast a fix now."""
        frame, leg = self.under_way
        likely = self.guesses.where(lambda guess: guess.leg is leg)
        theta = self._turned(leg, theta_of(likely).T).T
        arrival = self.track.end(leg, theta)
        terms = self._terms(leg, arrival, theta, arrival.z)
        bend = hypot(terms.bend, self.track.beside(arrival, self.fixes))
        terms = terms._replace(bend=bend)
        beside, radius = self._guessing.region(likely, terms)
        place = frame.position(arrival.z + self._turned(leg, beside))
        return Ahead(frame.date(leg.time), *place, radius * frame.metres)

    # --- results --------------------------------------------------------------------------------

    @property
    def guesses(self) -> Hypotheses[Guess]:
        """Guesses of what happened so far."""
        return self._guesses

    @guesses.setter
    def guesses(self, guesses: Hypotheses[Guess]) -> None:
        self._guesses = guesses
        for of_guesses in ("leg", "theta", "covariance"):
            self.__dict__.pop(of_guesses, None)

    @cached_property
    def leg(self) -> Leg | None:
        """Leg since the last right fix by the likeliest guess, or None."""
        legs = self._open()
        chances = self.guesses.chances(lambda guess: id(guess.leg))
        return max(legs, key=lambda leg: chances[id(leg)], default=None)

    @cached_property
    def theta(self) -> np.ndarray:
        """Mean of theta, (2, N)."""
        return theta_of(self.guesses)

    @property
    def scale(self) -> float:
        """Factor on the scatter, root mean square."""
        scatter = self.guesses.states[0].scatter
        return float(np.sum(scatter.weights * scatter.factors[1]) ** 0.5)

    @cached_property
    def covariance(self) -> np.ndarray:
        """Covariance of each row of theta, (N, N), scenario's units."""
        return self._guessing.covariance(self.guesses)

    @property
    def standard_error(self) -> np.ndarray:
        """Standard error of each flow parameter on both axes, (N,), m/s."""
        return np.sqrt(np.maximum(np.diag(self.covariance), 0.0)) * self.settings.speed

    @property
    def warnings(self) -> list[str]:
        """Sentences on motion through the water and interval of fixes."""
        told = wrong_motion(self.ways, self.settings.prior, self.settings.speed)
        notes = [*filter(None, (told, self.computed))]
        return notes + long_interval(self.turn)

    @property
    def guarantee(self) -> str:
        """Assumptions of `guaranteed`, or why there is no bound."""
        limits, speed = self.settings.limits, self.settings.speed
        if self.scenario.learning.law == WALKS:
            return f"no error is guaranteed: {WALKS} is for a flow that changes"
        shear = limits.shear * speed / self.settings.metres
        if not np.isfinite(self.guesses.states[0].level):
            return (
                "no error is guaranteed: the flow changed, or the fixes show that a limit does "
                "not hold. Give a larger unmodelled flow or shear"
            )
        if self.ways and not np.isfinite(self._guaranteed_at_fix()):
            return (
                "no error is guaranteed at the last fix: the bound is not below the prior there. "
                f"Shear x interval is {limits.shear * self.ways[-1][4]:.2g}: give a smaller shear, "
                "or fixes more often"
            )
        constant = "it" if np.all(np.isinf(self.scenario.periods)) else "theta"
        return (
            f"guaranteed of the modelled flow if {constant} is constant, "
            "|theta - theta_hat(0)| at most one "
            f"prior, shear at most {at_least(shear, 3)}/s, the unmodelled flow at most "
            f"{at_least(limits.unmodelled * speed, 3)} m/s, and each fix within "
            f"{at_least(limits.noise * self.settings.metres, 3)} m"
        )

    def _guaranteed_at_fix(self) -> float:
        frame, leg = self.under_way
        place = frame.position(np.array(leg.place))
        return self.guaranteed(frame.date(leg.start), *place)

    @property
    def flow_parameters(self) -> np.ndarray:
        """Estimate of theta, (2, N), m/s."""
        return self.theta * self.settings.speed

    @property
    def time(self) -> float:
        """Time of the last fix or stretch, s since 1970 UTC; -inf before."""
        leg = self.leg
        if self.frame is None or leg is None:
            return -np.inf
        return self.frame.date(leg.time)

    @property
    def under_way(self) -> tuple[LocalFrame, Leg]:
        """The frame, and the leg since the last fix."""
        leg = self.leg
        if self.frame is None or leg is None:
            raise DataError("no fix yet. Give a fix first")
        return self.frame, leg

    def _open(self) -> list[Leg]:
        """Return the legs of all guesses."""
        legs = [guess.leg for guess in self.guesses.states]
        return [*{id(leg): leg for leg in legs if leg is not None}.values()]

    # --- state ----------------------------------------------------------------------------------

    @public
    def save(self, path: str | Path) -> None:
        """Write scenario, limits and state to a file, without rounding.

        A process that is killed leaves the file as it was, or the new one.

        Parameters
        ----------
        path : str or Path
            File to write or replace.
        """
        scenario = scenario_to_text(self.scenario, Path(path).parent)
        text = json.dumps({"scenario": scenario, "state": self.state})
        write_file(path, f"{KIND} {VERSION} {_checksum(text)}\n{text}")

    @classmethod
    @public
    def load(cls, path: str | Path) -> "FlowEstimator":
        """Return the estimator that a file of `save` holds.

        It returns the same numbers, to the last bit, as the estimator that was saved.

        Parameters
        ----------
        path : str or Path
            File of `save`.

        Returns
        -------
        FlowEstimator

        Raises
        ------
        DataError
            If the file is damaged, of another version, or no file of `save`.
        """
        no_text = "is no file of FlowEstimator.save. Give another file"
        head, _, text = read_text(path, no_text).partition("\n")
        words = head.split(" ")
        if len(words) == 3 and words[0] == KIND and words[1] != VERSION:
            raise DataError(
                f"{path}: was saved by another version of clpt-control. Load it with that version"
            )
        if words != [KIND, VERSION, _checksum(text)]:
            raise DataError(
                f"{path}: is damaged, or no file of FlowEstimator.save. Give another file"
            )
        parts = json.loads(text)
        scenario = scenario_from_text(parts["scenario"], str(path), Path(path).parent)
        estimator = cls(scenario, **parts["state"]["limits"])
        estimator.state = parts["state"]
        return estimator

    @property
    def state(self) -> dict[str, Any]:
        """State as numbers and lists, which JSON writes without loss.

        An estimator of larger limits that takes it up guarantees nothing.
        """
        legs = self._open()
        numbers = {id(leg): number for number, leg in enumerate(legs)}
        return {
            "limits": self._limits,
            "frame": self.frame and [self.frame.time, *self.frame.place],
            "open": [asdict(leg) for leg in legs],
            "log_odds": self.guesses.log_odds,
            "guesses": [
                {"leg": numbers.get(id(guess.leg)), "fixes": guess.fixes}
                | {name: getattr(guess, name).tolist() for name in ARRAYS}
                | {
                    "level": guess.level,
                    "scatter": [np.asarray(x).tolist() for x in guess.scatter[1:]],
                }
                for guess in self.guesses.states
            ],
        } | {name: getattr(self, name) for name in PLAIN}

    @state.setter
    def state(self, state: dict[str, Any]) -> None:
        frame, legs = state["frame"], [Leg(**leg) for leg in state["open"]]
        self.frame = frame and LocalFrame(
            frame[0], (frame[1], frame[2]), self.scenario.units
        )
        for name in PLAIN:
            setattr(self, name, state[name])
        limits = FixSettings(self.scenario, **state["limits"]).limits
        is_wider = np.any(np.greater(self.settings.limits, limits))
        guesses = tuple(
            Guess(
                None if guess["leg"] is None else legs[guess["leg"]],
                fixes=tuple(guess["fixes"]),
                scatter=Scatter(self.settings, *map(np.array, guess["scatter"])),
                level=np.inf if is_wider else guess["level"],
                **{name: np.array(guess[name]) for name in ARRAYS},
            )
            for guess in state["guesses"]
        )
        self.guesses = Hypotheses(guesses, tuple(state["log_odds"]))

    def _learned(
        self, time: float, latitude: float, longitude: float, **results: Any
    ) -> Learned:
        """Return the results of a fix."""
        return Learned(
            *(time, latitude, longitude),
            self.flow_parameters,
            self.standard_error,
            self.flow(time, latitude, longitude),
            guaranteed=self.guaranteed(time, latitude, longitude),
            **results,
        )

    # --- one leg --------------------------------------------------------------------------------

    def _frame_at(self, latitude: float, longitude: float) -> LocalFrame:
        """Return the frame; of functions that are the same everywhere, with its origin there."""
        frame, _ = self.under_way
        if not self.is_everywhere:
            return frame
        return replace(frame, place=(latitude, longitude))

    def _recentre(self, begun: Leg, latitude: float, longitude: float) -> None:
        """Move the origin of the plane to the fix where a leg begins."""
        frame, _ = self.under_way
        self.frame = self._frame_at(latitude, longitude)
        begun.place = [0.0, 0.0]
        for leg in self._open():
            if leg == begun or frame == self.frame:
                continue
            place = np.array(leg.place)
            angle, _ = frame.axes(place)
            place = self.frame.point(*frame.position(place))
            leg.place = place.tolist()
            leg.turn(self.frame.axes(place)[0] - angle)

    def _turned(self, leg: Leg, flow: np.ndarray, sign: float = 1.0) -> np.ndarray:
        """Return flows (..., 2) by local east and north in the plane: those of the leg's middle.

        Only functions that are the same everywhere are by local east and north.
        """
        if not self.is_everywhere:
            return flow
        frame, _ = self.under_way
        angle, growth = frame.axes(np.array(leg.place))
        return rotated(flow, sign * (angle + growth * leg.east / 2))

    def _screened(self, position: list[float], is_known: bool) -> tuple[bool, str]:
        """Return whether a position (time, degrees) is a fix, and a note.

        Rows are kept a minute apart, but the last.
        """
        time, *place = position
        rows = self.rows * is_known
        is_repeated = bool(rows) and place == rows[-1][1:3]
        if rows[1:] and time < rows[-2][0] + MINUTE:
            rows = rows[:-1]
        self.rows = rows = [*rows[1 - ROWS :], [*position, *self.water]]
        self.seen += 1
        is_due = self.is_live and not (self.seen % EACH or self.computed)
        if not (is_repeated or is_due):
            return True, ""
        times, *degrees, east, north = np.array(rows).T
        track = times, np.transpose(degrees), np.diff(east + 1j * north)
        if is_repeated and is_held(*track):
            return False, f"held: {NO_FIX}"
        if is_due:
            self.computed = question(*track)
        return True, self.computed * is_due

    def _unknown(self, leg: Leg, t: float) -> str:
        """Return why a fix begins a leg instead of ending one, or an empty text."""
        frame, _ = self.under_way
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

    def _terms(
        self, leg: Leg, arrival: Arrival, theta: np.ndarray, Y: np.ndarray
    ) -> Regression:
        """Return the regression of a leg with its noise."""
        duration = leg.time - leg.start
        span = duration, leg.start + duration / 2
        noise = self.settings.noise_of(duration)
        bend = self.track.bend(leg, self.fastest)
        turn = self.track.turn(arrival, theta, self.covariance)
        return Regression(Y, arrival.m, *span, noise, bend, turn, self.theta)

    def _regression(self, leg: Leg, place: np.ndarray) -> Regression:
        """Return the regression of a leg along the track as its end fix corrects it."""
        theta = self._turned(leg, self.theta.T).T
        arrival = self.track.end(leg, theta)
        off = place - arrival.z
        drift = off / (leg.time - leg.start)
        if hypot(*off) > SAME * self.track.size[0]:
            arrival = self.track.end(leg, theta, drift)
            arrival = arrival._replace(z=arrival.z - off)
        Y = self._turned(leg, place - arrival.z + theta @ arrival.m, -1.0)
        times = np.append(arrival.points[:, 0], leg.time) - leg.start
        path = np.vstack([arrival.path, arrival.m])
        along = LegRegressor(times, path, float(np.hypot(*drift)) * times)
        return self._terms(leg, arrival, theta, Y)._replace(path=along)

    def _learn(self, start: Leg, leg: Leg | None) -> dict[str, Any]:
        """Divide each guess by the fix from which a leg may start; return note and turn."""
        place = np.array(start.place)
        known = {
            id(one): self._regression(one, place)
            for one in self._open()
            if not self._unknown(one, start.start)
        }
        self.legs += bool(known)
        self.guesses = self.guesses.divided(
            lambda guess: self._guessing.branches(
                guess, known.get(id(guess.leg)), start
            ),
            KEPT,
        )
        law, ended = self.scenario.learning.law, known.get(id(leg))
        self.told, note = remarks(self.guesses, self.told, law)
        if ended is None or leg is None:
            return {}
        r = float(ended.noise.sum() ** 0.5)
        row = [*(place - leg.place), *leg.moved, ended.duration, r, *ended.m]
        self.ways = [*self.ways[1 - COMPARED :], [float(x) for x in row]]
        self.turn = ended.turn.learned
        self.fixes = [*self.fixes[1 - ROWS :], start.place]
        drift = (place - leg.place - leg.moved) / ended.duration
        for one in self._open():  # the first leg too, if its end is in doubt
            one.shown = one.shown or drift.tolist()
        return {"note": note, "turn": self.turn}

    def _check_order(self, time: float) -> None:
        if time < self.time - EARLIER:
            raise DataError(
                f"time {time:.15g}: is before the last one, {self.time:.15g}. Give lines in the "
                "order of time, in s since 1970"
            )


def move_through(estimator: FlowEstimator, stretches: np.ndarray) -> None:
    """Move the prediction by rows of time, east and north."""
    frame, _ = estimator.under_way
    estimator.water = (estimator.water + stretches[:, 1:].sum(axis=0)).tolist()
    for leg in estimator._open():
        speeds = leg.move(frame, stretches, estimator.track.size)
        estimator.fastest = max(estimator.fastest, float(np.max(speeds, initial=0.0)))


def _checksum(text: str) -> str:
    return f"{crc32(text.encode()):08x}"


def flow_by(
    estimator: FlowEstimator, theta: np.ndarray, time: float, *place: float
) -> tuple[float, float]:
    """Return the flow of some theta, scenario's units, as `flow` does."""
    frame = estimator._frame_at(*place)
    point = frame.point(*place)
    phi = estimator.track.phi(frame.own_time(time), point)
    return frame.velocity(point, theta @ phi)
