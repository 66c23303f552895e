r"""The paper's block diagram: `control.interconnect` and nothing else.

    reference -> vehicle_controller -> vehicle -> clpe -> adaptation
              \> learning_controller -> learning_model /

`closed_loop` wires the whole system of sections II and III, `error_loop` the
error and parameter systems of Eqs. (27)-(28).
"""

from collections.abc import Collection, Iterable, Mapping
from typing import Any, NamedTuple

import numpy as np

from ..base.arguments import public
from ..base.errors import DiagramError
from ..engine.diagram.interconnection import (
    PARAMETER_HINTS,
    Diagram,
    connect,
    wiring_of_blocks,
)
from ..engine.diagram.wiring import (
    Node,
    Part,
    Wiring,
    input_ports,
    output_ports,
    read_anew,
    wiring_of,
)
from ..engine.model.block import Block
from ..engine.model.declaration import Parameters
from ..paper.blocks import (
    clpe,
    disturbance,
    field,
    flow,
    learner,
    localization,
    reference,
    vehicle,
)
from ..paper.blocks.localization import TRUE
from ..paper.laws.table import LAWS
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.file import OWN_LAW, OWN_PARTS
from ..paper.scenario.quantities import call_time_hint
from ..paper.scenario.tables import Units
from .dataset import LIMITED, MEASURED, SPEEDS, VARIABLES
from .user_parts import UNCHANGED, Changes, changes_of, functions_of, inserted, replaced

PARAMETER_HINTS.append(call_time_hint)


@public
def paper_blocks(scenario: Scenario) -> list[Part]:
    """Make the blocks of the paper's closed loop.

    Parameters
    ----------
    scenario : Scenario
        The experiment.

    Returns
    -------
    list of Block
        In the order of the table in the documentation; `measurement`, `fixes`, `disturbance`,
        `speed_limit` and `hedging` are among them where the scenario has them.

    Raises
    ------
    DataError
        If the scenario's field cannot be read.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> len(paper_blocks(clpt.paper_scenario()))
    12
    """
    return changed_blocks(scenario, UNCHANGED)


def changed_blocks(
    scenario: Scenario, changes: Changes, external: Collection[str] = ()
) -> list[Part]:
    """Return the blocks of a scenario with changes; they take `delta` where it is external."""
    N, alpha_M, law = scenario.basis.N, np.array(scenario.model_parameters), changes.law
    if law is not None and functions_of(law) != N:
        raise DiagramError(
            f"{law.name}: makes alpha of N = {functions_of(law)} functions; the scenario has {N}"
        )
    car, learning, delta = (
        scenario.vehicle,
        scenario.learning,
        scenario.flow.disturbance,
    )
    at_fixes = learning.row.at_fixes
    if at_fixes and law is not None:
        raise DiagramError(
            f"{law.name}: a law of your own reads the position at all times; set "
            "localization.interval to 0, or leave the law out"
        )
    if learning.sample is not None and law is not None:
        raise DiagramError(
            f"{law.name}: learning.sample is of the scenario's own law; sample yours by "
            "clpt.equations.Sampled(law, period), and leave the key out"
        )
    localized = _localized(scenario)
    true = TRUE if any(block.name == "measurement" for block in localized) else "x"
    steered = alpha_M, car.feedback, car.feedforward, car.max_speed is not None
    blocks = [
        reference.reference(scenario.waypoints, scenario.reference.dwell),
        scenario.basis_block("x"),
        scenario.basis_block("z"),
        *localized,
    ]
    if delta is not None:
        numbers = delta.amplitude, delta.period or 1.0, float(delta.seed or 0)
        blocks.append(disturbance.disturbance(delta.kind, *numbers))
    blocks.append(_true_flow(scenario, delta is not None or "delta" in external, true))
    if not at_fixes:  # else the law predicts by itself
        blocks.append(flow.modeled_flow(alpha_M))
    blocks.append(vehicle.vehicle_controller(*steered, "z" if at_fixes else "x"))
    if car.max_speed is not None:
        blocks.append(vehicle.speed_limit(car.max_speed))
    if scenario.hedged:
        blocks.append(vehicle.hedging())
    blocks.append(vehicle.vehicle(true))
    if not at_fixes:
        blocks.append(learner.learning_controller(N))
        blocks.append(learner.learning_model(hedged=scenario.hedged))
        if learning.row.given_estimate:
            blocks.append(
                learner.known_flow_injection(alpha_M, learning.theta_estimate)
            )
        elif learning.row.makes_estimate and (
            law is None or "theta_hat" in output_ports(law)
        ):
            blocks.append(learner.known_flow_injection(alpha_M))
        else:
            blocks.append(learner.learned_flow_injection(alpha_M))
    blocks += [clpe.clpe(), scenario.law_block]
    return inserted(replaced(blocks, changes.replace), changes.insert)


def units_of_ports(units: Units) -> dict[str, str]:
    """Return the unit of each port of the paper's blocks that has one."""
    rate = f"{units.time}-1"
    of_rows = {
        port: " ".join([units.length] * lengths + [rate] * rates)
        for rows in (VARIABLES, MEASURED, LIMITED)
        for port, _, lengths, rates in rows.values()
    }
    return of_rows | dict.fromkeys(SPEEDS, f"{units.length} {rate}")


def _localized(scenario: Scenario) -> list[Block]:
    """Return the blocks between the true position and the blocks that read it."""
    if (table := scenario.localization) is None:
        return []
    seed = float(table.seed or 0)
    if table.interval > 0:
        return [localization.fixes(table.noise, table.interval, table.dropouts, seed)]
    measured = localization.measurement(table.noise, table.noise_period or 1.0, seed)
    return [measured, scenario.basis_block(TRUE)]


def _true_flow(scenario: Scenario, disturbed: bool, position: str) -> Block:
    if scenario.field_path is None:
        assert scenario.flow.parameters is not None
        return flow.true_flow(scenario.flow.parameters, disturbed, position)
    from ..ocean.currents.plane import read_field

    gridded = read_field(scenario.field_path, scenario.units)
    return field.gridded_flow(
        gridded, scenario.flow.outside, disturbed, scenario.units, position
    )


class LoopOf(NamedTuple):
    """What `closed_loop` makes a loop of."""

    scenario: Scenario
    changes: Changes = UNCHANGED
    external: tuple[str, ...] = ()

    @property
    def beyond_scenario(self) -> dict[str, str]:
        """What the scenario does not hold, as the attributes of a run."""
        law, parts = self.changes.law, self.changes.description
        attributes = {OWN_LAW: law.name if law else "", OWN_PARTS: parts}
        return {name: text for name, text in attributes.items() if text}

    def is_unchanged(self, wiring: Wiring) -> bool:
        """Return whether a wiring has the wires and numbers with which the loop is made."""
        nodes = wiring_of_blocks(*remaining_parts(*self)).nodes
        return len(nodes) == len(wiring.nodes) and all(map(_alike, nodes, wiring.nodes))


def _alike(one: Node, other: Node) -> bool:
    numbers = [
        [
            number
            for own in params
            for number in (own if isinstance(own, Parameters) else [own])
        ]
        for params in (one.system.params.values(), other.system.params.values())
    ]
    wired = (one.name, one.wires) == (other.name, other.wires)
    return (
        wired
        and len(numbers[0]) == len(numbers[1])
        and all(map(np.array_equal, *numbers))
    )


def loop_of(system: Scenario | Diagram) -> LoopOf:
    """Return what a loop, which must have nothing from outside, is made of."""
    if isinstance(system, Scenario):
        return LoopOf(system)
    loop = getattr(system, "origin", None)
    if loop is None or loop.external:
        raise DiagramError(
            f"{system.name}: must be a scenario, or a closed_loop of one with nothing from outside"
        )
    read_anew(system)
    if not loop.is_unchanged(wiring_of(system)):
        raise DiagramError(
            f"{system.name}: was changed after closed_loop made it; give closed_loop what it is to "
            "have, with replace and insert"
        )
    return loop


@public
def closed_loop(
    scenario: Scenario,
    external: str | Iterable[str] = (),
    *,
    law: Block | Part | None = None,
    replace: Mapping[str, Any] | None = None,
    insert: Mapping[Any, Any] | None = None,
) -> Diagram:
    """Wire the paper's closed loop.

    Parameters
    ----------
    scenario : Scenario
        The experiment.
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

    Returns
    -------
    Diagram
        A `control.InterconnectedSystem`; states x, z, and those of the law, first
        alpha, K, Gamma, and those of inserted parts. It knows its scenario: `simulate`,
        `run_ensemble`, `initial_state` and `theory.prove` take it in the scenario's place.

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
    loop = LoopOf(scenario, changes_of(law, replace, insert), external)
    diagram = connect(*remaining_parts(*loop), name="closed_loop")
    diagram.origin = loop
    return diagram


def remaining_parts(
    scenario: Scenario, changes: Changes, external: tuple[str, ...]
) -> tuple[list[Part], tuple[str, ...]]:
    """Return the parts that remain where some ports come from outside, and these ports."""
    blocks = changed_blocks(scenario, changes, external)
    ports = {
        port
        for block in blocks
        for of in (input_ports, output_ports)
        for port in of(block)
    }
    for port in external:
        if port not in ports:
            raise DiagramError(
                f"external = '{port}': must be among the ports {', '.join(sorted(ports))}"
            )
    outside = {*external, *({TRUE} if "x" in external else ())}
    remaining = [block for block in blocks if not set(output_ports(block)) & outside]
    cut = [
        block
        for block in blocks
        if block not in remaining and block.name in changes.names
    ]
    while True:
        used = {port for block in (*remaining, *cut) for port in input_ports(block)}
        idle = [
            b for b in remaining if b.name != "clpe" and not set(output_ports(b)) & used
        ]
        if not idle or not external:
            break
        remaining = [block for block in remaining if block not in idle]
    return remaining, external


@public
def error_loop(scenario: Scenario) -> Diagram:
    """Wire the error and parameter systems, Eqs. (27)-(28).

    Parameters
    ----------
    scenario : Scenario
        Gives N, KD and the adaptation gain.

    Returns
    -------
    Diagram
        Inputs phi_x[N], z[2], zc[2]; states and outputs e[2], eta[2N], eta_3[2], eta_4[2].

    Examples
    --------
    >>> import clpt_control as clpt
    >>> error_loop(clpt.paper_scenario()).nstates
    12
    """
    N, KD = scenario.basis.N, np.array(scenario.vehicle.feedback)
    gains = scenario.learning.used_gains
    if scenario.learning.row is not LAWS["learned-flow"] or not gains.one:
        raise DiagramError(
            'error_loop: Eqs. (27)-(28) are of law = "learned-flow" with one gain for all; '
            f'the scenario has law = "{scenario.learning.law}"'
        )
    systems = clpe.error_system(N, KD), clpe.parameter_system(N, gains.parameters)
    return connect(systems, external=("phi_x", "z", "zc"), name="error_loop")
