"""Every law of the table, judged with its own V on the equations that run.

A law with V' <= -e^T KD e is proved; one with V' <= -e^T KD e + what is bounded is bounded, and
the set that V comes to is said.  A law that is given an estimate of the flow has the V' of
Theorem 3.1, and is bounded in the mean square by the error of the estimate.  A law that learns at
fixes keeps V from rising there.
"""

from ...blocks.laws.law import Law
from . import proof
from .fixes import fix_steps
from .kept_relations import GIVEN, kept_steps
from .lyapunov import decay_and_known_error, identity_steps
from .own_law import prove
from .proof import Proof, first_failure, where_all_hold
from .shrinking_errors import shrinking_steps
from .theorem_loop import law_and_V

POINTS = 1_000  # at which the running blocks of each law are called
N = 2  # functions; a proof for every N says so
MEAN = f"{GIVEN}: in the mean |e| <= |(theta - theta_hat) phi| over the least of KD"


def judged(law: Law) -> Proof:
    """Judge one law; equations that cannot be read leave it open."""
    return proof.judged("open", lambda: _of_law(law))


def _of_law(law: Law) -> Proof:
    if law.shrinking:
        claim = f"V' = {law.says}: in the mean |e| <= |eta phi| over the least of KD"
        return where_all_hold("bounded", claim, shrinking_steps(law, POINTS))
    if law.at_fixes:  # V does not rise, but CLPE is only what fixes leave
        claim = f"V' = {law.says}; |eta_k| <= (2 V(0) P_kk)^(1/2)/r"
        return where_all_hold("bounded", claim, fix_steps(law, POINTS))
    if law.keeps is not None:
        status, claim = "proved", f"V' <= {law.says}, so CLPE goes to zero"
        if law.makes_estimate:
            status, claim = "bounded", f"{MEAN}, and {law.says}"
        elif law.push is not None:
            status, claim = "bounded", f"V' <= {law.says}: {law.comes_to}"
        return where_all_hold(status, claim, kept_steps(law, POINTS))
    if law.given_estimate:
        steps = identity_steps(GIVEN, law.name, decay_and_known_error, POINTS)
        return where_all_hold("bounded", MEAN, steps)
    verdict = prove(*law_and_V(law, N), points=POINTS)
    sign = "=" if verdict.residual == 0 else "<="
    claim = verdict.reached or f"V' {sign} -e^T KD e, so CLPE goes to zero"
    if verdict.status not in ("proved", "bounded"):
        claim = first_failure(verdict.steps) or "V' is not known to fall"
    return Proof(verdict.status, claim, verdict.for_every_N, verdict.steps)
