"""The scales of a law's settings where they are left out, and the settings that laws share.

k is the mean of KD, per time; R how far the track reaches, length.
"""

import numpy as np

from ...errors import ScenarioError
from .law import Known, Setting

PRIOR = Setting(
    None,
    "positive",
    "standard deviation of each theta, length/time; 0.3 k R, mean KD times track's reach",
)
NOISE = Setting(None, "positive", "r of the regression, length/time^0.5; 0.1 R k^0.5")
FILTER = Setting(None, "positive", "pole l of the filter, 1/time; 2 k")
MEMORY = Setting(None, "not negative", "m of the memory, 1/time; 0.02 k")


def mean_feedback(known: Known) -> float:
    """Return k, the mean feedback gain of the vehicle, per time: the scale of time."""
    return float(np.mean(known.KD))


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


def prior(known: Known) -> float:
    """Return the standard deviation of each parameter as given, or the usual one."""
    return known.settings["prior"] or usual_prior(known)


def noise(known: Known) -> float:
    """Return r of the regression, length per square root of time."""
    given = known.settings["noise"]
    return given or 0.1 * reach(known) * float(np.sqrt(mean_feedback(known)))
