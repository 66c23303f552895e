"""The proof of a law that learns at fixes: what stays between them, and what each fix does.

    (x - z - eta m)' = 0, V' = 0               between fixes, where phi(x) = phi(z)
    V_after - V = (|w|^2 - r^2 |y|^2/d)/2      at a fix with y = eta m + w, d = r^2 + m^T P m
    x - z = eta m - w                          after it, and P is the inverse of P^-1 + m m^T/r^2
    nothing changes                            where a fix is missing, or only sent

w is any error: noise of the fix, unmodelled flow, phi(z) for phi(x).  A fix that arrives late has m
of when it was sent; what was integrated since stands beside it, x - z = eta (m_sent + m).  Coq
bounds w by the shear of the true flow times the interval, and so V (`coq/LawFixRegression.v`).
"""

from itertools import product
from typing import Any

import numpy as np
import sympy
from sympy import Expr

from ...engine.diagram.interconnection import Diagram, connect
from ...paper.laws.law import Law
from ...simulation.loops import ClosedLoop
from ..algebra.decided import decided
from ..algebra.exact import vanishes
from ..proofs.same_as_running import running_step
from ..proofs.statements import said
from ..proofs.steps import Step, exact_step
from ..proofs.symbolic_loop import equated, symbolic_loop
from .theorem_loop import law_and_V, rate_of_V, theorem_scenario

SIZES_AT_FIXES = (1, 2)  # numbers of functions; 3 takes half a minute
SEND, ARRIVE = 1, 2  # intervals that begin with a fix, and with its arrival
# what comes from blocks that are left out
OUTSIDE = ("phi_x", "phi_z", "v_x", "fix", "taken")
MOVING = ("x", "z", "m")  # states that change between fixes
READ = ("alpha", "z", "information")  # and those that others read as they are
CHANGE = "(|w|^2 - r^2 |y|^2/(r^2 + m^T P m))/2"  # of V at a fix
LARGEST_W = "omega + G kappa B^(1/2)"
COQ = "checked by Coq: theory/coq/LawFixRegression.v, fix_regression_bound"
States = dict[str, np.ndarray]


def wrong(rows: dict[str, Any]) -> str:
    """Return the names of the rows that are not zero for all symbols."""
    names = [
        name
        for name, residual in rows.items()
        if not all(map(vanishes, np.ravel(residual)))
    ]
    return f"{', '.join(names)} differs" if names else ""


def loop_at_fixes(law: Law, N: int, late: bool = False) -> Diagram:
    """Wire vehicle, law and V; fixes, basis functions and the velocity flown are inputs."""
    block, V = law_and_V(law, N)
    block.parameters = block.parameters._replace(latency=float(late))
    closed_loop = ClosedLoop(theorem_scenario(N, law.name), external=OUTSIDE)
    blocks = [b for b in closed_loop.blocks() if b.name != block.name]
    return connect([*blocks, block, V], OUTSIDE, name="between")


class AtFixes:
    """Vehicle, law and V on symbols; fixes and what moves the vehicle are inputs."""

    def __init__(self, law: Law, N: int, late: bool):
        self.N, self.late = N, late
        self.loop = symbolic_loop(loop_at_fixes(law, N, late), jumps=True)
        p = self.loop.parameters
        self.w = np.array(sympy.symbols("w_1:3", real=True, cls=sympy.Dummy))
        self.theta, self.r = p["true_flow"].theta, p["adaptation"].noise
        P = sympy.Matrix(N, N, lambda j, k: self.loop.states["P"][min(j, k), max(j, k)])
        before = {"P": P, "information": P.adjugate() / P.det()}
        self.known = {p["lyapunov"].noise: self.r} | equated(self.loop.states, before)

    def eta(self, states: States) -> np.ndarray:
        """Return theta + alpha, shape (2, N)."""
        return self.theta + states["alpha"]

    def missed(self, states: States) -> np.ndarray:
        """Return eta m, m with that of a fix under way."""
        return self.eta(states) @ (states["m"] + states["waiting"] * states["m_sent"])

    def V(self, states: States) -> Expr:
        """Return V = r^2 tr(eta P^-1 eta^T)/2 of the states, as its block has it."""
        substitutions = self.known | equated(self.loop.states, states)
        return self.loop.signals["V"][0].xreplace(substitutions)

    def stays(self) -> str:
        """Return what changes between fixes where phi(x) = phi(z), or nothing."""
        loop, s = self.loop, self.loop.states
        equal_phi = dict(zip(loop.inputs["phi_x"], loop.inputs["phi_z"], strict=True))
        return wrong(
            {
                "x - z - eta m": [
                    rate.subs(equal_phi)
                    for rate in loop.derivative(s["x"] - s["z"] - self.missed(s))
                ],
                "V": rate_of_V(loop),
                **{f"{port} read": loop.signals[port] - s[port] for port in READ},
                **{port: loop.rates[port] for port in s if port not in MOVING},
            }
        )

    def learns(self) -> str:
        """Return what a jump does wrong, or nothing; there is a fix, or it is missing."""
        jumps = (self.after(*jump_k) for jump_k in product((SEND, ARRIVE), (0, 1)))
        return next(filter(None, jumps), "")

    def after(self, interval: int, has_fix: int) -> str:
        """Return which of the claims fails at the jump with which an interval begins."""
        s, r, identity = self.loop.states, self.r, np.eye(self.N, dtype=int)
        got = has_fix if interval == ARRIVE or not self.late else 0
        substitutions = self.known | equated(self.loop.inputs, {"taken": has_fix})
        substitutions[self.loop.parameters["adaptation"].interval] = sympy.Integer(
            interval
        )
        sent = s["z_sent"] + self.eta(s) @ s["m_sent"] + self.w
        sent = sent if self.late else s["sent"]
        substitutions |= equated(s, {"waiting": got if self.late else 0, "sent": sent})

        def states(new: dict[Expr, Expr]) -> States:
            put = np.vectorize(
                lambda a: decided(a.xreplace(new).xreplace(substitutions)),
                otypes=[object],
            )
            return {port: put(symbols) for port, symbols in s.items()}

        before = states({})
        x, m = before["z"] + self.missed(before), before["m_sent" if self.late else "m"]
        substitutions |= equated(self.loop.inputs, {"fix": x + self.w})
        after = states(*self.loop.jumps.values())
        y, d = self.eta(before) @ m + self.w, r**2 + m @ before["P"] @ m
        sent = after["sent"] - after["z_sent"] - self.eta(after) @ after["m_sent"]
        sent = sent - self.w
        rise = got * (sum(self.w**2) - r**2 * sum(y**2) / d) / 2
        gained = after["information"] - before["information"]
        return wrong(
            {
                "V": self.V(after) - self.V(before) - rise,
                "P": after["P"] @ after["information"] - identity,
                "P^-1": gained - got * np.outer(m, m) / r**2,
                "x - z - eta m": x - after["z"] - self.missed(after) + got * self.w,
                "what is missing": (1 - got) * (after["alpha"] - before["alpha"]),
                "the fix under way": [
                    *after["waiting"] * sent,
                    *after["waiting"] - has_fix + got,
                ],
            }
        )


def fix_steps(law: Law, points: int) -> list[Step]:
    """Check a law that learns at fixes, for N = 1, 2."""
    cases = [AtFixes(law, N, late) for N in SIZES_AT_FIXES for late in (False, True)]
    claims = {
        "between fixes V' = 0, `P' = 0` and `(x - z - eta m)' = 0` where `phi(x) = phi(z)`, "
        "whatever `v` is flown": AtFixes.stays,
        f"at a fix with `y = eta m + w`, for any `w`, V changes by `{CHANGE}`, "
        "`P^-1` rises by `m m^T/r^2` and `x - z = eta m - w`, "
        "also where it arrives late; one missing or on its way changes nothing": AtFixes.learns,
    }
    steps = [
        exact_step(cases, claim, check, "values fixes")
        for claim, check in claims.items()
    ]
    claim = said(f"`|w| <= {LARGEST_W}`, for every N")
    bounded = Step(claim, True, "cited", COQ, shows="fixes")
    return [*steps, bounded, running_step(lambda: cases[-1].loop, points)]
