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

from ...blocks import flow
from ...equations.symbolic import expressions
from ...simulation.loops import error_loop
from .lemmas import errors, wanted_rates
from .proof import checked
from .signs import vanishes
from .symbolic_loop import SymbolicLoop, symbolic_loop
from .theorem_loop import rate_of_V, theorem_loop, theorem_scenario

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
        return checked("", lambda: not self.holds(True) and self.holds(False)).holds


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
    for read in (any_gains, paper_loop, _error_dynamics):
        read.cache_clear()  # the blocks may have been changed
    return tuple(MISPRINTS)


def misprint(equation: str, printed: str, corrected: str, check: str) -> Callable[[Check], Check]:
    """Return a decorator that adds a check to the misprints."""

    def add(holds: Check) -> Check:
        MISPRINTS.append(Misprint(equation, printed, corrected, check, holds))
        return holds

    return add


@cache
def any_gains(law: str, disturbed: bool = False) -> SymbolicLoop:
    """Return a loop with any injection, before a law is chosen: what adapts has any rate."""
    loop = symbolic_loop(theorem_loop(2, law, disturbed), ("injection",))
    free = {
        port: np.vectorize(lambda s: sympy.Symbol(f"{s}'", real=True))(loop.states[port])
        for port in ("alpha", "K", "Gamma")
        if port in loop.states
    }
    return replace(loop, rates=loop.rates | free)


@cache
def paper_loop(law: str) -> SymbolicLoop:
    """Return the closed loop of a law of the paper."""
    return symbolic_loop(theorem_loop(2, law))


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
    return all(map(vanishes, np.ravel(values)))


def brackets(loop: SymbolicLoop, before_K: Any, before_alpha: Any, flow: Any) -> sympy.Expr:
    """Return e^T (flow - KD e - psi) + the errors, each times what a law makes zero."""
    error, s, rates, phi = errors(loop), loop.states, loop.rates, loop.inputs["phi_x"]
    e, gamma, zc = error["e"], loop.parameters["adaptation"].gain, loop.inputs["zc"]
    form = e @ (flow - loop.parameters["vehicle_controller"].KD * e - loop.signals["psi"])
    form += error["eta_3"] @ (before_K * rates["K"] + s["z"] * e)
    form += error["eta_4"] @ (zc * e - rates["Gamma"] / gamma)
    if "eta" in error:
        form += np.sum(error["eta"] * (before_alpha * rates["alpha"] + np.outer(e, phi)))
    return form


def left_of_injection(loop: SymbolicLoop, printed: bool = False) -> np.ndarray:
    """Return -(alpha_M + alpha) phi(x) - (alpha_M - alpha) phi(z), Eq. (19), or as (25) has it."""
    alpha_M, alpha = loop.parameters["vehicle_controller"].alpha_M, loop.states["alpha"]
    phi, phi_z = loop.inputs["phi_x"], loop.inputs["phi_z"]
    return -2 * alpha_M @ phi if printed else -(alpha_M + alpha) @ phi - (alpha_M - alpha) @ phi_z


@misprint(
    "(18)",
    "(K - KD)^T (K' + z e)",
    "(K - KD)^T (K'/gamma + z e)",
    "V' of (17) along the loop, K' and Gamma' left free",
)
def equation_18(printed: bool) -> bool:
    """Check V' of Eq. (18)."""
    loop = any_gains("known-flow")
    p, gamma = loop.parameters, loop.parameters["adaptation"].gain
    flow = (p["true_flow"].theta - p["vehicle_controller"].alpha_M) @ loop.inputs["phi_x"]
    return _zero(rate_of_V(loop) - brackets(loop, 1 if printed else 1 / gamma, 0, flow))


def _equation_25(printed_K: bool, printed_alpha: bool, printed_flow: bool, disturbed: bool) -> bool:
    """Compare V' of the learned-flow law with Eq. (25) or (34), parts of it as printed."""
    loop = any_gains("learned-flow", disturbed)
    inverse = 1 / loop.parameters["adaptation"].gain
    flow = left_of_injection(loop, printed_flow) + loop.inputs.get("delta", 0)
    K, alpha = (1 if printed else inverse for printed in (printed_K, printed_alpha))
    return _zero(rate_of_V(loop) - brackets(loop, K, alpha, flow))


misprint(
    "(25)",
    "K' + z e, and (theta + alpha) alpha'",
    "K'/gamma + z e, and (theta + alpha) alpha'/gamma",
    "V' of (24) along the loop, the law left free",
)(lambda printed: _equation_25(printed, printed, False, disturbed=False))
misprint(
    "(25)",
    "-2 e^T alpha_M phi",
    "-e^T [(alpha_M + alpha) phi(x) + (alpha_M - alpha) phi(z)]",
    "V' of (24) along the loop, the injection left free",
)(lambda printed: _equation_25(False, False, printed, disturbed=False))


@misprint(
    "V'' after (26)",
    "... - Psi - 2 alpha_M phi",
    "... - Psi - (alpha_M + alpha) phi(x) - (alpha_M - alpha) phi(z)",
    "e' of the loop, the injection left free",
)
def second_derivative(printed: bool) -> bool:
    """Check e' as V'' after Eq. (26) has it."""
    loop = any_gains("learned-flow")
    beside = left_of_injection(loop, printed) - loop.signals["psi"]
    return _zero(_rate_of_e(loop) - wanted_rates(loop)["e"] - beside)


misprint(
    "(34)",
    "(K - KD)^T (K' + z e)",
    "(K - KD)^T (K'/gamma + z e)",
    "V' of (24) along the loop with Delta, the law left free",
)(lambda printed: _equation_25(printed, False, False, disturbed=True))


def _rate_of_e(loop: SymbolicLoop) -> np.ndarray:
    return np.array([loop.derivative(e) for e in loop.signals["e"]])


@misprint("(27)", "x eta_3", "z eta_3, as in (28) and (31)", "e' of the loop")
def equation_27(printed: bool) -> bool:
    """Check e' of Eq. (27)."""
    loop = paper_loop("learned-flow")
    return _zero(_rate_of_e(loop) - wanted_rates(loop, "x" if printed else "z")["e"])


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
    loop = paper_loop("known-flow")
    p, e = loop.parameters, loop.signals["e"]
    known = p["true_flow"].theta if printed else p["injection"].theta_hat
    missed = (p["true_flow"].theta - known) @ loop.inputs["phi_x"]
    return _zero(rate_of_V(loop) - e @ (missed - p["vehicle_controller"].KD * e))


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
    block = flow.flow_basis("basis_x", "x", kernel, *one, np.zeros(1), np.zeros(1))
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
    loop = paper_loop("learned-flow")
    alpha, theta = (np.ravel(a) for a in (loop.states["alpha"], loop.parameters["true_flow"].theta))
    place = dict(zip(alpha, theta if printed else -theta, strict=True))
    return _zero([sympy.diff(loop.signals["V"][0], a).xreplace(place) for a in place])


@misprint(
    "proof of 3.2",
    "z is bounded because (8) is linear with sinusoidal inputs",
    "z = x - e, with x bounded by (9) and e by V",
    "dz'/dz of the loop is free of adapting gains; z = x - e",
)
def bounded_z(printed: bool) -> bool:
    """Check the argument for bounded z, proof of Theorem 3.2."""
    loop = paper_loop("learned-flow")
    s = loop.states
    if not printed:
        return _zero(s["z"] - (s["x"] - loop.signals["e"]))
    adapting = {symbol for port in ("alpha", "K", "Gamma") for symbol in s[port].flat}
    slopes = (sympy.diff(rate, z) for rate, z in zip(loop.rates["z"], s["z"], strict=True))
    return not any(slope.free_symbols & adapting for slope in slopes)
