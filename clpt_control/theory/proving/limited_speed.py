"""A vehicle whose speed is limited: what hedging keeps of the theorems, and what is lost without.

    x' = F_R + v,   z' = F_M + v_z - (v_c - v)        v_c commanded by Eq. (7), v flown

With hedging e' = F_R + v_c - F_M - v_z, whatever v is: e' and V' of every law are those of a
vehicle without a limit.  Without it V' = -e^T KD e - e^T (v_c - v).

Theorem 3.2 also needs x bounded.  With w = KD x and v_c = b - w, b of phi and zc alone, the limit
v = v_max v_c/|v_c| gives w^T v <= v_max (2 |b| - |w|), so

    (x^T KD x/2)' = w^T (F_R + v) < 0      where |w| > 2 v_max |b|/(v_max - |F_R|)

if the flow is slower than the vehicle; x is then bounded.  A faster one carries it away.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import sympy

from ...blocks.laws.law import Law
from ...blocks.laws.table import LAWS
from ...blocks.vehicle import speed_limit
from ...diagrams.interconnection import connect
from ..counterexamples import limited_speed_counterexample
from .invariant_loop import InvariantLoop
from .lemmas import (
    algebra_step,
    definite_step,
    dissipation_step,
    learned_loop,
    wanted_rates,
    young_step,
)
from .proof import Proof, checked, counterexample, theorem
from .signs import left_over, vanishes
from .symbolic_loop import ArrayLoop, symbolic_loop
from .theorem_loop import decay, identity_steps, law_and_V, law_loop, rate_of_V, zero_step
from .words import MAXIMUM

POINTS = 1_000  # at which the running blocks are called
N = 2  # functions, for each law of the table
OPEN = "Theorem 3.2 where the vehicle's speed is limited, which the paper leaves open"
SLOWER = "|F_R| stays below some F < v_max"


def differs(law: Law) -> str:
    """Return how a hedged law differs from the one without a limit, or nothing."""
    loops = [
        symbolic_loop(law_loop(law, *law_and_V(law, N, speed), speed), jumps=True)
        for speed in ("no limit", "hedged")
    ]
    free, hedged = loops
    flown = dict(zip(hedged.inputs["v_x"], free.signals["v_x"], strict=True))
    if difference := left_over(rate_of_V(free) - rate_of_V(hedged)):  # whatever v is flown
        return difference
    own = free.motion.keys() - {*free.states["x"].flat, *free.states["z"].flat}
    jumps = (loop.jumps.values() for loop in loops)
    for one, other in [(free.motion, hedged.motion), *zip(*jumps, strict=True)]:
        for s in own & one.keys():
            if not vanishes(one[s] - other[s].xreplace(flown)):
                return f"{s} moves or jumps differently"
    return "" if law.invariants is None else InvariantLoop(law, N, "hedged").broken()


def same_rate_of_every_law() -> tuple[bool, str]:
    """Return whether V' of each law is that without a limit, and its relations are kept.

    Its own states move as without a limit too, with the flown velocity for the commanded one.
    """
    laws = [law for law in LAWS.values() if not law.at_fixes]  # those predict with v as flown
    for law in laws:
        if difference := differs(law):
            return False, f"{law.name}: {difference}"
    return True, ", ".join(law.name for law in laws)


def limits() -> bool:
    """Return whether the block flies v_c up to v_max, and v_max in its direction beyond."""
    loop = symbolic_loop(connect([speed_limit(1.5)], external=["v_c"]))
    v, c = loop.signals["v_x"], loop.inputs["v_c"]
    largest = loop.parameters["speed_limit"].max_speed
    speed = sympy.sqrt(c[0] ** 2 + c[1] ** 2)
    larger = MAXIMUM(speed, largest), MAXIMUM(largest, speed)
    return any(all(map(vanishes, v - largest * c / one)) for one in larger)


def commanded_back(loop: ArrayLoop) -> list[Any]:
    """Return what v_c has beside b - KD x, b of phi and zc alone, and x' beside F_R + v."""
    car, inputs = loop.parameters["vehicle_controller"], loop.inputs
    b = car.GammaD * inputs["zc"] - car.alpha_M @ inputs["phi_x"]
    commanded = loop.signals["v_c"] - (b - car.KD * loop.states["x"])
    return [commanded, loop.rates["x"] - (loop.signals["flow_x"] + inputs["v_x"])]


def lost_without(loop: ArrayLoop) -> list[Any]:
    """Return what V' has beside -e^T KD e - e^T (v_c - v) without hedging."""
    missing = loop.signals["v_c"] - loop.inputs["v_x"]
    return [rate_of_V(loop) - (decay(loop) - loop.signals["e"] @ missing)]


def with_hedging() -> Proof:
    """Prove Theorem 3.2 of a vehicle whose speed is limited, with hedging."""
    text = "V' = -e^T KD e, whatever v is flown"
    steps = [
        *identity_steps(text, "learned-flow", decay, POINTS, speed="hedged"),
        zero_step(
            "e' is that without a limit, for every N",
            partial(learned_loop, "hedged"),
            lambda loop: [loop.derivative(loop.signals["e"]) - wanted_rates(loop)["e"]],
        ),
        definite_step("learned-flow"),
        dissipation_step(),
        checked("v = v_c up to |v_c| = v_max, and v_max v_c/|v_c| beyond", limits),
        zero_step(
            "x' = F_R + v and v_c = b - KD x, b of phi and zc alone, for every N",
            partial(learned_loop, "hedged"),
            commanded_back,
        ),
        algebra_step(  # w^T v = v_max (b - c)^T c/|c|, b^T c <= |b| |c|, |c| >= |w| - |b|
            "w = KD x: (x^T KD x/2)' = w^T (F_R + v) <= |w| |F_R| + v_max (2 |b| - |w|) at the "
            "limit, so x is bounded where |F_R| < v_max",
            "(b1**2 + b2**2)*(c1**2 + c2**2) - (b1*c1 + b2*c2)**2 - (b1*c2 - b2*c1)**2",
            "2*v*b/(v - F)*F + v*(2*b - 2*v*b/(v - F))",  # zero at |w| = 2 v_max |b|/(v_max - F)
        ),
    ]
    return theorem(
        OPEN,
        ("Assumptions of Theorem 3.2", f"for CLPE -> 0 also: {SLOWER}"),
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
    return theorem(
        OPEN,
        ("Assumptions of Theorem 3.2",),
        [
            zero_step(
                "V' = -e^T KD e - e^T (v_c - v), for every N",
                partial(learned_loop, "not hedged"),
                lost_without,
            ),
            young_step(),
            counterexample(  # largest |e| with hedging, and without
                "the paper's system, started true, with v_max = 1.5: CLPE leaves zero",
                partial(limited_speed_counterexample, end=200.0),
                lambda found: found[0] < 1e-6 < 1e-2 < found[1],
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
