"""What a run achieved, in numbers and as the claims of section IV.

    CLPE rms per cycle     rms of |e| over one round of the waypoints
    parameter error        max |alpha + theta|, and max |gain - true gain|
    disagreement           of a team: max |alpha_i - alpha_j| over all pairs

Mean squares are over 2000 samples a cycle, each 0.1 of the paper's cycle of 200, a team's over its
recorded samples.  A run of more than 100 cycles goes on in pieces of 100 cycles, so that memory
does not grow with samples that are used for mean squares alone.
Errors and disagreement are given at some times (`TIMES`) and at the end.
The claims are the paper's sentences about figures 2 to 4, each with its criterion, what was
measured, and a verdict.
"""

import json
from collections.abc import Callable
from itertools import pairwise
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..arguments import check_holds, public
from ..blocks.localization import TRUE
from ..errors import DataError
from ..native.ending import Solution
from ..scenario.experiment import Scenario
from ..scenario.tables import Units
from ..scenario.team import Team
from .flows import SpeedTimer, explained_variance, note_speeds, speeds_of
from .integrate import sample_times, simulate
from .running import ScenarioRun

if TYPE_CHECKING:
    import xarray

SAMPLES_PER_CYCLE = 2000
PIECE = 100 * SAMPLES_PER_CYCLE  # samples; a piece ends where a cycle does, at a breakpoint
GROUP = 100  # samples summed together where there are several pieces


class Grid(NamedTuple):
    """Evenly spaced times from 0 to the end, by number, without holding them all."""

    step: float
    end: float
    last: int  # the number of the end

    @classmethod
    def to(cls, end: float, step: float) -> "Grid":
        """Return the grid whose times are those of `sample_times`."""
        last = int(np.floor(end / step * (1 + 1e-12)))
        return cls(step, end, last if last * step >= end * (1 - 1e-12) else last + 1)

    def times(self, numbers: np.ndarray) -> np.ndarray:
        """Return the times of some numbers."""
        return np.where(numbers < self.last, self.step * numbers, self.end)

    @property
    def every(self) -> int:
        """Return how many times there are for each one in pictures, which show a piece at most."""
        return -(-self.last // PIECE)


def run_in_pieces(
    scenario: Scenario, required: np.ndarray, grid: Grid, progress: Callable[[float], None] | None
) -> "tuple[xarray.Dataset, dict[str, Any], SpeedTimer | None]":
    """Run a scenario; return it at times that are required or drawn, its CLPE and speeds."""
    run, pieces = ScenarioRun(scenario), list(pairwise([*range(0, grid.last, PIECE), grid.last]))
    group = 1 if len(pieces) == 1 else GROUP
    squares, parts = [], []
    x_z = [run.columns(TRUE) or run.columns("x"), run.columns("z")]
    timer = None if run.max_speed is None else SpeedTimer(run.max_speed)
    state, statistics = run.start, dict[str, int]()
    engines, methods = dict[str, None](), dict[str, None]()
    for first, last in pieces:
        numbers = np.arange(first, last + 1)
        even = grid.times(numbers)
        inside = required[(required >= even[0]) & (required <= even[-1])]
        times = union(inside, even)
        times[0], times[-1] = even[0], even[-1]
        solution = run.runner.run(state, times, progress=progress, **scenario.run.solver)
        state, signals = solution.x[-1], run.runner.signals(solution)
        for name, count in solution.statistics.items():
            statistics[name] = statistics.get(name, 0) + count
        final = last == grid.last or solution.status == "stopped"
        at = nearest(solution.t, even)
        pictured = at[numbers[: len(at)] % grid.every == 0]
        end = [len(solution.t) - 1]
        stored = np.unique(np.concatenate([nearest(solution.t, inside), pictured, end]))
        if not final:  # the next piece begins there
            at, stored = at[:-1], stored[:-1]
        x, z = (signals[at][:, places] for places in x_z)
        size = np.sum((x - z) ** 2, axis=1)
        if timer is not None:
            speeds = (signals[at][:, run.columns(port)] for port in ("v_c", "flow_x"))
            timer.add(solution.t[at], *speeds)
        starts = np.arange(0, len(at), group)
        counts = np.diff(np.append(starts, len(at)))
        squares.append((solution.t[at][starts], np.add.reduceat(size, starts), counts))
        parts.append((solution.t[stored], solution.x[stored], signals[stored]))
        engines[solution.engine] = methods[solution.method] = None
        if final:
            break
    t, states, signals = (np.concatenate(one) for one in zip(*parts, strict=True))
    ran = ", ".join(engines), ", ".join(methods)  # a long run may begin in Python
    whole = Solution(t, states, solution.status, solution.message, statistics, *ran)
    times, sums, counts = (np.concatenate(one) for one in zip(*squares, strict=True))
    return run.dataset(whole, signals), clpe_rms(scenario, times, sums, counts), timer


def union(first: np.ndarray, more: np.ndarray) -> np.ndarray:
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


# --- figures -------------------------------------------------------------------------------------


SUMMARY = "summary"  # attribute of a run: its summary as JSON
TIMES = (10, 20, 100, 200, 500, 1000, 2000)


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
        sampled for pictures (2000 samples a cycle, fewer in a run of more
        than 100 cycles); and the summary:
        ``clpe_rms_per_cycle`` (over 2000 samples a cycle),
        ``max_flow_parameter_error`` and ``max_gain_error`` keyed by time,
        ``status`` and ``message``; with ``vehicle.max_speed`` also ``speed``, the share of time
        at it and when the flow was faster; for a gridded field also the shares of
        variance that the learned flow explains. Of a team these are by vehicle and of its own
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
        dense = simulate(system, times, progress=progress)
        run = _at_own_samples(dense, own)
        return RunReport(run, run, team_summary(system, run, dense))
    grid = Grid.to(end, system.cycle / SAMPLES_PER_CYCLE)
    dense, clpe, timer = run_in_pieces(system, times, grid, progress)
    if timer is not None:
        note_speeds(dense, timer.figures(), system.units)
    run = _at_own_samples(dense, own)
    pictured = np.append(np.arange(0, grid.last, grid.every), grid.last)
    even = dense.isel(time=nearest(dense.time.values, grid.times(pictured)))
    figures = {**clpe, **errors(system, run, at_times(dense))}
    if timer is not None:
        figures["speed"] = timer.figures()
    summary = _summary(dense, system.units, figures)
    run.attrs[SUMMARY] = json.dumps(summary)
    return RunReport(run, even, summary)


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
    return {
        "title": run.attrs["title"],
        "units": {"length": units.length, "time": units.time},
        "status": run.attrs["status"],
        "message": run.attrs["message"],
        "end": float(run.time[-1]),
        **figures,
        "solver": {
            name.removeprefix("solver_"): int(value)
            for name, value in run.attrs.items()
            if name.startswith("solver_")
        },
    }


def clpe_rms(
    scenario: Scenario, times: np.ndarray, squares: np.ndarray, counts: np.ndarray
) -> dict[str, Any]:
    """Return roots of mean squares: of each round, of all, of the last quarter.

    `squares` are sums of so many |e|^2, `counts`, from each time on.
    """
    first, end = float(times[0]), float(times[-1])
    slack = 1e-9 * max(1.0, end)
    number = np.floor((times + slack) / scenario.cycle)  # of the round
    starts = np.flatnonzero(np.diff(number, prepend=-1.0))
    rounds = pairwise(starts)  # the last one has just begun
    late = int(np.searchsorted(times, first + 0.75 * (end - first) - slack))
    spans = {"clpe_rms": slice(None), "clpe_rms_last_quarter": slice(late, None)}

    def rms(of: slice) -> float:
        return float(np.sqrt(squares[of].sum() / counts[of].sum()))

    return {
        "clpe_rms_per_cycle": [rms(slice(*one)) for one in rounds],
        **{name: rms(of) for name, of in spans.items()},
    }


def clpe_of_samples(scenario: Scenario, run: "xarray.Dataset") -> dict[str, Any]:
    """Return roots of mean squares over the samples of a vehicle's run."""
    squares = ((run.position - run.predicted_position).values ** 2).sum(-1)
    return clpe_rms(scenario, run.time.values, squares, np.ones(len(squares)))


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
    if scenario.flow.parameters is not None:
        theta = np.array(scenario.flow.parameters)
        figures["max_flow_parameter_error"] = {
            key: float(np.abs(one.flow_parameters_estimate - theta).max())
            for key, one in at.items()
        }
    car = scenario.vehicle
    gains = {"feedback_gain": car.feedback, "feedforward_gain": car.feedforward}
    figures["max_gain_error"] = {
        key: max(float(np.abs(one[name] - np.array(true)).max()) for name, true in gains.items())
        for key, one in at.items()
    }
    if scenario.flow.field is not None:
        figures["explained_variance"] = explained_variance(scenario, run)
    return figures


def team_summary(team: Team, run: "xarray.Dataset", dense: "xarray.Dataset") -> dict[str, Any]:
    """Return the figures of a team's run, by vehicle; errors are those of its `dense` samples."""
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
    check_holds(
        "claims: summary",
        summary,
        ["clpe_rms_per_cycle"],
        "clpt.simulation.run_and_report(scenario) gives a summary",
    )
    rms, keys = summary["clpe_rms_per_cycle"], ("max_flow_parameter_error", "max_gain_error")
    if len(rms) < 2 or not all({"200", "2000"} <= summary.get(key, {}).keys() for key in keys):
        raise DataError(
            "the claims of section IV are about its scenario, which has theta, from t = 0 to 2000"
        )
    share = rms[1] / rms[0]
    measured = f"{rms[0]:.3f}, then {rms[1]:.3f} ({100 * share:.0f} %); last cycle {rms[-1]:.4f}"
    rows = [
        (
            "CLPE goes to zero over about one cycle",
            "rms |e| in the second cycle at most 10 % of the first",
            measured,
            "holds" if share <= 0.1 else "fails",
        )
    ]
    about = "the six flow parameters converge to their true values", "the gains converge likewise"
    for claim, key in zip(about, keys, strict=True):
        early, late = summary[key]["200"], summary[key]["2000"]
        verdict = "fails"
        if late <= 0.05:
            verdict = "holds" if early <= 0.05 else "holds by t = 2000, not in one cycle"
        criterion = "largest error at most 0.05 after one cycle, t = 200"
        rows.append((claim, criterion, f"{early:.3f} at t = 200, {late:.3f} at t = 2000", verdict))
    names = ("claim", "criterion", "measured", "verdict")
    return [dict(zip(names, row, strict=True)) for row in rows]
