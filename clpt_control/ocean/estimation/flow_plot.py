"""Figure of a flow learned from fixes: track, forecasts, position errors and learned flow."""

from typing import Any

import numpy as np
import xarray

from ...base.figures import BLUE, GREY, ORANGE, TITLE, axes_for, legend_below
from ...base.figures.degree_axes import degree_axes
from ...base.geodesy import LocalPlane
from .learned_fix import PERCENT

MANY = 40  # legs; beyond, marks are small


def learned_flow_plot(data: xarray.Dataset, *, ax: Any = None) -> np.ndarray:
    """Draw fixes, forecasts and learned flow on a map, and the error of each forecast.

    `data` is that of `flow_estimate` for legs.
    """
    chart, errors = axes_for(ax, 6.8, 8.0, nrows=2, height_ratios=(3, 1.3))
    latitude, longitude = data.attrs["origin"]
    plane = LocalPlane(latitude, longitude, "km")
    x, y = plane.to_plane(data.latitude.values, data.longitude.values)
    px, py = plane.to_plane(
        data.predicted_latitude.values, data.predicted_longitude.values
    )
    size = 3 if len(x) > MANY else 5
    chart.plot(x, y, "-", color=GREY, lw=0.6, alpha=0.3)
    chart.plot(x, y, "o", color=BLUE, ms=size, label="fix")
    chart.plot(px, py, "x", color=ORANGE, ms=size + 1, label="forecast of it")
    flow = data.flow.values
    arrows = chart.quiver(
        *(x, y, flow[:, 0], flow[:, 1]),
        color="black",
        width=0.003,
        angles="xy",
        label="learned flow",
    )
    fastest = float(f"{np.hypot(*flow.T).max():.1g}") or 0.1
    chart.quiverkey(arrows, 0.86, 1.03, fastest, f"{fastest:g} m/s", labelpos="E")
    chart.set_aspect("equal", adjustable="datalim")
    chart.margins(0.12)
    degree_axes(chart, plane, "km")
    chart.set_title("Flow learned from fixes", **TITLE)
    legend_below(chart, 3)
    numbers = np.arange(1, len(x) + 1)
    error = np.hypot(*data.position_error.values.T) / 1000
    errors.fill_between(
        *(numbers, 0, data.forecast_radius.values / 1000),
        color=GREY,
        alpha=0.3,
        lw=0,
        label=f"{PERCENT} region of the forecast",
    )
    errors.plot(
        numbers, error, "o-", color=BLUE, ms=size, label="error before learning"
    )
    errors.set(xlabel="leg", ylabel="position error (km)", ylim=(0, None))
    errors.set_ylim(0, 1.15 * max(float(error.max()), 1e-3))
    legend_below(errors, 2)
    return np.array([chart, errors])
