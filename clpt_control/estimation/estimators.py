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
from .kalman import KalmanBank
from .priors import QUARTER_DAY


class Gradient:
    """The paper's gradient law in integral form."""

    def __init__(self, model: FixModel) -> None:
        self.model, self.priors = model, model.priors
        self.mean, self.covariance = np.zeros(len(model.names)), np.diag(model.prior_sd**2)
        self.time: float | None = None
        self.variance = self.priors.miss**2  # of a miss over its time
        self.count = self.priors.miss_weight

    def ahead(self, dive: Dive) -> tuple[FixModel, np.ndarray, np.ndarray]:
        """Return model, parameters and covariance at a dive, before its end."""
        model = self.model.reached(dive)
        old, new = model.matched(self.model)
        prior = model.prior_sd**2
        p, P = np.zeros(len(prior)), np.diag(prior)
        p[new], P[np.ix_(new, new)] = self.mean[old], self.covariance[np.ix_(old, old)]
        dt = 0.0 if self.time is None else max(0.0, mid_time(dive) - self.time)
        fade = model.faded(dt)
        F = model.turning(dt, dive.lat_gps2) * fade
        P = F @ P @ F.T + np.diag((1 - fade**2) * prior)
        walked = self.priors.gradient_walk**2 * dt / QUARTER_DAY
        P[[0, 1], [0, 1]] += np.clip(prior[:2] - P[[0, 1], [0, 1]], 0.0, walked)
        return model, F @ p, P

    def predict(self, dive: Dive) -> tuple[np.ndarray, np.ndarray]:
        """Forecast fix less dead reckoning of a dive: mean (2,), covariance (2, 2), m.

        The variance is that of earlier misses, or of the law's own errors if that is larger.
        """
        model, p, P = self.ahead(dive)
        H = model.regressor(dive)
        own = np.trace(H @ P @ H.T) / 2 + model.noise(dive, self.priors.gradient_scatter)
        return H @ p, max(self.variance * dive.duration**2, own) * np.eye(2)

    def update(self, dive: Dive) -> None:
        """Learn from a dive that has ended."""
        mean, S = self.predict(dive)
        far = float(np.sum((miss(dive) - mean) ** 2)) / S[0, 0]
        trust = 1.0 - dive.doubt**2 / S[0, 0]
        seen = 0.5 * min(far, FAR) * S[0, 0] / dive.duration**2
        self.variance = (self.count * self.variance + trust * seen) / (self.count + trust)
        self.count = min(self.count + 1, self.priors.miss_memory)
        self.model, p, P = self.ahead(dive)
        H = self.model.regressor(dive, ended=True)
        r = self.model.noise(dive, self.priors.gradient_scatter)
        weight = self.model.prior_sd[:, None] ** 2 * H.T
        mu = trust * self.priors.gain * FAR / max(far, FAR)
        gain = mu * weight @ np.linalg.inv(H @ weight + r * np.eye(2))
        self.mean = p + gain @ (miss(dive) - H @ p)
        rest = np.eye(len(p)) - gain @ H
        self.covariance = rest @ P @ rest.T + r * gain @ gain.T
        self.time = mid_time(dive)

    def estimate(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return mean (n,), covariance (n, n) and how much of the prior's error is left (n,)."""
        left = np.sqrt(np.diag(self.covariance)) / self.model.prior_sd
        return self.mean, self.covariance, left

    def parts(self) -> dict[str, float]:
        """Return nothing: the law does not ask which parts are present."""
        return {}

    def forget_speed(self) -> None:
        """Make the speed factor uncertain again, after a fault."""
        if self.model.learn_speed:
            k = self.model.names.index("speed")
            self.covariance[k, k] += self.priors.speed**2


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
