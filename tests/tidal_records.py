"""Tidal records that are known, and files of them."""

from pathlib import Path

import numpy as np
import xarray
from made_fields import gridded_current, saying

from clpt_control.currents.constituents import nodal_corrections
from clpt_control.scenario.tidal_periods import SPEEDS

MARACOOS = Path(__file__).parents[1] / "clpt_control/data/maracoos_hfr_2019-01-01.nc"
LATITUDE = 41.2
# name: east amplitude (m/s) and phase (degrees), north amplitude and phase
KNOWN = {
    "M2": (0.50, 40.0, 0.30, 110.0),
    "S2": (0.15, 350.0, 0.10, 20.0),
    "K1": (0.08, 200.0, 0.06, 300.0),
    "O1": (0.05, 10.0, 0.07, 95.0),
}


def moon(time):
    """Mean longitudes of moon, sun and node in degrees (J. Meeus, Astronomical Algorithms)."""
    days = (time - np.datetime64("2000-01-01T12")) / np.timedelta64(1, "D")
    T = days / 36525
    return 218.3164477 + 481267.88123 * T, 280.46646 + 36000.76983 * T, 125.04452 - 1934.136261 * T


def classical_m2(time):
    """f and u of M2 by the series in the node (D. Pugh, Tides, Surges and Mean Sea-Level)."""
    N = np.radians(moon(time)[2])
    return 1.0004 - 0.0373 * np.cos(N) + 0.0002 * np.cos(2 * N), -2.14 * np.sin(N)


def times(days, start="2019-01-01", step=60):
    return np.datetime64(start, "ms") + np.arange(0, days * 1440 + 1, step) * np.timedelta64(1, "m")


def waves(time, known=KNOWN, mean=(0.1, -0.05)):
    """East and north, from the cosines of each tide about the first time."""
    hours = (time - time[0]) / np.timedelta64(1, "h")
    angles = {name: np.radians(SPEEDS[name] * hours) for name in known}
    parts = [
        [row[2 * i] * np.cos(angles[n] - np.radians(row[2 * i + 1])) for n, row in known.items()]
        for i in (0, 1)
    ]
    return np.array([mean[i] + np.sum(parts[i], axis=0) for i in (0, 1)])


def local(fit, at):
    """Amplitude and phase about a time, from Greenwich constants."""
    f, u, V = nodal_corrections([each.name for each in fit.constituents], [at], LATITUDE)
    return {
        each.name: (
            f[0, k] * each.east,
            (each.east_phase - V[0, k] - u[0, k]) % 360,
            f[0, k] * each.north,
            (each.north_phase - V[0, k] - u[0, k]) % 360,
        )
        for k, each in enumerate(fit.constituents)
    }


def write_table(path, time, flow, units="m/s", latitude=LATITUDE):
    comment = "" if latitude is None else f"# latitude: {latitude}\n"
    cells = [["" if np.isnan(value) else str(value) for value in part] for part in flow]
    rows = "".join(f"{t}Z,{u},{v}\n" for t, u, v in zip(time, *cells, strict=True))
    path.write_text(f"{comment}time,u ({units}),v [{units}]\n{rows}")
    return path


def write_netcdf(path, time, flow, *, cells=None, latitude=LATITUDE, units="m/s", calendar=None):
    hours, since = (time - time[0]) / np.timedelta64(1, "h"), str(time[0])[:19].replace("T", " ")
    if cells is None:
        place = {} if latitude is None else {"latitude": latitude}
        u, v = (("time", part, {"units": units}) for part in flow)
        data = xarray.Dataset({"u": u, "v": v}, {"time": ("time", hours), **place})
    else:
        data = gridded_current(*flow, *cells, hours, units=units)
    saying("time", units=f"hours since {since}", calendar=calendar)(data).to_netcdf(path)
    return path


HEADER = "# latitude: 41\ntime,u (m/s),v (m/s)\n"
ROW = "2019-01-01T0{}:00,0.1,0.2\n"
