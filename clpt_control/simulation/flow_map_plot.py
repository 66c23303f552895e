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
SHADES = {"standard_error", "error"}
ARROWS = (  # prefix of the map's names, label, colour, width; the wide ones below
    ("true_", "true flow", GREY, 0.006),
    ("", "learned flow", ORANGE, 0.003),
)


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
    easting, northing = learned.track.T
    if learned.plane is not None:
        northing, easting = learned.plane.to_earth(easting, northing)
    for name in SHADES & flow.keys():
        shade = flow[name].plot.pcolormesh
        shade(ax=ax, cmap="Purples", vmin=0, alpha=0.4, cbar_kwargs={"shrink": 0.7})
    ax.plot(easting, northing, color=BLUE, linewidth=0.9, label="track")
    arrows = flow.isel(dict.fromkeys(flow.u.dims, slice(0, None, BETWEEN)))
    fastest = float(f"{np.hypot(flow.u, flow.v).max():.1g}") or 1.0
    for prefix, label, color, width in ARROWS:
        if f"{prefix}u" in flow:
            names = (x.name, y.name, f"{prefix}u", f"{prefix}v")
            drawn = ax.quiver(
                *(arrows[name] for name in names),
                scale=9 * fastest,
                label=label,
                color=color,
                width=width,
                zorder=3,
            )
    ax.quiverkey(drawn, 0.8, 1.03, fastest, f"{fastest:g} {learned.unit}", labelpos="E")
    ax.set(xlabel=f"{x.name} ({x.units})", ylabel=f"{y.name} ({y.units})", title="")
    ax.set_aspect(1 / np.cos(np.radians(y.mean())) if learned.is_geographic else 1.0)
    ax.ticklabel_format(style="plain", useOffset=False)
    ax.locator_params(nbins=4)
    ax.set_title("Learned flow at the end", **TITLE)
    legend_below(ax, 3)
    return ax
