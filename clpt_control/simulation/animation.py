"""Animation of a run as a GIF.

Each frame is a sample of the run with vehicle, prediction, waypoint, and both flows at its time.
"""

from base64 import b64encode
from collections.abc import Iterator
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arguments import public
from ..base.errors import ClptError
from ..base.figures import (
    BLUE,
    GREEN,
    GREY,
    ORANGE,
    RED,
    TITLE,
    axes_for,
    file_settings,
    legend_below,
)
from ..base.files import check_writable, write_file
from ..base.html import fragment
from ..base.progress import progress_bar
from ..base.progress.interrupt import check
from ..paper.scenario.recorded_run import scenario_with, waypoints_of
from .flows import flow_to_draw
from .track_chart import square_chart

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

LIMITS = {"seconds": (0.1, 600.0), "fps": (1.0, 50.0), "width": (200, 2000)}
MAX_PIXELS = 5e8  # of all frames together
INCHES = 5.6  # width of the chart
SIGNALS = (
    "position",
    "predicted_position",
    "clpe",
    "reference",
    "flow_parameters_estimate",
)
ARROWS = 9  # on a side
LENGTH = 1.3  # longest true arrow, steps of the grid
MAX_LEARNED = 1.7  # longest learned arrow, steps of the grid
FAINT = "#AAAAAA"
ARROW = {
    "angles": "xy",
    "scale_units": "xy",
    "minlength": 0,
    "pivot": "mid",
    "headwidth": 3.2,
    "headlength": 3.6,
    "headaxislength": 3.2,
}


@dataclass(repr=False, eq=False)
class Movie:
    """Animation of a run, which a notebook shows; `gif` has the bytes of the file."""

    gif: bytes
    frames: int
    seconds: float

    def __repr__(self) -> str:
        size = len(self.gif) / 1e6
        return f"<Movie of {self.frames} frames, {self.seconds:g} s, {size:.1f} MB>"

    def _repr_html_(self) -> str:
        data = b64encode(self.gif).decode()
        return fragment(
            "", "", f'<img alt="film of a run" src="data:image/gif;base64,{data}">'
        )


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

    Vehicle and prediction, and the true and the learned flow as arrows; frames are even in time.

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
    t = run.time.values
    times = np.linspace(float(t[0]), float(t[-1]), max(2, round(seconds / pause)))
    samples = np.searchsorted(t, times * (1 + 1e-12), side="right") - 1
    samples = np.clip(samples, 0, None)
    count = len(samples)
    with file_settings(), progress_bar("drawing", count, "frames") as report:
        ax = axes_for(None, INCHES, INCHES + 0.6)
        figure = ax.figure
        figure.set_dpi(width / INCHES)
        content = _gif(figure, draw_samples(ax, run, samples), pause, report)
    if path is None:
        return Movie(content, count, count * pause)
    write_file(path, content)
    return None


def check_options(path: str | Path | None, **options: float) -> None:
    """Raise `ClptError` for options that are not allowed, or an animation that is too large."""
    check_writable(path, "a film", (".gif",))
    for name, (low, high) in LIMITS.items():
        if not low <= options[name] <= high:
            raise ClptError(
                f"{name} = {options[name]!r:.60}: must be a number from {low:g} to {high:g}"
            )
    count = options["seconds"] * options["fps"]
    width = options["width"]
    if (size := count * width**2) > MAX_PIXELS:
        raise ClptError(
            f"a GIF of {count:.0f} frames of {width} pixels would take {size / 1e9:.1f} GB of "
            "memory: make it shorter or narrower"
        )


def _gif(figure: "Figure", frames: Iterator[int], pause: float, report: Any) -> bytes:
    """Return frames as a GIF."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from PIL import Image

    canvas = FigureCanvasAgg(figure)
    images = []
    for k in frames:
        if k == 0:  # the layout is that of the first frame
            figure.draw_without_rendering()
            figure.set_layout_engine("none")
        check()
        report(k)
        canvas.draw()
        image = Image.fromarray(np.asarray(canvas.buffer_rgba()))
        images.append(image.convert("P", palette=Image.Palette.ADAPTIVE))
    content = BytesIO()
    images[0].save(
        content,
        format="GIF",
        save_all=True,
        append_images=images[1:],
        duration=round(1000 * pause),
        loop=0,
    )
    return content.getvalue()


def draw_samples(ax: Any, run: "xarray.Dataset", samples: np.ndarray) -> Iterator[int]:
    """Draw samples of a run on axes, one after the other, and yield their numbers."""
    scenario = scenario_with(run, *SIGNALS)
    units = scenario.units
    time = run.time.values
    waypoints = waypoints_of(run, scenario)
    points = np.concatenate([waypoints, run.position.values])
    grid = square_chart(ax, scenario, points, ARROWS, MAX_LEARNED / 2)

    # flows of all samples, of shape (samples, points of the grid, 2)
    points = np.tile(grid, (len(samples), 1))
    times = np.repeat(time[samples], len(grid))
    theta = run.flow_parameters_estimate.values[samples].repeat(len(grid), axis=0)
    true = flow_to_draw(run, scenario, points, times)
    learned = flow_to_draw(run, scenario, points, times, theta)
    kind = "true" if true.any() else "learned"
    max_speed = np.hypot(*(true if true.any() else learned).T).max() or 1.0
    arrow_length = LENGTH * np.ptp(ax.get_xlim()) / (ARROWS - 1 + MAX_LEARNED)
    style = {**ARROW, "scale": max_speed / arrow_length}
    if learned.any() or true.any():
        note = f"longest {kind} arrow {max_speed:.2g} {units.length}/{units.time}"
        ax.set_title(note, loc="right", fontsize=8, color=GREY)
    excess = np.hypot(*learned.T) / (max_speed * MAX_LEARNED / LENGTH)
    bounded = learned / np.maximum(excess, 1.0)[:, None]
    flows = [
        (true, FAINT, 0.008, "true flow"),
        (bounded, ORANGE, 0.0042, "learned flow"),
    ]

    ax.plot(*waypoints.T, "o", color="black", ms=5, mfc="none")
    for j, k in enumerate(samples):
        artists = []
        for flow, color, width, label in flows:
            if not flow.any():
                continue
            arrows = flow.reshape(len(samples), -1, 2)[j]
            artists.append(
                ax.quiver(
                    *grid.T, *arrows.T, color=color, width=width, label=label, **style
                )
            )
        artists += _draw_vehicle(ax, run, k, len(waypoints) > 0)
        ax.set_title(f"t = {time[k]:g} {units.time}", **TITLE)
        if j == 0:
            legend_below(ax, 3, 30.0)
        yield j
        if j + 1 < len(samples):
            for artist in artists:
                artist.remove()


def _draw_vehicle(
    ax: Any, run: "xarray.Dataset", k: int, has_waypoints: bool
) -> list[Any]:
    """Draw track, waypoint, CLPE, vehicle and prediction at a sample."""
    track = run.position.values[: k + 1]
    x = track[k]
    z = run.predicted_position.values[k]
    zc = run.reference.values[k]
    desired = "waypoint, now" if has_waypoints else "desired"
    return [
        *ax.plot(*track.T, color=BLUE, lw=1.0, alpha=0.7),
        *ax.plot(*zc, "o", color="black", ms=5, label=desired),
        *ax.plot(*np.transpose([x, z]), color=RED, lw=1.6, label="CLPE"),
        *ax.plot(*x, "o", color=BLUE, ms=8, label="vehicle"),
        *ax.plot(*z, "D", color=GREEN, ms=8, mfc="none", mew=1.8, label="prediction"),
    ]
