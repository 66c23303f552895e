"""Gridded currents that are the same everywhere."""

import numpy as np
import xarray


def uniform_field(path, u=0.1, v=0.1, half=10.0, end=50.0):
    """Write a current (m/s) on a square of 5 x 5 places about 0, from 0 s to the end."""
    place = np.linspace(-half, half, 5)
    field = xarray.Dataset(
        {
            name: (("time", "y", "x"), np.full((2, 5, 5), speed), {"units": "m s-1"})
            for name, speed in (("u", u), ("v", v))
        },
        {"time": ("time", [0.0, end], {"units": "s"})}
        | {name: (name, place, {"units": "m"}) for name in "xy"},
    )
    field.to_netcdf(path)
    return field
