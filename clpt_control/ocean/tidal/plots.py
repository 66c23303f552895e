"""One picture of tidal constants: ellipses, and the record beside the fit.

All ellipses have one scale.  A solid one is run through counter-clockwise, a
dashed one clockwise; the dot is where the current is when V + u = 0.
"""

from typing import TYPE_CHECKING

import numpy as np

from ...plotting import BLUE, GREY, RED, new_figure
from .analysis import predict
from .constants import TidalFit
from .record import CurrentRecord

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MOST = 6  # ellipses that are drawn, the greatest
SPAN = np.timedelta64(15 * 24, "h")  # of the record that is drawn, about its middle
DAY = np.timedelta64(1, "D")


def tides_plot(fit: TidalFit, record: CurrentRecord) -> "Figure":
    """Draw tidal ellipses, and the record against the fit.

    Parameters
    ----------
    fit : TidalFit
        From `fit_tides`.
    record : CurrentRecord
        What was fitted.

    Returns
    -------
    Figure
        m/s; of a long record the middle 15 days.
    """
    figure, axes = new_figure(7.2, 6.6, nrows=3, height_ratios=(1.15, 1, 1))
    _ellipses(axes[0], fit)
    begin = max(fit.start, fit.middle - SPAN // 2)
    end = min(fit.end, fit.middle + SPAN // 2)
    kept = (record.time >= begin) & (record.time <= end)
    fine = begin + np.linspace(0, 1, 1500) * (end - begin)
    model = predict(fit, fine)
    origin = fit.start.astype("datetime64[D]")
    days = [(t - origin) / DAY for t in (record.time[kept], fine)]
    for ax, name, measured, tide in zip(
        axes[1:], ("east", "north"), (record.u[kept], record.v[kept]), model, strict=True
    ):
        ax.plot(days[0], measured, ".", color=GREY, ms=3.5, label="measured")
        ax.plot(days[1], tide, color=BLUE, lw=1.1, label="mean and tides")
        ax.set_ylabel(f"current {name} (m/s)")
    axes[1].sharex(axes[2])
    axes[1].tick_params(labelbottom=False)
    axes[1].legend(fontsize=8, frameon=False, ncols=2, loc="lower right", bbox_to_anchor=(1, 1))
    axes[1].set_title(
        f"Explained: {fit.explained_variance:.1%}; residual rms "
        f"{fit.residual_rms:.3g} m/s", loc="left", fontsize=10,
    )  # fmt: skip
    axes[2].set_xlabel(f"days since {origin} UTC")
    return figure


def _ellipses(ax, fit: TidalFit) -> None:
    shown = sorted(fit.constituents, key=lambda each: -each.major)[:MOST]
    shown = [each for each in fit.constituents if each in shown]
    most = max(each.major for each in shown)
    scale, step = float(f"{most:.1g}"), 2.5 * most
    turn = np.exp(1j * np.linspace(0, 2 * np.pi, 181))
    low = max(np.hypot(e.major * np.sin(np.radians(e.inclination)), e.minor) for e in shown)
    for k, each in enumerate(shown):
        lean = np.exp(1j * np.radians(each.inclination))
        path = lean * (each.major * turn.real + 1j * each.minor * turn.imag)
        lag = np.radians(-each.phase)
        dot = lean * (each.major * np.cos(lag) + 1j * each.minor * np.sin(lag))
        ax.plot(
            k * step + path.real, path.imag, color=BLUE, lw=1.5, ls="-" if each.minor >= 0 else "--"
        )
        ax.plot([k * step, k * step + dot.real], [0, dot.imag], color=RED, lw=0.9)
        ax.plot(k * step + dot.real, dot.imag, "o", color=RED, ms=4)
        ax.text(
            k * step, -low - 0.06 * step, f"{each.name}\n{each.major:.3f}", ha="center", va="top",
            fontsize=8,
        )  # fmt: skip
    left = (len(shown) - 0.45) * step
    ax.plot([left, left + scale], [0, 0], color="black", lw=2)
    ax.annotate(
        f"{scale:g} m/s", (left + scale / 2, 0.04 * step), ha="center", va="bottom", fontsize=8
    )
    ax.set_aspect("equal")
    ax.set(xlim=(-0.55 * step, left + 1.15 * scale), ylim=(-low - 0.32 * step, low + 0.02 * step))
    ax.axis("off")
    ax.figure.suptitle(
        "Tidal ellipses, east to the right, semi-major axis in m/s "
        "(dashed: clockwise; dot: V + u = 0)",
        x=0.01, ha="left", fontsize=10,
    )  # fmt: skip
