"""Pictures of a replay: map, CLPE per dive, learned current.

They take a `Replay` and give a `matplotlib.figure.Figure`; nothing is learned
here.  The 90 % ellipse is {m + sqrt(2 ln 10) L u, |u| = 1}, L L^T its covariance.
"""

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..plotting import BLUE, GREEN, GREY, ORANGE, RED, new_figure
from .dives import Dive, displacement
from .replay import ELLIPSE, Replay
from .replay_step import MODELS

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LEGEND = [
    "way between fixes",
    "miss of dead reckoning",
    "dead-reckoned end",
    "forecast, 90 % ellipse",
    "fix",
]


def map_plot(replay: Replay) -> "Figure":
    """Draw fixes, dead-reckoned ends and forecasts.

    Parameters
    ----------
    replay : Replay
        With one dive at least.

    Returns
    -------
    Figure
        In km east and north of the first fix.
    """
    figure, ax = new_figure(6.4, 6.2)
    origin = replay.steps[0].dive
    circle = np.linspace(0, 2 * np.pi, 73)
    unit = np.sqrt(ELLIPSE) * np.array([np.cos(circle), np.sin(circle)])
    for k, step in enumerate(replay.steps):
        d = step.dive
        start = _km(origin, d.lat_gps2, d.lon_gps2)
        end = _km(origin, d.lat_gpse, d.lon_gpse)
        reckoned = start + np.array([d.dr_east, d.dr_north]) / 1000
        forecast = reckoned + step.forecast / 1000
        ring = forecast[:, None] + np.linalg.cholesky(step.covariance) @ unit / 1000
        names = [None] * 5 if k else LEGEND
        ax.plot(*np.array([start, end]).T, color=BLUE, lw=1.3, label=names[0])
        ax.plot(*np.array([reckoned, end]).T, color=GREY, lw=0.7, ls=":", label=names[1])
        ax.plot(*reckoned, "x", color=RED, ms=6, label=names[2])
        if k:  # the first dive has no forecast
            ax.plot(*ring, color=GREEN, lw=0.7, alpha=0.7)
            ax.plot(*forecast, "+", color=GREEN, ms=7)
        else:
            ax.plot([], [], "-+", color=GREEN, ms=7, lw=0.7, label=names[3])
        ax.plot(*end, "o", color="black", ms=4, label=names[4])
        if len(replay.steps) <= 40:
            ax.annotate(str(d.number), end, xytext=(4, 4), textcoords="offset points", fontsize=7)
    ax.set(xlabel="east of the first fix (km)", ylabel="north of the first fix (km)")
    ax.set_aspect("equal", adjustable="datalim")
    ax.set_title("Where it surfaced, and where it was expected", loc="left", fontsize=10)
    figure.legend(loc="outside lower center", ncols=3, fontsize=8, frameon=False)
    return figure


def dive_clpe_plot(replay: Replay) -> "Figure":
    """Draw the CLPE of each dive for three flow models.

    Parameters
    ----------
    replay : Replay
        With one dive at least.

    Returns
    -------
    Figure
        Flagged dives are marked.
    """
    figure, ax = new_figure(6.8, 4.0)
    numbers = [step.dive.number for step in replay.steps]
    for model, colour, mark, style in zip(
        MODELS, (GREY, ORANGE, BLUE), ("s", "^", "o"), (":", "--", "-"), strict=True
    ):
        size = [step.clpe[model] / 1000 for step in replay.steps]
        rms = replay.rms(0)[model]
        label = f"{model.replace('_', ' ')}, rms {(rms or 0) / 1000:.2f} km"
        ax.plot(numbers, size, marker=mark, ls=style, color=colour, ms=4, lw=1.2, label=label)
    flagged = [step for step in replay.steps if step.anomaly]
    for k, step in enumerate(flagged):
        ax.axvline(step.dive.number, color=RED, lw=1, label=None if k else "speed anomaly")
    ax.set(xlabel="dive", ylabel="CLPE at the surfacing (km)", ylim=(0, None))
    ax.xaxis.get_major_locator().set_params(integer=True)
    ax.set_title("Prediction error, one dive ahead", loc="left", fontsize=10)
    figure.legend(loc="outside lower center", fontsize=8, frameon=False, ncols=2)
    return figure


def current_plot(replay: Replay) -> "Figure":
    """Draw learned current and speed against the file's own.

    Parameters
    ----------
    replay : Replay
        With one dive at least.

    Returns
    -------
    Figure
        Bands of two standard errors; the last panel is the speed factor.
    """
    steps, learned = replay.steps, replay.model.learn_speed
    figure, axes = new_figure(6.8, 6.4 if learned else 4.6, nrows=2 + learned, sharex=True)
    numbers = [step.dive.number for step in steps]
    for i, axis in enumerate(("east", "north")):
        ax = axes[i]
        value = np.array([step.current[i] for step in steps])
        error = 2 * np.array([step.current_error[i] for step in steps])
        ax.fill_between(numbers, value - error, value + error, color=BLUE, alpha=0.15, lw=0)
        ax.plot(numbers, value, "-o", color=BLUE, ms=4, lw=1.2, label="learned, 2 standard errors")
        own = [getattr(step.dive, f"dac_{axis}") for step in steps]
        if any(v is not None for v in own):
            shown = [np.nan if v is None else v for v in own]
            ax.plot(numbers, shown, "--^", color=ORANGE, ms=4, lw=1, label="the file's own")
        ax.axhline(0, color="black", lw=0.5)
        ax.set_ylabel(f"current {axis} (m/s)")
    axes[0].legend(fontsize=8, frameon=False, ncols=2, loc="lower left", bbox_to_anchor=(0, 1))
    if learned:
        value = np.array([step.speed for step in steps])
        error = 2 * np.array([step.speed_error for step in steps])
        axes[2].fill_between(numbers, value - error, value + error, color=GREEN, alpha=0.15, lw=0)
        axes[2].plot(numbers, value, "-o", color=GREEN, ms=4, lw=1.2)
        axes[2].axhline(1, color="black", lw=0.5)
        axes[2].set_ylabel("factor on speed")
    axes[-1].set_xlabel("dive")
    axes[-1].xaxis.get_major_locator().set_params(integer=True)
    return figure


def save_replay_figures(replay: Replay, folder: Path) -> list[Path]:
    """Write map.png, clpe.png and current.png.

    Parameters
    ----------
    replay : Replay
        With one dive at least.
    folder : Path
        An existing folder.

    Returns
    -------
    list of Path
        The files.
    """
    paths = []
    for name, draw in (("map", map_plot), ("clpe", dive_clpe_plot), ("current", current_plot)):
        paths.append(Path(folder) / f"{name}.png")
        draw(replay).savefig(paths[-1])
    return paths


def _km(origin: Dive, lat: float, lon: float) -> np.ndarray:
    east, north = displacement(origin.lat_gps2, origin.lon_gps2, lat, lon)
    return np.array([east, north]) / 1000
