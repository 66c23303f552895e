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
from typing import Any, NamedTuple

import numpy as np

from .fix_settings import FixSettings
from .leg_track import Regression

FADING = 0.97  # of the weight of a position error, at the next one
LEAST = 1e-300
INSTANT = 1e-9  # duration of a leg without one


class Known(NamedTuple):
    """Covariance of theta by kinds: shares of the prior's variance that are left along axes.

    `left` is (..., N); `axes` (N, N) are columns, each as long as the prior allows.
    """

    left: np.ndarray
    axes: np.ndarray


class Scatter(NamedTuple):
    """Filters of kinds of seas, (K, L) as `FixSettings.seas` has them.

    `taught` is the sum of u^2 r^2: all, by fixes, and by the scatter of each time with what it
    repeats, (2 + L, N). `lag` is what the next leg repeats, (L, N). `a` and `middle` are those of
    the last leg. `drift` and `error` are d and e on both axes, (K, L, 2); `dd`, `de` and `ee` are
    their covariances, of which an `ee` of 0 is not known. `errors` has S and nu.
    """

    settings: FixSettings
    log_odds: np.ndarray
    taught: np.ndarray
    a: np.ndarray
    lag: Any = 0.0
    drift: np.ndarray = np.zeros(2)
    error: Any = 0.0
    dd: Any = 0.0
    de: Any = 0.0
    ee: Any = 0.0
    # the weight of r as it is set is that of one position error on an axis
    errors: np.ndarray = np.ones((2, 1, 1))
    middle: Any = -np.inf

    @classmethod
    def of(cls, settings: FixSettings) -> "Scatter":
        """Return the scatter before any leg, each size as likely as another."""
        sizes, a = np.sqrt(settings.seas[1]), 0 * settings.prior
        taught = np.full((2 + sizes.shape[1], len(a)), LEAST)
        return cls(settings, np.log(sizes / sizes.sum()), taught, a)

    @property
    def weights(self) -> np.ndarray:
        """Probabilities of the kinds, (K, L)."""
        return np.exp(self.log_odds)

    @property
    def factors(self) -> np.ndarray:
        """Factors on the variances of fixes and scatter, (2, K, L)."""
        squares, count = self.errors
        return self.settings.seas * squares / count

    def known(self, P: np.ndarray) -> Known:
        """Return a covariance by the kinds, with the prior as it was."""
        prior = self.settings.prior
        sd = np.where(prior > 0, prior, 1.0)
        # of the prior's variance, the share that is left along each axis
        share, axes = np.linalg.eigh(P / np.outer(sd, sd))
        share, axes = np.clip(share, LEAST, 1.0), axes * prior[:, None]
        total, fixes, *scatter = self.taught @ axes**2
        of_fixes, of_scatter = self.factors[..., None]
        noise = (of_fixes - 1) * fixes + of_scatter * scatter - scatter[0]
        left = (total + noise) / (total + LEAST) * share
        return Known(left / (left + 1 - share), axes)

    def expected(
        self, leg: Regression, known: Known, y: np.ndarray | float
    ) -> "Expected":
        """Return what each kind expects of a leg with a position error y."""
        T = max(leg.duration, INSTANT)
        bend, left, a = leg.bend**2, known.left, leg.m / T
        now, last = a @ known.axes, self.a @ known.axes
        theta, before, both = left @ now**2, left @ last**2, left @ (now * last)
        fixes, scatter = self.factors * leg.noise[:, None, None]
        fix, square = fixes / 2, scatter / T**2
        q = np.exp((self.middle - leg.middle) / self.settings.lasting)
        g = q * (both + square) / (before + square + LEAST)
        dd, de = g**2 * (self.dd - before - square) + theta + square, g * self.de
        drift = g[..., None] * self.drift
        off = y - T * drift + self.error
        noise = np.where(self.ee > 0, self.ee, fix) + fix
        V = T**2 * dd - 2 * T * de + noise + bend + leg.added * T**2 * theta
        of_prior = T**2 * (left**2 @ now**2) + bend
        nu = self.errors[1] + of_prior / (T**2 * theta + bend + LEAST)
        tail = (nu / 2 + 1) * np.log1p(np.sum(off**2, axis=-1) / (nu * V))
        scatter = self._replace(
            log_odds=self.log_odds - np.log(2 * pi * V) - tail,
            lag=q[:, None] * self.lag,
            a=a,
            drift=drift,
            dd=dd,
            de=de,
            middle=leg.middle,
        )
        share = (noise + T**2 * square * (1 - q**2)) / V
        return Expected(scatter, off, V, nu, fix, share)


class Expected(NamedTuple):
    """Position errors by kinds: variance V, nu, and how far y is off, (K, L, 2).

    `scatter` is that before the leg is learned, but for `log_odds`, whose sum has the density of y.
    `fix` is the variance of e', `share` that of the noise in V.
    """

    scatter: Scatter
    off: np.ndarray
    V: np.ndarray
    nu: np.ndarray
    fix: np.ndarray
    share: np.ndarray

    @property
    def density(self) -> float:
        """Logarithm of the density of y."""
        return float(np.logaddexp.reduce(self.scatter.log_odds, axis=None))

    def learned(self, leg: Regression, change: np.ndarray, r: float) -> Scatter:
        """Return the scatter after a leg, by which least squares with r changed theta_hat."""
        scatter, off, V, _, fix, share = self
        gain, of_fix = (leg.duration * scatter.dd - scatter.de) / V, fix / V
        square = np.sum(off**2, axis=-1) / V
        new = np.array([scatter.factors[0] * square, 2 + 0 * V])
        fading = FADING**share
        of_fixes, u = np.sqrt(leg.noise)[:, None] * leg.m / r**2
        told = [(leg.m / r) ** 2, of_fixes**2, *((u + 2 * scatter.lag) * u)]
        return scatter._replace(
            log_odds=scatter.log_odds - self.density,
            taught=scatter.taught + np.array(told),
            lag=scatter.lag + u,
            drift=scatter.drift + gain[..., None] * off - change @ scatter.a,
            error=of_fix[..., None] * off,
            dd=scatter.dd - gain**2 * V,
            de=-gain * fix,
            ee=fix - of_fix * fix,
            errors=fading * scatter.errors + 1 - fading + share * new,
        )
