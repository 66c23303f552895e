"""A replay as NetCDF: CF discrete sampling geometry, one trajectory.

CF conventions 1.11, appendix H.4: `dive` is the element dimension, `time`,
`latitude` and `longitude` are where and when the vehicle surfaced, and a scalar
`trajectory` bears `cf_role`.  Forecast places have their own coordinates.
"""

import json
from collections.abc import Sequence
from importlib.metadata import version
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arguments import public
from ..errors import DataError
from ..geodesy import place_from
from .over_ground import drifts, over_ground
from .replay import Replay
from .step import ellipse
from .surfacing import NextDive
from .wording import direction

if TYPE_CHECKING:
    import xarray

EPOCH = "seconds since 1970-01-01 00:00:00 UTC"
SUMMARY = "summary"  # variable: what `clpt replay --json` prints
ALONG = {"coordinates": "time latitude longitude"}


@public
def replay_dataset(
    replay: Replay, name: str = "glider", ahead: NextDive | None = None
) -> "xarray.Dataset":
    """Return a replay as a dataset.

    Parameters
    ----------
    replay : Replay
        With one dive at least.
    name : str, optional
        Of the trajectory.
    ahead : NextDive, optional
        The next surfacing, which scalars then say.

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
    import xarray

    steps = replay.steps
    dives = [step.dive for step in steps]
    forecast = np.array(
        [
            place_from(
                d.lat_gps2, d.lon_gps2, d.dr_east + s.forecast[0], d.dr_north + s.forecast[1]
            )
            for s, d in zip(steps, dives, strict=True)
        ]
    ).reshape(-1, 2)
    reckoned = np.array(
        [place_from(d.lat_gps2, d.lon_gps2, d.dr_east, d.dr_north) for d in dives]
    ).reshape(-1, 2)
    numbers = np.array([d.number for d in dives], np.int64)
    if np.all(np.abs(numbers) < 2**31):
        numbers = numbers.astype(np.int32)
    time = {"units": EPOCH, "calendar": "standard", "standard_name": "time", "axis": "T"}
    north = {"units": "degrees_north", "standard_name": "latitude"}
    east = {"units": "degrees_east", "standard_name": "longitude"}
    data = xarray.Dataset(
        coords={
            "dive": ("dive", numbers, {"long_name": "number of the dive"}),
            "time": ("dive", [d.t_gpse for d in dives], {**time, "long_name": "surfacing"}),
            "latitude": ("dive", [d.lat_gpse for d in dives], {**north, "axis": "Y"}),
            "longitude": ("dive", [d.lon_gpse for d in dives], {**east, "axis": "X"}),
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
    data["trajectory"] = ((), name, {"cf_role": "trajectory_id"})

    def add(key: str, values: list, units: str, long_name: str, **more: str) -> None:
        column = np.array([np.nan if v is None else v for v in values], float)
        data[key] = ("dive", column, {"units": units, "long_name": long_name, **more, **ALONG})

    add("start_time", [d.t_gps2 for d in dives], EPOCH, "last fix before the dive")
    for axis, where in (("latitude", north), ("longitude", east)):
        k = axis == "longitude"
        start = [d.lon_gps2 if k else d.lat_gps2 for d in dives]
        for key, values, long_name in (
            ("start", start, "last fix before the dive"),
            ("reckoned", list(reckoned[:, int(k)]), "end of the dive by dead reckoning"),
            ("forecast", list(forecast[:, int(k)]), "surfacing as forecast"),
        ):
            add(f"{key}_{axis}", values, where["units"], f"{axis}, {long_name}")
    for model in replay.models:
        add(
            f"clpe_{model}",
            [s.clpe[model] for s in steps],
            "m",
            f"prediction error at the surfacing, flow: {model.replace('_', ' ')}",
        )
    if replay.flow_model is not None:
        data.attrs["flow_model"] = f"{replay.flow_model.source}: {replay.flow_model.about}"
        for axis in ("east", "north"):
            add(
                f"flow_model_{axis}",
                [getattr(d, f"model_{axis}") for d in dives],
                "m",
                f"displacement of the vehicle by the flow model, {axis}",
            )
    for i, axis in enumerate(("east", "north")):
        sea = {"standard_name": f"{axis}ward_sea_water_velocity"}
        add(
            f"current_{axis}",
            [s.current[i] for s in steps],
            "m s-1",
            f"learned current over the dive, {axis}",
            **sea,
        )
        add(
            f"current_{axis}_error",
            [s.current_error[i] for s in steps],
            "m s-1",
            f"standard error of current_{axis}",
        )
        add(
            f"file_current_{axis}",
            [getattr(d, f"dac_{axis}") for d in dives],
            "m s-1",
            f"depth-averaged current of the vehicle's own file, {axis}",
        )
        add(
            f"forecast_{axis}",
            [s.forecast[i] for s in steps],
            "m",
            f"fix less dead reckoning as forecast, {axis}",
        )
        add(
            f"forecast_variance_{axis}",
            [s.covariance[i, i] for s in steps],
            "m2",
            f"variance of forecast_{axis}",
        )
    add(
        "forecast_covariance",
        [s.covariance[0, 1] for s in steps],
        "m2",
        "covariance of forecast_east and forecast_north",
    )
    for part in steps[0].parts if steps else ():
        add(f"probability_{part}", [s.parts[part] for s in steps], "1", f"that {part} is present")
    if replay.model.learn_speed:
        for key, values, errors, units, long_name in (
            (
                "speed_factor",
                [s.speed for s in steps],
                [s.speed_error for s in steps],
                "1",
                "factor on speed through water",
            ),
            (
                "compass_error",
                [s.compass for s in steps],
                [s.compass_error for s in steps],
                "degree",
                "compass error, clockwise",
            ),
        ):
            wrong = f"{key}_standard_error"
            add(key, values, units, long_name, ancillary_variables=wrong)
            add(wrong, errors, units, f"standard error of: {long_name}")
    for key, said, no, yes, long_name in (
        (
            "inside_90",
            [s.inside for s in steps],
            "outside",
            "inside",
            "whether the vehicle surfaced in the 90 % ellipse of its forecast",
        ),
        (
            "speed_anomaly",
            [s.anomaly is not None for s in steps],
            "none",
            "flagged",
            "whether the speed factor left its credible range",
        ),
    ):
        data[key] = (
            "dive",
            np.array(said, np.int8),
            {
                "long_name": long_name,
                "flag_values": np.array([0, 1], np.int8),
                "flag_meanings": f"{no} {yes}",
                **ALONG,
            },
        )
    _over_ground(data, replay)
    if ahead is not None:
        _next(data, ahead)
    return data


def _over_ground(data: "xarray.Dataset", replay: Replay) -> None:
    """Add drift at the surface, way over ground, size and direction of the current."""
    dives = [step.dive for step in replay.steps]
    ways = [None if way is None else way.as_dict() for way in drifts(dives)]
    made = [over_ground(dive).as_dict() for dive in dives]
    for key, values, units, long_name, standard in (
        ("surface_drift", _of(ways, "distance"), "m", "drift at the surface before the dive", ""),
        ("surface_drift_speed", _of(ways, "speed"), "m s-1", "speed of surface_drift", ""),
        (
            "surface_drift_direction",
            _of(ways, "direction"),
            "degree",
            "where surface_drift goes to, clockwise from north",
            "",
        ),
        (
            "speed_over_ground",
            _of(made, "speed"),
            "m s-1",
            "from fix to fix",
            "platform_speed_wrt_ground",
        ),
        (
            "course_over_ground",
            _of(made, "direction"),
            "degree",
            "from fix to fix, clockwise from north",
            "platform_course",
        ),
        (
            "current_speed",
            [float(np.hypot(*step.current)) for step in replay.steps],
            "m s-1",
            "learned current over the dive",
            "sea_water_speed",
        ),
        (
            "current_direction",
            [direction(*map(float, step.current)) for step in replay.steps],
            "degree",
            "where the learned current goes to, clockwise from north",
            "sea_water_velocity_to_direction",
        ),
    ):
        column = np.array([np.nan if v is None else v for v in values], float)
        more = {"standard_name": standard} if standard else {}
        data[key] = ("dive", column, {"units": units, "long_name": long_name, **more, **ALONG})


def _of(ways: Sequence[dict | None], key: str) -> list:
    return [None if way is None else way[key] for way in ways]


def _next(data: "xarray.Dataset", ahead: NextDive) -> None:
    """Add the next surfacing: when, where, and its 90 % ellipse."""
    long, short, bearing = ellipse(ahead.covariance)
    said = "of the next surfacing, as forecast"
    for key, value, attributes in (
        ("next_time", ahead.plan.t_gpse, {"units": EPOCH, "calendar": "standard"}),
        ("next_latitude", ahead.latitude, {"units": "degrees_north"}),
        ("next_longitude", ahead.longitude, {"units": "degrees_east"}),
        ("next_ellipse_90_long", long, {"units": "m"}),
        ("next_ellipse_90_short", short, {"units": "m"}),
        ("next_ellipse_90_bearing", bearing, {"units": "degree"}),
    ):
        name = key.removeprefix("next_").replace("_90", " of 90 %").replace("_", " ")
        data[key] = ((), value, {"long_name": f"{name} {said}", **attributes})


def carrying(data: "xarray.Dataset", found: dict[str, Any]) -> "xarray.Dataset":
    """Return a replay's dataset that carries what `clpt replay --json` prints."""
    named = {"long_name": "all that was found, as JSON: what clpt replay --json prints"}
    return data.assign({SUMMARY: ((), json.dumps(found, allow_nan=False), named)})


def carried(data: "xarray.Dataset", name: str) -> Any:
    """Return what `carrying` put into a dataset."""
    try:
        return json.loads(str(data[SUMMARY].values))
    except (KeyError, ValueError):
        raise DataError(
            f"{name}: is a replay's NetCDF without its summary; run `clpt replay --out` again, or "
            "give what `clpt replay --json` prints"
        ) from None
