"""The picture of a counterexample to Eq. (16) or (33); nothing here runs."""

from typing import TYPE_CHECKING

import numpy as np

from ...figures import BLUE, GREY, RED, new_figure
from .printed_bounds import Counterexample

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def counterexample_plot(found: Counterexample, span: float | None = None) -> "Figure":
    """Draw |e| and the printed bound; below, around the peak.

    Parameters
    ----------
    found : Counterexample
        A run beside Eq. (16) or (33).
    span : float, optional
        Width of the lower panel; a thirtieth of the stretch measured.

    Returns
    -------
    Figure
        Axes in the counterexample's own units.

    Examples
    --------
    >>> from clpt_control.theory.counterexamples.scalar import square_wave_counterexample
    >>> figure = counterexample_plot(square_wave_counterexample(periods=8))
    """
    figure, (top, bottom) = new_figure(6.4, 5.2, nrows=2)
    late = found.late
    times, size, drive = found.times[late], found.size[late], found.drive[late]
    peak = times[np.argmax(size)]
    span = (times[-1] - times[0]) / 30 if span is None else span
    near = (times >= peak - span / 2) & (times <= peak + span / 2)
    for ax, shown, width in ((top, slice(None), 0.4), (bottom, near, 1.2)):
        ax.plot(times[shown], size[shown], color=BLUE, linewidth=width, label="|e|")
        ax.axhline(
            found.claimed,
            color=RED,
            linestyle="--",
            linewidth=1.4,
            label=f"Eq. {found.equation} allows, at most",
        )
        ax.set_ylabel(f"|e| ({found.length})")
        ax.set_ylim(0, 1.15 * found.peak)
    if np.ptp(drive) > 1e-9 * drive.max():  # else the dashed line says it
        bottom.plot(
            times[near],
            drive[near] / found.k,
            color=GREY,
            linestyle=":",
            linewidth=1.2,
            label=r"$|(\theta-\hat\theta)\phi+\Delta|/\lambda_{\min}(K_D)$",
        )
    bottom.plot(
        peak,
        found.peak,
        "o",
        color="black",
        markersize=4,
        label=f"peak, {found.ratio:.3g} of the bound",
    )
    top.set_xlim(times[0], times[-1])
    bottom.set(xlabel=f"time ({found.time})", xlim=(times[near][0], times[near][-1]))
    factor = r"$\mu$" if found.equation == "(16)" else r"$\beta$"
    verdict = (
        f"is no ultimate bound: |e| exceeds it for every {factor} from "
        f"{found.fails_above:.2g} to {found.k:g} per {found.time}"
        if found.ratio > 1
        else "is not violated here"
    )
    top.set_title(f"Eq. {found.equation} {verdict}", loc="left", fontsize=10)
    figure.legend(
        *bottom.get_legend_handles_labels(),
        fontsize=8,
        frameon=False,
        loc="outside lower center",
        ncols=4,
    )
    return figure
