"""A replay as NetCDF: CF discrete sampling geometry, one trajectory.

CF conventions 1.11, appendix H.4: `dive` is the element dimension, `time`,
`latitude` and `longitude` are where and when the vehicle surfaced, and a scalar
`trajectory` bears `cf_role`.  Forecast places have their own coordinates.

`FACTS` has a line for each variable of a dive: its name, units, words, CF standard name, and
which of the `flat_rows` it is where that has another name.  The plots of a replay draw the same
facts, of a replay, of its dataset or of what `clpt replay --json` prints.
"""

import json
from importlib.metadata import version
from typing import Any, NamedTuple

import numpy as np
import xarray

from ..arguments import public
from ..errors import DataError
from ..figures import literal
from ..units import known
from .outcome import flat_rows
from .places import utc
from .replay import Replay
from .step import FLOW_MODEL, MODELS
from .surfacing import ELLIPSE, NextDive, ellipse

EPOCH = "seconds since 1970-01-01 00:00:00 UTC"
SECOND, START = np.timedelta64(1, "s"), np.datetime64("1970-01-01")
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
speed_factor_standard_error | 1 | standard error of: factor on speed through water \
    | | speed_factor_error
compass_error | degree | compass error, clockwise | | compass
compass_error_standard_error | degree | standard error of: compass error, clockwise \
    | | compass_error
surface_drift | m | drift at the surface before the dive | | drift_distance
surface_drift_speed | m s-1 | speed of surface_drift | | drift_speed
surface_drift_direction | degree | where surface_drift goes to, clockwise from north \
    | | drift_direction
speed_over_ground | m s-1 | from fix to fix | platform_speed_wrt_ground | over_ground_speed
course_over_ground | degree | from fix to fix, clockwise from north | platform_course \
    | over_ground_direction
"""
FLAGS = """
inside_90 | outside inside | whether the vehicle surfaced in the 90 % ellipse of its forecast
speed_anomaly | none flagged | whether the speed factor left its credible range | | anomaly
"""
Source = Replay | xarray.Dataset | dict[str, Any]


class Fact(NamedTuple):
    """A variable of a dive, and the name `of` what it holds in `flat_rows`."""

    variable: str
    units: str
    words: str
    standard_name: str
    of: str


def parsed(text: str) -> list[Fact]:
    """Return the lines of `FACTS` or `FLAGS`, whose second field is the meaning of 0 and 1."""
    facts = []
    for line in text.strip().splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        cells += [""] * (len(Fact._fields) - len(cells))
        facts.append(Fact._make([*cells[:-1], cells[-1] or cells[0]]))
    return facts


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
        The next surfacing, which becomes scalars.

    Returns
    -------
    xarray.Dataset
        Dimension ``dive``; NaN where the vehicle's file had no value, or the
        flow model does not cover the dive.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> replay = clpt.replay.replay_dives(clpt.gliders.usable(clpt.gliders.sample_dives())[0])
    >>> data = clpt.replay.replay_dataset(replay, "SG542")
    >>> data.sizes["dive"], data.clpe_adaptive.units
    (14, 'm')
    """
    dives, rows = [step.dive for step in replay.steps], flat_rows(replay)
    small = all(abs(d.number) < 2**31 for d in dives)
    numbers = np.array([d.number for d in dives], np.int32 if small else np.int64)
    time = {"units": EPOCH, "calendar": "standard", "standard_name": "time", "axis": "T"}
    north = {"units": "degrees_north", "standard_name": "latitude", "axis": "Y"}
    east = {"units": "degrees_east", "standard_name": "longitude", "axis": "X"}
    data = xarray.Dataset(
        coords={
            "dive": ("dive", numbers, {"long_name": "number of the dive"}),
            "time": ("dive", [d.t_gpse for d in dives], {**time, "long_name": "surfacing"}),
            "latitude": ("dive", [d.lat_gpse for d in dives], north),
            "longitude": ("dive", [d.lon_gpse for d in dives], east),
        },
        attrs={
            "Conventions": "CF-1.11",
            "featureType": "trajectory",
            "title": "dead reckoning, forecasts and learned flow of a glider, dive by dive",
            "history": "written by clpt replay",
            "source": f"clpt-control {version('clpt-control')}",
            "estimator": replay.estimator,
            "flow": ",".join(replay.model.flow),
            "learn_speed": int(replay.model.learn_speed),
            "gaussian_width": replay.model.width,
            "gaussian_width_units": "m",
        },
    )
    if replay.flow_model is not None:
        data.attrs["flow_model"] = f"{replay.flow_model.source}: {replay.flow_model.about}"
    data["trajectory"] = ((), name, {"cf_role": "trajectory_id"})
    each = parsed(FACTS)
    each += [
        Fact(f"probability_{part}", "1", f"that {part} is present", "", f"probability_{part}")
        for part in replay.steps[0].parts
    ]
    each = [fact for fact in each if fact.of in rows[0]]
    names = {fact.variable for fact in each}
    for fact in each:
        more = {"standard_name": fact.standard_name} if fact.standard_name else {}
        if (wrong := f"{fact.variable}_standard_error") in names:
            more["ancillary_variables"] = wrong
        attributes = {"units": fact.units, "long_name": fact.words, **more, **ALONG}
        data[fact.variable] = ("dive", np.array([row[fact.of] for row in rows], float), attributes)
    for fact in parsed(FLAGS):
        flags = {"flag_values": np.array([0, 1], np.int8), "flag_meanings": fact.units}
        raised = np.array([bool(row[fact.of]) for row in rows], np.int8)
        data[fact.variable] = ("dive", raised, {"long_name": fact.words, **flags, **ALONG})
    if ahead is not None:
        _next(data, ahead)
    return data


def _next(data: xarray.Dataset, ahead: NextDive) -> None:
    """Add the next surfacing: when, where, and its 90 % ellipse."""
    time = ahead.plan.t_gpse
    values = time, ahead.latitude, ahead.longitude, *ellipse(ahead.covariance)
    units = EPOCH, "degrees_north", "degrees_east", "m", "m", "degree"
    names = "time", "latitude", "longitude", *ELLIPSE
    for key, value, unit in zip(names, values, units, strict=True):
        name = key.replace("_90", " of 90 %").replace("_", " ")
        words = {"long_name": f"{name} of the next surfacing, as forecast", "units": unit}
        data[f"next_{key}"] = ((), value, words)
    data["next_time"].attrs["calendar"] = "standard"


def with_summary(data: xarray.Dataset, found: dict[str, Any]) -> xarray.Dataset:
    """Return a replay's dataset with what `clpt replay --json` prints."""
    named = {"long_name": "all that was found, as JSON: what clpt replay --json prints"}
    return data.assign({SUMMARY: ((), json.dumps(found, allow_nan=False), named)})


def summary_in(data: xarray.Dataset, name: str) -> Any:
    """Return what `with_summary` put into a dataset."""
    try:
        return json.loads(str(data[SUMMARY].values))
    except (KeyError, ValueError, RecursionError):
        raise DataError(
            f"{name}: is a replay's NetCDF without its summary; run `clpt replay --out` again, or "
            "give what `clpt replay --json` prints"
        ) from None


def plot_data(source: Source) -> tuple[str, list[dict[str, Any]]]:
    """Return what plots draw, a vehicle as it is written and rows, or refuse what has no dive."""
    if isinstance(source, Replay):
        if not source.steps:
            raise DataError("the replay has no dive yet; feed one, as Replay.step does")
        vehicle, found = source.steps[-1].dive.vehicle or "glider", flat_rows(source)
    elif isinstance(source, dict) and source.get("each_dive"):
        vehicle, found = source["vehicle"], source["each_dive"]
    elif "dive" in getattr(source, "dims", ()) and "clpe_adaptive" in source:
        vehicle, found = str(source["trajectory"].values), _facts_in(source)
    else:
        raise DataError(
            f"{type(source).__name__}: is no replay; clpt.replay.replay_dives(dives) gives one, "
            "`clpt replay` writes its dataset, replay.nc"
        )
    return literal(vehicle), found


def learns_speed(rows: list[dict[str, Any]]) -> bool:
    """Whether a replay has learned a factor on speed."""
    return rows[0].get("speed_factor") is not None


def _facts_in(data: Any) -> list[dict[str, Any]]:
    """Return the facts of each dive of a dataset."""
    facts = {fact.variable: fact.of for fact in (*parsed(FACTS), *parsed(FLAGS))}
    facts |= {"latitude": "end_latitude", "longitude": "end_longitude", "dive": "dive"}
    columns = {of: [*map(known, data[k].values.tolist())] for k, of in facts.items() if k in data}
    ends = data["time"].values
    if ends.dtype.kind == "M":  # decoded
        ends = (ends - START) / SECOND
    columns["end"] = [utc(float(end)) for end in ends]
    found = [dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True)]
    for row in found:
        names = [f"forecast_{name}" for name in ("variance_east", "variance_north", "covariance")]
        east, north, both = (row[name] for name in names)
        half = ellipse(np.array([[east, both], [both, north]]))
        row |= dict(zip(ELLIPSE, half, strict=True))
        models = (name for name in (*MODELS, FLOW_MODEL) if f"clpe_{name}" in row)
        row["clpe"] = {name: row[f"clpe_{name}"] for name in models}
    return found
