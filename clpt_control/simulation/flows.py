"""The flow at any place and time, through the blocks that run.

    true flow      theta phi(x, t), Eq. (3), or the gridded field
    learned flow   theta_hat phi(x, t)

A map of the current, an arrow along a track and a share of variance all ask
the same blocks that a run asks.
"""

import numpy as np
from numpy.typing import ArrayLike

from ..blocks.arrays import on_arrays
from ..diagrams.scenario_basis import scenario_basis
from ..scenario.experiment import Scenario
from .loops import paper_blocks


def basis_functions(scenario: Scenario, points: ArrayLike, times: np.ndarray | float) -> np.ndarray:
    """Return phi(x, t) of Eq. (5) at places and times.

    Parameters
    ----------
    scenario : Scenario
        Names the basis.
    points : array_like, shape (n, 2)
        Places, units.length.
    times : array_like, shape (n,) or a number
        Times, units.time.

    Returns
    -------
    ndarray, shape (n, N)
        phi at each place and time.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> basis_functions(clpt.paper_scenario(), [[0.0, 0.0]], 0.0).round(3)
    array([[1.   , 0.243, 0.493]])
    """
    block = scenario_basis(scenario)
    return _outputs(block, np.atleast_2d(np.asarray(points, dtype=float)), times)


def flow_velocity(
    scenario: Scenario,
    points: ArrayLike,
    times: np.ndarray | float,
    parameters: np.ndarray | None = None,
) -> np.ndarray:
    """Return the flow at places and times, true or learned.

    The disturbance Delta is not part of it.

    Parameters
    ----------
    scenario : Scenario
        The experiment.
    points : array_like, shape (n, 2)
        Places, units.length.
    times : array_like, shape (n,) or a number
        Times, units.time.
    parameters : array_like, shape (2, N) or (n, 2, N), optional
        Flow parameters theta_hat to use in place of the truth.

    Returns
    -------
    ndarray, shape (n, 2)
        Velocity along x1 and x2, units.length per units.time.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> flow_velocity(clpt.paper_scenario(), [[0.0, 0.0]], 0.0).round(3)
    array([[1.492, 1.392]])
    """
    points = np.atleast_2d(np.asarray(points, dtype=float))
    if parameters is None and scenario.flow.field is not None:
        calm = scenario.with_values({"flow.disturbance": None})
        block = next(b for b in paper_blocks(calm) if b.name == "true_flow")
        return _outputs(block, points, times)
    theta = np.array(scenario.flow.parameters) if parameters is None else np.asarray(parameters)
    phi = basis_functions(scenario, points, times)
    return np.einsum("...ik,...k->...i", theta, phi)


def _outputs(block, points: np.ndarray, times: np.ndarray | float) -> np.ndarray:
    """Return a block's outputs at all places and times at once."""
    times = np.broadcast_to(np.asarray(times, dtype=float), len(points))
    return on_arrays(block.output_record, times, (), points.T, block.parameters).T
