"""The four theorems of section III, each checked as printed.

Every identity is checked on the blocks that run: for N = 1, 2, 3, for every N, and at random points
at which they are called.  Every printed statement that is false meets a counterexample and carries
the statement that holds, with what of it is cited.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from ...arguments import public
from ...errors import ClptError
from ...progress import interrupt
from ..counterexamples import (
    burst_counterexample,
    disturbance_counterexample,
    known_flow_counterexample,
    square_wave_counterexample,
    unlearned_counterexample,
)
from . import lemmas
from .proof import Proof, Step, cited, counterexample, proof_or_failure, theorem
from .theorem_loop import (
    KNOWN_ERROR,
    Loop,
    decay,
    decay_and_known_error,
    identity_steps,
)

POINTS = 10_000  # at which the running blocks are called for Theorem 3.2
FEWER = 1_000  # for 3.1 and 3.4, whose blocks are the same but for one
POSITIVE_KD = "Assumption 3.2: KD is positive definite, here diagonal"
PIECEWISE = (
    "zc is bounded and piecewise constant, with finitely many jumps in finite time"
)
SMOOTH = "phi(x, t) is bounded and lets solutions exist, as that of Eq. (5) does"
NO_DELTA = "the true flow is theta phi, without Delta"


def theorem_3_1() -> Proof:
    """Judge Theorem 3.1: the known-flow law and its bound, Eq. (16)."""
    return theorem(
        "CLPE is ultimately bounded by |e| <= |(theta - theta_hat) phi|/mu, mu < lambda_min(KD)",
        (
            POSITIVE_KD,
            PIECEWISE,
            SMOOTH,
            "|(theta - theta_hat) phi| is bounded, Assumption 3.3",
        ),
        [
            *identity_steps(KNOWN_ERROR, "known-flow", decay_and_known_error, FEWER),
            lemmas.definite_step("known-flow"),
            lemmas.young_step(),
            counterexample(
                "the paper's system with one wrong theta_hat leaves Eq. (16) for every mu < KD",
                partial(known_flow_counterexample, start=400.0, end=800.0, step=0.05),
                lambda found: found.ratio > 1.05,
                "max|e| = {0.ratio:.3f} of the largest drive over KD",
            ),
        ],
        "V' < 0 outside a ball in e bounds nothing while V also holds gain errors: "
        "the gains can store the drive and give it back.",
        corrected="int |e|^2 dt <= 2 V(0)/k + int |(theta - theta_hat) phi|^2 dt/k^2 with "
        "k = lambda_min(KD): in the mean square |e| is at most the drive over k",
        not_proved=(
            "a pointwise ultimate bound; it needs excitation, see Theorem 3.4",
        ),
    )


def theorem_3_2() -> Proof:
    """Judge Theorem 3.2: the learned-flow law drives CLPE to zero."""
    return theorem(
        "under Assumptions 3.1 and 3.2 CLPE converges to zero",
        (POSITIVE_KD, PIECEWISE, SMOOTH, NO_DELTA),
        [
            *identity_steps("V' = -e^T KD e", "learned-flow", decay, POINTS),
            lemmas.definite_step("learned-flow"),
            lemmas.dissipation_step(),
            *lemmas.convergence_steps(),
        ],
        "V falls and is bounded below, V'' is bounded, so V' -> 0 (Barbalat's lemma, "
        "whose argument is the last step) and e -> 0.",
        not_proved=(
            "any rate of convergence",
            "that alpha, K or Gamma converge (Theorem 3.3)",
        ),
    )


def theorem_3_3() -> Proof:
    """Judge Theorem 3.3: the parameters converge."""
    steps = [
        *lemmas.observability_steps(),
        lemmas.circle_step(),
        counterexample(
            "zc exciting is not enough: with the gaussian-sigma kernel a parameter stands still",
            partial(unlearned_counterexample, end=220.0),
            lambda found: (
                found.kappa > 1.0 and found.moved < 1e-9 and found.error > 0.1
            ),
            "zc excites (smallest eigenvalue {0.kappa:.0f}), yet theta[{0.function}] moves by "
            "{0.moved:.1e} and stays {0.error:.2f} off",
        ),
    ]
    return theorem(
        "under the setting of Theorem 3.2 alpha, K, Gamma converge to -theta, KD, GammaD",
        (POSITIVE_KD, PIECEWISE, SMOOTH, NO_DELTA),
        steps,
        "With output injection that keeps -KD, observability of (28) is excitation of "
        "the filtered joint regressor; zc alone does not give it.",
        corrected="if the joint regressor w = [phi(x), z_i, zc_i] of each axis is persistently "
        "exciting along the run, (e, alpha + theta, K - KD, Gamma - GammaD) goes to zero "
        "exponentially",
        cited="that observability gives exponential stability; the error system (28), its V' and "
        "its output injection are proved",
        not_proved=("that a given track excites w: `clpt excitation` measures it",),
    )


def ultimate_steps() -> list[Step]:
    """Check the ultimate bound where the regressor excites."""
    return [
        lemmas.algebra_step(  # with 2 V = |e|^2 + r, r the parameter errors' share
            "v = sqrt(2 V) grows by |Delta| at most: v' v = V' <= e^T Delta and "
            "(e^T Delta)^2 <= 2 V |Delta|^2",
            "(e1**2 + e2**2 + r)*(d1**2 + d2**2) - (e1*d1 + e2*d2)**2"
            " - (e1*d2 - e2*d1)**2 - r*(d1**2 + d2**2)",
        ),
        cited(
            "over a window T with an exciting regressor V falls to (1 - rho) V, rho > 0, "
            "where Delta = 0",
            "Ioannou and Sun 1996, theorem 3.4.8",
        ),
        lemmas.algebra_step(  # q = sqrt(1 - rho) < 1, d = T D
            "v_{n+1} <= sqrt(1 - rho) v_n + T D comes down to T D/(1 - sqrt(1 - rho)), and "
            "within a window v grows by T D",
            "(q*v + d - d/(1 - q)) - q*(v - d/(1 - q))",
        ),
    ]


def decay_and_disturbance(loop: Loop) -> Any:
    """V' = -e^T KD e + e^T Delta, Eq. (35)."""
    return decay(loop) + loop.signals["e"] @ loop.inputs["delta"]


def theorem_3_4() -> Proof:
    """Judge Theorem 3.4: the bound (33) under a disturbance."""
    text = "V' = -e^T KD e + e^T Delta"
    steps = [
        *identity_steps(
            text, "learned-flow", decay_and_disturbance, FEWER, disturbed=True
        ),
        lemmas.definite_step("learned-flow"),
        lemmas.young_step(),
        *ultimate_steps(),
        counterexample(
            "the paper's system, started true, with a square wave leaves Eq. (33) for every "
            "beta < KD within t = 60 to 120, and keeps the mean-square bound",
            partial(disturbance_counterexample, start=60.0, end=120.0, samples=20),
            lambda found: found.ratio > 1.05 and found.rms <= 1.0,
            "max|e| = {0.ratio:.3f} Delta_max/KD, rms(e) = {0.rms:.3f} of its bound",
        ),
        counterexample(
            "phi = 1, k = 1, gamma = 100, a unit square wave at sqrt(gamma): limsup|e| = 4/pi",
            square_wave_counterexample,
            lambda found: abs(found.peak * np.pi / 4 - 1) < 1e-2,
            "limsup|e| = {0.peak:.4f}",
        ),
        counterexample(
            "k = gamma = Delta = 1, phi = 0.2 for a time of 250, then 1 for 20, again and again: "
            "phi is exciting, and |e| > 2 Delta/k comes back",
            burst_counterexample,
            lambda found: found.ratio > 2.0,
            "|e| peaks at {0.peak:.3f} in each cycle",
        ),
    ]
    return theorem(
        "|e| <= |Delta|/beta with a positive constant beta < lambda_min(KD)",
        (POSITIVE_KD, PIECEWISE, SMOOTH, "Delta is bounded and piecewise continuous"),
        steps,
        "V' < 0 outside a ball in e bounds nothing while V also holds parameter errors.",
        corrected="int |e|^2 dt <= 2 V(0)/k + int |Delta|^2 dt/k^2 always, so rms(e) <= "
        "rms(Delta)/k in the long run; with a jointly exciting regressor that does not depend on "
        "the learner, limsup|e| <= T Delta_max (1 + 1/(1 - sqrt(1 - rho)))",
        cited="that an exciting regressor gives rho > 0; the mean-square bound is proved, and the "
        "ultimate bound from rho on",
        not_proved=(
            "the ultimate bound where z feeds the regressor back from the learner",
        ),
    )


THEOREMS: dict[str, Callable[[], Proof]] = {
    "3.1": theorem_3_1,
    "3.2": theorem_3_2,
    "3.3": theorem_3_3,
    "3.4": theorem_3_4,
}


def numbers_of(theorem: str | None) -> list[str]:
    """Return the theorem that is asked for, or all."""
    if theorem is not None and theorem not in THEOREMS:
        raise ClptError(f"theorem {theorem}: must be one of {', '.join(THEOREMS)}")
    return list(THEOREMS) if theorem is None else [theorem]


@public
def audit(
    theorem: str | None = None, progress: Callable[[float], None] | None = None
) -> dict[str, Proof]:
    """Judge the paper's theorems on the equations that run.

    Parameters
    ----------
    theorem : str, optional
        One of ``"3.1"`` to ``"3.4"``; all by default.
    progress : callable, optional
        Called with the number of theorems judged.

    Returns
    -------
    dict
        Number -> Proof: its `status`, the `printed` statement, its `assumptions`, the `steps`, and
        what is `corrected`, `cited` and `not_proved`.

    Raises
    ------
    ClptError
        If there is no such theorem.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> clpt.theory.audit("3.2")["3.2"].status
    'proved'
    """
    proofs = {}
    for done, number in enumerate(numbers_of(theorem), 1):
        interrupt.check()
        proofs[number] = proof_or_failure("failed", THEOREMS[number])
        if progress is not None:
            progress(done)
    return proofs
