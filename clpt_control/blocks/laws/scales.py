"""The scales of a law's settings where they are left out, and the settings that laws share.

k is the mean of KD, per time; R how far the track reaches, length.
"""

from typing import Any

import numpy as np

from ...errors import ScenarioError
from .known import Known
from .law import Setting


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
MEMORY = Setting("m of the memory, 1/time; 0.02 k", scaled(0.02), "not negative")


def prior(known: Known) -> float:
    """Return the standard deviation of each parameter, as given or the usual one."""
    return PRIOR.of(known, "prior")
