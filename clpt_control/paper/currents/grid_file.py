"""Read a gridded current, with its gaps: CF names or u/v, units from attributes.

The result is always the same: latitudes and longitudes increasing, hours since the
first step, u (east) and v (north) in m/s, NaN where either was not measured.  A
drifter needs the level nearest the surface, a glider samples the water column.

A current is a NetCDF file, a Zarr folder, or a folder of NetCDF files, each with other
steps on the same grid; of a step that two files have, the later by name counts.  Where u
and v are exactly 0 at all steps, and not everywhere, there is land, which is no water at
rest: it is a gap.

Steps are missing in an interval that is longer than 2.5 times the median of the two before it and
the two after it, so that steps may become coarser further ahead, as forecasts have them.
"""

import re
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager, nullcontext, suppress
from dataclasses import dataclass, replace
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np
import xarray
from scipy.integrate import trapezoid

from ...base.arguments import public
from ...base.errors import ClptError, DataError, naming
from ...base.files.reading import open_netcdf, shown_name, zarr_store
from . import cf

NAME = "maracoos_hfr_2019-01-01.nc"
DEEPEST = 1000.0  # m; no level of a column further down is read, except the next
# times the median step: no longer step is missing in a grid around the Earth
AROUND = 1.5
GAP = 2.5  # times the intervals around one: beyond, steps are missing
COUNT = re.compile(r"(\d+) of (\d+)")  # at the beginning of a note
SAME = 1e-6  # degrees: no cells are so near; 0.1 m
MOST = 10**8  # values of one component: 0.8 GB
SUFFIXES = (".nc", ".nc4", ".cdf", ".netcdf")
Box = tuple[float, float, float, float]
Source = str | Path | Sequence[str | Path] | xarray.Dataset
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


@dataclass(frozen=True)
class Currents:
    """A measured or modelled current on latitudes and longitudes."""

    lat: np.ndarray  # degrees north, increasing, shape (ny,)
    lon: np.ndarray  # degrees east, increasing, may pass 180, shape (nx,)
    # levels, m, increasing from the surface; 0 where the file has none, NaN of
    depth: np.ndarray
    # one whose depth it does not say
    dates: np.ndarray  # datetime64[ms], UTC, increasing, shape (nt,)
    # to the east, m/s, NaN in gaps, shape (nt, ny, nx), or (nt, nz, ny, nx)
    u: np.ndarray
    v: np.ndarray  # to the north
    box: Box  # lat0, lat1, lon0, lon1 asked for, degrees
    source: str  # name of the file or folder
    land: int = 0  # cells, of all levels, whose zeros were taken as land
    notes: tuple[str, ...] = ()  # on levels, flags and times

    @property
    def measured(self) -> np.ndarray:
        """Mask of measured values, boolean, with the shape of u."""
        return np.isfinite(self.u)

    @property
    def time(self) -> np.ndarray:
        """Hours since the first step."""
        return (self.dates - self.dates[0]) / np.timedelta64(1, "h")

    @property
    def start(self) -> str:
        """The first step, ISO 8601."""
        return self.dates[0].item().isoformat()


@public
def read_currents(
    source: str | Path | Sequence[str | Path] | xarray.Dataset,
    box: tuple[float, float, float, float] | None = None,
    *,
    column: bool = False,
    depth: float | None = None,
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
    span = None if box is None else _checked_box(box)
    if depth is not None and not (np.isfinite(depth) and depth > 0):
        raise DataError(f"depth (--depth) = {depth:g} m: must be positive and finite")
    deepest = DEEPEST if column else depth
    files = _files_of(source)
    if files is None:
        one = source if isinstance(source, xarray.Dataset) else Path(str(source))
        currents = _read(one, span, deepest, units, names, 2)
    else:
        parts = [_read(file, span, deepest, units, names, 1) for file in files]
        currents = _concatenated(source_name(source), parts)
    still = ~((currents.u != 0.0) | (currents.v != 0.0)).any(axis=0)
    if still.any() and not still.all():
        currents.u[:, still] = currents.v[:, still] = np.nan
        currents = replace(currents, land=int(still.sum()))
    return currents if column or depth is None else _mean_over_depth(currents, depth)


def _mean_over_depth(currents: Currents, depth: float) -> Currents:
    """Return the mean of a current from the surface to a depth, m.

    The current is linear between levels, and constant above the first and below the last one.
    Levels that are gaps, as below the sea floor, are left out of the mean.
    """
    z = currents.depth
    if not z.size > 1:
        raise DataError(f"{currents.source}: has one level. Leave depth (--depth) out")
    limits = np.unique([0.0, *z[z < depth], min(depth, z[-1])])
    hats = [np.interp(limits, z, row) for row in np.eye(z.size)]
    weights = trapezoid(hats, limits)[:, None, None] * currents.measured
    with np.errstate(invalid="ignore"):  # 0/0 where all levels are gaps
        u, v = (
            (weights * np.nan_to_num(w)).sum(axis=1) / weights.sum(axis=1)
            for w in (currents.u, currents.v)
        )
    note = f"u and v are means from the surface to {limits[-1]:g} m, of {z.size} levels"
    return replace(currents, depth=np.zeros(1), u=u, v=v, notes=(*currents.notes, note))


def source_name(source: Source) -> str:
    """Return the name of a source of currents, with which error sentences begin."""
    if isinstance(source, xarray.Dataset):
        return "Dataset"
    if isinstance(source, str | Path):
        return str(source)
    return f"{len(source)} files"


def _files_of(source: Source) -> list[Path] | None:
    """Return the files of a folder or list, or None for a single file or Dataset."""
    if isinstance(source, xarray.Dataset):
        return None
    if not isinstance(source, str | Path):
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


def missing_steps(time: np.ndarray) -> np.ndarray:
    """Return how many steps are missing in each interval between increasing steps.

    >>> missing_steps(np.array([0.0, 6.0, 12.0, 78.0, 84.0])).tolist()
    [0, 0, 10, 0]
    >>> missing_steps(np.array([0.0, 1.0, 2.0, 5.0, 8.0, 11.0])).tolist()
    [0, 0, 0, 0, 0]
    """
    steps = np.diff(time)
    missing = np.zeros(len(steps), int)
    for k, step in enumerate(steps):
        neighbours = np.concatenate([steps[max(k - 2, 0) : k], steps[k + 1 : k + 3]])
        if neighbours.size > 0 and step > GAP * np.median(neighbours):
            missing[k] = round(step / np.median(neighbours)) - 1
    return missing


def with_all_steps(currents: Currents) -> Currents:
    """Return a current on one level with the steps that are missing, as gaps."""
    missing = missing_steps(currents.time)
    if missing.sum() > len(currents.time):
        where = currents.time[np.argmax(missing)]
        raise DataError(
            f"{missing.sum()} steps are missing, most behind {where:.6g} h. Cut there"
        )
    rows = np.concatenate([[0], np.cumsum(1 + missing)])
    dates = np.interp(np.arange(rows[-1] + 1), rows, currents.dates.astype(float))
    u, v = (
        np.full((len(dates), *w.shape[1:]), np.nan) for w in (currents.u, currents.v)
    )
    u[rows], v[rows] = currents.u, currents.v
    return replace(currents, dates=dates.astype(currents.dates.dtype), u=u, v=v)


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


def _concatenated(path: str, files: list[Currents]) -> Currents:
    """Return one current of several on one grid, each with steps of its own."""
    template, nothing = files[0], f"{path}: u and v have no step in common"
    for file in files:
        for name in ("lat", "lon", "depth"):
            if not np.array_equal(
                getattr(file, name), getattr(template, name), equal_nan=True
            ):
                raise DataError(
                    f"{path}: {file.source} has another {name} than {template.source}"
                )
    steps = np.unique(np.concatenate([file.dates for file in files]))
    if len(steps) < 2:
        raise DataError(f"{path}: has 1 of the 2 required steps")
    u, v = (_component(path, files, key, steps) for key in "uv")
    has_u, has_v = (np.isfinite(w).any(axis=tuple(range(1, w.ndim))) for w in (u, v))
    lone_steps = int((has_u != has_v).sum())
    cf.mark_gaps(u, v, ("u", "v"), nothing)
    notes = [note for file in files for note in file.notes]
    if lone_steps:
        notes.append(f"{lone_steps} steps have values of u or v alone: left out")
    return replace(
        template,
        dates=steps,
        u=u,
        v=v,
        source=shown_name(Path(path)),
        notes=_counted(notes),
    )


def _component(
    path: str, files: list[Currents], key: str, steps: np.ndarray
) -> np.ndarray:
    """Return u or v of files at steps; of a step that two files have, the later file counts."""
    values = np.full((len(steps), *files[0].u.shape[1:]), np.nan)
    file_of_step = np.full(len(steps), -1)
    having = [
        k for k, file in enumerate(files) if np.isfinite(getattr(file, key)).any()
    ]
    if not having:
        raise DataError(
            f"{path}: no file has the velocity {key}. Give --u and --v, or names="
        )
    for k in having:
        rows = np.searchsorted(steps, files[k].dates)
        values[rows] = getattr(files[k], key)
        file_of_step[rows] = k
    for k in set(having) - set(file_of_step.tolist()):
        raise DataError(
            f"{path}: each step of {files[k].source} is in a later file too. Correct its times "
            f"(it begins at {files[k].start}), or remove the file"
        )
    return values


def _counted(notes: Iterable[str]) -> tuple[str, ...]:
    """Return notes of files, each once, with the sums of counts such as `9 of 70`.

    >>> _counted(["9 of 70 values", "a level", "1 of 30 values", "a level"])
    ('10 of 100 values', 'a level')
    """
    counts: dict[str, np.ndarray] = {}
    for note in notes:
        match, kind = COUNT.match(note), COUNT.sub("", note)
        count = np.array(match.groups() if match else (0, 0), int)
        counts[kind] = counts.get(kind, 0) + count
    return tuple(
        f"{part} of {total}{kind}" if total else kind
        for kind, (part, total) in counts.items()
    )


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
        lat, lon, when = (
            cf.find_axis(data, names[0], quantity)
            for quantity in ("latitude", "longitude", "time")
        )
        if lat.dims == lon.dims:  # places, and no grid of them
            raise DataError(
                f"{lat.name} and {lon.name} are along {lat.dims[0]}, not a grid; {cf.CURE}"
            )
        dates = cf.dates_of(data, when, names[0], notes, least)
        latitudes, longitudes = lat.values.astype(float), lon.values.astype(float)
        if abs(np.ptp(longitudes[[0, -1]]) - 360.0) < SAME:  # its first meridian again
            longitudes = longitudes[:-1]
        longitudes = _unwrapped(longitudes, span)
        limits = span or (
            latitudes.min(),
            latitudes.max(),
            longitudes.min(),
            longitudes.max(),
        )
        rows = _inside(latitudes, limits[:2], str(lat.name))
        columns = _inside(longitudes, limits[2:], str(lon.name))
        steps = np.argsort(dates)
        if len(np.unique(dates)) < len(dates):
            raise DataError(f"{when.name} has a time twice. Remove the repeated step")
        across = {lat.dims[0]: rows, lon.dims[0]: columns}
        index, depth = {when.dims[0]: steps}, np.zeros(1)
        if deepest is not None:
            level, depth = _levels(data, names[0], {*index, *across})
            order = np.argsort(depth)
            order = order[: max(int(np.searchsorted(depth[order], deepest)) + 1, 2)]
            depth = depth[order]
            index |= {} if level is None else {level: order}
        index |= across
        size = np.prod([len(indices) for indices in index.values()], dtype=float)
        if size > MOST:
            raise DataError(
                f"{names[0]} has {size:.3g} values, at most {MOST:.0g}. Cut the file"
            )
        flow = [cf.velocity_values(data, name, index, units, notes) for name in names]
        nothing = (
            f"{' and '.join(names)} have no finite value in the box {_edges(limits)}"
        )
        nothing = "; ".join(dict.fromkeys((nothing, *notes)))
        cf.mark_gaps(flow[0], flow[-1], (names[0], names[-1]), nothing)
        if deepest is not None and flow[0].ndim == 3:
            flow = [values[:, None] for values in flow]
        components = dict(zip(velocities, flow, strict=True))
        u, v = (components.get(key, np.full(flow[0].shape, np.nan)) for key in "uv")
        lat0, lat1, lon0, lon1 = map(float, limits)
        of_grid = latitudes[rows], longitudes[columns], depth, dates[steps], u, v
        return Currents(
            *of_grid,
            (lat0, lat1, lon0, lon1),
            shown_name(Path(source)),
            notes=tuple(dict.fromkeys(notes)),
        )


def _velocity_names(
    data: xarray.Dataset, given: dict[str, str] | None, is_part: bool
) -> dict[str, str]:
    """Return the names of u and v; a file that is a part of a current may lack one of them."""
    names = dict[str, str]()
    for key, quantity in (("u", "eastward"), ("v", "northward")):
        may_lack = is_part and (key == "u" or names)
        with suppress(DataError) if may_lack else nullcontext():
            names[key] = (
                cf.checked_name(data, given[key])
                if given
                else cf.find_variable(data, cf.VELOCITY, quantity)
            )
    return names


def _checked_box(box: Any) -> Box:
    """Return lat0, lat1, lon0, lon1 with lon1 > lon0, also across 180 degrees."""
    lat0, lat1, lon0, lon1 = map(float, box)
    width = (lon1 - lon0) % 360.0
    if not -90 <= lat0 < lat1 <= 90 or not 0 < width <= 180:
        raise DataError(
            f"box = {_edges(box)}: must be SOUTH NORTH WEST EAST, up to 180 wide"
        )
    return lat0, lat1, lon0, lon0 + width


def _unwrapped(lon: np.ndarray, box: Box | None) -> np.ndarray:
    """Return longitudes without a jump: cut opposite a box, or at the circle's largest gap.

    A grid around the Earth has none and is cut where the file begins.
    """
    if box is not None:
        west = box[2] + 0.5 * (box[3] - box[2]) - 180.0
    else:
        order = np.argsort(lon % 360.0)
        gaps = np.diff(lon[order] % 360.0, append=lon[order[0]] % 360.0 + 360.0)
        east_of_gap = order[(int(np.argmax(gaps)) + 1) % len(lon)]
        west = lon[east_of_gap] if np.max(gaps) > AROUND * np.median(gaps) else lon[0]
    return lon - 360.0 * np.floor((lon - west) / 360.0)


def _inside(axis: np.ndarray, span: tuple, where: str) -> np.ndarray:
    """Return the indices of the axis inside the span, in increasing order."""
    slack = 1e-9
    order = np.argsort(axis)
    inside = order[(axis[order] >= span[0] - slack) & (axis[order] <= span[1] + slack)]
    if len(inside) < 2:
        shortage = f"{len(inside)} of the 2 cells that are needed"
        raise DataError(
            f"{where} has {shortage}; it goes from {axis.min():.6g} to {axis.max():.6g}"
        )
    if not np.all(np.diff(axis[inside]) > SAME):
        raise DataError(
            f"{where} has a value twice (0 and 360 degrees are the same). Remove one"
        )
    return inside


def _levels(
    data: xarray.Dataset, name: str, axes: set
) -> tuple[Any | None, np.ndarray]:
    """Return the dimension of several levels, if any, and their depths, m; NaN if not known."""
    across = set(data[name].dims) - axes
    depth_names = [n for n in data.variables if cf.is_depth(data, n)]
    depth_names = [n for n in depth_names if n in across or data[n].size == 1]
    if not depth_names:  # what else there is, `velocity_values` refuses
        return None, np.zeros(1)
    where = str(max(depth_names, key=lambda n: data[n].size))
    is_single = data[where].size == 1
    try:
        depth = cf.depths_of(data, where)
    except DataError:
        if not is_single:
            raise
        depth = np.array([np.nan])
    if not np.all(np.diff(np.sort(depth)) > 0):
        raise DataError(
            f"{where} has {len(depth)} levels; must be finite depths, each once"
        )
    return None if is_single else where, depth


def _edges(box: Any) -> str:
    return " ".join(f"{value:g}" for value in box)
