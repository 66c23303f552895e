"""A replay as NetCDF: CF discrete sampling geometry, one trajectory.

CF conventions 1.11, appendix H.4: `dive` is the element dimension, `time`,
`latitude` and `longitude` are where and when the vehicle surfaced, and a scalar
`trajectory` bears `cf_role`.  Forecast places have their own coordinates.

It holds what `clpt replay --json` prints, whole as the variable `summary`, and a variable for each
number of its rows: what is within a part of a row is PART_NAME, such as `clpe_adaptive`.  Units of
the fields of a dive are in their rows (`dive_fields`); other units are by names, `UNITS`.  Page,
plots, tables and files for other programs are made of the same JSON.
"""

import json
import re
from collections.abc import Sequence
from typing import Any

import numpy as np
import pandas
import xarray

from ...base.arguments import public
from ...base.errors import DataError
from ...base.run_attributes import versions
from ...base.units import seconds_since_1970
from ..gliders.dive_fields import EPOCH
from ..gliders.dives import FIELDS
from .aim import Aim
from .surfacing import ELLIPSE, NextDive

SUMMARY = "summary"  # variable: what `clpt replay --json` prints
ALONG = {"coordinates": "time latitude longitude"}
UNITS = {  # pattern of a name: units; the first that matches counts
    r".*latitude": "degrees_north",
    r".*longitude": "degrees_east",
    r".*(direction|bearing)|compass.*": "degree",
    r".*(duration|time_half_width)": "s",
    r"(probability|speed_factor).*": "1",
    r".*(variance|covariance).*": "m2",
    r".*(current|speed).*": "m s-1",
    r".*": "m",
}
FIELD_UNITS = {field.result: field.unit for field in FIELDS}
STANDARD = {  # names of CF
    "current_east": "eastward_sea_water_velocity",
    "current_north": "northward_sea_water_velocity",
    "current_speed": "sea_water_speed",
    "current_direction": "sea_water_velocity_to_direction",
    "over_ground_speed": "platform_speed_wrt_ground",
    "over_ground_direction": "platform_course",
}
COORDINATES = ("dive", "end_time", "end_latitude", "end_longitude")
Source = Any  # a Replay, its dataset or its JSON


def report_of(source: Source, name: str = "the replay") -> dict[str, Any]:
    """Return what `clpt replay --json` prints of a replay, or of the dataset or JSON of one.

    With the next surfacing as the replay expects it.  What has no dive is refused.
    """
    report = source
    if isinstance(source, xarray.Dataset):
        try:
            report = json.loads(str(source[SUMMARY].values))
        except (KeyError, ValueError, RecursionError):
            raise DataError(
                f"{name}: is a replay's NetCDF without its summary. Run `clpt replay --out` again"
            ) from None
    elif hasattr(source, "steps"):
        report = source.summary()
    if not (isinstance(report, dict) and "hindsight" in report):
        raise DataError(
            f"{name}: is a replay of an earlier version. Run `clpt replay` again"
        )
    if not report.get("each_dive") or report.get("next_dive") is None:
        raise DataError(
            f"{name}: is a replay without a dive. Give a replay with one dive at least"
        )
    return {"vehicle": "glider", "aim": [], **report}


@public
def dataset(
    self: Any, next_dive: NextDive | None = None, aims: Sequence[Aim] = ()
) -> xarray.Dataset:
    """Return a replay of one dive at least as a dataset.

    Parameters
    ----------
    next_dive : NextDive, optional
        By default as the replay expects it.
    aims : sequence of Aim, optional
        As `Replay.aims` returns them.

    Returns
    -------
    xarray.Dataset
        Dimension ``dive``; NaN where the vehicle's file had no value, or the
        flow model does not cover the dive.  What no dive has is left out.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> data = clpt.replay.replay_dives(clpt.gliders.sample_dives()).dataset()
    >>> data.sizes["dive"], data.clpe_adaptive.units
    (14, 'm')
    """
    return dataset_of(self.summary(next_dive=next_dive, aims=aims))


def dataset_of(replay: Source) -> xarray.Dataset:
    """Return a replay, or what `clpt replay --json` prints of one, as a dataset."""
    report = report_of(replay)
    table = pandas.json_normalize(report["each_dive"], sep="_")
    time = {
        "units": EPOCH,
        "calendar": "standard",
        "standard_name": "time",
        "axis": "T",
    }
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
            name: ("dive", table[key].to_numpy(), attributes)
            for name, (key, attributes) in coords.items()
        },
        attrs={
            "Conventions": "CF-1.11",
            "featureType": "trajectory",
            "title": "dead reckoning, forecasts and learned flow of a glider, dive by dive",
            "history": "written by clpt replay",
            "source": versions("clpt-control"),
            "estimator": report["estimator"],
            "flow": ",".join(report["flow"]),
            "learn_speed": int(report["learn_speed"]),
            "level": report["level"],
        },
    )
    if "flow_model" in report:
        data.attrs["flow_model"] = "{source}: {about}".format(**report["flow_model"])
    data["trajectory"] = ((), report["vehicle"], {"cf_role": "trajectory_id"})
    for name, column in table.drop(columns=[*COORDINATES]).items():
        attributes = {"long_name": name.replace("_", " "), **ALONG}
        filled = column.dropna()
        if len(filled) and all(isinstance(value, bool | np.bool_) for value in filled):
            flags = {
                "flag_values": np.array([-1, 0, 1], np.int8),
                "flag_meanings": "unknown no yes",
            }
            values = np.array(column.fillna(-1), np.int8)
            data[name] = ("dive", values, attributes | flags)
        elif column.dtype == float and column.notna().any():
            attributes["units"] = units_of(name)
            if name in STANDARD:
                attributes["standard_name"] = STANDARD[name]
            if f"{name}_error" in table:
                attributes["ancillary_variables"] = f"{name}_error"
            data[name] = ("dive", column.to_numpy(), attributes)
    ahead = {
        key: report["next_dive"][key] for key in ("latitude", "longitude", *ELLIPSE)
    }
    ahead["time"] = seconds_since_1970(report["next_dive"]["time"])
    for name, value in ahead.items():
        long_name = {
            "long_name": f"{name.replace('_', ' ')} of the next surfacing, as forecast"
        }
        attributes_of_next = time if name == "time" else {"units": units_of(name)}
        data[f"next_{name}"] = ((), value, attributes_of_next | long_name)
    words = "all that was found, as JSON: what clpt replay --json prints"
    return data.assign(
        {SUMMARY: ((), json.dumps(report, allow_nan=False), {"long_name": words})}
    )


def units_of(name: str) -> str:
    """Return the units of a number: those of a field of a dive, or by its name."""
    by_name = (units for pattern, units in UNITS.items() if re.fullmatch(pattern, name))
    return FIELD_UNITS.get(name) or next(by_name)
