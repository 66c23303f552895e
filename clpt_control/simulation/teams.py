"""The closed loop of a team: the paper's blocks for each vehicle, and the pull of neighbours.

Every vehicle's blocks stand in a namespace of its name: `west/adaptation` makes `west/alpha`.
"""

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arguments import public
from ..blocks.laws.table import LAWS
from ..blocks.localization import TRUE
from ..blocks.team import consensus_block, pulled_law
from ..diagrams.changes import changes_of
from ..diagrams.interconnection import Diagram, connect, wiring_of_blocks
from ..diagrams.wiring import Wiring
from ..equations.block import Block
from ..equations.namespaces import split, within
from ..native.ending import Solution
from ..native.engines import chosen
from ..scenario.experiment import Scenario
from ..scenario.file import TEAM
from ..scenario.team import LAW, Team
from ..scenario.team_file import team_to_text
from .dataset import Columns, run_frame, with_states
from .loops import changed_blocks, paper_blocks
from .speeds import faster_flow, speeds_of
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


def vehicle_blocks(team: Team, name: str) -> list[Block]:
    """Return the blocks of one vehicle, in its namespace, its consensus the last."""
    scenario = team.members[name]
    law = pulled_law(LAWS[LAW].block(scenario.known_to_law))
    own = [within(block, name) for block in changed_blocks(scenario, changes_of(law))]
    neighbours = team.neighbours(name)
    return [*own, consensus_block(name, neighbours, scenario.basis.N, team.coupling)]


def team_blocks(team: Team) -> list[Block]:
    """Return the blocks of all vehicles, vehicle by vehicle."""
    return [block for name in team.members for block in vehicle_blocks(team, name)]


def team_state(team: Team) -> np.ndarray:
    """Return the state of a team at t = 0, vehicle by vehicle."""
    starts: Iterable[Scenario] = team.members.values()
    return np.concatenate([state_of(one, paper_blocks(one)) for one in starts])


class TeamRun:
    """A team's closed loop, ready to run: integrate, ask its signals, make a Dataset."""

    def __init__(
        self,
        team: Team,
        rtol: float | None = None,
        atol: float | None = None,
        engine: str | None = None,
    ):
        tolerances = {"run.rtol": rtol, "run.atol": atol}
        given = {key: value for key, value in tolerances.items() if value is not None}
        members = {name: one.with_values(given) for name, one in team.members.items()}
        self.scenario = Team(members=members, edges=team.edges, coupling=team.coupling)
        self.wiring, self.start = wiring_of_blocks(team_blocks(team)), team_state(team)
        self.runner = chosen(self.wiring, engine=engine, name="the team")

    def integrate(
        self, state: np.ndarray, times: np.ndarray, progress: Any = None, **how: Any
    ) -> Solution:
        """Integrate from a state at the first time to the last."""
        own: dict[str, Any] = {"rtol": self.scenario.run.rtol, "atol": self.scenario.run.atol}
        return self.runner.run(state, times, **own, progress=progress, **how)

    def signals(self, solution: Solution) -> np.ndarray:
        """Return all block outputs, shape (ntimes, nsignals), right limits at jumps."""
        return self.runner.signals(solution)

    def columns(self) -> dict[str, Columns]:
        """Return where each vehicle's signals stand; what one alone lacks is as in calm.

        Without noise the true position is what is read, without a limit what is commanded flown.
        """
        given = self.runner.sweep.given
        found = {name: vehicle_columns(self.wiring, given, name) for name in self.scenario.members}
        for port, other in (("v_c", "v_x"), (TRUE, "x")):
            if any(f"{port}[0]" in own.column for own in found.values()):
                for own in found.values():
                    for k in range(2):
                        own.column.setdefault(f"{port}[{k}]", own.column[f"{other}[{k}]"])
        return found

    def dataset(self, solution: Solution, signals: np.ndarray) -> "xarray.Dataset":
        """Return a solution with a dimension `vehicle`; V is the team's."""
        import xarray

        team, columns = self.scenario, self.columns()
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
        for name, found in speed_figures(whole, columns).items():
            if sentence := faster_flow(found, team.first.units):
                whole.attrs["message"] += f"; {name}: {sentence}"
        whole.encoding["folder"] = str(team.first._folder)
        return with_states(whole, state_labels(team_blocks(team)), solution)


def vehicle_columns(wiring: Wiring, given: Any, name: str) -> Columns:
    """Return where the signals of one vehicle stand, and the parameters of its blocks."""
    labels = [label for node in wiring.nodes for label in node.system.output_labels]
    return Columns(
        {split(label)[1]: k for k, label in enumerate(labels) if split(label)[0] == name},
        {
            split(node.name)[1]: p
            for node, p in zip(wiring.nodes, given, strict=True)
            if split(node.name)[0] == name
        },
    )


def speed_figures(run: "xarray.Dataset", columns: Mapping[str, Columns]) -> dict[str, Any]:
    """Return how the vehicles with a limit of speed fared, by name."""
    limits = {
        name: own.ran["speed_limit"].max_speed
        for name, own in columns.items()
        if "speed_limit" in own.ran
    }
    return {name: speeds_of(run.sel(vehicle=name), limit) for name, limit in limits.items()}
