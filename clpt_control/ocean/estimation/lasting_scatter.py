"""Scatter that lasts: the flow beside theta phi, in kinds of seas that the fixes weigh.

On a leg of duration T with its middle at t the position error is, on each axis,

    y = T d + e' - e,    d = (theta - theta_hat) a + x,    a = m/T

e and e' are the errors of the fixes before and after.  The scatter x is a process of Ornstein and
Uhlenbeck with a standard deviation S and a time tau, which a kind of sea has.  For each kind a
Kalman filter follows d and e.  With the leg before as 0, and P the covariance of theta,

    d = g d0 + w,    g = q (a^T P a0 + S^2)/(a0^T P a0 + S^2),    q = exp(-(t - t0)/tau)

and w keeps the variance a^T P a + S^2 of d.  The density of y, Student's t, weighs the kinds.

theta_hat is that of plain least squares, whose errors are a sum over the noises n of all legs. So
each kind multiplies P by c^2, with u = m/r^2 on each axis of P (W. K. Newey, K. D. West, "A simple,
positive semi-definite, heteroskedasticity and autocorrelation consistent covariance matrix",
Econometrica 55, 703-708, 1987):

    c^2 = sum_jk u_j u_k Cov(n_j, n_k) / sum_j u_j^2 r_j^2

All noise of a kind has a factor S/nu: nu counts the position errors, each by the share of the noise
in its variance, S is the sum of their squares, and both fade to 1.  Where a region is that of the
prior, nu is one more.
"""

from math import pi
from typing import NamedTuple

import numpy as np

from .fix_settings import Seas
from .leg_track import Regression

PRIOR_ERRORS = 1.0  # weight of r as it is set, in position errors on an axis
FADING = 0.97  # of the weight of a position error, at the next one
LEAST = 1e-300


class Known(NamedTuple):
    """Covariance of theta by kinds: shares of the prior's variance that are left along axes.

    `left` is (..., N); `axes` (N, N) are columns, each as long as the prior allows.
    """

    left: np.ndarray
    axes: np.ndarray


class Scatter(NamedTuple):
    """Filters of kinds of seas, whose shape (K, L) is that of `Seas.squares`.

    `drift` and `error` are d and e on both axes (K, L, 2); `dd`, `de` and `ee` their covariances,
    of which an `ee` of 0 is not known. `errors` has S and nu. `taught` is the sum of u^2 r^2 by
    fixes and by scatter of each time, with what it repeats, (1 + L, N), to which the next leg adds
    by `lag`, (L, N). `a` and `middle` are those of the last leg.
    """

    seas: Seas
    log_odds: np.ndarray
    drift: np.ndarray
    error: np.ndarray
    dd: np.ndarray
    de: np.ndarray
    ee: np.ndarray
    errors: np.ndarray
    taught: np.ndarray
    lag: np.ndarray
    a: np.ndarray
    middle: np.ndarray | float = -np.inf

    @classmethod
    def of(cls, seas: Seas, N: int) -> "Scatter":
        """Return the scatter before any leg."""
        kinds, times = seas.squares.shape, len(seas.lasting)
        still, none = np.zeros((*kinds, 2)), np.zeros(kinds)
        errors = np.full((2, *kinds), PRIOR_ERRORS)
        taught = np.full((1 + times, N), LEAST)
        of_kinds = seas.log_odds, still, still, none, none, none, errors
        return cls(seas, *of_kinds, taught, np.zeros((times, N)), np.zeros(N))

    @property
    def weights(self) -> np.ndarray:
        """Probabilities of the kinds, (K, L)."""
        return np.exp(self.log_odds)

    @property
    def factor(self) -> np.ndarray:
        """Factor on the variance of all noise, (K, L)."""
        squares, count = self.errors
        return squares / count

    @property
    def square(self) -> float:
        """Mean factor on the variance of the scatter."""
        return float(np.sum(self.weights * self.factor * self.seas.squares))

    @property
    def begun(self) -> "Scatter":
        """The scatter with a leg that begins at a fix of its own."""
        return self._replace(error=0 * self.error, de=0 * self.de, ee=0 * self.ee)

    def scale_along(self, axes: np.ndarray) -> np.ndarray:
        """Return c^2 along each axis, (K, L, N)."""
        fixes, *scatter = self.taught @ axes**2
        total = fixes + self.seas.squares[..., None] * scatter
        return self.factor[..., None] * total / (fixes + scatter[0])

    def expected(self, leg: Regression, known: Known) -> "Expected":
        """Return the position errors that each kind expects of a leg."""
        T, bend, left = leg.duration, leg.bend**2, known.left
        a = leg.m / T
        now, last = a @ known.axes, self.a @ known.axes
        theta, before, both = left @ now**2, left @ last**2, left @ (now * last)
        fixes, scatter = leg.noise
        fix = self.factor * fixes / 2
        square = self.factor * self.seas.squares * scatter / T**2
        q = np.exp((self.middle - leg.middle) / self.seas.lasting)
        g = q * (both + square) / (before + square + LEAST)
        dd, de = g**2 * (self.dd - before - square) + theta + square, g * self.de
        drift = g[..., None] * self.drift
        noise = np.where(self.ee > 0, self.ee, fix) + fix
        V = T**2 * dd - 2 * T * de + noise + bend + leg.added * T**2 * theta
        of_prior = (T**2 * (left**2 @ now**2) + bend) / V
        share = (noise + T**2 * square * (1 - q**2)) / V
        after = self._replace(
            drift=drift, dd=dd, de=de, lag=q[:, None] * self.lag, a=a, middle=leg.middle
        )
        mean = T * drift - self.error
        return Expected(after, mean, V, self.errors[1] + of_prior, fix, share)


class Expected(NamedTuple):
    """Position errors that kinds expect of a leg: mean (K, L, 2), variance V and nu.

    `scatter` is that before the leg is learned, `fix` the variance of e', `share` that of the noise
    in V.
    """

    scatter: Scatter
    mean: np.ndarray
    V: np.ndarray
    nu: np.ndarray
    fix: np.ndarray
    share: np.ndarray

    def weighed(self, y: np.ndarray) -> tuple[float, "Expected"]:
        """Return the log density of y, and what is expected with the kinds weighed by it."""
        square = np.sum((y - self.mean) ** 2, axis=-1) / self.V
        densities = np.log(2 * pi * self.V) + (self.nu / 2 + 1) * np.log1p(
            square / self.nu
        )
        log_odds = self.scatter.log_odds - densities
        density = np.logaddexp.reduce(log_odds, axis=None)
        scatter = self.scatter._replace(log_odds=log_odds - density)
        return float(density), self._replace(scatter=scatter)

    def learned(
        self, leg: Regression, y: np.ndarray, change: np.ndarray, r: float
    ) -> Scatter:
        """Return the scatter after y, by which least squares with r changed theta_hat."""
        before, V, fix, T = self.scatter, self.V, self.fix, leg.duration
        off = y - self.mean
        gain, of_fix = (T * before.dd - before.de) / V, fix / V
        fading = FADING**self.share
        squares = before.factor * np.sum(off**2, axis=-1) / V
        new = self.share * np.array([squares, np.full_like(V, 2)])
        fixes, scatter = leg.noise / leg.noise.sum()
        u = leg.m / r * scatter**0.5
        told = np.vstack([fixes * (leg.m / r) ** 2, (u + 2 * before.lag) * u])
        return before._replace(
            drift=before.drift + gain[..., None] * off - change @ before.a,
            error=of_fix[..., None] * off,
            dd=before.dd - gain**2 * V,
            de=-gain * fix,
            ee=fix - of_fix * fix,
            errors=fading * before.errors + (1 - fading) * PRIOR_ERRORS + new,
            taught=before.taught + told,
            lag=before.lag + u,
        )
