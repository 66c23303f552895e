"""Many tracks of waypoints at once, where nothing is left to learn: e = 0, z = x.

    x' = F_R(x, t) + v                                              Eqs. (1), (7)
    w  = [phi(x), x_i, zc_i],    kappa_1 = min_i lambda_min(int w w^T dt)

or, in place of kappa_1, what V of Eq. (24) falls by at worst over the window with the gains of a
linear law, 1 - |Phi|^2 in the units of V (`certificates`).

W of Eq. (31) holds z, which depends on the law.  Every law that works ends at e = 0, where W
depends on the vehicle alone; so the vehicle's own blocks are run, without the learner, and
without disturbance and noise of the position, which nobody knows beforehand.  Tracks are members
of one compiled diagram: only the waypoints in its parameters differ.
"""

from typing import Any, NamedTuple

import numpy as np

from ...blocks.laws.law import LEARNED
from ...diagrams.interconnection import wiring_of_blocks
from ...equations.at_many import evaluate
from ...native.batch import Batch
from ...native.machine import LANES
from ...native.native_diagram import NativeDiagram
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

    speed: np.ndarray  # (m, pieces), largest |v_x|, length per time; NaN where it is not asked
    low: np.ndarray  # (m, pieces, 2), of the vehicle's positions, length
    high: np.ndarray  # (m, pieces, 2)
    share: np.ndarray  # (m,), of the time that was reached


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
        self.blocks: list[Any] = remaining_parts(*LoopOf(self.scenario, external=LEARNER))[0]
        self.native = NativeDiagram(wiring_of_blocks(self.blocks))
        self.callee = self.native.callee(self.native.lanes(LANES))
        self.schedule = self.native.schedule((0.0, end))
        self.start = state_of(self.scenario, self.blocks)
        self.gains = gains
        cuts, self.nodes, self.weights = quadrature(self.scenario, window[1], sum(window))
        edges, _, _ = quadrature(self.scenario, 0.0, end)
        self.looks = edges[:-1, None] + np.diff(edges)[:, None] * np.linspace(0.0, 1.0, looks)
        times = np.concatenate([[0.0], self.nodes.ravel(), self.looks.ravel(), [end]])
        self.times, self.place = np.unique(times, return_inverse=True)
        self.waypoint_of_node = waypoint_in(self.scenario, cuts)
        self.waypoint_of_look = waypoint_in(self.scenario, edges)

    def __call__(self, points: np.ndarray) -> tuple[np.ndarray, Extremes]:
        """Return kappa_1 or the drop of V, (2, m), and the extremes of tracks (m, n, 2)."""
        size = 16 * self.nodes.size * (self.scenario.basis.N + 2) + 16 * len(self.times)
        together = max(8, BYTES // size)
        parts = [self._together(points[k : k + together]) for k in range(0, len(points), together)]
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
        share = self.times[np.clip(batch.reached - 1, 0, None)] / self.end
        return (
            self._least(nodes.reshape(m, *self.nodes.shape, 2), points),
            self._extremes(looks.reshape(m, *self.looks.shape, 2), points, share),
        )

    def _parameters(self, points: np.ndarray) -> np.ndarray:
        P = np.tile(self.native.parameters(), (len(points), 1))
        names = [block.name for block in self.blocks]
        for i, field in enumerate(("x1", "x2")):  # a table, of more waypoints than are designed
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

    def _extremes(self, x: np.ndarray, points: np.ndarray, share: np.ndarray) -> Extremes:
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
        return Extremes(speed.max(axis=2), x.min(axis=2), x.max(axis=2), share)


def with_waypoints(scenario: Scenario, points: np.ndarray) -> Scenario:
    """Return the scenario with other waypoints, each held as long as its own."""
    dwell = scenario.reference.dwell
    reference = {"kind": "waypoints", "points": np.asarray(points).tolist(), "dwell": dwell}
    return scenario.with_values({"reference": reference})


def vehicle_alone(scenario: Scenario) -> Scenario:
    """Return the scenario with nothing that is random, waypoints as a list, and any learner.

    The learner is not run, not even one by which the vehicle steers, since e = 0.
    """
    learner = {"law": "learned-flow", "gain": 1.0}
    calm = {"flow.disturbance": None, "localization": None, "learning": learner}
    return with_waypoints(scenario.with_values(calm), scenario.waypoints)
