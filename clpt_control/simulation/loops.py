r"""The paper's block diagram: `control.interconnect` and nothing else.

    reference -> vehicle_controller -> vehicle -> clpe -> adaptation
              \> learning_controller -> learning_model /

`closed_loop` wires the whole system of sections II and III, `error_loop` the
error and parameter systems of Eqs. (27)-(28).
"""

from collections.abc import Iterable
from typing import Any

import numpy as np

from ..blocks import (
    Block,
    clpe,
    disturbance,
    error_system,
    field,
    flow,
    learner,
    localization,
    reference,
    speed_limit,
    vehicle,
)
from ..blocks.laws.law import functions_of
from ..blocks.laws.table import LAWS
from ..blocks.localization import TRUE
from ..diagrams.interconnection import Diagram, connect
from ..diagrams.scenario_basis import scenario_basis
from ..errors import DiagramError
from ..scenario.experiment import Scenario, require_scenario


def paper_blocks(scenario: Scenario, law: Block | None = None) -> list[Block]:
    """Make the blocks of the paper's closed loop.

    Parameters
    ----------
    scenario : Scenario
        The experiment.
    law : Block, optional
        A law of your own in place of the scenario's, with outputs alpha[2N], K[2], Gamma[2].

    Returns
    -------
    list of Block
        In the order of the table in the documentation; `measurement`, `fixes`, `disturbance`,
        `speed_limit` and `hedging` are among them where the scenario has them.

    Raises
    ------
    DataError
        If the scenario's field cannot be read.
    DiagramError
        If the law does not make alpha[2N], K[2] and Gamma[2].

    Examples
    --------
    >>> import clpt_control as clpt
    >>> len(paper_blocks(clpt.paper_scenario()))
    12
    """
    require_scenario(scenario)
    N, alpha_M = scenario.basis.N, np.array(scenario.model_parameters)
    car = scenario.vehicle
    desired = vehicle.ControllerParameters(
        N, alpha_M, np.array(car.feedback), np.array(car.feedforward)
    )
    learning = scenario.learning
    if learning.row.given_estimate:
        theta_hat = np.array(learning.theta_estimate)
        inject: Any = learner.KnownFlowInjectionParameters(N, theta_hat, alpha_M)
    elif learning.row.makes_estimate and (law is None or "theta_hat" in law.output_ports):
        inject = learner.EstimatedFlowInjectionParameters(N, alpha_M)
    else:
        inject = learner.LearnedFlowInjectionParameters(N, alpha_M)
    limits = []
    if car.max_speed is not None:
        limits.append(speed_limit.speed_limit(speed_limit.SpeedLimitParameters(car.max_speed)))
    if scenario.hedged:
        limits.append(speed_limit.hedging())
    delta, disturbances = scenario.flow.disturbance, []
    if delta is not None:
        own = (delta.kind, delta.amplitude, delta.period or 1.0, float(delta.seed or 0))
        disturbances.append(disturbance.disturbance(*own))
    at_fixes = learning.row.at_fixes
    if at_fixes and law is not None:
        raise DiagramError(
            f"{law.name}: a law of your own reads the position at all times; set "
            "localization.interval to 0, or leave the law out"
        )
    localized = _localized(scenario)
    true = TRUE if any(block.name == "measurement" for block in localized) else "x"
    modeled = [flow.modeled_flow(flow.ModeledFlowParameters(N, alpha_M))]
    predicting = [
        learner.learning_controller(N),
        learner.learning_model(hedged=scenario.hedged),
        learner.injection(inject),
    ]
    if at_fixes:  # the law predicts by itself
        modeled, predicting = [], []
    return [
        reference.reference(scenario.waypoints, scenario.reference.dwell),
        scenario_basis(scenario, "x"),
        scenario_basis(scenario, "z"),
        *localized,
        *disturbances,
        _true_flow(scenario, delta is not None, true),
        *modeled,
        vehicle.vehicle_controller(desired, car.max_speed is not None, "z" if at_fixes else "x"),
        *limits,
        vehicle.vehicle(true),
        *predicting,
        clpe.clpe(),
        learning.row.block(scenario.known_to_law) if law is None else _own(law, N),
    ]


def _own(law: Block, N: int) -> Block:
    """Return a law of the user's, if it is one for N functions."""
    if functions_of(law) != N:
        raise DiagramError(
            f"{law.name}: makes alpha of N = {functions_of(law)} functions; the scenario has {N}"
        )
    return law


def _localized(scenario: Scenario) -> list[Block]:
    """Return the blocks between the true position and who reads it."""
    seen = scenario.localization
    if seen is None:
        return []
    seed = float(seen.seed or 0)
    if seen.interval > 0:
        own = localization.FixParameters(seen.noise, seen.interval, seen.dropouts, seed)
        return [localization.fixes(own)]
    held = localization.MeasurementParameters(seen.noise, seen.noise_period or 1.0, seed)
    return [localization.measurement(held), scenario_basis(scenario, TRUE)]


def _true_flow(scenario: Scenario, disturbed: bool, position: str) -> Block:
    if scenario.field_path is None:
        theta = np.array(scenario.flow.parameters)
        return flow.true_flow(flow.TrueFlowParameters(scenario.basis.N, theta), disturbed, position)
    from ..currents.field_file import read_field

    gridded = read_field(scenario.field_path, scenario.units)
    return field.gridded_flow(gridded, scenario.flow.outside, disturbed, scenario.units, position)


def closed_loop(
    scenario: Scenario, external: Iterable[str] = (), law: Block | None = None
) -> Diagram:
    """Wire the paper's closed loop.

    Parameters
    ----------
    scenario : Scenario
        The experiment.
    external : iterable of str, optional
        Ports taken from outside in place of the blocks that make them, such
        as ``("zc",)`` for step responses, or ``("x",)`` for the learner alone,
        fed by a measured track. Blocks that then feed nothing are left out.
    law : Block, optional
        A law of your own in place of the scenario's, with outputs alpha[2N], K[2], Gamma[2].

    Returns
    -------
    Diagram
        A `control.InterconnectedSystem`; states x, z, and those of the law, first
        alpha, K, Gamma.

    Raises
    ------
    DiagramError
        If an external port is unknown, or the law does not fit.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> loop = closed_loop(clpt.paper_scenario(), external=("zc",))
    >>> loop.input_labels
    ['zc[0]', 'zc[1]']
    """
    external = [external] if isinstance(external, str) else list(external)
    return connect(kept_blocks(paper_blocks(scenario, law), external), external, name="closed_loop")


def kept_blocks(blocks: list[Block], external: list[str]) -> list[Block]:
    """Return the blocks that are left where some ports come from outside."""
    ports = {port for block in blocks for port in block.output_ports}
    for port in external:
        if port not in ports:
            raise DiagramError(
                f"external = '{port}': must be among the ports {', '.join(sorted(ports))}"
            )
    outside = {*external, *({TRUE} if "x" in external else ())}
    kept = [block for block in blocks if not set(block.output_ports) & outside]
    while True:
        used = {port for block in kept for port in block.input_ports}
        idle = [b for b in kept if b.name != "clpe" and not set(b.output_ports) & used]
        if not idle or len(kept) == len(blocks):
            break
        kept = [block for block in kept if block not in idle]
    return kept


def error_loop(scenario: Scenario) -> Diagram:
    """Wire the error and parameter systems, Eqs. (27)-(28).

    Parameters
    ----------
    scenario : Scenario
        Gives N, KD and the adaptation gain.

    Returns
    -------
    Diagram
        Inputs phi_x[N], z[2], zc[2]; states and outputs e[2], eta[2N+4].

    Examples
    --------
    >>> import clpt_control as clpt
    >>> error_loop(clpt.paper_scenario()).nstates
    12
    """
    require_scenario(scenario)
    N, KD = scenario.basis.N, np.array(scenario.vehicle.feedback)
    gains = scenario.learning.used_gains
    if scenario.learning.row is not LAWS["learned-flow"] or not gains.one:
        raise DiagramError(
            'error_loop: Eqs. (27)-(28) are of law = "learned-flow" with one gain for all; '
            f'the scenario has law = "{scenario.learning.law}"'
        )
    return connect(
        [
            error_system.error_system(error_system.ErrorSystemParameters(N, KD)),
            error_system.parameter_system(
                error_system.ParameterSystemParameters(N, gains.parameters)
            ),
        ],
        external=("phi_x", "z", "zc"),
        name="error_loop",
    )
