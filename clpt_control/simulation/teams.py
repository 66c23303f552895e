"""The closed loop of a team: the paper's blocks for each vehicle, and the pull of neighbours.

Every vehicle's blocks stand in a namespace of its name: `west/adaptation` makes `west/alpha`.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arguments import public
from ..blocks.laws.table import LAWS
from ..blocks.localization import TRUE
from ..blocks.team import consensus_block, pulled_law
from ..diagrams.changes import changes_of
from ..diagrams.interconnection import Diagram, connect, wiring_of_blocks
from ..equations.block import Block
from ..equations.declaration import split, within
from ..native.ending import Solution
from ..native.engines import chosen
from ..scenario.file import TEAM
from ..scenario.team import LAW, Team, team_to_text
from .dataset import Columns, run_frame, with_states
from .loops import changed_blocks, paper_blocks
from .scenario_run import ScenarioRun, faster_flow, speeds_of, with_solver
from .starts import state_labels, state_of

if TYPE_CHECKING:
    import xarray


@public
def team_loop(team: Team) -> Diagram:
    """Wire the closed loop of a team.

    Parameters
    ----------
    team : Team
        Vehicles, graph and coupling.

    Returns
    -------
    Diagram
        A `control.InterconnectedSystem`; blocks and ports carry the vehicle's name, as
        ``west/adaptation`` and ``west/alpha``; the states are those of the first vehicle's
        `closed_loop`, then the second's.

    Raises
    ------
    ScenarioError
        If what is given is no team.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> paper = clpt.paper_scenario()
    >>> team = clpt.Team(members={"west": paper, "east": paper}, coupling=0.5)
    >>> clpt.team_loop(team).nstates
    28
    """
    return connect(team_blocks(team), name="team")


def team_blocks(team: Team) -> list[Block]:
    """Return the blocks of all vehicles, vehicle by vehicle, the consensus of each the last."""
    blocks = []
    for name, scenario in team.members.items():
        law = pulled_law(LAWS[LAW].block(scenario.known_to_law))
        blocks += [within(one, name) for one in changed_blocks(scenario, changes_of(law))]
        neighbours = team.neighbours(name)
        blocks.append(consensus_block(name, neighbours, scenario.basis.N, team.coupling))
    return blocks


class TeamRun(ScenarioRun):
    """A team's closed loop, ready to run: integrate, ask its signals, make a Dataset."""

    def __init__(
        self,
        team: Team,
        solver: Mapping[str, Any],
        engine: str | None = None,
    ):
        members = {name: with_solver(one, solver) for name, one in team.members.items()}
        self.scenario: Any = Team(members=members, edges=team.edges, coupling=team.coupling)
        self.parts = team_blocks(team)
        self.wiring = wiring_of_blocks(self.parts)
        starts = [state_of(one, paper_blocks(one)) for one in team.members.values()]
        self.start = np.concatenate(starts)
        self.runner = chosen(self.wiring, engine=engine, name="the team")

    def vehicles(self) -> dict[str, Columns]:
        """Return where each vehicle's signals stand; what one alone lacks is as in calm.

        Without noise the true position is what is read, without a limit what is commanded flown.
        """
        found: dict[str, Columns] = {name: Columns({}, {}) for name in self.scenario.members}
        for k, label in enumerate(self.labels):
            vehicle, own = split(label)
            found[vehicle].column[own] = k
        for node, given in zip(self.wiring.nodes, self.runner.sweep.given, strict=True):
            vehicle, own = split(node.name)
            found[vehicle].ran[own] = given
        for port, other in (("v_c", "v_x"), (TRUE, "x")):
            if any(f"{port}[0]" in one.column for one in found.values()):
                for one in found.values():
                    for k in range(2):
                        one.column.setdefault(f"{port}[{k}]", one.column[f"{other}[{k}]"])
        return found

    def dataset(self, solution: Solution, signals: np.ndarray) -> "xarray.Dataset":
        """Return a solution with a dimension `vehicle`; V is the team's."""
        import xarray

        team, columns = self.scenario, self.vehicles()
        runs = [
            run_frame(scenario, columns[name], {}).filled(solution, signals)
            for name, scenario in team.members.items()
        ]
        names = xarray.DataArray(
            list(team.members), dims="vehicle", attrs={"long_name": "vehicle of the team"}
        )
        whole = xarray.concat(runs, names.rename("vehicle"), data_vars=None, coords="minimal")
        if "flow_parameters" in whole:  # one flow
            whole["flow_parameters"] = runs[0].flow_parameters
        if "lyapunov" in whole:
            total = whole.lyapunov.sum("vehicle", keep_attrs=True)
            whole["lyapunov"] = total.assign_attrs(long_name="V of the team, the sum over vehicles")
        attributes = dict(runs[0].attrs)
        del attributes["scenario"]
        whole.attrs = {**attributes, TEAM: team_to_text(team)}
        for name, scenario in team.members.items():
            if (limit := scenario.vehicle.max_speed) is not None:
                found = speeds_of(whole.sel(vehicle=name), limit)
                if sentence := faster_flow(found, scenario.units):
                    whole.attrs["message"] += f"; {name}: {sentence}"
        whole.encoding["folder"] = str(team.first._folder)
        return with_states(whole, state_labels(self.parts), solution)
