"""Every law of the table, judged with its own V on the equations that run.

A law with V' <= -e^T KD e is proved; one with V' <= -e^T KD e + what is bounded is bounded, and
the set that V comes to is said.  A law that is given an estimate of the flow has the V' of
Theorem 3.1, and is bounded in the mean square by the error of the estimate.  A law that learns at
fixes keeps V from rising there.
"""

from typing import NamedTuple

from ...blocks.laws.law import Law
from .fixes import fix_steps
from .kept_relations import GIVEN, kept_steps
from .lyapunov import decay_and_known_error, identity_steps
from .own_law import prove
from .proof import Step, first_failure
from .shrinking_errors import shrinking_steps
from .theorem_loop import law_and_V

POINTS = 1_000  # at which the running blocks of each law are called
N = 2  # functions; a proof for every N says so
MEAN = f"{GIVEN}: in the mean |e| <= |(theta - theta_hat) phi| over the least of KD"


class JudgedLaw(NamedTuple):
    """What is known of V' under a law of the table."""

    law: str
    status: str  # "proved", "bounded", "open" or "refuted"
    claim: str  # V', and the set that is reached
    for_every_N: bool
    steps: tuple[Step, ...]

    @property
    def holds(self) -> bool:
        """Whether the law may stand in the table."""
        return self.status in ("proved", "bounded")


def judged(law: Law) -> JudgedLaw:
    """Judge one law; equations that cannot be read leave it open."""
    try:
        if law.shrinking:
            return _with_shrinking_errors(law)
        if law.at_fixes:
            return _at_fixes(law)
        if law.keeps is not None:
            return _with_kept_relations(law)
        return _of_given_flow(law) if law.given_estimate else _with_own_V(law)
    except Exception as error:  # an equation so changed that it cannot be traced
        step = Step("the equations can be read", False, "exact", f"{error}")
        return JudgedLaw(law.name, "open", str(error), False, (step,))


def _with_own_V(law: Law) -> JudgedLaw:
    """Judge a law that learns the flow."""
    verdict = prove(*law_and_V(law, N), points=POINTS)
    sign = "=" if verdict.residual == 0 else "<="
    claim = verdict.reached or f"V' {sign} -e^T KD e, so CLPE goes to zero"
    if verdict.status not in ("proved", "bounded"):
        claim = first_failure(verdict.steps) or "V' is not known to fall"
    return JudgedLaw(law.name, verdict.status, claim, verdict.for_every_N, verdict.steps)


def _with_kept_relations(law: Law) -> JudgedLaw:
    """Judge a law whose states keep relations."""
    steps = kept_steps(law, POINTS)
    if law.makes_estimate:
        return _if_all_hold(law, "bounded", f"{MEAN}, and {law.says}", steps)
    if law.push is not None:
        return _if_all_hold(law, "bounded", f"V' <= {law.says}: {law.comes_to}", steps)
    return _if_all_hold(law, "proved", f"V' <= {law.says}, so CLPE goes to zero", steps)


def _with_shrinking_errors(law: Law) -> JudgedLaw:
    """Judge a law of which no parameter's error rises."""
    claim = f"V' = {law.says}: in the mean |e| <= |eta phi| over the least of KD"
    return _if_all_hold(law, "bounded", claim, shrinking_steps(law, POINTS))


def _at_fixes(law: Law) -> JudgedLaw:
    """Judge a law that learns at fixes: V does not rise, but CLPE is only what fixes leave."""
    claim = f"V' = {law.says}; |eta_k| <= (2 V(0) P_kk)^(1/2)/r"
    return _if_all_hold(law, "bounded", claim, fix_steps(law, POINTS))


def _of_given_flow(law: Law) -> JudgedLaw:
    """Judge a law that is given an estimate of the flow."""
    steps = identity_steps(GIVEN, law.name, decay_and_known_error, POINTS)
    return _if_all_hold(law, "bounded", MEAN, steps)


def _if_all_hold(law: Law, status: str, claim: str, steps: list[Step]) -> JudgedLaw:
    """Return a status and a claim, or what does not hold."""
    failed = first_failure(steps)
    every = not failed and all(step.every_N for step in steps if step.how == "exact")
    known = ("open", failed) if failed else (status, claim)
    return JudgedLaw(law.name, *known, every, tuple(steps))
