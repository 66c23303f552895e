"""How far rounding alone can take one reading of a diagram from another.

A diagram is run again and again at points that are off by a hundred ulps, states, inputs, time and
parameters: what that moves, rounding on the way may move, and where it turns a choice it is seen.
Python adds one term after the other, machine code eight sums side by side, and SymPy makes 320 a of
the sum of 320 a: none is nearer to the truth, and what a sum feeds feels it.
"""

from typing import Any

import numpy as np

from clpt_control.engine.solver.evaluation_pass import Sweep
from clpt_control.engine.solver.python_diagram import PythonDiagram

OFF = 100 * 2.0**-52
RUNS = 40
MORE = 4  # as what is found may be off, beside what these runs show


@np.errstate(all="ignore")
def rounding_of(diagram: Any, t: float, x: Any, u: Any) -> np.ndarray:
    """Return by how much rates, outputs, and states after all jumps may be off."""
    sweep, draw = PythonDiagram(diagram).sweep, np.random.default_rng(0)

    def near(value: Any) -> Any:
        if isinstance(value, int):
            return value
        return np.asarray(value * (1.0 + OFF * draw.uniform(-1, 1, np.shape(value))))[
            ()
        ]

    found = []
    for _ in range(RUNS):
        numbers = (
            {n: near(value) for n, value in p._asdict().items()}
            for p in sweep.parameters
        )
        each = zip(sweep.parameters, numbers, strict=True)
        other = Sweep(sweep.wiring, [p._replace(**own) for p, own in each])
        other.enter(t)
        at = near(np.float64(t)), near(np.asarray(x)), near(np.asarray(u))
        values = other.derivative(*at), other.outputs(), other.jump(*at, other.jumping)
        found.append(np.concatenate(values))
    return MORE * (np.nanmax(found, axis=0) - np.nanmin(found, axis=0))
