"""Prove a law whose states keep relations between each other, such as P with the information.

A law's row says which relations its states `keep` (state = expression of the others), which
matrices, its `cones`, are not negative, what V' `losses` are beyond e^T KD e, products of factors
that are not negative, and what is a `push` beside.  Each is then shown:

    s' = (expression)'                    where the relations hold: what starts there stays
    c^T M' c >= 0  where  M c = 0         the cone M >= 0 is not left (Nagumo)
    V' = -e^T KD e - losses + push        where the relations hold, V and losses not negative

A law without a push is proved, one with is bounded by it.  `covariance_bounds` says more of laws
with a covariance P.  All is exact for N = 1, 2, 3, and the running blocks give the same V'.
Where its states jump, at times that may be any, x and inputs being those right before:

    the relations before give the relations after,  M >= 0 gives M+ >= 0,  V+ <= V

so that between and across jumps V falls.
For a law that makes an estimate theta_hat = theta + d with its covariance M, the third is

    V' = -e^T KD e + e^T (theta - theta_hat) phi          Theorem 3.1
    (d M^-1 d^T)' = gains <= 0                            so d never grows in this norm
"""

import math

from ...blocks.laws.law import Law
from .covariance_bounds import covariance_steps
from .kept_loop import Kept, cases_of, exact_step, kept_step, same_running
from .lyapunov import Claim, decay, decay_and_known_error
from .proof import Step

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
