"""The record of one dive: its forecast, its misses, and what is known after it.

The 90 % ellipse of its forecast,

    (x - m)^T P^-1 (x - m) = 2 ln 10

holds a normal pair of mean m and covariance P with probability 0.9; its half axes are
sqrt(2 ln 10 l), l the eigenvalues of P.
"""

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..errors import DataError
from ..estimation.estimators import Estimator
from ..gliders.dives import Dive
from .doubts import Anomaly
from .habits import Way
from .surfacing import NextDive

MODELS = ("no_flow", "previous_dive", "adaptive")
FLOW_MODEL = "flow_model"  # a forecast or a fit that was given
LEARNED = 0.87  # share of a prior's standard error; a parameter with more is not learned


@dataclass(frozen=True)
class Step:
    """A dive, its forecast, and what is known after it.

    `clpe` has |x - z| (m) of each flow model, None where it does not cover the dive. `forecast`
    (2,) and `covariance` (2, 2) are of the fix less dead reckoning, m; `inside` says whether the
    vehicle surfaced in their 90 % ellipse. `current` (2,) is the learned flow over the dive, m/s,
    `speed` the factor, `compass` the error in degrees clockwise, each with its standard error.
    `parts` has the probability that each part of the flow is present, `left` the share of the
    prior's standard error that the dives so far leave of each parameter. `headline` is the
    surfacing as forecast before the dive, `headline_held` whether its place and its time held: None
    for the first dive, and where dives between may be missing. `drift` is that before the dive,
    `row` all of this by name, once `outcome.rows` has made it.
    """

    dive: Dive
    clpe: dict[str, float | None]
    forecast: np.ndarray
    covariance: np.ndarray
    inside: bool
    anomaly: Anomaly | None
    current: np.ndarray
    current_error: np.ndarray
    parts: dict[str, float]
    left: dict[str, float]
    drift: Way | None = None
    headline: NextDive | None = None
    headline_held: tuple[bool, bool] | None = None
    speed: float = 1.0
    speed_error: float = 0.0
    compass: float = 0.0
    compass_error: float = 0.0
    row: dict[str, Any] = field(default_factory=dict, compare=False, repr=False)

    @property
    def response(self) -> np.ndarray:
        """I + M, the way through the water of a unit of dead reckoning, (2, 2)."""
        psi = np.radians(self.compass)
        a, b = self.speed * np.cos(psi), self.speed * np.sin(psi)
        return np.array([[a, b], [-b, a]])

    @property
    def learned(self) -> tuple[str, ...]:
        """Parameters that are better known than before any dive."""
        return tuple(name for name, left in self.left.items() if left < LEARNED)

    @property
    def not_learned(self) -> tuple[str, ...]:
        """Parameters that are hardly better known than before any dive."""
        return tuple(name for name, left in self.left.items() if left >= LEARNED)


def estimates(learner: Estimator, dive: Dive) -> dict[str, Any]:
    """Return the fields of a `Step` that an estimator fills which has learned its dive."""
    p, P, left = learner.estimate()
    model = learner.model
    flow = [k for k, part in enumerate(model.parts) if part not in ("speed", "compass")]
    H = model.regressor(dive, ended=True)[:, flow] / dive.duration
    known: dict[str, Any] = {
        "current": H @ p[flow],
        "current_error": np.sqrt(np.diag(H @ P[np.ix_(flow, flow)] @ H.T)),
        "parts": learner.parts(),
        "left": dict(zip(model.names, left.tolist(), strict=True)),
    }
    if model.learn_speed:
        k = model.names.index("speed")
        a, b = 1.0 + p[k], p[k + 1]  # f cos psi, f sin psi
        f = np.hypot(a, b)
        by = np.array([[a, b], [-b / f, a / f]]) / f  # derivatives of f and psi
        factor, compass = np.sqrt(np.diag(by @ P[k : k + 2, k : k + 2] @ by.T))
        known |= {
            "speed": float(f),
            "speed_error": float(factor),
            "compass": float(np.degrees(np.arctan2(b, a))),
            "compass_error": float(np.degrees(compass)),
        }
    return known


def check_next(dive: Dive, last: Dive | None) -> None:
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
