r"""The paper's block diagrams, wired with `control.interconnect`.

    reference -> vehicle_controller -> vehicle -> clpe -> adaptation
              \> learning_controller -> learning_model /

`closed_loop` is the system of sections II and III, or the closed loops of several vehicles, and
`error_loop` the error and parameter systems of Eqs. (27)-(28).
"""

from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple

import numpy as np

from ..base.arguments import public
from ..base.errors import DiagramError
from ..base.run_attributes import OWN_LAW, OWN_PARTS
from ..engine.diagram.block_numbers import PARAMETER_HINTS
from ..engine.diagram.interconnection import Diagram, connect, wiring_of_blocks
from ..engine.diagram.wiring import Node, Part, Wiring, read_anew, wiring_of
from ..engine.model.block import Block
from ..engine.model.declaration import Parameters
from ..engine.model.ports import within
from ..paper.blocks import clpe
from ..paper.laws.consensus import consensus_block, pulled_law
from ..paper.laws.table import LAWS
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.quantities import call_time_hint
from ..paper.scenario.team import TEAM_LAW, Team
from .loop_blocks import changed_blocks, remaining_blocks
from .user_components import UNCHANGED, Changes, changes_of

PARAMETER_HINTS.append(call_time_hint)


class ClosedLoop(NamedTuple):
    """Arguments of `closed_loop`: a scenario, the user's changes and the external ports."""

    scenario: Scenario
    changes: Changes = UNCHANGED
    external: tuple[str, ...] = ()

    @property
    def beyond_scenario(self) -> dict[str, str]:
        """Attributes of a run for changes that are not in its scenario."""
        law = self.changes.law
        attributes = {
            OWN_LAW: law.name if law else "",
            OWN_PARTS: self.changes.description,
        }
        return {name: text for name, text in attributes.items() if text}

    def blocks(self) -> list[Part]:
        """Return the blocks of the loop."""
        return remaining_blocks(*self)

    def is_unchanged(self, wiring: Wiring) -> bool:
        """Return whether a wiring has the wires and numbers of a new loop."""
        nodes = wiring_of_blocks(self.blocks(), self.external).nodes
        if len(nodes) != len(wiring.nodes):
            return False
        return all(map(_same_node, nodes, wiring.nodes))


def _same_node(node: Node, node_now: Node) -> bool:
    if (node.name, node.wires) != (node_now.name, node_now.wires):
        return False
    numbers = _parameters_of(node)
    numbers_now = _parameters_of(node_now)
    same_length = len(numbers) == len(numbers_now)
    return same_length and all(map(np.array_equal, numbers, numbers_now))


def _parameters_of(node: Node) -> list[Any]:
    numbers: list[Any] = []
    for value in node.system.params.values():
        numbers += value if isinstance(value, Parameters) else [value]
    return numbers


def loop_of(system: Scenario | Diagram) -> ClosedLoop:
    """Return the arguments of a closed loop; a loop with external ports is an error."""
    if isinstance(system, Scenario):
        return ClosedLoop(system)
    loop = getattr(system, "origin", None)
    if loop is None or loop.external:
        raise DiagramError(
            f"{system.name}: must be a scenario, or a closed_loop of one with nothing from outside"
        )
    read_anew(system)
    if not loop.is_unchanged(wiring_of(system)):
        raise DiagramError(
            f"{system.name}: was changed after closed_loop made it. Give closed_loop what it is to "
            "have, with replace and insert"
        )
    return loop


@public
def closed_loop(
    scenario: Scenario | Team,
    external: str | Iterable[str] = (),
    *,
    law: Block | Part | None = None,
    replace: Mapping[str, Any] | None = None,
    insert: Mapping[Any, Any] | None = None,
    errors: bool = False,
) -> Diagram:
    """Wire the paper's closed loop, a team's, or the error systems.

    Parameters
    ----------
    scenario : Scenario or Team
        The experiment. A team's loop has each vehicle's blocks by name, and the consensus of
        their laws; no other argument goes with it.
    external : str or iterable of str, optional
        Ports taken from outside in place of the blocks that make them, such
        as ``"zc"`` for step responses, ``"delta"`` for a disturbance of the flow, or ``"x"`` for
        the learner alone, fed by a measured track. Blocks that then feed nothing are left out,
        but for those that fed a part of your own: there the loop is cut open.
    law : Block, optional
        A law of your own in place of the scenario's, with outputs alpha[2N], K[2], Gamma[2];
        the same as ``replace={"adaptation": law}``.
    replace : mapping, optional
        ``{"vehicle": mine}``: a part of your own in place of the one of that name; a part is
        whatever `connect` takes. It makes the ports that others take of the old one.
    insert : mapping, optional
        ``{("v_x", "vehicle"): lag}``: a part between a signal and a block that takes it; more
        names are more blocks, ``{"v_x": lag}`` all of them. A part of one input and one output
        stands on each signal of a wide port if it is linear. What it makes is called ``v_x_lag``,
        unless its one output has a name of its own.
    errors : bool, optional
        Wire the error and parameter systems, Eqs. (27)-(28), with inputs phi_x, z and zc, in
        place of the loop; no other argument goes with it.

    Returns
    -------
    Diagram
        A `control.InterconnectedSystem`; states x, z, and those of the law, first
        alpha, K, Gamma, and those of inserted parts. It knows its scenario: `simulate`,
        `run_ensemble`, `initial_state` and `prove` accept the loop instead of the scenario.

    Raises
    ------
    DiagramError
        If an external port is unknown, or a part does not fit.

    Examples
    --------
    >>> import control
    >>> import clpt_control as clpt
    >>> loop = closed_loop(clpt.paper_scenario(), external="zc")
    >>> loop.input_labels
    ['zc[0]', 'zc[1]']
    >>> lag = control.tf(1, [0.5, 1], name="lag")
    >>> lagging = closed_loop(clpt.paper_scenario(), insert={("v_x", "vehicle"): lag})
    >>> lagging.state_labels[-2:]
    ['lag_x[0]', 'lag_x[1]']
    """
    external = (external,) if isinstance(external, str) else tuple(external)
    if isinstance(scenario, Team) or errors:
        changes = {
            "external": external,
            "law": law,
            "replace": replace,
            "insert": insert,
        }
        wrong = [name for name, value in changes.items() if value]
        if wrong or (errors and isinstance(scenario, Team)):
            raise DiagramError(
                f"closed_loop: {wrong[0] if wrong else 'errors'} does not go with "
                f"{'errors=True' if errors and wrong else 'a team'}. Leave it out"
            )
        if isinstance(scenario, Team):
            return connect(team_blocks(scenario), name="team")
        return error_loop(scenario)
    loop = ClosedLoop(scenario, changes_of(law, replace, insert), external)
    diagram = connect(loop.blocks(), external, name="closed_loop")
    diagram.origin = loop
    return diagram


def error_loop(scenario: Scenario) -> Diagram:
    """Wire the error and parameter systems, Eqs. (27)-(28), with inputs phi_x, z and zc."""
    N = scenario.basis.N
    gains = scenario.learning.used_gains
    if scenario.learning.row is not LAWS["learned-flow"] or not gains.shared:
        raise DiagramError(
            'closed_loop: Eqs. (27)-(28) are of law = "learned-flow" with one gain for all; '
            f'the scenario has law = "{scenario.learning.law}"'
        )
    systems = (
        clpe.error_system(N, scenario.vehicle.feedback),
        clpe.parameter_system(N, gains.parameters),
    )
    return connect(systems, external=("phi_x", "z", "zc"), name="error_loop")


def team_blocks(team: Team) -> list[Block]:
    """Return the blocks of all vehicles in the namespaces of their names, as `west/alpha`.

    The last block of each vehicle is its consensus.
    """
    blocks = []
    for name, scenario in team.members.items():
        law = pulled_law(LAWS[TEAM_LAW].block(scenario.known_to_law))
        vehicle_blocks = changed_blocks(scenario, changes_of(law))
        blocks += [within(block, name) for block in vehicle_blocks]
        neighbours = team.neighbours(name)
        blocks.append(
            consensus_block(name, neighbours, scenario.basis.N, team.coupling)
        )
    return blocks
