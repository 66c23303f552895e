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

from ..base.arguments import numbers, public
from ..base.errors import DataError
from ..base.units import percent
from ..engine.model.block import evaluate
from ..ocean.currents.plane import read_field
from ..ocean.estimation.least_squares import explained_share
from ..paper.blocks import vehicle
from ..paper.blocks.field import gridded_flow
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.recorded_run import unknown_parts
from ..paper.scenario.tables import Units
from .loop_blocks import paper_blocks

if TYPE_CHECKING:
    import xarray

LEAST_SAMPLES = 10  # of a measured track, to compare its motion with Eq. (7)
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
        calm = scenario.with_values({"flow.disturbance": None})
        block = next(b for b in paper_blocks(calm) if b.name == "true_flow")
        return evaluate(block, timepts, points)
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
) -> dict[str, Any]:
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
    if scenario.field_path is None:
        raise DataError(
            "the scenario's true flow is not a gridded field; shares of variance are for scenarios "
            "with flow.field, such as `clpt fit` writes"
        )
    phi = scenario.basis_block()
    if run.sizes.get("basis") != phi.noutputs:
        raise DataError(
            f"the run has {run.sizes.get('basis')} basis functions, the scenario {phi.noutputs}. "
            "Give the scenario that was run"
        )
    field = read_field(scenario.field_path, scenario.units)
    truth = gridded_flow(field, "clip")
    theta = run.flow_parameters_estimate.values
    t = run.time.values
    if window is None:
        window = float(t[-1] - 0.25 * (t[-1] - t[0])), float(t[-1])
    begin, end = window
    inside = (t >= begin) & (t <= end)
    if not inside.any():
        raise DataError(
            f"the window {begin:g} to {end:g} has no sample of the run, which covers "
            f"{t[0]:g} to {t[-1]:g} {scenario.units.time}"
        )
    # along the track, with the estimate of each time: theta_hat(t) phi(x(t), t)
    times = t[inside]
    points = run.position.values[inside]
    functions = evaluate(phi, times, points)
    learned = np.einsum("taN,tN->ta", theta[inside], functions)
    track = explained_share(evaluate(truth, times, points), learned)

    # at all points and times of the grid, with the last estimate
    grid = np.meshgrid(field.time, field.x2, field.x1, indexing="ij")
    times, x2, x1 = (axis.ravel() for axis in grid)
    functions = evaluate(phi, times, np.column_stack([x1, x2]))
    current = np.column_stack([field.u.ravel(), field.v.ravel()])
    box = explained_share(current, functions @ theta[-1].T)
    return {
        "track": None if np.isnan(track) else track,
        "box": None if np.isnan(box) else box,
        "window": [float(begin), float(end)],
    }


def speed_figures(
    max_speed: float, times: np.ndarray, commanded: np.ndarray, flow: np.ndarray
) -> dict[str, Any]:
    """Return shares of the time at the speed limit, |v_c| > v_max, and in faster flow.

    A vehicle in a faster flow, |F_R| > v_max, cannot hold its position.  Each sample counts until
    the next; velocities have the shape (n, 2).
    """
    at_limit = np.hypot(*commanded.T) > max_speed
    in_faster_flow = np.hypot(*flow.T) > max_speed
    durations = np.diff(times, append=times[-1])
    total = float(times[-1] - times[0])

    def share(samples: np.ndarray) -> float:
        return float(durations @ samples) / total if total else float(samples[-1])

    faster_flow = None
    if in_faster_flow.any():
        changes = np.diff(np.pad(in_faster_flow, 1)).nonzero()[0]
        edges = np.append(times, times[-1])[changes]  # begin, end, begin, ...
        faster_flow = {
            "first": float(edges[0]),
            "longest": float(np.diff(edges)[::2].max()),
            "share": share(in_faster_flow),
        }
    return {
        "max_speed": max_speed,
        "share_at_limit": share(at_limit),
        "faster_flow": faster_flow,
    }


def faster_flow(figures: dict[str, Any], units: Units) -> str:
    """Return a sentence on flow that was faster than the vehicle, or ""."""
    faster = figures["faster_flow"]
    time = units.time
    if faster is None:
        return ""
    return (
        f"the flow was faster than the vehicle ({figures['max_speed']:g} {units.length}/{time}), "
        f"which cannot hold its place there: first at t = {faster['first']:g} {time}, "
        f"{percent(faster['share'])} of the time, at most {faster['longest']:.3g} {time} long"
    )


def speeds_of(run: "xarray.Dataset", max_speed: float) -> dict[str, Any]:
    """Return the `speed_figures` of a run at its own samples."""
    commanded = run.commanded_velocity.values
    return speed_figures(max_speed, run.time.values, commanded, run.true_flow.values)


def note_speeds(run: "xarray.Dataset", figures: dict[str, Any], units: Units) -> None:
    """Add the share at the speed limit, and a sentence on faster flow, to a run's attributes."""
    run.attrs["share_at_speed_limit"] = figures["share_at_limit"]
    if sentence := faster_flow(figures, units):
        run.attrs["message"] = f"{run.attrs['message']}; {sentence}"


def unlike_controller(run: "xarray.Dataset", scenario: Scenario) -> str:
    """Return a sentence if measured positions do not move as Eq. (7) commands, or "".

    x' = f v + theta phi(x), Eqs. (1) and (3), with v of Eq. (7) at the scenario's gains, is solved
    by least squares: a vehicle that is steered by Eq. (7) has f = 1.
    """
    times, x = run.time.values, run.position.values
    if len(times) < LEAST_SAMPLES:
        return ""
    car = scenario.vehicle
    controller = vehicle.vehicle_controller(
        scenario.model_parameters, car.feedback, car.feedforward
    )
    phi = evaluate(scenario.basis_block(), times, x)
    commanded = evaluate(controller, times, np.hstack([x, run.reference.values, phi]))
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
