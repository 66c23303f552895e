"""`clpt run`: one scenario."""

from pathlib import Path
from typing import Annotated

import typer

from .printing import Json, ScenarioFile, print_json, print_table


def run(
    scenario: ScenarioFile,
    out: Annotated[Path, typer.Option(help="NetCDF file for the run.")],
    figures: Annotated[Path | None, typer.Option(help="Folder for four figures.")] = None,
    as_json: Json = False,
) -> None:
    """Run a scenario."""
    from ..files import check_writable, make_folder
    from ..progress import progress_bar
    from ..scenario.file import load_scenario
    from ..simulation.report import run_and_report
    from ..simulation.run_file import save_run

    experiment = load_scenario(scenario)
    check_writable(out)
    folder = None if figures is None else make_folder(figures)
    with progress_bar(f"running {scenario.name}", experiment.run.duration) as report:
        result, fine, summary = run_and_report(experiment, report)
    save_run(result, out)
    if folder is not None:
        from ..simulation.plots import save_figures

        save_figures(fine, experiment, folder)
    if as_json:
        print_json(summary)
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
    print_table(experiment.title or str(scenario), ["", ""], rows)
    typer.echo(f"{out}: written")
