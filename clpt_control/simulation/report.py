"""What a run achieved, in numbers and as the claims of section IV.

    CLPE rms per cycle     rms of |e| over one round of the waypoints
    parameter error        max |alpha + theta|, and max |gain - true gain|

The claims judge the paper's sentences about figures 2 to 4, each with its
criterion, what was measured, and a verdict.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..scenario.experiment import Scenario

if TYPE_CHECKING:
    import xarray

TIMES = (10, 20, 100, 200, 500, 1000, 2000)
SAMPLES_PER_CYCLE = 2000  # each 0.1 of the paper's cycle of 200
MOST_SAMPLES = 200_000


class Report(NamedTuple):
    """A run with what it achieved.

    Attributes
    ----------
    run : xarray.Dataset
        At the scenario's own samples.
    fine : xarray.Dataset
        The same run at 2000 samples a cycle, for mean squares and pictures.
    summary : dict
        Figures ready for JSON.
    """

    run: "xarray.Dataset"
    fine: "xarray.Dataset"
    summary: dict[str, Any]


def run_and_report(scenario: Scenario, progress: Callable[[float], None] | None = None) -> Report:
    """Run a scenario and summarise it.

    Parameters
    ----------
    scenario : Scenario
        The experiment.
    progress : callable, optional
        Called with the time reached.

    Returns
    -------
    Report
        The run, the same run finely sampled, and the summary:
        ``clpe_rms_per_cycle`` (over 2000 samples a cycle),
        ``max_flow_parameter_error`` and ``max_gain_error`` keyed by time,
        ``status`` and ``message``; for a gridded field also the shares of
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
    from .integrate import sample_times, simulate

    own = sample_times(scenario.run.duration, scenario.run.output_step)
    cycles = scenario.run.duration / scenario.cycle
    per_cycle = min(SAMPLES_PER_CYCLE, max(20, int(MOST_SAMPLES / max(cycles, 1))))
    fine = sample_times(scenario.run.duration, scenario.cycle / per_cycle)
    marks = np.array([t for t in TIMES if t <= scenario.run.duration], dtype=float)
    times = _union(own, np.concatenate([fine, marks]))
    dense = simulate(scenario, times, progress=progress)
    reached = dense.time.values
    run = dense.isel(time=nearest(reached, own))
    if dense.attrs["status"] == "stopped":
        run = dense.isel(time=np.append(nearest(reached, own[own < reached[-1]]), -1))
    run.encoding.update(dense.encoding)
    even = dense.isel(time=nearest(reached, fine))
    summary = summarise(scenario, even, dense)
    if scenario.flow.field is not None:
        from .flows import explained_variance

        summary["explained_variance"] = explained_variance(scenario, run)
    return Report(run, even, summary)


def _union(first: np.ndarray, more: np.ndarray) -> np.ndarray:
    """Sorted times of both; where two differ by rounding, the one of `first`."""
    distance = np.abs(first[nearest(first, more)] - more)
    return np.union1d(first, more[distance > 1e-9 * max(1.0, float(first[-1]))])


def nearest(times: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """Return where increasing times are nearest to those wanted, up to the last."""
    wanted = wanted[wanted <= times[-1] * (1 + 1e-12)]
    after = np.clip(np.searchsorted(times, wanted), 1, len(times) - 1)
    return np.where(wanted - times[after - 1] < times[after] - wanted, after - 1, after)


def summarise(
    scenario: Scenario, fine: "xarray.Dataset", dense: "xarray.Dataset"
) -> dict[str, Any]:
    """Return a run's figures, ready for JSON.

    Parameters
    ----------
    scenario : Scenario
        The experiment.
    fine : xarray.Dataset
        The run at evenly spaced samples, for mean squares.
    dense : xarray.Dataset
        The run with the times of the table among its samples.

    Returns
    -------
    dict
        See `run_and_report`.
    """
    summary: dict[str, Any] = {
        "title": scenario.title,
        "units": {"length": scenario.units.length, "time": scenario.units.time},
        "status": dense.attrs["status"],
        "message": dense.attrs["message"],
        "end": float(dense.time[-1]),
        "clpe_rms_per_cycle": clpe_rms(fine, scenario.cycle),
        "clpe_rms": _rms(fine),
        "clpe_rms_last_quarter": _rms(fine.isel(time=slice(-(len(fine.time) // 4 + 1), None))),
    }
    marks = {str(t): float(t) for t in TIMES if t <= summary["end"] * (1 + 1e-12)}
    at = {key: dense.sel(time=t, method="nearest") for key, t in marks.items()}
    if scenario.flow.parameters is not None:
        theta = np.array(scenario.flow.parameters)
        summary["max_flow_parameter_error"] = {
            key: float(np.abs(run.flow_parameters_estimate - theta).max())
            for key, run in at.items()
        }
    gains = {
        "feedback_gain": np.array(scenario.vehicle.feedback),
        "feedforward_gain": np.array(scenario.vehicle.feedforward),
    }
    summary["max_gain_error"] = {
        key: max(float(np.abs(run[name] - true).max()) for name, true in gains.items())
        for key, run in at.items()
    }
    summary["solver"] = {
        name.removeprefix("solver_"): int(value)
        for name, value in dense.attrs.items()
        if name.startswith("solver_")
    }
    return summary


def _rms(run: "xarray.Dataset") -> float:
    return float(np.sqrt(np.mean(np.sum(run.clpe.values**2, axis=1))))


def clpe_rms(run: "xarray.Dataset", span: float) -> list[float]:
    """Return the rms of |e| over each full span of time.

    Span j is [span j, span (j + 1)).

    Parameters
    ----------
    run : xarray.Dataset
        Evenly sampled.
    span : float
        Such as one round of the waypoints, in the run's unit of time.

    Returns
    -------
    list of float
        One number for each span that the run holds whole.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> run = clpt.simulate(clpt.paper_scenario().with_values({"run.duration": 40}))
    >>> len(clpe_rms(run, 20.0))
    2
    """
    time = run.time.values
    squares = np.sum(run.clpe.values**2, axis=1)
    slack = 1e-9 * max(1.0, float(time[-1]))
    number = np.floor((time + slack) / span).astype(int)
    full = int(np.floor((time[-1] + slack) / span))
    return [float(np.sqrt(squares[number == j].mean())) for j in range(full)]


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

    Examples
    --------
    >>> summary = {"clpe_rms_per_cycle": [0.2, 0.01],
    ...            "max_flow_parameter_error": {"200": 0.3, "2000": 0.02},
    ...            "max_gain_error": {"200": 0.04, "2000": 0.01}}
    >>> [claim["verdict"] for claim in claims(summary)]
    ['holds', 'holds by t = 2000, not in one cycle', 'holds']
    """
    rms = summary["clpe_rms_per_cycle"]
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
