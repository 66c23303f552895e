"""A run of a scenario cut into segments: what its vehicle would know at fixes.

Positions are those of the run's samples.  The velocity through the water is what the blocks of
the vehicle make of them, Eq. (7), so the parameters of the true flow are not read.  Between the
times at which the waypoint changes all is smooth and goes by cubic splines.  How exact the
samples let int v dt be is judged by leaving out every second one: the difference over 15, as the
error of a cubic spline falls with the fourth power of the step.
"""

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from scipy.interpolate import CubicSpline

from ..blocks import speed_limit, vehicle
from ..diagrams.scenario_basis import scenario_basis
from ..equations.at_many import evaluate
from ..equations.block import Block
from ..errors import DataError, ScenarioError
from ..scenario.experiment import Scenario
from .segments import SAMPLES, Segments

if TYPE_CHECKING:
    import xarray

LEAST = 5  # samples between two changes of the waypoint
MOST_FIXES = 100_000  # of a run
COARSE = 0.05  # of the way through the water between fixes, in the mean; more is refused


class Way:
    """Position and displacement through the water at any time of a run."""

    def __init__(self, run: "xarray.Dataset", scenario: Scenario):
        self.time, places = run.time.values, run.position.values
        self.scenario, self.basis = scenario, scenario_basis(scenario)
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
    from ..scenario.file import CHANGED, OWN_PARTS, folder_of, scenario_from_text

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
    text = attributes.get("scenario")
    if not isinstance(text, str) or "position" not in run:
        raise DataError("the run carries no scenario; clpt.simulate gives runs that do")
    if run.sizes.get("time", 0) < 2:
        raise DataError("the run has fewer than two samples; run it with a smaller output_step")
    for name in ("time", "position", "reference"):
        if name not in run or not np.all(np.isfinite(run[name].values)):
            raise DataError(f"the run has no whole {name}; clpt.simulate gives runs that do")
    return scenario_from_text(text, "scenario", folder_of(run))
