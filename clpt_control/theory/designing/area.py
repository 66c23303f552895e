"""Areas of a scenario in a measured current: its field's box, and a box in degrees."""

import numpy as np

from ...currents.field_file import read_field
from ...currents.plane import LocalPlane
from ...errors import ScenarioError
from ...files import open_netcdf
from ...scenario.experiment import Scenario
from ...units import METRES
from .limits import Box

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
