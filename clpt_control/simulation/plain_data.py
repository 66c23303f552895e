"""A diagram as plain data, and back; and a key that changes if the diagram would be read otherwise.

Plain data are the records of the blocks and their wires.  The diagram made of them is like any
other: python-control runs it, it is drawn, linearized, varied and proved.  It is flat; the blocks
of nested diagrams are called ``outer_inner``.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import control
import numpy as np

from ..base.errors import DiagramError
from ..engine.diagram.interconnection import MOST_BYTES, Diagram
from ..engine.diagram.wiring import Params, Wiring
from ..engine.model.block import Block
from ..engine.model.sampled import Sampled
from ..engine.model.system import System
from ..engine.trace.arrays import Unread
from ..engine.trace.fingerprint import reachable
from .plain_blocks import block_of, plain_block

Entry = tuple[int, int, float]  # row, column, gain


def plain_diagram(
    wiring: Wiring,
    parameters: Sequence[Any],
    names: Mapping[str, Any],
    begin: float,
    end: float,
) -> dict[str, Any]:
    """Return a diagram as plain data, its blocks with these parameters, for runs between times.

    `names` are its name, and the labels of its inputs, outputs and states.
    """

    def wires(external: bool) -> list[Entry]:
        return [
            (node.inputs.start + to, source, gain)
            for node in wiring.nodes
            for to, source, gain in node.fed(external)
        ]

    shown = [
        (to, k, gain)
        for to, row in enumerate(wiring.outputs)
        for k, gain in row.items()
    ]
    if any(k < 0 for _, k, _ in shown):
        raise Unread("an input of the diagram is an output of it")
    flat: list[str] = []  # names of blocks
    for node in wiring.nodes:
        name = node.name.replace(".", "_")
        flat.append(name + "_" * sum(name == one.rstrip("_") for one in flat))
    blocks = [
        plain_block(node.system, name, p, begin, end)
        for name, node, p in zip(flat, wiring.nodes, parameters, strict=True)
    ]
    return {
        "dt": wiring.dt,
        **names,
        "blocks": blocks,
        "connections": wires(False),
        "feeds": wires(True),
        "shown": shown,
    }


def diagram_of(plain: Mapping[str, Any]) -> Diagram:
    """Return the diagram that plain data hold."""
    blocks = [block_of(one) for one in plain["blocks"]]
    inputs, outputs = (
        sum(n) for n in zip(*((b.ninputs, b.noutputs) for b in blocks), strict=True)
    )
    external, shown = len(plain["inputs"]), len(plain["outputs"])
    if 8 * (inputs * (outputs + external) + shown * (outputs + inputs)) > MOST_BYTES:
        raise DiagramError(
            f"{plain['name']}: is larger than python-control's matrices may be"
        )
    diagram = control.InterconnectedSystem(
        blocks,
        inputs=plain["inputs"],
        outputs=plain["outputs"],
        states=plain["states"],
        name=plain["name"],
        dt=plain["dt"],
    )
    diagram.set_connect_map(_matrix(plain["connections"], (inputs, outputs)))
    diagram.set_input_map(_matrix(plain["feeds"], (inputs, external)))
    diagram.set_output_map(_matrix(plain["shown"], (shown, outputs + inputs)))
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


# --- a key of all that a diagram consists of ------------------------------------------------------


def diagram_key(diagram: Any, params: Params, *more: Any) -> tuple | None:
    """Return the key of a diagram with params and more, and the objects that must live as long.

    None where something in it could change without a trace.
    """
    numbers: list[Any] = [tuple((params or {}).items()), more]
    functions: list[Any] = []
    try:
        own = _system(diagram, numbers, functions)
        keys = reachable(*functions), reachable(*numbers)
    except Unread:
        return None
    key = own, keys[0].identity, keys[1].key
    return key, (diagram, *(one.referenced for one in keys))


def _system(system: Any, numbers: list[Any], functions: list[Any]) -> Any:
    """Return names and identities of a system; append its numbers and functions to the lists."""
    if not isinstance(system, control.NonlinearIOSystem):
        raise Unread("cannot be wired")
    labels = *system.input_index, *system.output_index, *(system.state_index or ())
    own: tuple = id(system), system.name, system.dt, labels
    if isinstance(system, Sampled):
        inner = system.inner
        numbers += inner.params.values() if isinstance(inner, System) else ()
        own = *own, id(system.parameters), system.period
        return *own, *_system(inner, numbers, functions)
    if isinstance(system, Block):  # what is the package's own is not traced again
        functions += [] if system.of_package else [f for f, _ in system._roles.values()]
        numbers.append(system.parameters)  # which stay alive
        return *own, id(system.parameters)
    own = *own, system.nstates, system.ninputs, system.noutputs
    numbers.append(tuple(system.params.items()))
    if isinstance(system, control.InterconnectedSystem):
        numbers += [system.connect_map, system.input_map, system.output_map]
        return *own, *(_system(part, numbers, functions) for part in system.syslist)
    if isinstance(system, control.StateSpace):
        numbers += [system.A, system.B, system.C, system.D]
        return own
    kind, plain = type(system), control.NonlinearIOSystem
    if kind._rhs is not plain._rhs or kind._out is not plain._out:
        # they are an object's
        raise Unread("its class has its own equations")
    functions += [system.updfcn, system.outfcn]
    return own
