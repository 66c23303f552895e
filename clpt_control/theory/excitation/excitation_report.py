"""Report and figure of the excitation of a track, for `clpt excitation`.

The report has Definition 3.1 over one window, the exact contraction of V of Eq. (24) and its
guaranteed drop, for one trajectory.  The figure has the eigenvalues of the Gramian in a sliding
window, and below the least excited direction and the identifiable share of each parameter.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from ...base.arguments import public
from ...base.errors import ScenarioError
from ...base.figures import BLUE, GREY, RED, TITLE, axes_for
from ...paper.scenario.experiment import Scenario
from ...paper.scenario.team import Team
from .certificates import certificate, time_to_tenth
from .gramian import NOT_LEARNABLE, Excitation, gramian, sliding_excitation
from .regressor import AnySource, Source, joint_regressor, system_of

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

MAX_CHANGE = 0.1  # of an eigenvalue, up to which it estimates the error
LOWEST = 1e-30  # share of the largest eigenvalue; smaller ones are drawn there
CERTIFIED = ("rho", "contraction", "drop", "disturbed")


def excitation_report(
    source: AnySource, window: float | None = None, start: float | None = None
) -> dict[str, Any]:
    """Return the excitation of a scenario's run, a team's or a recorded one over one window.

    Its entries are ``window``, ``start``, ``time_unit``, ``trajectory``, ``not_learnable``
    (sentences), and by axis ``eigenvalues`` (ascending), ``ceilings`` (of the smallest
    eigenvalue), ``least_excited`` and ``dimension`` (of the identifiable subspace).

    ``rho`` (guaranteed drop of V), ``contraction`` (exact V(t+T)/V(t) at worst), ``drop``
    (1 - contraction, with all its digits) and ``time_to_tenth`` (time in which sqrt(V) falls to
    a tenth in windows like this one, or None) exclude the effect of a disturbance if
    ``disturbed``.  All are None if the window cannot be certified; ``not_certified`` is the reason.

    A recorded run has an ``accuracy``: the largest relative change of an eigenvalue if every
    second sample is left out, which is above the error; None if that is more than `MAX_CHANGE`.
    A team has ``measured`` (description of the parameters), ``smallest`` (eigenvalues by name),
    and ``vehicles`` by name and ``team`` with ``eigenvalues``, ``dimension``, ``not_learnable``.
    """
    if isinstance(source, Team) or isinstance(system_of(source), Team):
        return _team_report(gramian(source, window, start))
    regressor = joint_regressor(source, window, start)
    excitation = gramian(regressor)
    report: dict[str, Any] = excitation.report
    report |= dict.fromkeys((*CERTIFIED, "time_to_tenth"))
    try:
        certified = certificate(regressor)
        report |= {name: getattr(certified, name) for name in CERTIFIED}
        time = time_to_tenth(excitation.window, min(certified.drop, 1.0))
        report["time_to_tenth"] = time if np.isfinite(time) else None
    except ScenarioError as error:
        report["not_certified"] = str(error)
    if not isinstance(source, Scenario):
        report["accuracy"] = _accuracy(source, excitation)
    return report


def _accuracy(run: "xarray.Dataset", excitation: Excitation) -> float | None:
    """Return the relative change of the eigenvalues without every second sample."""
    last = run.sizes["time"] - 1
    thin = run.isel(time=np.unique([*range(0, last, 2), last]))
    thin.encoding.update(run.encoding)
    coarse = gramian(thin, excitation.window, excitation.start).eigenvalues
    changes = [
        np.abs(coarse[axis] - values) / np.maximum(values, NOT_LEARNABLE * values[-1])
        for axis, values in excitation.eigenvalues.items()
    ]
    change = float(np.max(changes))
    known = thin.sizes["time"] <= last and change <= MAX_CHANGE
    return change if known else None


def _team_report(excitation: Excitation) -> dict[str, Any]:
    """Return the report of a team."""
    by_name = {**excitation.vehicles, "team": excitation}
    return {
        **excitation.report,
        "measured": "the flow parameters, which all share, and each one's gains where they adapt",
        "smallest": {name: single.smallest for name, single in by_name.items()},
        "vehicles": {n: single.report for n, single in excitation.vehicles.items()},
        "team": excitation.report,
    }


@public
def excitation_plot(
    source: Source,
    window: float | None = None,
    start: float | None = None,
    *,
    ax: Any = None,
) -> np.ndarray:
    """Draw the excitation along time and the least excited direction.

    Parameters
    ----------
    source : Scenario or xarray.Dataset
        A scenario is run from its own initial values; a run is read.
    window, start : float, optional
        Of the directions below, units.time; by default the second cycle.
    ax : array of 4 Axes, optional
        Where to draw; by default a new figure of pyplot's.

    Returns
    -------
    ndarray of Axes, shape (2, 2)
        A column for each axis: eigenvalues of the Gramian of Definition 3.1 in a window that
        slides over the run, and the least excited direction of one window.

    Raises
    ------
    ScenarioError
        If the window is not positive or does not fit into the run.
    DataError
        If the dataset is no run.
    ClptError
        If `ax` are not four Axes.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 60})
    >>> axes = clpt.theory.excitation_plot(scenario, window=20.0)
    """
    excitation = gramian(source, window, start)
    starts, values = sliding_excitation(source, excitation.window)
    axes = axes_for(ax, 7.6, 6.0, nrows=2, ncols=2, sharey="row")
    for (top, bottom), axis in zip(axes.T, excitation.names, strict=True):
        _draw_eigenvalues(top, starts, values[axis], excitation, axis)
        _draw_direction(bottom, excitation, axis)
        bottom.set(ylim=(-1.6, 1.15), yticks=[-1, -0.5, 0, 0.5, 1], axisbelow=True)
    axes[0, 0].set_ylabel(r"eigenvalue of $\int w w^T dt$")
    axes[1, 0].set_ylabel("component")
    legend: dict[str, Any] = {"fontsize": 8, "frameon": False, "loc": "lower left"}
    axes[0, 0].legend(ncols=3, bbox_to_anchor=(0, 1.1), **legend)
    axes[1, 1].legend(**legend)
    return axes


def _draw_eigenvalues(
    ax: "Axes",
    starts: np.ndarray,
    values: np.ndarray,
    excitation: Excitation,
    axis: str,
) -> None:
    """Draw the eigenvalues of one axis in the sliding window."""
    values = np.maximum(values, LOWEST * values.max())
    ax.semilogy(starts, values[:, 1:-1], ".-", color=GREY, linewidth=0.7, markersize=1)
    rows = ((-1, RED, r"$\kappa_2$, largest"), (0, BLUE, r"$\kappa_1$, smallest"))
    for k, color, label in rows:
        ax.semilogy(starts, values[:, k], ".-", color=color, markersize=3, label=label)
    style: dict[str, Any] = {"color": "black", "linestyle": ":", "linewidth": 1.0}
    ax.axvline(excitation.start, label="window below", **style)
    unit = excitation.time_unit
    ax.set_xlabel(f"start of the window ({unit})")
    ax.set_title(f"{axis}: window of {excitation.window:g} {unit}", **TITLE)


def _draw_direction(ax: "Axes", excitation: Excitation, axis: str) -> None:
    """Draw the least excited direction and the identifiable shares of one axis."""
    components = excitation.least_excited[axis]
    names = [*components]
    label = "least excited direction"
    ax.bar(names, [*components.values()], width=0.55, color=BLUE, label=label)
    shares = np.linalg.norm(excitation.identifiable[axis], axis=1)
    ax.plot(names, shares, "D", color=RED, markersize=5, label="learnable share")
    ax.axhline(0, color="black", linewidth=0.7)
    ax.tick_params(axis="x", labelsize=8, rotation=90)
    start, end = excitation.start, excitation.start + excitation.window
    kappa = excitation.eigenvalues[axis][0]
    span = f"{start:.4g} to {end:.4g} {excitation.time_unit}"
    ax.set_title(rf"{axis}: $\kappa_1$ = {kappa:.3g}, {span}", **TITLE)
