"""Read a current record at one place: NetCDF, or a table (`text_table`).

NetCDF: a time and two velocities, found by CF standard name or as u and v, of
the one dimension time; dimensions of one value and a depth beside it are
allowed (the level nearest the surface, or a given depth, is taken).  From a grid of latitudes and
longitudes the cell nearest to a given place is taken.  The latitude, which the
nodal corrections need, is the file's variable, its attribute
`geospatial_lat_min` (equal to `geospatial_lat_max`), `latitude` or `lat`, or
given.  Gaps are kept as NaN.

A profiler's NetCDF, as dolfyn writes it, has `vel` on dir, range and time.  `dir` names the
components, E, N and up where `coord_sys` is earth; they lie from true north once a
`declination` is set.  The current is the mean over the ranges that hold a number at half of
the times or more; so it is of a table that has a line for each range, as many at each time.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import xarray

from ...base.arguments import public
from ...base.errors import DataError, naming
from ...base.files.reading import open_netcdf, shown_name
from ...base.geodesy import angle_near
from ...base.units import number
from . import cf
from .cf_times import dates_of
from .constituents import check_increasing, checked_latitude
from .flags import said
from .text_table import is_table, read_table
from .valid_values import mark_gaps

SHARE = 0.5  # of times at which a range must hold a number


@dataclass(frozen=True)
class CurrentRecord:
    """A current at one place over time."""

    time: np.ndarray  # datetime64[ms], UTC, increasing, shape (n,)
    u: np.ndarray  # to the east, m/s; NaN in both where not measured
    v: np.ndarray  # to the north
    latitude: float  # degrees north
    source: str  # name of the file
    notes: tuple[str, ...] = ()  # on the level, flags and times

    def __repr__(self) -> str:
        span = f"{self.time[0].astype('M8[m]')} to {self.time[-1].astype('M8[m]')} UTC"
        return f"<CurrentRecord of {self.source}: {len(self.time)} times, {span}>"


@public
def read_record(
    path: str | Path,
    latitude: float | None = None,
    at: tuple[float, float] | None = None,
    units: str | None = None,
    depth: float | None = None,
) -> CurrentRecord:
    r"""Read a current record at one place.

    Parameters
    ----------
    path : str or Path
        NetCDF, or a table with the columns time, u and v.
    latitude : float, optional
        Degrees north; the file's own by default.
    at : tuple of float, optional
        Latitude and longitude, degrees: the nearest cell of a grid is read.
    units : str, optional
        Of u and v, such as ``m/s``, where the file has none.
    depth : float, optional
        m: the level nearest to it is read; by default the one nearest the surface.

    Returns
    -------
    CurrentRecord
        `time` (datetime64, UTC), `u` and `v` (m/s, NaN in gaps), `latitude`, `source` and
        `notes` on level, flags and times.

    Raises
    ------
    DataError
        If the file cannot be read or used; one sentence says why.

    Examples
    --------
    >>> import tempfile
    >>> text = "# latitude: 41.2\n time, u (cm/s), v (cm/s)\n 2019-01-01, 12, -5\n 2019-01-02,,"
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     _ = Path(folder, "mooring.csv").write_text(text)
    ...     record = read_record(Path(folder, "mooring.csv"))
    >>> record.latitude, record.u
    (41.2, array([0.12,  nan]))
    """
    path, notes = Path(path), list[str]()
    if is_table(path):
        if at is not None:
            raise DataError(
                f"{path}: is a table of one place; --at is for gridded NetCDF files"
            )
        times, u, v, file_latitude = read_table(path, units, notes)
        lines = int(np.argmax(times != times[0]))  # of one ping
        if lines > 1 and len(times) % lines == 0:
            pings = times.reshape(-1, lines)
            if (pings == pings[:, :1]).all():
                times = pings[:, 0]
                u, v = (_over_ranges(w.reshape(pings.shape)) for w in (u, v))
    else:
        with open_netcdf(path) as data, naming(path):
            times, u, v, file_latitude = _from_netcdf(
                of_profiler(data), at, units, depth, notes
            )
    check_increasing(times, str(path))
    with naming(path):
        nothing = "no time has a finite value of both components of the current"
        nothing = "; ".join(dict.fromkeys((nothing, *notes)))
        mark_gaps(u, v, ("the eastward current", "the northward current"), nothing)
        chosen = file_latitude if latitude is None else latitude
        if chosen is None:
            raise DataError("has no latitude. Give --latitude DEG")
        checked_latitude(chosen)
    notes = [*dict.fromkeys(notes)]
    return CurrentRecord(times, u, v, float(chosen), shown_name(path), tuple(notes))


def _from_netcdf(
    data: xarray.Dataset,
    at: tuple[float, float] | None,
    units: str | None,
    depth: float | None,
    notes: list[str],
) -> tuple:
    """Return times, u, v and latitude."""
    east, north = (
        cf.find_variable(data, cf.VELOCITY, quantity)
        for quantity in ("eastward", "northward")
    )
    when = cf.find_axis(data, east, "time")
    times = dates_of(data, when, east, notes)
    index: dict[Any, np.ndarray] = {when.dims[0]: np.arange(len(times))}
    latitude = _own_latitude(data)
    of_cell = (
        () if at is None else zip(("longitude", "latitude"), at[::-1], strict=True)
    )
    for quantity, degrees in of_cell:
        axis = cf.find_axis(data, east, quantity)
        k = _nearest(axis.values.astype(float), degrees, quantity)
        index[axis.dims[0]] = np.array([k])
        latitude = float(axis.values[k])
    u, v = (
        cf.velocity_values(data, name, index, units, notes, depth).ravel()
        for name in (east, north)
    )
    return times, u, v, latitude


def _nearest(axis: np.ndarray, degrees: float, quantity: str) -> int:
    """Return the cell nearest to a place that lies in the grid."""
    distance = (
        angle_near(axis - degrees, 0.0) if quantity == "longitude" else axis - degrees
    )
    k = int(np.argmin(np.abs(distance)))
    cell = np.abs(np.diff(np.sort(axis))).max() if len(axis) > 1 else 1.0
    if not abs(distance[k]) <= cell:  # also where not finite
        raise DataError(
            f"{quantity} {degrees:g} is outside: {axis.min():.6g} to {axis.max():.6g}"
        )
    return k


def _own_latitude(data: xarray.Dataset) -> float | None:
    """Return the latitude of a file of one place, None where it is silent."""
    axis_names = cf.AXES["latitude"][1]
    scalars = {
        str(name).lower(): variable
        for name, variable in data.variables.items()
        if variable.size == 1
    }
    of_axes = [
        variable.values.ravel()[0]
        for name, variable in scalars.items()
        if name in axis_names or said(variable, "standard_name") == "latitude"
    ]
    low, high = (
        number(data.attrs.get(f"geospatial_lat_{end}")) for end in ("min", "max")
    )
    values = (
        *of_axes,
        low if low == high else None,
        *map(data.attrs.get, ("latitude", "lat")),
    )
    return next(filter(np.isfinite, map(number, values)), None)


def _over_ranges(values: np.ndarray) -> np.ndarray:
    """Return the mean over those ranges, (times, ranges), that hold a number often enough."""
    often = values[:, np.isfinite(values).mean(axis=0) >= SHARE]
    finite = np.isfinite(often)
    with np.errstate(invalid="ignore"):
        return np.where(finite, often, 0.0).sum(axis=1) / finite.sum(axis=1)


def of_profiler(data: xarray.Dataset) -> xarray.Dataset:
    """Return u and v of a profiler's file; another file as it is."""
    if (
        "vel" not in data.variables
        or "dir" not in data.variables
        or "dir" not in data["vel"].dims
    ):
        return data
    system = str(data.attrs.get("coord_sys", "unknown"))
    names = [str(name) for name in data["dir"].values]
    if system != "earth" or not {"E", "N"} <= set(names):
        raise DataError(
            f"vel has {', '.join(names)} of '{system}'; Rotate it with dolfyn.rotate2 to earth"
        )
    if "declination" not in data.attrs:
        raise DataError("its north is magnetic. Correct it with dolfyn.set_declination")
    components = {}
    for name, direction in (("u", "E"), ("v", "N")):
        component = data["vel"].isel(dir=names.index(direction), drop=True)
        if "time" not in component.dims or component.ndim > 2:
            raise DataError(f"vel is on {', '.join(map(str, data['vel'].dims))}")
        mean = _over_ranges(
            component.transpose("time", ...).values.reshape(component.sizes["time"], -1)
        )
        units = {
            key: value for key, value in data["vel"].attrs.items() if key == "units"
        }
        components[name] = ("time", mean, units)
    others = data.drop_vars([n for n in data.variables if n != "time" and data[n].ndim])
    return others.assign(components)
