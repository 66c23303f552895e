"""Position and displacement through the water of a recorded run, between its samples.

Positions are those of the run's samples, with `localization.noise` as the vehicle reads them.  The
velocity through the water is computed from them by the blocks of the vehicle, Eq. (7), so the
parameters of the true flow are not read.

Between the times at which the waypoint or the noise changes, all signals are smooth and are
interpolated by cubic splines.  The error of int v dt is estimated by leaving out every second
sample: the difference over 15, as the error of a cubic spline falls with the fourth power of the
step.
"""

from itertools import pairwise

import numpy as np
import xarray
from scipy.interpolate import CubicSpline

from ...base.errors import DataError, ScenarioError
from ...base.run_attributes import BEYOND, CHANGED, OWN_PARTS
from ...engine.model.block import evaluate
from ...engine.model.declaration import multiples
from ..blocks import vehicle
from .experiment import Scenario
from .recorded_run import check_run, commanded_velocity
from .team import scenario_of_run

LEAST = 5  # samples between two changes of the waypoint, or of the noise


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
