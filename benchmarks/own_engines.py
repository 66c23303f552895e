"""clpt-control: machine code, `simulate`, ensembles, Python; and python-control as it stands."""

import control
import numpy as np

import clpt_control as clpt
from clpt_control import initial_state
from clpt_control.engine.solver.native_diagram import compile
from clpt_control.engine.solver.python_diagram import PythonDiagram

from .cases import Case
from .engines import timed

ORDER = ("position", "predicted_position", "alpha", "feedback_gain", "feedforward_gain")


def prepare(case: Case):
    """Prepare the fused diagram; compiling it is not timed."""
    scenario, run = case.scenario, case.scenario.run
    x0 = initial_state(scenario)
    native = compile(clpt.closed_loop(scenario))

    def go() -> tuple[np.ndarray, float]:
        solution, seconds = timed(
            lambda: native.run(x0, case.times, rtol=run.rtol, atol=run.atol)
        )
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
    from clpt_control.ensemble.varied_scenario import VariedScenario

    N, run = scenario.basis.N, scenario.run
    keys = ("flow.parameters", "learning.gain", "vehicle.position", "learning.position")
    ensemble = Ensemble(VariedScenario(scenario), keys)
    times = np.array([0.0, run.duration])

    def all_of_them(parameters, states) -> np.ndarray:
        values = {
            "flow.parameters": parameters[:, 5 * N : 7 * N].reshape(-1, 2, N),
            "learning.gain": parameters[:, -1],
            "vehicle.position": states[:, 0:2],
            "learning.position": states[:, 2:4],
        }
        made = ensemble.members(values)
        return ensemble.run(made, times).states[:, -1]

    return lambda parameters, states: timed(all_of_them, parameters, states)


def in_python(case: Case):
    """Prepare the engine in Python: one pass over the blocks per evaluation."""
    run, one = case.scenario.run, PythonDiagram(clpt.closed_loop(case.scenario))
    x0 = initial_state(case.scenario)

    def go():
        solution, seconds = timed(
            lambda: one.run(x0, case.times, rtol=run.rtol, atol=run.atol)
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
