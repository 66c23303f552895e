"""Times, initial states and inputs of a run, in the forms that python-control takes.

Inputs are joined by straight lines, or constant.  In Python a run stops at sharp bends of a sampled
input; smaller bends, as of a sampled sine, are smooth to the tolerance.
"""

from bisect import bisect_right
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy import ndarray

from ...base.arguments import brief, finite, numbers
from ...base.errors import SimulationError

SHARP = 10.0  # a bend is sharp if it is so many times as large as most


@dataclass(frozen=True)
class Inputs:
    """The inputs of a diagram: ``at(t)`` of shape (ninputs,).

    `samples` holds times and values (ninputs, nt), joined by straight lines.  Two samples at one
    time are a jump.
    """

    samples: tuple[ndarray, ndarray]

    def at(self, t: float) -> ndarray:
        """Return the inputs at a time."""
        times, u = self.samples
        if len(times) == 1:
            return u[:, 0]
        begins, rows, slopes = self._straight
        k = max(bisect_right(begins, t) - 1, 0)
        return rows[k] + (t - begins[k]) * slopes[k]

    @cached_property
    def _straight(self) -> tuple[list[float], ndarray, ndarray]:
        times, u = self.samples
        rows = np.ascontiguousarray(u.T)
        slopes = np.ascontiguousarray(self.slopes.T)
        return times.tolist(), rows, slopes

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

    @property
    def kinks(self) -> ndarray:
        """Times at which the inputs bend.

        Samples on one straight line, equal to the bit, are one segment.
        """
        times, u = self.samples
        slopes = self.slopes
        if len(times) < 3:
            return times
        bending = np.ones(len(times), dtype=bool)
        bending[1:-1] = np.any(slopes[:, 1:-1] != slopes[:, :-2], axis=0)
        if len(self.jumps):
            bending |= np.isin(times, self.jumps)
        bends = np.flatnonzero(bending)
        lengths = np.diff(bends)
        begins = np.repeat(bends[:-1], lengths)  # of each sample's segment
        elapsed = times[:-1] - times[begins]
        line = u[:, begins] + slopes[:, begins] * elapsed
        straight = np.array_equal(line, u[:, :-1])
        kinks = times[bends] if straight else times
        return np.unique(kinks) if len(self.jumps) else kinks

    def sharp_bends(self, least: float) -> ndarray:
        """Return the times at which the inputs bend sharply.

        A bend that is larger than most, or leaves the line before it by `least` of the largest
        value, is sharp.
        """
        times, u = self.samples
        if len(times) < 3:
            return times[:0]
        # compare each change of slope with the usual one
        slopes = self.slopes[:, :-1]
        bends = np.abs(np.diff(slopes))
        usual = np.median(bends, axis=1, keepdims=True)
        rounding_error = 1e-12 * np.max(np.abs(slopes), axis=1, keepdims=True)
        sharp = bends > SHARP * usual + rounding_error
        # compare the departure from the line before with the size of the input
        spans = np.diff(times)
        departure = bends * np.minimum(spans[1:], spans[:-1])
        sharp |= departure > (least + 1e-12) * np.max(np.abs(u), axis=1, keepdims=True)
        is_sharp = np.any(sharp, axis=0)
        if len(self.jumps):
            is_sharp |= np.isin(times[1:-1], self.jumps)
        return np.unique(times[1:-1][is_sharp])

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
    if values.shape not in {(), (1,), (count,)}:
        raise SimulationError(
            f"inputs: shape {values.shape}: give ({count}, {len(times)}), inputs by times"
            + ("" if count else "; initial_state= is the start")
        )
    constant = np.empty((count, 1))
    constant[:, 0] = values
    return Inputs((times[:1], constant))
