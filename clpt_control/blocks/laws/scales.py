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


def times_k(factor: float, power: int = 1) -> Any:
    """Return what makes a multiple of a power of k."""
    return lambda known: factor * mean_feedback(known) ** power


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


def usual_prior(known: Known) -> float:
    """Return 0.3 k R, the standard deviation of each parameter, length per time."""
    return 0.3 * mean_feedback(known) * reach(known)


def usual_noise(known: Known) -> float:
    """Return 0.1 R k^0.5, length per square root of time."""
    return 0.1 * reach(known) * float(np.sqrt(mean_feedback(known)))


PRIOR = Setting(
    None,
    "positive",
    "standard deviation of each theta, length/time; 0.3 k R, mean KD times track's reach",
    usual_prior,
)
NOISE = Setting(None, "positive", "r of the regression, length/time^0.5; 0.1 R k^0.5", usual_noise)
FILTER = Setting(None, "positive", "pole l of the filter, 1/time; 2 k", times_k(2))
MEMORY = Setting(None, "not negative", "m of the memory, 1/time; 0.02 k", times_k(0.02))


def prior(known: Known) -> float:
    """Return the standard deviation of each parameter, as given or the usual one."""
    return PRIOR.of(known, "prior")
