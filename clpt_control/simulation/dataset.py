"""A run as an `xarray.Dataset` with CF attributes.

dims time, axis, basis; units on every variable; the scenario, the versions and
the solver's statistics in the attributes, so that a run repeats from its file.
"""

import json
import platform
from collections.abc import Collection, Container, Mapping, Sequence
from functools import cache, lru_cache
from importlib.metadata import version
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..blocks.laws.known import Truth
from ..blocks.localization import TRUE
from ..diagrams.changes import LAW, UNCHANGED, Changes
from ..diagrams.wiring import Wiring
from ..equations.at_many import on_arrays
from ..equations.declaration import ports_of
from ..native.ending import Solution
from ..scenario.experiment import Scenario
from ..scenario.file import CHANGED, OWN_LAW, OWN_PARTS, scenario_to_text

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
STATE = {"long_name": "state of the diagram"}
STATES = {"long_name": "states of the diagram, each in its own unit"}


class Columns(NamedTuple):
    """Where a vehicle's signals stand, and with what its blocks ran."""

    column: dict[str, int]  # label -> column of the signals
    ran: Mapping[str, Any]  # block -> its parameters


def columns_of(labels: Sequence[str], wiring: Wiring, given: Sequence[Any]) -> Columns:
    """Return where signals of these labels stand; `given` are the parameters of the blocks."""
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
    changes: Changes = UNCHANGED,
    more: Collection[str] = (),
) -> "xarray.Dataset":
    """Return a scenario's solution as a Dataset.

    `signals` are all block outputs, shape (ntimes, nsignals), right limits at jumps; `left`
    call-time parameters that no key holds; `changes` the parts of the user's own; `more` are
    signals to show under their own names.
    """
    import xarray

    units, N, n = scenario.units, scenario.basis.N, len(solution.t)
    column, ran = columns
    data: dict[str, Any] = {}
    measured = f"{TRUE}[0]" in column
    wanted = {**VARIABLES, **(MEASURED if measured else {})}
    wanted |= LIMITED if "v_c[0]" in column else {}
    row, replaced = scenario.learning.row, set(changes.replace)
    for name, (port, long_name, lengths, rates) in wanted.items():
        size = 2 * N if port == "alpha" else 2
        if f"{port}[0]" not in column:
            continue
        values = signals[:, [column[f"{port}[{k}]"] for k in range(size)]]
        unit = " ".join([units.length] * lengths + [f"{units.time}-1"] * rates)
        dims: tuple[str, ...] = ("time", "axis")
        if port == "alpha":
            values, dims = values.reshape(n, 2, N), ("time", "axis", "basis")
        data[name] = (dims, values, {"long_name": long_name, "units": unit})
    alpha = data["alpha"][1]
    estimate = 0.0 - alpha  # without -0
    if row.given_estimate:
        known: Any = scenario.learning.theta_estimate
        known = getattr(ran.get("injection"), "theta_hat", known)
        estimate = np.broadcast_to(known, alpha.shape).copy()
    elif "theta_hat[0]" in column:
        made = [column[f"theta_hat[{k}]"] for k in range(2 * N)]
        estimate = signals[:, made].reshape(n, 2, N)
    speed = {"units": f"{units.length} {units.time}-1"}
    learned = {"long_name": "estimate of the flow parameters theta", **speed}
    data["flow_parameters_estimate"] = (("time", "axis", "basis"), estimate, learned)
    if row.readout and LAW not in replaced:
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
    ours = set(ran) - replaced if scenario.flow.parameters is not None else set()
    if "true_flow" in ours:
        said = {"long_name": "true flow parameters theta", **speed}
        data["flow_parameters"] = (("axis", "basis"), ran["true_flow"].theta, said)
    if {"true_flow", "vehicle_controller", LAW} <= ours:
        candidate = {"long_name": "Lyapunov candidate V", "units": f"{units.length}2"}
        data["lyapunov"] = (("time",), _lyapunov(scenario, ran, signals, column), candidate)
    shown = {port for port, *_ in wanted.values()}
    dims_of = {2: "axis", **({} if N == 2 else {N: "basis"})}
    data |= named_signals(
        {port: at for port, at in ports_of(column).items() if port in more and port not in shown},
        signals,
        dims_of,
        data,
    )
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
        **_changed(left, changes),
        **how_it_ran(solution),
    }
    run = xarray.Dataset(data, coordinates, attributes)
    run.encoding["folder"] = str(scenario._folder)
    return run


def diagram_dataset(
    name: str,
    labels: Sequence[str],
    signals: np.ndarray,
    solution: Solution,
    states: Sequence[str],
) -> "xarray.Dataset":
    """Return the run of any diagram: a variable for each port, named as it is, and its states."""
    from xarray import Coordinates, Dataset, Variable

    data = named_signals(ports_of(labels), signals, {}, ("time", "state", "states"))
    data["states"] = (("time", "state"), solution.x, STATES)
    times, own = _index("time", solution.t, None), _state_index(tuple(states))
    indexes = {"time": times[0], "state": own[0]}
    coordinates = Coordinates({"time": times[1], "state": own[1]}, indexes=indexes)
    attributes = {"title": f"Response of {name}", **how_it_ran(solution)}
    return Dataset({k: Variable(*one) for k, one in data.items()}, coordinates, attributes)


def _index(name: str, values: Any, attributes: Any) -> tuple[Any, Any]:
    """Return an index of values and its variable, which xarray else makes in some passes."""
    from pandas import Index
    from xarray import Variable
    from xarray.indexes import PandasIndex

    index = PandasIndex(Index(values), name)
    variable = Variable((name,), values, attributes)
    return index, index.create_variables({name: variable})[name]


@lru_cache(maxsize=64)
def _state_index(states: tuple[str, ...]) -> tuple[Any, Any]:
    """Return the index of a diagram's states."""
    return _index("state", np.array(states, dtype=object), STATE)


def named_signals(
    ports: Mapping[str, Sequence[int]],
    signals: np.ndarray,
    dims: Mapping[int, str],
    taken: Container[str],
) -> dict[str, Any]:
    """Return variables of ports; `dims` names dimensions by size, a name that is taken gets a _."""
    data: dict[str, Any] = {}
    for port, places in ports.items():
        size = len(places)
        more = () if size == 1 else (dims.get(size, f"index_{size}"),)
        values = signals[:, places[0]] if size == 1 else signals[:, places]
        data[f"{port}_" if port in taken else port] = (("time", *more), values)
    return data


def with_states(
    run: "xarray.Dataset", labels: Sequence[str], solution: Solution
) -> "xarray.Dataset":
    """Return a run with the states of its diagram, as `state_at` reads them."""
    named = {"state": ("state", list(labels), STATE)}
    return run.assign_coords(named).assign(states=(("time", "state"), solution.x, STATES))


def how_it_ran(solution: Solution) -> dict[str, Any]:
    """Return attributes: versions, status and the solver's statistics."""
    return {
        "software": _software(),
        "status": solution.status,
        "message": solution.message,
        "engine": solution.engine,
        **{f"solver_{name}": value for name, value in solution.statistics.items()},
    }


@cache
def _software() -> str:
    packages = ("clpt-control", "control", "numpy", "scipy", "numba")
    here = f"Python {platform.python_version()}"
    return ", ".join([here, *(f"{name} {version(name)}" for name in packages)])


def _changed(left: Mapping[str, Any], changes: Changes) -> dict[str, str]:
    """Return what the scenario does not hold: a run with that cannot be repeated."""
    plain = {name: np.asarray(value).tolist() for name, value in left.items()}
    found = {
        CHANGED: json.dumps(plain) if plain else "",
        OWN_LAW: changes.law.name if changes.law else "",
        OWN_PARTS: changes.in_words,
    }
    return {name: text for name, text in found.items() if text}


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
    return on_arrays(block, "output", 0.0, np.zeros((0, len(inputs))), inputs.T)[0]
