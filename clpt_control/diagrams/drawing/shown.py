"""A diagram in a line, and as a notebook shows it: drawn."""

import re

import control

from ...equations.shown import ports_line
from ...errors import ClptError
from ...html.fragment import fragment, shortened
from ...html.text import paragraphs
from ..wiring import wiring_of
from .drawn import drawing

MOST = 60  # blocks that a notebook is shown drawn


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
