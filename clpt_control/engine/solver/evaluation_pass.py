"""One pass over a diagram in Python: every signal once, in dependency order.

python-control finds the signals of a diagram by repeating all blocks until nothing changes.  A
sweep follows the wiring instead: it gathers the inputs of a block, calls its output function and
goes on; then it calls each update function.  It also knows which block and signal first became
non-finite.
"""

from collections.abc import Collection, Sequence
from typing import Any

import numpy as np
from numpy import ndarray

from ...base.arguments import attribute_of
from ...base.errors import SimulationError
from ..diagram.wiring import Node, Wiring
from ..model.ports import reused_vector

External = ndarray | None  # inputs of the diagram; zero without


class Sweep:
    """Evaluate a diagram's signals and state derivative.

    `parameters` are those of each block.  After a pass `signals` holds all block outputs.
    """

    def __init__(self, wiring: Wiring, parameters: Sequence[Any]):
        self.wiring = wiring
        self.nodes = wiring.nodes
        self.parameters = list(parameters)
        self._current = list(parameters)  # with the interval that was entered
        # arrays that each pass overwrites
        last = self.nodes[-1]
        self.nstates = last.states.stop
        self._states = np.zeros(self.nstates)
        self._inputs = np.zeros(last.inputs.stop)
        self.signals = np.zeros(last.outputs.stop)
        self._external = np.zeros(wiring.ninputs)
        # views of each block's states and inputs
        self._feeds = [self._views(node) for node in self.nodes]
        self._x = []
        self._u = []
        for node in self.nodes:
            x = self._states[node.states]
            u = self._inputs[node.inputs]
            self._x.append(reused_vector(x, node.system._x))
            self._u.append(reused_vector(u, node.system._u))
        # blocks by what they do
        systems = [node.system for node in self.nodes]
        outputs = [self.signals[node.outputs] for node in self.nodes]
        self._blocks = [(k, outputs[k]) for k in wiring.order]
        self._moving = [k for k in wiring.order if systems[k].nstates]
        breaking = [system.breakpoints_function is not None for system in systems]
        self.breaking = np.flatnonzero(breaking).tolist()
        self.with_intervals = [
            k for k in self.breaking if not parameters[k].interval >= 0.0
        ]
        jumping = [system.jump_function is not None for system in systems]
        self.jumping = np.flatnonzero(jumping).tolist()
        guarded = [system.guard is not None for system in systems]
        self.guarded = np.flatnonzero(guarded).tolist()
        # names of blocks that jump at a level
        self.resetting = [
            node.name for node in self.nodes if node.system.jumps_at_level
        ]
        # block -> its breakpoints, of blocks that an input of the diagram triggers
        self.triggered: dict[int, ndarray] = {}
        self.enter(0.0)

    def _views(self, node: Node) -> tuple[ndarray, list[tuple]]:
        """View a block's inputs, and (input, source, gain) of each wire."""
        u = self._inputs[node.inputs]
        views = []
        for wire in node.wires:
            signals = self._external if wire.external else self.signals
            to = u[wire.to : wire.to + wire.size]
            source = signals[wire.source : wire.source + wire.size]
            views.append((to, source, wire.gain))
        return u, views

    def _gather(self, k: int) -> ndarray:
        """Compute a block's inputs from the signals."""
        u, views = self._feeds[k]
        u.fill(0.0)
        for to, source, gain in views:
            to += source if gain == 1.0 else gain * source
        return self._u[k]

    def breakpoints(self, t0: float, t1: float) -> ndarray:
        """Return the times in (t0, t1] at which any block jumps, sorted.

        Times that differ by rounding alone are one time, the later.
        """
        jumps = [self.block_breakpoints(k, t0, t1) for k in self.breaking]
        if not jumps:
            return np.zeros(0)
        times = np.sort(np.concatenate(jumps))
        spans = np.diff(times, append=np.inf)
        return times[spans > rounding(times, t1 - t0)]

    def block_breakpoints(self, k: int, t0: float, t1: float) -> ndarray:
        """Return the times in (t0, t1] at which a block jumps."""
        times = self.triggered.get(k)
        if times is None:
            return self.nodes[k].system.breakpoints(t0, t1, self.parameters[k])
        return times[(times > t0) & (times <= t1)]

    def interval_of(self, k: int, t: float) -> float:
        """Return the number of a block's interval that holds t."""
        times = self.triggered.get(k)
        if times is None:
            return self.nodes[k].system.interval_at(t, self.parameters[k])
        return float(np.searchsorted(times, t, side="right"))

    def trigger(self, inputs: Any) -> None:
        """Set the breakpoints of blocks that jump where an input of the diagram rises."""
        self.triggered = {}
        for k in self.breaking:
            node = self.nodes[k]
            trigger = attribute_of(node.system.breakpoints_function, "trigger")
            signal = None if trigger is None else node.external_input(trigger)
            if signal is None:
                continue
            rises = inputs.rises(signal)
            if rises is not None:
                if not len(rises) and np.any(inputs.samples[1][signal]):
                    raise SimulationError(
                        f"{trigger}: never rises above 1/2, so {node.name} sees no event. Give a "
                        "pulse, 1 at the time of an event and 0 before it"
                    )
                after = node.system.breakpoints_function.after
                self.triggered[k] = after(self.parameters[k], rises)

    def enter(self, t: float) -> None:
        """Set every block's `interval` to the one that holds t."""
        for k in self.with_intervals:
            self.enter_interval(k, self.interval_of(k, t))

    def enter_interval(self, k: int, interval: float) -> None:
        """Set the `interval` of a block."""
        if self._current[k].interval != interval:
            self._current[k] = self.parameters[k]._replace(interval=interval)

    def evaluate(
        self, t: float, x: ndarray, u: External = None, sampling: Collection[int] = ()
    ) -> ndarray:
        """Return all block outputs at (t, x, u), in an array that the next pass overwrites.

        Without `u` the inputs of the diagram are zero.  Blocks in `sampling` sample their inputs
        before their outputs are computed.
        """
        with np.errstate(all="ignore"):
            self._pass(np.float64(t), x, u, sampling)
        return self.signals

    def _pass(
        self, time: Any, x: ndarray, u: External, sampling: Collection[int] = ()
    ) -> None:
        self._external[:] = 0.0 if u is None else u
        self._states[:] = x
        self.signals.fill(0.0)  # a block that is run twice reads what is not known yet
        for k, out in self._blocks:
            inputs = self._gather(k)
            if k in sampling:
                self._sample(k)
            self._call("output", k, time, self._x[k], inputs, out)

    def _sample(self, k: int) -> None:
        node = self.nodes[k]
        begin = node.states.start + node.system.first_held
        self._states[begin : node.states.stop] = self._gather(k)

    def derivative(self, t: float, x: ndarray, u: External = None) -> ndarray:
        """Return the state derivative; NaN where a system could not compute it."""
        dx = np.empty(self.nstates)
        time = np.float64(t)
        with np.errstate(all="ignore"):
            self._pass(time, x, u)
            for k in self._moving:  # a block may come before its inputs are known
                inputs = self._gather(k)
                rates = dx[self.nodes[k].states]
                self._call("update", k, time, self._x[k], inputs, rates)
        return dx

    def jump(
        self,
        t: float,
        x: ndarray,
        u: External,
        blocks: Sequence[int],
        beginning: Sequence[int] = (),
    ) -> ndarray:
        """Return the states after these blocks jump together; x are the states before.

        Those that sample then sample their inputs, and so do the blocks in `beginning`.
        """
        self.evaluate(t, x, u)
        states = np.array(x, dtype=float)
        time = np.float64(t)
        with np.errstate(all="ignore"):
            for k in blocks:
                inputs = self._gather(k)
                jumped = states[self.nodes[k].states]
                self._call("jump", k, time, self._x[k], inputs, jumped)
        sampling = [*beginning]
        sampling += [k for k in blocks if self.nodes[k].system.first_held is not None]
        if not sampling:
            return states
        self.evaluate(t, states, u, sampling)
        for k in sampling:  # a block that feeds it may come after it in the order
            self._sample(k)
        return self._states.copy()

    def results(self, t: float, x: ndarray, u: External, run: float) -> list[ndarray]:
        """Return signals, then rates, states after all jumps and distances of guards, if any.

        They are those right after t in a run of the length `run`.
        """
        if self.with_intervals:
            self.enter(t + rounding(t, run))
        rates = self.derivative(t, x, u)
        results = [self.signals.copy()]
        if self.nstates:
            results.append(rates)
        if self.jumping:
            results.append(self.jump(t, x, u, self.jumping))
        if self.guarded:
            results.append(np.array(self.distances(t, x, u)))
        return results

    def _call(
        self, role: str, k: int, t: float, x: ndarray, u: ndarray, out: Any
    ) -> None:
        system = self.nodes[k].system
        parameters = self._current[k]
        out[:] = system.values(role, len(out), t, x, u, parameters)

    def fed(self, k: int) -> ndarray:
        """Return the inputs of a block at the last pass."""
        return np.array(self._gather(k))

    def outputs(self) -> ndarray:
        """Return the diagram's outputs of the last pass."""
        return self.wiring.outputs_of(self.signals, self._external)

    def margin(
        self, t: float, x: ndarray, u: External = None
    ) -> tuple[float, str, str]:
        """Return the least distance to the edge of a guard, the guard's policy and its sentence."""
        distances = self.distances(t, x, u)
        least = int(np.argmin(distances))  # the first NaN, if any
        distance, k = distances[least], self.guarded[least]
        node = self.nodes[k]
        if np.isnan(distance):
            sentence = f"the distance of the guard of {node.name} is not a number at t = {t:.9g}"
            return distance, "raise", sentence
        guard: Any = node.system.guard
        sentence = guard.message(t, self._inputs[node.inputs], self._current[k])
        return distance, guard.policy, sentence

    @np.errstate(all="ignore")
    def distances(self, t: float, x: ndarray, u: External = None) -> list[float]:
        """Return the distances to the edges of guards."""
        self.evaluate(t, x, u)
        distances = []
        for k in self.guarded:
            node = self.nodes[k]
            arguments = x[node.states], self._gather(k), self._current[k]
            (distance,) = node.system.values("guard", 1, t, *arguments)
            distances.append(float(distance))
        return distances

    def first_trouble(
        self, t: float, x: ndarray, u: External, advice: str
    ) -> str | None:
        """Return what is first not finite at (t, x, u), or the error that its block raised."""
        dx = self.derivative(t, x, u)
        results = [(node, "jump", x[node.states]) for node in self.nodes]
        for k in self.wiring.order:
            node = self.nodes[k]
            results.append((node, "output", self.signals[node.outputs]))
        results += [(node, "update", dx[node.states]) for node in self.nodes]
        described = dict(DESCRIPTIONS)
        if self.wiring.dt:
            described["update"] = "next state"
        for node, role, values in results:
            system = node.system
            labels = system.output_labels if role == "output" else system.state_labels
            for label in np.array(labels)[~np.isfinite(values)]:
                name = f"{described[role]} {label} of block {node.name}"
                return system.raised.get(role) or f"{name} is not finite; {advice}"
        return None


# of results
DESCRIPTIONS = {"jump": "state", "output": "signal", "update": "derivative of"}


def rounding(times, run):
    """Return the largest difference between equal times that rounding can make in a run."""
    return 1e-12 * np.maximum(run, np.abs(times))
