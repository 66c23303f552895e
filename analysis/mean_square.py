"""The mean-square bound, which holds where Eqs. (16) and (33) do not.

    int |e|^2 dt <= 2 V(0)/k + int |Delta|^2 dt / k^2,    k = lambda_min(KD)

It follows from V' = -e^T KD e + e^T Delta, Eqs. (34)-(35), by completing the square,
e^T Delta <= k |e|^2/2 + |Delta|^2/(2 k), and needs no excitation.  So rms(e) <= rms(Delta)/k in
the long run.  With the known-flow law the residual (theta - theta_hat) phi(x, t) of Eq. (16)
is part of Delta.
"""

from typing import NamedTuple

import numpy as np
import xarray
from scipy.integrate import cumulative_trapezoid

import clpt_control as clpt


class MeanSquare(NamedTuple):
    """Both sides of the bound from 0 to each time, length squared times time, (nt, ...)."""

    left: np.ndarray
    right: np.ndarray

    @property
    def tightness(self) -> float:
        """The largest left side divided by its right side."""
        right = np.where(self.right > 0, self.right, 1.0)
        return float(np.max(self.left / right))

    @property
    def holds(self) -> bool:
        """Whether left <= right at every time, but for rounding."""
        return bool(np.all(self.left <= self.right * (1 + 1e-9)))


def mean_square_sides(
    times: np.ndarray, e: np.ndarray, delta: np.ndarray, V0: float | np.ndarray, k: float
) -> MeanSquare:
    """Integrate e and Delta (nt, ..., n) by the trapezoid rule over the times (nt,)."""
    left, power = (
        cumulative_trapezoid(np.sum(values**2, axis=-1), times, axis=0, initial=0.0)
        for values in (e, delta)
    )
    return MeanSquare(left, 2 * V0 / k + power / k**2)


def mean_square_bound(run: xarray.Dataset, scenario: clpt.Scenario) -> MeanSquare:
    """Return both sides along a finely sampled run from t = 0."""
    found = clpt.theory.printed_bound(scenario, run, 0.0)
    e, delta = found.size[:, None], found.drive[:, None]
    return mean_square_sides(found.times, e, delta, float(run.lyapunov[0]), found.k)
