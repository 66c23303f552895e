"""V' along the equations that run, for N = 1, 2, 3 and for every N.

    V' = sum_i dV/ds_i * s_i'        over all states s of the closed loop

V is a block of the diagram (`blocks.lyapunov`), s' comes from the update
functions on symbols.  What a theorem claims V' to be is stated once, over the paper's symbols, and
compared with what the blocks give: for N = 1, 2, 3 term by term, for every N as
base + sum over k of a summand, and at random points with the blocks that run.
"""

from collections.abc import Callable
from typing import NamedTuple

import sympy

from ...diagrams.interconnection import Diagram
from ...errors import DiagramError
from .every_n_loop import EveryNLoop, every_n_loop
from .every_n_signals import Summed
from .proof import Step, checked
from .running_rate import compared
from .symbolic_loop import SymbolicLoop, symbolic_loop
from .theorem_loop import Hedging, theorem_loop


class Terms(NamedTuple):
    """The paper's symbols as functions of the axis i = 0, 1 and the function k; phi at x."""

    e: Callable
    KD: Callable
    delta: Callable
    theta: Callable
    theta_hat: Callable
    phi: Callable


def loop_terms(loop: SymbolicLoop) -> Terms:
    """Return the paper's symbols of a loop for one N."""
    p, made, N = loop.parameters, loop.states.get("theta_hat"), loop.N or 0
    return Terms(
        e=lambda i: loop.signals["e"][i],
        KD=lambda i: p["vehicle_controller"].KD[i],
        delta=lambda i: loop.inputs["delta"][i],
        theta=lambda i, k: p["true_flow"].theta[i, k],
        theta_hat=lambda i, k: p["injection"].theta_hat[i, k] if made is None else made[i * N + k],
        phi=lambda k: loop.inputs["phi_x"][k],
    )


def every_n_terms(loop: EveryNLoop) -> Terms:
    """Return the paper's symbols for every N; k is None, the index."""

    def own(block: str, field: str) -> Callable:
        return lambda *places: loop.parameter(loop.names[block, field], *places)

    return Terms(
        e=lambda i: loop.signals["e", None, i].base,
        KD=own("vehicle_controller", "KD"),
        delta=lambda i: loop.signals["delta", None, i].base,
        theta=own("true_flow", "theta"),
        theta_hat=own("injection", "theta_hat"),
        phi=lambda k: loop.signals["phi_x", 0, None],
    )


# what V' should be: claim(terms, k) -> (base, summand over k)
Claim = Callable[[Terms, int | None], tuple[sympy.Expr, sympy.Expr]]


def decay(terms: Terms, k: int | None) -> tuple[sympy.Expr, sympy.Expr]:
    """V' = -e^T KD e, Eq. (26)."""
    return -sum(terms.KD(i) * terms.e(i) ** 2 for i in range(2)), sympy.Integer(0)


def decay_and_known_error(terms: Terms, k: int | None) -> tuple[sympy.Expr, sympy.Expr]:
    """V' = -e^T KD e + e^T (theta - theta_hat) phi, Theorem 3.1."""
    summand = sum(
        terms.e(i) * (terms.theta(i, k) - terms.theta_hat(i, k)) * terms.phi(k) for i in range(2)
    )
    return decay(terms, k)[0], summand


def decay_and_disturbance(terms: Terms, k: int | None) -> tuple[sympy.Expr, sympy.Expr]:
    """V' = -e^T KD e + e^T Delta, Eq. (35)."""
    push = sum(terms.e(i) * terms.delta(i) for i in range(2))
    return decay(terms, k)[0] + push, sympy.Integer(0)


def lyapunov_derivative(diagram: Diagram) -> tuple[SymbolicLoop, sympy.Expr]:
    """Return the diagram on symbols and its V', multiplied out."""
    loop = symbolic_loop(diagram)
    if "V" not in loop.signals:
        raise DiagramError("no block makes V; wire a candidate such as blocks.lyapunov")
    return loop, sympy.expand(loop.derivative(loop.signals["V"][0]))


def claimed(loop: SymbolicLoop, claim: Claim) -> sympy.Expr:
    """Return what a claim says of V', for the loop's own N."""
    terms = loop_terms(loop)
    summands = sum((claim(terms, k)[1] for k in range(loop.N or 0)), sympy.Integer(0))
    return claim(terms, 0)[0] + summands


def residual(diagram: Diagram, claim: Claim) -> tuple[SymbolicLoop, sympy.Expr]:
    """Return the loop and what V' has beyond a claim, for the diagram's own N."""
    loop, rate = lyapunov_derivative(diagram)
    return loop, sympy.expand(rate - claimed(loop, claim))


def every_n_residual(diagram: Diagram, claim: Claim) -> tuple[EveryNLoop, Summed]:
    """Return the loop and what V' has beyond a claim, base and summand, for every N."""
    loop = every_n_loop(diagram)
    rate = loop.derivative(loop.signals["V", None, 0])
    base, summand = claim(every_n_terms(loop), None)
    return loop, Summed(sympy.expand(rate.base - base), sympy.expand(rate.term - summand))


def identity_steps(
    text: str,
    law: str,
    claim: Claim,
    points: int,
    disturbed: bool = False,
    speed: Hedging = "no limit",
) -> list[Step]:
    """Check V' exactly, for N = 1, 2, 3 and every N, and at points of the running blocks.

    `text` is the claim in words; the exact step says what does not cancel, the other one where.
    """

    def identity() -> tuple[bool, str]:
        for N in (1, 2, 3):
            loop, left = residual(theorem_loop(N, law, disturbed, speed=speed), claim)
            if left != 0:
                return False, f"N = {N}, left over: {short(left)}"
            if loop.undefined:
                return False, loop.undefined[0]
        every_loop, rest = every_n_residual(theorem_loop(3, law, disturbed, speed=speed), claim)
        if rest.base != 0 or rest.term != 0:
            said = f"left over: {short(rest.base)}; summand {short(rest.term)}"
            return False, f"every N, {said}"
        if every_loop.undefined:
            return False, every_loop.undefined[0]
        return True, "base and summand over k vanish"

    def running() -> tuple[bool, str]:
        diagram = theorem_loop(3, law, disturbed, speed=speed)
        loop = symbolic_loop(diagram)
        found = compared(diagram, loop, claimed(loop, claim), points)
        if found.where is not None:
            return False, f"differs by {found.worst:.1e} at x = {found.where.x.round(3).tolist()}"
        return True, f"{found.points} points, N = 3, largest difference {found.worst:.0e} of V"

    return [
        checked(f"{text}, for N = 1, 2, 3 and every N", "exact", identity),
        checked(f"the running blocks give the same V' ({text})", "sampled", running, False),
    ]


def short(expression: sympy.Expr, most: int = 160) -> str:
    """Return an expression as text of a line."""
    text = str(expression)
    return text if len(text) <= most else text[:most] + " ..."
