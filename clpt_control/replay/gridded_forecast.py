"""A gridded forecast as a flow model (`carried_dives`): what a glider feels of its water column.

A dive samples the column down to its greatest depth D, so the flow is averaged over it, by
trapezoids through the levels that have data,

    F = (1 / D) int_0^D u dz,    u linear between levels, constant above the first,

as far down as there are data; D is `Dive.depth_max`, or 1000 m where it is not
known.  D is the one number of a dive that is read though it is measured during the
dive: a pilot knows the depth that was planned, which it stands for.

u is linear between latitudes, longitudes and times, and nowhere extrapolated:
outside the area, before the first step, after the last, where a corner of the cell
has no data and in a gap of the steps (`missing_steps`) there is no model.
"""

from math import isfinite
from pathlib import Path

import numpy as np
from scipy.integrate import trapezoid
from scipy.interpolate import RegularGridInterpolator

from ..currents.grid_file import DEEPEST, missing_steps, read_currents
from ..currents.plane import LocalPlane
from ..gliders.dives import Dive
from ..units import seconds_since_1970
from .carried_dives import Flow, FlowModel, Uncovered

OUTSIDE = "outside the forecast's area"


def depth_mean(depth: np.ndarray, profile: np.ndarray, deepest: float) -> complex:
    """Average a profile, u + iv at levels, from the surface to a depth, m.

    The mean ends at the deepest level with data, if that is higher, and is NaN where no
    level above the end has any.  Levels `depth`, m, increase from the surface.

    >>> depth_mean(np.array([0.0, 100.0, 400.0]), np.array([0.4, 0.3, 0.0]), 200.0).real.round(9)
    np.float64(0.3)
    """
    known = np.isfinite(profile)
    z, u = depth[known], profile[known]
    if not z.size or z[0] > max(deepest, depth[0]):
        return complex(np.nan)
    end = min(deepest, z[-1])
    if not end > 0:
        return complex(u[0])
    levels = np.array([0.0, *z[(z > 0) & (z < end)], end])
    return complex(trapezoid(np.interp(levels, z, u), levels) / end)


class Forecast(FlowModel):
    """A current on time, latitude, longitude and perhaps depth, of a NetCDF file."""

    def __init__(self, path: Path, units: str | None) -> None:
        column = read_currents(path, column=True, units=units)
        self.source, levels = column.source, len(column.depth)
        about = f"gridded, averaged over a dive's depth, {levels} levels"
        if levels == 1:
            where = "surface" if column.depth[0] < 1 else f"{column.depth[0]:g} m deep"
            where = "of unknown depth" if np.isnan(column.depth[0]) else where
            about = f"gridded, one level only ({where}), not what a glider feels over its depths"
        if column.land:
            about += f"; {column.land} cells of nothing but zeros are taken as land"
        self.about, self.depth = about, column.depth
        self.time = seconds_since_1970(column.start) + 3600.0 * column.time  # s since 1970 UTC
        self.gaps = missing_steps(self.time) > 0
        self.lat, self.lon = column.lat, column.lon
        self.flow = RegularGridInterpolator(
            (self.time, self.lat, self.lon),
            np.moveaxis(column.u + 1j * column.v, 1, -1),
            bounds_error=False,
            fill_value=np.nan,
        )

    def along(self, dive: Dive) -> Flow:
        """Return the flow for one dive, averaged over its depths.

        `Uncovered` is raised where the dive begins outside the area, is not within the
        steps or reaches into a gap of them.
        """
        time = self.time
        if not self._inside(dive.lat_gps2, dive.lon_gps2):
            raise Uncovered(OUTSIDE)
        if not dive.t_gps2 >= time[0]:
            raise Uncovered("begins before the forecast's first step")
        if not dive.t_gpse <= time[-1]:
            raise Uncovered("ends after the forecast's last step")
        ends = zip(time[:-1], time[1:], self.gaps, strict=True)
        if any(gap and a < dive.t_gpse and dive.t_gps2 < b for a, b, gap in ends):
            raise Uncovered("in a gap of the forecast's steps")
        plane = LocalPlane(dive.lat_gps2, dive.lon_gps2)
        deepest = dive.depth_max
        if deepest is None or not (isfinite(deepest) and deepest > 0):
            deepest = DEEPEST

        def flow(t: float, east: float, north: float) -> tuple[float, float]:
            lat, lon = map(float, plane.to_earth(east / 1000, north / 1000))
            (profile,) = self.flow([[dive.t_gps2 + t, lat, self._unwrapped(lon)]])
            mean = depth_mean(self.depth, profile, deepest)
            if not np.isfinite(mean):
                raise Uncovered("in a gap of the forecast" if self._inside(lat, lon) else OUTSIDE)
            u1, u2 = plane.rotate(lat, lon, mean.real, mean.imag)
            return float(u1), float(u2)

        return flow

    def _unwrapped(self, lon: float) -> float:
        """Return a longitude as the file counts, at or after its first."""
        return float(self.lon[0] + (lon - self.lon[0]) % 360.0)

    def _inside(self, lat: float, lon: float) -> bool:
        return bool(self.lat[0] <= lat <= self.lat[-1] and self._unwrapped(lon) <= self.lon[-1])
