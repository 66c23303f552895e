"""`clpt animate`: a run as a moving picture."""

from pathlib import Path
from typing import Annotated

import typer

from .help_pages import arg, opt


def animate(
    run: Annotated[Path, arg("RUN", "A run's NetCDF.")],
    out: Annotated[
        Path, opt("FILE", "The film: .gif, or .mp4 where ffmpeg is installed.", "-o", "--out")
    ] = Path("run.gif"),
    start: Annotated[float | None, opt("TIME", "First time shown; default: the run's.")] = None,
    end: Annotated[float | None, opt("TIME", "Last time shown; default: the run's.")] = None,
    seconds: Annotated[float, opt("SECONDS", "How long the film lasts.")] = 12.0,
    fps: Annotated[float, opt("NUMBER", "Frames a second.")] = 12.5,
    width: Annotated[int, opt("PIXELS", "Pixels.")] = 560,
) -> None:
    """Make a moving picture of a run.

    It shows the vehicle and its prediction, the true and the learned flow, and CLPE.

    Example:
        clpt animate run.nc -o run.gif
    """
    from ..simulation.film import animate, check_options
    from ..simulation.run_file import load_run

    check_options(out, seconds, fps, width)
    animate(load_run(run), out, start=start, end=end, seconds=seconds, fps=fps, width=width)
    typer.echo(f"{out}: written")
