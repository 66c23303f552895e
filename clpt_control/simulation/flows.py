"""The flow at any place and time, how much of it is learned, and whether it is too fast.

    true flow      theta phi(x, t), Eq. (3), or the gridded field
    learned flow   theta_hat phi(x, t)

How much of a gridded current F the learned flow explains is

    share = 1 - sum |F - theta_hat phi|^2 / sum |F - mean F|^2

over the samples of a set, both components together, each about its mean: 0 for
a learner that knows the mean alone, 1 for one that knows it all, less than 0
for one that knows no flow; as of `clpt fit` and `clpt tides`.  A current that
hardly changes, by less than 1 %, has no share.  Two sets, because a small CLPE does not
mean a right flow (K and Gamma adapt too, and can stand in for it):

    track   F at x(t), with theta_hat(t) of that time, over a window of the run
            (its last quarter by default): what the learner follows
    box     F at all places and times of the field's grid, with theta_hat of
            the end of the run: what the learner has understood

The disturbance Delta is part of none of them.
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
from ..paper.blocks.field import gridded_flow
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.recorded_run import unknown_parts
from ..paper.scenario.tables import Units
from .loop_blocks import paper_blocks

if TYPE_CHECKING:
    import xarray


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
    either = scenario.flow.parameters if parameters is None else parameters
    theta = numbers("parameters", either, 2, scenario.basis.N)
    phi = evaluate(scenario.basis_block(), timepts, points)
    return np.einsum("...ik,...k->...i", theta, phi)


def flow_to_draw(
    run: "xarray.Dataset",
    scenario: Scenario,
    points: np.ndarray,
    timepts: ArrayLike,
    *learned: Any,
) -> np.ndarray:
    """Return a run's flow at places and times, or 0 where its scenario does not hold it."""
    makers = {"basis_x"} if learned else {"basis_x", "true_flow"}
    if makers & unknown_parts(run):
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
            "the scenario's true flow is no gridded field; shares of variance are for scenarios "
            "with flow.field, such as `clpt fit` writes"
        )
    phi = scenario.basis_block()
    if run.sizes.get("basis") != phi.noutputs:
        raise DataError(
            f"the run has {run.sizes.get('basis')} basis functions, the scenario {phi.noutputs}; "
            "give the scenario that was run"
        )
    field = read_field(scenario.field_path, scenario.units)
    truth = gridded_flow(field, "clip")
    t = run.time.values
    first, last = window or (float(t[-1] - 0.25 * (t[-1] - t[0])), float(t[-1]))
    inside = (t >= first) & (t <= last)
    if not inside.any():
        raise DataError(
            f"the window {first:g} to {last:g} holds no sample of the run, which covers "
            f"{t[0]:g} to {t[-1]:g} {scenario.units.time}"
        )
    times, places = t[inside], run.position.values[inside]
    estimate = run.flow_parameters_estimate.values
    learned = np.einsum("taN,tN->ta", estimate[inside], evaluate(phi, times, places))
    track = evaluate(truth, times, places), learned

    grid = np.meshgrid(field.time, field.x2, field.x1, indexing="ij")
    at, x2, x1 = (axis.ravel() for axis in grid)
    model = evaluate(phi, at, np.column_stack([x1, x2])) @ estimate[-1].T
    box = np.column_stack([field.u.ravel(), field.v.ravel()]), model
    shares = {"track": explained_share(*track), "box": explained_share(*box)}
    of = {place: None if np.isnan(share) else share for place, share in shares.items()}
    return {**of, "window": [float(first), float(last)]}


# --- how fast: |v_c| > v_max is at the limit; |F_R| > v_max faster than the vehicle, which cannot
# hold its place there.  Each sample counts until the next one. -----------------------------------


def speed_figures(
    max_speed: float, times: np.ndarray, commanded: np.ndarray, flow: np.ndarray
) -> dict[str, Any]:
    """Return shares of the time, ready for JSON, of samples (n,), velocity and flow (n, 2)."""
    at_limit, faster = (np.hypot(*one.T) > max_speed for one in (commanded, flow))
    spans, whole = np.diff(times, append=times[-1]), float(times[-1] - times[0])

    def share(of: np.ndarray) -> float:
        return float(spans @ of) / whole if whole else float(of[-1])

    edges = np.append(times, times[-1])[np.diff(np.pad(faster, 1)).nonzero()[0]]
    flow_faster = None
    if len(edges):
        longest = float(np.diff(edges)[::2].max())
        flow_faster = {
            "first": float(edges[0]),
            "longest": longest,
            "share": share(faster),
        }
    figures = {"max_speed": max_speed, "share_at_limit": share(at_limit)}
    return {**figures, "faster_flow": flow_faster}


def faster_flow(figures: dict[str, Any], units: Units) -> str:
    """Return a sentence where the flow was faster than the vehicle, or nothing."""
    faster, time = figures["faster_flow"], units.time
    if faster is None:
        return ""
    return (
        f"the flow was faster than the vehicle ({figures['max_speed']:g} {units.length}/{time}), "
        f"which cannot hold its place there: first at t = {faster['first']:g} {time}, "
        f"{percent(faster['share'])} of the time, at most {faster['longest']:.3g} {time} long"
    )


def speeds_of(run: "xarray.Dataset", max_speed: float) -> dict[str, Any]:
    """Return the figures of a run at its own samples."""
    velocities = run.commanded_velocity.values, run.true_flow.values
    return speed_figures(max_speed, run.time.values, *velocities)


def note_speeds(run: "xarray.Dataset", figures: dict[str, Any], units: Units) -> None:
    """Put the share at the limit and, where there is one, the sentence into a run's attributes."""
    run.attrs["share_at_speed_limit"] = figures["share_at_limit"]
    if sentence := faster_flow(figures, units):
        run.attrs["message"] = f"{run.attrs['message']}; {sentence}"
