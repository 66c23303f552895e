"""Legs of a simulated run: fixes of its vehicle, and the displacement through the water between.

Positions are those of the run's samples, with `localization.noise` as the vehicle reads them.  The
velocity through the water is computed from them by the blocks of the vehicle, Eq. (7), so the
parameters of the true flow are not read.

Between the times at which the waypoint or the noise changes, all signals are smooth and are
interpolated by cubic splines.  The error of int v dt is estimated by leaving out every second
sample: the difference over 15, as the error of a cubic spline falls with the fourth power of the
step.

The plane of a run without an origin lies on the equator, where it is the Earth's to 1e-5 within
50 km.
"""

from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
import xarray
from scipy.interpolate import CubicSpline

from ...base.errors import DataError, ScenarioError
from ...base.units import seconds_since_1970
from ...engine.model.block import evaluate
from ...engine.model.declaration import multiples
from ...paper.blocks import vehicle
from ...paper.laws.law import PRIOR
from ...paper.scenario.experiment import Scenario
from ...paper.scenario.recorded_run import check_run, commanded_velocity
from ..gliders.dives import Dive, make_dive
from .fix_settings import LocalFrame

STRETCHES = 128  # of a leg
SEA = 0.0, -30.0  # degrees, origin of a run without one
LEAST = 5  # samples between two changes of the waypoint, or of the noise
MOST_FIXES = 100_000  # of a run
# of the way through the water between fixes, in the mean; more is refused
COARSE = 0.05
EXACT = (
    1e-4  # of the track's reach: noise of a position error without noise of the fixes
)
LEAST_FIX = 0.1  # of that noise: noise of a fix


def legs_of_run(
    run: xarray.Dataset, every: float | None, prior: Any = None, noise: Any = None
) -> tuple[list[Dive], Scenario, LocalFrame]:
    """Return the legs of a run, a scenario that learns from them, and their frame."""
    scenario = run_scenario(run)
    if scenario.localization is not None and scenario.localization.fixes is not None:
        raise ScenarioError(
            "localization.interval: the vehicle of this run steers on its prediction between "
            "fixes, so its velocity is not known. Estimate from a run with interval = 0"
        )
    track = RunTrack(run, scenario)
    interval = scenario.reference.dwell / 10 if every is None else every
    length = float(track.time[-1] - track.time[0])
    if not max(0.0, length / MOST_FIXES) < interval <= length:
        raise ScenarioError(
            f"every = {interval:g}: must be positive, at most the run's length, {length:g} "
            f"{scenario.units.time}, and make {MOST_FIXES:,} fixes at most"
        )
    count = int(np.floor(length / interval * (1 + 1e-12)))
    starts = track.time[0] + interval * np.arange(count)
    times = starts[:, None] + interval * np.linspace(0.0, 1.0, STRETCHES + 1)
    x, d = track.evaluate(np.minimum(times, track.time[-1]))
    moved = np.sqrt(np.mean(np.sum((d[:, -1] - d[:, 0]) ** 2, axis=1)))
    if track.doubt > COARSE * moved:
        raise DataError(
            f"the run's samples let the way through the water be known to {track.doubt:.2g} "
            f"{scenario.units.length} only. Run it with a smaller run.output_step"
        )
    begin = seconds_since_1970(run.attrs.get("time_origin", "1970-01-01T00:00:00Z"))
    frame = LocalFrame(begin, scenario.origin or SEA, scenario.units)
    legs = []
    for number, (t, places, ways) in enumerate(zip(times, x, d, strict=True), 1):
        axes = frame.axes(places[0])
        east, north = axes.T @ (ways - ways[0]).T * frame.metres
        start, end = (
            (frame.date(float(t[k])), *frame.position(places[k])) for k in (0, -1)
        )
        leg = make_dive(number, start, end, (float(east[-1]), float(north[-1])))
        elapsed = (t - t[0]) * frame.seconds
        legs.append(replace(leg, track=(elapsed, east, north)))
    alone = max(EXACT * scenario.known_to_law.R, track.doubt)
    return legs, _learner(scenario, interval, alone, prior, noise), frame


def _learner(
    scenario: Scenario, interval: float, alone: float, prior: Any, noise: Any
) -> Scenario:
    """Return the scenario of a law that learns from the legs, `alone` the noise of an exact one."""
    known = scenario.known_to_law
    fix = 0.0 if scenario.localization is None else scenario.localization.noise
    usual = float(np.hypot(alone, np.sqrt(2) * fix))
    settings = {
        "prior": float(PRIOR.usual(known)) if prior is None else prior,
        "noise": usual if noise is None else noise,
    }
    tables: dict[str, Any] = {
        "units": scenario.units,
        "origin": scenario.origin,
        "basis": scenario.basis,
        "learning": {
            "law": "fix-regression",
            "parameters": np.array(scenario.model_parameters).tolist(),
            "fix_regression": settings,
        },
        "localization": {"interval": interval, "noise": max(fix, LEAST_FIX * alone)},
    }
    return Scenario(**tables)


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
