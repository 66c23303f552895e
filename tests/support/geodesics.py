"""Geodesics on the WGS84 ellipsoid by pyproj, as (east, north) of the first place, m."""

import math

from pyproj import Geod

WGS84 = Geod(ellps="WGS84")


def place_from(lat, lon, east, north):
    """Return the place (latitude, longitude) at a displacement from another."""
    azimuth = math.degrees(math.atan2(east, north))
    lon, lat, _ = WGS84.fwd(lon, lat, azimuth, math.hypot(east, north))
    return lat, lon


def displacement(lat1, lon1, lat2, lon2):
    """Return the displacement between two places."""
    azimuth, _, length = WGS84.inv(lon1, lat1, lon2, lat2)
    azimuth = math.radians(azimuth)
    return length * math.sin(azimuth), length * math.cos(azimuth)
