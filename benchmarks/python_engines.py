"""python-control as it stands, and the engine with the blocks in Python."""

import control
import numpy as np

import clpt_control as clpt
from clpt_control.native.python_diagram import PythonDiagram
from clpt_control.simulation.loops import initial_state

from .cases import Case
from .engines import timed


def plain(case: Case):
    """Prepare the engine in Python: one pass over the blocks per evaluation."""
    run, one = case.scenario.run, PythonDiagram(clpt.closed_loop(case.scenario))
    x0 = initial_state(case.scenario)

    def go():
        solution, seconds = timed(lambda: one.run(x0, case.times, rtol=run.rtol, atol=run.atol))
        return solution.x, seconds

    return go


def python_control(case: Case):
    """Prepare `input_output_response`, started again at each waypoint."""
    loop, run = clpt.closed_loop(case.scenario), case.scenario.run
    tolerances = {"rtol": run.rtol, "atol": run.atol}

    def whole() -> np.ndarray:
        states = [initial_state(case.scenario)]
        for k in range(len(case.times) - 1):
            response = control.input_output_response(
                loop,
                case.times[k : k + 2],
                0,
                states[-1],
                params={"reference.interval": float(k)},
                solve_ivp_method="DOP853",
                solve_ivp_kwargs=tolerances,
            )
            states.append(response.states[:, -1])
        return np.array(states)

    return lambda: timed(whole)
