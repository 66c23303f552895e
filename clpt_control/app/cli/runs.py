"""Commands on scenarios and runs.

One scenario: `clpt init`, `clpt paper`, `clpt run`, `clpt export`.  Many runs: `clpt ensemble`,
with values that vary; `clpt tune`, which chooses law and gains, or waypoints.  Reports: `clpt
report` writes an HTML report, or a film.
"""

import os
from contextlib import suppress
from importlib import resources
from pathlib import Path
from typing import Any

import typer

import clpt_control as clpt

from ...base.errors import ClptError, refuse_unused
from ...base.files import check_writable, make_folder, write_together
from ...base.html import Result
from ...base.progress import progress_bar
from .printing import (
    FIGURE,
    RUN_FILE,
    SCENARIO,
    Formats,
    Json,
    Report,
    ScenarioFile,
    Start,
    Window,
    arg,
    cell_text,
    draw_figure,
    finish,
    flag,
    law_names,
    opt,
    say,
)
from .tracks import tune_waypoints

MOST_SHOWN = 15  # candidates in the table; --json has all
RUN = "Run it with: clpt run {} --out run.nc"
FIT = "Fit it with: clpt fit {} --out mine.toml"
EXAMPLES = {  # of `clpt init`: the name that it is given, the file in the package, what to do then
    "paper": ("paper.toml", "paper.toml", RUN),
    "team": ("team.toml", "team.toml", RUN),
    "currents": ("currents.nc", "maracoos_hfr_2019-01-01.nc", FIT),
}


def init(
    file: Path | None = arg(
        "FILE", "File to write. Default: the name of the example.", default=None
    ),
    example: str = opt(
        "NAME", f"Example to write: {', '.join(EXAMPLES)}.", default="paper"
    ),
) -> None:
    """Write an example to start from: a scenario, by default.

    The paper's scenario, commented; a team's; or a measured current for `clpt fit`.

    Example:
        clpt init mine.toml
    """
    if example not in EXAMPLES:
        raise ClptError(f"--example {example}: must be one of {', '.join(EXAMPLES)}")
    name, source, then = EXAMPLES[example]
    file = file or Path(name)
    if os.path.lexists(file):
        raise ClptError(
            f"{file}: already exists. Give another name, or move the file away"
        )
    content = (resources.files("clpt_control.data") / source).read_bytes()
    write_together({file: content})
    say(f"Wrote {file}. {then.format(file)}")


INTERPRETATION = (
    "Kernel exp(-d/(2 sigma)), periods in the unit of the run: the print allows five other "
    "interpretations, compared in docs/interpretations.md."
)


def paper(
    out: Path = opt("FOLDER", "Folder for figures and run.nc.", default=Path("paper")),
    formats: Formats = None,
    as_json: Json = False,
) -> None:
    """Run section IV of the paper and judge its claims.

    Example:
        clpt paper --out paper
    """
    from ...base.figures import checked_formats
    from ...simulation.run_file import as_written
    from ...simulation.summary import claims, run_and_report
    from ..pages.results import claims_result

    kinds = checked_formats(formats or ["png"])
    scenario = clpt.paper_scenario()
    folder = make_folder(out)
    with progress_bar("section IV", scenario.run.duration) as report:
        run, fine, summary = run_and_report(scenario, report)
    drawn = _run_figures(fine, folder, kinds)
    file = folder / "run.nc"
    write_together({file: as_written(run, file), **drawn})
    summary["claims"] = claims(summary)
    first_figure, *_, last_figure = drawn
    sentences = [
        f"{folder}: {first_figure.name} to {last_figure.name}, run.nc",
        INTERPRETATION,
    ]
    finish(
        [claims_result(summary["claims"])._replace(sentences=sentences)],
        summary,
        as_json,
    )


def run(
    scenario: ScenarioFile,
    out: Path = opt("FILE", "NetCDF file for the run.", default=...),
    figures: Path | None = opt("FOLDER", "Folder for the figures."),
    formats: Formats = None,
    as_json: Json = False,
) -> None:
    """Run a scenario, or a team: a scenario with a table [team].

    Example:
        clpt run mine.toml --out run.nc --figures figures
    """
    from ...base.figures import checked_formats
    from ...simulation.run_file import as_written, recorded_arguments
    from ...theory.excitation.gramian import not_learned

    if formats and figures is None:
        raise ClptError("--format: is of the figures. Give --figures FOLDER")
    kinds = checked_formats(formats or ["png"])
    system = clpt.load_scenario(scenario)
    check_writable(out, *RUN_FILE)
    folder = None if figures is None else make_folder(figures)
    arguments = recorded_arguments(scenario)
    if "timepts" in arguments:
        from ..pages.run_page import extent_of, response_result

        result = fine = clpt.simulate(system, **arguments)
        summary = {name: result.attrs[name] for name in ("title", "status", "message")}
        table, summary["signals"] = response_result(result), extent_of(result)
    else:
        from ...simulation.summary import run_and_report
        from ..pages.results import run_result

        with progress_bar(f"running {scenario.name}", system.run.duration) as report:
            result, fine, summary = run_and_report(system, report, **arguments)
        table = run_result(summary, summary["title"] or str(scenario))
        if missing := not_learned(result):
            table = table._replace(sentences=[*table.sentences, missing])
            summary["not_learnable"] = missing
    write_together({out: as_written(result, out)})  # before a figure may fail
    if folder is not None:
        write_together(_run_figures(fine, folder, kinds))
    finish([table], summary, as_json, out)


def _run_figures(run: Any, folder: Path, kinds: tuple[str, ...]) -> dict[Path, Any]:
    """Return the figures of a run by file: figure1.png to figure4.png, or team.png.

    Figures 1 to 4 are the track, CLPE, and the learning of both axes.
    """
    from ...base.figures import figure_of
    from ...base.run_attributes import TEAM
    from ...simulation.run_plots import clpe_plot, learning_plot, team_plot
    from ...simulation.track_chart import track_plot

    plots: dict[str, Any] = {
        "figure1": (track_plot,),
        "figure2": (clpe_plot,),
        "figure3": (learning_plot, 1),
        "figure4": (learning_plot, 2),
    }
    if TEAM in run.attrs:
        plots = {"team": (team_plot,)}
    figures: dict[Path, Any] = {}
    for name, (plot, *axis) in plots.items():
        figure = figure_of(plot, run, *axis)
        figures |= {folder / f"{name}.{kind}": figure for kind in kinds}
    return figures


def export(
    scenario: ScenarioFile,
    out: Path | None = opt(
        "FILE",
        "File to write: C (.c), an FMU (.fmu), a run's track (.kml, .geojson), learned flow "
        "(.nc) or table (.csv, .mat), an ensemble's table (.csv), with "
        "--drawing .svg, .png, .pdf or .mmd; default of a drawing: Mermaid text.",
        "-o",
        "--out",
    ),
    drawing: bool = flag("Draw the block diagram.", "--drawing"),
    part: str | None = opt(
        "NAME", "learner: law, model and controller alone, for a computer on board."
    ),
    single: bool = flag("Write C with float in place of double.", "--single"),
    watch: bool = flag(
        "With --part: carry |Phi|, a bound of the errors, beside the learner.",
        "--watch",
    ),
) -> None:
    """Write a loop as C99, FMU or drawing; a run as a map or table.

    Example:
        clpt export mine.toml -o loop.c
        clpt export mine.toml --part learner -o learner.c
        clpt export run.nc -o track.kml
        clpt export run.nc -o map.nc
        clpt export run.nc -o run.csv
        clpt export mine.toml --drawing -o loop.svg
    """
    from ...base.files.reading import open_netcdf
    from ...paper.scenario.file import load_vehicle_scenario
    from ...paper.scenario.recorded_run import kind_of
    from ...simulation.program_export import SUFFIXES

    if single and (drawing or (out and out.suffix not in (".c", ".h"))):
        raise ClptError(f"--single: is of C, not of {out}. Leave it out")
    if drawing:
        _draw_diagram(scenario, out)
        return
    if out is None:
        raise ClptError("--out: is missing. Give a file that ends in .c or .fmu")
    if out.suffix in (".csv", ".mat"):
        from ..pages.writing import read

        read(scenario).clpt.table(out)
    elif out.suffix in (*SUFFIXES, ".nc"):
        with open_netcdf(scenario) as data:
            estimate = data.load() if kind_of(data) == "fixes" else None
        clpt.export(clpt.load_run(scenario) if estimate is None else estimate, out)
    else:
        check_writable(
            out, "a program or map", (".c", ".h", ".fmu", ".csv", *SUFFIXES, ".nc")
        )
        loaded = load_vehicle_scenario(scenario)
        blocks = clpt.gramian(loaded).watch if watch else ()
        clpt.export(loaded, out, part=part, single=single, watch=blocks)
    say(f"Wrote {out}")


def _draw_diagram(scenario: Path, out: Path | None) -> None:
    """Draw a scenario's block diagram into a file, or print it as Mermaid text."""
    from ...paper.scenario.file import load_vehicle_scenario

    wired = clpt.closed_loop(load_vehicle_scenario(scenario))
    if out is None:
        from ...plots.drawing.figure import mermaid

        say(mermaid(wired))
        return
    clpt.draw(wired, out)
    say(f"Wrote {out}")


# --- many runs -----------------------------------------------------------------------------------


def _keys_to_vary(ctx: typer.Context, incomplete: str) -> list[str]:
    """Return the keys of the scenario named before that begin so."""
    from ...ensemble.varied_scenario import variable_values

    scenario = clpt.paper_scenario()
    with suppress(ClptError):
        scenario = clpt.load_scenario(ctx.params.get("scenario", ""))
    keys = variable_values(scenario)
    return [f"{key}=" for key in keys if key.startswith(incomplete)]


def ensemble(
    scenario: ScenarioFile,
    members: int | None = opt("COUNT", "Number of runs; default: all values of lists."),
    vary: list[str] = opt(
        "KEY=LOW:HIGH",
        "A range, KEY~normal:DEVIATION or KEY=[VALUE, ...]; repeat it.",
        default=...,
        autocompletion=_keys_to_vary,
    ),
    out: Path = opt(
        "FOLDER", "Zarr folder; if it holds a part, go on from there.", default=...
    ),
    design: str | None = opt(
        "NAME",
        "lhs (Latin hypercube), grid or random; default: lhs, without --members grid.",
    ),
    seed: int = opt("NUMBER", "Seed of the draws.", default=0),
    threads: int | None = opt("COUNT", "Default: all processors."),
    trajectories: bool = flag("Keep the states too.", "--trajectories"),
    figure: Path | None = opt(
        "FILE", ".png, .pdf or .svg: percentiles of CLPE and errors."
    ),
    dask: str | None = opt("ADDRESS", "Run on a cluster: tcp://HOST:PORT, or local."),
    chunk: int | None = opt("COUNT", "Members written at once."),
    as_json: Json = False,
) -> None:
    r"""Run a scenario many times with values that vary.

    Example:
        clpt ensemble mine.toml --members 1000 --vary learning.gain=0.2:2.0 \
            --vary vehicle.position~normal:0.5 --out e.zarr --figure e.png
    """
    from ...ensemble.ensemble_statistics import ensemble_summary
    from ...ensemble.sampled_parameters import grid_count, read_varies
    from ...paper.scenario.file import load_vehicle_scenario
    from ..pages.ensemble_page import percentile_table

    experiment = load_vehicle_scenario(scenario)
    check_writable(figure, *FIGURE)
    count = grid_count(read_varies(vary)) if members is None else members
    with progress_bar(f"running {scenario.name}", count, "members") as report:
        data = clpt.run_ensemble(
            experiment,
            vary,
            members,
            design,
            seed,
            out,
            threads=threads,
            trajectories=trajectories,
            chunk=chunk,
            progress=report,
            dask=dask,
        )
    summary = ensemble_summary(data)
    draw_figure(figure, data.clpt.plot)
    table = percentile_table(summary, experiment.title or str(scenario))
    finish([table], summary, as_json, out)


def tune(
    scenario: ScenarioFile,
    out: Path | None = opt("FILE", "Scenario file to write, with the choice in it."),
    members: int = opt("COUNT", "Number of sampled flows.", default=24),
    prior: float | None = opt(
        "SPEED", "Standard deviation of flow parameters; default: 0.3 k R."
    ),
    unmodelled: float | None = opt(
        "SPEED", "Rms of flow beside the basis; default: the scenario's."
    ),
    law: list[str] | None = opt(
        "NAME", "A law to compare; repeat it; default: all.", autocompletion=law_names
    ),
    seed: int = opt("NUMBER", "Seed of the draws.", default=0),
    waypoints: bool = flag(
        "Find waypoints instead, from which most can be learned; needs --out.",
        "--waypoints",
    ),
    length: float | None = opt(
        "LENGTH",
        "With --waypoints: longest closed polygon; default: the scenario's own.",
    ),
    max_speed: float | None = opt(
        "SPEED", "With --waypoints: largest speed through the water; default: any."
    ),
    area: tuple[float, float, float, float] | None = opt(
        "X1FROM X1TO X2FROM X2TO",
        "With --waypoints: where it may drive; default: where it drives now.",
    ),
    window: Window = None,
    start: Start = None,
    goal: str = opt(
        "GOAL",
        "With --waypoints: law, the scenario's own learns soonest; kappa, the largest smallest "
        "eigenvalue.",
        "--for",
        default="law",
    ),
    figure: Path | None = opt(
        "FILE", "With --waypoints: .png, .pdf or .svg, old and new track."
    ),
    as_json: Json = False,
) -> None:
    """Choose law, gains and filter, or waypoints, for an unknown flow.

    Example:
        clpt tune mine.toml --law learned-flow --law sigma --out tuned.toml
        clpt tune mine.toml --waypoints --out better.toml --max-speed 1.5
    """
    if waypoints:
        search: dict[str, Any] = {
            "length": length,
            "max_speed": max_speed,
            "area": area,
            "window": window,
            "start": start,
            "goal": goal,
            "seed": seed,
        }
        tune_waypoints(scenario, out, search, figure, as_json)
        return
    reason = "is of --waypoints. Give that too, or leave it out"
    unused: dict[str, Any] = {"length": length, "max-speed": max_speed, "area": area}
    unused |= {"window": window, "start": start, "figure": figure}
    refuse_unused(reason, "--", **unused)
    from ...paper.scenario.file import load_vehicle_scenario

    experiment = load_vehicle_scenario(scenario)
    check_writable(out, *SCENARIO)
    with progress_bar(f"tuning {scenario.name}", 1.0) as report:
        tuned = clpt.tune_law(
            experiment,
            members=members,
            prior=prior,
            unmodelled=unmodelled,
            laws=law or (),
            seed=seed,
            progress=report,
        )
    if out is not None:
        clpt.save_scenario(tuned.scenario, out)
    finish([_result(tuned.report)], tuned.report, as_json, out)


TRIED = {  # what of a candidate is said, by key
    "law": "law",
    "gain": "gain",
    "held": "K, Gamma held",
    "filter": "filter",
    "error": "error at the end ({length}/{time})",
    "error_95": "95 %",
    "learning_time": "to a tenth ({time})",
    "clpe_rms": "CLPE rms ({length})",
    "failed": "failed runs",
}


def _result(report: Report) -> Result:
    units = report["units"]
    rows = [
        [cell_text(candidate[key]) for key in TRIED]
        for candidate in report["candidates"][:MOST_SHOWN]
    ]
    hidden = len(report["candidates"]) - MOST_SHOWN
    title = (
        f"{report['members']} flows drawn with a prior of {report['prior']:.3g} "
        f"{units['length']}/{units['time']}, the scenario's own flow unseen"
        f"{f'; {hidden} more candidates' if hidden > 0 else ''}"
    )
    columns = [words.format(**units) for words in TRIED.values()]
    skipped = [f"skipped {name}: {why}" for name, why in report["skipped"].items()]
    return Result(title, columns, rows, [*skipped, report["because"]])


# --- to show -------------------------------------------------------------------------------------


def report(
    run: Path = arg("RUN", "run.nc, a team's too; an ensemble's folder; replay.nc."),
    out: Path | None = opt(
        "FILE", "File to write; default: report.html, of a film run.gif.", "-o", "--out"
    ),
    title: str | None = opt("TITLE", "In place of the scenario's."),
    figures: Path | None = opt("FOLDER", "Folder for the figures too, as SVG and PDF."),
    formats: Formats = None,
    film: bool = flag(
        "Write a film instead: the vehicle and its prediction, both flows, CLPE.",
        "--film",
    ),
    seconds: float = opt("SECONDS", "Length of the film.", default=12.0),
    fps: float = opt("NUMBER", "Frames of the film in a second.", default=12.5),
    width: int = opt("PIXELS", "Width of the film, pixels.", default=560),
    as_json: Json = False,
) -> None:
    """Write an HTML report of a run: one file that needs no other.

    Example:
        clpt report run.nc -o report.html
        clpt report run.nc --film -o run.gif
    """
    if film:
        path = out or Path("run.gif")
        clpt.animate(clpt.load_run(run), path, seconds=seconds, fps=fps, width=width)
        finish([], {"film": str(path)}, as_json, path)
        return
    out = out or Path("report.html")
    page = clpt.report(run, out, title, figures, formats or ("svg", "pdf"))
    written = f"Wrote {out}, {page['bytes'] / 1000:.0f} kB"
    finish([Result(sentences=[*page["sentences"], written])], page, as_json)
