"""How a scenario and a team are displayed: in a line, and in a notebook."""

from typing import Any

from ..html import facts, fragment, shortened


def scenario_line(scenario: Any) -> str:
    """Return a scenario in a line."""
    points = len(scenario.waypoints)
    return (
        f"<Scenario {shortened(scenario.title, 60)!r}: {scenario.learning.law}, "
        f"{scenario.basis.N} flow functions, {points} waypoint{'s' * (points > 1)}, "
        f"{scenario.run.duration:g} {scenario.units.time}>"
    )


def scenario_html(scenario: Any) -> str:
    """Return the keys that a scenario was given, as a table."""
    keys = ((key, value) for key, value, given in scenario.every_key() if given)
    return fragment("Scenario", scenario.title, facts(keys))


def team_line(team: Any) -> str:
    """Return a team in a line."""
    names = shortened(", ".join(team.members), 60)
    return f"<Team of {len(team.members)}: {names}; coupling {team.coupling:g}>"


def team_html(team: Any) -> str:
    """Return a team as a table of its graph and its vehicles."""
    graph = [("coupling", team.coupling), ("connectivity", f"{team.connectivity:.3g}")]
    return fragment("Team", team.first.title, facts([*graph, *team.members.items()]))
