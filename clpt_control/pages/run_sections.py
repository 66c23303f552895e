"""Sections of a run's page that are drawn: loop, track, CLPE, learning, excitation."""

from typing import Any

import numpy as np
from xarray import Dataset

from ..diagrams.drawing.figure import block_figure
from ..errors import ClptError
from ..figures import figure_of, new_figure
from ..html import Result
from ..scenario.experiment import Scenario
from ..scenario.recorded_run import unknown_parts
from ..scenario.team import Team
from ..simulation.charts import track_plot
from ..simulation.film import draw_samples
from ..simulation.loops import closed_loop
from ..simulation.plots import DIRECTIONS, clpe_plot, learning_plot
from ..simulation.team_loops import team_loop
from ..simulation.team_plots import team_plot
from ..theory.excitation.excitation_report import excitation_plot, excitation_report
from .page import Drawn, Section, drawn
from .results import excitation_result, is_team

MOST_SAMPLES = 6000  # in a figure
MOST_DRAWN = 3  # vehicles in a drawing of the loop
ONE_SAMPLE = Result(sentences=["The run has one sample: nothing can be drawn over time"])


def loop_section(system: Scenario | Team) -> list[Section]:
    """Return the diagram that ran; nothing of a team that is too large to be drawn."""
    if isinstance(system, Team) and len(system.members) > MOST_DRAWN:
        return []
    loop = team_loop(system) if isinstance(system, Team) else closed_loop(system)
    caption = "The loop as it ran. The number under a name is the equation of the paper."
    figure = Drawn("loop", block_figure(loop), caption, wide=True)
    return [Section("loop", "The loop", figures=[figure])]


def excitation_section(run: Dataset, why: str) -> Section:
    """Return the excitation over one round of a run, or `why` it cannot be measured, if so."""
    team = is_team(run)
    heading, figures = f"What the track{'s' if team else ''} can teach", []
    try:
        if why:
            raise ClptError(why)
        report = excitation_report(run)
        result = excitation_result(report)
        if not team:
            figure = figure_of(excitation_plot, run, report["window"], report["start"])
            caption = (
                "Above, eigenvalues of the Gramian in a window that slides over the run: the "
                "smallest says how fast the slowest combination is learned. Below, that "
                "combination in one window."
            )
            figures = [Drawn("excitation", figure, caption, wide=True)]
    except ClptError as error:
        result = Result(sentences=[f"Not measured: {error}"])
    return Section("excitation", heading, result, figures)


def figure_sections(run: Dataset, system: Scenario | Team) -> list[Section]:
    """Return what is drawn along the run, and what was learned."""
    learning = [] if isinstance(system, Team) else [_learned(run, system)]
    if run.sizes["time"] < 2:
        return [Section("track", "Track and errors", ONE_SAMPLE), *learning]
    few, thin = samples_to_draw(run)

    def figure(name: str, height: float, caption: str, plot: Any, *more: Any) -> Drawn:
        return drawn(name, height, caption + thin, plot, few, *more)

    if isinstance(system, Team):
        caption = (
            "Tracks and waypoints over the flow at the start; the size of each prediction error; "
            "the largest error of what each vehicle learned."
        )
        return [
            Section("track", "Track and errors", figures=[figure("team", 7.6, caption, team_plot)])
        ]
    unknown = unknown_parts(run)
    track = [figure("track", 4.9, "Where it was to be, and the track.", track_plot)]
    if "basis_x" not in unknown and "reference" in run:
        caption = (
            "The true flow, where it is known, and what was learned of it by the end. Where the "
            "vehicle never was, what is learned is a guess."
        )
        track.append(figure("flows", 4.9, caption, end_plot))
    caption = "The prediction error, at first; below, its size over the whole run, logarithmic."
    clpe = [figure("clpe", 4.9, caption, clpe_plot)]
    figures = []
    for axis, direction in enumerate(DIRECTIONS, 1):
        caption = f"What was learned of the flow to the {direction}, and the gains of that axis."
        figures.append(figure(f"learning-{axis}", 4.9, caption, learning_plot, axis))
    return [
        Section("track", "Track and flow", figures=track),
        Section("clpe", "Prediction error", figures=clpe),
        learning[0]._replace(figures=figures),
    ]


def _learned(run: Dataset, scenario: Scenario) -> Section:
    """Return what was learned beside the truth, without its figures."""
    unit, last, car = scenario.units, run.isel(time=-1), scenario.vehicle
    theta = run.flow_parameters.values if "flow_parameters" in run else None
    gains_known = "vehicle_controller" not in unknown_parts(run)
    rate = f"1/{unit.time}"
    parts = [
        ("theta", f"{unit.length}/{unit.time}", last.flow_parameters_estimate, theta),
        ("K", rate, last.feedback_gain, np.array(car.feedback) if gains_known else None),
        ("Gamma", rate, last.feedforward_gain, np.array(car.feedforward) if gains_known else None),
    ]
    rows = [
        [
            f"{name}_{axis + 1}{''.join(f'[{k + 1}]' for k in rest)} ({per})",
            f"{learned.values[axis, *rest]:.4g}",
            "not known" if true is None else f"{true[axis, *rest]:.4g}",
        ]
        for axis in range(2)
        for name, per, learned, true in parts
        for rest in np.ndindex(learned.shape[1:])
    ]
    title = f"Learned by t = {float(last.time):g} {unit.time}"
    result = Result(title, ["", "learned", "true"], rows)
    return Section("learning", "What was learned", result)


def end_plot(run: Dataset) -> Any:
    """Draw the end of a run: vehicle, prediction, the true flow and the learned one."""
    _, ax = new_figure()
    next(draw_samples(ax, run, np.array([run.sizes["time"] - 1])))
    return ax


def samples_to_draw(run: Dataset) -> tuple[Dataset, str]:
    """Return as many samples of a run as a figure shows, and a sentence if they are not all."""
    count = run.sizes["time"]
    step = -(-count // MOST_SAMPLES)
    if step == 1:
        return run, ""
    few = run.isel(time=np.unique([*range(0, count, step), count - 1]))
    few.encoding.update(run.encoding)
    return few, f" Drawn from 1 in {step} of {count} samples."
