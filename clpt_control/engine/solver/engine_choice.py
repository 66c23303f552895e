"""Choose the engine: machine code, or Python for a diagram that cannot be compiled or was misread.

The model alone decides, never the content of a cache: the same script gives the same numbers.  What
was read is compared with the functions where the run begins and at three of its own samples: rates,
signals and jumps.  Points drawn at random would not reach every branch of a function.
"""

import os
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any

import numpy as np
from numpy import ndarray

from ...base.errors import SimulationError, Uncompiled
from ...base.progress import warn
from ..codegen.machine import ENGINE
from ..conformance.differences import differ, differences
from ..diagram.wiring import Wiring
from ..model.on_arrays import on_arrays
from ..record.unread import Unread
from ..trace.arrays import OUTLIVES
from .inputs import Inputs, inputs_at
from .native_diagram import NativeDiagram
from .python_runs import PythonDiagram
from .runner import Runner, RunOptions
from .schedule import Schedule
from .solver_layout import Status
from .termination import Solution

ENGINES = ("native", "python")


def make_runner(
    wiring: Wiring,
    params: Mapping[str, Any] | None = None,
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
            return NativeDiagram(wiring, params, apart=apart)
        except Uncompiled as error:
            warn_python(name, str(error))
    runner = PythonDiagram(wiring, params)
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
    inputs: Inputs | None,
    options: RunOptions,
) -> tuple[Solution, ndarray]:
    """Run a diagram in Python; return the solution and all signals along it."""
    try:
        solution = runner.solve(start, times, inputs, options)
    except SimulationError as error:
        if runner.hidden_state:
            error.args = (f"{error}. Its reason may be this: {runner.hidden_state}",)
        raise
    signals = runner.signals(solution, inputs)
    if runner.hidden_state and runner.nstates and not runner.wiring.dt:
        given = start, times, inputs, options
        _warn_of_order(runner, name, given, solution, signals)
    return solution, signals


def _warn_of_order(
    runner: Runner,
    name: str,
    given: tuple[ndarray, ndarray, Inputs | None, RunOptions],
    solution: Solution,
    signals: ndarray,
) -> None:
    """Run a diagram with hidden state again with a tenth of rtol, and print the difference."""
    start, times, inputs, options = given
    exact = replace(
        options, rtol=0.1 * options.rtol, atol=0.1 * options.atol, progress=None
    )
    again = runner.solve(start, times, inputs, exact)
    following = runner.signals(again, inputs)
    n = min(len(signals), len(following))
    difference = max(
        np.abs(solution.x[:n] - again.x[:n]).max(initial=0.0),
        np.abs(signals[:n] - following[:n]).max(initial=0.0),
    )
    warn(
        f"{name}: a function has hidden state, so the result depends on the order of calls. With "
        f"rtol / 10 states and signals differ by up to {difference:.2g}. Replace the function by "
        "parts.backlash, parts.relay or a state"
    )


def run_compared(
    runner: NativeDiagram,
    start: ndarray,
    times: ndarray,
    inputs: Inputs | None,
    options: RunOptions,
    is_compared: bool = True,
) -> tuple[Any, str]:
    """Run a diagram; return the solution and a sentence on the function that was misread, or ""."""
    try:
        solution = runner.solve(start, times, inputs, options)
    except SimulationError as error:
        at_start = Solution(times[:1], start[None])
        why = difference(runner, at_start, inputs)
        if not why:
            why = difference_ahead(runner, error.points, times, inputs)
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


def difference(runner: NativeDiagram, solution: Solution, inputs: Inputs | None) -> str:
    """Return a sentence on the function that was misread; "" where all agrees."""
    n = len(solution.t)
    if not n or all(node.system.of_package for node in runner.wiring.nodes):
        return ""
    # four samples of the first run, and of each later one another sample
    samples = sorted({0, n // 3, 2 * n // 3, n - 1})
    if runner.comparisons:
        samples = [runner.comparisons * STRIDE % n]
    runner.comparisons += 1
    return difference_at(samples, runner, solution, inputs)


def difference_at(
    samples: Sequence[int],
    runner: NativeDiagram,
    solution: Solution,
    inputs: Inputs | None,
) -> str:
    """Return a sentence on the function that differs at a sample of a solution, or ""."""
    # compare the samples, then states next to those that differ
    segments = runner.segments_of(solution, inputs)
    solution.signals = runner.evaluate(solution, inputs)
    signals = solution.signals[samples]
    agrees = _agrees(
        runner, segments, solution.t[samples], solution.x[samples], inputs, signals
    )
    for k in np.array(samples)[~agrees]:
        why = _difference_beside(runner, segments, solution.t[k], solution.x[k], inputs)
        if why:
            return why
    return ""


def _difference_beside(
    runner: NativeDiagram,
    segments: Schedule,
    t: float,
    x: ndarray,
    inputs: Inputs | None,
) -> str:
    """Return a sentence on the function that differs at all states next to x too, or ""."""
    # equal directions might stay at rest
    scaled = (1.0 + np.abs(x)) * np.linspace(0.7, 1.0, len(x))
    for distance in DISTANCES:
        time = np.array([t + 1e-3 * distance])
        moved = x + distance * scaled
        if _agrees(runner, segments, time, moved[None], inputs)[0]:
            return ""
    misread = misread_function(runner, float(t), moved, inputs)
    return misread or f"at t = {t:.6g} its rates are not those of its functions"


def difference_ahead(
    runner: NativeDiagram, points: Any, times: Any, inputs: Inputs | None
) -> str:
    """Return where Python gives a number, and machine code none, ahead of a stopped run."""
    if not points or all(node.system.of_package for node in runner.wiring.nodes):
        return ""
    segments = runner.schedule(times, inputs)
    for t, x in points:
        time = np.array([t])
        is_finite = np.isfinite(x).all()
        if is_finite and not _agrees(runner, segments, time, x[None], inputs)[0]:
            return misread_function(runner, float(t), x, inputs)
    return ""


def _agrees(
    runner: NativeDiagram,
    segments: Schedule,
    times: ndarray,
    x: ndarray,
    inputs: Inputs | None,
    signals: ndarray | None = None,
) -> ndarray:
    """Return at which times and states Python and machine code give the same.

    That is the same signals, which machine code may have given before, the same rates, the same
    states after all jumps, and the same distances of guards.  Derivatives along directions, behind
    them, are not compared.
    """
    sweep = runner.sweep
    machine = runner.results(times, x, segments, signals)
    states = x[:, : sweep.nstates]
    run = times[-1] - times[0]
    python = [
        sweep.results(t, state, inputs_at(inputs, t), run)
        for t, state in zip(times.tolist(), states, strict=True)
    ]
    agrees = np.ones(len(times), dtype=bool)
    for rows, compiled in zip(zip(*python, strict=True), machine, strict=True):
        compiled = compiled[:, : len(rows[0])]
        if (compiled == rows).all():  # most often
            continue
        for k, *_ in differences(compiled, rows):
            agrees[k] = False
    return agrees


@np.errstate(all="ignore")  # as a sweep runs them
def misread_function(
    runner: Runner, t: float, x: ndarray, inputs: Inputs | None
) -> str:
    """Return a sentence on the function whose record differs from it, or ""."""
    sweep = runner.sweep
    x = x[: sweep.nstates]
    sweep.derivative(t, x, inputs_at(inputs, t))
    for k, node in enumerate(runner.wiring.nodes):
        block = node.system
        arguments = t, x[node.states], sweep.fed(k), sweep.parameters[k]
        for role in block._roles:
            with suppress(Unread):
                values = on_arrays(block, role, *arguments)
                expected = block.values(role, len(values), *arguments)
                if differ(values, expected).any():
                    return f"{node.name}.{role} gives other numbers in Python"
    return ""
