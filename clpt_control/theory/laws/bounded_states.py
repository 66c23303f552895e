"""States of a law that are bounded, or exist for all times, by V and by their own rates."""

from typing import Any

import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ...paper.laws.law import LEARNED
from ..algebra.exact import as_factors
from ..algebra.sums_of_squares import contains_all, squares
from ..proofs.symbolic_loop import equated
from .invariant_loop import arbitrary
from .semidefinite import SemidefiniteLoop
from .theorem_loop import ErrorCoordinates


def held(case: SemidefiniteLoop) -> tuple[set, set, list[str]]:
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
        same = equated(case.matrices, {port: case.symmetric[port]})
        grown += [port] * (flows and case.not_negative(rate, set(c)))
        at_zero = rate.xreplace(dict.fromkeys(M.flat, sympy.S.Zero))
        excess = (rate - at_zero).xreplace(same)
        has_bound = port == "P" and law.weighted_error is not None
        made = {*M.flat}
        made |= {*case.states["theta_hat"].flat} if law.makes_estimate else set()
        if has_bound or keeps_a_ceiling(case, port):
            bounded |= made
        elif flows and as_factors(excess).is_nonpositive:
            if at_zero == 0:
                bounded |= made
            elif not at_zero.free_symbols & {*loop.motion}:
                exist |= made
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
    if total and contains_all(total, [*e, *learned]):
        bounded |= {*coordinates.x, *coordinates.z, *learned}
        if law.weighted_error is not None:  # tr(eta P^-1 eta^T) bounds eta
            bounded |= {*case.states["alpha"].flat}
    for s, rate in loop.motion.items():
        share = sympy.cancel(rate / s) if s not in bounded else s
        if not share.has(s) and case.not_negative(-share):
            bounded.add(s)  # s' = -f s, f >= 0
    for _ in case.relations:
        for s, value in case.relations.items():
            states = value.free_symbols & loop.motion.keys()
            if states <= bounded and value.is_polynomial(*states):
                bounded.add(s)
    return bounded, exist, grown


def keeps_a_ceiling(case: SemidefiniteLoop, port: str) -> bool:
    """Return whether c^T M' c = 0 where M c = K c, K > 0 diagonal: then M <= K is kept.

    M begins at 0; K is made of parameters.
    """
    for after in case.loop.jumps.values():
        if any(after.get(m, m) != m for m in case.matrices[port].flat):
            return False
    K = np.array([sympy.Dummy(positive=True) for _ in case.matrices[port]])
    rate = case.rate_where(port, K)
    for factor in sympy.Mul.make_args(as_factors(rate)):
        base, power = factor.as_base_exp()
        is_linear = base.has(*K) and sympy.Poly(base, *K).total_degree() == 1
        if not (power.is_positive and is_linear):
            continue
        moving = base.free_symbols - {*K, *case.loop.values}
        moving |= base.atoms(AppliedUndef)
        equations = sympy.Poly(base, *moving).coeffs() if moving else [base]
        solutions = [*sympy.linsolve(equations, *K)]
        if solutions and all(k.is_positive for k in solutions[0]):
            return not case.forks(rate)
    return False
