"""Figures of a replay with one dive at least: map, CLPE per dive, learned current.

The 90 % ellipse is {m + sqrt(2 ln 10) L u, |u| = 1}, L L^T its covariance.
"""

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..figures import BLUE, GREEN, GREY, ORANGE, PURPLE, RED, new_figure
from ..files import write_together
from ..geodesy import displacement
from ..gliders.dives import Dive
from .outcome import clpe_rms
from .replay import Replay
from .step import CHI_SQUARED
from .surfacing import NextDive

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LINES = {
    "no_flow": (GREY, "s", ":"),
    "previous_dive": (ORANGE, "^", "--"),
    "adaptive": (BLUE, "o", "-"),
    "flow_model": (GREEN, "D", "-."),
}
CIRCLE = np.linspace(0, 2 * np.pi, 73)
UNIT = np.sqrt(CHI_SQUARED) * np.array([np.cos(CIRCLE), np.sin(CIRCLE)])
MANY = 40  # dives; beyond, no numbers, and ellipses of the last ones only


def map_plot(replay: Replay, ahead: NextDive | None = None) -> "Figure":
    """Draw fixes, dead-reckoned ends, forecasts and the next surfacing, km from the first fix."""
    from matplotlib.patheffects import withStroke

    dives = [step.dive for step in replay.steps]
    start = np.array([_km(dives[0], d.lat_gps2, d.lon_gps2) for d in dives])
    end = np.array([_km(dives[0], d.lat_gpse, d.lon_gpse) for d in dives])
    reckoned = start + np.array([[d.dr_east, d.dr_north] for d in dives]) / 1000
    forecast = reckoned + np.array([step.forecast for step in replay.steps]) / 1000
    rings = [
        place[:, None] + np.linalg.cholesky(step.covariance) @ UNIT / 1000
        for step, place in zip(replay.steps, forecast, strict=True)
    ][1:][-MANY:]  # the first dive has no forecast
    star = []
    if ahead is not None:
        goal = _km(dives[0], ahead.latitude, ahead.longitude)
        star = [goal[:, None] + np.linalg.cholesky(ahead.covariance) @ UNIT / 1000]
    everything = np.concatenate([start, end, reckoned, *(ring.T for ring in [*rings, *star])])
    wide, high = np.ptp(everything, axis=0) + 1e-3
    larger = max(wide, high)
    figure, ax = new_figure(max(6.5 * wide / larger, 3.8) + 0.8, max(6.5 * high / larger, 3) + 1)
    for k, ring in enumerate(rings):
        ax.plot(*ring, color=GREEN, lw=0.6, alpha=0.55, label=None if k else "90 % ellipse")
    for first, last, colour, width, style, name in (
        (start, end, BLUE, 1.3, "-", "fix to fix"),
        (end[:-1], start[1:], BLUE, 0.8, ":", "drift at the surface"),
        (reckoned, end, RED, 0.6, "--", "miss"),
    ):
        ax.plot(*_pieces(first, last), color=colour, lw=width, ls=style, label=name)
    small = len(dives) > MANY
    ax.plot(*reckoned.T, "x", color=RED, ms=3 if small else 6, label="dead-reckoned end")
    ax.plot(*forecast[1:].T, "+", color=GREEN, ms=4 if small else 8, mew=1.4, label="forecast")
    ax.plot(*end.T, "o", color="black", ms=2 if small else 4.5, label="fix", zorder=4)
    if ahead is not None:
        ax.plot(*star[0], color=PURPLE, lw=1.2, ls="--")
        ax.plot(*goal, "*", color=PURPLE, ms=11, label="next surfacing", zorder=5)
    for k, dive in enumerate(dives if not small else ()):
        away = 2 * end[k] - start[k] - (end[k + 1] if k + 1 < len(dives) else end[k])
        away = np.array([12, 8]) * away / max(np.hypot(*away), 1e-9)
        text = ax.annotate(
            str(dive.number),
            end[k],
            xytext=tuple(away),
            fontsize=7,
            textcoords="offset points",
            ha="center",
            va="center",
        )
        text.set_path_effects([withStroke(linewidth=2, foreground="white")])
    ax.set(xlabel="east of the first fix (km)", ylabel="north of the first fix (km)")
    ax.set_aspect("equal", adjustable="datalim")
    ax.set_title("Where it surfaced, and where it was expected", loc="left", fontsize=10)
    figure.legend(loc="outside lower center", ncols=3, fontsize=8, frameon=False)
    return figure


def dive_clpe_plot(replay: Replay) -> "Figure":
    """Draw the CLPE of each dive for each flow model, and mark speed anomalies."""
    figure, ax = new_figure(6.8, 4.0)
    numbers = [step.dive.number for step in replay.steps]
    for model, rms in clpe_rms(replay, 1).items():
        colour, mark, style = LINES[model]
        size = [np.nan if e is None else e / 1000 for e in (s.clpe[model] for s in replay.steps)]
        label = model.replace("_", " ") + ("" if rms is None else f", rms {rms / 1000:.2f} km")
        ax.plot(numbers, size, mark, ls=style, color=colour, label=label, **_fine(numbers))
    flagged = [step for step in replay.steps if step.anomaly]
    for k, step in enumerate(flagged):
        ax.axvline(step.dive.number, color=RED, lw=1, label=None if k else "speed anomaly")
    ax.set(xlabel="dive", ylabel="miss (CLPE) at the surfacing (km)", ylim=(0, None))
    _whole_dives(ax, numbers)
    ax.set_title("Prediction error, one dive ahead; rms after the first", loc="left", fontsize=10)
    figure.legend(loc="outside lower center", fontsize=8, frameon=False, ncols=3)
    return figure


def current_plot(replay: Replay) -> "Figure":
    """Draw the learned current, two standard errors and the file's own; the speed factor."""
    steps, learned = replay.steps, replay.model.learn_speed
    figure, axes = new_figure(6.8, 6.4 if learned else 4.6, nrows=2 + learned, sharex=True)
    numbers = [step.dive.number for step in steps]
    for i, axis in enumerate(("east", "north")):
        ax = axes[i]
        value = np.array([step.current[i] for step in steps])
        error = 2 * np.array([step.current_error[i] for step in steps])
        ax.fill_between(numbers, value - error, value + error, color=BLUE, alpha=0.15, lw=0)
        ax.plot(
            numbers, value, "-o", color=BLUE, label="learned, 2 standard errors", **_fine(numbers)
        )
        own = [getattr(step.dive, f"dac_{axis}") for step in steps]
        if any(v is not None for v in own):
            shown = [np.nan if v is None else v for v in own]
            ax.plot(numbers, shown, "--^", color=ORANGE, label="the file's own", **_fine(numbers))
        ax.axhline(0, color="black", lw=0.5)
        ax.set_ylabel(f"current {axis} (m/s)")
    axes[0].legend(fontsize=8, frameon=False, ncols=2, loc="lower left", bbox_to_anchor=(0, 1))
    if learned:
        value = np.array([step.speed for step in steps])
        error = 2 * np.array([step.speed_error for step in steps])
        axes[2].fill_between(numbers, value - error, value + error, color=GREEN, alpha=0.15, lw=0)
        axes[2].plot(numbers, value, "-o", color=GREEN, **_fine(numbers))
        axes[2].axhline(1, color="black", lw=0.5)
        axes[2].set_ylabel("factor on speed")
    axes[-1].set_xlabel("dive")
    _whole_dives(axes[-1], numbers)
    return figure


def replay_figures(replay: Replay, ahead: NextDive | None = None) -> "dict[str, Figure]":
    """Draw all figures, by the names of their files."""
    return {
        "map.png": map_plot(replay, ahead),
        "clpe.png": dive_clpe_plot(replay),
        "current.png": current_plot(replay),
    }


def save_replay_figures(replay: Replay, folder: Path, ahead: NextDive | None = None) -> list[Path]:
    """Draw map.png, clpe.png and current.png into a folder.

    Parameters
    ----------
    replay : Replay
        With one dive at least.
    folder : Path
        An existing folder. All three files are written, or none.
    ahead : NextDive, optional
        The next surfacing, a star on the map.

    Returns
    -------
    list of Path
        The files.

    Raises
    ------
    DataError
        If one cannot be written.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> import clpt_control as clpt
    >>> dives, skipped = clpt.gliders.usable(clpt.gliders.sample_dives())
    >>> replay = clpt.replay.replay_dives(dives[:3])
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     files = clpt.replay.save_replay_figures(replay, pathlib.Path(folder))
    >>> [path.name for path in files]
    ['map.png', 'clpe.png', 'current.png']
    """
    figures = {Path(folder) / name: f for name, f in replay_figures(replay, ahead).items()}
    write_together(figures)
    return list(figures)


def _km(origin: Dive, lat: float, lon: float) -> np.ndarray:
    east, north = displacement(origin.lat_gps2, origin.lon_gps2, lat, lon)
    return np.array([east, north]) / 1000


def _fine(numbers: list[int]) -> dict[str, float]:
    """Return sizes of marks and lines, small for many dives."""
    return {"ms": 4, "lw": 1.2} if len(numbers) <= MANY else {"ms": 1.8, "lw": 0.7}


def _whole_dives(ax: "Axes", numbers: list[int]) -> None:
    """Mark whole numbers of dives, also where there is one."""
    from matplotlib.ticker import MaxNLocator

    ax.xaxis.set_major_locator(MaxNLocator(integer=True, min_n_ticks=1))
    if len(numbers) == 1:
        ax.set_xlim(numbers[0] - 1, numbers[0] + 1)


def _pieces(first: np.ndarray, last: np.ndarray) -> np.ndarray:
    """Return n lines as one, broken by NaN, shape (2, 3 n)."""
    return np.stack([first, last, np.full_like(first, np.nan)], axis=1).reshape(-1, 2).T
