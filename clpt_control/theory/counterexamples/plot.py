"""Pictures of the counterexamples and of the bound that holds.

They take what `counterexamples`, `scalar_counterexamples`, `unlearned` and
`mean_square` give; nothing here runs.  Eqs. (16), (33), Theorem 3.3.
"""

from typing import TYPE_CHECKING

import numpy as np

from ...figures import BLUE, COLOURS, GREY, RED, STYLES, new_figure
from .mean_square import MeanSquare
from .printed_bounds import Counterexample
from .unlearned import Unlearned

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
        ax.axhline(found.claimed, color=RED, linestyle="--", linewidth=1.4,
                   label=f"Eq. {found.equation} allows, at most")  # fmt: skip
        ax.set_ylabel(f"|e| ({found.length})")
        ax.set_ylim(0, 1.15 * found.peak)
    if np.ptp(drive) > 1e-9 * drive.max():  # else the dashed line says it
        bottom.plot(times[near], drive[near] / found.k, color=GREY, linestyle=":", linewidth=1.2,
                    label=r"$|(\theta-\hat\theta)\phi+\Delta|/\lambda_{\min}(K_D)$")  # fmt: skip
    bottom.plot(peak, found.peak, "o", color="black", markersize=4,
                label=f"peak, {found.ratio:.3g} of the bound")  # fmt: skip
    top.set_xlim(times[0], times[-1])
    bottom.set(xlabel=f"time ({found.time})", xlim=(times[near][0], times[near][-1]))
    factor = r"$\mu$" if found.equation == "(16)" else r"$\beta$"
    verdict = (f"is no ultimate bound: |e| exceeds it for every {factor} from "
               f"{found.fails_above:.2g} to {found.k:g} per {found.time}"
               if found.ratio > 1 else "is not violated here")  # fmt: skip
    top.set_title(f"Eq. {found.equation} {verdict}", loc="left", fontsize=10)
    figure.legend(*bottom.get_legend_handles_labels(), fontsize=8, frameon=False,
                  loc="outside lower center", ncols=4)  # fmt: skip
    return figure


def unlearned_plot(found: Unlearned) -> "Figure":
    """Draw the estimate that stands still, and what it should be.

    Parameters
    ----------
    found : Unlearned
        The case of Theorem 3.3.

    Returns
    -------
    Figure
        One line per axis.

    Examples
    --------
    >>> from clpt_control.theory.counterexamples.unlearned import unlearned_counterexample
    >>> figure = unlearned_plot(unlearned_counterexample(end=40.0))
    """
    figure, ax = new_figure(6.4, 3.2)
    j = found.function
    for i in range(2):
        ax.plot(found.times, found.estimates[:, i], color=COLOURS[i], linestyle=STYLES[i],
                linewidth=1.4, label=rf"estimate of $\theta_{i + 1}^{{{j}}}$")  # fmt: skip
    for value in np.unique(found.true):
        ax.axhline(value, color="black", linestyle=":", linewidth=1.0)
        ax.annotate("true value", (found.times[-1], value), xytext=(0, 3), ha="right",
                    textcoords="offset points", fontsize=8)  # fmt: skip
    ax.set(xlabel="time (s)", ylabel="flow parameter (m/s)", xlim=(0, found.times[-1]))
    ax.set_title(
        rf"$\int z_c z_c^T dt \geq {found.kappa:.0f}$ m$^2$ s per cycle, "
        rf"yet $|\phi_{j}| \leq$ {found.largest:.0e} and nothing is learned",
        loc="left",
        fontsize=10,
    )
    ax.legend(fontsize=8, frameon=False, loc="center right")
    return figure


def mean_square_plot(found: MeanSquare, length: str = "m", time: str = "s") -> "Figure":
    """Draw both sides of the mean-square bound along time.

    Parameters
    ----------
    found : MeanSquare
        Of one run.
    length, time : str
        Units.

    Returns
    -------
    Figure
        int |e|^2 below 2 V(0)/k + int |Delta|^2/k^2.

    Examples
    --------
    >>> times = np.linspace(0.0, 1.0, 3)
    >>> figure = mean_square_plot(MeanSquare(times, times, 1.0 + times))
    """
    figure, ax = new_figure(6.4, 3.4)
    ax.plot(found.times, found.right, color=RED, linestyle="--", linewidth=1.4,
            label=r"allowed: $2V(0)/k + \int|\Delta|^2 dt/k^2$")  # fmt: skip
    ax.plot(found.times, found.left, color=BLUE, linewidth=1.4, label=r"$\int|e|^2 dt$")
    ax.set(xlabel=f"time ({time})", ylabel=f"({length}$^2$ {time})", ylim=(0, None))
    ax.set_xlim(found.times[0], found.times[-1])
    ax.set_title("The mean-square bound always holds", loc="left", fontsize=10)
    ax.legend(fontsize=8, frameon=False)
    return figure
