"""The fused native engine of clpt-control, alone and through `simulate`."""

import numpy as np

import clpt_control as clpt
from clpt_control.simulation.loops import initial_state

from .cases import Case
from .engines import timed

ORDER = ("position", "predicted_position", "alpha", "feedback_gain", "feedforward_gain")


def prepare(case: Case):
    """Prepare the fused diagram; compiling it is not timed."""
    from clpt_control.native.native_diagram import NativeDiagram

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
    """Prepare an ensemble: eight members at once where the processor allows it."""
    from clpt_control.ensemble.members import Ensemble

    N, run = scenario.basis.N, scenario.run
    ensemble = Ensemble(
        scenario,
        {
            "flow.parameters": (2, N),
            "learning.gain": (),
            "vehicle.position": (2,),
            "learning.position": (2,),
        },
    )
    times = np.array([0.0, run.duration])

    def all_of_them(parameters, states) -> np.ndarray:
        values = {
            "flow.parameters": parameters[:, 5 * N : 7 * N].reshape(-1, 2, N),
            "learning.gain": parameters[:, -1],
            "vehicle.position": states[:, 0:2],
            "learning.position": states[:, 2:4],
        }
        made = ensemble.members(values, run.duration)
        return ensemble.run(made, times, run.rtol, run.atol).states[:, -1]

    return lambda parameters, states: timed(all_of_them, parameters, states)


def advect(time, axis, u, v, x1, x2, step: float, steps: int) -> tuple[np.ndarray, float]:
    """Move passive particles: a user's block, RK4; final positions (2, n) and seconds."""
    from clpt_control.native.native_diagram import NativeDiagram

    from .drifter import drifter

    native = NativeDiagram(clpt.connect([drifter(time, axis, u, v)], name="drifter"))
    starts = np.column_stack([x1, x2])
    ends = np.array([0.0, step * steps])
    native.run_many(starts[:2], ends, step=step)
    found, seconds = timed(lambda: native.run_many(starts, ends, step=step))
    return found[:, -1].T, seconds
