"""`clpt fit`: a scenario in a measured current."""

from pathlib import Path
from typing import Annotated

import typer

from .printing import Json, print_json, print_table, shown


def fit(
    currents: Annotated[Path, typer.Argument(help="NetCDF file of a gridded current.")],
    out: Annotated[Path, typer.Option(help="Scenario file to write; the field lies beside it.")],
    box: Annotated[
        tuple[float, float, float, float] | None, typer.Option(help="LAT0 LAT1 LON0 LON1, degrees.")
    ] = None,
    rows: Annotated[int, typer.Option(help="Places of functions, south to north.")] = 3,
    columns: Annotated[int, typer.Option(help="Places of functions, west to east.")] = 3,
    width_km: Annotated[float, typer.Option(help="Width of the Gaussians, km.")] = 15.0,
    constituents: Annotated[
        str, typer.Option(help="steady and named tides, such as steady,M2.")
    ] = "steady,M2",
    start_from_fit: Annotated[
        bool, typer.Option("--start-from-fit", help="Let the learner start with the fit.")
    ] = False,
    units: Annotated[
        str | None, typer.Option(help="Of u and v, such as m/s, where the file has none.")
    ] = None,
    as_json: Json = False,
) -> None:
    """Fit flow basis functions to a measured current."""
    from ..currents.fit import fit_scenario
    from ..currents.fit_file import save_fit

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
    if as_json:
        print_json(fitted.report)
        return
    lines = [
        [key.replace("_", " "), shown(value)]
        for key, value in fitted.report.items()
        if key not in ("theta", "nodal")
    ]
    for name, found in (fitted.report["nodal"] or {}).items():
        f, u, V = (shown(found[key]) for key in "fuV")
        lines.append([f"{name} at the middle", f"f {f}, u {u} degrees, V {V} degrees"])
    print_table(f"{out}: written, with the field beside it", ["", ""], lines)
