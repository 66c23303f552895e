"""Wrong units and axes of the motion through the water, shown by the ways over ground.

With g and w the ways of n legs over ground and through the water,

    g = A(w) + theta m + c T + residual

with the functions of the flow and a mean flow c, which least squares with their priors finds.  A is
the identity for right columns, and a cause's for wrong ones.  Each residual is that of a forecast
from the other legs, over its noise (the sums R are PRESS: D. M. Allen, Technometrics 16, 125-127,
1974).  A cause is told if the log-likelihood ratio (n - 1) log(R/R_A) is clear and its forecasts
are better by a factor.

Where one part of w is over ground, speed or course, that part is g's to the noise, and the flow is
the one that the other part shows.  Legs of one course do not show it.  If both are over ground,
g - w is the noise of the fixes, without a flow: no sea is so still.
"""

from collections.abc import Callable, Sequence
from math import log

import numpy as np

from ...base.units import KNOT
from .fix_settings import rotated

FEWEST, COMPARED = 4, 40  # legs that are compared, the last ones
CLEAR = log(1e5)  # log-likelihood ratio
BETTER = 2.0  # times, root mean square of the errors of forecasts
STILL = 0.01  # m/s, root mean square of a flow
MEAN = 0.5  # m/s, standard deviation of the mean flow
TURNED = np.radians(5.0)


def _as_radians(w: np.ndarray) -> np.ndarray:
    """Return velocities whose courses, read as degrees, were radians."""
    course = np.degrees(np.arctan2(w[:, 0], w[:, 1]))
    speed = np.hypot(*w.T)[:, None]
    return speed * np.column_stack([np.sin(course), np.cos(course)])


CAUSES: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "speeds look like knots": lambda w: KNOT * w,
    "speeds look like km/h": lambda w: w / 3.6,
    "displacements look like km": lambda w: 1000.0 * w,
    "": np.zeros_like,  # of a vehicle that keeps its place
    "courses look like those that the vehicle comes from, or latitudes and longitudes have the "
    "wrong signs": lambda w: -w,
    "east and north look swapped, or courses are counted from east": lambda w: w[
        :, ::-1
    ],
    "courses look like radians": _as_radians,
    "longitudes look positive to the west": lambda w: w * [-1.0, 1.0],
    "latitudes look positive to the south": lambda w: w * [1.0, -1.0],
}


def wrong_motion(
    ways: Sequence[Sequence[float]], prior: np.ndarray, speed: float
) -> str:
    """Return a sentence on the motion through the water, or an empty text.

    `ways` has the way over ground (2) and through the water (2), the duration, the noise r and m of
    each leg, whose unit of speed is `speed` m/s.
    """
    if len(ways) < FEWEST:
        return ""
    rows = np.array(ways)
    over_ground, water, durations, r = rows[:, :2], rows[:, 2:4], rows[:, 4], rows[:, 5]
    still = STILL / speed * durations
    if np.any(water) and residual(over_ground, water) < still @ still:
        return (
            "course and speed look like those over ground. Give those through the water"
        )
    flow = np.column_stack([rows[:, 6:] * prior, durations * MEAN / speed]) / r[:, None]
    errors_of = forecast_errors(flow) / r
    g, w = errors_of @ over_ground, errors_of @ water
    better = min(np.exp(-CLEAR / (len(ways) - 1)), BETTER**-2)
    limit = residual(g, w) * better
    residuals = {
        name: residual(g, errors_of @ of(water)) for name, of in CAUSES.items()
    }
    residuals |= _parts_over_ground(over_ground, water, flow, r)
    cause = min(residuals, key=residuals.__getitem__)
    angle = float(
        np.arctan2(np.sum(w[:, 0] * g[:, 1] - w[:, 1] * g[:, 0]), np.sum(w * g))
    )
    turned = residual(g, rotated(w, angle))
    if residuals[cause] < limit and residuals[cause] < 2 * turned:
        sentence = f"the ways over ground contradict those through the water: {cause}"
        return sentence if cause else ""
    if turned < limit and abs(angle) > TURNED:
        side = "anticlockwise" if angle > 0 else "clockwise"
        return (
            f"the ways over ground are turned by {np.degrees(abs(angle)):.0f} degrees {side} from "
            "those through the water: courses look magnetic, or the compass is wrong"
        )
    return ""


def forecast_errors(regressors: np.ndarray) -> np.ndarray:
    """Return the matrix from values to what is left of each by a fit of the others, (n, n).

    The coefficients of the regressors (n, k) have the prior N(0, 1), the values the noise 1.
    """
    n, k = regressors.shape
    normal = regressors.T @ regressors + np.eye(k)
    residuals = np.eye(n) - regressors @ np.linalg.solve(normal, regressors.T)
    return residuals / np.diag(residuals)[:, None]


def residual(
    over_ground: np.ndarray,
    water: np.ndarray,
    factors: tuple[float, float] = (1.0, 1.0),
) -> float:
    """Return the sum of squared residuals with the best factor on w between two limits."""
    size = float(np.sum(water**2))
    factor = float(np.sum(water * over_ground)) / size if size > 0 else 0.0
    return float(np.sum((over_ground - np.clip(factor, *factors) * water) ** 2))


def _parts_over_ground(
    over_ground: np.ndarray, water: np.ndarray, flow: np.ndarray, r: np.ndarray
) -> dict[str, float]:
    """Return the sums of squared residuals if the speeds, or the courses, are over ground."""
    speed = np.hypot(*water.T)
    ahead = water / np.maximum(speed, 1e-300)[:, None]
    across = ahead @ np.array([[0.0, -1.0], [1.0, 0.0]])
    faster = np.hypot(*over_ground.T) - speed
    aside = np.sum(over_ground * across, axis=1)

    def squares(none: np.ndarray, shown: np.ndarray, directions: np.ndarray) -> float:
        regressors = np.hstack([flow * directions[:, :1], flow * directions[:, 1:]])
        return float(
            np.sum((none / r) ** 2 + (forecast_errors(regressors) @ (shown / r)) ** 2)
        )

    return {
        "speeds look like those over ground, not through the water": squares(
            faster, aside, across
        ),
        "courses look like those over ground, not through the water": squares(
            aside, faster, ahead
        ),
    }
