"""What a law may know of an experiment, the truth that V measures to, and a law's settings.

A setting that is left out is made of two scales: k, the mean of KD, per time; R, how far the track
reaches, length.
"""

from collections.abc import Mapping
from typing import Any, Literal, NamedTuple

import numpy as np

from ...errors import ScenarioError


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


class Setting(NamedTuple):
    """A key of a law's own table of the scenario."""

    meaning: str  # what it is, with its unit
    usual: Any  # where it is left out: a number, or what makes it of what is known
    # "below 1" and "at most 1" are positive too
    allowed: Literal["positive", "not negative", "below 1", "at most 1", "row"] = "positive"

    @property
    def default(self) -> Any:
        """A number; None where it is made of what is known."""
        return None if callable(self.usual) else self.usual

    def of(self, known: Known, key: str) -> Any:
        """Return what the scenario gives for a key, or what is usual."""
        given = known.settings[key]
        return self.usual(known) if given is None and callable(self.usual) else given


def mean_feedback(known: Known) -> float:
    """Return k, the mean feedback gain of the vehicle, per time: the scale of time."""
    return float(np.mean(known.KD))


def scaled(factor: float, k: float = 1, R: int = 0) -> Any:
    """Return what makes factor k^k R^R of what is known."""
    return lambda known: factor * mean_feedback(known) ** k * (reach(known) ** R if R else 1)


def reach(known: Known) -> float:
    """Return R, how far start and waypoints lie from the waypoints' middle: the scale of length."""
    places = np.vstack([known.waypoints, known.position])
    R = float(np.max(np.linalg.norm(places - known.waypoints.mean(axis=0), axis=1)))
    if R == 0:
        raise ScenarioError(
            "reference: start and waypoints lie at one place, which has no scale of length; give "
            "prior and noise in the law's own table"
        )
    return R


PRIOR = Setting(
    "standard deviation of each theta, length/time; 0.3 k R, mean KD times track's reach",
    scaled(0.3, k=1, R=1),
)
NOISE = Setting("r of the regression, length/time^0.5; 0.1 R k^0.5", scaled(0.1, k=0.5, R=1))
FILTER = Setting("pole l of the filter, 1/time; 2 k", scaled(2))
MEMORY = Setting(
    "m of the memory, which keeps all and comes to 1/m, 1/time; 0.1 k", scaled(0.1), "not negative"
)


def prior(known: Known) -> float:
    """Return the standard deviation of each parameter, as given or the usual one."""
    return PRIOR.of(known, "prior")
