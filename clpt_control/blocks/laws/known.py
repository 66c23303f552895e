"""What a law may know of an experiment, and the truth that V measures to."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np


class Gains(NamedTuple):
    """The gains with which a law adapts; 0 holds K or Gamma."""

    parameters: float  # gamma of alpha, per time squared
    feedback: float  # gamma of K, per length squared per time squared
    feedforward: float  # gamma of Gamma, per length squared per time squared
    one: bool  # whether one number is given for all, as in the paper


class Fixes(NamedTuple):
    """When the vehicle learns where it is."""

    between: float  # from one fix to the next, time
    latency: float  # from a fix to its arrival, time; below `between`
    noise: float  # standard deviation of each axis, length


class Known(NamedTuple):
    """What a law may know of the experiment: never theta."""

    N: int  # number of basis functions
    gains: Gains
    alpha_M: np.ndarray  # shape (2, N), the modelled flow, length per time
    KD: np.ndarray  # shape (2,), feedback gains of the vehicle, per time
    waypoints: np.ndarray  # shape (n, 2), length
    dwell: float  # time at each waypoint
    position: np.ndarray  # shape (2,), x(0), length
    alpha: np.ndarray  # shape (2, N), alpha(0), length per time
    theta_estimate: np.ndarray  # shape (2, N), given, or alpha_M, length per time
    settings: Mapping[str, Any]  # every key of the law's own table, its value or default
    GammaD: np.ndarray  # shape (2,), feedforward gains of the vehicle, per time
    fixes: Fixes | None = None  # None: the position is read at all times
    limited: bool = False  # whether the vehicle's speed is limited: v_c of Eq. (7) is not v_x

    @property
    def cycle(self) -> float:
        """Time to visit every waypoint once."""
        return len(self.waypoints) * self.dwell

    @property
    def reach(self) -> float:
        """The largest distance of a waypoint from the origin; 1 where all are at it."""
        return float(np.hypot(*self.waypoints.T).max()) or 1.0


class Truth(NamedTuple):
    """What V measures the distance to."""

    theta: np.ndarray  # shape (2, N), length per time
    KD: np.ndarray  # shape (2,), feedback gains of the vehicle, per time
    GammaD: np.ndarray  # shape (2,), feedforward gains, per time
