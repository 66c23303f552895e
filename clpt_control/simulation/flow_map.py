"""Map of the learned flow as a CF Dataset, for xarray, Panoply and QGIS.

    u, v = theta_hat phi(x, t)            of the last estimate theta_hat
    standard error = (phi^T P phi + v)^(1/2)  of each component, with the covariances P of the rows
                                              of theta_hat, the larger one if they differ, and v of
                                              the flow that the functions do not span (`unspanned`)

Flow that the vehicle of a run did not see is masked: places outside of the box of its track, or of
the measured current.  An estimate has standard errors, which grow there.

u and v are by local east and north.  So are functions that are the same everywhere, which need no
plane; v is then the scatter of the legs, and farther off than the track is long that of the prior.

The chart of a map has arrows of the learned flow and, where known, of the true flow, both on one
scale.  The shade is the standard error of an estimate, or the error of a run whose true flow is
known.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.spatial import cKDTree

from ..base.arguments import finite, public
from ..base.errors import ArgumentError, DataError
from ..base.figures import BLUE, GREY, ORANGE, TITLE, axes_for, legend_below
from ..base.geodesy import LocalPlane, angle_near
from ..base.units import DEGREES, SECONDS, printed_unit
from ..engine.model.block import evaluate
from ..paper.blocks.flow import unspanned
from ..paper.currents.plane import GriddedField, read_field
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.recorded_run import (
    fixes_of,
    kind_of,
    read_estimate,
    scenario_with,
    unknown_parts,
)
from .comparison import label_of
from .dataset import unit_of
from .flows import true_flow

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

POINTS = 41  # on each side of the box by default
AHEAD = 10  # latest time of a map, in lengths of the run
POINTS_OF_A_WAY = 5  # of the quadrature along a leg
BETWEEN = 4  # points of the map from arrow to arrow
SHADES = {"standard_error", "error"}
STANDARD_NAMES = {  # of u and v: on a plane, and by latitude and longitude
    False: ("sea_water_x_velocity", "sea_water_y_velocity"),
    True: ("eastward_sea_water_velocity", "northward_sea_water_velocity"),
}
READ = """latitude longitude start_latitude start_longitude start_time end_time has_origin
unspanned_flow walk time_origin leg_flow scatter flow_parameters_estimate covariance origin"""
ARROWS = (  # prefix of the map's names, label, colour, width; the wide ones below
    ("true_", "true flow", GREY, 0.006),
    ("", "learned flow", ORANGE, 0.003),
)


@dataclass
class _Learned:
    """Learned flow: theta (2, N) in `unit`, covariance (2, N, N), plane, box, start and end.

    Places are longitudes and latitudes if the functions are the same everywhere.
    """

    scenario: Scenario
    theta: np.ndarray
    unit: str
    covariance: np.ndarray | None
    plane: LocalPlane | None
    is_geographic: bool
    track: np.ndarray  # positions or fixes, (n, 2)
    places: np.ndarray  # that the box contains, (n, 2)
    date: str | None  # of t = 0
    end: Any
    has_truth: bool
    field: GriddedField | None = None  # measured current
    # variance beside that of theta phi at the end
    beside: Callable = lambda *of: 0.0

    def times(self, time: Any) -> tuple[np.ndarray, Any]:
        """Return times since t = 0, and the coordinate of the map."""
        time = self.end if time is None else time
        try:
            values = np.atleast_1d(time)
        except (TypeError, ValueError):  # rows of several lengths, or no numbers
            values = _row("time", time)
        unit = self.scenario.units.time
        if values.dtype.kind == "M":
            if self.date is None:
                raise DataError(
                    "time: the run has no date. Give numbers since its start"
                )
            elapsed = (values - np.datetime64(self.date)) / np.timedelta64(1, "s")
            times = _row("time", elapsed / SECONDS[unit])
            return times, ("time", values.astype("M8[ns]"))
        times = _row("time", values)
        if self.date is None:
            start = {"long_name": "time since the start of the run", "units": unit}
            return times, ("time", times, start)
        with np.errstate(invalid="ignore"):  # of times that are refused
            seconds = np.round(times * SECONDS[unit] * 1e9).astype("m8[ns]")
        return times, ("time", np.datetime64(self.date, "ns") + seconds)


@public
def flow_map(
    source: "xarray.Dataset",
    latitude: Any = None,
    longitude: Any = None,
    time: Any = None,
) -> "xarray.Dataset":
    """Return the learned flow on a grid, with its error if known.

    Parameters
    ----------
    source : xarray.Dataset
        A run of a scenario, or an estimate of `clpt.currents.flow_estimate`.
    latitude, longitude : array_like, optional
        Degrees; of a run without `origin`, x2 (north) and x1 (east) in units.length. By default
        41 of each over the box of the track.
    time : array_like, optional
        Times since the start in units.time, or dates, within ten lengths of the run; by default
        the end. With `kalman-flow` the standard error grows with the time from the last fix.

    Returns
    -------
    xarray.Dataset
        ``u`` and ``v``, learned; where the truth is known ``true_u``, ``true_v`` and ``error``, the
        length of the difference; of an estimate ``standard_error`` of u and of v, with the flow
        that the functions do not span: far from all functions, the prior. P of a run's law
        is no standard error, since it does not grow with the scatter of the data.
        Of a run, places outside of the box of the track, or of the measured current, are NaN; so
        is the truth where nothing was ever measured, as on land.

    Raises
    ------
    DataError
        If the dataset is no run of a scenario and no estimate.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> run = clpt.simulate(clpt.paper_scenario().with_values({"run.duration": 400}))
    >>> flow = clpt.flow_map(run, [0.0, 1.0], [0.0, 9.0])
    >>> flow.u.dims, float(flow.error[0, 0, 0].round(2)), bool(flow.u[0, 0, 1].isnull())
    (('time', 'y', 'x'), 0.03, True)
    """
    return map_of(learned_flow(source), latitude, longitude, time)


def map_of(
    learned: _Learned, latitude: Any = None, longitude: Any = None, time: Any = None
) -> "xarray.Dataset":
    """Return the map of a learned flow, as `flow_map`."""
    low = learned.places.min(axis=0)
    high = learned.places.max(axis=0)
    plane = learned.plane
    rows, columns = (np.linspace(low[i], high[i], POINTS) for i in (1, 0))
    if plane is not None:
        # the box in degrees that is inside of the box on the plane, whose edges are bent
        north, east = plane.to_earth(*np.meshgrid(columns, rows))
        rows = np.linspace(north[0].max(), north[-1].min(), POINTS)
        columns = np.linspace(east[:, 0].max(), east[:, -1].min(), POINTS)
    rows = rows if latitude is None else _row("latitude", latitude)
    columns = columns if longitude is None else _row("longitude", longitude)
    if learned.is_geographic and np.abs(rows).max() > 90.0:
        raise ArgumentError(
            f"latitude: {rows[np.abs(rows).argmax()]:g} is not from -90 to 90. Give latitudes, "
            "then longitudes"
        )
    times, time_axis = learned.times(time)
    latest, _ = learned.times(None)
    if np.any(np.abs(times) > AHEAD * latest):
        raise ArgumentError(
            f"time: must lie within {AHEAD} times the length of the run, {latest[0]:g} "
            f"{learned.scenario.units.time}. Give times since its start, or dates"
        )

    grid = np.meshgrid(times, rows, columns, indexing="ij")
    t, north, east = (axis.ravel() for axis in grid)
    points = np.column_stack([east, north])
    if plane is not None:
        points = np.column_stack(plane.to_plane(north, east))
    phi = evaluate(learned.scenario.basis_block(), t, points)
    margin = 1e-6 * (high - low)
    is_inside = np.all((points >= low - margin) & (points <= high + margin), axis=1)
    is_inside |= learned.covariance is not None

    def masked(values: np.ndarray, long_name: str, **names: str) -> tuple:
        shown = np.where(is_inside, values, np.nan).reshape(grid[0].shape)
        return dims, shown, {"long_name": long_name, "units": learned.unit, **names}

    def components(flow: np.ndarray, prefix: str, words: str) -> dict[str, Any]:
        u, v = flow.T
        if plane is not None:
            u, v = plane.rotate(north, east, u, v, inverse=True)
        names = STANDARD_NAMES[learned.is_geographic]
        return {
            prefix + name: masked(values, f"{words} flow", standard_name=standard)
            for name, values, standard in zip("uv", (u, v), names, strict=True)
        }

    dims = ["time", *(DEGREES if learned.is_geographic else "yx")]
    flow = phi @ learned.theta.T
    data = components(flow, "", "learned")
    if learned.has_truth:
        truth = true_flow(learned.scenario, points, t)
        if learned.field is not None:
            truth[learned.field.on_land(points)] = np.nan
        data |= components(truth, "true_", "true")
        off = np.hypot(*(flow - truth).T)
        data["error"] = masked(off, "length of learned less true flow")
    if learned.covariance is not None:
        of_rows = np.einsum("nk,akl,nl->an", phi, learned.covariance, phi)
        variance = of_rows.max(axis=0)
        variance += learned.beside(points, phi, t - latest)
        error = np.sqrt(np.maximum(variance, 0.0))
        data["standard_error"] = masked(error, "standard error of u and of v")
    return _dataset(learned, data, time_axis, {dims[1]: rows, dims[2]: columns})


def _row(name: str, values: Any) -> np.ndarray:
    row = np.atleast_1d(finite(name, values))
    if row.ndim != 1 or not row.size:
        raise ArgumentError(
            f"{name}: has shape {row.shape}. Give a number, or a row of numbers"
        )
    return row


def _dataset(
    learned: _Learned, data: dict[str, Any], time: Any, axes: dict[str, np.ndarray]
) -> "xarray.Dataset":
    """Return the variables of a map with units and coordinates."""
    import xarray

    coordinates = {"time": time}
    for name, values in axes.items():
        standard = name if name in DEGREES else f"projection_{name}_coordinate"
        unit = DEGREES.get(name, learned.scenario.units.length)
        coordinates[name] = (name, values, {"standard_name": standard, "units": unit})
    title = f"Learned flow: {learned.scenario.title}".removesuffix(": ")
    attributes = {"Conventions": "CF-1.11", "title": title}
    made = xarray.Dataset(data, coordinates, attributes)
    if made.time.dtype.kind == "M":  # the standard name is that of dates
        made.time.attrs["standard_name"] = "time"
    return made


def learned_flow(run: "xarray.Dataset") -> _Learned:
    """Return the learned flow of a run, or of an estimate."""
    if kind_of(run) == "fixes":
        return _of_estimate(run)
    scenario = scenario_with(run, "position", "flow_parameters_estimate")
    unknown = unknown_parts(run)
    if "basis_x" in unknown:
        raise DataError(
            "the run has other basis functions than its scenario, so no map"
        )
    points = run.position.values
    field = None
    if scenario.field_path is not None:
        field = read_field(scenario.field_path, scenario.units)
        points = np.column_stack([field.x1[[0, -1]], field.x2[[0, -1]]])
    return _Learned(
        scenario,
        run.flow_parameters_estimate.values[-1],
        unit_of(scenario.units, 1, 1),
        None,
        None if scenario.origin is None else scenario.plane,
        scenario.origin is not None,
        run.position.values,
        points,
        run.attrs.get("time_origin"),
        run.time.values[-1],
        "true_flow" not in unknown,
        field,
    )


def _of_estimate(data: "xarray.Dataset") -> _Learned:
    estimate, scenario = read_estimate(data, READ)
    estimate = estimate.sortby("end_time")
    latitude, longitude = estimate.attrs["origin"]
    has_origin = bool(estimate.attrs["has_origin"])
    plane = None
    (north, east), leg_of = fixes_of(estimate)
    places = np.column_stack([angle_near(east, longitude), north])
    is_everywhere = scenario.basis.is_everywhere(scenario.units.length)
    if not (has_origin and is_everywhere):
        plane = LocalPlane(latitude, longitude, scenario.units.length)
        places = np.column_stack(plane.to_plane(north, east))
    # of degrees of longitude, too
    scale = np.array([1.0 if plane else np.cos(np.radians(latitude)), 1.0])
    fixes = cKDTree(places * scale)
    extent = np.linalg.norm(np.std(places * scale, axis=0)) or 1.0
    misfits = None
    if plane is not None and not is_everywhere:
        misfits = _misfits(estimate, scenario, plane)[leg_of]

    def beside(points: np.ndarray, phi: np.ndarray, elapsed: np.ndarray) -> np.ndarray:
        prior = estimate.attrs["unspanned_flow"]
        if misfits is None:
            # what the legs show beside them, and the prior farther off than the track is long
            near = np.exp(-((fixes.query(points * scale)[0] / extent) ** 2) / 2)
            v = near * estimate.attrs["scatter"] ** 2 + (1 - near) * prior**2
        else:
            # the legs of the two nearest fixes, such as that before a fix and that behind it
            _, legs = fixes.query(points * scale, [1, 2])
            near = misfits[np.minimum(legs, len(misfits) - 1)].max(axis=1)
            off = near + misfits.mean()  # a place differs from its leg as legs do
            v, _, share = unspanned(scenario.basis, prior, points, places)
            v = v + share * off
        seconds = np.abs(elapsed) * SECONDS[scenario.units.time]
        walked = seconds * estimate.attrs["walk"] ** 2
        return v + walked * np.sum(phi**2, axis=1)

    return _Learned(
        scenario,
        estimate.flow_parameters_estimate.values[-1],
        "m s-1",
        estimate.covariance.values[-1],
        plane if has_origin else None,
        has_origin,
        places,
        places,
        estimate.attrs["time_origin"],
        estimate.end_time.values[-1],
        False,
        beside=beside,
    )


def _misfits(
    estimate: "xarray.Dataset", scenario: Scenario, plane: LocalPlane
) -> np.ndarray:
    """Return mean squares over the axes of each leg's flow less the learned one on its way, (n,).

    The way is a straight line from fix to fix; its mean is by Gauss-Legendre quadrature.
    """
    theta = estimate.flow_parameters_estimate.values[-1]
    start, end = (
        np.column_stack(
            [
                *plane.to_plane(estimate[f"{of}latitude"], estimate[f"{of}longitude"]),
                (estimate[time].values - np.datetime64(estimate.attrs["time_origin"]))
                / np.timedelta64(1, "s")
                / SECONDS[scenario.units.time],
            ]
        )
        for of, time in (("start_", "start_time"), ("", "end_time"))
    )
    learned = 0.0
    for node, weight in zip(
        *np.polynomial.legendre.leggauss(POINTS_OF_A_WAY), strict=True
    ):
        x1, x2, t = (start + (1 + node) / 2 * (end - start)).T
        phi = evaluate(scenario.basis_block(), t, np.column_stack([x1, x2]))
        learned = learned + weight / 2 * phi @ theta.T
    return np.mean((estimate.leg_flow.values - learned) ** 2, axis=1)


# --- chart ---------------------------------------------------------------------------------------


@public
def flow_map_plot(source: "xarray.Dataset", *, ax: "Axes | None" = None) -> "Axes":
    """Draw the learned flow at the end, its error and the track.

    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> ax = flow_map_plot(clpt.simulate(scenario))
    """
    learned = learned_flow(source)
    ax = axes_for(ax, 6.4, 5.2)
    flow = map_of(learned).isel(time=0)
    y, x = (flow[name] for name in flow.u.dims)
    easting, northing = learned.track.T
    if learned.plane is not None:
        northing, easting = learned.plane.to_earth(easting, northing)
    for name in SHADES & flow.keys():
        shade = flow[name].plot.pcolormesh
        label = label_of(flow[name].long_name, flow[name])
        bar = {"shrink": 0.7, "label": label}
        shade(ax=ax, cmap="Greys", vmin=0, alpha=0.4, cbar_kwargs=bar)
    ax.plot(easting, northing, color=BLUE, linewidth=0.9, label="track")
    arrows = flow.isel(dict.fromkeys(flow.u.dims, slice(0, None, BETWEEN)))
    fastest = float(f"{np.hypot(flow.u, flow.v).max():.1g}") or 1.0
    for prefix, label, color, width in ARROWS:
        if f"{prefix}u" in flow:
            names = x.name, y.name, f"{prefix}u", f"{prefix}v"
            drawn = ax.quiver(
                *(arrows[name] for name in names),
                scale=9 * fastest,
                label=label,
                color=color,
                width=width,
                zorder=3,
            )
    unit = printed_unit(learned.unit)
    ax.quiverkey(drawn, 0.85, 1.03, fastest, f"{fastest:g} {unit}", labelpos="E")
    ax.set(xlabel=label_of(x.name, x), ylabel=label_of(y.name, y), title="")
    ax.set_aspect(1 / np.cos(np.radians(y.mean())) if learned.is_geographic else 1.0)
    ax.ticklabel_format(style="plain", useOffset=False)
    ax.locator_params(nbins=4)
    ax.set_title(f"Learned flow, {_time_of(flow)}", **TITLE)
    legend_below(ax, 3)
    return ax


def _time_of(flow: "xarray.Dataset") -> str:
    """Return the time of a map: a date in UTC, or the time since the start of the run."""
    time = flow.time
    if time.dtype.kind == "M":
        return f"{time.dt.strftime('%Y-%m-%d %H:%M').item()} UTC"
    return f"t = {time.item():g} {time.attrs.get('units', '')}".strip()
