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

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from itertools import chain, combinations, filterfalse
from typing import Any

import numpy as np
import sympy

from ...paper.laws.law import Law
from ..algebra.exact import vanishes
from ..algebra.facts import MAXIMUM, WHERE
from ..proofs.certificates import Ways
from ..proofs.conclusions import Condition, for_sizes
from ..proofs.judge import Fall, Verdict, judge
from ..proofs.steps import Step, exact, exact_step, first_failure
from .invariant_loop import NOTHING, SIZES
from .law_certificates import of_invariants
from .law_equations import LoopCandidate
from .paper_loop import mean_square
from .semidefinite import SemidefiniteLoop
from .states_of_laws import held, off_at_the_start, off_at_zero, repels
from .theorem_loop import decay, rate_of_V

Claims = dict[str, tuple[str, Callable[[SemidefiniteLoop], bool | str]]]
MIDDLE = 2  # of `SIZES`: the running blocks are compared for it
IN_THE_MEAN = "|e| <= |eta phi| over the least of KD"


class Invariants(SemidefiniteLoop, LoopCandidate):
    """A law with invariants, on its loop for one N: a law of the table, or your own."""

    def __init__(
        self,
        law: Law,
        N: int,
        points: int,
        seed: int = 0,
        blocks: tuple | None = None,
        start: Mapping[str, Any] = NOTHING,
    ):
        SemidefiniteLoop.__init__(self, law, N, blocks=blocks, start=start)
        self.points, self.seed = points, seed
        self.eq, self.motion = self.loop, self.loop.motion
        self.fixed, self.residual = {*self.loop.values}, self.beside
        self.sizes = f"N = {N}"
        self.rate = rate_of_V(self.loop).xreplace(self.tied)
        self.undefined = self.loop.undefined
        bounded, self.exist, self.grown = held(self)
        self.forms = [*bounded]

    def is_definite(self) -> Step:
        """Return the step that V and what V' loses are not negative."""
        names = ", ".join(self.law.semidefinite)
        premise = f"with {names} >= 0 " * bool(names)
        terms = {self.V, *chain.from_iterable(self.losses)}
        holds = all(map(self.not_negative, terms))
        claim = f"{premise}V and what V' loses are not negative"
        return exact(claim, holds, "", "definite")

    def fall(self) -> Fall:
        """Return what is shown of the relations, and of V' where they hold."""
        steps = [
            exact_step([self], claim, check, shows)
            for claim, (shows, check) in claims_of(self).items()
        ]
        fall = Fall(steps, f"V' = {self.law.V_rate}")
        if self.law.perturbation is not None:
            fall.steps.append(mean_square())
            fall.bound = IN_THE_MEAN
        else:
            e = self.loop.states["x"] - self.loop.states["z"]
            fall.losses, fall.bound, fall.of = [*e], "e^T KD e", "CLPE goes"
        positive = f"{' and '.join(self.grown)} > 0" * bool(self.grown)
        kept = "the relations hold" * (not self.is_row)
        fall.conditions = [
            Condition("start", text) for text in (kept, positive) if text
        ]
        return fall

    def exact_steps(self) -> list[Step]:
        """Return the steps on V, V' and jumps."""
        jumps = [self.jumps()[0]] if self.eq.jumps else []
        return [self.has_values(), self.is_definite(), *self.fall().steps, *jumps]

    def rises_at_jumps(self) -> list[sympy.Expr]:
        """Return by how much V rises at each set of jumps, where the relations hold."""
        after = self.loop.jumps_at_once()
        rises = (self.V.xreplace(change) - self.V for change in after)
        return [sympy.expand(self.reduced(rise)) for rise in rises]

    def ways(self, fall: Fall) -> Ways:
        """Return the ways to write V' as a sum, for a certificate."""
        return of_invariants(self)

    def never_positive(self, expression: sympy.Expr) -> bool:
        """Return whether an expression is known never to be positive where M >= 0."""
        return vanishes(expression) or self.not_negative(-expression)


def judged_row(law: Law, points: int, seed: int) -> Verdict:
    """Return the verdict on a law of the table, of which each step holds for each N."""
    verdict = judge(Invariants(law, MIDDLE, points, seed))
    if verdict.status != "proved":
        return verdict
    others = [Invariants(law, N, points, seed) for N in SIZES if N != MIDDLE]
    claim = "each exact step holds for " + " and ".join(case.sizes for case in others)
    failed = {step.claim for step in verdict.failed}  # of jumps, which the verdict says

    def missing(case: Invariants) -> str:
        return first_failure(s for s in case.exact_steps() if s.claim not in failed)

    step = exact_step(others, claim, missing)
    if not step.holds:
        return replace(others[0].verdict("open", first_failure([step])), steps=(step,))
    of_N = for_sizes(SIZES)
    conditions = (of_N if c.name == "N" else c for c in verdict.conditions)
    steps = *verdict.steps, step
    return replace(verdict, conditions=tuple(conditions), steps=steps)


def claims_of(case: SemidefiniteLoop) -> Claims:
    """Return what is to be shown of a law, one's own or of the table: claim -> shows, check."""
    law, names = case.law, case.law.semidefinite
    kept, sizes = "what the law's states keep is kept", f"N = {case.N}"
    start = off_at_the_start
    if not case.is_row:
        kept += " where it begins so"
        sizes += " and the parameters as they are"
        start = off_at_zero
    claims: Claims = {kept: ("", lambda case: case.broken() or start(case))}
    if not case.is_row:
        claims["what is kept does not repel"] = "", repels
    if case.loop.jumps:
        claim = f"{', '.join(names)} >= 0 is not left where they jump"
        claims["and is kept where they jump"] = "", SemidefiniteLoop.broken_at_a_jump
        claims[claim] = "", SemidefiniteLoop.semidefinite_after_a_jump
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
            SemidefiniteLoop.estimate_grows,
        )
    if law.readout:
        claims[
            f"{law.readout} is theta where its condition holds, and -alpha elsewhere"
        ] = "", _reads
    return claims


def _reads(case: SemidefiniteLoop) -> bool:
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


def _moves(case: SemidefiniteLoop, index: int) -> bool:
    pairs = zip(*map(np.ravel, covariance_rates(case)[index]), strict=True)
    return bool(case.parameters.forgetting.is_nonnegative) and all(
        vanishes(case.reduced(case.loop.derivative(a) - rate)) for a, rate in pairs
    )


def covariance_rates(case: SemidefiniteLoop) -> tuple[tuple[Any, Any], ...]:
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


def _cauchy(case: SemidefiniteLoop) -> bool:
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
