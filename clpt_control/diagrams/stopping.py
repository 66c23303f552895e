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
from .wiring import Node, Wiring, joined_wires

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

    last, m, outputs = wiring.nodes[-1], wiring.ninputs, len(wiring.outputs)
    block = Block(
        NAME,
        output=lambda t, x, u, p: {},
        inputs={"y": outputs, "u": m},
        outputs={},
        guard=Guard(distance, "stop", sentence),
    )
    signals = last.outputs.stop
    fed = [*wiring.outputs, *({~j: 1.0} for j in range(m))]
    at = last.inputs.stop
    node = Node(
        block,
        NAME,
        slice(last.states.stop, last.states.stop),
        slice(at, at + len(fed)),
        slice(signals, signals),
        joined_wires(fed),
    )
    order = (*wiring.order, len(wiring.nodes))
    return Wiring((*wiring.nodes, node), order, m, wiring.outputs)
