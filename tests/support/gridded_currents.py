"""Gridded currents as datasets, which a test changes and writes by `to_netcdf`."""

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


def gridded_current(
    u, v, lat, lon, hours, *, since="2019-01-01", units="m/s", depth=None
):
    """Return a current, shapes (time, [depth,] lat, lon), as models and radars have it."""
    axes = {
        "time": (hours, f"hours since {since}"),
        "depth": (depth, "m"),
        "lat": (lat, "degrees_north"),
        "lon": (lon, "degrees_east"),
    }
    axes = {
        name: (name, values, {"units": unit})
        for name, (values, unit) in axes.items()
        if values is not None
    }
    flow = {
        name: (tuple(axes), values, {"units": units})
        for name, values in (("u", u), ("v", v))
    }
    return xarray.Dataset(flow, axes)


def as_it_is(data):
    return data


def saying(names, **attributes):
    """A change of what variables say of themselves; None takes it away."""

    def change(data):
        for name in names.split():
            said = data[name].attrs | attributes
            data[name].attrs = {
                key: value for key, value in said.items() if value is not None
            }
        return data

    return change
