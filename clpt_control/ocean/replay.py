"""Replay of a glider's dives: each forecast before its end is seen.

The CLPE of a dive, Eq. (10) at the surfacing, is |x - z| with x the fix and z
the dead reckoning carried by a modelled flow:

    no flow         z = start + d
    previous dive   z = start + d + T (y / T of the previous used dive)
    adaptive        z = start + d + forecast of an estimator

d is the dead-reckoned displacement, y = fix - dead reckoning and T the duration
of a dive.  Duration and d of the dive are taken as known, its end fix is not.
The first used dive is forecast with no flow.  The state moves by `step` alone,
so that feeding dives one by one is feeding them at once, bit for bit.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..errors import DataError
from ..estimation.between_fixes import make_estimator
from ..estimation.fix_model import FixModel, miss
from .anomaly import SpeedWatch
from .dives import Dive
from .replay_step import MODELS, Step

ELLIPSE = 4.605170185988092  # chi-squared of two components, 90 %: 2 ln 10


@dataclass
class Replay:
    """The state of a replay, fed dive by dive.

    Attributes
    ----------
    estimator : str
        ``"kalman"``, ``"rls"`` or ``"gradient"``.
    model : FixModel
        The parameters.
    steps : list of Step
        One per dive so far.

    Examples
    --------
    >>> from clpt_control.ocean.dives import make_dive
    >>> replay = Replay()
    >>> dive = make_dive(1, (0.0, 40.0, 8.0), (9000.0, 40.0, 8.02), (500.0, 0.0))
    >>> round(replay.step(dive).clpe["no_flow"])
    1208
    """

    estimator: str = "kalman"
    model: FixModel = field(default_factory=FixModel)
    steps: list[Step] = field(default_factory=list)

    def __post_init__(self) -> None:
        """Start without any dive."""
        self._learner = make_estimator(self.estimator, self.model)
        self._watch = SpeedWatch(self.model) if self.model.learn_speed else None

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
        if not (np.all(np.isfinite(y)) and np.isfinite(dive.lat_gps2) and dive.duration > 0):
            raise DataError(f"dive {dive.number}: fixes and dead reckoning must be finite")
        last = self.steps[-1].dive if self.steps else None
        if last is not None and dive.t_gpse <= last.t_gpse:
            raise DataError(
                f"dive {dive.number} ends before dive {last.number}, which was learned; feed dives "
                "in the order of their ends"
            )
        previous = np.zeros(2) if last is None else miss(last) * (dive.duration / last.duration)
        mean, covariance = self.forecast(dive)
        away = y - mean
        self._learner.update(dive)
        anomaly = None if self._watch is None else self._watch.step(dive)
        if anomaly is not None:
            self._learner.forget_speed()
        self.steps.append(
            Step(
                dive,
                dict(zip(MODELS, (_size(y), _size(y - previous), _size(away)), strict=True)),
                mean,
                covariance,
                bool(away @ np.linalg.solve(covariance, away) <= ELLIPSE),
                anomaly,
                **self._learned(dive),
            )
        )
        return self.steps[-1]

    def _learned(self, dive: Dive) -> dict[str, Any]:
        """What `Step` keeps of the estimates after a dive."""
        p, P, learned = self._learner.estimate()
        names = self.model.names
        n = len(names) - 2 * self.model.learn_speed
        H = self.model.regressor(dive)[:, :n] / dive.duration
        known: dict[str, Any] = {
            "current": H @ p[:n],
            "current_error": np.sqrt(np.diag(H @ P[:n, :n] @ H.T)),
            "learned": tuple(name for name, on in zip(names, learned, strict=True) if on),
            "held": tuple(name for name, on in zip(names, learned, strict=True) if not on),
        }
        if self.model.learn_speed:
            factor, compass = np.sqrt(np.diag(P)[-2:])
            known |= {
                "speed": 1.0 + float(p[-2]),
                "speed_error": float(factor),
                "compass": float(np.degrees(p[-1])),
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
        steps = self.steps
        own = [
            float(np.hypot(*(miss(d) / d.duration - (d.dac_east, d.dac_north))))
            for d in (step.dive for step in steps)
            if d.dac_east is not None and d.dac_north is not None
        ]
        last = steps[-1] if steps else None
        factor = last is not None and self.model.learn_speed
        return {
            "dives": len(steps) + len(skipped),
            "used": len(steps),
            "clpe_rms": self.rms(0),
            "clpe_rms_after_1": self.rms(1),
            "clpe_rms_after_3": self.rms(3),
            "dac_identity_median": float(np.median(own)) if own else None,
            "inside_90": float(np.mean([step.inside for step in steps])) if steps else None,
            "speed_factor": {
                "value": last.speed if last and factor else None,
                "standard_error": last.speed_error if last and factor else None,
            },
            "learned": list(last.learned) if last else [],
            "held": list(last.held) if last else [],
            "anomalies": [step.anomaly.as_dict() for step in steps if step.anomaly],
            "skipped": [{"dive": s.dive, "why": s.why} for s in skipped],
        }

    def rms(self, after: int) -> dict[str, float | None]:
        """Give the CLPE rms of each model, m.

        Parameters
        ----------
        after : int
            How many first dives are left out.

        Returns
        -------
        dict
            None where no dive is left.
        """
        rest = self.steps[after:]
        return {
            name: float(np.sqrt(np.mean([step.clpe[name] ** 2 for step in rest]))) if rest else None
            for name in MODELS
        }


def replay_dives(
    dives: Iterable[Dive], estimator: str = "kalman", model: FixModel | None = None
) -> Replay:
    """Feed used dives to a new replay.

    Parameters
    ----------
    dives : iterable of Dive
        In the order of their ends, as `usable` gives them.
    estimator : str, optional
        ``"kalman"``, ``"rls"`` or ``"gradient"``.
    model : FixModel, optional
        The parameters; by default steady, M2, inertial and speed.

    Returns
    -------
    Replay
        After the last dive.

    Raises
    ------
    DataError
        If dives are out of order.
    ScenarioError
        If the estimator is unknown.
    """
    replay = Replay(estimator, model or FixModel())
    for dive in dives:
        replay.step(dive)
    return replay


def _size(vector: np.ndarray) -> float:
    return float(np.hypot(vector[0], vector[1]))
