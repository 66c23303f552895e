"""A current without gaps on a regular grid of a local plane (`geodesy`): the file of a scenario.

Gaps are filled harmonically in space and time: each missing value is the
weighted mean of its neighbours,

    sum_n w_n (f_n - f) = 0,   w_n = 1 / (d_n h),   d_n = |dx_n|, or c |dt_n| in time,

h the size of the cell along that axis, with no flow of information through the
edge of the box.  This is the discrete Laplace equation (finite volumes) with
measured values as boundary values; times the volumes of the cells it is symmetric, and is solved by
conjugate gradients.  Reasons: one linear
equation does the work in time where a cell has hours nearby and in space where
it has none, in proportion to the distances; a filled value never exceeds the
measured ones (maximum principle), where splines and radial functions shoot
over in a corner that was never seen; and no basis function enters, so that the
true flow is not drawn towards what the learner can represent.  The speed c
says how much space one hour is worth: 10 km/h, as structures 20 km wide change
with the tide in about 2 h (one radian of M2).  Twice continuously
differentiable it becomes by the cubic spline through all values, in
`regular_grid` and in the field block.

The file is NetCDF with dims time, y, x (uniform, increasing), variables `u` and `v`, CF units, and
perhaps `land` (y, x), 1 where nothing was ever measured; `read_field` converts it to the scenario's
units of length and time.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ...base.errors import DataError, naming
from ...base.files.reading import open_netcdf
from ...base.geodesy import LocalPlane
from ...base.units import (
    METRES,
    SECONDS,
    length_in_metres,
    speed_in_metres_per_second,
    time_in_seconds,
)

if TYPE_CHECKING:
    import xarray

ORIGIN = "origin_latitude_longitude"  # attribute of a field's file
ROUNDING = 1e-14  # of what flows in: the solver's residual
SPEED = 10.0  # km/h: what one hour of distance in time is worth in space


@dataclass(frozen=True)
class GriddedField:
    """A current on a regular grid, without gaps; axes are even and have two points at least."""

    time: np.ndarray
    x2: np.ndarray  # length
    x1: np.ndarray
    u: np.ndarray  # flow along x1, length per time, shape (nt, n2, n1)
    v: np.ndarray  # flow along x2
    land: np.ndarray | None = None  # never measured, shape (n2, n1); None: nowhere

    @property
    def dataset(self) -> "xarray.Dataset":
        """The field as a Dataset without units."""
        import xarray

        dims = "time", "y", "x"
        axes = {"time": self.time, "y": self.x2, "x": self.x1}
        data = xarray.Dataset({"u": (dims, self.u), "v": (dims, self.v)}, axes)
        if self.land is None:
            return data
        words = {"long_name": "1 where no current was ever measured"}
        return data.assign(land=(dims[1:], self.land.astype("int8"), words))

    def on_land(self, points: np.ndarray) -> np.ndarray:
        """Return which points (n, 2) are nearest to a point that was never measured."""
        if self.land is None:
            return np.zeros(len(points), bool)
        return self.land[
            _nearest(self.x2, points[:, 1]), _nearest(self.x1, points[:, 0])
        ]

    def __repr__(self) -> str:
        return repr(self.dataset)

    def _repr_html_(self) -> str:
        return self.dataset._repr_html_()


def _nearest(axis: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Return the indices of the nearest numbers of an increasing axis."""
    return np.searchsorted((axis[1:] + axis[:-1]) / 2, values)


def fill_gaps(
    time: np.ndarray, x2: np.ndarray, x1: np.ndarray, u: np.ndarray, v: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return a current with its gaps filled harmonically in space and time, and where they were.

    `time` in h, `x2` and `x1` in km increase; `u` and `v`, shape (nt, ny, nx), are NaN where
    missing, and finite somewhere.

    >>> axis = np.arange(3.0)
    >>> u = np.broadcast_to(axis, (3, 3, 3)).copy()
    >>> u[1, 1, 1] = np.nan
    >>> full, _, gap = fill_gaps(axis, axis, axis, u, u)
    >>> float(full[1, 1, 1].round(12)), int(gap.sum())
    (1.0, 1)
    """
    from scipy.sparse import diags_array, kronsum
    from scipy.sparse.linalg import cg

    gap = ~(np.isfinite(u) & np.isfinite(v))
    # weights of the neighbours along each axis; of the cells
    alone, volume = ([], np.ones(1))
    for axis in (SPEED * time, x2, x1):
        d = np.diff(axis)
        size = np.concatenate([d[:1], (d[1:] + d[:-1]) / 2, d[-1:]])
        alone.append(
            diags_array([1 / (d * size[:-1]), 1 / (d * size[1:])], offsets=[1, -1])
        )
        volume = np.outer(volume, size).ravel()
    links = kronsum(kronsum(alone[2], alone[1]), alone[0]).tocsr()
    missing, measured = np.flatnonzero(gap), np.flatnonzero(~gap)
    values = np.column_stack([u.ravel(), v.ravel()])
    if len(missing):
        neighbours = diags_array(volume[missing]) @ links[missing]  # symmetric
        diagonal = neighbours.sum(axis=1)
        laplace = diags_array(diagonal) - neighbours[:, missing]
        for field_values, flux in zip(
            values.T, (neighbours[:, measured] @ values[measured]).T, strict=True
        ):
            field_values[missing] = cg(
                laplace, flux, rtol=ROUNDING, M=diags_array(1 / diagonal)
            )[0]
    return values[:, 0].reshape(gap.shape), values[:, 1].reshape(gap.shape), gap


def regular_grid(
    time: np.ndarray,
    lat: np.ndarray,
    lon: np.ndarray,
    u: np.ndarray,
    v: np.ndarray,
    plane: LocalPlane,
    land: np.ndarray,
) -> GriddedField:
    """Put a current without gaps on a regular grid of the plane, in h and km.

    The grid is the largest rectangle of the plane whose corners lie within the cells, with as
    many points as there are cells, and the record's mean step in time; values, shape (nt, ny,
    nx), come from cubic splines in time, latitude and longitude, so nothing is extrapolated;
    `land`, shape (ny, nx), from the nearest cell.
    """
    from scipy.interpolate import RectBivariateSpline, make_interp_spline

    west, east = (plane.to_plane(lat, end)[0] for end in lon[[0, -1]])
    south, north = (plane.to_plane(end, lon)[1] for end in lat[[0, -1]])
    x1 = np.linspace(float(west.max()), float(east.min()), len(lon))
    x2 = np.linspace(float(south.max()), float(north.min()), len(lat))
    if not (x1[-1] > x1[0] and x2[-1] > x2[0]):
        raise DataError(
            "the cells contain no rectangle of the local plane. Choose a larger box"
        )
    here_lat, here_lon = plane.to_earth(x1[None, :], x2[:, None])
    nearest_inside = (
        np.clip(here_lat, lat[0], lat[-1]),
        np.clip(here_lon, lon[0], lon[-1]),
    )
    even = np.linspace(time[0], time[-1], len(time))
    orders = {"kx": min(3, len(lat) - 1), "ky": min(3, len(lon) - 1)}

    def resampled(values: np.ndarray) -> np.ndarray:
        if not np.allclose(even, time, rtol=0, atol=1e-9 * (time[-1] - time[0])):
            values = make_interp_spline(time, values, k=min(3, len(time) - 1))(even)
        return np.stack(
            [
                RectBivariateSpline(lat, lon, now, **orders).ev(*nearest_inside)
                for now in values
            ]
        )

    land = land[_nearest(lat, here_lat), _nearest(lon, here_lon)]
    found = land if land.any() else None
    return GriddedField(even, x2, x1, resampled(u), resampled(v), found)


def read_field(
    path: Path, units, origin: tuple[float, float] | None = None
) -> GriddedField:
    """Return the field of a file, such as `clpt fit` writes, in the units of a scenario.

    An `origin` (latitude, longitude) must be that of the field, if the file has one.
    """
    from .valid_values import numbers_of

    with open_netcdf(path) as data, naming(path):
        _check_origin(data.attrs.get(ORIGIN), origin)
        for name in ("time", "y", "x", "u", "v"):
            if name not in data.variables:
                raise DataError(
                    f"no variable '{name}'; a field has time, y, x, u and v"
                )
        stated = {
            name: str(variable.attrs.get("units", ""))
            for name, variable in data.variables.items()
        }
        length, time = METRES[units.length], SECONDS[units.time]
        sizes = {
            name: length_in_metres(stated[name], name) / length for name in ("y", "x")
        }
        sizes["time"] = time_in_seconds(stated["time"], "time") / time
        axes = [_regular(numbers_of(data[n]) * sizes[n], n) for n in ("time", "y", "x")]
        values = []
        for name in ("u", "v"):
            if data[name].dims != ("time", "y", "x"):
                raise DataError(f"{name} must have the dimensions time, y, x")
            size = speed_in_metres_per_second(stated[name], name)
            values.append(numbers_of(data[name]) * (size / (length / time)))
            if not np.all(np.isfinite(values[-1])):
                raise DataError(f"{name} has gaps. Fill them with clpt fit")
        if "land" in data.variables and data["land"].dims == ("y", "x"):
            values.append(data["land"].values == 1)
    return GriddedField(*axes, *values)


def _check_origin(of_field: Any, of_scenario: tuple[float, float] | None) -> None:
    """Refuse a scenario with another origin than its field's."""
    if of_field is None or of_scenario is None:
        return
    if not np.allclose(of_field, of_scenario, rtol=0, atol=1e-6):
        raise DataError(
            f"the field's origin is {np.asarray(of_field).tolist()}, the scenario's is "
            f"{list(of_scenario)}. Give the scenario the field's origin"
        )


def time_origin(path: Path) -> dict[str, str]:
    """Return the date of a field's t = 0, ``{"time_origin": "2019-01-01T00:00:00"}``, or none."""
    with open_netcdf(path) as data:
        origin = data.attrs.get("time_origin")
    return {} if origin is None else {"time_origin": str(origin)}


def _regular(axis: np.ndarray, name: str) -> np.ndarray:
    step = np.diff(np.atleast_1d(axis))
    if axis.ndim != 1 or not step.size or not np.ptp(step) < 1e-6 * step.min():
        raise DataError(
            f"{name} must have two points or more, evenly spaced and increasing"
        )
    return axis


def field_dataset(field: GriddedField, units, attributes: dict) -> "xarray.Dataset":
    """Return a field in a scenario's units as CF data; attributes are title and source."""
    data = field.dataset
    speed = f"{units.length} {units.time}-1"
    attributes_of = {
        "time": {"long_name": "time since start", "units": units.time},
        "u": {"long_name": "flow along x1 (east)", "units": speed},
        "v": {"long_name": "flow along x2 (north)", "units": speed},
    }
    for name in "yx":
        standard_name = f"projection_{name}_coordinate"
        attributes_of[name] = {"standard_name": standard_name, "units": units.length}
    for name, words in attributes_of.items():
        data[name].attrs = words
    return data.assign_attrs({"Conventions": "CF-1.11", **attributes})
