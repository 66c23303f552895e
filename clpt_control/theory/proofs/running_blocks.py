"""The blocks of a diagram as they run, evaluated at many points.

By python-control, as a user calls them; or by their records, which machine code runs, at all points
at once.
"""

from typing import Any

import control
import numpy as np

from ...engine.diagram.wiring import wiring_of
from ...engine.model.on_arrays import on_arrays
from ...engine.solver.evaluation_pass import Sweep

# rates (n, nx) and V (n,); NaN where there are none
Values = tuple[np.ndarray, np.ndarray]


class RunningBlocks:
    """The blocks of a diagram as they run, with an output V, "" for none.

    Times are (n,), states (n, nx) and inputs (n, nu).
    """

    def __init__(self, system: control.NonlinearIOSystem, V: str = "V[0]"):
        self.system, self.wiring = system, wiring_of(system)
        self.V = [system.output_labels.index(V)] if V else []
        self.sweep = Sweep(
            self.wiring, [node.system.parameters for node in self.wiring.nodes]
        )

    def by_control(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> Values:
        """Return rates and V as python-control computes them."""
        system = self.system
        system._update_params({})  # once: it takes as long as the equations

        def at_point(*point: Any) -> tuple:
            if self.sweep.jumping:  # its states may jump between one point and the next
                system._update_params({})
            try:
                return system._rhs(*point), *(
                    system._out(*point)[self.V] if self.V else [0.0]
                )
            except RuntimeError:  # python-control's word for a NaN on its way
                return np.full(system.nstates, np.nan), np.nan

        with np.errstate(all="ignore"):
            rates, V = zip(*map(at_point, t, x, u), strict=True)
        return np.array(rates), np.array(V, dtype=float)

    def by_records(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> Values:
        """Return rates and V of the blocks' records at all points at once."""
        signals, rates = self.signals(t, x, u), np.empty(x.shape)
        for k, node in enumerate(self.wiring.nodes):
            if node.system.nstates:
                rates.T[node.states] = self._values_of(k, "update", signals, t, x, u)
        V = np.zeros(len(t))
        for place in self.V:
            for k, gain in self.wiring.outputs[place].items():
                V += gain * (signals[k] if k >= 0 else u.T[~k])
        return rates, V

    def signals(self, t: np.ndarray, x: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Return the outputs of all blocks, block by block, shape (outputs, n)."""
        nodes = self.wiring.nodes
        signals = np.zeros((nodes[-1].outputs.stop, len(t)))
        for k in self.wiring.order:
            signals[nodes[k].outputs] = self._values_of(k, "output", signals, t, x, u)
        return signals

    def _values_of(
        self, k: int, role: str, signals: np.ndarray, t: Any, x: Any, u: Any
    ) -> np.ndarray:
        """Return the outputs or the rates of block k, of signals that are known."""
        node, p = self.wiring.nodes[k], self.sweep.parameters[k]
        block = node.system
        if block.breakpoints_function is not None and p.interval < 0:
            p = p._replace(
                interval=np.array([block.interval_at(time, p) for time in t])
            )
        fed = np.zeros((block.ninputs, len(t)))
        for wire in node.wires:
            source = (u.T if wire.external else signals)[
                wire.source : wire.source + wire.size
            ]
            fed[wire.to : wire.to + wire.size] += wire.gain * source
        return on_arrays(block, role, t, x.T[node.states], fed, p)
