"""What a run achieved, in numbers and as the claims of section IV.

    CLPE rms per cycle     rms of |e| over one round of the waypoints
    parameter error        max |alpha + theta|, and max |gain - true gain|

Mean squares are over 2000 samples a cycle, each 0.1 of the paper's cycle of 200.  A run of
more than 100 cycles goes piece by piece, 100 cycles at a time; of each piece only sums of
squares and the samples that are asked for are kept.

The claims judge the paper's sentences about figures 2 to 4, each with its
criterion, what was measured, and a verdict.
"""

from collections.abc import Callable
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..native.ending import Solution
from ..scenario.experiment import Scenario
from .integrate import ScenarioRun, sample_times

if TYPE_CHECKING:
    import xarray

TIMES = (10, 20, 100, 200, 500, 1000, 2000)
SAMPLES_PER_CYCLE = 2000
PIECE = 100 * SAMPLES_PER_CYCLE  # samples; a piece ends where a cycle does, at a breakpoint
BLOCK = 100  # samples summed together where there are several pieces


class RunReport(NamedTuple):
    """A run with what it achieved: `run` at its own samples, `fine` evenly for pictures."""

    run: "xarray.Dataset"
    fine: "xarray.Dataset"
    summary: dict[str, Any]


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
        The run; the same run evenly sampled for pictures (2000 samples a
        cycle, fewer in a run of more than 100 cycles); and the summary:
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
    end = scenario.run.duration
    own = sample_times(end, scenario.run.output_step)
    marks = np.array([t for t in TIMES if t <= end], dtype=float)
    grid = Grid(end, scenario.cycle / SAMPLES_PER_CYCLE)
    dense, squares = _run_in_pieces(scenario, _union(own, marks), grid, progress)
    reached = dense.time.values
    run = dense.isel(time=nearest(reached, own))
    if dense.attrs["status"] == "stopped":
        run = dense.isel(time=np.append(nearest(reached, own[own < reached[-1]]), -1))
    run.encoding.update(dense.encoding)
    even = dense.isel(time=nearest(reached, grid.shown()))
    summary = _summary(scenario, squares, dense)
    if scenario.flow.field is not None:
        from .flows import explained_variance

        summary["explained_variance"] = explained_variance(scenario, run)
    return RunReport(run, even, summary)


class Grid:
    """Evenly spaced times to the end, as `sample_times` gives them, without holding them all."""

    def __init__(self, end: float, step: float):
        self.end, self.step = end, step
        last = int(np.floor(end / step * (1 + 1e-12)))
        self.last = last if last * step >= end * (1 - 1e-12) else last + 1  # the end's number

    def times(self, first: int, last: int) -> np.ndarray:
        """Return times number `first` to `last`, both included."""
        times = self.step * np.arange(first, last + 1)
        times[-1] = min(times[-1], self.end) if last < self.last else self.end
        return times

    def pieces(self) -> list[tuple[int, int]]:
        """Return the numbers of the first and the last time of each piece."""
        edges = [*range(0, self.last, PIECE), self.last]
        return list(pairwise(edges))

    def shown(self, first: int = 0, last: int | None = None) -> np.ndarray:
        """Return those of the times that pictures show: at most a piece's number and the end."""
        last, every = self.last if last is None else last, -(-self.last // PIECE)
        numbers = np.arange(-(-first // every) * every, last + 1, every)
        times = numbers[numbers < self.last] * self.step
        return np.append(times, self.end) if last == self.last else times


class Squares(NamedTuple):
    """Sums of |e|^2 over blocks of evenly spaced samples."""

    sums: np.ndarray
    counts: np.ndarray
    block: int  # samples

    def rms(self, first: int = 0, last: int | None = None) -> float:
        """Return the rms of |e| from sample `first` up to `last`, to the block."""
        span = slice(first // self.block, None if last is None else last // self.block)
        return float(np.sqrt(self.sums[span].sum() / self.counts[span].sum()))


def _run_in_pieces(
    scenario: Scenario, kept: np.ndarray, grid: Grid, progress: Callable[[float], None] | None
) -> "tuple[xarray.Dataset, Squares]":
    """Run a scenario; return it at the times that are kept or shown, and its squares."""
    run, pieces = ScenarioRun(scenario), grid.pieces()
    block = 1 if len(pieces) == 1 else BLOCK
    sums, counts, parts = [], [], []
    state, statistics = run.start, dict[str, int]()
    for first, last in pieces:
        even, shown = grid.times(first, last), grid.shown(first, last)
        inside = kept[(kept >= even[0]) & (kept <= even[-1])]
        times = _union(inside, np.union1d(even, shown))
        times[0], times[-1] = even[0], even[-1]
        solution = run.integrate(state, times, progress)
        state = solution.x[-1]
        for name, count in solution.statistics.items():
            statistics[name] = statistics.get(name, 0) + count
        stopped = solution.status == "stopped"
        whole = stopped or last == grid.last
        signals = run.signals(solution)
        at = nearest(solution.t, even)[: None if whole else -1]  # the next piece begins there
        e = signals[at][:, run.columns("e")]
        starts = np.arange(0, len(at), block)
        sums.append(np.add.reduceat(np.sum(e**2, axis=1), starts))
        counts.append(np.diff(np.append(starts, len(at))))
        held = np.union1d(nearest(solution.t, inside), nearest(solution.t, shown))
        if stopped:
            held = np.union1d(held, [len(solution.t) - 1])
        if not whole:
            held = held[held < len(solution.t) - 1]
        parts.append((solution.t[held], solution.x[held], signals[held]))
        if stopped:
            break
    t, x, signals = (np.concatenate(one) for one in zip(*parts, strict=True))
    joined = Solution(t, x, solution.status, solution.message, statistics)
    squares = Squares(np.concatenate(sums), np.concatenate(counts), block)
    return run.dataset(joined, signals), squares


def _union(first: np.ndarray, more: np.ndarray) -> np.ndarray:
    """Return sorted times of both; where two differ by rounding, the one of `first`."""
    if not len(first):
        return more
    after = np.searchsorted(first, more)
    sides = [first[np.clip(after - k, 0, len(first) - 1)] for k in (0, 1)]
    distance = np.abs(np.array(sides) - more).min(axis=0)
    return np.union1d(first, more[distance > 1e-9 * max(1.0, float(first[-1]))])


def nearest(times: np.ndarray, wanted: np.ndarray) -> np.ndarray:
    """Return where increasing times are nearest to those wanted, up to the last."""
    wanted = wanted[wanted <= times[-1] * (1 + 1e-12)]
    after = np.clip(np.searchsorted(times, wanted), 1, len(times) - 1)
    return np.where(wanted - times[after - 1] < times[after] - wanted, after - 1, after)


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
