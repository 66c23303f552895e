"""`clpt diagram`: what is wired to what."""

from pathlib import Path
from typing import Annotated

import typer

from .printing import ScenarioFile


def diagram(
    scenario: ScenarioFile,
    out: Annotated[
        Path | None,
        typer.Option("-o", "--out", help=".svg, .png, .pdf or .mmd; default: Mermaid text."),
    ] = None,
    external: Annotated[
        list[str] | None, typer.Option(help="A port to take from outside, such as zc.")
    ] = None,
) -> None:
    """Draw a scenario's block diagram."""
    from ..diagrams.drawing import draw, mermaid
    from ..scenario.file import load_scenario
    from ..simulation.loops import closed_loop

    wired = closed_loop(load_scenario(scenario), external or ())
    if out is None:
        typer.echo(mermaid(wired))
        return
    draw(wired, out)
    typer.echo(f"{out}: written")
