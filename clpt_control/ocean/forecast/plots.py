"""Figures of a replay with one dive at least: misses, learned current, and all with the map."""

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.dates import AutoDateLocator, ConciseDateFormatter

from ...base.arguments import public
from ...base.figures import BLUE, GREEN, GREY, ORANGE, TITLE, axes_for, legend_below
from .netcdf_export import Source, report_of
from .replay_summary import rms_of
from .table_rows import Row
from .track_map import map_plot

LINES = {
    "no_flow": (GREY, "s", ":"),
    "previous_dive": (ORANGE, "^", "--"),
    "adaptive": (BLUE, "o", "-"),
    "flow_model": (GREEN, "D", "-."),
}
MANY = 40  # dives; beyond, marks are small
MARKS = 100  # of a line, about, at most


@public
def dive_clpe_plot(replay: Source, *, ax: Axes | None = None) -> Axes:
    """Draw the CLPE of each dive for each flow model.

    >>> import clpt_control as clpt
    >>> replay = clpt.replay.replay_dives(clpt.gliders.sample_dives())
    >>> ax = dive_clpe_plot(replay)
    """
    rows = report_of(replay)["each_dive"]
    ax = axes_for(ax, 6.8, 4.0)
    x = _surfaced(rows)
    clpe = [row["clpe"] for row in rows]
    for model, rms in rms_of(clpe[1:], list(clpe[0])).items():
        colour, mark, style = LINES[model]
        size = _column(clpe, model) / 1000
        label = model.replace("_", " ") + (
            "" if rms is None else f", rms {rms / 1000:.2f} km"
        )
        ax.plot(x, size, mark, ls=style, color=colour, label=label, **_fine(x))
    ax.set(ylabel="position error (CLPE) (km)", ylim=(0, None))
    mark_dates(ax, x)
    ax.set_title("Prediction error, one dive ahead; rms after the first", **TITLE)
    legend_below(ax, 3)
    return ax


@public
def current_plot(replay: Source, *, ax: Any = None) -> np.ndarray:
    """Draw the learned current of each dive, and the speed factor.

    >>> import clpt_control as clpt
    >>> replay = clpt.replay.replay_dives(clpt.gliders.sample_dives())
    >>> east, north, speed = current_plot(replay)
    """
    rows = report_of(replay)["each_dive"]
    learned = rows[0]["speed_factor"] is not None
    axes = axes_for(ax, 6.8, 6.4 if learned else 4.6, nrows=2 + learned, sharex=True)
    x = _surfaced(rows)
    for axes_of_component, axis in zip(axes, ("east", "north"), strict=False):
        label = "learned current, 2 standard errors"
        _band(axes_of_component, x, rows, f"current_{axis}", BLUE, label)
        of_file = _column(rows, f"file_current_{axis}")
        if np.isfinite(of_file).any():
            axes_of_component.plot(
                x, of_file, "--^", color=ORANGE, label="the file's own", **_fine(x)
            )
        axes_of_component.axhline(0, color="black", lw=0.5)
        axes_of_component.set_ylabel(f"{axis} (m/s)")
    axes[0].legend(
        fontsize=8, frameon=False, ncols=2, loc="lower left", bbox_to_anchor=(0, 1)
    )
    if learned:
        _band(axes[2], x, rows, "speed_factor", GREEN)
        axes[2].axhline(1, color="black", lw=0.5)
        axes[2].set_ylabel("factor on speed")
    mark_dates(axes[-1], x)
    return axes


@public
def replay_plot(replay: Source, *, ax: Any = None) -> np.ndarray:
    """Draw a replay's map, CLPE and learned current in one figure.

    >>> import clpt_control as clpt
    >>> replay = clpt.replay.replay_dives(clpt.gliders.sample_dives())
    >>> axes = replay_plot(replay)
    """
    replay = report_of(replay)
    learned = replay["each_dive"][0]["speed_factor"] is not None
    speed = [["map", "speed"]] if learned else []
    mosaic = [
        ["map", "clpe"],
        ["map", "clpe"],
        ["map", "east"],
        ["map", "north"],
        *speed,
    ]
    axes = axes_for(ax, 12.0, 9.5, mosaic=mosaic)
    for panel in axes[2:-1]:  # one axis of time below
        panel.tick_params(labelbottom=False)
    map_plot(replay, ax=axes[0])
    dive_clpe_plot(replay, ax=axes[1])
    current_plot(replay, ax=axes[2:])
    return axes


def _surfaced(rows: list[Row]) -> np.ndarray:
    """Return when the vehicle surfaced."""
    return np.array([row["end"].removesuffix("Z") for row in rows], "datetime64[s]")


def _column(rows: list[Row], key: str) -> np.ndarray:
    """Return a number of each dive, NaN where it is not known."""
    return np.array([row.get(key) for row in rows], dtype=float)


def _band(
    ax: Axes, x: np.ndarray, rows: list, key: str, colour: str, label: str = ""
) -> None:
    """Draw a number of each dive with two standard errors."""
    value = _column(rows, key)
    error = _column(rows, f"{key}_error")
    ax.fill_between(
        x, value - 2 * error, value + 2 * error, color=colour, alpha=0.15, lw=0
    )
    ax.plot(x, value, "-o", color=colour, label=label, **_fine(x))


def _fine(x: np.ndarray) -> dict[str, Any]:
    """Return sizes of marks and lines, small for many dives; of very many each n-th has a mark."""
    size = {"ms": 4, "lw": 1.2} if len(x) <= MANY else {"ms": 1.8, "lw": 0.7}
    return {**size, "markevery": 1 + len(x) // MARKS}


def mark_dates(ax: Axes, x: np.ndarray) -> None:
    """Mark dates, also where there is one."""
    # three days are marked by days: hours of twelve are too many for four days
    locator = AutoDateLocator(minticks=3, maxticks=7)
    ax.xaxis.set_major_formatter(ConciseDateFormatter(locator))
    ax.xaxis.set_major_locator(locator)
    ax.set_xlabel("surfaced (UTC)")
    if len(x) == 1:
        hour = np.timedelta64(1, "h")
        ax.set_xlim(x[0] - hour, x[0] + hour)
