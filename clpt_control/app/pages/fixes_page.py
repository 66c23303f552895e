"""Results, figure and page of a flow learned from fixes: errors of the forecasts, parameters."""

import json
from math import hypot
from typing import Any

import numpy as np
import xarray

from ...base.figures import BLUE, GREY, ORANGE, TITLE, axes_for, legend_below
from ...base.figures.degree_axes import degree_axes
from ...base.geodesy import LocalPlane, direction
from ...base.html import Result
from ...base.page import Page, Section, drawn, versions_section
from ...base.units import at_most, finite_or_none
from ...ocean.estimation.fix_model import LEVEL, PERCENT
from ...paper.scenario.recorded_run import fixes_of, read_estimate

Report = dict[str, Any]  # ready for JSON
MANY = 40  # legs; beyond, marks are small
SPREAD = (
    20.0  # of the largest error over the usual one; beyond, the axis is logarithmic
)
MOST_SPREAD = 1e3  # of errors below the usual one
DRAWN = """origin latitude longitude start_latitude start_longitude predicted_latitude
predicted_longitude flow leg position_error forecast_radius"""
REPORTED = """leg start_time end_time position_error forecast_radius inside flow guaranteed
flow_parameters_estimate standard_error turn noise_scale origin time_origin fix_law fix_method
guarantee"""


def fixes_page(data: xarray.Dataset, title: str | None) -> Page:
    """Return the page of a flow learned from fixes."""
    report = report_of(data)
    legs, parameters = results_of({**report, "notes": []})  # notes are warnings
    caption = (
        "Above, fixes, their forecasts and the learned flow; below, the error of each forecast "
        "before its fix was learned."
    )
    figure = drawn("fixes", 4.8, caption, learned_flow_plot, data)
    return Page(
        "Flow learned from fixes",
        title or report["title"],
        [f"Law {report['law']}, {len(report['legs'])} legs between fixes."],
        report["notes"],
        [
            Section("legs", "Legs", legs, [figure]),
            Section("parameters", "Flow parameters", parameters),
            versions_section(data.attrs),
        ],
    )


def report_of(data: xarray.Dataset, truth: "np.ndarray | None" = None) -> Report:
    """Return the results of legs by name, ready for JSON; `truth` is theta of a run, m/s."""
    data, _ = read_estimate(data, REPORTED)
    error = np.hypot(*data.position_error.values.T)
    legs = [
        {
            "leg": int(number),
            "start": str(start)[:19] + "Z",
            "end": str(end)[:19] + "Z",
            "error_m": float(size),
            "radius_m": float(radius),
            "inside": bool(inside),
            "flow": {"speed": hypot(*flow), "towards": direction(*flow) or 0.0},
            "guaranteed_m_s": finite_or_none(bound),
        }
        for number, start, end, size, radius, inside, flow, bound in zip(
            data.leg.values,
            data.start_time.values,
            data.end_time.values,
            error,
            data.forecast_radius.values,
            data.inside.values,
            data.flow.values,
            data.guaranteed.values,
            strict=True,
        )
    ]
    theta = data.flow_parameters_estimate.values[-1]
    return {
        "title": str(data.attrs.get("title", "fixes")),
        "law": data.attrs["fix_law"],
        "method": data.attrs["fix_method"],
        "origin": [float(x) for x in data.attrs["origin"]],
        "time_origin": data.attrs["time_origin"],
        "legs": legs,
        "error_rms_m": float(np.sqrt(np.mean(error**2))),
        "later_error_rms_m": float(np.sqrt(np.mean(error[len(error) // 2 :] ** 2))),
        "level": LEVEL,
        "inside": int(data.inside.sum()),
        "theta_m_s": theta.tolist(),
        "standard_error_m_s": data.standard_error.values[-1].tolist(),
        "guarantee": data.attrs["guarantee"],
        "largest_error_m_s": None if truth is None else np.abs(theta - truth).max(),
        "largest_turn_rad": float(data.turn.max()),
        "noise_scale": float(data.attrs["noise_scale"]),
        "notes": np.atleast_1d(data.attrs.get("notes", [])).tolist(),
        "skipped": json.loads(data.attrs.get("skipped", "[]")),
    }


def results_of(report: Report) -> list[Result]:
    """Return the tables of legs and of parameters."""
    legs = [
        [
            str(leg["leg"]),
            leg["end"][:16].replace("T", " "),
            f"{leg['error_m']:.0f}",
            f"{leg['radius_m']:.0f}",
            "in" if leg["inside"] else "OUT",
            f"{leg['flow']['speed']:.3f} towards {leg['flow']['towards']:.0f}",
        ]
        for leg in report["legs"]
    ]
    columns = [
        "leg",
        "fix, UTC",
        "error before learning (m)",
        f"{PERCENT} radius (m)",
        "",
        "learned flow (m/s, degrees)",
    ]
    east, north = report["theta_m_s"]
    parameters = [
        [str(k + 1), f"{a:+.4f}", f"{b:+.4f}", f"{error:.4f}"]
        for k, (a, b, error) in enumerate(
            zip(east, north, report["standard_error_m_s"], strict=True)
        )
    ]
    names = ["function", "x1 (m/s)", "x2 (m/s)", "standard error (m/s)"]
    largest = report["largest_error_m_s"]
    bound = report["legs"][-1]["guaranteed_m_s"]
    sentence = (
        "" if bound is None else f"flow at the last fix: to {at_most(bound, 3)} m/s"
    )
    sentences = [
        *([f"{sentence}, {report['guarantee']}"] if sentence else []),
        *([] if largest is None else [f"largest error: {largest:.2e} m/s"]),
        f"{report['inside']} of {len(legs)} fixes inside the {PERCENT} region of their forecast; "
        f"rms of the errors {report['error_rms_m']:.0f} m, of the later half of the legs "
        f"{report['later_error_rms_m']:.0f} m",
        *report["notes"],
        *(
            f"skipped: {'' if skip['leg'] is None else 'leg {leg}: '.format(**skip)}{skip['why']}"
            for skip in report["skipped"]
        ),
    ]
    method = f"law {report['law']}, {report['method']}"
    title = f"{report['title']}: {method}, t = 0 at {report['time_origin'][:19]} UTC"
    return [
        Result(title, columns, legs),
        Result("Flow parameters theta", names, parameters, sentences),
    ]


def learned_flow_plot(data: xarray.Dataset, *, ax: Any = None) -> np.ndarray:
    """Draw fixes, forecasts and learned flow on a map, and the error of each forecast.

    `data` is that of `flow_estimate` for legs.
    """
    data, _ = read_estimate(data, DRAWN)
    chart, errors = axes_for(ax, 6.8, 8.0, nrows=2, height_ratios=(3, 1.3))
    latitude, longitude = data.attrs["origin"]
    plane = LocalPlane(latitude, longitude, "km")
    plane.widest = np.inf  # a drawing may be distorted
    x, y = plane.to_plane(data.latitude.values, data.longitude.values)
    px, py = plane.to_plane(
        data.predicted_latitude.values, data.predicted_longitude.values
    )
    size = 3 if len(x) > MANY else 5
    fixes = plane.to_plane(*fixes_of(data)[0])
    chart.plot(*fixes, "-", color=GREY, lw=0.6, alpha=0.3)
    chart.plot(*fixes, "o", color=BLUE, ms=size, label="fix")
    chart.plot(px, py, "x", color=ORANGE, ms=size + 1, label="forecast of it")
    flow = data.flow.values
    fastest = float(f"{np.hypot(*flow.T).max():.1g}") or 0.1
    look = {"color": "black", "width": 0.003, "angles": "xy", "scale": 9 * fastest}
    arrows = chart.quiver(x, y, *flow.T, **look)
    key = f"flow of {fastest:g} m/s"
    chart.quiverkey(arrows, 0.76, 1.03, fastest, key, labelpos="E")
    chart.set_aspect("equal", adjustable="datalim")
    chart.margins(0.12, 0.25)  # arrows point beyond the fixes
    degree_axes(chart, plane, "km")
    chart.set_title("Flow learned from fixes", **TITLE)
    legend_below(chart, 3)
    numbers = data.leg.values
    error = np.hypot(*data.position_error.values.T) / 1000
    errors.fill_between(
        numbers,
        0,
        data.forecast_radius.values / 1000,
        color=GREY,
        alpha=0.3,
        lw=0,
        label=f"{PERCENT} region of the forecast",
    )
    errors.plot(
        numbers, error, "o-", color=BLUE, ms=size, label="error before learning"
    )
    errors.xaxis.get_major_locator().set_params(integer=True)
    errors.set(xlabel="leg", ylabel="position error (km)")
    largest, usual = max(float(error.max()), 1e-3), float(np.median(error))
    if 0 < usual < largest / SPREAD:  # later errors would lie on the axis
        errors.set_yscale("log")
        least = max(float(error[error > 0].min()), usual / MOST_SPREAD)
        errors.set_ylim(min(usual / SPREAD, least / 2), 3.0 * largest)
    else:
        errors.set_ylim(0, 1.15 * largest)
    legend_below(errors, 2)
    return np.array([chart, errors])
