"""The page of a run of any diagram: its loop, its equations if short, each port over time."""

from typing import TYPE_CHECKING, Any

from ..diagrams.drawing.drawn import MOST
from ..diagrams.drawing.figure import block_figure
from ..diagrams.on_symbols import equations
from ..errors import ClptError
from ..figures import figure_of
from ..html import Result, listing, paragraphs, safe, table
from ..scenario.file import NOT_REPEATED
from ..simulation.plots import STATES, named, response_plot, signals_of
from ..simulation.repeating import diagram_from, text_of
from .page import Card, Drawn, Page, Section, again_section, narrow, solver_facts
from .pictures import ONE_SAMPLE, shown_samples
from .run_words import number

if TYPE_CHECKING:
    import xarray

    from ..diagrams.interconnection import Diagram

EACH = 5  # ports of a figure
MOST_SIGNALS = 60  # in the table
MOST_SAID = 4  # signals in a sentence
SHORT = 12, 200  # lines of equations, and letters of each


def diagram_page(run: "xarray.Dataset", title: str | None = None) -> Page:
    """Return the page of a diagram's run."""
    text, why = text_of(run)
    diagram = diagram_from(text) if text else None
    why = why or str(run.attrs.get(NOT_REPEATED, ""))
    name = str(run.attrs.get("title") or "A run without a title")
    found = response_result(run)
    signals = len(extent_of(run))
    cards = [
        Card("Samples", str(run.sizes["time"]), f"{span_of(run)}, of {signals} signals"),
        Card("Ended", str(run.attrs.get("status", "-")), str(run.attrs.get("method", ""))),
    ]
    if diagram is not None:
        states = f"{diagram.nstates or 0} states"
        cards.insert(0, Card("Blocks", str(len(diagram.syslist)), states))
    warnings = []
    if run.attrs.get("status", "finished") != "finished":
        warnings.append(f"The run ended early: {run.attrs.get('message')}.")
    if diagram is None:
        warnings.append(f"The run cannot be made again from its file{f': {why}' if why else ''}.")
    return Page(
        "Run of a diagram",
        title or name,
        [f"Asked: what the signals of a diagram do, {span_of(run)}.", _found(run)],
        warnings,
        cards,
        [*_loop(diagram), *_over_time(run, found), _again(run, diagram is not None)],
    )


def span_of(run: "xarray.Dataset") -> str:
    """Return from when to when a run is."""
    unit = run.time.attrs.get("units")
    first, last = (f"{float(t):.6g}" for t in run.time.values[[0, -1]])
    return f"t = {first} to {last}{f' {unit}' if unit else ''}"


def extent_of(run: "xarray.Dataset") -> dict[str, dict[str, float]]:
    """Return of each signal, by name and unit, where it began and ended and how far it went."""
    return {
        named(name, one.attrs.get("units")): {
            "first": float(values[0]),
            "last": float(values[-1]),
            "least": float(values.min()),
            "most": float(values.max()),
        }
        for port, one in run.data_vars.items()
        if port != STATES
        for name, values in signals_of(one).items()
    }


def response_result(run: "xarray.Dataset") -> Result:
    """Return where the signals of a diagram's run began and ended, and how far they went."""
    rows = [[name, *(f"{v:.6g}" for v in own.values())] for name, own in extent_of(run).items()]
    said = [f"{more} more signals"] if (more := len(rows) - MOST_SIGNALS) > 0 else []
    title = f"{run.attrs.get('title', 'A run')}, {span_of(run)}"
    columns = ["signal", "first", "last", "least", "most"]
    return Result(title, columns, rows[:MOST_SIGNALS], said)


def _found(run: "xarray.Dataset") -> str:
    signals = extent_of(run)
    said = [f"{name} = {number(own['last'])}" for name, own in [*signals.items()][:MOST_SAID]]
    more = f", of {len(signals)} signals" if len(signals) > MOST_SAID else ""
    return f"Found: at the end {', '.join(said)}{more}."


def _loop(diagram: "Diagram | None") -> list[Section]:
    """Return the diagram as it was recorded, drawn, and its equations where they are short."""
    if diagram is None:
        return []
    sections = []
    if len(diagram.syslist) <= MOST:
        caption = "The diagram that ran; a thick frame is a block with states."
        sections.append(
            Section("loop", "The loop", [Drawn("loop", block_figure(diagram), caption, wide=True)])
        )
    if lines := _equations(diagram):
        sections.append(Section("equations", "Equations", [listing("\n".join(lines))]))
    return sections


def _equations(diagram: Any) -> list[str]:
    """Return the equations of a diagram where they are short; nothing of what SymPy cannot read."""
    lines, letters = SHORT
    if (diagram.nstates or 0) + (diagram.noutputs or 0) > 2 * lines:
        return []
    try:
        made = equations(diagram)
    except ClptError:
        return []
    found, values = repr(made).splitlines(), made.values.items()
    if values:
        found.append("with " + ", ".join(f"{name} = {float(value):g}" for name, value in values))
    return found if len(found) <= lines and max(map(len, found), default=0) <= letters else []


def _over_time(run: "xarray.Dataset", found: Result) -> list[Section]:
    """Return each port over time, and where signals began and ended."""
    parts: list[str | Drawn] = []
    few, thin = shown_samples(run)
    ports = [port for port, one in run.data_vars.items() if port != STATES]
    for first in range(0, len(ports), EACH) if run.sizes["time"] > 1 else ():
        own = ports[first : first + EACH]
        figure = narrow(figure_of(response_plot, few[own]), 1.0 + 1.2 * len(own))
        said = f"{', '.join(map(str, own))} over time.{thin}"
        parts.append(Drawn(f"response-{first // EACH + 1}", figure, said))
    if not parts:
        parts.append(paragraphs([ONE_SAMPLE]))
    return [
        Section("response", "Signals over time", parts),
        Section(
            "signals",
            "Where they began and ended",
            [table(*found[:3]), paragraphs(found.sentences)],
        ),
    ]


def _again(run: "xarray.Dataset", repeats: bool) -> Section:
    said, commands = "The run cannot be made again from its file.", list[str]()
    if repeats:
        said = (
            "The file holds the equations, inputs, start and method of the run, as plain data. "
            f"With it, called <code>{safe('run.nc')}</code>, type:"
        )
        commands = ["clpt run run.nc --out again.nc", "clpt report again.nc -o report.html"]
    return again_section(
        said, commands, str(run.attrs.get("software", "")), solver_facts(run.attrs)
    )
