"""A design: the scenario with better waypoints, and both tracks side by side.

The goal is how soon the scenario's own law learns, or kappa_1: the smallest eigenvalue over both
axes of the joint Gramian of Definition 3.1 where e = 0 (`waypoint_tracks`).  The limits
(`track_limits`) hold over the whole run (`search`).  For the paper's two laws, which are linear in
e and eta, the search maximises what V falls by over the window; for another law kappa_1.  Its best
tracks and the scenario's own are then run with the law, and the one on which it learns soonest is
taken.  The other numbers of both tracks come from `gramian` and `simulate` of the two scenarios
with their own law.

learning time   the first time from which on every flow parameter is within a level of theta
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ...arguments import Positive, Seed, public
from ...errors import ScenarioError
from ...scenario.experiment import Scenario
from ...simulation.flows import explained_variance
from ...simulation.integrate import sample_times, simulate
from ...simulation.mean_squares import clpe_of_samples, step_of_means
from ..excitation.certificates import gains_of_w
from ..excitation.gramian import gramian, started_true
from ..excitation.regressor import checked_window
from .search import CLOSE, best_waypoints
from .track_limits import Box, Limits, closed_length, corners
from .waypoint_tracks import Extremes, Tracks, vehicle_alone, with_waypoints

if TYPE_CHECKING:
    import xarray

MOST_WAYPOINTS = 200
LOOKS, MOST = 50, 20_000  # samples a waypoint for a smooth picture, and in all
TENTH = 0.1  # of the first error: the level without another


class Learned(NamedTuple):
    """A run, its largest flow-parameter error in time (None with a field), and a summary."""

    scenario: Scenario
    run: "xarray.Dataset"
    error: np.ndarray | None
    summary: dict[str, Any]

    @property
    def cost(self) -> tuple[float, ...]:
        """Less is better: learning time, last error, CLPE; with a field what is not explained."""
        rms = self.summary["clpe_rms_last_quarter"]
        if self.error is None:
            return -(self.summary["explained_variance"]["box"] or 0.0), rms
        time = self.summary["learning_time"]
        return np.inf if time is None else time, self.summary["error_at_end"], rms


def learned(scenario: Scenario, level: float | None) -> Learned:
    """Run a scenario with its own law and summarise what it learned."""
    smooth = min(scenario.reference.dwell / LOOKS, step_of_means(scenario))
    step = min(scenario.run.output_step, max(smooth, scenario.run.duration / MOST))
    run = simulate(scenario, sample_times(scenario.run.duration, step))
    key = "clpe_rms_last_quarter"
    summary: dict[str, Any] = {key: clpe_of_samples(scenario, run)[key]}
    if scenario.flow.parameters is None:
        shares = explained_variance(scenario, run)
        summary["explained_variance"] = {key: shares[key] for key in ("track", "box")}
        return Learned(scenario, run, None, summary)
    theta = np.array(scenario.flow.parameters)
    error = np.abs(run.flow_parameters_estimate.values - theta).max(axis=(1, 2))
    level = TENTH * float(error[0]) if level is None else float(level)
    summary |= {
        "level": level,
        "learning_time": time_below(run.time.values, error, level),
        "error_at_end": float(error[-1]),
    }
    return Learned(scenario, run, error, summary)


def time_below(times: np.ndarray, values: np.ndarray, level: float) -> float | None:
    """Return the first sample from which on all values are at most a level; None: there is none."""
    first = 1 + np.max(np.flatnonzero(~(values <= level)), initial=-1)
    return float(times[first]) if first < len(values) else None


GOALS = ("law", "kappa")
TRAJECTORY = "the vehicle alone in the scenario's flow, without CLPE (e = 0, z = x) and disturbance"


@dataclass(frozen=True)
class Design:
    """What `design_track` found."""

    scenario: Scenario  # with the new waypoints
    report: dict[str, Any]  # ready for JSON
    tracks: tuple[Learned, Learned]  # runs with the scenario's own law, before and after

    def __repr__(self) -> str:
        before, after = (self.report[k]["smallest_eigenvalue"] for k in ("before", "after"))
        return f"<Design of {len(self.scenario.waypoints)} waypoints: {before:.3g} to {after:.3g}>"


@public
def design_track(
    scenario: Scenario,
    *,
    length: Positive | None = None,
    max_speed: Positive | None = None,
    area: Box | None = None,
    goal: str = "law",
    window: float | None = None,
    start: float | None = None,
    level: Positive | None = None,
    seed: Seed = 0,
    progress: Callable[[float], None] | None = None,
) -> Design:
    """Find waypoints from which most can be learned, within limits.

    For the scenario's own law, or for the smallest eigenvalue of the joint Gramian over a window,
    along the vehicle in the scenario's flow without CLPE: where every law that works ends. The
    vehicle may wait: waypoints may coincide.

    Parameters
    ----------
    scenario : Scenario
        The flow to expect, the vehicle, the track to begin with.
    length : float, optional
        Longest closed polygon of waypoints, units.length; that of the scenario's own.
    max_speed : float, optional
        Largest speed through the water, length per time; any without.
    area : tuple of float, optional
        Box for waypoints and vehicle: x1 from and to, x2 from and to. Without, the field's, or
        what the scenario's own track fills.
    goal : str
        ``"law"``: the scenario's own law learns soonest; its track is kept where none is better.
        ``"kappa"``: the smallest eigenvalue, whatever the law makes of it.
    window, start : float, optional
        Of the Gramian, units.time; by default the second cycle, or as late as fits.
    level : float, optional
        Error of a flow parameter that ends the learning time; a tenth of the first.
    seed : int, optional
        Of the search; the same seed gives the same design.
    progress : callable, optional
        Called with the share of the work done.

    Returns
    -------
    Design
        `scenario` with the new waypoints, `report` and `tracks`, the runs before and after.

    Raises
    ------
    ScenarioError
        If a limit is impossible, or no track was found that keeps to the limits.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 80, "reference.count": 2})
    >>> given = {"goal": "kappa", "window": 20}
    >>> found = clpt.theory.design_track(scenario, **given)
    >>> found.report["after"]["smallest_eigenvalue"] > 0, len(found.scenario.waypoints)
    (True, 2)
    """
    if goal not in GOALS:
        raise ScenarioError(f"goal {goal!r}: must be one of {', '.join(GOALS)}")
    own, law = scenario.waypoints, goal == "law"
    if len(own) > MOST_WAYPOINTS:
        raise ScenarioError(
            f"reference: has {len(own)} waypoints; at most {MOST_WAYPOINTS} are designed"
        )
    span = checked_window(scenario, window, start)
    before = _look(scenario, span)
    reached = float(before[1].share[0])
    if reached < 1:
        raise ScenarioError(
            f"the scenario's own vehicle does not reach the end, {scenario.run.duration:g} "
            f"{scenario.units.time}, but {reached * scenario.run.duration:.4g}: shorten "
            "run.duration, or move its waypoints so that it stays within flow.field"
        )
    low, high = corners(scenario, area, before[1])
    longest = float(closed_length(own)) if length is None else float(length)
    report = progress or (lambda share: None)
    best, runs = best_waypoints(
        scenario,
        Limits(longest, max_speed, low, high),
        span,
        seed,
        report,
        linear_gains(scenario) if law else None,
    )
    tracks = [with_waypoints(scenario, one) for one in best[: None if law else 1]]
    ran = (
        learned(scenario, level),
        min((learned(one, level) for one in tracks), key=lambda one: one.cost),
    )
    designed = ran[1].scenario
    points, after = designed.waypoints, _look(designed, span)
    report(1.0)
    summary: dict[str, Any] = {
        "title": scenario.title,
        "units": scenario.units.model_dump(),
        "law": scenario.learning.law,
        "goal": goal,
        "own_track_kept": np.array_equal(points, own),
        "window": span[0],
        "start": span[1],
        "trajectory": TRAJECTORY,
        "limits": {
            "length": longest,
            "max_speed": max_speed,
            "area": np.transpose([low, high]).ravel().tolist(),
        },
        "seed": seed,
        "tracks_tried": runs,
        "before": _reported(scenario, before, span, ran[0]),
        "after": _reported(designed, after, span, ran[1]),
    }
    first, last = (summary[key]["smallest_eigenvalue"] for key in ("before", "after"))
    summary["ratio"] = last / first if first > 0 else None
    return Design(designed, summary, ran)


def linear_gains(scenario: Scenario) -> np.ndarray | None:
    """Return the N + 2 gains of one of the paper's laws, Eq. (28); None of another."""
    learning, gains = scenario.learning, gains_of_w(scenario)
    linear = learning.law in ("learned-flow", "known-flow") and learning.sample is None
    return gains if linear and gains.any() else None


def _look(scenario: Scenario, span: tuple[float, float]) -> tuple[float, Extremes]:
    """Return kappa_1 of one track, closely, and its extremes over the whole run."""
    tracks = Tracks(scenario, span, scenario.run.duration, *CLOSE)
    least, extremes = tracks(scenario.waypoints[None])
    return float(least.min()), extremes


def _reported(
    scenario: Scenario, looked: tuple[float, Extremes], span: tuple[float, float], ran: Learned
) -> dict[str, Any]:
    found, (least, extremes), ceiling = gramian(scenario, *span), looked, None
    if scenario.flow.parameters is not None and scenario.vehicle.max_speed is None:
        alone = gramian(started_true(vehicle_alone(scenario)), *span)
        ceiling = min(alone.ceilings.values(), default=None)  # where the vehicle moves so
    return {
        "smallest_eigenvalue": least,
        "of_the_run": min(float(values[0]) for values in found.eigenvalues.values()),
        "ceiling": ceiling,
        "closed_length": float(closed_length(scenario.waypoints)),
        "largest_speed": float(extremes.speed.max()),
        "positions": np.transpose(
            [extremes.low[0].min(axis=0), extremes.high[0].max(axis=0)]
        ).tolist(),
        "waypoints": scenario.waypoints.tolist(),
        **ran.summary,
    }
