"""The house style of figures, the axes on which a plot draws, and figures in pages.

Colours are those of Okabe and Ito, which colour-blind readers distinguish; line styles distinguish
lines in black and white.  A function `*_plot` draws on the given axes, or on those of a new figure
of pyplot, which a notebook or a window displays.  `figure_of` returns the same figure for a file
or a page, without pyplot.

`inline_svg` returns a figure as SVG for a page.  Texts stay texts.  House colours become variables
of the page's style, for light and dark screens and paper.  Style attributes, which the page's
policy forbids, become attributes.  Identifiers begin with the figure's name, so that a page may
have many figures.
"""

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from io import BytesIO
from pathlib import Path
from threading import RLock
from typing import IO, TYPE_CHECKING, Any

import numpy as np

from ..arguments import brief
from ..errors import ArgumentError, ClptError
from ..html import plain, safe

if TYPE_CHECKING:
    from matplotlib.figure import Figure

BLUE, ORANGE, GREEN, RED, GREY = "#0072B2", "#E69F00", "#009E73", "#D55E00", "#666666"
PURPLE = "#CC79A7"
COLOURS = (BLUE, RED, GREEN, ORANGE, PURPLE, "#56B4E9")
TITLE: dict[str, Any] = {"loc": "left", "fontsize": 10}
STYLES = ("-", "--", "-.", (0, (1, 1)), (0, (5, 1, 1, 1, 1, 1)), (0, (8, 2)))

LEGEND_COLUMNS = 3
LEGEND_ROW = 0.25  # of the height of the data

FORMATS = ("png", "pdf", "svg")
SAME: dict[Any, Any] = {  # whatever the user's matplotlibrc says
    "svg.hashsalt": "clpt-control",
    "svg.fonttype": "none",
    "pdf.fonttype": 42,
    "text.usetex": False,
}
DATES: dict[str, dict[str, Any]] = {
    "svg": {"Date": None},
    "pdf": {"CreationDate": None},
}

NUMBER = re.compile(r"-?\d+\.\d+")
THEME = {  # colour -> the page's
    "#000000": "currentColor",
    "#ffffff": "var(--paper)",
    "#404040": "var(--soft)",
    "#b0b0b0": "var(--rule)",
    "#e0e0e0": "var(--card)",
    GREY: "var(--soft)",
    BLUE: "var(--blue)",
    ORANGE: "var(--orange)",
    GREEN: "var(--green)",
    RED: "var(--red)",
    PURPLE: "var(--purple)",
    COLOURS[-1]: "var(--sky)",
}
ENLARGED = 1.45  # px per point, if the page is wide enough
HUGE = 1500.0  # px; wider figures scroll horizontally on every screen
DROPPED = re.compile(  # of matplotlib's: what it tells of itself, names of groups, fonts, line ends
    r"<metadata>.*?</metadata>|<defs>\s*<style.*?</defs>|(?<=<g) id=\"[^\"]*\"|"
    r"(?:font-family|white-space|stroke-miterlimit): [^;\"]*;? ?|(?<=>)\s+(?=<)",
    re.DOTALL,
)
ROOT = 'stroke-linejoin="round" stroke-linecap="butt" fill="currentColor"'

ONE_DRAWING = RLock()  # settings of matplotlib are those of the process
_for_a_file: ContextVar[bool] = ContextVar("for_a_file", default=False)


def styled(axes: Any) -> Any:
    """Return axes in the house style."""
    for ax in np.ravel(axes):
        ax.spines[["top", "right"]].set_visible(False)
        ax.grid(True, linewidth=0.4, alpha=0.5)
    return axes


def line_style(k: int) -> dict[str, Any]:
    """Return colour and style of line k of several lines."""
    return {"color": COLOURS[k % 6], "linestyle": STYLES[k % 6]}


def axes_for(
    ax: Any, width: float, height: float, mosaic: Any = None, **subplots: Any
) -> Any:
    """Return the axes that a plot draws on: the given axes, or those of a new figure (inches).

    Their shape is that of ``pyplot.subplots(**subplots)``, or the axes of a `mosaic` in a row.
    Given axes may have any shape, but the number must be right.
    """
    if ax is None:
        figure = (
            _bare(width, height) if _for_a_file.get() else _displayed(width, height)
        )
        if mosaic is not None:
            return styled(np.array(list(figure.subplot_mosaic(mosaic).values())))
        return styled(figure.subplots(**subplots))
    shape = tuple(
        n for n in (subplots.get("nrows", 1), subplots.get("ncols", 1)) if n > 1
    )
    if mosaic is not None:
        shape = (len({name for row in mosaic for name in row}),)
    return _checked_axes(ax, shape)


def _checked_axes(ax: Any, shape: tuple[int, ...]) -> Any:
    """Return given axes in a shape; refuse other objects and a wrong number of axes."""
    from matplotlib.axes import Axes

    is_list = isinstance(ax, list | tuple | np.ndarray)
    items = np.ravel(np.asarray(ax, dtype=object)).tolist() if is_list else [ax]
    count = int(np.prod(shape))
    for item in items:
        if not isinstance(item, Axes):
            raise ArgumentError(
                f"ax = {brief(item)}: must be matplotlib Axes. Make them with pyplot.subplots"
            )
    if len(items) != count:
        size = ", ".join(map(str, shape)) or "1"
        raise ClptError(
            f"ax: has {len(items)} Axes; this plot needs {count}. Make them with "
            f"pyplot.subplots({size})"
        )
    return np.reshape(items, shape) if shape else items[0]


def _bare(width: float, height: float) -> "Figure":
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height), dpi=150, layout="constrained")


def _displayed(width: float, height: float) -> "Figure":
    """Return a new figure of pyplot, or one without pyplot if its backend cannot start."""
    try:
        from matplotlib import pyplot

        return pyplot.figure(figsize=(width, height), layout="constrained")
    except ImportError:  # a backend with windows, without a screen
        return _bare(width, height)


@contextmanager
def file_settings() -> Iterator[None]:
    """Draw for files, without pyplot, one thread at a time, whatever the matplotlibrc says."""
    from matplotlib import rc_context

    token = _for_a_file.set(True)
    try:
        with ONE_DRAWING, rc_context(SAME):
            yield
    finally:
        _for_a_file.reset(token)


def figure_of(plot: Callable[..., Any], *arguments: Any, **keywords: Any) -> "Figure":
    """Return the figure that a plot draws, without pyplot, for a file or a page."""
    with file_settings():
        axes = plot(*arguments, **keywords)
    return np.ravel(np.asarray(axes, dtype=object))[0].figure


def literal(text: str) -> str:
    r"""Return a text without formulas; characters that cannot be printed are replaced.

    >>> print(literal("$x$\u2028"))
    \$x\$�
    """
    return printable(text).replace("$", r"\$")


def with_formulas(text: str) -> str:
    r"""Return a text whose formulas matplotlib can set, or else the literal text.

    >>> print(with_formulas("$k_p$ = 2"), with_formulas("2 $"))
    $k_p$ = 2 2 \$
    """
    from matplotlib.mathtext import MathTextParser

    text = printable(text)
    try:
        MathTextParser("path").parse(text)
    except ValueError:
        return literal(text)
    return text if text.count("$") % 2 == 0 else literal(text)


def printable(text: str) -> str:
    r"""Return a text in which characters that cannot be printed are replaced.

    >>> print(printable("a\u2028b"))
    a�b
    """
    return "".join(c if c.isprintable() or c == "\n" else "\ufffd" for c in text)


def legend_below(ax: Any, columns: int, points: float = 34.0) -> None:
    """Place a legend some points below axes, under their label."""
    from matplotlib.transforms import ScaledTranslation

    below = ax.transAxes + ScaledTranslation(0, -points / 72, ax.figure.dpi_scale_trans)
    position = {
        "loc": "upper center",
        "bbox_to_anchor": (0.5, 0),
        "bbox_transform": below,
    }
    ax.legend(ncols=columns, fontsize=8, frameon=False, **position)


def legend_above_data(ax: Any) -> None:
    """Draw a legend of three columns in room that is added above the data."""
    rows = -(-len(ax.get_legend_handles_labels()[0]) // LEGEND_COLUMNS)
    if not rows:
        return
    ax.autoscale(axis="y")
    scale = ax.yaxis.get_transform()
    low, high = scale.transform(np.array(ax.get_ylim()))
    high += LEGEND_ROW * rows * (high - low)
    ax.set_ylim(scale.inverted().transform([low, high]))
    ax.legend(frameon=False, fontsize=8, ncols=LEGEND_COLUMNS, loc="upper right")


def checked_formats(formats: Sequence[str]) -> tuple[str, ...]:
    """Return formats of figures without duplicates; refuse others than `FORMATS`."""
    for kind in formats:
        if kind not in FORMATS:
            raise ClptError(f"format {kind!r:.40}: must be one of {', '.join(FORMATS)}")
    return tuple(dict.fromkeys(formats))


def save_figure(
    figure: "Figure", target: Path | IO[bytes], kind: str, **options: Any
) -> None:
    """Write a figure as one of `FORMATS`: texts as text, no date, the same bytes each time."""
    with file_settings():
        try:
            figure.savefig(target, format=kind, metadata=DATES.get(kind), **options)
        except (ValueError, ArithmeticError) as error:  # limits of axes overflow
            raise ClptError(
                f"a figure cannot be drawn: {error}; numbers above 1e307 are too large for axes"
            ) from None


# --- figures in pages ----------------------------------------------------------------------------


def inline_svg(figure: "Figure", name: str, words: str) -> str:
    """Return a figure as an element of a page; `words` are its text for screen readers."""
    content = BytesIO()
    save_figure(figure, content, "svg", transparent=True)
    text = re.sub(DROPPED, "", plain(content.getvalue().decode()))
    head, _, text = text.partition("<svg")[2].partition(">")
    box = head.partition('viewBox="')[2].partition('"')[0]
    width, height = (ENLARGED * float(size) for size in box.split()[2:])
    text = re.sub(r'(id="|url\(#)', rf"\1{name}-", text).replace(
        'xlink:href="#', f'href="#{name}-'
    )
    text = re.sub(r' (?:d|x|y|transform|points)="[^"]*"', _with_short_numbers, text)
    text = re.sub(r'style="([^"]*)"', _as_attributes, text)
    for colour, of_page in THEME.items():
        text = text.replace(colour.lower(), of_page)
    kind = ' class="huge"' if width > HUGE else ""
    size = f'viewBox="{box}" width="{width:.0f}" height="{height:.0f}"'
    return (
        f'<svg role="img" aria-label="{safe(words)}"{kind} {size} {ROOT}>{text.strip()}'
    )


def _as_attributes(style: re.Match[str]) -> str:
    rules = (rule.partition(":") for rule in style[1].split(";") if rule.strip())
    return " ".join(f'{key.strip()}="{value.strip()}"' for key, _, value in rules)


def _with_short_numbers(attribute: re.Match[str]) -> str:
    text = NUMBER.sub(
        lambda number: f"{float(number[0]):.2f}".rstrip("0").rstrip("."), attribute[0]
    )
    return " " + " ".join(text.split())
