"""Summary of a run in numbers, and the claims of section IV.

    CLPE rms per cycle     rms of |e| over one round of the waypoints
    parameter error        max |alpha + theta|, and max |gain - true gain|
    disagreement           of a team: max |alpha_i - alpha_j| over all pairs

Mean squares are those of `mean_squares`.  Errors and disagreement are reported at some times
(`TIMES`) and at the end.  The claims are the paper's sentences about figures 2 to 4, each with a
criterion, the measured value and a verdict.
"""

import json
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..base.arguments import check_holds
from ..base.errors import DataError
from ..base.run_attributes import ARGUMENTS
from ..engine.methods import ROWS
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.recorded_run import unknown_parts
from ..paper.scenario.team import Team
from .flows import Figures, explained_variance, flow_error, speeds_of
from .integrate import simulate
from .mean_squares import MAX_SAMPLES, clpe_of_samples, nearest, step_of_means, union
from .requests import sample_times

if TYPE_CHECKING:
    from xarray import Dataset

SUMMARY = "summary"  # attribute of a run: its summary as JSON
SOLVER = "solver_"  # prefix of the attributes of solver statistics
TIMES = (10, 20, 100, 200, 500, 1000, 2000)  # of errors


class RunReport(NamedTuple):
    """A run with its summary: `run` at its own samples, `fine` at even ones for figures."""

    run: "Dataset"
    fine: "Dataset"
    summary: Figures


def run_and_report(
    system: Scenario | Team,
    progress: Callable[[float], None] | None = None,
    **options: Any,
) -> RunReport:
    """Run a scenario, or a team, and summarise it; `options` are those of `simulate`.

    Returns the run with the summary in its attributes, the same run evenly sampled for pictures
    (2000 samples a cycle, at most 200,000) and the summary: ``clpe_rms_per_cycle``, ``status``,
    ``message``, ``flow_error``, ``max_flow_parameter_error`` and ``max_gain_error`` by time; with a
    limited speed ``speed``; for a gridded field the explained variance.  A team's are by vehicle,
    of at most 20,000 samples, with ``max_disagreement`` by time.

    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> list(run_and_report(scenario).summary["max_gain_error"])
    ['10', '20']
    """
    end = system.run.duration
    scenarios = [*system.members.values()] if isinstance(system, Team) else [system]
    max_samples = MAX_SAMPLES // len(scenarios)
    step = min(step_of_means(scenario, max_samples) for scenario in scenarios)
    even_times = sample_times(end, step)
    run_times = sample_times(end, system.run.output_step)
    error_times = np.array([t for t in TIMES if t <= end], dtype=float)

    # one run at all of these times
    times = union(run_times, error_times, even_times)
    dense = simulate(system, times, progress=progress, **options)
    plain = None
    if dense.attrs["method"] not in [m.name for m in ROWS if not m.ends_at_samples]:
        plain = simulate(system, **options)
    dense.encoding[ARGUMENTS] = options
    reached = dense.time.values
    if dense.attrs["status"] == "stopped":
        indices = nearest(reached, run_times[run_times < reached[-1]])
        indices = np.append(indices, -1)
    else:
        indices = nearest(reached, run_times)
    run = dense.isel(time=indices) if plain is None else plain
    fine = dense.isel(time=nearest(reached, even_times))
    summary = ending_of(system, run) | figures_of(system, run, fine, dense)
    run.attrs[SUMMARY] = json.dumps(summary)
    return RunReport(run, fine, summary)


def ending_of(system: Scenario | Team, run: "Dataset") -> Figures:
    """Return title, units, status and solver statistics of a run, ready for JSON."""
    units = (system.first if isinstance(system, Team) else system).units
    statistics = {
        name.removeprefix(SOLVER): int(value)
        for name, value in run.attrs.items()
        if name.startswith(SOLVER)
    }
    return {
        "title": run.attrs.get("title", ""),
        "units": {"length": units.length, "time": units.time},
        "status": run.attrs.get("status", "finished"),
        "message": str(run.attrs.get("message", "no reason is recorded")),
        "end": float(run.time[-1]),
        "solver": statistics,
    }


def figures_of(
    system: Scenario | Team, run: "Dataset", fine: "Dataset", dense: "Dataset"
) -> Figures:
    """Return the figures of a run, for a team by vehicle, ready for JSON.

    Mean squares and speeds are those of `fine`, whose samples are even, errors those of `dense`,
    which has samples at the times of errors.
    """
    samples = _error_samples(dense)
    if isinstance(system, Scenario):
        return _vehicle_figures(system, run, fine, samples)
    disagreement = {
        time: float(sample.alpha.reduce(np.ptp, "vehicle").max())
        for time, sample in samples.items()
    }
    figures: Figures = {
        "vehicles": list(system.members),
        "coupling": system.coupling,
        "connectivity": system.connectivity,
        "max_disagreement": disagreement,
    }
    for name, scenario in system.members.items():
        vehicle_figures = _vehicle_figures(
            scenario,
            run.sel(vehicle=name),
            fine.sel(vehicle=name),
            {time: sample.sel(vehicle=name) for time, sample in samples.items()},
        )
        for key, value in vehicle_figures.items():
            figures.setdefault(key, {})[name] = value
    # vehicles have rounds of their own, the team has none
    del figures["clpe_rms_per_cycle"]
    return figures


def _error_samples(run: "Dataset") -> "dict[str, Dataset]":
    """Return the samples of a run at the times of errors, and the last, by time."""
    times = run.indexes["time"]
    targets = np.array(TIMES, dtype=float)
    targets = targets[targets < times[-1]]
    indices = times.get_indexer(targets, method="nearest", tolerance=1e-9 * targets)
    return {f"{times[k]:g}": run.isel(time=k) for k in (*indices[indices >= 0], -1)}


def _vehicle_figures(
    scenario: Scenario, run: "Dataset", fine: "Dataset", samples: "dict[str, Dataset]"
) -> Figures:
    """Return the figures of one vehicle; `samples` of its run are by time."""
    figures = clpe_of_samples(scenario, fine)
    vehicle = scenario.vehicle
    unknown = unknown_parts(run)
    if not {"basis_x", "true_flow"} & unknown and "delta" not in unknown:
        figures["flow_error"] = flow_error(scenario, fine)
    if "flow_parameters" in run:
        theta = run.flow_parameters
        figures["max_flow_parameter_error"] = {
            time: _max_error(sample.flow_parameters_estimate, theta)
            for time, sample in samples.items()
        }
    if "vehicle_controller" not in unknown:
        figures["max_gain_error"] = {
            time: max(
                _max_error(sample.feedback_gain, vehicle.feedback),
                _max_error(sample.feedforward_gain, vehicle.feedforward),
            )
            for time, sample in samples.items()
        }
    if scenario.flow.parameters is None and "true_flow" not in unknown:
        figures["explained_variance"] = explained_variance(scenario, run)
    if vehicle.max_speed is not None and "commanded_velocity" in run:
        figures["speed"] = speeds_of(fine, vehicle.max_speed)
    return figures


def _max_error(estimate: Any, truth: Any) -> float:
    return float(np.abs(estimate - truth).max())


def claims(summary: Figures) -> list[dict[str, str]]:
    """Check the three claims of section IV on a run of its scenario.

    >>> summary = {"clpe_rms_per_cycle": [0.2, 0.01],
    ...            "max_flow_parameter_error": {"200": 0.3, "2000": 0.02},
    ...            "max_gain_error": {"200": 0.04, "2000": 0.01}}
    >>> [claim["verdict"] for claim in claims(summary)]
    ['holds', 'holds by t = 2000, not in one cycle', 'holds']
    """
    cure = "run_and_report(scenario) gives a summary"
    check_holds("claims: summary", summary, ["clpe_rms_per_cycle"], cure)
    rms = summary["clpe_rms_per_cycle"]
    errors = [
        summary.get(f"max_{name}_error", {}) for name in ("flow_parameter", "gain")
    ]
    if len(rms) < 2 or any({"200", "2000"} - error.keys() for error in errors):
        raise DataError(
            "the claims of section IV are about its scenario, which has theta, from t = 0 to 2000"
        )
    share = rms[1] / rms[0]
    clpe_claim = {
        "claim": "CLPE goes to zero over about one cycle",
        "criterion": "rms |e| in the second cycle at most 10 % of the first",
        "measured": f"{rms[0]:.3g}, then {rms[1]:.3g} ({100 * share:.4g} %); "
        f"last cycle {rms[-1]:.3g}",
        "verdict": "holds" if share <= 0.1 else "fails",
    }
    flow_claim = "the six flow parameters converge to their true values"
    return [
        clpe_claim,
        _convergence(flow_claim, errors[0]),
        _convergence("the gains converge likewise", errors[1]),
    ]


def _convergence(claim: str, error: dict[str, float]) -> dict[str, str]:
    """Return a claim of convergence with its verdict; errors are by time."""
    early = error["200"]
    late = error["2000"]
    verdict = "fails"
    if late <= 0.05:
        verdict = "holds" if early <= 0.05 else "holds by t = 2000, not in one cycle"
    return {
        "claim": claim,
        "criterion": "largest error at most 0.05 after one cycle, t = 200",
        "measured": f"{early:.3g} at t = 200, {late:.3g} at t = 2000",
        "verdict": verdict,
    }
