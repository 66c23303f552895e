"""The page of a run, of one vehicle or a team; of the paper's, with the table of its claims."""

from typing import TYPE_CHECKING, Any

from ..html import folded, listing, paragraphs, safe, table
from ..scenario.experiment import Scenario
from ..scenario.file import CHANGED, OWN_LAW, OWN_PARTS, TEAM, paper_scenario
from ..scenario.recorded_run import waypoints_of
from ..scenario.team import Team
from ..simulation.repeating import text_of
from ..simulation.report import claims
from .excitation_section import excitation_section
from .page import Card, Page, Section, again_section, solver_facts
from .pictures import figure_sections, loop_section, team_section
from .run_words import (
    asked,
    asked_of_team,
    at_end,
    claims_result,
    found_of_clpe,
    found_of_clpes,
    found_of_flow,
    number,
    numbers_of,
    of_the_worst,
)

if TYPE_CHECKING:
    import xarray

KINDS = ("Run of a scenario", "Run of a diagram")
GIVEN = {OWN_LAW: "law", CHANGED: "parameters", OWN_PARTS: "parts"}
ALL = "All that was asked, as a file for <code>clpt run</code>:"


def run_page(run: "xarray.Dataset", system: Scenario | Team, title: str | None = None) -> Page:
    """Return the page of a run that carries this scenario, or this team."""
    numbers = numbers_of(run, system)
    own, changed, parts = (run.attrs.get(name) for name in (OWN_LAW, CHANGED, OWN_PARTS))
    paper = system == paper_scenario() and not (own or changed or parts)
    text = listing(str(run.attrs.get(TEAM, run.attrs.get("scenario"))))
    if isinstance(system, Team):
        kind, scenario, alone = "Run of a team", system.first, of_the_worst(numbers)
        said = [asked_of_team(system), found_of_clpes(numbers, scenario.units.length)]
        cards = [_vehicles(system)]
        sections = [team_section(run, numbers)]
    else:
        kind, scenario, alone = KINDS[parts is not None], system, numbers
        law = f"{own}, given in Python," if own else scenario.learning.law
        count = len(waypoints_of(run, system))
        if not count:  # there are no rounds
            numbers = alone = {**numbers, "clpe_rms_per_cycle": []}
        begin = "Asked, as far as the scenario says" if parts else "Asked"
        said = [asked(scenario, law, count, begin), found_of_clpe(numbers, scenario.units.length)]
        cards, sections = [], figure_sections(run, scenario, numbers)
    claimed = []
    if paper and not numbers["of_samples"]:  # else the run does not carry its figures
        judged = claims_result(claims(numbers))
        claimed = [Section("claims", judged.title, [table(*judged[:3])])]
    loop = [] if parts else loop_section(system, own)
    if changed or parts:
        why = paragraphs(["Not measured: the run had what its scenario does not hold."])
        taught = Section("excitation", "What the track can teach", [why])
    else:
        taught = excitation_section(run)
    return Page(
        "Section IV of the paper" if paper else kind,
        title or str(run.attrs.get("title") or "A run without a title"),
        [*said, found_of_flow(alone, scenario)],
        _warnings(run, scenario, numbers),
        [*cards, *_cards(alone, scenario)],
        [
            *claimed,
            *loop,
            *sections,
            taught,
            Section("scenario", "Scenario", [f"<p>{ALL}</p>", folded("The scenario, TOML", text)]),
            _again(run, scenario, paper),
        ],
    )


def _vehicles(team: Team) -> Card:
    coupling = f"coupling {team.coupling:g} 1/{team.first.units.time}; below, of the worst"
    return Card("Vehicles", str(len(team.members)), coupling)


def _warnings(run: "xarray.Dataset", scenario: Scenario, numbers: dict[str, Any]) -> list[str]:
    """Return what a reader must know before the figures."""
    changed, parts = run.attrs.get(CHANGED), run.attrs.get(OWN_PARTS)
    said = []
    if run.attrs.get("status", "finished") != "finished":
        said.append(f"The run ended early: {run.attrs.get('message', 'no reason is recorded')}.")
    elif "; " in str(run.attrs.get("message")):  # more than that it ended
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
            f"The run is of a diagram with parts given in Python, {parts}: what it followed, the "
            "true flow and the law may be others than the scenario says."
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
    if given and text_of(run)[0]:
        said = "The file holds the equations that ran, with inputs, start and method. Type:"
        commands = ["clpt run run.nc --out again.nc", "clpt report again.nc -o report.html"]
    elif given:
        said = f"The run cannot be made again from its file alone: its {' and '.join(given)}"
        said, commands = f"{said} were given in Python.", []
    return again_section(
        said, commands, str(run.attrs.get("software", "")), solver_facts(run.attrs)
    )
