"""A gridded forecast as a flow model (`carried_dives`): what a glider feels of its water column.

A dive samples the column down to its greatest depth D, so the flow is averaged over it, by
trapezoids through the levels that have data,

    F = (1 / D) int_0^D u dz,    u linear between levels, constant above the first,

as far down as there are data; D is `Dive.depth_max`, or 1000 m where it is not
known.  D is the one number of a dive that is read though it is measured during the
dive: a pilot knows the depth that was planned, which it stands for.

F is linear between latitudes, longitudes and times, and nowhere extrapolated:
outside the area, before the first step, after the last, where a corner of the cell
has no data and in a gap of the steps (`missing_steps`) there is no model.
"""

from math import cos, isfinite, radians
from pathlib import Path

import numpy as np
from scipy.interpolate import RegularGridInterpolator

from ..currents.grid_file import AROUND, DEEPEST, missing_steps, read_currents
from ..currents.plane import LocalPlane
from ..geodesy import near
from ..gliders.dives import Dive
from .carried_dives import Flow, FlowModel, Uncovered

OUTSIDE = "outside the forecast's area"
DEGREE = 110500.0  # m; no degree of latitude is shorter


@np.errstate(invalid="ignore", divide="ignore")
def depth_mean(depth: np.ndarray, values: np.ndarray, deepest: float) -> np.ndarray:
    """Average a profile, shape (nt, nz, ...), from the surface to a depth, m.

    The mean ends at the deepest level with data, if that is higher, and is NaN where no
    level above the end has any.  Levels `depth`, m, increase from the surface.

    >>> depth = np.array([0.0, 100.0, 400.0])
    >>> depth_mean(depth, np.array([[0.4, 0.3, 0.0]]), 200.0).round(9)
    array([0.3])
    """
    shape = values[:, 0].shape
    total, last, above = np.zeros(shape), np.zeros(shape), np.full(shape, np.nan)
    for z, value in zip(depth, np.moveaxis(values, 1, 0), strict=True):
        first = np.isnan(above)
        use = np.isfinite(value) & (first | (last < deepest))
        if z > max(deepest, depth[0]):
            use &= ~first  # nothing was seen above that end
        end = min(z, deepest)
        slope = np.where(first | (z == last), 0.0, (value - above) / (z - last))
        top = np.where(first, value, above)
        thick = end - last
        total = np.where(use, total + thick * (top + slope * thick / 2), total)
        above, last = np.where(use, value, above), np.where(use, end, last)
    return np.where(last > 0, total / last, above)


class Forecast(FlowModel):
    """A current on time, latitude, longitude and perhaps depth, of a NetCDF file."""

    def __init__(self, path: Path, units: str | None) -> None:
        self.column = column = read_currents(path, column=True, units=units)
        self.source, levels = column.source, len(column.depth)
        about = f"gridded, averaged over a dive's depth, {levels} levels"
        if levels == 1:
            where = "surface" if column.depth[0] < 1 else f"{column.depth[0]:g} m deep"
            where = "of unknown depth" if np.isnan(column.depth[0]) else where
            about = f"gridded, one level only ({where}), not what a glider feels over its depths"
        if column.land:
            about += f"; {column.land} cells of nothing but zeros are taken as land"
        self.about = about
        self.fastest = float(np.sqrt(np.nanmax(column.u**2 + column.v**2)))  # m/s, anywhere
        self.time = column.dates.astype(float) / 1e3  # s since 1970 UTC
        self.gaps = missing_steps(self.time) > 0
        self.lon, n = column.lon, len(column.lon)
        self.columns = np.arange(n)
        if self.lon[0] + 360.0 - self.lon[-1] < AROUND * np.median(np.diff(self.lon)):
            # around the Earth: a turn on either side
            turns, self.columns = np.divmod(np.arange(-n, 2 * n + 1), n)
            self.lon = column.lon[self.columns] + 360.0 * turns

    def along(self, dive: Dive) -> Flow:
        """Return the flow for one dive, averaged over its depths.

        `Uncovered` is raised where the dive begins outside the area, is not within the
        steps or reaches into a gap of them.
        """
        c, time = self.column, self.time
        if not self._inside(dive.lat_gps2, dive.lon_gps2):
            raise Uncovered(OUTSIDE)
        if not dive.t_gps2 >= time[0]:
            raise Uncovered("begins before the forecast's first step")
        if not dive.t_gpse <= time[-1]:
            raise Uncovered("ends after the forecast's last step")
        within = _bracket(time, dive.t_gps2, dive.t_gpse)
        if self.gaps[within.start : within.stop - 1].any():
            raise Uncovered("in a gap of the forecast's steps")
        plane = LocalPlane(dive.lat_gps2, dive.lon_gps2)
        steps, rows, across = self._reached(dive)
        start, columns = self._unwrapped(dive.lon_gps2), self.columns[across]
        deepest = dive.depth_max
        if deepest is None or not (isfinite(deepest) and deepest > 0):
            deepest = DEEPEST
        u, v = (depth_mean(c.depth, w[steps, :, rows, columns], deepest) for w in (c.u, c.v))
        look = RegularGridInterpolator(
            (time[steps] - dive.t_gps2, c.lat[rows], self.lon[across]),
            np.stack([u, v], axis=-1),
            bounds_error=False,
            fill_value=np.nan,
        )

        def flow(t: float, east: float, north: float) -> tuple[float, float]:
            lat, lon = map(float, plane.to_earth(east / 1000, north / 1000))
            eastward, northward = look([[t, lat, near(lon, start)]])[0]
            if not (isfinite(eastward) and isfinite(northward)):
                raise Uncovered("in a gap of the forecast" if self._inside(lat, lon) else OUTSIDE)
            u1, u2 = plane.rotate(lat, lon, eastward, northward)
            return float(u1), float(u2)

        return flow

    def _unwrapped(self, lon: float) -> float:
        """Return a longitude as the file counts, at or after its first."""
        return self.column.lon[0] + (lon - self.column.lon[0]) % 360.0

    def _inside(self, lat: float, lon: float) -> bool:
        c = self.column
        return bool(c.lat[0] <= lat <= c.lat[-1] and self._unwrapped(lon) <= self.lon[-1])

    def _reached(self, dive: Dive) -> tuple[slice, slice, slice]:
        """Return the steps, rows and columns that the dive can reach."""
        c = self.column
        track = (dive.dr_east, dive.dr_north) if dive.track is None else dive.track[1:]
        reach = float(np.max(np.hypot(*track))) + dive.duration * self.fastest
        high = reach / DEGREE
        wide = high / max(cos(radians(min(abs(dive.lat_gps2) + high, 89.9))), 1e-3)
        lat, lon = dive.lat_gps2, self._unwrapped(dive.lon_gps2)
        return (
            _bracket(self.time, dive.t_gps2, dive.t_gpse),
            _bracket(c.lat, lat - high, lat + high),
            _bracket(self.lon, lon - wide, lon + wide),
        )


def _bracket(axis: np.ndarray, low: float, high: float) -> slice:
    """Cut an axis to the span and one value on either side, two at least."""
    first = min(max(int(np.searchsorted(axis, low, "right")) - 1, 0), len(axis) - 2)
    last = max(int(np.searchsorted(axis, high, "left")), first + 1)
    return slice(first, last + 1)
