"""A scenario from a measured current: the field is the truth, the basis learns.

    F(x, t) = theta phi(x, t) + Delta,  |Delta| <= its largest residual    Eq. (32)

A gridded current is projected to a local plane in km and h (origin at the
box's centre, x1 east, x2 north, t = 0 at the first step) and fitted by basis
functions of Eq. (5): gaussian kernels at the middles of rows x columns equal
parts of the box, times cos and sin of each constituent (a rotary tide needs
both; the sine is the phase -pi/2), one function for "steady".  Places are
repeated, one entry per function: all places of the first tide, then of the
next.  Kernels are 0.6 times as wide as their places are apart, so that neighbours cross at
0.7 of their height, and the learner's track is a circle of 0.32 of the way to the field's
nearest edge: 15 km and 10 km on a box of 72 x 75 km.  The fit sees measured samples only.
The scenario's true flow is the field itself, gaps filled; the learner has the basis and
starts without theta.  Its law is composite least squares: in one slice of a current, which excites
few of the functions, the paper's Eq. (21) may learn less than the mean current.

A fit on disk is SCENARIO.toml and its field beside it, both or none.  The scenario refers
to the field by its name alone, so that the two files can be moved together.
"""

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ...base.arguments import Count, Positive, public
from ...base.errors import DataError, naming
from ...base.files import check_writable, write_together
from ...base.geodesy import LocalPlane
from ...base.run_attributes import versions
from ...base.units import finite_or_none
from ...engine.model.block import evaluate
from ..scenario import tidal_periods
from ..scenario.experiment import Scenario
from ..scenario.file import load_vehicle_scenario, scenario_to_text
from .current_grid import Box, Currents, with_all_steps
from .grid_file import Source, read_currents, source_name
from .identifiability import check_nyquist, check_separable
from .least_squares import least_squares
from .plane import ORIGIN, GriddedField, field_dataset, fill_gaps, regular_grid

SINE = -np.pi / 2
SPEED = "km h-1"
KM_PER_HOUR = 3.6  # one m/s
WIDTH = 0.61  # of a kernel, in the distance between places
RADIUS = 0.32  # of the track, in the distance to the nearest edge of the field
LAW = "composite-least-squares"
PAPER_LAW = (
    '# law = "learned-flow"  # the paper\'s, Eq. (21); may learn less than the mean\n'
)
LABELS = {"functions_felt_on_the_track": "functions wide enough to reach the track"}
FELT = 0.1  # of its height: what a kernel has somewhere on a track that feels it


@dataclass(frozen=True)
class Fit:
    """A scenario made from a measured current."""

    scenario: Scenario  # in km and h; its field is not on disk before `save`
    field: GriddedField  # the true flow, km/h on a grid in km and h
    report: dict[str, Any]  # what was read, filled and fitted; fit for JSON

    @public
    def save(self, path: str | Path) -> Scenario:
        """Write the scenario, PATH.toml, with its field beside it.

        The field becomes ``PATH_field.nc``.  Returns the scenario as read back, ready to run.

        >>> fit = fit_current("currents.nc")  # doctest: +SKIP
        >>> run = clpt.simulate(fit.save("mine.toml"))  # doctest: +SKIP
        """
        out = Path(path)
        check_writable(out, "a scenario", (".toml",))
        field = out.with_name(f"{out.stem}_field.nc")
        check_writable(field)
        report, scenario = self.report, self.scenario
        attributes = {
            "title": scenario.title,
            "source": f"{report['source']}, by {versions('clpt-control')}",
            "time_origin": report["start"],
            ORIGIN: report["origin"],
            "comment": "gaps are filled harmonically in space and time; fit_report counts them",
            "fit_report": json.dumps(report),
        }
        flow = scenario.flow.model_copy(update={"field": field.name})
        text = _header(report) + scenario_to_text(
            scenario.model_copy(update={"flow": flow})
        )
        law = f'law = "{LAW}"\n'
        text = text.replace(law, law + PAPER_LAW, 1)
        write_together(
            {out: text, field: field_dataset(self.field, scenario.units, attributes)}
        )
        return load_vehicle_scenario(out)


@public
def fit_current(
    source: Source,
    box: Box | None = None,
    *,
    rows: Count = 3,
    columns: Count = 3,
    width_km: Positive | None = None,
    constituents: Sequence[str] = ("steady", "M2"),
    radius_km: Positive | None = None,
    depth: Positive | None = None,
    units: str | None = None,
    names: dict[str, str] | None = None,
) -> Fit:
    """Make a scenario of a gridded current, fitted by its basis.

    Parameters
    ----------
    source : str, Path, list of str or Path, or xarray.Dataset
        Gridded current, as in `read_currents`.
    box : tuple of float, optional
        lat0, lat1, lon0, lon1, degrees; the whole file by default.
    rows, columns : int, optional
        Places of functions from south to north and from west to east.
    width_km : float, optional
        Width of every gaussian kernel, km; 0.6 of the distance between places.
    constituents : sequence of str, optional
        Names such as ``"M2"``, and "steady".
    radius_km : float, optional
        Radius of the circle of 12 waypoints around the origin, km; 0.32 of the
        distance to the nearest edge of the field.
    depth : float, optional
        m: fit the mean from the surface to this depth, the current of a glider that dives
        so deep; by default the level nearest the surface.
    units : str, optional
        Of u and v, such as ``m/s``, where the file has none.
    names : dict, optional
        ``{"u": NAME, "v": NAME}``, names of the velocities.

    Returns
    -------
    Fit
        `scenario`, in km and h, `field`, the true flow, and `report`, a dict with theta; method
        `save("mine.toml")`.

    Raises
    ------
    DataError
        If the file cannot be used, the record is too short to tell the
        constituents apart (`check_separable`), the circle leaves the field, or
        the samples cannot separate the functions.
    ScenarioError
        If a constituent is unknown.

    Examples
    --------
    A made tide, the same everywhere:

    >>> import tempfile, xarray
    >>> hours, dims = np.arange(25.0), ("time", "lat", "lon")
    >>> tide = 0.5 * np.cos(2 * np.pi * hours / 12.42)[:, None, None] * np.ones((7, 7))
    >>> flow = (dims, tide, {"units": "m/s"})
    >>> axes = {
    ...     "time": ("time", hours, {"units": "hours since 2019-01-01"}),
    ...     "lat": np.linspace(40.9, 41.5, 7),
    ...     "lon": np.linspace(-69.9, -69.0, 7),
    ... }
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     xarray.Dataset({"u": flow, "v": flow}, axes).to_netcdf(f"{folder}/tide.nc")
    ...     fit = fit_current(f"{folder}/tide.nc", rows=2, columns=2, width_km=60)
    >>> fit.scenario.basis.N, bool(fit.report["explained_variance"] > 0.95)
    (12, True)
    """
    constituents = tuple(constituents)
    if not constituents or len(set(constituents)) != len(constituents):
        raise DataError(
            f"constituents = {','.join(constituents)}: must be names, each once"
        )
    currents = read_currents(source, box, depth=depth, units=units, names=names)
    path = source_name(source)
    with naming(path):
        currents = with_all_steps(currents)
    hours = currents.time[currents.measured.any(axis=(1, 2))]
    check_separable(constituents, float(np.ptp(hours)), path)
    tidal = [name for name in constituents if name != "steady"]
    cycles = np.array([tidal_periods.speed(name) for name in tidal]) / 360.0
    check_nyquist(hours, cycles, tidal, path)
    measured, N = (
        currents.measured,
        rows * columns * (2 * len(tidal) + ("steady" in constituents)),
    )
    if measured.sum() < N:
        raise DataError(
            f"{path}: {measured.sum()} samples for {N!s:.20} functions. Use fewer"
        )
    lat0, lat1, lon0, lon1 = currents.box
    plane = LocalPlane(round((lat0 + lat1) / 2, 9), round((lon0 + lon1) / 2, 9))
    lat, lon = currents.lat[:, None], currents.lon[None, :]
    x1, x2 = plane.to_plane(lat, lon)
    u, v = (KM_PER_HOUR * w for w in plane.rotate(lat, lon, currents.u, currents.v))
    full_u, full_v, gap = fill_gaps(
        currents.time, x2.mean(axis=1), x1.mean(axis=0), u, v
    )
    field = regular_grid(
        currents.time,
        currents.lat,
        currents.lon,
        full_u,
        full_v,
        plane,
        np.all(gap, axis=0),
    )
    room = min(-field.x1[0], field.x1[-1], -field.x2[0], field.x2[-1])
    radius_km = float(f"{RADIUS * room:.2g}" if radius_km is None else radius_km)
    if not radius_km < room:
        raise DataError(
            f"{path}: a circle of {radius_km:g} km leaves the field, of {room:.3g} km"
        )
    centers, spacing = _middles(plane, currents.box, rows, columns)
    width_km = float(f"{WIDTH * spacing:.2g}" if width_km is None else width_km)
    # of places from the track
    away = np.abs(np.hypot(*np.transpose(centers)) - radius_km)
    felt = np.exp(-((away / width_km) ** 2) / 2) >= FELT
    origin = plane.lat, plane.lon
    scenario = _scenario(currents, origin, centers, width_km, constituents, radius_km)
    t, s1, s2 = (
        np.broadcast_to(a, measured.shape)[measured]
        for a in (currents.time[:, None, None], x1, x2)
    )
    functions = zip(
        scenario.basis.constituents or (), scenario.basis.centers, strict=True
    )
    function_names = [f"{tide} at ({x:.3g}, {y:.3g}) km" for tide, (x, y) in functions]
    phi = evaluate(scenario.basis_block(), t, np.column_stack([s1, s2]))
    with naming(path):
        fit = least_squares(
            phi, np.column_stack([u[measured], v[measured]]), function_names
        )
    report = {
        "source": currents.source,
        "box": list(currents.box),
        "origin": list(origin),
        "start": currents.start,
        "functions": N,
        "functions_felt_on_the_track": int(N * felt.mean()),
        "track_radius": radius_km,
        "places": [rows, columns],
        "width": width_km,
        "width_units": "km",
        "constituents": list(constituents),
        "samples": len(t),
        "missing_fraction": float(1 - measured.mean()),
        "cells_never_measured": int(gap.all(axis=0).sum()),
        "cells_of_zeros_taken_as_land": currents.land,
        "notes": list(currents.notes),
        "explained_variance": finite_or_none(fit.explained_variance),
        "residual_rms": fit.residual_rms,
        "residual_max": fit.residual_max,
        "speed_units": SPEED,
        "condition_number": fit.condition_number,
        "theta": fit.theta.tolist(),
    }
    return Fit(scenario, field, report)


def _middles(
    plane: LocalPlane, box: Box, rows: int, columns: int
) -> tuple[list[tuple[float, float]], float]:
    """Return the middles of equal parts of a box, km, and how far they are apart.

    They go row by row from the south-west.

    None sits on the edge, where half of its kernel would see no data: on the MARACOOS
    box the middles explain 80 % of the variance, places on the edges 79, on the quarters 78.
    """
    lat0, lat1, lon0, lon1 = box
    x1 = [float(plane.to_plane(plane.lat, lon)[0]) for lon in (lon0, lon1)]
    x2 = [float(plane.to_plane(lat, plane.lon)[1]) for lat in (lat0, lat1)]
    ys, xs = (
        start + (end - start) * (np.arange(n) + 0.5) / n
        for (start, end), n in ((x2, rows), (x1, columns))
    )
    spacing = np.sqrt((x1[1] - x1[0]) / columns * (x2[1] - x2[0]) / rows)
    middles = [
        (round(float(x), 3) + 0.0, round(float(y), 3) + 0.0) for y in ys for x in xs
    ]
    return middles, float(spacing)


def _scenario(
    currents: Currents,
    origin: tuple[float, float],
    centers: list,
    width: float,
    constituents: tuple,
    radius: float,
) -> Scenario:
    """Return the scenario; `Fit.save` writes its field and names it."""
    phased = [
        (c, p) for c in constituents for p in ((0.0,) if c == "steady" else (0.0, SINE))
    ]
    car = {"feedback": [1.0, 1.0], "feedforward": [1.0, 1.0], "position": [radius, 0.0]}
    return Scenario.model_validate(
        {
            "title": f"Measured current of {currents.source} from {currents.start}",
            "origin": origin,
            "units": {"length": "km", "time": "h"},
            "basis": {
                "kernel": "gaussian",
                "centers": [center for _ in phased for center in centers],
                "widths": [width] * len(phased) * len(centers),
                "constituents": [name for name, _ in phased for _ in centers],
                "phases": [phase for _, phase in phased for _ in centers],
            },
            "flow": {"field": "field.nc", "outside": "raise"},
            "vehicle": car,
            "reference": {
                "kind": "circle",
                "radius": radius,
                "count": 12,
                "dwell": 2.0,
            },
            "learning": {"law": LAW, "gain": 5.0, **car},
            "run": {"duration": float(currents.time[-1]), "output_step": 0.1},
        }
    )


def _header(report: dict) -> str:
    """Return the comment lines that say where the scenario came from."""
    lines = [
        f"Made by {versions('clpt-control')}; x1 is east, x2 north.",
        "The true flow is the measured current, gaps filled harmonically in space and time.",
        "The learner does not know theta of the fit, which the field's fit_report has.",
    ]
    keys = [key for key in report if key != "theta"]
    lines += [f"{report_label(key)}: {report[key]}" for key in keys]
    return "".join(f"# {line}\n" for line in lines) + "\n"


def report_label(key: str) -> str:
    """Return the name of an entry of `fit_report` for a reader."""
    return LABELS.get(key, key.replace("_", " "))
