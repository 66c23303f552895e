"""`clpt init`: a scenario to start from."""

from pathlib import Path
from typing import Annotated

import typer

from ..errors import ClptError


def init(
    file: Annotated[Path, typer.Argument(help="Where to write it.")] = Path("paper.toml"),
) -> None:
    """Write the paper's scenario, commented, to start from."""
    from ..files import check_name, write_text
    from ..scenario.file import paper_text

    check_name(file)
    if file.exists():
        raise ClptError(f"{file}: exists already; name another file, or move this one away")
    write_text(file, paper_text())
    typer.echo(f"{file}: written; run it with `clpt run {file} --out run.nc`")
