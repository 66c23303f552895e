"""Output of `clpt`: help pages, the version, tables, or one JSON object.

Help is plain text of 80 columns, on a terminal and in a pipe.  Values are named by shell words
(FILE, SECONDS, LAT LON), and a command's docstring ends in an example.
"""

import inspect
import json
import os
import re
import sys
from collections.abc import Callable, Iterable
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import typer
from typer.core import TyperCommand, TyperGroup

from ...base.errors import SimulationError
from ...base.files import write_file
from ...base.html import Result
from ...base.progress import discard, escaped

PACKAGES = ("control", "numpy", "scipy", "llvmlite", "xarray", "sympy")


class Command(TyperCommand):
    """A command whose values are named by shell words."""

    def format_options(self, ctx: Any, formatter: Any) -> None:
        """Write arguments and options."""
        rows: dict[str, list] = {"argument": [], "option": []}
        for param in self.get_params(ctx):
            words, about = param.get_help_record(ctx) or ("", "")
            is_argument = param.param_type_name == "argument"
            rows[param.param_type_name].append(
                (param.metavar if is_argument else words, about)
            )
        for title, lines in rows.items():
            if lines:
                with formatter.section(f"{title.title()}s"):
                    formatter.write_dl(lines)


class HelpPage(TyperGroup):
    """All commands, under the titles of their groups."""

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        """Write the commands in their order, a line each."""
        groups: dict[str, list] = {}
        for name, command in self.commands.items():
            row = name, command.get_short_help_str(70)
            groups.setdefault(command.rich_help_panel, []).append(row)  # type: ignore[attr-defined]
        for title, rows in groups.items():
            with formatter.section(title):
                formatter.write_dl(rows)


def help_of(command: Callable[..., Any]) -> str:
    """Return a docstring as help, in which the lines of an example stay as they are."""
    return re.sub(r"\n(\w[\w ]*:\n)", r"\n\b\n\1", inspect.getdoc(command) or "")


def _print_version(requested: bool) -> None:
    """Print the versions that a question or a bug report needs, and end."""
    if not requested:
        return
    import platform
    from importlib.metadata import version

    typer.echo(f"clpt-control {version('clpt-control')}")
    typer.echo(
        f"{'Python':12} {platform.python_version()} on {platform.platform(terse=True)}"
    )
    for name in PACKAGES:
        typer.echo(f"{name:12} {version(name)}")
    raise typer.Exit


def clpt(
    version: Annotated[
        bool,
        typer.Option(
            "--version", is_eager=True, callback=_print_version, help="Print versions."
        ),
    ] = False,
) -> None:
    """Adaptive learning for controlled Lagrangian particle tracking.

    To start:
        clpt paper                        section IV: its figures and claims
        clpt init mine.toml               a scenario of your own to change
        clpt run mine.toml --out run.nc   run it
        clpt COMMAND --help               what a command takes, with an example
    """


def opt(
    metavar: str, about: str, *names: str, default: Any = None, **options: Any
) -> Any:
    """Return an option: the word for its value, its help, names other than the parameter's.

    One whose default is ... is required.
    """
    return typer.Option(default, *names, metavar=metavar, help=about, **options)


annotated = partial(opt, default=...)  # in Annotated, whose parameter has the default


def flag(about: str, *names: str, default: Any = False) -> Any:
    """Return an option without a value: its help, names other than the parameter's."""
    return typer.Option(default, *names, help=about)


def arg(metavar: str, about: str, default: Any = ..., **settings: Any) -> Any:
    """Return an argument: its word and its help; one whose default is ... is required."""
    return typer.Argument(default, metavar=metavar, help=about, **settings)


def law_names(incomplete: str) -> list[str]:
    """Return the laws whose name begins so, for a shell that completes a word."""
    from ...paper.laws.table import LAWS

    return [name for name in LAWS if name.startswith(incomplete)]


# --- what commands take, and print ---------------------------------------------------------------

ScenarioFile = Annotated[
    Path, arg("SCENARIO", "A scenario's TOML file, or a run's NetCDF.")
]
Window = Annotated[
    float | None,
    annotated("TIME", "Length of the window; default: one cycle of waypoints."),
]
Start = Annotated[
    float | None, annotated("TIME", "Start of the window; default: the second cycle.")
]
Report = dict[str, Any]  # ready for JSON
PIPED = 140  # letters of a line that goes to no terminal
LONG = 40  # characters; longer cells are broken into lines
Json = Annotated[bool, flag("Print results as one JSON object.", "--json", default=...)]

Formats = Annotated[
    list[str] | None,
    annotated("FORMAT", "Format of the figures: png, svg, pdf; repeat it.", "--format"),
]


FIGURE = "a figure", (".png", ".pdf", ".svg")
SCENARIO = "a scenario", (".toml",)
RUN_FILE = "a run", (".nc",)


def draw_figure(path: Path | None, plot: Callable[..., Any], *args: Any) -> None:
    """Write what a plot draws of its arguments, where a figure has a path."""
    if path is not None:
        from ...base.figures import figure_of

        write_file(path, figure_of(plot, *args))


def print_json(value: Report) -> None:
    """Print one JSON object on standard output."""
    try:
        text = json.dumps(value, indent=1, allow_nan=False)
    except ValueError:
        raise SimulationError(
            "--json: a number is not finite, so JSON cannot represent it. Leave --json "
            "out to see which"
        ) from None
    say(text.replace("\x7f", "\\u007f"))


def say(text: str) -> None:
    """Print text on standard output, without characters that a terminal obeys."""
    _print(f"{escaped(text)}\n")


def _print(text: str) -> None:
    """Print; where the reader went away, the command comes to its end without."""
    try:
        sys.stdout.write(text)
        sys.stdout.flush()
    except BrokenPipeError:
        discard(sys.stdout)


def finish(
    results: Iterable[Result], report: Report, as_json: bool, *written: Path | None
) -> None:
    """Print a report as one JSON object, or results as tables and sentences; name files written."""
    if as_json:
        print_json(report)
        return
    for result in results:
        if result.columns:
            print_table(result)
        for sentence in result.sentences:
            say(sentence)
    for path in written:
        if path is not None:
            say(f"Wrote {path}")


def terminal_width() -> int:
    """Return how many letters a line has: the terminal's, or COLUMNS; 140 into files and pipes."""
    from rich.console import Console

    console = Console()
    return console.width if console.is_terminal or os.environ.get("COLUMNS") else PIPED


def print_table(result: Result) -> None:
    """Print a table on standard output, brackets in it as they are.

    No cell is cut: words of the first column and of long cells are broken into lines, and what
    is still too wide for the terminal is printed wider.
    """
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    title = Text(escaped(result.title))
    head = any(result.columns)  # else a column of names beside one of values
    table = Table(title=title, title_justify="left", show_header=head)
    lines = [[*map(escaped, line)] for line in (result.columns, *result.rows)]
    least = 1
    for k, cells in enumerate(zip(*lines, strict=True)):
        words = k == 0 and any(" " in cell for cell in cells)
        # numbers are never cut
        is_short = not words and all(len(cell) <= LONG for cell in cells)
        table.add_column(Text(cells[0]), no_wrap=is_short, overflow="fold")
        words_of_column = (
            cells if is_short else [word for cell in cells for word in cell.split()]
        )
        least += 3 + max(min(len(word), LONG) for word in words_of_column)
    for line in lines[1:]:
        table.add_row(*map(Text, line))
    console = Console(width=max(terminal_width(), least))
    with console.capture() as printed:
        console.print(table)
    _print(printed.get())


def cell_text(value: Any) -> str:
    """Return a value as a cell of a table."""
    if isinstance(value, float):
        return f"{value:.4g}"
    if isinstance(value, list | tuple):
        return ", ".join(cell_text(inner) for inner in value)
    return "none" if value is None else str(value)
