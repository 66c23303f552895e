"""Sections of a run's page that are drawn: loop, track, CLPE, learning, excitation."""

from typing import Any

import numpy as np
from xarray import Dataset

from ..diagrams.drawing.figure import block_figure
from ..errors import ClptError
from ..figures import BLUE, GREY, RED, TITLE, figure_of, new_figure
from ..html import Result
from ..scenario.experiment import Scenario
from ..scenario.file import OWN_LAW
from ..scenario.recorded_run import unknown_parts, waypoints_of
from ..scenario.tables import Units
from ..scenario.team import Team
from ..simulation.charts import square_chart, track_plot
from ..simulation.flows import flow_to_draw, flow_velocity
from ..simulation.loops import closed_loop
from ..simulation.plots import DIRECTIONS, clpe_plot, learning_plot
from ..simulation.team_loops import team_loop
from ..simulation.team_plots import team_plot
from ..theory.excitation.excitation_report import excitation_plot, excitation_report
from .page import Drawn, Section, drawn
from .results import Numbers, excitation_result, is_team, number, run_result

PLACES = 9  # arrows on a side
MOST_SAMPLES = 6000  # in a figure
MOST_DRAWN = 3  # vehicles in a drawing of the loop
ONE_SAMPLE = Result(sentences=["The run has one sample: nothing can be drawn over time"])


def team_section(run: Dataset, numbers: Numbers) -> Section:
    """Return a team's figure and what each vehicle achieved."""
    figures = []
    result = run_result(numbers, "What the vehicles achieved", len(numbers["vehicles"]))
    if run.sizes["time"] > 1:
        few, thin = samples_to_draw(run)
        caption = (
            "Tracks and waypoints over the flow at the start; the size of each prediction error; "
            "the largest error of what each vehicle learned." + thin
        )
        figures = [drawn("team", 7.6, caption, team_plot, few)]
    else:
        result = result._replace(sentences=ONE_SAMPLE.sentences)
    return Section("team", "Tracks, errors, what was learned", result, figures)


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


def figure_sections(run: Dataset, scenario: Scenario, numbers: Numbers) -> list[Section]:
    """Return what is drawn along the run."""
    heading, learning = "Prediction error", _learned(run, scenario)
    if run.sizes["time"] < 2:
        return [Section("clpe", heading, ONE_SAMPLE), learning]
    few, thin = samples_to_draw(run)
    unknown = unknown_parts(run)
    known = not {"true_flow", "basis_x"} & unknown
    where = f"Where it was to be, the track{', and the true flow at the start' * known}.{thin}"
    flows = "The true flow and what was learned of it" if known else "The learned flow"
    flows += " by the end. Where the vehicle never was, what is learned is a guess."
    unit = scenario.units
    errors = (
        "The prediction error over the first two rounds; below, its size over the whole run, and "
        f"its root mean square at each waypoint ({scenario.reference.dwell:g} {unit.time}), "
        "logarithmic."
    )
    if not len(waypoints_of(run, scenario)):
        errors = "The prediction error over time; below, its size, logarithmic."
    rms, rounds = numbers["clpe_rms_per_cycle"], Result()
    if rms:
        title = f"CLPE, root mean square in each round ({unit.length})"
        rows = [[str(k), number(value)] for k, value in enumerate(rms, 1)]
        rounds = Result(title, ["round", "rms"], rows)
    figures = []
    for axis in (1, 2):
        caption = (
            f"What was learned of the flow to the {DIRECTIONS[axis - 1]}, and the gains of that "
            f"axis.{thin}"
        )
        figures.append(drawn(f"learning-{axis}", 4.9, caption, learning_plot, few, axis))
    if "lyapunov" in few and np.any(few.lyapunov.values > 0):
        V = run.lyapunov.values
        caption = (
            f"V, a weighted sum of all squared errors: {number(V[0])} at the start, "
            f"{number(V[-1])} at the end.{thin}"
        )
        figures.append(drawn("lyapunov", 2.8, caption, lyapunov_plot, few, unit))
    track = [drawn("track", 4.9, where, track_plot, few)]
    if "basis_x" not in unknown:
        track.append(drawn("flows", 4.9, flows, flows_plot, few, scenario))
    clpe = drawn("clpe", 4.9, errors + thin, clpe_plot, few)
    return [
        Section("track", "Track and flow", figures=track),
        Section("clpe", heading, rounds, [clpe]),
        learning._replace(figures=figures),
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


def flows_plot(run: Dataset, scenario: Scenario) -> Any:
    """Draw the true flow and the learned one at the end of a run, at the same places."""
    _, ax = new_figure(4.8, 4.8)
    time, path = float(run.time[-1]), run.position.values
    grid = square_chart(ax, scenario, np.concatenate([waypoints_of(run, scenario), path]), PLACES)
    learned = flow_velocity(scenario, grid, time, run.flow_parameters_estimate.values[-1])
    true = flow_to_draw(run, scenario, grid, time)
    most = np.nanmax(np.hypot(*np.concatenate([true, learned]).T)) or 1.0
    size = {"angles": "xy", "scale_units": "xy", "scale": most * PLACES / np.ptp(ax.get_xlim())}
    ax.plot(*path.T, color=GREY, linewidth=0.4, alpha=0.6, label="track")
    if true.any():
        ax.quiver(*grid.T, *true.T, color=BLUE, alpha=0.45, width=0.009, label="true", **size)
    if learned.any():
        ax.quiver(*grid.T, *learned.T, color=RED, width=0.003, label="learned", **size)
    unit = scenario.units
    title = f"Flow at t = {time:g} {unit.time}, at most {most:.2g} {unit.length}/{unit.time}"
    ax.set_title(title, **TITLE)
    ax.legend(loc="upper center", bbox_to_anchor=(0.5, -0.12), ncols=3, fontsize=8, frameon=False)
    return ax


def lyapunov_plot(run: Dataset, units: Units) -> Any:
    """Draw the Lyapunov candidate V along a run, logarithmic."""
    _, ax = new_figure(4.8, 2.6)
    V = run.lyapunov.values
    ax.semilogy(run.time.values, np.where(V > 0, V, np.nan), color=BLUE, linewidth=1.2)
    ax.set_xlim(float(run.time[0]), float(run.time[-1]))
    ax.set(xlabel=f"time ({units.time})", ylabel=f"$V$ ({units.length}$^2$)")
    ax.set_title("Lyapunov candidate of the law's proof", **TITLE)
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
