"""The command `clpt`.

Results go to standard output, progress and complaints to standard error.  Exit
status 0 is done, 1 a run that failed, 2 a user's mistake, 130 an interrupt;
each failure is one sentence.  Commands import what they need when they run, so
that `clpt --help` answers at once.
"""

import json
import sys
from pathlib import Path
from typing import Annotated, Any

import typer

from .errors import ClptError, SimulationError

INTERRUPTED = "interrupted; nothing half-written was left"

app = typer.Typer(
    name="clpt",
    help="Adaptive learning for controlled Lagrangian particle tracking.",
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
)

ScenarioFile = Annotated[Path, typer.Argument(help="A scenario's TOML file, or a run's NetCDF.")]
Json = Annotated[bool, typer.Option("--json", help="Print one JSON object and nothing else.")]


def _print_json(value: dict[str, Any]) -> None:
    typer.echo(json.dumps(value, indent=1, allow_nan=False))


def _table(title: str, columns: list[str], rows: list[list[str]]) -> None:
    from rich.console import Console
    from rich.table import Table

    table = Table(title=title, title_justify="left")
    for column in columns:
        table.add_column(column)
    for row in rows:
        table.add_row(*row)
    console = Console()
    if not console.is_terminal:
        console = Console(width=140)
    console.print(table)


@app.command()
def init(
    file: Annotated[Path, typer.Argument(help="Where to write it.")] = Path("paper.toml"),
) -> None:
    """Write the paper's scenario, commented, to start from."""
    from .files import write_text
    from .paper import paper_text

    if file.exists():
        raise ClptError(f"{file}: exists already; name another file, or move this one away")
    write_text(file, paper_text())
    typer.echo(f"{file}: written; run it with `clpt run {file} --out run.nc`")


@app.command()
def paper(
    out: Annotated[Path, typer.Option(help="Folder for figures and run.nc.")] = Path("paper"),
    as_json: Json = False,
) -> None:
    """Run section IV of the paper and judge its claims."""
    from .files import make_folder
    from .paper import paper_scenario
    from .plotting import save_figures
    from .progress import progress_bar
    from .report import claims, run_and_report
    from .runs import save_run

    scenario, folder = paper_scenario(), make_folder(out)
    with progress_bar("section IV", scenario.run.duration) as report:
        run, fine, summary = run_and_report(scenario, report)
    save_run(run, folder / "run.nc")
    save_figures(fine, scenario, folder)
    summary["claims"] = claims(summary)
    if as_json:
        _print_json(summary)
        return
    _table(
        "Claims of section IV",
        ["claim", "criterion", "measured", "verdict"],
        [list(claim.values()) for claim in summary["claims"]],
    )
    typer.echo(f"{folder}: figure1.png to figure4.png, run.nc")


@app.command()
def run(
    scenario: ScenarioFile,
    out: Annotated[Path, typer.Option(help="NetCDF file for the run.")],
    figures: Annotated[Path | None, typer.Option(help="Folder for four figures.")] = None,
    as_json: Json = False,
) -> None:
    """Run a scenario."""
    from .files import check_writable, make_folder
    from .progress import progress_bar
    from .report import run_and_report
    from .runs import save_run
    from .scenario_file import load_scenario

    experiment = load_scenario(scenario)
    check_writable(out)
    folder = None if figures is None else make_folder(figures)
    with progress_bar(f"running {scenario.name}", experiment.run.duration) as report:
        result, fine, summary = run_and_report(experiment, report)
    save_run(result, out)
    if folder is not None:
        from .plotting import save_figures

        save_figures(fine, experiment, folder)
    if as_json:
        _print_json(summary)
        return
    rows = [["status", summary["message"]]]
    unit = experiment.units.length
    rms = summary["clpe_rms_per_cycle"]
    if rms:
        shown = ", ".join(f"{value:.3g}" for value in rms[:10]) + (", ..." if rms[10:] else "")
        rows.append([f"CLPE rms per cycle ({unit})", shown])
    rows.append([f"CLPE rms, whole run ({unit})", f"{summary['clpe_rms']:.3g}"])
    rows.append([f"CLPE rms, last quarter ({unit})", f"{summary['clpe_rms_last_quarter']:.3g}"])
    for key, name in (
        ("max_flow_parameter_error", "largest flow parameter error"),
        ("max_gain_error", "largest gain error"),
    ):
        if summary.get(key):
            time, error = list(summary[key].items())[-1]
            rows.append([name, f"{error:.3g} at t = {time} {experiment.units.time}"])
    for place, share in summary.get("explained_variance", {}).items():
        if isinstance(share, float):
            worse = "; negative: worse than no flow" if share < 0 else ""
            rows.append([f"share of the flow's variance learned, {place}", f"{share:.3f}{worse}"])
    _table(experiment.title or str(scenario), ["", ""], rows)
    typer.echo(f"{out}: written")


@app.command()
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
    from .diagram import closed_loop
    from .drawing import draw, mermaid
    from .scenario_file import load_scenario

    wired = closed_loop(load_scenario(scenario), external or ())
    if out is None:
        typer.echo(mermaid(wired))
        return
    draw(wired, out)
    typer.echo(f"{out}: written")


@app.command()
def fit(
    currents: Annotated[Path, typer.Argument(help="NetCDF file of a gridded current.")],
    out: Annotated[Path, typer.Option(help="Scenario file to write; the field lies beside it.")],
    box: Annotated[
        tuple[float, float, float, float] | None,
        typer.Option(help="LAT0 LAT1 LON0 LON1, degrees."),
    ] = None,
    centers: Annotated[str, typer.Option(help="Places of the functions, such as 3x3.")] = "3x3",
    width: Annotated[str, typer.Option(help="Width of the Gaussians, such as 15km.")] = "15km",
    constituents: Annotated[
        str, typer.Option(help="steady and named tides, such as steady,M2.")
    ] = "steady,M2",
    start_from_fit: Annotated[
        bool, typer.Option("--start-from-fit", help="Let the learner start with the fit.")
    ] = False,
    as_json: Json = False,
) -> None:
    """Fit flow basis functions to a measured current."""
    from .ocean.fit import fit_scenario, read_centers, read_width, save_fit

    fitted = fit_scenario(
        currents,
        box,
        centers=read_centers(centers),
        width_km=read_width(width),
        constituents=tuple(name.strip() for name in constituents.split(",")),
        start_from_fit=start_from_fit,
    )
    save_fit(fitted, out)
    if as_json:
        _print_json(fitted.report)
        return
    rows = [
        [key.replace("_", " "), _shown(value)]
        for key, value in fitted.report.items()
        if key != "theta" and value != []
    ]
    _table(f"{out}: written, with the field beside it", ["", ""], rows)


def _shown(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.4g}"
    if isinstance(value, list | tuple):
        return ", ".join(_shown(inner) for inner in value)
    return str(value)


def main() -> None:
    """Run the command line; a failure is a sentence and a status."""
    try:
        status = app(standalone_mode=False)
    except SimulationError as error:
        _complain(str(error), 1)
    except ClptError as error:
        _complain(str(error), 2)
    except typer.TyperException as error:
        _complain(error.format_message(), 2)
    except (KeyboardInterrupt, typer.Abort):
        _complain(INTERRUPTED, 130)
    except BrokenPipeError:
        sys.exit(0)
    except MemoryError:
        _complain("out of memory; record fewer samples (run.output_step)", 1)
    if status == 130:
        _complain(INTERRUPTED, 130)
    sys.exit(status if isinstance(status, int) else 0)


def _complain(sentence: str, status: int) -> None:
    line = " ".join(sentence.split())
    typer.echo(f"clpt: {line}", err=True)
    sys.exit(status)
