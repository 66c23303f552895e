"""Prove what a law keeps that learns at fixes: between them and at each, on the running equations.

    (x - z - eta m)' = 0, V' = 0              between fixes, where phi(x) = phi(z)
    V_after - V = -r^2 |eta m|^2/(2 d)        at an exact fix, d = r^2 + m^T P m
    x - z = eta m                             still, and P is the inverse of P^-1 + m m^T/r^2
    nothing changes                           where a fix is missing

So V never rises, P^-1 never falls, and |eta_k| <= (2 V(0) P_kk)^(1/2)/r.  A fix that arrives late
is shown alike, with what was integrated in between.  Not shown: phi(x) = phi(z), which holds the
better the nearer the prediction is.
"""

from operator import ge, gt, le, lt
from typing import Any

import numpy as np
import sympy

from ...blocks.laws.law import Law
from ...diagrams.interconnection import connect
from ...equations.block import Block
from ...equations.elements import Index
from ...equations.record import Shape
from ...equations.symbolic import expressions
from ...simulation.loops import paper_blocks
from .proof import Step, checked
from .symbolic_loop import symbolic_loop
from .theorem_loop import law_and_V, theorem_scenario
from .vanishing import vanishes

SIZES = (1, 2)  # numbers of functions; 3 takes half a minute, in a slow test
SEND, ARRIVE = 1, 2  # intervals that begin with a fix, and with its arrival
OUTSIDE: dict[str, tuple[str, ...]] = {  # blocks that are left out, and what they make
    "basis_x": ("phi_x",),
    "basis_z": ("phi_z",),
    "vehicle_controller": ("v_x",),
    "fixes": ("fix", "taken"),
}
MOVING = ("x", "z", "m")  # states that change between fixes
r, latency = sympy.symbols("r latency", positive=True)
States = dict[str, np.ndarray]


def read(block: Block, role: str, x: States, u: States, p: dict[str, Any]) -> np.ndarray:
    """Return what a block computes of expressions, every choice decided."""

    def leaf(at: tuple[str, str], shape: Shape, index: Index) -> Any:
        group, name = at
        if group == "t" or (group == "p" and name not in p):  # what is not used
            return sympy.Symbol("_".join(map(str, (group, name, *index))))
        given = {"x": x, "u": u, "p": p}[group][name]
        return np.asarray(given, dtype=object).reshape(shape)[index]

    return np.array([_decided(e) for e in expressions(block, role, leaf)], dtype=object)


def _decided(expression: sympy.Expr) -> sympy.Expr:
    """Return an expression where comparisons and remainders of what is known are carried out."""
    known: dict[str, Any] = {
        "mod": lambda a, b: a % b,
        **{
            name: lambda a, b, ask=ask: sympy.Integer(bool(ask(a, b)))
            for name, ask in {"gt": gt, "ge": ge, "lt": lt, "le": le}.items()
        },
        "and_": lambda a, b: a * b,
        "or_": lambda a, b: a + b - a * b,
        "not_": lambda a: 1 - a,
        "where": lambda condition, a, b: a if condition == 1 else b,
    }
    return expression.replace(
        lambda e: e.func.__name__ in known, lambda e: known[e.func.__name__](*e.args)
    )


def is_zero(expressions: Any) -> bool:
    """Return whether every expression is zero for all symbols."""
    return all(vanishes(e) for e in np.ravel(expressions))


class AtAFix:
    """A law's states on symbols right before an exact fix, x - z = eta m, and right after."""

    def __init__(self, law: Law, N: int, late: bool, taken: int = 1):
        self.N, self.late = N, late
        self.block, self.candidate = law_and_V(law, N)
        self.before: States = {
            port: np.array(sympy.symbols(f"{port}_1:{size + 1}", real=True), dtype=object)
            for port, size in self.block.state_ports.items()
        }
        P = sympy.Matrix(N, N, lambda j, k: sympy.Symbol(f"P_{min(j, k)}{max(j, k)}", real=True))
        self.before["P"] = np.array(P, dtype=object).ravel()
        self.before["information"] = np.array(P.adjugate() / P.det(), dtype=object).ravel()
        theta = sympy.symbols(f"theta_1:{2 * N + 1}", real=True)
        self.theta = np.array(theta, dtype=object).reshape(2, N)
        since, eta = self.before["m"], self.eta(self.before)
        self.x = self.before["z"] + eta @ since  # the true position now
        self.m = self.before["m_sent"] if late else since  # of the fix that arrives
        if late:
            self.before["sent"] = self.before["z_sent"] + eta @ self.m
            self.before["waiting"] = np.array([sympy.Integer(taken)])
        fix, more = self.x, sympy.symbols(f"u_1:{N + 3}", real=True)
        self.u = np.array([*fix, sympy.Integer(taken), *more], dtype=object)

    def jump(self, interval: int) -> States:
        """Return the states after the jump with which an interval begins."""
        p = {"noise": r, "latency": latency if self.late else 0, "interval": interval}
        u = _by_port(self.block.input_ports, self.u)
        return _by_port(self.block.state_ports, read(self.block, "jump", self.before, u, p))

    def eta(self, states: States) -> np.ndarray:
        """Return theta + alpha, shape (2, N)."""
        return self.theta + states["alpha"].reshape(2, self.N)

    def V(self, states: States) -> sympy.Expr:
        """Return V of the states."""
        return read(self.candidate, "output", {}, states, {"noise": r, "theta": self.theta})[0]

    def apart(self, states: States) -> np.ndarray:
        """Return x - z - eta m, shape (2,)."""
        more = self.eta(self.before) @ self.m if self.late else 0
        return self.x + more - states["z"] - self.eta(states) @ states["m"]

    def learns(self) -> tuple[bool, str]:
        """Return whether V falls as claimed, P stays the inverse and x - z = eta m."""
        before, after, n = self.before, self.jump(ARRIVE), self.N
        P = before["P"].reshape(n, n)
        d = r**2 + self.m @ P @ self.m
        y = self.eta(before) @ self.m
        rows = {
            "V": self.V(after) - self.V(before) + r**2 * sum(y**2) / (2 * d),
            "P": after["P"].reshape(n, n) @ after["information"].reshape(n, n)
            - np.eye(n, dtype=int),
            "P^-1": after["information"]
            - before["information"]
            - np.outer(self.m, self.m).ravel() / r**2,
            "x - z - eta m": self.apart(after),
            "the fix under way": after["waiting"],
        }
        wrong = [name for name, rest in rows.items() if not is_zero(rest)]
        return not wrong, f"{', '.join(wrong)} differs, N = {n}" if wrong else ""

    def same(self, after: States, *ports: str) -> bool:
        """Return whether the states of these ports are as before."""
        return all(is_zero(after[port] - self.before[port]) for port in ports)

    def sends(self) -> bool:
        """Return whether a fix on its way changes nothing but m, and keeps what it is of."""
        after = self.jump(SEND)
        kept = self.same(after, "alpha", "P", "information", "z")
        apart = after["sent"] - after["z_sent"] - self.eta(after) @ after["m_sent"]
        return kept and is_zero([*apart, *after["m"], *(after["waiting"] - 1)])


def _by_port(ports: dict[str, int], values: np.ndarray) -> States:
    ends = np.cumsum(list(ports.values()))[:-1]
    return dict(zip(ports, np.split(values, ends), strict=True))


def _between(law: Law, N: int) -> tuple[bool, str]:
    """Check that x - z - eta m, V and P keep their values between fixes where phi(x) = phi(z)."""
    blocks = paper_blocks(theorem_scenario(N, law.name))
    block, V = law_and_V(law, N)
    inner = [b for b in blocks if b.name not in (*OUTSIDE, "reference", block.name)]
    external = [port for name, ports in OUTSIDE.items() for port in ports]
    loop = symbolic_loop(connect([*inner, block, V], external, name="between"), jumps=True)
    own = {port.rpartition(":")[2]: symbols for port, symbols in loop.states.items()}
    eta = loop.parameters["true_flow"].theta + own["alpha"]
    apart = own["x"] - own["z"] - eta @ own["m"]
    same = dict(zip(loop.inputs["phi_x"], loop.inputs["phi_z"], strict=True))
    rates = {
        "x - z - eta m": [loop.derivative(e).subs(same) for e in apart],
        "V": [loop.derivative(loop.signals["V"][0])],
        **{
            f"{port} read": loop.signals[port] - own[port] for port in ("alpha", "z", "information")
        },
        **{port: [loop.motion[s] for s in own[port].flat] for port in own if port not in MOVING},
    }
    wrong = [name for name, rate in rates.items() if not is_zero(rate)]
    return not wrong, f"{', '.join(wrong)} changes, N = {N}" if wrong else ""


def _running(law: Law, N: int, points: int) -> tuple[bool, str]:
    """Compare the fall of V with the blocks that run."""
    random, worst = np.random.default_rng(0), 0.0
    block, candidate = law_and_V(law, N)
    p = block.parameters._replace(interval=float(ARRIVE))
    names = list(block.state_ports)
    for _ in range(points):
        x: States = {own: random.standard_normal(size) for own, size in block.state_ports.items()}
        A = random.standard_normal((N, N))
        P = A @ A.T + np.eye(N)
        eta = candidate.parameters.theta + x["alpha"].reshape(2, N)
        x["P"], x["information"], y = P.ravel(), np.linalg.inv(P).ravel(), eta @ x["m"]
        u = np.array([*(x["z"] + y), 1.0, *random.standard_normal(N + 2)])
        state = np.concatenate([x[port] for port in names])
        after = _by_port(block.state_ports, block.values("jump", block.nstates, 0.0, state, u, p))
        V = [
            candidate.output(0.0, [], np.concatenate([s[port] for port in candidate.input_ports]))[
                0
            ]
            for s in (x, after)
        ]
        fall = p.noise**2 * np.sum(y**2) / (2 * (p.noise**2 + x["m"] @ P @ x["m"]))
        worst = max(worst, abs(V[1] - V[0] + fall) / V[0])
    return worst < 1e-9, f"{points} points, largest difference {worst:.0e} of V"


def fix_steps(law: Law, points: int) -> list[Step]:
    """Check a law that learns at fixes, for N = 1, 2."""

    def both(check: Any) -> Any:
        def all_sizes() -> tuple[bool, str]:
            found = [check(N, late) for N in SIZES for late in (False, True)]
            wrong = [detail for truth, detail in found if not truth]
            return not wrong, wrong[0] if wrong else ""

        return all_sizes

    def missing(N: int, late: bool) -> tuple[bool, str]:
        case = AtAFix(law, N, late, taken=0)
        kept = case.same(case.jump(ARRIVE), "alpha", "P", "information", "z", "m")
        if late:
            kept = kept and case.same(case.jump(SEND), "alpha", "P", "information", "z", "m")
        return kept, "" if kept else f"something changes, N = {N}"

    def sends(N: int, late: bool) -> tuple[bool, str]:
        kept = not late or AtAFix(law, N, late).sends()
        return kept, "" if kept else f"something changes, N = {N}"

    return [
        checked(
            "between fixes V' = 0, P' = 0 and (x - z - eta m)' = 0 where phi(x) = phi(z), "
            "whatever v is flown",
            "exact",
            both(lambda N, late: _between(law, N) if not late else (True, "")),
            False,
        ),
        checked(
            "at an exact fix V falls by r^2 |eta m|^2/(2 (r^2 + m^T P m)), P^-1 rises by m m^T/r^2 "
            "and x - z = eta m, also where it arrives late",
            "exact",
            both(lambda N, late: AtAFix(law, N, late).learns()),
            False,
        ),
        checked("a fix on its way changes nothing yet", "exact", both(sends), False),
        checked("a missing fix changes nothing", "exact", both(missing), False),
        checked(
            "the running blocks let V fall alike",
            "sampled",
            lambda: _running(law, 2, points),
            False,
        ),
    ]
