"""Whether what was read does what the functions do: asked at the run's own samples.

A record is compared with Python where the run begins and at three of its own samples, on its own
rates, signals and jumps; points chosen by chance do not reach every way through a function.
"""

import ctypes
from collections.abc import Iterator
from typing import Any

import numpy as np

from ..equations.arrays import Unread
from ..equations.at_many import leaf_values
from ..equations.block import Block
from .ending import Solution
from .inputs import Inputs
from .native_diagram import NativeDiagram
from .schedule import JUMPS

SAMPLES = 4
CLOSE = 1e-7  # relative: rounding of terms that cancel, not another way through a function
APART = (
    0.0,
    1e-6,
    -1e-6,
)  # where a sample lies on a kink, rounding decides; beside it nothing does
_CALL = ctypes.CFUNCTYPE(None, *[ctypes.c_void_p] * 6)


def difference(runner: NativeDiagram, solution: Solution, inputs: Inputs | None) -> str | None:
    """Return what was read otherwise than Python runs it, in words; None where all agrees."""
    if all(node.system.of_package for node in runner.wiring.nodes):
        return None
    n = len(solution.t)
    at = sorted({0, n // 3, 2 * n // 3, n - 1}) if n else []
    machine = _Machine(runner, solution, inputs, at)
    samples = [(k, float(solution.t[k]), solution.x[k]) for k in at]
    asked = zip(*[_python(runner, t, x, inputs) for _, t, x in samples], strict=True)
    own = zip(*[machine.ask(*one) for one in samples], strict=True)
    if all(_same(np.array(a), np.array(b)) for a, b in zip(asked, own, strict=False)):
        return None
    for k, t, x in samples:
        found = None
        for apart in APART:
            moved = x + apart * (1.0 + np.abs(x))
            found = _differs(runner, machine, k, t, moved, inputs)
            if found is None:
                break
        if found is not None:
            return found
    return None


class _Machine:
    """Signals, rates and jumps by machine code at single points."""

    def __init__(
        self, runner: NativeDiagram, solution: Solution, inputs: Inputs | None, at: list[int]
    ):
        self.pieces = runner.pieces_of(solution, inputs)
        number = np.searchsorted(self.pieces.edges, solution.t[at], side="right")
        self.number = dict(zip(at, number.tolist(), strict=True))
        self.P, self.T = np.append(runner.parameters(), 0.0), np.append(runner.layout.T, 0.0)
        program, self.held = runner.code.program, runner.held
        self.decided = program.decided
        room = max(runner.nstates, 2 * self.decided) + 1
        self.W, self.D = np.zeros(max(program.room, 1)), np.zeros(room)
        self.signals, self.states = runner.nsignals, runner.nstates
        self.t, self.x = np.zeros(1), np.zeros(runner.nstates + 1)
        given = self.t, self.x, self.P, self.T, self.W, self.D
        self.places = [one.ctypes.data for one in given]
        self.jumps = list(runner.layout.jumps.values())
        has = {"prepare": 1, "signals": 1, "decide": self.decided, "derivative": self.states}
        has["jump"] = len(self.jumps)
        self.own = {name: _CALL(runner.code.address(name, 1)) for name in has if has[name]}

    def ask(self, k: int, t: float, x: np.ndarray) -> list[np.ndarray]:
        """Return signals, rates and what every jump leaves at sample k, from states x."""
        self.P[self.pieces.places] = self.pieces.values[self.number[k]]
        self.t[0], self.x[: self.states], self.P[self.jumps] = t, x, JUMPS
        self.own["prepare"](*self.places)
        self.own["signals"](*self.places)
        found = [self.W[: self.signals].copy()]
        if self.decided:
            self.own["decide"](*self.places)
            self.P[self.held : self.held + self.decided] = self.D[: self.decided]
            self.own["prepare"](*self.places)
        for name in ("derivative", "jump"):
            if name in self.own:
                self.own[name](*self.places)
                found.append(self.D[: self.states].copy())
        return found


def _python(
    runner: NativeDiagram, t: float, x: np.ndarray, inputs: Inputs | None
) -> list[np.ndarray]:
    """Return signals, rates and what every jump leaves, by the functions themselves."""
    sweep, u = runner.sweep, None if inputs is None else inputs.at(t)
    sweep.enter(t)
    rates = sweep.derivative(t, x, u)
    found = [sweep.signals.copy(), rates]
    if sweep.leaping:
        found.append(sweep.leap(t, x, u, sweep.leaping))
    return found


def _differs(
    runner: NativeDiagram, machine: _Machine, k: int, t: float, x: np.ndarray, inputs: Any
) -> str | None:
    if all(map(_same, _python(runner, t, x, inputs), machine.ask(k, t, x))):
        return None
    runner.sweep.derivative(t, x, None if inputs is None else inputs.at(t))
    for node, role, sentence in _blocks(runner, t, x):
        return f"{node}.{role}{sentence}"
    return f"at t = {t:.6g} its rates are not those of its functions"


def _same(a: np.ndarray, b: np.ndarray) -> bool:
    """Whether numbers are the same but for rounding, beside the largest of their row."""
    if not a.size or np.array_equal(a, b):
        return True
    size = np.abs(a)
    largest = np.where(size < np.inf, size, 0.0).max(axis=-1, initial=1e-300, keepdims=True)
    near = np.abs(a - b) <= CLOSE * (size + 1e-3 * largest)
    return bool((near | (a == b) | (np.isnan(a) & np.isnan(b))).all())


def _blocks(runner: NativeDiagram, t: float, x: np.ndarray) -> Iterator[tuple[str, str, str]]:
    """Yield the blocks whose records differ from their functions, on the last pass's inputs."""
    sweep = runner.sweep
    for k, node in enumerate(runner.wiring.nodes):
        block, p = node.system, sweep.given[k]
        for role in ("output", "update", "jump"):
            if getattr(block, f"{role}_function") is None:
                continue
            states, u = x[node.states], sweep.fed(k)
            try:
                values = _of_record(block, role, t, states, u, p)
            except Unread:
                continue
            asked = block.values(role, len(values), t, states, u, p)
            if not _same(asked, values):
                yield node.name, role, " was read otherwise than Python runs it"


def _of_record(block: Block, role: str, t: float, x: Any, u: Any, p: Any) -> np.ndarray:
    """Return what a block's record gives."""
    found = block.array_record(role).values(leaf_values(block, t, x, u, p), block.sizes)
    return np.concatenate([np.zeros(0), *(one.ravel() for one in found)])
