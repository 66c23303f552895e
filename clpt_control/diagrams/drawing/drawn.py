"""A diagram drawn: into a file, or for a notebook in the colour of its text; and in a line."""

import os
import re
from dataclasses import dataclass
from pathlib import Path

import control

from ...arguments import public
from ...equations.shown import ports_line
from ...errors import ClptError, DiagramError
from ...figures.svg import inline_svg
from ...files import beside, check_name
from ...html import fragment, paragraphs, shortened
from ..wiring import wiring_of
from .arrows import mermaid
from .figure import STYLE, block_figure, save

SUFFIXES = (".svg", ".png", ".pdf", ".mmd", ".md")
MOST = 60  # blocks that a notebook is shown drawn


@dataclass(frozen=True, repr=False)
class Drawing:
    """A diagram drawn, which a notebook shows; `svg` is an element of a page."""

    name: str
    svg: str

    def __repr__(self) -> str:
        return f"<Drawing of {self.name}; clpt.draw(diagram, 'loop.svg') writes a file>"

    def _repr_html_(self) -> str:
        return fragment("", "", self.svg)


@public
def draw(
    diagram: control.NonlinearIOSystem, path: str | os.PathLike[str] | None = None
) -> Drawing | None:
    """Draw a diagram, for a notebook or into a file.

    Parameters
    ----------
    diagram : control.NonlinearIOSystem
        An interconnected system; blocks of nested ones are drawn one by one.
    path : str or path, optional
        Ends in ``.svg``, ``.png`` or ``.pdf``; ``.mmd`` gets Mermaid text,
        ``.md`` the same in a fence. The same diagram gives the same bytes.

    Returns
    -------
    Drawing or None
        Without a path what a notebook shows.

    Raises
    ------
    DiagramError
        If the ending is another.
    DataError
        If the folder is missing or cannot be written to.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> loop = clpt.closed_loop(clpt.paper_scenario())
    >>> clpt.draw(loop).svg[:4]
    '<svg'
    """
    if path is None:
        return drawing(diagram)
    path = Path(path)
    check_name(path)
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise DiagramError(
            f"{path}: a diagram is drawn as {', '.join(SUFFIXES)}, not '{path.suffix}'"
        )
    figure = None if suffix in (".mmd", ".md") else block_figure(diagram)
    with beside(path) as part:
        if figure is None:
            text = mermaid(diagram)
            text = f"```mermaid\n{text}```\n" if suffix == ".md" else text
            part.write_text(text, encoding="utf-8")
        else:
            save(figure, part, suffix)
    return None


def drawing(diagram: control.NonlinearIOSystem) -> Drawing:
    """Return a diagram drawn for a page, as wide as on paper."""
    from matplotlib import style

    figure = block_figure(diagram)
    with style.context(["default", STYLE]):
        svg = inline_svg(figure, "diagram", f"block diagram of {diagram.name}")
    wide = f'<svg width="{72 * figure.get_figwidth():.0f}pt" '
    return Drawing(diagram.name, svg.replace("<svg ", wide, 1))


def diagram_line(diagram: control.InterconnectedSystem) -> str:
    """Return what a diagram is, in a line."""
    flows = f"{_ports(diagram.input_labels)} -> {_ports(diagram.output_labels)}"
    return f"<Diagram {shortened(diagram.name, 60)}: {_size(diagram)}; {flows}>"


def diagram_html(diagram: control.InterconnectedSystem) -> str:
    """Return a diagram drawn, or in words where it is large."""
    name = f"{diagram.name}: {_size(diagram)}"
    try:
        large = len(wiring_of(diagram).nodes) > MOST
        drawn = "" if large else drawing(diagram).svg
    except ClptError as error:  # of what cannot be wired
        return fragment("Diagram", name, paragraphs([str(error)]))
    said = [f"It has more than {MOST} blocks; clpt.draw(diagram, 'loop.svg') draws it."]
    return fragment("Diagram", name, paragraphs(said) if large else drawn)


def _size(diagram: control.InterconnectedSystem) -> str:
    return f"{len(diagram.syslist)} blocks, {diagram.nstates or 0} states"


def _ports(labels: list[str]) -> str:
    """Return labels as ports with their sizes: a[0], a[1], b as a[2], b."""
    sizes: dict[str, int] = {}
    for label in labels:
        port = re.sub(r"\[\d+\]$", "", label)
        sizes[port] = sizes.get(port, 0) + 1
    return ports_line(sizes)
