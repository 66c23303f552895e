"""The fused native engine of clpt-control, alone and through `simulate`."""

import numpy as np

import clpt_control as clpt
from clpt_control.diagram import initial_state

from .cases import Case
from .engines import timed

ORDER = ("position", "predicted_position", "alpha", "feedback_gain", "feedforward_gain")


def prepare(case: Case):
    """Prepare the fused diagram; compiling it is not timed."""
    from clpt_control.native.engine import NativeDiagram

    scenario, run = case.scenario, case.scenario.run
    x0 = initial_state(scenario)
    native = NativeDiagram(clpt.closed_loop(scenario))

    def go() -> tuple[np.ndarray, float]:
        solution, seconds = timed(lambda: native.run(x0, case.times, rtol=run.rtol, atol=run.atol))
        return solution.x, seconds

    go()
    return go


def simulate(case: Case):
    """Prepare `simulate`: the diagram is wired and the Dataset filled within the time."""
    times = case.times
    clpt.simulate(case.scenario, times[:2])

    def go() -> tuple[np.ndarray, float]:
        dataset, seconds = timed(lambda: clpt.simulate(case.scenario, times))
        states = [dataset[name].values.reshape(len(times), -1) for name in ORDER]
        return np.hstack(states), seconds

    return go


def members(scenario):
    """Prepare an ensemble; not there yet."""
    raise NotImplementedError("clpt_control.native has no ensembles yet")


def advect(time, axis, u, v, x1, x2, step: float, steps: int) -> tuple[np.ndarray, float]:
    """Move passive particles; not there yet."""
    raise NotImplementedError("clpt_control.native moves no passive particles yet")
