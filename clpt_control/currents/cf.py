"""Find velocities, coordinates and units in a NetCDF file.

Names follow the CF standard name table (cfconventions.org); a file without
standard names is read by the names that are common in practice.
"""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import DataError
from .gridded import numbers_of, speed_in_metres_per_second

if TYPE_CHECKING:
    import xarray

VELOCITY = {
    "eastward": (
        ("eastward_sea_water_velocity", "surface_eastward_sea_water_velocity"),
        ("u", "water_u", "uo", "u_velocity", "ucur", "u_current", "u_east", "usurf"),
    ),
    "northward": (
        ("northward_sea_water_velocity", "surface_northward_sea_water_velocity"),
        ("v", "water_v", "vo", "v_velocity", "vcur", "v_current", "v_north", "vsurf"),
    ),
}
AXES = {
    "latitude": (("latitude",), ("lat", "latitude", "nav_lat", "y_lat")),
    "longitude": (("longitude",), ("lon", "longitude", "nav_lon", "x_lon")),
    "time": (("time",), ("time", "t", "ocean_time", "mtime")),
}
DEPTHS = ("depth", "altitude", "height", "depth_below_sea_surface", "ocean_s_coordinate")
FASTEST = 15.0  # m/s; no current at sea is faster, a fill value taken as data is
DEPTH_NAMES = ("depth", "z", "lev", "level", "altitude", "s_rho", "deptht", "depthu", "sigma")


def find_variable(data: "xarray.Dataset", table: dict[str, Any], what: str, path: Path) -> str:
    """Return the name of the variable, by standard name and by name.

    Parameters
    ----------
    data : xarray.Dataset
        The file.
    table : dict
        `VELOCITY` or `AXES`.
    what : str
        Key of the table.
    path : Path
        The file's name, for messages.

    Returns
    -------
    str
        A variable with both, or with the standard name, or with the name.

    Raises
    ------
    DataError
        If there is none.
    """
    standard, names = table[what]
    by_standard = [n for n in data.variables if data[n].attrs.get("standard_name") in standard]
    by_name = sorted(
        (n for n in data.variables if str(n).lower() in names),
        key=lambda n: names.index(str(n).lower()),
    )
    for candidates in ([n for n in by_name if n in by_standard], by_standard, by_name):
        if candidates:
            return str(candidates[0])
    kind = f"{what} velocity" if table is VELOCITY else what
    raise DataError(
        f"{path}: no {kind}; a variable with standard_name '{standard[0]}' or one of the names "
        f"{', '.join(names)} is needed, the file has "
        f"{', '.join(map(str, data.variables)) or 'none'}"
    )


def find_axis(data: "xarray.Dataset", velocity: str, what: str, path: Path) -> "xarray.DataArray":
    """Return a coordinate of one dimension that the velocity has.

    Parameters
    ----------
    data : xarray.Dataset
        The file.
    velocity : str
        Name of a velocity.
    what : str
        Key of `AXES`.
    path : Path
        The file's name, for messages.

    Returns
    -------
    xarray.DataArray
        The coordinate.

    Raises
    ------
    DataError
        If there is none, or the grid is not one of latitudes and longitudes.
    """
    name = find_variable(data, AXES, what, path)
    axis = data[name]
    if axis.ndim != 1 or axis.dims[0] not in data[velocity].dims:
        raise DataError(
            f"{path}: {name} has the dimensions ({', '.join(map(str, axis.dims))}); must be one "
            f"of those of {velocity} ({', '.join(map(str, data[velocity].dims))})"
            + ("" if what == "time" else ": a grid of latitudes and longitudes")
        )
    if what == "time":
        return axis
    if not axis.size:
        raise DataError(f"{path}: {name} has the length zero; must hold at least one {what}")
    most = 90.0 if what == "latitude" else 720.0
    degrees = numbers_of(axis, f"{path}: {name}")
    degrees = degrees[np.isfinite(degrees)]
    if np.any(np.abs(degrees) > most + 1e-6):
        raise DataError(
            f"{path}: {name} goes from {degrees.min():.6g} to {degrees.max():.6g}; must be "
            f"a {what} in degrees"
        )
    return axis


def check_speed(values: np.ndarray, what: str, path: Path) -> None:
    """Refuse a speed that no sea has.

    Parameters
    ----------
    values : ndarray
        m/s, NaN in gaps; at least one is finite.
    what : str
        The velocity, for the message.
    path : Path
        The file's name, for the message.

    Raises
    ------
    DataError
        If one is faster than `FASTEST`.
    """
    most = np.nanmax(np.abs(values))
    if most > FASTEST:
        raise DataError(
            f"{path}: {what} reaches {most:.4g} m/s; at most {FASTEST} are allowed: check its "
            "units and fill value"
        )


def surface_values(
    data: "xarray.Dataset", name: str, kept: dict[Any, np.ndarray], path: Path
) -> np.ndarray:
    """Return a velocity in m/s at the level nearest the surface.

    Parameters
    ----------
    data : xarray.Dataset
        The file.
    name : str
        Name of the velocity.
    kept : dict of str to ndarray
        Names of time, latitude and longitude, and the indices to read.
    path : Path
        The file's name, for messages.

    Returns
    -------
    ndarray, shape (nt, ny, nx)
        m/s, NaN where missing.

    Raises
    ------
    DataError
        If units are missing or unknown, or a dimension is no depth.
    """
    values, dims = data[name], tuple(kept)
    if "units" not in values.attrs:
        raise DataError(f"{path}: {name} has no units; must be such as 'm/s' or 'cm s-1'")
    size = speed_in_metres_per_second(str(values.attrs["units"]), f"{path}: {name}")
    for dim in set(values.dims) - set(dims):
        level = 0
        if values.sizes[dim] != 1:
            depth = data[dim] if dim in data.variables else None
            standard = depth.attrs.get("standard_name", "") if depth is not None else ""
            if depth is None or (
                str(dim).lower() not in DEPTH_NAMES and not str(standard).startswith(DEPTHS)
            ):
                raise DataError(
                    f"{path}: {name} has the dimension {dim} of {values.sizes[dim]}; allowed are "
                    "time, latitude, longitude and a depth: choose one and write it alone"
                )
            level = int(np.argmin(np.nan_to_num(np.abs(depth.values.astype(float)), nan=np.inf)))
        values = values.isel({dim: level})
    if set(values.dims) != set(dims):
        raise DataError(
            f"{path}: {name} has the dimensions ({', '.join(map(str, values.dims))}); must have "
            f"({', '.join(map(str, dims))})"
        )
    chosen = values.isel(kept).transpose(*dims)
    numbers = numbers_of(chosen, f"{path}: {name}")
    check_packing(chosen, numbers, f"{path}: {name}")
    return numbers * size


def check_packing(packed: "xarray.DataArray", numbers: np.ndarray, where: str) -> None:
    """Refuse packed gaps that the fill value does not name.

    A gap is packed as an end of the integers.  Where such a number is left as
    data, twice or more and further from all others than these are apart, the
    fill value of the file is another than the one that it declares.

    Parameters
    ----------
    packed : xarray.DataArray
        As the file has it.
    numbers : ndarray
        Its values, NaN in gaps.
    where : str
        File and variable, for the message.

    Raises
    ------
    DataError
        If there are such numbers.
    """
    kind = np.dtype(packed.encoding.get("dtype", float))
    if kind.kind not in "iu":
        return
    scale = float(packed.encoding.get("scale_factor", 1.0))
    offset = float(packed.encoding.get("add_offset", 0.0))
    raw = (numbers[np.isfinite(numbers)] - offset) / scale
    limits = np.iinfo(kind)
    for end in (limits.min, limits.min + 1, limits.max):
        at_end = np.abs(raw - end) <= 0.5
        rest = raw[~at_end]
        if at_end.sum() > 1 and rest.size and np.abs(rest - end).min() > np.ptp(rest):
            raise DataError(
                f"{where} holds {end} of {kind} {at_end.sum()} times, which marks a gap, but "
                f"declares the fill value {packed.encoding.get('_FillValue')}; correct _FillValue"
            )
