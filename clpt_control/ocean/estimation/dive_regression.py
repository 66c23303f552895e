"""Gaussian-process regression of the misses of a vehicle's dives.

The miss of dive k, fix less dead reckoning, is

    y_k = H_k p(t_k) + int u dt + n_k

with H the regressor of `FixModel`, p its parameters, u a slow current and n white
noise. A parameter of standard deviation sd and memory tau has the covariance

    cov(p(t), p(t')) = sd^2 exp(-|t - t'|/tau) + (variance of its jumps until the earlier time)

Inertial currents are parameters in axes that rotate with them. With K the covariance of all
misses, K = L L^T, and c the covariance of a quantity q with them,

    E[q] = (L^-1 c)^T L^-1 y,   cov(q) = prior - (L^-1 c)^T L^-1 c

(C. E. Rasmussen, C. K. I. Williams, "Gaussian Processes for Machine Learning", 2006, section
2.2). A new dive appends two rows to L^-1, and its innovation, scaled to unit variance, to
L^-1 y.

A current displaces a vehicle by its integral over the dive. For a current with the covariance
k(|t - s|), the integrals over [a, b] and [c, d] have the covariance

    Q(b - c) + Q(a - d) - Q(b - d) - Q(a - c),   Q'' = k,  Q(0) = Q'(0) = 0,

for any two intervals: separate, overlapping or identical. The Matern covariances of order 1/2
("rough") and 3/2 ("smooth") are, with u = |t|/tau and v = sqrt(3) |t|/tau,

    rough    k = exp(-u)             Q = tau^2 (u - 1 + exp(-u))
    smooth   k = (1 + v) exp(-v)     Q = tau^2/3 (2 v - 3 + (3 + v) exp(-v))

A steady current that depends on position has the covariance exp(-|x - y|^2/(2 l^2)). Its mean
along two straight dives is computed by Gauss-Legendre quadrature with two points each; dives are
short compared with l.
"""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from .priors import Sea

LENGTH = 28e3  # m, l: that of gaussians which are 20 km wide
# Gauss-Legendre points from the start and the end of a dive
POINTS = 0.5 + np.array([[1.0, -1.0], [-1.0, 1.0]]) / np.sqrt(12)


@dataclass(frozen=True)
class DiveRegression:
    """Regressions of the same N dives by m Gaussian processes with n parameters.

    Attributes
    ----------
    seas : Sea
        Slow current of each process.
    variance, memory : ndarray, shapes (m, n) and (n,)
        Prior of the parameters; memory in s.
    columns : ndarray, shape (N, 2, n)
        Regressors H in the axes of the last dive.
    paths : ndarray, shape (N, 2, 3)
        Time (s), east and north (m) at start and end of each dive.
    jumps : ndarray, shape (m, N, n)
        Variance of the parameters' jumps until each dive.
    misses, whitened : ndarray, shapes (2N,) and (m, 2N)
        y and L^-1 y.
    inverse_factor : ndarray, shape (m, 2N, 2N)
        L^-1.
    """

    seas: Sea
    variance: np.ndarray
    memory: np.ndarray
    columns: np.ndarray
    paths: np.ndarray
    jumps: np.ndarray
    misses: np.ndarray
    whitened: np.ndarray
    inverse_factor: np.ndarray

    def current_covariance(self, path: np.ndarray, paths: np.ndarray) -> np.ndarray:
        """Return the covariances of the integrals of u along paths, (m, N), m^2."""
        seas, durations = self.seas, np.ptp(paths[:, :, 0], axis=1)
        time = integral_covariance(path[:, 0], paths[:, :, 0], seas.memory, seas.smooth)
        position = np.ptp(path[:, 0]) * durations
        position = position * position_covariance(path[:, 1:], paths[:, :, 1:])
        return seas.size[:, None] ** 2 * time + seas.mapped[:, None] ** 2 * position

    def posterior(
        self, H: np.ndarray, path: np.ndarray, jumps: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return mean (m, k), covariance (m, k, k) and (L^-1 c)^T (m, k, 2N) of q = H p.

        `H` is (k, n). The first two parameters contain the mean of u along the path; `jumps`
        (m, n) is the variance of all jumps so far.
        """
        duration = np.ptp(path[:, 0])
        age = np.abs(path[:, 0].mean() - self.paths[:, :, 0].mean(axis=1))
        variance = self.variance[:, None] * np.exp(-age[:, None] / self.memory)
        cross = ((variance + self.jumps)[:, :, None] * self.columns) @ H.T
        current = self.current_covariance(path, self.paths) / duration
        cross += current[..., None, None] * H[:, :2].T
        c = cross.reshape(len(cross), -1, len(H)).transpose(0, 2, 1)
        factor = c @ self.inverse_factor.transpose(0, 2, 1)
        mean = (factor @ self.whitened[..., None])[..., 0]
        prior = self.variance + jumps
        prior[:, :2] += self.current_covariance(path, path[None]) / duration**2
        covariance = (prior[:, None] * H) @ H.T
        return mean, covariance - factor @ factor.transpose(0, 2, 1), factor

    def with_dive(
        self, S: np.ndarray, innovation: np.ndarray, factor: np.ndarray, **dive: Any
    ) -> "DiveRegression":
        """Return the regression of one more dive.

        `innovation` (m, 2), its covariance `S` (m, 2, 2) and the factor (m, 2, 2N) are those of
        its posterior; `dive` has its columns, path, jumps and miss by the names of the
        attributes.
        """
        m, size = self.whitened.shape
        inverse = np.linalg.inv(np.linalg.cholesky(S))
        inverse_factor = np.zeros((m, size + 2, size + 2))
        inverse_factor[:, :size, :size] = self.inverse_factor
        inverse_factor[:, size:, :size] = -inverse @ (factor @ self.inverse_factor)
        inverse_factor[:, size:, size:] = inverse
        whitened = (inverse @ innovation[..., None])[..., 0]
        return replace(
            self,
            columns=np.concatenate([self.columns, dive["columns"][None]]),
            paths=np.concatenate([self.paths, dive["paths"][None]]),
            jumps=np.concatenate([self.jumps, dive["jumps"][:, None]], axis=1),
            misses=np.concatenate([self.misses, dive["misses"]]),
            whitened=np.concatenate([self.whitened, whitened], axis=1),
            inverse_factor=inverse_factor,
        )

    def without_oldest(self, count: int) -> "DiveRegression":
        """Return the regression of all but the oldest dives."""
        L = np.linalg.inv(self.inverse_factor)[:, 2 * count :]
        inverse_factor = np.linalg.inv(np.linalg.cholesky(L @ L.transpose(0, 2, 1)))
        misses = self.misses[2 * count :]
        return replace(
            self,
            columns=self.columns[count:],
            paths=self.paths[count:],
            jumps=self.jumps[:, count:],
            misses=misses,
            whitened=inverse_factor @ misses,
            inverse_factor=inverse_factor,
        )


def empty_regression(
    seas: Sea, variance: np.ndarray, memory: np.ndarray
) -> DiveRegression:
    """Return the regression without dives."""
    m, n = variance.shape
    return DiveRegression(
        seas,
        variance,
        memory,
        columns=np.zeros((0, 2, n)),
        paths=np.zeros((0, 2, 3)),
        jumps=np.zeros((m, 0, n)),
        misses=np.zeros(0),
        whitened=np.zeros((m, 0)),
        inverse_factor=np.zeros((m, 0, 0)),
    )


def rough_integral(time: np.ndarray, tau: np.ndarray) -> np.ndarray:
    """Return Q of the rough covariance, s^2."""
    u = np.abs(time) / tau
    return tau**2 * (u + np.expm1(-u))


def smooth_integral(time: np.ndarray, tau: np.ndarray) -> np.ndarray:
    """Return Q of the smooth covariance, s^2."""
    v = np.sqrt(3) * np.abs(time) / tau
    return tau**2 / 3 * (2 * v - 3 + (3 + v) * np.exp(-v))


def integral_covariance(
    interval: np.ndarray, intervals: np.ndarray, tau: np.ndarray, smooth: np.ndarray
) -> np.ndarray:
    """Return the covariances of a unit current's integrals, (m, N), s^2.

    `interval` (2,) and each of `intervals` (N, 2) are start and end in s; `tau` (m,) in s, and
    `smooth` (m,) is 1 for smooth currents and 0 for rough ones.
    """
    start, end = interval
    starts, ends = intervals.T
    lags = np.stack([end - starts, start - ends, end - ends, start - starts])
    tau, smooth = tau[:, None, None], smooth[:, None, None]
    Q = np.where(smooth, smooth_integral(lags, tau), rough_integral(lags, tau))
    return Q[:, 0] + Q[:, 1] - Q[:, 2] - Q[:, 3]


def position_covariance(line: np.ndarray, lines: np.ndarray) -> np.ndarray:
    """Return the mean covariances along lines, (N,), of a unit current that depends on position.

    `line` (2, 2) and each of `lines` (N, 2, 2) are start and end, in m.
    """
    separation = (POINTS @ line)[:, None] - (POINTS @ lines)[:, None]
    square = np.sum(separation**2, axis=-1)
    return np.exp(-square / (2 * LENGTH**2)).mean(axis=(1, 2))
