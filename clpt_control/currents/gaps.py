"""Fill the gaps of a measured current, and put it on a regular grid.

Gaps are filled harmonically in space and time: each missing value is the
weighted mean of its neighbours,

    sum_n w_n (f_n - f) = 0,   w_n = 1 / (d_n h),   d_n = |dx_n|, or c |dt_n| in time,

h the size of the cell along that axis, with no flow of information through the
edge of the box.  This is the discrete Laplace equation (finite volumes) with
measured values as boundary values.  Reasons: one linear
equation does the work in time where a cell has hours nearby and in space where
it has none, in proportion to the distances; a filled value never exceeds the
measured ones (maximum principle), where splines and radial functions shoot
over in a corner that was never seen; and no basis function enters, so that the
true flow is not drawn towards what the learner can represent.  The speed c
says how much space one hour is worth: 10 km/h, as structures 20 km wide turn
with the tide in about 2 h (one radian of M2).  Twice continuously
differentiable it becomes by the cubic spline through all values, in
`regular_grid` and in the field block.
"""

from dataclasses import dataclass

import numpy as np

from ..errors import DataError
from .field_file import GriddedField
from .plane import LocalPlane

SPEED = 10.0  # km/h: what one hour of distance in time is worth in space


@dataclass(frozen=True)
class Filled:
    """A current without gaps, and how much of it was made up."""

    u: np.ndarray  # measured values as they were, filled ones elsewhere, shape (nt, ny, nx)
    v: np.ndarray
    samples: int  # values of each component
    filled: int  # of them
    cells: int
    never: int  # cells without any measured hour

    @property
    def share(self) -> float:
        """Share of the values that was filled, 0 to 1."""
        return self.filled / self.samples


def fill_gaps(
    time: np.ndarray,
    x2: np.ndarray,
    x1: np.ndarray,
    u: np.ndarray,
    v: np.ndarray,
    speed: float = SPEED,
) -> Filled:
    """Fill the gaps of a current harmonically in space and time.

    `time` in h, `x2` and `x1` in km increase; `u` and `v`, shape (nt, ny, nx), are NaN where
    missing; one hour is worth `speed` in space, km/h.

    >>> axis = np.arange(3.0)
    >>> u = np.broadcast_to(axis, (3, 3, 3)).copy()
    >>> u[1, 1, 1] = np.nan
    >>> full = fill_gaps(axis, axis, axis, u, u)
    >>> float(full.u[1, 1, 1].round(12)), full.filled, full.never
    (1.0, 1, 0)
    """
    from scipy.sparse import coo_array
    from scipy.sparse.linalg import splu

    u, v = np.asarray(u, float), np.asarray(v, float)
    gap = ~(np.isfinite(u) & np.isfinite(v))
    if gap.all():
        raise DataError("the current has no finite value to fill gaps from; choose another box")
    index = np.arange(gap.size).reshape(gap.shape)
    rows, columns, weights = [], [], []
    for axis, scale in zip(range(3), (speed * np.asarray(time), x2, x1), strict=True):
        d = np.diff(np.asarray(scale, float))
        size = np.concatenate([d[:1], (d[1:] + d[:-1]) / 2, d[-1:]])
        shape = [1, 1, 1]
        shape[axis] = -1
        before = np.take(index, range(len(d)), axis)
        after = np.take(index, range(1, len(d) + 1), axis)
        for row, column, h in ((before, after, size[:-1]), (after, before, size[1:])):
            rows.append(row.ravel())
            columns.append(column.ravel())
            weights.append(np.broadcast_to((1 / (d * h)).reshape(shape), row.shape).ravel())
    links = coo_array(
        (np.concatenate(weights), (np.concatenate(rows), np.concatenate(columns))),
        shape=(gap.size, gap.size),
    ).tocsr()
    missing, known = np.flatnonzero(gap), np.flatnonzero(~gap)
    values = np.column_stack([u.ravel(), v.ravel()])
    if len(missing):
        own = np.asarray(links.sum(axis=1)).ravel()[missing]
        among = links[missing]
        matrix = coo_array((own, (range(len(missing)), range(len(missing)))))
        solver = splu((matrix - among[:, missing]).tocsc())
        values[missing] = solver.solve(among[:, known] @ values[known])
    full_u, full_v = (values[:, k].reshape(gap.shape) for k in range(2))
    never = int(gap.all(axis=0).sum())
    return Filled(full_u, full_v, gap.size, len(missing), gap[0].size, never)


def regular_grid(
    time: np.ndarray,
    lat: np.ndarray,
    lon: np.ndarray,
    u: np.ndarray,
    v: np.ndarray,
    plane: LocalPlane,
) -> GriddedField:
    """Put a current without gaps on a regular grid of the plane, in h and km.

    The grid is the largest rectangle of the plane whose corners lie within the cells, with as
    many points as there are cells, and the record's mean step in time; values, shape (nt, ny,
    nx), come from cubic splines in time, latitude and longitude, so nothing is extrapolated.
    """
    from scipy.interpolate import RectBivariateSpline, make_interp_spline

    west, east = (plane.to_plane(lat, end)[0] for end in lon[[0, -1]])
    south, north = (plane.to_plane(end, lon)[1] for end in lat[[0, -1]])
    x1 = np.linspace(float(west.max()), float(east.min()), len(lon))
    x2 = np.linspace(float(south.max()), float(north.min()), len(lat))
    if not (x1[-1] > x1[0] and x2[-1] > x2[0]):
        raise DataError("the cells hold no rectangle of the local plane; choose a larger box")
    here_lat, here_lon = plane.to_earth(x1[None, :], x2[:, None])
    here = np.clip(here_lat, lat[0], lat[-1]), np.clip(here_lon, lon[0], lon[-1])
    even = np.linspace(time[0], time[-1], len(time))
    orders = {"kx": min(3, len(lat) - 1), "ky": min(3, len(lon) - 1)}

    def resampled(values: np.ndarray) -> np.ndarray:
        if not np.allclose(even, time, rtol=0, atol=1e-9 * (time[-1] - time[0])):
            values = make_interp_spline(time, values, k=min(3, len(time) - 1))(even)
        return np.stack([RectBivariateSpline(lat, lon, now, **orders).ev(*here) for now in values])

    return GriddedField(even, x2, x1, resampled(u), resampled(v))
