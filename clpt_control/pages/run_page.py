"""The page of a run: of one vehicle or a team, of the paper's with its claims; of any diagram."""

from xarray import Dataset

from ..diagrams.drawing.figure import MOST, block_figure
from ..diagrams.interconnection import Diagram
from ..html import Result, folded, listing
from ..scenario.experiment import Scenario
from ..scenario.file import BEYOND, CHANGED, NOT_REPEATED, OWN_LAW, OWN_PARTS, TEAM, paper_scenario
from ..scenario.recorded_run import waypoints_of
from ..scenario.team import Team
from ..simulation.comparing import named, ports_along, response_plot, signals_of
from ..simulation.run_file import diagram_of_text, equations_text
from ..simulation.summary import claims
from . import results, run_sections
from .page import Drawn, Page, Section, drawn, versions_section
from .results import Numbers

KINDS = ("Run of a scenario", "Run of a diagram")
ALL = "<p>All that was asked, as a file for <code>clpt run</code>:</p>"
EACH = 5  # ports of a figure
MOST_SIGNALS = 60  # in the table


def run_page(run: Dataset, system: Scenario | Team, title: str) -> Page:
    """Return the page of a run that carries this scenario, or this team."""
    numbers = results.numbers_of(run, system)
    own, changed, parts = (run.attrs.get(name) for name in (OWN_LAW, CHANGED, OWN_PARTS))
    paper = system == paper_scenario() and not (own or changed or parts)
    text = listing(str(run.attrs.get(TEAM, run.attrs.get("scenario"))))
    if isinstance(system, Team):
        kind, scenario, waypoints = "Run of a team", system.first, 1
    else:
        kind, scenario, waypoints = KINDS[parts is not None], system, len(waypoints_of(run, system))
    if not waypoints:  # there are no rounds
        numbers = {**numbers, "clpe_rms_per_cycle": []}
    achieved = results.run_result(numbers, "What came of the run")
    sections = [Section("achieved", achieved.title, achieved)]
    if paper and not numbers["of_samples"]:  # else the run does not carry its figures
        judged = results.claims_result(claims(numbers))
        sections.append(Section("claims", judged.title, judged))
    if not (own or parts):
        sections += run_sections.loop_section(system)
    unmeasured = "the run had what its scenario does not hold" if changed or parts else ""
    return Page(
        "Section IV of the paper" if paper else kind,
        title,
        [results.asked(system, waypoints)],
        [*_ended(run), *_warnings(run, scenario, numbers)],
        [
            *sections,
            *run_sections.figure_sections(run, system),
            run_sections.excitation_section(run, unmeasured),
            Section("scenario", "Scenario", more=ALL + folded("The scenario, TOML", text)),
            versions_section(run.attrs),
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
    sentences = []
    first, last = float(run.time[0]), float(run.time[-1])
    if not _ended(run) and (first > 0 or last < scenario.run.duration * (1 - 1e-9)):
        unit = scenario.units.time
        sentences.append(f"What is shown is t = {first:g} to {last:g} {unit} of the run.")
    kinds = [name for name in BEYOND if name in run.attrs]
    if beyond := [f"{BEYOND[name][0]}, {run.attrs[name]}" for name in kinds]:
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
        sentences.append(f"Mean squares here are over the {run.sizes['time']} samples of the file.")
    return sentences


# --- of any diagram ------------------------------------------------------------------------------


def diagram_page(run: Dataset, title: str) -> Page:
    """Return the page of a diagram's run: its loop, each port over time."""
    text, why = equations_text(run)
    found, warnings = response_result(run), _ended(run)
    sections = [
        _over_time(run),
        Section("signals", "Where they began and ended", found),
        versions_section(run.attrs),
    ]
    if text:
        sections = [*_loop(diagram_of_text(text)), *sections]
    else:
        why = why or run.attrs.get(NOT_REPEATED, "")
        warnings.append(f"The run cannot be made again from its file{f': {why}' if why else ''}.")
    lead = f"What the signals of a diagram do, {span_of(run)}, at {run.sizes['time']} samples."
    return Page(KINDS[1], title, [lead], warnings, sections)


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
    """Return the diagram as it was recorded, drawn; nothing of one that is too large."""
    if len(diagram.syslist) > MOST:
        return []
    caption = "The diagram that ran; a thick frame is a block with states."
    figure = Drawn("loop", block_figure(diagram), caption, wide=True)
    return [Section("loop", "The loop", figures=[figure])]


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
