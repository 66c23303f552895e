"""Recursive least squares between fixes, forgetting with time.

    W <- l W + H^T H / r,  b <- l b + H^T y / r,  p = (W/c + P0^-1)^-1 b/c

l = exp(-dt/MEMORY) forgets (L. Ljung, "System Identification", 2nd ed., 1999,
section 11.2); the prior P0 is never forgotten, so that a quiet time does not
wind the gain up.  r is the variance of a fix and of what nothing explains, c what
earlier misses make of it.  A fix beyond the 99.9 % ellipse weighs less, r times
how far beyond.  W is the Gramian of the dives: it says which parameters are
learned.
"""

from typing import Any

import numpy as np

from .fix_model import FAR, FixModel, fix_variance, mid_time, miss
from .held import hold
from .running import RunningMean

MEMORY = 86400.0  # s
UNEXPLAINED = 0.04  # m/s, before dives have told


class RecursiveLeastSquares:
    """Least squares with forgetting, the parameters of `FixModel`.

    Parameters
    ----------
    model : FixModel
        The parameters.

    Examples
    --------
    >>> RecursiveLeastSquares(FixModel(("steady",))).estimate()[0]
    array([0., 0., 0., 0.])
    """

    def __init__(self, model: FixModel) -> None:
        self.model = model
        n = len(model.names)
        self.W, self.b = np.zeros((n, n)), np.zeros(n)
        self.time: float | None = None
        self.scale = RunningMean(1.0)  # variance of forecasts over the expected

    def ahead(self, dive: Any) -> tuple[FixModel, np.ndarray, np.ndarray]:
        """Return model, W and b turned and faded to a dive's middle."""
        model = self.model.reached(dive)
        old, new = model.kept(self.model)
        n = len(model.names)
        W, b = np.zeros((n, n)), np.zeros(n)
        W[np.ix_(new, new)], b[new] = self.W[np.ix_(old, old)], self.b[old]
        dt = 0.0 if self.time is None else max(0.0, mid_time(dive) - self.time)
        F = model.turning(dt, dive.lat_gps2)
        fade = np.exp(-dt / MEMORY)
        return model, fade * F @ W @ F.T, fade * F @ b

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
        model, W, b = self.ahead(dive)
        H = model.regressor(dive)
        mean, P, _ = solved(W / self.scale.value, b / self.scale.value, model.prior_sd)
        return H @ mean, H @ P @ H.T + self.scale.value * noise(dive) * np.eye(2)

    def update(self, dive: Any) -> None:
        """Learn from a dive that has ended.

        Parameters
        ----------
        dive : Dive
            With its end fix.
        """
        mean, S = self.predict(dive)
        away = miss(dive) - mean
        far = float(away @ np.linalg.solve(S, away))
        if self.time is not None:  # the first miss is the prior's
            self.scale.add(0.5 * min(far, FAR) * self.scale.value)
        self.model, W, b = self.ahead(dive)
        H, r = self.model.regressor(dive, ended=True), noise(dive) * max(1.0, far / FAR)
        self.W = W + H.T @ H / r
        self.b = b + H.T @ miss(dive) / r
        self.time = mid_time(dive)

    def estimate(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the parameters after the last dive.

        Returns
        -------
        mean : ndarray, shape (n,)
            m/s, 1 and rad; held parameters stand at zero.
        covariance : ndarray, shape (n, n)
        learned : ndarray of bool, shape (n,)
        """
        c = self.scale.value
        return solved(self.W / c, self.b / c, self.model.prior_sd)

    def forget_speed(self) -> None:
        """Do nothing: all is forgotten in a day."""


def solved(
    W: np.ndarray, b: np.ndarray, prior_sd: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return mean, covariance and learned of W and b."""
    P = np.linalg.inv(W + np.diag(prior_sd**-2.0))
    mean, P, learned = hold((P @ b)[None], P[None], prior_sd[None])
    return mean[0], P[0], learned[0]


def noise(dive: Any) -> float:
    """Return the variance of one component of y, m^2."""
    return float(fix_variance(dive, UNEXPLAINED))
