"""What a film of a run shows at each of its times, and the figure that shows it.

Places between samples lie on straight lines, as the track is drawn; the flows are those of
`flow_velocity` at the times themselves.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..figures import BLUE, GREEN, GREY, ORANGE, RED, legend_below, new_figure
from ..scenario.experiment import Scenario
from ..scenario.recorded_run import waypoints_of
from .plots import TITLE, scenario_with

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

SIGNALS = ("position", "predicted_position", "clpe", "reference", "flow_parameters_estimate")
ARROWS = 9  # along the longer side
FAINT = "#AAAAAA"
INKS = (BLUE, GREEN, RED, ORANGE, FAINT)  # and black
LENGTH, LONGEST = 1.8, 2.4  # steps of the grid: the longest true arrow, any learned one
LEAST = 1e-6  # of the largest |e|: below it nothing is told apart
WIDE = 5.6  # inches


class Film(NamedTuple):
    """A run at the times of the frames: places (n, 2), flows (n, arrows, 2)."""

    scenario: Scenario
    run: "xarray.Dataset"
    times: np.ndarray
    x: np.ndarray
    z: np.ndarray
    zc: np.ndarray
    grid: np.ndarray  # (arrows, 2)
    true: np.ndarray
    learned: np.ndarray


def film_of(run: "xarray.Dataset", times: np.ndarray) -> Film:
    """Return what is shown at each time."""
    from .flows import flow_velocity

    scenario = scenario_with(run, *SIGNALS)
    t = run.time.values

    def at(name: str) -> np.ndarray:
        values = run[name].values.reshape(len(t), -1)
        return np.column_stack([np.interp(times, t, column) for column in values.T])

    x, z, theta = at("position"), at("predicted_position"), at("flow_parameters_estimate")
    zc = run.reference.values[np.searchsorted(t, times, side="right") - 1]
    grid, n = _grid(scenario, run), len(times)
    places, moments = np.tile(grid, (n, 1)), np.repeat(times, len(grid))
    each = np.repeat(theta.reshape(n, 2, -1), len(grid), axis=0)
    true, learned = (
        flow_velocity(scenario, places, moments, *known).reshape(n, -1, 2)
        for known in ((), (each,))
    )
    return Film(scenario, run, times, x, z, zc, grid, true, learned)


def _grid(scenario: Scenario, run: "xarray.Dataset") -> np.ndarray:
    """Return the places of the arrows: over waypoints and track, within the true flow's field."""
    seen = np.vstack([run.position.values, waypoints_of(run, scenario)])
    low, high = seen.min(0), seen.max(0)
    rim = 0.12 * max(*(high - low), 1e-9)
    low, high = low - rim, high + rim
    if scenario.field_path is not None:
        from ..currents.plane import read_field

        field = read_field(scenario.field_path, scenario.units)
        low = np.maximum(low, [field.x1[0], field.x2[0]])
        high = np.minimum(high, [field.x1[-1], field.x2[-1]])
    step = max(high - low) / ARROWS
    sides = [np.arange(a + step / 2, b, step) for a, b in zip(low, high, strict=True)]
    return np.stack(np.meshgrid(*sides), -1).reshape(-1, 2)


def draw_frames(film: Film, width: int) -> "tuple[Figure, Iterator[int]]":
    """Return a figure so many pixels wide, and an iterator that turns it to frame after frame."""
    low, high = film.grid.min(0), film.grid.max(0)
    step = max(high - low) / (ARROWS - 1)
    low, high = low - 0.75 * step, high + 0.75 * step
    shape = (high - low)[1] / (high - low)[0]
    dpi = width / WIDE
    high_inches = np.clip(shape, 0.4, 1.6) * (WIDE - 0.9) + 2.6
    height = 2 * round(high_inches * dpi / 2) / dpi  # an even number of pixels, for MP4
    rows = (height - 1.9, 1.1)
    figure, (chart, below) = new_figure(WIDE, height, nrows=2, height_ratios=rows)
    figure.set_dpi(dpi)
    moving = _chart(chart, film, step)
    moving |= _trace(below, film)
    chart.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
    legend_below(chart, 3, 30.0)
    figure.draw_without_rendering()
    figure.set_layout_engine("none")  # nothing moves from frame to frame
    return figure, _turning(film, moving, step)


def _chart(ax: Any, film: Film, step: float) -> dict[str, Any]:
    """Draw the chart at the first time; return what moves."""
    units = film.scenario.units
    points = waypoints_of(film.run, film.scenario)
    ax.plot(*points.T, "o", color="black", ms=5, mfc="none")
    arrows: dict[str, Any] = {"angles": "xy", "scale_units": "xy", "scale": 1, "minlength": 0}
    arrows |= {"headwidth": 3.2, "headlength": 3.6, "headaxislength": 3.2}
    nothing = np.zeros(film.grid.shape).T
    line: dict[str, Any] = {"color": BLUE, "lw": 1.0, "alpha": 0.7}
    moving = {
        "true": ax.quiver(*film.grid.T, *nothing, color=FAINT, width=0.008, **arrows),
        "learned": ax.quiver(*film.grid.T, *nothing, color=ORANGE, width=0.0042, **arrows),
        "track": ax.plot([], [], **line)[0],
        "zc": ax.plot(
            [], [], "o", color="black", ms=5, label="waypoint, now" if len(points) else "desired"
        )[0],
        "x": ax.plot([], [], "o", color=BLUE, ms=8, label="vehicle")[0],
        "z": ax.plot([], [], "D", color=GREEN, ms=8, mfc="none", mew=1.8, label="prediction")[0],
        "e": ax.plot([], [], color=RED, lw=1.6, label="CLPE")[0],
        "title": ax.set_title("", **TITLE),
    }
    ax.plot([], [], color=FAINT, lw=4, label="true flow")
    ax.plot([], [], color=ORANGE, lw=2, label="learned flow")
    longest = np.hypot(*film.true.reshape(-1, 2).T).max()
    ax.set(xlabel=f"$x_1$ ({units.length})", ylabel=f"$x_2$ ({units.length})")
    said = f"longest true arrow {longest:.2g} {units.length}/{units.time}"
    ax.set_title(said, loc="right", fontsize=8, color=GREY)
    return moving


def _trace(ax: Any, film: Film) -> dict[str, Any]:
    """Draw |e| over the film's time; return what moves."""
    t, size = film.run.time.values, np.hypot(*film.run.clpe.values.T)
    shown = (t >= film.times[0]) & (t <= film.times[-1])
    size = np.where(size > LEAST * size[shown].max(), size, np.nan)
    ax.semilogy(t[shown], size[shown], color=RED, lw=0.8)
    units = film.scenario.units
    ax.set(xlabel=f"time ({units.time})", ylabel=f"|CLPE| ({units.length})")
    ax.set_xlim(film.times[0], film.times[-1])
    return {"now": ax.axvline(film.times[0], color="black", lw=1.0)}


def _turning(film: Film, moving: dict[str, Any], step: float) -> Iterator[int]:
    t, units = film.run.time.values, film.scenario.units
    longest = max(float(np.hypot(*film.true.reshape(-1, 2).T).max()), 1e-300)
    digits = max(0, int(np.ceil(-np.log10(max(np.ptp(film.times), 1e-9) / len(film.times)))))
    for k, now in enumerate(film.times):
        for name in ("true", "learned"):
            moving[name].set_UVC(*_drawn(getattr(film, name)[k], longest, step).T)
        before = (t >= film.times[0]) & (t <= now)
        moving["track"].set_data(*np.vstack([film.run.position.values[before], film.x[k]]).T)
        moving["e"].set_data(*np.vstack([film.x[k], film.z[k]]).T)
        for name in ("x", "z", "zc"):
            moving[name].set_data(*getattr(film, name)[k][:, None])
        moving["now"].set_xdata([now, now])
        moving["title"].set_text(f"t = {now:.{digits}f} {units.time}")
        yield k


def _drawn(flow: np.ndarray, longest: float, step: float) -> np.ndarray:
    """Return arrows on the chart, the longest true one `LENGTH` steps, none over `LONGEST`."""
    arrows = flow / longest * LENGTH * step
    size = np.maximum(np.hypot(*arrows.T) / (LONGEST * step), 1.0)
    return arrows / size[:, None]
