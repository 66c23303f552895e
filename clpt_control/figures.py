"""The house style of figures.

Colours are those of Okabe and Ito, told apart by the colour-blind; line styles tell them
apart in black and white.
"""

from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from matplotlib.figure import Figure

BLUE, ORANGE, GREEN, RED, GREY = "#0072B2", "#E69F00", "#009E73", "#D55E00", "#666666"
PURPLE = "#CC79A7"
COLOURS = (BLUE, RED, GREEN, ORANGE, PURPLE, "#56B4E9")
STYLES = ("-", "--", "-.", (0, (1, 1)), (0, (5, 1, 1, 1, 1, 1)), (0, (8, 2)))

FORMATS = ("png", "pdf", "svg")
SAME: dict[Any, Any] = {"svg.hashsalt": "clpt-control", "svg.fonttype": "none", "pdf.fonttype": 42}
DATES: dict[str, dict[str, Any]] = {"svg": {"Date": None}, "pdf": {"CreationDate": None}}


def new_figure(width: float = 6.4, height: float = 4.2, **subplots: Any) -> "tuple[Figure, Any]":
    """Return a figure (inches) and its axes, as ``pyplot.subplots``, in the house style."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height), dpi=150, layout="constrained")
    axes = figure.subplots(**subplots)
    for ax in np.atleast_1d(axes).ravel():
        ax.spines[["top", "right"]].set_visible(False)
        ax.grid(True, linewidth=0.4, alpha=0.5)
    return figure, axes


def save_figure(figure: "Figure", target: Path | IO[bytes], kind: str, **options: Any) -> None:
    """Write a figure as one of `FORMATS`: texts as text, no date, the same bytes each time."""
    from matplotlib import rc_context

    with rc_context(SAME):
        figure.savefig(target, format=kind, metadata=DATES.get(kind), **options)
