"""Find velocities, coordinates and levels in a NetCDF file.

Names follow the CF standard name table (cfconventions.org); a file without
standard names is read by the names that are common in practice.

Times are those of `cf_times`, numbers those of `valid_values`.
"""

from typing import Any

import numpy as np
import xarray

from ...base.errors import DataError
from ...base.units import length_in_metres
from .flags import said, without_flagged
from .valid_values import in_valid_range, numbers_of, speed_unit

VELOCITY = {  # quantity: its standard names, and the names in use
    "eastward": (
        ("eastward_sea_water_velocity", "surface_eastward_sea_water_velocity"),
        # of ROMS u_eastward, beside u along the axes of its grid; ua of FVCOM
        (
            "u_eastward",
            "u",
            "water_u",
            "uo",
            "u_velocity",
            "ucur",
            "u_current",
            "u_east",
            "usurf",
            "ua",
        ),
    ),
    "northward": (
        ("northward_sea_water_velocity", "surface_northward_sea_water_velocity"),
        (
            "v_northward",
            "v",
            "water_v",
            "vo",
            "v_velocity",
            "vcur",
            "v_current",
            "v_north",
            "vsurf",
            "va",
        ),
    ),
}
AXES = {
    "latitude": (
        ("latitude",),
        ("lat", "latitude", "nav_lat", "y_lat", "lat_rho", "lat_u", "latc"),
    ),
    "longitude": (
        ("longitude",),
        ("lon", "longitude", "nav_lon", "x_lon", "lon_rho", "lon_u", "lonc"),
    ),
    "time": (("time",), ("time", "t", "ocean_time", "mtime")),
}
AXIS_NAMES = {name for _, names in AXES.values() for name in names}
HEIGHTS = ("altitude", "height")
DEPTHS = (*HEIGHTS, "depth", "ocean_s_coordinate")
DEPTH_NAMES = (
    "depth",
    "z",
    "lev",
    "level",
    "altitude",
    "s_rho",
    "deptht",
    "depthu",
    "sigma",
    "siglay",
)
CURE = (
    "regrid it to latitudes and longitudes, by cdo remapbil or xESMF, and turn u and v to east and "
    "north first: on such a grid they may lie along its own axes"
)
PROJECTED = ("projection_x_coordinate", "projection_y_coordinate")


def find_variable(data: xarray.Dataset, table: dict[str, Any], quantity: str) -> str:
    """Return the name of a variable of `VELOCITY` or `AXES`, by standard name and by name.

    One with both comes first, then one with the standard name, then one with the name; a wind is
    no current, whatever its name.
    """
    standard, names = table[quantity]
    named = {
        name: said(variable, "standard_name")
        for name, variable in data.variables.items()
    }
    by_standard = [name for name, variable in named.items() if variable in standard]
    by_name = [
        n
        for n, variable in named.items()
        if str(n).lower() in names and "wind" not in variable
    ]
    by_name.sort(key=lambda name: names.index(str(name).lower()))
    if candidates := [
        *(n for n in by_name if n in by_standard),
        *by_standard,
        *by_name,
    ]:
        return str(candidates[0])
    if table is AXES and any(variable in PROJECTED for variable in named.values()):
        raise DataError(f"has a projected grid, of x and y, and no {quantity}; {CURE}")
    kind = f"{quantity} velocity" if table is VELOCITY else quantity
    criteria = f"no standard_name '{standard[0]}' and none of {', '.join(names)}"
    remedy = ". Give --u and --v, or names=" if table is VELOCITY else ""
    raise DataError(
        f"no {kind}: {criteria} among {', '.join(map(str, data.variables))}{remedy}"
    )


def checked_name(data: xarray.Dataset, name: str, quantity: str) -> str:
    """Return the name of a variable that the user chose; refuse an unknown or another one."""
    if name not in data.data_vars:
        raise DataError(
            f"no variable {name}; must be one of {', '.join(map(str, data.data_vars))}"
        )
    told = said(data[name], "standard_name")
    if any(told in row[0] for other, row in VELOCITY.items() if other != quantity):
        raise DataError(
            f"{name} as the {quantity} velocity: its standard_name is {told}"
        )
    return name


def find_axis(data: xarray.Dataset, velocity: str, quantity: str) -> xarray.DataArray:
    """Return the coordinate, of one dimension that a velocity has, for a key of `AXES`.

    Of several times, such as `time` and `time1`, the one on a dimension of the velocity counts.
    """
    flow = data[velocity]
    if "mesh" in flow.attrs or "nele" in flow.dims:  # UGRID, FVCOM
        raise DataError(f"{velocity} {_dims(flow)} is on a triangular grid; {CURE}")
    name = find_variable(data, AXES, quantity)
    if quantity == "time" and not set(data[name].dims) & set(flow.dims):
        times = [
            dim for dim in flow.dims if dim in data and " since " in said(data[dim])
        ]
        name = str(times[0]) if times else name
    axis = data[name]
    if quantity == "time" and axis.ndim == 0:
        return axis.expand_dims(name)
    if quantity != "time" and axis.ndim == 2:
        raise DataError(
            f"{name} has the dimensions {_dims(axis)}: a curvilinear grid; {CURE}"
        )
    if axis.ndim != 1 or axis.dims[0] not in flow.dims:
        raise DataError(f"{name} is on {_dims(axis)}; must be on one of {_dims(flow)}")
    if quantity == "time":
        return axis
    if not axis.size:
        raise DataError(
            f"{name} has the length zero; must have at least one {quantity}"
        )
    most = 90.0 if quantity == "latitude" else 720.0
    degrees = numbers_of(axis)
    if not np.all(np.abs(degrees) <= most + 1e-6):  # also where not finite
        raise DataError(
            f"{name} reaches {np.abs(degrees).max():.6g}; must be a {quantity}, degrees"
        )
    return axis


def _dims(values: xarray.DataArray) -> str:
    return f"({', '.join(map(str, values.dims))})"


def is_depth(data: xarray.Dataset, dim: Any) -> bool:
    """Return whether a dimension has a coordinate that is a depth by its names."""
    if dim not in data.variables:
        return False
    by_standard = said(data[dim], "standard_name").startswith(DEPTHS)
    return str(dim).lower() in DEPTH_NAMES or by_standard


def depths_of(data: xarray.Dataset, dim: Any, in_metres: bool = True) -> np.ndarray:
    """Return depths of levels below the surface, m or in their unit.

    Heights above the sea floor are refused.
    """
    axis = data[dim]
    levels, unit = np.atleast_1d(numbers_of(axis)), said(axis)
    up = said(axis, "positive") == "up" or said(axis, "standard_name").startswith(
        HEIGHTS
    )
    if up and np.any(levels > 0):
        raise DataError(
            f"{axis.name} counts up from the sea floor; must be depths below water"
        )
    levels = np.abs(levels)
    if in_metres and (unit or not str(dim).lower().startswith(("depth", "z"))):
        return levels * length_in_metres(unit, str(dim))
    return levels


def _level(data: xarray.Dataset, dim: Any) -> tuple[int, str]:
    """Return the index of the level nearest the surface, and a note on it."""
    depths = depths_of(data, dim, in_metres=False)
    # a level above water, or without a depth, is the last choice
    level = int(np.argmin(np.where(depths >= 0, depths, np.inf)))
    unit = said(data[dim]).replace("1", "")
    return level, (
        f"{dim} has {depths.size} levels: the level nearest the surface is read, "
        f"{depths[level]:.4g} {unit}".rstrip()
        + ". --depth (depth=) chooses by depth"
    )


def velocity_values(
    data: xarray.Dataset,
    name: str,
    index: dict[Any, np.ndarray],
    units: str | None,
    notes: list[str],
) -> np.ndarray:
    """Return a velocity in m/s, NaN where missing or flagged bad, at the `index` of each dimension.

    Of levels that are not among them, the one nearest the surface is read.
    `units` are those of a variable that says none.  The level and the flags add to the notes.
    """
    values, levels = data[name], dict[Any, int]()
    cure = "Give units (--units), such as m/s, or write the attribute"
    size = speed_unit(said(values), units, name, cure)
    for dim in set(values.dims) - set(index):
        levels[dim] = 0
        if values.sizes[dim] != 1:
            if not is_depth(data, dim):
                raise DataError(
                    f"{name} has {values.sizes[dim]} {dim}; must be on time, latitude, longitude "
                    "and depth. Select one with xarray's isel"
                )
            levels[dim], note = _level(data, dim)
            notes.append(note)
    added = [dim for dim in index if dim not in values.dims]
    if any(dim not in data or data[dim].ndim for dim in added):
        raise DataError(
            f"{name} is on {_dims(values)}; must be on {', '.join(map(str, index))}"
        )

    def select(variable: xarray.DataArray) -> xarray.DataArray:
        variable = variable.isel(levels, missing_dims="ignore")
        return _in_one_block(
            variable, {d: index[d] for d in index if d in variable.dims}
        )

    try:
        chosen, flagged = without_flagged(
            data, [name, *_coordinates(data, name)], select
        )
    except (ValueError, TypeError):  # of letters that are to be scaled
        raise DataError(
            f"{name} has an entry that is not a number. Give numbers only"
        ) from None
    notes += flagged
    chosen = chosen.expand_dims(added).transpose(*index)
    numbers = numbers_of(chosen)
    return in_valid_range(chosen, numbers, name) * size


def _coordinates(data: xarray.Dataset, name: str) -> list[str]:
    """Return the times, places and depths along dimensions of a velocity."""
    return [
        axis
        for axis in map(str, data.variables)
        if data[axis].ndim > 0
        and set(data[axis].dims) <= set(data[name].dims)
        and (axis.lower() in AXIS_NAMES or is_depth(data, axis))
    ]


def _in_one_block(
    values: xarray.DataArray, index: dict[Any, np.ndarray]
) -> xarray.DataArray:
    """Return values at the `index` of each dimension, read as the block that holds them.

    A library reads places one by one, and unpacks the whole part of a file for each of them.
    """
    block = values.isel(
        {
            dim: slice(positions.min(), positions.max() + 1)
            for dim, positions in index.items()
        }
    )
    return block.load().isel(
        {dim: positions - positions.min() for dim, positions in index.items()}
    )
