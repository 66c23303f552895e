"""`clpt paper`: section IV and its claims."""

from pathlib import Path
from typing import Annotated

import typer

from .printing import Json, print_json, print_table


def paper(
    out: Annotated[Path, typer.Option(help="Folder for figures and run.nc.")] = Path("paper"),
    as_json: Json = False,
) -> None:
    """Run section IV of the paper and judge its claims."""
    from ..files import make_folder
    from ..progress import progress_bar
    from ..scenario.file import paper_scenario
    from ..simulation.plots import save_figures
    from ..simulation.report import claims, run_and_report
    from ..simulation.run_file import save_run

    scenario, folder = paper_scenario(), make_folder(out)
    with progress_bar("section IV", scenario.run.duration) as report:
        run, fine, summary = run_and_report(scenario, report)
    save_run(run, folder / "run.nc")
    save_figures(fine, scenario, folder)
    summary["claims"] = claims(summary)
    if as_json:
        print_json(summary)
        return
    print_table(
        "Claims of section IV",
        ["claim", "criterion", "measured", "verdict"],
        [list(claim.values()) for claim in summary["claims"]],
    )
    typer.echo(f"{folder}: figure1.png to figure4.png, run.nc")
