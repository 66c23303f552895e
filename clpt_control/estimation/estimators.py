"""Estimators between fixes, chosen by name.

`gradient` is the paper's law, Eq. (22), in integral form; `kalman` a bank of
Kalman filters.  Whatever one says of a dive before `update` is a forecast: it
reads the dive's times, start and dead reckoning, never its end.

The gradient of the error at a surfacing is the paper's law between fixes:

    p <- p + K (y - H p),  K = mu P0 H^T (H P0 H^T + r)^-1

Eq. (22) moves theta along e phi at every instant; a vehicle under water has no
e.  Integrated from fix to fix phi becomes H and e the miss y - H p at the
surfacing.  P0 gives each parameter its unit, and the division keeps a long dive
from overshooting (G. C. Goodwin, K. S. Sin, "Adaptive Filtering Prediction and
Control", 1984, section 3.3).  The law itself needs no covariance; that of its
error follows from any gain K, for a current that walks,

    P <- (I - K H) (P + Q) (I - K H)^T + K r K^T,

and says how far to trust it.  A fix beyond the 99.9 % ellipse moves the law less, by
how far beyond it lies, and a fix that is doubted by the share of its variance that is not doubt.
"""

from collections.abc import Callable
from typing import Protocol

import numpy as np

from ..arguments import public
from ..errors import ScenarioError
from .dive import Dive, mid_time, miss
from .fix_model import FAR, FixModel
from .kalman import HIDDEN, Bank, KalmanBank, with_hidden


class Gradient(Bank):
    """The paper's gradient law in integral form, in one sea that has all parts."""

    def __init__(self, model: FixModel) -> None:
        super().__init__(model, (model.priors.gradient,), np.ones((1, len(model.optional)), bool))
        self.variance = self.priors.miss**2  # of a miss over its time
        self.count = self.priors.miss_weight

    def transition(self, model: FixModel, dt: float, latitude: float) -> np.ndarray:
        """Return F over `dt` s, (1, n, n): the steady current is forgotten, too."""
        F = super().transition(model, dt, latitude)
        F[:, HIDDEN : HIDDEN + 2] *= np.exp(-dt / self.priors.gradient.memory)
        return F

    def predict(self, dive: Dive) -> tuple[np.ndarray, np.ndarray]:
        """Forecast fix less dead reckoning of a dive: mean (2,), covariance (2, 2), m.

        The variance is that of earlier misses, or of the law's own errors if that is larger.
        """
        mean, S = super().predict(dive)
        return mean, max(self.variance * dive.duration**2, np.trace(S) / 2) * np.eye(2)

    def update(self, dive: Dive) -> None:
        """Learn from a dive that has ended."""
        mean, S = self.predict(dive)
        far = float(np.sum((miss(dive) - mean) ** 2)) / S[0, 0]
        trust = 1.0 - dive.doubt**2 / S[0, 0]
        seen = 0.5 * min(far, FAR) * S[0, 0] / dive.duration**2
        self.variance = (self.count * self.variance + trust * seen) / (self.count + trust)
        self.count = min(self.count + 1, self.priors.miss_memory)
        self.model, _, p, P = self.ahead(dive)
        H, R = with_hidden(self.model.regressor(dive, ended=True)), self.noise(dive)
        weight = self.prior_sd(self.model)[0][:, None] ** 2 * H.T
        mu = trust * self.priors.gain * FAR / max(far, FAR)
        gain = mu * weight @ np.linalg.inv(H @ weight + R)
        self.mean = p + (miss(dive) - p @ H.T) @ gain.transpose(0, 2, 1)[0]
        rest = np.eye(P.shape[1]) - gain @ H
        self.covariance = rest @ P @ rest.transpose(0, 2, 1) + gain @ R @ gain.transpose(0, 2, 1)
        self.time = mid_time(dive)

    def parts(self) -> dict[str, float]:
        """Return nothing: the law does not ask which parts are present."""
        return {}


class Estimator(Protocol):
    """What an estimator can do; its `model` has the parameters so far."""

    model: FixModel

    def predict(self, dive: Dive) -> tuple[np.ndarray, np.ndarray]:
        """Forecast a dive's miss: mean (2,) and covariance (2, 2), m."""

    def update(self, dive: Dive) -> None:
        """Learn from a dive that has ended."""

    def estimate(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return mean (n,), covariance (n, n) and how much of the prior's error is left (n,)."""

    def parts(self) -> dict[str, float]:
        """Return the probability that each part of the flow is present; empty if not asked."""

    def forget_speed(self) -> None:
        """Make the speed factor uncertain again, after a fault."""


ESTIMATORS: dict[str, Callable[[FixModel], Estimator]] = {
    "kalman": KalmanBank,
    "gradient": Gradient,
}


@public
def make_estimator(name: str, model: FixModel) -> Estimator:
    """Make an estimator by its name.

    Parameters
    ----------
    name : str
        ``"kalman"`` or ``"gradient"``.
    model : FixModel
        The parameters.

    Returns
    -------
    Estimator
        That has seen no dive.

    Raises
    ------
    ScenarioError
        If the name is unknown.

    Examples
    --------
    >>> make_estimator("gradient", FixModel()).estimate()[0].any()
    np.False_
    """
    if name not in ESTIMATORS:
        raise ScenarioError(f"estimator '{name}': must be one of {', '.join(ESTIMATORS)}")
    return ESTIMATORS[name](model)
