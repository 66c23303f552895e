"""Inputs of a diagram as python-control gives them."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..errors import SimulationError


@dataclass(frozen=True)
class Inputs:
    """The inputs of a diagram as a function of time.

    Attributes
    ----------
    at : callable
        ``at(t)`` -> ndarray, shape (ninputs,).
    samples : tuple of ndarray or None
        Times and values, shape (ninputs, nt), joined by straight lines; None
        for a function of the user's.
    """

    at: Callable[[float], np.ndarray]
    samples: tuple[np.ndarray, np.ndarray] | None

    @property
    def kinks(self) -> np.ndarray | None:
        """Times at which the inputs may bend."""
        return None if self.samples is None else self.samples[0]

    def along(self, times: np.ndarray) -> np.ndarray:
        """Return the inputs at times, shape (ninputs, nt)."""
        return np.array([self.at(t) for t in times]).reshape(len(times), -1).T


def numbers(name: str, values: Any) -> np.ndarray:
    """Return an array of numbers, or refuse what is none by its name."""
    try:
        return np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        raise SimulationError(f"{name} = {values!r:.60}: must be an array of numbers") from None


def read_inputs(inputs: Any, times: np.ndarray, count: int) -> Inputs:
    """Read inputs in python-control's forms.

    Parameters
    ----------
    inputs : array_like, callable or None
        Shape (count, nt) at `times`, joined by straight lines; a number or
        one number per input, held; or a function of time.
    times : ndarray
        Times of the samples.
    count : int
        Number of inputs of the diagram.

    Returns
    -------
    Inputs
        At any time.

    Raises
    ------
    SimulationError
        If the shape does not fit or a value is not finite.

    Examples
    --------
    >>> read_inputs([1.0, 3.0], np.array([0.0, 2.0]), 1).at(1.0)
    array([2.])
    """
    if callable(inputs):

        def given(t: float) -> np.ndarray:
            u = np.atleast_1d(numbers("inputs", inputs(float(t))))
            if u.shape != (count,):
                raise SimulationError(
                    f"inputs: the function gives shape {u.shape}, the diagram has {count} inputs"
                )
            return u

        given(times[0])
        return Inputs(given, None)
    values = np.zeros(count) if inputs is None else numbers("inputs", inputs)
    if not np.all(np.isfinite(values)):
        raise SimulationError("inputs: must be finite; fill the gaps before the run")
    if values.ndim <= 1 and not (count == 1 and values.shape == times.shape and len(times) > 1):
        try:
            held = np.broadcast_to(values, count).astype(float)
        except ValueError:
            raise SimulationError(
                f"inputs: shape {values.shape} does not fit {count} inputs at {len(times)} times"
            ) from None
        return Inputs(lambda t: held, (times[:1], held[:, None]))
    values = np.atleast_2d(values)
    if values.shape != (count, len(times)):
        raise SimulationError(
            f"inputs: shape {values.shape} must be ({count}, {len(times)}): inputs x timepts"
        )

    def straight(t: float) -> np.ndarray:
        k = int(np.clip(np.searchsorted(times, t, side="right") - 1, 0, len(times) - 2))
        share = (t - times[k]) / (times[k + 1] - times[k])
        return values[:, k] + share * (values[:, k + 1] - values[:, k])

    return Inputs(straight, (times, values))
