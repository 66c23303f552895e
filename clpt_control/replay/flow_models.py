"""The displacement of a glider by a modelled flow during a dive, and files of such flows.

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

A file has a gridded forecast, or a fitted basis.  Of a gridded forecast a glider feels a water
column.  A dive samples the column down to its greatest depth D, so the flow is averaged over it, by
trapezoids through the levels that have data,

    F = (1 / D) int_0^D u dz,    u linear between levels, constant above the first,

as far down as there are data; D is `Dive.depth_max`, or 1000 m where it is not
known.  D is the one number of a dive that is read though it is measured during the
dive: a pilot knows the depth that was planned, which it stands for.

F is linear between latitudes, longitudes and times, and nowhere extrapolated:
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
from dataclasses import dataclass, replace
from math import cos, isfinite, radians
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import RegularGridInterpolator

from ..arguments import public
from ..currents.grid_file import DEEPEST, SUFFIXES, missing_steps, read_currents
from ..currents.plane import LocalPlane
from ..errors import ClptError, DataError
from ..estimation.dive import reckoned
from ..files.reading import open_netcdf, shown_name
from ..geodesy import near
from ..gliders.dives import Dive
from ..scenario.experiment import Scenario
from ..scenario.file import load_scenario
from ..units import METRES, SECONDS, seconds_since_1970

Flow = Callable[[float, float, float], tuple[float, float]]
NOTE = "flow model: "
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


def carried_by(dive: Dive, flow: Flow) -> tuple[float, float]:
    """Integrate a flow along a dive's dead reckoning: q(T), m east and north.

    `Uncovered` is raised where the flow says nothing on the track.
    """
    T = dive.duration
    time, east, north = reckoned(dive)
    if not (isfinite(T) and T > 0 and all(np.isfinite(a).all() for a in (time, east, north))):
        raise Uncovered("the dive's times and dead reckoning are not finite and in their order")

    def rate(t: float, q: np.ndarray) -> tuple[float, float]:
        u, v = flow(t, np.interp(t, time, east) + q[0], np.interp(t, time, north) + q[1])
        if not (isfinite(u) and isfinite(v)):
            raise Uncovered(f"its flow is not finite {t / 3600:.2g} h into the dive")
        return u, v

    found = solve_ivp(
        rate, (0.0, T), np.zeros(2), rtol=RELATIVE, atol=ABSOLUTE, max_step=LONGEST_STEP
    )
    if not found.success:  # pragma: no cover - only a flow that jumps endlessly
        raise Uncovered(f"the dive cannot be integrated: {found.message}")
    return float(found.y[0, -1]), float(found.y[1, -1])


@public
def carried(dive: Dive, flow_model: FlowModel) -> Dive:
    """Return a dive with its displacement by a flow model.

    Parameters
    ----------
    dive : Dive
        Its end fix is not read, and may be NaN.
    flow_model : FlowModel
        As `read_flow_model` returns it, or one of your own.

    Returns
    -------
    Dive
        With `model_east` and `model_north`, m; None, and the reason in
        `notes`, where the model does not cover the whole dive.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.replay.flow_models import FlowModel
    >>> class Stream(FlowModel):
    ...     source, about = "none", "0.1 m/s to the east"
    ...
    ...     def along(self, dive):
    ...         return lambda t, east, north: (0.1, 0.0)
    >>> fixes = (0.0, 40.0, 8.0), (9000.0, 40.0, 8.02)
    >>> dive = clpt.gliders.make_dive(1, *fixes, (500.0, 0.0))
    >>> round(clpt.replay.carried(dive, Stream()).model_east, 6)
    900.0
    """
    rest = tuple(note for note in dive.notes if not note.startswith(NOTE))
    try:
        east, north = carried_by(dive, flow_model.along(dive))
    except Uncovered as why:
        return replace(dive, model_east=None, model_north=None, notes=(*rest, f"{NOTE}{why}"))
    return replace(dive, model_east=east, model_north=north, notes=rest)


def why_uncovered(dive: Dive) -> str:
    """Return why a flow model does not cover a dive; empty if it does."""
    return next((note[len(NOTE) :] for note in dive.notes if note.startswith(NOTE)), "")


DEGREE = 110500.0  # m; no degree of latitude is shorter


@np.errstate(invalid="ignore", divide="ignore")
def depth_mean(depth: np.ndarray, values: np.ndarray, deepest: float) -> np.ndarray:
    """Average a profile, shape (nt, nz, ...), from the surface to a depth, m.

    The mean ends at the deepest level with data, if that is higher, and is NaN where no
    level above the end has any.  Levels `depth`, m, increase from the surface.

    >>> depth = np.array([0.0, 100.0, 400.0])
    >>> depth_mean(depth, np.array([[0.4, 0.3, 0.0]]), 200.0).round(9)
    array([0.3])
    """
    shape = values[:, 0].shape
    total, last, above = np.zeros(shape), np.zeros(shape), np.full(shape, np.nan)
    for z, value in zip(depth, np.moveaxis(values, 1, 0), strict=True):
        first = np.isnan(above)
        use = np.isfinite(value) & (first | (last < deepest))
        if z > max(deepest, depth[0]):
            use &= ~first  # nothing was seen above that end
        end = min(z, deepest)
        slope = np.where(first | (z == last), 0.0, (value - above) / (z - last))
        top = np.where(first, value, above)
        thick = end - last
        total = np.where(use, total + thick * (top + slope * thick / 2), total)
        above, last = np.where(use, value, above), np.where(use, end, last)
    return np.where(last > 0, total / last, above)


class Forecast(FlowModel):
    """A current on time, latitude, longitude and perhaps depth, of a NetCDF file."""

    def __init__(self, path: Path, units: str | None) -> None:
        self.column = column = read_currents(path, column=True, units=units)
        self.source, levels = column.source, len(column.depth)
        about = f"gridded, averaged over a dive's depth, {levels} levels"
        if levels == 1:
            where = "surface" if column.depth[0] < 1 else f"{column.depth[0]:g} m deep"
            about = f"gridded, one level only ({where}), not what a glider feels over its depths"
        if column.land:
            about += f"; {column.land} cells of nothing but zeros are taken as land"
        self.about = about
        self.fastest = float(np.sqrt(np.nanmax(column.u**2 + column.v**2)))  # m/s, anywhere
        self.time = seconds_since_1970(column.start) + 3600.0 * column.time  # s since 1970 UTC
        self.gaps = missing_steps(self.time) > 0
        self.lon, self.columns = column.lon, np.arange(len(column.lon))
        if column.lon[-1] == column.lon[0] + 360.0:  # around the Earth: a turn on either side
            n = len(column.lon) - 1
            turns, self.columns = np.divmod(np.arange(-n, 2 * n + 1), n)
            self.lon = column.lon[self.columns] + 360.0 * turns

    def along(self, dive: Dive) -> Flow:
        """Return the flow for one dive, averaged over its depths.

        `Uncovered` is raised where the dive begins outside the area, is not within the
        steps or reaches into a gap of them.
        """
        c, time = self.column, self.time
        if not self._inside(dive.lat_gps2, dive.lon_gps2):
            raise Uncovered("outside the forecast's area")
        if not dive.t_gps2 >= time[0]:
            raise Uncovered("begins before the forecast's first step")
        if not dive.t_gpse <= time[-1]:
            raise Uncovered("ends after the forecast's last step")
        within = _bracket(time, dive.t_gps2, dive.t_gpse)
        if self.gaps[within.start : within.stop - 1].any():
            raise Uncovered("in a gap of the forecast's steps")
        plane = LocalPlane(dive.lat_gps2, dive.lon_gps2)
        steps, rows, across = self._reached(dive)
        start, columns = self._unwrapped(dive.lon_gps2), self.columns[across]
        deepest = dive.depth_max
        if deepest is None or not (isfinite(deepest) and deepest > 0):
            deepest = DEEPEST
        u, v = (depth_mean(c.depth, w[steps, :, rows, columns], deepest) for w in (c.u, c.v))
        look = RegularGridInterpolator(
            (time[steps] - dive.t_gps2, c.lat[rows], self.lon[across]),
            np.stack([u, v], axis=-1),
            bounds_error=False,
            fill_value=np.nan,
        )

        def flow(t: float, east: float, north: float) -> tuple[float, float]:
            lat, lon = map(float, plane.to_earth(east / 1000, north / 1000))
            eastward, northward = look([[t, lat, near(lon, start)]])[0]
            if not (isfinite(eastward) and isfinite(northward)):
                raise Uncovered(
                    "in a gap of the forecast"
                    if self._inside(lat, lon)
                    else "outside the forecast's area"
                )
            u1, u2 = plane.rotate(lat, lon, eastward, northward)
            return float(u1), float(u2)

        return flow

    def _unwrapped(self, lon: float) -> float:
        """Return a longitude as the file counts, at or after its first."""
        return self.column.lon[0] + (lon - self.column.lon[0]) % 360.0

    def _inside(self, lat: float, lon: float) -> bool:
        c = self.column
        return bool(c.lat[0] <= lat <= c.lat[-1] and self._unwrapped(lon) <= c.lon[-1])

    def _reached(self, dive: Dive) -> tuple[slice, slice, slice]:
        """Return the steps, rows and columns that the dive can reach."""
        c = self.column
        track = (dive.dr_east, dive.dr_north) if dive.track is None else dive.track[1:]
        reach = float(np.max(np.hypot(*track))) + dive.duration * self.fastest
        high = reach / DEGREE
        wide = high / max(cos(radians(min(abs(dive.lat_gps2) + high, 89.9))), 1e-3)
        lat, lon = dive.lat_gps2, self._unwrapped(dive.lon_gps2)
        return (
            _bracket(self.time, dive.t_gps2, dive.t_gpse),
            _bracket(c.lat, lat - high, lat + high),
            _bracket(self.lon, lon - wide, lon + wide),
        )


def _bracket(axis: np.ndarray, low: float, high: float) -> slice:
    """Cut an axis to the span and one value on either side, two at least."""
    first = min(max(int(np.searchsorted(axis, low, "right")) - 1, 0), len(axis) - 2)
    last = max(int(np.searchsorted(axis, high, "left")), first + 1)
    return slice(first, last + 1)


@dataclass(frozen=True, repr=False)
class Fitted(FlowModel):
    """A basis with its parameters, on the plane of its fit."""

    scenario: Scenario
    theta: np.ndarray  # shape (2, N), along x1 and x2, the scenario's length per time
    plane: LocalPlane  # about the origin of the fit
    start: float  # its t = 0, s since 1970 UTC
    box: tuple[float, float, float, float]  # lat0, lat1, lon0, lon1 that was fitted, degrees
    source: str
    about: str

    def along(self, dive: Dive) -> Flow:
        """Return theta phi for one dive; `Uncovered` if it begins outside the fit's area."""
        here, units = LocalPlane(dive.lat_gps2, dive.lon_gps2), self.scenario.units
        long, second = METRES[units.length], SECONDS[units.time]
        basis, N, no_state = self.scenario.basis_block(), self.scenario.basis.N, np.zeros(0)

        def flow(t: float, east: float, north: float) -> tuple[float, float]:
            lat, lon = here.to_earth(east / 1000, north / 1000)
            lat0, lat1, lon0, lon1 = self.box
            if not (lat0 <= lat <= lat1 and (lon - lon0) % 360.0 <= lon1 - lon0):
                raise Uncovered("outside the fit's area")
            x1, x2 = (1000.0 * float(x) / long for x in self.plane.to_plane(lat, lon))
            when = (dive.t_gps2 + t - self.start) / second
            phi = basis.values("output", N, when, no_state, [x1, x2], basis.parameters)
            u1, u2 = self.theta @ phi * (long / second)
            c, s = self.plane.rotate(lat, lon, 1.0, 0.0)  # where east points in the fit's plane
            u1, u2 = here.rotate(lat, lon, c * u1 + s * u2, c * u2 - s * u1)
            return float(u1), float(u2)

        flow(0.0, 0.0, 0.0)
        return flow


def read_fitted(path: str | Path) -> Fitted:
    """Read the TOML file that `clpt fit` wrote, its field beside it; theta is the fitted one."""
    path = Path(path)
    scenario = load_scenario(path)
    if scenario.field_path is None:
        raise DataError(
            f"{path}: has no flow.field, so neither origin nor date; a flow model is a scenario "
            "that `clpt fit` wrote"
        )
    with open_netcdf(scenario.field_path) as data:
        text = data.attrs.get("fit_report", "")
    try:
        report = json.loads(text)
        theta = np.array(report["theta"], float)
        plane = LocalPlane(*map(float, report["origin"]))
        start = seconds_since_1970(report["start"])
        lat0, lat1, lon0, lon1 = map(float, report["box"])
        tides = ", ".join(report["constituents"])
    except (ValueError, KeyError, TypeError):
        raise DataError(
            f"{scenario.field_path}: has no fit_report with theta, origin, box and a real date as "
            "start; write scenario and field anew with `clpt fit`"
        ) from None
    if theta.shape != (2, scenario.basis.N) or not np.all(np.isfinite(theta)):
        raise DataError(
            f"{path}: its basis has {scenario.basis.N} functions, the theta in "
            f"{scenario.field_path.name} has the shape {theta.shape}; write both anew with "
            "`clpt fit`"
        )
    about = f"fitted basis of {scenario.basis.N} functions, {tides}"
    return Fitted(scenario, theta, plane, start, (lat0, lat1, lon0, lon1), shown_name(path), about)


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
    >>> dives, skipped = clpt.gliders.usable(clpt.gliders.sample_dives())
    >>> replay = clpt.replay.replay_dives(dives, flow_model=model)  # doctest: +SKIP
    """
    path = Path(path)
    kind = path.suffix.lower()
    if kind not in (".toml", *SUFFIXES) and not path.is_dir():
        raise DataError(
            f"{path}: is no flow model; must be a NetCDF file (.nc) of a current on time, latitude "
            "and longitude, or the .toml file of a `clpt fit`"
        )
    if not path.exists():
        raise DataError(
            f"{path}: no such file; a flow model is a NetCDF file (.nc) of a current, or the .toml "
            "file that `clpt fit` writes"
        )
    if kind == ".toml" and units is not None:
        raise DataError(f"{path}: a fit has its units in the file; leave out units ({units})")
    return read_fitted(path) if kind == ".toml" else Forecast(path, units)
