"""Replay of a glider's dives: each forecast before its end is seen.

The CLPE of a dive, Eq. (10) at the surfacing, is |x - z| with x the fix and z
the dead reckoning carried by a modelled flow:

    no flow         z = start + d
    previous dive   z = start + d + T (y / T of the previous used dive)
    adaptive        z = start + d + forecast of an estimator
    flow model      z = start + d + q, q as `carried` has it

d is the dead-reckoned displacement, y = fix - dead reckoning and T the duration
of a dive.  Duration and d of the dive are taken as known, its end fix is not.
The first used dive is forecast with no flow.  If a dive starts too far from the end of
the last one, one of the two fixes is wrong (`quality_control`): before the dive is forecast
the last one is learned again, its forecast as it was.  An outlier, a dive outside the 99 % ellipse
of its forecast, is learned with doubt and without.  The start of the next dive chooses between the
two for the forecast of that dive, its end for good.  A flow model is no part of
the state: each dive brings its q, or None where the model does not cover it.
The state moves by `Replay.step` alone, so that feeding dives one by one is feeding
them at once, bit for bit.
"""

import copy
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from math import hypot
from typing import Any

import numpy as np

from ...base.arguments import public
from ...base.geodesy import place_from
from ...base.html import facts, fragment, paragraphs
from ...base.progress.interrupt import check
from ...base.units import finite_or_none
from ..estimation.fix_model import CHI_SQUARED, FLOW, FixModel
from ..estimation.process_mixture import ProcessMixture
from ..gliders.dives import Dive, Fix
from ..gliders.usable_dives import follows
from .aim import aims
from .flow_models import FlowModel, carried
from .netcdf_export import dataset
from .quality_control import (
    OUTLYING,
    Forecast,
    check_dead_reckoning,
    check_next,
    check_tides,
    doubt_one_fix,
    doubt_outlier,
    is_confirmed,
    log_density,
    squared_distance,
)
from .replay_summary import summary
from .step import FLOW_MODEL, MODELS, Step
from .surfacing import (
    GIVEN,
    NORMAL,
    DiveStatistics,
    Guess,
    NextDive,
    check_flown,
    drift,
    has_course,
    unflown,
)
from .table_rows import cells

SURE = OUTLYING / 2  # log odds beyond which a confirmed fix is doubted after all
LISTED = 10  # dives of a notebook's table


def _in_words(replay: Any) -> str:
    if not replay.steps:
        return "no dive yet"
    first_dive = replay.steps[0].dive
    last = replay.steps[-1].dive
    count = f"{len(replay.steps)} dives, {first_dive.number} to {last.number}"
    return f"{last.vehicle or 'a glider'}: {count}"


@public
@dataclass(repr=False)
class Replay:
    """The state of a replay, fed dive by dive.

    Attributes
    ----------
    model : FixModel
        The parameters.
    flow_model : FlowModel or None
        What the dives were `carried` by; it gets a CLPE of its own.
    steps : list of Step
        One per dive so far.
    dive_statistics : DiveStatistics
        How the vehicle dives.
    seen : tuple of float
        Time and place of a fix after the last dive, where a later dive could not be used.

    Examples
    --------
    >>> from clpt_control.ocean.gliders.dives import make_dive
    >>> replay = Replay()
    >>> dive = make_dive(1, (0.0, 40.0, 8.0), (9000.0, 40.0, 8.02), (500.0, 0.0))
    >>> round(replay.step(dive).clpe["no_flow"])
    1208
    """

    model: FixModel = field(default_factory=FixModel)
    flow_model: FlowModel | None = None
    steps: list[Step] = field(default_factory=list)

    def __post_init__(self) -> None:
        """Start without any dive."""
        self._learner = ProcessMixture(self.model)
        self.dive_statistics = DiveStatistics()
        self._fed: list[Dive] = []
        self._outlier: tuple[Dive, ProcessMixture] | None = None
        self.seen: Fix = (-np.inf, np.nan, np.nan)
        self._before = self._state()

    def __repr__(self) -> str:
        return f"<Replay of {_in_words(self)}>"

    def _repr_html_(self) -> str:
        """Return the last dives as a table, the last one first."""
        rows = [cells(step.row) for step in self.steps[: -LISTED - 1 : -1]]
        table = facts([tuple(row.values()) for row in rows], [*rows[0]]) if rows else ""
        remarks = (
            [f"The last {LISTED} of {len(self.steps)} dives."]
            if self.steps[LISTED:]
            else []
        )
        return fragment("Replay", f"of {_in_words(self)}", table, paragraphs(remarks))

    @property
    def models(self) -> tuple[str, ...]:
        """Names of the flow models in `Step.clpe`."""
        return MODELS if self.flow_model is None else (*MODELS, FLOW_MODEL)

    @public
    def forecast(self, dive: Dive) -> Forecast:
        """Forecast a dive's miss from the dives so far.

        Mean (2,), m, zero for the first dive, and covariance (2, 2), m^2; the dive's end fix and
        displacement are not read.
        """
        sketch = copy.copy(self)
        sketch.steps = [*self.steps]
        return sketch.ahead(sketch._settle_last(dive))

    @public
    def ahead(self, dive: Dive) -> Forecast:
        """Forecast a dive's miss, its start taken as true."""
        mean, covariance = self._learner.predict(dive)
        return (mean if self.steps else np.zeros(2)), covariance

    def known(self) -> dict[str, float]:
        """Return the parameters as known now: m/s, 1 and rad."""
        names = self._learner.model.names
        mean, _, _ = self._learner.estimate()
        return dict(zip(names, mean.tolist(), strict=True))

    @public
    def step(self, dive: Dive) -> Step:
        """Forecast a dive, see its end, and learn from it.

        A dive that is not finite, or ends before the last one, is a `DataError`; so are dives whose
        dead reckoning looks swapped, reversed or in km.
        """
        check_next(dive, self.steps[-1].dive if self.steps else None)
        check_dead_reckoning([*(step.dive for step in self.steps), dive])
        self.seen = (-np.inf, np.nan, np.nan)
        headline = self.surfacing() if self.steps else None
        dive = self._settle_last(dive)
        self._take(dive, self.ahead(dive), headline)
        return self.steps[-1]

    def feed(
        self, dives: Sequence[Dive], report: Callable[[int], None] = lambda count: None
    ) -> "Replay":
        """Take all dives of a record, and return the replay of them.

        Each is carried by the flow model.  Of a record that grows, dives that come first again
        are not learned again.
        """
        if [*map(_identity, self._fed)] != [*map(_identity, dives[: len(self._fed)])]:
            self.steps = []
            self.__post_init__()
        for dive in dives[len(self._fed) :]:
            check()
            self.step(
                dive if self.flow_model is None else carried(dive, self.flow_model)
            )
            self._fed.append(dive)
            report(len(self._fed))
        return self

    @property
    def fix(self) -> Fix:
        """Time and place of the last fix."""
        last = self.steps[-1].dive
        return max((last.t_gpse, *last.end), self.seen)

    def start(self) -> Fix:
        """Return the fix where the next dive begins."""
        time, *position = self.fix
        stay = self.dive_statistics.stay()[0]
        drift = self.dive_statistics.drift()[0]
        return (time + stay, *place_from(*position, *drift))

    def surfacing(
        self, guess: Guess | None = None, start: Fix | None = None
    ) -> NextDive:
        """Forecast the end of the next dive.

        It goes by a guess, by default that of the dive statistics, and begins at `start`, by
        default as the vehicle should be when it dives.
        """
        last = self.steps[-1]
        habits = self.dive_statistics
        guess = habits.guess() if guess is None else guess
        begin = self.start() if start is None else start
        plan = unflown(last.dive, begin, guess)
        if self.flow_model is not None:
            plan = carried(plan, self.flow_model)
        mean, covariance = self.ahead(plan)
        position = place_from(*begin[1:], *(guess.way + mean))
        scatter = last.response @ guess.scatter[:2, :2] @ last.response.T
        covariance = covariance + scatter + habits.drift()[1]
        late = np.hypot(guess.duration * np.sqrt(guess.scatter[2, 2]), habits.stay()[1])
        wide, long = (max(w, 1.0) if guess.basis == GIVEN else w for w in habits.width)
        return NextDive(
            plan,
            mean,
            covariance * guess.tails * wide**2,
            *position,
            self.fix,
            float(NORMAL * late * np.sqrt(guess.tails) * long),
            guess.basis,
            has_course(last.dive),
        )

    @public
    def next_dive(
        self,
        duration: float | None = None,
        through_water: tuple[float, float] | None = None,
    ) -> NextDive:
        """Forecast the surfacing of the next dive, after one at least.

        It begins at the end of the last dive, or at `seen`.

        Parameters
        ----------
        duration : float, optional
            Of the next dive, s; by default guessed by the last dives.
        through_water : tuple of float, optional
            Planned displacement, east and north, m; by default guessed by the last
            dives and the plan in their files.

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
        >>> dives = clpt.gliders.sample_dives()
        >>> found = clpt.replay.replay_dives(dives).next_dive(18000.0, (0.0, 3000.0))
        >>> -42.93 < found.latitude < -42.89
        True
        """
        if duration is None and through_water is None:
            return self.surfacing()
        guess = self.surfacing().plan
        T = guess.duration if duration is None else duration
        through = guess.through_water if through_water is None else through_water
        check_flown(hypot(*through) / T if T > 0 else 0.0, T)
        return self.surfacing(self.dive_statistics.guess_of(through, T))

    # methods in files of their own, which cannot import this class
    summary = summary
    dataset = dataset
    aims = aims

    def _state(self) -> tuple[Any, ...]:
        """Return all that a dive changes, and the last step."""
        habits = copy.deepcopy(self.dive_statistics)
        return copy.copy(self._learner), habits, self._outlier, self.steps[-1:]

    def _settle_last(self, dive: Dive) -> Dive:
        """Judge the last dive by the start of this one; return this one, doubted if it is wrong."""
        if not self.steps:
            return dive
        last = self.steps[-1]
        before = last.dive if self._outlier is None else self._outlier[0]
        forecast = last.forecast, last.covariance
        is_next = follows(dive, before)
        priors = self.model.priors
        usual_drift = self.dive_statistics.drift()
        doubted, judged = doubt_one_fix(
            before, dive, is_next, forecast, priors, usual_drift
        )
        if doubted is not before:
            self._learn_again(doubted)
        elif (
            self._outlier is not None
            and judged is dive
            and is_confirmed(before, dive, last.forecast, last.current)
        ):
            self._swap_outlier()
        return judged

    def _learn_again(self, dive: Dive) -> None:
        """Learn the last dive again, as it is now known, its forecast as it was."""
        was = self.steps.pop()
        learner, habits, self._outlier, last = self._before
        self._learner = copy.copy(learner)
        self.dive_statistics = copy.deepcopy(habits)
        self.steps[-1:] = last
        self._take(dive, (was.forecast, was.covariance), was.headline)

    def _swap_outlier(self) -> None:
        """Trust the last dive if it is doubted, doubt it if it is trusted."""
        assert self._outlier is not None
        last = self._learner
        step = self.steps[-1]
        learner = self._outlier[1]
        self._learner = copy.copy(learner)
        dive = self._outlier[0]
        self.steps[-1] = replace(step, dive=dive, **learner.learned(dive))
        self._outlier = step.dive, last

    def _take(self, dive: Dive, forecast: Forecast, headline: NextDive | None) -> None:
        """Compare a dive's forecast and headline with its end, and learn from it."""
        self._before = self._state()
        last = self.steps[-1].dive if self.steps else None
        surface_drift = drift(dive, last)
        is_inside = None
        if headline is not None and last is not None and follows(dive, last):
            is_inside = headline.holds(dive)
        self.dive_statistics.learn(dive, surface_drift, is_inside or ())
        dive = self._learn(dive, forecast)
        mean, covariance = forecast
        inside = squared_distance(dive.miss, mean, covariance) <= CHI_SQUARED
        clpe = self._clpe(dive, last, mean)
        judged = clpe, mean, covariance, inside, surface_drift, headline, is_inside
        self.steps.append(Step(dive, *judged, **self._learner.learned(dive)))

    def _learn(self, dive: Dive, forecast: Forecast) -> Dive:
        """Learn from a dive, and return it; an outlier is doubted until the next dive agrees."""
        forecast = self._decide_outlier(dive, forecast)
        doubted = doubt_outlier(dive, *forecast) if self.steps else dive
        if doubted is not dive:
            trusting = copy.copy(self._learner)
            trusting.update(dive)
            self._outlier = dive, trusting
        self._learner.update(doubted)
        return doubted

    def _decide_outlier(self, dive: Dive, forecast: Forecast) -> Forecast:
        """Trust or doubt the last dive by the end of this one; return the forecast after that."""
        if self._outlier is None:
            return forecast
        rival = self._outlier[1].predict(dive)
        y = dive.miss
        log_odds = log_density(y, *rival) - log_density(y, *forecast)
        is_trusted = self.steps[-1].dive.doubt < self._outlier[0].doubt
        if log_odds > (SURE if is_trusted else 0.0):
            self._swap_outlier()
            forecast = rival
        self._outlier = None
        return forecast

    def _clpe(self, dive: Dive, last: Dive | None, mean: np.ndarray) -> dict[str, Any]:
        """Return the position error of a dive by each flow model, m."""
        y = dive.miss
        scale = dive.duration / last.duration if last else 0.0
        carried_by = [np.zeros(2), scale * (last or dive).miss, mean]
        if self.flow_model is not None:
            carried_by.append(np.array([dive.model_east, dive.model_north], float))
        sizes = [
            finite_or_none(np.hypot(*(y - displacement))) for displacement in carried_by
        ]
        return dict(zip(self.models, sizes, strict=True))


def _identity(dive: Dive) -> tuple:
    """Return all that a dive tells, to compare."""
    track = dive.track and tuple(np.asarray(column).tobytes() for column in dive.track)
    return dive, dive.vehicle, dive.notes, track


@public
def replay_dives(
    dives: Iterable[Dive],
    *,
    flow: Sequence[str] = FLOW,
    learn_speed: bool = True,
    flow_model: FlowModel | None = None,
) -> Replay:
    """Feed used dives to a new replay.

    Parameters
    ----------
    dives : iterable of Dive
        In the order of their ends, as `read_dives` returns them.
    flow : sequence of str, optional
        Parts of the flow: ``"steady"``, then any of ``"inertial"``, ``"shear"``, ``"gaussians"`` (a
        steady current that depends on position), ``"model"`` (a factor on the flow model) and
        constituents such as ``"M2"``.
    learn_speed : bool, optional
        Learn a factor on the speed through the water and a compass error.
    flow_model : FlowModel, optional
        Carries each dive before it is fed.

    Returns
    -------
    Replay
        After the last dive.

    Raises
    ------
    DataError
        If dives are out of order, or too few to tell the model's tides apart, or their dead
        reckoning looks swapped, reversed or in km.
    ScenarioError
        If a part of the flow is unknown.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> replay = clpt.replay.replay_dives(clpt.gliders.sample_dives())
    >>> len(replay.steps), 0.7 < replay.steps[-1].speed < 1
    (14, True)
    """
    dives = list(dives)
    replay = Replay(FixModel((*flow,), learn_speed), flow_model)
    check_tides(flow, dives)
    return replay.feed(dives)
