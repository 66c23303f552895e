"""Figure of an excitation: a column for each axis.

Above are the eigenvalues of the Gramian of Definition 3.1 in a window that slides over the run,
below the least excited direction of one window and the excited share of each parameter.
"""

from typing import TYPE_CHECKING, Any

import numpy as np

from ...base.figures import BLUE, GREY, RED, TITLE, axes_for

if TYPE_CHECKING:
    from matplotlib.axes import Axes

LOWEST = 1e-30  # share of the largest eigenvalue; smaller ones are drawn there


def draw_excitation(
    excitation: Any, starts: np.ndarray, values: dict[str, np.ndarray], ax: Any
) -> np.ndarray:
    """Draw a `gramian.Excitation` and the eigenvalues (starts, n) of each axis; (2, axes) Axes."""
    columns = len(excitation.names)
    axes = axes_for(ax, 7.6, 6.0, nrows=2, ncols=columns, sharey="row", squeeze=False)
    for (top, bottom), axis in zip(axes.T, excitation.names, strict=True):
        _draw_eigenvalues(top, starts, values[axis], excitation, axis)
        _draw_direction(bottom, excitation, axis)
        bottom.set(ylim=(-1.6, 1.15), yticks=[-1, -0.5, 0, 0.5, 1], axisbelow=True)
    axes[0, 0].set_ylabel(r"eigenvalue of $\int w w^T dt$")
    axes[1, 0].set_ylabel("component")
    legend: dict[str, Any] = {"fontsize": 8, "frameon": False, "loc": "lower left"}
    axes[0, 0].legend(ncols=3, bbox_to_anchor=(0, 1.1), **legend)
    axes[1, -1].legend(**legend)
    return axes


def _draw_eigenvalues(
    ax: "Axes", starts: np.ndarray, values: np.ndarray, excitation: Any, axis: str
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


def _draw_direction(ax: "Axes", excitation: Any, axis: str) -> None:
    """Draw the least excited direction and the excited shares of one axis."""
    components = excitation.least_excited[axis]
    names = [*components]
    label = "least excited direction"
    ax.bar(names, [*components.values()], width=0.55, color=BLUE, label=label)
    shares = np.linalg.norm(excitation.excited[axis], axis=1)
    ax.plot(names, shares, "D", color=RED, markersize=5, label="excited share")
    ax.axhline(0, color="black", linewidth=0.7)
    ax.tick_params(axis="x", labelsize=8, rotation=90)
    start, end = excitation.start, excitation.start + excitation.window
    kappa = excitation.eigenvalues[axis][0]
    span = f"{start:.4g} to {end:.4g} {excitation.time_unit}"
    ax.set_title(rf"{axis}: $\kappa_1$ = {kappa:.3g}, {span}", **TITLE)
