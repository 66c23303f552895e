"""The paper's law between fixes: the gradient of the error at a surfacing.

    p <- p + mu P0 H^T (H P0 H^T + r)^-1 (y - H p)

Eq. (22) moves theta along e phi at every instant; a vehicle under water has no
e.  Integrated from fix to fix phi becomes H and e the miss y - H p at the
surfacing.  P0 gives each parameter its unit, and the division keeps a long dive
from overshooting (G. C. Goodwin, K. S. Sin, "Adaptive Filtering Prediction and
Control", 1984, section 3.3).  The law keeps no covariance: what the dives
excite is read from their Gramian, the spread of forecasts from earlier misses.
"""

from typing import Any

import numpy as np

from .fix_model import LEARNED, FixModel, mid_time, miss
from .recursive import noise

GAIN = 0.5  # mu, between 0 and 2 for stability
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
        n = len(model.prior_sd)
        self.mean, self.gramian = np.zeros(n), np.zeros((n, n))
        self.time: float | None = None
        self.variance, self.count = USUAL**2, 4.0  # of one component of the miss over time

    def turn(self, dive: Any) -> np.ndarray:
        """Give the rotation of the parameters to a dive's middle."""
        dt = 0.0 if self.time is None else max(0.0, mid_time(dive) - self.time)
        return self.model.turning(dt, dive.lat_gps2)

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
            m^2.
        """
        mean = self.turn(dive) @ np.where(self.learned(self.gramian), self.mean, 0.0)
        variance = self.variance * dive.duration**2
        return self.model.regressor(dive) @ mean, variance * np.eye(2)

    def learned(self, gramian: np.ndarray) -> np.ndarray:
        """Say which parameters a Gramian of dives has excited."""
        prior = self.model.prior_sd**2
        P = np.linalg.inv(gramian + np.diag(1 / prior))
        return np.diagonal(P) < LEARNED * prior

    def update(self, dive: Any) -> None:
        """Learn from a dive that has ended.

        Parameters
        ----------
        dive : Dive
            With its end fix.
        """
        mean, _ = self.predict(dive)
        seen = 0.5 * float(np.sum((miss(dive) - mean) ** 2)) / dive.duration**2
        self.variance = (self.count * self.variance + seen) / (self.count + 1)
        self.count = min(self.count + 1, 20.0)
        H, F = self.model.regressor(dive), self.turn(dive)
        self.gramian = F @ self.gramian @ F.T + H.T @ H / noise(dive)
        excited = self.learned(self.gramian)
        p = F @ np.where(excited, self.mean, 0.0)
        weight = np.diag(self.model.prior_sd**2 * excited)
        inner = H @ weight @ H.T + noise(dive) * np.eye(2)
        self.mean = p + GAIN * weight @ H.T @ np.linalg.solve(inner, miss(dive) - H @ p)
        self.time = mid_time(dive)

    def estimate(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Give the parameters after the last dive.

        Returns
        -------
        mean : ndarray, shape (n,)
            m/s, 1 and rad; held parameters stand at zero.
        covariance : ndarray, shape (n, n)
            The prior's: the law keeps none.
        learned : ndarray of bool, shape (n,)
        """
        learned = self.learned(self.gramian)
        return np.where(learned, self.mean, 0.0), np.diag(self.model.prior_sd**2), learned

    def forget_speed(self) -> None:
        """Do nothing: the law forgets by itself."""
