"""Least squares and Kalman filter of theta, Eq. (3), from position errors between fixes of a run.

Eq. (1) with Eq. (3), integrated over a segment between two fixes, is

    y = x(t2) - x(t1) - int v dt = theta h + n,    h = int phi(x(t), t) dt

with y the position error of the segment and n ~ N(0, r^2 I).  Each row of theta has the prior
N(theta_0, prior^2).

least-squares   theta = theta_0 + (sum y~ h^T/r^2) P,  P^-1 = P_0^-1 + sum h h^T/r^2,
                y~ = y - theta_0 h
kalman          the same segment by segment, by `least_squares_step` of the law fix-regression

P is N x N and serves both axes.  The filter ends at least squares.

Neighbouring segments share a fix: n_s = r_s (a_s + m_s - m_{s-1}), with a_s the noise of this
segment alone and m_s that of the fix at its end; `Segments.shares` are their variances.  The n_s
are a moving average of order 1.  A filter whose only state is the noise of the last fix makes
white innovations of them, of y and of h (`whitened`): generalised least squares.  If the track
itself is read with noise, theta h is as wrong as that noise makes phi (`Segments.blur`).

Sources: R. E. Kalman, "A new approach to linear filtering and prediction problems", 1960; P. J.
Brockwell, R. A. Davis, "Time Series: Theory and Methods", 1991, section 5.3 (innovations).

A run of a scenario is divided into segments by what its vehicle would know at fixes.  Positions
are those of the run's samples, with `localization.noise` as the vehicle reads them.  The velocity
through the water is computed from them by the blocks of the vehicle, Eq. (7), so the parameters of
the true flow are not read.

Between the times at which the waypoint or the noise changes, all signals are smooth and are
interpolated by cubic splines.  The error of int v dt is estimated by leaving out every second
sample: the difference over 15, as the error of a cubic spline falls with the fourth power of the
step.
"""

from collections.abc import Callable, Iterator
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import xarray
from scipy.integrate import simpson
from scipy.interpolate import CubicSpline

from ...base.errors import DataError, ScenarioError
from ...engine.model.block import Block, evaluate
from ...engine.model.declaration import multiples
from ...paper.blocks import vehicle
from ...paper.currents.least_squares import regularised
from ...paper.laws.memory_laws import least_squares_step
from ...paper.scenario.experiment import Scenario
from ...paper.scenario.recorded_run import check_run, commanded_velocity

GRADIENT_STEP = 1e-4  # of the track's size: step of the differences of phi
SAMPLES = 129  # of a segment's track

LEAST = 5  # samples between two changes of the waypoint, or of the noise
MOST_FIXES = 100_000  # of a run
# of the way through the water between fixes, in the mean; more is refused
COARSE = 0.05


class Segments(NamedTuple):
    """n segments between fixes, each at m times.

    Attributes
    ----------
    time : ndarray, shape (n, m)
        From fix to fix.
    track : ndarray, shape (n, m, 2)
        x(t), length.
    error : ndarray, shape (n, 2)
        y, length.
    alone : float
        Largest noise that a segment has alone, length; what is beyond belongs to its fixes.
    noise_period : float
        Time over which one noise of the track lasts; 0 without noise.
    """

    time: np.ndarray
    track: np.ndarray
    error: np.ndarray
    alone: float = np.inf
    noise_period: float = 0.0

    @property
    def duration(self) -> np.ndarray:
        """Time between the fixes, (n,)."""
        return self.time[:, -1] - self.time[:, 0]

    @property
    def renewed(self) -> np.ndarray:
        """True where the noise at the end differs from that at the start, (n,)."""
        if not self.noise_period:
            return np.ones(len(self.time), dtype=bool)
        return np.ptp(self._noise_numbers(), axis=1) > 0

    def _noise_numbers(self) -> np.ndarray:
        """Return the number of the noise at each time, (n, m); a last one of no length is not."""
        slack = 1e-9 * self.noise_period
        time = np.minimum(self.time + slack, self.time[-1, -1] - slack)
        return time // self.noise_period

    def integrals(self, basis: Block) -> np.ndarray:
        """Return h = int phi(x(t), t) dt, shape (n, N), time."""
        n, m = self.time.shape
        phi = evaluate(basis, self.time.ravel(), self.track.reshape(-1, 2))
        return simpson(phi.reshape(n, m, -1), dx=1.0, axis=1) * (
            self.duration[:, None] / (m - 1)
        )

    def shares(self, r: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the shares of r^2 of a segment alone and of each of its fixes, (n,)."""
        alone = np.minimum(1.0, self.alone / r) ** 2
        return alone, (1 - alone) / 2

    def blur(self, basis: Block) -> np.ndarray:
        """Return B, (n, N, N): read with noise s, theta h has the variance s^2 theta B theta^T.

        B = sum over axes i and noises of g g^T/l, g = int dphi/dx_i dt while one noise lasts, l
        the share of its samples that are in this segment.  One noise in several segments is one
        error of all of them; B as if each had its own bounds it, as (sum a)^2 <= sum a^2/l.
        """
        n, m = self.time.shape
        if not self.noise_period:
            return np.zeros((n, *2 * [sum(basis.output_ports.values())]))
        slope = self._gradients(basis)
        slope *= np.repeat(self.duration / m, m)[:, None, None]
        # sum the gradients over the samples of each noise in each segment
        numbers = self._noise_numbers()
        begins = np.diff(numbers, axis=1, prepend=-1.0) != 0
        starts = np.flatnonzero(begins)
        g = np.add.reduceat(slope, starts, axis=0)
        samples = np.diff(starts, append=n * m)
        # weight each by the share of its noise that lies in the segment
        noise_index = np.unique(numbers[begins], return_inverse=True)[1]
        samples_of_noise = np.bincount(noise_index, samples)[noise_index]
        g *= np.sqrt(samples_of_noise / samples)[:, None, None]
        B = np.zeros((n, g.shape[-1], g.shape[-1]))
        np.add.at(B, np.nonzero(begins)[0], np.einsum("gik,gil->gkl", g, g))
        return B

    def _gradients(self, basis: Block) -> np.ndarray:
        """Return dphi/dx_i along the tracks by central differences, (n m, 2, N)."""
        size = GRADIENT_STEP * np.ptp(self.track)
        times, points = self.time.ravel(), self.track.reshape(-1, 2)
        differences = [
            evaluate(basis, times, points + step)
            - evaluate(basis, times, points - step)
            for step in size * np.eye(2)
        ]
        return np.stack(differences, axis=1) / (2 * size)


def whitened(
    segments: Segments,
    columns: np.ndarray,
    r: np.ndarray,
    blur: Callable[[int], float] = lambda k: 0.0,
) -> Iterator[np.ndarray]:
    """Yield rows of columns (n, c) as innovations over their standard deviation: white, of size 1.

    `blur(k)` is that of segment k, and is called when its row is due.
    """
    alone, fix = segments.shares(r)
    rows = columns / r[:, None]
    fix_noise, variance = np.zeros(columns.shape[1]), fix[0]
    for k, renewed in enumerate(segments.renewed):
        S = renewed * (variance + fix[k]) + alone[k] + fix[k] * blur(k)
        innovation = rows[k] + renewed * fix_noise  # one noise at both ends cancels
        yield innovation / np.sqrt(S)
        if renewed:
            fix_noise = fix[k] / S * innovation
            variance = fix[k] - fix[k] ** 2 / S


def expected_blur(theta: np.ndarray, P: np.ndarray, B: np.ndarray) -> float:
    """Return the expectation of theta B theta^T, of the axis where it is larger."""
    of_mean = np.einsum("kl,ak,al->a", B, theta, theta).max()
    return float(of_mean + np.sum(B * P))


Estimate = tuple[np.ndarray, np.ndarray, np.ndarray]


def kalman(
    segments: Segments, basis: Block, theta: np.ndarray, sd: np.ndarray, r: np.ndarray
) -> Estimate:
    """Return theta after each segment, P after the last one, and h; each step is causal."""
    h, B = segments.integrals(basis), segments.blur(basis)
    P, steps = np.diag(sd**2), []

    def blur(k: int) -> float:
        return expected_blur(theta, P, B[k])

    for row in whitened(segments, np.hstack([h, segments.error]), r, blur):
        m, y = row[:-2], row[-2:]
        change, P = least_squares_step(P, m, y - theta @ m, 1.0)
        theta = theta + change
        steps.append(theta)
    return np.array(steps), P, h


def batch_least_squares(
    segments: Segments, basis: Block, theta: np.ndarray, sd: np.ndarray, r: np.ndarray
) -> Estimate:
    """Return theta, P and h of least squares, by singular values: accurate for any prior."""
    h, B = segments.integrals(basis), segments.blur(basis)
    prior, P = theta, np.diag(sd**2)

    def blur(k: int) -> float:
        return expected_blur(theta, P, B[k])

    for _ in range(3 if segments.noise_period else 1):
        columns = np.hstack([h, segments.error])
        rows = np.array([*whitened(segments, columns, r, blur)])
        theta, P = regularised(rows[:, :-2], rows[:, -2:], prior, sd)
    return theta[None], P, h


METHODS: dict[str, Callable[..., Estimate]] = {
    "least-squares": batch_least_squares,
    "kalman": kalman,
}


# --- segments of a run ----------------------------------------------------------------------------


class RunTrack:
    """Position and displacement through the water at any time of a run."""

    def __init__(self, run: xarray.Dataset, scenario: Scenario):
        self.time, position = run.time.values, run.position.values
        self.positions, self.water = [], []  # splines, one for each smooth interval
        self.doubt = 0.0  # error of the displacement over an interval, length
        self.periods = {"waypoint": scenario.reference.dwell}  # of each discontinuity
        read = position
        if scenario.localization is not None:
            self.periods["noise"] = float(scenario.localization.noise_period or 0)
            read = run.measured_position.values
        self.slack = 1e-9 * min(self.periods.values())
        # smooth intervals between changes of the waypoint or the noise
        start, end = self.time[0], self.time[-1]
        changes = np.concatenate(
            [multiples(span, start, end) for span in self.periods.values()]
        )
        inside = (changes > start + self.slack) & (changes < end - self.slack)
        changes = np.sort(changes[inside])
        is_distinct = np.diff(changes, prepend=start) > self.slack
        self.edges = np.array([start, *changes[is_distinct], end])
        rows_of_edges = np.searchsorted(self.time, self.edges - self.slack)
        rows_of_edges = rows_of_edges.clip(0, len(self.time) - 1)
        off = np.abs(self.time[rows_of_edges] - self.edges) > 1e3 * self.slack
        if off.any() or np.diff(rows_of_edges).min() + 1 < LEAST:
            unit = scenario.units.time
            spans = " and the ".join(
                f"{name} each {span:g} {unit}" for name, span in self.periods.items()
            )
            raise ScenarioError(
                f"run.output_step: there change the {spans}. Run it with a "
                f"step that divides that into {LEAST} samples at least"
            )
        rows = np.concatenate([np.arange(a, b + 1) for a, b in pairwise(rows_of_edges)])
        # an interval has one noise and one waypoint, those of its first row
        first_row = np.repeat(rows_of_edges[:-1], np.diff(rows_of_edges) + 1)
        x = position[rows] + (read - position)[first_row]
        times, limit = self.time[rows], scenario.vehicle.max_speed
        zc = run.reference.values[first_row]
        velocity = commanded_velocity(scenario, times, x, zc)
        if limit is not None:
            velocity = evaluate(vehicle.speed_limit(limit), times, velocity)
        total = np.zeros(2)
        ends = np.flatnonzero(np.diff(first_row)) + 1
        for part in np.split(np.arange(len(rows)), ends):
            t, v = self.time[rows[part]], velocity[part]
            spline, coarse = CubicSpline(t, v), CubicSpline(t[::2], v[::2])
            span = t[0], t[::2][-1]
            difference = spline.integrate(*span) - coarse.integrate(*span)
            self.doubt = max(self.doubt, float(np.abs(difference).max()) / 15)
            self.positions.append(CubicSpline(t, x[part]))
            self.water.append((spline.antiderivative(), total))
            total = total + spline.integrate(t[0], t[-1])

    def evaluate(self, times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the position as read and the displacement since the start, (..., 2) each."""
        interval = np.searchsorted(self.edges, times + self.slack, "right") - 1
        interval = np.clip(interval, 0, len(self.positions) - 1)
        x, d = np.zeros((*times.shape, 2)), np.zeros((*times.shape, 2))
        for k in np.unique(interval):
            inside = interval == k
            integral, before = self.water[k]
            x[inside] = self.positions[k](times[inside])
            d[inside] = before + integral(times[inside])
        return x, d


def run_segments(
    run: xarray.Dataset, scenario: Scenario, every: float | None
) -> Segments:
    """Return the segments of a run."""
    if scenario.localization is not None and scenario.localization.fixes is not None:
        raise ScenarioError(
            "localization.interval: the vehicle of this run steers on its prediction between "
            "fixes, so its velocity is not known. Estimate from a run with interval = 0"
        )
    track = RunTrack(run, scenario)
    fix = scenario.reference.dwell / 10 if every is None else every
    length = float(track.time[-1] - track.time[0])
    if not max(0.0, length / MOST_FIXES) < fix <= length:
        raise ScenarioError(
            f"every = {fix:g}: must be positive, at most the run's length, {length:g} "
            f"{scenario.units.time}, and make {MOST_FIXES:,} fixes at most"
        )
    count = int(np.floor(length / fix * (1 + 1e-12)))
    starts = track.time[0] + fix * np.arange(count)
    time = starts[:, None] + fix * np.linspace(0.0, 1.0, SAMPLES)
    x, d = track.evaluate(np.minimum(time, track.time[-1]))
    floor = max(1e-4 * scenario.known_to_law.R, track.doubt)
    error = x[:, -1] - x[:, 0] - (d[:, -1] - d[:, 0])
    segments = Segments(time, x, error, floor, track.periods.get("noise", 0.0))
    moved = np.sqrt(np.mean(np.sum((d[:, -1] - d[:, 0]) ** 2, axis=1)))
    if track.doubt > COARSE * moved:
        raise DataError(
            f"the run's samples let the way through the water be known to {track.doubt:.2g} "
            f"{scenario.units.length} only. Run it with a smaller run.output_step"
        )
    return segments


def run_scenario(run: xarray.Dataset) -> Scenario:
    """Return the scenario that a run carries."""
    from ...paper.scenario.file import scenario_of_run
    from ...paper.scenario.run_constants import BEYOND, CHANGED, OWN_PARTS

    for attribute in (CHANGED, OWN_PARTS):
        if attribute in run.attrs:
            raise DataError(
                f"the run was made with {BEYOND[attribute][0]}, {run.attrs[attribute]}, so its "
                "vehicle is not known. Estimate from a run without them"
            )
    scenario = scenario_of_run(run)
    if run.sizes.get("time", 0) < 2:
        raise DataError(
            "the run has fewer than two samples. Run it with a smaller output_step"
        )
    names, noisy = ["time", "position", "reference"], scenario.localization
    if noisy is not None and not noisy.fixes:
        names.append("measured_position")
    check_run(run, scenario, *names)
    return scenario
