"""Drawings of diagrams: into a file, for a notebook, for a page, and as Mermaid text.

Thick frame and integral sign: a block with states.  Grey: a source of time or
tables (`Block.opaque`).  Dashed: feedback.  The number under a name is the
first equation number in the docstrings of the block's functions.
"""

import os
import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import control

from ...base.arguments import public
from ...base.errors import ClptError, DiagramError
from ...base.figures import inline_svg, literal, printable
from ...base.files import check_name, write_file
from ...base.html import fragment, paragraphs
from ...engine.diagram.wiring import Node, Part, wiring_of
from ...engine.model.declaration import docs_of
from .layers import Net, arrange, gather, ports
from .routing import Routed, route

NAME, NOTE, PORT = 8.0, 6.5, 7.0  # sizes of text, points
MARGIN, KEY = 6.0, 18.0
SUFFIXES = (".svg", ".png", ".pdf", ".mmd")
LEGEND = "∫ thick: has states; grey: source of time or tables; dashed: feedback"
MOST = 60  # blocks that a notebook is shown drawn
STYLE: dict[Any, Any] = {
    "font.family": "sans-serif",
    "font.sans-serif": [
        "DejaVu Sans",
        "Bitstream Vera Sans",
        "Verdana",
        "Arial",
        "Helvetica",
    ],
    "path.simplify": False,
    "text.usetex": False,
    "text.parse_math": False,
}


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
        Ends in ``.svg``, ``.png`` or ``.pdf``; ``.mmd`` gets Mermaid text. The same diagram gives
        the same bytes.

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
    if suffix == ".mmd":
        write_file(path, mermaid(diagram))
        return None
    figure = block_figure(diagram)
    with _same_style():
        write_file(path, figure)
    return None


def drawing(diagram: Part) -> Drawing:
    """Return a diagram drawn for a page, as wide as on paper."""
    figure = block_figure(diagram)
    with _same_style():
        svg = inline_svg(figure, "diagram", f"block diagram of {diagram.name}")
    wide = f'<svg width="{72 * figure.get_figwidth():.0f}pt" '
    return Drawing(diagram.name, svg.replace("<svg ", wide, 1))


def _same_style() -> Any:
    """Return a context in which pictures are drawn, whatever the user's matplotlibrc says."""
    from matplotlib import style

    return style.context(["default", STYLE])


def diagram_html(diagram: control.InterconnectedSystem) -> str:
    """Return a diagram drawn, or in words where it is large."""
    size = f"{len(diagram.syslist)} blocks, {diagram.nstates or 0} states"
    name = f"{diagram.name}: {size}"
    try:
        large = len(wiring_of(diagram).nodes) > MOST
        drawn = "" if large else drawing(diagram).svg
    except ClptError as error:  # of what cannot be wired
        return fragment("Diagram", name, paragraphs([str(error)]))
    advice = [
        f"It has more than {MOST} blocks; clpt.draw(diagram, 'loop.svg') draws it."
    ]
    return fragment("Diagram", name, paragraphs(advice) if large else drawn)


@public
def mermaid(diagram: control.NonlinearIOSystem) -> str:
    """Write a diagram as a Mermaid flowchart.

    >>> from clpt_control import connect
    >>> from clpt_control.paper.blocks import clpe, vehicle
    >>> loop = connect([vehicle.vehicle(), clpe.clpe()], external=["flow_x", "v_x", "z"])
    >>> print(mermaid(loop), end="")
    flowchart LR
        in0(["flow_x"])
        in1(["v_x"])
        in2(["z"])
        b0["vehicle<br/>x"]
        b1["clpe<br/>e"]
        in0 -->|"flow_x"| b0
        in1 -->|"v_x"| b0
        b0 -->|"x"| b1
        in2 -->|"z"| b1
    """
    wiring = wiring_of(diagram)
    keys = {
        f"in:{port}": f"in{k}" for k, port in enumerate(ports(diagram.input_labels))
    }
    lines = ["flowchart LR"]
    lines += [f'    {key}(["{_quoted(name[3:])}"])' for name, key in keys.items()]
    keys |= {node.name: f"b{k}" for k, node in enumerate(wiring.nodes)}
    for node in wiring.nodes:
        signals = _quoted(", ".join(ports(node.system.output_labels)))
        lines.append(f'    {keys[node.name]}["{_quoted(node.name)}<br/>{signals}"]')
    for net in gather(diagram, wiring):
        for target, text in net.targets.items():
            lines.append(
                f'    {keys[net.source]} -->|"{_quoted(text)}"| {keys[target]}'
            )
    return "\n".join(lines) + "\n"


def _quoted(text: str) -> str:
    return (
        printable(text).replace("#", "#35;").replace('"', "#quot;").replace("<", "#lt;")
    )


# --- the figure ----------------------------------------------------------------------------------


def block_figure(diagram: Part) -> Any:
    """Return a diagram as a figure."""
    from matplotlib.figure import Figure

    routed, nets, nodes = layout(diagram)
    across = max(routed.width, width(LEGEND, NOTE)) + 2 * MARGIN
    height = routed.height + 2 * MARGIN + KEY
    with _same_style():
        figure = Figure(figsize=(across / 72, height / 72), facecolor="white", dpi=200)
        axes = figure.add_axes((0, 0, 1, 1))
        axes.set_axis_off()
        axes.set_xlim(-MARGIN, across - MARGIN)
        axes.set_ylim(height - MARGIN, -MARGIN)
        _draw_arrows(axes, routed, nets)
        for name, box in routed.boxes.items():
            if name.startswith("in:"):
                style: Any = {"ha": "right", "va": "center_baseline", "style": "italic"}
                text = printable(name[3:])
                axes.text(box.x + box.width - 4, box.y, text, size=PORT, **style)
            elif name in nodes:
                _draw_block(axes, box, name, nodes[name].system)
        axes.text(
            0, height - MARGIN - 4, LEGEND, size=NOTE, va="baseline", color="0.25"
        )
    return figure


def _draw_arrows(axes: Any, routed: Routed, nets: list[Net]) -> None:
    from matplotlib.lines import Line2D
    from matplotlib.patches import Circle, Polygon

    for (k, target), path in routed.paths.items():
        net, (x1, y1) = nets[k], path[-1]
        xs, ys = zip(*path[:-1], (x1 - 3, y1), strict=True)
        line = Line2D(xs, ys, lw=0.8, color="black", zorder=1, solid_joinstyle="miter")
        if target in net.back:
            line.set_dashes((5, 2.2))
        arrow_name = f"arrow:{net.source}:{net.text}:{target}".replace(" ", "")
        line.set_gid(printable(arrow_name))
        axes.add_line(line)
        head = [(x1, y1), (x1 - 6, y1 - 2.2), (x1 - 6, y1 + 2.2)]
        axes.add_patch(Polygon(head, closed=True, fc="black", ec="none", zorder=3))
        text = printable(net.targets.get(target, net.text))
        axes.text(
            x1 - 8, y1 - 3.5, text, size=PORT, ha="right", va="baseline", style="italic"
        )
    for x, y in routed.dots:
        axes.add_patch(Circle((x, y), 1.7, fc="black", ec="none", zorder=3))


def _draw_block(axes: Any, box: Any, name: str, system: Part) -> None:
    from matplotlib.patches import Rectangle

    frame = Rectangle(
        (box.x, box.y - box.height / 2),
        box.width,
        box.height,
        fc="0.88" if system.opaque else "white",
        ec="black",
        lw=1.8 if system.nstates else 0.8,
        zorder=4,
    )
    frame.set_gid(printable(f"block:{name}"))
    axes.add_patch(frame)
    rows = [(printable(line), NAME, "bold") for line in lines_of(name)]
    if text := caption(system):
        rows.append((text, NOTE, "normal"))
    for k, (line, size, weight) in enumerate(rows):
        y = box.y + (k - (len(rows) - 1) / 2) * 10 + size * 0.36
        style = {"ha": "center", "va": "baseline", "zorder": 5}
        axes.text(box.x + box.width / 2, y, line, size=size, weight=weight, **style)


def layout(diagram: Part) -> tuple[Routed, list[Net], dict[str, Node]]:
    """Return boxes and arrows in points, the nets they carry, and the blocks by name."""
    wiring = wiring_of(diagram)
    nets = gather(diagram, wiring)
    layered = arrange(nets, wiring)
    sizes = {
        name: (width(name[3:], PORT) + 4, PORT)
        for name in layered.rank
        if name[:3] == "in:"
    }
    for node in wiring.nodes:
        widths = [width(line, NAME, "bold") for line in lines_of(node.name)]
        widths.append(width(caption(node.system), NOTE))
        rows = len(lines_of(node.name)) + bool(caption(node.system))
        sizes[node.name] = (max(widths) + 11, rows * 10 + 10)
    routed = route(layered, sizes, lambda text: width(text, PORT))
    return routed, nets, {node.name: node for node in wiring.nodes}


def equation_numbers(system: Part) -> str:
    """Return the equations that a block's docstrings name first, as "Eqs. (21)-(23)", but V's."""
    text = " ".join(" ".join(docs_of(system)).split())
    match = re.search(r"(?<!V of )Eqs?\. \(\d+\)((-|, | and )\(\d+\))*", text)
    return match[0] if match else ""


def lines_of(name: str) -> list[str]:
    """Return a name in lines, broken where its words meet."""
    lines: list[str] = []
    for word in re.findall(r"[^_.]+[_.]*|[_.]+", name):
        if lines and len(lines[-1]) + len(word) <= 12:
            lines[-1] += word
        else:
            lines.append(word)
    return lines


def caption(system: Part) -> str:
    """Return the line under a block's name: an integral sign for states, and equations."""
    return f"{'∫' if system.nstates else ''}  {equation_numbers(system)}".strip()


@cache
def width(text: str, size: float, weight: str = "normal") -> float:
    """Return the width of a line of text in points."""
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextPath

    font = FontProperties(family="DejaVu Sans", weight=weight)
    plain = literal(text)
    return (
        float(TextPath((0, 0), plain, size=size, prop=font).get_extents().width)
        if text.strip()
        else 0.3 * size * len(text)
    )
