"""What a run achieved, in numbers and as the claims of section IV.

    CLPE rms per cycle     rms of |e| over one round of the waypoints
    parameter error        max |alpha + theta|, and max |gain - true gain|
    disagreement           of a team: max |alpha_i - alpha_j| over all pairs

Mean squares are those of `mean_squares`.  Errors and disagreement are given at some times (`TIMES`)
and at the end.
The claims are the paper's sentences about figures 2 to 4, each with its criterion, what was
measured, and a verdict.
"""

import json
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..base.arguments import check_holds, public
from ..base.errors import DataError
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.recorded_run import unknown_parts
from ..paper.scenario.team import Team
from .flows import explained_variance, speeds_of
from .integrate import sample_times, simulate
from .mean_squares import MOST, clpe_of_samples, nearest, step_of_means, union

if TYPE_CHECKING:
    from xarray import Dataset

SUMMARY = "summary"  # attribute of a run: its summary as JSON
OF = "solver_"  # begins the attributes that say how much the solver did
TIMES = (10, 20, 100, 200, 500, 1000, 2000)


class RunReport(NamedTuple):
    """A run with what it achieved: `run` at its own samples, `fine` evenly for pictures."""

    run: "Dataset"
    fine: "Dataset"
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
    end, step = system.run.duration, system.run.output_step
    members = [*system.members.values()] if isinstance(system, Team) else [system]
    even = sample_times(
        end, min(step_of_means(one, MOST // len(members)) for one in members)
    )
    own, marks = (
        sample_times(end, step),
        np.array([t for t in TIMES if t <= end], dtype=float),
    )
    dense = simulate(system, union(own, marks, even), progress=progress)
    reached, stopped = dense.time.values, dense.attrs["status"] == "stopped"
    at = nearest(reached, own[own < reached[-1]] if stopped else own)
    run = dense.isel(time=[*at, -1] if stopped else at)
    fine = dense.isel(time=nearest(reached, even))
    summary = {**ending_of(system, run), **figures_of(system, run, fine, dense)}
    run.attrs[SUMMARY] = json.dumps(summary)
    return RunReport(run, fine, summary)


def ending_of(system: Scenario | Team, run: "Dataset") -> dict[str, Any]:
    """Return what a run is, where it ended and how, ready for JSON."""
    units = (system.first if isinstance(system, Team) else system).units
    return {
        "title": run.attrs.get("title", ""),
        "units": {"length": units.length, "time": units.time},
        "status": run.attrs.get("status", "finished"),
        "message": str(run.attrs.get("message", "no reason is recorded")),
        "end": float(run.time[-1]),
        "solver": {
            k.removeprefix(OF): int(v) for k, v in run.attrs.items() if k.startswith(OF)
        },
    }


def figures_of(
    system: Scenario | Team, run: "Dataset", fine: Any = None, dense: Any = None
) -> dict[str, Any]:
    """Return the figures of a run, a team's by vehicle, ready for JSON.

    Mean squares and speeds are those of `fine`, whose samples are even, errors those of `dense`,
    which has samples at the times of errors.
    """
    fine, dense = run if fine is None else fine, run if dense is None else dense
    at = _at_times(dense)
    if isinstance(system, Scenario):
        return _achieved(system, run, fine, at)
    apart = {
        k: one.alpha.max("vehicle") - one.alpha.min("vehicle") for k, one in at.items()
    }
    figures: dict[str, Any] = {
        "vehicles": list(system.members),
        "coupling": system.coupling,
        "connectivity": system.connectivity,
        "max_disagreement": {key: float(one.max()) for key, one in apart.items()},
    }
    for name, scenario in system.members.items():
        own, own_fine = (one.sel(vehicle=name) for one in (run, fine))
        own_at = {key: one.sel(vehicle=name) for key, one in at.items()}
        for key, value in _achieved(scenario, own, own_fine, own_at).items():
            figures.setdefault(key, {})[name] = value
    # rounds of several vehicles are no rounds of the team
    del figures["clpe_rms_per_cycle"]
    return figures


def _at_times(run: "Dataset") -> "dict[str, Dataset]":
    """Return those samples of a run at which errors are given, by time, the end the last."""
    times = run.time.values
    at = {t: int(np.abs(times - t).argmin()) for t in TIMES if t < times[-1]}
    there = [(t, k) for t, k in at.items() if abs(times[k] - t) <= 1e-9 * t]
    return {f"{t:g}": run.isel(time=k) for t, k in [*there, (float(times[-1]), -1)]}


def _achieved(
    scenario: Scenario, run: "Dataset", fine: "Dataset", at: "dict[str, Dataset]"
) -> dict[str, Any]:
    """Return what one vehicle achieved; `at` are samples of its run by time."""
    figures, unknown = clpe_of_samples(scenario, fine), unknown_parts(run)
    if "flow_parameters" in run:
        wrong = {
            k: one.flow_parameters_estimate - run.flow_parameters
            for k, one in at.items()
        }
        figures["max_flow_parameter_error"] = {
            k: float(abs(v).max()) for k, v in wrong.items()
        }
    if "vehicle_controller" not in unknown:
        car = scenario.vehicle
        true = {"feedback_gain": car.feedback, "feedforward_gain": car.feedforward}
        figures["max_gain_error"] = {
            key: max(
                float(np.abs(one[name] - gain).max()) for name, gain in true.items()
            )
            for key, one in at.items()
        }
    if scenario.flow.field is not None and "true_flow" not in unknown:
        figures["explained_variance"] = explained_variance(scenario, run)
    if scenario.vehicle.max_speed is not None and "commanded_velocity" in run:
        figures["speed"] = speeds_of(fine, scenario.vehicle.max_speed)
    return figures


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
    rms, keys = (
        summary["clpe_rms_per_cycle"],
        ("max_flow_parameter_error", "max_gain_error"),
    )
    if len(rms) < 2 or not all(
        {"200", "2000"} <= summary.get(key, {}).keys() for key in keys
    ):
        raise DataError(
            "the claims of section IV are about its scenario, which has theta, from t = 0 to 2000"
        )
    share = rms[1] / rms[0]
    measured = f"{rms[0]:.3g}, then {rms[1]:.3g} ({100 * share:.4g} %); last cycle {rms[-1]:.3g}"
    claim = "CLPE goes to zero over about one cycle"
    criterion = "rms |e| in the second cycle at most 10 % of the first"
    rows = [(claim, criterion, measured, "holds" if share <= 0.1 else "fails")]
    about = (
        "the six flow parameters converge to their true values",
        "the gains converge likewise",
    )
    criterion = "largest error at most 0.05 after one cycle, t = 200"
    for claim, key in zip(about, keys, strict=True):
        early, late = summary[key]["200"], summary[key]["2000"]
        verdict = "fails"
        if late <= 0.05:
            verdict = (
                "holds" if early <= 0.05 else "holds by t = 2000, not in one cycle"
            )
        rows.append(
            (
                claim,
                criterion,
                f"{early:.3g} at t = 200, {late:.3g} at t = 2000",
                verdict,
            )
        )
    names = ("claim", "criterion", "measured", "verdict")
    return [dict(zip(names, row, strict=True)) for row in rows]
