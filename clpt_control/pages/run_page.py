"""The page of a run: of one vehicle or a team, of the paper's with its claims; of any diagram."""

from typing import Any

from xarray import Dataset

from ..diagrams.drawing.figure import MOST, block_figure
from ..diagrams.interconnection import Diagram
from ..diagrams.on_symbols import readable_equations
from ..errors import ClptError
from ..html import Result, folded, listing, safe
from ..scenario.experiment import Scenario
from ..scenario.file import CHANGED, NOT_REPEATED, OWN_LAW, OWN_PARTS, TEAM, paper_scenario
from ..scenario.recorded_run import waypoints_of
from ..scenario.team import Team
from ..simulation.comparing import named, ports_along, response_plot, signals_of
from ..simulation.run_file import diagram_of_text, equations_text
from ..simulation.summary import claims
from ..theory.proving.symbolic_loop import no_value
from ..units import percent
from . import results, run_sections
from .page import Card, Drawn, Page, Section, again_section, drawn
from .results import Numbers, number

KINDS = ("Run of a scenario", "Run of a diagram")
IN_PYTHON = {OWN_LAW: "law", CHANGED: "parameters", OWN_PARTS: "parts"}
ALL = "<p>All that was asked, as a file for <code>clpt run</code>:</p>"
EACH = 5  # ports of a figure
MOST_SIGNALS = 60  # in the table
MOST_SAID = 4  # signals in a sentence
SHORT = 12, 200  # lines of equations, and letters of each


def run_page(run: Dataset, system: Scenario | Team, title: str) -> Page:
    """Return the page of a run that carries this scenario, or this team."""
    numbers = results.numbers_of(run, system)
    own, changed, parts = (run.attrs.get(name) for name in (OWN_LAW, CHANGED, OWN_PARTS))
    paper = system == paper_scenario() and not (own or changed or parts)
    text = listing(str(run.attrs.get(TEAM, run.attrs.get("scenario"))))
    if isinstance(system, Team):
        kind, scenario, alone = "Run of a team", system.first, results.of_the_worst(numbers)
        sentences = [
            results.asked_of_team(system),
            results.found_of_clpes(numbers, scenario.units.length),
        ]
        per = f"1/{scenario.units.time}"
        below = f"coupling {system.coupling:g} {per}; below, of the worst"
        cards = [Card("Vehicles", str(len(system.members)), below)]
        sections = [run_sections.team_section(run, numbers)]
    else:
        kind, scenario, alone = KINDS[parts is not None], system, numbers
        law = f"{own}, given in Python," if own else scenario.learning.law
        count = len(waypoints_of(run, system))
        if not count:  # there are no rounds
            numbers = alone = {**numbers, "clpe_rms_per_cycle": []}
        begin = "Asked, as far as the scenario says" if parts else "Asked"
        question = results.asked(scenario, law, count, begin)
        sentences = [question, results.found_of_clpe(numbers, scenario.units.length)]
        cards, sections = [], run_sections.figure_sections(run, scenario, numbers)
    if not parts:
        sections = [*run_sections.loop_section(system, own), *sections]
    if paper and not numbers["of_samples"]:  # else the run does not carry its figures
        judged = results.claims_result(claims(numbers))
        sections = [Section("claims", judged.title, judged), *sections]
    unmeasured = "the run had what its scenario does not hold" if changed or parts else ""
    return Page(
        "Section IV of the paper" if paper else kind,
        title,
        [*sentences, results.found_of_flow(alone, scenario)],
        [*_ended(run), *_warnings(run, scenario, numbers)],
        [*cards, *_cards(alone, scenario)],
        [
            *sections,
            run_sections.excitation_section(run, unmeasured),
            Section("scenario", "Scenario", more=ALL + folded("The scenario, TOML", text)),
            _again(run, scenario, paper),
        ],
    )


def _ended(run: Dataset) -> list[str]:
    """Return how a run ended, where it did not just come to its end."""
    message = run.attrs.get("message", "no reason is recorded")
    if run.attrs.get("status", "finished") != "finished":
        return [f"The run ended early: {message}."]
    return [f"{message}."] if "; " in str(message) else []


def _warnings(run: Dataset, scenario: Scenario, numbers: Numbers) -> list[str]:
    """Return what a reader must know before the figures."""
    changed, parts = run.attrs.get(CHANGED), run.attrs.get(OWN_PARTS)
    sentences = []
    first, last = float(run.time[0]), float(run.time[-1])
    if not _ended(run) and (first > 0 or last < scenario.run.duration * (1 - 1e-9)):
        unit = scenario.units.time
        covered = f"covers t = {first:g} to {last:g} {unit} of the run"
        alone = f"is t = {last:g} {unit} of the run alone"
        sentences.append(f"What is shown {alone if first == last else covered}.")
    if changed:
        sentences.append(
            "The run had parameters that its scenario does not hold, so that waypoints and the "
            f"true flow may be others than drawn: {changed}."
        )
    if parts:
        sentences.append(
            f"The run is of a diagram with parts given in Python, {parts}: what it followed, the "
            "true flow and the law may be others than the scenario says."
        )
    if "measured_position" in run:
        sentences.append(
            "The CLPE is drawn of the measured position, which the vehicle reads with noise; mean "
            "squares are of the true one."
        )
    if numbers["of_samples"]:
        count = run.sizes["time"]
        samples = "one sample" if count == 1 else f"{count} samples"
        sentences.append(f"Mean squares here are over the {samples} of the file.")
    return sentences


def _cards(numbers: Numbers, scenario: Scenario) -> list[Card]:
    unit, rms = scenario.units, numbers["clpe_rms_per_cycle"]
    cards = []
    if len(rms) > 1:
        below = f"in the first round {number(rms[0])} {unit.length}"
        cards.append(Card("CLPE rms, last round", f"{number(rms[-1])} {unit.length}", below))
    else:
        late = f"over the last quarter {number(numbers['clpe_rms_last_quarter'])} {unit.length}"
        whole = f"{number(numbers['clpe_rms'])} {unit.length}"
        cards.append(Card(f"CLPE rms, {results.span_of_means(numbers)}", whole, late))
    for what, per, errors in results.errors_by_time(numbers, unit.length, unit.time):
        below = f"at t = {numbers['end']:g} {unit.time}"
        after = [time for time in errors if scenario.cycle <= float(time) < numbers["end"]]
        if after:
            below += f"; at t = {after[0]} {unit.time}: {number(errors[after[0]])}"
        cards.append(
            Card(f"Largest error of a {what}", f"{number(results.at_end(errors))} {per}", below)
        )
    for place, share, worse in results.shares_of(numbers):
        said = "none" if share is None else percent(share)
        why = "; it hardly changes there" if share is None else f"{worse and '; '}{worse}"
        cards.append(Card("Current's variance explained", said, results.SHARES[place] + why))
    return cards


def _again(run: Dataset, scenario: Scenario | None, paper: bool = False) -> Section:
    """Return how a run is made again: from its file's equations, from its scenario, or not."""
    missing, commands = [what for name, what in IN_PYTHON.items() if name in run.attrs], list[str]()
    if (missing or scenario is None) and equations_text(run)[0]:
        how = "The file holds the equations that ran, with inputs, start and method. Type:"
        commands = ["clpt run run.nc --out again.nc", "clpt report again.nc -o report.html"]
    elif missing:
        how = f"The run cannot be made again from its file alone: its {' and '.join(missing)}"
        how = f"{how} were given in Python."
    elif scenario is None:
        how = "The run cannot be made again from its file."
    elif paper:
        how = "The scenario comes with clpt-control; type:"
        commands = ["clpt paper --out paper", "clpt report paper/run.nc -o report.html"]
    else:
        how = "Save the scenario above as <code>scenario.toml</code>, and type:"
        if scenario.flow.field is not None:
            field = f"<code>{safe(scenario.flow.field)}</code>"
            how = f"With the file of the current, {field}, where the scenario says. {how}"
        commands = [
            "clpt run scenario.toml --out run.nc --figures figures",
            "clpt report run.nc -o report.html",
        ]
    return again_section(how, commands, run.attrs)


# --- of any diagram ------------------------------------------------------------------------------


def diagram_page(run: Dataset, title: str) -> Page:
    """Return the page of a diagram's run: its loop, its equations if short, each port over time."""
    text, why = equations_text(run)
    signals, found, warnings = extent_of(run), response_result(run), _ended(run)
    cards = [
        Card("Samples", str(run.sizes["time"]), f"{span_of(run)}, of {len(signals)} signals"),
        Card("Ended", str(run.attrs.get("status", "-")), str(run.attrs.get("method", ""))),
    ]
    sections = [
        _over_time(run),
        Section("signals", "Where they began and ended", found),
        _again(run, None),
    ]
    if text:
        diagram = diagram_of_text(text)
        states = f"{diagram.nstates or 0} states"
        cards.insert(0, Card("Blocks", str(len(diagram.syslist)), states))
        sections = [*_loop(diagram), *sections]
    else:
        why = why or run.attrs.get(NOT_REPEATED, "")
        warnings.append(f"The run cannot be made again from its file{f': {why}' if why else ''}.")
    last = [f"{name} = {number(own['last'])}" for name, own in signals.items()]
    more = f", of {len(last)} signals" if len(last) > MOST_SAID else ""
    return Page(
        KINDS[1],
        title,
        [
            f"Asked: what the signals of a diagram do, {span_of(run)}.",
            f"Found: at the end {', '.join(last[:MOST_SAID])}{more}.",
        ],
        warnings,
        cards,
        sections,
    )


def span_of(run: Dataset) -> str:
    """Return from when to when a run is."""
    unit = run.time.attrs.get("units")
    first, last = (f"{float(t):.6g}" for t in run.time.values[[0, -1]])
    return f"t = {first} to {last}{f' {unit}' if unit else ''}"


def extent_of(run: Dataset) -> dict[str, dict[str, float]]:
    """Return of each signal, by name and unit, where it began and ended and how far it went."""
    return {
        named(name, one.attrs.get("units")): {
            "first": float(values[0]),
            "last": float(values[-1]),
            "least": float(values.min()),
            "most": float(values.max()),
        }
        for one in (run[port] for port in ports_along(run))
        for name, values in signals_of(one).items()
    }


def response_result(run: Dataset) -> Result:
    """Return where the signals of a diagram's run began and ended, and how far they went."""
    rows = [[name, *(f"{v:.6g}" for v in own.values())] for name, own in extent_of(run).items()]
    sentences = [f"{more} more signals"] if (more := len(rows) - MOST_SIGNALS) > 0 else []
    title = f"{run.attrs.get('title', 'A run')}, {span_of(run)}"
    columns = ["signal", "first", "last", "least", "most"]
    return Result(title, columns, rows[:MOST_SIGNALS], sentences)


def _loop(diagram: Diagram) -> list[Section]:
    """Return the diagram as it was recorded, drawn, and its equations where they are short."""
    sections = []
    if len(diagram.syslist) <= MOST:
        caption = "The diagram that ran; a thick frame is a block with states."
        figure = Drawn("loop", block_figure(diagram), caption, wide=True)
        sections.append(Section("loop", "The loop", figures=[figure]))
    if lines := _equations(diagram):
        sections.append(Section("equations", "Equations", more=listing("\n".join(lines))))
    return sections


def _equations(diagram: Any) -> list[str]:
    """Return the equations of a diagram where they are short; nothing of what SymPy cannot read."""
    lines, letters = SHORT
    if (diagram.nstates or 0) + (diagram.noutputs or 0) > 2 * lines:
        return []
    try:
        made = readable_equations(diagram, watch=no_value)  # which refuses what is long
    except ClptError:
        return []
    found, values = repr(made).splitlines(), made.values.items()
    if values:
        found.append("with " + ", ".join(f"{name} = {float(value):g}" for name, value in values))
    return found if len(found) <= lines and max(map(len, found), default=0) <= letters else []


def _over_time(run: Dataset) -> Section:
    """Return each port over time."""
    heading = "Signals over time"
    if run.sizes["time"] < 2:
        return Section("response", heading, run_sections.ONE_SAMPLE)
    few, thin = run_sections.samples_to_draw(run)
    ports = ports_along(run)
    figures = []
    for first in range(0, len(ports), EACH):
        some = ports[first : first + EACH]
        name, caption = f"response-{first // EACH + 1}", f"{', '.join(some)} over time.{thin}"
        figures.append(drawn(name, 1.0 + 1.2 * len(some), caption, response_plot, few[some]))
    return Section("response", heading, figures=figures)
