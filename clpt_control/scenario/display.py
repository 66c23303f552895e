"""How a scenario and a team are displayed: in a line, and in a notebook."""

from collections.abc import Iterator
from typing import Any

from ..html import facts, fragment, shortened, unfolding
from .tables import Circle

MOST_VEHICLES = 20


def scenario_line(scenario: Any) -> str:
    """Return a scenario in a line."""
    points = len(scenario.waypoints)
    return (
        f"<Scenario {shortened(scenario.title, 60)!r}: {scenario.learning.law}, "
        f"{scenario.basis.N} flow functions, {points} waypoint{'s' * (points > 1)}, "
        f"{scenario.run.duration:g} {scenario.units.time}>"
    )


def scenario_html(scenario: Any) -> str:
    """Return a scenario as a table, with its keys to unfold."""
    keys = (f"{key} = {value!r}" for key, value, given in scenario.every_key() if given)
    listed = unfolding("every key given", "\n".join(keys))
    return fragment("Scenario", scenario.title, facts(_facts(scenario)), listed)


def team_line(team: Any) -> str:
    """Return a team in a line."""
    names = shortened(", ".join(team.members), 60)
    return f"<Team of {len(team.members)}: {names}; coupling {team.coupling:g}>"


def team_html(team: Any) -> str:
    """Return a team as a table of its vehicles, and what they share."""
    length, time = team.first.units.length, team.first.units.time
    rows = []
    for name, one in list(team.members.items())[:MOST_VEHICLES]:
        hears = ", ".join(team.neighbours(name)) or "nobody"
        rows.append((name, _pair(one.vehicle.position), _waypoints(one), hears))
    if (more := len(team.members) - MOST_VEHICLES) > 0:
        rows.append(("...", f"{more} more", "", ""))
    shared = [
        ("coupling kappa", f"{team.coupling:g} 1/{time}"),
        ("connectivity lambda_2", f"{team.connectivity:.3g}"),
        ("flow", _flow(team.first)),
        ("run", _run(team.first)),
    ]
    head = ("vehicle", f"starts at ({length})", "waypoints", "hears")
    return fragment("Team", team.first.title, facts(rows, head), facts(shared))


def _facts(scenario: Any) -> Iterator[tuple[str, str]]:
    units, car, learning = scenario.units, scenario.vehicle, scenario.learning
    rate = f"1/{units.time}"
    yield "flow", _flow(scenario)
    if (push := scenario.flow.disturbance) is not None:
        size = _pair(push.amplitude)
        yield "disturbance", f"{push.kind}, {size} {units.length}/{units.time}"
    speed = f"{units.length}/{units.time} through the water"
    limit = "" if car.max_speed is None else f", at most {car.max_speed:g} {speed}"
    gains = f"K_D = {_pair(car.feedback)}, Gamma_D = {_pair(car.feedforward)} {rate}"
    yield "vehicle", f"{gains}, from {_pair(car.position)} {units.length}{limit}"
    yield "waypoints", f"{_waypoints(scenario)}; a cycle lasts {scenario.cycle:g} {units.time}"
    used = learning.used_gains
    one = f", gain {used.parameters:g}" if used.one else ", a gain each"
    sample = "" if learning.sample is None else f", sampled each {learning.sample:g} {units.time}"
    yield "law", f"{learning.law}{'' if learning.row.at_fixes else one}{sample}"
    if (table := scenario.localization) is not None:
        fixes = f"fixes each {table.interval:g} {units.time}, " if table.interval else ""
        yield "position", f"{fixes}noise {table.noise:g} {units.length}"
    yield "run", _run(scenario)


def _flow(scenario: Any) -> str:
    functions = f"{scenario.basis.N} {scenario.basis.kernel} functions"
    if scenario.flow.field is not None:
        return f"the field {scenario.flow.field}, learned with {functions}"
    return f"theta of {functions}"


def _waypoints(scenario: Any) -> str:
    units, reference = scenario.units, scenario.reference
    circle = isinstance(reference, Circle)
    where = f" on a circle of {reference.radius:g} {units.length}" if circle else ""
    return f"{len(scenario.waypoints)}{where}, {reference.dwell:g} {units.time} at each"


def _run(scenario: Any) -> str:
    run, time = scenario.run, scenario.units.time
    return f"{run.duration:g} {time}, recorded each {run.output_step:g} {time}"


def _pair(pair: Any) -> str:
    return f"({pair[0]:g}, {pair[1]:g})"
