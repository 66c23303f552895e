"""A diagram's equations in another library's algebra, from the functions that run.

heyoka and diffrax get their right-hand sides by calling each block's own update
and output on their expressions, through the diagram's wiring: no equation is
written a second time.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np

from clpt_control.blocks.readers import rebind
from clpt_control.wiring import read


def boxed(values: Any) -> np.ndarray:
    """Put expressions into an array one by one; NumPy shall not look inside them."""
    array = np.empty(len(values), dtype=object)
    for i in range(len(values)):
        array[i] = values[i]
    return array


def rates(
    diagram: Any,
    t: Any,
    x: list,
    words: Mapping[str, Any],
    given: Mapping[str, list],
    parameters: Mapping[tuple[str, str], Any] | None = None,
) -> list:
    """Call a diagram's equations on expressions; give the state derivatives.

    Parameters
    ----------
    diagram : control.InterconnectedSystem
        Blocks, wired.
    t : expression
        Time.
    x : list of expressions
        States.
    words : mapping
        What ``math`` (and other words) mean in that algebra.
    given : mapping
        Outputs of blocks that are not traced: ``{"reference": [zc1, zc2]}``.
    parameters : mapping, optional
        Expressions in place of numbers: ``{("adaptation", "gain"): gamma}``.

    Returns
    -------
    list of expressions
        dx/dt.
    """
    wiring = read(diagram)
    states = boxed(x)
    signals = np.full(wiring.nodes[-1].outputs.stop, 0.0, dtype=object)
    derivative = np.full(len(x), 0.0, dtype=object)

    def inputs(node) -> np.ndarray:
        u = np.full(node.system.ninputs, None, dtype=object)
        for wire in node.wires:
            for i in range(wire.size):
                one = signals[wire.source + i]
                one = one if wire.gain == 1 else wire.gain * one
                at = wire.to + i
                u[at] = one if u[at] is None else u[at] + one
        u[[value is None for value in u]] = 0.0
        return u

    changed: dict[str, dict] = {}
    for (block, field), value in (parameters or {}).items():
        changed.setdefault(block, {})[field] = value

    def call(function, node, out) -> None:
        p = node.system.parameters
        p = p._replace(**changed[node.name]) if node.name in changed else p
        rebind(function, words)(t, states[node.states], inputs(node), p, out)

    nodes = [wiring.nodes[k] for k in wiring.order]
    for node in nodes:
        if node.name in given:
            signals[node.outputs] = boxed(given[node.name])
        else:
            call(node.system.output_function, node, signals[node.outputs])
    for node in nodes:
        if node.system.nstates:
            call(node.system.update_function, node, derivative[node.states])
    return list(derivative)
