"""A gridded forecast as a flow model: what a glider feels of a water column.

A dive samples the column down to its greatest depth D, so the flow is averaged
over it, by trapezoids through the levels that have data,

    F = (1 / D) int_0^D u dz,    u linear between levels, constant above the first,

as far down as there are data; D is `Dive.depth_max`, or 1000 m where it is not
known.  D is the one number of a dive that is read though it is measured during the
dive: a pilot knows the depth that was planned, which it stands for.

F is linear between latitudes, longitudes and times, and nowhere extrapolated:
outside the area, before the first step, after the last, where a corner of the cell
has no data and in a gap of the steps there is no model.  A gap is an interval that
is longer than 2.5 times the median of the two before it and the two after it, so
that steps may become coarser further ahead, as forecasts have them.
"""

from dataclasses import dataclass
from functools import cached_property
from math import cos, isfinite, radians
from pathlib import Path

import numpy as np

from ..currents.grid_file import DEEPEST, Currents, read_currents
from ..currents.plane import LocalPlane
from ..gliders.dives import Dive
from ..units import seconds_since_1970
from .flow_models import Flow, FlowModel, Uncovered

DEGREE = 110500.0  # m; no degree of latitude is shorter
GAP = 2.5  # times the intervals around one: beyond, steps are missing


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
        if not use.any():
            continue
        end = min(z, deepest)
        with np.errstate(invalid="ignore", divide="ignore"):
            slope = np.where(first | (z == last), 0.0, (value - above) / (z - last))
        top = np.where(first, value, above)
        thick = end - last
        total = np.where(use, total + thick * (top + slope * thick / 2), total)
        above, last = np.where(use, value, above), np.where(use, end, last)
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.where(last > 0, total / last, above)


def gaps_of(time: np.ndarray) -> np.ndarray:
    """Return which intervals between increasing steps are gaps.

    They are longer than 2.5 times the median of the two before and the two after them.

    >>> gaps_of(np.array([0.0, 6.0, 12.0, 78.0, 84.0])).tolist()
    [False, False, True, False]
    >>> gaps_of(np.array([0.0, 1.0, 2.0, 5.0, 8.0, 11.0])).tolist()
    [False, False, False, False, False]
    """
    steps = np.diff(time)
    gaps = np.zeros(len(steps), bool)
    for k, step in enumerate(steps):
        around = np.concatenate([steps[max(k - 2, 0) : k], steps[k + 1 : k + 3]])
        gaps[k] = around.size > 0 and step > GAP * np.median(around)
    return gaps


@dataclass(frozen=True)
class Forecast(FlowModel):
    """A gridded current, read by `read_currents`, that carries dead reckoning."""

    column: Currents
    source: str
    about: str

    @cached_property
    def fastest(self) -> float:
        """Greatest speed anywhere in the file, m/s."""
        return float(np.sqrt(np.nanmax(self.column.u**2 + self.column.v**2)))

    @cached_property
    def time(self) -> np.ndarray:
        """Steps, s since 1970 UTC, shape (nt,)."""
        return seconds_since_1970(self.column.start) + 3600.0 * self.column.time

    @cached_property
    def gaps(self) -> np.ndarray:
        """Which intervals of the steps are gaps, shape (nt - 1,)."""
        return gaps_of(self.time)

    def along(self, dive: Dive) -> Flow:
        """Return the flow for one dive, averaged over its depths.

        `Uncovered` is raised where the dive begins outside the area, is not within the
        steps or reaches into a gap of them.
        """
        from scipy.interpolate import RegularGridInterpolator

        c, time = self.column, self.time
        if not self._inside(dive.lat_gps2, dive.lon_gps2):
            raise Uncovered("outside the forecast's area")
        if not dive.t_gps2 >= time[0]:
            raise Uncovered("begins before the forecast's first step")
        if not dive.t_gpse <= time[-1]:
            raise Uncovered("ends after the forecast's last step")
        within = _bracket(time, dive.t_gps2, dive.t_gpse)
        if self.gaps[within.start : within.stop - 1].any():
            raise Uncovered("in a gap of the forecast's steps")
        plane = LocalPlane(dive.lat_gps2, dive.lon_gps2)
        steps, rows, columns = self._reached(dive)
        deepest = dive.depth_max
        if deepest is None or not (isfinite(deepest) and deepest > 0):
            deepest = DEEPEST
        u, v = (depth_mean(c.depth, w[steps, :, rows, columns], deepest) for w in (c.u, c.v))
        look = RegularGridInterpolator(
            (time[steps] - dive.t_gps2, c.lat[rows], c.lon[columns]),
            np.stack([u, v], axis=-1),
            bounds_error=False,
            fill_value=np.nan,
        )

        def flow(t: float, east: float, north: float) -> tuple[float, float]:
            lat, lon = map(float, plane.to_earth(east / 1000, north / 1000))
            eastward, northward = look([[t, lat, self._unwrapped(lon)]])[0]
            if not (isfinite(eastward) and isfinite(northward)):
                raise Uncovered(
                    "in a gap of the forecast"
                    if self._inside(lat, lon)
                    else "outside the forecast's area"
                )
            u1, u2 = plane.turn(lat, lon, eastward, northward)
            return float(u1), float(u2)

        return flow

    def _unwrapped(self, lon: float) -> float:
        """Return a longitude as the file counts, at or after its first."""
        return self.column.lon[0] + (lon - self.column.lon[0]) % 360.0

    def _inside(self, lat: float, lon: float) -> bool:
        c = self.column
        return bool(c.lat[0] <= lat <= c.lat[-1] and self._unwrapped(lon) <= c.lon[-1])

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
            _bracket(c.lon, lon - wide, lon + wide),
        )


def read_forecast(path: str | Path, units: str | None = None) -> Forecast:
    """Read a NetCDF of a current on time, latitude, longitude and perhaps depth."""
    column = read_currents(path, column=True, units=units)
    about = f"gridded, averaged over a dive's depth, {len(column.depth)} levels"
    if len(column.depth) == 1:
        where = "surface" if column.depth[0] < 1 else f"{column.depth[0]:g} m deep"
        about = f"gridded, one level only ({where}), not what a glider feels over its depths"
    return Forecast(column, column.source, about)


def _bracket(axis: np.ndarray, low: float, high: float) -> slice:
    """Cut an axis to the span and one value on either side, two at least."""
    first = min(max(int(np.searchsorted(axis, low, "right")) - 1, 0), len(axis) - 2)
    last = max(int(np.searchsorted(axis, high, "left")), first + 1)
    return slice(first, last + 1)
