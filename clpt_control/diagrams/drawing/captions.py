"""The words in a picture: names, equation numbers, and how wide they are."""

import re
from functools import cache

import control


def equations(system: control.NonlinearIOSystem) -> str:
    """Name the equations that a block's functions name."""
    numbers: set[int] = set()
    for role in ("update_function", "output_function"):
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
    """Break a long name where its words meet."""
    lines: list[str] = []
    for word in re.findall(r"[^_.]+[_.]*|[_.]+", name):
        if lines and len(lines[-1]) + len(word) <= 12:
            lines[-1] += word
        else:
            lines.append(word)
    return lines


def note(system: control.NonlinearIOSystem) -> str:
    """Return the line under a block's name."""
    return f"{'∫' if system.nstates else ''}  {equations(system)}".strip()


@cache
def width(text: str, size: float, weight: str = "normal") -> float:
    """Measure text in the font of the picture."""
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextPath

    font = FontProperties(family="DejaVu Sans", weight=weight)
    return float(TextPath((0, 0), text, size=size, prop=font).get_extents().width) if text else 0.0
