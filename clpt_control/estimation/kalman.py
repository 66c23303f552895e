"""Kalman filters between fixes, weighed by how well each has forecast.

    p_k = F p_{k-1} + w,  y_k = H_k p_k + n,  n ~ (FIX^2 + (s T)^2) I

(R. E. Kalman, "A new approach to linear filtering and prediction problems",
1960; H is that of `fix_model`, w below).  How restless a sea is, and
which parts of the flow there are, differ from sea to sea.  A bank holds a filter
for each combination (D. T. Magill, "Optimal adaptive estimation of sampled
stochastic processes", 1965), weighed by the density of the fixes that it has
forecast, with r the innovation and S its covariance before the fix is used:

    w <- w |S|^(-1/2) (1 + r^T S^-1 r / (nu - 2))^(-(nu + 2)/2)

Student's t of nu degrees of freedom and covariance S, which forgives a strange fix
(K. L. Lange, R. J. A. Little, J. M. G. Taylor, "Robust statistical modeling using
the t distribution", J. Am. Stat. Assoc. 84, 881-896, 1989).  What was likely weeks ago is
forgotten.  A fix beyond a filter's 99.9 % ellipse is taken for a front: that
filter's current walks until the fix lies about there.

A part is present with the weight of the filters that have it.  Speed and compass
are in all: they are absent, f = 1 or psi = 0, with the ratio of the density there
after and before the dives (J. M. Dickey, "The weighted likelihood ratio, linear
hypotheses on normal location parameters", Annals of Statistics 42, 204-223, 1971).

A current wanders between dives by a walk, a trend and an eddying part:

    du = a dt + q dw,  da = -a/F dt + s dw,  s^2 = 2 A^2 / F
    dv = -v/tau dt + sqrt(2/tau) S dw,       flow = u + v

q alone is a random walk.  A trend a fades in F: a manoeuvring target (R. A.
Singer, "Estimating optimal tracking filter performance for manned maneuvering
targets", IEEE Trans. Aerospace and Electronic Systems 6, 473-483, 1970), as a
vehicle sees it that crosses an eddy or a jet.  An eddying part v of size S is
forgotten in tau and returns to the steady current.  Over a time t, with x = t/F,
r = exp(-x) and b = exp(-t/tau),

    a <- r a,  u <- u + F (1 - r) a,  v <- b v
    var a  += A^2 (1 - r^2)
    cov ua += A^2 F (1 - r)^2
    var u  += A^2 F^2 (2x - 3 + 4r - r^2) + q^2 t
    var v  += S^2 (1 - b^2)

The state of one filter is (a_east, a_north, v_east, v_north, u_east, u_north), continued by
the other parameters.
"""

import math
from typing import NamedTuple

import numpy as np

from .dive import Dive, mid_time, miss
from .fix_model import FAR, FixModel
from .priors import QUARTER_DAY, Kind, Priors


def wander(dt: float, kinds: Kind, priors: Priors) -> tuple[np.ndarray, np.ndarray]:
    """Return F and Q of (a, v, u) over `dt` s, (m, 6, 6) each, for m kinds."""
    fading = priors.trend_fading
    x, r = dt / fading, math.exp(-dt / fading)
    b = math.exp(-dt / priors.eddy_memory)
    A2 = (kinds.trend / QUARTER_DAY) ** 2
    m = len(kinds.walk)
    F, Q = np.tile(np.eye(6), (m, 1, 1)), np.zeros((m, 6, 6))
    for a, v, u in ((0, 2, 4), (1, 3, 5)):
        F[:, a, a], F[:, v, v] = r, b
        F[:, u, a] = fading * (1 - r)
        Q[:, a, a] = A2 * (1 - r**2)
        Q[:, a, u] = Q[:, u, a] = A2 * fading * (1 - r) ** 2
        Q[:, u, u] = (
            A2 * fading**2 * max(0.0, 2 * x - 3 + 4 * r - r**2) + kinds.walk**2 * dt / QUARTER_DAY
        )
        Q[:, v, v] = kinds.eddy**2 * (1 - b**2)
    return F, Q


HIDDEN = 4  # states before the parameters: trend and eddies


class Seen(NamedTuple):
    """What the bank saw at its last dive, for who watches it.

    `matched` is where the state before stands in the one that `F` (m, n, n) turned,
    `H` (2, n) is the regressor, `innovation` (m, 2) the
    miss less what was expected, `inverse` (m, 2, 2) of its covariance, `rest`
    (m, n, n) is I - K H, `weights` and `mean` were before the dive.
    """

    matched: tuple[np.ndarray, np.ndarray]
    F: np.ndarray
    H: np.ndarray
    innovation: np.ndarray
    inverse: np.ndarray
    rest: np.ndarray
    weights: np.ndarray
    mean: np.ndarray


class KalmanBank:
    """m Kalman filters: each restlessness with each choice of parts.

    `mean` (m, n) and `covariance` (m, n, n) are those at the middle of the last dive.
    """

    def __init__(self, model: FixModel) -> None:
        self.model, self.priors = model, model.priors
        grid, choices = np.array(self.priors.kinds), model.choices()
        kind, choice = (a.ravel() for a in np.indices((len(grid), len(choices))))
        self.kinds, self.present = Kind(*grid[kind].T), choices[choice]
        chance = np.array(
            [self.priors.shelf if p == "tides" else self.priors.present for p in model.optional]
        )
        self.log_prior = np.log(np.where(self.present, chance, 1 - chance)).sum(axis=1)
        self.log_weight = self.log_prior
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
        """Return which filters have which parameters, (m, n less `HIDDEN`)."""
        always = np.ones(len(self.present), bool)
        columns = dict(zip(model.optional, self.present.T, strict=True))
        return np.stack([columns.get(part, always) for part in model.parts], axis=1)

    def prior_sd(self, model: FixModel) -> np.ndarray:
        """Return the standard deviations before any dive, (m, n); what is absent has zero."""
        hidden = np.stack([self.kinds.trend / QUARTER_DAY, self.kinds.eddy], axis=1)
        return np.hstack([np.repeat(hidden, 2, axis=1), model.prior_sd * self.has(model)])

    def since(self, dive: Dive) -> float:
        """Return the time from the middle of the last dive to that of this one, s."""
        return 0.0 if self.time is None else max(0.0, mid_time(dive) - self.time)

    def ahead(self, dive: Dive) -> tuple[FixModel, np.ndarray, np.ndarray, np.ndarray]:
        """Return model, F, mean and covariance at a dive, before its end."""
        model, priors, dt = self.model.reached(dive), self.priors, self.since(dive)
        sd = self.prior_sd(model)
        n = len(sd[0])
        mean, P = np.zeros(sd.shape), sd[:, :, None] ** 2 * np.eye(n)
        old, new = with_hidden_matched(*model.matched(self.model))
        mean[:, new] = self.mean[:, old]
        P[np.ix_(np.arange(len(P)), new, new)] = self.covariance[:, old[:, None], old]
        fade = model.faded(dt)
        F = np.tile(np.eye(n), (len(sd), 1, 1))
        F[:, HIDDEN:, HIDDEN:] = model.turning(dt, dive.lat_gps2)
        F[:, :6, :6], Q = wander(dt, self.kinds, priors)
        F[:, HIDDEN:, HIDDEN:] *= fade
        k = HIDDEN + model.moving  # gaussians stand behind and do not move
        mean[:, :k] = np.einsum("mij,mj->mi", F[:, :k, :k], mean[:, :k])
        P[:, :k, :] = F[:, :k, :k] @ P[:, :k, :]
        P[:, :, :k] = P[:, :, :k] @ F[:, :k, :k].transpose(0, 2, 1)
        P[:, :6, :6] += Q
        states = np.arange(HIDDEN, n)
        P[:, states, states] += sd[:, HIDDEN:] ** 2 * (1 - fade**2)
        if model.learn_speed:
            P[:, k - 2, k - 2] += priors.speed_walk**2 * dt / QUARTER_DAY
            P[:, k - 1, k - 1] += priors.compass_walk**2 * dt / QUARTER_DAY
        return model, F, mean, P

    def noise(self, dive: Dive) -> np.ndarray:
        """Return the m covariances of n for a dive, m^2."""
        return self.model.noise(dive, self.kinds.scatter)[:, None, None] * np.eye(2)

    def predict(self, dive: Dive) -> tuple[np.ndarray, np.ndarray]:
        """Forecast fix less dead reckoning of a dive: mean (2,), covariance (2, 2), m."""
        model, _, mean, P = self.ahead(dive)
        H = with_hidden(model.regressor(dive))
        return mixed(mean @ H.T, H @ P @ H.T + self.noise(dive), self.weights)

    def update(self, dive: Dive) -> None:
        """Learn from a dive that has ended."""
        weights, before, model = self.weights, self.mean, self.model
        dt = self.since(dive)
        self.model, F, mean, P = self.ahead(dive)
        matched = with_hidden_matched(*self.model.matched(model))
        H, R = with_hidden(self.model.regressor(dive, ended=True)), self.noise(dive)
        innovation = miss(dive) - mean @ H.T
        S = H @ P @ H.T + R
        far = np.einsum("mi,mij,mj->m", innovation, np.linalg.inv(S), innovation)
        nu = self.priors.degrees_of_freedom
        density = -0.5 * (np.log(np.linalg.det(S)) + (nu + 2) * np.log1p(far / (nu - 2)))
        remembered = np.exp(-dt / self.priors.weight_memory) * (self.log_weight - self.log_prior)
        self.log_weight = self.log_prior + remembered + density
        self.log_weight -= self.log_weight.max()
        jump = np.maximum(far / FAR - 1.0, 0.0) * np.trace(S, axis1=1, axis2=2) / 2
        P[:, [4, 5], [4, 5]] += (jump / dive.duration**2)[:, None]
        inverse = np.linalg.inv(H @ P @ H.T + R)
        gain = P @ H.T @ inverse
        self.mean = mean + np.einsum("mni,mi->mn", gain, innovation)
        rest = np.eye(P.shape[1]) - gain @ H
        P = rest @ P @ rest.transpose(0, 2, 1) + gain @ R @ gain.transpose(0, 2, 1)
        self.covariance = 0.5 * (P + P.transpose(0, 2, 1))
        self.time = mid_time(dive)
        self.seen = Seen(matched, F, H, innovation, inverse, rest, weights, before)

    def estimate(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return mean (n,), covariance (n, n) and how much of the prior's error is left (n,).

        What is left is judged by the filters that have the parameter.
        """
        add = with_hidden(np.eye(len(self.model.names)))  # current: steady and eddying
        means, P = self.mean @ add.T, add @ self.covariance @ add.T
        within = self.weights[:, None] * self.has(self.model)
        within /= np.maximum(within.sum(axis=0), 1e-300)
        variance = np.diagonal(P, axis1=1, axis2=2) + (means - (within * means).sum(axis=0)) ** 2
        left = np.sqrt((within * variance).sum(axis=0)) / self.model.prior_sd
        mean, covariance = mixed(means, P, self.weights)
        return mean, covariance, left

    def parts(self) -> dict[str, float]:
        """Return the probability that each part is present."""
        w = self.weights
        has = dict(zip(self.model.optional, self.present.T, strict=True))
        has |= {"trend": self.kinds.trend > 0, "eddies": self.kinds.eddy > 0}
        found = {name: min(float(w @ on), 1.0) for name, on in has.items()}
        for name in ("speed", "compass") if self.model.learn_speed else ():
            k = self.model.names.index(name)
            variance = self.covariance[:, HIDDEN + k, HIDDEN + k]
            after = np.exp(-0.5 * self.mean[:, HIDDEN + k] ** 2 / variance) / np.sqrt(variance)
            found[name] = float(1 / (1 + w @ after * self.model.prior_sd[k]))
        return found

    def forget_speed(self) -> None:
        """Make the speed factor uncertain by half its prior variance."""
        if self.model.learn_speed:
            k = HIDDEN + self.model.names.index("speed")
            self.covariance[:, k, k] += 0.5 * self.priors.speed**2


def mixed(
    means: np.ndarray, covariances: np.ndarray, weights: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return mean (n,) and covariance (n, n) of a mixture of m parts: within and between them.

    m = sum w_i m_i,  P = sum w_i (P_i + (m_i - m)(m_i - m)^T)
    """
    mean = weights @ means
    away = means - mean
    between = np.einsum("m,mi,mj->ij", weights, away, away)
    return mean, np.einsum("m,mij->ij", weights, covariances) + between


def with_hidden(H: np.ndarray) -> np.ndarray:
    """Return the regressor of the state: eddies act as the current."""
    return np.hstack([np.zeros((len(H), 2)), H[:, :2], H])


def with_hidden_matched(old: np.ndarray, new: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return where states stand, from where parameters do."""
    hidden = np.arange(HIDDEN)
    return np.concatenate([hidden, HIDDEN + old]), np.concatenate([hidden, HIDDEN + new])
