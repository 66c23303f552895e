"""The words in a picture: names, equation numbers, and how wide they are."""

import re
from functools import cache

import control


def equations(system: control.NonlinearIOSystem) -> str:
    """Name the equations that a block's functions name.

    Parameters
    ----------
    system : control.NonlinearIOSystem
        A block; other systems name none.

    Returns
    -------
    str
        Such as ``"Eq. (21)"`` or ``"Eqs. (21)–(23)"``; empty without any.

    Examples
    --------
    >>> from clpt_control.blocks import clpe, vehicle
    >>> equations(clpe.clpe()), equations(vehicle.vehicle())
    ('Eq. (10)', 'Eq. (1)')
    """
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
    """Break a long name where its words meet.

    Parameters
    ----------
    name : str
        Name of a block.

    Returns
    -------
    list of str
        One or more lines.

    Examples
    --------
    >>> lines_of("learning_controller"), lines_of("vehicle")
    (['learning_', 'controller'], ['vehicle'])
    """
    lines: list[str] = []
    for word in re.findall(r"[^_.]+[_.]*|[_.]+", name):
        if lines and len(lines[-1]) + len(word) <= 12:
            lines[-1] += word
        else:
            lines.append(word)
    return lines


def note(system: control.NonlinearIOSystem) -> str:
    """Return the line under a block's name.

    Parameters
    ----------
    system : control.NonlinearIOSystem
        The block.

    Returns
    -------
    str
        An integral sign where it has states, and its equations.

    Examples
    --------
    >>> from clpt_control.blocks import vehicle
    >>> note(vehicle.vehicle())
    '∫  Eq. (1)'
    """
    return f"{'∫' if system.nstates else ''}  {equations(system)}".strip()


@cache
def width(text: str, size: float, weight: str = "normal") -> float:
    """Measure text in the font of the picture.

    Parameters
    ----------
    text : str
        One line.
    size : float
        Of the font, in points.
    weight : str, optional
        ``"normal"`` or ``"bold"``.

    Returns
    -------
    float
        Points.

    Examples
    --------
    >>> width("clpe", 8) < width("clpe", 8, "bold")
    True
    """
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextPath

    font = FontProperties(family="DejaVu Sans", weight=weight)
    return float(TextPath((0, 0), text, size=size, prop=font).get_extents().width) if text else 0.0
