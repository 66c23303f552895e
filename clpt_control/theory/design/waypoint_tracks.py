"""Waypoint tracks with their excitation and limits, many tracks per batch.

    x' = F_R(x, t) + v                                              Eqs. (1), (7)
    w  = [phi(x), x_i, zc_i],    kappa_1 = min_i lambda_min(int w w^T dt)

For a linear law with gains, the worst-case drop of V of Eq. (24) over the window,
1 - |Phi|^2 in the units of V (`certificates`), replaces kappa_1.  W of Eq. (31) contains z,
which depends on the law.  Every law that converges ends at e = 0, z = x, where W depends on the
vehicle alone.  Therefore the vehicle's blocks run without the learner, disturbance and noise.
All tracks run in one compiled diagram.  Limits are the closed length sum_j |w_{j+1} - w_j|, the
speed |v_x| of Eq. (7), and a box for waypoints and vehicle.
"""

from typing import Any, NamedTuple

import numpy as np

from ...base.errors import ScenarioError
from ...engine.codegen.machine import LANES
from ...engine.diagram.interconnection import wiring_of_blocks
from ...engine.model.block import evaluate
from ...engine.solver.batch import Batch
from ...engine.solver.native_diagram import NativeDiagram
from ...engine.solver.runner import RunOptions
from ...paper.laws.law import LEARNED
from ...paper.scenario.experiment import Scenario
from ...simulation.initial_states import state_of
from ...simulation.loops import ClosedLoop
from ..excitation.certificates import worst_drop
from ..excitation.regressor import eigenvalues_of, quadrature, w_along, waypoint_in

ATOL = 1e-2  # absolute tolerance over the relative one
LEARNER = ("z", "e", *LEARNED)  # signals of the learner, which does not run
SPEED_BLOCKS = ("basis_x", "vehicle_controller", "speed_limit")
BATCH_BYTES = 20_000_000  # largest array of a batch


class Extremes(NamedTuple):
    """Largest speed and positions of m tracks in each piece; NaN if a run failed."""

    speed: np.ndarray  # (m, pieces), |v_x|, length per time; NaN if not computed
    low: np.ndarray  # (m, pieces, 2), positions, length
    high: np.ndarray  # (m, pieces, 2)


class Tracks:
    """Batch simulator of the vehicle on tracks with the scenario's count and dwell.

    Runs end at `end` and have `samples` per piece for the extremes.  `window` is the length and
    start of the Gramian; `gains` are the N + 2 of a linear law, whose drop of V replaces kappa_1.
    """

    def __init__(
        self,
        scenario: Scenario,
        window: tuple[float, float],
        end: float,
        samples: int,
        rtol: float,
        with_speed: bool = True,
        gains: np.ndarray | None = None,
    ):
        self.scenario = vehicle_alone(scenario)
        self.rtol = rtol
        self.with_speed = with_speed
        self.gains = gains
        self.runs = 0
        loop = ClosedLoop(self.scenario, external=LEARNER)
        self.blocks: list[Any] = loop.blocks()
        self.native = NativeDiagram(wiring_of_blocks(self.blocks))
        self.callee = self.native.callee(self.native.lanes(LANES))
        self.basis = self.scenario.basis_block()
        self.schedule = self.native.schedule((0.0, end))
        self.initial_state = state_of(self.scenario, self.blocks)
        cuts, self.nodes, self.weights = quadrature(
            self.scenario, window[1], sum(window)
        )
        edges, _, _ = quadrature(self.scenario, 0.0, end)
        self.samples = np.linspace(edges[:-1], edges[1:], samples, axis=1)
        times = np.concatenate([self.nodes.ravel(), self.samples.ravel()])
        self.times, self.index = np.unique(times, return_inverse=True)
        self.node_waypoint = waypoint_in(self.scenario, cuts)[:, None]
        self.sample_waypoint = waypoint_in(self.scenario, edges)[:, None]

    def __call__(self, waypoints: np.ndarray) -> tuple[np.ndarray, Extremes]:
        """Return kappa_1 or the drop of V, (2, m), and the extremes of tracks (m, n, 2)."""
        numbers = len(self.times)
        numbers += self.nodes.size * (self.scenario.basis.N + 2)
        size = max(8, BATCH_BYTES // (16 * numbers))
        batches = np.split(waypoints, range(size, len(waypoints), size))
        kappa, extremes = zip(*map(self._run, batches), strict=True)
        fields = map(np.concatenate, zip(*extremes, strict=True))
        return np.concatenate(kappa, axis=1), Extremes(*fields)

    def _run(self, waypoints: np.ndarray) -> tuple[np.ndarray, Extremes]:
        """Return the results of one batch of tracks."""
        m = len(waypoints)
        self.runs += m
        states = np.tile(self.initial_state, (m, 1))
        parameters = self._parameters(waypoints)
        batch = Batch(self.callee, states, parameters, self.times, [self.schedule])
        batch.finish(RunOptions(self.rtol, ATOL * self.rtol))
        x = batch.out[:, self.index]
        nodes, samples = np.split(x, [self.nodes.size], axis=1)
        nodes = nodes.reshape(m, *self.nodes.shape, 2)
        samples = samples.reshape(m, *self.samples.shape, 2)
        kappa = self._kappa(nodes, waypoints)
        return kappa, self._extremes(samples, waypoints)

    def _parameters(self, waypoints: np.ndarray) -> np.ndarray:
        """Return the parameters of the diagram with the waypoints of each track."""
        parameters = np.tile(self.native.parameters(), (len(waypoints), 1))
        reference = [block.name for block in self.blocks].index("reference")
        for i, field in enumerate(("x1", "x2")):
            array, start = self.native.layout.slots[reference, field]
            # a long list of waypoints is a constant table, not parameters
            if array == "P":
                columns = slice(start, start + waypoints.shape[1])
                parameters[:, columns] = waypoints[..., i]
        return parameters

    def _kappa(self, x: np.ndarray, waypoints: np.ndarray) -> np.ndarray:
        """Return kappa_1 of each axis or the drop of V; 0 if the run failed."""
        zc = waypoints[:, self.node_waypoint]
        w = np.nan_to_num(w_along(self.basis, self.nodes, x, x, zc))
        if self.gains is None:
            kappa = eigenvalues_of(w, self.weights)[..., 0]
        else:
            k = np.array(self.scenario.vehicle.feedback)[:, None]
            kappa, _ = worst_drop(w, k, self.gains, self.weights)
        finite = np.isfinite(x).all(axis=(1, 2, 3))
        return np.where(finite, kappa, 0.0)

    def _extremes(self, x: np.ndarray, waypoints: np.ndarray) -> Extremes:
        """Return the extremes of positions x and of the commanded speed there."""
        speed = np.full(x.shape[:-1], np.nan)
        if self.with_speed:
            speed = self._speed(x, waypoints)
        return Extremes(speed=speed.max(axis=2), low=x.min(axis=2), high=x.max(axis=2))

    def _speed(self, x: np.ndarray, waypoints: np.ndarray) -> np.ndarray:
        """Return |v_x| at positions x (m, pieces, samples, 2)."""
        zc = np.broadcast_to(waypoints[:, self.sample_waypoint], x.shape)
        times = np.broadcast_to(self.samples, x.shape[:-1]).ravel()
        signals = {"x": x.reshape(-1, 2), "zc": zc.reshape(-1, 2)}
        for block in self.blocks:  # in order of evaluation
            if block.name in SPEED_BLOCKS:
                inputs = [signals[port] for port in block.input_ports]
                (port,) = block.output_ports
                signals[port] = evaluate(block, times, np.hstack(inputs))
        v_x = signals["v_x"]
        return np.hypot(v_x[:, 0], v_x[:, 1]).reshape(x.shape[:-1])


def with_waypoints(scenario: Scenario, waypoints: np.ndarray) -> Scenario:
    """Return the scenario with new waypoints of the same dwell."""
    reference = {
        "kind": "waypoints",
        "points": np.asarray(waypoints).tolist(),
        "dwell": scenario.reference.dwell,
    }
    return scenario.with_values({"reference": reference})


def vehicle_alone(scenario: Scenario) -> Scenario:
    """Return the scenario without noise and disturbance, with a list of waypoints.

    The learner is replaced by a plain one, because it does not run at e = 0.
    """
    learner = {"law": "learned-flow", "gain": 1.0}
    calm = {"flow.disturbance": None, "localization": None, "learning": learner}
    return with_waypoints(scenario.with_values(calm), scenario.waypoints)


MARGIN = 1e-3  # share of a limit that stays free between the samples
PADDING = 0.01  # of the default area, share of its size
Box = tuple[float, float, float, float]


class Limits(NamedTuple):
    """Limits of a track: closed length, speed and the corners of the area."""

    length: float
    max_speed: float | None  # None: any
    low: np.ndarray  # (2,)
    high: np.ndarray

    def tighter(self, share: float) -> "Limits":
        """Return limits that leave a share of speed and area free."""
        border = share * (self.high - self.low)
        speed = self.max_speed
        return self._replace(
            max_speed=None if speed is None else (1 - share) * speed,
            low=self.low + border,
            high=self.high - border,
        )

    def excess(self, extremes: Extremes) -> np.ndarray:
        """Return the largest relative excess of each track, 1 if its run failed."""
        excess = np.maximum(-self.slack(extremes).min(axis=0), 0.0)
        return np.where(np.isfinite(excess), excess, 1.0)

    def slack(self, extremes: Extremes) -> np.ndarray:
        """Return the relative distances to the limits, piece by piece, (k, m)."""
        size = self.high - self.low
        slacks = [(extremes.low - self.low) / size, (self.high - extremes.high) / size]
        if self.max_speed is not None:
            slacks.append(1 - extremes.speed[..., None] / self.max_speed)
        rows = [slack.reshape(len(slack), -1) for slack in slacks]
        return np.concatenate(rows, axis=1).T


def closed_length(waypoints: np.ndarray) -> np.ndarray:
    """Return the length of closed polygons, (..., n, 2) -> (...)."""
    legs = np.roll(waypoints, -1, axis=-2) - waypoints
    return np.linalg.norm(legs, axis=-1).sum(axis=-1)


def shortened(waypoints: np.ndarray, length: float) -> np.ndarray:
    """Return closed polygons, those longer than `length` shrunk about their mean."""
    center = waypoints.mean(axis=-2, keepdims=True)
    scale = length / np.maximum(closed_length(waypoints), 1e-300)
    scale = np.where(scale < 1, scale * (1 - 1e-13), 1.0)[..., None, None]
    return center + scale * (waypoints - center)


def corners(
    scenario: Scenario, area: Box | None, extremes: Extremes
) -> tuple[np.ndarray, np.ndarray]:
    """Return the corners of an area, by default of the padded box of the track."""
    if area is not None:
        low, high = np.reshape(area, (2, 2)).T
        position = np.array(scenario.vehicle.position)
        inside = np.all((low <= position) & (position <= high))
        if not (np.all(low < high) and inside):
            raise ScenarioError(
                f"area = {area}: must be x1 from and to, x2 from and to, {scenario.units.length}, "
                "each pair increasing, with vehicle.position in it"
            )
        return low, high
    low = np.vstack([scenario.waypoints, extremes.low[0]]).min(axis=0)
    high = np.vstack([scenario.waypoints, extremes.high[0]]).max(axis=0)
    border = PADDING * np.maximum(high - low, 1e-9 + 1e-9 * np.abs(high))
    return low - border, high + border
