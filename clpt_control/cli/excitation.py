"""`clpt excitation`: what can be learned on a track, and how fast."""

from pathlib import Path
from typing import Annotated

import typer

from ..errors import ClptError
from .help_pages import opt
from .printing import Json, ScenarioFile, Start, Window, check_figure, print_json, print_table

MOST_SHOWN = 20  # eigenvalues in the table; --json has all


def excitation(
    scenario: ScenarioFile,
    window: Window = None,
    start: Start = None,
    figure: Annotated[
        Path | None, opt("FILE", ".png, .pdf or .svg: eigenvalues and directions.")
    ] = None,
    as_json: Json = False,
) -> None:
    """Measure what can be learned on a track, and how fast.

    Of a team: by each vehicle alone, and by all together.

    Example:
        clpt excitation mine.toml --figure excitation.png
    """
    from ..figures import figure_of
    from ..files import write_figure
    from ..scenario.file import TEAM
    from ..scenario.team import Team
    from ..scenario.team_file import load_either
    from ..simulation.run_file import load_run
    from ..theory.excitation.report import excitation_report

    source = load_run(scenario) if scenario.suffix == ".nc" else load_either(scenario)
    if isinstance(source, Team) or TEAM in getattr(source, "attrs", {}):
        if figure is not None:
            raise ClptError("--figure: is for one vehicle; leave it out for a team")
        from .team import excitation_and_print

        excitation_and_print(source, window, start, as_json)
        return
    check_figure(figure)
    report = excitation_report(source, window, start)
    if figure is not None:
        from ..theory.excitation.plot import excitation_plot

        drawn = figure_of(excitation_plot, source, report["window"], report["start"])
        write_figure(drawn, figure)
    if as_json:
        print_json(report)
        return
    unit = report["time_unit"]
    rows = []
    for axis, values in report["eigenvalues"].items():
        shown = [f"{value:.4g}" for value in values]
        if len(shown) > MOST_SHOWN:
            shown = [*shown[:6], "...", *shown[-3:], f"({len(values)} in all)"]
        rows.append([f"{axis}: eigenvalues", ", ".join(shown)])
        parts = sorted(report["least_excited"][axis].items(), key=lambda part: -abs(part[1]))[:8]
        listed = ", ".join(f"{name} {share:+.2f}" for name, share in parts)
        rows.append([f"{axis}: least excited direction", listed])
    if report["contraction"] is None:
        rows.append(["contraction of V", report["not_certified"]])
    else:
        rows.append(["contraction of V, exact, at worst", f"{report['contraction']:.6g}"])
        rows.append(["guaranteed drop of V, rho", f"{report['rho']:.3g}"])
        time = report["time_to_tenth"]
        within = "never" if time is None else f"{time:.6g} {unit}, in windows like this one"
        rows.append(["errors fall to a tenth within", within])
    if "accuracy" in report:
        rows.append(["accuracy of the eigenvalues", f"{report['accuracy']:.2g} relative"])
    end = report["start"] + report["window"]
    title = f"Excitation from {report['start']:g} to {end:g} {unit}, {report['trajectory']}"
    print_table(title, ["", ""], rows)
    for sentence in report["not_learnable"]:
        typer.echo(sentence)
    if figure is not None:
        typer.echo(f"{figure}: written")
