"""A run as a moving picture, a GIF.

Each frame is a sample of the run, with the flows of `flow_velocity` at its time.
"""

from base64 import b64encode
from collections.abc import Iterator
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
    SAME,
    TITLE,
    legend_below,
    new_figure,
)
from ..base.files import check_writable, write_file
from ..base.html import fragment
from ..base.progress import progress_bar
from ..base.progress.interrupt import check
from ..paper.scenario.recorded_run import waypoints_of
from .flows import flow_to_draw
from .track_chart import scenario_with, square_chart

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

LIMITS = {"seconds": (0.1, 600.0), "fps": (1.0, 50.0), "width": (200, 2000)}
MOST_PIXELS = 5e8  # pixels that all frames have together, at most


class Movie:
    """A film of a run, which a notebook shows; `gif` are the bytes of the file."""

    def __init__(self, gif: bytes, frames: int, seconds: float):
        self.gif, self.frames, self.seconds = gif, frames, seconds

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
    at = np.clip(np.searchsorted(t, times * (1 + 1e-12), side="right") - 1, 0, None)
    from matplotlib import rc_context

    with rc_context(SAME), progress_bar("drawing", len(at), "frames") as report:
        figure, ax = new_figure(INCHES, INCHES + 0.6)
        figure.set_dpi(width / INCHES)
        content = _gif(figure, draw_samples(ax, run, at), pause, report)
    if path is None:
        return Movie(content, len(at), len(at) * pause)
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
    """Return frames as a GIF."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from PIL import Image

    canvas, images, content = FigureCanvasAgg(figure), list[Any](), BytesIO()
    for k in frames:
        if not k:  # then nothing moves from frame to frame
            figure.draw_without_rendering()
            figure.set_layout_engine("none")
        check()
        report(k)
        canvas.draw()
        image = Image.fromarray(np.asarray(canvas.buffer_rgba()))
        images.append(image.convert("P", palette=Image.Palette.ADAPTIVE))
    first, *rest = images
    every: dict[str, Any] = {"duration": round(1000 * pause), "loop": 0}
    first.save(content, format="GIF", save_all=True, append_images=rest, **every)
    return content.getvalue()


# --- what is shown at each time -------------------------------------------------------------------

SIGNALS = (
    "position",
    "predicted_position",
    "clpe",
    "reference",
    "flow_parameters_estimate",
)
ARROWS = 9  # on a side
FAINT = "#AAAAAA"
LENGTH, LONGEST = 1.8, 2.4  # steps of the grid: the longest true arrow, any learned one
INCHES = 5.6  # inches


def draw_samples(ax: Any, run: "xarray.Dataset", at: np.ndarray) -> Iterator[int]:
    """Draw samples of a run on axes, one after the other: vehicle, prediction and both flows."""
    scenario = scenario_with(run, *SIGNALS)
    units, t, path = scenario.units, run.time.values, run.position.values
    points = waypoints_of(run, scenario)
    places = np.concatenate([points, path])
    grid = square_chart(ax, scenario, places, ARROWS)
    every, moments = np.tile(grid, (len(at), 1)), np.repeat(t[at], len(grid))
    theta = np.repeat(run.flow_parameters_estimate.values[at], len(grid), axis=0)
    true, learned = (
        flow_to_draw(run, scenario, every, moments, *of).reshape(len(at), -1, 2)
        for of in ((), (theta,))
    )
    kind, flow = ("true", true) if true.any() else ("learned", learned)
    longest = float(np.hypot(*flow.reshape(-1, 2).T).max())
    # of a chart, of a speed
    unit = LENGTH * np.ptp(ax.get_xlim()) / ARROWS / (longest or 1.0)
    arrows: dict[str, Any] = {"angles": "xy", "scale_units": "xy", "scale": 1 / unit}
    arrows |= {
        "minlength": 0,
        "headwidth": 3.2,
        "headlength": 3.6,
        "headaxislength": 3.2,
    }
    note = f"longest {kind} arrow {longest:.2g} {units.length}/{units.time}"
    ax.set_title(note if longest else "", loc="right", fontsize=8, color=GREY)
    ax.plot(*points.T, "o", color="black", ms=5, mfc="none")
    for j, k in enumerate(at):
        moving: list[Any] = []
        if true.any():
            of = {"color": FAINT, "width": 0.008, "label": "true flow", **arrows}
            moving.append(ax.quiver(*grid.T, *true[j].T, **of))
        if learned.any():
            size = np.hypot(*learned[j].T) / (longest * LONGEST / LENGTH)
            bounded = learned[j] / np.maximum(size, 1.0)[:, None]
            of = {"color": ORANGE, "width": 0.0042, "label": "learned flow", **arrows}
            moving.append(ax.quiver(*grid.T, *bounded.T, **of))
        x, z, zc = path[k], run.predicted_position.values[k], run.reference.values[k]
        now = "waypoint, now" if len(points) else "desired"
        prediction = {
            "color": GREEN,
            "ms": 8,
            "mfc": "none",
            "mew": 1.8,
            "label": "prediction",
        }
        moving += ax.plot(*path[: k + 1].T, color=BLUE, lw=1.0, alpha=0.7)
        moving += ax.plot(*zc, "o", color="black", ms=5, label=now)
        moving += ax.plot(*np.transpose([x, z]), color=RED, lw=1.6, label="CLPE")
        moving += ax.plot(*x, "o", color=BLUE, ms=8, label="vehicle")
        moving += ax.plot(*z, "D", **prediction)
        ax.set_title(f"t = {t[k]:g} {units.time}", **TITLE)
        if j == 0:
            legend_below(ax, 3, 30.0)
        yield j
        for one in moving if j + 1 < len(at) else ():
            one.remove()
