"""Two figures that only pages have: the flow beside what was learned of it, and V along a run."""

from typing import TYPE_CHECKING

import numpy as np

from ..figures import BLUE, GREY, RED, new_figure
from ..scenario.experiment import Scenario
from ..simulation.flows import flow_velocity

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

PLACES = 9  # arrows on a side


def flows_figure(run: "xarray.Dataset", scenario: Scenario) -> "Figure":
    """Draw the true flow and the learned one at the end of a run, at the same places."""
    figure, ax = new_figure(4.8, 4.8)
    time, path = float(run.time[-1]), run.position.values
    points = np.concatenate([scenario.waypoints, path])
    low, high = points.min(0), points.max(0)
    middle, half = (low + high) / 2, 0.62 * (max(high - low) or 1.0)
    grid = np.stack(np.meshgrid(*(np.linspace(m - half, m + half, PLACES) for m in middle)), -1)
    grid = grid.reshape(-1, 2)
    learned = flow_velocity(scenario, grid, time, run.flow_parameters_estimate.values[-1])
    true = flow_velocity(scenario, grid, time)
    most = np.nanmax(np.hypot(*np.concatenate([true, learned]).T)) or 1.0
    size = {"angles": "xy", "scale_units": "xy", "scale": most * PLACES / (2 * half)}
    ax.plot(*path.T, color=GREY, linewidth=0.4, alpha=0.6, label="track")
    if true.any():
        ax.quiver(*grid.T, *true.T, color=BLUE, alpha=0.45, width=0.009, label="true", **size)
    if learned.any():
        ax.quiver(*grid.T, *learned.T, color=RED, width=0.003, label="learned", **size)
    unit = scenario.units
    ax.set(xlabel=f"$x_1$ ({unit.length})", ylabel=f"$x_2$ ({unit.length})", aspect="equal")
    ax.set(xlim=(middle[0] - half, middle[0] + half), ylim=(middle[1] - half, middle[1] + half))
    ax.set_title(
        f"Flow at t = {time:g} {unit.time}, at most {most:.2g} {unit.length}/{unit.time}",
        loc="left",
        fontsize=10,
    )
    ax.legend(loc="upper center", bbox_to_anchor=(0.5, -0.12), ncols=3, fontsize=8, frameon=False)
    return figure


def lyapunov_figure(run: "xarray.Dataset") -> "Figure":
    """Draw the Lyapunov candidate V along a run, logarithmic."""
    figure, ax = new_figure(4.8, 2.6)
    V = run.lyapunov.values
    ax.semilogy(run.time.values, np.where(V > 0, V, np.nan), color=BLUE, linewidth=1.2)
    ax.set_xlim(float(run.time[0]), float(run.time[-1]))
    ax.set_xlabel(f"time ({run.time.attrs['units']})")
    ax.set_ylabel(f"$V$ ({run.lyapunov.attrs['units'].rstrip('2')}$^2$)")
    ax.set_title("Lyapunov candidate of the law's proof", loc="left", fontsize=10)
    return figure
