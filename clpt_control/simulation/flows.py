"""True and learned flow, the variance that the learned flow explains, and speed limits.

    true flow      theta phi(x, t), Eq. (3), or the gridded field
    learned flow   theta_hat phi(x, t)
    share          1 - sum |F - theta_hat phi|^2 / sum |F - mean F|^2   of a gridded current F

The share is 1 if all is learned, 0 if the mean alone, and negative if the learned flow is worse.
The disturbance Delta is not part of any of these.
"""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike
from scipy.integrate import cumulative_trapezoid

from ..base.arguments import numbers, public
from ..base.errors import DataError
from ..base.units import finite_or_none, percent
from ..engine.model.block import evaluate
from ..paper.blocks.field import gridded_flow
from ..paper.blocks.flow import phi_and_slopes, turning_rate
from ..paper.currents.least_squares import explained_share
from ..paper.currents.plane import read_field
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.recorded_run import commanded_velocity, unknown_parts
from ..paper.scenario.tables import Units
from .loop_blocks import true_flow_block
from .mean_squares import last_quarter

if TYPE_CHECKING:
    import xarray

Figures = dict[str, Any]  # of a run, by name
TOLD_TURN = 1.0  # rad between fixes
BOX_POINTS = 9261  # of a track's box and the window, each at a time of its own
# g^-k with g^4 = g + 1: irrational steps, which fill a box evenly
SPREAD = 1.2207440846057596 ** -np.arange(1.0, 4.0)
LEAST_SAMPLES = 10  # of a measured track, to compare its motion with Eq. (7)
SPEEDS = "commanded_velocity", "true_flow", "reference"  # speed_figures reads these
LEAST_FACTOR = 0.7  # and its inverse; samples and noise leave it between them


@public
def flow_velocity(
    scenario: Scenario,
    points: ArrayLike,
    timepts: ArrayLike,
    parameters: np.ndarray | None = None,
) -> np.ndarray:
    """Return the flow at places and times, true or learned.

    The disturbance Delta is not part of it.

    Parameters
    ----------
    scenario : Scenario
        The experiment.
    points : array_like, shape (n, 2)
        Places, units.length.
    timepts : array_like, shape (n,) or a number
        Times, units.time.
    parameters : array_like, shape (2, N) or (n, 2, N), optional
        Flow parameters theta_hat to use in place of the truth.

    Returns
    -------
    ndarray, shape (n, 2)
        Velocity along x1 and x2, units.length per units.time.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> flow_velocity(clpt.paper_scenario(), [[0.0, 0.0]], 0.0).round(3)
    array([[1.492, 1.392]])
    """
    points = np.atleast_2d(numbers("points", points, 2))
    if parameters is None and scenario.flow.parameters is None:
        return evaluate(true_flow_block(scenario), timepts, points)
    values = scenario.flow.parameters if parameters is None else parameters
    theta = numbers("parameters", values, 2, scenario.basis.N)
    phi = evaluate(scenario.basis_block(), timepts, points)
    return np.einsum("...ik,...k->...i", theta, phi)


def flow_to_draw(
    run: "xarray.Dataset",
    scenario: Scenario,
    points: np.ndarray,
    timepts: ArrayLike,
    *learned: Any,
) -> np.ndarray:
    """Return a run's flow at points and times, or 0 if its scenario does not determine it."""
    blocks = {"basis_x"} if learned else {"basis_x", "true_flow"}
    if blocks & unknown_parts(run):
        return np.zeros(points.shape)
    return flow_velocity(scenario, points, timepts, *learned)


@public
def explained_variance(
    scenario: Scenario, run: "xarray.Dataset", window: tuple[float, float] | None = None
) -> Figures:
    """Return the shares of variance that the learned flow explains.

    Parameters
    ----------
    scenario : Scenario
        Its true flow must be a gridded field.
    run : xarray.Dataset
        As `simulate` gives it for this scenario.
    window : tuple of float, optional
        First and last time of the samples along the track, units.time; the
        last quarter of the run by default.

    Returns
    -------
    dict
        ``track`` and ``box``, shares of the variance about the mean, without
        unit (at most 1; negative where the learned flow is worse than the
        current's mean; None where the current hardly changes), and
        ``window``, units.time.

    Raises
    ------
    DataError
        If the scenario has no field, the run has another basis, or the window
        holds no sample.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.load_scenario("fit.toml")  # doctest: +SKIP
    >>> explained_variance(scenario, clpt.simulate(scenario))["track"]  # doctest: +SKIP
    0.81
    """
    if scenario.flow.parameters is not None:
        raise DataError(
            "the scenario's true flow is that of its functions; shares of variance are for "
            "scenarios with flow.field, such as `clpt fit` writes, or flow.basis"
        )
    phi = scenario.basis_block()
    if run.sizes.get("basis") != phi.noutputs:
        raise DataError(
            f"the run has {run.sizes.get('basis')} basis functions, the scenario {phi.noutputs}. "
            "Give the scenario that was run"
        )
    times = run.time.values
    window = window or (last_quarter(times), float(times[-1]))
    flows = flows_learned(scenario, run, window)
    shares = {name: explained_share(*pair) for name, pair in flows.items()}
    return {**finite_or_none(shares), "window": [float(time) for time in window]}


def flow_error(scenario: Scenario, run: "xarray.Dataset") -> dict[str, float]:
    """Return the rms error of the learned flow along the track and over the box, length/time.

    Where functions overlap, parameters may be far off while the flow is right.
    """
    times = run.time.values
    flows = flows_learned(scenario, run, (last_quarter(times), times[-1]))
    return {
        name: float(np.sqrt(((true - learned) ** 2).sum(axis=1).mean()))
        for name, (true, learned) in flows.items()
    }


def flows_learned(
    scenario: Scenario, run: "xarray.Dataset", window: tuple[float, float]
) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Return true and learned flow, (n, 2) each, along the track and over the box.

    Along the track with the estimate of each time, theta_hat(t) phi(x(t), t), over the box with the
    last one.  The box is that of the grid, or of the track; then at points that fill box and window
    evenly, whose times are no multiples of a tide's period.
    """
    phi = scenario.basis_block()
    theta = run.flow_parameters_estimate.values
    begin, end = window
    t = run.time.values
    inside = (t >= begin) & (t <= end)
    if not inside.any():
        raise DataError(
            f"the window {begin:g} to {end:g} has no sample of the run, which covers "
            f"{t[0]:g} to {t[-1]:g} {scenario.units.time}"
        )
    times = t[inside]
    points = run.position.values[inside]
    learned = np.einsum("taN,tN->ta", theta[inside], evaluate(phi, times, points))
    flows = {"track": (true_flow(scenario, points, times), learned)}
    if scenario.field_path is None:
        low = points.min(axis=0)
        high = points.max(axis=0)
        share = (0.5 + np.arange(BOX_POINTS)[:, None] * SPREAD) % 1.0
        points = low + (high - low) * share[:, :2]
        times = begin + (end - begin) * share[:, 2]
    else:
        field = read_field(scenario.field_path, scenario.units)
        axes = np.meshgrid(field.time, field.x2, field.x1, indexing="ij")
        times, x2, x1 = (axis.ravel() for axis in axes)
        points = np.column_stack([x1, x2])
    learned = evaluate(phi, times, points) @ theta[-1].T
    return flows | {"box": (true_flow(scenario, points, times), learned)}


def true_flow(scenario: Scenario, points: np.ndarray, times: np.ndarray) -> np.ndarray:
    """Return F of Eq. (3), or of the grid, clipped to it."""
    if scenario.field_path is None:
        return flow_velocity(scenario, points, times)
    field = read_field(scenario.field_path, scenario.units)
    return evaluate(gridded_flow(field, "clip"), times, points)


def speed_figures(
    max_speed: float,
    times: np.ndarray,
    commanded: np.ndarray,
    flow: np.ndarray,
    reference: np.ndarray,
) -> Figures:
    """Return shares of the time at the speed limit, |v_c| > v_max, and in faster flow.

    A vehicle in a faster flow, |F_R| > v_max, cannot hold its position.  Speeds are straight lines
    between samples, but a command holds until the reference jumps.  Shapes are (n, 2).
    """
    jumps = np.abs(np.diff(reference, axis=0)).sum(axis=1) > 0.0
    at_limit = _times_above(times, np.hypot(*commanded.T) - max_speed, jumps)
    in_faster_flow = _times_above(times, np.hypot(*flow.T) - max_speed)
    total = max(float(times[-1] - times[0]), np.finfo(float).tiny)
    faster_flow = None
    if in_faster_flow.size:
        durations = np.diff(in_faster_flow)
        faster_flow = {
            "first": float(in_faster_flow[0, 0]),
            "longest": float(durations.max()),
            "share": float(durations.sum() / total),
        }
    return {
        "max_speed": max_speed,
        "share_at_limit": float(np.diff(at_limit).sum() / total),
        "faster_flow": faster_flow,
    }


def _times_above(
    times: np.ndarray, excess: np.ndarray, jumps: np.ndarray | None = None
) -> np.ndarray:
    """Return begins and ends, shape (n, 2), of the times at which straight lines exceed 0.

    An interval with a jump has its first value up to its end.
    """
    above = excess > 0.0
    k = np.flatnonzero(above[1:] != above[:-1])
    crossings = times[k] + np.diff(times)[k] * excess[k] / (excess[k] - excess[k + 1])
    edges = crossings if jumps is None else np.where(jumps[k], times[k + 1], crossings)
    edges = np.concatenate([times[:1][above[:1]], edges, times[-1:][above[-1:]]])
    return edges.reshape(-1, 2)


def faster_flow(figures: Figures, units: Units) -> str:
    """Return a sentence on flow that was faster than the vehicle, or ""."""
    faster = figures["faster_flow"]
    time = units.time
    if faster is None:
        return ""
    return (
        f"the flow was faster than the vehicle ({figures['max_speed']:g} {units.length}/{time}), "
        f"which cannot hold its place there: first at t = {faster['first']:g} {time}, "
        f"{percent(faster['share'])} of the time by the samples, {faster['longest']:.3g} {time} "
        "the longest"
    )


def speeds_of(run: "xarray.Dataset", max_speed: float) -> Figures:
    """Return the `speed_figures` of a run at its own samples."""
    return speed_figures(
        max_speed, run.time.values, *(run[name].values for name in SPEEDS)
    )


def note_speeds(run: "xarray.Dataset", figures: Figures, units: Units) -> None:
    """Add the share at the speed limit, and a sentence on faster flow, to a run's attributes."""
    run.attrs["share_at_speed_limit"] = figures["share_at_limit"]
    if sentence := faster_flow(figures, units):
        run.attrs["message"] = f"{run.attrs['message']}; {sentence}"


def long_interval(run: "xarray.Dataset", scenario: Scenario) -> str:
    """Return a sentence if the learned flow turns far between fixes of a law at fixes, or ""."""
    fixes = None if scenario.localization is None else scenario.localization.fixes
    read = {"predicted_position", "flow_parameters_estimate"}
    if fixes is None or not read <= set(run):
        return ""
    times = run.time.values
    z = run.predicted_position.values
    step = 1e-3 * scenario.basis.lengths.min()
    _, slopes = phi_and_slopes(scenario.basis_block(), times, z, step)
    rates = turning_rate(slopes, run.flow_parameters_estimate.values)
    turned = cumulative_trapezoid(rates, times, initial=0.0)
    before = np.interp(times - fixes.interval, times, turned)
    turn = float(np.max(turned - before))
    if turn <= TOLD_TURN:
        return ""
    return (
        f"the interval is long for this flow: it turns by {turn:.1f} radians between fixes, so "
        "phi(z) is not phi(x) and the law may not learn it. Set localization.interval smaller"
    )


def unlike_controller(run: "xarray.Dataset", scenario: Scenario) -> str:
    """Return a sentence if measured positions do not move as Eq. (7) commands, or "".

    x' = f v + theta phi(x), Eqs. (1) and (3), with v of Eq. (7) at the scenario's gains, is solved
    by least squares: a vehicle that is steered by Eq. (7) has f = 1.
    """
    times = run.time.values
    x = run.position.values
    if len(times) < LEAST_SAMPLES:
        return ""
    phi = evaluate(scenario.basis_block(), times, x)
    commanded = commanded_velocity(scenario, times, x, run.reference.values)
    moved = np.diff(x, axis=0) / np.diff(times)[:, None]
    v, phi = ((a[1:] + a[:-1]) / 2 for a in (commanded, phi))
    zero = np.zeros_like(phi)
    columns = np.vstack(
        [np.hstack([v[:, :1], phi, zero]), np.hstack([v[:, 1:], zero, phi])]
    )
    factor = float(np.linalg.lstsq(columns, moved.T.ravel())[0][0])
    if LEAST_FACTOR <= factor <= 1 / LEAST_FACTOR:
        return ""
    return (
        f"the positions move {factor:.2g} times as fast as Eq. (7) commands with vehicle.feedback "
        "and vehicle.feedforward, so K and Gamma take up a part of the flow: clpt estimate learns "
        "from the fixes of such a vehicle"
    )
