"""Summaries of the members of a scenario, and the times of their samples.

    clpe_rms                rms of |e| over each full cycle of the waypoints
    clpe_rms_whole          the same over the whole run
    flow_parameter_error    max |estimate - theta| at the marks
    flow_error              in a measured current: rms |F - theta_hat phi|, last quarter
    gain_error              max |gain - true gain| at the marks, if gains adapt
    share_in_faster_flow    share of time, for a vehicle with a speed limit
    status, end             termination of the run, and the last time that it reached

They are computed from the states, for all members of a batch at once.  `varied` is a
`VariedScenario`.
"""

from collections.abc import Sequence
from functools import cached_property, partial
from typing import Any, NamedTuple

import numpy as np

from ..base.errors import ScenarioError
from ..engine.model.ports import ports_of
from ..paper.blocks.ports import POWERS
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.recorded_run import DIMS
from ..simulation.dataset import VARIABLES, plane_axes, series, unit_of
from ..simulation.dataset_template import Axes, Series
from ..simulation.flows import speed_figures
from ..simulation.mean_squares import (
    last_quarter,
    nearest,
    rms,
    rms_of_rounds,
    samples_for_means,
    starts_of_rounds,
    union,
)
from ..simulation.requests import sample_times
from .members import MemberBatch

MOST_SAMPLES = 20_000  # of a member, but at least a tenth of the samples of `clpt run`
MARKS = 41  # default number of times of errors
SUMMARIES = {  # name -> dimensions, powers of length and 1/time, long name
    "clpe_rms": (
        "cycle",
        1,
        0,
        "rms of the CLPE over a cycle, {0.cycle:g} {0.units.time}",
    ),
    "clpe_rms_whole": ("", 1, 0, "rms of the CLPE over the whole run"),
    "flow_parameter_error": ("mark", 1, 1, "largest error of a flow parameter"),
    "gain_error": ("mark", 0, 1, "largest error of a gain"),
    "flow_error": (
        "",
        1,
        1,
        "rms error of the learned flow along the track, last quarter",
    ),
    "share_in_faster_flow": (
        "",
        0,
        0,
        "share of time in a flow faster than the vehicle",
    ),
}
TRAJECTORIES = (
    "position",
    "predicted_position",
    "alpha",
    "feedback_gain",
    "feedforward_gain",
)


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


def axes_of(scenario: Scenario, times: SampleTimes) -> Axes:
    """Return values and attributes of the dimensions of summaries."""
    time = scenario.units.time
    marks, samples = times.union[times.marks], times.union[times.output]
    cycles = np.arange(1, len(times.starts))
    rounds = {"long_name": "round of the waypoints", "length": scenario.cycle}
    since = {"long_name": "time since the start of the run", "units": time}
    waypoints = 1 + np.arange(len(scenario.waypoints))
    return {
        "cycle": (cycles, rounds),
        "mark": (marks, since),
        "time": (samples, since),
        **plane_axes(scenario.basis.N),
        "waypoint": (waypoints, {"long_name": "waypoint"}),
    }


def summaries_of(varied: Any) -> list[tuple[str, Series]]:
    """Return the names and series of summaries, functions of a `LoopBatch`."""
    scenario = varied.scenario
    summaries = []
    for name, (dims, lengths, rates, long_name) in SUMMARIES.items():
        unit = unit_of(scenario.units, lengths, rates) or "1"
        of, words = getattr(LoopBatch, name), long_name.format(scenario)
        summaries.append((name, series(tuple(dims.split()), of, words, unit)))
    for name in TRAJECTORIES:
        port, long_name = VARIABLES[name]
        unit = unit_of(scenario.units, *POWERS[port])
        of = partial(LoopBatch.trajectory, port=port)
        summaries.append((name, series(DIMS[name], of, long_name, unit)))
    return [one for one in summaries if one[0] not in varied.absent]


class LoopBatch(MemberBatch):
    """Summaries of members that ran; NaN after the end of a failed run."""

    def states(self, port: str) -> np.ndarray:
        """Return a state of all members, (m, times, numbers)."""
        return self.run.states[..., self.varied.columns[port]]

    def at_marks(self, port: str) -> np.ndarray:
        """Return a state at the times of errors."""
        return self.states(port)[:, self.varied.times.marks]

    def value(self, key: str) -> np.ndarray:
        """Return the value of a key for each member, (m or 1, 1, numbers)."""
        usual = self.varied.values[key]
        return np.asarray(self.values.get(key, usual)).reshape(-1, 1, usual.size)

    def estimates(self, port_values: Any) -> np.ndarray:
        """Return the estimate of theta, given the values of a port."""
        law = self.varied.scenario.learning.row
        if law.given_estimate:
            return self.value("learning.theta_estimate")
        return port_values("theta_hat") if law.makes_estimate else -port_values("alpha")

    @cached_property
    def squares(self) -> np.ndarray:
        """|e|^2 at the fine times, (m, times)."""
        times = self.varied.times
        fine = slice(None) if len(times.fine) == len(times.union) else times.fine
        x, z = self.states("x"), self.states("z")
        squares = np.zeros((len(x), len(times.fine)))
        for i in range(2):
            squares += np.square(x[:, fine, i] - z[:, fine, i])
        return squares

    def clpe_rms(self) -> np.ndarray:
        """Return the rms of the CLPE over each cycle."""
        times = self.varied.times
        rounds = rms_of_rounds(self.squares, times.union[times.fine], times.starts)
        return np.array(rounds).reshape(-1, len(self.squares)).T

    def clpe_rms_whole(self) -> np.ndarray:
        """Return the rms of the CLPE over the whole run."""
        times = self.varied.times
        return rms(self.squares, times.union[times.fine])

    def flow_parameter_error(self) -> np.ndarray:
        """Return the largest error of a flow parameter at the marks."""
        error = np.abs(self.estimates(self.at_marks) - self.value("flow.parameters"))
        running = np.isfinite(self.run.states[:, self.varied.times.marks, 0])
        return np.where(running, error.max(axis=2), np.nan)

    def gain_error(self) -> np.ndarray:
        """Return the largest error of a gain at the marks."""
        K_error = np.abs(self.at_marks("K") - self.value("vehicle.feedback"))
        true_gains = self.value("vehicle.feedforward")
        Gamma_error = np.abs(self.at_marks("Gamma") - true_gains)
        return np.maximum(K_error.max(axis=2), Gamma_error.max(axis=2))

    def trajectory(self, port: str) -> np.ndarray:
        """Return a state at the scenario's output samples."""
        trajectory = self.states(port)[:, self.varied.times.output]
        if port != "alpha":
            return trajectory
        return trajectory.reshape(*trajectory.shape[:2], 2, -1)

    @cached_property
    def along_tracks(self) -> tuple[np.ndarray, np.ndarray]:
        """Errors of the learned flow in a measured current, and shares of time in a faster flow."""
        varied, run = self.varied, self.run
        count, N = len(run.states), varied.scenario.basis.N
        theta = self.estimates(self.states)
        theta = np.broadcast_to(theta, (count, len(varied.times.union), 2 * N))
        shares, errors = np.full(count, np.nan), np.full(count, np.nan)
        limits = self.values.get("vehicle.max_speed")
        if limits is None:
            limits = np.full(count, varied.scenario.vehicle.max_speed)
        is_limited = varied.scenario.vehicle.max_speed is not None
        nodes = varied.wiring.nodes
        ports = ports_of(
            [label for node in nodes for label in node.system.output_labels]
        )
        groups = self.ensemble.signals(self.members, run)
        tracks = (track for group in groups for track in zip(*group, strict=True))
        for m, track in tracks:
            reached = run.reached[m]
            if reached < 2:
                continue
            times, signals = varied.state_times[:reached], track[:reached]
            flow = signals[:, ports["flow_x"]]
            if is_limited:
                commanded, reference = (signals[:, ports[k]] for k in ("v_c", "zc"))
                limit = float(limits[m])
                figures = speed_figures(limit, times, commanded, flow, reference)
                faster = figures["faster_flow"]
                shares[m] = faster["share"] if faster else 0.0
            if "flow_error" not in varied.absent:
                late = times >= last_quarter(times)
                phi = signals[late][:, ports["phi_x"]]
                estimate = theta[m, :reached][late].reshape(len(phi), 2, -1)
                off = flow[late] - np.einsum("taN,tN->ta", estimate, phi)
                errors[m] = np.sqrt((off**2).sum(axis=1).mean())
        return errors, shares

    def flow_error(self) -> np.ndarray:
        """Return the rms error of the learned flow along the track, at its end."""
        return self.along_tracks[0]

    def share_in_faster_flow(self) -> np.ndarray:
        """Return the share of time in a flow faster than the vehicle."""
        return self.along_tracks[1]
