"""`clpt excitation`: what can be learned on a track, and how fast."""

from pathlib import Path
from typing import Annotated

from ..errors import ClptError
from .help_pages import opt
from .printing import Json, ScenarioFile, Start, Window, check_figure, finish


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
    from ..pages.excitation_section import excitation_of, excitation_result, is_team
    from ..scenario.team_file import load_either
    from ..simulation.run_file import load_run

    source = load_run(scenario) if scenario.suffix == ".nc" else load_either(scenario)
    if figure is not None and is_team(source):
        raise ClptError("--figure: is for one vehicle; leave it out for a team")
    check_figure(figure)
    report = excitation_of(source, window, start)
    if figure is not None:
        from ..figures import figure_of
        from ..files import write_figure
        from ..theory.excitation.plot import excitation_plot

        write_figure(figure_of(excitation_plot, source, report["window"], report["start"]), figure)
    finish(excitation_result(report), report, as_json, figure)
