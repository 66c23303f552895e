"""Tidal ellipses, and a current record beside its fit.

All ellipses have one scale, but for those that would be dots: they are thin, drawn five times as
large and marked so.  A solid one is run through counter-clockwise, a dashed one clockwise; the dot
is where the current is when V + u = 0.
"""

from typing import Any

import numpy as np

from ..arguments import public
from ..figures import BLUE, GREY, RED, TITLE, axes_for
from ..units import percent
from .current_record import CurrentRecord
from .tidal_fit import Constituent, TidalFit, predict

MOST = 6  # ellipses that are drawn, the greatest
SMALL = 1 / 8  # of the greatest: below it an ellipse is drawn larger
LARGER = 5
WIDE, HIGH, ROOM = 6.2, 1.3, 0.45  # of the row, its ellipses and between two, inches
LINE = 0.14  # of small print, inches
SPAN = np.timedelta64(15 * 24, "h")  # of the record that is drawn, about its middle
DAY = np.timedelta64(1, "D")


@public
def tides_plot(fit: TidalFit, record: CurrentRecord, *, ax: Any = None) -> np.ndarray:
    """Draw tidal ellipses, and a record against its fit, m/s.

    Parameters
    ----------
    fit : TidalFit
        As `fit_tides` gives it.
    record : CurrentRecord
        As `read_record` gives it, the record of the fit; its middle 15 days are drawn.
    ax : array of 3 Axes, optional
        Where to draw; by default a new figure of pyplot's.

    Returns
    -------
    ndarray of Axes, shape (3,)
        Ellipses, the current to the east, to the north.

    Raises
    ------
    ClptError
        If `ax` are not three Axes.

    Examples
    --------
    >>> import numpy as np
    >>> from clpt_control.currents import fit_tides, read_record
    >>> record = read_record("currents.csv", latitude=41.0)  # doctest: +SKIP
    >>> fit = fit_tides(record.time, record.u, record.v, 41.0)  # doctest: +SKIP
    >>> ellipses, east, north = tides_plot(fit, record)  # doctest: +SKIP
    """
    tides, half, larger = _largest(fit)
    wide, high = np.hypot(*half.real.T).sum(), np.hypot(*half.imag.T).max()
    bar = float(f"{max(tide.major for tide in tides) / 2:.1g}")  # m/s, round
    inch = max((2 * wide + bar) / (WIDE - ROOM * len(tides)), 2 * high / HIGH)  # m/s: the row full
    row = 2 * high / inch + 5 * LINE
    axes = axes_for(ax, 7.2, 4.9 + row, nrows=3, height_ratios=(row, 2, 2))
    _draw(axes[0], tides, half, larger, bar, inch)
    begin = max(fit.start, fit.middle - SPAN // 2)
    end = min(fit.end, fit.middle + SPAN // 2)
    near = (record.time >= begin) & (record.time <= end)
    fine = begin + np.linspace(0, 1, 1500) * (end - begin)
    model = predict(fit, fine)
    origin = fit.start.astype("datetime64[D]")
    days = [(t - origin) / DAY for t in (record.time[near], fine)]
    for one, name, measured, tide in zip(
        axes[1:], ("east", "north"), (record.u[near], record.v[near]), model, strict=True
    ):
        one.plot(days[0], measured, ".", color=GREY, ms=3.5, label="measured")
        one.plot(days[1], tide, color=BLUE, lw=1.1, label="mean and tides")
        one.set_ylabel(f"current {name} (m/s)")
    if ax is None:
        axes[1].sharex(axes[2])
        axes[1].tick_params(labelbottom=False)
    axes[1].legend(fontsize=8, frameon=False, ncols=2, loc="lower right", bbox_to_anchor=(1, 1))
    axes[1].set_title(
        f"Explained: {percent(fit.explained_variance)}; residual rms {fit.residual_rms:.3g} m/s",
        **TITLE,
    )
    axes[2].set_xlabel(f"days since {origin} UTC")
    return axes


def _largest(fit: TidalFit) -> tuple[list[Constituent], np.ndarray, np.ndarray]:
    """Return the greatest tides in the order of the fit, their half axes as they are drawn.

    The half axes are complex, (n, 2), m/s; the third is how much larger each is drawn, (n,).
    """
    largest = sorted(fit.constituents, key=lambda each: -each.major)[:MOST]
    tides = [tide for tide in fit.constituents if tide in largest]
    larger = np.array([LARGER if t.major < SMALL * largest[0].major else 1 for t in tides])
    lean = larger * np.exp(1j * np.radians([tide.inclination for tide in tides]))
    return tides, lean[:, None] * [[tide.major, 1j * tide.minor] for tide in tides], larger


def _draw(
    ax: Any, tides: list[Constituent], axes: np.ndarray, larger: np.ndarray, bar: float, inch: float
) -> None:
    """Draw ellipses in a row, `inch` m/s to an inch, and a `bar` of so many m/s."""
    turn = np.exp(1j * np.linspace(0, 2 * np.pi, 181))
    wide, low, x = np.hypot(*axes.real.T), np.hypot(*axes.imag.T).max(), 0.0
    for tide, half, out, times in zip(tides, axes, wide, larger, strict=True):
        x += out
        path = x + half @ [turn.real, turn.imag]
        lag = np.radians(-tide.phase)
        dot = x + half @ [np.cos(lag), np.sin(lag)]
        thick = 1.5 if times == 1 else 0.8
        ax.plot(path.real, path.imag, color=BLUE, lw=thick, ls="-" if tide.minor >= 0 else "--")
        ax.plot([x, dot.real], [0, dot.imag], color=RED, lw=0.6 * thick)
        ax.plot(dot.real, dot.imag, "o", color=RED, ms=2 + thick)
        label = f"{tide.name}\n{tide.major:.3f}" + (f"\n× {LARGER}" if times > 1 else "")
        ax.text(x, -low - LINE * inch, label, ha="center", va="top", fontsize=8)
        x += out + ROOM * inch
    ax.plot([x, x + bar], [0, 0], color="black", lw=2)
    ax.text(x + bar / 2, LINE / 2 * inch, f"{bar:g} m/s", ha="center", va="bottom", fontsize=8)
    spare = (WIDE * inch - x - bar) / 2 + LINE * inch  # also for the width of lines
    ax.set_aspect("equal")
    ax.set(xlim=(-spare, x + bar + spare), ylim=(-low - 4 * LINE * inch, low + LINE * inch))
    ax.axis("off")
    more = f"; × {LARGER}: drawn {LARGER} times as large as the others"
    ax.set_title(
        "Tidal ellipses, east to the right, semi-major axis in m/s\n"
        "dashed: clockwise; dot: V + u = 0" + (more if larger.max() > 1 else ""),
        **TITLE,
    )
