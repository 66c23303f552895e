"""Kalman filters between fixes, weighed by how well each has forecast.

    p_k = F p_{k-1} + w,  y_k = H_k p_k + n,  n ~ (FIX^2 + (s T)^2) I

(R. E. Kalman, "A new approach to linear filtering and prediction problems",
1960; H is that of `fix_model`, w of `wandering`).  How the current wanders, how
much of it no parameter explains (s), and which parts of the flow there are,
differ from sea to sea.  A bank of filters holds a grid of them; each is weighed
by the likelihood of the dives it has forecast (D. T. Magill, "Optimal adaptive
estimation of sampled stochastic processes", 1965), so none is set by hand.  A
fix beyond a filter's 99.9 % ellipse is taken for a front: that filter's current
walks until the fix lies within.

The state of a filter is that of `wandering`, continued by the other parameters.
"""

from typing import Any, NamedTuple

import numpy as np

from .fix_model import FixModel, fix_variance, mid_time, miss
from .held import hold
from .mixture import mixed
from .wandering import QUARTER_DAY, Kinds, kinds, wander

UNEXPLAINED = (0.003, 0.01, 0.03, 0.06, 0.12)  # s, m/s
USUAL, SPREAD = 0.02, 1.5  # its usual value and the spread of its logarithm
SHELF = 0.1  # odds before any dive that tides are strong: the share of shelves in the ocean
ABSENT = 1e-4  # share of a prior's standard deviation where a part is absent
FAR = 13.82  # chi-squared of two components, 99.9 %
INERTIAL_FADING = 4 * 86400.0  # s
MEMORY = 4  # numbers of a state before the parameters: trend and eddies
SPEED_WALK = 0.002  # per sqrt(6 h): a factor changes by 0.04 in 100 days


class Seen(NamedTuple):
    """What the bank saw at its last dive, for who watches it.

    `F` (m, n, n) turned the states, `H` (2, n) is the regressor, `innovation` (m, 2) the
    miss less what was expected, `inverse` (m, 2, 2) of its covariance, `rest`
    (m, n, n) is I - K H, `weights` and `mean` were before the dive.
    """

    F: np.ndarray
    H: np.ndarray
    innovation: np.ndarray
    inverse: np.ndarray
    rest: np.ndarray
    weights: np.ndarray
    mean: np.ndarray


class KalmanBank:
    """Kalman filters on a grid of wandering, noise and parts.

    Attributes
    ----------
    mean, covariance : ndarray, shapes (m, n) and (m, n, n)
        Of the m filters, at the middle of the last dive; n is `MEMORY` more
        than the model's parameters, for trend and eddies.
    log_weight : ndarray, shape (m,)
        Logarithms of the weights, the largest zero.
    seen : Seen or None
        The last dive.

    Parameters
    ----------
    model : FixModel
        The parameters.

    Examples
    --------
    >>> KalmanBank(FixModel(("steady",))).mean.shape
    (75, 8)
    """

    def __init__(self, model: FixModel) -> None:
        self.model = model
        grid, present = kinds(), model.choices()
        which, s, parts = (
            a.ravel()
            for a in np.meshgrid(
                np.arange(len(grid.walk)), UNEXPLAINED, np.arange(len(present)), indexing="ij"
            )
        )
        self.kinds, self.unexplained = Kinds(*(a[which] for a in grid)), s
        self.present = present[parts]
        self.log_weight = self.kinds.log_prior - 0.5 * (np.log(s / USUAL) / SPREAD) ** 2
        tides = [k for k, name in enumerate(model.names) if name.endswith("_cos_east")]
        self.log_weight += self.present[:, tides].any(axis=1) * np.log(SHELF / (1 - SHELF))
        sd = self.prior_sd(model)
        self.mean, self.covariance = np.zeros(sd.shape), sd[:, :, None] ** 2 * np.eye(sd.shape[1])
        self.time: float | None = None
        self.seen: Seen | None = None

    @property
    def weights(self) -> np.ndarray:
        """Probabilities of the m filters."""
        w = np.exp(self.log_weight - self.log_weight.max())
        return w / w.sum()

    def prior_sd(self, model: FixModel) -> np.ndarray:
        """Give the standard deviations before any dive, shape (m, n)."""
        fixed, last = self.present[:, :-1], self.present[:, -1:]
        present = np.hstack([fixed, np.repeat(last, len(model.names) - fixed.shape[1], axis=1)])
        memory = np.stack([self.kinds.trend / QUARTER_DAY, self.kinds.eddy], axis=1)
        return np.hstack(
            [np.repeat(memory, 2, axis=1), model.prior_sd * np.where(present, 1.0, ABSENT)]
        )

    def ahead(self, dive: Any) -> tuple[FixModel, np.ndarray, np.ndarray, np.ndarray]:
        """Give the filters at a dive, before its end.

        Parameters
        ----------
        dive : Dive
            The next dive.

        Returns
        -------
        model : FixModel
            With the places it comes near.
        F : ndarray, shape (m, n, n)
        mean, covariance : ndarray
            Of the m filters.
        """
        model = self.model.reached(dive)
        sd = self.prior_sd(model)
        old, n = len(self.mean[0]), len(sd[0])
        mean, P = np.zeros(sd.shape), sd[:, :, None] ** 2 * np.eye(n)
        mean[:, :old], P[:, :old, :old] = self.mean, self.covariance
        dt = 0.0 if self.time is None else max(0.0, mid_time(dive) - self.time)
        F = np.tile(np.eye(n), (len(sd), 1, 1))
        F[:, MEMORY:, MEMORY:] = model.turning(dt, dive.lat_gps2)
        F[:, :6, :6], Q = wander(dt, self.kinds)
        k = MEMORY + model.moving  # what stands behind does not move
        if "inertial" in model.flow:
            i, fade = MEMORY + model.names.index("inertial_east"), np.exp(-dt / INERTIAL_FADING)
            F[:, i : i + 2, i : i + 2] *= fade
        mean[:, :k] = np.einsum("mij,mj->mi", F[:, :k, :k], mean[:, :k])
        P[:, :k, :] = F[:, :k, :k] @ P[:, :k, :]
        P[:, :, :k] = P[:, :, :k] @ F[:, :k, :k].transpose(0, 2, 1)
        P[:, :6, :6] += Q
        if "inertial" in model.flow:
            for j in (i, i + 1):
                P[:, j, j] += sd[:, j] ** 2 * (1 - fade**2)
        if model.learn_speed:
            P[:, k - 2, k - 2] += SPEED_WALK**2 * dt / QUARTER_DAY
        return model, F, mean, P

    def noise(self, dive: Any) -> np.ndarray:
        """Give the m covariances of n for a dive, m^2."""
        return fix_variance(dive, self.unexplained)[:, None, None] * np.eye(2)

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
        model, _, mean, P = self.ahead(dive)
        H = with_memory(model.regressor(dive))
        mean, P, _ = self.held(model, mean, P)
        return mixed(mean @ H.T, H @ P @ H.T + self.noise(dive), self.weights)

    def held(
        self, model: FixModel, mean: np.ndarray, P: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Hold what is not excited; trend and eddies never are."""
        sd = self.prior_sd(model)
        sd[:, :MEMORY] = np.inf
        return hold(mean, P, sd)

    def update(self, dive: Any) -> None:
        """Learn from a dive that has ended.

        Parameters
        ----------
        dive : Dive
            With its end fix.
        """
        weights, before = self.weights, self.mean
        self.model, F, mean, P = self.ahead(dive)
        H, R = with_memory(self.model.regressor(dive, ended=True)), self.noise(dive)
        innovation = miss(dive) - mean @ H.T
        S = H @ P @ H.T + R
        far = np.einsum("mi,mij,mj->m", innovation, np.linalg.inv(S), innovation)
        jump = np.maximum(far / FAR - 1.0, 0.0) * np.trace(S, axis1=1, axis2=2) / 2
        P[:, [4, 5], [4, 5]] += (jump / dive.duration**2)[:, None]
        S = H @ P @ H.T + R
        inverse = np.linalg.inv(S)
        far = np.einsum("mi,mij,mj->m", innovation, inverse, innovation)
        self.log_weight = self.log_weight - 0.5 * (far + np.log(np.linalg.det(S)))
        self.log_weight -= self.log_weight.max()
        gain = P @ H.T @ inverse
        self.mean = mean + np.einsum("mni,mi->mn", gain, innovation)
        rest = np.eye(P.shape[1]) - gain @ H
        P = rest @ P @ rest.transpose(0, 2, 1) + gain @ R @ gain.transpose(0, 2, 1)
        self.covariance = 0.5 * (P + P.transpose(0, 2, 1))
        self.time = mid_time(dive)
        self.seen = Seen(F, H, innovation, inverse, rest, weights, before)

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
        mean, P, learned = self.held(self.model, self.mean, self.covariance)
        p, C = mixed(mean, P, self.weights)
        add = with_memory(np.eye(len(p) - MEMORY))  # the current is the steady and the eddying
        return add @ p, add @ C @ add.T, (self.weights @ learned > 0.5)[MEMORY:]

    def forget_speed(self) -> None:
        """Give the speed factor its prior variance again, after a fault."""
        if self.model.learn_speed:
            k = MEMORY + self.model.names.index("speed")
            self.covariance[:, k, k] += self.prior_sd(self.model)[:, k] ** 2


def with_memory(H: np.ndarray) -> np.ndarray:
    """Give the regressor of the state: eddies act as the current."""
    return np.hstack([np.zeros((len(H), 2)), H[:, :2], H])
