"""The mean-square bound, what Eqs. (16) and (33) can be replaced with.

    int |e|^2 dt <= 2 V(0)/k + int |Delta|^2 dt / k^2,    k = lambda_min(KD)

It follows from V' = -e^T KD e + e^T Delta, Eqs. (34)-(35), by completing the
square, e^T Delta <= k |e|^2/2 + |Delta|^2/(2 k), and needs no excitation.  So
rms(e) <= rms(Delta)/k in the long run.  With the known-flow law the residual
(theta - theta_hat) phi(x, t) of Eq. (16) takes part in Delta.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ...errors import ScenarioError
from ...scenario.experiment import Scenario
from ...simulation.flows import flow_velocity

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True)
class MeanSquare:
    """Both sides of the mean-square bound, from 0 to each time.

    Attributes
    ----------
    times : ndarray, shape (nt,)
        units.time.
    left : ndarray, shape (nt, ...)
        int |e|^2 dt, length squared times time.
    right : ndarray, shape (nt, ...)
        2 V(0)/k + int |Delta|^2 dt / k^2, the same unit.
    """

    times: np.ndarray
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
    """Return both sides of the bound from samples.

    Parameters
    ----------
    times : ndarray, shape (nt,)
        Increasing; the integrals are by the trapezoid rule over them.
    e, delta : ndarray, shape (nt, ..., n)
        Error (length) and disturbance (length per time).
    V0 : float or ndarray
        V at the first time, Eq. (24), length squared.
    k : float or ndarray
        Smallest feedback gain, per time.

    Returns
    -------
    MeanSquare
        Running integrals, one for each member.

    Examples
    --------
    >>> times = np.linspace(0.0, 1.0, 3)
    >>> found = mean_square_sides(times, np.ones((3, 1)), np.ones((3, 1)), 0.0, 1.0)
    >>> found.left, found.holds
    (array([0. , 0.5, 1. ]), True)
    """
    from scipy.integrate import cumulative_trapezoid

    left, power = (
        cumulative_trapezoid(np.sum(values**2, axis=-1), times, axis=0, initial=0.0)
        for values in (e, delta)
    )
    return MeanSquare(times, left, 2 * V0 / k + power / k**2)


def residual(scenario: Scenario, run: "xarray.Dataset") -> np.ndarray:
    """Return what drives the error: Delta of Eq. (32) along a run.

    Parameters
    ----------
    scenario : Scenario
        With flow parameters theta.
    run : xarray.Dataset
        As `simulate` gives it.

    Returns
    -------
    ndarray, shape (ntimes, 2)
        Delta; with the known-flow law, Delta + (theta - theta_hat) phi(x, t)
        of Eq. (16).  Length per time.

    Raises
    ------
    ScenarioError
        If the true flow is a gridded field, which has no theta.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 2})
    >>> float(np.abs(residual(scenario, clpt.simulate(scenario))).max()) < 1e-12
    True
    """
    if scenario.flow.parameters is None:
        raise ScenarioError("flow.field: a gridded field has no parameters theta to compare with")
    known = scenario.learning.law == "known-flow"
    estimate = scenario.learning.theta_estimate if known else scenario.flow.parameters
    modelled = flow_velocity(scenario, run.position.values, run.time.values, np.array(estimate))
    return run.true_flow.values - modelled


def mean_square_bound(run: "xarray.Dataset", scenario: Scenario) -> MeanSquare:
    """Return both sides of the mean-square bound along a run.

    Parameters
    ----------
    run : xarray.Dataset
        From t = 0, finely sampled: integrals are by the trapezoid rule.
    scenario : Scenario
        Its scenario, with flow parameters theta.

    Returns
    -------
    MeanSquare
        Running integrals.

    Raises
    ------
    ScenarioError
        If the true flow is a gridded field, which has no theta.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> mean_square_bound(clpt.simulate(scenario), scenario).holds
    True
    """
    return mean_square_sides(
        run.time.values,
        run.clpe.values,
        residual(scenario, run),
        float(run.lyapunov.values[0]),
        min(scenario.vehicle.feedback),
    )
