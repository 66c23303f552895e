"""Kalman filters between fixes, weighed by how well each has forecast.

    p_k = F p_{k-1} + w,  y_k = H_k p_k + n,  n ~ (FIX^2 + (s T)^2) I

(R. E. Kalman, "A new approach to linear filtering and prediction problems",
1960; the model is that of `fix_model`).  How fast the current walks, q, and how
much of it no parameter explains, s, differ from sea to sea.  A bank of filters
holds a grid of both; each is weighed by the likelihood of the dives it has
forecast (D. T. Magill, "Optimal adaptive estimation of sampled stochastic
processes", 1965), so neither is set by hand.  A fix beyond a filter's 99.9 % ellipse is
taken for a front: that filter's current walks until the fix lies within.
"""

from typing import Any

import numpy as np

from .fix_model import (
    FADING,
    FIX,
    QUARTER_DAY,
    SPEED_WALK,
    FixModel,
    hold,
    mid_time,
    miss,
)

WALKS = (0.003, 0.01, 0.03, 0.06, 0.12)  # q, m/s per sqrt(6 h)
UNEXPLAINED = (0.003, 0.01, 0.03, 0.06, 0.12)  # s, m/s
USUAL = (0.04, 0.02, 1.5)  # their usual values and the spread of their logarithms
SHELF = 0.1  # odds before any dive that tides are strong: the share of shelves in the ocean
ABSENT = 1e-4  # share of a prior's standard deviation where a part is absent
FAR = 13.82  # chi-squared of two components, 99.9 %


class KalmanBank:
    """Kalman filters on a grid of current walks and noises.

    Attributes
    ----------
    mean, covariance : ndarray, shapes (m, n) and (m, n, n)
        Of the m filters, at the middle of the last dive.
    log_weight : ndarray, shape (m,)
        Logarithms of the weights, the largest zero.

    Parameters
    ----------
    model : FixModel
        The parameters.

    Examples
    --------
    >>> KalmanBank(FixModel(("steady",))).mean.shape
    (25, 4)
    """

    def __init__(self, model: FixModel) -> None:
        self.model = model
        present = model.choices()
        grid = np.array([(q, s) for q in WALKS for s in UNEXPLAINED])
        self.walk, self.unexplained = np.repeat(grid, len(present), axis=0).T
        self.present = np.tile(present, (len(grid), 1))
        self.prior_sd = model.prior_sd * np.where(self.present, 1.0, ABSENT)
        m, n = self.prior_sd.shape
        self.mean = np.zeros((m, n))
        self.covariance = self.prior_sd[:, :, None] ** 2 * np.eye(n)
        tides = [k for k, name in enumerate(model.names) if name.endswith("_cos_east")]
        self.log_weight = self.present[:, tides].sum(axis=1) * np.log(SHELF / (1 - SHELF)) - 0.5 * (
            (np.log(self.walk / USUAL[0]) / USUAL[2]) ** 2
            + (np.log(self.unexplained / USUAL[1]) / USUAL[2]) ** 2
        )
        self.time: float | None = None

    @property
    def weights(self) -> np.ndarray:
        """Probabilities of the m filters."""
        w = np.exp(self.log_weight - self.log_weight.max())
        return w / w.sum()

    def transition(self, dive: Any) -> tuple[np.ndarray, np.ndarray]:
        """Give F and the m covariances of w from the last dive to this.

        Parameters
        ----------
        dive : Dive
            The next dive.

        Returns
        -------
        F : ndarray, shape (n, n)
        Q : ndarray, shape (m, n, n)
        """
        n = self.mean.shape[1]
        Q = np.zeros_like(self.covariance)
        dt = 0.0 if self.time is None else max(0.0, mid_time(dive) - self.time)
        F = self.model.turning(dt, dive.lat_gps2)
        Q[:, 0, 0] = Q[:, 1, 1] = self.walk**2 * dt / QUARTER_DAY
        names = self.model.names
        if "inertial" in self.model.flow:
            k, fade = names.index("inertial_east"), np.exp(-dt / FADING)
            F[k : k + 2, k : k + 2] *= fade
            Q[:, k, k] = Q[:, k + 1, k + 1] = self.prior_sd[:, k] ** 2 * (1 - fade**2)
        if self.model.learn_speed:
            Q[:, n - 2, n - 2] = self.present[:, n - 2] * SPEED_WALK**2 * dt / QUARTER_DAY
        return F, Q

    def ahead(self, dive: Any) -> tuple[np.ndarray, np.ndarray]:
        """Give the m means and covariances at a dive, before its end."""
        F, Q = self.transition(dive)
        return self.mean @ F.T, F @ self.covariance @ F.T + Q

    def noise(self, dive: Any) -> np.ndarray:
        """Give the m covariances of n for a dive, m^2."""
        variance = FIX**2 + (self.unexplained * dive.duration) ** 2
        return variance[:, None, None] * np.eye(2)

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
            m^2, of the whole bank.
        """
        H = self.model.regressor(dive)
        mean, P, _ = hold(*self.ahead(dive), self.prior_sd)
        return mixed(mean @ H.T, H @ P @ H.T + self.noise(dive), self.weights)

    def update(self, dive: Any) -> None:
        """Learn from a dive that has ended.

        Parameters
        ----------
        dive : Dive
            With its end fix.
        """
        H, R = self.model.regressor(dive), self.noise(dive)
        mean, P = self.ahead(dive)
        innovation = miss(dive) - mean @ H.T
        S = H @ P @ H.T + R
        far = np.einsum("mi,mij,mj->m", innovation, np.linalg.inv(S), innovation)
        jump = np.maximum(far / FAR - 1.0, 0.0) * np.trace(S, axis1=1, axis2=2) / 2
        P[:, [0, 1], [0, 1]] += (jump / dive.duration**2)[:, None]
        S = H @ P @ H.T + R
        inverse = np.linalg.inv(S)
        far = np.einsum("mi,mij,mj->m", innovation, inverse, innovation)
        self.log_weight = self.log_weight - 0.5 * (far + np.log(np.linalg.det(S)))
        self.log_weight -= self.log_weight.max()
        gain = P @ H.T @ inverse
        rest = np.eye(P.shape[1]) - gain @ H
        self.innovation, self.spread, self.rest = innovation, inverse, rest
        self.mean = mean + np.einsum("mni,mi->mn", gain, innovation)
        P = rest @ P @ rest.transpose(0, 2, 1) + gain @ R @ gain.transpose(0, 2, 1)
        self.covariance = 0.5 * (P + P.transpose(0, 2, 1))
        self.time = mid_time(dive)

    def estimate(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Give the parameters after the last dive.

        Returns
        -------
        mean : ndarray, shape (n,)
            m/s, 1 and rad; held parameters stand at zero.
        covariance : ndarray, shape (n, n)
            Of the whole bank.
        learned : ndarray of bool, shape (n,)
            Which parameters the likelier half of the bank has learned.
        """
        mean, P, learned = hold(self.mean, self.covariance, self.prior_sd)
        return (*mixed(mean, P, self.weights), self.weights @ learned > 0.5)

    def forget_speed(self) -> None:
        """Give the speed factor its prior variance again, after a fault."""
        if self.model.learn_speed:
            k = self.mean.shape[1] - 2
            self.covariance[:, k, k] += self.model.prior_sd[k] ** 2


def mixed(
    means: np.ndarray, covariances: np.ndarray, weights: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Give mean and covariance of a weighed mixture.

    Parameters
    ----------
    means : ndarray, shape (m, n)
        Of the parts.
    covariances : ndarray, shape (m, n, n)
        Of the parts.
    weights : ndarray, shape (m,)
        Probabilities.

    Returns
    -------
    mean : ndarray, shape (n,)
    covariance : ndarray, shape (n, n)
        Within the parts and between them.

    Examples
    --------
    >>> mixed(np.array([[0.0], [2.0]]), np.ones((2, 1, 1)), np.array([0.5, 0.5]))
    (array([1.]), array([[2.]]))
    """
    mean = weights @ means
    away = means - mean
    between = np.einsum("m,mi,mj->ij", weights, away, away)
    return mean, np.einsum("m,mij->ij", weights, covariances) + between
