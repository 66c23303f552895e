"""From a diagram to boxes and arrows: its texts, how wide they are, and the layout."""

import re
from functools import cache
from typing import Any

import control

from ..wiring import Node, wiring_of
from .layers import arrange, gather
from .routing import Routed, route

NAME, NOTE, PORT = 8.0, 6.5, 7.0  # sizes of text, points


def layout(diagram: control.NonlinearIOSystem) -> tuple[Routed, list[Any], dict[str, Node]]:
    """Return boxes and arrows in points, the nets they carry, and the blocks by name."""
    wiring = wiring_of(diagram)
    nets = gather(diagram, wiring)
    layered = arrange(nets, wiring)
    sizes = {name: (width(name[3:], PORT) + 4, PORT) for name in layered.rank if name[:3] == "in:"}
    for node in wiring.nodes:
        widths = [width(line, NAME, "bold") for line in lines_of(node.name)]
        widths.append(width(note(node.system), NOTE))
        rows = len(lines_of(node.name)) + bool(note(node.system))
        sizes[node.name] = (max(widths) + 11, rows * 10 + 10)
    routed = route(layered, sizes, lambda text: width(text, PORT))
    return routed, nets, {node.name: node for node in wiring.nodes}


def equations(system: control.NonlinearIOSystem) -> str:
    """Return the equations that a block's docstrings name, such as ``"Eqs. (21)–(23)"``."""
    numbers: set[int] = set()
    for role in ("update_function", "output_function", "jump_function"):
        text = getattr(getattr(system, role, None), "__doc__", None) or ""
        for found in re.findall(r"Eqs?\.\s*((?:\(\d+\)(?:\s*(?:,|-|–|and)\s*)?)+)", text):
            for first, last in re.findall(r"\((\d+)\)(?:\s*[-–]\s*\((\d+)\))?", found):
                numbers |= set(range(int(first), int(last or first) + 1))
    runs: list[list[int]] = []
    for number in sorted(numbers):
        if runs and number == runs[-1][-1] + 1:
            runs[-1].append(number)
        else:
            runs.append([number])
    parts = []
    for run in runs:
        parts += [f"({run[0]})–({run[-1]})"] if len(run) > 2 else [f"({n})" for n in run]
    return f"Eq{'s' * (len(numbers) > 1)}. {', '.join(parts)}" if parts else ""


def lines_of(name: str) -> list[str]:
    """Return a name in lines, broken where its words meet."""
    lines: list[str] = []
    for word in re.findall(r"[^_.]+[_.]*|[_.]+", name):
        if lines and len(lines[-1]) + len(word) <= 12:
            lines[-1] += word
        else:
            lines.append(word)
    return lines


def note(system: control.NonlinearIOSystem) -> str:
    """Return the line under a block's name: an integral sign for states, and equations."""
    return f"{'∫' if system.nstates else ''}  {equations(system)}".strip()


@cache
def width(text: str, size: float, weight: str = "normal") -> float:
    """Return the width of a line of text in points."""
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextPath

    font = FontProperties(family="DejaVu Sans", weight=weight)
    return float(TextPath((0, 0), text, size=size, prop=font).get_extents().width) if text else 0.0
