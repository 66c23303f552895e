"""Tidal records that are known, and files of them."""

import numpy as np
import xarray
from gridded_currents import gridded_current, saying
from paths import ROOT

from clpt_control.paper.scenario.tidal_periods import SPEEDS

MARACOOS = ROOT / "clpt_control/data/maracoos_hfr_2019-01-01.nc"
LATITUDE = 41.2
# name: east amplitude (m/s) and phase (degrees), north amplitude and phase
KNOWN = {
    "M2": (0.50, 40.0, 0.30, 110.0),
    "S2": (0.15, 350.0, 0.10, 20.0),
    "K1": (0.08, 200.0, 0.06, 300.0),
    "O1": (0.05, 10.0, 0.07, 95.0),
}


def times(days, start="2019-01-01", step=60):
    return np.datetime64(start, "ms") + np.arange(
        0, days * 1440 + 1, step
    ) * np.timedelta64(1, "m")


def waves(time, known=KNOWN, mean=(0.1, -0.05)):
    """East and north, from the cosines of each tide about the first time."""
    hours = (time - time[0]) / np.timedelta64(1, "h")
    angles = {name: np.radians(SPEEDS[name] * hours) for name in known}
    parts = [
        [
            row[2 * i] * np.cos(angles[n] - np.radians(row[2 * i + 1]))
            for n, row in known.items()
        ]
        for i in (0, 1)
    ]
    return np.array([mean[i] + np.sum(parts[i], axis=0) for i in (0, 1)])


def write_table(path, time, flow, units="m/s", latitude=LATITUDE):
    comment = "" if latitude is None else f"# latitude: {latitude}\n"
    cells = [["" if np.isnan(value) else str(value) for value in part] for part in flow]
    rows = "".join(f"{t}Z,{u},{v}\n" for t, u, v in zip(time, *cells, strict=True))
    path.write_text(f"{comment}time,u ({units}),v [{units}]\n{rows}")
    return path


def write_netcdf(
    path, time, flow, *, cells=None, latitude=LATITUDE, units="m/s", calendar=None
):
    hours, since = (
        (time - time[0]) / np.timedelta64(1, "h"),
        str(time[0])[:19].replace("T", " "),
    )
    if cells is None:
        place = {} if latitude is None else {"latitude": latitude}
        u, v = (("time", part, {"units": units}) for part in flow)
        data = xarray.Dataset({"u": u, "v": v}, {"time": ("time", hours), **place})
    else:
        data = gridded_current(*flow, *cells, hours, units=units)
    saying("time", units=f"hours since {since}", calendar=calendar)(data).to_netcdf(
        path
    )
    return path
