"""Choose the engine: machine code, or Python for what cannot be compiled."""

import os
import warnings
from collections.abc import Mapping
from typing import Any

import control

from ..diagrams.wiring import Wiring, wiring_of
from ..errors import SimulationError, Uncompiled
from .inputs import Inputs
from .python_diagram import PythonDiagram

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
    diagram whose inputs are a function, unless machine code is asked for: an error.
    """
    asked = engine or os.environ.get(VARIABLE) or "native"
    if asked not in ENGINES:
        whose = "engine" if engine else f"the environment variable {VARIABLE}"
        raise SimulationError(f"{whose} = '{asked}': must be one of {', '.join(ENGINES)}")
    wiring = diagram if isinstance(diagram, Wiring) else wiring_of(diagram)
    by_function = inputs is not None and inputs.samples is None and bool(wiring.ninputs)
    if engine == "native" and by_function:
        raise SimulationError(
            "inputs: machine code takes no function; give samples at timepts, or leave engine out"
        )
    if asked == "native" and not by_function and wiring.nodes[-1].states.stop:
        from .native_diagram import NativeDiagram

        try:
            return NativeDiagram(wiring, params)
        except Uncompiled as error:
            warnings.warn(f"{name} runs in Python, not as machine code: {error}", stacklevel=4)
    return PythonDiagram(wiring, params)
