"""`clpt init`, `clpt paper`, `clpt run`, `clpt diagram`, `clpt export`: one scenario.

And what is sent or shown: `clpt report` writes a page, `clpt animate` a moving picture.
"""

import os
from importlib import resources
from pathlib import Path
from typing import Any

import clpt_control as clpt

from ..errors import ClptError
from ..files import check_writable, make_folder, write_together
from ..html import Result
from ..progress import progress_bar
from .help_pages import arg, opt
from .printing import Formats, Json, ScenarioFile, finish, say

RUN = "run it with `clpt run {} --out run.nc`"
FIT = "fit it with `clpt fit {} --out mine.toml`"
EXAMPLES = {  # of `clpt init`: the name that it is given, the file in the package, what to do then
    "paper": ("paper.toml", "paper.toml", RUN),
    "team": ("team.toml", "team.toml", RUN),
    "currents": ("currents.nc", "maracoos_hfr_2019-01-01.nc", FIT),
}


def init(
    file: Path | None = arg(
        "FILE", "Where to write it; default: the name of the example.", default=None
    ),
    example: str = opt(
        "NAME", f"What to write: {', '.join(EXAMPLES)}.", default="paper", words=(*EXAMPLES,)
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
        raise ClptError(f"{file}: exists already; name another file, or move this one away")
    write_together({file: (resources.files("clpt_control.data") / source).read_bytes()})
    say(f"{file}: written; {then.format(file)}")


def paper(
    out: Path = opt("FOLDER", "Folder for figures and run.nc.", default=Path("paper")),
    formats: Formats = None,
    as_json: Json = False,
) -> None:
    """Run section IV of the paper and judge its claims.

    Example:
        clpt paper --out paper
    """
    from ..figures import checked_formats
    from ..pages.results import claims_result
    from ..simulation.run_file import as_written
    from ..simulation.team_plots import run_figures

    kinds = checked_formats(formats or ["png"])
    scenario, folder = clpt.paper_scenario(), make_folder(out)
    with progress_bar("section IV", scenario.run.duration) as report:
        run, fine, summary = clpt.simulation.run_and_report(scenario, report)
    drawn, file = run_figures(fine, folder, kinds), folder / "run.nc"
    write_together({file: as_written(run, file), **drawn})
    summary["claims"] = clpt.simulation.claims(summary)
    first, *_, last = drawn
    said = [f"{folder}: {first.name} to {last.name}, run.nc"]
    finish([claims_result(summary["claims"])._replace(sentences=said)], summary, as_json)


def run(
    scenario: ScenarioFile,
    out: Path = opt("FILE", "NetCDF file for the run.", default=...),
    figures: Path | None = opt("FOLDER", "Folder for the figures."),
    formats: Formats = None,
    as_json: Json = False,
) -> None:
    """Run a scenario, or a team: a scenario with a table [team].

    The file of a diagram's run is run again, from the equations that it holds.

    Example:
        clpt run mine.toml --out run.nc --figures figures
    """
    from ..figures import checked_formats
    from ..scenario.team import load_either
    from ..simulation.run_file import as_written, repeats_by_equations
    from ..simulation.team_plots import run_figures
    from ..theory.excitation.gramian import not_learned

    kinds = checked_formats(formats or ["png"])
    again = scenario.suffix == ".nc" and repeats_by_equations(scenario)
    system: Any = clpt.load_diagram(scenario) if again else load_either(scenario)
    check_writable(out)
    folder = None if figures is None else make_folder(figures)
    if again:
        from ..pages.run_page import extent_of, response_result

        result = fine = clpt.simulate(system)
        summary = {name: result.attrs[name] for name in ("title", "status", "message")}
        found, summary["signals"] = response_result(result), extent_of(result)
    else:
        from ..pages.results import run_result

        with progress_bar(f"running {scenario.name}", system.run.duration) as report:
            result, fine, summary = clpt.simulation.run_and_report(system, report)
        found = run_result(summary, summary["title"] or str(scenario))
        if missing := not_learned(result):
            found, summary["not_learnable"] = found._replace(sentences=[missing]), missing
    drawn = {} if folder is None else run_figures(fine, folder, kinds)
    write_together({out: as_written(result, out), **drawn})
    finish([found], summary, as_json, out)


def diagram(
    scenario: ScenarioFile,
    out: Path | None = opt(
        "FILE", ".svg, .png, .pdf or .mmd; default: Mermaid text.", "-o", "--out"
    ),
    external: list[str] | None = opt("PORT", "A port to take from outside, such as zc."),
) -> None:
    """Draw a scenario's block diagram.

    Example:
        clpt diagram mine.toml -o loop.svg
    """
    wired = clpt.closed_loop(clpt.load_scenario(scenario), external or ())
    if out is None:
        say(clpt.diagrams.mermaid(wired))
        return
    clpt.draw(wired, out)
    say(f"{out}: written")


def export(
    scenario: ScenarioFile,
    out: Path = opt("FILE", "The file of C.", "-o", "--out", default=...),
) -> None:
    """Write a scenario's loop, or a run's diagram, as one C99 file.

    Example:
        clpt export mine.toml -o loop.c
    """
    from ..simulation.run_file import repeats_by_equations

    again = scenario.suffix == ".nc" and repeats_by_equations(scenario)
    clpt.export_c(clpt.load_diagram(scenario) if again else clpt.load_scenario(scenario), out)
    say(f"{out}: written")


# --- to show -------------------------------------------------------------------------------------


def report(
    run: Path = arg("RUN", "run.nc, a team's too; an ensemble's folder; replay.nc or its JSON."),
    out: Path = opt("FILE", "The page, .html.", "-o", "--out", default=Path("report.html")),
    title: str | None = opt("TITLE", "In place of the scenario's."),
    figures: Path | None = opt("FOLDER", "Folder for the figures too, as SVG and PDF."),
    formats: Formats = None,
    as_json: Json = False,
) -> None:
    """Write a page to send: one HTML file that needs nothing else.

    Example:
        clpt report run.nc -o report.html
    """
    made = clpt.report(run, out, title, figures, formats or ("svg", "pdf"))
    written = f"{out}: written, {made['bytes'] / 1000:.0f} kB"
    finish([Result("", [], [], [*made["sentences"], written])], made, as_json)


def animate(
    run: Path = arg("RUN", "A run's NetCDF."),
    out: Path = opt(
        "FILE",
        "The film: .gif, or .mp4 where ffmpeg is installed.",
        "-o",
        "--out",
        default=Path("run.gif"),
    ),
    start: float | None = opt("TIME", "First time shown; default: the run's."),
    end: float | None = opt("TIME", "Last time shown; default: the run's."),
    seconds: float = opt("SECONDS", "How long the film lasts.", default=12.0),
    fps: float = opt("NUMBER", "Frames a second.", default=12.5),
    width: int = opt("PIXELS", "Pixels.", default=560),
) -> None:
    """Make a moving picture of a run.

    It shows the vehicle and its prediction, the true and the learned flow, and CLPE.

    Example:
        clpt animate run.nc -o run.gif
    """
    from ..simulation.film import check_options

    check_options(out, seconds, fps, width)
    data = clpt.load_run(run)
    clpt.animate(data, out, start=start, end=end, seconds=seconds, fps=fps, width=width)
    say(f"{out}: written")
