"""What commands print: one JSON object, or a table."""

import json
import os
import sys
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Annotated, Any

from ..errors import SimulationError
from ..files import check_writable, write_figure
from ..html import Result
from ..progress import let_go, plain
from .help_pages import arg, flag, opt

ScenarioFile = Annotated[Path, arg("SCENARIO", "A scenario's TOML file, or a run's NetCDF.")]
Window = Annotated[
    float | None, opt("TIME", "Length of the window; default: one cycle of waypoints.", default=...)
]
Start = Annotated[
    float | None, opt("TIME", "Start of the window; default: the second cycle.", default=...)
]
PIPED = 140  # letters of a line that goes to no terminal
LONG = 40  # characters; longer cells are broken into lines
Json = Annotated[
    bool,
    flag(
        "Print one JSON object and nothing else; a mistake is told on standard error.",
        "--json",
        default=...,
    ),
]

Formats = Annotated[
    list[str] | None,
    opt("FORMAT", "Format of the figures: png, svg, pdf; repeat it.", "--format", default=...),
]


def check_figure(path: Path | None) -> None:
    """Refuse a figure that cannot be written, before work begins."""
    if path is not None:
        check_writable(path, "a figure", (".png", ".pdf", ".svg"))


def check_scenario(path: Path | None) -> None:
    """Refuse a scenario's file that cannot be written, before work begins."""
    if path is not None:
        check_writable(path, "a scenario", (".toml",))


def draw_figure(path: Path | None, plot: Callable[..., Any], *given: Any) -> None:
    """Write what a plot draws, where a figure is asked for."""
    if path is not None:
        from ..figures import figure_of

        write_figure(figure_of(plot, *given), path)


def print_json(value: dict[str, Any]) -> None:
    """Print one JSON object on standard output."""
    try:
        text = json.dumps(value, indent=1, allow_nan=False)
    except ValueError:
        raise SimulationError(
            "--json: a figure is not finite, which JSON cannot hold; leave --json out to see which"
        ) from None
    say(text.replace("\x7f", "\\u007f"))


def say(text: str) -> None:
    """Print text on standard output, as it may be shown."""
    _print(f"{plain(text)}\n")


def _print(text: str) -> None:
    """Print; where the reader went away, the command comes to its end without."""
    try:
        sys.stdout.write(text)
        sys.stdout.flush()
    except BrokenPipeError:
        let_go(sys.stdout)


def finish(
    found: Iterable[Result], report: dict[str, Any], as_json: bool, *written: Path | None
) -> None:
    """Print what was found, as one JSON object or as tables and sentences; name files written."""
    if as_json:
        print_json(report)
        return
    for one in found:
        if one.columns:
            print_table(one.title, one.columns, one.rows)
        for sentence in one.sentences:
            say(sentence)
    for path in written:
        if path is not None:
            say(f"{path}: written")


def terminal_width() -> int:
    """Return how many letters a line has: the terminal's, or COLUMNS; 140 into files and pipes."""
    from rich.console import Console

    console = Console()
    return console.width if console.is_terminal or os.environ.get("COLUMNS") else PIPED


def print_table(title: str, columns: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """Print a table on standard output, brackets in it as they are.

    No cell is cut: words of the first column and of long cells are broken into lines, and what
    is still too wide for the terminal is printed wider.
    """
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table(title=Text(plain(title)), title_justify="left")
    columns, rows = [plain(one) for one in columns], [[plain(one) for one in row] for row in rows]
    least = 1
    for k, column in enumerate(columns):
        cells = [column, *(row[k] for row in rows)]
        words = k == 0 and any(" " in cell for cell in cells)
        whole = not words and all(len(cell) <= LONG for cell in cells)  # numbers are never cut
        table.add_column(Text(column), no_wrap=whole, overflow="fold")
        parts = cells if whole else [word for cell in cells for word in cell.split()]
        least += 3 + max(min(len(part), LONG) for part in parts)
    for row in rows:
        table.add_row(*map(Text, row))
    console = Console(width=max(terminal_width(), least))
    with console.capture() as printed:
        console.print(table)
    _print(printed.get())


def shown(value: Any) -> str:
    """Return a value as a table shows it."""
    if isinstance(value, float):
        return f"{value:.4g}"
    if isinstance(value, list | tuple):
        return ", ".join(shown(inner) for inner in value)
    return str(value)
