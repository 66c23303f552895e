"""What a replay says of one dive, and the 90 % ellipse of its forecast.

    (x - m)^T P^-1 (x - m) = 2 ln 10

holds a normal pair of mean m and covariance P with probability 0.9; its half axes are
sqrt(2 ln 10 l), l the eigenvalues of P.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..estimation.estimators import Estimator
from ..gliders.dives import Dive
from .anomaly import Anomaly

MODELS = ("no_flow", "previous_dive", "adaptive")
FLOW_MODEL = "flow_model"  # a forecast or a fit that was given
CHI_SQUARED = 4.605170185988092  # of two components, 90 %: 2 ln 10
ELLIPSE = ("ellipse_90_long", "ellipse_90_short", "ellipse_90_bearing")  # as `ellipse` has them
LEARNED = 0.87  # share of a prior's standard error; a parameter with more is held


@dataclass(frozen=True)
class Step:
    """What a replay says of one dive.

    `clpe` has |x - z| (m) of each flow model, None where it does not cover the dive. `forecast`
    (2,) and `covariance` (2, 2) are of the fix less dead reckoning, m; `inside` says whether the
    vehicle surfaced in their 90 % ellipse. `current` (2,) is the learned flow over the dive, m/s,
    `speed` the factor, `compass` the error in degrees clockwise, each with its standard error.
    `parts` has the probability that each part of the flow is present, `left` the share of the
    prior's standard error that the dives so far leave of each parameter.
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
    speed: float = 1.0
    speed_error: float = 0.0
    compass: float = 0.0
    compass_error: float = 0.0

    @property
    def learned(self) -> tuple[str, ...]:
        """Parameters that the dives so far tell of."""
        return tuple(name for name, left in self.left.items() if left < LEARNED)

    @property
    def held(self) -> tuple[str, ...]:
        """Parameters that are hardly better known than before any dive."""
        return tuple(name for name, left in self.left.items() if left >= LEARNED)


def ellipse(covariance: np.ndarray) -> tuple[float, float, float]:
    """Return half axes of the 90 % ellipse (m) and the bearing of the long one (degrees).

    The covariance (2, 2) is east and north, m^2; the bearing clockwise from north, 0 to 180.
    """
    size, axes = np.linalg.eigh(covariance)
    short, long = np.sqrt(CHI_SQUARED * size)
    bearing = np.degrees(np.arctan2(axes[0, 1], axes[1, 1])) % 180.0
    return float(long), float(short), float(bearing)


def learned(learner: Estimator, dive: Dive) -> dict[str, Any]:
    """Return what `Step` keeps of an estimator that has learned a dive."""
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
        factor, compass = np.sqrt(np.diag(P)[k : k + 2])
        known |= {
            "speed": 1.0 + float(p[k]),
            "speed_error": float(factor),
            "compass": float(np.degrees(p[k + 1])),
            "compass_error": float(np.degrees(compass)),
        }
    return known
