"""What is sent or shown: `clpt report` writes a page, `clpt animate` a moving picture."""

from pathlib import Path

import clpt_control as clpt

from ..html import Result
from .help_pages import arg, opt
from .printing import Formats, Json, finish, say


def report(
    run: Path = arg("RUN", "run.nc, a team's too; an ensemble's folder; replay.nc or its JSON."),
    out: Path = opt("FILE", "The page, .html.", "-o", "--out", default=Path("report.html")),
    title: str | None = opt("TITLE", "In place of the scenario's."),
    figures: Path | None = opt("FOLDER", "Folder for the figures too, as SVG and PDF."),
    formats: Formats = None,
    as_json: Json = False,
) -> None:
    """Write a page to send: one HTML file that needs nothing else.

    Example:
        clpt report run.nc -o report.html
    """
    made = clpt.report(run, out, title, figures, formats or ("svg", "pdf"))
    written = f"{out}: written, {made['bytes'] / 1000:.0f} kB"
    finish([Result("", [], [], [*made["sentences"], written])], made, as_json)


def animate(
    run: Path = arg("RUN", "A run's NetCDF."),
    out: Path = opt(
        "FILE",
        "The film: .gif, or .mp4 where ffmpeg is installed.",
        "-o",
        "--out",
        default=Path("run.gif"),
    ),
    start: float | None = opt("TIME", "First time shown; default: the run's."),
    end: float | None = opt("TIME", "Last time shown; default: the run's."),
    seconds: float = opt("SECONDS", "How long the film lasts.", default=12.0),
    fps: float = opt("NUMBER", "Frames a second.", default=12.5),
    width: int = opt("PIXELS", "Pixels.", default=560),
) -> None:
    """Make a moving picture of a run.

    It shows the vehicle and its prediction, the true and the learned flow, and CLPE.

    Example:
        clpt animate run.nc -o run.gif
    """
    from ..simulation.film import check_options

    check_options(out, seconds, fps, width)
    data = clpt.load_run(run)
    clpt.animate(data, out, start=start, end=end, seconds=seconds, fps=fps, width=width)
    say(f"{out}: written")
