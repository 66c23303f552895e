"""Choose the engine: machine code, or Python for what cannot be compiled, or was read otherwise.

The model alone decides, never what a cache holds: the same script gives the same numbers.  What was
read is compared with the functions where the run begins and at three of its own samples: rates,
signals and jumps.  Points drawn at random would not reach every branch of a function.
"""

import os
from collections.abc import Mapping
from contextlib import suppress
from typing import Any

import control
import numpy as np

from ..diagrams.wiring import Wiring, wiring_of
from ..equations.arrays import Unread
from ..equations.at_many import leaf_values
from ..errors import SimulationError, Uncompiled
from ..progress import warn
from . import solver
from .batch import Callee
from .ending import Solution, Status
from .native_diagram import NativeDiagram
from .python_diagram import PythonDiagram
from .schedule import JUMPS, Inputs, Schedule

ENGINES = ("native", "python")
VARIABLE = "CLPT_CONTROL_ENGINE"  # environment variable that names another default


def make_runner(
    diagram: control.NonlinearIOSystem | Wiring,
    params: Mapping[str, Any] | None = None,
    by_function: bool = False,
    engine: str | None = None,
    name: str = "the diagram",
    apart: Mapping[tuple[int, str], Any] = {},
) -> PythonDiagram:
    """Return a diagram ready to run, compiled where that can be; `apart` as `lay_out` takes it.

    What cannot be compiled runs in Python, with a warning that calls it by `name`; so does a
    diagram whose inputs come `by_function`, unless machine code is asked for: an error.
    """
    asked = engine or os.environ.get(VARIABLE) or "native"
    if asked not in ENGINES:
        whose = "engine" if engine else f"the environment variable {VARIABLE}"
        raise SimulationError(f"{whose} = '{asked}': must be one of {', '.join(ENGINES)}")
    wiring = diagram if isinstance(diagram, Wiring) else wiring_of(diagram, params)
    by_function = by_function and bool(wiring.ninputs)
    if engine == "native" and by_function:
        raise SimulationError(
            "inputs: machine code takes no function; give samples at timepts, or leave engine out"
        )
    if asked == "native" and not by_function:
        try:
            return NativeDiagram(wiring, params, apart=apart)
        except Uncompiled as error:
            warn_python(name, str(error))
    return PythonDiagram(wiring, params)


def run_checked(
    runner: PythonDiagram, name: str, start: Any, times: Any, params: Any, **given: Any
) -> tuple[Solution, np.ndarray]:
    """Run a diagram; in Python what was read otherwise than Python runs it.

    Returns the solution and all signals along it.
    """
    if isinstance(runner, NativeDiagram):
        solution, signals, found = run_compared(runner, start, times, **given)
        if not found:
            return solution, runner.finite(solution, signals, given["inputs"])
        warn_python(name, found)
        runner = PythonDiagram(runner.wiring, params)
    solution = runner.run(start, times, **given)
    return solution, runner.signals(solution, given["inputs"])


def run_compared(runner: NativeDiagram, start: Any, times: Any, **given: Any) -> tuple:
    """Run a diagram; return solution, signals and, in words, what was read otherwise."""
    try:
        solution = runner.run(start, times, **given)
    except SimulationError as error:
        begun, inputs = Solution(np.asarray(times[:1]), np.reshape(start, (1, -1))), given["inputs"]
        why = difference(runner, begun, runner.signals(begun, inputs, check=False), inputs)
        if not why and Status.NOT_FINITE.sentence in str(error):  # Python's blocks find nothing
            why = "what was read gives a number that is not finite, where Python gives one"
        if not why:
            raise
        return None, None, why
    signals = runner.signals(solution, given["inputs"], check=False)
    return solution, signals, difference(runner, solution, signals, given["inputs"]) or ""


def warn_python(name: str, why: str) -> None:
    """Warn that a diagram runs in Python."""
    warn(f"{name} runs in Python, not as machine code: {why}")


# --- whether what was read does what the functions do -----------------------------------------

CLOSE = 1e-7  # relative: rounding of terms that cancel, not another way through a function
APART = 1e-6, -1e-6  # where a sample lies on a kink, rounding decides; beside it nothing does


def difference(
    runner: NativeDiagram, solution: Solution, signals: np.ndarray, inputs: Inputs | None
) -> str | None:
    """Return what was read otherwise than Python runs it, in words; None where all agrees."""
    n = len(solution.t)
    if not n or all(node.system.of_package for node in runner.wiring.nodes):
        return None
    at = sorted({0, n // 3, 2 * n // 3, n - 1})
    callee, pieces = runner.callee(1, inputs), runner.pieces_of(solution, inputs)
    machine = _asked(runner, callee, pieces, solution.t[at], solution.x[at], signals[at])
    same = _alike(runner, machine, solution.t[at], solution.x[at], inputs)
    for k in np.array(at)[~same]:
        t, x = solution.t[k : k + 1], solution.x[k]
        for moved in (x + apart * (1.0 + np.abs(x)) for apart in APART):
            asked = _asked(runner, callee, pieces, t, moved[None])
            if _alike(runner, asked, t, moved[None], inputs)[0]:
                break
        else:
            runner.sweep.derivative(t[0], moved, None if inputs is None else inputs.at(t[0]))
            found = misread_function(runner, float(t[0]), moved)
            return found or f"at t = {t[0]:.6g} its rates are not those of its functions"
    return None


def _asked(
    runner: NativeDiagram,
    callee: Callee,
    pieces: Schedule,
    times: Any,
    x: np.ndarray,
    signals: np.ndarray | None = None,
) -> list[np.ndarray]:
    """Return signals, unless they are known, rates and what every jump leaves, by machine code."""
    own, n = runner.parameters(), runner.nstates

    def ask(role: int, count: int, pieces: Schedule = pieces) -> np.ndarray:
        return callee.evaluate(role, times, x, pieces, own, np.empty((len(times), count)))

    found = [ask(solver.SIGNALS, runner.nsignals) if signals is None else signals]
    if n:
        found.append(ask(solver.DERIVATIVE, n))
    if callee.jumping:
        values, jumps = pieces.values.copy(), list(runner.jumps.values())
        values[:, np.isin(pieces.places, jumps)] = JUMPS
        found.append(ask(solver.JUMP, n, pieces._replace(values=values)))
    return found


def _alike(
    runner: NativeDiagram, machine: list[np.ndarray], times: Any, x: np.ndarray, inputs: Any
) -> np.ndarray:
    """Return whether Python says the same, at each time."""
    sweep, asked = runner.sweep, []
    for t, state in zip(times.tolist(), x, strict=True):
        u = None if inputs is None else inputs.at(t)
        sweep.enter(t)
        rates = sweep.derivative(t, state, u)
        own = [sweep.signals.copy(), rates][: len(machine)]
        asked.append([*own, sweep.jump(t, state, u, sweep.jumping)] if sweep.jumping else own)
    found = np.ones(len(asked), dtype=bool)
    for ours, others in zip(zip(*asked, strict=True), machine, strict=True):
        found &= _same(np.array(ours), others)
    return found


def _same(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return which rows are the same but for rounding."""
    with np.errstate(invalid="ignore"):
        size = np.abs(a)
        largest = size.max(axis=-1, initial=1e-300, where=size < np.inf, keepdims=True)
        near = np.abs(a - b) <= CLOSE * (size + 1e-3 * largest)
    return np.all(near | (a == b) | (np.isnan(a) & np.isnan(b)), axis=-1)


def misread_function(runner: PythonDiagram, t: float, x: np.ndarray) -> str | None:
    """Name the block whose record differs from its functions, on the last pass's inputs."""
    sweep = runner.sweep
    for k, node in enumerate(runner.wiring.nodes):
        block, states, u, p = node.system, x[node.states], sweep.fed(k), sweep.parameters[k]
        for role in ("output", "update", "jump"):
            if getattr(block, f"{role}_function") is None:
                continue
            with suppress(Unread):
                leaves = leaf_values(block, t, states, u, p)
                found = block.array_record(role).values(leaves, block.sizes)
                values = np.concatenate([np.zeros(0), *(one.ravel() for one in found)])
                if not _same(block.values(role, len(values), t, states, u, p), values).all():
                    return f"{node.name}.{role} was read otherwise than Python runs it"
    return None
