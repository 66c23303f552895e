"""heyoka: Taylor series of high order through LLVM, on the traced diagram."""

import heyoka as hy
import numpy as np

import clpt_control as clpt
from clpt_control import initial_state

from .cases import Case
from .engines import timed
from .traced import rates

# The derivatives of |x - c| are not finite at x = c, where the paper's run starts.
KINK = 1e-24
FUNCTIONS = {
    "exp": hy.exp,
    "cos": hy.cos,
    "sin": hy.sin,
    "sqrt": lambda a: hy.sqrt(a + KINK),
}


def system(scenario, parameters=None) -> list:
    """Return the equations, with zc as the parameters 0 and 1."""
    diagram = clpt.closed_loop(scenario)
    states = hy.make_vars(*[f"s{i}" for i in range(2 * scenario.basis.N + 8)])
    given = {"reference": [hy.par[0], hy.par[1]]}
    found = rates(diagram, hy.time, states, FUNCTIONS, given, parameters)
    return list(zip(states, [hy.expression(0.0) + f for f in found], strict=True))


def prepare(case: Case):
    """Prepare one run at a tolerance of rtol."""
    scenario = case.scenario
    x0, points = initial_state(scenario), scenario.waypoints
    solver = hy.taylor_adaptive(
        system(scenario),
        x0,
        tol=scenario.run.rtol,
        compact_mode=case.N > 10,
        pars=[0.0, 0.0],
    )

    def whole() -> np.ndarray:
        solver.time, solver.state[:] = 0.0, x0
        states = [x0]
        for k, until in enumerate(case.times[1:]):
            solver.pars[:] = points[k % len(points)]
            solver.propagate_until(until)
            states.append(solver.state.copy())
        return np.array(states)

    return lambda: timed(whole)


def members(scenario):
    """Prepare batches of eight members, one in each SIMD lane."""
    N, lanes = scenario.basis.N, hy.recommended_simd_size()
    theta = np.array([hy.par[2 + i] for i in range(2 * N)], dtype=object).reshape(2, N)
    own = {("true_flow", "theta"): theta, ("adaptation", "gain"): hy.par[2 + 2 * N]}
    points, run = scenario.waypoints, scenario.run
    ends = np.arange(1, round(run.duration / scenario.reference.dwell) + 1)
    solver = hy.taylor_adaptive_batch(
        system(scenario, own),
        np.zeros((2 * N + 8, lanes)),
        tol=run.rtol,
        pars=np.zeros((2 * N + 3, lanes)),
    )

    def all_of_them(parameters, states) -> np.ndarray:
        final = np.empty_like(states)
        for first in range(0, len(states), lanes):
            chosen = np.minimum(np.arange(first, first + lanes), len(states) - 1)
            solver.set_time(0.0)
            solver.state[:] = states[chosen].T
            solver.pars[2 : 2 + 2 * N] = parameters[chosen, 5 * N : 7 * N].T
            solver.pars[2 + 2 * N] = parameters[chosen, -1]
            for k in ends:
                solver.pars[:2] = points[(k - 1) % len(points)][:, None]
                solver.propagate_until([k * scenario.reference.dwell] * lanes)
            final[chosen] = solver.state.T
        return final

    return lambda parameters, states: timed(all_of_them, parameters, states)
