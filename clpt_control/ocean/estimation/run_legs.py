"""Legs of a simulated run: fixes of its vehicle, and the displacement through the water between.

Positions and displacements are those of `run_track`.
The plane of a run without an origin lies on the equator, where it is the Earth's to 1e-5 within
50 km.
"""

from dataclasses import replace
from typing import Any

import numpy as np
import xarray

from ...base.errors import DataError, ScenarioError
from ...base.units import seconds_since_1970
from ...paper.laws.law import PRIOR
from ...paper.scenario.experiment import Scenario
from ...paper.scenario.run_track import RunTrack, run_scenario
from ..gliders.dives import Dive, make_dive
from .fix_settings import LocalFrame, rotated

STRETCHES = 128  # of a leg
SEA = 0.0, -30.0  # degrees, origin of a run without one
MOST_FIXES = 100_000  # of a run
# of the way through the water between fixes, in the mean; more is refused
COARSE = 0.05
EXACT = (
    1e-4  # of the track's reach: noise of a position error without noise of the fixes
)
LEAST_FIX = 0.1  # of that noise: noise of a fix


def legs_of_run(
    run: xarray.Dataset, every: float | None, prior: Any, noise: Any
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
        angle, growth = frame.axes(places[0])
        over_ground, _ = rotated(places - places[0], -angle).T
        middle = (over_ground[1:] + over_ground[:-1]) / 2
        moved = rotated(np.diff(ways, axis=0), -angle - growth * middle)
        east, north = np.cumsum(np.vstack([[0, 0], moved]), axis=0).T * frame.metres
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
