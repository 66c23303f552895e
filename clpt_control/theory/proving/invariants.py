"""The proof of a law whose states have invariants, such as P beside the information.

A law's row says which `invariants` its states have (state = expression of the others), which
matrices are `semidefinite`, what V' `losses` are beyond e^T KD e, products of factors
that are not negative, and what is a `perturbation` beside.  Each is then shown:

    s' = (expression)'                    where the relations hold: what starts there stays
    c^T M' c >= 0  where  M c = 0         M stays semidefinite (Nagumo)
    V' = -e^T KD e - losses + perturbation    where the relations hold, V and losses not negative

A law without a perturbation is proved, one with is bounded by it.  All is exact for N = 1, 2, 3,
and the running blocks give the same V'.  Where its states jump, at times that may be any, x and
inputs being those right before:

    the relations before give the relations after,  M >= 0 gives M+ >= 0,  V+ <= V

so that between and across jumps V falls.
For a law that makes an estimate theta_hat = theta + d with its covariance M, the third is

    V' = -e^T KD e + e^T (theta - theta_hat) phi          Theorem 3.1
    (d M^-1 d^T)' = error_growth <= 0                     so d never grows in this norm

A law of which no parameter's error ever rises, eta = w eta(0), w' = -f w, f >= 0, takes no part of
e into alpha'.  So V' has e^T eta phi left, which bounds the mean square of e by that of eta phi;
its readout is theta where its condition holds:

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

from collections.abc import Callable
from functools import partial
from itertools import chain, combinations, filterfalse
from typing import Any

import numpy as np
import sympy

from ...blocks.laws.law import Law
from . import invariant_loop
from .invariant_loop import InvariantLoop
from .lemmas import young_step
from .proof import Step, exact_step, short
from .running_rate import running_step
from .signs import vanishes
from .theorem_loop import KNOWN_ERROR, decay, decay_and_known_error
from .words import MAXIMUM, WHERE

Claims = dict[str, Callable[[InvariantLoop], bool | str]]


def invariant_steps(law: Law, points: int, single: InvariantLoop | None = None) -> list[Step]:
    """Check a law whose row has invariants, for N = 1, 2, 3; or a single loop, of your own law."""
    cases = [single] if single else [InvariantLoop(law, N) for N in invariant_loop.SIZES]
    start = InvariantLoop.off_at_zero if single else InvariantLoop.off_at_the_start
    claims: Claims = {
        f"what the law's states keep is kept{' where it begins so' * bool(single)}": (
            lambda case: case.broken() or start(case)
        )
    }
    if law.error_left:
        claims |= shrinking_claims(law)
    else:
        claims |= jump_claims(law) if cases[0].loop.jumps else {}
        own = f"N = {single.N} and the parameters as they are" if single else "N = 1, 2, 3"
        falls = partial(falling_claims, sizes=own)
        claims |= estimate_claims(law) if law.makes_estimate else falls(law)
    steps = [exact_step(cases, claim, check) for claim, check in claims.items()]
    steps += [young_step()] if law.error_left else []
    two = cases[len(cases) // 2]
    return [*steps, running_step(lambda: (two.diagram, two.loop), points)]


def jump_claims(law: Law) -> Claims:
    """Return what is to be shown of invariants, semidefinite states and V where states jump."""
    names = ", ".join(law.semidefinite)
    return {
        "and is kept where they jump": InvariantLoop.broken_at_a_jump,
        f"{names} >= 0 is not left where they jump": InvariantLoop.semidefinite_after_a_jump,
        "V does not rise where they jump": InvariantLoop.V_rises_by,
    }


def semidefinite_claims(law: Law) -> Claims:
    """Return what is to be shown of semidefinite states between jumps."""
    names = law.semidefinite
    claim = f"c^T M' c >= 0 where M c = 0, so M >= 0 is not left: {', '.join(names)}"
    left: Claims = {claim: lambda case: ", ".join(filterfalse(case.stays_semidefinite, names))}
    return left if names else {}


def falling_claims(law: Law, sizes: str) -> Claims:
    """Return what is to be shown of V' of a law without an estimate."""
    given = f"with {', '.join(law.semidefinite)} >= 0 " if law.semidefinite else ""
    return {
        **semidefinite_claims(law),
        f"V' as claimed, {sizes}: {law.V_rate}": lambda case: case.left_over(decay, case.beside),
        **(covariance_claims(law.perturbation is None) if law.weighted_error else {}),
        f"{given}V and what V' loses are not negative": (
            lambda case: all(map(case.not_negative, {case.V, *chain.from_iterable(case.losses)}))
        ),
    }


def estimate_claims(law: Law) -> Claims:
    """Return what is to be shown of a law that makes an estimate."""
    return {
        **semidefinite_claims(law),
        f"{KNOWN_ERROR}, N = 1, 2, 3": (
            lambda case: case.left_over(decay_and_known_error, case.beside)
        ),
        f"the error of the estimate never grows: {law.V_rate}": InvariantLoop.estimate_grows,
    }


def shrinking_claims(law: Law) -> Claims:
    """Return what is to be shown of a law whose state w scales every parameter's error."""
    w, read = law.error_left, {}
    if law.readout:
        read = {f"{law.readout} is theta where its condition holds, and -alpha elsewhere": _reads}
    return {
        f"eta = {w} eta(0) for every parameter": _scales_all_errors,
        f"{w}' = -f {w}, f >= 0, so no parameter's error rises": _why_rising,
        **read,
        f"V' = {law.V_rate}, N = 1, 2, 3": lambda case: case.left_over(decay, driven(case)),
        "V is not negative": lambda case: case.not_negative(case.V),
    }


def _why_rising(case: InvariantLoop) -> str:
    """Return why w is not known to fall, or nothing."""
    if case.loop.jumps:
        return "its states jump, and what its errors do there is not judged"
    (w,), (rate,) = case.states[case.law.error_left], case.rates[case.law.error_left]
    f = -case.masked(rate) / w  # each maximum(a, b) with a positive one a positive symbol
    if f.has(w) or not f.is_nonnegative or vanishes(f):
        return f"{case.law.error_left}' = {short(rate)}"
    return ""


def driven(case: InvariantLoop) -> sympy.Expr:
    """Return e^T eta phi - f |eta|^2/gamma, gamma those of V."""
    p, loop = case.loop.parameters, case.loop
    eta = p["true_flow"].theta + case.states["alpha"]
    w, rate = case.states[case.law.error_left][0], case.rates[case.law.error_left][0]
    pushed = loop.signals["e"] @ (eta @ loop.inputs["phi_x"])
    return pushed + rate / w * np.sum(eta**2 / p["lyapunov"].gain)


def _scales_all_errors(case: InvariantLoop) -> bool:
    """Return whether each alpha is w times a constant, less theta."""
    (w,) = case.states[case.law.error_left]
    theta = case.loop.parameters["true_flow"].theta
    for alpha, own in zip(case.states["alpha"].flat, theta.flat, strict=True):
        eta = sympy.expand(case.relations.get(alpha, alpha) + own)
        first = sympy.cancel(eta / w)
        if first == 0 or first.free_symbols & case.loop.motion.keys() or not first.has(own):
            return False
    return True


def _reads(case: InvariantLoop) -> bool:
    """Return whether a readout where(1 - w >= m, a, -alpha) is theta in its first branch."""
    (w,) = case.states[case.law.error_left]
    read, truth = case.loop.signals[case.law.readout], case.loop.parameters["true_flow"].theta
    for one, alpha, theta in zip(read.flat, case.states["alpha"].flat, truth.flat, strict=True):
        if not isinstance(one, WHERE) or str(one.args[0].func) != "ge":
            return False
        condition, then, before = one.args
        gone, margin = condition.args
        known = {MAXIMUM(*pair): 1 - w for pair in ((margin, 1 - w), (1 - w, margin))}
        right = vanishes(case.reduced(then.subs(known)) - theta)
        if not (right and gone == 1 - w and margin.is_positive and vanishes(before + alpha)):
            return False
    return True


def covariance_claims(driven: bool) -> Claims:
    """Return the bounds of P and eta; `driven` is whether CLPE drives alpha."""
    moves = {
        "tr(eta P^-1 eta^T)' = -|eta phi_f|^2/r^2 - lambda tr(eta P^-1 eta^T): it never "
        "rises": "size",
        "(k_0 - tr P)' >= 0 where tr P = k_0: tr P <= k_0 is kept": "room",
        "(rho P)' = -rho (P phi_f) (P phi_f)^T/r^2: P^-1 >= rho P(0)^-1 at all times": "rho P",
        "P' + P phi_f phi_f^T P/r^2 = lambda P: P^-1 <= P(0)^-1 + int phi_f phi_f^T/r^2": "P",
    }
    claims: Claims = {claim: partial(_moves, of=of) for claim, of in moves.items()}
    claims["|eta|^2 <= tr P tr(eta P^-1 eta^T) <= k_0 tr(eta P^-1 eta^T): eta is bounded by V"] = (
        _cauchy
    )
    return dict(list(claims.items())[driven:])


def _moves(case: InvariantLoop, of: str) -> bool:
    pairs = zip(*map(np.ravel, covariance_rates(case)[of]), strict=True)
    return bool(case.parameters.forgetting.is_nonnegative) and all(
        vanishes(case.reduced(case.loop.derivative(a) - rate)) for a, rate in pairs
    )


def covariance_rates(case: InvariantLoop) -> dict[str, tuple[Any, Any]]:
    """Return quantities of P and eta, each with its rate; lambda is 0 where tr P = k_0."""
    P, p, rho, error = case.states["P"], case.parameters, case.states["rho"], case.weighted_error
    forgetting = p.forgetting * (1 - np.trace(P) / p.largest)
    gain, size = P @ case.states["phi_f"] / p.noise, np.sum((error @ P) * error)
    return {
        "size": (size, -sum((error @ gain) ** 2) - forgetting * size),
        "room": (p.largest - np.trace(P), sum(gain**2) - forgetting * np.trace(P)),
        "rho P": (rho * P, -rho * np.outer(gain, gain)),
        "P": (P, forgetting * P - np.outer(gain, gain)),
    }


def _cauchy(case: InvariantLoop) -> bool:
    """Return whether tr P p P p^T - |p P|^2 is a sum of squares for P = sum of v v^T."""
    n = len(case.matrices["P"])
    p = np.array(sympy.symbols(f"p_1:{n + 1}", real=True))
    v = np.array(sympy.symbols(f"v_1:{n * n + 1}", real=True)).reshape(n, n)
    P = v.T @ v
    squares = sum(
        (sum((v[a] * (v[b] @ p) - v[b] * (v[a] @ p)) ** 2) for a, b in combinations(range(n), 2)),
        start=sympy.Integer(0),
    )
    return vanishes(np.trace(P) * (p @ P @ p) - sum((p @ P) ** 2) - squares)
