"""`clpt animate`: a run as a moving picture."""

from pathlib import Path
from typing import Annotated

import typer


def animate(
    run: Annotated[Path, typer.Argument(metavar="RUN", help="A run's NetCDF.")],
    out: Annotated[
        Path,
        typer.Option(
            "-o", "--out", metavar="FILE", help="The film: .gif, or .mp4 where ffmpeg is installed."
        ),
    ] = Path("run.gif"),
    start: Annotated[
        float | None, typer.Option(metavar="TIME", help="First time shown; default: the run's.")
    ] = None,
    end: Annotated[
        float | None, typer.Option(metavar="TIME", help="Last time shown; default: the run's.")
    ] = None,
    seconds: Annotated[
        float, typer.Option(metavar="SECONDS", help="How long the film lasts.")
    ] = 12.0,
    fps: Annotated[float, typer.Option(metavar="NUMBER", help="Frames a second.")] = 12.5,
    width: Annotated[int, typer.Option(metavar="PIXELS", help="Pixels.")] = 560,
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
