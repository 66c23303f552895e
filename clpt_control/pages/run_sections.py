"""Sections of a run's page that are drawn: loop, track, CLPE, learning, excitation."""

from typing import Any

import numpy as np
from xarray import Dataset

from ..diagrams.drawing.figure import block_figure
from ..errors import ClptError
from ..figures import figure_of, new_figure
from ..html import Result
from ..scenario.experiment import Scenario
from ..scenario.file import OWN_LAW
from ..scenario.recorded_run import unknown_parts
from ..scenario.team import Team
from ..simulation.charts import track_plot
from ..simulation.film import draw_samples
from ..simulation.loops import closed_loop
from ..simulation.plots import DIRECTIONS, clpe_plot, learning_plot
from ..simulation.team_loops import team_loop
from ..simulation.team_plots import team_plot
from ..theory.excitation.excitation_report import excitation_plot
from .page import Drawn, Section, drawn
from .results import excitation_of, excitation_result, is_team

MOST_SAMPLES = 6000  # in a figure
MOST_DRAWN = 3  # vehicles in a drawing of the loop
ONE_SAMPLE = Result(sentences=["The run has one sample: nothing can be drawn over time"])


def loop_section(system: Scenario | Team, own: str | None) -> list[Section]:
    """Return the diagram that ran; nothing of a team that is too large to be drawn."""
    sentence = f"The law that ran, {own}, was given in Python and takes the place of adaptation"
    if isinstance(system, Team):
        if len(system.members) > MOST_DRAWN:
            return []
        caption = "The team's loop: the blocks of each vehicle, and the pull of its neighbours."
        figure = block_figure(team_loop(system))
    else:
        caption = (
            "The closed loop as it ran: the vehicle above, the prediction and what it learns "
            "below. The number under a name is the equation of the paper."
        )
        figure = block_figure(closed_loop(system))
    result = Result(sentences=[sentence] if own else [])
    return [Section("loop", "The loop", result, [Drawn("loop", figure, caption, wide=True)])]


def excitation_section(run: Dataset, why: str) -> Section:
    """Return the excitation over one round of a run, or `why` it cannot be measured, if so."""
    team = is_team(run)
    heading, figures = f"What the track{'s' if team else ''} can teach", []
    try:
        if why:
            raise ClptError(why)
        report = excitation_of(run)
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
    """Return what was learned, without its figures."""
    unit, last, row = scenario.units, run.isel(time=-1), scenario.learning.row
    estimate = last.flow_parameters_estimate.values
    unknown = np.full_like(estimate, np.nan)
    true = run.flow_parameters.values if "flow_parameters" in run else unknown
    per = f"{unit.length}/{unit.time}"
    rows = [
        _row(f"theta_{i + 1}[{k + 1}] ({per})", estimate[i, k], true[i, k])
        for i, k in np.ndindex(estimate.shape)
    ]
    gain = 1.0 if "vehicle_controller" not in unknown_parts(run) else np.nan
    rows += [
        _row(f"{symbol}_{i + 1} (1/{unit.time})", last[name].values[i], gain * right[i])
        for name, symbol, right in (
            ("feedback_gain", "K", scenario.vehicle.feedback),
            ("feedforward_gain", "Gamma", scenario.vehicle.feedforward),
        )
        for i in range(2)
    ]
    title = f"Learned by t = {float(last.time):g} {unit.time}"
    promise = f"What {row.name} promises, where its theorem holds: {row.promise}"
    sentences = [] if run.attrs.get(OWN_LAW) else [promise]
    result = Result(title, ["", "learned", "true", "error"], rows, sentences)
    return Section("learning", "What was learned", result)


def _row(name: str, learned: float, true: float) -> list[str]:
    known = [f"{true:.4g}", f"{learned - true:+z.2g}"] if np.isfinite(true) else ["not known", "-"]
    return [name, f"{learned:.4g}", *known]


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
