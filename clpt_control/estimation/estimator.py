"""What an estimator between fixes can do.

Everything it says of a dive before `update` is a forecast: `predict` reads the
dive's times, start and dead reckoning, never its end.
"""

from typing import Any, Protocol

import numpy as np

from .fix_model import FixModel


class Estimator(Protocol):
    """An estimator between fixes.

    Attributes
    ----------
    model : FixModel
        Its parameters so far.
    """

    model: FixModel

    def predict(self, dive: Any) -> tuple[np.ndarray, np.ndarray]:
        """Forecast a dive's miss: mean (2,) and covariance (2, 2), m."""

    def update(self, dive: Any) -> None:
        """Learn from a dive that has ended."""

    def estimate(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return mean, covariance and which parameters are learned."""

    def forget_speed(self) -> None:
        """Make the speed factor uncertain again, after a fault."""
