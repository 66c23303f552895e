"""Scatter that lasts: the flow beside theta phi, in kinds of seas that the fixes weigh.

On a leg of duration T with its middle at t the position error is, on each axis,

    y = T d + e' - e,    d = (theta - theta_hat) m/T + x

e and e' are the errors of the fixes before and after.  The scatter x is a process of Ornstein and
Uhlenbeck of standard deviation S and time tau, which a kind of sea has.  For each kind a Kalman
filter follows d and e; with the covariance P of theta, a = m/T and the leg before as 0,

    d = g d0 + w,    g = q (a^T P a0 + S^2)/(a0^T P a0 + S^2),    q = exp(-(t - t0)/tau)

and w keeps the variance a^T P a + S^2 of d.  The density of y, Student's t, weighs the kinds.

theta_hat is that of plain least squares, whose errors sum the noise n of all legs.  So P has a
factor for each kind, with u = m/r^2 by components (W. K. Newey, K. D. West, "A simple, positive
semi-definite, heteroskedasticity and autocorrelation consistent covariance matrix", Econometrica
55, 703-708, 1987):

    c^2 = sum_jk u_j u_k Cov(n_j, n_k) / sum_j u_j^2 r_j^2

The variances of fixes and scatter have a factor each, S/nu: nu counts the position errors, each by
the share of the part in its variance, S is the sum of their squares, and both fade to 1.  Where a
region is that of the prior, nu is one more.
"""

from dataclasses import dataclass, fields, replace
from functools import cached_property
from math import pi
from typing import Any, NamedTuple

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


class Expected(NamedTuple):
    """Position errors y by kinds: their mean (..., 2), variance V and nu.

    `d` is the drift before y is known, `P` the covariances dd and de.
    `fix` is the variance of e', `shares` those of the parts of the noise in V.
    """

    mean: np.ndarray
    V: np.ndarray
    nu: np.ndarray
    d: np.ndarray
    P: np.ndarray
    fix: np.ndarray
    shares: np.ndarray
    q: np.ndarray

    def densities(self, y: np.ndarray) -> np.ndarray:
        """Return the logarithms of the densities of y."""
        square = np.sum((y - self.mean) ** 2, axis=-1)
        of_size = np.log(2 * pi * self.V)
        return -of_size - (self.nu / 2 + 1) * np.log1p(square / (self.nu * self.V))


@dataclass(frozen=True, eq=False)
class Scatter:
    """Filters of all kinds of seas, whose shape is that of `seas.sizes`, (K, L).

    `mean` has d and e on both axes, `P` their covariances dd, de and ee. `taught` is the sum of
    u^2 r^2 by its parts (2, N), `repeated` that of the scatter with what it repeats, (L, N).
    `lag` (L, N) carries what the next leg may repeat, `a` is m/T of the last leg.
    """

    seas: Seas
    log_odds: np.ndarray
    mean: np.ndarray
    P: np.ndarray
    squares: np.ndarray
    count: np.ndarray
    taught: np.ndarray
    repeated: np.ndarray
    lag: np.ndarray
    a: np.ndarray
    middle: float = -np.inf

    @classmethod
    def of(cls, seas: Seas, N: int) -> "Scatter":
        """Return the scatter before any leg."""
        kinds = seas.sizes.shape
        times = len(seas.lasting), N
        return cls(
            seas,
            seas.log_odds,
            np.zeros((2, *kinds, 2)),
            np.zeros((3, *kinds)),
            np.full((2, *kinds), PRIOR_ERRORS),
            np.full((2, *kinds), PRIOR_ERRORS),
            np.full((2, N), LEAST),
            np.full(times, LEAST),
            np.zeros(times),
            np.zeros(N),
        )

    @cached_property
    def weights(self) -> np.ndarray:
        """Probabilities of the kinds, of which `log_odds` are the logarithms."""
        return np.exp(self.log_odds)

    @cached_property
    def factors(self) -> np.ndarray:
        """Factors on the variances of fixes and scatter as they are set."""
        of_fixes, of_scatter = self.squares / self.count
        return np.array([of_fixes, of_scatter * self.seas.sizes**2])

    @property
    def mean_factors(self) -> np.ndarray:
        """Mean of the factors, (2,)."""
        return np.sum(self.weights * self.factors, axis=(1, 2))

    @property
    def square(self) -> float:
        """Factor c^2 on r^2, the mean by what the legs taught."""
        taught = self.taught.sum(axis=1)
        return float(self.mean_factors @ taught / taught.sum())

    def scale_along(self, axes: np.ndarray) -> np.ndarray:
        """Return the factor of P along each axis."""
        squares = axes**2
        fixes, scatter = self.taught @ squares
        of_fixes, of_scatter = self.factors[..., None]
        total = of_fixes * fixes + of_scatter * (self.repeated @ squares)
        return total / (fixes + scatter)

    def begun(self, fix: float) -> "Scatter":
        """Return the scatter with a leg that begins at a fix of its own."""
        d, e = self.mean
        P = np.array([self.P[0], 0 * self.P[1], fix * self.factors[0]])
        return replace(self, mean=np.array([d, 0 * e]), P=P)

    def expected(self, leg: Regression, known: Known) -> Expected:
        """Return the position errors that each kind expects of a leg."""
        T, bend = leg.duration, leg.bend**2
        now, last = leg.m @ known.axes / T, self.a @ known.axes
        of_theta, of_last, of_both = (
            known.left @ by for by in (now**2, last**2, now * last)
        )
        fixes, scatter = self.factors * leg.noise[:, None, None]
        fix, square = fixes / 2, scatter / T**2
        q = np.exp((self.middle - leg.middle) / self.seas.lasting)
        g = q * (of_both + square) / (of_last + square + LEAST)
        dd, de, ee = self.P
        dd, de = g**2 * (dd - of_last - square) + of_theta + square, g * de
        d, e = g[..., None] * self.mean[0], self.mean[1]
        theta, noise = T**2 * of_theta, np.array([ee + fix, scatter * (1 - q**2)])
        V = T**2 * dd - 2 * T * de + ee + fix + bend + leg.added * theta
        of_prior = T**2 * (known.left**2 @ now**2) + bend
        nu = sum(noise * self.count) / sum(noise) + of_prior / (theta + bend + LEAST)
        return Expected(T * d - e, V, nu, d, np.array([dd, de]), fix, noise / V, q)

    def learned(
        self,
        leg: Regression,
        y: np.ndarray,
        found: Expected,
        shift: np.ndarray,
        r: float,
        log_odds: np.ndarray,
    ) -> "Scatter":
        """Return the scatter after a leg, learned with r, that moved theta_hat m/T by a shift."""
        off, fix = y - found.mean, found.fix
        dd, de = found.P
        gain = (leg.duration * dd - de) / found.V
        d = found.d + gain[..., None] * off - shift
        e = (fix / found.V)[..., None] * off
        fading = FADING**found.shares
        square = found.shares * np.sum(off**2, axis=-1) / found.V
        prior = (1 - fading) * PRIOR_ERRORS
        shares = np.sqrt(leg.noise / leg.noise.sum())
        u = np.outer(shares, leg.m / r)
        lag = self.lag * found.q[:, None]
        return replace(
            self,
            log_odds=log_odds,
            mean=np.array([d, e]),
            P=np.array([dd - gain**2 * found.V, -gain * fix, fix - fix**2 / found.V]),
            squares=fading * self.squares + prior + square * self.squares / self.count,
            count=fading * self.count + prior + 2 * found.shares,
            taught=self.taught + u**2,
            repeated=self.repeated + (u[1] + 2 * lag) * u[1],
            lag=lag + u[1],
            a=leg.m / leg.duration,
            middle=leg.middle,
        )

    @property
    def state(self) -> dict[str, Any]:
        """State as numbers and lists."""
        named = {one.name: getattr(self, one.name) for one in fields(self)[1:]}
        return {name: np.asarray(value).tolist() for name, value in named.items()}

    @classmethod
    def of_state(cls, seas: Seas, state: dict[str, Any]) -> "Scatter":
        """Return the scatter that has a state."""
        return cls(seas, **{name: np.array(value) for name, value in state.items()})
