"""The limits of a design: closed length, speed through the water, area.

length   sum_j |w_{j+1} - w_j| once around, at most; longer polygons shrink about their middle
speed    |v_x| of Eq. (7), at most, at all times of the run
area     a box that waypoints and vehicle stay in, at all times of the run

In a measured current the area is the field's box, or one given in degrees.
"""

from typing import NamedTuple

import numpy as np

from ...currents.plane import LocalPlane, read_field
from ...errors import ScenarioError
from ...files.reading import open_netcdf
from ...scenario.experiment import Scenario
from ...units import METRES
from .waypoint_tracks import Extremes

MARGIN = 1e-3  # of a limit, kept free between the times at which it is looked at
MOST_WAYPOINTS = 200
WIDER = 0.01  # than what the scenario's own track fills, where no area is given
Box = tuple[float, float, float, float]


class Limits(NamedTuple):
    """What a track must keep to."""

    length: float
    max_speed: float | None  # None: any
    area: Box  # x1 from and to, x2 from and to

    def tighter(self, part: float) -> "Limits":
        """Return limits for speed and path that leave a part of each free."""
        x1, x2 = (part * (self.area[k + 1] - self.area[k]) for k in (0, 2))
        low1, high1, low2, high2 = self.area
        speed = None if self.max_speed is None else (1 - part) * self.max_speed
        return Limits(self.length, speed, (low1 + x1, high1 - x1, low2 + x2, high2 - x2))

    def excess(self, extremes: Extremes) -> np.ndarray:
        """Return how far tracks go beyond, as a share of the limit; 0 where they keep to it.

        A run that failed counts 1 and the share of the time that it missed.
        """
        found = np.maximum(-self.slack(extremes).min(axis=0), 0.0)
        return np.where(np.isfinite(found), found, 2.0 - extremes.share)

    def slack(self, extremes: Extremes) -> np.ndarray:
        """Return how far tracks stay within, piece by piece, shares of the limits, (k, m)."""
        low, high = np.array(self.area[::2]), np.array(self.area[1::2])
        rows = [(extremes.low - low) / (high - low), (high - extremes.high) / (high - low)]
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


def around(points: np.ndarray, count: int) -> np.ndarray:
    """Return `count` points evenly along a closed polygon; its own where it has as many."""
    if len(points) == count:
        return points
    closed = np.vstack([points, points[:1]])
    along = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(closed, axis=0), axis=1)))
    wanted = along[-1] * np.arange(count) / count
    return np.column_stack([np.interp(wanted, along, closed[:, i]) for i in range(2)])


def filled_area(points: np.ndarray, extremes: Extremes) -> Box:
    """Return the box that a track fills, waypoints and path, and a little more."""
    low = np.minimum(points.min(axis=0), extremes.low[0].min(axis=0))
    high = np.maximum(points.max(axis=0), extremes.high[0].max(axis=0))
    more = WIDER * np.maximum(high - low, 1e-9 + 1e-9 * np.abs(high))
    (low1, low2), (high1, high2) = (low - more).tolist(), (high + more).tolist()
    return low1, high1, low2, high2


def check_numbers(scenario: Scenario, count: int | None, **numbers: float | None) -> None:
    """Refuse numbers that no track can have."""
    unit, time = scenario.units.length, scenario.units.time
    units = {"length": unit, "dwell": time}
    for name, value in numbers.items():
        if value is not None and not 0 < value < np.inf:
            own_unit = units.get(name, f"{unit}/{time}")
            raise ScenarioError(f"{name} = {value:g}: must be a positive number of {own_unit}")
    if count is not None and not 2 <= count <= MOST_WAYPOINTS:
        raise ScenarioError(f"count = {count}: must be a whole number, 2 to {MOST_WAYPOINTS}")
    if count is None and (n := len(scenario.waypoints)) > MOST_WAYPOINTS:
        raise ScenarioError(f"reference: has {n} waypoints; give count, 2 to {MOST_WAYPOINTS}")


def check_area(scenario: Scenario, area: Box, field: Box | None) -> None:
    """Refuse an area that is empty, leaves the field, or does not hold the vehicle's start."""
    unit = scenario.units.length
    low1, high1, low2, high2 = area
    text = _in_words(area, unit)
    if not (np.isfinite(area).all() and low1 < high1 and low2 < high2):
        raise ScenarioError(
            f"area = {text}: must be four numbers, x1 from and to, x2 from and to, each pair "
            "increasing"
        )
    if field is not None and not (
        field[0] <= low1 and high1 <= field[1] and field[2] <= low2 and high2 <= field[3]
    ):
        raise ScenarioError(
            f"area = {text}: reaches out of the scenario's field, "
            f"{_in_words(field, unit)}; must lie "
            "within it"
        )
    x1, x2 = scenario.vehicle.position
    if not (low1 <= x1 <= high1 and low2 <= x2 <= high2):
        raise ScenarioError(
            f"area = {text}: the vehicle starts outside of it, at ({x1:g}, {x2:g}); the area must "
            "hold vehicle.position"
        )


def _in_words(area: Box, unit: str) -> str:
    return f"x1 {area[0]:g} to {area[1]:g}, x2 {area[2]:g} to {area[3]:g} {unit}"


ORIGIN = "origin_latitude_longitude"  # attribute of a field's file
EDGE = 50  # places along an edge of a box in degrees


def field_area(scenario: Scenario) -> Box | None:
    """Return the box of the scenario's field, x1 and x2, units.length; None without a field."""
    if scenario.field_path is None:
        return None
    field = read_field(scenario.field_path, scenario.units)
    return tuple(float(axis[k]) for axis in (field.x1, field.x2) for k in (0, -1))  # type: ignore[return-value]


def area_of_degrees(scenario: Scenario, box: tuple[float, float, float, float]) -> Box:
    """Return the largest box of the plane within LAT0 LAT1 LON0 LON1, units.length."""
    south, north, west, east = box
    if not (np.isfinite(box).all() and south < north and west < east):
        raise ScenarioError(
            f"box = {south:g} {north:g} {west:g} {east:g}: must be LAT0 LAT1 LON0 LON1 in degrees, "
            "each pair increasing"
        )
    if scenario.field_path is None:
        raise ScenarioError(
            "box: is in degrees, and the scenario has no field that says where it lies; give area "
            f"in {scenario.units.length}"
        )
    with open_netcdf(scenario.field_path) as data:
        origin = data.attrs.get(ORIGIN)
    if origin is None or np.size(origin) != 2:
        raise ScenarioError(
            f"box: {scenario.field_path} does not say where its plane lies ({ORIGIN}); give area "
            f"in {scenario.units.length}"
        )
    plane = LocalPlane(*map(float, origin))
    size = 1000.0 / METRES[scenario.units.length]
    lats, lons = np.linspace(south, north, EDGE), np.linspace(west, east, EDGE)
    x1 = [size * plane.to_plane(lats, lon)[0] for lon in (west, east)]
    x2 = [size * plane.to_plane(lat, lons)[1] for lat in (south, north)]
    return float(x1[0].max()), float(x1[1].min()), float(x2[0].max()), float(x2[1].min())
