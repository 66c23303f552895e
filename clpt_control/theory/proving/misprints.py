"""The paper's misprints, each with a check that tells print from correction.

Its residual is what the printed form, or the corrected one, leaves of the blocks that run, for
N = 2: it is zero for the corrected form alone.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import numpy as np
import sympy

from ...blocks import flow
from ...blocks.laws.law import LEARNED
from ...engine.record.symbolic import Symbols
from ...simulation.loops import error_loop
from .exact import vanishes
from .proof import checked
from .symbolic_loop import SymbolicLoop, symbolic_loop
from .theorem_loop import (
    decay,
    decay_and_known_error,
    rate_of_V,
    theorem_loop,
    theorem_scenario,
)


@dataclass(frozen=True)
class Misprint:
    """One misprint."""

    equation: str  # where it stands in the paper
    printed: str
    corrected: str
    check: str  # what tells them apart
    # of the printed form or the corrected one; zero where it fits
    residual: Callable[[bool], Any]

    def holds(self, printed: bool) -> bool:
        """Return whether the check passes on the printed form, or the corrected one."""
        return all(
            map(vanishes, np.ravel(np.array(self.residual(printed), dtype=object)))
        )

    @property
    def confirmed(self) -> bool:
        """Whether the check fails on the print, passes corrected."""
        return checked("", lambda: not self.holds(True) and self.holds(False)).holds


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
    for read in (any_gains, paper_loop, error_dynamics):
        read.cache_clear()  # the blocks may have been changed
    return MISPRINTS


def errors(loop: SymbolicLoop) -> dict[str, Any]:
    """Return e and eta: theta + alpha, K - KD and GammaD - Gamma."""
    p, s, car = loop.parameters, loop.states, loop.parameters["vehicle_controller"]
    first = {
        "e": s["x"] - s["z"],
        "eta_3": s["K"] - car.KD,
        "eta_4": car.GammaD - s["Gamma"],
    }
    return (
        {**first, "eta": p["true_flow"].theta + s["alpha"]} if "alpha" in s else first
    )


def wanted_rate(loop: SymbolicLoop, before_eta_3: str = "z") -> Any:
    """Return e' = -KD e + W^T eta, Eq. (27) with z eta_3."""
    error, inputs = errors(loop), loop.inputs
    KD = loop.parameters["vehicle_controller"].KD
    rate = -KD * error["e"] + error["eta"] @ inputs["phi_x"]
    rate = rate + loop.states[before_eta_3] * error["eta_3"]
    return rate + inputs["zc"] * error["eta_4"]


# --- what they are compared with ---------------------------------------------------------------


@cache
def any_gains(law: str, disturbed: bool = False) -> SymbolicLoop:
    """Return a loop with any injection, before a law is chosen: what adapts has any rate."""
    loop = symbolic_loop(theorem_loop(2, law, disturbed), ("injection",))
    free = {
        port: np.vectorize(lambda s: sympy.Symbol(f"{s}'", real=True))(
            loop.states[port]
        )
        for port in LEARNED
        if port in loop.states
    }
    return replace(loop, rates=loop.rates | free)


@cache
def paper_loop(law: str) -> SymbolicLoop:
    """Return the closed loop of a law of the paper."""
    return symbolic_loop(theorem_loop(2, law))


@cache
def error_dynamics() -> tuple[sympy.Matrix, sympy.Matrix, sympy.Matrix, sympy.Symbol]:
    """Return A of Eq. (28), in the order e, eta, the joint regressor W (8, 2), KD and gamma."""
    loop = symbolic_loop(error_loop(theorem_scenario(2, "learned-flow")))
    A = sympy.Matrix([*loop.motion.values()]).jacobian([*loop.motion])
    KD = sympy.diag(*loop.parameters["error_system"].KD)
    return A, A[:2, 2:].T, KD, loop.parameters["parameter_system"].gain


def rate_of_e(loop: SymbolicLoop) -> np.ndarray:
    """Return e' along the equations."""
    return np.array([loop.derivative(e) for e in loop.signals["e"]])


def brackets(loop: SymbolicLoop, flow: Any, K: bool, alpha: bool = False) -> sympy.Expr:
    """Return V' less e^T (flow - KD e - psi) + the errors, each times what a law makes zero.

    Before K' and alpha' stands 1/gamma, or nothing, as printed.
    """
    error, s, rates, phi = errors(loop), loop.states, loop.rates, loop.inputs["phi_x"]
    e, gamma, zc = error["e"], loop.parameters["adaptation"].gain, loop.inputs["zc"]
    before_K, before_alpha = (1 if printed else 1 / gamma for printed in (K, alpha))
    form = e @ (
        flow - loop.parameters["vehicle_controller"].KD * e - loop.signals["psi"]
    )
    form += error["eta_3"] @ (before_K * rates["K"] + s["z"] * e)
    form += error["eta_4"] @ (zc * e - rates["Gamma"] / gamma)
    if "eta" in error:
        form += np.sum(
            error["eta"] * (before_alpha * rates["alpha"] + np.outer(e, phi))
        )
    return rate_of_V(loop) - form


def left_of_injection(loop: SymbolicLoop, printed: bool = False) -> np.ndarray:
    """Return -(alpha_M + alpha) phi(x) - (alpha_M - alpha) phi(z), Eq. (19), or as (25) has it."""
    alpha_M, alpha = loop.parameters["vehicle_controller"].alpha_M, loop.states["alpha"]
    phi, phi_z = loop.inputs["phi_x"], loop.inputs["phi_z"]
    return (
        -2 * alpha_M @ phi
        if printed
        else -(alpha_M + alpha) @ phi - (alpha_M - alpha) @ phi_z
    )


# --- one by one --------------------------------------------------------------------------------


def equation_18(printed: bool) -> Any:
    """V' of Eq. (18)."""
    loop = any_gains("known-flow")
    p = loop.parameters
    flow = (p["true_flow"].theta - p["vehicle_controller"].alpha_M) @ loop.inputs[
        "phi_x"
    ]
    return brackets(loop, flow, printed)


def equation_25(
    K: bool = False, alpha: bool = False, flow: bool = False, delta: bool = False
):
    """V' of the learned-flow law by Eq. (25) or, with Delta, (34), parts of it as printed."""
    loop = any_gains("learned-flow", delta)
    left = left_of_injection(loop, flow) + loop.inputs.get("delta", 0)
    return brackets(loop, left, K, alpha)


def second_derivative(printed: bool) -> Any:
    """e' as V'' after Eq. (26) has it."""
    loop = any_gains("learned-flow")
    beside = left_of_injection(loop, printed) - loop.signals["psi"]
    return rate_of_e(loop) - wanted_rate(loop) - beside


def equation_27(printed: bool) -> Any:
    """e' of Eq. (27)."""
    loop = paper_loop("learned-flow")
    return rate_of_e(loop) - wanted_rate(loop, "x" if printed else "z")


def equation_28_rows(printed: bool) -> Any:
    """The lower rows of A, Eq. (28)."""
    A, W, _, gamma = error_dynamics()
    blocks = [W[j : j + 2, :] for j in range(0, 8, 2)]
    return A[2:, :2] + gamma * sympy.Matrix.vstack(
        *(b.T if printed else b for b in blocks)
    )


def equation_28_P(printed: bool) -> Any:
    """All blocks of A^T P + P A but e e, P of Eq. (28)."""
    A, _, KD, gamma = error_dynamics()
    first, others = (
        (KD.inv(), [KD.inv()] * 4) if printed else (sympy.eye(2), [sympy.eye(8)])
    )
    P = sympy.diag(first, *(one / gamma for one in others)) / 2
    Q = A.T * P + P * A
    return [*Q[:2, 2:], *Q[2:, 2:]]


def output_injection(printed: bool) -> Any:
    """The first block of A + L C, L before Eq. (30), C = [I, 0]."""
    A, W, KD, gamma = error_dynamics()
    L = (KD if printed else sympy.zeros(2, 2)).col_join(gamma * W)
    return (A + L * sympy.eye(2).row_join(sympy.zeros(2, 8)))[:2, :2] + KD


def hats(printed: bool) -> Any:
    """V' by which theta Eqs. (12)-(16) mean."""
    loop = paper_loop("known-flow")
    return rate_of_V(loop) - (decay if printed else decay_and_known_error)(loop)


def gaussian(printed: bool) -> Any:
    """Return how log phi of Eq. (5) bends with distance."""
    d, width = sympy.symbols("d sigma", positive=True)
    kernel, one = (
        "exponential" if printed else "gaussian",
        (np.zeros((1, 2)), np.ones(1)),
    )
    block = flow.flow_basis("basis_x", "x", kernel, *one, np.zeros(1), np.zeros(1))
    known = {("u", "x", (0,)): d, ("p", "widths", (0,)): width}  # all else is zero
    record = block.array_record("output")
    leaf = lambda at, shape, k: known.get((*at, k), 0)  # noqa: E731
    phi = Symbols(record.operations, leaf, sizes=block.sizes).outputs(record)[0]
    return sympy.diff(sympy.expand_log(sympy.log(phi), force=True), d, 2) + 1 / width**2


def converges_to(printed: bool) -> Any:
    """The slopes of V of Eq. (24) where it shall have its minimum."""
    loop = paper_loop("learned-flow")
    alpha, theta = (
        np.ravel(a) for a in (loop.states["alpha"], loop.parameters["true_flow"].theta)
    )
    place = dict(zip(alpha, theta if printed else -theta, strict=True))
    return [sympy.diff(loop.signals["V"][0], a).xreplace(place) for a in place]


def bounded_z(printed: bool) -> Any:
    """What the argument for bounded z says is zero, proof of Theorem 3.2."""
    loop = paper_loop("learned-flow")
    s, rates = loop.states, zip(loop.rates["z"], loop.states["z"], strict=True)
    if not printed:
        return s["z"] - (s["x"] - loop.signals["e"])
    return [
        rate.diff(z, a) for rate, z in rates for port in LEARNED for a in s[port].flat
    ]


BEFORE_K = "(K - KD)^T (K' + z e)", "(K - KD)^T (K'/gamma + z e)"
MISPRINTS = (
    Misprint(
        "(18)",
        *BEFORE_K,
        "V' of (17) along the loop, K' and Gamma' left free",
        equation_18,
    ),
    Misprint(
        "(25)",
        "K' + z e, and (theta + alpha) alpha'",
        "K'/gamma + z e, and (theta + alpha) alpha'/gamma",
        "V' of (24) along the loop, the law left free",
        lambda printed: equation_25(K=printed, alpha=printed),
    ),
    Misprint(
        "(25)",
        "-2 e^T alpha_M phi",
        "-e^T [(alpha_M + alpha) phi(x) + (alpha_M - alpha) phi(z)]",
        "V' of (24) along the loop, the injection left free",
        lambda printed: equation_25(flow=printed),
    ),
    Misprint(
        "V'' after (26)",
        "... - Psi - 2 alpha_M phi",
        "... - Psi - (alpha_M + alpha) phi(x) - (alpha_M - alpha) phi(z)",
        "e' of the loop, the injection left free",
        second_derivative,
    ),
    Misprint(
        "(34)",
        *BEFORE_K,
        "V' of (24) along the loop with Delta, the law left free",
        lambda printed: equation_25(K=printed, delta=True),
    ),
    Misprint(
        "(27)", "x eta_3", "z eta_3, as in (28) and (31)", "e' of the loop", equation_27
    ),
    Misprint(
        "(28), lower rows of A",
        "-gamma phi_1, -gamma phi_2, -gamma z, -gamma zc",
        "-gamma phi_1^T, -gamma phi_2^T, -gamma z^T, -gamma zc^T",
        "A of the error and parameter blocks, N = 2",
        equation_28_rows,
    ),
    Misprint(
        "(28), P",
        "blocks K_D^{-1}/2 and K_D^{-1}/(2 gamma)",
        "diag(I, I/gamma)/2",
        "A^T P + P A has no blocks but e e, for KD not a multiple of I (and the printed "
        "blocks fit N = 2 alone)",
        equation_28_P,
    ),
    Misprint(
        "L before (30)",
        "L = [KD; gamma W], which removes -KD",
        "L = [0; gamma W]",
        "the first block of A + L C is -KD, as (31) has it",
        output_injection,
    ),
    Misprint(
        "(12)-(16), Assumption 3.3",
        "theta where theta_hat is meant",
        "theta_hat in (13), theta - theta_hat in (16)",
        "V' of (17) along the traced known-flow loop",
        hats,
    ),
    Misprint(
        "(5)",
        "exp of -|x - c|/(2 sigma), called Gaussian",
        "exp(-|x - c|^2/(2 sigma^2)) is Gaussian; the printed exponent is ambiguous",
        "log phi is quadratic in the distance",
        gaussian,
    ),
    Misprint(
        "figures 3 and 4",
        "parameters converge to the true values",
        "alpha converges to -theta; -alpha is plotted",
        "V of (24) has its minimum there",
        converges_to,
    ),
    Misprint(
        "proof of 3.2",
        "z is bounded because (8) is linear with sinusoidal inputs",
        "z = x - e, with x bounded by (9) and e by V",
        "dz'/dz of the loop is free of adapting gains; z = x - e",
        bounded_z,
    ),
)
