"""Read a current through the water column: levels of depth, absolute times.

`read_currents` gives the level nearest the surface, which is what a drifter
needs; a glider samples the column.  Names, units and gaps are read by the same
rules (`cf`): one surface level is a column of one.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import DataError
from ..files import open_netcdf
from .cf import DEPTH_NAMES, DEPTHS, VELOCITY, check_speed, find_axis, find_variable, surface_values
from .cf_time import check_calendar, hours_since_first
from .gridded import length_in_metres

if TYPE_CHECKING:
    import xarray

DEEPEST = 1000.0  # m; no level further down is read, except the next
MOST = 10**8  # values of one component: 0.8 GB


@dataclass(frozen=True)
class Column:
    """A current on times, depths, latitudes and longitudes.

    Attributes
    ----------
    time : ndarray, shape (nt,)
        Increasing, s since 1970 UTC.
    depth : ndarray, shape (nz,)
        Increasing from the surface, m; ``[0.0]`` where the file has none.
    lat, lon : ndarray, shapes (ny,) and (nx,)
        Degrees, increasing; longitudes may pass 180.
    u, v : ndarray, shape (nt, nz, ny, nx)
        Flow to the east and to the north, m/s; NaN in both where missing.
    source : str
        Name of the file.
    """

    time: np.ndarray
    depth: np.ndarray
    lat: np.ndarray
    lon: np.ndarray
    u: np.ndarray
    v: np.ndarray
    source: str


def read_column(path: str | Path) -> Column:
    """Read a gridded current with all its levels down to 1000 m.

    Parameters
    ----------
    path : str or Path
        A NetCDF file with dims time, latitude, longitude and perhaps a depth,
        in any order.

    Returns
    -------
    Column
        In m/s, m and s since 1970, gaps as NaN.

    Raises
    ------
    DataError
        If the file, a variable, a unit or data are missing, or it is too large
        to be held; one sentence.
    """
    path = Path(path)
    with open_netcdf(path) as data:
        if "fit_report" in data.attrs:
            raise DataError(f"{path}: is the field of a `clpt fit`; give the .toml file beside it")
        names = [find_variable(data, VELOCITY, what, path) for what in ("eastward", "northward")]
        lat, lon, when = (
            find_axis(data, names[0], what, path) for what in ("latitude", "longitude", "time")
        )
        axes = {axis.dims[0]: axis for axis in (when, lat, lon)}
        time = _seconds(when, path)
        level, depth = _levels(data, names[0], set(axes), path)
        degrees, columns = _longitudes(lon, path)
        latitudes = lat.values.astype(float)
        kept: dict[Any, np.ndarray] = {
            when.dims[0]: np.argsort(time),
            lat.dims[0]: np.argsort(latitudes),
            lon.dims[0]: columns,
        }
        steps, rows, _ = kept.values()
        for name, values in (
            (when.name, time[steps]),
            (lat.name, latitudes[rows]),
            (lon.name, degrees),
        ):
            if len(values) < 2 or not np.all(np.diff(values) > 0):  # also where not finite
                raise DataError(
                    f"{path}: {name} has {_counted(len(values), 'value')}; a forecast needs at "
                    "least 2, finite and each once"
                )
        order = np.argsort(depth)
        order = order[: int(np.searchsorted(depth[order], DEEPEST)) + 1]
        size = len(order) * np.prod([len(index) for index in kept.values()], dtype=float)
        if size > MOST:
            raise DataError(
                f"{path}: {names[0]} has {size:.3g} values; at most {MOST:.0g} can be held, cut "
                "the file to the glider's area and days"
            )
        u, v = (_stack(data, name, level, order, kept, path) for name in names)
    gap = ~(np.isfinite(u) & np.isfinite(v))
    if gap.all():
        raise DataError(f"{path}: {names[0]} and {names[1]} have no finite value")
    u[gap] = v[gap] = np.nan
    for name, component in zip(names, (u, v), strict=True):
        check_speed(component, name, path)
    return Column(time[steps], depth[order], latitudes[rows], degrees, u, v, path.name)


def _seconds(when: "xarray.DataArray", path: Path) -> np.ndarray:
    """Return times in s since 1970 UTC."""
    from datetime import UTC, datetime

    check_calendar(when, path)
    if len(when) < 2:
        raise DataError(
            f"{path}: {when.name} has {_counted(len(when), 'step')}; a forecast needs at least 2"
        )
    hours, start = hours_since_first(when, path)
    try:
        first = datetime.fromisoformat(start).replace(tzinfo=UTC).timestamp()
    except ValueError:
        raise DataError(
            f"{path}: {when.name} begins at {start}; must be a date of a dive, such as "
            "2019-01-01T00:00:00"
        ) from None
    return first + 3600.0 * hours


def _counted(count: int, what: str) -> str:
    return f"{count} {what}{'' if count == 1 else 's'}"


def _levels(
    data: "xarray.Dataset", name: str, axes: set, path: Path
) -> tuple[Any | None, np.ndarray]:
    """Return the dimension of depth, if any, and its levels, m."""
    others = [d for d in data[name].dims if d not in axes]
    dims = [d for d in others if data[name].sizes[d] != 1]
    if not dims:
        single = [d for d in others if str(d).lower() in DEPTH_NAMES and d in data.variables]
        alone = np.abs(data[single[0]].values.astype(float)) if single else np.zeros(1)
        return None, np.nan_to_num(alone)
    coordinate = data[dims[0]] if dims[0] in data.variables else None
    known = coordinate is not None and (
        str(dims[0]).lower() in DEPTH_NAMES
        or str(coordinate.attrs.get("standard_name", "")).startswith(DEPTHS)
    )
    if len(dims) > 1 or coordinate is None or not known:
        raise DataError(
            f"{path}: {name} has the dimensions ({', '.join(map(str, data[name].dims))}); allowed "
            "are time, latitude, longitude and a depth"
        )
    depth = np.abs(coordinate.values.astype(float))
    unit = str(coordinate.attrs.get("units", "")).strip()
    if unit or not str(dims[0]).lower().startswith(("depth", "z")):  # else taken as m
        depth *= length_in_metres(unit, f"{path}: {dims[0]}")
    if not np.all(np.diff(np.sort(depth)) > 0):
        raise DataError(
            f"{path}: {dims[0]} has {_counted(len(depth), 'level')}; must be finite depths, each "
            "once"
        )
    return dims[0], depth


def _longitudes(lon: "xarray.DataArray", path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Unwrap longitudes: cut where the circle's largest gap is.

    A forecast all around the Earth gets its first column again at its end.
    """
    values = lon.values.astype(float)
    if not np.all(np.isfinite(values)) or len(values) < 2:
        raise DataError(f"{path}: {lon.name} must have at least 2 values, all finite")
    circle = values % 360.0
    order = np.argsort(circle)
    gaps = np.diff(circle[order], append=circle[order[0]] + 360.0)
    order = np.roll(order, -(int(np.argmax(gaps)) + 1))
    degrees = values[order[0]] + (circle[order] - circle[order[0]]) % 360.0
    if np.max(gaps) < 1.5 * np.median(gaps):
        degrees, order = np.append(degrees, degrees[0] + 360.0), np.append(order, order[0])
    return degrees, order


def _stack(
    data: "xarray.Dataset", name: str, level: Any, order: np.ndarray, kept: dict, path: Path
) -> np.ndarray:
    """Return a velocity, m/s, shape (nt, nz, ny, nx), level by level."""
    if level is None:
        return surface_values(data, name, kept, path)[:, None]
    if level not in data[name].dims:
        raise DataError(f"{path}: {name} has no {level}; both velocities must have the same levels")
    layers = [surface_values(data.isel({level: [k]}), name, kept, path) for k in order]
    return np.stack(layers, axis=1)
