"""A replay as NetCDF: CF discrete sampling geometry, one trajectory.

CF conventions 1.11, appendix H.4: `dive` is the element dimension, `time`,
`latitude` and `longitude` are where and when the vehicle surfaced, and a scalar
`trajectory` bears `cf_role`.  Forecast places have their own coordinates.

It holds what `clpt replay --json` prints, whole as the variable `summary`, and a variable for each
number of its rows: what is within a part of a row is PART_NAME, such as `clpe_adaptive`, `UNITS`
are by names.  Page, plots, tables and files for other programs are made of the same JSON.
"""

import json
import re
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
UNITS = {  # pattern of a name: units; the first that matches counts
    r".*latitude": "degrees_north",
    r".*longitude": "degrees_east",
    r".*(direction|bearing)|compass.*": "degree",
    r".*(duration|time_90)": "s",
    r"start_time": EPOCH,
    r"(probability|speed_factor).*": "1",
    r".*(variance|covariance).*": "m2",
    r".*(current|speed).*": "m s-1",
    r".*": "m",
}
STANDARD = {  # names of CF
    "current_east": "eastward_sea_water_velocity",
    "current_north": "northward_sea_water_velocity",
    "current_speed": "sea_water_speed",
    "current_direction": "sea_water_velocity_to_direction",
    "over_ground_speed": "platform_speed_wrt_ground",
    "over_ground_direction": "platform_course",
}
COORDINATES = ("dive", "end_time", "end_latitude", "end_longitude")
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
    for name in dict.fromkeys(name for row in rows for name in row):
        each = [row.get(name) for row in rows]
        attributes = {"long_name": name.replace("_", " "), **ALONG}
        if all(isinstance(one, bool) for one in each):
            flags = {"flag_values": np.array([0, 1], np.int8), "flag_meanings": "no yes"}
            data[name] = ("dive", np.array(each, np.int8), {**attributes, **flags})
        elif name not in COORDINATES and any(isinstance(one, float) for one in each):
            attributes["units"] = units_of(name)
            if name in STANDARD:
                attributes["standard_name"] = STANDARD[name]
            if f"{name}_error" in rows[0]:
                attributes["ancillary_variables"] = f"{name}_error"
            data[name] = ("dive", np.array(each, float), attributes)
    ahead = {key: found["next_dive"][key] for key in ("latitude", "longitude", *ELLIPSE)}
    ahead["time"] = seconds_since_1970(found["next_dive"]["time"])
    for name, value in ahead.items():
        long_name = {"long_name": f"{name.replace('_', ' ')} of the next surfacing, as forecast"}
        more = time if name == "time" else {"units": units_of(name)}
        data[f"next_{name}"] = ((), value, {**more, **long_name})
    words = "all that was found, as JSON: what clpt replay --json prints"
    return data.assign({SUMMARY: ((), json.dumps(found, allow_nan=False), {"long_name": words})})


def _flat(row: dict[str, Any]) -> Iterator[tuple[str, Any]]:
    """Yield what a row has, what is within a part of it as PART_NAME."""
    for name, value in row.items():
        if name == "anomaly":
            yield name, value is not None
        elif isinstance(value, dict):
            yield from ((f"{name}_{inner}", one) for inner, one in value.items())
        else:
            yield name, value


def units_of(name: str) -> str:
    """Return the units of a number by its name."""
    return next(units for pattern, units in UNITS.items() if re.fullmatch(pattern, name))


def summary_in(data: xarray.Dataset, name: str) -> Any:
    """Return the JSON in a replay's dataset."""
    try:
        return json.loads(str(data[SUMMARY].values))
    except (KeyError, ValueError, RecursionError):
        raise DataError(
            f"{name}: is a replay's NetCDF without its summary; run `clpt replay --out` again"
        ) from None
