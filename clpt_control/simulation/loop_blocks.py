"""Blocks of the paper's closed loop, as a scenario and the user's changes define them.

`paper_blocks` returns the blocks of sections II and III.  `changed_blocks` applies the user's
changes, and `remaining_blocks` leaves out blocks whose signals come from outside the loop.
"""

from collections.abc import Collection

import numpy as np

from ..base.arguments import check_known, public
from ..base.errors import DiagramError
from ..engine.diagram.wiring import Part, input_ports, output_ports
from ..engine.model.block import Block
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
from ..paper.scenario.experiment import Scenario
from .user_components import UNCHANGED, Changes, functions_of, inserted, replaced


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
    """Return the blocks of a scenario with changes; an external `delta` is an input."""
    if changes.law is not None:
        _check_law(scenario, changes.law)
    alpha_M = np.array(scenario.model_parameters)
    car = scenario.vehicle
    delta = scenario.flow.disturbance
    at_fixes = scenario.learning.row.at_fixes  # such a law has its own prediction

    # the vehicle in the flow
    localized = _localization(scenario)
    is_noisy = any(block.name == "measurement" for block in localized)
    true_position = TRUE if is_noisy else "x"
    blocks = [
        reference.reference(scenario.waypoints, scenario.reference.dwell),
        scenario.basis_block("x"),
        scenario.basis_block("z"),
        *localized,
    ]
    if delta is not None:
        period = delta.period or 1.0
        seed = float(delta.seed or 0)
        blocks.append(
            disturbance.disturbance(delta.kind, delta.amplitude, period, seed)
        )
    disturbed = delta is not None or "delta" in external
    blocks.append(true_flow_block(scenario, disturbed, true_position))
    if not at_fixes:
        blocks.append(flow.modeled_flow(alpha_M))
    controller = vehicle.vehicle_controller(
        alpha_M,
        car.feedback,
        car.feedforward,
        car.max_speed is not None,
        "z" if at_fixes else "x",
    )
    blocks.append(controller)
    if car.max_speed is not None:
        blocks.append(vehicle.speed_limit(car.max_speed))
    if scenario.hedged:
        blocks.append(vehicle.hedging())
    blocks.append(vehicle.vehicle(true_position))

    # the learner
    if not at_fixes:
        blocks.append(learner.learning_controller(scenario.basis.N))
        blocks.append(learner.learning_model(hedged=scenario.hedged))
        blocks.append(_injection(scenario, changes.law, alpha_M))
    blocks += [clpe.clpe(), scenario.law_block]
    return inserted(replaced(blocks, changes.replace), changes.insert)


def _check_law(scenario: Scenario, law: Part) -> None:
    """Raise `DiagramError` if the user's law does not fit the scenario."""
    N = functions_of(law)
    if N != scenario.basis.N:
        raise DiagramError(
            f"{law.name}: makes alpha of N = {N} functions; the scenario has {scenario.basis.N}"
        )
    if scenario.learning.row.at_fixes:
        raise DiagramError(
            f"{law.name}: a law of your own reads the position at all times. Set "
            "localization.interval to 0, or leave the law out"
        )
    if scenario.learning.sample is not None:
        raise DiagramError(
            f"{law.name}: learning.sample is of the scenario's own law; sample yours by "
            "clpt.Sampled(law, period), and leave the key out"
        )


def _localization(scenario: Scenario) -> list[Block]:
    """Return the blocks between the true position and the blocks that read a position."""
    table = scenario.localization
    if table is None:
        return []
    seed = float(table.seed or 0)
    if table.interval > 0:
        return [localization.fixes(table.noise, table.interval, table.dropouts, seed)]
    period = table.noise_period or 1.0
    measured = localization.measurement(table.noise, period, seed)
    return [measured, scenario.basis_block(TRUE)]


def true_flow_block(
    scenario: Scenario, disturbed: bool = False, position: str = "x"
) -> Block:
    """Return the block of a scenario's true flow, of functions or of a gridded current."""
    if scenario.flow.parameters is not None:
        return flow.true_flow(scenario.flow.parameters, disturbed, position)
    if (basis := scenario.flow.basis) is not None:
        functions = {
            "centers": basis.centers,
            "widths": basis.widths,
            "frequencies": 2 * np.pi / basis.periods_in(scenario.units.time),
            "phases": basis.phases or (0.0,) * basis.N,
        }
        return flow.own_true_flow(
            basis.parameters, basis.kernel, functions, disturbed, position
        )
    from ..paper.currents.plane import read_field

    assert scenario.field_path is not None
    gridded = read_field(scenario.field_path, scenario.units, scenario.origin)
    outside = scenario.flow.outside
    return field.gridded_flow(gridded, outside, disturbed, scenario.units, position)


def _injection(scenario: Scenario, law: Part | None, alpha_M: np.ndarray) -> Block:
    """Return the injection of a law: Eq. (13) with an estimate of theta, or Eq. (20)."""
    row = scenario.learning.row
    if row.given_estimate:
        theta_estimate = scenario.learning.theta_estimate
        return learner.known_flow_injection(alpha_M, theta_estimate)
    law_has_estimate = law is None or "theta_hat" in output_ports(law)
    if row.makes_estimate and law_has_estimate:
        return learner.known_flow_injection(alpha_M)
    return learner.learned_flow_injection(alpha_M)


def remaining_blocks(
    scenario: Scenario, changes: Changes, external: tuple[str, ...] = ()
) -> list[Part]:
    """Return the blocks that remain if some ports come from outside.

    Blocks that make these ports are left out, then blocks that feed nothing.  A block that feeds a
    left-out component of the user remains, so that the loop is open at that component.
    """
    blocks = changed_blocks(scenario, changes, external)
    if not external:
        return blocks
    ports = {
        port for block in blocks for port in input_ports(block) | output_ports(block)
    }
    check_known("external", external, sorted(ports))
    outside = {*external, *({TRUE} if "x" in external else ())}
    remaining = [block for block in blocks if outside.isdisjoint(output_ports(block))]
    opened = [
        block
        for block in blocks
        if block not in remaining and block.name in changes.names
    ]
    while True:
        used = {port for block in remaining + opened for port in input_ports(block)}
        feeding = [
            block
            for block in remaining
            if block.name == "clpe" or not used.isdisjoint(output_ports(block))
        ]
        if len(feeding) == len(remaining):
            return remaining
        remaining = feeding
