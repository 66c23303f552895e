"""Base class of the estimators between fixes.

An estimator forecasts the miss of a dive, fix less dead reckoning,

    y = H p + n,  n ~ N(0, (FIX^2 + doubt^2 + (s T)^2) I),

with H the regressor of `FixModel`. Its state is a mixture of m normal distributions of the n
parameters p. A forecast reads a dive's times, start and dead reckoning, never its end.
"""

from abc import ABC, abstractmethod

import numpy as np

from .dive import Dive
from .fix_model import FixModel


class Estimator(ABC):
    """Mixture of m normal distributions of the parameters of the flow and the vehicle.

    `mean` (m, n) and `covariance` (m, n, n) are those at the middle of the last dive, `variance`
    (m, n) is the prior's and `scatter` (m,) is s in m/s. `has_part` (m, parts) is true if a
    distribution has an optional part.
    """

    def __init__(
        self, model: FixModel, scatter: np.ndarray, has_part: np.ndarray
    ) -> None:
        self.model, self.priors = model, model.priors
        self.scatter, self.has_part = scatter, has_part
        self.log_weight = np.zeros(len(has_part))
        self.time: float | None = None
        always = np.ones(len(has_part), bool)
        columns = dict(zip(model.optional, has_part.T, strict=True))
        self.has_parameter = np.stack(
            [columns.get(part, always) for part in model.parts], axis=1
        )
        self.variance = model.prior_sd**2 * self.has_parameter
        self.mean = np.zeros(self.variance.shape)
        self.covariance = self.variance[:, :, None] * np.eye(len(model.names))

    @abstractmethod
    def forecast(self, dive: Dive) -> tuple[np.ndarray, np.ndarray]:
        """Return mean (m, 2) and covariance (m, 2, 2) of a dive's miss, m."""

    @abstractmethod
    def update(self, dive: Dive) -> None:
        """Learn from a dive that has ended."""

    @property
    def weights(self) -> np.ndarray:
        """Probabilities of the m distributions."""
        weights = np.exp(self.log_weight - self.log_weight.max())
        return weights / weights.sum()

    def elapsed(self, dive: Dive) -> float:
        """Return the time from the middle of the last dive to that of this one, s."""
        return 0.0 if self.time is None else max(0.0, dive.mid_time - self.time)

    def noise(self, dive: Dive) -> np.ndarray:
        """Return the m covariances of the noise n of a dive, (m, 2, 2), m^2."""
        return self.model.noise(dive, self.scatter)[:, None, None] * np.eye(2)

    def predict(self, dive: Dive) -> tuple[np.ndarray, np.ndarray]:
        """Forecast fix less dead reckoning of a dive: mean (2,), covariance (2, 2), m."""
        return mixed(*self.forecast(dive), self.weights)

    def parts(self) -> dict[str, float]:
        """Return the probability that each part of the flow is present, if known."""
        return {}

    def estimate(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return mean (n,), covariance (n, n) and the share of the prior's error left (n,).

        The share is computed from the distributions that have the parameter.
        """
        weights = self.weights[:, None] * self.has_parameter
        weights /= np.maximum(weights.sum(axis=0), 1e-300)
        spread = self.mean - (weights * self.mean).sum(axis=0)
        variance = np.diagonal(self.covariance, axis1=1, axis2=2) + spread**2
        share = np.sqrt((weights * variance).sum(axis=0)) / self.model.prior_sd
        return *mixed(self.mean, self.covariance, self.weights), share


def mixed(
    means: np.ndarray, covariances: np.ndarray, weights: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return mean (n,) and covariance (n, n) of a mixture of m distributions.

    m = sum w_i m_i,  P = sum w_i (P_i + (m_i - m)(m_i - m)^T)
    """
    mean = weights @ means
    deviation = means - mean
    between_means = np.einsum("m,mi,mj->ij", weights, deviation, deviation)
    return mean, np.einsum("m,mij->ij", weights, covariances) + between_means
