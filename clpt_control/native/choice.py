"""Choose the engine: machine code, or Python for what cannot be compiled."""

import os
import warnings
from collections.abc import Mapping
from typing import Any

import control

from ..diagrams.wiring import Wiring, read
from ..errors import SimulationError, Uncompiled
from .inputs import Inputs
from .plain import PlainDiagram

ENGINES = ("native", "python")
VARIABLE = "CLPT_CONTROL_ENGINE"  # environment variable that names another default


def chosen(
    diagram: control.NonlinearIOSystem | Wiring,
    params: Mapping[str, Any] | None = None,
    inputs: Inputs | None = None,
    engine: str | None = None,
    name: str = "the diagram",
) -> PlainDiagram:
    """Return a diagram ready to run, compiled where that can be.

    Parameters
    ----------
    diagram : control.NonlinearIOSystem or Wiring
        Any interconnected system.
    params : mapping, optional
        Call-time parameters by qualified name.
    inputs : Inputs, optional
        Inputs of the diagram; a function of the user's is called in Python.
    engine : str, optional
        ``"native"`` or ``"python"``.
    name : str, optional
        Of the diagram, for messages.

    Returns
    -------
    PlainDiagram
        A NativeDiagram where it is compiled.

    Raises
    ------
    SimulationError
        If there is no such engine.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> type(chosen(clpt.closed_loop(clpt.paper_scenario()), engine="python")).__name__
    'PlainDiagram'
    """
    engine = engine or os.environ.get(VARIABLE) or "native"
    if engine not in ENGINES:
        raise SimulationError(f"engine = '{engine}': must be one of {', '.join(ENGINES)}")
    wiring = diagram if isinstance(diagram, Wiring) else read(diagram)
    by_function = inputs is not None and inputs.samples is None and bool(wiring.ninputs)
    if engine == "native" and not by_function and wiring.nodes[-1].states.stop:
        from .engine import NativeDiagram

        try:
            return NativeDiagram(wiring, params)
        except Uncompiled as error:
            warnings.warn(f"{name} runs in Python, not as machine code: {error}", stacklevel=4)
    return PlainDiagram(wiring, params)
