"""A condition on outputs and inputs of a diagram that ends a run.

stop(t, y, u) > 0 goes on; the run ends where it falls to 0.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from ..arguments import shown
from ..equations.block import Block
from ..equations.declaration import Guard
from ..errors import DiagramError
from .wiring import Node, Wiring, entries, joined_wires

NAME = "stop"


def with_stop(wiring: Wiring, stop: Callable[[float, Any, Any], Any]) -> Wiring:
    """Return the wiring with a block that looks at outputs and inputs, and ends the run."""
    if not callable(stop):
        raise DiagramError(f"stop = {shown(stop)}: must be a function of t, outputs and inputs")
    if wiring.dt:
        raise DiagramError(
            f"stop: a diagram of discrete time (dt = {wiring.dt}) has nothing between its samples "
            "to cross; look at the samples of a whole run"
        )

    def distance(t, x, u, p):
        return stop(t, u.y, u.u)

    def sentence(t: float, u: np.ndarray, p: Any) -> str:
        return f"`{getattr(stop, '__name__', 'stop')}` fell to 0 at t = {t:.9g}"

    last, m, outputs = wiring.nodes[-1], wiring.ninputs, wiring.output_map.shape[0]
    block = Block(
        NAME,
        output=lambda t, x, u, p: {},
        inputs={"y": outputs, "u": m},
        outputs={},
        guard=Guard(distance, "stop", sentence),
    )
    signals = last.outputs.stop
    inner: dict[int, list[tuple[int, float]]] = {}
    outer = {outputs + j: [(j, 1.0)] for j in range(m)}
    for to, row in entries(wiring.output_map).items():
        inner[to] = [(k, gain) for k, gain in row if k < signals]
        outer[to] = [(k - signals, gain) for k, gain in row if k >= signals]
    n = outputs + m
    own = (*joined_wires(inner, 0, n, False), *joined_wires(outer, 0, n, True))
    at = last.inputs.stop
    node = Node(
        block,
        NAME,
        slice(last.states.stop, last.states.stop),
        slice(at, at + n),
        slice(signals, signals),
        own,
    )
    order = (*wiring.order, len(wiring.nodes))
    return Wiring((*wiring.nodes, node), order, m, wiring.output_map)
