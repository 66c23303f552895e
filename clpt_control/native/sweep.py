"""One pass over a diagram: every signal once, in dependency order.

python-control finds the signals of a diagram by repeating all blocks until
nothing changes.  A sweep follows the wiring instead: gather a block's inputs,
call its output, go on; then call each update.  It also knows which block and
signal first became non-finite.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import control
import numpy as np

from ..blocks import Block
from ..wiring import Node, read

TROUBLE = (OverflowError, ValueError, ZeroDivisionError, FloatingPointError)


class Sweep:
    """Evaluate a diagram's signals and state derivative.

    Parameters
    ----------
    diagram : control.NonlinearIOSystem
        Any interconnected system; blocks are called through their functions.
    params : mapping, optional
        Call-time parameters by qualified name.

    Attributes
    ----------
    signals : ndarray
        All block outputs of the last pass.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario()
    >>> sweep = Sweep(clpt.closed_loop(scenario))
    >>> sweep.derivative(0.0, clpt.initial_state(scenario)).shape
    (14,)
    """

    def __init__(self, diagram: control.NonlinearIOSystem, params: Mapping[str, Any] | None = None):
        diagram._update_params(params)
        self.wiring = read(diagram)
        self.nodes = self.wiring.nodes
        self.nstates = self.nodes[-1].states.stop
        self.signals = np.zeros(self.nodes[-1].outputs.stop)
        self._inputs = np.zeros(self.nodes[-1].inputs.stop)
        self._rates = np.zeros(self.nstates)
        self._external = np.zeros(diagram.ninputs or 0)
        self._parameters: list[Any] = [
            node.system._current if isinstance(node.system, Block) else None for node in self.nodes
        ]
        self.given = list(self._parameters)
        self._pinned = [
            p is not None and getattr(p, "interval", 0.0) >= 0.0 for p in self._parameters
        ]
        self._plan = [(k, self.nodes[k]) for k in self.wiring.order]
        self._wires = {k: self._views(node) for k, node in self._plan}
        self.enter(0.0)

    def _views(self, node: Node) -> tuple[bool, list[tuple[np.ndarray, np.ndarray, float]]]:
        """Tell whether wires meet at one input, and view each (input, source, gain)."""
        block_inputs = self._inputs[node.inputs]
        count = np.zeros(len(block_inputs), dtype=int)
        views = []
        for wire in node.wires:
            to = slice(wire.to, wire.to + wire.size)
            source = self._external if wire.external else self.signals
            count[to] += 1
            views.append(
                (block_inputs[to], source[wire.source : wire.source + wire.size], wire.gain)
            )
        return bool(np.any(count > 1)), views

    def _gather(self, k: int) -> np.ndarray:
        """Bring a block's inputs up to date from the signals."""
        block_inputs = self._inputs[self.nodes[k].inputs]
        meet, views = self._wires[k]
        if meet:
            block_inputs[:] = 0.0
        for to, source, gain in views:
            if meet:
                to += gain * source
            else:
                to[:] = source if gain == 1.0 else gain * source
        return block_inputs

    def breakpoints(self, t0: float, t1: float) -> np.ndarray:
        """Give the times in (t0, t1] at which any block jumps, sorted.

        Times that differ by rounding alone are one time, the later.
        """
        jumps = [
            node.system.breakpoints(t0, t1, p)
            for node, p in zip(self.nodes, self.given, strict=True)
            if isinstance(node.system, Block) and node.system.breakpoints_function is not None
        ]
        times = np.unique(np.concatenate([np.zeros(0), *jumps]))
        apart = np.append(np.diff(times) > 1e-12 * np.maximum(1.0, np.abs(times[1:])), True)
        return times[apart[-len(times) :]] if len(times) else times

    def enter(self, t: float) -> None:
        """Set every block's `interval` to the one that holds t."""
        for k, node in enumerate(self.nodes):
            block = node.system
            if isinstance(block, Block) and block.breakpoints_function and not self._pinned[k]:
                p = self._parameters[k]
                interval = block.interval_at(t, self.given[k])
                self._parameters[k] = p._replace(interval=interval)

    def use(self, parameters: Sequence[Any]) -> None:
        """Take other parameters of the same blocks, in wiring order."""
        self.given = list(parameters)
        self._parameters = list(parameters)
        self.enter(0.0)

    def evaluate(self, t: float, x: np.ndarray, u: np.ndarray | None = None) -> np.ndarray:
        """Compute all block outputs at (t, x, u) in the interval.

        Parameters
        ----------
        t : float
            Time.
        x : ndarray
            State of the diagram.
        u : ndarray, optional
            Inputs of the diagram.

        Returns
        -------
        ndarray
            `signals`; overwritten by the next call.
        """
        if u is not None:
            self._external[:] = u
        for k, node in self._plan:
            system, y = node.system, self.signals[node.outputs]
            block_inputs = self._gather(k)
            try:
                if isinstance(system, Block):
                    system.output_function(t, x[node.states], block_inputs, self._parameters[k], y)
                else:
                    y[:] = system._out(t, x[node.states], block_inputs)
            except TROUBLE:
                y[:] = np.nan
        return self.signals

    def derivative(self, t: float, x: np.ndarray, u: np.ndarray | None = None) -> np.ndarray:
        """Compute the state derivative; a new array.

        Parameters
        ----------
        t : float
            Time.
        x : ndarray
            State of the diagram.
        u : ndarray, optional
            Inputs of the diagram.

        Returns
        -------
        ndarray
            dx/dt; NaN where a block could not compute it.
        """
        self.evaluate(t, x, u)
        dx = np.zeros(self.nstates)
        # a block without feedthrough may come before its inputs are known
        for k, node in self._plan:
            system = node.system
            if not system.nstates:
                continue
            block_inputs = self._gather(k)
            try:
                if isinstance(system, Block):
                    assert system.update_function is not None
                    system.update_function(
                        t, x[node.states], block_inputs, self._parameters[k], dx[node.states]
                    )
                else:
                    dx[node.states] = system._rhs(t, x[node.states], block_inputs)
            except TROUBLE:
                dx[node.states] = np.nan
        return dx

    def outputs(self, u: np.ndarray | None = None) -> np.ndarray:
        """Give the diagram's outputs of the last pass."""
        return self.wiring.output_map @ np.concatenate([self.signals, self._external])

    def first_trouble(self, t: float, x: np.ndarray, u: np.ndarray | None = None) -> str | None:
        """Name the first block and signal not finite at (t, x, u)."""
        with np.errstate(all="ignore"):
            dx = self.derivative(t, x, u)
        for node in self.nodes:
            for state, label in zip(x[node.states], node.system.state_labels, strict=True):
                if not np.isfinite(state):
                    return f"state {label} of block {node.name}"
        for _, node in self._plan:
            for value, label in zip(
                self.signals[node.outputs], node.system.output_labels, strict=True
            ):
                if not np.isfinite(value):
                    return f"signal {label} of block {node.name}"
        for node in self.nodes:
            for value, label in zip(dx[node.states], node.system.state_labels, strict=True):
                if not np.isfinite(value):
                    return f"derivative of {label} of block {node.name}"
        return None

    def guards(self) -> list[tuple[Node, Any]]:
        """Give the guarded blocks with their parameters."""
        return [
            (node, self._parameters[k])
            for k, node in enumerate(self.nodes)
            if isinstance(node.system, Block) and node.system.guard is not None
        ]

    def inputs_of(self, node: Node) -> np.ndarray:
        """Give a block's inputs of the last pass."""
        return self._inputs[node.inputs]
