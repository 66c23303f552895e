"""Read a gridded current, with its gaps: CF names or u/v, units from attributes.

The result is always the same: latitudes and longitudes increasing, hours since the
first step, u (east) and v (north) in m/s, NaN where either was not measured.  A
drifter needs the level nearest the surface, a glider samples the water column.

A current is a NetCDF file, a Zarr folder, or a folder of NetCDF files, each with other
steps on the same grid; of a step that two files have, the later by name counts.  Where u
and v are exactly 0 at all steps, and not everywhere, there is land, which is no water at
rest: it is a gap.
"""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager, nullcontext, suppress
from dataclasses import replace
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np
import xarray

from ...base.arguments import Positive, public
from ...base.errors import ClptError, DataError, naming
from ...base.files.reading import AnyPath, open_netcdf, shown_name, zarr_store
from . import cf
from .cf_times import dates_of
from .current_grid import (
    SAME,
    Box,
    Currents,
    cells_inside,
    checked_box,
    concatenated,
    edges_of,
    mean_over_depth,
    unwrapped,
)
from .valid_values import mark_gaps

NAME = "maracoos_hfr_2019-01-01.nc"
DEEPEST = 1000.0  # m; no level of a column further down is read, except the next
MOST = 10**8  # values of one component: 0.8 GB
SUFFIXES = (".nc", ".nc4", ".cdf", ".netcdf")
Source = AnyPath | Sequence[AnyPath] | xarray.Dataset
ZARR = ("zarr.json", ".zgroup", ".zmetadata")  # one is in each folder of Zarr


def sample_currents() -> Path:
    """Return the file of a measured current in the package.

    Returns
    -------
    Path
        NetCDF: the surface current of Nantucket Shoals on 1 January 2019 by HF radar, hourly, on
        cells of 6 km; u and v in cm/s, with gaps (MARACOOS; MIT licence).

    Examples
    --------
    >>> import clpt_control as clpt
    >>> clpt.currents.read_currents(sample_currents()).u.shape
    (24, 14, 18)
    """
    return Path(str(resources.files("clpt_control.data") / NAME))


@public
def read_currents(
    source: Source,
    box: Box | None = None,
    *,
    column: bool = False,
    depth: Positive | None = None,
    units: str | None = None,
    names: dict[str, str] | None = None,
) -> Currents:
    """Read a gridded current: files, Zarr, a folder or a Dataset.

    Parameters
    ----------
    source : str, Path, list of str or Path, or xarray.Dataset
        A NetCDF file, a Zarr folder, a folder or list of NetCDF files, or a Dataset, with
        dims time, latitude, longitude in any order, and perhaps a depth.
        Files of one folder or list have the same grid, and other steps or one of u and v.
    box : tuple of float, optional
        lat0, lat1, lon0, lon1 in degrees; cells whose centre is inside are
        read. Without it, the whole file.
    column : bool, optional
        Read all levels down to 1000 m and the next, in place of the level
        nearest the surface.
    depth : float, optional
        m: the mean over the levels from the surface to this depth, in place of the
        level nearest the surface.
    units : str, optional
        Of u and v, such as ``m/s``, where the file has none.
    names : dict, optional
        Names of the eastward and northward velocity, ``{"u": NAME, "v": NAME}``;
        otherwise they are found by standard name, or by usual names.

    Returns
    -------
    Currents
        In m/s, m, degrees and hours, gaps as NaN, and `notes` on levels, flags and times.

    Raises
    ------
    DataError
        If the file, a variable, a unit, or data in the box are missing, or
        they are too many to be held; one sentence naming file, variable and
        what is allowed.

    Examples
    --------
    A current of two hours on four cells:

    >>> import tempfile, xarray
    >>> hours = ("time", [0.0, 1.0], {"units": "hours since 2019-01-01"})
    >>> grid = {"time": hours, "lat": [41.0, 41.1], "lon": [-69.2, -69.1]}
    >>> flow = (("time", "lat", "lon"), np.full((2, 2, 2), 25.0), {"units": "cm/s"})
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     data = xarray.Dataset({"east": flow, "north": flow}, grid)
    ...     data.to_netcdf(f"{folder}/current.nc")
    ...     names = {"u": "east", "v": "north"}
    ...     currents = read_currents(f"{folder}/current.nc", names=names)
    >>> currents.start, currents.time, float(currents.u[0, 0, 0])
    ('2019-01-01T00:00:00', array([0., 1.]), 0.25)
    """
    if names is not None and set(names) != {"u", "v"}:
        raise DataError(
            f"names: has {', '.join(names) or 'nothing'}; must have u and v"
        )
    span = None if box is None else checked_box(box)
    deepest = DEEPEST if column else depth
    files = _files_of(source)
    if files is None:
        one = source if isinstance(source, xarray.Dataset) else Path(str(source))
        currents = _read(one, span, deepest, units, names, 2)
    else:
        parts = [_read(file, span, deepest, units, names, 1) for file in files]
        currents = concatenated(source_name(source), parts)
    still = ~((currents.u != 0.0) | (currents.v != 0.0)).any(axis=0)
    if still.any() and not still.all():
        currents.u[:, still] = currents.v[:, still] = np.nan
        currents = replace(currents, land=int(still.sum()))
    return currents if column or depth is None else mean_over_depth(currents, depth)


def source_name(source: Source) -> str:
    """Return the name of a source of currents, with which error sentences begin."""
    if isinstance(source, xarray.Dataset):
        return "Dataset"
    if isinstance(source, AnyPath):
        return str(source)
    return f"{len(source)} files"


def _files_of(source: Source) -> list[Path] | None:
    """Return the files of a folder or list, or None for a single file or Dataset."""
    if isinstance(source, xarray.Dataset):
        return None
    if not isinstance(source, AnyPath):
        if not source:
            raise DataError("source: an empty list. Give at least one file")
        return [Path(file) for file in source]
    path = Path(source)
    if not path.is_dir() or any((path / name).exists() for name in ZARR):
        return None
    files = sorted(f for f in path.iterdir() if f.suffix.lower() in SUFFIXES)
    if not files:
        raise DataError(
            f"{path}: has neither Zarr nor NetCDF files ({', '.join(SUFFIXES)})"
        )
    return files


@contextmanager
def _opened(path: Path | xarray.Dataset) -> Iterator[xarray.Dataset]:
    """Open a NetCDF file or a Zarr folder, whose values are read when used.

    A Dataset is encoded as it would be in a file, with numbers as its times.
    """
    if isinstance(path, xarray.Dataset):
        variables, attributes = xarray.conventions.cf_encoder(
            path.variables, path.attrs
        )
        encoded = xarray.Dataset(variables, attrs=attributes)
        yield xarray.decode_cf(encoded, decode_times=False)
        return
    if not path.is_dir():
        with open_netcdf(path) as data:
            yield data
        return
    store = zarr_store(path)
    try:
        with xarray.open_zarr(
            store, chunks=None, consolidated=False, decode_times=False
        ) as data:
            yield data
    except ClptError:
        raise
    except Exception as error:  # whatever a damaged folder makes of itself
        reason = str(error).partition("\n")[0][:120] or type(error).__name__
        raise DataError(f"{path}: cannot be read as Zarr: {reason}") from None


def _read(
    path: Path | xarray.Dataset,
    span: Box | None,
    deepest: float | None,
    units: str | None,
    given: dict[str, str] | None,
    least: int,
) -> Currents:
    """Read one file, Zarr folder or Dataset of so many steps at least.

    All levels to the `deepest` (m) and the next are read, or the one nearest the surface.
    """
    source, notes = source_name(path), list[str]()
    with _opened(path) as data, naming(source):
        if "fit_report" in data.attrs:
            raise DataError(
                "is the field of a fit. Give the .toml file beside it as a flow model"
            )
        velocities = _velocity_names(data, given, is_part=least == 1)
        names = list(velocities.values())
        when = cf.find_axis(data, names[0], "time")
        across, lat, lon, limits = cells_in_box(data, names[0], span)
        dates = dates_of(data, when, names[0], notes, least)
        steps = np.argsort(dates)
        if len(np.unique(dates)) < len(dates):
            raise DataError(f"{when.name} has a time twice. Remove the repeated step")
        index, depth = {when.dims[0]: steps}, np.zeros(1)
        if deepest is not None:
            levels, depth = _levels(data, names[0], {*index, *across}, deepest)
            index |= levels
        index |= across
        size = np.prod([len(indices) for indices in index.values()], dtype=float)
        if size > MOST:
            raise DataError(
                f"{names[0]} has {size:.3g} values, at most {MOST:.0g}. Cut the file"
            )
        flow = [cf.velocity_values(data, name, index, units, notes) for name in names]
        nothing = (
            f"{' and '.join(names)} have no finite value in the box {edges_of(limits)}. "
            "Give another box"
        )
        nothing = "; ".join(dict.fromkeys((nothing, *notes)))
        mark_gaps(flow[0], flow[-1], (names[0], names[-1]), nothing)
    if deepest is not None and flow[0].ndim == 3:
        flow = [values[:, None] for values in flow]
    components = dict(zip(velocities, flow, strict=True))
    u, v = (components.get(key, np.full(flow[0].shape, np.nan)) for key in "uv")
    of_grid = lat, lon, depth, dates[steps], u, v, limits, shown_name(Path(source))
    return Currents(*of_grid, notes=tuple(dict.fromkeys(notes)))


def cells_in_box(
    data: xarray.Dataset, velocity: str, span: Box | None
) -> tuple[dict[Any, np.ndarray], np.ndarray, np.ndarray, Box]:
    """Return the cells in a box: indices by dimension, latitudes, longitudes, and the box."""
    lat, lon = (
        cf.find_axis(data, velocity, quantity) for quantity in ("latitude", "longitude")
    )
    if lat.dims == lon.dims:  # places, and no grid of them
        raise DataError(
            f"{lat.name} and {lon.name} are along {lat.dims[0]}, not a grid; {cf.CURE}"
        )
    latitudes, longitudes = lat.values.astype(float), lon.values.astype(float)
    if abs(np.ptp(longitudes[[0, -1]]) - 360.0) < SAME:  # its first meridian again
        longitudes = longitudes[:-1]
    longitudes = unwrapped(longitudes, span)
    ends = (end(axis) for axis in (latitudes, longitudes) for end in (np.min, np.max))
    south, north, west, east = span or map(float, ends)
    rows = cells_inside(latitudes, (south, north), str(lat.name))
    columns = cells_inside(longitudes, (west, east), str(lon.name))
    across = {lat.dims[0]: rows, lon.dims[0]: columns}
    return across, latitudes[rows], longitudes[columns], (south, north, west, east)


def _velocity_names(
    data: xarray.Dataset, given: dict[str, str] | None, is_part: bool
) -> dict[str, str]:
    """Return the names of u and v; a file that is a part of a current may lack one of them."""
    names = dict[str, str]()
    for key, quantity in (("u", "eastward"), ("v", "northward")):
        may_lack = is_part and (key == "u" or names)
        with suppress(DataError) if may_lack else nullcontext():
            names[key] = (
                cf.checked_name(data, given[key], quantity)
                if given
                else cf.find_variable(data, cf.VELOCITY, quantity)
            )
    return names


def _levels(
    data: xarray.Dataset, name: str, axes: set, deepest: float
) -> tuple[dict[Any, np.ndarray], np.ndarray]:
    """Return the indices of levels to a depth and the next, if there are several, and depths.

    Depths are in m, NaN if that of a single level is not known.
    """
    across = set(data[name].dims) - axes
    depth_names = [n for n in data.variables if cf.is_depth(data, n)]
    depth_names = [n for n in depth_names if n in across or data[n].size == 1]
    if not depth_names:  # what else there is, `velocity_values` refuses
        return {}, np.zeros(1)
    where = str(max(depth_names, key=lambda n: data[n].size))
    is_single = data[where].size == 1
    try:
        depth = cf.depths_of(data, where)
    except DataError:
        if not is_single:
            raise
        depth = np.array([np.nan])
    order = np.argsort(depth)
    depth = depth[order]
    if not np.all(np.diff(depth) > 0):
        raise DataError(
            f"{where} has {len(depth)} levels; must be finite depths, each once"
        )
    count = max(int(np.searchsorted(depth, deepest)) + 1, 2)
    return {} if is_single else {where: order[:count]}, depth[:count]
