"""A run as an `xarray.Dataset` with CF attributes.

dims time, axis, basis; units on every variable; the scenario, the versions and
the solver's statistics in the attributes, so that a run repeats from its file.
"""

import json
from collections.abc import Mapping, Sequence
from functools import cache
from importlib.metadata import version
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..blocks.arrays import on_arrays
from ..blocks.block import Block
from ..blocks.laws.law import Truth
from ..blocks.localization import TRUE
from ..diagrams.wiring import Wiring
from ..native.ending import Solution
from ..scenario.experiment import Scenario
from ..scenario.file import CHANGED, OWN_LAW, scenario_to_text

if TYPE_CHECKING:
    import xarray

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
LIMITED = {  # where the vehicle's speed has a limit
    "velocity": ("v_x", "velocity through the water, as flown", 1, 1),
    "commanded_velocity": ("v_c", "velocity through the water, as commanded", 1, 1),
}
MEASURED = {  # where the vehicle reads its position with noise
    "position": (TRUE, "true position", 1, 0),
    "measured_position": ("x", "measured position, which the vehicle reads", 1, 0),
    "clpe": ("e", "controlled Lagrangian prediction error, of the measured position", 1, 0),
}


class Columns(NamedTuple):
    """Where a vehicle's signals stand, and with what its blocks ran."""

    column: dict[str, int]  # label -> column of the signals
    ran: Mapping[str, Any]  # block -> its parameters


def all_columns(wiring: Wiring, given: Sequence[Any]) -> Columns:
    """Return where all signals of a diagram stand; `given` are its blocks' parameters."""
    labels = [label for node in wiring.nodes for label in node.system.output_labels]
    return Columns(
        {label: k for k, label in enumerate(labels)},
        {node.name: p for node, p in zip(wiring.nodes, given, strict=True)},
    )


def run_dataset(
    scenario: Scenario,
    columns: Columns,
    signals: np.ndarray,
    solution: Solution,
    left: Mapping[str, Any],
    law: Block | None = None,
) -> "xarray.Dataset":
    """Return a scenario's solution as a Dataset.

    `signals` are all block outputs, shape (ntimes, nsignals), right limits at jumps; `left`
    call-time parameters that no key holds; `law` a law of the user's own, which has no V here.
    """
    import xarray

    units, N, n = scenario.units, scenario.basis.N, len(solution.t)
    column, ran = columns
    data: dict[str, Any] = {}
    measured = f"{TRUE}[0]" in column
    wanted = {**VARIABLES, **(MEASURED if measured else {})}
    wanted |= LIMITED if "v_c[0]" in column else {}
    for name, (port, long_name, lengths, rates) in wanted.items():
        size = 2 * N if port == "alpha" else 2
        values = signals[:, [column[f"{port}[{k}]"] for k in range(size)]]
        unit = " ".join([units.length] * lengths + [f"{units.time}-1"] * rates)
        dims: tuple[str, ...] = ("time", "axis")
        if port == "alpha":
            values, dims = values.reshape(n, 2, N), ("time", "axis", "basis")
        data[name] = (dims, values, {"long_name": long_name, "units": unit})
    alpha = data["alpha"][1]
    estimate = 0.0 - alpha  # without -0
    if scenario.learning.row.given_estimate:
        estimate = np.broadcast_to(ran["injection"].theta_hat, alpha.shape).copy()
    elif "theta_hat[0]" in column:
        made = [column[f"theta_hat[{k}]"] for k in range(2 * N)]
        estimate = signals[:, made].reshape(n, 2, N)
    speed = {"units": f"{units.length} {units.time}-1"}
    learned = {"long_name": "estimate of the flow parameters theta", **speed}
    data["flow_parameters_estimate"] = (("time", "axis", "basis"), estimate, learned)
    row = scenario.learning.row
    if row.readout and law is None:
        values = signals[:, [column[f"{row.readout}[{k}]"] for k in range(2 * N)]]
        right = f"theta_hat until {row.shrinking} is small enough"
        named = {"long_name": f"readout of the flow parameters theta; {right}", **speed}
        data["flow_parameters_readout"] = (
            ("time", "axis", "basis"),
            values.reshape(n, 2, N),
            named,
        )
        left_of = {"long_name": "share of the first error of theta_hat that is left", "units": "1"}
        data["error_left"] = (("time",), signals[:, column[f"{row.shrinking}[0]"]], left_of)
    if scenario.flow.parameters is not None:
        true = ran["true_flow"].theta
        known = {"long_name": "true flow parameters theta", **speed}
        data["flow_parameters"] = (("axis", "basis"), true, known)
    if scenario.flow.parameters is not None and law is None:
        candidate = {"long_name": "Lyapunov candidate V", "units": f"{units.length}2"}
        data["lyapunov"] = (("time",), _lyapunov(scenario, ran, signals, column), candidate)
    origin = {}
    if scenario.field_path is not None:
        from ..currents.field_file import time_origin

        origin = time_origin(scenario.field_path)
    since = {"long_name": "time since the start of the run", "units": units.time}
    coordinates = {
        "time": ("time", solution.t, since),
        "axis": ("axis", [1, 2], {"long_name": "axis of the plane, x1 and x2"}),
        "basis": ("basis", np.arange(1, N + 1), {"long_name": "flow basis function"}),
    }
    attributes = {
        "Conventions": "CF-1.11",
        "title": scenario.title,
        "source": f"clpt-control {version('clpt-control')}",
        "references": "Cho, Zhang, Edwards (2016), Adaptive learning for controlled "
        "Lagrangian particle tracking, OCEANS 2016 MTS/IEEE Monterey",
        "scenario": scenario_to_text(scenario),
        **origin,
        **_changed(left, law),
        "software": _software(),
        "status": solution.status,
        "message": solution.message,
        "engine": solution.engine,
        **{f"solver_{name}": value for name, value in solution.statistics.items()},
    }
    run = xarray.Dataset(data, coordinates, attributes)
    run.encoding["folder"] = str(scenario._folder)
    return run


@cache
def _software() -> str:
    packages = ("clpt-control", "control", "numpy", "scipy")
    return ", ".join(f"{name} {version(name)}" for name in packages)


def _changed(left: Mapping[str, Any], law: Block | None) -> dict[str, str]:
    """Return what the scenario does not hold: a run with that cannot be repeated."""
    plain = {name: np.asarray(value).tolist() for name, value in left.items()}
    own = {} if law is None else {OWN_LAW: law.name}
    return {CHANGED: json.dumps(plain), **own} if plain else own


def _lyapunov(
    scenario: Scenario, ran: Mapping[str, Any], signals: np.ndarray, column: Mapping[str, int]
) -> np.ndarray:
    """Return the law's V along the run, with the parameters that ran."""
    car, p = ran["vehicle_controller"], ran["adaptation"]
    block = scenario.learning.row.V(p, Truth(ran["true_flow"].theta, car.KD, car.GammaD))

    def values(port: str, size: int) -> np.ndarray:
        if port == "e" and f"{TRUE}[0]" in column:  # not of the measured position
            return values(TRUE, 2) - values("z", 2)
        return signals[:, [column[f"{port}[{k}]"] for k in range(size)]]

    inputs = np.hstack([values(port, size) for port, size in block.input_ports.items()])
    zero = np.zeros(len(inputs))
    return on_arrays(block.output_record, zero, (), inputs.T, block.parameters)[0]
