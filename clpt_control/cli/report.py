"""`clpt report`: a page to send."""

from pathlib import Path
from typing import Annotated

import typer

from .help_pages import arg, opt
from .printing import Formats, Json, print_json


def report(
    run: Annotated[
        Path, arg("RUN", "run.nc, a team's too; an ensemble's folder; replay.nc or its JSON.")
    ],
    out: Annotated[Path, opt("FILE", "The page, .html.", "-o", "--out")] = Path("report.html"),
    title: Annotated[str | None, opt("TITLE", "In place of the scenario's.")] = None,
    figures: Annotated[
        Path | None, opt("FOLDER", "Folder for the figures too, as SVG and PDF.")
    ] = None,
    formats: Formats = None,
    as_json: Json = False,
) -> None:
    """Write a page to send: one HTML file that needs nothing else.

    Example:
        clpt report run.nc -o report.html
    """
    from ..pages import report as written

    made = written(run, out, title, figures, formats or ("svg", "pdf"))
    if as_json:
        print_json(made)
        return
    for sentence in made["sentences"]:
        typer.echo(sentence)
    typer.echo(f"{out}: written, {made['bytes'] / 1000:.0f} kB")
