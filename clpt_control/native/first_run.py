"""A run before anything is compiled: it begins in Python, and is compiled where that pays.

Compiling the solver takes some ten seconds, once for a machine, so a short run is over
sooner in Python.  What Python does is counted, not timed: a diagram's `effort` is the
number of operations that one pass over its blocks takes, and every evaluation is a pass, as is
every sample.  With the work done when a share s of the time is over,

    ahead = work (1 - s)/s + effort * samples

and the run is begun anew as machine code once all that Python did in this process, and
what is ahead, come to more than compiling is `WORTH`.  So one engine makes all numbers of
a run, and the same calls are answered by the same engines on every machine.
"""

import warnings
from collections.abc import Mapping
from contextlib import suppress
from typing import Any

import numpy as np

from ..blocks.tracers import TooLong
from ..diagrams.wiring import Wiring
from ..equations.block import Block
from ..errors import Uncompiled
from . import solver
from .batch import Batch
from .ending import Solution
from .python_diagram import PythonDiagram

WORTH = 6e7  # operations in Python that compiling is worth
LOOKED = 0.1  # share of WORTH that a run does before its pace says anything
CALL = 60  # operations that calling one block is worth
STEP = 14  # evaluations of a step, and a few


class FirstRun(PythonDiagram):
    """A diagram that runs in Python until machine code pays."""

    most = 500_000_000  # as of machine code, for which it may be given up
    done = 0.0  # operations by all first runs of this process

    def __init__(self, wiring: Wiring, params: Mapping[str, Any] | None, name: str):
        super().__init__(wiring, params)
        self._params, self._name = params, name
        self._effort = effort(wiring)
        self.tries = int(np.clip(0.5 * LOOKED * WORTH / (STEP * self._effort), 1, 64))
        self._after: PythonDiagram | None = None  # what runs once machine code pays

    def run(self, x0: Any, times: Any, **given: Any) -> Solution:
        """Integrate, in Python or anew as machine code."""
        self._sampling, self._counted = self._effort * np.size(times), 0.0
        with suppress(_Pays):
            self._compile_if(self._sampling)
            return super().run(x0, times, **given)
        assert self._after is not None
        return self._after.run(x0, times, **given)

    def looked(self, batch: Batch) -> None:
        """Begin anew as machine code where that pays."""
        work = self._effort * float(batch.counts[0, solver.EVALUATIONS])
        self._add(work - self._counted)
        self._counted = work
        first, last = batch.times[0], batch.times[-1]
        share = max((batch.now - first) / (last - first), 1e-12)
        if work >= LOOKED * WORTH:
            self._compile_if(work * (1.0 - share) / share + self._sampling)

    def signals(self, solution: Solution, inputs: Any = None) -> np.ndarray:
        """Return all block outputs by the engine that ran."""
        if self._after is not None:
            return self._after.signals(solution, inputs)
        self._add(self._sampling)
        return super().signals(solution, inputs)

    def _add(self, work: float) -> None:
        FirstRun.done += work

    def _compile_if(self, ahead: float) -> None:
        """Go over to machine code where what is ahead makes it pay."""
        if self._after is None:
            if FirstRun.done + ahead < WORTH:
                return
            self._after = compiled(self.wiring, self._params, self._name)
        raise _Pays


class _Pays(Exception):
    """Machine code pays."""


def effort(wiring: Wiring) -> float:
    """Return how many operations one pass over a diagram takes."""
    total = 0.0
    for node in wiring.nodes:
        total += CALL
        if isinstance(node.system, Block):
            total += sum(_length(node.system, role) for role in ("output", "update"))
    return total


def _length(block: Block, role: str) -> int:
    try:
        record = block.output_record if role == "output" else block.update_record
    except TooLong:
        return 10_000
    return 0 if record is None else len(record.operations)


def compiled(wiring: Wiring, params: Mapping[str, Any] | None, name: str) -> PythonDiagram:
    """Return a diagram as machine code; in Python, with a warning, what cannot be compiled."""
    from .native_diagram import NativeDiagram

    try:
        return NativeDiagram(wiring, params)
    except Uncompiled as error:
        warnings.warn(f"{name} runs in Python, not as machine code: {error}", stacklevel=5)
        return PythonDiagram(wiring, params)
