"""`clpt ensemble`: many runs of one scenario."""

from pathlib import Path
from typing import Annotated

import typer

from .help_pages import one_of, opt
from .printing import Json, ScenarioFile, check_figure, print_json, print_table, shown


def ensemble(
    scenario: ScenarioFile,
    members: Annotated[int, opt("COUNT", "How many runs.")],
    vary: Annotated[
        list[str], opt("KEY=LOW:HIGH", "Or KEY~normal:DEVIATION, or KEY=[VALUE, ...]; repeat it.")
    ],
    out: Annotated[Path, opt("FOLDER", "Zarr folder; if it holds a part, go on from there.")],
    design: Annotated[
        str,
        opt(
            "NAME",
            "lhs (Latin hypercube), grid or random.",
            autocompletion=one_of("lhs", "grid", "random"),
        ),
    ] = "lhs",
    seed: Annotated[int, opt("NUMBER", "Of the draws.")] = 0,
    threads: Annotated[int | None, opt("COUNT", "Default: all processors.")] = None,
    trajectories: Annotated[
        bool, typer.Option("--trajectories", help="Keep the states too.")
    ] = False,
    figure: Annotated[
        Path | None, opt("FILE", ".png, .pdf or .svg: percentiles of CLPE and errors.")
    ] = None,
    dask: Annotated[
        str | None, opt("ADDRESS", "Run on a cluster: tcp://HOST:PORT, or local.")
    ] = None,
    chunk: Annotated[int | None, opt("COUNT", "Members written at once.")] = None,
    samples: Annotated[int | None, opt("COUNT", "Samples a cycle for CLPE rms.")] = None,
    as_json: Json = False,
) -> None:
    r"""Run a scenario many times with values that vary.

    Example:
        clpt ensemble mine.toml --members 1000 --vary learning.gain=0.2:2.0 \
            --vary vehicle.position~normal:0.5 --out e.zarr --figure e.png
    """
    from ..ensemble.run import run_ensemble
    from ..ensemble.spread import ensemble_summary
    from ..files import write_figure
    from ..progress import progress_bar
    from ..scenario.file import load_scenario

    experiment = load_scenario(scenario)
    check_figure(figure)
    with progress_bar(f"running {scenario.name}", members, "members") as report:
        data = run_ensemble(
            experiment,
            vary,
            members,
            design,
            seed,
            out,
            threads=threads,
            trajectories=trajectories,
            chunk=chunk,
            samples=samples,
            progress=report,
            dask=dask,
        )
    summary = ensemble_summary(data)
    if figure is not None:
        from ..ensemble.spread import ensemble_plot
        from ..figures import figure_of

        write_figure(figure_of(ensemble_plot, data), figure)
    if as_json:
        print_json(summary)
        return
    length, time = experiment.units.length, experiment.units.time
    rows = []
    for number, column in enumerate(summary["clpe_rms_per_cycle"], 1):
        if number <= 3 or number == len(summary["clpe_rms_per_cycle"]):
            rows.append([f"CLPE rms, cycle {number} ({length})", *_cells(column)])
    rows.append([f"CLPE rms, whole run ({length})", *_cells(summary["clpe_rms"])])
    for key, name in (("flow_parameter_error", "flow parameter"), ("gain_error", "gain")):
        if f"{key}_at_end" in summary:
            end = f"t = {experiment.run.duration:g} {time}"
            rows.append([f"largest {name} error, {end}", *_cells(summary[f"{key}_at_end"])])
    columns = ["percentile", *(f"{p} %" for p in summary["percents"])]
    ended = ", ".join(
        f"{count} {name.replace('_', ' ')}" for name, count in summary["ended"].items()
    )
    print_table(f"{experiment.title or scenario}: {ended}", columns, rows)
    if "faster_flow" in summary and summary["faster_flow"]["members"]:
        faster = summary["faster_flow"]
        typer.echo(
            f"in {faster['members']} members the flow was faster than the vehicle, for at most "
            f"{100 * faster['largest_share']:.3g} % of the time and {faster['longest']:.3g} {time} "
            "in a stretch"
        )
    if summary["first_failed"] is not None:
        typer.echo(f"the first member that did not finish is {summary['first_failed']}")
    typer.echo(f"{out}: written")


def _cells(column: list[float] | None) -> list[str]:
    return ["-"] * 5 if column is None else [shown(value) for value in column]
