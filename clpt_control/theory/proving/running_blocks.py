"""The blocks that run, asked for V and the rates of all states at many points.

`Functions` calls the blocks' own functions point by point, at first as python-control does;
`Records` computes what was read of them, which is what machine code runs, at all points at once.
"""

from collections.abc import Mapping
from typing import Any

import control
import numpy as np

from ...diagrams.interconnection import changed_parameters
from ...diagrams.wiring import Node, Wiring, wiring_of
from ...equations.at_many import on_arrays
from ...equations.block import Block
from ...errors import DiagramError
from ...native.sweep import Sweep
from .array_loop import blocks_of

THROUGH_CONTROL = 20  # points at which python-control gives the rates


class RunningBlocks:
    """A diagram one block of which makes V[1], and its two readings.

    They are asked at times (n,), states (n, nx) and inputs (n, nu).
    """

    def __init__(self, diagram: control.NonlinearIOSystem):
        self.wiring = wiring_of(diagram)
        self.blocks = blocks_of(self.wiring)
        made = [k for k, block in enumerate(self.blocks) if block.output_ports == {"V": 1}]
        if not made:
            raise DiagramError("no block makes V[1]; wire a candidate such as blocks.lyapunov")
        V = self.wiring.nodes[made[0]].outputs.start
        self.functions = Functions(diagram, self.wiring, V)
        self.records = Records(self.wiring, V)

    def set(self, params: Mapping[str, Any]) -> None:
        """Set the parameters with which the blocks run."""
        found = changed_parameters(self.wiring, params)
        self.functions.set(params, found)
        self.records.given = found


class Functions:
    """The blocks' functions, called as python-control does, then in the order of the wiring."""

    def __init__(self, diagram: control.NonlinearIOSystem, wiring: Wiring, V: int):
        self.diagram, self.wiring, self.V = diagram, wiring, V
        self.left = THROUGH_CONTROL

    def set(self, params: Mapping[str, Any], found: list[Any]) -> None:
        """Set parameters: as python-control takes them, and those of each block."""
        self.params, self.sweep = dict(params), Sweep(self.wiring, found)

    def rates(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Return the rates of all states, (n, nx); NaN where there are none."""
        return np.array([self._rates(*point) for point in zip(t, x, u, strict=True)])

    def _rates(self, t: float, x: np.ndarray, u: np.ndarray) -> np.ndarray:
        self.left -= 1
        if self.left < 0:
            self.sweep.enter(t)
            return self.sweep.derivative(t, x, u)
        self.diagram._update_params(self.params)  # anew, for the interval
        try:
            return self.diagram._rhs(t, x, u)
        except RuntimeError:  # python-control's word for a NaN on its way
            return np.full(len(x), np.nan)

    def values(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Return V, (n,)."""
        return np.array([self._value(*point) for point in zip(t, x, u, strict=True)])

    def _value(self, t: float, x: np.ndarray, u: np.ndarray) -> float:
        self.sweep.enter(t)
        return float(self.sweep.evaluate(t, x, u)[self.V])


class Records:
    """The blocks' records on arrays, those alone that are needed, in the order of the wiring."""

    def __init__(self, wiring: Wiring, V: int):
        self.wiring, self.V = wiring, V
        self.given: list[Any] = []  # parameters of each block
        nodes = wiring.nodes
        self.moving = [k for k, node in enumerate(nodes) if node.system.nstates]
        level = [k for k, node in enumerate(nodes) if node.outputs.start == V]
        self.for_rates, self.for_V = (_ancestors(wiring, own) for own in (self.moving, level))

    def rates(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Return the rates of all states, (n, nx); NaN where there are none."""
        signals, found = self._signals(self.for_rates, t, x, u), np.empty(x.shape)
        for node, p in self._of(self.moving):
            given = t, x.T[node.states], _fed(node, signals, u), _at_times(node.system, p, t)
            found.T[node.states] = on_arrays(node.system, "update", *given)
        return found

    def values(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Return V, (n,)."""
        return self._signals(self.for_V, t, x, u)[self.V]

    def _of(self, blocks: Any) -> Any:
        return ((self.wiring.nodes[k], self.given[k]) for k in blocks)

    def _signals(self, needed: set[int], t: np.ndarray, x: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Return all that is put out, of the blocks that are needed."""
        signals = np.zeros((self.wiring.nodes[-1].outputs.stop, len(t)))
        for node, p in self._of(k for k in self.wiring.order if k in needed):
            block, own = node.system, x.T[node.states]
            if not block.states_are_outputs:
                given = t, own, _fed(node, signals, u), _at_times(block, p, t)
                own = on_arrays(block, "output", *given)
            signals[node.outputs] = own
        return signals


Reading = Functions | Records


def _fed(node: Node, signals: np.ndarray, u: np.ndarray) -> np.ndarray:
    """Return the inputs of a block, (inputs, n)."""
    found = np.zeros((node.system.ninputs, len(u)))
    for wire in node.wires:
        source = (u.T if wire.external else signals)[wire.source : wire.source + wire.size]
        found[wire.to : wire.to + wire.size] += wire.gain * source
    return found


def _at_times(block: Block, p: Any, t: np.ndarray) -> Any:
    """Return parameters with the interval in which each time lies, where a block counts them."""
    if block.breakpoints_function is None or p.interval >= 0:
        return p
    return p._replace(interval=np.array([block.interval_at(one, p) for one in t]))


def _ancestors(wiring: Wiring, own: list[int]) -> set[int]:
    """Return blocks and all that what they put out, and their rates, are made of."""
    made = np.repeat(
        np.arange(len(wiring.nodes)), [node.system.noutputs for node in wiring.nodes]
    ).tolist()
    found, stack = set(own), list(own)
    while stack:
        k = stack.pop()
        read = k in own or wiring.nodes[k].system.feedthrough
        for wire in wiring.nodes[k].wires if read else ():
            for other in set(made[wire.source : wire.source + wire.size]) - found:
                if not wire.external:
                    found.add(other)
                    stack.append(other)
    return found
