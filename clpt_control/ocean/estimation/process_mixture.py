"""Estimator between fixes: a mixture of Gaussian processes.

Seas differ in how fast currents change and in the parts of the flow. The mixture has a Gaussian
process (`DiveRegression`) for each of a few kinds of sea (`Priors.kinds`) with each choice of
the optional parts (compare D. T. Magill, "Optimal adaptive estimation of sampled stochastic
processes", IEEE Trans. Automatic Control 10, 434-439, 1965). Each is weighted by the density of
the fixes that it has forecast. With r a miss less its forecast and S its covariance,

    w <- w |S|^(-1/2) (1 + r^T S^-1 r / (nu - 2))^(-(nu + 2)/2)

This is Student's t with nu degrees of freedom and covariance S, in which an outlier counts little
(K. L. Lange, R. J. A. Little, J. M. G. Taylor, "Robust statistical modeling using the t
distribution", J. Am. Stat. Assoc. 84, 881-896, 1989). The weights return to their prior within
weeks.

The steady current jumps in two cases:

- A fix outside the 99.9 % ellipse of a process is taken for a front. The variance of the jump
  moves that ellipse's edge to about the fix.
- A vehicle that dives deeper than before, to D instead of D', is in another current. The standard
  deviation of the jump is shear log(D/D'). A vehicle that keeps its depth has no such jump.

A part is present with the weight of the processes that have it: a trend is a smooth current that
changes by more than 5 cm/s in a day, eddies have a memory of up to four days. All processes have
speed and compass errors. The odds that one of these is zero are the ratio of its density at zero
after and before the dives (J. M. Dickey, "The weighted likelihood ratio, linear hypotheses on
normal location parameters", Annals of Statistics 42, 204-223, 1971).

In each process the miss of dive k, fix less dead reckoning, is

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
from itertools import product
from math import atan2, degrees, log
from typing import Any

import numpy as np
from scipy.special import softmax

from ...base.geodesy import displacement
from ...base.units import DAY
from ..gliders.dives import Dive
from .fix_model import FAR, LEARNED, FixModel, Sea

MOST, DROPPED = 120, 40  # dives of the regression, and oldest dives dropped beyond
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


class ProcessMixture:
    """A Gaussian process for each kind of sea with each choice of parts, and its weight.

    `mean` (m, n) and `covariance` (m, n, n) of the parameters of the flow and the vehicle are those
    at the middle of the last dive, `variance` (m, n) is the prior's and `scatter` (m,) is s in m/s.
    `has_part` (m, parts) is true if a process has an optional part.
    """

    def __init__(self, model: FixModel) -> None:
        p = model.priors
        chance = np.array(
            [p.shelf if part == "tides" else p.present for part in model.optional]
        )
        choices = np.array([*product((False, True), repeat=len(chance))], bool)
        has_part = np.tile(choices, (len(p.kinds), 1))
        seas = Sea(*np.repeat(np.array(p.kinds).T, len(choices), axis=1))
        if "gaussians" in model.optional:
            mapped = has_part[:, model.optional.index("gaussians")]
            seas = seas._replace(mapped=p.gaussian * mapped)
        self.model, self.priors = model, p
        self.scatter, self.has_part = seas.scatter, has_part
        self.time: float | None = None
        always = np.ones(len(has_part), bool)
        columns = dict(zip(model.optional, has_part.T, strict=True))
        self.has_parameter = np.stack(
            [columns.get(part, always) for part in model.parts], axis=1
        )
        self.variance = model.prior_sd**2 * self.has_parameter
        self.mean = np.zeros(self.variance.shape)
        self.covariance = self.variance[:, :, None] * np.eye(len(model.names))
        self.log_prior = np.log(np.where(has_part, chance, 1 - chance)).sum(axis=1)
        self.log_weight = self.log_prior
        self.regression = empty_regression(seas, self.variance, model.memory)
        self.jumps = np.zeros(self.mean.shape)
        self.deepest = 0.0
        self.origin: tuple[float, float] | None = None

    def forecast(self, dive: Dive) -> tuple[np.ndarray, np.ndarray]:
        """Return each process's mean (m, 2) and covariance (m, 2, 2) of a dive's miss."""
        reckoned = np.array(dive.through_water)
        mean, S, _ = self._rotated(dive).posterior(
            self.model.regressor(dive), self._path(dive, reckoned), self._jumps(dive)
        )
        return mean, S + self.noise(dive)

    def _rotated(self, dive: Dive) -> DiveRegression:
        """Return the regression in the axes of the inertial current at a dive."""
        rotation = self.model.rotation(self.elapsed(dive), dive.lat_gps2)
        columns = self.regression.columns @ rotation.T
        return replace(self.regression, columns=columns)

    def _path(self, dive: Dive, displaced: np.ndarray) -> np.ndarray:
        """Return time, east and north at start and end of a dive, (2, 3)."""
        start = np.array(dive.start)
        origin = start if self.origin is None else self.origin
        x = np.array(displacement(*origin, *start))
        return np.array([[dive.t_gps2, *x], [dive.t_gpse, *(x + displaced)]])

    def _jumps(self, dive: Dive) -> np.ndarray:
        """Return the variance of the jumps until a dive; a deeper one has its own, (m, n)."""
        jumps, depth = self.jumps.copy(), dive.depth_max or 0.0
        if depth > self.deepest > 0 and "shear" not in self.model.flow:
            jumps[:, :2] += (self.priors.shear * log(depth / self.deepest)) ** 2
        return jumps

    def update(self, dive: Dive) -> None:
        """Learn from a dive that has ended."""
        y, H = dive.miss, self.model.regressor(dive)
        path = self._path(dive, np.array(dive.over_ground))
        regression, jumps = self._rotated(dive), self._jumps(dive)
        mean, S, factor = regression.posterior(H, path, jumps)
        S = S + self.noise(dive)
        innovation = y - mean
        distance = np.einsum("mi,mij,mj->m", innovation, np.linalg.inv(S), innovation)
        self._weigh(distance, S, self.elapsed(dive))
        excess = np.maximum(distance / FAR - 1.0, 0.0)
        front = excess * np.trace(S, axis1=1, axis2=2) / 2
        jumps[:, :2] += front[:, None] / dive.duration**2
        S = S + front[:, None, None] * np.eye(2)
        self.regression = regression.with_dive(
            S, innovation, factor, columns=H, paths=path, jumps=jumps, misses=y
        )
        if len(self.regression.paths) > MOST:
            self.regression = self.regression.without_oldest(DROPPED)
        self.time, self.jumps = dive.mid_time, jumps
        self.deepest = max(self.deepest, dive.depth_max or 0.0)
        self.origin = self.origin or dive.start
        self._describe()

    def _weigh(self, distance: np.ndarray, S: np.ndarray, elapsed: float) -> None:
        """Weight the processes by the density of a fix that they have forecast."""
        nu = self.priors.degrees_of_freedom
        t = (nu + 2) * np.log1p(distance / (nu - 2))
        density = -0.5 * (np.log(np.linalg.det(S)) + t)
        memory = np.exp(-elapsed / self.priors.weight_memory)
        gained = memory * (self.log_weight - self.log_prior) + density
        self.log_weight = self.log_prior + gained
        self.log_weight -= self.log_weight.max()

    def _describe(self) -> None:
        """Compute mean and covariance of the parameters at the last dive."""
        H, path = np.eye(len(self.model.names)), self.regression.paths[-1]
        posterior = self.regression.posterior(H, path, self.jumps)
        self.mean, self.covariance, _ = posterior

    def parts(self) -> dict[str, float]:
        """Return the probability that each part is present."""
        seas = self.regression.seas
        has_part = dict(zip(self.model.optional, self.has_part.T, strict=True))
        has_part["trend"] = seas.smooth * seas.size / seas.memory > 0.05 / DAY
        has_part["eddies"] = seas.memory <= 4 * DAY
        weights = self.weights
        present = {
            name: min(float(weights @ has), 1.0) for name, has in has_part.items()
        }
        for name in ("speed", "compass") if self.model.learn_speed else ():
            k = self.model.names.index(name)
            variance = self.covariance[:, k, k]
            density = np.exp(-0.5 * self.mean[:, k] ** 2 / variance) / np.sqrt(variance)
            odds = weights @ density * self.model.prior_sd[k]
            present[name] = float(1 / (1 + odds))
        return present

    @property
    def weights(self) -> np.ndarray:
        """Probabilities of the m distributions."""
        return softmax(self.log_weight)

    def elapsed(self, dive: Dive) -> float:
        """Return the time from the middle of the last dive to that of this one, s."""
        return 0.0 if self.time is None else max(0.0, dive.mid_time - self.time)

    def noise(self, dive: Dive) -> np.ndarray:
        """Return the m covariances of the noise n of a dive, (m, 2, 2), m^2."""
        return self.model.noise(dive, self.scatter)[:, None, None] * np.eye(2)

    def predict(self, dive: Dive) -> tuple[np.ndarray, np.ndarray]:
        """Forecast fix less dead reckoning of a dive: mean (2,), covariance (2, 2), m."""
        return mixed(*self.forecast(dive), self.weights)

    def estimate(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return mean (n,), covariance (n, n) and the share of the prior's error left (n,).

        The share is computed from the processes that have the parameter.
        """
        weights = self.weights[:, None] * self.has_parameter
        weights /= np.maximum(weights.sum(axis=0), 1e-300)
        spread = self.mean - (weights * self.mean).sum(axis=0)
        variance = np.diagonal(self.covariance, axis1=1, axis2=2) + spread**2
        share = np.sqrt((weights * variance).sum(axis=0)) / self.model.prior_sd
        return *mixed(self.mean, self.covariance, self.weights), share

    def learned(self, dive: Dive) -> dict[str, Any]:
        """Return what is known after a dive, by the names of `forecast.step.Step`."""
        names, (p, P, prior_share) = self.model.names, self.estimate()
        flow = np.arange(len(names) - 2 * self.model.learn_speed)
        H = self.model.regressor(dive)[:, flow] / dive.duration
        known = {
            "current": H @ p[flow],
            "current_error": np.sqrt(np.diag(H @ P[np.ix_(flow, flow)] @ H.T)),
            "parameters": dict(zip(names, p.tolist(), strict=True)),
            "parts": self.parts(),
            "not_learned": tuple(
                name
                for name, share in zip(names, prior_share, strict=True)
                if share >= LEARNED
            ),
        }
        if not self.model.learn_speed:
            return known
        a, b = 1.0 + p[-2], p[-1]  # f cos psi, f sin psi
        f = np.hypot(a, b)
        by = np.array([[a, b], [-b / f, a / f]]) / f  # derivatives of f and psi
        factor, compass = np.sqrt(np.diag(by @ P[-2:, -2:] @ by.T))
        return known | {
            "speed": float(f),
            "speed_error": float(factor),
            "compass": degrees(atan2(b, a)),
            "compass_error": degrees(compass),
        }


def mixed(
    means: np.ndarray, covariances: np.ndarray, weights: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return mean (n,) and covariance (n, n) of a mixture of m distributions.

    m = sum w_i m_i,  P = sum w_i (P_i + (m_i - m)(m_i - m)^T)
    """
    between_means = np.cov(means.T, aweights=weights, ddof=0)
    return weights @ means, np.tensordot(weights, covariances, 1) + between_means
