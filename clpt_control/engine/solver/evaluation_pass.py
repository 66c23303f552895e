"""One pass over a diagram in Python: every signal once, in dependency order.

python-control finds the signals of a diagram by repeating all blocks until nothing changes.  A
sweep follows the wiring instead: it gathers the inputs of a block, calls its output function and
goes on; then it calls each update function.  It also knows which block and signal first became
non-finite.
"""

from collections.abc import Collection, Sequence
from typing import Any

import numpy as np

from ..diagram.wiring import Node, Wiring
from ..model.ports import reused_vector


class Sweep:
    """Evaluate a diagram's signals and state derivative.

    `parameters` are those of each block.  After a pass `signals` holds all block outputs.
    """

    def __init__(self, wiring: Wiring, parameters: Sequence[Any]):
        self.wiring, self.nodes, self.parameters = wiring, wiring.nodes, list(parameters)
        last = self.nodes[-1]
        self.nstates = last.states.stop
        self._states, self._inputs = np.zeros(self.nstates), np.zeros(last.inputs.stop)
        self.signals, self._external = np.zeros(last.outputs.stop), np.zeros(wiring.ninputs)
        self._fed = [self._views(node) for node in self.nodes]
        x, u = self._states, self._inputs  # are filled again and again
        self._x = [reused_vector(x[node.states], node.system._x) for node in self.nodes]
        self._u = [reused_vector(u[node.inputs], node.system._u) for node in self.nodes]
        feeding = np.zeros(len(self.signals), dtype=bool)
        for wire in (w for node in self.nodes for w in node.wires if not w.external):
            feeding[wire.source : wire.source + wire.size] = True
        self._all = [(k, self.signals[self.nodes[k].outputs]) for k in wiring.order]
        self._feeding = [one for one in self._all if feeding[self.nodes[one[0]].outputs].any()]
        self._moving = [k for k in wiring.order if self.nodes[k].system.nstates]
        self._current = list(parameters)  # with the interval that was entered
        systems = [node.system for node in self.nodes]
        self._breaking = [k for k, s in enumerate(systems) if s.breakpoints_function is not None]
        self._with_intervals = [k for k in self._breaking if not parameters[k].interval >= 0.0]
        self.jumping = [k for k, one in enumerate(systems) if one.jump_function is not None]
        self.guarded = any(one.guard is not None for one in systems)
        self.enter(0.0)

    def _views(self, node: Node) -> tuple[np.ndarray, list[tuple[np.ndarray, np.ndarray, float]]]:
        """View a block's inputs, and (input, source, gain) of each wire."""
        u, views = self._inputs[node.inputs], []
        for wire in node.wires:
            source = self._external if wire.external else self.signals
            to = u[wire.to : wire.to + wire.size]
            views.append((to, source[wire.source : wire.source + wire.size], wire.gain))
        return u, views

    def _gather(self, k: int) -> np.ndarray:
        """Compute a block's inputs from the signals."""
        u, views = self._fed[k]
        u.fill(0.0)
        for to, source, gain in views:
            to += source if gain == 1.0 else gain * source
        return self._u[k]

    def breakpoints(self, t0: float, t1: float) -> np.ndarray:
        """Return the times in (t0, t1] at which any block jumps, sorted.

        Times that differ by rounding alone are one time, the later.
        """
        nodes, given = self.nodes, self.parameters
        jumps = [nodes[k].system.breakpoints(t0, t1, given[k]) for k in self._breaking]
        if not jumps:
            return np.zeros(0)
        times = np.sort(np.concatenate(jumps))
        return times[np.diff(times, append=np.inf) > rounding(times)]

    def enter(self, t: float) -> None:
        """Set every block's `interval` to the one that holds t."""
        for k in self._with_intervals:
            interval = self.nodes[k].system.interval_at(t, self.parameters[k])
            self._current[k] = self.parameters[k]._replace(interval=interval)

    def evaluate(
        self, t: float, x: np.ndarray, u: np.ndarray | None = None, sampling: Collection[int] = ()
    ) -> np.ndarray:
        """Return all block outputs at (t, x, u), in an array that the next pass overwrites.

        Without `u` the inputs of the diagram are zero.  Blocks in `sampling` sample their inputs
        before their outputs are computed.
        """
        with np.errstate(all="ignore"):
            self._pass(np.float64(t), x, u, self._all, sampling)
        return self.signals

    def _pass(
        self, t: Any, x: np.ndarray, u: Any, blocks: list, sampling: Collection[int] = ()
    ) -> None:
        self._external[:] = 0.0 if u is None else u
        self._states[:] = x
        self.signals.fill(0.0)  # a block that is run twice reads what is not known yet
        for k, out in blocks:
            inputs = self._gather(k)
            if k in sampling:
                self._sample(k)
            self._call("output", k, t, self._x[k], inputs, out)

    def _sample(self, k: int) -> None:
        node = self.nodes[k]
        samples = slice(node.states.start + node.system.first_held, node.states.stop)
        self._states[samples] = self._gather(k)

    def derivative(self, t: float, x: np.ndarray, u: np.ndarray | None = None) -> np.ndarray:
        """Return the state derivative; NaN where a system could not compute it."""
        with np.errstate(all="ignore"):
            return self.rates(t, x, u, self._all)

    def rates(
        self, t: float, x: np.ndarray, u: np.ndarray | None = None, blocks: Any = None
    ) -> np.ndarray:
        """Return the state derivative; of the outputs only those that feed a block are computed."""
        t = np.float64(t)
        self._pass(t, x, u, blocks or self._feeding)
        dx = np.empty(self.nstates)
        for k in self._moving:  # a block may come before its inputs are known
            self._call("update", k, t, self._x[k], self._gather(k), dx[self.nodes[k].states])
        return dx

    def jump(
        self,
        t: float,
        x: np.ndarray,
        u: np.ndarray | None,
        blocks: Sequence[int],
        beginning: Sequence[int] = (),
    ) -> np.ndarray:
        """Return the states after these blocks jump together; x are the states before.

        Those that sample then sample their inputs, and so do the blocks in `beginning`.
        """
        self.evaluate(t, x, u)
        new, t = np.array(x, dtype=float), np.float64(t)
        with np.errstate(all="ignore"):
            for k in blocks:
                states = self.nodes[k].states
                self._call("jump", k, t, self._x[k], self._gather(k), new[states])
        sampling = [*beginning, *(k for k in blocks if self.nodes[k].system.first_held is not None)]
        if sampling:
            self.evaluate(t, new, u, sampling)
            for k in sampling:  # a block that feeds it may come after it in the order
                self._sample(k)
            new = self._states.copy()
        return new

    def _call(self, role: str, k: int, t: float, x: np.ndarray, u: np.ndarray, out: Any) -> None:
        out[:] = self.nodes[k].system.values(role, len(out), t, x, u, self._current[k])

    def fed(self, k: int) -> np.ndarray:
        """Return the inputs of a block at the last pass."""
        return np.array(self._gather(k))

    def outputs(self) -> np.ndarray:
        """Return the diagram's outputs of the last pass."""
        return self.wiring.output_map @ np.concatenate([self.signals, self._external])

    def margin(
        self, t: float, x: np.ndarray, u: np.ndarray | None = None
    ) -> tuple[float, str, str]:
        """Return the least distance to the edge of a guard, the guard's policy and its sentence."""
        self.evaluate(t, x, u)
        least = (np.inf, "", "")
        for k, node in enumerate(self.nodes):
            if (guard := node.system.guard) is not None:
                inputs, p = self._inputs[node.inputs], self._current[k]
                (distance,) = node.system.values("guard", 1, t, x[node.states], inputs, p)
                if not distance >= least[0]:
                    least = (float(distance), guard.policy, guard.message(t, inputs, p))
        return least

    def first_trouble(
        self, t: float, x: np.ndarray, u: np.ndarray | None = None, advice: str = ""
    ) -> str | None:
        """Return what is first not finite at (t, x, u), or the error that its block raised."""
        dx = self.derivative(t, x, u)
        ordered = [self.nodes[k] for k in self.wiring.order]
        for nodes, kind, values, role, what in (
            (self.nodes, "state", x, "jump", "state"),
            (ordered, "output", self.signals, "output", "signal"),
            (self.nodes, "state", dx, "update", "derivative of"),
        ):
            for node in nodes:
                system, own = node.system, values[getattr(node, f"{kind}s")]
                for label in np.array(getattr(system, f"{kind}_labels"))[~np.isfinite(own)]:
                    sentence = f"{what} {label} of block {node.name} is not finite; {advice}"
                    return system.raised.get(role) or sentence
        return None


def moved_to(jumps: np.ndarray, times: np.ndarray) -> np.ndarray:
    """Return times, of which those before a jump by rounding alone are moved to it."""
    following = np.append(jumps, np.inf)[np.searchsorted(jumps, times)]
    return np.where(following - times <= rounding(times), following, times)


def moved_back(jumps: np.ndarray, times: np.ndarray) -> np.ndarray:
    """Return jumps, of which those after a sample by rounding alone are moved to it."""
    before = times[np.searchsorted(times, jumps, side="right") - 1]
    return np.where(jumps - before <= rounding(jumps), before, jumps)


def rounding(times: Any) -> Any:
    """Return the largest difference between equal times that rounding can make."""
    return 1e-12 * np.maximum(1.0, np.abs(times))
