"""The proof of a law whose states have invariants, such as P beside the information.

A law's row says which `invariants` its states have (state = expression of the others), which
matrices are `semidefinite`, what V' `losses` are beyond e^T KD e, products of factors
that are not negative, and what is a `perturbation` beside.  Each is then shown:

    s' = (expression)'                    where the relations hold: what starts there stays
    c^T M' c >= 0  where  M c = 0         M stays semidefinite (Nagumo)
    V' = -e^T KD e - losses + perturbation    where the relations hold, V and losses not negative

A law without a perturbation is proved, one with e^T d, which bounds the mean square of e by that of
d, is bounded by it.  All is exact for N = 1, 2, 3,
and the running blocks give the same V'.  Where its states jump, at times that may be any, x and
inputs being those right before:

    the relations before give the relations after,  M >= 0 gives M+ >= 0,  V+ <= V

so that between and across jumps V falls.
Of a law that makes an estimate theta_hat = theta + d with its covariance M it is shown as well that

    (d M^-1 d^T)' = error_growth <= 0                     so d never grows in this norm

A law of which no parameter's error ever rises, eta = w eta(0), w' = -f w, f >= 0, takes no part of
e into alpha', so that V' is perturbed by e^T eta phi; its readout is theta where its condition
holds.

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

from ...paper.laws.law import Law
from .certificates import Ways, of_invariants
from .conclusions import Condition
from .exact import vanishes
from .facts import MAXIMUM, WHERE
from .invariant_loop import InvariantLoop
from .judge import Fall
from .law_candidate import LoopCandidate
from .steps import Step, exact_step
from .theorem_loop import decay, rate_of_V
from .theorems import mean_square

Claims = dict[str, tuple[str, Callable[[InvariantLoop], bool | str]]]
IN_THE_MEAN = "|e| <= |eta phi| over the least of KD"


class Invariants(LoopCandidate):
    """A law with invariants, on its loops: of its row N = 1, 2, 3, of your own law one N."""

    def __init__(
        self, law: Law, cases: list[InvariantLoop], points: int, seed: int = 0
    ):
        self.law, self.cases, self.points, self.seed = law, cases, points, seed
        self.case = cases[len(cases) // 2]
        self.eq = self.loop = self.case.loop
        self.V, self.residual = self.case.V, self.case.beside
        self.fixed = {*self.loop.values}
        self.sizes = "N = " + ", ".join(str(case.N) for case in cases)
        self.rate = rate_of_V(self.loop).xreplace(self.case.tied)
        self.motion = self.loop.motion
        self.undefined = [s for case in self.cases for s in case.loop.undefined]
        bounded, self.exist, self.grown = self.case.held()
        self.forms = [*bounded]

    def is_definite(self) -> Step:
        """Return the step that V and what V' loses are not negative."""
        names = ", ".join(self.law.semidefinite)
        premise = f"with {names} >= 0 " * bool(names)

        def holds(case: InvariantLoop) -> bool:
            terms = {case.V, *chain.from_iterable(case.losses)}
            return all(map(case.not_negative, terms))

        claim = f"{premise}V and what V' loses are not negative"
        return exact_step(self.cases, claim, holds, "definite")

    def fall(self) -> Fall:
        """Return what is shown of the relations, and of V' where they hold."""
        steps = [
            exact_step(self.cases, claim, check, shows)
            for claim, (shows, check) in claims_of(self.law, self.case).items()
        ]
        fall = Fall(steps, f"V' = {self.law.V_rate}")
        if self.law.perturbation is not None:
            fall.steps.append(mean_square())
            fall.bound = IN_THE_MEAN
        else:
            e = self.loop.states["x"] - self.loop.states["z"]
            fall.losses, fall.bound, fall.of = [*e], "e^T KD e", "CLPE goes"
        positive = f"{' and '.join(self.grown)} > 0" * bool(self.grown)
        kept = "the relations hold" * (not self.case.is_row)
        fall.conditions = [
            Condition("start", text) for text in (kept, positive) if text
        ]
        return fall

    def jumps(self) -> tuple[Step, sympy.Expr]:
        """Return the step that V does not rise where states jump."""
        claim = "V does not rise where they jump"
        step = exact_step(self.cases, claim, InvariantLoop.V_rises_by, "jumps")
        return step, sympy.S.Zero

    def ways(self, fall: Fall) -> Ways:
        """Return the ways to write V' as a sum, for a certificate."""
        return of_invariants(self)

    def never_positive(self, expression: sympy.Expr) -> bool:
        """Return whether an expression is known never to be positive where M >= 0."""
        return self.case.not_negative(-expression)


def claims_of(law: Law, case: InvariantLoop) -> Claims:
    """Return what is to be shown of a law, one's own or of the table: claim -> shows, check."""
    names = law.semidefinite
    kept, sizes = "what the law's states keep is kept", "N = 1, 2, 3"
    start = InvariantLoop.off_at_the_start
    if not case.is_row:
        kept += " where it begins so"
        sizes = f"N = {case.N} and the parameters as they are"
        start = InvariantLoop.off_at_zero
    claims: Claims = {kept: ("", lambda case: case.broken() or start(case))}
    if not case.is_row:
        claims["what is kept does not repel"] = "", InvariantLoop.repels
    if case.loop.jumps:
        claim = f"{', '.join(names)} >= 0 is not left where they jump"
        claims["and is kept where they jump"] = "", InvariantLoop.broken_at_a_jump
        claims[claim] = "", InvariantLoop.semidefinite_after_a_jump
    if names:
        claims[
            f"c^T M' c >= 0 where M c = 0, so M >= 0 is not left: {', '.join(names)}"
        ] = ("", lambda case: ", ".join(filterfalse(case.stays_semidefinite, names)))
    shows = "mean" if law.perturbation is not None else "falls loses"
    claims[f"V' as claimed, {sizes}: {law.V_rate}"] = (
        shows,
        lambda case: case.left_over(decay),
    )
    if law.weighted_error:
        # where CLPE drives alpha BOUNDS[0] does not hold
        start_index = int(law.perturbation is None)
        claims |= {
            BOUNDS[k]: ("", partial(_moves, index=k))
            for k in range(start_index, len(BOUNDS))
        }
        claims[BOUNDED_BY_V] = "", _cauchy
    if law.makes_estimate:
        claims["the error of the estimate never grows: (d P^-1 d^T)' is as claimed"] = (
            "",
            InvariantLoop.estimate_grows,
        )
    if law.readout:
        claims[
            f"{law.readout} is theta where its condition holds, and -alpha elsewhere"
        ] = "", _reads
    return claims


def _reads(case: InvariantLoop) -> bool:
    """Return whether a readout where(1 - w >= m, a, -alpha) is theta in its first branch."""
    (w,) = case.states[case.law.error_left]
    read, truth = (
        case.loop.signals[case.law.readout],
        case.loop.parameters["true_flow"].theta,
    )
    for element, alpha, theta in zip(
        read.flat, case.states["alpha"].flat, truth.flat, strict=True
    ):
        if not isinstance(element, WHERE) or str(element.args[0].func) != "ge":
            return False
        condition, then, before = element.args
        gone_share, margin = condition.args
        substitutions = {
            MAXIMUM(*pair): 1 - w for pair in ((margin, 1 - w), (1 - w, margin))
        }
        is_truth = vanishes(case.reduced(then.subs(substitutions)) - theta)
        if not (
            is_truth
            and gone_share == 1 - w
            and margin.is_positive
            and vanishes(before + alpha)
        ):
            return False
    return True


BOUNDS = (  # of eta and P, as `covariance_rates` has what moves
    "tr(eta P^-1 eta^T)' = -|eta phi_f|^2/r^2 - lambda tr(eta P^-1 eta^T): it never rises",
    "(k_0 - tr P)' >= 0 where tr P = k_0: tr P <= k_0 is kept",
    "(rho P)' = -rho (P phi_f) (P phi_f)^T/r^2: P^-1 >= rho P(0)^-1 at all times",
    "P' + P phi_f phi_f^T P/r^2 = lambda P: P^-1 <= P(0)^-1 + int phi_f phi_f^T/r^2",
)
BOUNDED_BY_V = (
    "|eta|^2 <= tr P tr(eta P^-1 eta^T) <= k_0 tr(eta P^-1 eta^T): eta is bounded by V"
)


def _moves(case: InvariantLoop, index: int) -> bool:
    pairs = zip(*map(np.ravel, covariance_rates(case)[index]), strict=True)
    return bool(case.parameters.forgetting.is_nonnegative) and all(
        vanishes(case.reduced(case.loop.derivative(a) - rate)) for a, rate in pairs
    )


def covariance_rates(case: InvariantLoop) -> tuple[tuple[Any, Any], ...]:
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


def _cauchy(case: InvariantLoop) -> bool:
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
