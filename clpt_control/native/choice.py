"""Choose the engine: machine code, or Python for what cannot be compiled."""

import os
import warnings
from collections.abc import Callable, Mapping
from typing import Any

import control
import numpy as np

from ..errors import DiagramError, SimulationError
from .inputs import Inputs
from .record import sample_signals
from .solution import Solution
from .sweep import Sweep

ENGINES = ("native", "python")
VARIABLE = "CLPT_CONTROL_ENGINE"  # environment variable that names another default


class Engine:
    """A diagram ready to run.

    Parameters
    ----------
    diagram : control.NonlinearIOSystem
        Any interconnected system.
    params : mapping, optional
        Call-time parameters by qualified name.
    inputs : Inputs, optional
        Inputs of the diagram.
    engine : str, optional
        ``"native"`` or ``"python"``.

    Attributes
    ----------
    sweep : Sweep
        The plain evaluator.
    native : NativeDiagram or None
        The compiled one, where it is used.

    Raises
    ------
    SimulationError
        If there is no such engine.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> Engine(clpt.closed_loop(clpt.paper_scenario()), engine="python").native is None
    True
    """

    def __init__(
        self,
        diagram: control.NonlinearIOSystem,
        params: Mapping[str, Any] | None = None,
        inputs: Inputs | None = None,
        engine: str | None = None,
    ):
        engine = engine or os.environ.get(VARIABLE) or "native"
        if engine not in ENGINES:
            raise SimulationError(f"engine = '{engine}': must be one of {', '.join(ENGINES)}")
        self.inputs = inputs
        self.native: Any = None
        self.sweep = Sweep(diagram, params)
        by_function = inputs is not None and inputs.samples is None and bool(diagram.ninputs)
        if engine == "native" and not by_function and self.sweep.nstates:
            self.native = _compiled(diagram, params)

    def run(
        self,
        x0: np.ndarray,
        times: np.ndarray,
        rtol: float,
        atol: float,
        progress: Callable[[float], None] | None = None,
        method: str = "dop853",
    ) -> Solution:
        """Integrate from the first to the last of the times."""
        if self.native is not None:
            return self.native.run(
                x0,
                times,
                rtol=rtol,
                atol=atol,
                samples=self._samples(),
                progress=progress,
                method=method,
            )
        from .integrate import integrate

        u, kinks = (None, None) if self.inputs is None else (self.inputs.at, self.inputs.kinks)
        return integrate(
            self.sweep, x0, times, rtol=rtol, atol=atol, inputs=u, stops=kinks, progress=progress
        )

    def signals(self, solution: Solution) -> np.ndarray:
        """Give all block outputs at a solution's times."""
        if self.native is not None:
            return self.native.signals(solution, self._samples())
        return sample_signals(self.sweep, solution, None if self.inputs is None else self.inputs.at)

    def _samples(self) -> tuple[np.ndarray, np.ndarray] | None:
        if self.inputs is None or self.native is None or not self.native.fused.ninputs:
            return None
        return self.inputs.samples


def _compiled(diagram: control.NonlinearIOSystem, params: Mapping[str, Any] | None) -> Any:
    from .engine import NativeDiagram
    from .reader import Unreadable

    try:
        return NativeDiagram(diagram, params)
    except (Unreadable, DiagramError) as error:
        warnings.warn(f"{diagram.name} runs in Python, not as machine code: {error}", stacklevel=4)
        return None
