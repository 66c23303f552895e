"""What a run achieved, in numbers and as the claims of section IV.

    CLPE rms per cycle     rms of |e| over one round of the waypoints
    parameter error        max |alpha + theta|, and max |gain - true gain|

Mean squares are over 2000 samples a cycle (`pieces`).
The claims judge the paper's sentences about figures 2 to 4, each with its
criterion, what was measured, and a verdict.
"""

import json
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..arguments import check_holds, public
from ..errors import DataError
from ..scenario.experiment import Scenario
from .integrate import sample_times
from .pieces import SAMPLES_PER_CYCLE, Grid, Squares, nearest, run_in_pieces, union
from .speeds import note_speeds

if TYPE_CHECKING:
    import xarray

SUMMARY = "summary"  # attribute of a run: its summary as JSON
TIMES = (10, 20, 100, 200, 500, 1000, 2000)


class RunReport(NamedTuple):
    """A run with what it achieved: `run` at its own samples, `fine` evenly for pictures."""

    run: "xarray.Dataset"
    fine: "xarray.Dataset"
    summary: dict[str, Any]


@public
def run_and_report(
    scenario: Scenario, progress: Callable[[float], None] | None = None
) -> RunReport:
    """Run a scenario and summarise it.

    Parameters
    ----------
    scenario : Scenario
        The experiment.
    progress : callable, optional
        Called with the time reached.

    Returns
    -------
    RunReport
        The run, which carries the summary as JSON; the same run evenly
        sampled for pictures (2000 samples a cycle, fewer in a run of more
        than 100 cycles); and the summary:
        ``clpe_rms_per_cycle`` (over 2000 samples a cycle),
        ``max_flow_parameter_error`` and ``max_gain_error`` keyed by time,
        ``status`` and ``message``; with ``vehicle.max_speed`` also ``speed``, the share of time
        at it and when the flow was faster; for a gridded field also the shares of
        variance that the learned flow explains.

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
    end = scenario.run.duration
    own = sample_times(end, scenario.run.output_step)
    marks = np.array([t for t in TIMES if t <= end], dtype=float)
    grid = Grid.to(end, scenario.cycle / SAMPLES_PER_CYCLE)
    dense, squares, watch = run_in_pieces(scenario, union(own, marks), grid, progress)
    if watch is not None:
        note_speeds(dense, watch.figures(), scenario.units)
    reached = dense.time.values
    run = dense.isel(time=nearest(reached, own))
    if dense.attrs["status"] == "stopped":
        run = dense.isel(time=np.append(nearest(reached, own[own < reached[-1]]), -1))
    run.encoding.update(dense.encoding)
    shown = np.append(np.arange(0, grid.last, grid.every), grid.last)
    even = dense.isel(time=nearest(reached, grid.times(shown)))
    summary = _summary(scenario, squares, dense)
    if watch is not None:
        summary["speed"] = watch.figures()
    if scenario.flow.field is not None:
        from .flows import explained_variance

        summary["explained_variance"] = explained_variance(scenario, run)
    run.attrs[SUMMARY] = json.dumps(summary)
    return RunReport(run, even, summary)


def _summary(scenario: Scenario, squares: Squares, dense: "xarray.Dataset") -> dict[str, Any]:
    """Return a run's figures, ready for JSON."""
    end = float(dense.time[-1])
    cycles = int(np.floor((end + 1e-9 * max(1.0, end)) / scenario.cycle))
    samples = int(squares.counts.sum())
    summary: dict[str, Any] = {
        "title": scenario.title,
        "units": {"length": scenario.units.length, "time": scenario.units.time},
        "status": dense.attrs["status"],
        "message": dense.attrs["message"],
        "end": end,
        "clpe_rms_per_cycle": [
            squares.rms(j * SAMPLES_PER_CYCLE, (j + 1) * SAMPLES_PER_CYCLE) for j in range(cycles)
        ],
        "clpe_rms": squares.rms(),
        "clpe_rms_last_quarter": squares.rms(samples - samples // 4 - 1),
    }
    marks = {str(t): float(t) for t in TIMES if t <= end * (1 + 1e-12)}
    at = {key: dense.sel(time=t, method="nearest") for key, t in marks.items()}
    if scenario.flow.parameters is not None:
        summary["max_flow_parameter_error"] = {
            key: parameter_error(scenario, sample) for key, sample in at.items()
        }
    summary["max_gain_error"] = {key: gain_error(scenario, one) for key, one in at.items()}
    summary["solver"] = {
        name.removeprefix("solver_"): int(value)
        for name, value in dense.attrs.items()
        if name.startswith("solver_")
    }
    return summary


def parameter_error(scenario: Scenario, sample: "xarray.Dataset") -> float:
    """Return the largest error of a flow parameter at one time."""
    theta = np.array(scenario.flow.parameters)
    return float(np.abs(sample.flow_parameters_estimate - theta).max())


def gain_error(scenario: Scenario, sample: "xarray.Dataset") -> float:
    """Return the largest error of K and Gamma at one time."""
    gains = {
        "feedback_gain": np.array(scenario.vehicle.feedback),
        "feedforward_gain": np.array(scenario.vehicle.feedforward),
    }
    return max(float(np.abs(sample[name] - true).max()) for name, true in gains.items())


@public
def claims(summary: dict[str, Any]) -> list[dict[str, str]]:
    """Judge the three claims of section IV on a run of its scenario.

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
    check_holds(
        "claims: summary",
        summary,
        ["clpe_rms_per_cycle"],
        "clpt.simulation.run_and_report(scenario) gives a summary",
    )
    rms = summary["clpe_rms_per_cycle"]
    if len(rms) < 2 or "2000" not in summary.get("max_flow_parameter_error", {}):
        raise DataError(
            "the claims of section IV are about its scenario, which has theta, from t = 0 to 2000"
        )
    share = rms[1] / rms[0]
    verdicts = [
        {
            "claim": "CLPE goes to zero over about one cycle",
            "criterion": "rms |e| in the second cycle at most 10 % of the first",
            "measured": f"{rms[0]:.3f}, then {rms[1]:.3f} ({100 * share:.0f} %); "
            f"last cycle {rms[-1]:.4f}",
            "verdict": "holds" if share <= 0.1 else "fails",
        }
    ]
    for claim, key in (
        ("the six flow parameters converge to their true values", "max_flow_parameter_error"),
        ("the gains converge likewise", "max_gain_error"),
    ):
        error = summary[key]
        early, late = error["200"], error["2000"]
        verdict = "fails"
        if late <= 0.05:
            verdict = "holds" if early <= 0.05 else "holds by t = 2000, not in one cycle"
        verdicts.append(
            {
                "claim": claim,
                "criterion": "largest error at most 0.05 after one cycle, t = 200",
                "measured": f"{early:.3f} at t = 200, {late:.3f} at t = 2000",
                "verdict": verdict,
            }
        )
    return verdicts
