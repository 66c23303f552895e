"""The facts of each dive, by name: a row for JSON and pages, with more for files and plots.

Lengths are in m, times ISO 8601 UTC, currents in m/s, angles in degrees clockwise from north;
what is not known is None.
"""

from math import hypot, isfinite
from typing import Any

from ..geodesy import place_from
from .over_ground import drifts, over_ground
from .replay import Replay
from .step import ELLIPSE, Step, ellipse
from .wording import direction, utc

SPEED = ("speed_factor", "speed_factor_error", "compass", "compass_error")


def rows(replay: Replay) -> list[dict[str, Any]]:
    """Return a row for each dive of a replay."""
    ways = drifts([step.dive for step in replay.steps])
    found = []
    for step, way in zip(replay.steps, ways, strict=True):
        row = _row(step, replay.models)
        row["drift"] = None if way is None else way.as_dict()
        if not replay.model.learn_speed:
            row |= dict.fromkeys(SPEED)
        found.append({key: known(value) for key, value in row.items()})
    return found


def facts(replay: Replay) -> list[dict[str, Any]]:
    """Return the row of each dive with what files and plots have in addition, on one level."""
    found = rows(replay)
    for row, step in zip(found, replay.steps, strict=True):
        dive, covariance = step.dive, step.covariance
        row |= {"start_time": dive.t_gps2, "forecast_covariance": covariance[0, 1]}
        for k, axis in enumerate(("east", "north")):
            row[f"file_current_{axis}"] = getattr(dive, f"dac_{axis}")
            row[f"forecast_variance_{axis}"] = covariance[k, k]
            if replay.flow_model is not None:
                row[f"flow_model_{axis}"] = getattr(dive, f"model_{axis}")
        for key in ("distance", "speed", "direction"):
            row[f"drift_{key}"] = row["drift"] and row["drift"][key]
            row[f"over_ground_{key}"] = row["over_ground"][key]
        row |= {f"clpe_{name}": size for name, size in row["clpe"].items()}
        row |= {f"probability_{part}": p for part, p in step.parts.items()}
        if not replay.model.learn_speed:
            for key in SPEED:
                del row[key]
    return found


def known(value: Any) -> Any:
    """Return None for a number that is not finite, which JSON has no word for."""
    return None if isinstance(value, float) and not isfinite(value) else value


def _row(step: Step, models: tuple[str, ...]) -> dict[str, Any]:
    dive = step.dive
    start = dive.lat_gps2, dive.lon_gps2
    reckoned = place_from(*start, dive.dr_east, dive.dr_north)
    forecast = place_from(*start, dive.dr_east + step.forecast[0], dive.dr_north + step.forecast[1])
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
        **dict(zip(ELLIPSE, ellipse(step.covariance), strict=True)),
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
