"""A run as a moving picture, a GIF.

Places between samples lie on straight lines, as the track is drawn; the flows are those of
`flow_velocity` at the times themselves.
"""

from base64 import b64encode
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..arguments import public
from ..errors import ClptError
from ..figures import BLUE, GREEN, GREY, ORANGE, RED, SAME, TITLE, legend_below, new_figure
from ..files import check_writable, write_file
from ..html import fragment
from ..progress import progress_bar
from ..progress.interrupt import check
from ..scenario.experiment import Scenario
from ..scenario.recorded_run import waypoints_of
from .charts import arrow_grid, scenario_with
from .flows import flow_to_draw

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

LIMITS = {"seconds": (0.1, 600.0), "fps": (1.0, 50.0), "width": (200, 2000)}
MOST_PIXELS = 5e8  # pixels that all frames have together, at most
SHADES = 5  # of each colour towards white


class Movie:
    """A film of a run, which a notebook shows; `gif` are the bytes of the file."""

    def __init__(self, gif: bytes, frames: int, seconds: float):
        self.gif, self.frames, self.seconds = gif, frames, seconds

    def __repr__(self) -> str:
        size = len(self.gif) / 1e6
        return f"<Movie of {self.frames} frames, {self.seconds:g} s, {size:.1f} MB>"

    def _repr_html_(self) -> str:
        data = b64encode(self.gif).decode()
        return fragment("", "", f'<img alt="film of a run" src="data:image/gif;base64,{data}">')


@public
def animate(
    run: "xarray.Dataset",
    path: str | Path | None = None,
    *,
    seconds: float = 12.0,
    fps: float = 12.5,
    width: int = 560,
) -> Movie | None:
    """Make a moving picture of a run.

    Vehicle and prediction, the true and the learned flow as arrows, and CLPE over time; frames
    are even in time.

    Parameters
    ----------
    run : xarray.Dataset
        As `simulate` gives it, or `load_run`.
    path : str or path, optional
        Ends in ``.gif``.
    seconds : float, optional
        How long the film lasts.
    fps : float, optional
        Frames a second; each lasts whole hundredths of a second.
    width : int, optional
        Pixels.

    Returns
    -------
    Movie or None
        Without a path what a notebook shows; its `gif` are the file's bytes.

    Raises
    ------
    DataError
        If the run lacks a signal, or the file cannot be written.
    ClptError
        If an option is not allowed.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> run = clpt.simulate(clpt.paper_scenario().with_values({"run.duration": 20}))
    >>> clpt.animate(run, seconds=0.4, width=200).frames
    5
    """
    check_options(path, seconds=seconds, fps=fps, width=width)
    pause = round(100 / fps) / 100
    scenario_with(run, *SIGNALS)
    first, last = map(float, run.time.values[[0, -1]])
    times = np.linspace(first, last, max(2, round(seconds / pause)))
    film = film_of(run, times)
    from matplotlib import rc_context

    with rc_context(SAME), progress_bar("drawing", len(times), "frames") as report:
        figure, frames = draw_frames(film, width)
        content = _gif(figure, frames, pause, report)
    if path is None:
        return Movie(content, len(times), len(times) * pause)
    write_file(path, content)
    return None


def check_options(path: str | Path | None, **options: float) -> None:
    """Refuse what cannot be filmed, before work begins."""
    if path is not None:
        check_writable(path, "a film", (".gif",))
    for name, (low, high) in LIMITS.items():
        if not low <= options[name] <= high:
            raise ClptError(
                f"{name} = {options[name]!r:.60}: must be a number from {low:g} to {high:g}"
            )
    count, width = options["seconds"] * options["fps"], options["width"]
    if (size := count * width**2) > MOST_PIXELS:
        raise ClptError(
            f"a GIF of {count:.0f} frames of {width} pixels would take {size / 1e9:.1f} GB of "
            "memory: make it shorter or narrower"
        )


def _gif(figure: "Figure", frames: Iterator[int], pause: float, report: Any) -> bytes:
    """Return frames that share their colours as a GIF; all but what changes is left out."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from PIL import Image

    canvas, images, content = FigureCanvasAgg(figure), list[Any](), BytesIO()
    palette = Image.new("P", (1, 1))
    palette.putpalette(_palette())
    for k in frames:
        check()
        report(k)
        canvas.draw()
        image = Image.fromarray(np.asarray(canvas.buffer_rgba())).convert("RGB")
        images.append(image.quantize(palette=palette, dither=Image.Dither.NONE))
    first, *rest = images
    options = {"duration": round(1000 * pause), "loop": 0, "disposal": 1, "optimize": False}
    first.save(content, format="GIF", save_all=True, append_images=rest, **options)
    return content.getvalue()


def _palette() -> list[int]:
    """Return red, green and blue of every colour that a frame may have."""
    from matplotlib.colors import to_rgb

    share = np.linspace(0, 1, SHADES, endpoint=False)[:, None]
    shades = [share + (1 - share) * to_rgb(colour) for colour in (*INKS, "black")]
    return [int(part) for part in np.rint(255 * np.vstack([*shades, np.ones((1, 3))])).ravel()]


# --- what is shown at each time, and the figure that shows it -------------------------------------


SIGNALS = ("position", "predicted_position", "clpe", "reference", "flow_parameters_estimate")
ARROWS = 9  # along the longer side
FAINT = "#AAAAAA"
INKS = (BLUE, GREEN, RED, ORANGE, FAINT)  # and black
LENGTH, LONGEST = 1.8, 2.4  # steps of the grid: the longest true arrow, any learned one
LEAST = 1e-6  # of the largest |e|: below it nothing is told apart
INCHES = 5.6  # inches


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

    @property
    def longest(self) -> tuple[str, float]:
        """The flow that scales the arrows, the true one where there is any, and its most."""
        kind, flow = ("true", self.true) if self.true.any() else ("learned", self.learned)
        return kind, float(np.hypot(*flow.reshape(-1, 2).T).max())


def film_of(run: "xarray.Dataset", times: np.ndarray) -> Film:
    """Return what is shown at each time."""
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
    true = flow_to_draw(run, scenario, places, moments).reshape(n, -1, 2)
    learned = flow_to_draw(run, scenario, places, moments, each).reshape(n, -1, 2)
    return Film(scenario, run, times, x, z, zc, grid, true, learned)


def _grid(scenario: Scenario, run: "xarray.Dataset") -> np.ndarray:
    """Return the places of the arrows: over waypoints and track, within the true flow's field."""
    places = np.vstack([run.position.values, waypoints_of(run, scenario)])
    low, high = places.min(0), places.max(0)
    rim = 0.12 * max(*(high - low), 1e-9)
    return arrow_grid(scenario, low - rim, high + rim, ARROWS)


def draw_frames(film: Film, width: int) -> "tuple[Figure, Iterator[int]]":
    """Return a figure so many pixels wide, and an iterator that turns it to frame after frame."""
    low, high = film.grid.min(0), film.grid.max(0)
    step = max(high - low) / (ARROWS - 1)
    low, high = low - 0.75 * step, high + 0.75 * step
    shape = (high - low)[1] / (high - low)[0]
    dpi = width / INCHES
    high_inches = np.clip(shape, 0.4, 1.6) * (INCHES - 0.9) + 2.6
    rows = (high_inches - 1.9, 1.1)
    figure, (chart, below) = new_figure(INCHES, high_inches, nrows=2, height_ratios=rows)
    figure.set_dpi(dpi)
    moving = _chart(chart, film, step)
    moving |= _trace(below, film)
    chart.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
    legend_below(chart, 3, 30.0)
    figure.draw_without_rendering()
    figure.set_layout_engine("none")  # nothing moves from frame to frame
    return figure, _frames(film, moving, step)


def _chart(ax: Any, film: Film, step: float) -> dict[str, Any]:
    """Draw the chart at the first time; return what moves."""
    units = film.scenario.units
    points = waypoints_of(film.run, film.scenario)
    ax.plot(*points.T, "o", color="black", ms=5, mfc="none")
    arrows: dict[str, Any] = {"angles": "xy", "scale_units": "xy", "scale": 1, "minlength": 0}
    arrows |= {"headwidth": 3.2, "headlength": 3.6, "headaxislength": 3.2}
    nothing = np.zeros(film.grid.shape).T
    desired = "waypoint, now" if len(points) else "desired"
    moving = {
        "true": ax.quiver(*film.grid.T, *nothing, color=FAINT, width=0.008, **arrows),
        "learned": ax.quiver(*film.grid.T, *nothing, color=ORANGE, width=0.0042, **arrows),
        "track": ax.plot([], [], color=BLUE, lw=1.0, alpha=0.7)[0],
        "zc": ax.plot([], [], "o", color="black", ms=5, label=desired)[0],
        "x": ax.plot([], [], "o", color=BLUE, ms=8, label="vehicle")[0],
        "z": ax.plot([], [], "D", color=GREEN, ms=8, mfc="none", mew=1.8, label="prediction")[0],
        "e": ax.plot([], [], color=RED, lw=1.6, label="CLPE")[0],
        "title": ax.set_title("", **TITLE),
    }
    kind, longest = film.longest
    if kind == "true":
        ax.plot([], [], color=FAINT, lw=4, label="true flow")
    ax.plot([], [], color=ORANGE, lw=2, label="learned flow")
    ax.set(xlabel=f"$x_1$ ({units.length})", ylabel=f"$x_2$ ({units.length})")
    note = f"longest {kind} arrow {longest:.2g} {units.length}/{units.time}"
    ax.set_title(note if longest else "", loc="right", fontsize=8, color=GREY)
    return moving


def _trace(ax: Any, film: Film) -> dict[str, Any]:
    """Draw |e| over the film's time; return what moves."""
    samples, ends = film.run.time.values, film.times[[0, -1]]
    t = np.union1d(samples[(samples > ends[0]) & (samples < ends[1])], ends)
    size = np.hypot(*(np.interp(t, samples, one) for one in film.run.clpe.values.T))
    ax.semilogy(t, np.where(size > LEAST * size.max(), size, np.nan), color=RED, lw=0.8)
    units = film.scenario.units
    ax.set(xlabel=f"time ({units.time})", ylabel=f"|CLPE| ({units.length})")
    ax.set_xlim(film.times[0], film.times[-1])
    return {"now": ax.axvline(film.times[0], color="black", lw=1.0)}


def _frames(film: Film, moving: dict[str, Any], step: float) -> Iterator[int]:
    t, units = film.run.time.values, film.scenario.units
    longest = max(film.longest[1], 1e-300)
    digits = max(0, int(np.ceil(-np.log10(max(np.ptp(film.times), 1e-9) / len(film.times)))))
    for k, now in enumerate(film.times):
        for name in ("true", "learned"):
            moving[name].set_UVC(*_on_chart(getattr(film, name)[k], longest, step).T)
        before = (t >= film.times[0]) & (t <= now)
        moving["track"].set_data(*np.vstack([film.run.position.values[before], film.x[k]]).T)
        moving["e"].set_data(*np.vstack([film.x[k], film.z[k]]).T)
        for name in ("x", "z", "zc"):
            moving[name].set_data(*getattr(film, name)[k][:, None])
        moving["now"].set_xdata([now, now])
        moving["title"].set_text(f"t = {now:.{digits}f} {units.time}")
        yield k


def _on_chart(flow: np.ndarray, longest: float, step: float) -> np.ndarray:
    """Return arrows on the chart, the `longest` `LENGTH` steps, none over `LONGEST`."""
    arrows = flow / longest * LENGTH * step
    size = np.maximum(np.hypot(*arrows.T) / (LONGEST * step), 1.0)
    return arrows / size[:, None]
