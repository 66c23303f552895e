"""What a team's run achieved, in numbers, vehicle by vehicle.

    parameter error    max |alpha_i + theta|
    disagreement       max |alpha_i - alpha_j| over all pairs
    CLPE rms           of |e_i|, of the true position, over the recorded samples

Errors and disagreement stand at the times of `report.TIMES` and at the end.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from ..scenario.team import Team
from .integrate import sample_times, simulate
from .pieces import nearest, union
from .report import TIMES, gain_error, parameter_error
from .speeds import speeds_of

if TYPE_CHECKING:
    import xarray


def run_team(
    team: Team, progress: Callable[[float], None] | None = None
) -> "tuple[xarray.Dataset, dict[str, Any]]":
    """Return a team's run at its own samples, and its figures, ready for JSON."""
    end = team.run.duration
    own = sample_times(end, team.run.output_step)
    marks = np.array([float(t) for t in TIMES if t < end])
    dense = simulate(team, union(own, marks), progress=progress)
    reached = dense.time.values
    run = dense.isel(time=nearest(reached, own))
    if dense.attrs["status"] == "stopped":
        run = dense.isel(time=np.append(nearest(reached, own[own < reached[-1]]), -1))
    run.encoding.update(dense.encoding)
    last = float(reached[-1])
    times = {f"{t:g}": float(t) for t in (*marks[marks < last], last)}
    at = {key: dense.sel(time=t, method="nearest") for key, t in times.items()}
    return run, team_summary(team, run, at)


def team_summary(
    team: Team, run: "xarray.Dataset", at: "dict[str, xarray.Dataset]"
) -> dict[str, Any]:
    """Return the figures of a run; `at` are samples of it by time."""
    units = team.first.units
    summary: dict[str, Any] = {
        "title": run.attrs["title"],
        "units": {"length": units.length, "time": units.time},
        "status": run.attrs["status"],
        "message": run.attrs["message"],
        "end": float(run.time[-1]),
        "vehicles": list(team.members),
        "coupling": team.coupling,
        "connectivity": team.connectivity,
        "clpe_rms": {},
        "clpe_rms_last_quarter": {},
        "max_gain_error": {},
    }
    if team.first.flow.parameters is not None:
        summary["max_flow_parameter_error"] = {}
    for name, scenario in team.members.items():
        off = (run.position - run.predicted_position).sel(vehicle=name).values
        squares = (off**2).sum(-1)
        late = run.time.values >= 0.75 * summary["end"]
        summary["clpe_rms"][name] = float(np.sqrt(squares.mean()))
        summary["clpe_rms_last_quarter"][name] = float(np.sqrt(squares[late].mean()))
        own = {key: one.sel(vehicle=name) for key, one in at.items()}
        summary["max_gain_error"][name] = {k: gain_error(scenario, s) for k, s in own.items()}
        if (limit := scenario.vehicle.max_speed) is not None:
            speeds = summary.setdefault("speed", {})
            speeds[name] = speeds_of(run.sel(vehicle=name), limit)
        if scenario.flow.parameters is not None:
            summary["max_flow_parameter_error"][name] = {
                key: parameter_error(scenario, sample) for key, sample in own.items()
            }
        else:
            from .flows import explained_variance

            of = summary.setdefault("explained_variance", {})
            of[name] = explained_variance(scenario, run.sel(vehicle=name))
    summary["max_disagreement"] = {key: disagreement(one) for key, one in at.items()}
    summary["solver"] = {
        name.removeprefix("solver_"): int(value)
        for name, value in run.attrs.items()
        if name.startswith("solver_")
    }
    return summary


def disagreement(sample: "xarray.Dataset") -> float:
    """Return the largest |alpha_i - alpha_j| of a team at one time."""
    alpha = sample.alpha
    return float((alpha.max("vehicle") - alpha.min("vehicle")).max())
