"""Replay of a glider's dives: each forecast before its end is seen.

The CLPE of a dive, Eq. (10) at the surfacing, is |x - z| with x the fix and z
the dead reckoning carried by a modelled flow:

    no flow         z = start + d
    previous dive   z = start + d + T (y / T of the previous used dive)
    adaptive        z = start + d + forecast of an estimator
    flow model      z = start + d + q, q as `flow_models.carried` has it

d is the dead-reckoned displacement, y = fix - dead reckoning and T the duration
of a dive.  Duration and d of the dive are taken as known, its end fix is not.
The first used dive is forecast with no flow.  Where a dive starts too far from the end of
the last one, one of the two fixes is wrong (`doubtful_fixes`): before the dive is forecast
the last one is learned again, its own forecast as it was.  A given flow model is no part of
the state: each dive brings its q, or None where the model does not cover it.
The state moves by `Replay.step` alone, so that feeding dives one by one is feeding
them at once, bit for bit.
"""

import copy
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field

import numpy as np

from ..arguments import public
from ..currents.rayleigh import check_separable
from ..errors import DataError
from ..estimation.dive import miss
from ..estimation.estimators import make_estimator
from ..estimation.fix_model import OTHERS, FixModel
from ..estimation.kalman import KalmanBank
from ..gliders.dives import Dive
from ..progress.interrupt import check
from .anomaly import SpeedWatch
from .doubtful_fixes import weighed
from .flow_models import FlowModel, carried
from .shown import replay_html, replay_line
from .step import CHI_SQUARED, FLOW_MODEL, MODELS, Step, learned


@public
@dataclass(repr=False)
class Replay:
    """The state of a replay, fed dive by dive.

    Attributes
    ----------
    estimator : str
        ``"kalman"`` or ``"gradient"``.
    model : FixModel
        The parameters.
    flow_model : FlowModel or None
        What the dives were `carried` by; it gets a CLPE of its own.
    steps : list of Step
        One per dive so far.

    Examples
    --------
    >>> from clpt_control.gliders.dives import make_dive
    >>> replay = Replay()
    >>> dive = make_dive(1, (0.0, 40.0, 8.0), (9000.0, 40.0, 8.02), (500.0, 0.0))
    >>> round(replay.step(dive).clpe["no_flow"])
    1208
    """

    estimator: str = "kalman"
    model: FixModel = field(default_factory=FixModel)
    flow_model: FlowModel | None = None
    steps: list[Step] = field(default_factory=list)

    def __post_init__(self) -> None:
        """Start without any dive."""
        self._learner = make_estimator(self.estimator, self.model)
        bank = self._learner if isinstance(self._learner, KalmanBank) else None
        self._watch = SpeedWatch(self.model, bank) if self.model.learn_speed else None
        self._before = self._learner, self._watch  # the last dive

    def __repr__(self) -> str:
        return replay_line(self)

    def _repr_html_(self) -> str:
        return replay_html(self)

    @property
    def models(self) -> tuple[str, ...]:
        """Names of the flow models that `Step.clpe` is asked for."""
        return MODELS if self.flow_model is None else (*MODELS, FLOW_MODEL)

    @public
    def forecast(self, dive: Dive) -> tuple[np.ndarray, np.ndarray]:
        """Forecast a dive's miss from the dives so far.

        Mean (2,), m, zero for the first dive, and covariance (2, 2), m^2; the dive's end fix and
        displacement are not read.
        """
        again, dive = self._weighed(dive)
        if again is None:
            return self._ahead(dive)
        known = copy.deepcopy(self)
        known._learn_again(again)
        return known._ahead(dive)

    def known(self) -> dict[str, float]:
        """Return the parameters as known now: m/s, 1 and rad."""
        names, (mean, _, _) = self._learner.model.names, self._learner.estimate()
        return dict(zip(names, mean.tolist(), strict=True))

    @public
    def step(self, dive: Dive) -> Step:
        """Forecast a dive, see its end, and learn from it.

        A dive that is not finite, or ends before the last one, is a `DataError`.
        """
        _check(dive, self.steps[-1].dive if self.steps else None)
        again, dive = self._weighed(dive)
        if again is not None:
            self._learn_again(again)
        self._take(dive, *self._ahead(dive))
        return self.steps[-1]

    def _ahead(self, dive: Dive) -> tuple[np.ndarray, np.ndarray]:
        """Forecast a dive's miss by what is known: mean (2,), covariance (2, 2)."""
        mean, covariance = self._learner.predict(dive)
        return (mean if self.steps else np.zeros(2)), covariance

    def _weighed(self, dive: Dive) -> tuple[Dive | None, Dive]:
        """Return the last dive where this one's start says that its end is wrong, and this one."""
        if not self.steps:
            return None, dive
        last = self.steps[-1]
        found, dive = weighed(last.dive, dive, (last.forecast, last.covariance), self.model)
        return (None if found is last.dive else found), dive

    def _learn_again(self, dive: Dive) -> None:
        """Learn the last dive again, as it is now known, its forecast as it was."""
        was = self.steps.pop()
        self._learner, self._watch = self._before
        self._take(dive, was.forecast, was.covariance)

    def _take(self, dive: Dive, mean: np.ndarray, covariance: np.ndarray) -> None:
        """Judge a forecast of a dive by its end, and learn from it."""
        self._before = copy.deepcopy((self._learner, self._watch))
        y = miss(dive)
        last = self.steps[-1].dive if self.steps else None
        previous = np.zeros(2) if last is None else miss(last) * (dive.duration / last.duration)
        away = y - mean
        modelled = None
        if dive.model_east is not None and dive.model_north is not None:
            modelled = _size(y - (dive.model_east, dive.model_north))
        self._learner.update(dive)
        anomaly = None if self._watch is None else self._watch.step(dive)
        if anomaly is not None and anomaly.certain:
            self._learner.forget_speed()
        self.steps.append(
            Step(
                dive,
                {
                    "no_flow": _size(y),
                    "previous_dive": _size(y - previous),
                    "adaptive": _size(away),
                    FLOW_MODEL: modelled,
                },
                mean,
                covariance,
                bool(away @ np.linalg.solve(covariance, away) <= CHI_SQUARED),
                anomaly,
                **learned(self._learner, dive),
            )
        )


def _check(dive: Dive, last: Dive | None) -> None:
    """Refuse a dive that is not finite or ends before the last one."""
    numbers = [dive.miss_east, dive.miss_north, dive.lat_gps2, dive.lon_gps2]
    numbers += [dive.model_east or 0, dive.model_north or 0]
    numbers += [np.sum(part) for part in dive.track or ()]
    if not (np.all(np.isfinite(numbers)) and dive.duration > 0):
        raise DataError(
            f"dive {dive.number}: fixes, dead reckoning and flow model must be finite, its "
            "duration above 0"
        )
    if last is not None and dive.t_gpse <= last.t_gpse:
        raise DataError(
            f"dive {dive.number} ends before dive {last.number}, which was learned; feed dives "
            "in the order of their ends"
        )


def _size(vector: np.ndarray) -> float:
    return float(np.hypot(vector[0], vector[1]))


def check_tides(flow: Sequence[str], dives: Sequence[Dive]) -> None:
    """Refuse two tides of a flow that dives, by time, are too few to tell apart.

    A single tide is allowed on any record: its prior holds it.
    """
    tides = [name for name in flow[1:] if name not in OTHERS]
    if len(tides) > 1 and dives:
        hours = round((dives[-1].t_gpse - dives[0].t_gps2) / 3600, 1)
        check_separable(tides, hours, f"flow {','.join(flow)}")


def feed(
    replay: Replay, dives: Sequence[Dive], report: Callable[[int], None] = lambda done: None
) -> Replay:
    """Feed dives to a replay, carried by its flow model; report how many are done."""
    for k, dive in enumerate(dives):
        check()
        model = replay.flow_model
        replay.step(dive if model is None else carried(dive, model))
        report(k + 1)
    return replay


@public
def replay_dives(
    dives: Iterable[Dive],
    estimator: str = "kalman",
    model: FixModel | None = None,
    flow_model: FlowModel | None = None,
) -> Replay:
    """Feed used dives to a new replay.

    Parameters
    ----------
    dives : iterable of Dive
        In the order of their ends, as `usable` returns them.
    estimator : str, optional
        ``"kalman"`` or ``"gradient"``.
    model : FixModel, optional
        The parameters; by default steady, M2, inertial and speed.
    flow_model : FlowModel, optional
        Carries each dive before it is fed.

    Returns
    -------
    Replay
        After the last dive.

    Raises
    ------
    DataError
        If dives are out of order, or too few to tell the model's tides apart.
    ScenarioError
        If the estimator is unknown.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> dives, skipped = clpt.gliders.usable(clpt.gliders.sample_dives())
    >>> replay = clpt.replay.replay_dives(dives)
    >>> len(replay.steps), 0.7 < replay.steps[-1].speed < 1
    (14, True)
    """
    dives = list(dives)
    replay = Replay(estimator, model or FixModel(), flow_model)
    check_tides(replay.model.flow, dives)
    return feed(replay, dives)
