"""Bound on the flow that least squares at fixes has learned, leg by leg (law fix-regression).

With eta = theta - theta_hat, V = tr(eta P^-1 eta^T), legs of duration T, fixes within n of the
truth, an unmodelled flow within d, and a true flow whose shear is at most L:

    V <= V(0) + sum_k |w_k|^2/r_k^2 - |y_k|^2/(r_k^2 + m_k^T P_k m_k)
    |w_k| <= n (1 + e^LT) + d (e^LT - 1)/L + b_k
    b_k = int_0^T L e^(L (T - u)) (|eta m(u)| + |c| u) du,    m(u) = int_0^u phi(z)
    |eta a| <= (V a^T P a)^(1/2)                                                  for every a

b_k is the error of phi(z) for phi(x), not linearised.  c is a velocity that was added to that of
the prediction, so that it ends at the fix; 0 if the vehicle steered on it.  The steps are theorems
in Coq, `theory/coq/AtFixes.v`.  `ErrorBound` has a second bound, in which the noise of a fix that
two legs share counts once:

    eta a = eta(0) P(0)^-1 P a - sum_k w_k c_k,    c_k = m_k^T P a/r_k^2

Numbers are in one unit of length and one of time.
"""

from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq

from .memory_laws import least_squares_step

SIGMAS = 3.0  # largest error of a fix, in standard deviations of an axis
UNMODELLED = 0.01  # m/s


class Limits(NamedTuple):
    """Limits that the sea and the fixes keep."""

    shear: float  # L, of the true flow, per time
    unmodelled: (
        float  # d, largest flow that the functions do not express, length per time
    )
    noise: float  # n, largest error of a fix, length

    def strayed(self, time: float) -> float:
        """Return the distance by which noise and unmodelled flow grow after a fix."""
        grown = float(np.expm1(self.shear * time))
        return self.noise * grown + self.unmodelled * grown / self.shear

    def sheared(self, times: np.ndarray, known: np.ndarray) -> np.ndarray:
        """Return int L e^(L (T - u)) f(u) du of f at times up to T (..., n), linear between."""
        turns = self.shear * np.diff(times)
        after = np.exp(self.shear * (times[-1] - times[1:]))
        later = beyond_linear(turns) / turns
        before = np.expm1(turns) - later
        return known[..., :-1] @ (after * before) + known[..., 1:] @ (after * later)


class LegRegressor(NamedTuple):
    """int phi(z) from a fix on, (n, N), at n times since then, the last one at the next fix."""

    times: np.ndarray
    m: np.ndarray
    drift: np.ndarray | float = 0.0  # |c| u at the times


def variances(a: np.ndarray, P: np.ndarray) -> np.ndarray:
    """Return a^T P a of rows a."""
    return np.maximum(np.einsum("ui,ij,uj->u", a, P, a), 0.0)


def level_after(
    level: float,
    leg: LegRegressor,
    P: np.ndarray,
    r: float,
    limits: Limits,
    error: float,
) -> float:
    """Return a bound of V after a leg that is learned with P and r; `level` bounds V before it.

    `error` is |y|, by which V falls: V + |w|^2/r^2 - |y|^2/(r^2 + m^T P m), exactly. A larger one
    than the limits allow shows that they are broken: inf.
    """
    if not np.isfinite(level):
        return np.inf
    share = float(variances(leg.m[-1:], P)[0])
    with np.errstate(over="ignore", invalid="ignore"):
        known = np.sqrt(level * variances(leg.m, P))
        sheared = limits.sheared(leg.times, known + leg.drift)
        w = 2 * limits.noise + limits.strayed(leg.times[-1]) + sheared
        after = level + float(np.square(w / r)) - error**2 / (r**2 + share)
    return after if after >= 0 and error <= known[-1] + w else np.inf


def beyond_linear(x: np.ndarray) -> np.ndarray:
    """Return e^x - 1 - x with all digits, x >= 0."""
    return np.where(x < 1e-3, x**2 / 2 * (1 + x / 3 * (1 + x / 4)), np.expm1(x) - x)


def largest_gain(share: float) -> float:
    """Return the largest L T with share^(1/2) (e^LT - 1 - LT)/(LT) < 1.

    `share` is the largest k T^2 phi^T P phi/r^2 along legs k; N at least.

    >>> [round(largest_gain(N), 2) for N in (1, 3, 6)]
    [1.26, 0.85, 0.65]
    """

    def excess(x: float) -> float:
        return float(share**0.5 * (np.expm1(x) - x) / x - 1)

    return float(brentq(excess, 1e-9, 10.0))


class ErrorBound:
    """Bound on |(theta - theta_hat) a| after legs with one P, for any direction a.

    `prior` is the standard deviation of each parameter, and tr(eta(0) P(0)^-1 eta(0)^T) at most
    `radius` squared.

    >>> bound = ErrorBound(np.array([0.5]), 1.0, Limits(1e-9, 0.0, 0.0))
    >>> bound.learn(LegRegressor(np.array([0.0, 2.0]), np.array([[0.0], [2.0]])), r=1.0)
    >>> bound.at(np.ones((1, 1))).round(6).tolist()  # 0.5/(1 + 0.5^2 2^2)
    [0.25]
    """

    def __init__(self, prior: np.ndarray, radius: float, limits: Limits):
        self.prior, self.radius, self.limits = prior, radius, limits
        self.P = np.diag(prior**2)
        self.level = radius**2
        self.rows = np.empty((0, len(prior)))  # m/r^2
        self.rests = np.empty(0)  # |w| but for the noise of both fixes

    def learn(self, leg: LegRegressor, r: float) -> None:
        """Learn from a leg."""
        by_level, by_sums = self._both(leg.m) + leg.drift
        sheared = self.limits.sheared(leg.times, np.array([by_level, by_sums])).min()
        rest = self.limits.strayed(leg.times[-1]) + sheared
        self.level += np.square((2 * self.limits.noise + rest) / r)
        m = leg.m[-1]
        _, self.P = least_squares_step(self.P, m, np.zeros(2), r)
        self.rows = np.vstack([self.rows, m / r**2])
        self.rests = np.append(self.rests, rest)

    def at(self, a: np.ndarray) -> np.ndarray:
        """Return the bound for rows a, (k, N)."""
        return self._both(a).min(axis=0)

    def _both(self, a: np.ndarray) -> np.ndarray:
        """Return the bounds by V and by sums over the legs, (2, k)."""
        by_level = np.sqrt(self.level * variances(a, self.P))
        Pa = self.P @ a.T
        by_sums = self.radius * np.linalg.norm(Pa / self.prior[:, None], axis=0)
        c = self.rows @ Pa
        ends = np.zeros((1, len(a)))
        # of each fix, the difference of the legs beside it
        fixes = np.abs(np.diff(c, axis=0, prepend=ends, append=ends)).sum(axis=0)
        by_sums = by_sums + self.limits.noise * fixes + self.rests @ np.abs(c)
        return np.array([by_level, by_sums])
