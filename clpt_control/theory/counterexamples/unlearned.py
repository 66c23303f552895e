"""Is z_c exciting enough?  A counterexample to the argument of Theorem 3.3.

The joint regressor w = [phi, z, z_c] of Eq. (31) must be persistently
exciting.  That z_c is, Assumption 3.1, does not make w so: a basis function
of Eq. (5) that vanishes on the track leaves its parameter where it started,
by Eq. (21), alpha' = -gamma e phi^T.
"""

from dataclasses import dataclass

import numpy as np

from ...blocks import evaluate
from ...diagrams.scenario_basis import scenario_basis
from ...scenario.file import paper_scenario
from ...simulation.integrate import simulate


@dataclass(frozen=True)
class Unlearned:
    """A parameter that stands still while z_c is exciting.

    Attributes
    ----------
    claim : str
        What Theorem 3.3 says.
    kappa : float
        Smallest eigenvalue of int zc zc^T over a cycle, length^2 time.
    function : int
        Number of the basis function, from 1.
    largest : float
        Its largest size along the track.
    times : ndarray, shape (nt,)
        Time.
    estimates : ndarray, shape (nt, 2)
        Estimate of its parameter, both axes, length per time.
    true : ndarray, shape (2,)
        What it should become.
    """

    claim: str
    kappa: float
    function: int
    largest: float
    times: np.ndarray
    estimates: np.ndarray
    true: np.ndarray

    @property
    def moved(self) -> float:
        """How far the estimate went from its start at most."""
        return float(np.abs(self.estimates - self.estimates[0]).max())

    @property
    def error(self) -> float:
        """Smallest error of the estimate at the end."""
        return float(np.abs(self.estimates[-1] - self.true).min())


def unlearned_counterexample(end: float = 400.0, function: int = 2) -> Unlearned:
    """Refute "z_c exciting is enough" of Theorem 3.3.

    Parameters
    ----------
    end : float
        Duration, s.
    function : int
        Basis function to watch, from 1.

    Returns
    -------
    Unlearned
        The paper's scenario with the kernel exp(-d^2/s) of Eq. (5): the second
        function, exp(-d^2/5) around (10, 10), vanishes on the circle.

    Examples
    --------
    >>> found = unlearned_counterexample(end=40.0)
    >>> round(found.kappa, 6), found.moved < 1e-9
    (900.0, True)
    """
    scenario = paper_scenario().with_values(
        {"basis.kernel": "gaussian-sigma", "run.duration": end, "run.output_step": 0.5}
    )
    run = simulate(scenario)
    zc, k = scenario.waypoints, function - 1
    phi = evaluate(scenario_basis(scenario), run.time.values, run.position.values)
    return Unlearned(
        "z_c persistently exciting, so every parameter converges",
        float(np.linalg.eigvalsh(scenario.reference.dwell * zc.T @ zc)[0]),
        function,
        float(np.abs(phi[:, k]).max()),
        run.time.values,
        run.flow_parameters_estimate.values[:, :, k],
        np.array(scenario.flow.parameters)[:, k],
    )
