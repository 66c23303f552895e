"""Excitation along a run: Definition 3.1 for every t of a sliding window.

    t -> eigenvalues of int_t^{t+T} w(s) w(s)^T ds

Persistent excitation asks for kappa_1 > 0 for all t; where the smallest eigenvalue falls to zero
along time, the track stops teaching.
"""

from dataclasses import dataclass

import numpy as np

from .between_samples import Source, scenario_of, span_of
from .gramian import NOT_LEARNABLE, Excitation, joined, parameter_names, piece_factors
from .regressor import checked_window, joint_regressor


@dataclass(frozen=True)
class SlidingExcitation:
    """One Excitation per start of the window."""

    window: float  # its length T, units.time
    starts: np.ndarray  # (count,), units.time
    at: tuple[Excitation, ...]  # one per start

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
    """Measure the excitation in a window that slides over a run, `count` starts evenly."""
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
