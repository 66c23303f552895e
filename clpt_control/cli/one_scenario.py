"""`clpt init`, `clpt paper`, `clpt run`, `clpt diagram`: one scenario."""

from importlib import resources
from pathlib import Path
from typing import Annotated

import typer

from ..errors import ClptError
from .help_pages import arg, one_of, opt
from .printing import Formats, Json, ScenarioFile, print_json, print_table

RUN = "run it with `clpt run {} --out run.nc`"
FIT = "fit it with `clpt fit {} --out mine.toml`"
EXAMPLES = {  # of `clpt init`: the name that it is given, the file in the package, what to do then
    "paper": ("paper.toml", "paper.toml", RUN),
    "team": ("team.toml", "team.toml", RUN),
    "currents": ("currents.nc", "maracoos_hfr_2019-01-01.nc", FIT),
}


def init(
    file: Annotated[
        Path | None, arg("FILE", "Where to write it; default: the name of the example.")
    ] = None,
    example: Annotated[
        str, opt("NAME", f"What to write: {', '.join(EXAMPLES)}.", autocompletion=one_of(*EXAMPLES))
    ] = "paper",
) -> None:
    """Write an example to start from: a scenario, by default.

    The paper's scenario, commented; a team's; or a measured current for `clpt fit`.

    Example:
        clpt init mine.toml
    """
    from ..files import beside, check_name

    if example not in EXAMPLES:
        raise ClptError(f"--example {example}: must be one of {', '.join(EXAMPLES)}")
    name, source, then = EXAMPLES[example]
    file = file or Path(name)
    check_name(file)
    if file.exists():
        raise ClptError(f"{file}: exists already; name another file, or move this one away")
    with beside(file) as made:
        made.write_bytes((resources.files("clpt_control.data") / source).read_bytes())
    typer.echo(f"{file}: written; {then.format(file)}")


def paper(
    out: Annotated[Path, opt("FOLDER", "Folder for figures and run.nc.")] = Path("paper"),
    formats: Formats = None,
    as_json: Json = False,
) -> None:
    """Run section IV of the paper and judge its claims.

    Example:
        clpt paper --out paper
    """
    from ..figures import checked_formats
    from ..files import make_folder
    from ..progress import progress_bar
    from ..scenario.file import paper_scenario
    from ..simulation.plots import save_figures
    from ..simulation.report import claims, run_and_report
    from ..simulation.run_file import save_run

    kinds = checked_formats(formats or ["png"])
    scenario, folder = paper_scenario(), make_folder(out)
    with progress_bar("section IV", scenario.run.duration) as report:
        run, fine, summary = run_and_report(scenario, report)
    save_run(run, folder / "run.nc")
    drawn = save_figures(fine, folder, kinds)
    summary["claims"] = claims(summary)
    if as_json:
        print_json(summary)
        return
    print_table(
        "Claims of section IV",
        ["claim", "criterion", "measured", "verdict"],
        [list(claim.values()) for claim in summary["claims"]],
    )
    typer.echo(f"{folder}: {drawn[0].name} to {drawn[-1].name}, run.nc")


def run(
    scenario: ScenarioFile,
    out: Annotated[Path, opt("FILE", "NetCDF file for the run.")],
    figures: Annotated[Path | None, opt("FOLDER", "Folder for the figures.")] = None,
    formats: Formats = None,
    as_json: Json = False,
) -> None:
    """Run a scenario, or a team: a scenario with a table [team].

    Example:
        clpt run mine.toml --out run.nc --figures figures
    """
    from ..figures import checked_formats
    from ..files import check_writable, make_folder
    from ..progress import progress_bar
    from ..scenario.team import Team
    from ..scenario.team_file import load_either
    from ..simulation.report import run_and_report
    from ..simulation.run_file import save_run

    kinds = checked_formats(formats or ["png"])
    experiment = load_either(scenario)
    check_writable(out)
    folder = None if figures is None else make_folder(figures)
    if isinstance(experiment, Team):
        from .team import run_and_print

        run_and_print(experiment, scenario.name, out, folder, kinds, as_json)
        return
    with progress_bar(f"running {scenario.name}", experiment.run.duration) as report:
        result, fine, summary = run_and_report(experiment, report)
    save_run(result, out)
    if folder is not None:
        from ..simulation.plots import save_figures

        save_figures(fine, folder, kinds)
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
    if "speed" in summary:
        rows.append(
            ["share of time at the speed limit", f"{summary['speed']['share_at_limit']:.3g}"]
        )
        if summary["speed"]["faster_flow"] is None:
            rows.append(["flow faster than the vehicle", "never"])
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


def diagram(
    scenario: ScenarioFile,
    out: Annotated[
        Path | None, opt("FILE", ".svg, .png, .pdf or .mmd; default: Mermaid text.", "-o", "--out")
    ] = None,
    external: Annotated[
        list[str] | None, opt("PORT", "A port to take from outside, such as zc.")
    ] = None,
) -> None:
    """Draw a scenario's block diagram.

    Example:
        clpt diagram mine.toml -o loop.svg
    """
    from ..diagrams.drawing import draw, mermaid
    from ..scenario.file import load_scenario
    from ..simulation.loops import closed_loop

    wired = closed_loop(load_scenario(scenario), external or ())
    if out is None:
        typer.echo(mermaid(wired))
        return
    draw(wired, out)
    typer.echo(f"{out}: written")
