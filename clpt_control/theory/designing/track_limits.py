"""The limits of a design: closed length, speed through the water, area.

length   sum_j |w_{j+1} - w_j| once around, at most; longer polygons shrink about their middle
speed    |v_x| of Eq. (7), at most, at all times of the run
area     a box that waypoints and vehicle stay in, at all times of the run

In a measured current the area is the field's box.
"""

from typing import NamedTuple

import numpy as np

from ...currents.plane import read_field
from ...errors import ScenarioError
from ...scenario.experiment import Scenario
from .waypoint_tracks import Extremes

MARGIN = 1e-3  # of a limit, kept free between the times at which it is looked at
WIDER = 0.01  # than what the scenario's own track fills, where no area is given
Box = tuple[float, float, float, float]


class Limits(NamedTuple):
    """What a track must keep to."""

    length: float
    max_speed: float | None  # None: any
    low: np.ndarray  # (2,), corners of the area
    high: np.ndarray

    def tighter(self, part: float) -> "Limits":
        """Return limits for speed and path that leave a part of each free."""
        more = part * (self.high - self.low)
        speed = None if self.max_speed is None else (1 - part) * self.max_speed
        return Limits(self.length, speed, self.low + more, self.high - more)

    def excess(self, extremes: Extremes) -> np.ndarray:
        """Return how far tracks go beyond, as a share of the limit; 0 where they keep to it.

        A run that failed counts 1 and the share of the time that it missed.
        """
        found = np.maximum(-self.slack(extremes).min(axis=0), 0.0)
        return np.where(np.isfinite(found), found, 2.0 - extremes.share)

    def slack(self, extremes: Extremes) -> np.ndarray:
        """Return how far tracks stay within, piece by piece, shares of the limits, (k, m)."""
        size = self.high - self.low
        rows = [(extremes.low - self.low) / size, (self.high - extremes.high) / size]
        if self.max_speed is not None:
            rows.append(1 - extremes.speed[..., None] / self.max_speed)
        return np.concatenate([row.reshape(len(row), -1) for row in rows], axis=1).T


def closed_length(points: np.ndarray) -> np.ndarray:
    """Return the length of closed polygons, (..., n, 2) -> (...)."""
    return np.linalg.norm(np.roll(points, -1, axis=-2) - points, axis=-1).sum(axis=-1)


def shortened(points: np.ndarray, length: float) -> np.ndarray:
    """Return closed polygons; those longer than `length` are shrunk about their middle."""
    middle = points.mean(axis=-2, keepdims=True)
    share = np.minimum(1.0, length / np.maximum(closed_length(points), 1e-300))
    share = np.where(share < 1, share * (1 - 1e-13), 1.0)[..., None, None]
    return middle + share * (points - middle)


def corners(
    scenario: Scenario, area: Box | None, extremes: Extremes
) -> tuple[np.ndarray, np.ndarray]:
    """Return the corners of an area; by default the field's, or what the track fills and more."""
    points, field = scenario.waypoints, None
    if scenario.field_path is not None:
        grid = read_field(scenario.field_path, scenario.units)
        field = np.array([[axis[0], axis[-1]] for axis in (grid.x1, grid.x2)], dtype=float).T
    if area is not None:
        given = np.reshape(area, (2, 2)).T
        whole = np.array([[-np.inf] * 2, [np.inf] * 2]) if field is None else field
        rows = whole[0], given[0], scenario.vehicle.position, given[1], whole[1]
        if not (np.all(np.diff(rows, axis=0) >= 0) and np.all(given[0] < given[1])):
            within = "" if field is None else f", within the scenario's field, {field.T.tolist()}"
            raise ScenarioError(
                f"area = {area}: must be x1 from and to, x2 from and to, {scenario.units.length}, "
                f"each pair increasing, with vehicle.position in it{within}"
            )
        return given[0], given[1]
    if field is not None:
        return field[0], field[1]
    low = np.minimum(points.min(axis=0), extremes.low[0].min(axis=0))
    high = np.maximum(points.max(axis=0), extremes.high[0].max(axis=0))
    more = WIDER * np.maximum(high - low, 1e-9 + 1e-9 * np.abs(high))
    return low - more, high + more
