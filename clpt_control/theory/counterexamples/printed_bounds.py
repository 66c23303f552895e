"""The printed bounds on |e|, Eqs. (16) and (33), beside a run.

    |e| <= |(theta - theta_hat) phi(x, t)| / mu,  mu < lambda_min(KD)      Eq. (16)
    |e| <= |Delta| / beta,                      beta < lambda_min(KD)      Eq. (33)

Each is taken at its kindest: the largest drive of the measured stretch, and the limit that any
mu or beta below lambda_min(KD) allows.  A ratio above 1 then refutes it.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ...arguments import check_holds, public
from ...errors import ScenarioError
from ...scenario.experiment import Scenario
from ...simulation.flows import flow_velocity

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True)
class PrintedBound:
    """A printed bound on |e| beside what the equations do."""

    equation: str
    claim: str  # what the equation says
    k: float  # lambda_min(KD), per time
    times: np.ndarray  # (nt,)
    size: np.ndarray  # |e|, length, (nt,)
    drive: np.ndarray  # the size of what drives e, length per time, (nt,)
    start: float  # measured from here on
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


def residual(scenario: Scenario, run: "xarray.Dataset") -> np.ndarray:
    """Return what drives e along a run, length per time, shape (nt, 2).

    Delta of Eq. (32); with the known-flow law Delta + (theta - theta_hat) phi(x, t), Eq. (16).
    """
    if scenario.flow.parameters is None:
        raise ScenarioError("flow.field: a gridded field has no parameters theta to compare with")
    known = scenario.learning.row.given_estimate
    estimate = scenario.learning.theta_estimate if known else scenario.flow.parameters
    modelled = flow_velocity(scenario, run.position.values, run.time.values, np.array(estimate))
    return run.true_flow.values - modelled


@public
def printed_bound(scenario: Scenario, run: "xarray.Dataset", start: float) -> PrintedBound:
    """Set a run beside the bound printed for its law.

    Parameters
    ----------
    scenario : Scenario
        With flow parameters theta; its law chooses Eq. (16) or Eq. (33).
    run : xarray.Dataset
        Its run, finely sampled.
    start : float
        Measure from here on, units.time.

    Returns
    -------
    PrintedBound
        `peak` and `claimed` in units.length, their `ratio`, which is above 1 where the bound is
        violated, and `rms`, that of e over that of what drives it divided by lambda_min(KD).

    Raises
    ------
    ScenarioError
        If the true flow is a gridded field, which has no theta, or the law is not one of
        the paper's.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> wave = {"kind": "square", "amplitude": [0.05, 0.0], "period": 1.8}
    >>> scenario = clpt.theory.started_true(clpt.paper_scenario()).with_values(
    ...     {"flow.disturbance": wave, "run.duration": 40, "run.output_step": 0.05}
    ... )
    >>> clpt.theory.printed_bound(scenario, clpt.simulate(scenario), 0.0).ratio > 1
    True
    """
    printed = {
        "known-flow": ("(16)", "|e| <= max|(theta - theta_hat) phi|/mu for any mu < k"),
        "learned-flow": ("(33)", "|e| <= max|Delta|/beta for any beta < k"),
    }
    law = scenario.learning.law
    if law not in printed:
        raise ScenarioError(
            f'learning.law = "{law}": has no printed bound; must be {" or ".join(printed)}'
        )
    equation, claim = printed[law]
    check_holds("printed_bound: run", run, ["time", "clpe"], "clpt.simulate(scenario) makes a run")
    return PrintedBound(
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
