"""From fix to fix: what a vehicle knows of its way, and the flow along it.

    y = x(t2) - x(t1) - d(t2) = theta int phi(x(t), t) dt,    d(t) = int v dt since t1

is Eq. (1) with Eq. (3), integrated over a segment: y is its miss, where the vehicle comes up less
where its dead reckoning d has it, and the integral is h, shape (N,).  Where the track x(t) is
unknown it is predicted with an estimate of theta, z' = theta phi(z, t) + v, or the dead-reckoned
track is bent evenly to the fix that it ends at.

A run of a scenario is cut into segments by what its vehicle would know at fixes.
Positions are those of the run's samples, with `localization.noise` as the vehicle reads them.  The
velocity through the water is what the blocks of the vehicle make of them, Eq. (7), so the
parameters of the true flow are not read.  Between the times at which the waypoint or the noise
changes all is smooth and goes by cubic splines.  How exact the samples let int v dt be is judged
by leaving out every second one: the difference over 15, as the error of a cubic spline falls with
the fourth power of the step.

Neighbouring segments share a fix, and with it its noise: y_s has n(end) - n(start).
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import xarray
from scipy.integrate import simpson
from scipy.interpolate import CubicSpline

from ...base.errors import DataError, ScenarioError
from ...base.geodesy import displacement
from ...engine.model.block import Block, evaluate
from ...engine.model.declaration import multiples
from ...paper.blocks import vehicle
from ...paper.scenario.experiment import Scenario
from ...paper.scenario.recorded_run import check_run
from .dive import Dive, reckoned

# of a segment; every second is of its track, for Simpson
SHARES = np.linspace(0.0, 1.0, 257)


class Segments(NamedTuple):
    """n segments, each at m times."""

    time: np.ndarray  # (n, m), from fix to fix
    water: np.ndarray  # (n, 2 m - 1, 2), d there and at the times between, length
    start: np.ndarray  # (n, 2), x(t1), length
    end: np.ndarray  # (n, 2), x(t2), length
    # (n, m, 2), x(t), length; None where it is not known
    track: np.ndarray | None = None
    # most error that a miss has alone, length; its fixes have what is beyond
    alone: float = np.inf
    # how long one noise of the track's reading lasts; 0: without noise
    noise_period: float = 0.0

    @property
    def miss(self) -> np.ndarray:
        """y of each segment, (n, 2), length."""
        return self.end - self.start - self.water[:, -1]

    @property
    def duration(self) -> np.ndarray:
        """Time between the fixes, (n,)."""
        return self.time[:, -1] - self.time[:, 0]

    @property
    def renewed(self) -> np.ndarray:
        """Whether the noise at the end is another than at the start, (n,)."""
        if not self.noise_period:
            return np.ones(len(self.time), dtype=bool)
        return np.ptp(self._noises(), axis=1) > 0

    def _noises(self) -> np.ndarray:
        """Return the number of the noise at each time, (n, m); one that begins last is not read."""
        near = 1e-9 * self.noise_period
        return (
            np.minimum(self.time + near, self.time[-1, -1] - near) // self.noise_period
        )

    def blur(self, basis: Block) -> np.ndarray:
        """Return B, (n, N, N): read with noise s, theta h has the variance s^2 theta B theta^T.

        B = sum over axes i and noises of g g^T/l, g = int dphi/dx_i dt while one noise lasts, l
        the share of its samples that are in this segment.  One noise in several segments is one
        error of them all; B as if each had its own bounds it, as (sum a)^2 <= sum a^2/l.
        """
        n, m = self.time.shape
        if not self.noise_period:
            return np.zeros((n, *2 * [sum(basis.output_ports.values())]))
        track, step = self.known_track, 1e-4 * np.ptp(self.known_track) * np.eye(2)
        ahead, behind = (
            [
                evaluate(basis, self.time.ravel(), (track + one).reshape(-1, 2))
                for one in moves
            ]
            for moves in (step, -step)
        )
        slope = np.stack(ahead, axis=1) - np.stack(behind, axis=1)
        slope *= np.repeat(self.duration / m, m)[:, None, None] / (2 * step[0, 0])
        noises = self._noises()
        new = np.diff(noises, axis=1, prepend=-1.0) != 0
        first = np.flatnonzero(new)
        g, here = np.add.reduceat(slope, first, axis=0), np.diff(first, append=n * m)
        which = np.unique(noises[new], return_inverse=True)[1]
        g *= np.sqrt(np.bincount(which, here)[which] / here)[:, None, None]
        B = np.zeros((n, g.shape[-1], g.shape[-1]))
        np.add.at(B, np.nonzero(new)[0], np.einsum("gik,gil->gkl", g, g))
        return B

    def shares(self, r: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the shares of r^2 that a miss has alone, and that each of its fixes has, (n,)."""
        alone = np.minimum(1.0, self.alone / r) ** 2
        return alone, (1 - alone) / 2

    @property
    def known_track(self) -> np.ndarray:
        """The track, or the dead-reckoned one bent evenly to its end, (n, m, 2), length."""
        if self.track is not None:
            return self.track
        share = (self.time - self.time[:, :1]) / self.duration[:, None]
        return (
            self.start[:, None]
            + self.water[:, ::2]
            + share[:, :, None] * self.miss[:, None]
        )

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
            return (
                evaluate(basis, self.time[:, k] + 0.5 * half * h[:, 0], place) @ theta.T
            )

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
    time, water, start = [], [], []
    for dive in dives:
        since, *axes = reckoned(dive)
        time.append(dive.t_gps2 + SHARES[::2] * dive.duration)
        way = [np.interp(SHARES * dive.duration, since, axis) for axis in axes]
        way[0][-1], way[1][-1] = dive.dr_east, dive.dr_north
        water.append(np.stack(way, axis=1))
        start.append(displacement(*origin, dive.lat_gps2, dive.lon_gps2))
    moved = np.array([[dive.gps_east, dive.gps_north] for dive in dives])
    return Segments(
        np.array(time), np.array(water), np.array(start), np.array(start) + moved
    )


LEAST = 5  # samples between two changes of the waypoint, or of the noise
MOST_FIXES = 100_000  # of a run
# of the way through the water between fixes, in the mean; more is refused
COARSE = 0.05


class RunTrack:
    """Position and displacement through the water at any time of a run."""

    def __init__(self, run: xarray.Dataset, scenario: Scenario):
        self.time, places = run.time.values, run.position.values
        basis = scenario.basis_block()
        self.places, self.water = [], []  # splines, one a piece
        self.doubt = 0.0  # of the displacement over a piece, length
        self.periods = {"waypoint": scenario.reference.dwell}  # how long what lasts
        read = places
        if scenario.localization is not None:
            self.periods["noise"] = float(scenario.localization.noise_period or 0)
            read = run.measured_position.values
        self.near = 1e-9 * min(self.periods.values())
        first, last = self.time[0], self.time[-1]
        inner = np.concatenate(
            [multiples(span, first, last) for span in self.periods.values()]
        )
        inner = np.sort(inner[(inner > first + self.near) & (inner < last - self.near)])
        apart = np.diff(inner, prepend=first) > self.near
        self.edges = np.array([first, *inner[apart], last])
        at = np.searchsorted(self.time, self.edges - self.near).clip(
            0, len(self.time) - 1
        )
        beside = np.abs(self.time[at] - self.edges) > 1e3 * self.near
        if beside.any() or np.diff(at).min() + 1 < LEAST:
            unit = scenario.units.time
            each = (f"{w} each {span:g} {unit}" for w, span in self.periods.items())
            spans = " and the ".join(each)
            raise ScenarioError(
                f"run.output_step: there change the {spans}; run it with a "
                f"step that divides that into {LEAST} samples at least"
            )
        every = np.concatenate([np.arange(a, b + 1) for a, b in pairwise(at)])
        # a piece ends with the noise it began with
        began = np.repeat(at[:-1], np.diff(at) + 1)
        x = places[every] + (read - places)[began]
        t, car = self.time[every], scenario.vehicle
        gains = scenario.model_parameters, car.feedback, car.feedforward
        seen = np.hstack([x, run.reference.values[began], evaluate(basis, t, x)])
        way = evaluate(vehicle.vehicle_controller(*gains), t, seen)  # through the water
        if car.max_speed is not None:
            way = evaluate(vehicle.speed_limit(car.max_speed), t, way)
        gone = np.zeros(2)
        for rows in np.split(np.arange(len(every)), np.flatnonzero(np.diff(began)) + 1):
            t, v = self.time[every[rows]], way[rows]
            whole, half = CubicSpline(t, v), CubicSpline(t[::2], v[::2])
            span = t[0], t[::2][-1]
            apart = whole.integrate(*span) - half.integrate(*span)
            self.doubt = max(self.doubt, float(np.abs(apart).max()) / 15)
            self.places.append(CubicSpline(t, x[rows]))
            self.water.append((whole.antiderivative(), gone))
            gone = gone + whole.integrate(t[0], t[-1])

    def at(self, times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the position as read and the displacement since the start, (..., 2) each."""
        piece = np.searchsorted(self.edges, times + self.near, "right") - 1
        piece = np.clip(piece, 0, len(self.places) - 1)
        x, d = np.zeros((*times.shape, 2)), np.zeros((*times.shape, 2))
        for k in np.unique(piece):
            here = piece == k
            whole, gone = self.water[k]
            x[here], d[here] = self.places[k](times[here]), gone + whole(times[here])
        return x, d


def run_segments(
    run: xarray.Dataset, scenario: Scenario, every: float | None
) -> Segments:
    """Return the segments of a run."""
    if scenario.localization is not None and scenario.localization.fixes is not None:
        raise ScenarioError(
            "localization.interval: the vehicle of this run steers on its prediction between "
            "fixes, so its velocity is not known; estimate from a run with interval = 0"
        )
    track, fix = (
        RunTrack(run, scenario),
        scenario.reference.dwell / 10 if every is None else every,
    )
    length = float(track.time[-1] - track.time[0])
    if not max(0.0, length / MOST_FIXES) < fix <= length:
        raise ScenarioError(
            f"every = {fix:g}: must be positive, at most the run's length, {length:g} "
            f"{scenario.units.time}, and make {MOST_FIXES:,} fixes at most"
        )
    fixes = track.time[0] + fix * np.arange(
        int(np.floor(length / fix * (1 + 1e-12))) + 1
    )
    fine = fixes[:-1, None] + fix * SHARES
    x, d = track.at(np.minimum(fine, track.time[-1]))
    floor = max(1e-4 * scenario.known_to_law.R, track.doubt)
    period = track.periods.get("noise", 0.0)
    segments = Segments(
        fine[:, ::2], d - d[:, :1], x[:, 0], x[:, -1], x[:, ::2], floor, period
    )
    moved = np.sqrt(np.mean(np.sum((d[:, -1] - d[:, 0]) ** 2, axis=1)))
    if track.doubt > COARSE * moved:
        raise DataError(
            f"the run's samples let the way through the water be known to {track.doubt:.2g} "
            f"{scenario.units.length} only; run it with a smaller run.output_step"
        )
    return segments


def run_scenario(run: xarray.Dataset) -> Scenario:
    """Return the scenario that a run carries."""
    from ...paper.scenario.file import BEYOND, CHANGED, OWN_PARTS, scenario_of_run

    for one in (CHANGED, OWN_PARTS):
        if one in run.attrs:
            raise DataError(
                f"the run was made with {BEYOND[one][0]}, {run.attrs[one]}, so its vehicle is not "
                "known; estimate from a run without them"
            )
    scenario = scenario_of_run(run)
    if run.sizes.get("time", 0) < 2:
        raise DataError(
            "the run has fewer than two samples; run it with a smaller output_step"
        )
    names, noisy = ["time", "position", "reference"], scenario.localization
    more = [] if noisy is None or noisy.fixes else ["measured_position"]
    check_run(run, scenario, *names, *more)
    return scenario
