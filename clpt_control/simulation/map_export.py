"""Track of a run for maps: KML or GeoJSON with the vehicle, its prediction and the waypoints.

The scenario has an `origin`, so that the run has latitudes and longitudes.  If the run has a date
(`time_origin`), start and end have their time.
"""

from typing import TYPE_CHECKING

import numpy as np

from ..base.errors import DataError
from ..base.map_files import BLUE, GREEN, ORANGE, Feature, geojson, kml
from ..base.units import SECONDS
from ..paper.scenario.file import scenario_of_run
from ..paper.scenario.recorded_run import check_run, waypoints_of

if TYPE_CHECKING:
    import xarray

SUFFIXES = (".kml", ".geojson")


def track_text(run: "xarray.Dataset", suffix: str) -> str:
    """Return the track of a scenario's run as KML or GeoJSON, by the ending of a name.

    Features are the track, the predicted track, the waypoints, start and end.
    """
    scenario = scenario_of_run(run)
    check_run(run, scenario, "time", "position")
    if scenario.origin is None:
        raise DataError(
            "the run has no latitude and longitude. Give its scenario an origin: "
            "origin = [41.2, -69.5]"
        )

    def places(points: np.ndarray) -> np.ndarray:
        return np.column_stack(scenario.plane.to_earth(*points.T))

    track = places(run.position.values)
    features = [Feature("track", "LineString", track, BLUE)]
    if "predicted_position" in run:
        predicted = places(run.predicted_position.values)
        features.append(Feature("prediction", "LineString", predicted, GREEN))
    for number, place in enumerate(places(waypoints_of(run, scenario)), 1):
        features.append(Feature(f"waypoint {number}", "Point", [place], ORANGE))
    for name, sample in (("start", 0), ("end", -1)):
        time = _date(run, float(run.time[sample]) * SECONDS[scenario.units.time])
        properties = {"time": time} if time else {}
        features.append(
            Feature(name, "Point", [track[sample]], BLUE, time, "", properties)
        )
    title = str(run.attrs.get("title", "")) or "run"
    return kml(features, title) if suffix == ".kml" else geojson(features)


def _date(run: "xarray.Dataset", seconds: float) -> str:
    """Return the date of a time of a run as ISO 8601, or "" if the run has none."""
    origin = run.attrs.get("time_origin")
    if origin is None:
        return ""
    return f"{np.datetime64(origin, 's') + np.timedelta64(round(seconds), 's')}Z"
