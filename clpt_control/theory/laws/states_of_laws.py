"""States of a law beside alpha, K and Gamma: their relations, and which of them are bounded.

Of the covariance P of least squares, and of the errors eta of its law, it is shown that

    P'   = lambda P - P phi_f phi_f^T P/r^2,    lambda = lambda_0 (1 - tr P/k_0)
    rho' = -lambda rho

    (k_0 - tr P)'              = |P phi_f|^2/r^2 >= 0 where tr P = k_0, so tr P <= k_0
    (rho P)'                   = -rho (P phi_f) (P phi_f)^T/r^2, so P <= P(0)/rho
    P' + P phi_f phi_f^T P/r^2 = lambda P >= 0, so P >= (P(0)^-1 + int phi_f phi_f^T/r^2)^-1
    |p P|^2 <= tr P p P p^T    for every row p, so |eta|^2 <= k_0 tr(eta P^-1 eta^T)

and where CLPE does not drive alpha, tr(eta P^-1 eta^T)' = -|eta phi_f|^2/r^2 - lambda times it.
With lambda_0 = 0 rho is 1 at all times, and the second is P^-1 >= P(0)^-1.
"""

from functools import cache, partial
from itertools import combinations
from typing import Any

import numpy as np
import sympy
from sympy import Dummy, Poly, symbols
from sympy.core.function import AppliedUndef

from ...engine.record.symbolic import rational
from ...paper.laws.law import LEARNED, Law
from ...simulation.initial_states import state_columns, state_of
from ...simulation.loop_blocks import paper_blocks
from ..algebra.exact import as_factors, vanishes
from ..algebra.numeric_values import NO_VALUE
from ..algebra.sums_of_squares import squares, zero_of
from ..algebra.texts import short
from ..proofs.symbolic_loop import equated
from .promises import truth_of
from .theorem_loop import ErrorCoordinates, theorem_scenario

START = (0.4, -0.7)  # of vehicle and learner
BOUNDS = (  # of eta and P, as `covariance_rates` has what moves
    "`tr(eta P^-1 eta^T)' = -|eta phi_f|^2/r^2 - lambda tr(eta P^-1 eta^T)`: it never rises",
    "`(k_0 - tr P)' >= 0` where `tr P = k_0`: `tr P <= k_0` is kept",
    "`(rho P)' = -rho (P phi_f) (P phi_f)^T/r^2`: `P^-1 >= rho P(0)^-1` at all times",
    "`P' + P phi_f phi_f^T P/r^2 = lambda P`: `P^-1 <= P(0)^-1 + int phi_f phi_f^T/r^2`",
)
BOUNDED_BY_V = (
    "`|eta|^2 <= tr P tr(eta P^-1 eta^T) <= k_0 tr(eta P^-1 eta^T)`: "
    "`eta` is bounded by V"
)


@cache
def arbitrary(n: int, name: str = "c") -> np.ndarray:
    """Return n symbols that may be any numbers, the same ones each time: what is found of them."""
    return np.array(symbols(f"{name}_1:{n + 1}", real=True, cls=Dummy), dtype=object)


def off_at_the_start(case: Any) -> str:
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


def off_at_zero(case: Any) -> str:
    """Return a state that is not what the truth makes it where all of a law's own are 0, or "".

    No start of alpha, K and Gamma, nor of the vehicle, is known to be true.
    """
    law_states = case.states.keys() - {"x", "z", *LEARNED}
    start: dict[Any, sympy.Expr] = {}
    for name in law_states | case.start.keys():
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


def bounded_states(case: Any) -> tuple[set, set, list[str]]:
    """Return states that are bounded, others that exist, and matrices positive at the start.

    V holds e and what is learned, of M that never shrinks with a multiple of I in its place:
    it began above one.  M that keeps a ceiling is bounded, with an estimate whose error over M
    never rises, and what is made of bounded states.
    """
    loop, V, law = case.loop, case.V, case.law
    grown, bounded, exist = list[str](), set[Any](), set[Any]()
    for port, M in case.matrices.items():
        c = arbitrary(len(M))
        rate = c @ case.rates[port] @ c
        flows = not loop.jumps
        symmetry = equated(case.matrices, {port: case.symmetric[port]})
        grown += [port] * (flows and case.not_negative(rate, set(c)))
        at_zero = rate.xreplace(dict.fromkeys(M.flat, sympy.S.Zero))
        excess = (rate - at_zero).xreplace(symmetry)
        has_bound = port == "P" and law.weighted_error is not None
        entries = {*M.flat}
        entries |= {*case.states["theta_hat"].flat} if law.makes_estimate else set()
        if has_bound or keeps_a_ceiling(case, port):
            bounded |= entries
        elif flows and as_factors(excess).is_nonpositive:
            if at_zero == 0:
                bounded |= entries
            elif not at_zero.free_symbols & {*loop.motion}:
                exist |= entries
        bound = sympy.eye(len(M)) if port in grown else sympy.zeros(len(M))
        V = V.xreplace(dict(zip(M.flat, bound, strict=True)))
    in_V = [port for port in LEARNED if port in loop.states]
    if law.error_left:  # its w falls, each parameter's error is w times the first one
        bounded |= {*case.states[law.error_left].flat, *case.states["alpha"].flat}
    if law.error_left or law.weighted_error is not None:
        in_V.remove("alpha")
    coordinates = ErrorCoordinates(loop)
    e, V = coordinates.e, V.xreplace(coordinates.in_e)
    learned = [s for port in in_V for s in loop.states[port].flat]
    total = squares(V, V.free_symbols - {*e, *learned}, functions_are_free=False)
    if total and zero_of(total, [*e, *learned]):
        bounded |= {*coordinates.x, *coordinates.z, *learned}
        if law.weighted_error is not None:  # tr(eta P^-1 eta^T) bounds eta
            bounded |= {*case.states["alpha"].flat}
    for s, rate in loop.motion.items():
        share = sympy.cancel(rate / s) if s not in bounded else s
        if not share.has(s) and case.not_negative(-share):
            bounded.add(s)  # s' = -f s, f >= 0
    for _ in case.relations.solved:
        for s, value in case.relations.solved.items():
            states = value.free_symbols & loop.motion.keys()
            if states <= bounded and value.is_polynomial(*states):
                bounded.add(s)
    return bounded, exist, grown


def keeps_a_ceiling(case: Any, port: str) -> bool:
    """Return whether c^T M' c = 0 where M c = K c, K > 0 diagonal: then M <= K is kept.

    M begins at 0; K is made of parameters.
    """
    for after in case.loop.jumps.values():
        if any(after.get(m, m) != m for m in case.matrices[port].flat):
            return False
    K = np.array([Dummy(positive=True) for _ in case.matrices[port]])
    rate = case.rate_where(port, K)
    for factor in sympy.Mul.make_args(as_factors(rate)):
        base, power = factor.as_base_exp()
        is_linear = base.has(*K) and Poly(base, *K).total_degree() == 1
        if not (power.is_positive and is_linear):
            continue
        moving = base.free_symbols - {*K, *case.loop.values}
        moving |= base.atoms(AppliedUndef)
        equations = Poly(base, *moving).coeffs() if moving else [base]
        solutions = [*sympy.linsolve(equations, *K)]
        if solutions and all(k.is_positive for k in solutions[0]):
            return not case.forks(rate)
    return False


# --- the covariance of least squares --------------------------------------------------------------


def covariance_claims(law: Law) -> dict[str, Any]:
    """Return the bounds of P and eta that a law has: claim -> what it shows, its check."""
    # where CLPE drives alpha BOUNDS[0] does not hold
    offset = int(not law.driving_estimate)
    claims = {
        BOUNDS[k]: ("", partial(_has_rate, index=k)) for k in range(offset, len(BOUNDS))
    }
    return {**claims, BOUNDED_BY_V: ("", _is_bounded_by_V)}


def _has_rate(case: Any, index: int) -> bool:
    """Return whether a quantity of `covariance_rates` has its rate on a law's loop."""
    pairs = zip(*map(np.ravel, covariance_rates(case)[index]), strict=True)
    return bool(case.parameters.forgetting.is_nonnegative) and all(
        vanishes(case.reduced(case.loop.derivative(a) - rate)) for a, rate in pairs
    )


def covariance_rates(case: Any) -> tuple[tuple[Any, Any], ...]:
    """Return quantities of P and eta, each with its rate; lambda is 0 where tr P = k_0."""
    P, p, rho, error = (
        case.states["P"],
        case.parameters,
        case.states["rho"],
        case.weighted_error,
    )
    forgetting = p.forgetting * (1 - np.trace(P) / p.largest)
    gain, size = P @ case.states["phi_f"] / p.noise, np.sum((error @ P) * error)
    return (
        (size, -sum((error @ gain) ** 2) - forgetting * size),
        (p.largest - np.trace(P), sum(gain**2) - forgetting * np.trace(P)),
        (rho * P, -rho * np.outer(gain, gain)),
        (P, forgetting * P - np.outer(gain, gain)),
    )


def _is_bounded_by_V(case: Any) -> bool:
    """Return whether tr P p P p^T - |p P|^2 is a sum of squares for P = sum of v v^T."""
    n = len(case.matrices["P"])
    p = np.array(symbols(f"p_1:{n + 1}", real=True))
    v = np.array(symbols(f"v_1:{n * n + 1}", real=True)).reshape(n, n)
    P = v.T @ v
    squares = sum(
        sum((v[a] * (v[b] @ p) - v[b] * (v[a] @ p)) ** 2)
        for a, b in combinations(range(n), 2)
    )
    return vanishes(np.trace(P) * (p @ P @ p) - sum((p @ P) ** 2) - squares)
