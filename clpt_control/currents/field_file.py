"""A current on a regular grid of a local plane: the file beside a scenario.

NetCDF with dims time, y, x (uniform, increasing), variables `u` and `v`, and
CF units; `read_field` turns it to the scenario's units of length and time.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..errors import DataError
from ..files import open_netcdf
from ..units import METRES, SECONDS, length_in_metres, speed_in_metres_per_second, time_in_seconds
from .cf import numbers_of

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True)
class GriddedField:
    """A current on a regular grid, without gaps; axes are even and have two points at least."""

    time: np.ndarray
    x2: np.ndarray  # length
    x1: np.ndarray
    u: np.ndarray  # flow along x1, length per time, shape (nt, n2, n1)
    v: np.ndarray  # flow along x2


def read_field(path: Path, units) -> GriddedField:
    """Return the field of a file, such as `clpt fit` writes, in the units of a scenario."""
    with open_netcdf(path) as data:
        for name in ("time", "y", "x", "u", "v"):
            if name not in data.variables:
                raise DataError(f"{path}: no variable '{name}'; a field has time, y, x, u and v")
        axes = []
        for name in ("time", "y", "x"):
            where, unit = f"{path}: {name}", str(data[name].attrs.get("units", ""))
            if name == "time":
                size = time_in_seconds(unit, where) / SECONDS[units.time]
            else:
                size = length_in_metres(unit, where) / METRES[units.length]
            axes.append(_regular(numbers_of(data[name], where) * size, name, path))
        own = METRES[units.length] / SECONDS[units.time]
        values = []
        for name in ("u", "v"):
            if data[name].dims != ("time", "y", "x"):
                raise DataError(f"{path}: {name} must have the dimensions time, y, x")
            size = speed_in_metres_per_second(
                str(data[name].attrs.get("units", "")), f"{path}: {name}"
            )
            values.append(numbers_of(data[name], f"{path}: {name}") * (size / own))
            if not np.all(np.isfinite(values[-1])):
                raise DataError(f"{path}: {name} has gaps; `clpt fit` fills them")
    return GriddedField(*axes, *values)


def time_origin(path: Path) -> dict[str, str]:
    """Return the date of a field's t = 0, ``{"time_origin": "2019-01-01T00:00:00"}``, or none."""
    with open_netcdf(path) as data:
        origin = data.attrs.get("time_origin")
    return {} if origin is None else {"time_origin": str(origin)}


def _regular(axis: np.ndarray, name: str, path: Path) -> np.ndarray:
    step = np.diff(axis)
    if axis.ndim != 1 or len(axis) < 2 or not np.all(step > 0):
        raise DataError(f"{path}: {name} must increase and have at least two points")
    if np.ptp(step) > 1e-6 * step.mean():
        raise DataError(f"{path}: {name} must be evenly spaced; `clpt fit` writes such a field")
    return axis.astype(float)


def field_dataset(field: GriddedField, units, attributes: dict) -> "xarray.Dataset":
    """Return a field in a scenario's units as CF data; attributes are title and source."""
    import xarray

    speed = f"{units.length} {units.time}-1"
    dims = ("time", "y", "x")
    return xarray.Dataset(
        {
            "u": (dims, field.u, {"long_name": "flow along x1 (east)", "units": speed}),
            "v": (dims, field.v, {"long_name": "flow along x2 (north)", "units": speed}),
        },
        {
            "time": ("time", field.time, {"long_name": "time since start", "units": units.time}),
            "y": (
                "y",
                field.x2,
                {"standard_name": "projection_y_coordinate", "units": units.length},
            ),
            "x": (
                "x",
                field.x1,
                {"standard_name": "projection_x_coordinate", "units": units.length},
            ),
        },
        {"Conventions": "CF-1.11", **attributes},
    )
