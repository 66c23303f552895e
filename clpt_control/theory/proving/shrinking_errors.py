"""Prove a law of which no parameter's error ever rises: eta = w eta(0), w' = -f w, f >= 0.

Such a law takes no part of e into alpha', so that V' has e^T eta phi left, as in Theorem 3.1:

    V' = -e^T KD e + e^T eta phi - f |eta|^2/gamma,    |eta_ik| never rises

which bounds the mean square of e by that of eta phi.  That eta = w eta(0) is kept is shown as in
`kept_relations`; the readout is theta where its condition holds.
"""

from typing import Any

import numpy as np
import sympy

from ...blocks.laws.law import Law
from ...equations.symbolic import UNEXPANDED
from .boundedness import young_step
from .kept_loop import Kept, cases_of, exact_step, kept_step, same_running
from .lyapunov import decay
from .proof import Step, short
from .vanishing import vanishes

MAXIMUM = sympy.Function(UNEXPANDED["maximum"], real=True)
WHERE = sympy.Function(UNEXPANDED["where"], real=True)


def shrinking_steps(law: Law, points: int) -> list[Step]:
    """Check a law whose row names the state with which every parameter's error shrinks."""
    cases, w = cases_of(law), law.shrinking

    def rest(case: Kept) -> str:
        return case.left_over(decay, driven(case, law))

    steps = [
        kept_step(cases),
        exact_step(
            cases, f"eta = {w} eta(0) for every parameter", lambda case: _is_all_of_alpha(case, law)
        ),
        exact_step(
            cases,
            f"{w}' = -f {w}, f >= 0, so no parameter's error rises",
            lambda case: _rises(case, law),
        ),
        exact_step(cases, f"V' = {law.says}, N = 1, 2, 3", rest),
        exact_step(cases, "V is not negative", lambda case: case.not_negative(case.V)),
        young_step(),
        same_running(cases, points),
    ]
    if law.readout:
        claim = f"{law.readout} is theta where its condition holds, and -alpha elsewhere"
        steps.insert(3, exact_step(cases, claim, lambda case: _reads(case, law)))
    return steps


def _rises(case: Kept, law: Law) -> str:
    """Return why w is not known to fall, or nothing."""
    if case.loop.jumps:
        return "its states jump, and what its errors do there is not judged"
    f = rate_of_shrinking(case, law)
    if not f.is_nonnegative or sympy.expand(f) == 0:
        return f"{law.shrinking}' = {short(case.rates[law.shrinking][0])}"
    return ""


def rate_of_shrinking(case: Kept, law: Law) -> sympy.Expr:
    """Return f of w' = -f w, each maximum(a, b) with a positive one a positive symbol."""
    (w,), (rate,) = case.states[law.shrinking], case.rates[law.shrinking]
    f = -case.veiled(rate) / w
    return sympy.nan if f.has(w) else f


def driven(case: Kept, law: Law) -> sympy.Expr:
    """Return e^T eta phi - f |eta|^2/gamma, gamma those of V."""
    p, loop = case.loop.parameters, case.loop
    eta = p["true_flow"].theta + case.states["alpha"]
    w, rate = case.states[law.shrinking][0], case.rates[law.shrinking][0]
    pushed = loop.signals["e"] @ (eta @ loop.inputs["phi_x"])
    return pushed + rate / w * np.sum(eta**2 / p["lyapunov"].gain)


def _is_all_of_alpha(case: Kept, law: Law) -> bool:
    """Return whether each alpha is kept at w times what does not move, less theta."""
    (w,) = case.states[law.shrinking]
    theta = case.loop.parameters["true_flow"].theta
    for alpha, own in zip(case.states["alpha"].flat, theta.flat, strict=True):
        eta = sympy.expand(case.relations.get(alpha, alpha) + own)
        first = sympy.cancel(eta / w)
        if first == 0 or first.free_symbols & case.loop.motion.keys() or not first.has(own):
            return False
    return True


def _reads(case: Kept, law: Law) -> bool:
    """Return whether a readout where(1 - w >= m, a, -alpha) is theta in its first branch."""
    (w,) = case.states[law.shrinking]
    read, theta = case.loop.signals[law.readout], case.loop.parameters["true_flow"].theta
    triples = zip(read.flat, case.states["alpha"].flat, theta.flat, strict=True)
    return all(_is_readout(case, *triple, w) for triple in triples)


def _is_readout(case: Kept, found: Any, alpha: Any, theta: Any, w: Any) -> bool:
    if not isinstance(found, WHERE):
        return False
    condition, then, before = found.args
    if str(getattr(condition, "func", "")) != "ge" or condition.args[0] != 1 - w:
        return False
    margin = condition.args[1]
    known = {MAXIMUM(*pair): 1 - w for pair in ((margin, 1 - w), (1 - w, margin))}
    right = vanishes(case.put(then.subs(known)) - theta)
    return bool(margin.is_positive) and right and sympy.expand(before + alpha) == 0
