"""Choose the engine: machine code, or Python for what cannot be compiled.

The model alone decides, never what a cache holds: the same script gives the same numbers.
"""

import os
from collections.abc import Mapping
from typing import Any

import control

from ..diagrams.wiring import Wiring, wiring_of
from ..errors import SimulationError, Uncompiled
from ..progress import warn
from .ending import Solution, Status
from .python_diagram import PythonDiagram

ENGINES = ("native", "python")
VARIABLE = "CLPT_CONTROL_ENGINE"  # environment variable that names another default


def chosen(
    diagram: control.NonlinearIOSystem | Wiring,
    params: Mapping[str, Any] | None = None,
    by_function: bool = False,
    engine: str | None = None,
    name: str = "the diagram",
) -> PythonDiagram:
    """Return a diagram ready to run, compiled where that can be.

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
    if asked == "python" or by_function:
        return PythonDiagram(wiring, params)
    return compiled(wiring, params, name)


def compiled(wiring: Wiring, params: Mapping[str, Any] | None, name: str) -> PythonDiagram:
    """Return a diagram as machine code; in Python, with a warning, what cannot be compiled."""
    from .native_diagram import NativeDiagram

    try:
        return NativeDiagram(wiring, params)
    except Uncompiled as error:
        in_python(name, str(error))
        return PythonDiagram(wiring, params)


def run_as_read(
    runner: PythonDiagram, name: str, start: Any, times: Any, params: Any, **given: Any
) -> tuple[Solution, PythonDiagram]:
    """Run a diagram; in Python what was read otherwise than Python runs it.

    Returns the solution and what ran.
    """
    from .agreement import difference
    from .native_diagram import NativeDiagram

    if not isinstance(runner, NativeDiagram):
        return runner.run(start, times, **given), runner
    try:
        solution = runner.run(start, times, **given)
    except SimulationError as error:
        if Status.NOT_FINITE.sentence not in str(error):  # Python's blocks find nothing there
            raise
        found = "what was read gives a number that is not finite, where Python gives one"
    else:
        found = difference(runner, solution, given.get("inputs")) or ""
        if not found:
            return solution, runner
    in_python(name, found)
    again = PythonDiagram(runner.wiring, params)
    return again.run(start, times, **given), again


def in_python(name: str, why: str) -> None:
    """Warn that a diagram runs in Python."""
    warn(f"{name} runs in Python, not as machine code: {why}")
