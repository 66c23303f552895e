"""Many tracks of waypoints at once, where nothing is left to learn: e = 0, z = x.

    x' = F_R(x, t) + v                                              Eqs. (1), (7)
    w  = [phi(x), x_i, zc_i],    kappa_1 = min_i lambda_min(int w w^T dt)

or, in place of kappa_1, what V of Eq. (24) falls by at worst over the window with the gains of a
linear law, 1 - |Phi|^2 in the units of V (`certificates`).

W of Eq. (31) holds z, which depends on the law.  Every law that works ends at e = 0, where W
depends on the vehicle alone; so the vehicle's own blocks are run, without the learner, and
without disturbance and noise of the position, which nobody knows beforehand.  Tracks are members
of one compiled diagram: only the waypoints in its parameters differ.

The limits of a design: closed length, speed through the water, area.

length   sum_j |w_{j+1} - w_j| once around, at most; longer polygons shrink about their middle
speed    |v_x| of Eq. (7), at most, at all times of the run
area     a box that waypoints and vehicle stay in, at all times of the run
"""

from typing import Any, NamedTuple

import numpy as np

from ...blocks.laws.law import LEARNED
from ...engine.codegen.machine import LANES
from ...engine.diagram.interconnection import wiring_of_blocks
from ...engine.model.block import evaluate
from ...engine.solver.batch import Batch
from ...engine.solver.native_diagram import NativeDiagram
from ...errors import ScenarioError
from ...scenario.experiment import Scenario
from ...simulation.loops import LoopOf, remaining_parts
from ...simulation.starts import state_of
from ..excitation.certificates import smallest_eigenvalue, worst_drop
from ..excitation.regressor import quadrature, w_along, waypoint_in

ATOL = 1e-2  # absolute tolerance over the relative one
LEARNER = ("z", "e", *LEARNED)  # the vehicle alone is what feeds none of them
BYTES = 20_000_000  # of one array of tracks that are taken together


class Extremes(NamedTuple):
    """The farthest that each of m tracks goes in each piece; NaN where a run failed."""

    # (m, pieces), largest |v_x|, length per time; NaN where it is not asked
    speed: np.ndarray
    low: np.ndarray  # (m, pieces, 2), of the vehicle's positions, length
    high: np.ndarray  # (m, pieces, 2)


class Tracks:
    """The vehicle of a scenario on tracks of as many waypoints, each held as long as its own.

    It is watched from 0 to `end`, at `looks` times in each piece, its speed where `speeds` asks;
    `window` is length and start of the Gramian's; `gains` are the N + 2 of a linear law whose
    contraction takes the place of kappa_1.
    """

    def __init__(
        self,
        scenario: Scenario,
        window: tuple[float, float],
        end: float,
        looks: int,
        rtol: float,
        speeds: bool = True,
        gains: np.ndarray | None = None,
    ):
        self.scenario = vehicle_alone(scenario)
        self.end, self.rtol, self.speeds, self.runs = end, rtol, speeds, 0
        self.blocks: list[Any] = remaining_parts(
            *LoopOf(self.scenario, external=LEARNER)
        )[0]
        self.native = NativeDiagram(wiring_of_blocks(self.blocks))
        self.callee = self.native.callee(self.native.lanes(LANES))
        self.schedule = self.native.schedule((0.0, end))
        self.start = state_of(self.scenario, self.blocks)
        self.gains = gains
        cuts, self.nodes, self.weights = quadrature(
            self.scenario, window[1], sum(window)
        )
        edges, _, _ = quadrature(self.scenario, 0.0, end)
        self.looks = edges[:-1, None] + np.diff(edges)[:, None] * np.linspace(
            0.0, 1.0, looks
        )
        times = np.concatenate([[0.0], self.nodes.ravel(), self.looks.ravel(), [end]])
        self.times, self.place = np.unique(times, return_inverse=True)
        self.waypoint_of_node = waypoint_in(self.scenario, cuts)
        self.waypoint_of_look = waypoint_in(self.scenario, edges)

    def __call__(self, points: np.ndarray) -> tuple[np.ndarray, Extremes]:
        """Return kappa_1 or the drop of V, (2, m), and the extremes of tracks (m, n, 2)."""
        size = 16 * self.nodes.size * (self.scenario.basis.N + 2) + 16 * len(self.times)
        together = max(8, BYTES // size)
        parts = [
            self._together(points[k : k + together])
            for k in range(0, len(points), together)
        ]
        sizes, extremes = zip(*parts, strict=True)
        fields = map(np.concatenate, zip(*extremes, strict=True))
        return np.concatenate(sizes, axis=1), Extremes(*fields)

    def _together(self, points: np.ndarray) -> tuple[np.ndarray, Extremes]:
        m = len(points)
        self.runs += m
        batch = Batch(
            self.callee,
            np.tile(self.start, (m, 1)),
            self._parameters(points),
            self.times,
            [self.schedule],
        )
        batch.adaptive(self.rtol, ATOL * self.rtol)
        x = batch.out[:, self.place]
        nodes, looks = np.split(x[:, 1:-1], [self.nodes.size], axis=1)
        return (
            self._least(nodes.reshape(m, *self.nodes.shape, 2), points),
            self._extremes(looks.reshape(m, *self.looks.shape, 2), points),
        )

    def _parameters(self, points: np.ndarray) -> np.ndarray:
        P = np.tile(self.native.parameters(), (len(points), 1))
        names = [block.name for block in self.blocks]
        for i, field in enumerate(("x1", "x2")):
            # a table, of more waypoints than are designed
            array, place = self.native.layout.slots[names.index("reference"), field]
            if array == "P":
                P[:, place : place + points.shape[1]] = points[:, :, i]
        return P

    def _least(self, x: np.ndarray, points: np.ndarray) -> np.ndarray:
        """Return the smallest eigenvalue of each axis or the drop of V, 0 where the run failed."""
        times = np.broadcast_to(self.nodes, x.shape[:-1])
        zc = np.broadcast_to(points[:, self.waypoint_of_node, None], x.shape)
        w = np.nan_to_num(w_along(self.scenario, times, x, x, zc))
        k = np.array(self.scenario.vehicle.feedback)
        if self.gains is None:
            sizes = smallest_eigenvalue(w, self.weights)
        else:
            sizes = worst_drop(w, k[:, None], self.gains, self.weights)
        return np.where(np.isfinite(x).all(axis=(1, 2, 3)), sizes, 0.0)

    def _extremes(self, x: np.ndarray, points: np.ndarray) -> Extremes:
        speed = np.full(x.shape[:-1], np.nan)
        if self.speeds:
            zc = np.broadcast_to(points[:, self.waypoint_of_look, None], x.shape)
            times = np.broadcast_to(self.looks, x.shape[:-1]).ravel()
            ports = {"x": x.reshape(-1, 2), "zc": zc.reshape(-1, 2)}
            for block in self.blocks:  # in their order
                if block.name in ("basis_x", "vehicle_controller", "speed_limit"):
                    inputs = [ports[port] for port in block.input_ports]
                    (made,) = block.output_ports
                    ports[made] = evaluate(block, times, np.concatenate(inputs, axis=1))
            speed = np.hypot(*ports["v_x"].T).reshape(x.shape[:-1])
        return Extremes(speed.max(axis=2), x.min(axis=2), x.max(axis=2))


def with_waypoints(scenario: Scenario, points: np.ndarray) -> Scenario:
    """Return the scenario with other waypoints, each held as long as its own."""
    dwell = scenario.reference.dwell
    reference = {
        "kind": "waypoints",
        "points": np.asarray(points).tolist(),
        "dwell": dwell,
    }
    return scenario.with_values({"reference": reference})


def vehicle_alone(scenario: Scenario) -> Scenario:
    """Return the scenario with nothing that is random, waypoints as a list, and any learner.

    The learner is not run, not even one by which the vehicle steers, since e = 0.
    """
    learner = {"law": "learned-flow", "gain": 1.0}
    calm = {"flow.disturbance": None, "localization": None, "learning": learner}
    return with_waypoints(scenario.with_values(calm), scenario.waypoints)


MARGIN = 1e-3  # of a limit, kept free between the times at which it is looked at
WIDER = 0.01  # than what the scenario's own track fills, where no area is given
Box = tuple[float, float, float, float]


class Limits(NamedTuple):
    """What a track must keep to."""

    length: float
    max_speed: float | None  # None: any
    low: np.ndarray  # (2,), corners of the area
    high: np.ndarray

    def tighter(self, part: float) -> "Limits":
        """Return limits for speed and path that leave a part of each free."""
        more = part * (self.high - self.low)
        speed = None if self.max_speed is None else (1 - part) * self.max_speed
        return Limits(self.length, speed, self.low + more, self.high - more)

    def excess(self, extremes: Extremes) -> np.ndarray:
        """Return how far tracks go beyond, as a share of the limit; 0 where they keep to it.

        A run that failed counts 1.
        """
        found = np.maximum(-self.slack(extremes).min(axis=0), 0.0)
        return np.where(np.isfinite(found), found, 1.0)

    def slack(self, extremes: Extremes) -> np.ndarray:
        """Return how far tracks stay within, piece by piece, shares of the limits, (k, m)."""
        size = self.high - self.low
        rows = [(extremes.low - self.low) / size, (self.high - extremes.high) / size]
        if self.max_speed is not None:
            rows.append(1 - extremes.speed[..., None] / self.max_speed)
        return np.concatenate([row.reshape(len(row), -1) for row in rows], axis=1).T


def closed_length(points: np.ndarray) -> np.ndarray:
    """Return the length of closed polygons, (..., n, 2) -> (...)."""
    return np.linalg.norm(np.roll(points, -1, axis=-2) - points, axis=-1).sum(axis=-1)


def shortened(points: np.ndarray, length: float) -> np.ndarray:
    """Return closed polygons; those longer than `length` are shrunk about their middle."""
    middle = points.mean(axis=-2, keepdims=True)
    share = np.minimum(1.0, length / np.maximum(closed_length(points), 1e-300))
    share = np.where(share < 1, share * (1 - 1e-13), 1.0)[..., None, None]
    return middle + share * (points - middle)


def corners(
    scenario: Scenario, area: Box | None, extremes: Extremes
) -> tuple[np.ndarray, np.ndarray]:
    """Return the corners of an area; by default what the track fills and more."""
    if area is not None:
        low, high = np.reshape(area, (2, 2)).T
        place = np.array(scenario.vehicle.position)
        if not (np.all(low < high) and np.all((low <= place) & (place <= high))):
            raise ScenarioError(
                f"area = {area}: must be x1 from and to, x2 from and to, {scenario.units.length}, "
                "each pair increasing, with vehicle.position in it"
            )
        return low, high
    points = scenario.waypoints
    low = np.minimum(points.min(axis=0), extremes.low[0].min(axis=0))
    high = np.maximum(points.max(axis=0), extremes.high[0].max(axis=0))
    more = WIDER * np.maximum(high - low, 1e-9 + 1e-9 * np.abs(high))
    return low - more, high + more
