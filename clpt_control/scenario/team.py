"""Several vehicles that learn one flow over a graph.

A team is a scenario for each vehicle and who hears whom.  The vehicles share everything but
themselves: each has its own [vehicle], [reference], [localization] and start of the learner.
"""

import re
from itertools import combinations
from typing import Annotated, Any

import numpy as np
from pydantic import Field, Strict, model_validator

from ..arguments import public, shown
from .experiment import Scenario, scenario_tables
from .mistakes import Table
from .shown import team_html, team_line
from .tables import Run

LAW = "learned-flow"
OWN = ("vehicle", "reference", "localization", "learning")  # tables that a member may have
STARTS = ("position", "feedback", "feedforward", "parameters")  # its keys of [learning]
FEWEST, MOST = 2, 100  # vehicles


class Team(Table):
    """Several vehicles that learn one flow over a graph.

    Made by `load_team`, or from scenarios by name, the edges of the graph (pairs of names; left
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
        edges, members = values.get("edges"), values.get("members")
        if edges is None:
            return {**values, "edges": tuple(combinations(members or (), 2))}
        for k, edge in enumerate(edges if isinstance(edges, list | tuple) else [edges]):
            pair = isinstance(edge, list | tuple) and len(edge) == 2
            if not pair or not all(isinstance(name, str) for name in edge):
                raise ValueError(f"edges[{k}] = {shown(edge)}: must be the names of two vehicles")
        return values

    @model_validator(mode="after")
    def _named_vehicles(self) -> "Team":
        names = list(self.members)
        if not FEWEST <= len(names) <= MOST:
            raise ValueError(
                f"members: has {len(names)} vehicles; must have {FEWEST} to {MOST}, a scenario each"
            )
        for name in names:
            if not re.fullmatch(r"\w[\w-]*", name):
                raise ValueError(
                    f"members: the name {name!r} of a vehicle must be letters, digits, _ and -"
                )
        return self

    @model_validator(mode="after")
    def _one_flow(self) -> "Team":
        first, *others = self.members
        shared = shared_tables(self.members[first])
        for name in others:
            own = shared_tables(self.members[name])
            for table in sorted(shared.keys() | own.keys()):
                if shared.get(table) != own.get(table):
                    raise ValueError(
                        f"members.{name}: its {table} is not that of {first}; the vehicles of a "
                        f"team share everything but {', '.join(OWN[:-1])} and the learner's start"
                    )
        if (law := self.members[first].learning.law) != LAW:
            raise ValueError(f'learning.law = "{law}": must be "{LAW}", the law of a team')
        if self.members[first].learning.sample is not None:
            raise ValueError("learning.sample: a team learns at all times; remove the key")
        return self

    @model_validator(mode="after")
    def _noise_of_their_own(self) -> "Team":
        seeds: dict[int, str] = {}
        for name, scenario in self.members.items():
            if (seen := scenario.localization) is None or not seen.noise:
                continue
            other = seeds.setdefault(seen.seed or 0, name)
            if other != name:
                raise ValueError(
                    f"members.{name}: localization.seed = {seen.seed or 0} is that of {other}, so "
                    "that both would have the same noise; give each its own"
                )
        return self

    @model_validator(mode="after")
    def _connected(self) -> "Team":
        from scipy.sparse.csgraph import connected_components

        names, seen = list(self.members), set[frozenset[str]]()
        for k, edge in enumerate(self.edges):
            for name in edge:
                if name not in self.members:
                    raise ValueError(
                        f"edges[{k}]: there is no vehicle {name!r}; must be among "
                        f"{', '.join(names)}"
                    )
            if len(set(edge)) < 2 or set(edge) in seen:
                raise ValueError(
                    f"edges[{k}] = {list(edge)}: must join two vehicles, each pair once"
                )
            seen.add(frozenset(edge))
        _, groups = connected_components(self._laplacian)
        for name, group in zip(names, groups, strict=True):
            if group != groups[0]:
                raise ValueError(
                    f"edges: no path joins {name} to {names[0]}; join every vehicle to the others, "
                    "or run it alone"
                )
        return self

    def __repr__(self) -> str:
        return team_line(self)

    def __str__(self) -> str:
        return repr(self)

    def _repr_html_(self) -> str:
        return team_html(self)

    @public
    def neighbours(self, name: str) -> list[str]:
        """Return the neighbours of a vehicle, in the order of the edges."""
        return [b if a == name else a for a, b in self.edges if name in (a, b)]

    @property
    def first(self) -> Scenario:
        """Scenario of the first vehicle, for what all share."""
        return next(iter(self.members.values()))

    @property
    def run(self) -> Run:
        """How long, how often recorded, how exact."""
        return self.first.run

    @property
    def _laplacian(self) -> np.ndarray:
        place = {name: k for k, name in enumerate(self.members)}
        laplacian = np.zeros((len(place), len(place)))
        for edge in self.edges:
            a, b = (place[name] for name in edge)
            laplacian[[a, b], [a, b]] += 1
            laplacian[[a, b], [b, a]] -= 1
        return laplacian

    @property
    def connectivity(self) -> float:
        """Second eigenvalue lambda_2 of the graph's Laplacian."""
        return float(np.linalg.eigvalsh(self._laplacian)[1])


def shared_tables(scenario: Scenario) -> dict[str, Any]:
    """Return what all scenarios of a team must have alike, by table."""
    dumped = scenario.model_dump(mode="python")
    shared = {table: value for table, value in dumped.items() if table not in ("title", *OWN)}
    shared["learning"] = {k: v for k, v in dumped["learning"].items() if k not in STARTS}
    if scenario.field_path is not None:
        shared["flow"]["field"] = scenario.field_path.resolve()
    return shared


def own_tables(scenario: Scenario) -> dict[str, Any]:
    """Return what a vehicle of a team has for itself, with the keys it was given."""
    tables = scenario_tables(scenario)
    own = {table: tables[table] for table in OWN[:-1] if table in tables}
    starts = {key: value for key, value in tables["learning"].items() if key in STARTS}
    return {**own, "learning": starts} if starts else own
