"""Gridded currents as datasets, which a test changes and writes by `to_netcdf`."""

import numpy as np
import xarray

import clpt_control as clpt


def plane_field(path, time, y, x, u, v, length="m", hour="s"):
    """Write a current, shapes (time, y, x), on a plane, with units of length and time."""
    flow = {
        name: (("time", "y", "x"), values, {"units": f"{length} {hour}-1"})
        for name, values in (("u", u), ("v", v))
    }
    axes = {"time": ("time", time, {"units": hour})}
    axes |= {name: (name, at, {"units": length}) for name, at in (("y", y), ("x", x))}
    field = xarray.Dataset(flow, axes)
    field.to_netcdf(path)
    return field


def uniform_field(path, u=0.1, v=0.1, half=10.0, end=50.0):
    """Write a current (m/s) on a square of 5 x 5 places about 0, from 0 s to the end."""
    place = np.linspace(-half, half, 5)
    flow = (np.full((2, 5, 5), speed) for speed in (u, v))
    return plane_field(path, [0.0, end], place, place, *flow)


def field_blocks(path, outside="raise", length="m", hour="s"):
    """Return the true flow of a field's file, and the vehicle, of the paper's loop."""
    flow = {"field": str(path), "outside": outside}
    units = {"length": length, "time": hour}
    scenario = clpt.paper_scenario().with_values({"flow": flow, "units": units})
    blocks = {block.name: block for block in clpt.paper_blocks(scenario)}
    return blocks["true_flow"], blocks["vehicle"]


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
