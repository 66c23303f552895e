"""Command `clpt fit`: a scenario in a measured current."""

from pathlib import Path

import clpt_control as clpt

from ...base.errors import ScenarioError
from ...base.html import Result
from ...base.units import percent
from .printing import Json, Report, arg, cell_text, finish, opt

MOSTLY = 0.5  # least share of the variance that functions should explain


def fit(
    currents: Path = arg(
        "FILE", "NetCDF file of a gridded current, Zarr, or a folder of files."
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
        "NAMES", "steady and named tides; default: steady,M2."
    ),
    depth: float | None = opt(
        "METRES",
        "Mean of the levels from the surface to this depth, the current of a glider that dives so "
        "deep; default: the level nearest the surface.",
    ),
    units: str | None = opt(
        "UNIT", "Units of u and v, such as m/s, if the file has none."
    ),
    u: str | None = opt("NAME", "Variable of the eastward velocity; needs --v."),
    v: str | None = opt("NAME", "Variable of the northward velocity; needs --u."),
    as_json: Json = False,
) -> None:
    """Make a scenario in a measured current.

    Example:
        clpt fit currents.nc --box 40.9 41.55 -69.9 -69.0 --out mine.toml
    """
    if (u is None) != (v is None):
        raise ScenarioError("--u and --v: one is missing. Give both names")
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
    length = fitted.report["width_units"]
    speed = fitted.report["speed_units"]
    unit_of = dict.fromkeys(("track_radius", "width"), f" {length}")
    unit_of |= dict.fromkeys(("residual_rms", "residual_max"), f" {speed}")
    lines = [
        [report_label(key), cell_text(value) + unit_of.get(key, "")]
        for key, value in fitted.report.items()
        if key not in ("theta", "width_units", "speed_units", "notes")
    ]
    missing = not_learned(scenario)
    warnings = _explained_too_little(fitted.report), missing
    sentences = [*fitted.report["notes"], *filter(None, warnings)]
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
