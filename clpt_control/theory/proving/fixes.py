"""The proof of a law that learns at fixes: what stays between them, and what each fix does.

    (x - z - eta m)' = 0, V' = 0              between fixes, where phi(x) = phi(z)
    V_after - V = -r^2 |eta m|^2/(2 d)        at an exact fix, d = r^2 + m^T P m
    x - z = eta m                             still, and P is the inverse of P^-1 + m m^T/r^2
    nothing changes                           where a fix is missing

So V never rises, P^-1 never falls, and |eta_k| <= (2 V(0) P_kk)^(1/2)/r.  A fix that arrives late
is shown alike, with what was integrated in between.  Not shown: phi(x) = phi(z), which holds the
better the nearer the prediction is.
"""

from typing import Any

import numpy as np
import sympy

from ...blocks.laws.law import Law
from ...diagrams.interconnection import connect
from ...simulation.loops import LoopOf, remaining_parts
from .proof import Step, checked, exact_step
from .signs import vanishes
from .symbolic_loop import SymbolicLoop, equated, symbolic_loop
from .theorem_loop import law_and_V, rate_of_V, theorem_scenario
from .words import decided

SIZES = (1, 2)  # numbers of functions; 3 takes half a minute, in a slow test
SEND, ARRIVE = 1, 2  # intervals that begin with a fix, and with its arrival
OUTSIDE = "phi_x", "phi_z", "v_x", "fix", "taken"  # what comes from blocks that are left out
MOVING = ("x", "z", "m")  # states that change between fixes
States = dict[str, np.ndarray]


def loop_of(law: Law, N: int, late: bool) -> SymbolicLoop:
    """Return the vehicle, the law and V on symbols; fixes and what moves the vehicle are inputs."""
    block, V = law_and_V(law, N)
    block.parameters = block.parameters._replace(latency=float(late))
    parts, _ = remaining_parts(*LoopOf(theorem_scenario(N, law.name), external=OUTSIDE))
    inner = [one for one in parts if one.name != block.name]
    return symbolic_loop(connect([*inner, block, V], OUTSIDE, name="between"), jumps=True)


def changed(rows: dict[str, Any]) -> str:
    """Return the names of the rows that are not zero for all symbols."""
    wrong = [name for name, rest in rows.items() if not all(map(vanishes, np.ravel(rest)))]
    return f"{', '.join(wrong)} differs" if wrong else ""


class AtAFix:
    """A law's states on symbols right before an exact fix, x - z = eta m, and right after."""

    def __init__(self, law: Law, N: int, late: bool):
        self.late, self.N, self.loop = late, N, loop_of(law, N, late)
        s, p = self.loop.states, self.loop.parameters
        self.theta, self.r = p["true_flow"].theta, p["adaptation"].noise
        self.m = s["m_sent"] if late else s["m"]  # of the fix that arrives
        self.x = s["z"] + self.eta(s) @ s["m"]  # the true position now
        P = sympy.Matrix(N, N, lambda j, k: s["P"][min(j, k), max(j, k)])
        before = {"P": P, "information": P.adjugate() / P.det()}
        if late:
            before["sent"] = s["z_sent"] + self.eta(s) @ self.m
        self.known: dict[Any, Any] = {p["lyapunov"].noise: self.r}
        self.known |= equated(self.loop.inputs, {"fix": self.x}) | equated(s, before)
        self.before = {port: self.put(symbols) for port, symbols in s.items()}

    def put(self, values: Any) -> np.ndarray:
        """Return expressions right before the fix, every choice decided."""
        return np.vectorize(lambda e: decided(e.xreplace(self.known)), otypes=[object])(values)

    def jump(self, interval: int, taken: int = 1) -> States:
        """Return the states after the jump with which an interval begins."""
        self.known[self.loop.parameters["adaptation"].interval] = sympy.Integer(interval)
        self.known |= equated(self.loop.inputs, {"taken": taken})
        if self.late:
            self.known |= equated(self.loop.states, {"waiting": taken})
        (new,) = self.loop.jumps.values()
        return {
            port: self.put([new.get(s, s) for s in symbols.flat]).reshape(symbols.shape)
            for port, symbols in self.loop.states.items()
        }

    def eta(self, states: States) -> np.ndarray:
        """Return theta + alpha, shape (2, N)."""
        return self.theta + states["alpha"]

    def V(self, states: States) -> sympy.Expr:
        """Return V = r^2 tr(eta P^-1 eta^T)/2 of the states, as its block has it."""
        known = equated(self.loop.states, {port: states[port] for port in ("alpha", "information")})
        return self.loop.signals["V"][0].xreplace({**self.known, **known})

    def stays(self) -> str:
        """Return what changes between fixes where phi(x) = phi(z), or nothing."""
        loop, s = self.loop, self.loop.states
        same = dict(zip(loop.inputs["phi_x"], loop.inputs["phi_z"], strict=True))
        apart = s["x"] - s["z"] - self.eta(s) @ s["m"]
        read = ("alpha", "z", "information")
        return changed(
            {
                "x - z - eta m": [loop.derivative(e).subs(same) for e in apart],
                "V": rate_of_V(loop),
                **{f"{port} read": loop.signals[port] - s[port] for port in read},
                **{port: loop.rates[port] for port in s if port not in MOVING},
            }
        )

    def learns(self) -> str:
        """Return which of these fails: V falls as claimed, P stays the inverse, x - z = eta m."""
        before, after = self.before, self.jump(ARRIVE)
        y, gained = self.eta(before) @ self.m, np.outer(self.m, self.m) / self.r**2
        d = self.r**2 + self.m @ before["P"] @ self.m
        x = self.x + y if self.late else self.x  # z had gone on from where the fix was sent
        return changed(
            {
                "V": self.V(after) - self.V(before) + self.r**2 * sum(y**2) / (2 * d),
                "P": after["P"] @ after["information"] - np.eye(len(self.m), dtype=int),
                "P^-1": after["information"] - before["information"] - gained,
                "x - z - eta m": x - after["z"] - self.eta(after) @ after["m"],
                "the fix under way": after["waiting"],
            }
        )

    def moved(self, after: States, *ports: str) -> States:
        """Return by how much the states of these ports change."""
        return {port: after[port] - self.before[port] for port in ports}

    def sends(self) -> str:
        """Return what a fix on its way changes beside m, or what it stores wrongly."""
        if not self.late:
            return ""
        after = self.jump(SEND)
        apart = after["sent"] - after["z_sent"] - self.eta(after) @ after["m_sent"]
        still = self.moved(after, "alpha", "P", "information", "z")
        under_way = {"waiting": after["waiting"] - 1, "m": after["m"]}
        return changed({"x - z - eta m": apart, **under_way, **still})

    def misses(self) -> str:
        """Return what a fix that is missing changes, or nothing."""
        ends = [self.jump(one, taken=0) for one in ((SEND, ARRIVE) if self.late else (ARRIVE,))]
        moved = [self.moved(one, "alpha", "P", "information", "z", "m") for one in ends]
        return ", ".join(filter(None, map(changed, moved)))


def _running(law: Law, N: int, points: int) -> tuple[bool, str]:
    """Compare the fall of V with the blocks that run."""
    random, worst = np.random.default_rng(0), 0.0
    block, candidate = law_and_V(law, N)
    p = block.parameters._replace(interval=float(ARRIVE))
    ends = np.cumsum(list(block.state_ports.values()))[:-1]
    for _ in range(points):
        x: States = {one: random.standard_normal(size) for one, size in block.state_ports.items()}
        A = random.standard_normal((N, N))
        P = A @ A.T + np.eye(N)
        eta = candidate.parameters.theta + x["alpha"].reshape(2, N)
        x["P"], x["information"], y = P.ravel(), np.linalg.inv(P).ravel(), eta @ x["m"]
        u = np.array([*(x["z"] + y), 1.0, *random.standard_normal(N + 2)])
        state = np.concatenate(list(x.values()))
        new = np.split(block.values("jump", block.nstates, 0.0, state, u, p), ends)
        V = [
            candidate.output(0.0, [], np.concatenate([s["alpha"], s["information"]]))[0]
            for s in (x, dict(zip(x, new, strict=True)))
        ]
        fall = p.noise**2 * np.sum(y**2) / (2 * (p.noise**2 + x["m"] @ P @ x["m"]))
        worst = max(worst, abs(V[1] - V[0] + fall) / V[0])
    return worst < 1e-9, f"{points} points, largest difference {worst:.0e} of V"


def fix_steps(law: Law, points: int) -> list[Step]:
    """Check a law that learns at fixes, for N = 1, 2."""
    cases = [AtAFix(law, N, late) for N in SIZES for late in (False, True)]
    claims = {
        "between fixes V' = 0, P' = 0 and (x - z - eta m)' = 0 where phi(x) = phi(z), "
        "whatever v is flown": AtAFix.stays,
        "at an exact fix V falls by r^2 |eta m|^2/(2 (r^2 + m^T P m)), P^-1 rises by m m^T/r^2 "
        "and x - z = eta m, also where it arrives late": AtAFix.learns,
        "a fix on its way changes nothing yet": AtAFix.sends,
        "a missing fix changes nothing": AtAFix.misses,
    }
    steps = [exact_step(cases, claim, check) for claim, check in claims.items()]
    claim = "the running blocks let V fall alike"
    return [*steps, checked(claim, lambda: _running(law, 2, points), "sampled", False)]
