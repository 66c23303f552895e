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
from .kept_loop import Kept, cases_of, kept_step, said_of, same_running
from .lyapunov import Claim, decay, decay_and_known_error
from .proof import Step, checked

GIVEN = "V' = -e^T KD e + e^T (theta - theta_hat) phi"


def jump_steps(cases: list[Kept], law: Law) -> list[Step]:
    """Check what the states keep, and V, where they jump; nothing where they do not."""
    if not any(case.loop.jumps for case in cases):
        return []
    return [
        checked(
            "and is kept where they jump",
            "exact",
            lambda: said_of(cases, Kept.left_at_a_jump),
            False,
        ),
        checked(
            f"{', '.join(law.cones)} >= 0 is not left where they jump",
            "exact",
            lambda: all(case.cone_is_kept_at_a_jump() for case in cases),
            False,
        ),
        checked(
            "V does not rise where they jump",
            "exact",
            lambda: said_of(cases, Kept.V_rises_by),
            False,
        ),
    ]


def kept_steps(law: Law, points: int) -> list[Step]:
    """Check a law whose row states what its states keep, for N = 1, 2, 3."""
    cases = cases_of(law)
    made = law.makes_estimate
    claim: Claim = decay_and_known_error if made else decay
    names = ", ".join(law.cones)

    def falls() -> tuple[bool, str]:
        def left(case: Kept) -> str:
            return case.left_over(claim, case.push - sum(map(math.prod, case.losses)))

        return said_of(cases, left)

    def recedes() -> tuple[bool, str]:
        if any(case.loop.jumps for case in cases):
            return False, "its states jump, and what its error does there is not judged"
        return said_of(cases, Kept.estimate_grows)

    def cones() -> tuple[bool, str]:
        left = [p for case in cases for p in law.cones if not case.cone_is_kept(p)]
        return not left, ", ".join(sorted(set(left)))

    if made:
        third = [
            checked(f"{GIVEN}, N = 1, 2, 3", "exact", falls, False),
            checked(f"the error of the estimate never grows: {law.says}", "exact", recedes, False),
        ]
    else:
        third = [
            checked(f"V' as claimed, N = 1, 2, 3: {law.says}", "exact", falls, False),
            *(covariance_steps(cases, law.push is None) if law.over else []),
            checked(
                f"with {names} >= 0 V and what V' loses are not negative",
                "exact",
                lambda: all(case.not_negative(case.V) and case.loses() for case in cases),
                False,
            ),
        ]
    return [
        kept_step(cases),
        *jump_steps(cases, law),
        checked(
            f"c^T M' c >= 0 where M c = 0, so M >= 0 is not left: {names}", "exact", cones, False
        ),
        *third,
        same_running(cases, points),
    ]
