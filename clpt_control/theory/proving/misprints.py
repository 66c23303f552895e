"""The paper's misprints, each with a check that tells print from correction.

A check takes `printed` and returns whether that form agrees with the blocks that run, for N = 2:
it is false for the printed form and true for the corrected one.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import numpy as np
import sympy

from ...blocks import basis
from ...equations.symbolic import expressions
from ...simulation.loops import error_loop
from .symbolic_loop import symbolic_loop
from .theorem_loop import theorem_loop, theorem_scenario

Check = Callable[[bool], bool]


@dataclass(frozen=True)
class Misprint:
    """One misprint."""

    equation: str  # where it stands in the paper
    printed: str
    corrected: str
    check: str  # what tells them apart
    holds: Check  # holds(printed): whether the check passes on that form

    @property
    def confirmed(self) -> bool:
        """Whether the check fails on the print, passes corrected."""
        try:
            return not self.holds(True) and self.holds(False)
        except Exception:  # equations so changed that the check cannot run
            return False


MISPRINTS: list[Misprint] = []


def misprints() -> tuple[Misprint, ...]:
    """Return the paper's misprints with their checks.

    Returns
    -------
    tuple of Misprint
        Each with `equation`, `printed`, `corrected`, `check` and `confirmed`, whether the check
        fails on the print and passes on the correction.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> found = clpt.theory.misprints()[0]
    >>> found.equation, found.holds(True), found.holds(False)
    ('(18)', False, True)
    """
    for read in (_without_injection, _error_dynamics):
        read.cache_clear()  # the blocks may have been changed
    return tuple(MISPRINTS)


def misprint(equation: str, printed: str, corrected: str, check: str) -> Callable[[Check], Check]:
    """Return what lists a check as a misprint."""

    def listed(holds: Check) -> Check:
        MISPRINTS.append(Misprint(equation, printed, corrected, check, holds))
        return holds

    return listed


class PaperLoop:
    """The paper's symbols of the closed loop, as arrays of SymPy's expressions."""

    def __init__(self, law: str, disturbed: bool = False, opaque: tuple[str, ...] = ()):
        self.loop = loop = symbolic_loop(theorem_loop(2, law, disturbed), opaque)
        controller = loop.parameters["vehicle_controller"]
        self.KD, self.GammaD, self.alpha_M = controller.KD, controller.GammaD, controller.alpha_M
        self.theta = loop.parameters["true_flow"].theta
        self.gamma = loop.parameters["adaptation"].gain
        self.x, self.z, self.K, self.Gamma = (loop.states[s] for s in ("x", "z", "K", "Gamma"))
        self.phi, self.phi_z, self.zc = (loop.inputs[u] for u in ("phi_x", "phi_z", "zc"))
        self.delta = loop.inputs.get("delta", sympy.Integer(0))
        self.e, self.psi, self.V = loop.signals["e"], loop.signals["psi"], loop.signals["V"][0]
        self.alpha = loop.signals["alpha"]
        self.free: dict[str, np.ndarray] = {  # rates of what adapts, before a law is chosen
            port: np.vectorize(lambda s: sympy.Symbol(f"{s}'", real=True))(loop.states[port])
            for port in ("alpha", "K", "Gamma")
            if port in loop.states
        }

    def free_rate(self) -> sympy.Expr:
        """Return V' with free rates of alpha, K and Gamma."""
        return replace(self.loop, rates=self.loop.rates | self.free).derivative(self.V)

    def gain_terms(self, before_K: sympy.Expr) -> sympy.Expr:
        """Return (K - KD)^T (before K' + z e) + (GammaD - Gamma)^T (zc e - Gamma'/gamma)."""
        K, Gamma = self.free["K"], self.free["Gamma"]
        feedback = (self.K - self.KD) @ (before_K * K + self.z * self.e)
        return feedback + (self.GammaD - self.Gamma) @ (self.zc * self.e - Gamma / self.gamma)

    def left_of_injection(self) -> np.ndarray:
        """Return -(alpha_M + alpha) phi(x) - (alpha_M - alpha) phi(z), as in Eq. (19)."""
        return -(self.alpha_M + self.alpha) @ self.phi - (self.alpha_M - self.alpha) @ self.phi_z

    def error_rate(self, before_eta_3: np.ndarray) -> np.ndarray:
        """Return e' of Eq. (27), -KD e + [phi_1, phi_2, ..., zc]^T eta."""
        flow = (self.theta + self.alpha) @ self.phi - self.KD * self.e
        return flow + before_eta_3 * (self.K - self.KD) + self.zc * (self.GammaD - self.Gamma)

    def rate_of_e(self) -> np.ndarray:
        """Return e' as the blocks have it."""
        return np.array([self.loop.derivative(e) for e in self.e])


@cache
def _without_injection(law: str, disturbed: bool = False) -> PaperLoop:
    return PaperLoop(law, disturbed, ("injection",))


@cache
def _error_dynamics() -> tuple[sympy.Matrix, sympy.Matrix, sympy.Matrix, sympy.Symbol]:
    """Return A of Eq. (28), in the order e, eta, the joint regressor W (8, 2), KD and gamma."""
    loop = symbolic_loop(error_loop(theorem_scenario(2, "learned-flow")))
    X, rates = sympy.Matrix([*loop.motion]), sympy.Matrix([*loop.motion.values()])
    A = rates.jacobian(X)
    if sympy.expand(rates - A * X) != sympy.zeros(*X.shape):
        raise ValueError("Eq. (28) is not linear in (e, eta)")
    KD = sympy.diag(*loop.parameters["error_system"].KD)
    return A, A[:2, 2:].T, KD, loop.parameters["parameter_system"].gain


def _zero(values: Any) -> bool:
    return all(sympy.expand(value) == 0 for value in np.ravel(values))


@misprint(
    "(18)",
    "(K - KD)^T (K' + z e)",
    "(K - KD)^T (K'/gamma + z e)",
    "V' of (17) along the loop, K' and Gamma' left free",
)
def equation_18(printed: bool) -> bool:
    """Check V' of Eq. (18)."""
    o = _without_injection("known-flow")
    form = o.gain_terms(sympy.Integer(1) if printed else 1 / o.gamma)
    form += o.e @ (-o.KD * o.e + (o.theta - o.alpha_M) @ o.phi - o.psi)
    return _zero(o.free_rate() - form)


def _learned(o: PaperLoop, before_K: Any, before_alpha: Any, rest: np.ndarray) -> bool:
    """Compare V' with e^T (-KD e + Delta - psi + rest) + the law's brackets."""
    form = o.gain_terms(before_K) + o.e @ (-o.KD * o.e + o.delta - o.psi + rest)
    bracket = before_alpha * o.free["alpha"] + np.outer(o.e, o.phi)
    return _zero(o.free_rate() - form - np.sum((o.theta + o.alpha) * bracket))


@misprint(
    "(25)",
    "K' + z e, and (theta + alpha) alpha'",
    "K'/gamma + z e, and (theta + alpha) alpha'/gamma",
    "V' of (24) along the loop, the law left free",
)
def equation_25_gains(printed: bool) -> bool:
    """Check the factors 1/gamma of Eq. (25)."""
    o = _without_injection("learned-flow")
    inverse = sympy.Integer(1) if printed else 1 / o.gamma
    return _learned(o, inverse, inverse, o.left_of_injection())


@misprint(
    "(25)",
    "-2 e^T alpha_M phi",
    "-e^T [(alpha_M + alpha) phi(x) + (alpha_M - alpha) phi(z)]",
    "V' of (24) along the loop, the injection left free",
)
def equation_25_flow(printed: bool) -> bool:
    """Check the flow terms of Eq. (25)."""
    o = _without_injection("learned-flow")
    rest = -2 * o.alpha_M @ o.phi if printed else o.left_of_injection()
    return _learned(o, 1 / o.gamma, 1 / o.gamma, rest)


@misprint(
    "V'' after (26)",
    "... - Psi - 2 alpha_M phi",
    "... - Psi - (alpha_M + alpha) phi(x) - (alpha_M - alpha) phi(z)",
    "e' of the loop, the injection left free",
)
def second_derivative(printed: bool) -> bool:
    """Check e' as V'' after Eq. (26) has it."""
    o = _without_injection("learned-flow")
    rest = -2 * o.alpha_M @ o.phi if printed else o.left_of_injection()
    return _zero(o.rate_of_e() - (o.error_rate(o.z) - o.psi + rest))


@misprint(
    "(34)",
    "(K - KD)^T (K' + z e)",
    "(K - KD)^T (K'/gamma + z e)",
    "V' of (24) along the loop with Delta, the law left free",
)
def equation_34(printed: bool) -> bool:
    """Check the factor 1/gamma of Eq. (34)."""
    o = _without_injection("learned-flow", True)
    before = sympy.Integer(1) if printed else 1 / o.gamma
    return _learned(o, before, 1 / o.gamma, o.left_of_injection())


@misprint("(27)", "x eta_3", "z eta_3, as in (28) and (31)", "e' of the loop")
def equation_27(printed: bool) -> bool:
    """Check e' of Eq. (27)."""
    o = PaperLoop("learned-flow")
    return _zero(o.rate_of_e() - o.error_rate(o.x if printed else o.z))


@misprint(
    "(28), lower rows of A",
    "-gamma phi_1, -gamma phi_2, -gamma z, -gamma zc",
    "-gamma phi_1^T, -gamma phi_2^T, -gamma z^T, -gamma zc^T",
    "A of the error and parameter blocks, N = 2",
)
def equation_28_rows(printed: bool) -> bool:
    """Check the lower rows of A, Eq. (28)."""
    A, W, _, gamma = _error_dynamics()
    blocks = [W[j : j + 2, :] for j in range(0, 8, 2)]
    rows = [block.T if printed else block for block in blocks]
    return A[2:, :2] == -gamma * sympy.Matrix.vstack(*rows)


@misprint(
    "(28), P",
    "blocks K_D^{-1}/2 and K_D^{-1}/(2 gamma)",
    "diag(I, I/gamma)/2",
    "A^T P + P A has no blocks but e e, for KD not a multiple of I (and the printed "
    "blocks fit N = 2 alone)",
)
def equation_28_P(printed: bool) -> bool:
    """Check P of Eq. (28)."""
    A, _, KD, gamma = _error_dynamics()
    P = sympy.diag(sympy.eye(2) / 2, sympy.eye(8) / (2 * gamma))
    if printed:
        P = sympy.diag(KD.inv() / 2, *[KD.inv() / (2 * gamma)] * 4)
    Q = sympy.expand(A.T * P + P * A)
    return Q[:2, 2:] == sympy.zeros(2, 8) and Q[2:, 2:] == sympy.zeros(8, 8)


@misprint(
    "L before (30)",
    "L = [KD; gamma W], which removes -KD",
    "L = [0; gamma W]",
    "the first block of A + L C is -KD, as (31) has it",
)
def output_injection(printed: bool) -> bool:
    """Check L before Eq. (30), C = [I, 0]."""
    A, W, KD, gamma = _error_dynamics()
    L = (KD if printed else sympy.zeros(2, 2)).col_join(gamma * W)
    C = sympy.eye(2).row_join(sympy.zeros(2, 8))
    return sympy.expand((A + L * C)[:2, :2] + KD) == sympy.zeros(2, 2)


@misprint(
    "(12)-(16), Assumption 3.3",
    "theta where theta_hat is meant",
    "theta_hat in (13), theta - theta_hat in (16)",
    "V' of (17) along the traced known-flow loop",
)
def hats(printed: bool) -> bool:
    """Check which theta Eqs. (12)-(16) mean."""
    o = PaperLoop("known-flow")
    known = o.theta if printed else o.loop.parameters["injection"].theta_hat
    return _zero(o.loop.derivative(o.V) - o.e @ ((o.theta - known) @ o.phi - o.KD * o.e))


@misprint(
    "(5)",
    "exp of -|x - c|/(2 sigma), called Gaussian",
    "exp(-|x - c|^2/(2 sigma^2)) is Gaussian; the printed exponent is ambiguous",
    "log phi is quadratic in the distance",
)
def gaussian(printed: bool) -> bool:
    """Check whether log phi of Eq. (5) is quadratic in distance."""
    d, width = sympy.symbols("d sigma", positive=True)
    kernel, one = "exponential" if printed else "gaussian", (np.zeros((1, 2)), np.ones(1))
    block = basis.flow_basis("basis_x", "x", kernel, *one, np.zeros(1), np.zeros(1))
    known = {("u", "x", (0,)): d, ("p", "widths", (0,)): width}  # all else is zero
    phi = expressions(block, "output", lambda at, shape, k: known.get((*at, k), 0))[0]
    bend = sympy.simplify(sympy.diff(sympy.expand_log(sympy.log(phi), force=True), d, 2))
    return bend != 0 and not bend.has(d)


@misprint(
    "figures 3 and 4",
    "parameters converge to the true values",
    "alpha converges to -theta; -alpha is plotted",
    "V of (24) has its minimum there",
)
def converges_to(printed: bool) -> bool:
    """Check where V of Eq. (24) has its minimum."""
    o = PaperLoop("learned-flow")
    place = dict(zip(np.ravel(o.alpha), np.ravel(o.theta if printed else -o.theta), strict=True))
    return _zero([sympy.diff(o.V, a).subs(place, simultaneous=True) for a in place])


@misprint(
    "proof of 3.2",
    "z is bounded because (8) is linear with sinusoidal inputs",
    "z = x - e, with x bounded by (9) and e by V",
    "dz'/dz of the loop is free of adapting gains; z = x - e",
)
def bounded_z(printed: bool) -> bool:
    """Check the argument for bounded z, proof of Theorem 3.2."""
    o = PaperLoop("learned-flow")
    if not printed:
        return _zero(o.z - (o.x - o.e))
    adapting = {s for port in ("alpha", "K", "Gamma") for s in o.loop.states[port].flat}
    slopes = [sympy.diff(o.loop.rates["z"][i], o.z[i]) for i in range(2)]
    return not any(slope.free_symbols & adapting for slope in slopes)
