"""Bounds of the covariance P of least squares, and of eta where V falls.

    P'   = lambda P - P phi_f phi_f^T P/r^2,    lambda = lambda_0 (1 - tr P/k_0)
    rho' = -lambda rho

    (k_0 - tr P)'              = |P phi_f|^2/r^2 >= 0 where tr P = k_0, so tr P <= k_0
    (rho P)'                   = -rho (P phi_f) (P phi_f)^T/r^2, so P <= P(0)/rho
    P' + P phi_f phi_f^T P/r^2 = lambda P >= 0, so P >= (P(0)^-1 + int phi_f phi_f^T/r^2)^-1
    |p P|^2 <= tr P p P p^T    for every row p, so |eta|^2 <= k_0 tr(eta P^-1 eta^T)

and where CLPE does not drive alpha, tr(eta P^-1 eta^T)' = -|eta phi_f|^2/r^2 - lambda times it.
With lambda_0 = 0 rho is 1 at all times, and the second is P^-1 >= P(0)^-1.
"""

from itertools import combinations
from typing import Any

import numpy as np
import sympy

from .kept_loop import Kept, exact_step
from .proof import Step
from .vanishing import vanishes


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
    P = case.symmetric("P")
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
    P, p = case.symmetric("P"), case.parameters
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
