"""Checks of recorded runs before they are plotted, reported, estimated from or measured.

A run comes from a file, which may be damaged, or from a user, who may have changed it.
"""

import re
from typing import TYPE_CHECKING, Any

import numpy as np

from ...base.errors import DataError
from ...base.run_attributes import CHANGED, REFERENCE, TEAM
from ...engine.model.block import evaluate
from ..blocks.vehicle import vehicle_controller
from .experiment import Scenario
from .file import own_parts
from .team import Team, scenario_of_run

if TYPE_CHECKING:
    import xarray

ON_THE_PLANE = (  # variables of a run with two axes
    "position",
    "predicted_position",
    "measured_position",
    "clpe",
    "reference",
    "feedback_gain",
    "feedforward_gain",
    "true_flow",
    "velocity",
    "commanded_velocity",
)
DIMS = {  # variable of a run -> its dimensions, after those of a team
    "time": ("time",),
    **dict.fromkeys(ON_THE_PLANE, ("time", "axis")),
    "alpha": ("time", "axis", "basis"),
    "flow_parameters_estimate": ("time", "axis", "basis"),
    "flow_parameters_readout": ("time", "axis", "basis"),
    "flow_parameters": ("axis", "basis"),
    **dict.fromkeys(("lyapunov", "error_left"), ("time",)),
}
SHARED = (
    "time",
    "flow_parameters",
    "lyapunov",
)  # variables without a dimension of vehicles
# attributes that are texts
TEXTS = ("title", "source", "software", "status", "message", "engine", "method")
LARGEST = 1e75  # number whose fourth power is finite
KINDS = {  # kind of dataset -> its attribute; the first that is present decides
    "team": TEAM,
    "ensemble": "ensemble",
    "fixes": "fix_law",
    "tube": "steps_beside_switches",
    "run": "scenario",
    "replay": "estimator",
    "diagram": "engine",
}
# variables and attributes of an estimate that are read, by their kinds of NumPy and dimensions
ESTIMATE = {
    "iuf leg": """leg start_latitude start_longitude latitude longitude predicted_latitude
    predicted_longitude forecast_radius turn guaranteed""",
    "M leg": "start_time end_time",
    "biu leg": "inside",
    "iuf leg axis": "position_error flow leg_flow",
    "iuf leg axis basis": "flow_parameters_estimate",
    "iuf leg basis": "standard_error",
    "iuf leg axis basis other_basis": "covariance",
    "iuf axis": "origin",
    "iuf": "has_origin unspanned_flow scatter walk noise_scale",
    "U": "time_origin fix_law fix_method guarantee",
}
MOST_WAYPOINTS = 1e6  # visited in a run that is longer than its scenario


def commanded_velocity(
    scenario: Scenario, timepts: np.ndarray, x: np.ndarray, zc: np.ndarray
) -> np.ndarray:
    """Return the velocity through the water at positions, Eq. (7), without a limit, (n, 2)."""
    car = scenario.vehicle
    controller = vehicle_controller(
        scenario.model_parameters, car.feedback, car.feedforward
    )
    phi = evaluate(scenario.basis_block(), timepts, x)
    return evaluate(controller, timepts, np.hstack([x, zc, phi]))


def waypoints_of(run: "xarray.Dataset", scenario: Scenario) -> np.ndarray:
    """Return the waypoints of a run; none if its reference is not that of its scenario."""
    return np.zeros((0, 2)) if REFERENCE in own_parts(run.attrs) else scenario.waypoints


def unknown_parts(run: "xarray.Dataset") -> set[str]:
    """Return the blocks of a run's diagram that are not those of its scenario."""
    changed = re.findall(r"(\w+)\.", run.attrs.get(CHANGED, ""))  # blocks, and digits
    return {*changed, *own_parts(run.attrs)}


def kind_of(data: "xarray.Dataset") -> str:
    """Return the kind of a dataset, a key of `KINDS`, or ""."""
    kind = next((kind for kind, name in KINDS.items() if name in data.attrs), "")
    is_one = kind == "team" and "vehicle" in data.coords and not data.vehicle.ndim
    return "run" if is_one else kind


def is_response(run: "xarray.Dataset") -> bool:
    """Return whether a dataset is the run of a diagram that has no scenario."""
    return kind_of(run) == "diagram"


def check_response(run: "xarray.Dataset") -> None:
    """Refuse a dataset that is not a complete run of a diagram: finite numbers along time."""
    check_attributes(run)
    times = run.variables.get("time")
    if times is None or times.dims != ("time",) or not times.size:
        raise DataError("the run has no sample along time; clpt.simulate makes runs")
    names = {"state", "parameter"} & run.coords.keys()
    for name, variable in run.variables.items():
        finite = name in names or (
            variable.dtype.kind in "iuf" and np.all(np.isfinite(variable.values))
        )
        if not finite or (name in run.data_vars and "time" not in variable.dims):
            raise DataError(
                f"the run's {name!s:.40} has no finite numbers along time. Run it again"
            )
        if not isinstance(variable.attrs.get("units", ""), str):
            raise DataError(f"the units of the run's {name!s:.40} are no text")
    check_increasing(times.values)
    if not set(run.data_vars) - {"states"}:
        raise DataError("the run has no signal; clpt.simulate makes runs")


def check_variable(
    run: "xarray.Dataset", name: str, sizes: dict[str, int], finite: bool
) -> None:
    """Refuse a variable that is not of numbers over its dimensions, finite if asked for."""
    dims = DIMS[name]
    if "vehicle" in sizes and name not in SHARED:
        dims = ("vehicle", *dims)
    variable: Any = run.variables.get(name)
    fits = variable is not None and variable.dims == dims
    if not fits or any(n != sizes.get(dim, n) for dim, n in variable.sizes.items()):
        over = ", ".join(f"{dim} {sizes.get(dim, '')}".strip() for dim in dims)
        raise DataError(
            f"the run has no {name} over {over}, as its scenario has; clpt.simulate(scenario) "
            "makes runs"
        )
    if not variable.size:
        raise DataError("the run has no sample; there is nothing to show")
    is_number = variable.dtype.kind in "iuf"
    if not is_number or (finite and not np.all(np.abs(variable.values) <= LARGEST)):
        raise DataError(
            f"the run's {name} contains a number that is not finite, or one beyond "
            f"{LARGEST:g}. Run "
            "it again"
        )


def check_increasing(times: np.ndarray) -> None:
    """Refuse times that do not increase."""
    if not np.all(np.diff(times) > 0):
        raise DataError("the run is not whole: its times do not increase")


def check_attributes(run: "xarray.Dataset") -> None:
    """Refuse attributes of the wrong type: texts and the solver's counts."""
    for name, value in run.attrs.items():
        if str(name).startswith("solver_"):
            valid, kind = isinstance(value, int | np.integer), "a whole number"
        else:
            valid, kind = name not in TEXTS or isinstance(value, str), "a text"
        if not valid:
            raise DataError(
                f"the run's attribute {name} is {value!r:.40}; must be {kind}"
            )


def check_run(run: "xarray.Dataset", system: Scenario | Team, *names: str) -> None:
    """Refuse a dataset that is not a complete run of a system, or without the variables `names`.

    All variables of `DIMS` must be numbers over their dimensions, those of `names` finite, times
    must increase, and there must be a sample.
    """
    scenario = system.first if isinstance(system, Team) else system
    sizes = {"axis": 2, "basis": scenario.basis.N}
    if isinstance(system, Team):
        names += ("alpha", "flow_parameters_estimate")  # on which its vehicles agree
        sizes["vehicle"] = len(system.members)
        vehicles = np.ravel(run["vehicle"].values) if "vehicle" in run else ()
        if list(map(str, vehicles)) != list(system.members):
            raise DataError(
                f"the run's vehicles are not {', '.join(system.members)}, its team's"
            )
    check_attributes(run)
    for name in DIMS:
        if name in run.variables or name in names:
            check_variable(run, name, sizes, name in names)
    times = run.time.values
    check_increasing(times)
    latest = max(scenario.run.duration, MOST_WAYPOINTS * scenario.reference.dwell)
    if not 0 <= times[0] <= times[-1] <= latest:
        raise DataError(
            f"the run's times go from {times[0]:g} to {times[-1]:g}; must lie in 0 to {latest:g} "
            f"{scenario.units.time}"
        )


def scenario_with(run: "xarray.Dataset", *names: str) -> Scenario:
    """Return the scenario of a run that has some variables along its time."""
    scenario = scenario_of_run(run)
    check_run(run, scenario, "time", *names)
    return scenario


def read_estimate(
    data: "xarray.Dataset", read: str
) -> "tuple[xarray.Dataset, Scenario]":
    """Return an estimate with dates and its axes in order, and its scenario.

    Refuse one without the variables and attributes `read`, finite over their dimensions.
    """
    import xarray

    scenario = scenario_of_run(data)
    N = scenario.basis.N
    sizes = {**data.sizes, "axis": 2, "basis": N, "other_basis": N}
    try:
        estimate = xarray.decode_cf(data).reindex(axis=["east", "north"])
        np.datetime64(str(data.attrs.get("time_origin", "NaT")))
    except ValueError:
        raise DataError(
            "the estimate has no axis east and north, or no dates. Estimate again"
        ) from None
    rows = {name: row for row, names in ESTIMATE.items() for name in names.split()}
    for name in read.split():
        found = estimate.variables.get(name, estimate.attrs.get(name, ()))
        (kind, *dims), values = rows[name].split(), np.asarray(found)
        fits = [*getattr(found, "dims", dims)] == dims and values.dtype.kind in kind
        fits &= values.size > 0 and [*values.shape] == [*map(sizes.get, dims)]
        # before they became dates, too
        numbers = values, np.asarray(data.variables.get(name, 0.0))
        valid = np.isfinite if name != "guaranteed" else lambda x: ~np.isnan(x)
        if not fits or (kind != "U" and not all(valid(x).all() for x in numbers)):
            over = f" over {', '.join(dims)}" if dims else ""
            raise DataError(
                f"the estimate has no finite {name}{over}, as its scenario has: it is damaged, or "
                "of an older version. Estimate again"
            )
    return estimate, scenario


def fixes_of(estimate: "xarray.Dataset") -> tuple[np.ndarray, np.ndarray]:
    """Return latitudes and longitudes of all fixes, (2, m), and the number of the leg of each.

    Each leg ends at a fix; it begins at that of the leg before, or at one of its own.
    """
    starts = estimate[["start_latitude", "start_longitude"]].to_array().values
    ends = estimate[["latitude", "longitude"]].to_array().values
    is_other = np.any(starts[:, 1:] != ends[:, :-1], axis=0)
    own = np.flatnonzero(np.append(True, is_other))
    legs = np.arange(ends.shape[1])
    return np.insert(ends, own, starts[:, own], axis=1), np.insert(legs, own, own)


def thinned(run: "xarray.Dataset", step: int) -> "xarray.Dataset":
    """Return each `step`-th sample of a run, and the last one."""
    last = run.sizes["time"] - 1
    few = run.isel(time=np.unique([*range(0, last, step), last]))
    few.encoding.update(run.encoding)
    return few
