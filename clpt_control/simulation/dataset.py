"""Dataset of a run: an `xarray.Dataset` with units, which for a scenario has CF attributes.

The dimensions of a scenario's run are time, axis and basis.  The attributes have the scenario, the
versions and the solver's statistics, so that a run can be repeated from its file.
"""

import json
from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from ..base.run_attributes import CHANGED, OWN_LAW, versions
from ..base.units import DEGREES
from ..engine.diagram.wiring import Params
from ..engine.model.block import Block
from ..engine.model.ports import labels as labels_of_ports
from ..engine.model.ports import ports_of
from ..paper.blocks.localization import TRUE
from ..paper.blocks.ports import POWERS
from ..paper.laws.law import Truth
from ..paper.laws.regressions import error_by_P
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.file import own_parts, scenario_to_text
from ..paper.scenario.recorded_run import DIMS
from ..paper.scenario.tables import Units
from .dataset_template import Axes, DatasetTemplate, Series, Signals, port_variables
from .user_components import LAW

VARIABLES = {  # name -> (port, long name)
    "position": ("x", "true position"),
    "predicted_position": ("z", "predicted position"),
    "clpe": ("e", "controlled Lagrangian prediction error"),
    "reference": ("zc", "desired position"),
    "feedback_gain": ("K", "adapted feedback gain"),
    "feedforward_gain": ("Gamma", "adapted feedforward gain"),
    "alpha": ("alpha", "adapted parameter alpha"),
    "true_flow": ("flow_x", "true flow at the vehicle"),
}
LIMITED = {  # of a vehicle with a speed limit
    "velocity": ("v_x", "velocity through the water, as flown"),
    "commanded_velocity": ("v_c", "velocity through the water, as commanded"),
}
MEASURED_CLPE = "controlled Lagrangian prediction error, of the measured position"
MEASURED = {  # of a vehicle that reads its position with noise
    "position": (TRUE, "true position"),
    "measured_position": ("x", "measured position, which the vehicle reads"),
    "clpe": ("e", MEASURED_CLPE),
}
REFERENCES = (
    "Cho, Zhang, Edwards (2016), Adaptive learning for controlled "
    "Lagrangian particle tracking, OCEANS 2016 MTS/IEEE Monterey"
)


def unit_of(units: Units, lengths: int, rates: int) -> str:
    """Return the unit of a variable from its powers of length and 1/time."""
    return " ".join([units.length] * lengths + [f"{units.time}-1"] * rates)


def scenario_template(
    scenario: Scenario,
    signals: Signals,
    attributes: Mapping[str, str] = {},
    ports: Mapping[str, str] = {},
    states: Sequence[str] | None = None,
) -> DatasetTemplate:
    """Return the template of a scenario's runs; samples at jumps are right limits.

    `attributes` describe call-time parameters and the user's components.  Each of `ports`, with its
    unit or "", that has no variable yet becomes a variable.  `states` are the labels of states.
    """
    units = scenario.units
    N = scenario.basis.N
    replaced = own_parts(attributes)
    if OWN_LAW in attributes:
        replaced |= {LAW}

    table = _table(signals)
    variables: dict[str, Series] = {}
    sizes = {"axis": 2, "basis": N}
    for name, (port, long_name) in table.items():
        of = signals.of(port, *(sizes[dim] for dim in DIMS[name][1:]))
        unit = unit_of(units, *POWERS[port])
        variables |= variable_of_run(name, of, long_name, unit)
    if scenario.origin is not None and "position" in table:
        variables |= _coordinates(scenario, signals.of(table["position"][0], 2))
    variables |= _estimates(scenario, signals, LAW in replaced)
    truths, note = _truths(scenario, signals, replaced)
    variables |= truths

    # ports without a variable
    in_table = {port for port, _ in table.values()}
    extra_ports = {
        port: port_columns
        for port, port_columns in ports_of(signals.column).items()
        if port in ports and port not in in_table
    }
    port_units = {
        port: unit or unit_of(units, *POWERS.get(port, (0, 0)))
        for port, unit in ports.items()
    }
    dim_names = {N: "basis", 2: "axis"}
    extra_variables, axes = port_variables(
        extra_ports, dim_names, variables, port_units
    )
    return DatasetTemplate(
        variables | extra_variables,
        axes | plane_axes(N),
        {**_attributes(scenario), **attributes},
        {"long_name": "time since the start of the run", "units": units.time},
        states,
        str(scenario._folder),
        note,
    )


def plane_axes(N: int) -> Axes:
    """Return values and attributes of the dimensions of the plane and of N functions."""
    return {
        "axis": (np.array([1, 2]), {"long_name": "axis of the plane, x1 and x2"}),
        "basis": (np.arange(1, N + 1), {"long_name": "flow basis function"}),
    }


def _table(signals: Signals) -> dict[str, tuple[str, str]]:
    """Return the rows of `VARIABLES` that apply to a vehicle."""
    table = dict(VARIABLES)
    if f"{TRUE}[0]" in signals.column:
        table |= MEASURED
    if "v_c[0]" in signals.column:
        table |= LIMITED
    return {
        name: row for name, row in table.items() if f"{row[0]}[0]" in signals.column
    }


def series(dims: tuple[str, ...], of: Any, long_name: str, unit: str) -> Series:
    """Return a variable of a Dataset with its long name and its unit."""
    return Series(dims, of, {"long_name": long_name, "units": unit})


def variable_of_run(name: str, of: Any, long_name: str, unit: str) -> dict[str, Series]:
    """Return a variable of `DIMS` by its name."""
    return {name: series(DIMS[name], of, long_name, unit)}


def _coordinates(scenario: Scenario, position: Any) -> dict[str, Series]:
    """Return latitude and longitude of the vehicle on the local plane of the scenario."""
    plane = scenario.plane

    def coordinate(k: int, signals: np.ndarray) -> np.ndarray:
        return np.asarray(plane.to_earth(*position(signals).T)[k])

    coordinates = {}
    for k, (name, unit) in enumerate(DEGREES.items()):
        of = partial(coordinate, k)
        long_name = f"{name} of the vehicle"
        coordinates[name] = series(("time",), of, long_name, unit)
        coordinates[name].attributes["standard_name"] = name
    return coordinates


def _estimates(
    scenario: Scenario, signals: Signals, law_replaced: bool
) -> dict[str, Series]:
    """Return the variables of the law's estimate of theta."""
    row = scenario.learning.row
    speed = unit_of(scenario.units, 1, 1)
    variables = variable_of_run(
        "flow_parameters_estimate",
        _estimate(scenario, signals),
        "estimate of the flow parameters theta",
        speed,
    )
    if not row.readout or law_replaced:
        return variables
    readout = variable_of_run(
        "flow_parameters_readout",
        signals.of(row.readout, 2, scenario.basis.N),
        "readout of the flow parameters theta; "
        f"theta_hat until {row.error_left} is small enough",
        speed,
    )
    if keys := _keys_of_other_flow(scenario):
        comment = f"not theta exactly: {keys} is taken for flow of the basis"
        readout["flow_parameters_readout"].attributes["comment"] = comment
    error_left = variable_of_run(
        "error_left",
        signals.of(row.error_left),
        "share of the first error of theta_hat that is left",
        "1",
    )
    return variables | readout | error_left


def _estimate(scenario: Scenario, signals: Signals) -> Any:
    """Return the law's estimate of theta, as a function of the signals."""
    N = scenario.basis.N
    if scenario.learning.row.given_estimate:
        block = signals.parameters.get("injection")
        theta = getattr(block, "theta_hat", scenario.learning.theta_estimate)
        theta = np.array(theta, dtype=float)
        return lambda signals: np.broadcast_to(theta, (len(signals), 2, N)).copy()
    if "theta_hat[0]" in signals.column:
        return signals.of("theta_hat", 2, N)
    alpha = signals.of("alpha", 2, N)
    return lambda signals: 0.0 - alpha(signals)  # without -0


def _keys_of_other_flow(scenario: Scenario) -> str:
    """Return the keys of flow that the basis functions do not span, or ""."""
    flow = scenario.flow
    fixes = scenario.localization
    present = {
        "flow.field": flow.field is not None,
        "flow.basis": flow.basis is not None,
        "flow.disturbance": flow.disturbance is not None,
        "localization.noise": fixes is not None and fixes.noise > 0,
    }
    return " and ".join(key for key, is_present in present.items() if is_present)


def _truths(
    scenario: Scenario, signals: Signals, replaced: set[str]
) -> tuple[dict[str, Series], str]:
    """Return the variables theta and V as far as they exist, and the law's note on V."""
    parameters = signals.parameters
    blocks = set(parameters) - replaced
    if scenario.flow.parameters is None or "true_flow" not in blocks:
        return {}, ""
    units = scenario.units
    theta = parameters["true_flow"].theta
    variables = variable_of_run(
        "flow_parameters",
        lambda signals: theta.copy(),
        "true flow parameters theta",
        unit_of(units, 1, 1),
    )
    if not {"vehicle_controller", LAW} <= blocks:
        return variables, ""
    controller = parameters["vehicle_controller"]
    truth = Truth(theta, controller.KD, controller.GammaD)
    row = scenario.learning.row
    p = parameters[LAW]
    V = _lyapunov(row.V(p, truth, along_run=True), signals.column)
    unit = f"{units.length}2"
    variables |= variable_of_run("lyapunov", V, "Lyapunov candidate V", unit)
    return variables, row.doubt(p, truth)


def _attributes(scenario: Scenario) -> dict[str, Any]:
    time_attributes = {}
    if scenario.field_path is not None:
        from ..paper.currents.plane import time_origin

        time_attributes = time_origin(scenario.field_path)
    return {
        "Conventions": "CF-1.11",
        "title": scenario.title,
        "source": versions("clpt-control"),
        "references": REFERENCES,
        "scenario": scenario_to_text(scenario),
        **time_attributes,
    }


def changed_parameters(
    params: Params, attributes: Mapping[str, str] = {}
) -> dict[str, str]:
    """Return attributes with call-time parameters added to those that they have."""
    values = json.loads(attributes.get(CHANGED, "{}"))
    for name, value in (params or {}).items():
        values[name] = np.asarray(value).tolist()
    return {**attributes, CHANGED: json.dumps(values)} if values else {**attributes}


def _lyapunov(block: Block, column: Mapping[str, int]) -> Any:
    """Return V along the run, as a function of the signals."""
    input_labels = labels_of_ports(block.input_ports)
    input_columns = np.array([column.get(label, 0) for label in input_labels])

    def V(signals: np.ndarray) -> np.ndarray:
        inputs = signals[:, input_columns]
        if f"{TRUE}[0]" in column:  # the signal e is that of the measured position
            for k in range(2):
                x, z = (signals[:, column[f"{port}[{k}]"]] for port in (TRUE, "z"))
                inputs[:, input_labels.index(f"e[{k}]")] = x - z
        if "weighted" in block.input_ports:
            N = block.input_ports["weighted"] // 2
            alpha = signals[:, column["alpha[0]"] :][:, : 2 * N].reshape(-1, 2, N)
            P = signals[:, column["P[0]"] :][:, : N * N].reshape(-1, N, N)
            weighted = error_by_P(block.parameters, alpha, P)
            inputs[:, -2 * N :] = weighted.reshape(-1, 2 * N)
        return block.on_arrays("output", 0.0, np.zeros((0, len(inputs))), inputs.T)[0]

    return V
