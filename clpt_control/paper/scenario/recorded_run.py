"""The check of a recorded run, before it is reported, filmed, estimated from or measured.

A run comes from a file, which may be damaged, or from a user, who may have changed it.
"""

import re
from typing import TYPE_CHECKING, Any

import numpy as np

from ...base.errors import DataError
from .experiment import Scenario
from .file import CHANGED, REFERENCE, TEAM, own_parts
from .team import Team

if TYPE_CHECKING:
    import xarray

ON_THE_PLANE = (  # variables of a run
    *("position", "predicted_position", "measured_position", "clpe", "reference"),
    *(
        "feedback_gain",
        "feedforward_gain",
        "true_flow",
        "velocity",
        "commanded_velocity",
    ),
)
DIMS = {  # variable of a run -> its dimensions, after those of a team
    "time": ("time",),
    **dict.fromkeys(ON_THE_PLANE, ("time", "axis")),
    "alpha": ("time", "axis", "basis"),
    "flow_parameters_estimate": ("time", "axis", "basis"),
    "flow_parameters_readout": ("time", "axis", "basis"),
    "flow_parameters": ("axis", "basis"),
    "lyapunov": ("time",),
}
SHARED = ("time", "flow_parameters", "lyapunov")  # by the vehicles of a team
# attributes
TEXTS = ("title", "source", "software", "status", "message", "engine", "method")
LARGEST = 1e75  # number whose fourth power is finite
KINDS = {  # of datasets -> the attribute that says so; the first counts
    "team": TEAM,
    "ensemble": "ensemble",
    "run": "scenario",
    "replay": "estimator",
    "diagram": "engine",
}
MOST_WAYPOINTS = 1e6  # of a run, unless its scenario has more


def waypoints_of(run: "xarray.Dataset", scenario: Scenario) -> np.ndarray:
    """Return the waypoints of a run; none where its desired position is not its scenario's."""
    return np.zeros((0, 2)) if REFERENCE in own_parts(run.attrs) else scenario.waypoints


def unknown_parts(run: "xarray.Dataset") -> set[str]:
    """Return the parts of a run's diagram that its scenario does not hold, or their numbers."""
    changed = re.findall(r"(\w+)\.", run.attrs.get(CHANGED, ""))  # blocks, and digits
    return {*changed, *own_parts(run.attrs)}


def kind_of(data: "xarray.Dataset") -> str:
    """Return what a dataset is, one of `KINDS`, or nothing."""
    return next((kind for kind, name in KINDS.items() if name in data.attrs), "")


def is_response(run: "xarray.Dataset") -> bool:
    """Return whether a dataset is the run of a diagram that has no scenario."""
    return kind_of(run) == "diagram"


def check_response(run: "xarray.Dataset") -> None:
    """Refuse a dataset that is no whole run of a diagram: finite numbers along times."""
    check_attributes(run)
    times = run.variables.get("time")
    if times is None or times.dims != ("time",) or not times.size:
        raise DataError("the run has no sample along time; clpt.simulate makes runs")
    names = {"state", "parameter"} & run.coords.keys()
    for name, one in run.variables.items():
        finite = name in names or (
            one.dtype.kind in "iuf" and np.all(np.isfinite(one.values))
        )
        if not finite or (name in run.data_vars and "time" not in one.dims):
            raise DataError(
                f"the run's {name!s:.40} holds no finite numbers along time; run it again"
            )
        if not isinstance(one.attrs.get("units", ""), str):
            raise DataError(f"the units of the run's {name!s:.40} are no text")
    if not np.all(np.diff(times.values) > 0):
        raise DataError("the run is not whole: its times do not increase")
    if not set(run.data_vars) - {"states"}:
        raise DataError("the run has no signal; clpt.simulate makes runs")


def check_attributes(run: "xarray.Dataset") -> None:
    """Refuse texts and the solver's counts that are none."""
    for name, value in run.attrs.items():
        count = str(name).startswith("solver_")
        if (count or name in TEXTS) and not isinstance(
            value, int | np.integer if count else str
        ):
            kind = "a whole number" if count else "a text"
            raise DataError(
                f"the run's attribute {name} is {value!r:.40}; must be {kind}"
            )


def check_run(run: "xarray.Dataset", system: Scenario | Team, *names: str) -> None:
    """Refuse a dataset that is no whole run of a system, or whose `names` hold no finite numbers.

    All variables of `DIMS` must be numbers over their dimensions, times must increase, and there
    must be a sample.
    """
    first = system.first if isinstance(system, Team) else system
    sizes = {"axis": 2, "basis": first.basis.N}
    if isinstance(system, Team):
        names += ("alpha", "flow_parameters_estimate")  # on which its vehicles agree
        sizes["vehicle"] = len(system.members)
        vehicles = np.ravel(run["vehicle"].values) if "vehicle" in run else ()
        if list(map(str, vehicles)) != list(system.members):
            raise DataError(
                f"the run's vehicles are not {', '.join(system.members)}, its team's"
            )
    check_attributes(run)
    for name, dims in DIMS.items():
        if "vehicle" in sizes and name not in SHARED:
            dims = ("vehicle", *dims)
        if name not in {*run.variables, *names}:
            continue
        one: Any = run.variables.get(name)
        whole = one is not None and one.dims == dims
        if not whole or any(n != sizes.get(dim, n) for dim, n in one.sizes.items()):
            over = ", ".join(f"{dim} {sizes.get(dim, '')}".strip() for dim in dims)
            raise DataError(
                f"the run has no {name} over {over}, as its scenario has; clpt.simulate(scenario) "
                "makes runs"
            )
        if not one.size:
            raise DataError("the run has no sample; there is nothing to show")
        numbers = one.dtype.kind in "iuf"
        if not numbers or (name in names and not np.all(np.abs(one.values) <= LARGEST)):
            raise DataError(
                f"the run's {name} holds what is no finite number, or one beyond {LARGEST:g}; run "
                "it again"
            )
    times, last = (
        run.time.values,
        max(first.run.duration, MOST_WAYPOINTS * first.reference.dwell),
    )
    if not np.all(np.diff(times) > 0):
        raise DataError("the run is not whole: its times do not increase")
    if not 0 <= times[0] <= times[-1] <= last:
        raise DataError(
            f"the run's times go from {times[0]:g} to {times[-1]:g}; must lie in 0 to {last:g} "
            f"{first.units.time}"
        )
