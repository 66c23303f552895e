"""`clpt tides`: tidal constants of a current record."""

from pathlib import Path
from typing import Annotated, Any

from ..html.text import Result
from .help_pages import TIDES, arg, one_of, opt
from .printing import Formats, Json, finish


def tides(
    record: Annotated[Path, arg("FILE", "NetCDF, or CSV with time, u and v.")],
    constituents: Annotated[
        str,
        opt(
            "NAMES",
            "Named tides, such as M2,S2,K1; auto: all that can be told apart.",
            autocompletion=one_of("auto", *TIDES),
        ),
    ],
    latitude: Annotated[
        float | None, opt("DEGREES", "Degrees north; default: the file's own.")
    ] = None,
    at: Annotated[
        tuple[float, float] | None, opt("LAT LON", "Degrees: the nearest cell of a grid.")
    ] = None,
    units: Annotated[
        str | None, opt("UNIT", "Of u and v, such as m/s, where the file has none.")
    ] = None,
    out: Annotated[Path | None, opt("FOLDER", "Folder for tides.nc and its figure.")] = None,
    formats: Formats = None,
    as_json: Json = False,
) -> None:
    """Fit tidal constituents to a current record.

    Example:
        clpt tides record.nc --constituents M2,S2,K1 --out tides
    """
    from ..currents.record import read_record
    from ..currents.tidal_constants import tides_dataset, tides_report
    from ..currents.tides import fit_tides
    from ..figures import checked_formats, figure_of
    from ..files import make_folder, write_together

    kinds = checked_formats(formats or ["png"])
    measured = read_record(record, latitude, at, units)
    names = [name.strip() for name in constituents.split(",")]
    fit = fit_tides(
        measured.time,
        measured.u,
        measured.v,
        measured.latitude,
        "auto" if names == ["auto"] else names,
        where=str(record),
    )
    report = {"source": measured.source, **tides_report(fit)}
    written: list[Path] = []
    if out is not None:
        from ..currents.tidal_plots import tides_plot

        results: dict[Path, Any] = {make_folder(out) / "tides.nc": tides_dataset(fit, measured)}
        figure = figure_of(tides_plot, fit, measured)
        results |= {out / f"tides.{kind}": figure for kind in kinds}
        write_together(results)
        written = list(results)
    finish(tides_result(report), report, as_json, *written)


def tides_result(report: dict[str, Any]) -> Result:
    """Return tidal constants: a row per constituent, then the whole."""
    rows = []
    for name, each in report["constituents"].items():
        row = [name]
        for key, error in each["standard_errors"].items():
            digits = 4 if key in ("east", "north", "major", "minor") else 1
            if error is None or (digits == 1 and error > 90.0):
                words = "any"  # an angle as good as unknown
            else:
                words = f"{error:.{digits}f}"
            row.append(f"{each[key]:.{digits}f} ({words})")
        rows.append(row)
    title = (
        f"Tides of {report['source']}: amplitudes and axes in m/s, Greenwich phases and "
        "inclination in degrees (standard error)"
    )
    east, north = report["mean"]
    said = [
        f"{report['samples']} measurements over {report['hours']:.6g} h from "
        f"{report['start'][:16]} UTC, latitude {report['latitude']:g}",
        f"mean current: {east:+.4f} east, {north:+.4f} north (m/s)",
        f"explained: {report['explained_variance']:.1%} of the variance; residual rms "
        f"{report['residual_rms']:.4f} m/s",
    ]
    columns = ["", "east", "phase", "north", "phase", "major", "minor", "incl.", "phase"]
    return Result(title, columns, rows, said)
