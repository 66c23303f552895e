"""Theorem 3.2 of a vehicle whose speed is limited, with and without hedging.

    x' = F_R + v,   z' = F_M + v_z - (v_c - v)        v_c commanded by Eq. (7), v flown

With hedging e' = F_R + v_c - F_M - v_z, whatever v is: e' and V' of every law are those of a
vehicle without a limit.  Without it V' = -e^T KD e - e^T (v_c - v).

Theorem 3.2 also needs x bounded.  With w = KD x and v_c = b - w, b of phi and zc alone, the limit
v = v_max v_c/|v_c| gives w^T v <= v_max (2 |b| - |w|), so

    (x^T KD x/2)' = w^T (F_R + v) < 0      where |w| > 2 v_max |b|/(v_max - |F_R|)

if the flow is slower than the vehicle; x is then bounded.  A faster flow carries the vehicle away.
"""

from collections.abc import Callable

import sympy

from ...engine.diagram.interconnection import connect
from ...paper.blocks.vehicle import speed_limit
from ...paper.laws.law import Law
from ...paper.laws.table import LAWS
from ..algebra.exact import nonzero_residual, vanishes
from ..algebra.facts import MAXIMUM
from ..laws.invariants import Invariants
from ..laws.paper_loop import PaperLoop, algebra, line, mean_square, quadratic, running
from ..laws.theorem_loop import decay, law_and_V, law_loop, rate_of_V
from ..proofs.proof import Proof, theorem
from ..proofs.steps import checked, counterexample
from ..proofs.symbolic_loop import symbolic_loop
from .counterexamples import limited_speed_counterexample

N = 2  # functions of a law of the table
POINTS = 1_000  # at which the running blocks are called
OPEN = "Theorem 3.2 where the vehicle's speed is limited, which the paper leaves open"


def differs(law: Law) -> str:
    """Return how a hedged law differs from the one without a limit, or nothing."""
    free, hedged = (
        symbolic_loop(law_loop(law, *law_and_V(law, N, speed), speed), jumps=True)
        for speed in ("no limit", "hedged")
    )
    flown = dict(zip(hedged.inputs["v_x"], free.signals["v_x"], strict=True))
    if difference := nonzero_residual(rate_of_V(free) - rate_of_V(hedged)):
        # whatever v is flown
        return difference
    compared = free.motion.keys() - {*free.states["x"].flat, *free.states["z"].flat}
    jumps = zip(free.jumps.values(), hedged.jumps.values(), strict=True)
    for without_limit, with_limit in [(free.motion, hedged.motion), *jumps]:
        for s in compared & without_limit.keys():
            if not vanishes(without_limit[s] - with_limit[s].xreplace(flown)):
                return f"{s} moves or jumps differently"
    return (
        ""
        if law.invariants is None
        else Invariants(law, N, speed="hedged").relations.broken()
    )


def same_rate_of_every_law() -> tuple[bool, str]:
    """Return whether V' of each law is that without a limit, and its relations are kept.

    Its own states move as without a limit too, with the flown velocity for the commanded one.
    """
    # those predict with v as flown
    laws = [law for law in LAWS.values() if not law.at_fixes]
    different = next(
        (f"{law.name}: {how}" for law in laws if (how := differs(law))), ""
    )
    return not different, different or ", ".join(law.name for law in laws)


def limits() -> bool:
    """Return whether the block flies v_c up to v_max, and v_max in its direction beyond."""
    loop = symbolic_loop(connect([speed_limit(1.5)], external=["v_c"]))
    v, c = loop.signals["v_x"], loop.inputs["v_c"]
    largest = loop.parameters["speed_limit"].max_speed
    speed = sympy.sqrt(c[0] ** 2 + c[1] ** 2)
    larger = MAXIMUM(speed, largest), MAXIMUM(largest, speed)
    return any(all(map(vanishes, v - largest * c / size)) for size in larger)


def with_hedging() -> Proof:
    """Prove Theorem 3.2 of a vehicle whose speed is limited, with hedging."""
    paper = PaperLoop("learned-flow", speed="hedged")
    zero, KD, e, phi, zc = paper.zero, paper.KD, paper.e, paper.phi, paper.zc
    signals, inputs = paper.loop.signals, paper.loop.inputs
    claim = "V' = -e^T KD e, whatever v is flown"
    fall = paper.rate(paper.V) - decay(paper.loop)
    commanded = paper.GammaD * zc - paper.alpha_M @ phi - KD * paper.x
    moved = paper.rate(paper.x) - (signals["flow_x"] + inputs["v_x"])
    steps = [
        line(f"{claim}, for every N", paper.positive(KD), zero(fall)),
        running(paper, POINTS, claim),
        line(
            "e' is that without a limit, for every N",
            zero(paper.rate(e) - paper.error_rate),
        ),
        quadratic(paper, "(24)"),
        checked("v = v_c up to |v_c| = v_max, and v_max v_c/|v_c| beyond", limits),
        line(
            "x' = F_R + v and v_c = b - KD x, b of phi and zc alone, for every N",
            zero(signals["v_c"] - commanded, moved),
        ),
        line(
            # w^T v = v_max (b - c)^T c/|c|, b^T c <= |b| |c|, |c| >= |w| - |b|;
            # zero at |w| = 2 v_max |b|/(v_max - F)
            "w = KD x: (x^T KD x/2)' = w^T (F_R + v) <= |w| |F_R| + v_max (2 |b| - |w|) at the "
            "limit, so x is bounded where |F_R| < v_max",
            algebra(
                "(b1**2 + b2**2)*(c1**2 + c2**2) - (b1*c1 + b2*c2)**2 - (b1*c2 - b2*c1)**2",
                "2*v*b/(v - F)*F + v*(2*b - 2*v*b/(v - F))",
            ),
        ),
    ]
    return theorem(
        OPEN,
        (
            "Assumptions of Theorem 3.2",
            "for CLPE -> 0 also: |F_R| stays below some F < v_max",
        ),
        steps,
        "V falls as without a limit; where the flow is slower than the vehicle x is "
        "bounded, and Theorem 3.2 goes on as it stands, since e' is the same.",
        not_proved=("that CLPE goes to zero where the flow carries the vehicle away",),
    )


def every_law() -> Proof:
    """Prove that hedging keeps V' of every law of the table."""
    claim = f"V' is that without a limit, whatever v is flown, N = {N}"
    return theorem(
        "not in the paper",
        ("what the law's own proof assumes",),
        [checked(claim, same_rate_of_every_law, every_N=False)],
        "Laws that read the velocity are given the one that is flown.",
    )


def without_hedging() -> Proof:
    """Refute Theorem 3.2 of a vehicle whose speed is limited, without hedging."""
    paper = PaperLoop("learned-flow", speed="not hedged")
    missing = paper.loop.signals["v_c"] - paper.loop.inputs["v_x"]
    return theorem(
        OPEN,
        ("Assumptions of Theorem 3.2",),
        [
            line(
                "V' = -e^T KD e - e^T (v_c - v), for every N",
                paper.zero(
                    paper.rate(paper.V) - (decay(paper.loop) - paper.e @ missing)
                ),
            ),
            mean_square(),
            counterexample(  # largest |e| with hedging, and without
                "the paper's system, started true, with v_max = 1.5: CLPE leaves zero",
                limited_speed_counterexample,
                lambda largest: largest[0] < 1e-6 < 1e-2 < largest[1],
                "largest |e| {0[1]:.3f} within a cycle, {0[0]:.0e} with hedging",
            ),
        ],
        "What is not flown acts like a disturbance at every waypoint.",
        corrected="int |e|^2 dt <= 2 V(0)/k + int |v_c - v|^2 dt/k^2 with k = lambda_min(KD)",
    )


LIMITED_SPEED: dict[str, Callable[[], Proof]] = {
    "with hedging": with_hedging,
    "every law with hedging": every_law,
    "without hedging": without_hedging,
}
