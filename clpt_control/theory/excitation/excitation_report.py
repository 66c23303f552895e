"""What a track can teach, as one dictionary, `clpt excitation --json`, and as a picture.

Definition 3.1 over one window, the exact contraction of V of Eq. (24) and the guaranteed drop
of it, for one trajectory.

In the picture stand above the eigenvalues of the Gramian in the sliding window; below, the least
excited direction of one window by parameter name, and how much of each parameter lies in the
identifiable subspace.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from ...arguments import public
from ...errors import ScenarioError
from ...figures import BLUE, GREY, RED, TITLE, axes_for
from ...scenario.experiment import Scenario
from ...scenario.team import Team
from .certificates import certificate, time_to_tenth
from .gramian import NOT_LEARNABLE, Excitation, gramian, sliding_excitation
from .regressor import AnySource, Source, joint_regressor, system_of, thinned

if TYPE_CHECKING:
    from matplotlib.axes import Axes

ROUGHEST = 0.1  # change of an eigenvalue by which its error is judged
LOWEST = 1e-30  # eigenvalues below this share of the largest are drawn there


def excitation_report(
    source: AnySource, window: float | None = None, start: float | None = None
) -> dict[str, Any]:
    """Return what a scenario's run, a team's, or a recorded one can teach over one window.

    ``window``, ``start``, ``time_unit``, ``trajectory``; by axis ``eigenvalues`` (ascending),
    ``ceilings`` (of the smallest eigenvalue), ``least_excited`` and ``dimension`` (of what can be
    learned); ``not_learnable`` (sentences);
    ``rho`` (V falls by at least this share), ``contraction`` (exact V(t+T)/V(t) at worst),
    ``drop`` (1 less that, with all its digits) and ``time_to_tenth`` (of windows like this one,
    until sqrt(V) is a tenth; None: never), without what a disturbance adds where ``disturbed``; all
    are None where the window cannot be certified and ``not_certified`` says why.  For a recorded
    run ``accuracy`` is the largest relative change of an eigenvalue when every second sample is
    left out, which is above the error; None where that is more than `ROUGHEST`, or no sample can be
    left out: the error is not known.

    Of a team ``measured`` says of which parameters; ``vehicles`` by name and ``team`` have
    ``eigenvalues``, ``dimension`` and ``not_learnable``, ``smallest`` the smallest eigenvalues.
    """
    if isinstance(source, Team) or isinstance(system_of(source), Team):
        return _of_a_team(gramian(source, window, start))
    along = joint_regressor(source, window, start)
    found = gramian(along)
    report: dict[str, Any] = found.report
    report |= dict.fromkeys(
        ("rho", "contraction", "drop", "disturbed", "time_to_tenth")
    )
    try:
        certified = certificate(along)
        time = time_to_tenth(found.window, min(certified.drop, 1.0))
        names = ("rho", "contraction", "drop", "disturbed")
        report |= {name: getattr(certified, name) for name in names}
        report["time_to_tenth"] = time if np.isfinite(time) else None
    except ScenarioError as error:
        report["not_certified"] = str(error)
    if not isinstance(source, Scenario):
        thin = thinned(source)
        rough = gramian(thin, found.window, found.start)
        floor = {
            a: NOT_LEARNABLE * values[-1] for a, values in found.eigenvalues.items()
        }
        change = max(
            float(
                np.max(
                    np.abs(rough.eigenvalues[a] - values) / np.maximum(values, floor[a])
                )
            )
            for a, values in found.eigenvalues.items()
        )
        known = thin.sizes["time"] < source.sizes["time"] and change <= ROUGHEST
        report["accuracy"] = change if known else None
    return report


def _of_a_team(found: Excitation) -> dict[str, Any]:
    every = {**found.vehicles, "team": found}
    return {
        **found.report,
        "measured": "the flow parameters, which all share, and each one's gains where they adapt",
        "smallest": {name: one.smallest for name, one in every.items()},
        "vehicles": {name: one.report for name, one in found.vehicles.items()},
        "team": found.report,
    }


@public
def excitation_plot(
    source: Source,
    window: float | None = None,
    start: float | None = None,
    *,
    ax: Any = None,
) -> np.ndarray:
    """Draw what can be learned along time, and what least.

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
    at = gramian(source, window, start)
    starts, values = sliding_excitation(source, at.window)
    axes = axes_for(ax, 7.6, 6.0, nrows=2, ncols=2, sharey="row")
    for column, axis in enumerate(at.names):
        _eigenvalues(axes[0, column], starts, values[axis], at, axis)
        _direction(axes[1, column], at, axis)
    axes[0, 0].set_ylabel(r"eigenvalue of $\int w w^T dt$")
    axes[1, 0].set_ylabel("component")
    axes[0, 0].legend(
        fontsize=8, frameon=False, ncols=3, loc="lower left", bbox_to_anchor=(0, 1.1)
    )
    axes[1, 1].legend(fontsize=8, frameon=False, loc="lower left")
    for one in axes[1]:
        one.set_ylim(-1.6, 1.15)
        one.set_axisbelow(True)
        one.set_yticks([-1, -0.5, 0, 0.5, 1])
    return axes


def _eigenvalues(
    ax: "Axes", starts: np.ndarray, values: np.ndarray, at: Excitation, axis: str
) -> None:
    values = np.maximum(values, LOWEST * values.max())
    ax.semilogy(starts, values[:, 1:-1], ".-", color=GREY, linewidth=0.7, markersize=1)
    rows = ((-1, RED, r"$\kappa_2$, largest"), (0, BLUE, r"$\kappa_1$, smallest"))
    for k, color, label in rows:
        ax.semilogy(starts, values[:, k], ".-", color=color, markersize=3, label=label)
    ax.axvline(
        at.start, color="black", linestyle=":", linewidth=1.0, label="window below"
    )
    ax.set_xlabel(f"start of the window ({at.time_unit})")
    ax.set_title(f"{axis}: window of {at.window:g} {at.time_unit}", **TITLE)


def _direction(ax: "Axes", at: Excitation, axis: str) -> None:
    least = at.least_excited[axis]
    shares = np.linalg.norm(at.identifiable[axis], axis=1)
    ax.bar(
        [*least],
        [*least.values()],
        width=0.55,
        color=BLUE,
        label="least excited direction",
    )
    ax.plot([*least], shares, "D", color=RED, markersize=5, label="learnable share")
    ax.axhline(0, color="black", linewidth=0.7)
    ax.tick_params(axis="x", labelsize=8, rotation=90)
    ax.set_title(
        rf"{axis}: $\kappa_1$ = {at.eigenvalues[axis][0]:.3g}, "
        f"{at.start:.4g} to {at.start + at.window:.4g} {at.time_unit}",
        **TITLE,
    )
