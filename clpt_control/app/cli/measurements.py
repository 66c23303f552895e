"""Command `clpt fit`: a scenario in a measured current, or tides of a record."""

from pathlib import Path
from typing import Any

import clpt_control as clpt

from ...base.errors import ScenarioError
from ...base.html import Result
from ...base.units import percent
from .printing import Json, Report, arg, cell_text, finish, flag, opt

MOSTLY = 0.5  # least share of the variance that functions should explain


def fit(
    currents: Path = arg(
        "FILE",
        "NetCDF file of a gridded current, Zarr, or a folder of files; with --tides a record.",
    ),
    out: Path | None = opt(
        "SCENARIO", "Scenario file to write; the field lies beside it."
    ),
    box: tuple[float, float, float, float] | None = opt(
        "LAT0 LAT1 LON0 LON1", "Degrees; default: the whole grid."
    ),
    rows: int = opt("COUNT", "Centers of functions, south to north.", default=3),
    columns: int = opt("COUNT", "Centers of functions, west to east.", default=3),
    width_km: float | None = opt(
        "KM",
        "Width of the Gaussians, km; default: 0.6 of the distance between centers.",
    ),
    constituents: str | None = opt(
        "NAMES",
        "steady and named tides; default: steady,M2. With --tides such as M2,S2,K1, or auto: all "
        "that are distinguishable.",
    ),
    depth: float | None = opt(
        "METRES",
        "Mean of the levels from the surface to this depth, the current of a glider that dives so "
        "deep; default: the level nearest the surface. With --tides: the level nearest this depth.",
    ),
    units: str | None = opt(
        "UNIT", "Units of u and v, such as m/s, if the file has none."
    ),
    u: str | None = opt("NAME", "Variable of the eastward velocity; needs --v."),
    v: str | None = opt("NAME", "Variable of the northward velocity; needs --u."),
    tides: bool = flag(
        "Fit tidal constituents to a record at one place instead.", "--tides"
    ),
    latitude: float | None = opt(
        "DEGREES", "With --tides: degrees north; default: the file's own."
    ),
    at: tuple[float, float] | None = opt(
        "LAT LON", "With --tides: degrees, the nearest cell of a grid."
    ),
    as_json: Json = False,
) -> None:
    """Make a scenario in a measured current, or fit tides to a record.

    Example:
        clpt fit currents.nc --box 40.9 41.55 -69.9 -69.0 --out mine.toml
        clpt fit record.nc --tides --constituents M2,S2,K1
    """
    if (u is None) != (v is None):
        raise ScenarioError("--u and --v: one is missing. Give both names")
    if tides:
        if u is not None:
            raise ScenarioError("--u, --v: not with --tides. Name the columns u and v")
        if constituents is None:
            raise ScenarioError("--tides: needs --constituents, such as M2,S2, or auto")
        record = clpt.currents.read_record(currents, latitude, at, units, depth)
        _fit_tides(record, str(currents), constituents, as_json)
        return
    if out is None:
        raise ScenarioError("--out: is missing. Give the scenario file to write")
    names = tuple(name.strip() for name in (constituents or "steady,M2").split(","))
    from ...paper.currents.fit import report_label
    from ...theory.excitation.gramian import not_learned

    fitted = clpt.currents.fit_current(
        currents,
        box,
        rows=rows,
        columns=columns,
        width_km=width_km,
        constituents=names,
        depth=depth,
        units=units,
        names=None if u is None or v is None else {"u": u, "v": v},
    )
    scenario = fitted.save(out)
    length, speed = fitted.report["width_units"], fitted.report["speed_units"]
    unit_of = dict.fromkeys(("track_radius", "width"), f" {length}")
    unit_of |= dict.fromkeys(("residual_rms", "residual_max"), f" {speed}")
    lines = [
        [report_label(key), cell_text(value) + unit_of.get(key, "")]
        for key, value in fitted.report.items()
        if key not in ("theta", "width_units", "speed_units", "notes")
    ]
    missing = not_learned(scenario)
    sentences = [
        sentence
        for sentence in (
            *fitted.report["notes"],
            _explained_too_little(fitted.report),
            missing,
        )
        if sentence
    ]
    result = Result(
        f"Wrote {out}, with the field next to it", ["", ""], lines, sentences
    )
    finish([result], fitted.report | {"not_learnable": missing}, as_json)


def _explained_too_little(fit: Report) -> str:
    """Return a warning if the functions fit the current badly, with the remedy."""
    explained = fit["explained_variance"] or 0
    if explained < 0:
        return "the fit is worse than the mean current alone; --width-km wider than that may do"
    if explained < MOSTLY:
        return (
            f"the functions explain {percent(explained)} of the current's variance: no law learns "
            "more of the box; more --constituents, --rows and --columns, or a smaller --box, may do"
        )
    return ""


def _fit_tides(measured: Any, where: str, constituents: str, as_json: bool) -> None:
    """Print the tidal constants of a record."""
    names = [name.strip() for name in constituents.split(",")]
    current = measured.time, measured.u, measured.v, measured.latitude
    fit = clpt.currents.fit_tides(*current, names, where=where)
    report = {"source": measured.source, **fit.as_dict()}
    report["notes"] = list(measured.notes)
    finish([tides_result(report)], report, as_json)


def tides_result(report: Report) -> Result:
    """Return tidal constants: a row per constituent, then the whole."""
    rows = []
    for name, constituent in report["constituents"].items():
        row = [name]
        for key, error in constituent["standard_errors"].items():
            digits = 4 if key in ("east", "north", "major", "minor") else 1
            words = "any" if error is None else f"{error:.{digits}f}"
            row.append(f"{constituent[key]:z.{digits}f} ({words})")
        rows.append(row)
    title = (
        f"Tides of {report['source']}: amplitudes and axes in m/s, Greenwich phases and "
        "inclination in degrees (standard error)"
    )
    east, north = report["mean"]
    sentences = [
        *report["notes"],
        f"{report['samples']} measurements over {report['hours']:.6g} h from "
        f"{report['start'][:16]} UTC, latitude {report['latitude']:g}",
        f"mean current: {east:+z.4f} east, {north:+z.4f} north (m/s)",
        f"explained: {percent(report['explained_variance'])} of the variance; residual rms "
        f"{report['residual_rms']:.4f} m/s",
    ]
    columns = [
        "",
        "east",
        "phase",
        "north",
        "phase",
        "major",
        "minor",
        "incl.",
        "phase",
    ]
    return Result(title, columns, rows, sentences)
