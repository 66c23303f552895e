"""A team's loop: the paper's blocks for each vehicle, in a namespace of its name, `west/alpha`."""

from ..base.arguments import public
from ..engine.diagram.interconnection import Diagram, connect
from ..engine.model.block import Block
from ..engine.model.ports import within
from ..paper.laws.consensus import consensus_block, pulled_law
from ..paper.laws.table import LAWS
from ..paper.scenario.team import TEAM_LAW, Team
from .loops import changed_blocks
from .user_parts import changes_of


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
        law = pulled_law(LAWS[TEAM_LAW].block(scenario.known_to_law))
        blocks += [
            within(one, name) for one in changed_blocks(scenario, changes_of(law))
        ]
        neighbours = team.neighbours(name)
        blocks.append(
            consensus_block(name, neighbours, scenario.basis.N, team.coupling)
        )
    return blocks
