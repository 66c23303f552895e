"""Flow learned from recorded legs, a leg at a time, as a Dataset.

Each leg (`dives.Dive`: two fixes and the way through the water between them) goes through
`FlowEstimator`, so that feeding legs at once is feeding their fixes one by one.  The learned flow
along the track is that of the parameters after the last leg, at each fix.
"""

from collections.abc import Iterable
from importlib.metadata import version
from itertools import pairwise
from math import hypot
from operator import attrgetter
from typing import Any

import numpy as np
import xarray

from ...base.errors import DataError
from ...base.progress.interrupt import check
from ...paper.scenario.experiment import Scenario
from ..gliders.dives import Dive, reckoned
from .fix_model import PERCENT
from .flow_estimator import FlowEstimator, Learned

BENT = 0.9  # share of its way at most from which on a leg is straight
HARDLY = 0.7  # share of the prior's standard deviation that is left
MPS = "m s-1"


def learn_leg(estimator: FlowEstimator, leg: Dive) -> Learned:
    """Learn from one leg."""
    # dives may overlap by rounded times
    start = max(leg.t_gps2, estimator.time)
    estimator.fix(start, *leg.start)
    elapsed, east, north = reckoned(leg)
    keep = np.diff(elapsed, prepend=-1.0) > 0
    points = np.array([elapsed, east, north]).T[keep]
    is_later = leg.t_gps2 + points[:, 0] > start
    points = points[(points[:, 0] == 0) | (is_later & (points[:, 0] < leg.duration))]
    points = np.vstack([points, [leg.duration, *leg.through_water]])
    for (_, *before), (time, *after) in pairwise(points):
        stretch = np.subtract(after, before)
        estimator.move(leg.t_gps2 + float(time), float(stretch[0]), float(stretch[1]))
    return estimator.fix(leg.t_gpse, *leg.end)


def flow_of_legs(
    legs: list[Dive], scenario: Scenario
) -> tuple[xarray.Dataset, FlowEstimator]:
    """Return the Dataset of `flow_estimate`, and the estimator after the last leg."""
    if not legs:
        raise DataError("no leg: a leg lies between two fixes. Give two fixes or more")
    estimator = FlowEstimator(scenario)
    learned = []
    for leg in legs:
        check()
        learned.append(learn_leg(estimator, leg))
    frame, _ = estimator.under_way
    flow = [estimator.flow(r.time, r.latitude, r.longitude) for r in learned]
    forecasts = [result.forecast for result in learned]
    start, end = (
        _dates(getattr(leg, key) for leg in legs) for key in ("t_gps2", "t_gpse")
    )
    north, east = "degrees_north", "degrees_east"
    error, region = "fix less forecast, before it was learned", f"{PERCENT} region"

    def column(values: Iterable[Any], name: str, units: str = "", *dims: str) -> tuple:
        attributes = {"long_name": name} | ({"units": units} if units else {})
        return ("leg", *dims), np.array([*values]), attributes

    def of(source: Iterable[Any], keys: str, *described: str) -> tuple:
        return column(map(attrgetter(*keys.split()), source), *described)

    data = xarray.Dataset(
        {
            "start_time": column(start, "last fix before the leg"),
            "end_time": column(end, "first fix after the leg"),
            "latitude": of(learned, "latitude", "latitude of the fix", north),
            "longitude": of(learned, "longitude", "longitude of the fix", east),
            "predicted_latitude": of(forecasts, "latitude", "forecast latitude", north),
            "predicted_longitude": of(
                forecasts, "longitude", "forecast longitude", east
            ),
            "position_error": of(learned, "error_east error_north", error, "m", "axis"),
            "forecast_radius": of(
                forecasts, "radius", f"radius of the forecast's {region}", "m"
            ),
            "inside": of(learned, "inside", f"fix in the {region} of its forecast"),
            "flow": column(flow, "learned flow at the fix", MPS, "axis"),
            "flow_parameters_estimate": of(
                *(learned, "flow_parameters", "estimate of theta after the leg"),
                *(MPS, "axis", "basis"),
            ),
            "standard_error": of(
                *(learned, "standard_error", "standard error of each row of theta"),
                *(MPS, "basis"),
            ),
        },
        {"leg": [leg.number for leg in legs], "axis": ["east", "north"]},
        {
            "fix_law": scenario.learning.law,
            "source": f"clpt-control {version('clpt-control')}",
            "origin": list(frame.place),
            "time_origin": str(np.datetime64(round(frame.time * 1e3), "ms")),
            "noise_scale": estimator.scale,
            "notes": [
                f"leg {leg.number}: its end fix {r.note}"
                for leg, r in zip(legs, learned, strict=True)
                if r.note
            ]
            + not_learned(estimator)
            + bent_legs(legs),
        },
    )
    return data, estimator


def not_learned(estimator: FlowEstimator) -> list[str]:
    """Return a note on functions that the track hardly teaches."""
    settings = estimator.settings
    share = (
        estimator.standard_error / np.maximum(settings.prior, 1e-300) / settings.speed
    )
    numbers = np.flatnonzero((share > HARDLY) & (settings.prior > 0)) + 1
    if not len(numbers):
        return []
    listed = ", ".join(map(str, numbers[:8])) + (", ..." if len(numbers) > 8 else "")
    which = "all functions" if len(numbers) == len(share) else f"functions {listed}"
    return [
        f"{which} hardly learned: their standard errors are still above {HARDLY:.0%} of the prior. "
        "Check origin, centers and widths against the fixes, or record more legs"
    ]


def bent_legs(legs: list[Dive]) -> list[str]:
    """Return a note on legs of a table whose way was not straight."""
    speeds = np.array(
        [hypot(*leg.through_water) / leg.duration for leg in legs if leg.track is None]
    )
    bent = int(np.sum(speeds < BENT * speeds.max())) if len(speeds) else 0
    if len(speeds) < 2 or 2 * bent < len(speeds):
        return []
    return [
        f"{bent} of {len(legs)} legs are shorter than {speeds.max():.2f} m/s x duration, as if the "
        "vehicle had turned or slowed. They are taken as straight: give the way between fixes "
        "(rows of time, course, speed) for a better estimate"
    ]


def _dates(times: Iterable[float]) -> np.ndarray:
    """Return s since 1970 UTC as dates."""
    return np.array([round(1e3 * t) for t in times], dtype="datetime64[ms]").astype(
        "datetime64[ns]"
    )
