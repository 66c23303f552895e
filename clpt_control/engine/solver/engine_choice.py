"""Choose the engine: machine code, or Python for a diagram that cannot be compiled or was misread.

The model alone decides, never the content of a cache: the same script gives the same numbers.  What
was read is compared with the functions where the run begins and at three of its own samples: rates,
signals and jumps.  Points drawn at random would not reach every branch of a function.
"""

import os
from collections.abc import Mapping
from contextlib import suppress
from typing import Any

import numpy as np

from ...errors import SimulationError, Uncompiled
from ...progress import warn
from ..codegen.machine import ENGINE
from ..diagram.wiring import Wiring
from ..model.vectorized import on_arrays
from ..trace.arrays import Unread
from .evaluation_pass import rounding
from .native_diagram import NativeDiagram
from .runner import PythonDiagram
from .schedule import JUMPS, Inputs, Schedule
from .solver_layout import DERIVATIVE, JUMP, SIGNALS, Status
from .termination import Solution

ENGINES = ("native", "python")


def make_runner(
    wiring: Wiring,
    params: Mapping[str, Any] | None = None,
    engine: str | None = None,
    name: str = "the diagram",
    apart: Mapping[tuple[int, str], Any] = {},
) -> PythonDiagram:
    """Return a diagram ready to run, compiled if possible; `apart` as `lay_out` takes it.

    A diagram that cannot be compiled runs in Python, with a warning that calls it by `name`.
    """
    wanted = engine or os.environ.get(ENGINE) or "native"
    if wanted not in ENGINES:
        whose = "engine" if engine else f"the environment variable {ENGINE}"
        raise SimulationError(f"{whose} = '{wanted}': must be one of {', '.join(ENGINES)}")
    if wanted == "native":
        try:
            return NativeDiagram(wiring, params, apart=apart)
        except Uncompiled as error:
            warn_python(name, str(error))
    return PythonDiagram(wiring, params)


def run_checked(
    runner: PythonDiagram, name: str, start: Any, times: Any, params: Any, **options: Any
) -> tuple[Solution, np.ndarray]:
    """Run a diagram, in Python if it was misread; return the solution and all signals along it."""
    if isinstance(runner, NativeDiagram):
        solution, why = run_compared(runner, start, times, **options)
        if not why:
            return solution, runner.signals(solution, options["inputs"])
        warn_python(name, why)
        runner = PythonDiagram(runner.wiring, params)
    solution = runner.run(start, times, **options)
    return solution, runner.signals(solution, options["inputs"])


def run_compared(runner: NativeDiagram, start: Any, times: Any, **options: Any) -> tuple[Any, str]:
    """Run a diagram; return the solution and, in words, what was misread."""
    try:
        solution = runner.run(start, times, **options)
    except SimulationError as error:
        at_start = Solution(np.asarray(times[:1]), np.reshape(start, (1, -1)))
        why = difference(runner, at_start, options["inputs"])
        points = getattr(error, "points", [])
        why = why or difference_ahead(runner, points, times, options["inputs"])
        not_finite = Status.NOT_FINITE.sentence in str(error)
        if not why and not_finite:  # Python's blocks find nothing
            why = "what was read gives a number that is not finite, where Python gives one"
        if not why:
            raise
        return None, why
    return solution, difference(runner, solution, options["inputs"])


def warn_python(name: str, why: str) -> None:
    """Warn that a diagram runs in Python."""
    warn(f"{name} runs in Python, not as machine code: {why}")


# --- whether the record does what the functions do --------------------------------------------

CLOSE = 1e-7  # relative: rounding of terms that cancel, not another way through a function
# relative: on a kink, and at rest, rounding decides: compared is beside it, and then farther, where
# rates are far above the rounding of what cancels at rest
BESIDE = 1e-6, -1e-6, 1e-3, -1e-3
OTHER = 7919  # a prime: samples of the runs that follow


def difference(runner: NativeDiagram, solution: Solution, inputs: Inputs | None) -> str:
    """Return in words what was misread; "" where all agrees."""
    n = len(solution.t)
    if not n or all(node.system.of_package for node in runner.wiring.nodes):
        return ""
    # four samples of the first run, and of each later one another sample
    later = runner.comparisons * OTHER % n
    at = [later] if runner.comparisons else sorted({0, n // 3, 2 * n // 3, n - 1})
    runner.comparisons += 1
    pieces = runner.pieces(solution, inputs)
    solution.signals = runner.evaluated_signals(solution, inputs)
    same = _agrees(runner, pieces, solution.t[at], solution.x[at], inputs, solution.signals[at])
    for k in np.array(at)[~same]:
        t = solution.t[k : k + 1]
        for apart, moved in zip(BESIDE, beside(solution.x[k]), strict=True):
            if _agrees(runner, pieces, t + 1e-3 * apart, moved[None], inputs)[0]:
                break
        else:
            moved = moved[: runner.sweep.nstates]
            runner.sweep.derivative(t[0], moved, None if inputs is None else inputs.at(t[0]))
            misread = misread_function(runner, float(t[0]), moved)
            return misread or f"at t = {t[0]:.6g} its rates are not those of its functions"
    return ""


def difference_ahead(runner: NativeDiagram, points: list, times: Any, inputs: Inputs | None) -> str:
    """Return where Python gives a number, and machine code none, ahead of a stopped run."""
    if not points or all(node.system.of_package for node in runner.wiring.nodes):
        return ""
    at, x = (np.array(own) for own in zip(*points, strict=True))
    finite = np.isfinite(x).all(axis=1)
    pieces = runner.schedule(times, inputs)
    for t, state in zip(at[finite], x[finite], strict=True):
        if not _agrees(runner, pieces, t[None], state[None], inputs)[0]:
            return misread_function(runner, float(t), state) or ""
    return ""


def beside(x: np.ndarray) -> list[np.ndarray]:
    """Return states beside these."""
    ways = (1.0 + np.abs(x)) * np.linspace(0.7, 1.0, len(x))  # all alike might stay at rest
    return [x + apart * ways for apart in BESIDE]


def _agrees(
    runner: NativeDiagram,
    pieces: Schedule,
    times: Any,
    x: np.ndarray,
    inputs: Inputs | None,
    signals: np.ndarray | None = None,
) -> np.ndarray:
    """Return at which times and states Python and machine code give the same.

    That is the same signals, which machine code may have given before, the same rates, and the
    same states after all jumps.  Derivatives along directions, behind them, are not compared.
    """
    sweep, P = runner.sweep, runner.parameters()

    def evaluated(role: int, count: int, own: Schedule = pieces) -> np.ndarray:
        return runner.callee(1, inputs).evaluate(role, times, x, own, P, count)

    signals = evaluated(SIGNALS, runner.nsignals) if signals is None else signals
    machine = [signals]
    if runner.nstates:
        machine.append(evaluated(DERIVATIVE, runner.nstates))
    if sweep.jumping:
        every_jump = pieces.values.copy()
        every_jump[:, np.isin(pieces.places, list(runner.jumps.values()))] = JUMPS
        every = pieces._replace(values=every_jump)
        machine.append(evaluated(JUMP, runner.nstates, every))
    python = []
    for t, state in zip(times.tolist(), x[:, : sweep.nstates], strict=True):
        u = None if inputs is None else inputs.at(t)
        sweep.enter(t + rounding(t))
        rates = sweep.derivative(t, state, u)
        own = [sweep.signals.copy(), rates][: len(machine)]
        python.append([*own, sweep.jump(t, state, u, sweep.jumping)] if sweep.jumping else own)
    pairs = zip(zip(*python, strict=True), machine, strict=True)
    return np.all([_same(np.array(own), others[:, : len(own[0])]) for own, others in pairs], axis=0)


def _same(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return which rows are equal up to rounding."""
    with np.errstate(invalid="ignore"):
        size = np.abs(a)
        if (np.abs(a - b) <= CLOSE * size).all():
            return np.ones(len(a), dtype=bool)
        largest = size.max(axis=-1, initial=1e-300, where=size < np.inf, keepdims=True)
        near = np.abs(a - b) <= CLOSE * (size + 1e-3 * largest)
    return np.all(near | (a == b) | (np.isnan(a) & np.isnan(b)), axis=-1)


@np.errstate(all="ignore")  # as a sweep runs them
def misread_function(runner: PythonDiagram, t: float, x: np.ndarray) -> str | None:
    """Return a sentence on the function whose record differs from it, at the last pass's inputs."""
    sweep = runner.sweep
    for k, node in enumerate(runner.wiring.nodes):
        block, states, u, p = node.system, x[node.states], sweep.fed(k), sweep.parameters[k]
        for role in ("output", "update", "jump"):
            if getattr(block, f"{role}_function") is None:
                continue
            with suppress(Unread):
                values = on_arrays(block, role, t, states, u, p)
                if not _same(block.values(role, len(values), t, states, u, p), values).all():
                    return f"{node.name}.{role} gives other numbers in Python"
    return None
