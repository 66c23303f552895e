"""Replay of a glider's dives: each forecast before its end is seen.

The CLPE of a dive, Eq. (10) at the surfacing, is |x - z| with x the fix and z
the dead reckoning carried by a modelled flow:

    no flow         z = start + d
    previous dive   z = start + d + T (y / T of the previous used dive)
    adaptive        z = start + d + forecast of an estimator
    flow model      z = start + d + q, q as `flow_models.carried` has it

d is the dead-reckoned displacement, y = fix - dead reckoning and T the duration
of a dive.  Duration and d of the dive are taken as known, its end fix is not.
The first used dive is forecast with no flow.  A given flow model is no part of
the state: each dive brings its q, or None where the model does not cover it.
The state moves by `step` alone, so that feeding dives one by one is feeding them
at once, bit for bit.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..errors import DataError
from ..estimation.between_fixes import make_estimator
from ..estimation.fix_model import FixModel, miss
from ..estimation.kalman import KalmanBank
from ..gliders.dives import Dive
from .anomaly import SpeedWatch
from .ellipse import CHI_SQUARED
from .flow_models import FlowModel
from .step import FLOW_MODEL, MODELS, Step
from .summary import rms_of, summary_of


@dataclass
class Replay:
    """The state of a replay, fed dive by dive.

    Attributes
    ----------
    estimator : str
        ``"kalman"``, ``"rls"`` or ``"gradient"``.
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
        inner = self._learner.estimator
        bank = inner if isinstance(inner, KalmanBank) else None
        self._watch = SpeedWatch(self.model, bank) if self.model.learn_speed else None

    @property
    def models(self) -> tuple[str, ...]:
        """Names of the flow models that `Step.clpe` is asked for."""
        return MODELS if self.flow_model is None else (*MODELS, FLOW_MODEL)

    def forecast(self, dive: Dive) -> tuple[np.ndarray, np.ndarray]:
        """Forecast a dive's miss from the dives so far.

        Parameters
        ----------
        dive : Dive
            Its end fix and displacement are not read.

        Returns
        -------
        mean : ndarray, shape (2,)
            Fix less dead reckoning, m; zero for the first dive.
        covariance : ndarray, shape (2, 2)
            m^2.
        """
        mean, covariance = self._learner.predict(dive)
        return (mean if self.steps else np.zeros(2)), covariance

    def step(self, dive: Dive) -> Step:
        """Forecast a dive, see its end, and learn from it.

        Parameters
        ----------
        dive : Dive
            The next used dive.

        Returns
        -------
        Step
            Also the last of ``steps``.

        Raises
        ------
        DataError
            If the dive ends before the last one, or is not finite.
        """
        y = miss(dive)
        numbers = [*y, dive.lat_gps2, dive.lon_gps2, dive.model_east or 0, dive.model_north or 0]
        numbers += [np.sum(part) for part in dive.track or ()]
        if not (np.all(np.isfinite(numbers)) and dive.duration > 0):
            raise DataError(
                f"dive {dive.number}: fixes, dead reckoning and flow model must be finite, its "
                "duration above 0"
            )
        last = self.steps[-1].dive if self.steps else None
        if last is not None and dive.t_gpse <= last.t_gpse:
            raise DataError(
                f"dive {dive.number} ends before dive {last.number}, which was learned; feed dives "
                "in the order of their ends"
            )
        previous = np.zeros(2) if last is None else miss(last) * (dive.duration / last.duration)
        mean, covariance = self.forecast(dive)
        away = y - mean
        modelled = None
        if dive.model_east is not None and dive.model_north is not None:
            modelled = _size(y - (dive.model_east, dive.model_north))
        share = self._learner.share if self.steps else 0.0
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
                previous_share=share,
                **self._learned(dive),
            )
        )
        return self.steps[-1]

    def _learned(self, dive: Dive) -> dict[str, Any]:
        """What `Step` keeps of the estimates after a dive."""
        p, P, learned = self._learner.estimate()
        model = self._learner.model
        names = model.names
        flow = [k for k, name in enumerate(names) if name not in ("speed", "compass")]
        H = model.regressor(dive, ended=True)[:, flow] / dive.duration
        known: dict[str, Any] = {
            "current": H @ p[flow],
            "current_error": np.sqrt(np.diag(H @ P[np.ix_(flow, flow)] @ H.T)),
            "learned": tuple(name for name, on in zip(names, learned, strict=True) if on),
            "held": tuple(name for name, on in zip(names, learned, strict=True) if not on),
        }
        if model.learn_speed:
            k = names.index("speed")
            factor, compass = np.sqrt(np.diag(P)[k : k + 2])
            known |= {
                "speed": 1.0 + float(p[k]),
                "speed_error": float(factor),
                "compass": float(np.degrees(p[k + 1])),
                "compass_error": float(np.degrees(compass)),
            }
        return known

    def summary(self, skipped: Sequence[Any] = ()) -> dict[str, Any]:
        """Summarize, as `clpt replay --json` prints it.

        Parameters
        ----------
        skipped : sequence of Skipped
            Dives that were not fed, from `usable` and the readers.

        Returns
        -------
        dict
            Lengths in m; what does not exist is None.
        """
        return summary_of(self, skipped)

    def rms(self, after: int) -> dict[str, float | None]:
        """Return the CLPE rms of each flow model, m.

        Parameters
        ----------
        after : int
            How many first dives are left out.

        Returns
        -------
        dict
            None where no dive is left or covered.
        """
        return rms_of(self, after)


def _size(vector: np.ndarray) -> float:
    return float(np.hypot(vector[0], vector[1]))
