"""Flow models: a gridded forecast or a fitted basis, and the displacement of a dive by them.

Dead reckoning carried by a flow model F is

    dz/dt = v_dr(t) + F(z, t),    z(GPS2) = the fix,

Eq. (10)'s z between two fixes; what F adds to the dead reckoning,

    q(T) = int_0^T F(z(t), t) dt,    dq/dt = F(z_dr(t) + q, t),  q(0) = 0,

is the model's forecast of the miss, m east and north.  z_dr is the dive's
track, or a straight line at constant speed where it has none.  Places are in the
plane about GPS2 (`LocalPlane`), times in s since GPS2.  Integration: Dormand
and Prince, order 5(4) (`scipy.integrate.solve_ivp`), to 1e-8 or 1 mm per step,
steps of a quarter of an hour at most.

Of the dive, the fix GPS2, the times and the dead reckoning are used and never
the fix after it: the forecast is one.

Of a gridded forecast a glider feels its water column.  A dive samples it down to its greatest
depth D, so the flow is averaged over it, by trapezoids through the levels that have data,

    F = (1 / D) int_0^D u dz,    u linear between levels, constant above the first,

as far down as there are data; D is `Dive.depth_max`, or 1000 m where it is not
known.  D is the one number of a dive that is read though it is measured during the
dive: a pilot knows the depth that was planned, which it stands for.

u is linear between latitudes, longitudes and times, and nowhere extrapolated:
outside the area, before the first step, after the last, where a corner of the cell
has no data and in a gap of the steps (`missing_steps`) there is no model.

A fitted basis is that of a scenario that `clpt fit` wrote,

    F(x, t) = theta phi(x, t)    Eq. (3)

with the basis of the scenario, evaluated by its block, and theta, the origin of
its plane, t = 0 and its box from the field file beside it.  Constituents go on
in time, before and after the record that was fitted; in space there is a model
within the box alone.
"""

import json
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import replace
from math import isfinite
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp, trapezoid

from ...base.arguments import public
from ...base.errors import ClptError, DataError
from ...base.files.reading import open_netcdf, shown_name
from ...base.geodesy import LocalPlane
from ...base.units import METRES, SECONDS, seconds_since_1970
from ...engine.model.block import evaluate
from ...paper.currents.current_grid import AROUND, missing_steps
from ...paper.currents.grid_file import DEEPEST, SUFFIXES, read_currents
from ..gliders.dives import Dive, reckoned

Flow = Callable[[float, float, float], tuple[float, float]]
LONGEST_STEP = 900.0  # s; a glider crosses no cell of a forecast in less
RELATIVE, ABSOLUTE = 1e-8, 1e-3  # error of a step: share of q, and m


class Uncovered(ClptError):
    """A flow model says nothing here or now; the message is why."""


class FlowModel(ABC):
    """A flow that was modelled elsewhere, to carry dead reckoning."""

    source: str  # the name of its file
    about: str  # what it is, in a few words

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.source}: {self.about}>"

    @abstractmethod
    def along(self, dive: Dive) -> Flow:
        """Return the flow for one dive, whose end fix is not read.

        (s since GPS2, m east, m north of it) -> flow east and north, m/s; `Uncovered` is
        raised where the model says nothing.
        """


def flow_of(current: Flow, dive: Dive) -> Flow:
    """Return the flow for a dive of a current by time, latitude and longitude, east and north."""
    plane = LocalPlane(*dive.start)

    def flow(t: float, east: float, north: float) -> tuple[float, float]:
        lat, lon = map(float, plane.to_earth(east / 1000, north / 1000))
        u1, u2 = plane.rotate(lat, lon, *current(dive.t_gps2 + t, lat, lon))
        return float(u1), float(u2)

    return flow


def flow_displacement(dive: Dive, flow: Flow) -> tuple[float, float]:
    """Integrate a flow along a dive's dead reckoning: q(T), m east and north.

    `Uncovered` is raised where the flow says nothing on the track.
    """
    T = dive.duration
    time, east, north = reckoned(dive)
    if not (
        isfinite(T) and T > 0 and all(np.isfinite(a).all() for a in (time, east, north))
    ):
        raise Uncovered(
            "the dive's times and dead reckoning are not finite and in their order"
        )

    def rate(t: float, q: np.ndarray) -> tuple[float, float]:
        u, v = flow(
            t, np.interp(t, time, east) + q[0], np.interp(t, time, north) + q[1]
        )
        if not (isfinite(u) and isfinite(v)):
            raise Uncovered(f"its flow is not finite {t / 3600:.2g} h into the dive")
        return u, v

    solution = solve_ivp(
        rate, (0.0, T), np.zeros(2), rtol=RELATIVE, atol=ABSOLUTE, max_step=LONGEST_STEP
    )
    if not solution.success:  # pragma: no cover - only a flow that jumps endlessly
        raise Uncovered(f"the dive cannot be integrated: {solution.message}")
    return float(solution.y[0, -1]), float(solution.y[1, -1])


@public
def carried(dive: Dive, flow_model: FlowModel) -> Dive:
    """Return a dive with its displacement by a flow model.

    >>> import clpt_control as clpt
    >>> from clpt_control.ocean.forecast.flow_models import FlowModel
    >>> class Stream(FlowModel):
    ...     source, about = "none", "0.1 m/s to the east"
    ...
    ...     def along(self, dive):
    ...         return lambda t, east, north: (0.1, 0.0)
    >>> fixes = (0.0, 40.0, 8.0), (9000.0, 40.0, 8.02)
    >>> dive = clpt.gliders.make_dive(1, *fixes, (500.0, 0.0))
    >>> round(carried(dive, Stream()).model_east, 6)
    900.0
    """
    try:
        east, north = flow_displacement(dive, flow_model.along(dive))
    except Uncovered as why:
        return replace(dive, model_east=None, model_north=None, uncovered=str(why))
    return replace(dive, model_east=east, model_north=north, uncovered=None)


def depth_mean(depth: np.ndarray, profile: np.ndarray, deepest: float) -> complex:
    """Average a profile, u + iv at levels, from the surface to a depth, m.

    The mean ends at the deepest level with data, if that is higher, and is NaN where no
    level above the end has any.  Levels `depth`, m, increase from the surface.

    >>> round(depth_mean(np.array([0.0, 100.0, 400.0]), np.array([0.4, 0.3, 0.0]), 200.0).real, 9)
    0.3
    """
    finite = np.isfinite(profile)
    z = depth[finite]
    u = profile[finite]
    if not z.size or z[0] > max(deepest, depth[0]):
        return complex(np.nan)
    end = min(deepest, z[-1])
    if not end > 0:
        return complex(u[0])
    levels = np.array([0.0, *z[(z > 0) & (z < end)], end])
    return complex(trapezoid(np.interp(levels, z, u), levels) / end)


class Forecast(FlowModel):
    """A current on time, latitude, longitude and perhaps depth, of a NetCDF file."""

    def __init__(self, path: Path, units: str | None):
        from scipy.interpolate import RegularGridInterpolator

        column = read_currents(path, column=True, units=units)
        self.source = column.source
        levels = len(column.depth)
        about = f"gridded, averaged over a dive's depth, {levels} levels"
        if levels == 1:
            about = "gridded, one level only, not what a glider feels over its depths"
        if column.land:
            about += f"; {column.land} cells of nothing but zeros are taken as land"
        self.about = about
        self.depth = column.depth
        self.time = column.dates.astype(float) / 1e3  # s since 1970 UTC
        self.gaps = missing_steps(self.time) > 0
        self.lat = column.lat
        self.lon = column.lon
        values = np.moveaxis(column.u + 1j * column.v, 1, -1)
        if self.lon[0] + 360.0 - self.lon[-1] < AROUND * np.median(np.diff(self.lon)):
            self.lon = np.append(self.lon, self.lon[0] + 360.0)  # around the Earth
            values = np.concatenate([values, values[:, :, :1]], axis=2)
        self.flow = RegularGridInterpolator(
            (self.time, self.lat, self.lon),
            values,
            bounds_error=False,
            fill_value=np.nan,
        )

    def along(self, dive: Dive) -> Flow:
        """Return the flow for one dive, averaged over its depths.

        `Uncovered` is raised where the dive is not within the steps, or reaches into a gap of them.
        """
        time = self.time
        bridged = self.gaps & (time[:-1] < dive.t_gpse) & (dive.t_gps2 < time[1:])
        if bridged.any() or not (time[0] <= dive.t_gps2 and dive.t_gpse <= time[-1]):
            raise Uncovered("outside the forecast's steps, or in a gap of them")
        deepest = dive.depth_max
        if deepest is None or not (isfinite(deepest) and deepest > 0):
            deepest = DEEPEST

        def current(time: float, lat: float, lon: float) -> tuple[float, float]:
            unwrapped = self.lon[0] + (lon - self.lon[0]) % 360.0  # as the file counts
            (profile,) = self.flow([[time, lat, unwrapped]])
            mean = depth_mean(self.depth, profile, deepest)
            if not np.isfinite(mean):
                raise Uncovered("outside the forecast's area, or in a gap of it")
            return mean.real, mean.imag

        return flow_of(current, dive)


class Fitted(FlowModel):
    """A basis with its parameters, of the TOML file that `clpt fit` wrote, its field beside it."""

    def __init__(self, path: Path):
        from ...paper.scenario.file import load_vehicle_scenario

        self.scenario = load_vehicle_scenario(path)
        text = ""
        if self.scenario.field_path is not None:
            with open_netcdf(self.scenario.field_path) as data:
                text = data.attrs.get("fit_report", "")
        N = self.scenario.basis.N
        try:
            report = json.loads(text)
            self.theta = np.array(report["theta"], float)  # (2, N), along x1 and x2
            latitude, longitude = map(float, report["origin"])
            units = self.scenario.units
            self.plane = LocalPlane(latitude, longitude, units.length)
            self.start = seconds_since_1970(report["start"])  # its t = 0
            self.lat0, self.lat1, self.lon0, self.lon1 = map(float, report["box"])
            self.about = (
                f"fitted basis of {N} functions, {', '.join(report['constituents'])}"
            )
            if self.theta.shape != (2, N) or not np.all(np.isfinite(self.theta)):
                raise ValueError("of other functions")
        except (ValueError, KeyError, TypeError):
            raise DataError(
                f"{path}: is not a fit with its field beside it, which has theta, "
                "origin, box and a "
                "date. Write both anew with `clpt fit`"
            ) from None
        self.source = shown_name(path)

    def along(self, dive: Dive) -> Flow:
        """Return theta phi for one dive; `Uncovered` if it begins outside the fit's area."""
        units = self.scenario.units
        time_unit = SECONDS[units.time]
        basis = self.scenario.basis_block()

        def current(time: float, lat: float, lon: float) -> tuple[float, float]:
            in_box = (lon - self.lon0) % 360.0 <= self.lon1 - self.lon0
            if not (self.lat0 <= lat <= self.lat1 and in_box):
                raise Uncovered("outside the fit's area")
            place = np.array([self.plane.to_plane(lat, lon)])
            [phi] = evaluate(basis, (time - self.start) / time_unit, place)
            u, v = self.theta @ phi * METRES[units.length] / time_unit
            u, v = self.plane.rotate(lat, lon, u, v, inverse=True)
            return float(u), float(v)

        flow = flow_of(current, dive)
        flow(0.0, 0.0, 0.0)
        return flow


@public
def read_flow_model(path: str | Path, units: str | None = None) -> FlowModel:
    """Read a flow model: a gridded forecast, or a fitted basis.

    Parameters
    ----------
    path : str or Path
        NetCDF of a current on time, latitude, longitude and perhaps depth, Zarr, or
        a folder of such files; or
        the TOML file that `clpt fit` wrote, its field beside it.
    units : str, optional
        Of u and v of a NetCDF file, such as ``"m/s"``, where it has none.

    Returns
    -------
    FlowModel
        To be given to `carried` with each dive.

    Raises
    ------
    DataError
        If the file is missing or neither, or lacks what a flow model needs.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> model = clpt.replay.read_flow_model("forecast.nc")  # doctest: +SKIP
    >>> dives = clpt.gliders.sample_dives()
    >>> replay = clpt.replay.replay_dives(dives, flow_model=model)  # doctest: +SKIP
    """
    path = Path(path)
    kind = path.suffix.lower()
    if not path.exists() or (kind not in (".toml", *SUFFIXES) and not path.is_dir()):
        raise DataError(
            f"{path}: {'is not a flow model' if path.exists() else 'no such file'}; "
            "must be a NetCDF "
            "file (.nc) of a current on time, latitude and longitude, or the .toml file that "
            "`clpt fit` writes"
        )
    if kind == ".toml" and units is not None:
        raise DataError(
            f"{path}: a fit has its units in the file. Leave out units ({units})"
        )
    return Fitted(path) if kind == ".toml" else Forecast(path, units)
