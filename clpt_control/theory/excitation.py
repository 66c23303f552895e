"""Persistent excitation, Definition 3.1, measured along a trajectory.

    kappa_2 I > int_t^{t+T} w(s) w(s)^T ds > kappa_1 I            Definition 3.1

Axis by axis the joint regressor is w = [phi(x), z_i, zc_i], of Eq. (31).  The
integral is not divided by the window.  Its eigenvalues say how well the
parameters of that axis can be told apart on this track; w holds z, which
depends on the learner, so a Gramian belongs to the trajectory it came from.
"""

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from ..blocks.reference import multiples
from ..errors import ScenarioError
from ..flows import basis_functions
from ..scenario import Scenario
from ..simulation import simulate

if TYPE_CHECKING:
    import xarray

NODES_PER_PIECE = 24


@dataclass(frozen=True)
class Excitation:
    """Gramians of the joint regressor over one window.

    Attributes
    ----------
    start, window : float
        The window [start, start + window], units.time.
    names : dict
        ``"x1"`` and ``"x2"`` -> names of the N + 2 parameters of that axis.
    gramians : dict
        ``"x1"`` and ``"x2"`` -> ndarray, shape (N + 2, N + 2).
    """

    start: float
    window: float
    names: dict[str, list[str]]
    gramians: dict[str, np.ndarray]

    @property
    def eigenvalues(self) -> dict[str, np.ndarray]:
        """Eigenvalues of each axis, ascending: kappa_1 first, kappa_2 last."""
        return {axis: np.linalg.eigvalsh(G) for axis, G in self.gramians.items()}

    @property
    def least_excited(self) -> dict[str, dict[str, float]]:
        """Unit eigenvector of the smallest eigenvalue, by parameter name."""
        found = {}
        for axis, G in self.gramians.items():
            vector = np.linalg.eigh(G)[1][:, 0]
            vector = vector * np.sign(vector[np.argmax(np.abs(vector))])
            found[axis] = dict(zip(self.names[axis], map(float, vector), strict=True))
        return found


def parameter_names(N: int) -> dict[str, list[str]]:
    """Name the parameters of each axis, numbered from 1.

    Examples
    --------
    >>> parameter_names(1)["x2"]
    ['theta_2[1]', 'K_2', 'Gamma_2']
    """
    return {
        f"x{i}": [f"theta_{i}[{k}]" for k in range(1, N + 1)] + [f"K_{i}", f"Gamma_{i}"]
        for i in (1, 2)
    }


def started_true(scenario: Scenario) -> Scenario:
    """Give the scenario with the learner started true.

    Parameters
    ----------
    scenario : Scenario
        With flow parameters theta and the learned-flow law.

    Returns
    -------
    Scenario
        alpha(0) = -theta, K(0) = KD, Gamma(0) = GammaD, z(0) = x(0).

    Raises
    ------
    ScenarioError
        If the true flow is a gridded field, which has no theta.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> started_true(clpt.paper_scenario()).learning.parameters[0]
    (-1.0, -0.4, -0.8)
    """
    if scenario.flow.parameters is None:
        raise ScenarioError("flow.field: a gridded field has no true parameters to start from")
    return scenario.with_values(
        {
            "learning.parameters": (-np.array(scenario.flow.parameters)),
            "learning.feedback": scenario.vehicle.feedback,
            "learning.feedforward": scenario.vehicle.feedforward,
            "learning.position": scenario.vehicle.position,
        }
    )


def quadrature(scenario: Scenario, start: float, end: float) -> tuple[np.ndarray, np.ndarray]:
    """Give quadrature nodes and weights between the switches.

    Gauss-Legendre, with a piece for every half period of the fastest tide.

    Parameters
    ----------
    scenario : Scenario
        Its dwell gives the switches.
    start, end : float
        The window, units.time.

    Returns
    -------
    times, weights : ndarray
        No node lies on a switch.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> times, weights = quadrature(clpt.paper_scenario(), 0.0, 50.0)
    >>> float(weights.sum().round(9))
    50.0
    """
    dwell = scenario.reference.dwell
    fastest = min([dwell, *(scenario.periods[np.isfinite(scenario.periods)] / 2)])
    edges = np.unique([start, *multiples(dwell, start, end), end])
    pieces = []
    for a, b in pairwise(edges):
        pieces.append(np.linspace(a, b, int(np.ceil((b - a) / fastest)) + 1))
    cuts = np.unique(np.concatenate(pieces))
    node, weight = np.polynomial.legendre.leggauss(NODES_PER_PIECE)
    half = np.diff(cuts)[:, None] / 2
    times = cuts[:-1, None] + half * (1 + node)
    return times.ravel(), (half * weight).ravel()


def regressor(scenario: Scenario, run: "xarray.Dataset") -> np.ndarray:
    """Give w = [phi(x), z_i, zc_i] of Eq. (31) along a run.

    Parameters
    ----------
    scenario : Scenario
        Names the basis.
    run : xarray.Dataset
        As `simulate` gives it.

    Returns
    -------
    ndarray, shape (2, ntimes, N + 2)
        Axis first.
    """
    phi = basis_functions(scenario, run.position.values, run.time.values)
    z, zc = run.predicted_position.values, run.reference.values
    return np.stack([np.column_stack([phi, z[:, i], zc[:, i]]) for i in range(2)])


def excitation(
    scenario: Scenario, window: float | None = None, start: float | None = None
) -> Excitation:
    """Measure the joint excitation of a scenario over one window.

    Parameters
    ----------
    scenario : Scenario
        Run from its own initial values.
    window : float, optional
        Length of the window, units.time; one cycle of the waypoints.
    start : float, optional
        Start of the window; the second cycle, or as late as fits.

    Returns
    -------
    Excitation
        Gramians, eigenvalues and the least excited direction.

    Raises
    ------
    ScenarioError
        If the window is not positive or does not fit into the run.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.theory.excitation import excitation, started_true
    >>> found = excitation(started_true(clpt.paper_scenario()), 200.0, 200.0)
    >>> [round(float(values[0]), 3) for values in found.eigenvalues.values()]
    [4.333, 4.669]
    """
    duration = scenario.run.duration
    window = min(scenario.cycle, duration) if window is None else window
    start = max(0.0, min(scenario.cycle, duration - window)) if start is None else start
    if not (window > 0 and start >= 0 and start + window <= duration * (1 + 1e-12)):
        raise ScenarioError(
            f"window {window:g} from {start:g}: must be positive and lie within the run, "
            f"0 to {duration:g} {scenario.units.time}"
        )
    times, weights = quadrature(scenario, start, start + window)
    run = simulate(scenario, times)
    gramians = {
        f"x{i}": np.einsum("t,ta,tb->ab", weights, w, w)
        for i, w in enumerate(regressor(scenario, run), 1)
    }
    return Excitation(start, window, parameter_names(scenario.basis.N), gramians)
