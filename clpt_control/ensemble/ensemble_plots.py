"""Plots of an ensemble: percentiles over time or cycles, and a sweep over the numbers that vary.

Of a scenario the percentiles are those of CLPE in each cycle and of what was learned, of a diagram
those of its outputs over time.  A diagram without trajectories has the rms of each output, one
number for each member, drawn over the numbers that vary:

    the one of most values   along x
    the second               in colours with a legend, or along y of a map where both have more
                             than 8 values
    the third                in panels side by side
    others                   held at their first value, which the title names

The colours of a map end at 2 and 98 % of the numbers, so that one member that diverged leaves the
others their colours.  Positive numbers of several sizes have logarithmic ones.

A number of more values than panels is not drawn apart: the title says so.
"""

import json
from typing import TYPE_CHECKING, Any

import numpy as np
import pandas

from ..base.arguments import check_holds, public
from ..base.figures import (
    BLUE,
    GREY,
    TITLE,
    axes_for,
    legend_above_data,
    line_style,
    literal,
)
from ..simulation.comparison import label_of, panels_for
from .ensemble_statistics import (
    ENSEMBLE,
    by_member,
    curves_of,
    is_of_diagram,
    percentiles_of,
    rms_of,
    summaries_of,
)

if TYPE_CHECKING:
    import xarray

MOST_COLOURS = 8
MOST_PANELS = 4
COLOURED = 0.02, 0.98  # quantiles at the ends of the colours
WIDE = 30.0  # largest number on linear colours, relative to the median


@public
def ensemble_plot(data: "xarray.Dataset", *, ax: Any = None) -> np.ndarray:
    """Draw percentiles of CLPE and of the parameter error, or of a diagram's outputs.

    Without trajectories, the rms of a diagram's outputs is drawn over the numbers that vary.

    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> data = clpt.run_ensemble(scenario, "learning.gain=0.2:2.0", 3)
    >>> clpe, error = ensemble_plot(data)
    """
    of_diagram = is_of_diagram(data)
    required = [] if of_diagram else ["clpe_rms"]
    check_holds("ensemble_plot: data", data, required, ENSEMBLE)
    data = by_member(data)
    curves = curves_of(data)
    if not curves:
        return _sweep_plot(data, ax)
    if of_diagram:
        axes = panels_for(ax, len(curves), f"data[{[*data.data_vars][-1:]}]")
    else:
        axes = axes_for(ax, 6.4, 3.0 * len(curves), nrows=len(curves))
    panels = np.ravel(axes)
    for panel, (label, values) in zip(panels, curves.items(), strict=True):
        x = values[values.dims[1]]
        _draw_bands(panel, x, percentiles_of(values))
        panel.set_ylabel(literal(label_of(label, values)))
        if panel is panels[-1] or not of_diagram:
            panel.set_xlabel(_axis_of(x))
    panels[0].set_title(_members(data), **TITLE)
    if panels[0].lines:
        legend_above_data(panels[0])
    return axes


def _axis_of(values: "xarray.DataArray") -> str:
    """Return name and unit of values, for an axis."""
    name = values.attrs.get("long_name", str(values.name))
    return literal(label_of(name, values))


def _members(data: "xarray.Dataset") -> str:
    return f"{data.sizes['member']:,} members".replace(",", " ")


def _draw_bands(ax: Any, x: "xarray.DataArray", bands: np.ndarray) -> None:
    """Draw percentiles over x, on a logarithmic axis if they are positive and not over time."""
    if not np.isfinite(bands).any():
        message = "no value in any run"
        ax.text(0.5, 0.5, message, ha="center", color=GREY, transform=ax.transAxes)
        ax.set_axis_off()
        return
    low, quarter, median, three_quarters, high = bands
    times, area = x.values, {"color": BLUE, "linewidth": 0}
    ax.fill_between(times, low, high, alpha=0.18, label="5 to 95 %", **area)
    ax.fill_between(
        times, quarter, three_quarters, alpha=0.35, label="25 to 75 %", **area
    )
    line = {"color": BLUE, "marker": "o" if len(times) < 12 else None}
    ax.plot(times, median, linewidth=1.5, markersize=4, label="median", **line)
    for edge in (low, high):
        ax.plot(times, edge, linewidth=0.6, linestyle="--", markersize=2, **line)
    if x.name != "time" and np.nanmin(bands) > 0:
        ax.set_yscale("log")
    if times.dtype.kind == "i":  # cycles
        ax.xaxis.get_major_locator().set_params(integer=True)


# --- sweeps --------------------------------------------------------------------------------------


def _sweep_plot(data: "xarray.Dataset", ax: Any) -> np.ndarray:
    """Draw the rms of each output over the numbers that vary."""
    shown = rms_of(data) or summaries_of(data)
    varied = _varied(data)
    rows = pandas.DataFrame(
        {name: one.values for name, one in (varied | shown).items()}
    )
    title = _members(data)
    counts = rows[[*varied]].nunique().sort_values(ascending=False, kind="stable")
    for name in counts.index[3:]:
        value = rows[name].iloc[0]
        rows = rows[rows[name] == value]
        title += f", {len(rows)} of them with {_equation(name, value)}"
    x, *others = counts.index[:3]
    is_map = bool(others) and counts[others[0]] > MOST_COLOURS
    columns = [("", rows)]
    if third := others[1:]:
        if counts[third[0]] > MOST_PANELS:
            title += f"; {third[0]} varies, too"
        else:
            groups = rows.groupby(third[0])
            columns = [(_equation(third[0], value), part) for value, part in groups]
    # axes: a row for each output, a column for each value of the third number
    shape = {"nrows": len(shown), "ncols": len(columns)}
    height = 1.2 + (2.4 if others else 1.3) * len(shown)
    axes = axes_for(
        ax, 4.4 + 2.0 * len(columns), height, **shape, sharex=True, sharey="row"
    )
    panels = np.reshape(axes, (len(shown), len(columns)))
    for (label, values), in_row in zip(shown.items(), panels, strict=True):
        name = literal(label_of(label, values))
        limits = {"norm": _colours_of(rows[label]), "cmap": "cividis"}
        for (_, part), panel in zip(columns, in_row, strict=True):
            if is_map:
                colours = _draw_map(panel, part, x, others[0], label, limits)
            else:
                _draw_lines(panel, part, x, label, others[:1])
        in_row[0].set_ylabel(_axis_of(varied[others[0]]) if is_map else name)
        if is_map:
            bar = {"ax": in_row.tolist(), "label": name, "extend": "both"}
            in_row[0].figure.colorbar(colours, **bar)
    for (equation, _), top, below in zip(columns, panels[0], panels[-1], strict=True):
        top.set_title(f"{title}\n{equation}".strip(), **TITLE)
        title = ""
        below.set_xlabel(_axis_of(varied[x]))
        # numbers below an axis need about 0.6 inches each
        inches = below.get_window_extent().width / below.figure.dpi
        below.locator_params(axis="x", nbins=max(1, int(inches / 0.6)))
    if others and not is_map:
        beside = {"loc": "upper left", "bbox_to_anchor": (1.0, 1.0)}
        panels[0, -1].legend(frameon=False, fontsize=8, **beside)
    return axes


def _colours_of(values: pandas.Series) -> Any:
    """Return a scale of colours, logarithmic for positive numbers of several sizes."""
    from matplotlib.colors import LogNorm, Normalize

    low, middle, high = values.quantile([COLOURED[0], 0.5, COLOURED[1]])
    is_wide = low > 0 and high > WIDE * middle
    return (LogNorm if is_wide else Normalize)(low, high)


def _draw_map(
    ax: Any, rows: pandas.DataFrame, x: str, y: str, label: str, limits: dict
) -> Any:
    """Draw cells in colours if each x has all y, or a square at each member."""
    cells = rows.groupby([y, x])[label].mean().unstack()
    if cells.size > len(rows):
        return ax.scatter(rows[x], rows[y], 16, rows[label], marker="s", **limits)
    ax.grid(visible=False)
    return ax.pcolormesh(cells.columns, cells.index, cells, **limits)


def _draw_lines(
    ax: Any, rows: pandas.DataFrame, x: str, y: str, coloured: list[str]
) -> None:
    """Draw dots, or a line in its colour for each value of another number."""
    if not coloured:
        ax.plot(rows[x], rows[y], ".", color=BLUE)
    for name in coloured:
        for k, (value, part) in enumerate(rows.sort_values(x).groupby(name)):
            label = _equation(name, value)
            ax.plot(part[x], part[y], marker=".", label=label, **line_style(k))


def _equation(name: str, value: Any) -> str:
    text = f"{value:.4g}" if isinstance(value, float) else value
    return literal(f"{name} = {text}")


def _varied(data: "xarray.Dataset") -> "dict[str, xarray.DataArray]":
    """Return the single numbers that vary, or the number of the member."""
    keys = json.loads(data.attrs["ensemble"])["keys"]
    single = {key: data[key] for key in keys if key in data and data[key].ndim == 1}
    return single or {"member": data["member"]}
