"""Several vehicles that learn one flow over a graph, and their TOML file.

A team has a scenario for each vehicle, and a graph of the pairs that communicate.  The scenarios
differ only in [vehicle], [reference], [localization] and the learner's initial values.

    [team]
    coupling = 0.5                        # kappa, 1/time
    edges = [["west", "east"]]            # pairs of neighbours; default: all pairs

    [team.members.west]                   # keys that replace those of the file's other tables
    title = "west of the strait"
    vehicle.position = [-15, 0]
    reference = { kind = "circle", radius = 3, count = 8, dwell = 2 }

A vehicle's [reference] with a kind replaces the common one; without a kind, its keys do.
"""

import re
from collections.abc import Iterator
from itertools import combinations
from pathlib import Path
from typing import Annotated, Any

import numpy as np
from pydantic import Field, Strict, model_validator

from ...base.arguments import brief, public
from ...base.errors import DataError, ScenarioError
from ...base.html import facts, fragment, shortened
from ...base.run_attributes import TEAM
from . import file
from .experiment import Nested, Scenario, checked_scenario, scenario_tables
from .tables import Run, Table

TEAM_LAW = "learned-flow"
# tables that may differ between members, besides the initial values of [learning]
MEMBER_TABLES = ("vehicle", "reference", "localization")
MEMBER_STARTS = ("position", "feedback", "feedforward", "parameters")
FEWEST, MOST = 2, 100  # vehicles
# smaller connectivities are rounding; that of 100 vehicles in a row is 1e-3
LEAST_CONNECTIVITY = 1e-6


class Team(Table):
    """Several vehicles that learn one flow over a graph.

    Made by `load_scenario`, or from scenarios by name, the edges of the graph (pairs of names; left
    out, all are neighbours) and the coupling kappa, per ``units.time``, 0 or more. The scenarios
    share everything but vehicle, reference, localization and the learner's start.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> west = clpt.paper_scenario()
    >>> east = west.with_values({"vehicle.position": [3.0, 0.0]})
    >>> team = clpt.Team(members={"west": west, "east": east}, coupling=0.5)
    >>> team.edges
    (('west', 'east'),)
    """

    coupling: Annotated[float, Strict(), Field(ge=0, allow_inf_nan=False)]
    edges: tuple[tuple[str, str], ...] = ()
    members: dict[str, Scenario]

    @model_validator(mode="before")
    @classmethod
    def _all_are_neighbours(cls, values: Any) -> Any:
        if isinstance(values, dict) and values.get("edges") is None:
            names = values.get("members")
            names = names if isinstance(names, dict) else ()
            return {**values, "edges": tuple(combinations(names, 2))}
        return values

    def _mistakes(self) -> Iterator[str]:
        yield from self._member_mistakes()
        yield from self._seed_mistakes()
        yield from self._edge_mistakes()

    def _member_mistakes(self) -> Iterator[str]:
        names = list(self.members)
        if not FEWEST <= len(names) <= MOST:
            yield (
                f"members: has {len(names)} vehicles; must have {FEWEST} to {MOST}, a scenario each"
            )
        for name in names:
            if not re.fullmatch(r"\w[\w-]*", name):
                yield f"members: the name {name!r} of a vehicle must be letters, digits, _ and -"
        shared = shared_tables(self.first)
        for name, scenario in self.members.items():
            tables = shared_tables(scenario)
            for table in sorted(shared.keys() | tables.keys()):
                if shared.get(table) != tables.get(table):
                    yield (
                        f"members.{name}: its {table} is not that of {names[0]}; the vehicles of a "
                        f"team share everything but {', '.join(MEMBER_TABLES)} and the learner's "
                        "start"
                    )
        learning = self.first.learning
        if learning.law != TEAM_LAW:
            yield f'learning.law = "{learning.law}": must be "{TEAM_LAW}", the law of a team'
        if learning.sample is not None:
            yield "learning.sample: a team learns at all times. Remove the key"

    def _seed_mistakes(self) -> Iterator[str]:
        seeds: dict[int, str] = {}
        for name, scenario in self.members.items():
            if (fixes := scenario.localization) is None or not fixes.noise:
                continue
            owner = seeds.setdefault(fixes.seed or 0, name)
            if owner != name:
                yield (
                    f"members.{name}: localization.seed = {fixes.seed or 0} is that of {owner}, so "
                    "that both would have the same noise. Give each its own"
                )

    def _edge_mistakes(self) -> Iterator[str]:
        pairs = set[frozenset[str]]()
        for k, edge in enumerate(self.edges):
            for name in edge:
                if name not in self.members:
                    yield (
                        f"edges[{k}]: there is no vehicle {name!r}; must be among "
                        f"{', '.join(self.members)}"
                    )
            if len(set(edge)) < 2 or set(edge) in pairs:
                yield f"edges[{k}] = {list(edge)}: must join two vehicles, each pair once"
            pairs.add(frozenset(edge))
        if not self.connectivity > LEAST_CONNECTIVITY:
            yield "edges: no path joins all vehicles. Join each to the others, or run it alone"

    def __repr__(self) -> str:
        names = shortened(", ".join(self.members), 60)
        return f"<Team of {len(self.members)}: {names}; coupling {self.coupling:g}>"

    __str__ = __repr__

    def _repr_html_(self) -> str:
        graph = [
            ("coupling", self.coupling),
            ("connectivity", f"{self.connectivity:.3g}"),
        ]
        return fragment(
            "Team", self.first.title, facts([*graph, *self.members.items()])
        )

    @public
    def neighbours(self, name: str) -> list[str]:
        """Return the neighbours of a vehicle, in the order of the edges."""
        return [b if a == name else a for a, b in self.edges if name in (a, b)]

    @property
    def first(self) -> Scenario:
        """The first vehicle's scenario, with all that vehicles share."""
        return next(iter(self.members.values()))

    @property
    def run(self) -> Run:
        """Duration, output step and tolerances of a run."""
        return self.first.run

    @property
    def connectivity(self) -> float:
        """Second eigenvalue lambda_2 of the graph's Laplacian."""
        near = [self.neighbours(name) for name in self.members]
        joined = np.array([[name in names for name in self.members] for names in near])
        laplacian = np.diag(joined.sum(axis=1)) - joined
        return float(np.linalg.eigvalsh(laplacian)[1])


def shared_tables(scenario: Scenario) -> Nested:
    """Return the tables that must be the same in all scenarios of a team."""
    shared = _without_member_tables(
        scenario.model_dump(mode="python", exclude={"title"})
    )
    if scenario.field_path is not None:
        shared["flow"]["field"] = scenario.field_path.resolve()
    return shared


def _without_member_tables(tables: Nested) -> Nested:
    """Return the tables of a scenario without the keys that may differ between vehicles."""
    shared = {
        table: value for table, value in tables.items() if table not in MEMBER_TABLES
    }
    shared["learning"] = {
        k: v for k, v in shared["learning"].items() if k not in MEMBER_STARTS
    }
    return shared


@public
def load_scenario(path: str | Path) -> Any:
    """Read a scenario or a team from a TOML file or a run's file.

    Parameters
    ----------
    path : str or Path
        A ``.toml`` file, or a ``.nc`` file that `clpt run` wrote.

    Returns
    -------
    Scenario or Team
        Checked; a Team if the file has a table ``[team]``. A relative ``flow.field`` is relative
        to the file.

    Raises
    ------
    ScenarioError
        If the file is missing, is not TOML, or a key or value is not allowed.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> import tempfile, pathlib
    >>> file = pathlib.Path(tempfile.mkdtemp()) / "paper.toml"
    >>> clpt.save_scenario(clpt.paper_scenario(), file)
    >>> clpt.load_scenario(file) == clpt.paper_scenario()
    True
    """
    path = Path(path)
    return system_from_text(file.read_text(path), str(path), path.parent)


def system_from_text(text: str, name: str, folder: Path | None) -> Scenario | Team:
    """Read a scenario or a team from TOML text; `name` begins errors, `folder` has its files."""
    common = file.tables_of(text, name)
    if "team" not in common:
        return checked_scenario(common, name, folder)
    team = _table(common.pop("team"), f"{name}: team")
    vehicles = _table(team.pop("members", None), f"{name}: team.members")
    members = {
        member: checked_scenario(
            _merged(common, _table(member_tables, f"{name}: team.members.{member}")),
            f"{name}, {member}",
            folder,
        )
        for member, member_tables in vehicles.items()
    }
    values = {"members": members, **team}
    return Team.model_validate(values, context={"name": f"{name}, team"})


def team_to_text(team: Team, folder: Path | None = None) -> str:
    """Return a team as TOML text; its field's path is relative to `folder`, if given."""
    tables = _without_member_tables(file.placed_tables(team.first, folder))
    members = {
        name: _member_tables(scenario, team.first.title)
        for name, scenario in team.members.items()
    }
    return file.toml(
        {
            **tables,
            "team": {
                "coupling": team.coupling,
                "edges": team.edges,
                "members": members,
            },
        }
    )


def _member_tables(scenario: Scenario, title: str) -> Nested:
    """Return the keys that were set and may differ between vehicles; `title` is the team's."""
    tables = scenario_tables(scenario)
    member = {} if scenario.title == title else {"title": scenario.title}
    member |= {table: tables[table] for table in MEMBER_TABLES if table in tables}
    starts = {
        key: value for key, value in tables["learning"].items() if key in MEMBER_STARTS
    }
    return {**member, "learning": starts} if starts else member


def _merged(common: Nested, member_tables: Nested) -> Nested:
    """Return the tables of one vehicle: its keys replace those of the team."""
    tables = dict(common)
    for table, values in member_tables.items():
        before = tables.get(table)
        if isinstance(values, dict) and isinstance(before, dict):
            replaced = table == "reference" and "kind" in values
            values = values if replaced else before | values
        tables[table] = values
    return tables


def _table(value: Any, where: str) -> Nested:
    """Return the value, which must be a table."""
    if not isinstance(value, dict):
        raise ScenarioError(f"{where} = {brief(value)}: must be a table of keys")
    return value


def team_of_run(run: Any) -> Team:
    """Return the team that a run carries."""
    if TEAM not in getattr(run, "attrs", {}):
        raise DataError(
            f"{brief(run)}: must be a Team or a team's run; clpt.load_scenario and "
            "clpt.load_run read them"
        )
    team: Any = system_of_run(run)
    return team


def scenario_of_run(run: Any) -> Scenario:
    """Return the scenario of a vehicle's run; its field's file must exist."""
    system = system_of_run(run)
    if isinstance(system, Team):
        raise DataError(
            "the run is a team's. Give that of one vehicle, "
            f"run.sel(vehicle={next(iter(system.members))!r}); run.clpt.plot() draws a team"
        )
    return system


def system_of_run(run: Any, files: bool = True) -> Scenario | Team:
    """Return the scenario or team that a run carries; with `files` its field's file must exist.

    The run of one vehicle, `run.sel(vehicle=...)`, has the scenario of this member.
    """
    attributes = getattr(run, "attrs", {})
    if TEAM in attributes and "scenario" in attributes:
        raise DataError(
            "the run carries a scenario and a team; must be of one of the two"
        )
    if TEAM not in attributes:
        return file.attached_scenario(run, files)
    folder = file.folder_of(run) if files else None
    system = system_from_text(str(attributes[TEAM]), "the run", folder)
    vehicle = run.coords.get("vehicle")
    if isinstance(system, Team) and vehicle is not None and not vehicle.ndim:
        return system.members[vehicle.item()]
    return system
