"""An estimator's forecast combined with the previous dive's current.

    forecast = m + s (p - m),  s = sum (y - m).(p - m)/v / sum |p - m|^2/v

m is what an estimator forecasts, p the previous dive's miss scaled by duration,
y what came, v the estimator's variance: s, kept in [0, 1], is the share that
would have forecast the dives so far best (J. M. Bates, C. W. J. Granger, "The
combination of forecasts", Operational Research Quarterly 20, 451-468, 1969).
Where a current keeps what it had, the previous dive knows best, and an
estimator that does not know so loses less with it than without.  Before dives have told, s is
`SHARE`, weighing as much as `WEIGHT` dives on which the two differ as far as the
estimator errs; after weeks it is so again.  A dive that is strange to either
counts less.
"""

from typing import Any

import numpy as np

from .estimator import Estimator
from .fix_model import FAR, FixModel, miss

SHARE, WEIGHT = 0.3, 8.0
MEMORY = 20 * 86400.0  # s


class Combination:
    """Forecasts of an estimator and of the previous dive, combined.

    Attributes
    ----------
    estimator : Estimator
        Learns the parameters.
    share : float
        s, of the previous dive's current in the next forecast.

    Parameters
    ----------
    estimator : Estimator
        That has seen no dive.

    Examples
    --------
    >>> from clpt_control.estimation.recursive import RecursiveLeastSquares
    >>> Combination(RecursiveLeastSquares(FixModel())).share
    0.3
    """

    def __init__(self, estimator: Estimator) -> None:
        self.estimator = estimator
        self.gain, self.weight = SHARE * WEIGHT, WEIGHT
        self.rate: np.ndarray | None = None  # the previous dive's miss over its duration, m/s
        self.time = 0.0
        self.asked: tuple[Any, tuple[np.ndarray, np.ndarray]] | None = None

    @property
    def model(self) -> FixModel:
        """The estimator's parameters."""
        return self.estimator.model

    @property
    def share(self) -> float:
        """Share of the previous dive's current in the next forecast."""
        return float(np.clip(self.gain / self.weight, 0.0, 1.0))

    def predict(self, dive: Any) -> tuple[np.ndarray, np.ndarray]:
        """Forecast fix less dead reckoning of a dive.

        Parameters
        ----------
        dive : Dive
            Its end fix is not read.

        Returns
        -------
        mean : ndarray, shape (2,)
            East and north, m.
        covariance : ndarray, shape (2, 2)
            m^2, of a mixture of both with the estimator's covariance.
        """
        mean, covariance = self.own(dive)
        if self.rate is None:
            return mean, covariance
        s, apart = self.share, dive.duration * self.rate - mean
        return mean + s * apart, covariance + s * (1 - s) * np.outer(apart, apart)

    def update(self, dive: Any) -> None:
        """Learn from a dive that has ended.

        Parameters
        ----------
        dive : Dive
            With its end fix.
        """
        if self.rate is not None:
            mean, covariance = self.own(dive)
            away, apart = miss(dive) - mean, dive.duration * self.rate - mean
            variance = np.trace(covariance) / 2
            variance *= max(1.0, max(away @ away, apart @ apart) / variance / FAR)
            left = np.exp(-max(0.0, dive.t_gpse - self.time) / MEMORY)
            self.gain = SHARE * WEIGHT + left * (self.gain - SHARE * WEIGHT)
            self.weight = WEIGHT + left * (self.weight - WEIGHT)
            self.gain += float(away @ apart / variance)
            self.weight += float(apart @ apart / variance)
        self.rate, self.time, self.asked = miss(dive) / dive.duration, dive.t_gpse, None
        self.estimator.update(dive)

    def own(self, dive: Any) -> tuple[np.ndarray, np.ndarray]:
        """Return the estimator's own forecast, asked for once a dive."""
        if self.asked is None or self.asked[0] is not dive:
            self.asked = (dive, self.estimator.predict(dive))
        return self.asked[1]

    def estimate(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the estimator's mean, covariance and what is learned."""
        return self.estimator.estimate()

    def forget_speed(self) -> None:
        """Make the speed factor uncertain again, after a fault."""
        self.estimator.forget_speed()
