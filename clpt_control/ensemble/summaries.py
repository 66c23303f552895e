"""The summaries of each member of a scenario, and the times of its samples.

    clpe_rms                rms of |e| over each full cycle of the waypoints
    clpe_rms_whole          the same over the whole run
    flow_parameter_error    max |estimate - theta| at the marks
    gain_error              max |gain - true gain| at the marks, where gains adapt
    share_in_faster_flow    of time, of a vehicle whose speed is limited
    status, end             how the run ended and the last time it reached

They are computed for all members of a chunk at once, from their states.
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
from ..simulation.mean_squares import nearest, samples_for_means, starts_of_rounds
from .members import Ensemble, Members, States, Values

MOST_SAMPLES = 20_000  # a member, but at least a tenth of those of `clpt run`
MARKS = 41  # times of errors, unless they are given
TRAJECTORIES = (
    "position",
    "predicted_position",
    "alpha",
    "feedback_gain",
    "feedforward_gain",
)
# a member goes on by itself where it is stiff
STATUS = tuple(status.label for status in Status if status != Status.STIFF)


class SampleTimes(NamedTuple):
    """Times of the states, and the numbers of those for each purpose."""

    all: np.ndarray  # increasing, from 0 to the end
    # where in `fine` each full cycle starts, and where the last one ends
    starts: np.ndarray
    fine: np.ndarray  # evenly spaced, for mean squares
    marks: np.ndarray  # of errors
    own: np.ndarray  # the scenario's own, for trajectories; empty without them


def samples_per_cycle(scenario: Scenario) -> int:
    """Return the number of samples a cycle, or a run that is shorter, for mean squares.

    As in `clpt run` where a run has 20,000 at most; fewer in others, but at least a tenth.
    """
    usual, cycles = (
        samples_for_means(scenario),
        max(1.0, scenario.run.duration / scenario.cycle),
    )
    return min(usual, max(usual // 10, int(MOST_SAMPLES / cycles)))


def marks_of(scenario: Scenario, times: Sequence[float] | None) -> tuple[float, ...]:
    """Return the times of errors, increasing; the end is one."""
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
    """Return all times of samples; those that differ by rounding are one."""
    end, cycle = scenario.run.duration, scenario.cycle
    fine = sample_times(end, min(cycle, end) / samples_per_cycle(scenario))
    own = sample_times(end, scenario.run.output_step) if trajectories else np.zeros(0)
    wanted = fine, np.array(marks, dtype=float), own
    every = np.sort(np.concatenate(wanted))
    slack = 1e-9 * max(1.0, end)
    merged = every[np.append(True, np.diff(every) > slack)]
    merged[-1] = end
    return SampleTimes(
        merged, starts_of_rounds(fine, cycle), *(nearest(merged, t) for t in wanted)
    )


class StoredArray(NamedTuple):
    """An array of the store; without values it is filled member by member."""

    dims: tuple[str, ...]
    shape: tuple[int, ...]
    dtype: Any
    attrs: dict[str, Any]
    values: np.ndarray | None = None


class Arrays(dict[str, StoredArray]):
    """The arrays of a store by name: the summaries of members, made of values, and fixed ones."""

    def __init__(self, values: Values, sizes: Mapping[str, int]):
        self.members, self.sizes = len(next(iter(values.values()))), sizes

    def add(
        self,
        name: str,
        dims: Iterable[str],
        long_name: str,
        dtype: str = "float64",
        **attrs: Any,
    ) -> None:
        """Add an array that summaries fill, the first dimension the member."""
        dims = tuple(dims)
        shape = (self.members, *(self.sizes[dim] for dim in dims))
        self._put(
            name, ("member", *dims), shape, dtype, {"long_name": long_name, **attrs}
        )

    def add_members(self, **of_time: str) -> None:
        """Add the number of each member, how it ended, and when."""
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
                f"{name} is twice a name of the result; rename what is called so"
            )
        self[name] = StoredArray(*array)


def ends_of(run: States, times: np.ndarray) -> Values:
    """Return how members ended, and when."""
    end = times[np.clip(run.reached - 1, 0, None)]
    return {"status": run.status.astype("int8"), "end": end}


# --- of a scenario: `varied` is a `VariedScenario` -----------------------------------------------


def arrays_of(varied: Any, values: Values) -> Arrays:
    """Return all arrays of an ensemble: summaries, the members' values, and coordinates."""
    scenario, times = varied.scenario, varied.times
    length, time = scenario.units.length, scenario.units.time
    units = {"time": time, **units_of_ports(scenario.units)}
    rate, N, cycles = f"{time}-1", scenario.basis.N, len(times.starts) - 1
    sizes = {"cycle": cycles, "mark": len(times.marks), "axis": 2, "basis": N}
    arrays = Arrays(values, sizes | {"time": len(times.own)})

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
    if varied.needs_signals:
        add(
            "share_in_faster_flow",
            "",
            "share of time in a flow faster than the vehicle",
            "1",
        )
    arrays.add_members(units=time)
    for name in followed(varied):
        port, long_name, *_ = VARIABLES[name]
        dims = "time axis basis" if port == "alpha" else "time axis"
        add(name, dims, long_name, units[port])
    for key, array in values.items():
        one = QUANTITIES.get(key, Quantity())
        axes_of_key = one.axes.split() or ["axis", "basis"][: array.ndim - 1]
        attrs = (
            {"units": units[port]} if (port := one.unit or one.state) in units else {}
        )
        long_name = f"{key}, which varies"
        arrays.add_fixed(
            key, ("member", *axes_of_key), array, long_name=long_name, **attrs
        )
    used = {dim for array in arrays.values() for dim in array.dims}
    axes = {
        "cycle": (
            np.arange(1, cycles + 1),
            "round of the waypoints",
            {"length": scenario.cycle},
        ),
        "mark": (times.all[times.marks], "time of an error", {"units": time}),
        "time": (
            times.all[times.own],
            "time since the start of the run",
            {"units": time},
        ),
        "axis": (np.array([1, 2]), "axis of the plane, x1 and x2", {}),
        "basis": (np.arange(1, N + 1), "flow basis function", {}),
        "waypoint": (np.arange(1, len(scenario.waypoints) + 1), "waypoint", {}),
    }
    for dim, (numbers, long_name, attributes) in axes.items():
        if dim in used and numbers.size:
            arrays.add_fixed(dim, (dim,), numbers, long_name=long_name, **attributes)
    return arrays


def followed(varied: Any) -> list[str]:
    """Return the names of the states that are stored at the scenario's own samples."""
    row = varied.scenario.learning.row
    absent = {"alpha"} if row.alpha_is_constant else set()
    absent |= {"feedback_gain", "feedforward_gain"} if row.at_fixes else set()
    return [name for name in TRAJECTORIES if varied.trajectories and name not in absent]


def summarise(
    varied: Any, ensemble: Ensemble, members: Members, values: Values, run: States
) -> Values:
    """Return the summaries of members; NaN after the end of one that failed."""
    scenario, times, y = varied.scenario, varied.times, run.states
    row, m, N = scenario.learning.row, len(run.states), scenario.basis.N
    at = {port: y[..., column] for port, column in varied.columns.items()}

    def value(key: str) -> np.ndarray:
        return np.asarray(values.get(key, varied.values[key]))

    fine = slice(None) if len(times.fine) == len(times.all) else times.fine
    squares = np.zeros((m, len(times.fine)))
    for i in range(2):
        squares += np.square(at["x"][:, fine, i] - at["z"][:, fine, i])
    rounds = itertools.pairwise(times.starts)
    means = [np.mean(squares[:, first:last], axis=1) for first, last in rounds]
    summaries = {
        "clpe_rms": np.sqrt(np.array(means).reshape(-1, m).T),
        "clpe_rms_whole": np.sqrt(np.mean(squares, axis=1)),
    }
    if varied.knows_flow:
        if row.given_estimate:
            estimate = value("learning.theta_estimate").reshape(-1, 1, 2 * N)
        elif row.makes_estimate:
            estimate = at["theta_hat"][:, times.marks]
        else:
            estimate = -at["alpha"][:, times.marks]
        error = np.abs(estimate - value("flow.parameters").reshape(-1, 1, 2 * N)).max(
            axis=2
        )
        alive = np.isfinite(y[:, times.marks, 0])
        summaries["flow_parameter_error"] = np.where(alive, error, np.nan)
    if varied.knows_gains:
        errors = [
            np.abs(
                at[port][:, times.marks] - value(f"vehicle.{key}").reshape(-1, 1, 2)
            ).max(axis=2)
            for port, key in (("K", "feedback"), ("Gamma", "feedforward"))
        ]
        summaries["gain_error"] = np.maximum(*errors)
    if varied.needs_signals:
        summaries["share_in_faster_flow"] = _faster_flow(
            varied, ensemble, members, values, run
        )
    summaries |= ends_of(run, times.all)
    for name in followed(varied):
        own = at[VARIABLES[name][0]][:, times.own]
        summaries[name] = own.reshape(m, -1, 2, N) if name == "alpha" else own
    return summaries


def _faster_flow(
    varied: Any, ensemble: Ensemble, members: Members, values: Values, run: States
) -> np.ndarray:
    """Return the share of time in a flow faster than each member, by the samples it reached."""
    shares, times = np.full(len(run.states), np.nan), varied.state_times
    limits = values.get(
        "vehicle.max_speed", itertools.repeat(varied.scenario.vehicle.max_speed)
    )
    every = [
        label for node in varied.wiring.nodes for label in node.system.output_labels
    ]
    ports = ports_of(every)
    for m, limit in zip(range(len(shares)), limits, strict=False):
        if run.reached[m] < 2:
            continue
        signals = ensemble.signals(members, run, m)
        velocities = (signals[:, ports[port]] for port in ("v_c", "flow_x"))
        faster = speed_figures(float(limit), times[: run.reached[m]], *velocities)[
            "faster_flow"
        ]
        shares[m] = faster["share"] if faster else 0.0
    return shares
