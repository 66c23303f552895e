"""A row for each dive, by name, for JSON and pages.

Lengths are in m, times ISO 8601 UTC, currents in m/s, angles in degrees clockwise from north;
what is not known is None.
"""

from math import hypot, isfinite
from typing import Any

from ..geodesy import place_from
from .over_ground import drifts, over_ground
from .replay import Replay
from .step import Step, ellipse
from .wording import direction, utc


def rows(replay: Replay) -> list[dict[str, Any]]:
    """Return a row for each dive of a replay."""
    ways = drifts([step.dive for step in replay.steps])
    found = []
    for step, way in zip(replay.steps, ways, strict=True):
        row = _row(step, replay.models)
        row["drift"] = None if way is None else way.as_dict()
        if not replay.model.learn_speed:
            row |= dict.fromkeys(("speed_factor", "speed_factor_error"))
            row |= dict.fromkeys(("compass", "compass_error"))
        found.append({key: _known(value) for key, value in row.items()})
    return found


def _known(value: Any) -> Any:
    """Return None for a number that is not finite, which JSON has no word for."""
    return None if isinstance(value, float) and not isfinite(value) else value


def _row(step: Step, models: tuple[str, ...]) -> dict[str, Any]:
    dive = step.dive
    start = dive.lat_gps2, dive.lon_gps2
    reckoned = place_from(*start, dive.dr_east, dive.dr_north)
    forecast = place_from(*start, dive.dr_east + step.forecast[0], dive.dr_north + step.forecast[1])
    long, short, bearing = ellipse(step.covariance)
    east, north = map(float, step.current)
    return {
        "dive": dive.number,
        "start": utc(dive.t_gps2),
        "end": utc(dive.t_gpse),
        "duration": dive.duration,
        "start_latitude": dive.lat_gps2,
        "start_longitude": dive.lon_gps2,
        "end_latitude": dive.lat_gpse,
        "end_longitude": dive.lon_gpse,
        "reckoned_latitude": reckoned[0],
        "reckoned_longitude": reckoned[1],
        "forecast_latitude": forecast[0],
        "forecast_longitude": forecast[1],
        "dr_east": dive.dr_east,
        "dr_north": dive.dr_north,
        "forecast_east": float(step.forecast[0]),
        "forecast_north": float(step.forecast[1]),
        "clpe": {name: step.clpe[name] for name in models},
        "ellipse_90_long": long,
        "ellipse_90_short": short,
        "ellipse_90_bearing": bearing,
        "inside_90": step.inside,
        "current_east": east,
        "current_north": north,
        "current_east_error": float(step.current_error[0]),
        "current_north_error": float(step.current_error[1]),
        "current_speed": hypot(east, north),
        "current_direction": direction(east, north),
        "speed_factor": step.speed,
        "speed_factor_error": step.speed_error,
        "compass": step.compass,
        "compass_error": step.compass_error,
        "over_ground": over_ground(dive).as_dict(),
        "anomaly": None if step.anomaly is None else step.anomaly.as_dict(),
        "depth_max": dive.depth_max,
        "notes": list(dive.notes),
    }
