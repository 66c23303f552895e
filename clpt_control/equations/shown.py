"""A block in a line, and as a notebook shows it: ports, states, parameters."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from ..html import facts, fragment, shortened

MOST = 8  # ports of a line


def ports_line(ports: Mapping[str, int]) -> str:
    """Return ports with their sizes.

    >>> ports_line({"e": 2, "w": 1})
    'e[2], w'
    """
    named = [name if size == 1 else f"{name}[{size}]" for name, size in ports.items()]
    more = [f"... {len(named)} in all"] if len(named) > MOST else []
    return ", ".join(named[: MOST if more else None] + more) or "nothing"


def block_line(block: Any) -> str:
    """Return what a block is, in a line."""
    states = f", {block.nstates} states" if block.nstates else ""
    flows = f"{ports_line(block.input_ports)} -> {ports_line(block.output_ports)}"
    return f"<Block {block.name}: {flows}{states}>"


def block_html(block: Any) -> str:
    """Return a block as a table."""
    said = next((f.__doc__ for f in (block.update_function, block.output_function) if f), None)
    rows = [
        ("equations", " ".join((said or "").split("\n\n")[0].split())),
        ("inputs", ports_line(block.input_ports)),
        ("outputs", ports_line(block.output_ports)),
        ("states", ports_line(block.state_ports)),
    ]
    values = block.parameters._asdict().items()
    rows += [(f"{block.name}.{name}", _value(value)) for name, value in values]
    return fragment("Block", block.name, facts(rows))


def _value(value: Any) -> str:
    """Return a parameter: a number, or the first numbers of an array and its shape."""
    whole = np.asarray(value)
    if whole.ndim == 0:
        return f"{value:g}" if isinstance(value, float) else str(value)
    first = ", ".join(f"{number:g}" for number in whole.ravel()[:12])
    dots = ", ..." if whole.size > 12 else ""
    return shortened(f"[{first}{dots}], shape {whole.shape}")
