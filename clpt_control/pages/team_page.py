"""The page of a team's run: who swam where, and what they learned together."""

from typing import TYPE_CHECKING, Any

from ..figures import figure_of
from ..html.text import folded, listing, paragraphs, table
from ..scenario.file import TEAM
from ..scenario.team import Team
from ..scenario.team_file import team_of_run
from ..simulation.report import team_summary
from ..simulation.team_plots import team_plot
from .excitation_section import excitation_section
from .page import Card, Drawn, Page, Section, narrow
from .run_numbers import at_end, shown_samples
from .run_words import number
from .versions import again_section, solver_facts

if TYPE_CHECKING:
    import xarray

MOST_NAMED = 4  # vehicles in a sentence
MOST_DRAWN = 3  # vehicles in a drawing of the loop


def team_page(run: "xarray.Dataset", title: str | None = None) -> Page:
    """Return the page of a team's run."""
    team = team_of_run(run)
    numbers = team_summary(team, run, run)
    early = run.attrs.get("status", "finished") != "finished"
    sections = [
        _team(run, team, numbers),
        *_loop(team),
        excitation_section(run),
        Section(
            "scenario",
            "Scenario",
            [folded("The team's scenario, TOML", listing(str(run.attrs[TEAM])))],
        ),
        again_section(
            "Save the scenario above as <code>team.toml</code>, and type:",
            ["clpt run team.toml --out team.nc", "clpt report team.nc -o report.html"],
            str(run.attrs.get("software", "")),
            solver_facts(run.attrs),
        ),
    ]
    return Page(
        "Run of a team",
        title or str(run.attrs.get("title") or "A team's run without a title"),
        [_asked(team), _found(team, numbers), _learned(team, numbers)],
        [f"The run ended early: {run.attrs.get('message')}."] if early else [],
        _cards(team, numbers),
        sections,
    )


def _named(names: list[str]) -> str:
    if len(names) > MOST_NAMED:
        return f"{names[0]} to {names[-1]}"
    return ", ".join(names[:-1]) + f" and {names[-1]}" if names[1:] else names[0]


def _asked(team: Team) -> str:
    unit, names = team.first.units, list(team.members)
    water = "a measured current" if team.first.flow.field is not None else "one flow"
    return (
        f"Asked: {len(names)} vehicles, {_named(names)}, each visit their own waypoints for "
        f"{team.run.duration:g} {unit.time} in {water} that none of them knows; each learns it "
        "from its own prediction error (CLPE) and, with a coupling of "
        f"{team.coupling:g} 1/{unit.time}, from its neighbours."
    )


def _found(team: Team, numbers: dict[str, Any]) -> str:
    late, unit = numbers["clpe_rms_last_quarter"], team.first.units.length
    worst = max(late, key=late.__getitem__)
    return (
        f"Found: over the last quarter the CLPE, root mean square, is at most "
        f"{number(late[worst])} {unit}, that of {worst}; over the whole run it was at most "
        f"{number(max(numbers['clpe_rms'].values()))} {unit}."
    )


def _learned(team: Team, numbers: dict[str, Any]) -> str:
    unit = team.first.units
    said = f"At the end, t = {numbers['end']:g} {unit.time}, "
    if errors := numbers.get("max_flow_parameter_error"):
        most = max(at_end(one) for one in errors.values())
        said += (
            f"the largest error of a flow parameter of any vehicle is {number(most)} "
            f"{unit.length}/{unit.time}, and "
        )
    apart = at_end(numbers["max_disagreement"])
    return said + f"two vehicles differ by at most {number(apart)} {unit.length}/{unit.time}."


def _cards(team: Team, numbers: dict[str, Any]) -> list[Card]:
    unit = team.first.units
    cards = [
        Card("Vehicles", str(len(team.members)), f"coupling {team.coupling:g} 1/{unit.time}"),
        Card(
            "CLPE rms, last quarter",
            f"{number(max(numbers['clpe_rms_last_quarter'].values()))} {unit.length}",
            "of the vehicle with the largest",
        ),
    ]
    if errors := numbers.get("max_flow_parameter_error"):
        most = max(at_end(one) for one in errors.values())
        below = f"of any vehicle, at t = {numbers['end']:g} {unit.time}"
        value = f"{number(most)} {unit.length}/{unit.time}"
        cards.append(Card("Largest error of a flow parameter", value, below))
    return cards


def _team(run: "xarray.Dataset", team: Team, numbers: dict[str, Any]) -> Section:
    """Return the team's figure and a row for each vehicle."""
    unit = team.first.units
    columns = ["vehicle", f"CLPE rms ({unit.length})", f"last quarter ({unit.length})"]
    keys = {
        "max_flow_parameter_error": f"flow parameter error ({unit.length}/{unit.time})",
        "max_gain_error": f"gain error (1/{unit.time})",
    }
    keys = {key: name for key, name in keys.items() if key in numbers}
    rows = [
        [
            name,
            number(numbers["clpe_rms"][name]),
            number(numbers["clpe_rms_last_quarter"][name]),
            *(number(at_end(numbers[key][name])) for key in keys),
        ]
        for name in team.members
    ]
    listed = table("Each vehicle, errors at the end", [*columns, *keys.values()], rows)
    parts: list[str | Drawn] = [listed]
    if run.sizes["time"] > 1:
        few, thin = shown_samples(run)
        caption = (
            "Tracks and waypoints over the flow at the start; the size of each prediction error; "
            "the largest error of what each vehicle learned." + thin
        )
        parts.insert(0, Drawn("team", narrow(figure_of(team_plot, few), 7.6), caption))
    else:
        parts.append(paragraphs(["The run has one sample: nothing can be drawn over time."]))
    return Section("team", "Tracks, errors, what was learned", parts)


def _loop(team: Team) -> list[Section]:
    from ..diagrams.drawing.figure import block_figure
    from ..simulation.teams import team_loop

    if len(team.members) > MOST_DRAWN:
        return []
    caption = "The team's loop: the blocks of each vehicle, and the pull of its neighbours."
    drawn = Drawn("loop", block_figure(team_loop(team)), caption, wide=True)
    return [Section("loop", "The loop", [drawn])]
