"""Relations of a law's states at the start, and where rounding leaves them."""

from typing import Any

import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ...engine.record.symbolic import rational
from ...paper.laws.law import LEARNED
from ...simulation.initial_states import state_columns, state_of
from ...simulation.loop_blocks import paper_blocks
from ..algebra.decide import never_positive
from ..algebra.exact import vanishes
from ..algebra.numeric_values import NO_VALUE
from ..algebra.texts import short
from ..proofs.symbolic_loop import equated
from .invariant_loop import InvariantLoop
from .promises import truth_of
from .theorem_loop import theorem_scenario

REPELS = 1e-9  # of the largest eigenvalue: a positive real part that is no rounding
START = (0.4, -0.7)  # of vehicle and learner


def off_at_the_start(case: InvariantLoop) -> str:
    """Name the states whose relation does not hold where a run begins, whatever alpha is."""
    alpha, theta = np.random.default_rng(0).normal(size=(2, 2, case.N)).tolist()
    drawn = {
        "flow.parameters": theta,
        "vehicle.position": START,
        "learning.position": START,
    }
    drawn |= {} if case.law.alpha_is_constant else {"learning.parameters": alpha}
    scenario = theorem_scenario(case.N, case.law.name).with_values(drawn)
    blocks = paper_blocks(scenario)
    start, columns = state_of(scenario, blocks), state_columns(blocks)
    states = {
        port: start[columns[port]].reshape(s.shape) for port, s in case.states.items()
    }
    assert case.law.invariants is not None
    p = case.law.parameters_of(scenario.known_to_law)
    values = case.law.invariants(states, p, truth_of(scenario))
    off = [
        s
        for s, value in values.items()
        if not np.allclose(np.ravel(value), np.ravel(states[s]))
    ]
    return ", ".join(f"{name} at the start" for name in off)


def off_at_zero(case: InvariantLoop) -> str:
    """Return a state that is not what the truth makes it where all of a law's own are 0, or "".

    No start of alpha, K and Gamma, nor of the vehicle, is known to be true.
    """
    own = case.states.keys() - {"x", "z", *LEARNED}
    start: dict[Any, sympy.Expr] = {}
    for name in own | case.start.keys():
        value = np.asarray(case.start.get(name, 0.0), float)
        values = np.broadcast_to(value, case.states[name].shape)
        start |= equated(case.states, {name: np.vectorize(rational)(values)})
    for symbol, value in case.stated.items():
        residual = (symbol - value).xreplace(start)
        if residual.has(*NO_VALUE):  # P = R^-1 from R = 0: another start is meant
            continue
        if not vanishes(residual):
            begins = start.get(symbol, "anything")
            relation = f"{symbol} = {short(sympy.nsimplify(value), 40)}"
            return f"{relation} does not hold at the start, where it is {begins}"
    return ""


def repels(case: InvariantLoop) -> str:
    """Return which relation pushes away states that leave it by rounding, or "".

    With r = s - value beside each relation, r' = J r where r is small.  J is judged where it
    is constant; elsewhere by the sign of its trace, the rate at which volumes of r grow.
    """
    if not case.relations:
        return ""
    offsets = {s: sympy.Dummy(f"r_{s}", real=True) for s in case.relations}
    moved = {s: case.relations[s] + r for s, r in offsets.items()}
    rates = [
        case.masked(case.loop.derivative(s - value)).xreplace(moved)
        for s, value in case.relations.items()
    ]
    zero = dict.fromkeys(offsets.values(), sympy.S.Zero)
    J = sympy.Matrix(rates).jacobian([*offsets.values()]).xreplace(zero)
    J = J.xreplace(case.loop.values).applyfunc(sympy.expand)
    if J.is_zero_matrix:
        return ""
    if not J.free_symbols and not J.atoms(AppliedUndef):
        eigenvalues = np.linalg.eigvals(np.array(J, dtype=float))
        grows = eigenvalues.real.max() > REPELS * np.abs(eigenvalues).max()
    else:
        trace = sympy.expand(J.trace())
        grows = trace != 0 and never_positive(-trace, set())
    if not grows:
        return ""
    names = ", ".join(f"{s} = {short(v, 40)}" for s, v in case.relations.items())
    return f"{names}: a distance from it that rounding leaves grows"
