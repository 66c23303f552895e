"""`clpt ensemble`: many runs of one scenario."""

from pathlib import Path
from typing import Annotated

import typer

from .help_pages import one_of, opt
from .printing import Json, ScenarioFile, check_figure, finish

MOST_CYCLES = 4  # rows of the table


def ensemble(
    scenario: ScenarioFile,
    members: Annotated[int, opt("COUNT", "How many runs.")],
    vary: Annotated[
        list[str],
        opt("KEY=LOW:HIGH", "A range, KEY~normal:DEVIATION or KEY=[VALUE, ...]; repeat it."),
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
    seed: Annotated[int, opt("NUMBER", "Seed of the draws.")] = 0,
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
    from ..pages.ensemble_page import ensemble_result
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
    found = ensemble_result(data, summary, experiment.title or str(scenario), MOST_CYCLES)
    finish(found, summary, as_json, out)
