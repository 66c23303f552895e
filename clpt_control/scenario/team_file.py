"""A team in a TOML file: a scenario whose [team] says what each vehicle has for itself.

    [team]
    coupling = 0.5                        # kappa, 1/time
    edges = [["west", "east"]]            # who hears whom; left out: all

    [team.members.west]                   # keys in place of those at the top
    vehicle.position = [-15, 0]
    reference = { kind = "circle", radius = 3, count = 8, dwell = 2 }

A vehicle's [reference] with a kind takes the place of the common one; else key by key.
"""

from pathlib import Path
from typing import Any

from ..arguments import public, shown
from ..errors import DataError, ScenarioError
from .experiment import Scenario, checked_scenario
from .file import (
    TEAM,
    folder_of,
    placed_tables,
    read_text,
    run_text,
    scenario_from_text,
    scenario_of_run,
    tables_of,
    toml,
)
from .team import OWN, STARTS, Team, own_tables


@public
def load_team(path: str | Path) -> Team:
    """Read a team from a TOML file or from its run's NetCDF file.

    Parameters
    ----------
    path : str or Path
        A ``.toml`` file with a table ``[team]``, or a ``.nc`` file that `clpt run` wrote of it.

    Returns
    -------
    Team
        Checked; a relative ``flow.field`` is relative to the file.

    Raises
    ------
    ScenarioError
        If the file is missing, is no team's, or a key or value is not allowed.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> clpt.load_team("team.toml").connectivity  # doctest: +SKIP
    2.0
    """
    found = load_either(path)
    if not isinstance(found, Team):
        raise ScenarioError(f"{path}: is a scenario of one vehicle; a team has a table [team]")
    return found


def load_either(path: str | Path) -> Scenario | Team:
    """Read a scenario or a team from a TOML file or a run's NetCDF file."""
    path = Path(path)
    text = run_text(path) if path.suffix == ".nc" else read_text(path)
    if "team" in tables_of(text, str(path)):
        return team_from_text(text, str(path), path.parent)
    return scenario_from_text(text, str(path), path.parent)


def team_from_text(text: str, name: str, folder: Path) -> Team:
    """Read a team of TOML text; `name` begins each error, `folder` holds its files."""
    common = tables_of(text, name)
    team = _table(common.pop("team", None), f"{name}: team")
    given = _table(team.pop("members", None), f"{name}: team.members")
    members = {
        member: checked_scenario(
            _merged(common, _table(own, f"{name}: team.members.{member}"), f"{name}, {member}"),
            f"{name}, {member}",
            folder,
        )
        for member, own in given.items()
    }
    whole = {"members": members, **team}
    return Team.model_validate(whole, context={"name": f"{name}, team"})


def team_to_text(team: Team, folder: Path | None = None) -> str:
    """Return a team as TOML text to lie in `folder`, to which a relative field is turned."""
    tables = placed_tables(team.first, folder)
    for table in OWN[:-1]:
        tables.pop(table, None)
    tables["learning"] = {k: v for k, v in tables["learning"].items() if k not in STARTS}
    members = {name: own_tables(scenario) for name, scenario in team.members.items()}
    return toml(
        {**tables, "team": {"coupling": team.coupling, "edges": team.edges, "members": members}}
    )


def _merged(common: dict[str, Any], own: dict[str, Any], name: str) -> dict[str, Any]:
    """Return the keys of all vehicles with those of one in their places."""
    tables = dict(common)
    for table, values in own.items():
        if table not in OWN:
            raise ScenarioError(
                f"{name}: {table} is no table of a vehicle's own, which are {', '.join(OWN)}; what "
                "the team shares stands at the top"
            )
        for key in values if table == "learning" and isinstance(values, dict) else ():
            if key not in STARTS:
                raise ScenarioError(
                    f"{name}: learning.{key} is shared by the team and stands at the top; a "
                    f"vehicle's own are {', '.join(STARTS)}"
                )
        before = tables.get(table)
        whole = table == "reference" and isinstance(values, dict) and "kind" in values
        if isinstance(values, dict) and isinstance(before, dict) and not whole:
            tables[table] = {**before, **values}
        else:
            tables[table] = values
    return tables


def _table(value: Any, where: str) -> dict[str, Any]:
    """Return a table; refuse what is none."""
    if not isinstance(value, dict):
        raise ScenarioError(f"{where} = {shown(value)}: must be a table of keys")
    return value


def team_of_run(run: Any) -> Team:
    """Return the team that a run carries in its attributes."""
    text = getattr(run, "attrs", {}).get(TEAM)
    if text is None:
        raise DataError(
            f"{shown(run)}: must be a Team or a team's run; clpt.load_team and clpt.load_run read "
            "them"
        )
    return team_from_text(str(text), "the run", folder_of(run))


def system_of_run(run: Any) -> Scenario | Team:
    """Return the scenario or the team that a run carries in its attributes."""
    return team_of_run(run) if TEAM in getattr(run, "attrs", {}) else scenario_of_run(run)
