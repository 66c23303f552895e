"""Design of waypoint tracks for a scenario's law, with a comparison of both tracks.

The goal is the shortest learning time of the scenario's own law, or the largest kappa_1: the
smallest eigenvalue over both axes of the joint Gramian of Definition 3.1 at e = 0
(`waypoint_tracks`).  The paper's two laws are linear in e and eta; for them the search maximises
the drop of V over the window, for another law kappa_1.  The best tracks and the original
one are then run with the law, and the track of the shortest learning time is chosen.

The learning time is the first time from which every flow parameter is within a level of theta.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ...base.arguments import Positive, Seed, public
from ...base.errors import ScenarioError
from ...base.figures import BLUE, GREY, ORANGE, TITLE, axes_for, legend_below
from ...paper.scenario.experiment import Scenario
from ...simulation.integrate import simulate
from ...simulation.mean_squares import clpe_of_samples, step_of_means
from ...simulation.requests import sample_times
from ..excitation.gramian import gramian
from ..excitation.regressor import checked_window, gains_of_w
from .search import FINE, best_waypoints
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

MAX_WAYPOINTS = 200
SAMPLES_PER_DWELL = 50  # for a smooth picture
MAX_SAMPLES = 20_000
ROUNDING = (
    1e-12  # of an eigenvalue of the Gramian of functions of size 1, over the window
)
TENTH = 0.1  # default level, share of the initial error
CLPE = "clpe_rms_last_quarter"
GOALS = ("law", "kappa")
TRAJECTORY = "the vehicle alone in the scenario's flow, without CLPE (e = 0, z = x) and disturbance"


class LearningRun(NamedTuple):
    """A run with its largest flow-parameter error in time and a summary."""

    scenario: Scenario
    run: "xarray.Dataset"
    error: np.ndarray
    summary: dict[str, Any]

    @property
    def cost(self) -> tuple[float, ...]:
        """Learning time, final error and CLPE, to be compared in this order."""
        time = self.summary["learning_time"]
        return (
            np.inf if time is None else time,
            self.summary["error_at_end"],
            self.summary[CLPE],
        )


def learned(scenario: Scenario, level: float | None) -> LearningRun:
    """Run a scenario with its own law and summarise the learning."""
    duration = scenario.run.duration
    step = min(scenario.reference.dwell / SAMPLES_PER_DWELL, step_of_means(scenario))
    step = min(scenario.run.output_step, max(step, duration / MAX_SAMPLES))
    run = simulate(scenario, sample_times(duration, step))
    theta = np.array(scenario.flow.parameters)
    error = np.abs(run.flow_parameters_estimate.values - theta).max(axis=(1, 2))
    level = TENTH * float(error[0]) if level is None else float(level)
    summary = {
        CLPE: clpe_of_samples(scenario, run)[CLPE],
        "level": level,
        "learning_time": time_below(run.time.values, error, level),
        "error_at_end": float(error[-1]),
    }
    return LearningRun(scenario, run, error, summary)


def time_below(times: np.ndarray, values: np.ndarray, level: float) -> float | None:
    """Return the time from which all values are at most a level, or None."""
    start = 1 + np.max(np.flatnonzero(~(values <= level)), initial=-1)
    return float(times[start]) if start < len(values) else None


@dataclass(frozen=True)
class Design:
    """Result of `design_track`."""

    scenario: Scenario  # with the new waypoints
    report: dict[str, Any]  # ready for JSON
    tracks: tuple[LearningRun, LearningRun]  # runs with the law, before and after

    def __repr__(self) -> str:
        before, after = _kappas(self.report)
        count = len(self.scenario.waypoints)
        return f"<Design of {count} waypoints: {before:.3g} to {after:.3g}>"

    def plot(self, *, ax: Any = None) -> np.ndarray:
        """Draw both tracks over the window, and the largest parameter error on both, (3,) Axes."""
        axes = axes_for(ax, 11.8, 4.9, ncols=3)
        for key, learning, axis in zip(
            ("before", "after"), self.tracks, axes[:2], strict=True
        ):
            _draw_track(axis, learning, self.report, key)
        axes[0].sharex(axes[1])
        axes[0].sharey(axes[1])
        legend_below(axes[1], 3)
        _draw_errors(axes[2], self)
        return axes


def _kappas(report: dict[str, Any]) -> list[float]:
    """Return kappa_1 before and after."""
    return [report[key]["smallest_eigenvalue"] for key in ("before", "after")]


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
    _check(scenario, goal)
    report = progress or (lambda share: None)
    # Step 1: window and limits
    span = checked_window(scenario, window, start)
    kappa, extremes = _measure(scenario, span)
    low, high = corners(scenario, area, extremes)
    longest = float(length or closed_length(scenario.waypoints))
    limits = Limits(longest, max_speed, low, high)
    # Step 2: search
    gains = linear_gains(scenario) if goal == "law" else None
    tracks, tracks_tried = best_waypoints(scenario, limits, span, seed, report, gains)
    best = max(_measure(with_waypoints(scenario, track), span)[0] for track in tracks)
    if best < ROUNDING * span[0]:
        raise ScenarioError(
            "flow.parameters: no track within the limits shows all of them: the smallest "
            f"eigenvalue is at most {best:.1g}, rounding. Widen area or length, or leave out "
            "functions that are out of reach"
        )
    if goal == "kappa":
        tracks = tracks[:1]
    # Step 3: runs with the law
    before = learned(scenario, level)
    runs = [learned(with_waypoints(scenario, track), level) for track in tracks]
    after = min(runs, key=lambda run: run.cost)
    designed = after.scenario
    report(1.0)
    # Step 4: report
    summary = {
        "title": scenario.title,
        "units": scenario.units.model_dump(),
        "law": scenario.learning.law,
        "goal": goal,
        "own_track_kept": np.array_equal(designed.waypoints, scenario.waypoints),
        "window": span[0],
        "start": span[1],
        "trajectory": TRAJECTORY,
        "limits": {
            "length": longest,
            "max_speed": max_speed,
            "area": np.transpose([low, high]).ravel().tolist(),
        },
        "seed": seed,
        "tracks_tried": tracks_tried,
        "before": _track_report(before, kappa, extremes, span),
        "after": _track_report(after, *_measure(designed, span), span),
    }
    old, new = _kappas(summary)
    summary["ratio"] = new / old if old > 0 else None
    return Design(designed, summary, (before, after))


def _check(scenario: Scenario, goal: str) -> None:
    """Raise an error for a goal or scenario without a design."""
    if goal not in GOALS:
        raise ScenarioError(f"goal {goal!r}: must be one of {', '.join(GOALS)}")
    count = len(scenario.waypoints)
    if count > MAX_WAYPOINTS:
        raise ScenarioError(
            f"reference: has {count} waypoints; at most {MAX_WAYPOINTS} are designed"
        )
    if scenario.flow.parameters is None:
        raise ScenarioError(
            "flow.field: a track is designed for parameters theta. Give flow.parameters in its "
            "place, which `clpt fit` finds"
        )


def linear_gains(scenario: Scenario) -> np.ndarray | None:
    """Return the N + 2 gains of one of the paper's laws, Eq. (28), or None."""
    learning = scenario.learning
    gains = gains_of_w(scenario)
    linear = learning.law in ("learned-flow", "known-flow") and learning.sample is None
    return gains if linear and gains.any() else None


def _measure(scenario: Scenario, span: tuple[float, float]) -> tuple[float, Extremes]:
    """Return kappa_1 of a finely sampled track and its extremes over the run."""
    tracks = Tracks(scenario, span, scenario.run.duration, *FINE)
    kappa, extremes = tracks(scenario.waypoints[None])
    return float(kappa.min()), extremes


def _track_report(
    learning: LearningRun, kappa: float, extremes: Extremes, span: tuple[float, float]
) -> dict[str, Any]:
    """Return the entries of one track."""
    scenario = learning.scenario
    ceiling = None
    if scenario.vehicle.max_speed is None:
        exact = gramian(vehicle_alone(scenario).started_true(), *span)
        ceiling = min(exact.ceilings.values(), default=None)
    corner = extremes.low[0].min(axis=0), extremes.high[0].max(axis=0)
    return {
        "smallest_eigenvalue": kappa,
        "of_the_run": gramian(scenario, *span).smallest,
        "ceiling": ceiling,
        "closed_length": float(closed_length(scenario.waypoints)),
        "largest_speed": float(extremes.speed.max()),
        "positions": np.transpose(corner).tolist(),
        "waypoints": scenario.waypoints.tolist(),
        **learning.summary,
    }


LOWEST = 1e-16  # smaller errors are drawn there


def _draw_track(
    ax: "Axes", learning: LearningRun, report: dict[str, Any], key: str
) -> None:
    """Draw the area, the waypoints and the vehicle's path in the window."""
    from matplotlib.patches import Rectangle

    unit = report["units"]["length"]
    left, right, bottom, top = report["limits"]["area"]
    area = Rectangle((left, bottom), right - left, top - bottom, label="area")
    area.set(fill=False, edgecolor=GREY, linestyle=":")
    ax.add_patch(area)
    waypoints = learning.scenario.waypoints
    polygon = np.vstack([waypoints, waypoints[:1]])
    ax.plot(*polygon.T, "--", color=ORANGE, linewidth=1.0, label="closed polygon")
    since = learning.run.time.values - report["start"]
    path = learning.run.position.values
    inside = (since >= 0) & (since <= report["window"])
    label = "vehicle, in the window"
    ax.plot(*path[inside].T, color=BLUE, linewidth=1.0, label=label)
    order = np.arange(len(waypoints))
    label = "waypoints, the first dark"
    x1, x2 = waypoints.T
    ax.scatter(x1, x2, c=order, cmap="viridis", zorder=3, label=label)
    ax.plot(*path[0], "s", color="black", markersize=5, label="start")
    name = "old" if key == "before" else "new"
    kappa, length = (report[key][k] for k in ("smallest_eigenvalue", "closed_length"))
    title = rf"{name}: $\kappa_1$ = {kappa:.3g}, length {length:.4g} {unit}"
    ax.set_title(title, **TITLE)
    ax.set(xlabel=f"$x_1$ ({unit})", ylabel=f"$x_2$ ({unit})")
    ax.set_aspect("equal")
    ax.margins(0.06)


def _draw_errors(ax: "Axes", design: Design) -> None:
    """Draw the largest flow-parameter error on both tracks."""
    time, length = (design.report["units"][key] for key in ("time", "length"))
    old, new = design.tracks
    for learning, style, color, label in (
        (old, "--", ORANGE, "old track"),
        (new, "-", BLUE, "new track"),
    ):
        error = np.maximum(learning.error, LOWEST)
        ax.semilogy(
            learning.run.time, error, style, color=color, linewidth=1.6, label=label
        )
    level = new.summary["level"]
    label = f"level {level:.3g} {length}/{time}"
    ax.axhline(level, color=GREY, linewidth=1.0, linestyle=":", label=label)
    ax.set_xlabel(f"time ({time})")
    ax.set_ylabel(f"largest flow-parameter error ({length}/{time})")
    ax.set_title(f"learning of {design.report['law']}", **TITLE)
    legend_below(ax, 2)
