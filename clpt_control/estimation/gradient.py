"""The paper's law between fixes: the gradient of the error at a surfacing.

    p <- p + K (y - H p),  K = mu P0 H^T (H P0 H^T + r)^-1

Eq. (22) moves theta along e phi at every instant; a vehicle under water has no
e.  Integrated from fix to fix phi becomes H and e the miss y - H p at the
surfacing.  P0 gives each parameter its unit, and the division keeps a long dive
from overshooting (G. C. Goodwin, K. S. Sin, "Adaptive Filtering Prediction and
Control", 1984, section 3.3).  The law itself needs no covariance; that of its
error follows from any gain K, for a current that walks by WALK,

    P <- (I - K H) (P + Q) (I - K H)^T + K r K^T,

and says how far to trust it.  A fix beyond the 99.9 % ellipse moves the law less, r
times how far beyond.  Which parameters are learned is read from the
Gramian of the dives.
"""

from typing import Any

import numpy as np

from .fix_model import FAR, FixModel, mid_time, miss
from .held import LEARNED
from .kalman import faded
from .recursive import noise
from .running import RunningMean
from .wandering import QUARTER_DAY

GAIN = 0.5  # mu, between 0 and 2 for stability
WALK = 0.04  # m/s per sqrt(6 h)
USUAL = 0.1  # m/s, a miss before dives have told


class Gradient:
    """The paper's gradient law in integral form.

    Parameters
    ----------
    model : FixModel
        The parameters.

    Examples
    --------
    >>> Gradient(FixModel(("steady",))).estimate()[0]
    array([0., 0., 0., 0.])
    """

    def __init__(self, model: FixModel) -> None:
        self.model = model
        n = len(model.names)
        self.mean, self.gramian = np.zeros(n), np.zeros((n, n))
        self.covariance = np.diag(model.prior_sd**2)
        self.time: float | None = None
        self.variance = RunningMean(USUAL**2)  # of one component of the miss over time

    def ahead(self, dive: Any) -> tuple[FixModel, np.ndarray, np.ndarray, np.ndarray]:
        """Return model, parameters, Gramian and covariance at a dive."""
        model = self.model.reached(dive)
        old, new = model.kept(self.model)
        n = len(model.names)
        p, G, P = np.zeros(n), np.zeros((n, n)), np.diag(model.prior_sd**2)
        p[new], G[np.ix_(new, new)] = self.mean[old], self.gramian[np.ix_(old, old)]
        P[np.ix_(new, new)] = self.covariance[np.ix_(old, old)]
        dt = 0.0 if self.time is None else max(0.0, mid_time(dive) - self.time)
        F = model.turning(dt, dive.lat_gps2) * faded(model, dt)
        P = F @ P @ F.T + np.diag((1 - faded(model, dt) ** 2) * model.prior_sd**2)
        for k in (0, 1):
            walked = WALK**2 * dt / QUARTER_DAY
            P[k, k] += min(walked, max(0.0, model.prior_sd[k] ** 2 - P[k, k]))
        return model, F @ np.where(excited(G, model), p, 0.0), F @ G @ F.T, P

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
            m^2: how far earlier forecasts missed, or the law's own errors if
            they are larger.
        """
        model, p, _, P = self.ahead(dive)
        H = model.regressor(dive)
        seen = self.variance.value * dive.duration**2
        return H @ p, max(seen, np.trace(H @ P @ H.T) / 2 + noise(dive)) * np.eye(2)

    def update(self, dive: Any) -> None:
        """Learn from a dive that has ended.

        Parameters
        ----------
        dive : Dive
            With its end fix.
        """
        mean, S = self.predict(dive)
        far = float(np.sum((miss(dive) - mean) ** 2)) / S[0, 0]
        self.variance.add(0.5 * min(far, FAR) * S[0, 0] / dive.duration**2)
        self.model, p, G, P = self.ahead(dive)
        H, r = self.model.regressor(dive, ended=True), noise(dive) * max(1.0, far / FAR)
        self.gramian = G + H.T @ H / r
        weight = np.diag(self.model.prior_sd**2 * excited(self.gramian, self.model))
        gain = GAIN * weight @ H.T @ np.linalg.inv(H @ weight @ H.T + r * np.eye(2))
        self.mean = p + gain @ (miss(dive) - H @ p)
        rest = np.eye(len(p)) - gain @ H
        self.covariance = rest @ P @ rest.T + r * gain @ gain.T
        self.time = mid_time(dive)

    def estimate(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the parameters after the last dive.

        Returns
        -------
        mean : ndarray, shape (n,)
            m/s, 1 and rad; held parameters stand at zero.
        covariance : ndarray, shape (n, n)
            Of the error, the prior's where held.
        learned : ndarray of bool, shape (n,)
        """
        learned = excited(self.gramian, self.model)
        P = np.where(np.outer(learned, learned), self.covariance, np.diag(self.model.prior_sd**2))
        return np.where(learned, self.mean, 0.0), P, learned

    def forget_speed(self) -> None:
        """Make the speed factor uncertain again, after a fault."""
        if self.model.learn_speed:
            k = self.model.names.index("speed")
            self.covariance[k, k] += self.model.prior_sd[k] ** 2


def excited(gramian: np.ndarray, model: FixModel) -> np.ndarray:
    """Say which parameters a Gramian of dives has excited."""
    prior = model.prior_sd**2
    P = np.linalg.inv(gramian + np.diag(1 / prior))
    return np.diagonal(P) < LEARNED * prior
