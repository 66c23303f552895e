"""Bounds of the covariance P and of the errors eta of a law of least squares.

    P'   = lambda P - P phi_f phi_f^T P/r^2,    lambda = lambda_0 (1 - tr P/k_0)
    rho' = -lambda rho

    (k_0 - tr P)'              = |P phi_f|^2/r^2 >= 0 where tr P = k_0, so tr P <= k_0
    (rho P)'                   = -rho (P phi_f) (P phi_f)^T/r^2, so P <= P(0)/rho
    P' + P phi_f phi_f^T P/r^2 = lambda P >= 0, so P >= (P(0)^-1 + int phi_f phi_f^T/r^2)^-1
    |p P|^2 <= tr P p P p^T    for every row p, so |eta|^2 <= k_0 tr(eta P^-1 eta^T)

and where CLPE does not drive alpha, tr(eta P^-1 eta^T)' = -|eta phi_f|^2/r^2 - lambda times it.
With lambda_0 = 0 rho is 1 at all times, and the second is P^-1 >= P(0)^-1.
"""

from functools import partial
from itertools import combinations
from typing import Any

import numpy as np
import sympy

from ...paper.laws.law import Law
from ..algebra.exact import vanishes

BOUNDS = (  # of eta and P, as `covariance_rates` has what moves
    "tr(eta P^-1 eta^T)' = -|eta phi_f|^2/r^2 - lambda tr(eta P^-1 eta^T): it never rises",
    "(k_0 - tr P)' >= 0 where tr P = k_0: tr P <= k_0 is kept",
    "(rho P)' = -rho (P phi_f) (P phi_f)^T/r^2: P^-1 >= rho P(0)^-1 at all times",
    "P' + P phi_f phi_f^T P/r^2 = lambda P: P^-1 <= P(0)^-1 + int phi_f phi_f^T/r^2",
)
BOUNDED_BY_V = (
    "|eta|^2 <= tr P tr(eta P^-1 eta^T) <= k_0 tr(eta P^-1 eta^T): eta is bounded by V"
)


def covariance_claims(law: Law) -> dict[str, Any]:
    """Return the bounds of P and eta that a law has: claim -> what it shows, its check."""
    # where CLPE drives alpha BOUNDS[0] does not hold
    first = int(law.perturbation is None)
    claims = {
        BOUNDS[k]: ("", partial(_has_rate, index=k)) for k in range(first, len(BOUNDS))
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
    p = np.array(sympy.symbols(f"p_1:{n + 1}", real=True))
    v = np.array(sympy.symbols(f"v_1:{n * n + 1}", real=True)).reshape(n, n)
    P = v.T @ v
    squares = sum(
        sum((v[a] * (v[b] @ p) - v[b] * (v[a] @ p)) ** 2)
        for a, b in combinations(range(n), 2)
    )
    return vanishes(np.trace(P) * (p @ P @ p) - sum((p @ P) ** 2) - squares)
