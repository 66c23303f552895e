"""Choose the engine: machine code, or Python for a diagram that cannot be compiled or was misread.

The model alone decides, never the content of a cache: the same script gives the same numbers.  What
was read is compared with the functions where the run begins and at three of its own samples: rates,
signals and jumps.  Points drawn at random would not reach every branch of a function.
"""

import os
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy import ndarray

from ...base.errors import SimulationError, Uncompiled
from ...base.progress import warn
from ..codegen.machine import ENGINE
from ..conformance.confirmation import differ
from ..diagram.wiring import Wiring
from ..record.unread import Unread
from ..trace.arrays import OUTLIVES
from .inputs import Inputs
from .native_diagram import NativeDiagram
from .runner import Runner, RunOptions
from .schedule import Schedule
from .solver_layout import Status
from .termination import Solution

ENGINES = ("native", "python")


def make_runner(
    wiring: Wiring,
    engine: str | None = None,
    name: str = "the diagram",
    apart: Mapping[tuple[int, str], Any] = {},
) -> Runner:
    """Return a diagram ready to run, compiled if possible; `apart` as `lay_out` takes it.

    A diagram that cannot be compiled runs in Python, with a warning that calls it by `name`.
    """
    choice = engine or os.environ.get(ENGINE) or "native"
    if choice not in ENGINES:
        origin = "engine" if engine else f"the environment variable {ENGINE}"
        raise SimulationError(
            f"{origin} = '{choice}': must be one of {', '.join(ENGINES)}"
        )
    if choice == "native":
        try:
            return NativeDiagram(wiring, apart=apart)
        except Uncompiled as error:
            warn_python(name, str(error))
    from .python_diagram import PythonDiagram

    runner = PythonDiagram(wiring)
    runner.hidden_state = hidden_state(wiring)
    return runner


def hidden_state(wiring: Wiring) -> str:
    """Return a sentence on a function that writes to what outlives its call, or ""."""
    for node in wiring.nodes:
        block = node.system
        for role in () if block.of_package else ("output", *block._roles):
            try:
                block.array_record(role)
            except Unread as error:
                if OUTLIVES in str(error):
                    return str(error)
    return ""


def run_in_python(
    runner: Runner,
    name: str,
    start: ndarray,
    times: ndarray,
    inputs: Inputs,
    options: RunOptions,
) -> tuple[Solution, ndarray]:
    """Run a diagram in Python; return the solution and all signals along it.

    One with hidden state runs again with a tenth of rtol, and a warning has the difference.
    """
    try:
        solution = runner.solve(start, times, inputs, options)
    except SimulationError as error:
        if runner.hidden_state:
            error.args = (f"{error}. Its reason may be this: {runner.hidden_state}",)
        raise
    signals = runner.signals(solution, inputs)
    if runner.hidden_state and runner.nstates and not runner.wiring.dt:
        rtol, atol = 0.1 * options.rtol, 0.1 * options.atol
        exact = replace(options, rtol=rtol, atol=atol, progress=None)
        again = runner.solve(start, times, inputs, exact)
        following = runner.signals(again, inputs)
        n = min(len(signals), len(following))
        difference = max(
            np.abs(solution.x[:n] - again.x[:n]).max(initial=0.0),
            np.abs(signals[:n] - following[:n]).max(initial=0.0),
        )
        warn(
            f"{name}: a function has hidden state, so the result depends on the order of calls. "
            f"With rtol / 10 states and signals differ by up to {difference:.2g}. Replace the "
            "function by parts.backlash, parts.relay or a state"
        )
    return solution, signals


def run_compared(
    runner: NativeDiagram,
    start: ndarray,
    times: ndarray,
    inputs: Inputs,
    options: RunOptions,
    is_compared: bool = True,
) -> tuple[Any, str]:
    """Run a diagram; return the solution and a sentence on the function that was misread, or ""."""
    try:
        solution = runner.solve(start, times, inputs, options)
    except SimulationError as error:
        at_start = Solution(times[:1], start[None])
        why = difference(runner, at_start, inputs)
        if not why and error.points and not _is_of_package(runner):
            segments = runner.schedule(times, inputs)
            why = Comparison(runner, segments, inputs).ahead(error.points)
        if not why and Status.NOT_FINITE.sentence in str(error):
            # blocks in Python find nothing
            why = "what was read gives a number that is not finite, where Python gives one"
        if not why:
            raise
        return None, why
    return solution, difference(runner, solution, inputs) if is_compared else ""


def warn_python(name: str, why: str) -> None:
    """Warn that a diagram runs in Python."""
    warn(f"{name} runs in Python, not as machine code: {why}")


# --- comparison of the record with the functions ----------------------------------------------

# relative: on a kink, and at rest, rounding decides: states next to it are compared, and then
# states farther away, where rates are far above the rounding of terms that cancel at rest
DISTANCES = 1e-6, -1e-6, 1e-3, -1e-3
STRIDE = 7919  # a prime: samples of the runs that follow


def difference(runner: NativeDiagram, solution: Solution, inputs: Inputs) -> str:
    """Return a sentence on the function that was misread; "" where all agrees."""
    n = len(solution.t)
    if not n or _is_of_package(runner):
        return ""
    # four samples of the first run, and of each later one another sample
    samples = [runner.comparisons * STRIDE % n]
    if not runner.comparisons:
        samples = sorted({0, n // 3, 2 * n // 3, n - 1})
    runner.comparisons += 1
    return difference_at(samples, runner, solution, inputs)


def _is_of_package(runner: Runner) -> bool:
    """Return whether all functions are the package's own, which are not compared."""
    return all(node.system.of_package for node in runner.wiring.nodes)


def difference_at(
    samples: Sequence[int], runner: NativeDiagram, solution: Solution, inputs: Inputs
) -> str:
    """Return a sentence on the function that differs at a sample of a solution, or ""."""
    # compare the samples, then states next to those that differ
    compared = Comparison(runner, runner.segments_of(solution, inputs), inputs)
    t, x = solution.t, solution.x
    solution.signals = runner.evaluate(solution, inputs)
    rows = np.array(samples)
    agrees = compared.agrees(t[rows], x[rows], solution.signals[rows])
    differing = [k for k, same in zip(samples, agrees, strict=True) if not same]
    return next(filter(None, (compared.beside(t[k], x[k]) for k in differing)), "")


def _is_near(row: ndarray, values: ndarray) -> bool:
    """Return whether a row of machine code has Python's values; most often to the bit."""
    return row.tobytes() == values.tobytes() or not differ(row, values).any()


class Comparison(NamedTuple):
    """Machine code and Python, compared at points of a run."""

    runner: NativeDiagram
    segments: Schedule
    inputs: Inputs

    def agrees(self, times: ndarray, x: ndarray, signals: Any = None) -> list[bool]:
        """Return at which times and states Python and machine code give the same.

        That is the same signals, which machine code may have given before, the same rates, the same
        states after all jumps, and the same distances of guards.  Derivatives along directions,
        behind them, are not compared.
        """
        runner, segments, inputs = self
        sweep = runner.sweep
        machine = runner.results(times, x, segments, signals)
        run = times[-1] - times[0]
        agrees = []
        for k, t in enumerate(times.tolist()):
            python = sweep.results(t, x[k, : sweep.nstates], inputs.at(t), run)
            pairs = zip((rows[k] for rows in machine), python, strict=True)
            agrees.append(all(_is_near(row[: len(p)], p) for row, p in pairs))
        return agrees

    def beside(self, t: float, x: ndarray) -> str:
        """Return a sentence on the function that differs at all states next to x too, or ""."""
        # equal directions might stay at rest
        scaled = (1.0 + np.abs(x)) * np.linspace(0.7, 1.0, len(x))
        for distance in DISTANCES:
            moved = x + distance * scaled
            if self.agrees(np.array([t + 1e-3 * distance]), moved[None])[0]:
                return ""
        misread = self.misread(float(t), moved)
        return misread or f"at t = {t:.6g} its rates are not those of its functions"

    def ahead(self, points: Any) -> str:
        """Return where Python gives a number, and machine code none, ahead of a stopped run."""
        for t, x in points:
            if np.isfinite(x).all() and not self.agrees(np.array([t]), x[None])[0]:
                return self.misread(float(t), x)
        return ""

    @np.errstate(all="ignore")  # as a sweep runs them
    def misread(self, t: float, x: ndarray) -> str:
        """Return a sentence on the function whose record differs from it, or ""."""
        sweep = self.runner.sweep
        x = x[: sweep.nstates]
        sweep.derivative(t, x, self.inputs.at(t))
        for k, node in enumerate(sweep.nodes):
            block = node.system
            p = block.parameters_at(t, sweep.parameters[k])
            arguments = t, x[node.states], sweep.fed(k), p
            for role in block._roles:
                with suppress(Unread):
                    values = block.on_arrays(role, *arguments)
                    expected = block.values(role, len(values), *arguments)
                    if differ(values, expected).any():
                        return f"{node.name}.{role} gives other numbers in Python"
        return ""
