"""Estimators between fixes, chosen by name.

`gradient` is the paper's law, Eq. (22), in integral form; `kalman` a bank of
Kalman filters.  Whatever one says of a dive before `update` is a forecast: it
reads the dive's times, start and dead reckoning, never its end.
"""

from collections.abc import Callable
from typing import Protocol

import numpy as np

from ..arguments import public
from ..errors import ScenarioError
from .dive import Dive
from .fix_model import FixModel
from .gradient import Gradient
from .kalman import KalmanBank


class Estimator(Protocol):
    """What an estimator can do; its `model` has the parameters so far."""

    model: FixModel

    def predict(self, dive: Dive) -> tuple[np.ndarray, np.ndarray]:
        """Forecast a dive's miss: mean (2,) and covariance (2, 2), m."""

    def update(self, dive: Dive) -> None:
        """Learn from a dive that has ended."""

    def estimate(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return mean (n,), covariance (n, n) and how much of the prior's error is left (n,)."""

    def parts(self) -> dict[str, float]:
        """Return the probability that each part of the flow is present; empty if not asked."""

    def forget_speed(self) -> None:
        """Make the speed factor uncertain again, after a fault."""


ESTIMATORS: dict[str, Callable[[FixModel], Estimator]] = {
    "kalman": KalmanBank,
    "gradient": Gradient,
}


@public
def make_estimator(name: str, model: FixModel) -> Estimator:
    """Make an estimator by its name.

    Parameters
    ----------
    name : str
        ``"kalman"`` or ``"gradient"``.
    model : FixModel
        The parameters.

    Returns
    -------
    Estimator
        That has seen no dive.

    Raises
    ------
    ScenarioError
        If the name is unknown.

    Examples
    --------
    >>> make_estimator("gradient", FixModel()).estimate()[0].any()
    np.False_
    """
    if name not in ESTIMATORS:
        raise ScenarioError(f"estimator '{name}': must be one of {', '.join(ESTIMATORS)}")
    return ESTIMATORS[name](model)
