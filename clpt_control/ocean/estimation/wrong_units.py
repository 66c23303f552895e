"""Wrong units and axes of the motion through the water, shown by the ways over ground.

With g and w the velocities of n legs over ground and through the water,

    g = A(w) + c + residual

with a mean flow c.  A is the identity for right columns, and a cause's for wrong ones.  The
log-likelihood ratio of a cause and the identity is (n - 1) log(R/R_A), with R the sums of squared
residuals.

Where one part of w is over ground, speed or course, that part is g's to the noise, and the mean
flow is the one that the other part shows.  Legs of one course do not show it.

If w is the way over ground itself, g - w is the noise of the fixes, without a flow: no sea is so
still.
"""

from collections.abc import Callable, Sequence
from math import log

import numpy as np

from ...base.units import KNOT

FEWEST, COMPARED = 4, 40  # legs that are compared, the last ones
CLEAR = log(1e5)  # log-likelihood ratio
TURNED = np.radians(5.0)
STILL = 0.01  # m/s, root mean square of a flow


def _as_radians(w: np.ndarray) -> np.ndarray:
    """Return velocities whose courses, read as degrees, were radians."""
    course = np.degrees(np.arctan2(w[:, 0], w[:, 1]))
    speed = np.hypot(*w.T)[:, None]
    return speed * np.column_stack([np.sin(course), np.cos(course)])


CAUSES: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "speeds look like knots": lambda w: KNOT * w,
    "speeds look like km/h": lambda w: w / 3.6,
    "displacements look like km": lambda w: 1000.0 * w,
    "courses look like those that the vehicle comes from": lambda w: -w,
    "east and north look swapped, or courses are counted from east": lambda w: w[
        :, ::-1
    ],
    "courses look like radians": _as_radians,
}


def wrong_motion(ways: Sequence[Sequence[float]], speed: float = 1.0) -> str:
    """Return a sentence on the motion through the water, or an empty text.

    `ways` has velocities over ground (2) and through the water (2) and the duration of each leg,
    whose unit of speed is `speed` m/s.
    """
    if len(ways) < FEWEST:
        return ""
    rows = np.array(ways)
    over_ground, water, durations = rows[:, :2], rows[:, 2:4], rows[:, 4]
    errors = np.hypot(*(over_ground - water).T) * durations
    rms = float(np.sqrt(np.mean(errors**2)))
    if np.any(water) and rms < STILL / speed * float(np.median(durations)):
        return (
            "the ways through the water are those over ground, without any flow: course and speed "
            "look like those over ground. Give those through the water"
        )
    limit = residual(over_ground, water) * np.exp(-CLEAR / (len(ways) - 1))
    residuals = {name: residual(over_ground, of(water)) for name, of in CAUSES.items()}
    residuals |= _parts_over_ground(over_ground, water)
    cause = min(residuals, key=residuals.__getitem__)
    angle = _turn(over_ground, water)
    c, s = np.cos(angle), np.sin(angle)
    turned = residual(over_ground, water @ np.array([[c, s], [-s, c]]))
    if residuals[cause] < limit and residuals[cause] < 2 * turned:
        return f"the ways over ground contradict those through the water: {cause}"
    if turned < limit and abs(angle) > TURNED:
        return (
            f"the ways over ground are turned by {np.degrees(-angle):+.0f} degrees clockwise from "
            "those through the water: courses look magnetic, or the compass is wrong"
        )
    return ""


def _centred(velocity: np.ndarray) -> np.ndarray:
    return velocity - velocity.mean(axis=0)


def residual(
    over_ground: np.ndarray,
    water: np.ndarray,
    factors: tuple[float, float] = (1.0, 1.0),
) -> float:
    """Return the sum of squared residuals with the best factor on w between two limits."""
    g, w = _centred(over_ground), _centred(water)
    size = float(np.sum(w**2))
    factor = float(np.sum(w * g)) / size if size > 0 else 0.0
    return float(np.sum((g - np.clip(factor, *factors) * w) ** 2))


def _parts_over_ground(over_ground: np.ndarray, water: np.ndarray) -> dict[str, float]:
    """Return the sums of squared residuals if the speeds, or the courses, are over ground."""
    speed = np.hypot(*water.T)
    ahead = water / np.maximum(speed, 1e-300)[:, None]
    across = ahead @ np.array([[0.0, -1.0], [1.0, 0.0]])
    faster = np.hypot(*over_ground.T) - speed
    aside = np.sum(over_ground * across, axis=1)

    def squares(none: np.ndarray, shown: np.ndarray, directions: np.ndarray) -> float:
        flow = np.linalg.lstsq(directions, shown)[0]
        return float(none @ none + np.sum((shown - directions @ flow) ** 2))

    return {
        "speeds look like those over ground, not through the water": squares(
            faster, aside, across
        ),
        "courses look like those over ground, not through the water": squares(
            aside, faster, ahead
        ),
    }


def _turn(over_ground: np.ndarray, water: np.ndarray) -> float:
    """Return the angle by which a rotation of the ways through the water fits best, rad."""
    (gx, gy), (wx, wy) = _centred(over_ground).T, _centred(water).T
    return float(np.arctan2(wx @ gy - wy @ gx, wx @ gx + wy @ gy))


def way_of(
    start: Sequence[float], end: Sequence[float], way: Sequence, span: float
) -> list[float]:
    """Return a row of `wrong_motion`: places, stretches, duration."""
    east, north = (sum(stretch[k] for stretch in way) for k in (1, 2))
    ground = [(b - a) / span for a, b in zip(start, end, strict=True)]
    return [*ground, east / span, north / span, span]
