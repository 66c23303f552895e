"""Currents that are known, as formulas and on grids, and dives whose end is not."""

import math
from dataclasses import replace
from datetime import UTC, datetime

import numpy as np
from made_fields import as_it_is, gridded_current
from pyproj import Geod

from clpt_control.gliders.dives import make_dive
from clpt_control.replay.carried_dives import FlowModel, carried

START = datetime(2020, 6, 1, tzinfo=UTC).timestamp()
LAT, LON = np.linspace(40.5, 41.5, 21), np.linspace(-70.0, -68.5, 31)
HOURS = np.arange(0.0, 49.0, 0.25)
W = 2 * math.pi / (12.42 * 3600)  # rad/s


class Made(FlowModel):
    """A flow given as a formula."""

    source, about = "made", "a formula"

    def __init__(self, flow):
        self.flow = flow

    def along(self, dive):
        return self.flow


def dive_at(hour=3.0, hours=6.0, way=(4000.0, 2500.0), lat=41.0, lon=-69.3, **more):
    """A dive whose end fix is not a number: nothing may read it."""
    t = START + 3600 * hour
    dive = make_dive(1, (t, lat, lon), (t + 3600 * hours, lat, lon), way, **more)
    nan = math.nan
    return replace(dive, lat_gpse=nan, lon_gpse=nan, gps_east=nan, gps_north=nan)


def ended(dive, east, north):
    """The same dive, surfaced where a flow took it."""
    east, north = dive.dr_east + east, dive.dr_north + north
    angle = math.degrees(math.atan2(east, north))
    lon, lat, _ = Geod(ellps="WGS84").fwd(
        dive.lon_gps2, dive.lat_gps2, angle, math.hypot(east, north)
    )
    return replace(dive, lat_gpse=lat, lon_gpse=lon, gps_east=east, gps_north=north)


def write(path, u, v, lat=LAT, lon=LON, hours=HOURS, depth=None, change=as_it_is):
    """Write a current, shapes (time, [depth,] lat, lon), m/s."""
    made = gridded_current(u, v, lat, lon, hours, since="2020-06-01", depth=depth)
    change(made).to_netcdf(path)
    return path


def turning(hours, shape, speed=0.3):
    """A current that is the same everywhere and turns with M2."""
    angle = W * 3600 * hours.reshape(-1, *(1 for _ in shape))
    return (np.broadcast_to(speed * f(angle), (len(hours), *shape)) for f in (np.cos, np.sin))


def turned(dive, speed=0.3):
    """Its way over a dive, integrated by hand, m."""
    a, b = W * (dive.t_gps2 - START), W * (dive.t_gpse - START)
    return speed / W * np.array([math.sin(b) - math.sin(a), math.cos(a) - math.cos(b)])


def model_way(dive, model):
    found = carried(dive, model)
    assert found.uncovered is None
    return np.array([found.model_east, found.model_north])
