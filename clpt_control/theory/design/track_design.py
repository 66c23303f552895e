"""A design: the scenario with better waypoints, and both tracks side by side.

The goal is how soon the scenario's own law learns, or kappa_1: the smallest eigenvalue over both
axes of the joint Gramian of Definition 3.1 where e = 0 (`waypoint_tracks`).  The limits
(`Limits`) hold over the whole run (`search`).  For the paper's two laws, which are linear in
e and eta, the search maximises what V falls by over the window; for another law kappa_1.  Its best
tracks and the scenario's own are then run with the law, and the one on which it learns soonest is
taken.  The other numbers of both tracks come from `gramian` and `simulate` of the two scenarios
with their own law.

learning time   the first time from which on every flow parameter is within a level of theta

The picture has the two tracks side by side, and what is learned on each.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ...arguments import Positive, Seed, public
from ...errors import ScenarioError
from ...figures import BLUE, GREY, ORANGE, TITLE, axes_for, legend_below
from ...scenario.experiment import Scenario
from ...simulation.integrate import sample_times, simulate
from ...simulation.mean_squares import clpe_of_samples, step_of_means
from ..excitation.certificates import gains_of_w
from ..excitation.gramian import gramian, started_true
from ..excitation.regressor import checked_window
from .search import CLOSE, best_waypoints
from .waypoint_tracks import (
    Box,
    Extremes,
    Limits,
    Tracks,
    closed_length,
    corners,
    vehicle_alone,
    with_waypoints,
)

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

MOST_WAYPOINTS = 200
LOOKS, MOST = 50, 20_000  # samples a waypoint for a smooth picture, and in all
TENTH = 0.1  # of the first error: the level without another


class Learned(NamedTuple):
    """A run, its largest flow-parameter error in time, and a summary."""

    scenario: Scenario
    run: "xarray.Dataset"
    error: np.ndarray
    summary: dict[str, Any]

    @property
    def cost(self) -> tuple[float, ...]:
        """Less is better: learning time, last error, CLPE."""
        time = self.summary["learning_time"]
        last = self.summary["error_at_end"], self.summary["clpe_rms_last_quarter"]
        return np.inf if time is None else time, *last


def learned(scenario: Scenario, level: float | None) -> Learned:
    """Run a scenario with its own law and summarise what it learned."""
    smooth = min(scenario.reference.dwell / LOOKS, step_of_means(scenario))
    step = min(scenario.run.output_step, max(smooth, scenario.run.duration / MOST))
    run = simulate(scenario, sample_times(scenario.run.duration, step))
    theta = np.array(scenario.flow.parameters)
    error = np.abs(run.flow_parameters_estimate.values - theta).max(axis=(1, 2))
    level = TENTH * float(error[0]) if level is None else float(level)
    key = "clpe_rms_last_quarter"
    summary = {
        key: clpe_of_samples(scenario, run)[key],
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
    # runs with the scenario's own law, before and after
    tracks: tuple[Learned, Learned]

    def __repr__(self) -> str:
        before, after = (
            self.report[k]["smallest_eigenvalue"] for k in ("before", "after")
        )
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
        Box for waypoints and vehicle: x1 from and to, x2 from and to. Without, what the
        scenario's own track fills.
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
    if scenario.flow.parameters is None:
        raise ScenarioError(
            "flow.field: a track is designed for parameters theta; give flow.parameters in its "
            "place, which `clpt fit` finds"
        )
    span = checked_window(scenario, window, start)
    before = _look(scenario, span)
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
    scenario: Scenario,
    looked: tuple[float, Extremes],
    span: tuple[float, float],
    ran: Learned,
) -> dict[str, Any]:
    found, (least, extremes), ceiling = gramian(scenario, *span), looked, None
    if scenario.vehicle.max_speed is None:
        alone = gramian(started_true(vehicle_alone(scenario)), *span)
        # where the vehicle moves so
        ceiling = min(alone.ceilings.values(), default=None)
    return {
        "smallest_eigenvalue": least,
        "of_the_run": found.smallest,
        "ceiling": ceiling,
        "closed_length": float(closed_length(scenario.waypoints)),
        "largest_speed": float(extremes.speed.max()),
        "positions": np.transpose(
            [extremes.low[0].min(axis=0), extremes.high[0].max(axis=0)]
        ).tolist(),
        "waypoints": scenario.waypoints.tolist(),
        **ran.summary,
    }


LOWEST = 1e-16  # errors below are drawn there


@public
def design_plot(design: Design, *, ax: Any = None) -> np.ndarray:
    """Draw the old and the new track, and what is learned on both.

    Parameters
    ----------
    design : Design
        As `design_track` gives it.
    ax : array of 3 Axes, optional
        Where to draw; by default a new figure of pyplot's.

    Returns
    -------
    ndarray of Axes, shape (3,)
        Both tracks over the window; the largest error of a flow parameter on both.

    Raises
    ------
    ClptError
        If `ax` are fewer or more Axes.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 80, "reference.count": 2})
    >>> given = {"goal": "kappa", "window": 20}
    >>> found = clpt.theory.design_track(scenario, **given)
    >>> old, new, error = clpt.theory.design_plot(found)
    """
    axes = axes_for(ax, 11.8, 4.9, ncols=3)
    for k, one in enumerate(axes[:2]):
        _track(one, design, k)
        one.set_aspect("equal")
        one.margins(0.06)
    axes[0].sharex(axes[1])
    axes[0].sharey(axes[1])
    legend_below(axes[1], 3)
    _error(axes[2], design)
    return axes


def _track(ax: "Axes", design: Design, k: int) -> None:
    from matplotlib.patches import Rectangle

    one, report = design.tracks[k], design.report
    found = report["before" if k == 0 else "after"]
    unit, (x1, x1_end, x2, x2_end) = one.scenario.units.length, report["limits"]["area"]
    dotted: dict[str, Any] = {"fill": False, "edgecolor": GREY, "linestyle": ":"}
    ax.add_patch(Rectangle((x1, x2), x1_end - x1, x2_end - x2, label="area", **dotted))
    points = one.scenario.waypoints
    closed = np.vstack([points, points[:1]])
    ax.plot(*closed.T, "--", color=ORANGE, linewidth=1.0, label="closed polygon")
    t = one.run.time.values
    inside = (t >= report["start"]) & (t <= report["start"] + report["window"])
    path = one.run.position.values[inside]
    ax.plot(*path.T, color=BLUE, linewidth=1.0, label="vehicle, in the window")
    ranks: dict[str, Any] = {
        "c": np.arange(len(points)),
        "cmap": "viridis",
        "zorder": 3,
    }
    ax.scatter(points[:, 0], points[:, 1], label="waypoints, the first dark", **ranks)
    ax.plot(
        *one.run.position.values[0], "s", color="black", markersize=5, label="start"
    )
    name = "old" if k == 0 else "new"
    ax.set_title(
        rf"{name}: $\kappa_1$ = {found['smallest_eigenvalue']:.3g}, "
        f"length {found['closed_length']:.4g} {unit}",
        **TITLE,
    )
    ax.set(xlabel=f"$x_1$ ({unit})", ylabel=f"$x_2$ ({unit})")


def _error(ax: "Axes", design: Design) -> None:
    units = design.report["units"]
    for one, colour, style, name in zip(
        design.tracks,
        (ORANGE, BLUE),
        ("--", "-"),
        ("old track", "new track"),
        strict=True,
    ):
        error = np.maximum(one.error, LOWEST)
        ax.semilogy(one.run.time, error, style, color=colour, linewidth=1.6, label=name)
    speed, level = f"{units['length']}/{units['time']}", design.report["after"]["level"]
    ax.axhline(
        level,
        color=GREY,
        linewidth=1.0,
        linestyle=":",
        label=f"level {level:.3g} {speed}",
    )
    ax.set(
        xlabel=f"time ({units['time']})",
        ylabel=f"largest flow-parameter error ({speed})",
    )
    ax.set_title(f"what {design.report['law']} learns", **TITLE)
    ax.legend(fontsize=8, frameon=False)
