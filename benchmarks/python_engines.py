"""python-control as it stands, and scipy's DOP853 over the blocks in Python."""

import control
import numpy as np

import clpt_control as clpt
from clpt_control.diagram import initial_state
from clpt_control.native.integrate import integrate
from clpt_control.native.sweep import Sweep

from .cases import Case
from .engines import timed


def sweep(case: Case):
    """Prepare scipy's DOP853 with one pass over the blocks per evaluation."""
    run, one = case.scenario.run, Sweep(clpt.closed_loop(case.scenario))
    x0 = initial_state(case.scenario)

    def go():
        solution, seconds = timed(
            lambda: integrate(one, x0, case.times, rtol=run.rtol, atol=run.atol)
        )
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
