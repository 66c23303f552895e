"""A run as a moving picture: GIF by Pillow, MP4 by ffmpeg."""

from base64 import b64encode
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arguments import public
from ..errors import ClptError, DataError
from ..files import beside, check_writable
from ..html import fragment
from ..progress import progress_bar
from ..progress.interrupt import check
from ..scenario.recorded_run import is_response
from .film_frames import INKS, SIGNALS, draw_frames, film_of
from .plots import scenario_with

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

ENDINGS = (".gif", ".mp4")
MOST = 3000  # frames
HELD = 5e8  # pixels that a GIF's frames have together, at most
NARROW, WIDE = 200, 2000  # pixels
SHADES = 5  # of each colour towards white, in a GIF


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
    start: float | None = None,
    end: float | None = None,
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
        Ends in ``.gif``, or in ``.mp4`` where ffmpeg is installed.
    start, end : float, optional
        What of the run is shown, units.time; by default all.
    seconds : float, optional
        How long the film lasts.
    fps : float, optional
        Frames a second; a GIF has whole hundredths of a second for each frame.
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
        If an option is not allowed, or ffmpeg is missing.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> run = clpt.simulate(clpt.paper_scenario().with_values({"run.duration": 20}))
    >>> clpt.animate(run, seconds=0.4, width=200).frames
    5
    """
    suffix = ".gif" if path is None else Path(path).suffix.lower()
    check_options(path, seconds, fps, width)
    times, pause = _times(run, start, end, seconds, fps, suffix)
    film = film_of(run, times)
    figure, frames = draw_frames(film, 2 * (width // 2))
    with progress_bar("drawing", len(times), "frames") as report:
        if path is None:
            made = BytesIO()
            _write_gif(made, figure, _reported(frames, report), pause)
            return Movie(made.getvalue(), len(times), len(times) * pause)
        with beside(path) as part:
            write = _write_gif if suffix == ".gif" else _write_mp4
            write(part, figure, _reported(frames, report), pause)
    return None


def check_options(path: str | Path | None, seconds: float, fps: float, width: int) -> None:
    """Refuse what cannot be filmed, before work begins."""
    suffix = ".gif" if path is None else Path(path).suffix.lower()
    if path is not None:
        if suffix not in ENDINGS:
            raise ClptError(f"{path}: a film's name must end in {' or '.join(ENDINGS)}")
        check_writable(path)
        if suffix == ".mp4":
            from matplotlib.animation import FFMpegWriter

            if not FFMpegWriter.isAvailable():
                raise ClptError(f"{path}: needs ffmpeg, which is not installed; a .gif needs none")
    for name, value, low, high in (
        ("seconds", seconds, 0.1, 600),
        ("fps", fps, 1, 50),
        ("width", width, NARROW, WIDE),
    ):
        if not low <= value <= high:
            raise ClptError(f"{name} = {value!r:.60}: must be a number from {low:g} to {high:g}")
    if seconds * fps > MOST:
        raise ClptError(f"seconds x fps = {seconds * fps:.0f} frames; at most {MOST} are made")
    if suffix == ".gif" and (size := seconds * fps * width**2) > HELD:
        raise ClptError(
            f"a GIF of {seconds * fps:.0f} frames of {width} pixels would take {size / 1e9:.1f} "
            "GB of memory: make it shorter or narrower, or an .mp4"
        )


def _times(
    run: "xarray.Dataset",
    start: float | None,
    end: float | None,
    seconds: float,
    fps: float,
    suffix: str,
) -> tuple[np.ndarray, float]:
    """Return the times of the frames, and how long each is shown, s."""
    if is_response(run):
        raise DataError(
            "the run is of a diagram, which has no track to film; run.clpt.plot() draws its signals"
        )
    scenario = scenario_with(run, *SIGNALS)
    first, last = float(run.time[0]), float(run.time[-1])
    begin, over = first if start is None else start, last if end is None else end
    if not first <= begin < over <= last:
        raise DataError(
            f"start = {begin:g}, end = {over:g}: must lie one after the other within the run, "
            f"{first:g} to {last:g} {scenario.units.time}"
        )
    pause = round(100 / fps) / 100 if suffix == ".gif" else 1 / fps
    return np.linspace(begin, over, max(2, round(seconds / pause))), pause


def _reported(frames: Iterator[int], report: Any) -> Iterator[int]:
    for k in frames:
        check()
        report(k)
        yield k


def _write_gif(file: Any, figure: "Figure", frames: Iterator[int], pause: float) -> None:
    """Write frames that share their colours; all but what changes is left out."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from PIL import Image

    canvas, images = FigureCanvasAgg(figure), list[Any]()
    palette = Image.new("P", (1, 1))
    palette.putpalette(_palette())
    for _ in frames:
        canvas.draw()
        image = Image.fromarray(np.asarray(canvas.buffer_rgba())).convert("RGB")
        images.append(image.quantize(palette=palette, dither=Image.Dither.NONE))
    first, *rest = images
    shown = {"duration": round(1000 * pause), "loop": 0, "disposal": 1, "optimize": False}
    first.save(file, format="GIF", save_all=True, append_images=rest, **shown)


def _palette() -> list[int]:
    """Return red, green and blue of every colour that a frame may have."""
    from matplotlib.colors import to_rgb

    share = np.linspace(0, 1, SHADES, endpoint=False)[:, None]
    shades = [share + (1 - share) * to_rgb(colour) for colour in (*INKS, "black")]
    return [int(part) for part in np.rint(255 * np.vstack([*shades, np.ones((1, 3))])).ravel()]


def _write_mp4(file: Path, figure: "Figure", frames: Iterator[int], pause: float) -> None:
    from matplotlib.animation import FFMpegWriter

    fps: Any = 1 / pause  # need not be whole
    writer = FFMpegWriter(fps=fps, codec="h264", extra_args=["-f", "mp4"])
    with writer.saving(figure, str(file), figure.dpi):
        for _ in frames:
            writer.grab_frame()
