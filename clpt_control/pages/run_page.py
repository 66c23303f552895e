"""The page of a scenario's run; of the paper's, with the table of its claims."""

from typing import TYPE_CHECKING, Any

import numpy as np

from ..figures import figure_of
from ..html.text import folded, listing, paragraphs, safe, table
from ..scenario.experiment import Scenario
from ..scenario.file import CHANGED, OWN_LAW, OWN_PARTS, paper_scenario
from ..simulation.plots import clpe_plot, learning_plot, track_plot
from ..simulation.report import claims
from .excitation_section import excitation_section
from .page import Beside, Card, Drawn, Page, Section, narrow
from .pictures import flows_figure, lyapunov_figure
from .run_numbers import at_end, numbers_of, shown_samples
from .run_words import asked, found_of_clpe, found_of_flow, number
from .versions import again_section, solver_facts

if TYPE_CHECKING:
    import xarray

KINDS = ("Run of a scenario", "Run of a diagram")
GIVEN = {OWN_LAW: "law", CHANGED: "parameters", OWN_PARTS: "parts"}
MOST_ROWS = 12  # of a table that is not folded


def run_page(run: "xarray.Dataset", scenario: Scenario, title: str | None = None) -> Page:
    """Return the page of a run that carries this scenario."""
    numbers = numbers_of(run, scenario)
    own, changed, parts = (run.attrs.get(name) for name in (OWN_LAW, CHANGED, OWN_PARTS))
    law = f"{own}, given in Python," if own else scenario.learning.law
    unit, paper = scenario.units, scenario == paper_scenario() and not (own or changed or parts)
    sections = [*_claims(numbers)] if paper else []
    sections += [] if parts else [_loop(scenario, own)]
    sections += _figures(run, scenario, numbers)
    if changed or parts:
        said = "Not measured: the run had what its scenario does not hold."
        sections.append(Section("excitation", "What the track can teach", [paragraphs([said])]))
    else:
        sections.append(excitation_section(run))
    sections += [_scenario(run), _again(run, scenario, paper)]
    return Page(
        "Section IV of the paper" if paper else KINDS[parts is not None],
        title or scenario.title or "A run without a title",
        [
            asked(scenario, law, "Asked, as far as the scenario says" if parts else "Asked"),
            found_of_clpe(numbers, unit.length),
            found_of_flow(numbers, scenario),
        ],
        _warnings(run, scenario, numbers),
        _cards(numbers, scenario),
        sections,
    )


def _warnings(run: "xarray.Dataset", scenario: Scenario, numbers: dict[str, Any]) -> list[str]:
    """Return what a reader must know before the figures."""
    changed, parts = run.attrs.get(CHANGED), run.attrs.get(OWN_PARTS)
    said = []
    if run.attrs.get("status", "finished") != "finished":
        said.append(f"The run ended early: {run.attrs.get('message', 'no reason is recorded')}.")
    elif "flow was faster" in str(run.attrs.get("message")):
        said.append(f"{run.attrs['message']}.")
    first, last = float(run.time[0]), float(run.time[-1])
    if not said and (first > 0 or last < scenario.run.duration * (1 - 1e-9)):
        unit = scenario.units.time
        said.append(f"What is shown covers t = {first:g} to {last:g} {unit} of the run.")
    if changed:
        said.append(
            "The run had parameters that its scenario does not hold, so that waypoints and the "
            f"true flow may be others than drawn: {changed}."
        )
    if parts:
        said.append(
            f"The run is of a diagram with parts given in Python, {parts}: waypoints, true flow "
            "and law may be others than the scenario says."
        )
    if "measured_position" in run:
        said.append(
            "The CLPE is drawn of the measured position, which the vehicle reads with noise; mean "
            "squares are of the true one."
        )
    if numbers["of_samples"]:
        said.append(f"Mean squares here are over the {run.sizes['time']} samples of the file.")
    return said


def _cards(numbers: dict[str, Any], scenario: Scenario) -> list[Card]:
    unit, rms = scenario.units, numbers["clpe_rms_per_cycle"]
    cards = []
    if len(rms) > 1:
        below = f"in the first round {number(rms[0])} {unit.length}"
        cards.append(Card("CLPE rms, last round", f"{number(rms[-1])} {unit.length}", below))
    else:
        late = f"over the last quarter {number(numbers['clpe_rms_last_quarter'])} {unit.length}"
        whole = f"{number(numbers['clpe_rms'])} {unit.length}"
        cards.append(Card("CLPE rms, whole run", whole, late))
    for key, what, per in (
        ("max_flow_parameter_error", "Largest error of a flow parameter", f"{unit.length}/"),
        ("max_gain_error", "Largest error of a gain", "1/"),
    ):
        if errors := numbers.get(key):
            below = f"at t = {numbers['end']:g} {unit.time}"
            after = [time for time in errors if scenario.cycle <= float(time) < numbers["end"]]
            if after:
                below += f"; at t = {after[0]} {unit.time}: {number(errors[after[0]])}"
            cards.append(Card(what, f"{number(at_end(errors))} {per}{unit.time}", below))
    for place, share in (numbers.get("explained_variance") or {}).items():
        if isinstance(share, float):
            where = "along the track" if place == "track" else "over the whole box"
            where += "; worse than no flow" if share < 0 else ""
            cards.append(Card("Current's variance explained", f"{100 * share:.0f} %", where))
    return cards


def _claims(numbers: dict[str, Any]) -> list[Section]:
    """Return the table of claims of section IV; none where the run does not carry its figures."""
    if numbers["of_samples"]:
        return []
    rows = [list(one.values()) for one in claims(numbers)]
    columns = ["claim", "criterion", "measured", "verdict"]
    return [
        Section(
            "claims",
            "Claims of section IV",
            [table("Each claim and what was measured", columns, rows)],
        )
    ]


def _loop(scenario: Scenario, own: str | None) -> Section:
    from ..diagrams.drawing.figure import block_figure
    from ..simulation.loops import closed_loop

    caption = (
        "The closed loop as it ran: the vehicle above, the prediction and what it learns below. "
        "The number under a name is the equation of the paper."
    )
    said = f"The law that ran, {own}, was given in Python and takes the place of adaptation."
    parts: list[str | Drawn] = [paragraphs([said])] if own else []
    drawn = Drawn("loop", block_figure(closed_loop(scenario)), caption, wide=True)
    return Section("loop", "The loop", [*parts, drawn])


def _figures(run: "xarray.Dataset", scenario: Scenario, numbers: dict[str, Any]) -> list[Section]:
    """Return what is drawn along the run."""
    if run.sizes["time"] < 2:
        said = paragraphs(["The run has one sample: nothing can be drawn over time."])
        return [Section("clpe", "Prediction error", [said]), _learned(run, scenario, [])]
    few, thin = shown_samples(run)
    track = [
        Drawn(
            "track",
            narrow(figure_of(track_plot, few), 4.9),
            "Waypoints in their order, the track, and the true flow at the start." + thin,
        ),
        Drawn(
            "flows",
            narrow(flows_figure(few, scenario), 4.9),
            "The true flow and what was learned of it by the end. Where the vehicle never was, "
            "what is learned is a guess.",
        ),
    ]
    unit = scenario.units
    clpe = Drawn(
        "clpe",
        narrow(figure_of(clpe_plot, few), 4.9),
        f"The prediction error by waypoint intervals of {scenario.reference.dwell:g} {unit.time}; "
        "below, its size and its root mean square in each interval, logarithmic." + thin,
    )
    rms = numbers["clpe_rms_per_cycle"]
    rows = [[str(k + 1), number(value)] for k, value in enumerate(rms)]
    listed = table(f"CLPE, root mean square in each round ({unit.length})", ["round", "rms"], rows)
    clpe_parts: list[str | Drawn] = [clpe]
    if rows:
        shown = listed if len(rows) <= MOST_ROWS else folded("Each round", listed)
        clpe_parts.append(Beside(shown))
    learned = [
        Drawn(
            f"learning-{axis}",
            narrow(figure_of(learning_plot, few, axis), 4.9),
            f"What was learned of the flow along x{axis}, and the gains of that axis." + thin,
        )
        for axis in (1, 2)
    ]
    if "lyapunov" in few and np.any(few.lyapunov.values > 0):
        V = run.lyapunov.values
        said = (
            f"V, a weighted sum of all squared errors: {number(V[0])} at the start, "
            f"{number(V[-1])} at the end."
        )
        learned.append(Drawn("lyapunov", narrow(lyapunov_figure(few), 2.8), said + thin))
    return [
        Section("track", "Track and flow", track),
        Section("clpe", "Prediction error", clpe_parts),
        _learned(run, scenario, learned),
    ]


def _learned(run: "xarray.Dataset", scenario: Scenario, drawn: list[Drawn]) -> Section:
    """Return figures and table of what was learned."""
    unit, last = scenario.units, run.isel(time=-1)
    row = scenario.learning.row
    promise = (
        ""
        if run.attrs.get(OWN_LAW)
        else f"What {row.name} promises, where its theorem holds: {row.promise}."
    )
    estimate = last.flow_parameters_estimate.values
    true = np.full_like(estimate, np.nan)
    if "flow_parameters" in run:
        true = run.flow_parameters.values
    per = f"{unit.length}/{unit.time}"
    rows = [
        _row(f"theta_{i + 1}[{k + 1}] ({per})", estimate[i, k], true[i, k])
        for i, k in np.ndindex(estimate.shape)
    ]
    rows += [
        _row(f"{symbol}_{i + 1} (1/{unit.time})", last[name].values[i], right[i])
        for name, symbol, right in (
            ("feedback_gain", "K", scenario.vehicle.feedback),
            ("feedforward_gain", "Gamma", scenario.vehicle.feedforward),
        )
        for i in range(2)
    ]
    listed = table(
        f"Learned by t = {float(last.time):g} {unit.time}", ["", "learned", "true", "error"], rows
    )
    said = [paragraphs([promise])] if promise else []
    shown = listed if len(rows) <= MOST_ROWS else folded(f"All {len(rows)} values", listed)
    return Section("learning", "What was learned", [*said, *drawn, Beside(shown)])


def _row(name: str, learned: float, true: float) -> list[str]:
    known = [f"{true:.4g}", f"{learned - true:+.2g}"] if np.isfinite(true) else ["not known", "-"]
    return [name, f"{learned:.4g}", *known]


def _scenario(run: "xarray.Dataset") -> Section:
    said = "All that was asked, as a file for <code>clpt run</code>:"
    text = listing(str(run.attrs["scenario"]))
    return Section("scenario", "Scenario", [f"<p>{said}</p>", folded("The scenario, TOML", text)])


def _again(run: "xarray.Dataset", scenario: Scenario, paper: bool) -> Section:
    said = "Save the scenario above as <code>scenario.toml</code>, and type:"
    if scenario.flow.field is not None:
        field = f"<code>{safe(scenario.flow.field)}</code>"
        said = f"With the file of the current, {field}, where the scenario says. {said}"
    commands = [
        "clpt run scenario.toml --out run.nc --figures figures",
        "clpt report run.nc -o report.html",
    ]
    if paper:
        said = "The scenario comes with clpt-control; type:"
        commands = ["clpt paper --out paper", "clpt report paper/run.nc -o report.html"]
    given = [what for name, what in GIVEN.items() if name in run.attrs]
    if given:
        said = f"The run cannot be made again from its file alone: its {' and '.join(given)}"
        said, commands = f"{said} were given in Python.", []
    return again_section(
        said, commands, str(run.attrs.get("software", "")), solver_facts(run.attrs)
    )
