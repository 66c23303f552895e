"""Mixture of Gaussian processes: the default estimator between fixes.

Seas differ in how fast currents change and in the parts of the flow. The mixture has a Gaussian
process (`dive_regression`) for each of a few kinds of sea (`Priors.kinds`) with each choice of
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
"""

from dataclasses import replace
from itertools import product
from math import log

import numpy as np

from ...base.geodesy import displacement
from .dive import Dive
from .dive_regression import DiveRegression, empty_regression
from .estimator import Estimator
from .fix_model import FAR, FixModel
from .priors import DAY, Sea

MOST, DROPPED = 120, 40  # dives of the regression, and oldest dives dropped beyond


class ProcessMixture(Estimator):
    """A Gaussian process for each kind of sea with each choice of parts, and its weight."""

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
        super().__init__(model, seas.scatter, has_part)
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
