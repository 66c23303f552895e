"""Prove a law whose states keep relations between each other, such as P with the information.

A law's row says which relations its states `keep` (state = expression of the others), which
matrices, its `cones`, are not negative, what V' `losses` are beyond e^T KD e, products of factors
that are not negative, and what is a `push` beside.  Each is then shown:

    s' = (expression)'                    where the relations hold: what starts there stays
    c^T M' c >= 0  where  M c = 0         the cone M >= 0 is not left (Nagumo)
    V' = -e^T KD e - losses + push        where the relations hold, V and losses not negative

A law without a push is proved, one with is bounded by it.  All is exact for N = 1, 2, 3, and the
running blocks give the same V'.  Where its states jump, at times that may be any, x and inputs
being those right before:

    the relations before give the relations after,  M >= 0 gives M+ >= 0,  V+ <= V

so that between and across jumps V falls.
For a law that makes an estimate theta_hat = theta + d with its covariance M, the third is

    V' = -e^T KD e + e^T (theta - theta_hat) phi          Theorem 3.1
    (d M^-1 d^T)' = gains <= 0                            so d never grows in this norm

A law of which no parameter's error ever rises, eta = w eta(0), w' = -f w, f >= 0, takes no part of
e into alpha', so that V' has e^T eta phi left, which bounds the mean square of e by that of
eta phi; its readout is theta where its condition holds:

    V' = -e^T KD e + e^T eta phi - f |eta|^2/gamma,    |eta_ik| never rises

More is said of laws with a covariance P of least squares:

    P'   = lambda P - P phi_f phi_f^T P/r^2,    lambda = lambda_0 (1 - tr P/k_0)
    rho' = -lambda rho

    (k_0 - tr P)'              = |P phi_f|^2/r^2 >= 0 where tr P = k_0, so tr P <= k_0
    (rho P)'                   = -rho (P phi_f) (P phi_f)^T/r^2, so P <= P(0)/rho
    P' + P phi_f phi_f^T P/r^2 = lambda P >= 0, so P >= (P(0)^-1 + int phi_f phi_f^T/r^2)^-1
    |p P|^2 <= tr P p P p^T    for every row p, so |eta|^2 <= k_0 tr(eta P^-1 eta^T)

and where CLPE does not drive alpha, tr(eta P^-1 eta^T)' = -|eta phi_f|^2/r^2 - lambda times it.
With lambda_0 = 0 rho is 1 at all times, and the second is P^-1 >= P(0)^-1.
"""

import math
from itertools import combinations
from typing import Any

import numpy as np
import sympy

from ...blocks.laws.law import Law
from ...equations.symbolic import UNEXPANDED
from .kept_loop import Kept, cases_of, exact_step, kept_step, same_running
from .lemmas import young_step
from .proof import Step, short
from .signs import vanishes
from .theorem_loop import Claim, decay, decay_and_known_error

GIVEN = "V' = -e^T KD e + e^T (theta - theta_hat) phi"


def jump_steps(cases: list[Kept], law: Law) -> list[Step]:
    """Check what the states keep, and V, where they jump; nothing where they do not."""
    if not any(case.loop.jumps for case in cases):
        return []
    left = f"{', '.join(law.cones)} >= 0 is not left where they jump"
    return [
        exact_step(cases, "and is kept where they jump", Kept.left_at_a_jump),
        exact_step(cases, left, Kept.cone_is_kept_at_a_jump),
        exact_step(cases, "V does not rise where they jump", Kept.V_rises_by),
    ]


def kept_steps(law: Law, points: int) -> list[Step]:
    """Check a law whose row states what its states keep, for N = 1, 2, 3."""
    cases, names = cases_of(law), ", ".join(law.cones)
    claim: Claim = decay_and_known_error if law.makes_estimate else decay

    def rest(case: Kept) -> str:
        return case.left_over(claim, case.push - sum(map(math.prod, case.losses)))

    def grows(case: Kept) -> str:
        jumps = "its states jump, and what its error does there is not judged"
        return jumps if case.loop.jumps else case.estimate_grows()

    def cones_left(case: Kept) -> str:
        return ", ".join(port for port in law.cones if not case.cone_is_kept(port))

    def not_negative(case: Kept) -> bool:
        return case.not_negative(case.V) and case.loses()

    if law.makes_estimate:
        third = [
            exact_step(cases, f"{GIVEN}, N = 1, 2, 3", rest),
            exact_step(cases, f"the error of the estimate never grows: {law.says}", grows),
        ]
    else:
        third = [
            exact_step(cases, f"V' as claimed, N = 1, 2, 3: {law.says}", rest),
            *(covariance_steps(cases, law.push is None) if law.over else []),
            exact_step(
                cases, f"with {names} >= 0 V and what V' loses are not negative", not_negative
            ),
        ]
    inner = f"c^T M' c >= 0 where M c = 0, so M >= 0 is not left: {names}"
    return [
        kept_step(cases),
        *jump_steps(cases, law),
        exact_step(cases, inner, cones_left),
        *third,
        same_running(cases, points),
    ]


MAXIMUM = sympy.Function(UNEXPANDED["maximum"], real=True)
WHERE = sympy.Function(UNEXPANDED["where"], real=True)


def shrinking_steps(law: Law, points: int) -> list[Step]:
    """Check a law whose row names the state with which every parameter's error shrinks."""
    cases, w = cases_of(law), law.shrinking

    def rest(case: Kept) -> str:
        return case.left_over(decay, driven(case, law))

    steps = [
        kept_step(cases),
        exact_step(
            cases, f"eta = {w} eta(0) for every parameter", lambda case: _is_all_of_alpha(case, law)
        ),
        exact_step(
            cases,
            f"{w}' = -f {w}, f >= 0, so no parameter's error rises",
            lambda case: _rises(case, law),
        ),
        exact_step(cases, f"V' = {law.says}, N = 1, 2, 3", rest),
        exact_step(cases, "V is not negative", lambda case: case.not_negative(case.V)),
        young_step(),
        same_running(cases, points),
    ]
    if law.readout:
        claim = f"{law.readout} is theta where its condition holds, and -alpha elsewhere"
        steps.insert(3, exact_step(cases, claim, lambda case: _reads(case, law)))
    return steps


def _rises(case: Kept, law: Law) -> str:
    """Return why w is not known to fall, or nothing."""
    if case.loop.jumps:
        return "its states jump, and what its errors do there is not judged"
    f = rate_of_shrinking(case, law)
    if not f.is_nonnegative or sympy.expand(f) == 0:
        return f"{law.shrinking}' = {short(case.rates[law.shrinking][0])}"
    return ""


def rate_of_shrinking(case: Kept, law: Law) -> sympy.Expr:
    """Return f of w' = -f w, each maximum(a, b) with a positive one a positive symbol."""
    (w,), (rate,) = case.states[law.shrinking], case.rates[law.shrinking]
    f = -case.veiled(rate) / w
    return sympy.nan if f.has(w) else f


def driven(case: Kept, law: Law) -> sympy.Expr:
    """Return e^T eta phi - f |eta|^2/gamma, gamma those of V."""
    p, loop = case.loop.parameters, case.loop
    eta = p["true_flow"].theta + case.states["alpha"]
    w, rate = case.states[law.shrinking][0], case.rates[law.shrinking][0]
    pushed = loop.signals["e"] @ (eta @ loop.inputs["phi_x"])
    return pushed + rate / w * np.sum(eta**2 / p["lyapunov"].gain)


def _is_all_of_alpha(case: Kept, law: Law) -> bool:
    """Return whether each alpha is kept at w times what does not move, less theta."""
    (w,) = case.states[law.shrinking]
    theta = case.loop.parameters["true_flow"].theta
    for alpha, own in zip(case.states["alpha"].flat, theta.flat, strict=True):
        eta = sympy.expand(case.relations.get(alpha, alpha) + own)
        first = sympy.cancel(eta / w)
        if first == 0 or first.free_symbols & case.loop.motion.keys() or not first.has(own):
            return False
    return True


def _reads(case: Kept, law: Law) -> bool:
    """Return whether a readout where(1 - w >= m, a, -alpha) is theta in its first branch."""
    (w,) = case.states[law.shrinking]
    read, theta = case.loop.signals[law.readout], case.loop.parameters["true_flow"].theta
    triples = zip(read.flat, case.states["alpha"].flat, theta.flat, strict=True)
    return all(_is_readout(case, *triple, w) for triple in triples)


def _is_readout(case: Kept, found: Any, alpha: Any, theta: Any, w: Any) -> bool:
    if not isinstance(found, WHERE):
        return False
    condition, then, before = found.args
    if str(getattr(condition, "func", "")) != "ge" or condition.args[0] != 1 - w:
        return False
    margin = condition.args[1]
    known = {MAXIMUM(*pair): 1 - w for pair in ((margin, 1 - w), (1 - w, margin))}
    right = vanishes(case.put(then.subs(known)) - theta)
    return bool(margin.is_positive) and right and sympy.expand(before + alpha) == 0


def covariance_steps(cases: list[Kept], driven: bool) -> list[Step]:
    """Check the bounds for each case, whose states hold P and rho.

    `driven` is whether CLPE drives alpha.
    """
    claims = {
        "tr(eta P^-1 eta^T)' = -|eta phi_f|^2/r^2 - lambda tr(eta P^-1 eta^T): it never "
        "rises": _falls,
        "(k_0 - tr P)' >= 0 where tr P = k_0: tr P <= k_0 is kept": _top,
        "(rho P)' = -rho (P phi_f) (P phi_f)^T/r^2: P^-1 >= rho P(0)^-1 at all times": _above,
        "P' + P phi_f phi_f^T P/r^2 = lambda P: P^-1 <= P(0)^-1 + int phi_f phi_f^T/r^2": _below,
        "|eta|^2 <= tr P tr(eta P^-1 eta^T) <= k_0 tr(eta P^-1 eta^T): eta is bounded by "
        "V": _cauchy,
    }
    checks = list(claims.items())[driven:]
    return [exact_step(cases, claim, check) for claim, check in checks]


def _parts(case: Kept) -> tuple[Any, Any, Any]:
    """Return P, P' and (P phi_f) (P phi_f)^T/r^2, symmetric."""
    P = case.symmetric["P"]
    slope = np.vectorize(case.put, otypes=[object])(case.slopes["P"])
    seen = P @ case.states["phi_f"]
    return P, slope, np.outer(seen, seen) / case.parameters.noise**2


def _top(case: Kept) -> bool:
    """Return whether the slope of k_0 - tr P, where that is 0, is a sum of squares."""
    P, slope, _ = _parts(case)
    first = P[0, 0]
    touching = {first: case.parameters.largest - sum(P.diagonal()[1:])}
    seen = (P @ case.states["phi_f"]) / case.parameters.noise
    rest = -np.trace(slope) - sum(seen**2)
    return vanishes(rest.subs(touching))


def _above(case: Kept) -> bool:
    """Return whether rho P comes down by a square and nothing else."""
    P, slope, seen = _parts(case)
    rho, rate = case.states["rho"][0], case.put(case.rates["rho"][0])
    rest = rate * P + rho * slope + rho * seen
    return all(map(vanishes, rest.ravel()))


def _below(case: Kept) -> bool:
    """Return whether P' is lambda P, lambda >= 0, beside what is learned."""
    P, slope, seen = _parts(case)
    share = 1 - np.trace(P) / case.parameters.largest
    rest = slope + seen - case.parameters.forgetting * share * P
    given = case.parameters.forgetting
    return bool(given.is_nonnegative) and all(map(vanishes, rest.ravel()))


def _falls(case: Kept) -> bool:
    """Return whether tr(eta P^-1 eta^T) falls by what is seen and what is forgotten."""
    P, p = case.symmetric["P"], case.parameters
    size = np.sum((case.held @ P) * case.held)
    share = p.forgetting * (1 - np.trace(P) / p.largest)
    seen = sum((case.held @ P @ case.states["phi_f"]) ** 2) / p.noise**2
    return vanishes(case.put(case.loop.derivative(size)) + seen + share * size)


def _cauchy(case: Kept) -> bool:
    """Return whether tr P p P p^T - |p P|^2 is a sum of squares for P = sum of v v^T."""
    n = len(case.cones["P"])
    p = np.array(sympy.symbols(f"p_1:{n + 1}", real=True))
    v = np.array(sympy.symbols(f"v_1:{n * n + 1}", real=True)).reshape(n, n)
    P = v.T @ v
    squares = sum(
        (sum((v[a] * (v[b] @ p) - v[b] * (v[a] @ p)) ** 2) for a, b in combinations(range(n), 2)),
        start=sympy.Integer(0),
    )
    return vanishes(np.trace(P) * (p @ P @ p) - sum((p @ P) ** 2) - squares)
