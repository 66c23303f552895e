"""All that `clpt prove` proves: theorems, laws, a team.

Every law of the table is proved with its own V on the equations that run.  One with
V' <= -e^T KD e is proved; one with V' <= -e^T KD e + what is bounded is bounded, and the set that V
comes to is said.  A law that is given an estimate of the flow has the V' of Theorem 3.1, and is
bounded in the mean square by the error of the estimate.  A law that learns at fixes keeps V from
rising there.  Of a team V is the sum of the vehicles' V,

    V' = -sum_i e_i^T KD_i e_i - (kappa/gamma) sum |alpha_i - alpha_j|^2    over the edges (i, j)

Each vehicle has its own phi, zc, KD, GammaD and alpha_M; theta, gamma and kappa are one.  Shown
for two vehicles, three in a row and three in a circle, exactly for every N.  As V
never rises, e goes to zero by the lemma of Theorem 3.2 and neighbours agree likewise.

A vehicle whose speed is limited: what hedging keeps of the theorems, and what is lost without.

    x' = F_R + v,   z' = F_M + v_z - (v_c - v)        v_c commanded by Eq. (7), v flown

With hedging e' = F_R + v_c - F_M - v_z, whatever v is: e' and V' of every law are those of a
vehicle without a limit.  Without it V' = -e^T KD e - e^T (v_c - v).

Theorem 3.2 also needs x bounded.  With w = KD x and v_c = b - w, b of phi and zc alone, the limit
v = v_max v_c/|v_c| gives w^T v <= v_max (2 |b| - |w|), so

    (x^T KD x/2)' = w^T (F_R + v) < 0      where |w| > 2 v_max |b|/(v_max - |F_R|)

if the flow is slower than the vehicle; x is then bounded.  A faster one carries it away.
"""

from collections.abc import Callable, Iterator
from functools import partial
from itertools import chain
from typing import Any, NamedTuple

import numpy as np
import sympy

from ...blocks.consensus import total_candidate
from ...blocks.laws.law import Law
from ...blocks.laws.table import LAWS
from ...blocks.vehicle import speed_limit
from ...engine.diagram.interconnection import Diagram, connect
from ...engine.model.ports import named, split, within
from ...scenario.team import TEAM_LAW, Team
from ...simulation.team_loops import team_blocks
from ..counterexamples import limited_speed_counterexample
from . import lemmas
from .invariant_loop import InvariantLoop
from .invariants import fix_steps, invariant_steps
from .misprints import misprints
from .own_law import prove
from .proof import (
    Proof,
    Step,
    checked,
    counterexample,
    proof_or_failure,
    theorem,
    where_all_hold,
)
from .running_rate import running_step
from .signs import left_over, vanishes
from .symbolic_loop import ArrayLoop, symbolic_loop
from .theorem_loop import (
    KNOWN_ERROR,
    SOURCES,
    Loop,
    decay,
    decay_and_known_error,
    identity_steps,
    law_and_V,
    law_loop,
    rate_of_V,
    theorem_candidate,
    theorem_scenario,
    zero_step,
)
from .theorems import THEOREMS, numbers_of
from .words import MAXIMUM

POINTS = 1_000  # at which the running blocks are called
N = 2  # functions of a law of the table; a proof for every N says so
OPEN = "Theorem 3.2 where the vehicle's speed is limited, which the paper leaves open"


def differs(law: Law) -> str:
    """Return how a hedged law differs from the one without a limit, or nothing."""
    free, hedged = (
        symbolic_loop(law_loop(law, *law_and_V(law, N, speed), speed), jumps=True)
        for speed in ("no limit", "hedged")
    )
    flown = dict(zip(hedged.inputs["v_x"], free.signals["v_x"], strict=True))
    if difference := left_over(rate_of_V(free) - rate_of_V(hedged)):
        # whatever v is flown
        return difference
    own = free.motion.keys() - {*free.states["x"].flat, *free.states["z"].flat}
    jumps = zip(free.jumps.values(), hedged.jumps.values(), strict=True)
    for one, other in [(free.motion, hedged.motion), *jumps]:
        for s in own & one.keys():
            if not vanishes(one[s] - other[s].xreplace(flown)):
                return f"{s} moves or jumps differently"
    return "" if law.invariants is None else InvariantLoop(law, N, "hedged").broken()


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
            partial(lemmas.learned_loop, "hedged"),
            lambda loop: [
                loop.derivative(loop.signals["e"]) - lemmas.wanted_rates(loop)["e"]
            ],
        ),
        lemmas.definite_step("learned-flow"),
        lemmas.dissipation_step(),
        checked("v = v_c up to |v_c| = v_max, and v_max v_c/|v_c| beyond", limits),
        zero_step(
            "x' = F_R + v and v_c = b - KD x, b of phi and zc alone, for every N",
            partial(lemmas.learned_loop, "hedged"),
            commanded_back,
        ),
        lemmas.algebra_step(  # w^T v = v_max (b - c)^T c/|c|, b^T c <= |b| |c|, |c| >= |w| - |b|
            "w = KD x: (x^T KD x/2)' = w^T (F_R + v) <= |w| |F_R| + v_max (2 |b| - |w|) at the "
            "limit, so x is bounded where |F_R| < v_max",
            "(b1**2 + b2**2)*(c1**2 + c2**2) - (b1*c1 + b2*c2)**2 - (b1*c2 - b2*c1)**2",
            "2*v*b/(v - F)*F + v*(2*b - 2*v*b/(v - F))",  # zero at |w| = 2 v_max |b|/(v_max - F)
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
    return theorem(
        OPEN,
        ("Assumptions of Theorem 3.2",),
        [
            zero_step(
                "V' = -e^T KD e - e^T (v_c - v), for every N",
                partial(lemmas.learned_loop, "not hedged"),
                lost_without,
            ),
            lemmas.young_step(),
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


MEAN = (
    f"{KNOWN_ERROR}: in the mean |e| <= |(theta - theta_hat) phi| over the least of KD"
)


def proof_of_law(law: Law) -> Proof:
    """Prove one law."""
    if law.at_fixes:  # V does not rise, but CLPE is only what fixes leave
        claim = f"V' = {law.V_rate}; |eta_k| <= (2 V(0) P_kk)^(1/2)/r"
        return where_all_hold("bounded", claim, fix_steps(law, POINTS))
    if law.invariants is not None:
        status, end = "proved", "so CLPE goes to zero"
        if law.perturbation is not None:
            status, end = "bounded", "in the mean |e| <= |eta phi| over the least of KD"
        claim = f"V' <= {law.V_rate}, {end}"
        return where_all_hold(status, claim, invariant_steps(law, POINTS))
    if law.given_estimate:
        steps = identity_steps(KNOWN_ERROR, law.name, decay_and_known_error, POINTS)
        return where_all_hold("bounded", MEAN, steps)
    verdict = prove(
        law_and_V(law, N)[0], lambda truth, p: law.V(p, truth), points=POINTS
    )
    return Proof(verdict.status, verdict.claim, verdict.for_every_N, verdict.steps)


GRAPHS = {
    "two vehicles": (("a", "b"),),
    "three in a row": (("a", "b"), ("b", "c")),
    "three in a circle": (("a", "b"), ("b", "c"), ("a", "c")),
}
CITED = (
    "where the pooled Gramian is positive definite in every window alike, the flow parameters of "
    "all vehicles go to theta exponentially (Chen, Wen, Hua and Sun 2014, IEEE Transactions on "
    "Automatic Control 59(1))"
)
COUPLING = 0.6  # stands for any kappa > 0
CLAIM = "V' = -sum e^T KD e - (kappa/gamma) sum over edges |alpha_i - alpha_j|^2"


def proof_of_team() -> Proof:
    """Prove the law of a team."""
    claim = f"{CLAIM}, so CLPE goes to zero and the vehicles agree: {', '.join(GRAPHS)}"
    return where_all_hold("proved", claim, team_steps(), CITED)


def team_steps() -> Iterator[Step]:
    """Yield the steps of the proof one by one."""
    for name, edges in GRAPHS.items():
        diagram, rest = (
            partial(team_diagram, edges, N),
            partial(beside_claim, edges=edges),
        )
        yield zero_step(f"{CLAIM}, {name}, every N", diagram, rest)
    row = team_diagram(GRAPHS["three in a row"], N)
    yield running_step(lambda: symbolic_loop(row), POINTS, ", three in a row")


def team_diagram(edges: tuple[tuple[str, str], ...], N: int) -> Diagram:
    """Wire a team with its V, whose vehicles differ in all that may differ.

    phi_x, phi_z and zc of each vehicle are inputs.
    """
    members = {
        name: theorem_scenario(N, TEAM_LAW).with_values(
            {
                "vehicle.feedback": [1.0 + 0.3 * k, 0.7 + 0.2 * k],
                "vehicle.feedforward": [1.2 - 0.4 * k, -0.5 - 0.1 * k],
            }
        )
        for k, name in enumerate(sorted({*chain(*edges)}))
    }
    blocks = team_blocks(Team(members=members, edges=edges, coupling=COUPLING))
    sources = [block for block in blocks if split(block.name)[1] in SOURCES]
    external = [port for block in sources for port in block.output_ports]
    blocks = [block for block in blocks if block not in sources]
    blocks += [within(theorem_candidate(one), name) for name, one in members.items()]
    return connect([*blocks, total_candidate(list(members))], external, name="team")


def beside_claim(loop: Loop, edges: tuple[tuple[str, str], ...]) -> list[Any]:
    """Return what V' has beside the claim."""
    p, signals = loop.parameters, loop.signals
    kappa, gamma = p[named("a", "consensus")].coupling, p[named("a", "adaptation")].gain
    falls = [
        np.sum(p[named(name, "vehicle_controller")].KD * signals[named(name, "e")] ** 2)
        for name in sorted({*chain(*edges)})
    ]
    apart = [
        np.sum((signals[named(one, "alpha")] - signals[named(other, "alpha")]) ** 2)
        for one, other in edges
    ]
    return [rate_of_V(loop) + sum(falls) + kappa / gamma * sum(apart)]


Outcome = Proof | list[dict[str, Any]]  # of misprints the rows of a table
PROOFS: dict[
    str, tuple[str, dict[str, Callable[[], Proof]]]
] = {  # room -> status where unread
    "theorems": ("failed", THEOREMS),
    "team": ("open", {"": proof_of_team}),
    "limited_speed": ("failed", LIMITED_SPEED),
    "laws": ("open", {name: partial(proof_of_law, law) for name, law in LAWS.items()}),
}


class Statement(NamedTuple):
    """One of the things that are proved."""

    room: str  # of `PROOFS`, or "misprints"
    name: str = ""

    def prove(self) -> Outcome:
        """Prove it now."""
        if self.room == "misprints":
            keys = ("equation", "printed", "corrected", "check", "confirmed")
            return [{key: getattr(one, key) for key in keys} for one in misprints()]
        status, proofs = PROOFS[self.room]
        return proof_or_failure(status, proofs[self.name])


Outcomes = dict[Statement, Outcome]


def statements(theorem: str | None = None) -> list[Statement]:
    """Return what is proved: one theorem and the misprints, or everything."""
    every = {
        room: list(proofs) for room, (_, proofs) in PROOFS.items() if theorem is None
    }
    wanted = {**every, "theorems": numbers_of(theorem), "misprints": [""]}
    return [Statement(room, name) for room, names in wanted.items() for name in names]
