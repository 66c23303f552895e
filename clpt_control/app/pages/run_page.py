"""The page of a run: of one vehicle or a team, of the paper's with its claims; of any diagram."""

from typing import Any

import numpy as np
from xarray import Dataset

from ...base.errors import ClptError
from ...base.figures import axes_for, figure_of
from ...base.html import Result, folded, listing
from ...base.page import Drawn, Page, Section, drawn, versions_section
from ...base.run_attributes import CHANGED, OWN_LAW, OWN_PARTS, TEAM, beyond_scenario
from ...engine.diagram.interconnection import Diagram
from ...paper.scenario.experiment import Scenario
from ...paper.scenario.file import paper_scenario
from ...paper.scenario.recorded_run import thinned, unknown_parts, waypoints_of
from ...paper.scenario.team import Team
from ...plots.drawing.figure import MOST, block_figure
from ...simulation.animation import draw_samples
from ...simulation.comparison import (
    ports_along,
    response_plot,
    shown_ports,
    signals_of,
    with_unit,
)
from ...simulation.loops import closed_loop
from ...simulation.run_plots import DIRECTIONS, clpe_plot, learning_plot, team_plot
from ...simulation.summary import claims
from ...simulation.track_chart import track_plot
from ...theory.excitation.gramian import gramian
from . import results
from .results import Summary

KINDS = ("Run of a scenario", "Run of a diagram")
ALL = "<p>All that was asked, as a file for <code>clpt run</code>:</p>"
EACH = 5  # ports of a figure
MOST_SIGNALS = 60  # in the table
MOST_SAMPLES = 6000  # in a figure
ROUNDING = 1e-12  # share of a signal's largest value below which the table has 0
PAPERS_LOOP = (
    "The loop as it ran. The number under a name is the equation of the paper."
)
ONE_SAMPLE = Result(
    sentences=["The run has one sample: nothing can be drawn over time"]
)


def run_page(run: Dataset, system: Scenario | Team, title: str) -> Page:
    """Return the page of a run that carries this scenario, or this team."""
    numbers = results.numbers_of(run, system)
    own_law, changed, own_parts = (
        run.attrs.get(name) for name in (OWN_LAW, CHANGED, OWN_PARTS)
    )
    paper = system == paper_scenario() and not (own_law or changed or own_parts)
    text = listing(str(run.attrs.get(TEAM, run.attrs.get("scenario"))))
    if isinstance(system, Team):
        kind = "Run of a team"
        scenario = system.first
        waypoints = 1
    else:
        kind = KINDS[own_parts is not None]
        scenario = system
        waypoints = len(waypoints_of(run, system))
    if not waypoints:  # there are no rounds
        numbers = {**numbers, "clpe_rms_per_cycle": []}
    achieved = results.run_result(numbers, "Results of the run")
    sections = [Section("achieved", achieved.title, achieved)]
    if paper and not numbers["of_samples"]:  # else the run does not carry its figures
        judged = results.claims_result(claims(numbers))
        sections.append(Section("claims", judged.title, judged))
    if not (own_law or own_parts):
        loop = closed_loop(system)
        sections += loop_section(loop)
    unmeasured = (
        "the run had what its scenario does not hold" if changed or own_parts else ""
    )
    return Page(
        "Section IV of the paper" if paper else kind,
        title,
        [results.asked(system, waypoints)],
        _ended(run) + _warnings(run, scenario, numbers),
        [
            *sections,
            *figure_sections(run, system),
            excitation_section(run, unmeasured),
            Section(
                "scenario", "Scenario", more=ALL + folded("The scenario, TOML", text)
            ),
            versions_section(run.attrs),
        ],
    )


def _ended(run: Dataset) -> list[str]:
    """Return how a run ended, where it did not just come to its end."""
    message = run.attrs.get("message", "no reason is recorded")
    if run.attrs.get("status", "finished") != "finished":
        return [f"The run ended early: {message}."]
    return [f"{message}."] if "; " in str(message) else []


def _warnings(run: Dataset, scenario: Scenario, numbers: Summary) -> list[str]:
    """Return what a reader must know before the figures."""
    sentences = []
    begin = float(run.time[0])
    end = float(run.time[-1])
    if not _ended(run) and (begin > 0 or end < scenario.run.duration * (1 - 1e-9)):
        unit = scenario.units.time
        sentences.append(f"The page shows t = {begin:g} to {end:g} {unit} of the run.")
    if beyond := beyond_scenario(run.attrs):
        sentences.append(
            f"The run had what its scenario does not hold: {'; '.join(beyond)}. What it followed, "
            "the true flow and the law may be others than drawn."
        )
    if "measured_position" in run:
        sentences.append(
            "The CLPE is drawn of the measured position, which the vehicle reads with noise; mean "
            "squares are of the true one."
        )
    if numbers["of_samples"]:
        sentences.append(
            f"Mean squares here are over the {run.sizes['time']} samples of the file."
        )
    return sentences


def loop_section(diagram: Diagram) -> list[Section]:
    """Return the paper's diagram that ran, drawn; nothing of one that is too large."""
    if len(diagram.syslist) > MOST:
        return []
    figure = Drawn("loop", block_figure(diagram), PAPERS_LOOP, wide=True)
    return [Section("loop", "The loop", figures=[figure])]


def excitation_section(run: Dataset, why: str) -> Section:
    """Return the excitation over one round of a run, or `why` it cannot be measured, if so."""
    team = results.is_team(run)
    heading = f"Excitation along the track{'s' if team else ''}"
    figures = []
    try:
        if why:
            raise ClptError(why)
        excitation = gramian(run)
        result = excitation.result
        if not team:
            figure = figure_of(excitation.plot)
            caption = (
                "Above, eigenvalues of the Gramian in a window that slides over the run: the "
                "smallest says how fast the slowest combination is learned. Below, that "
                "combination in one window."
            )
            figures = [Drawn("excitation", figure, caption, wide=True)]
        if "lyapunov" in run and excitation.certified[0]:
            figure = figure_of(excitation.plot_tube)
            caption = "Root of V along the run, and what the window certifies of it."
            figures.append(Drawn("tube", figure, caption))
    except ClptError as error:
        result = Result(sentences=[f"Not measured: {error}"])
    return Section("excitation", heading, result, figures)


def figure_sections(run: Dataset, system: Scenario | Team) -> list[Section]:
    """Return what is drawn along the run, and what was learned."""
    learning = [] if isinstance(system, Team) else [_learned(run, system)]
    if run.sizes["time"] < 2:
        return [Section("track", "Track and errors", ONE_SAMPLE), *learning]
    few, thin = samples_to_draw(run)

    def figure(
        name: str, height: float, caption: str, plot: Any, *arguments: Any
    ) -> Drawn:
        return drawn(name, height, caption + thin, plot, few, *arguments)

    if isinstance(system, Team):
        caption = (
            "Tracks and waypoints over the flow at the start; the size of each prediction error; "
            "the largest error of what each vehicle learned."
        )
        drawn_team = [figure("team", 7.6, caption, team_plot)]
        return [Section("track", "Track and errors", figures=drawn_team)]
    unknown = unknown_parts(run)
    track = [figure("track", 4.9, "Reference and track.", track_plot)]
    if "basis_x" not in unknown and "reference" in run:
        caption = (
            "The true flow, if known, and the learned flow at the end. The learned flow is a guess "
            "at places that the vehicle did not visit."
        )
        track.append(figure("flows", 4.9, caption, end_plot))
    caption = (
        "The prediction error, in the first cycles; below, its size over the whole run "
        "(logarithmic)."
    )
    clpe = [figure("clpe", 4.9, caption, clpe_plot)]
    figures = []
    for axis, direction in enumerate(DIRECTIONS, 1):
        caption = (
            f"Learned flow parameters to the {direction}, and the gains of that axis."
        )
        figures.append(figure(f"learning-{axis}", 4.9, caption, learning_plot, axis))
    return [
        Section("track", "Track and flow", figures=track),
        Section("clpe", "Prediction error", figures=clpe),
        learning[0]._replace(figures=figures),
    ]


def _learned(run: Dataset, scenario: Scenario) -> Section:
    """Return the section of learned and true parameters, without figures."""
    unit = scenario.units
    last = run.isel(time=-1)
    car = scenario.vehicle
    atol = scenario.run.atol
    theta = run.flow_parameters.values if "flow_parameters" in run else None
    gains: Any = (None, None)
    if "vehicle_controller" not in unknown_parts(run):
        gains = np.array(car.feedback), np.array(car.feedforward)
    rate = f"1/{unit.time}"
    parameters = [
        ("theta", f"{unit.length}/{unit.time}", last.flow_parameters_estimate, theta),
        ("K", rate, last.feedback_gain, gains[0]),
        ("Gamma", rate, last.feedforward_gain, gains[1]),
    ]
    rows = [
        [
            f"{name}_{axis + 1}{''.join(f'[{k + 1}]' for k in index)} ({per})",
            _learned_value(learned.values[axis, *index], atol),
            "" if true is None else f"{true[axis, *index]:.4g}",
        ]
        for axis in range(2)
        for name, per, learned, true in parameters
        for index in np.ndindex(learned.shape[1:])
    ]
    title = f"Learned by t = {float(last.time):g} {unit.time}"
    note = [f"0 stands for less than the tolerance, {atol:g}"]
    note *= any(row[1] == "0" for row in rows)
    columns = ["", "learned", "true"]
    if not any(row[2] for row in rows):
        columns, rows = columns[:2], [row[:2] for row in rows]
    result = Result(title, columns, rows, note)
    return Section("learning", "Learned parameters", result)


def _learned_value(value: float, atol: float) -> str:
    """Return a learned number; 0 below the tolerance of the run."""
    return "0" if abs(value) < atol else f"{value:.4g}"


def end_plot(run: Dataset) -> Any:
    """Draw the end of a run: vehicle, prediction, the true flow and the learned one."""
    ax = axes_for(None, 6.4, 4.2)
    next(draw_samples(ax, run, np.array([run.sizes["time"] - 1])))
    return ax


def samples_to_draw(run: Dataset) -> tuple[Dataset, str]:
    """Return as many samples of a run as a figure shows, and a sentence if they are not all."""
    count = run.sizes["time"]
    step = -(-count // MOST_SAMPLES)
    if step == 1:
        return run, ""
    return thinned(run, step), f" Drawn from 1 in {step} of {count} samples."


# --- of any diagram ------------------------------------------------------------------------------


def diagram_page(run: Dataset, title: str) -> Page:
    """Return the page of a diagram's run: each port over time."""
    table = response_result(run)
    warnings = _ended(run)
    sections = [
        _over_time(run),
        Section("signals", "Signals at begin and end", table),
        versions_section(run.attrs),
    ]
    lead = f"Signals of a diagram, {span_of(run)}, at {run.sizes['time']} samples."
    return Page(KINDS[1], title, [lead], warnings, sections)


def span_of(run: Dataset) -> str:
    """Return from when to when a run is."""
    unit = run.time.attrs.get("units")
    begin, end = (f"{float(t):.6g}" for t in run.time.values[[0, -1]])
    return f"t = {begin} to {end}{f' {unit}' if unit else ''}"


def extent_of(run: Dataset) -> dict[str, dict[str, float]]:
    """Return of each signal, by name and unit, where it began and ended and how far it went."""
    return {
        with_unit(name, signal): {
            "first": float(values[0]),
            "last": float(values[-1]),
            "least": float(values.min()),
            "most": float(values.max()),
        }
        for signal in (run[port] for port in ports_along(run))
        for name, values in signals_of(signal).items()
    }


def response_result(run: Dataset) -> Result:
    """Return where the signals of a diagram's run began and ended, and how far they went."""
    rows = []
    has_rounding = False
    for name, extent in extent_of(run).items():
        values = np.array([*extent.values()])
        is_rounding = np.abs(values) < ROUNDING * np.abs(values).max()
        has_rounding |= bool(values[is_rounding].any())
        rows.append([name, *(f"{v:.6g}" for v in np.where(is_rounding, 0.0, values))])
    hidden = len(rows) - MOST_SIGNALS
    sentences = [f"{hidden} more signals"] if hidden > 0 else []
    if has_rounding:
        share = f"{ROUNDING:g} of the signal's largest value"
        sentences.append(f"0 stands for less than {share}")
    title = f"{run.attrs.get('title', 'A run')}, {span_of(run)}"
    columns = ["signal", "first", "last", "least", "most"]
    return Result(title, columns, rows[:MOST_SIGNALS], sentences)


def _over_time(run: Dataset) -> Section:
    """Return each port over time."""
    heading = "Signals over time"
    if run.sizes["time"] < 2:
        return Section("response", heading, ONE_SAMPLE)
    few, thin = samples_to_draw(run)
    ports = shown_ports(run)
    figures = []
    for begin in range(0, len(ports), EACH):
        group = ports[begin : begin + EACH]
        name = f"response-{begin // EACH + 1}"
        caption = f"{', '.join(group)} over time.{thin}"
        figures.append(
            drawn(name, 1.0 + 1.2 * len(group), caption, response_plot, few[group])
        )
    return Section("response", heading, figures=figures)
