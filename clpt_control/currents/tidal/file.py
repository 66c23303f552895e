"""Tidal constants on disk: NetCDF with CF units, one entry per constituent.

`amplitude` and `phase` have the dims (constituent, axis), the ellipse's numbers
(constituent); each has its standard error beside it under `..._standard_error`.
Phases are Greenwich lags in degrees, the mean is in m/s.  `f`, `u` and `V` are
the nodal corrections at the record's middle.  Latitude and longitude are scalar
coordinates of all; times are ISO 8601, UTC.
"""

from importlib.metadata import version
from typing import TYPE_CHECKING

import numpy as np

from ..nodal import nodal_corrections
from .constants import NUMBERS, TidalFit
from .record import CurrentRecord

if TYPE_CHECKING:
    import xarray


def tides_dataset(fit: TidalFit, record: CurrentRecord) -> "xarray.Dataset":
    """Return tidal constants and the place of their record as a dataset to write."""
    import xarray

    names = [each.name for each in fit.constituents]
    tables: list[tuple[str, tuple[str, ...], str, str]] = [
        ("amplitude", ("east", "north"), "amplitude of each component", "m s-1"),
        ("phase", ("east_phase", "north_phase"), "Greenwich phase lag", "degree"),
    ]
    tables += [
        (f"ellipse_{key}", (key,), *NUMBERS[key])
        for key in ("major", "minor", "inclination", "phase")
    ]
    variables: dict[str, tuple] = {}
    for name, keys, long_name, unit in tables:
        dims = ("constituent", "axis")[: len(keys)]
        shape = (len(names), 2)[: len(keys)]
        values = [[getattr(each, key) for key in keys] for each in fit.constituents]
        errors = [[each.errors[key] for key in keys] for each in fit.constituents]
        wrong = f"{name}_standard_error"
        words = {"long_name": long_name, "units": unit, "ancillary_variables": wrong}
        variables[name] = (dims, np.reshape(values, shape), words)
        words = {"long_name": f"standard error of: {long_name}", "units": unit}
        variables[wrong] = (dims, np.reshape(errors, shape), words)
    found = nodal_corrections(names, fit.middle, fit.latitude)
    for key, long_name, unit in (
        ("f", "nodal factor", "1"),
        ("u", "nodal angle", "degree"),
        ("V", "astronomical argument at Greenwich", "degree"),
    ):
        attributes = {"long_name": f"{long_name} at nodal_time", "units": unit}
        variables[key] = ("constituent", getattr(found, key)[0], attributes)
    words = {"long_name": "mean current", "units": "m s-1"}
    variables["mean"] = ("axis", np.array(fit.mean), words)
    coordinates: dict[str, tuple] = {
        "constituent": ("constituent", names, {"long_name": "tidal constituent"}),
        "axis": ("axis", ["east", "north"], {"long_name": "component of the current"}),
    }
    for name, degrees, unit in (
        ("latitude", fit.latitude, "degrees_north"),
        ("longitude", record.longitude, "degrees_east"),
    ):
        if degrees is not None:
            coordinates[name] = ((), degrees, {"standard_name": name, "units": unit})
    return xarray.Dataset(
        variables,
        coordinates,
        {
            "Conventions": "CF-1.11",
            "title": f"Tidal constants of {record.source}",
            "history": "written by clpt tides",
            "source": f"{record.source}, by clpt-control {version('clpt-control')} and UTide",
            "time_coverage_start": f"{fit.start}Z",
            "time_coverage_end": f"{fit.end}Z",
            "nodal_time": f"{fit.middle}Z",
            "samples": fit.samples,
            "explained_variance": fit.explained_variance,
            "residual_rms": fit.residual_rms,
            "residual_rms_units": "m s-1",
            "comment": "tide(t) = f(t) amplitude cos(V(t) + u(t) - phase)",
        },
    )
