"""The worst disturbance, where the regressor w(t) is given: a peak gain.

    max |e_i(t)| = Dmax int_0^t |c Phi(t, s) b| ds                Eqs. (28), (32)

over all |Delta_i| <= Dmax, started true; b and c pick e_i in (e_i, eta_i), Phi is
the transition matrix of Eq. (28), and Delta_i(s) = Dmax sign(c Phi(t, s) b) attains
it.  It is exact for this w; the w of a disturbed run differs somewhat, since it
holds z.  Eq. (33) would have it below Dmax/k, the corrected bound of Theorem 3.4
is far above it.
"""

from dataclasses import dataclass

import numpy as np

from ...blocks import evaluate
from ...diagrams.scenario_basis import scenario_basis
from ...scenario.experiment import Scenario
from ...simulation.integrate import simulate
from ..excitation.gramian import started_true
from ..excitation.transition import error_matrices


@dataclass(frozen=True)
class WorstDisturbance:
    """Largest |e_i| that any disturbance of size 1 can make.

    Attributes
    ----------
    times : ndarray, shape (nt,)
        When, units.time.
    gains : ndarray, shape (2, nt)
        max |e_i(t)| / Dmax for a disturbance of axis i, time.
    """

    times: np.ndarray
    gains: np.ndarray

    @property
    def peaks(self) -> tuple[float, float]:
        """The largest gain of each axis."""
        return float(self.gains[0].max()), float(self.gains[1].max())


def influences(A: np.ndarray, step: float, targets: np.ndarray) -> np.ndarray:
    """Return c Phi(t, s) b: what Delta at s does to e at t.

    Parameters
    ----------
    A : ndarray, shape (steps, n, n)
        Matrix of the linear system, held over each step; e comes first.
    step : float
        Length of a step, time.
    targets : ndarray of int, shape (nt,)
        t as numbers of steps from 0.

    Returns
    -------
    ndarray, shape (steps + 1, nt)
        At s = 0, step, 2 step, ...; zero for s > t.

    Examples
    --------
    >>> A = np.full((2, 1, 1), -1.0)
    >>> influences(A, 0.5, np.array([1, 2])).round(4)
    array([[0.6065, 0.3679],
           [1.    , 0.6065],
           [0.    , 1.    ]])
    """
    from scipy.linalg import expm

    moves = expm(A * step)
    targets = np.asarray(targets, dtype=int)
    rows = np.zeros((len(targets), A.shape[-1]))
    found = np.zeros((len(A) + 1, len(targets)))
    for j in range(targets.max(), -1, -1):
        if j < targets.max():
            rows = np.einsum("ti,ij->tj", rows, moves[j])
        rows[targets == j, 0] = 1.0
        found[j] = rows[:, 0]
    return found


def peak_gains(A: np.ndarray, step: float, targets: np.ndarray) -> np.ndarray:
    """Integrate |c Phi(t, s) b| over s from 0 to t.

    Parameters
    ----------
    A : ndarray, shape (steps, n, n)
        As for `influences`.
    step : float
        Length of a step, time.
    targets : ndarray of int, shape (nt,)
        t as numbers of steps from 0.

    Returns
    -------
    ndarray, shape (nt,)
        The largest |e(t)| that a disturbance of size 1 can make.

    Examples
    --------
    >>> A = np.full((4000, 1, 1), -2.0)
    >>> peak_gains(A, 0.005, np.array([4000])).round(4)
    array([0.5])
    """
    size = np.abs(influences(A, step, targets))
    ends = (size[0] + size[targets, np.arange(len(targets))]) / 2
    return step * (size.sum(axis=0) - ends)


def regressor_matrices(scenario: Scenario, end: float, step: float) -> np.ndarray:
    """Return A of Eq. (28) along the undisturbed run, started true.

    Parameters
    ----------
    scenario : Scenario
        With theta and the learned-flow law.
    end, step : float
        A is taken in the middle of each step up to end, units.time.

    Returns
    -------
    ndarray, shape (2, steps, N + 3, N + 3)
        Axis first.

    Raises
    ------
    ScenarioError
        If the true flow is a gridded field, which has no theta.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> regressor_matrices(clpt.paper_scenario(), 1.0, 0.1).shape
    (2, 10, 6, 6)
    """
    calm = started_true(scenario).with_values({"flow.disturbance": None, "run.duration": end})
    run = simulate(calm, step * (np.arange(round(end / step)) + 0.5))
    return error_matrices(
        evaluate(scenario_basis(calm), run.time.values, run.position.values),
        run.predicted_position.values,
        run.reference.values,
        np.array(calm.vehicle.feedback),
        calm.learning.gain,
    )


def worst_disturbance(
    scenario: Scenario, start: float, end: float, step: float = 0.04, every: float = 1.0
) -> WorstDisturbance:
    """Find how far any disturbance can push the error.

    Parameters
    ----------
    scenario : Scenario
        With theta and the learned-flow law; run started true, without Delta.
    start, end : float
        The gains are given from start to end, units.time; Delta acts from 0.
    step : float, optional
        The regressor is held over it, units.time.
    every : float, optional
        Between the times of the gains, units.time.

    Returns
    -------
    WorstDisturbance
        For the regressor of that run.

    Raises
    ------
    ScenarioError
        If the true flow is a gridded field, which has no theta.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> found = worst_disturbance(clpt.paper_scenario(), 20.0, 40.0, step=0.05)
    >>> min(found.peaks) > 1
    True
    """
    A = regressor_matrices(scenario, end, step)
    targets = np.unique(np.round(np.arange(start, end, every) / step).astype(int))
    return WorstDisturbance(
        targets * step, np.stack([peak_gains(A[i], step, targets) for i in range(2)])
    )
