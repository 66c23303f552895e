"""A figure of matplotlib as SVG inside a page.

Its texts stay texts.  Colours of the house become those of the page's style, so that the figure
is read in light, in dark and on paper.  Style attributes, which the page's policy refuses, become
attributes; identifiers begin with the figure's name, so that a page may hold many.
"""

import re
from collections.abc import Iterator
from io import BytesIO
from typing import TYPE_CHECKING
from xml.etree import ElementTree

from ..html import plain, safe
from . import BLUE, COLOURS, GREEN, GREY, ORANGE, PURPLE, RED, save_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

XLINK = "{http://www.w3.org/1999/xlink}"
NUMBER = re.compile(r"-?\d+\.\d+")
REFERENCE = re.compile(r"url\(#(.+?)\)")
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
THEMED = {colour.lower(): name for colour, name in THEME.items()}
ENLARGED = 1.45  # px per point, where there is room
HUGE = 1500.0  # px; a wider one is moved sideways on every screen
DROPPED = {"font-family", "stroke-miterlimit", "white-space"}
ROOT = {"stroke-linejoin": "round", "stroke-linecap": "butt", "fill": "currentColor"}


def inline_svg(figure: "Figure", name: str, said: str) -> str:
    """Return a figure as an element of a page; `name` is its own, `said` is read aloud."""
    made = BytesIO()
    save_figure(figure, made, "svg", transparent=True)
    root = ElementTree.fromstring(plain(made.getvalue().decode()))
    for parent in root.iter():
        for child in list(parent):
            if child.tag.rpartition("}")[2] in ("metadata", "style"):
                parent.remove(child)
    wanted = _references(root)
    for element in root.iter():
        element.tag = element.tag.rpartition("}")[2]
        _restyle(element)
        _rename(element, name, wanted)
    box = root.attrib["viewBox"]
    width, height = (f"{ENLARGED * float(size):.0f}" for size in box.split()[2:])
    root.attrib.clear()
    if float(width) > HUGE:
        root.set("class", "huge")
    root.attrib.update({"viewBox": box, "width": width, "height": height, **ROOT})
    root[:] = list(_shown(root))
    text = ElementTree.tostring(root, "unicode", short_empty_elements=True)
    text = re.sub(r">\s+<", "><", text)
    return text.replace("<svg", f'<svg role="img" aria-label="{safe(said)}"', 1)


def _references(root: ElementTree.Element) -> set[str]:
    """Return the identifiers that something in a figure refers to."""
    found = set()
    for element in root.iter():
        for key, value in element.attrib.items():
            if key == f"{XLINK}href":
                found.add(value[1:])
            found.update(REFERENCE.findall(value))
    return found


def _restyle(element: ElementTree.Element) -> None:
    """Write a style attribute as attributes, in the page's colours and with few digits."""
    for rule in element.attrib.pop("style", "").split(";"):
        key, _, value = (part.strip() for part in rule.partition(":"))
        if key and key not in DROPPED:
            element.set(key, THEMED.get(value.lower(), value))
    for key in ("d", "x", "y", "transform", "points", "stroke-dasharray"):
        if (numbers := element.get(key)) is not None:
            element.set(key, " ".join(NUMBER.sub(_short, numbers).split()))


def _short(number: re.Match[str]) -> str:
    return f"{float(number[0]):.2f}".rstrip("0").rstrip(".")


def _rename(element: ElementTree.Element, name: str, wanted: set[str]) -> None:
    """Begin identifiers with a name; drop those to which nothing refers."""
    own = element.attrib.pop("id", None)
    if own in wanted:
        element.set("id", f"{name}-{own}")
    if (target := element.attrib.pop(f"{XLINK}href", None)) is not None:
        element.set("href", f"#{name}-{target[1:]}")
    for key, value in element.attrib.items():
        element.set(key, REFERENCE.sub(rf"url(#{name}-\1)", value))


def _shown(element: ElementTree.Element) -> Iterator[ElementTree.Element]:
    """Yield what is in an element, without groups that say nothing."""
    for child in element:
        kept = list(_shown(child))
        if child.tag == "g" and not child.attrib:
            yield from kept
        elif child.tag != "defs" or kept:
            child[:] = kept
            yield child
