"""Diagrams as plain data: the plain data of the blocks, and the wires between them.

The diagram of plain data is like any other: python-control runs it, and it can be drawn,
linearized, varied and proved.  It is flat: the block `inner` of a nested diagram `outer` is called
`outer_inner`.
"""

from collections.abc import Mapping, Sequence
from math import prod
from typing import Any

import control
import numpy as np

from ...base.errors import DiagramError
from ...engine.diagram.interconnection import MOST_BYTES, Diagram
from ...engine.diagram.wiring import Wiring
from ...engine.record.unread import Unread
from .blocks import block_of, plain_block

Entry = tuple[int, int, float]  # row, column, gain


def plain_diagram(
    wiring: Wiring,
    parameters: Sequence[Any],
    names: Mapping[str, Any],
    begin: float,
    end: float,
    triggered: Mapping[int, np.ndarray],
) -> dict[str, Any]:
    """Return a diagram with parameters of its blocks as plain data, for runs between two times.

    `names` has the diagram's name, and the labels of its inputs, outputs and states; `triggered`
    has the breakpoints of blocks that jump where an input of the diagram rises.
    """
    outputs = [
        (row, source, gain)
        for row, gains in enumerate(wiring.outputs)
        for source, gain in gains.items()
    ]
    if any(source < 0 for _, source, _ in outputs):
        raise Unread("an input of the diagram is an output of it")
    blocks = [
        plain_block(node.system, name, p, begin, end, triggered.get(k))
        for k, (name, node, p) in enumerate(
            zip(_flat_names(wiring), wiring.nodes, parameters, strict=True)
        )
    ]
    return {
        "dt": wiring.dt,
        **names,
        "blocks": blocks,
        "connections": _wires(wiring, external=False),
        "feeds": _wires(wiring, external=True),
        "shown": outputs,
    }


def _flat_names(wiring: Wiring) -> list[str]:
    """Return a unique name of each block, without dots."""
    names: list[str] = []
    for node in wiring.nodes:
        name = node.name.replace(".", "_")
        count = sum(name == previous.rstrip("_") for previous in names)
        names.append(name + "_" * count)
    return names


def _wires(wiring: Wiring, external: bool) -> list[Entry]:
    return [
        (node.inputs.start + row, source, gain)
        for node in wiring.nodes
        for row, source, gain in node.fed(external)
    ]


def diagram_of(plain: Mapping[str, Any]) -> Diagram:
    """Return the diagram of plain data."""
    blocks = [block_of(block) for block in plain["blocks"]]
    ninputs = sum(block.ninputs for block in blocks)
    noutputs = sum(block.noutputs for block in blocks)
    shapes = {
        "connections": (ninputs, noutputs),
        "feeds": (ninputs, len(plain["inputs"])),
        "shown": (len(plain["outputs"]), noutputs + ninputs),
    }
    if 8 * sum(map(prod, shapes.values())) > MOST_BYTES:
        raise DiagramError(
            f"{plain['name']}: is larger than python-control's matrices may be"
        )
    names = {key: plain[key] for key in ("inputs", "outputs", "states", "name", "dt")}
    diagram = control.InterconnectedSystem(blocks, **names)
    connections, feeds, shown = (
        _matrix(plain[wires], shape) for wires, shape in shapes.items()
    )
    diagram.set_connect_map(connections)
    diagram.set_input_map(feeds)
    diagram.set_output_map(shown)
    diagram.__class__ = Diagram
    return diagram


def _matrix(entries: Sequence[Entry], shape: tuple[int, int]) -> np.ndarray:
    matrix = np.zeros(shape)
    for row, column, gain in entries:
        if not (0 <= row < shape[0] and 0 <= column < shape[1]):
            raise DiagramError(
                f"a wire leads to the signal {row} from {column}, of {shape}"
            )
        matrix[row, column] = gain
    return matrix
