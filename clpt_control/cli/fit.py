"""`clpt fit`: a scenario in a measured current."""

from pathlib import Path
from typing import Annotated

import typer

from ..html.text import Result
from .help_pages import TIDES, arg, one_of, opt
from .printing import Json, finish, shown


def fit(
    currents: Annotated[Path, arg("FILE", "NetCDF file of a gridded current.")],
    out: Annotated[Path, opt("SCENARIO", "Scenario file to write; the field lies beside it.")],
    box: Annotated[
        tuple[float, float, float, float] | None,
        opt("LAT0 LAT1 LON0 LON1", "Degrees; default: the whole grid."),
    ] = None,
    rows: Annotated[int, opt("COUNT", "Places of functions, south to north.")] = 3,
    columns: Annotated[int, opt("COUNT", "Places of functions, west to east.")] = 3,
    width_km: Annotated[float, opt("KM", "Width of the Gaussians, km.")] = 15.0,
    constituents: Annotated[
        str,
        opt(
            "NAMES",
            "steady and named tides, such as steady,M2.",
            autocompletion=one_of("steady", *TIDES),
        ),
    ] = "steady,M2",
    start_from_fit: Annotated[
        bool, typer.Option("--start-from-fit", help="Let the learner start with the fit.")
    ] = False,
    units: Annotated[
        str | None, opt("UNIT", "Of u and v, such as m/s, where the file has none.")
    ] = None,
    as_json: Json = False,
) -> None:
    """Make a scenario in a measured current, and fit its flow.

    Example:
        clpt fit currents.nc --box 40.9 41.55 -69.9 -69.0 --out mine.toml
    """
    from ..currents.fit import fit_scenario, save_fit

    fitted = fit_scenario(
        currents,
        box,
        rows=rows,
        columns=columns,
        width_km=width_km,
        constituents=tuple(name.strip() for name in constituents.split(",")),
        start_from_fit=start_from_fit,
        units=units,
    )
    save_fit(fitted, out)
    lines = [
        [key.replace("_", " "), shown(value)]
        for key, value in fitted.report.items()
        if key not in ("theta", "nodal")
    ]
    for name, tide in (fitted.report["nodal"] or {}).items():
        f, u, V = (shown(tide[key]) for key in "fuV")
        lines.append([f"{name} at the middle", f"f {f}, u {u} degrees, V {V} degrees"])
    found = Result(f"{out}: written, with the field beside it", ["", ""], lines)
    finish(found, fitted.report, as_json)
