"""Choose the engine: machine code, or Python for what cannot be compiled."""

import os
from collections.abc import Mapping
from typing import Any

import control

from ..diagrams.wiring import Wiring, wiring_of
from ..errors import SimulationError
from .first_run import FirstRun, compiled
from .inputs import Inputs
from .python_diagram import PythonDiagram
from .solver_cache import ready

ENGINES = ("native", "python")
VARIABLE = "CLPT_CONTROL_ENGINE"  # environment variable that names another default


def chosen(
    diagram: control.NonlinearIOSystem | Wiring,
    params: Mapping[str, Any] | None = None,
    inputs: Inputs | None = None,
    engine: str | None = None,
    name: str = "the diagram",
) -> PythonDiagram:
    """Return a diagram ready to run, compiled where that can be.

    What cannot be compiled runs in Python, with a warning that calls it by `name`; so does a
    diagram whose inputs are a function, unless machine code is asked for: an error.  Where
    neither engine is asked for and the solver is not compiled yet, a run begins in Python.
    """
    wanted = engine or os.environ.get(VARIABLE)
    asked = wanted or "native"
    if asked not in ENGINES:
        whose = "engine" if engine else f"the environment variable {VARIABLE}"
        raise SimulationError(f"{whose} = '{asked}': must be one of {', '.join(ENGINES)}")
    wiring = diagram if isinstance(diagram, Wiring) else wiring_of(diagram)
    by_function = inputs is not None and inputs.samples is None and bool(wiring.ninputs)
    if engine == "native" and by_function:
        raise SimulationError(
            "inputs: machine code takes no function; give samples at timepts, or leave engine out"
        )
    if asked == "python" or by_function or not wiring.nodes[-1].states.stop:
        return PythonDiagram(wiring, params)
    if wanted is None and not ready():
        return FirstRun(wiring, params, name)
    return compiled(wiring, params, name)
