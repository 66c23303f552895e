"""Excitation along a run: Definition 3.1 for every t of a sliding window.

    t -> eigenvalues of int_t^{t+T} w(s) w(s)^T ds

Persistent excitation asks for kappa_1 > 0 for all t; a picture of the smallest
eigenvalue along time says where a track stops teaching.
"""

from dataclasses import dataclass

import numpy as np

from .factors import joined, piece_factors
from .gramian import NOT_LEARNABLE, Excitation, parameter_names
from .recorded import Source, scenario_of, span_of
from .regressor import checked_window, joint_regressor


@dataclass(frozen=True)
class SlidingExcitation:
    """One Excitation per start of the window.

    Attributes
    ----------
    window : float
        Length T of the window, units.time.
    starts : ndarray, shape (count,)
        Starts t of the windows, units.time.
    at : tuple of Excitation
        One per start.
    """

    window: float
    starts: np.ndarray
    at: tuple[Excitation, ...]

    @property
    def eigenvalues(self) -> dict[str, np.ndarray]:
        """Eigenvalues in time, each axis (count, N + 2), ascending."""
        return {
            axis: np.array([found.eigenvalues[axis] for found in self.at])
            for axis in self.at[0].names
        }

    @property
    def weakest(self) -> Excitation:
        """The window with the smallest eigenvalue of all."""
        least = [min(v[0] for v in found.eigenvalues.values()) for found in self.at]
        return self.at[int(np.argmin(least))]


def sliding_excitation(
    source: Source, window: float | None = None, count: int = 100, tolerance: float = NOT_LEARNABLE
) -> SlidingExcitation:
    """Measure the excitation in a window that slides over a run.

    Parameters
    ----------
    source : Scenario or xarray.Dataset
        A scenario is run once from its own initial values; a run is read.
    window : float, optional
        Length of the window, units.time; one cycle of the waypoints.
    count : int, optional
        Number of starts, evenly from the first to the last that fits.
    tolerance : float, optional
        As in `excitation`.

    Returns
    -------
    SlidingExcitation
        Eigenvalues and directions along time.

    Raises
    ------
    ScenarioError
        If the window does not fit into the run.
    DataError
        If the dataset is no run.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 60})
    >>> sliding_excitation(scenario, 20.0, count=5).eigenvalues["x1"].shape
    (5, 5)
    """
    scenario = scenario_of(source)
    first, last = span_of(source)
    window, _ = checked_window(source, window, first)
    starts = np.unique(np.linspace(first, max(first, last - window), max(1, count)))
    along = joint_regressor(source, last - first, first, np.concatenate([starts, starts + window]))
    pieces, names = piece_factors(along), parameter_names(scenario.basis.N)
    left = np.searchsorted(along.cuts, starts - 1e-9 * window)
    right = np.searchsorted(along.cuts, starts + window * (1 - 1e-9))
    unit = scenario.units.time
    found = []
    for start, a, b in zip(starts.tolist(), left, right, strict=True):
        factors = {axis: joined(pieces[i, a:b]) for i, axis in enumerate(names)}
        found.append(Excitation(start, window, along.trajectory, unit, names, factors, tolerance))
    return SlidingExcitation(window, starts, tuple(found))
