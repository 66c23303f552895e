"""A replay as NetCDF: CF discrete sampling geometry, one trajectory.

CF conventions 1.11, appendix H.4: `dive` is the element dimension, `time`,
`latitude` and `longitude` are where and when the vehicle surfaced, and a scalar
`trajectory` bears `cf_role`.  Forecast places have their own coordinates.

It holds what `clpt replay --json` prints, whole as the variable `summary`, and a variable for each
number of the rows in it: `FACTS` has a line for each, its name there, units, words, and CF standard
name.  Page, plots, tables and files for other programs are made of the same JSON.
"""

import json
from collections.abc import Iterator
from importlib.metadata import version
from typing import Any

import numpy as np
import xarray

from ..arguments import public
from ..errors import DataError
from ..units import seconds_since_1970
from .outcome import summary
from .replay import Replay, next_dive
from .surfacing import ELLIPSE, NextDive

EPOCH = "seconds since 1970-01-01 00:00:00 UTC"
SUMMARY = "summary"  # variable: what `clpt replay --json` prints
ALONG = {"coordinates": "time latitude longitude"}
FACTS = f"""
start_time | {EPOCH} | last fix before the dive
start_latitude | degrees_north | latitude, last fix before the dive
reckoned_latitude | degrees_north | latitude, end of the dive by dead reckoning
forecast_latitude | degrees_north | latitude, surfacing as forecast
start_longitude | degrees_east | longitude, last fix before the dive
reckoned_longitude | degrees_east | longitude, end of the dive by dead reckoning
forecast_longitude | degrees_east | longitude, surfacing as forecast
clpe_no_flow | m | prediction error at the surfacing, flow: no flow
clpe_previous_dive | m | prediction error at the surfacing, flow: previous dive
clpe_adaptive | m | prediction error at the surfacing, flow: adaptive
clpe_flow_model | m | prediction error at the surfacing, flow: flow model
flow_model_east | m | displacement of the vehicle by the flow model, east
flow_model_north | m | displacement of the vehicle by the flow model, north
current_east | m s-1 | learned current over the dive, east | eastward_sea_water_velocity
current_east_error | m s-1 | standard error of current_east
current_north | m s-1 | learned current over the dive, north | northward_sea_water_velocity
current_north_error | m s-1 | standard error of current_north
current_speed | m s-1 | learned current over the dive | sea_water_speed
current_direction | degree | where the learned current goes to, clockwise from north \
    | sea_water_velocity_to_direction
file_current_east | m s-1 | depth-averaged current of the vehicle's own file, east
file_current_north | m s-1 | depth-averaged current of the vehicle's own file, north
forecast_east | m | fix less dead reckoning as forecast, east
forecast_variance_east | m2 | variance of forecast_east
forecast_north | m | fix less dead reckoning as forecast, north
forecast_variance_north | m2 | variance of forecast_north
forecast_covariance | m2 | covariance of forecast_east and forecast_north
speed_factor | 1 | factor on speed through water
speed_factor_error | 1 | standard error of speed_factor
compass | degree | compass error, clockwise
compass_error | degree | standard error of compass
drift_distance | m | drift at the surface before the dive
drift_speed | m s-1 | speed of the drift at the surface
drift_direction | degree | where the drift at the surface goes to, clockwise from north
over_ground_speed | m s-1 | from fix to fix | platform_speed_wrt_ground
over_ground_direction | degree | from fix to fix, clockwise from north | platform_course
"""
FLAGS = {  # what 0 and 1 mean, and words
    "inside_90": ("outside inside", "whether the vehicle surfaced in the 90 % ellipse"),
    "anomaly": ("none flagged", "whether the speed factor left its credible range"),
}
Source = Replay | xarray.Dataset | dict[str, Any]


def found_of(source: Source, ahead: NextDive | None = None) -> dict[str, Any]:
    """Return what `clpt replay --json` prints of a replay, or of the dataset or JSON of one.

    With the next surfacing, `ahead` or as the replay expects it.  What has no dive is refused.
    """
    if isinstance(source, Replay):
        if not source.steps:
            raise DataError("the replay has no dive yet; feed one, as Replay.step does")
        ahead = ahead or next_dive(source)
        return {**summary(source), "next_dive": ahead.as_dict(), "aim": []}
    found: Any = source
    if isinstance(source, xarray.Dataset) and SUMMARY in source:
        found = summary_in(source, "the dataset")
    if not (isinstance(found, dict) and found.get("each_dive")):
        raise DataError(
            f"{type(source).__name__}: is no replay; clpt.replay.replay_dives(dives) gives one, "
            "`clpt replay` writes its dataset, replay.nc"
        )
    return found if ahead is None else {**found, "next_dive": ahead.as_dict()}


@public
def replay_dataset(
    replay: Replay, name: str = "glider", ahead: NextDive | None = None
) -> xarray.Dataset:
    """Return a replay as a dataset.

    Parameters
    ----------
    replay : Replay
        With one dive at least.
    name : str, optional
        Of the trajectory.
    ahead : NextDive, optional
        The next surfacing, which becomes scalars; by default as the replay expects it.

    Returns
    -------
    xarray.Dataset
        Dimension ``dive``; NaN where the vehicle's file had no value, or the
        flow model does not cover the dive.  What no dive has is left out.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> replay = clpt.replay.replay_dives(clpt.gliders.usable(clpt.gliders.sample_dives())[0])
    >>> data = clpt.replay.replay_dataset(replay, "SG542")
    >>> data.sizes["dive"], data.clpe_adaptive.units
    (14, 'm')
    """
    return dataset_of({**found_of(replay, ahead), "vehicle": name})


def dataset_of(found: dict[str, Any]) -> xarray.Dataset:
    """Return what `clpt replay --json` prints, with one dive at least, as a dataset."""
    rows = [dict(_flat(row)) for row in found["each_dive"]]
    time = {"units": EPOCH, "calendar": "standard", "standard_name": "time", "axis": "T"}
    north = {"units": "degrees_north", "standard_name": "latitude", "axis": "Y"}
    east = {"units": "degrees_east", "standard_name": "longitude", "axis": "X"}
    coords = {
        "dive": ("dive", {"long_name": "number of the dive"}),
        "time": ("end_time", {**time, "long_name": "surfacing"}),
        "latitude": ("end_latitude", north),
        "longitude": ("end_longitude", east),
    }
    data = xarray.Dataset(
        coords={
            name: ("dive", [row[key] for row in rows], attributes)
            for name, (key, attributes) in coords.items()
        },
        attrs={
            "Conventions": "CF-1.11",
            "featureType": "trajectory",
            "title": "dead reckoning, forecasts and learned flow of a glider, dive by dive",
            "history": "written by clpt replay",
            "source": f"clpt-control {version('clpt-control')}",
            "estimator": found["estimator"],
            "flow": ",".join(found["flow"]),
            "learn_speed": int(found["learn_speed"]),
            "gaussian_width": found["gaussian_width"],
            "gaussian_width_units": "m",
        },
    )
    if "flow_model" in found:
        data.attrs["flow_model"] = "{source}: {about}".format(**found["flow_model"])
    data["trajectory"] = ((), found["vehicle"], {"cf_role": "trajectory_id"})
    lines = [[cell.strip() for cell in line.split("|")] for line in FACTS.strip().splitlines()]
    lines += [[name, "1", "that the part is present"] for name in rows[0] if name[:5] == "proba"]
    for name, units, words, *standard in lines:
        each = np.array([row.get(name) for row in rows], float)
        if np.isnan(each).all():
            continue
        more = {"standard_name": standard[0]} if standard else {}
        if f"{name}_error" in rows[0]:
            more["ancillary_variables"] = f"{name}_error"
        data[name] = ("dive", each, {"units": units, "long_name": words, **more, **ALONG})
    for name, (meanings, words) in FLAGS.items():
        flags = {"flag_values": np.array([0, 1], np.int8), "flag_meanings": meanings}
        raised = np.array([bool(row[name]) for row in found["each_dive"]], np.int8)
        data[name] = ("dive", raised, {"long_name": words, **flags, **ALONG})
    _next(data, found["next_dive"])
    words = "all that was found, as JSON: what clpt replay --json prints"
    return data.assign({SUMMARY: ((), json.dumps(found, allow_nan=False), {"long_name": words})})


def _flat(row: dict[str, Any]) -> Iterator[tuple[str, Any]]:
    """Yield what a row has, what is within a part of it as PART_NAME."""
    for name, value in row.items():
        if isinstance(value, dict):
            yield from ((f"{name}_{inner}", one) for inner, one in value.items())
        else:
            yield name, value


def _next(data: xarray.Dataset, ahead: dict[str, Any]) -> None:
    """Add the next surfacing: when, where, and its 90 % ellipse."""
    names = "time", "latitude", "longitude", *ELLIPSE
    units = EPOCH, "degrees_north", "degrees_east", "m", "m", "degree"
    for key, unit in zip(names, units, strict=True):
        value = seconds_since_1970(ahead[key]) if key == "time" else ahead[key]
        name = key.replace("_90", " of 90 %").replace("_", " ")
        words = {"long_name": f"{name} of the next surfacing, as forecast", "units": unit}
        data[f"next_{key}"] = ((), value, words)
    data["next_time"].attrs["calendar"] = "standard"


def summary_in(data: xarray.Dataset, name: str) -> Any:
    """Return the JSON in a replay's dataset."""
    try:
        return json.loads(str(data[SUMMARY].values))
    except (KeyError, ValueError, RecursionError):
        raise DataError(
            f"{name}: is a replay's NetCDF without its summary; run `clpt replay --out` again, or "
            "give what `clpt replay --json` prints"
        ) from None
