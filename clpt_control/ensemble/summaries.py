"""Summaries of the members of a scenario, and the times of their samples.

    clpe_rms                rms of |e| over each full cycle of the waypoints
    clpe_rms_whole          the same over the whole run
    flow_parameter_error    max |estimate - theta| at the marks
    flow_error              in a measured current: rms |F - theta_hat phi|, last quarter
    gain_error              max |gain - true gain| at the marks, if gains adapt
    share_in_faster_flow    share of time, for a vehicle with a speed limit
    status, end             termination of the run, and the last time that it reached

They are computed from the states, for all members of a batch at once.
"""

import itertools
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from ..base.errors import ScenarioError
from ..engine.model.ports import ports_of
from ..engine.solver.solver_layout import Status
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.quantities import QUANTITIES, Quantity
from ..simulation.dataset import VARIABLES
from ..simulation.flows import speed_figures
from ..simulation.integrate import sample_times
from ..simulation.loop_blocks import units_of_ports
from ..simulation.mean_squares import (
    nearest,
    samples_for_means,
    starts_of_rounds,
    union,
)
from .members import Ensemble, Members, States, Values, member_count

MOST_SAMPLES = 20_000  # of a member, but at least a tenth of the samples of `clpt run`
MARKS = 41  # default number of times of errors
TRAJECTORIES = (
    "position",
    "predicted_position",
    "alpha",
    "feedback_gain",
    "feedforward_gain",
)
# stiff members are continued by an implicit method and end otherwise
STATUS = tuple(status.label for status in Status if status != Status.STIFF)


class SampleTimes(NamedTuple):
    """Times of the states, and indices of the times for each purpose."""

    union: np.ndarray  # all times, increasing, from 0 to the end
    starts: (
        np.ndarray
    )  # offsets in `fine` of the starts of full cycles and the last end
    fine: np.ndarray  # evenly spaced, for mean squares
    marks: np.ndarray  # of errors
    output: np.ndarray  # of the scenario's output, for trajectories; empty without them


def samples_per_cycle(scenario: Scenario) -> int:
    """Return the number of samples of a cycle, or of a shorter run, for mean squares.

    The number of `clpt run` if a run has at most 20,000; fewer otherwise, but at least a tenth.
    """
    usual = samples_for_means(scenario)
    cycles = max(1.0, scenario.run.duration / scenario.cycle)
    return min(usual, max(usual // 10, int(MOST_SAMPLES / cycles)))


def marks_of(scenario: Scenario, times: Sequence[float] | None) -> tuple[float, ...]:
    """Return the times of errors, increasing, including the end."""
    end = scenario.run.duration
    if times is None:
        return tuple(np.linspace(0.0, end, MARKS).tolist())
    for time in times:
        if not 0 <= time <= end:
            raise ScenarioError(
                f"times: {time} must lie between 0 and run.duration = {end}"
            )
    return tuple(sorted({float(time) for time in times} | {end}))


def sample_times_of(
    scenario: Scenario, marks: Sequence[float], trajectories: bool
) -> SampleTimes:
    """Return all times of samples; times that differ by rounding are merged."""
    end, cycle = scenario.run.duration, scenario.cycle
    fine = sample_times(end, min(cycle, end) / samples_per_cycle(scenario))
    output = (
        sample_times(end, scenario.run.output_step) if trajectories else np.zeros(0)
    )
    groups = fine, np.array(marks, dtype=float), output
    times = union(*groups)
    times[-1] = end
    indices = (nearest(times, group) for group in groups)
    return SampleTimes(times, starts_of_rounds(fine, cycle), *indices)


class StoredArray(NamedTuple):
    """An array of the store; chunks fill an array without values."""

    dims: tuple[str, ...]
    shape: tuple[int, ...]
    dtype: Any
    attrs: dict[str, Any]
    values: np.ndarray | None = None


class Arrays(dict[str, StoredArray]):
    """The arrays of a store by name: summaries of members, and fixed arrays with values."""

    def __init__(self, values: Values, sizes: Mapping[str, int]):
        self.members = member_count(values)
        self.sizes = sizes

    def add(
        self,
        name: str,
        dims: Iterable[str],
        long_name: str,
        dtype: str = "float64",
        **attrs: Any,
    ) -> None:
        """Add an array of summaries; its first dimension is the member."""
        dims = tuple(dims)
        shape = (self.members, *(self.sizes[dim] for dim in dims))
        attrs = {"long_name": long_name, **attrs}
        self._put(name, ("member", *dims), shape, dtype, attrs)

    def add_members(self, **of_time: str) -> None:
        """Add the number, the status and the last time of each member."""
        flags = {
            "flag_values": list(range(len(STATUS))),
            "flag_meanings": " ".join(STATUS),
        }
        self.add("status", "", "how the run ended", "int8", **flags)
        self.add("end", "", "last sample reached", **of_time)
        numbers = np.arange(self.members)
        self.add_fixed(
            "member", ("member",), numbers, long_name="member of the ensemble"
        )

    def add_fixed(
        self, name: str, dims: tuple[str, ...], numbers: np.ndarray, **attrs: Any
    ) -> None:
        """Add an array with its values."""
        self._put(name, dims, numbers.shape, numbers.dtype, attrs, numbers)

    def _put(self, name: str, *array: Any) -> None:
        if name in self:
            raise ScenarioError(
                f"{name} is used twice as a name in the result. Rename one"
            )
        self[name] = StoredArray(*array)


def ends_of(run: States, times: np.ndarray) -> Values:
    """Return the status and the last time of members."""
    end = times[np.clip(run.reached - 1, 0, None)]
    return {"status": run.status.astype("int8"), "end": end}


# --- of a scenario: `varied` is a `VariedScenario` -----------------------------------------------


def arrays_of(varied: Any, values: Values) -> Arrays:
    """Return all arrays of an ensemble: summaries, the members' values, and coordinates."""
    scenario, times = varied.scenario, varied.times
    sizes = {
        "cycle": len(times.starts) - 1,
        "mark": len(times.marks),
        "axis": 2,
        "basis": scenario.basis.N,
        "time": len(times.output),
    }
    arrays = Arrays(values, sizes)
    _add_summaries(arrays, varied)
    units = {"time": scenario.units.time, **units_of_ports(scenario.units)}
    for key, array in values.items():
        quantity = QUANTITIES.get(key, Quantity())
        dims = quantity.axes.split() or ["axis", "basis"][: array.ndim - 1]
        port = quantity.unit or quantity.state
        attrs = {"long_name": f"{key}, which varies"}
        if port in units:
            attrs["units"] = units[port]
        arrays.add_fixed(key, ("member", *dims), array, **attrs)
    _add_coordinates(arrays, varied)
    return arrays


def _add_summaries(arrays: Arrays, varied: Any) -> None:
    scenario = varied.scenario
    length, time = scenario.units.length, scenario.units.time
    rate = f"{time}-1"

    def add(name: str, dims: str, long_name: str, units: str) -> None:
        arrays.add(name, dims.split(), long_name, units=units)

    cycle = f"rms of the CLPE over a cycle, {scenario.cycle:g} {time}"
    add("clpe_rms", "cycle", cycle, length)
    add("clpe_rms_whole", "", "rms of the CLPE over the whole run", length)
    if varied.knows_flow:
        speed = f"{length} {rate}"
        add("flow_parameter_error", "mark", "largest error of a flow parameter", speed)
    if varied.knows_gains:
        add("gain_error", "mark", "largest error of a gain", rate)
    if varied.has_flow_error:
        error = "rms error of the learned flow along the track, last quarter"
        add("flow_error", "", error, f"{length} {rate}")
    if scenario.vehicle.max_speed is not None:
        add(
            "share_in_faster_flow",
            "",
            "share of time in a flow faster than the vehicle",
            "1",
        )
    arrays.add_members(units=time)
    units = units_of_ports(scenario.units)
    for name in followed(varied):
        port, long_name, *_ = VARIABLES[name]
        dims = "time axis basis" if port == "alpha" else "time axis"
        add(name, dims, long_name, units[port])


def _add_coordinates(arrays: Arrays, varied: Any) -> None:
    """Add the coordinates of the dimensions that arrays have."""
    scenario, times = varied.scenario, varied.times
    used = {dim for array in arrays.values() for dim in array.dims}

    def add(dim: str, numbers: np.ndarray, long_name: str, **attrs: Any) -> None:
        if dim in used and numbers.size:
            arrays.add_fixed(dim, (dim,), numbers, long_name=long_name, **attrs)

    time = scenario.units.time
    marks, samples = times.union[times.marks], times.union[times.output]
    cycles = np.arange(1, len(times.starts))
    add("cycle", cycles, "round of the waypoints", length=scenario.cycle)
    add("mark", marks, "time of an error", units=time)
    add("time", samples, "time since the start of the run", units=time)
    add("axis", np.array([1, 2]), "axis of the plane, x1 and x2")
    add("basis", 1 + np.arange(scenario.basis.N), "flow basis function")
    add("waypoint", 1 + np.arange(len(scenario.waypoints)), "waypoint")


def followed(varied: Any) -> list[str]:
    """Return the names of the states that are stored at the scenario's output samples."""
    row = varied.scenario.learning.row
    absent = {"alpha"} if row.alpha_is_constant else set()
    absent |= {"feedback_gain", "feedforward_gain"} if row.at_fixes else set()
    return [name for name in TRAJECTORIES if varied.trajectories and name not in absent]


def summarise(
    varied: Any, ensemble: Ensemble, members: Members, values: Values, run: States
) -> Values:
    """Return the summaries of members; NaN after the end of a failed run."""
    scenario, times, y = varied.scenario, varied.times, run.states
    m, N = len(run.states), scenario.basis.N
    states = {port: y[..., column] for port, column in varied.columns.items()}

    def at_marks(port: str) -> np.ndarray:
        return states[port][:, times.marks]

    def value(key: str) -> np.ndarray:
        """Return the value of a key for each member, (m or 1, 1, numbers)."""
        value = np.asarray(values.get(key, varied.values[key]))
        return value.reshape(-1, 1, varied.values[key].size)

    def estimates(port_values: Any) -> np.ndarray:
        """Return the estimate of theta, given the values of a port."""
        law = scenario.learning.row
        if law.given_estimate:
            return value("learning.theta_estimate")
        return port_values("theta_hat") if law.makes_estimate else -port_values("alpha")

    # 1. CLPE
    fine = slice(None) if len(times.fine) == len(times.union) else times.fine
    squares = np.zeros((m, len(times.fine)))
    for i in range(2):
        squares += np.square(states["x"][:, fine, i] - states["z"][:, fine, i])
    rounds = itertools.pairwise(times.starts)
    means = [np.mean(squares[:, begin:end], axis=1) for begin, end in rounds]
    summaries = {
        "clpe_rms": np.sqrt(np.array(means).reshape(-1, m).T),
        "clpe_rms_whole": np.sqrt(np.mean(squares, axis=1)),
    }
    # 2. errors of the flow parameters and the gains
    if varied.knows_flow:
        error = np.abs(estimates(at_marks) - value("flow.parameters")).max(axis=2)
        running = np.isfinite(y[:, times.marks, 0])
        summaries["flow_parameter_error"] = np.where(running, error, np.nan)
    if varied.knows_gains:
        K_error = np.abs(at_marks("K") - value("vehicle.feedback"))
        Gamma_error = np.abs(at_marks("Gamma") - value("vehicle.feedforward"))
        summaries["gain_error"] = np.maximum(
            K_error.max(axis=2), Gamma_error.max(axis=2)
        )
    # 3. flow along the track, termination, trajectories
    if varied.needs_signals:
        theta = estimates(states.__getitem__)
        theta = np.broadcast_to(theta, (m, len(times.union), 2 * N))
        summaries |= _flow_along_tracks(varied, ensemble, members, values, run, theta)
    summaries |= ends_of(run, times.union)
    for name in followed(varied):
        trajectory = states[VARIABLES[name][0]][:, times.output]
        summaries[name] = (
            trajectory.reshape(m, -1, 2, N) if name == "alpha" else trajectory
        )
    return summaries


def _flow_along_tracks(
    varied: Any,
    ensemble: Ensemble,
    members: Members,
    values: Values,
    run: States,
    theta: np.ndarray,
) -> Values:
    """Return figures of members along their tracks, given the estimates (m, times, 2N).

    These are the error of the learned flow in a measured current, and the share of time in a flow
    faster than the vehicle.
    """
    count = len(run.states)
    shares, errors = np.full(count, np.nan), np.full(count, np.nan)
    limits = values.get("vehicle.max_speed")
    if limits is None:
        limits = np.full(count, varied.scenario.vehicle.max_speed)
    is_limited = varied.scenario.vehicle.max_speed is not None
    nodes = varied.wiring.nodes
    ports = ports_of([label for node in nodes for label in node.system.output_labels])
    for m in np.flatnonzero(run.reached >= 2).tolist():
        signals = ensemble.signals(members, run, m)
        times = varied.state_times[: run.reached[m]]
        flow = signals[:, ports["flow_x"]]
        if is_limited:
            commanded = signals[:, ports["v_c"]]
            figures = speed_figures(float(limits[m]), times, commanded, flow)
            faster = figures["faster_flow"]
            shares[m] = faster["share"] if faster else 0.0
        if varied.has_flow_error:
            late = times >= times[-1] - 0.25 * (times[-1] - times[0])
            phi = signals[late][:, ports["phi_x"]]
            estimate = theta[m, : run.reached[m]][late].reshape(len(phi), 2, -1)
            off = flow[late] - np.einsum("taN,tN->ta", estimate, phi)
            errors[m] = np.sqrt(np.mean(np.sum(off**2, axis=1)))
    summaries = {"share_in_faster_flow": shares} if is_limited else {}
    return summaries | ({"flow_error": errors} if varied.has_flow_error else {})
