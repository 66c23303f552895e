"""Kalman filters between fixes, weighed by how well each has forecast.

    p_k = F p_{k-1} + w,  y_k = H_k p_k + n,  n ~ (FIX^2 + (s T)^2) I

(R. E. Kalman, "A new approach to linear filtering and prediction problems",
1960; H is that of `fix_model`, w of `wandering`).  How the current wanders, how
much of it no parameter explains (s), and which parts of the flow there are,
differ from sea to sea.  A bank of filters holds a grid of them; each is weighed
by the likelihood of the dives it has forecast (D. T. Magill, "Optimal adaptive
estimation of sampled stochastic processes", 1965), so none is set by hand, and
what was likely weeks ago is forgotten.  A fix beyond a filter's 99.9 % ellipse
is taken for a front: that filter's current walks until the fix lies about there.

The state of a filter is that of `wandering`, continued by the other parameters.
"""

from typing import Any, NamedTuple

import numpy as np

from .fix_model import FAR, FixModel, fix_variance, mid_time, miss
from .held import hold
from .mixture import mixed
from .wandering import QUARTER_DAY, Kinds, kinds, wander

UNEXPLAINED = (0.003, 0.01, 0.03, 0.06, 0.12)  # s, m/s
USUAL, SPREAD = 0.02, 1.5  # its usual value and the spread of its logarithm
SHELF = 0.1  # odds before any dive that tides are strong: the share of shelves in the ocean
ABSENT = 1e-4  # share of a prior's standard deviation where a part is absent
INERTIAL_FADING = 4 * 86400.0  # s
TIDE_FADING = 60 * 86400.0  # s, of what neaps and another place change
MEMORY_OF_WEIGHTS = 20 * 86400.0  # s
MEMORY = 4  # numbers of a state before the parameters: trend and eddies
SPEED_WALK = 0.002  # per sqrt(6 h): a factor changes by 0.04 in 100 days
COMPASS_WALK = 0.001  # rad per sqrt(6 h): by a degree in 100 days


class Seen(NamedTuple):
    """What the bank saw at its last dive, for who watches it.

    `kept` is where the state before stands in the one that `F` (m, n, n) turned,
    `H` (2, n) is the regressor, `innovation` (m, 2) the
    miss less what was expected, `inverse` (m, 2, 2) of its covariance, `rest`
    (m, n, n) is I - K H, `weights` and `mean` were before the dive.
    """

    kept: tuple[np.ndarray, np.ndarray]
    F: np.ndarray
    H: np.ndarray
    innovation: np.ndarray
    inverse: np.ndarray
    rest: np.ndarray
    weights: np.ndarray
    mean: np.ndarray


def faded(model: FixModel, dt: float) -> np.ndarray:
    """Return how much of each parameter is left after a time.

    Parameters
    ----------
    model : FixModel
    dt : float
        s.

    Returns
    -------
    ndarray, shape (n,)
        One, but for what oscillates.
    """
    left = np.ones(len(model.names))
    for k, name in enumerate(model.names):
        if name.startswith("inertial_"):
            left[k] = np.exp(-dt / INERTIAL_FADING)
        elif "_cos_" in name or "_sin_" in name:
            left[k] = np.exp(-dt / TIDE_FADING)
    return left


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
        self.log_prior = self.log_weight
        sd = self.prior_sd(model)
        self.mean, self.covariance = np.zeros(sd.shape), sd[:, :, None] ** 2 * np.eye(sd.shape[1])
        self.time: float | None = None
        self.seen: Seen | None = None

    @property
    def weights(self) -> np.ndarray:
        """Probabilities of the m filters."""
        w = np.exp(self.log_weight - self.log_weight.max())
        return w / w.sum()

    def has(self, model: FixModel) -> np.ndarray:
        """Return which filters have which parameters, shape (m, n)."""
        fixed, last = self.present[:, :-1], self.present[:, -1:]
        return np.hstack([fixed, np.repeat(last, len(model.names) - fixed.shape[1], axis=1)])

    def prior_sd(self, model: FixModel) -> np.ndarray:
        """Return the standard deviations before any dive, shape (m, n)."""
        memory = np.stack([self.kinds.trend / QUARTER_DAY, self.kinds.eddy], axis=1)
        return np.hstack(
            [np.repeat(memory, 2, axis=1), model.prior_sd * np.where(self.has(model), 1.0, ABSENT)]
        )

    def ahead(self, dive: Any) -> tuple[FixModel, np.ndarray, np.ndarray, np.ndarray]:
        """Return the filters at a dive, before its end.

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
        n = len(sd[0])
        mean, P = np.zeros(sd.shape), sd[:, :, None] ** 2 * np.eye(n)
        old, new = with_memory_kept(*model.kept(self.model))
        mean[:, new] = self.mean[:, old]
        P[np.ix_(np.arange(len(P)), new, new)] = self.covariance[:, old[:, None], old]
        dt = 0.0 if self.time is None else max(0.0, mid_time(dive) - self.time)
        F = np.tile(np.eye(n), (len(sd), 1, 1))
        F[:, MEMORY:, MEMORY:] = model.turning(dt, dive.lat_gps2)
        F[:, :6, :6], Q = wander(dt, self.kinds)
        k = MEMORY + model.moving  # what stands behind does not move
        fade = faded(model, dt)
        F[:, MEMORY:, MEMORY:] *= fade
        mean[:, :k] = np.einsum("mij,mj->mi", F[:, :k, :k], mean[:, :k])
        P[:, :k, :] = F[:, :k, :k] @ P[:, :k, :]
        P[:, :, :k] = P[:, :, :k] @ F[:, :k, :k].transpose(0, 2, 1)
        P[:, :6, :6] += Q
        states = np.arange(MEMORY, n)
        P[:, states, states] += sd[:, MEMORY:] ** 2 * (1 - fade**2)
        if model.learn_speed:
            P[:, k - 2, k - 2] += SPEED_WALK**2 * dt / QUARTER_DAY
            P[:, k - 1, k - 1] += COMPASS_WALK**2 * dt / QUARTER_DAY
        return model, F, mean, P

    def noise(self, dive: Any) -> np.ndarray:
        """Return the m covariances of n for a dive, m^2."""
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
        """Hold what is not excited; what every dive excites never is."""
        sd = self.prior_sd(model)
        sd[:, : MEMORY + 2] = np.inf  # trend, eddies and the current itself
        return hold(mean, P, sd)

    def update(self, dive: Any) -> None:
        """Learn from a dive that has ended.

        Parameters
        ----------
        dive : Dive
            With its end fix.
        """
        weights, before, model = self.weights, self.mean, self.model
        self.model, F, mean, P = self.ahead(dive)
        kept = with_memory_kept(*self.model.kept(model))
        H, R = with_memory(self.model.regressor(dive, ended=True)), self.noise(dive)
        innovation = miss(dive) - mean @ H.T
        S = H @ P @ H.T + R
        far = np.einsum("mi,mij,mj->m", innovation, np.linalg.inv(S), innovation)
        jump = np.maximum(far / FAR - 1.0, 0.0) * np.trace(S, axis1=1, axis2=2) / 2
        P[:, [4, 5], [4, 5]] += (jump / dive.duration**2)[:, None]
        S = H @ P @ H.T + R
        inverse = np.linalg.inv(S)
        far = np.einsum("mi,mij,mj->m", innovation, inverse, innovation)
        dt = 0.0 if self.time is None else max(0.0, mid_time(dive) - self.time)
        remembered = np.exp(-dt / MEMORY_OF_WEIGHTS) * (self.log_weight - self.log_prior)
        self.log_weight = self.log_prior + remembered - 0.5 * (far + np.log(np.linalg.det(S)))
        self.log_weight -= self.log_weight.max()
        gain = P @ H.T @ inverse
        self.mean = mean + np.einsum("mni,mi->mn", gain, innovation)
        rest = np.eye(P.shape[1]) - gain @ H
        P = rest @ P @ rest.transpose(0, 2, 1) + gain @ R @ gain.transpose(0, 2, 1)
        self.covariance = 0.5 * (P + P.transpose(0, 2, 1))
        self.time = mid_time(dive)
        self.seen = Seen(kept, F, H, innovation, inverse, rest, weights, before)

    def estimate(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the parameters after the last dive.

        Returns
        -------
        mean : ndarray, shape (n,)
            m/s, 1 and rad; held parameters stand at zero.
        covariance : ndarray, shape (n, n)
            Of the whole bank.
        learned : ndarray of bool, shape (n,)
            Which parameters are learned by the likelier half of those filters
            that have them; what is then found to be absent is near zero.
        """
        mean, P, learned = self.held(self.model, self.mean, self.covariance)
        p, C = mixed(mean, P, self.weights)
        add = with_memory(np.eye(len(p) - MEMORY))  # the current is the steady and the eddying
        log_weight = np.where(self.has(self.model), self.log_weight[:, None], -np.inf)
        within = np.exp(log_weight - log_weight.max(axis=0))
        share = (within * learned[:, MEMORY:]).sum(axis=0) / within.sum(axis=0)
        return add @ p, add @ C @ add.T, (share > 0.5) & (self.time is not None)

    def forget_speed(self) -> None:
        """Make the speed factor uncertain by half its prior variance."""
        if self.model.learn_speed:
            k = MEMORY + self.model.names.index("speed")
            self.covariance[:, k, k] += 0.5 * self.prior_sd(self.model)[:, k] ** 2


def with_memory(H: np.ndarray) -> np.ndarray:
    """Return the regressor of the state: eddies act as the current."""
    return np.hstack([np.zeros((len(H), 2)), H[:, :2], H])


def with_memory_kept(old: np.ndarray, new: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return where states stand, from where parameters do."""
    memory = np.arange(MEMORY)
    return np.concatenate([memory, MEMORY + old]), np.concatenate([memory, MEMORY + new])
