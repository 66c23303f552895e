"""A run as an `xarray.Dataset`; a scenario's has CF attributes.

Its dimensions are time, axis, basis.  Every variable has units; the attributes hold the scenario,
the versions and the solver's statistics, so that a run repeats from its file.
"""

import json
from collections.abc import Mapping, Sequence
from functools import lru_cache
from importlib.metadata import version
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from ..engine.diagram.wiring import Params
from ..engine.model.block import Block
from ..engine.model.ports import ports_of
from ..engine.trace.traced_block import on_arrays
from ..paper.blocks.localization import TRUE
from ..paper.laws.law import Truth
from ..paper.laws.regressions import error_by_P
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.file import CHANGED, OWN_LAW, own_parts, scenario_to_text
from .frame import Frame, Labels, Series, columns, port_variables
from .user_parts import LAW

VARIABLES = {  # name -> (port, long name, unit of length or none, powers of 1/time)
    "position": ("x", "true position", 1, 0),
    "predicted_position": ("z", "predicted position", 1, 0),
    "clpe": ("e", "controlled Lagrangian prediction error", 1, 0),
    "reference": ("zc", "desired position", 1, 0),
    "feedback_gain": ("K", "adapted feedback gain", 0, 1),
    "feedforward_gain": ("Gamma", "adapted feedforward gain", 0, 1),
    "alpha": ("alpha", "adapted parameter alpha", 1, 1),
    "true_flow": ("flow_x", "true flow at the vehicle", 1, 1),
}
# ports without a word above
SPEEDS = ("flow_z", "v_x", "v_c", "v_z", "psi", "delta", "unflown")
LIMITED = {  # where the vehicle's speed has a limit
    "velocity": ("v_x", "velocity through the water, as flown", 1, 1),
    "commanded_velocity": ("v_c", "velocity through the water, as commanded", 1, 1),
}
MEASURED = {  # where the vehicle reads its position with noise
    "position": (TRUE, "true position", 1, 0),
    "measured_position": ("x", "measured position, which the vehicle reads", 1, 0),
    "clpe": (
        "e",
        "controlled Lagrangian prediction error, of the measured position",
        1,
        0,
    ),
}


class Signals(NamedTuple):
    """A vehicle's signals: their columns by label, and the parameters of the blocks by name."""

    column: dict[str, int]
    parameters: dict[str, Any]


def run_frame(
    scenario: Scenario,
    signals: Signals,
    beyond: Mapping[str, str] = MappingProxyType({}),
    more: Mapping[str, str] = MappingProxyType({}),
    states: Sequence[str] | None = None,
) -> Frame:
    """Return the Dataset of a scenario's runs, to be filled with signals, right limits at jumps.

    `beyond` has attributes for what no key holds: call-time parameters and the user's own parts;
    `more` ports, each with its unit or "", become variables of their own names; `states` are the
    labels of states.
    """
    units, N = scenario.units, scenario.basis.N
    column, parameters = signals
    variables: dict[str, Series] = {}
    wanted = {**VARIABLES, **(MEASURED if f"{TRUE}[0]" in column else {})}
    wanted |= LIMITED if "v_c[0]" in column else {}
    row, own = (
        scenario.learning.row,
        own_parts(beyond) | ({LAW} if OWN_LAW in beyond else set()),
    )
    by_functions = ("time", "axis", "basis")

    def of(port: str, *shape: int) -> Any:
        return columns(
            [column[f"{port}[{k}]"] for k in range(int(np.prod(shape)))], *shape
        )

    def add(
        name: str, dims: tuple[str, ...], series: Any, long_name: str, unit: str
    ) -> None:
        variables[name] = Series(dims, series, {"long_name": long_name, "units": unit})

    for name, (port, long_name, lengths, rates) in wanted.items():
        if f"{port}[0]" not in column:
            continue
        unit = " ".join([units.length] * lengths + [f"{units.time}-1"] * rates)
        dims, shape = (
            (by_functions, (2, N)) if port == "alpha" else (("time", "axis"), (2,))
        )
        add(name, dims, of(port, *shape), long_name, unit)
    estimate, speed = _estimate(scenario, signals, of), f"{units.length} {units.time}-1"
    long_name = "estimate of the flow parameters theta"
    add("flow_parameters_estimate", by_functions, estimate, long_name, speed)
    if row.readout and LAW not in own:
        until = f"theta_hat until {row.error_left} is small enough"
        long_name = f"readout of the flow parameters theta; {until}"
        add(
            "flow_parameters_readout",
            by_functions,
            of(row.readout, 2, N),
            long_name,
            speed,
        )
        if beside := _beside_the_basis(scenario):
            comment = f"not theta exactly: {beside} is taken for flow of the basis"
            variables["flow_parameters_readout"].attributes["comment"] = comment
        long_name = "share of the first error of theta_hat that is left"
        add("error_left", ("time",), of(row.error_left), long_name, "1")
    ours = set(parameters) - own if scenario.flow.parameters is not None else set()
    if "true_flow" in ours:
        theta, dims = parameters["true_flow"].theta, ("axis", "basis")
        long_name = "true flow parameters theta"
        add("flow_parameters", dims, lambda signals: theta.copy(), long_name, speed)
    doubt = ""
    if {"true_flow", "vehicle_controller", LAW} <= ours:
        car, p = parameters["vehicle_controller"], parameters[LAW]
        truth = Truth(parameters["true_flow"].theta, car.KD, car.GammaD)
        doubt = row.doubt(p, truth)
        V = _lyapunov(row.V(p, truth, along_run=True), column)
        add("lyapunov", ("time",), V, "Lyapunov candidate V", f"{units.length}2")
    there = {port for port, *_ in wanted.values()}
    others = {
        k: at for k, at in ports_of(column).items() if k in more and k not in there
    }
    in_units = {
        port: unit or (speed if port in SPEEDS else "") for port, unit in more.items()
    }
    more_variables, more_axes = port_variables(
        others, {2: "axis", **({} if N == 2 else {N: "basis"})}, variables, in_units
    )
    variables |= more_variables
    axes = {
        **more_axes,
        "axis": ([1, 2], {"long_name": "axis of the plane, x1 and x2"}),
        "basis": (np.arange(1, N + 1), {"long_name": "flow basis function"}),
    }
    since = {"long_name": "time since the start of the run", "units": units.time}
    of_run = {**_attributes(scenario), **beyond}
    return Frame(variables, axes, of_run, since, states, str(scenario._folder), doubt)


def _beside_the_basis(scenario: Scenario) -> str:
    """Return the keys that bring flow which the basis functions do not span, or nothing."""
    flow, fixes = scenario.flow, scenario.localization
    present = {
        "flow.field": flow.field is not None,
        "flow.disturbance": flow.disturbance is not None,
        "localization.noise": fixes is not None and fixes.noise > 0,
    }
    return " and ".join(key for key, is_there in present.items() if is_there)


def _attributes(scenario: Scenario) -> dict[str, Any]:
    origin = {}
    if scenario.field_path is not None:
        from ..ocean.currents.plane import time_origin

        origin = time_origin(scenario.field_path)
    return {
        "Conventions": "CF-1.11",
        "title": scenario.title,
        "source": f"clpt-control {version('clpt-control')}",
        "references": "Cho, Zhang, Edwards (2016), Adaptive learning for controlled "
        "Lagrangian particle tracking, OCEANS 2016 MTS/IEEE Monterey",
        "scenario": scenario_to_text(scenario),
        **origin,
    }


def _estimate(scenario: Scenario, signals: Signals, of: Any) -> Any:
    """Return the law's estimate of theta, as a function of the signals."""
    N = scenario.basis.N
    if scenario.learning.row.given_estimate:
        known: Any = scenario.learning.theta_estimate
        block = signals.parameters.get("injection")
        known = np.array(getattr(block, "theta_hat", known), dtype=float)
        return lambda signals: np.broadcast_to(known, (len(signals), 2, N)).copy()
    if "theta_hat[0]" in signals.column:
        return of("theta_hat", 2, N)
    alpha = of("alpha", 2, N)
    return lambda signals: 0.0 - alpha(signals)  # without -0


@lru_cache(maxsize=64)
def diagram_frame(name: str, labels: Labels, units: Labels, states: Labels) -> Frame:
    """Return the Dataset of any diagram: a variable for each port, named as it is, and its states.

    `labels` and `units` are those of the signals with which it is filled.
    """
    ports = ports_of(labels)
    by_port = {port: units[places[0]] for port, places in ports.items()}
    variables, axes = port_variables(ports, {}, ("time", "state", "states"), by_port)
    return Frame(variables, axes, {"title": f"Response of {name}"}, states=states)


def beyond_scenario_of(
    params: Params, attributes: Mapping[str, str] = {}
) -> dict[str, str]:
    """Return attributes for what the scenario does not hold, with call-time parameters added."""
    plain = {name: np.asarray(value).tolist() for name, value in (params or {}).items()}
    before = json.loads(attributes.get(CHANGED, "{}"))
    changed = {CHANGED: json.dumps({**before, **plain})} if before or plain else {}
    return {**attributes, **changed}


def _lyapunov(block: Block, column: Mapping[str, int]) -> Any:
    """Return V along the run, as a function of the signals."""
    labels = [
        f"{port}[{k}]" for port, size in block.input_ports.items() for k in range(size)
    ]
    places = np.array([column.get(label, 0) for label in labels])

    def along(signals: np.ndarray) -> np.ndarray:
        inputs = signals[:, places]
        for k in range(2 if f"{TRUE}[0]" in column else 0):
            # e is not of the measured position
            off = signals[:, column[f"{TRUE}[{k}]"]] - signals[:, column[f"z[{k}]"]]
            inputs[:, labels.index(f"e[{k}]")] = off
        if "weighted" in block.input_ports:
            N = block.input_ports["weighted"] // 2
            alpha, P = (signals[:, column[f"{port}[0]"] :] for port in ("alpha", "P"))
            alpha, P = (
                alpha[:, : 2 * N].reshape(-1, 2, N),
                P[:, : N * N].reshape(-1, N, N),
            )
            inputs[:, -2 * N :] = error_by_P(block.parameters, alpha, P).reshape(
                -1, 2 * N
            )
        return on_arrays(block, "output", 0.0, np.zeros((0, len(inputs))), inputs.T)[0]

    return along
