"""Read a gridded current: CF names or u/v, units from attributes, gaps kept.

The answer is always the same: one surface level, latitudes and longitudes
increasing, hours since the first step, u (east) and v (north) in m/s, NaN where
either was not measured.

`valid_min` and `valid_max` are not used: files disagree on whether they are in
packed or unpacked values (MARACOOS writes -300 cm/s beside a scale factor of
0.01, which read by the letter of CF would throw most of the data away).  A
speed that no sea has is refused instead.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..errors import DataError
from ..files import open_netcdf
from .cf import VELOCITY, check_speed, find_axis, find_variable, surface_values
from .cf_time import hours_since_first


@dataclass(frozen=True)
class Currents:
    """A measured current on latitudes and longitudes.

    Attributes
    ----------
    lat : ndarray, shape (ny,)
        Latitudes, degrees north, increasing.
    lon : ndarray, shape (nx,)
        Longitudes, degrees east, increasing; may pass 180.
    time : ndarray, shape (nt,)
        Hours since the first step, increasing.
    start : str
        The first step, ISO 8601, as the file counts it (UTC unless it says).
    u, v : ndarray, shape (nt, ny, nx)
        Flow to the east and to the north, m/s; NaN in both where either is
        missing.
    box : tuple of float
        lat0, lat1, lon0, lon1 that were asked for, degrees.
    source : str
        Name of the file.
    """

    lat: np.ndarray
    lon: np.ndarray
    time: np.ndarray
    start: str
    u: np.ndarray
    v: np.ndarray
    box: tuple[float, float, float, float]
    source: str

    @property
    def measured(self) -> np.ndarray:
        """Where the current was measured, shape (nt, ny, nx), boolean."""
        return np.isfinite(self.u)


def read_currents(
    path: str | Path, box: tuple[float, float, float, float] | None = None
) -> Currents:
    """Read a gridded current from a NetCDF file.

    Parameters
    ----------
    path : str or Path
        A NetCDF file with dims time, latitude, longitude in any order, and
        perhaps a depth, of which the level nearest the surface is taken.
    box : tuple of float, optional
        lat0, lat1, lon0, lon1 in degrees; cells whose centre is inside are
        kept. Without it, the whole file.

    Returns
    -------
    Currents
        In m/s and hours, gaps as NaN.

    Raises
    ------
    DataError
        If the file, a variable, a unit, or data in the box are missing; one
        sentence naming file, variable and what is allowed.
    """
    path = Path(path)
    with open_netcdf(path) as data:
        east = find_variable(data, VELOCITY, "eastward", path)
        north = find_variable(data, VELOCITY, "northward", path)
        lat = find_axis(data, east, "latitude", path)
        lon = find_axis(data, east, "longitude", path)
        when = find_axis(data, east, "time", path)
        hours, start = hours_since_first(when, path)
        for axis in (lat, lon):
            if not np.all(np.isfinite(axis.values)):
                raise DataError(f"{path}: {axis.name} has values that are not finite")
        latitudes, longitudes = lat.values.astype(float), lon.values.astype(float)
        wanted = _checked_box(box, latitudes, longitudes, path)
        middle = wanted[2] + 0.5 * (wanted[3] - wanted[2])
        longitudes = middle + (longitudes - middle + 180.0) % 360.0 - 180.0
        if box is None:
            wanted = (*np.sort(latitudes)[[0, -1]], *np.sort(longitudes)[[0, -1]])
        kept = {
            when.dims[0]: np.argsort(hours),
            lat.dims[0]: _inside(latitudes, wanted[:2], "latitude", path),
            lon.dims[0]: _inside(longitudes, wanted[2:], "longitude", path),
        }
        times, rows, columns = kept.values()
        if not np.all(np.diff(hours[times]) > 0):
            raise DataError(f"{path}: {when.name} has a step twice; keep each time once")
        u, v = (surface_values(data, name, kept, path) for name in (east, north))
    gap = ~(np.isfinite(u) & np.isfinite(v))
    if gap.all():
        raise DataError(
            f"{path}: {east} and {north} have no finite value in the box {_shown(wanted)}; "
            "choose a box where the current was measured"
        )
    u, v = np.where(gap, np.nan, u), np.where(gap, np.nan, v)
    for name, values in ((east, u), (north, v)):
        check_speed(values, name, path)
    axes = (latitudes[rows], longitudes[columns], hours[times])
    box_used = (float(wanted[0]), float(wanted[1]), float(wanted[2]), float(wanted[3]))
    return Currents(*axes, start, u, v, box_used, path.name)


def _checked_box(box: Any, lat: np.ndarray, lon: np.ndarray, path: Path) -> tuple:
    """Return lat0, lat1, lon0, lon1 with lon1 > lon0, also across 180 degrees."""
    if box is None:
        return float(lat.min()), float(lat.max()), float(lon.min()), float(lon.max())
    if len(box) != 4 or not np.all(np.isfinite(box)):
        raise DataError(f"box = {tuple(box)}: must be 4 finite numbers, LAT0 LAT1 LON0 LON1")
    lat0, lat1, lon0, lon1 = map(float, box)
    width = (lon1 - lon0) % 360.0
    if not -90 <= lat0 < lat1 <= 90 or not 0 < width <= 180:
        raise DataError(
            f"box = {_shown(box)}: must be LAT0 LAT1 LON0 LON1 in degrees, south before north "
            "and west before east, at most 180 degrees wide"
        )
    return lat0, lat1, lon0, lon0 + width


def _inside(axis: np.ndarray, span: tuple, what: str, path: Path) -> np.ndarray:
    """Return the indices of the axis inside the span, in increasing order."""
    slack = 1e-9
    order = np.argsort(axis)
    kept = order[(axis[order] >= span[0] - slack) & (axis[order] <= span[1] + slack)]
    if len(kept) < 2:
        raise DataError(
            f"{path}: the box's {what} {span[0]:g} to {span[1]:g} holds {len(kept)} cells; at "
            f"least 2 are needed, the file covers {axis.min():.6g} to {axis.max():.6g}"
        )
    if not np.all(np.diff(axis[kept]) > 0):
        raise DataError(f"{path}: {what} has a value twice; keep each cell once")
    return kept


def _shown(box: Any) -> str:
    return " ".join(f"{value:g}" for value in box)
