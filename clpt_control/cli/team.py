"""What `clpt run` and `clpt excitation` do with a team's file."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from .printing import print_json, print_table

if TYPE_CHECKING:
    from ..scenario.team import Team

MOST_ROWS = 8  # vehicles in the table; --json has all


def run_and_print(
    team: "Team", name: str, out: Path, folder: Path | None, kinds: Sequence[str], as_json: bool
) -> None:
    """Run a team, write its file and figure, and print what it achieved."""
    from ..progress import progress_bar
    from ..simulation.run_file import save_run
    from ..simulation.team_report import run_team

    with progress_bar(f"running {name}", team.run.duration) as report:
        run, summary = run_team(team, report)
    save_run(run, out)
    if folder is not None:
        from ..figures import figure_of
        from ..files import write_together
        from ..simulation.team_plots import team_plot

        figure = figure_of(team_plot, run)
        write_together({folder / f"team.{kind}": figure for kind in kinds})
    if as_json:
        print_json(summary)
        return
    unit, end = summary["units"]["length"], f"{summary['end']:g} {summary['units']['time']}"
    rows = [
        ["status", summary["message"]],
        ["coupling kappa, connectivity lambda_2", f"{team.coupling:g}, {team.connectivity:.3g}"],
        [f"largest disagreement at t = {end}", f"{_last(summary['max_disagreement']):.3g}"],
    ]
    for vehicle in summary["vehicles"][:MOST_ROWS]:
        late = summary["clpe_rms_last_quarter"][vehicle]
        rows.append([f"{vehicle}: CLPE rms, last quarter ({unit})", f"{late:.3g}"])
        for key, said in (
            ("max_flow_parameter_error", "largest flow parameter error"),
            ("max_gain_error", "largest gain error"),
        ):
            if key in summary:
                error = _last(summary[key][vehicle])
                rows.append([f"{vehicle}: {said} at t = {end}", f"{error:.3g}"])
        for place, share in summary.get("explained_variance", {}).get(vehicle, {}).items():
            if isinstance(share, float):
                rows.append([f"{vehicle}: share of the flow's variance, {place}", f"{share:.3f}"])
    if left := summary["vehicles"][MOST_ROWS:]:
        rows.append(["...", f"{len(left)} more vehicles in --json"])
    print_table(summary["title"] or name, ["", ""], rows)
    typer.echo(f"{out}: written")


def _last(by_time: dict[str, float]) -> float:
    return list(by_time.values())[-1]


def excitation_and_print(
    source: Any, window: float | None, start: float | None, as_json: bool
) -> None:
    """Print what each vehicle and the team can learn; the source is a team or its run."""
    from ..theory.excitation.pooled import team_excitation_report

    report = team_excitation_report(source, window, start)
    if as_json:
        print_json(report)
        return
    rows = []
    for name, one in [*report["vehicles"].items(), ("team", report["team"])]:
        for axis, values in one["eigenvalues"].items():
            learned = f"{one['dimension'][axis]} of {len(values)}"
            rows.append([name, axis, f"{values[0]:.4g}", f"{values[-1]:.4g}", learned])
    end = report["start"] + report["window"]
    unit = report["time_unit"]
    title = f"Excitation from {report['start']:g} to {end:g} {unit}, {report['trajectory']}"
    columns = ["", "axis", "smallest eigenvalue", "largest", "can be learned"]
    print_table(title, columns, rows)
    typer.echo(f"measured: {report['measured']}")
    for name, one in report["vehicles"].items():
        for sentence in one["not_learnable"]:
            typer.echo(f"{name} alone: {sentence}")
    for sentence in report["team"]["not_learnable"]:
        typer.echo(f"the team: {sentence}")
