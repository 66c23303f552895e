"""From fix to fix: what a vehicle knows of its way, and the flow along it.

    y = x(t2) - x(t1) - d(t2) = theta int phi(x(t), t) dt,    d(t) = int v dt since t1

is Eq. (1) with Eq. (3), integrated over a segment: y is its miss, where the vehicle comes up less
where its dead reckoning d has it, and the integral is h, shape (N,).  Where the track x(t) is
unknown it is predicted with an estimate of theta, z' = theta phi(z, t) + v, or the dead-reckoned
track is bent evenly to the fix that it ends at.

A run of a scenario is cut into segments by what its vehicle would know at fixes.
Positions are those of the run's samples.  The velocity through the water is what the blocks of
the vehicle make of them, Eq. (7), so the parameters of the true flow are not read.  Between the
times at which the waypoint changes all is smooth and goes by cubic splines.  How exact the
samples let int v dt be is judged by leaving out every second one: the difference over 15, as the
error of a cubic spline falls with the fourth power of the step.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from scipy.integrate import simpson
from scipy.interpolate import CubicSpline

from ..blocks import speed_limit, vehicle
from ..equations.at_many import evaluate
from ..equations.block import Block
from ..errors import DataError, ScenarioError
from ..geodesy import displacement
from ..scenario.experiment import Scenario
from .dive import Dive, reckoned

if TYPE_CHECKING:
    import xarray

SAMPLES = 129  # of a segment's track, an odd number for Simpson's rule


class Segments(NamedTuple):
    """n segments, each at m times."""

    time: np.ndarray  # (n, m), from fix to fix
    water: np.ndarray  # (n, 2 m - 1, 2), d there and at the times between, length
    start: np.ndarray  # (n, 2), x(t1), length
    end: np.ndarray  # (n, 2), x(t2), length
    track: np.ndarray | None = None  # (n, m, 2), x(t), length; None where it is not known

    @property
    def miss(self) -> np.ndarray:
        """y of each segment, (n, 2), length."""
        return self.end - self.start - self.water[:, -1]

    @property
    def duration(self) -> np.ndarray:
        """Time between the fixes, (n,)."""
        return self.time[:, -1] - self.time[:, 0]

    @property
    def seen(self) -> np.ndarray:
        """The track, or the dead-reckoned one bent evenly to its end, (n, m, 2), length."""
        if self.track is not None:
            return self.track
        share = (self.time - self.time[:, :1]) / self.duration[:, None]
        return self.start[:, None] + self.water[:, ::2] + share[:, :, None] * self.miss[:, None]

    def integrals(self, basis: Block, track: np.ndarray) -> np.ndarray:
        """Return h = int phi(x(t), t) dt along tracks (n, m, 2): shape (n, N), time."""
        n, m = self.time.shape
        phi = evaluate(basis, self.time.ravel(), track.reshape(-1, 2)).reshape(n, m, -1)
        return simpson(phi, dx=1.0, axis=1) * (self.duration / (m - 1))[:, None]

    def predicted(self, basis: Block, theta: np.ndarray) -> np.ndarray:
        """Return tracks z' = theta phi(z, t) + v from the start fixes, (n, m, 2), by RK4.

        The fixes at the ends are not read.
        """
        h = (self.time[:, 1] - self.time[:, 0])[:, None]
        carried = np.zeros((*self.time.shape, 2))  # by the flow: z less start and d

        def flow(k: int, half: int, moved: np.ndarray) -> np.ndarray:
            place = self.start + self.water[:, 2 * k + half] + moved
            return evaluate(basis, self.time[:, k] + 0.5 * half * h[:, 0], place) @ theta.T

        for k in range(self.time.shape[1] - 1):
            u = carried[:, k]
            a = flow(k, 0, u)
            b = flow(k, 1, u + 0.5 * h * a)
            c = flow(k, 1, u + 0.5 * h * b)
            d = flow(k, 2, u + h * c)
            carried[:, k + 1] = u + h * (a + 2 * b + 2 * c + d) / 6
        return self.start[:, None] + self.water[:, ::2] + carried


def dive_segments(dives: Sequence[Dive], origin: tuple[float, float]) -> Segments:
    """Return dives as segments, m and s since 1970, on the plane of an origin (degrees)."""
    share, fine = np.linspace(0.0, 1.0, SAMPLES), np.linspace(0.0, 1.0, 2 * SAMPLES - 1)
    time, water, start = [], [], []
    for dive in dives:
        since, *axes = reckoned(dive)
        time.append(dive.t_gps2 + share * dive.duration)
        way = [np.interp(fine * dive.duration, since, axis) for axis in axes]
        way[0][-1], way[1][-1] = dive.dr_east, dive.dr_north
        water.append(np.stack(way, axis=1))
        start.append(displacement(*origin, dive.lat_gps2, dive.lon_gps2))
    moved = np.array([[dive.gps_east, dive.gps_north] for dive in dives])
    return Segments(np.array(time), np.array(water), np.array(start), np.array(start) + moved)


LEAST = 5  # samples between two changes of the waypoint
MOST_FIXES = 100_000  # of a run
COARSE = 0.05  # of the way through the water between fixes, in the mean; more is refused


class Way:
    """Position and displacement through the water at any time of a run."""

    def __init__(self, run: "xarray.Dataset", scenario: Scenario):
        self.time, places = run.time.values, run.position.values
        self.scenario, self.basis = scenario, scenario.basis_block()
        self.places, self.water = [], []  # splines, one a piece
        self.doubt = 0.0  # of the displacement over a piece, length
        dwell, last = scenario.reference.dwell, self.time[-1]
        jumps = dwell * np.arange(np.floor(self.time[0] / dwell) + 1, np.ceil(last / dwell))
        self.edges = np.array([self.time[0], *jumps[jumps < last * (1 - 1e-12)], last])
        at = np.searchsorted(self.time, self.edges - 1e-9 * dwell).clip(0, len(self.time) - 1)
        if np.any(np.abs(self.time[at] - self.edges) > 1e-6 * dwell):
            raise ScenarioError(
                f"run.output_step: the waypoint changes each {dwell:g} {scenario.units.time}, "
                "between two samples of the run; run it with a step that divides reference.dwell"
            )
        gone = np.zeros(2)
        for a, b in pairwise(at):
            if b - a + 1 < LEAST:
                raise ScenarioError(
                    f"run.output_step: {b - a + 1} samples between two changes of the waypoint; "
                    f"at least {LEAST} are needed, run it with a smaller step"
                )
            t, x = self.time[a : b + 1], places[a : b + 1]
            v = self._velocity(t, x, run.reference.values[a])
            whole, half = CubicSpline(t, v), CubicSpline(t[::2], v[::2])
            apart = whole.integrate(t[0], t[::2][-1]) - half.integrate(t[0], t[::2][-1])
            self.doubt = max(self.doubt, float(np.abs(apart).max()) / 15)
            self.places.append(CubicSpline(t, x))
            self.water.append((whole.antiderivative(), gone))
            gone = gone + whole.integrate(t[0], t[-1])

    def _velocity(self, t: np.ndarray, x: np.ndarray, zc: np.ndarray) -> np.ndarray:
        """Return the velocity through the water at samples with one waypoint, (n, 2)."""
        car = self.scenario.vehicle
        alpha_M = self.scenario.model_parameters
        controller = vehicle.vehicle_controller(alpha_M, car.feedback, car.feedforward)
        phi = evaluate(self.basis, t, x)
        v = evaluate(controller, t, np.hstack([x, 0 * x + zc, phi]))
        if car.max_speed is None:
            return v
        return evaluate(speed_limit.speed_limit(car.max_speed), t, v)

    def at(self, times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return position and displacement since the run's start, (..., 2) each."""
        piece = np.clip(np.searchsorted(self.edges, times, "right") - 1, 0, len(self.places) - 1)
        x, d = np.zeros((*times.shape, 2)), np.zeros((*times.shape, 2))
        for k in np.unique(piece):
            here = piece == k
            whole, gone = self.water[k]
            x[here], d[here] = self.places[k](times[here]), gone + whole(times[here])
        return x, d


def run_segments(
    run: "xarray.Dataset", scenario: Scenario, every: float | None
) -> tuple[Segments, Block, float]:
    """Return the segments of a run, the scenario's basis, and the doubt of a miss, length."""
    if scenario.localization is not None:
        raise ScenarioError(
            "localization: the vehicle of this run does not steer by its true position, so its "
            "velocity is not known from the samples; estimate from a run without the table"
        )
    way, fix = Way(run, scenario), scenario.reference.dwell / 10 if every is None else every
    length = float(way.time[-1] - way.time[0])
    if not 0 < fix <= length:
        raise ScenarioError(
            f"every = {fix:g}: must be positive and at most the run's length, {length:g} "
            f"{scenario.units.time}"
        )
    if length / fix > MOST_FIXES:
        raise ScenarioError(
            f"every = {fix:g}: more than {MOST_FIXES:,} fixes in the run; must be at least "
            f"{length / MOST_FIXES:g} {scenario.units.time}"
        )
    fixes = way.time[0] + fix * np.arange(int(np.floor(length / fix * (1 + 1e-12))) + 1)
    fine = fixes[:-1, None] + fix * np.linspace(0.0, 1.0, 2 * SAMPLES - 1)
    x, d = way.at(np.minimum(fine, way.time[-1]))
    segments = Segments(fine[:, ::2], d - d[:, :1], x[:, 0], x[:, -1], x[:, ::2])
    moved = np.sqrt(np.mean(np.sum((d[:, -1] - d[:, 0]) ** 2, axis=1)))
    if way.doubt > COARSE * moved:
        raise DataError(
            f"the run's samples let the way through the water be known to {way.doubt:.2g} "
            f"{scenario.units.length} only; run it with a smaller run.output_step"
        )
    return segments, way.basis, way.doubt


def run_scenario(run: "xarray.Dataset") -> Scenario:
    """Return the scenario that a run carries."""
    from ..scenario.file import CHANGED, OWN_PARTS, scenario_of_run

    attributes = run.attrs
    if CHANGED in attributes:
        raise DataError(
            f"the run was made with parameters that its scenario does not hold, "
            f"{attributes[CHANGED]}, so its vehicle is not known; estimate from a run without them"
        )
    if OWN_PARTS in attributes:
        raise DataError(
            f"the run was made with parts given in Python, {attributes[OWN_PARTS]}, so its vehicle "
            "is not known; estimate from a run without them"
        )
    scenario = scenario_of_run(run)
    if run.sizes.get("time", 0) < 2:
        raise DataError("the run has fewer than two samples; run it with a smaller output_step")
    for name in ("time", "position", "reference"):
        if name not in run or not np.all(np.isfinite(run[name].values)):
            raise DataError(f"the run has no whole {name}; clpt.simulate gives runs that do")
    return scenario
