"""Times, initial states and inputs of a run, in the forms that python-control takes.

Inputs are joined by straight lines, or constant.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy import ndarray

from ...base.arguments import brief, finite, numbers
from ...base.errors import SimulationError


@dataclass(frozen=True)
class Inputs:
    """The inputs of a diagram: ``at(t)`` of shape (ninputs,).

    `samples` holds times and values (ninputs, nt), joined by straight lines.  Two samples at one
    time are a jump.
    """

    samples: tuple[ndarray, ndarray]

    def at(self, t: float) -> ndarray:
        """Return the inputs at a time."""
        return self.along(np.array([t]))[:, 0]

    @cached_property
    def slopes(self) -> ndarray:
        """The slopes from each sample on, shape (ninputs, nt); 0 from the last one."""
        times, u = self.samples
        slopes = np.zeros(u.shape)
        spans = np.diff(times)
        if len(self.jumps):
            spans[spans == 0] = np.inf
        slopes[:, :-1] = np.diff(u) / spans
        return slopes

    @cached_property
    def jumps(self) -> ndarray:
        """Times at which the inputs jump."""
        times = self.samples[0]
        repeated = times[1:] == times[:-1]
        return np.unique(times[1:][repeated]) if repeated.any() else times[:0]

    def kinks(self, slack: float) -> ndarray:
        """Return the times at which the inputs bend.

        Samples on one straight line, equal but for `slack`, relative, are one segment.
        """
        times, u = self.samples
        slopes = self.slopes
        if len(times) < 3:
            return times
        bending = np.ones(len(times), dtype=bool)
        least = slack * np.abs(slopes).max(axis=1, keepdims=True)
        bending[1:-1] = np.any(np.abs(np.diff(slopes[:, :-1])) > least, axis=0)
        if len(self.jumps):
            bending |= np.isin(times, self.jumps)
        bends = np.flatnonzero(bending)
        lengths = np.diff(bends)
        begins = np.repeat(bends[:-1], lengths)  # of each sample's segment
        elapsed = times[:-1] - times[begins]
        line = u[:, begins] + slopes[:, begins] * elapsed
        off = np.abs(line - u[:, :-1]) > slack * np.abs(u).max(axis=1, keepdims=True)
        kinks = times if off.any() else times[bends]
        return np.unique(kinks) if len(self.jumps) else kinks

    def rises(self, k: int) -> ndarray | None:
        """Return the times at which an input rises above 1/2; None if it is constant."""
        times, u = self.samples
        if len(times) < 2:
            return None
        high = u[k] > 0.5
        return times[1:][high[1:] & ~high[:-1]]

    def along(self, times: ndarray) -> ndarray:
        """Return the inputs at times, shape (ninputs, nt)."""
        sample_times, u = self.samples
        rows = np.empty((len(u), len(times)))
        for row, values in zip(rows, u, strict=True):
            row[:] = np.interp(times, sample_times, values)
        return rows


# zero at all times, however many there are
NO_INPUTS = Inputs((np.array([-np.inf]), np.zeros((1, 1))))


def checked_times(name: str, timepts: Any) -> ndarray:
    """Return times as an array: at least two, increasing and finite."""
    times = np.atleast_1d(finite(name, timepts))
    if times.ndim != 1 or len(times) < 2 or not (times[1:] > times[:-1]).all():
        raise SimulationError(
            f"{name} = {brief(timepts)}: must be at least two increasing times, such as "
            "np.linspace(0, 10, 101)"
        )
    return times


def read_inputs(inputs: Any, times: ndarray, count: int) -> Inputs:
    """Read `count` inputs in python-control's forms.

    Straight lines join values of shape (count, nt) at `times`.  A number, or one for each input, is
    constant.
    """
    if isinstance(inputs, Inputs):  # as read before
        return inputs
    if callable(inputs):
        raise SimulationError(
            "inputs: must be values, not a function. Connect a block with this output"
        )
    if inputs is None:
        return Inputs((times[:1], np.zeros((count, 1))))
    values = numbers("inputs", inputs)
    for value in values[~np.isfinite(values)]:
        raise SimulationError(
            f"inputs: must be finite, not {value}. Fill the gaps before the run"
        )
    samples = (count, len(times))
    if values.shape == samples or (count == 1 and values.shape == times.shape):
        return Inputs((times, values.reshape(samples)))
    if values.shape not in {(), (count,)}:
        raise SimulationError(
            f"inputs: shape {values.shape}: give ({count}, {len(times)}), inputs by times"
            + ("" if count else "; initial_state= is the start")
        )
    constant = np.empty((count, 1))
    constant[:, 0] = values
    return Inputs((times[:1], constant))
