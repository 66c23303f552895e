"""Covariances of currents averaged over dives, in closed form.

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

Source: C. E. Rasmussen, C. K. I. Williams, "Gaussian Processes for Machine Learning", 2006,
section 4.2.1.
"""

import numpy as np

LENGTH = 28e3  # m, l: that of gaussians which are 20 km wide
# Gauss-Legendre points from the start and the end of a dive
POINTS = 0.5 + np.array([[1.0, -1.0], [-1.0, 1.0]]) / np.sqrt(12)


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
