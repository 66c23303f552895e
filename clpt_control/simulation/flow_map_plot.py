"""Chart of the learned flow of a run or of an estimate, as `flow_map` computes it.

Arrows are the learned flow and, where known, the true flow, both on one scale.  The shade is the
standard error of an estimate, or the error of a run whose true flow is known.
"""

from typing import TYPE_CHECKING

import numpy as np

from ..base.arguments import public
from ..base.figures import BLUE, GREY, ORANGE, TITLE, axes_for, legend_below
from .flow_map import learned_flow, map_of

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

BETWEEN = 4  # points of the map from arrow to arrow
SHADES = "standard_error", "error"


@public
def flow_map_plot(source: "xarray.Dataset", *, ax: "Axes | None" = None) -> "Axes":
    """Draw the learned flow at the end, its error and the track.

    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> ax = flow_map_plot(clpt.simulate(scenario))
    """
    learned = learned_flow(source)
    ax = axes_for(ax, 6.4, 5.2)
    flow = map_of(learned).isel(time=0)
    y, x = (flow[name] for name in flow.u.dims)
    track = learned.track.T
    if learned.plane is not None:
        track = learned.plane.to_earth(*track)[::-1]
    for name in SHADES:
        if name in flow:
            shade = ax.pcolormesh(x, y, flow[name], cmap="Purples", vmin=0.0, alpha=0.4)
            words = f"{flow[name].long_name} ({learned.unit})"
            ax.figure.colorbar(shade, ax=ax, label=words, shrink=0.7)
    ax.plot(*track, color=BLUE, linewidth=0.9, label="track")
    _draw_arrows(ax, flow.isel(dict.fromkeys(flow.u.dims, slice(0, None, BETWEEN))))
    if learned.is_geographic:
        ax.set(xlabel="longitude (degrees east)", ylabel="latitude (degrees north)")
        ax.set_aspect(1 / np.cos(np.radians(float(y.mean()))))
    else:
        unit = x.units
        ax.set(xlabel=f"$x_1$, east ({unit})", ylabel=f"$x_2$, north ({unit})")
        ax.set_aspect("equal")
    ax.set_title("Learned flow at the end", **TITLE)
    legend_below(ax, 3)
    return ax


def _draw_arrows(ax: "Axes", flow: "xarray.Dataset") -> None:
    """Draw the true flow, if the map has it, and the learned flow on one scale."""
    y, x = (flow[name] for name in flow.u.dims)
    kinds = {"true_": ("true flow", GREY, 0.006), "": ("learned flow", ORANGE, 0.003)}
    drawn = {prefix: row for prefix, row in kinds.items() if prefix + "u" in flow}
    speeds = [np.hypot(flow[f"{prefix}u"], flow[f"{prefix}v"]) for prefix in drawn]
    fastest = float(f"{np.nanmax(speeds):.1g}") or 1.0
    for prefix, (label, color, width) in drawn.items():
        velocity = flow[f"{prefix}u"], flow[f"{prefix}v"]
        style = {"color": color, "width": width, "label": label, "zorder": 3}
        arrows = ax.quiver(x, y, *velocity, scale=9 * fastest, **style)
    text = f"{fastest:g} {flow.u.units}"
    ax.quiverkey(arrows, 0.85, 1.03, fastest, text, labelpos="E")
