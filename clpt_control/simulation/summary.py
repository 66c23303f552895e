"""What a run achieved, in numbers and as the claims of section IV.

    CLPE rms per cycle     rms of |e| over one round of the waypoints
    parameter error        max |alpha + theta|, and max |gain - true gain|
    disagreement           of a team: max |alpha_i - alpha_j| over all pairs

Mean squares are those of `pieces`, a team's over at most `MOST_OF_TEAM` samples.
Errors and disagreement are given at some times (`TIMES`) and at the end.
The claims are the paper's sentences about figures 2 to 4, each with its criterion, what was
measured, and a verdict.
"""

import json
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..arguments import check_holds, public
from ..errors import DataError
from ..scenario.experiment import Scenario
from ..scenario.recorded_run import unknown_parts
from ..scenario.tables import Units
from ..scenario.team import Team
from .flows import explained_variance, note_speeds, speeds_of
from .integrate import sample_times, simulate
from .pieces import Grid, clpe_of_samples, nearest, run_in_pieces, step_of_means, union

if TYPE_CHECKING:
    import xarray

SUMMARY = "summary"  # attribute of a run: its summary as JSON
OF = "solver_"  # begins the attributes that say how much the solver did
TIMES = (10, 20, 100, 200, 500, 1000, 2000)
MOST_OF_TEAM = 20_000  # samples


class RunReport(NamedTuple):
    """A run with what it achieved: `run` at its own samples, `fine` evenly for pictures."""

    run: "xarray.Dataset"
    fine: "xarray.Dataset"
    summary: dict[str, Any]


@public
def run_and_report(
    system: Scenario | Team, progress: Callable[[float], None] | None = None
) -> RunReport:
    """Run a scenario, or a team, and summarise it.

    Parameters
    ----------
    system : Scenario or Team
        The experiment.
    progress : callable, optional
        Called with the time reached.

    Returns
    -------
    RunReport
        The run, which carries the summary as JSON; the same run evenly
        sampled for pictures (2000 samples a cycle, or a run that is shorter; more where there are
        many waypoints or each is long; at most 200,000); and the summary:
        ``clpe_rms_per_cycle`` (over all such samples),
        ``max_flow_parameter_error`` and ``max_gain_error`` keyed by time,
        ``status`` and ``message``; with ``vehicle.max_speed`` also ``speed``, the share of time
        at it and when the flow was faster; for a gridded field also the shares of
        variance that the learned flow explains. Of a team these are by vehicle, of at most 20,000
        samples, with ``max_disagreement`` keyed by time.

    Raises
    ------
    SimulationError
        If the run cannot go on.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> list(run_and_report(scenario).summary["max_gain_error"])
    ['10', '20']
    """
    end = system.run.duration
    own = sample_times(end, system.run.output_step)
    times = union(own, np.array([t for t in TIMES if t <= end], dtype=float))
    if isinstance(system, Team):
        finest = min(step_of_means(one) for one in system.members.values())
        even = sample_times(end, max(finest, end / MOST_OF_TEAM))
        dense = simulate(system, union(times, even), progress=progress)
        fine = dense.isel(time=nearest(dense.time.values, even))
        return RunReport(_at_own_samples(dense, own), fine, team_summary(system, fine, dense))
    grid = Grid.to(end, step_of_means(system))
    dense, clpe, timer = run_in_pieces(system, times, grid, progress)
    if timer is not None:
        note_speeds(dense, timer.figures(), system.units)
    run = _at_own_samples(dense, own)
    pictured = np.append(np.arange(0, grid.last, grid.every), grid.last)
    fine = dense.isel(time=nearest(dense.time.values, grid.times(pictured)))
    figures = {**clpe, **errors(system, run, at_times(dense))}
    if timer is not None:
        figures["speed"] = timer.figures()
    summary = _summary(dense, system.units, figures)
    run.attrs[SUMMARY] = json.dumps(summary)
    return RunReport(run, fine, summary)


def _at_own_samples(dense: "xarray.Dataset", own: np.ndarray) -> "xarray.Dataset":
    """Return a run at times of its own; one that stopped is there to where it stopped."""
    reached = dense.time.values
    at = nearest(reached, own)
    if dense.attrs["status"] == "stopped":
        at = np.append(nearest(reached, own[own < reached[-1]]), -1)
    run = dense.isel(time=at)
    run.encoding.update(dense.encoding)
    return run


def _summary(run: "xarray.Dataset", units: Units, figures: dict[str, Any]) -> dict[str, Any]:
    """Return a run's figures with what it is and how it ended, ready for JSON."""
    solver = {k.removeprefix(OF): int(v) for k, v in run.attrs.items() if k.startswith(OF)}
    return {
        "title": run.attrs["title"],
        "units": {"length": units.length, "time": units.time},
        "status": run.attrs["status"],
        "message": run.attrs["message"],
        "end": float(run.time[-1]),
        **figures,
        "solver": solver,
    }


def at_times(run: "xarray.Dataset") -> "dict[str, xarray.Dataset]":
    """Return a run at the times of its errors, by time, the end the last."""
    last = float(run.time[-1])
    times = [*(float(t) for t in TIMES if t < last), last]
    return {f"{t:g}": run.sel(time=t, method="nearest") for t in times}


def errors(
    scenario: Scenario, run: "xarray.Dataset", at: "dict[str, xarray.Dataset]"
) -> dict[str, Any]:
    """Return how far a vehicle is from the truth; `at` are samples of its run by time."""
    figures: dict[str, Any] = {}
    if "flow_parameters" in run:
        wrong = {k: one.flow_parameters_estimate - run.flow_parameters for k, one in at.items()}
        figures["max_flow_parameter_error"] = {k: float(abs(v).max()) for k, v in wrong.items()}
    car = scenario.vehicle
    gains = {"feedback_gain": car.feedback, "feedforward_gain": car.feedforward}
    if "vehicle_controller" not in unknown_parts(run):
        figures["max_gain_error"] = {
            key: max(
                float(np.abs(one[name] - np.array(true)).max()) for name, true in gains.items()
            )
            for key, one in at.items()
        }
    if scenario.flow.field is not None and "true_flow" not in unknown_parts(run):
        figures["explained_variance"] = explained_variance(scenario, run)
    return figures


def team_summary(team: Team, run: "xarray.Dataset", dense: "xarray.Dataset") -> dict[str, Any]:
    """Return the figures of a team's run, by vehicle; errors are those of its `dense` samples.

    Mean squares and speeds are those of `run`, whose samples are even.
    """
    at = at_times(dense)
    figures: dict[str, Any] = {}
    for name, scenario in team.members.items():
        vehicle_run = run.sel(vehicle=name)
        of_vehicle = clpe_of_samples(scenario, vehicle_run)
        del of_vehicle["clpe_rms_per_cycle"]  # rounds of several vehicles are no rounds of the team
        own_at = {key: one.sel(vehicle=name) for key, one in at.items()}
        of_vehicle |= errors(scenario, vehicle_run, own_at)
        if (limit := scenario.vehicle.max_speed) is not None:
            of_vehicle["speed"] = speeds_of(vehicle_run, limit)
        for key, value in of_vehicle.items():
            figures.setdefault(key, {})[name] = value
    apart = {key: one.alpha.max("vehicle") - one.alpha.min("vehicle") for key, one in at.items()}
    of_the_team = {
        "vehicles": list(team.members),
        "coupling": team.coupling,
        "connectivity": team.connectivity,
        "max_disagreement": {key: float(one.max()) for key, one in apart.items()},
    }
    return _summary(run, team.first.units, {**of_the_team, **figures})


@public
def claims(summary: dict[str, Any]) -> list[dict[str, str]]:
    """Check the three claims of section IV on a run of its scenario.

    Parameters
    ----------
    summary : dict
        As `run_and_report` gives it.

    Returns
    -------
    list of dict
        ``claim``, ``criterion``, ``measured`` and ``verdict`` of each.

    Raises
    ------
    DataError
        If the run is too short, or its scenario has no theta.

    Examples
    --------
    >>> summary = {"clpe_rms_per_cycle": [0.2, 0.01],
    ...            "max_flow_parameter_error": {"200": 0.3, "2000": 0.02},
    ...            "max_gain_error": {"200": 0.04, "2000": 0.01}}
    >>> [claim["verdict"] for claim in claims(summary)]
    ['holds', 'holds by t = 2000, not in one cycle', 'holds']
    """
    cure = "clpt.simulation.run_and_report(scenario) gives a summary"
    check_holds("claims: summary", summary, ["clpe_rms_per_cycle"], cure)
    rms, keys = summary["clpe_rms_per_cycle"], ("max_flow_parameter_error", "max_gain_error")
    if len(rms) < 2 or not all({"200", "2000"} <= summary.get(key, {}).keys() for key in keys):
        raise DataError(
            "the claims of section IV are about its scenario, which has theta, from t = 0 to 2000"
        )
    share = rms[1] / rms[0]
    measured = f"{rms[0]:.3g}, then {rms[1]:.3g} ({100 * share:.4g} %); last cycle {rms[-1]:.3g}"
    claim = "CLPE goes to zero over about one cycle"
    criterion = "rms |e| in the second cycle at most 10 % of the first"
    rows = [(claim, criterion, measured, "holds" if share <= 0.1 else "fails")]
    about = "the six flow parameters converge to their true values", "the gains converge likewise"
    criterion = "largest error at most 0.05 after one cycle, t = 200"
    for claim, key in zip(about, keys, strict=True):
        early, late = summary[key]["200"], summary[key]["2000"]
        verdict = "fails"
        if late <= 0.05:
            verdict = "holds" if early <= 0.05 else "holds by t = 2000, not in one cycle"
        rows.append((claim, criterion, f"{early:.3g} at t = 200, {late:.3g} at t = 2000", verdict))
    names = ("claim", "criterion", "measured", "verdict")
    return [dict(zip(names, row, strict=True)) for row in rows]
