"""The printed bounds on |e|, Eqs. (16) and (33), set beside a run.

    |e| <= |(theta - theta_hat) phi(x, t)| / mu,  mu < lambda_min(KD)      Eq. (16)
    |e| <= |Delta| / beta,                      beta < lambda_min(KD)      Eq. (33)

Each is taken at its kindest: the largest drive of the whole stretch, and the
limit that any mu or beta below lambda_min(KD) allows.  A ratio above 1 then
refutes it.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ...scenario.experiment import Scenario
from .mean_square import residual

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True)
class Counterexample:
    """A printed bound on |e| beside what the equations do.

    Attributes
    ----------
    equation, claim : str
        Which equation, and what it says.
    k : float
        lambda_min(KD), per time.
    times, size, drive : ndarray, shape (nt,)
        |e| (length) and the size of what drives it (length per time).
    start : float
        Measured from here on; earlier samples are the way there.
    length, time : str
        Units.
    """

    equation: str
    claim: str
    k: float
    times: np.ndarray
    size: np.ndarray
    drive: np.ndarray
    start: float
    length: str = "m"
    time: str = "s"

    @property
    def late(self) -> np.ndarray:
        """Mask of the samples measured, shape (nt,)."""
        return self.times >= self.start

    @property
    def peak(self) -> float:
        """The largest |e| from `start` on, length."""
        return float(self.size[self.late].max())

    @property
    def claimed(self) -> float:
        """The largest drive over k: the printed bound's limit, length."""
        return float(self.drive[self.late].max()) / self.k

    @property
    def ratio(self) -> float:
        """peak / claimed: above 1 the printed bound is violated."""
        return self.peak / self.claimed

    @property
    def fails_above(self) -> float:
        """The printed bound fails for beta (mu) between this and k."""
        return self.k / self.ratio

    @property
    def rms(self) -> float:
        """Root mean square of e, over that of the drive divided by k."""
        e, drive = (_rms(self.times[self.late], v[self.late]) for v in (self.size, self.drive))
        return e / (drive / self.k)


def _rms(times: np.ndarray, values: np.ndarray) -> float:
    from scipy.integrate import trapezoid

    return float(np.sqrt(trapezoid(values**2, times) / (times[-1] - times[0])))


def measured(scenario: Scenario, run: "xarray.Dataset", start: float) -> Counterexample:
    """Set a run beside the bound printed for its law.

    Parameters
    ----------
    scenario : Scenario
        Its law chooses Eq. (16) or Eq. (33).
    run : xarray.Dataset
        Its run, finely sampled.
    start : float
        Measure from here on, units.time.

    Returns
    -------
    Counterexample
        It is one if its ratio is above 1.

    Raises
    ------
    ScenarioError
        If the true flow is a gridded field, which has no theta.
    """
    equation, claim = {
        "known-flow": ("(16)", "|e| <= max|(theta - theta_hat) phi|/mu for any mu < k"),
        "learned-flow": ("(33)", "|e| <= max|Delta|/beta for any beta < k"),
    }[scenario.learning.law]
    return Counterexample(
        equation,
        claim,
        min(scenario.vehicle.feedback),
        run.time.values,
        np.hypot(*run.clpe.values.T),
        np.hypot(*residual(scenario, run).T),
        start,
        scenario.units.length,
        scenario.units.time,
    )
