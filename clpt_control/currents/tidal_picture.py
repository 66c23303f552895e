"""Tidal ellipses, and a current record beside its fit.

A solid ellipse is run through counter-clockwise, a dashed one clockwise; the dot is where the
current is when V + u = 0.
"""

from typing import Any

import numpy as np

from ..arguments import public
from ..figures import BLUE, COLOURS, GREY, TITLE, axes_for
from ..units import percent
from .current_record import CurrentRecord
from .tidal_fit import TidalFit, predict

MOST = len(COLOURS)  # ellipses that are drawn, the greatest
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
    axes = axes_for(ax, 7.2, 8.0, nrows=3, height_ratios=(2, 1, 1))
    largest = sorted(fit.constituents, key=lambda tide: -tide.major)[:MOST]
    for tide, color in zip(largest, COLOURS, strict=False):
        turn = np.radians([*range(361), -tide.phase])
        ellipse = tide.major * np.cos(turn) + 1j * tide.minor * np.sin(turn)
        ellipse = ellipse * np.exp(1j * np.radians(tide.inclination))
        style = {"color": color, "ls": "-" if tide.minor >= 0 else "--"}
        label = f"{tide.name}, major axis {tide.major:.3f}"
        axes[0].plot(ellipse.real[:-1], ellipse.imag[:-1], label=label, **style)
        axes[0].plot(ellipse.real[-1:], ellipse.imag[-1:], "o", color=color)
    axes[0].set_aspect("equal", "datalim")
    axes[0].set_xlabel("current east (m/s); dashed: clockwise; dot: V + u = 0")
    axes[0].set_ylabel("current north (m/s)")
    axes[0].legend(fontsize=8, frameon=False, loc="upper right")
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
    axes[1].legend(fontsize=8, frameon=False, ncols=2, loc="lower right", bbox_to_anchor=(1, 1))
    axes[1].set_title(
        f"Explained: {percent(fit.explained_variance)}; residual rms {fit.residual_rms:.3g} m/s",
        **TITLE,
    )
    axes[2].set_xlabel(f"days since {origin} UTC")
    return axes
