"""What commands print: one JSON object, or a table."""

import json
from pathlib import Path
from typing import Annotated, Any

import typer

ScenarioFile = Annotated[Path, typer.Argument(help="A scenario's TOML file, or a run's NetCDF.")]
LONG = 40  # characters; longer cells are broken into lines
Json = Annotated[bool, typer.Option("--json", help="Print one JSON object and nothing else.")]


def print_json(value: dict[str, Any]) -> None:
    """Print one JSON object on standard output."""
    typer.echo(json.dumps(value, indent=1, allow_nan=False))


def print_table(title: str, columns: list[str], rows: list[list[str]]) -> None:
    """Print a table on standard output, brackets in it as they are."""
    from rich.console import Console
    from rich.measure import Measurement
    from rich.table import Table
    from rich.text import Text

    table = Table(title=Text(title), title_justify="left")
    for k, column in enumerate(columns):
        short = all(len(row[k]) <= LONG for row in rows)  # numbers are never cut
        table.add_column(Text(column), no_wrap=short)
    for row in rows:
        table.add_row(*map(Text, row))
    console = Console()
    width = console.width if console.is_terminal else 140
    least = Measurement.get(Console(width=1000), Console(width=1000).options, table).minimum
    Console(width=max(width, least)).print(table)


def shown(value: Any) -> str:
    """Return a value as a table shows it."""
    if isinstance(value, float):
        return f"{value:.4g}"
    if isinstance(value, list | tuple):
        return ", ".join(shown(inner) for inner in value)
    return str(value)
