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
    centers: Annotated[str, typer.Option(help="Places of the functions, such as 3x3.")] = "3x3",
    width: Annotated[str, typer.Option(help="Width of the Gaussians, such as 15km.")] = "15km",
    constituents: Annotated[
        str, typer.Option(help="steady and named tides, such as steady,M2.")
    ] = "steady,M2",
    start_from_fit: Annotated[
        bool, typer.Option("--start-from-fit", help="Let the learner start with the fit.")
    ] = False,
    as_json: Json = False,
) -> None:
    """Fit flow basis functions to a measured current."""
    from ..currents.fit import fit_scenario, read_centers, read_width
    from ..currents.fit_file import save_fit

    fitted = fit_scenario(
        currents,
        box,
        centers=read_centers(centers),
        width_km=read_width(width),
        constituents=tuple(name.strip() for name in constituents.split(",")),
        start_from_fit=start_from_fit,
    )
    save_fit(fitted, out)
    if as_json:
        print_json(fitted.report)
        return
    rows = [
        [key.replace("_", " "), shown(value)]
        for key, value in fitted.report.items()
        if key not in ("theta", "nodal")
    ]
    for name, found in (fitted.report["nodal"] or {}).items():
        f, u, V = (shown(found[key]) for key in "fuV")
        rows.append([f"{name} at the middle", f"f {f}, u {u} degrees, V {V} degrees"])
    print_table(f"{out}: written, with the field beside it", ["", ""], rows)
