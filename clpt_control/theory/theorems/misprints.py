"""Misprints of the paper, each with a check of the printed and the corrected form.

The residual of a check is the difference between the printed or corrected form and the running
blocks for N = 2; it is zero for the corrected form alone.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import numpy as np
import sympy
from sympy import Matrix, Symbol, diff, eye, zeros

from ...engine.record.symbolic import Symbols
from ...paper.blocks import flow
from ...paper.laws.law import LEARNED
from ...simulation.loops import error_loop
from ..algebra.exact import vanishes
from ..laws.paper_loop import PaperLoop
from ..laws.theorem_loop import (
    decay,
    decay_and_known_error,
    rate_of_V,
    theorem_loop,
    theorem_scenario,
)
from ..proofs.steps import checked
from ..proofs.symbolic_loop import symbolic_loop


@dataclass(frozen=True)
class Misprint:
    """A misprint with its correction and a check."""

    equation: str  # its location in the paper
    printed: str
    corrected: str
    check: str  # the quantity that is compared
    residual: Callable[[bool], Any]  # of the printed form if True; zero if it is right

    def holds(self, printed: bool) -> bool:
        """Return True if the residual of the printed or the corrected form vanishes."""
        residual = np.array(self.residual(printed), dtype=object)
        return all(map(vanishes, residual.flat))

    @property
    def confirmed(self) -> bool:
        """True if the check fails on the print and passes on the correction."""
        return checked("", lambda: not self.holds(True) and self.holds(False)).holds


def misprints() -> tuple[Misprint, ...]:
    """Return the paper's misprints with their checks.

    Returns
    -------
    tuple of Misprint
        Each with `equation`, `printed`, `corrected`, `check` and `confirmed`, True if the
        check fails on the print and passes on the correction.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> found = clpt.theory.misprints()[0]
    >>> found.equation, found.holds(True), found.holds(False)
    ('(18)', False, True)
    """
    for cached in (any_gains, of_law, error_dynamics):
        cached.cache_clear()  # the blocks may have been changed
    return MISPRINTS


# --- symbolic loops ----------------------------------------------------------------------------


@cache
def any_gains(law: str, disturbed: bool = False) -> PaperLoop:
    """Return a loop with free injection and free rates of the adapted parameters."""
    loop = symbolic_loop(theorem_loop(2, law, disturbed), ("injection",))
    rate_symbol = np.vectorize(lambda s: Symbol(f"{s}'", real=True))
    adapted = [port for port in LEARNED if port in loop.states]
    free = {port: rate_symbol(loop.states[port]) for port in adapted}
    return PaperLoop(loop=replace(loop, rates=loop.rates | free))


@cache
def of_law(law: str) -> PaperLoop:
    """Return the closed loop of a law of the paper."""
    return PaperLoop(loop=symbolic_loop(theorem_loop(2, law)))


@cache
def error_dynamics() -> tuple[Matrix, Matrix, Matrix, Symbol]:
    """Return A of Eq. (28), in the order e, eta, the joint regressor W (8, 2), KD and gamma."""
    loop = symbolic_loop(error_loop(theorem_scenario(2, "learned-flow")))
    A = Matrix([*loop.motion.values()]).jacobian([*loop.motion])
    KD = sympy.diag(*loop.parameters["error_system"].KD)
    return A, A[:2, 2:].T, KD, loop.parameters["parameter_system"].gain


def brackets(paper: PaperLoop, flow: Any, K: bool, alpha: bool = False) -> sympy.Expr:
    """Return V' less e^T (flow - KD e - psi) and less the brackets of the parameter errors.

    K' and alpha' are divided by gamma, or not, if `K` or `alpha` is as printed.
    """
    e, gamma, loop = paper.e, paper.gamma, paper.loop
    of_K = loop.rates["K"] / (1 if K else gamma)
    form = e @ (flow - paper.KD * e - loop.signals["psi"])
    form += paper.kappa @ (of_K + paper.z * e)
    form += paper.nu @ (paper.zc * e - loop.rates["Gamma"] / gamma)
    if "alpha" in loop.states:
        of_alpha = loop.rates["alpha"] / (1 if alpha else gamma)
        form += np.sum(paper.eta * (of_alpha + np.outer(e, paper.phi)))
    return rate_of_V(loop) - form


def modelled_flow(paper: PaperLoop, printed: bool) -> np.ndarray:
    """Return -(alpha_M + alpha) phi(x) - (alpha_M - alpha) phi(z), Eq. (19), or that of (25)."""
    alpha_M, alpha = paper.alpha_M, paper.alpha
    if printed:
        return -2 * alpha_M @ paper.phi
    return (
        -(alpha_M + alpha) @ paper.phi - (alpha_M - alpha) @ paper.loop.inputs["phi_z"]
    )


# --- residuals ---------------------------------------------------------------------------------


def equation_18(printed: bool) -> Any:
    """V' of Eq. (18)."""
    paper = any_gains("known-flow")
    return brackets(paper, (paper.theta - paper.alpha_M) @ paper.phi, printed)


def equation_25(
    K: bool = False, alpha: bool = False, flow: bool = False, delta: bool = False
):
    """V' of the learned-flow law by Eq. (25) or, with Delta, Eq. (34), as printed."""
    paper = any_gains("learned-flow", delta)
    total = modelled_flow(paper, flow) + paper.loop.inputs.get("delta", 0)
    return brackets(paper, total, K, alpha)


def second_derivative(printed: bool) -> Any:
    """e' in V'' after Eq. (26)."""
    paper = any_gains("learned-flow")
    flow = modelled_flow(paper, printed) - paper.loop.signals["psi"]
    return paper.rate(paper.e) - paper.error_rate - flow


def equation_27(printed: bool) -> Any:
    """e' of Eq. (27)."""
    paper = of_law("learned-flow")
    rate = paper.rate(paper.e) - paper.error_rate
    return rate - (paper.x - paper.z) * paper.kappa if printed else rate


def equation_28_rows(printed: bool) -> Any:
    """The lower rows of A, Eq. (28)."""
    A, W, _, gamma = error_dynamics()
    blocks = [W[j : j + 2, :] for j in range(0, 8, 2)]
    if printed:
        blocks = [block.T for block in blocks]
    return A[2:, :2] + gamma * Matrix.vstack(*blocks)


def equation_28_P(printed: bool) -> Any:
    """All blocks of A^T P + P A but that of e, P of Eq. (28)."""
    A, _, KD, gamma = error_dynamics()
    block = KD.inv() if printed else eye(2)
    P = sympy.diag(block, *[block / gamma] * 4) / 2
    Q = A.T * P + P * A
    return [*Q[:2, 2:], *Q[2:, 2:]]


def output_injection(printed: bool) -> Any:
    """The first block of A + L C, L before Eq. (30), C = [I, 0]."""
    A, W, KD, gamma = error_dynamics()
    L = (KD if printed else zeros(2, 2)).col_join(gamma * W)
    return (A + L * eye(2).row_join(zeros(2, 8)))[:2, :2] + KD


def hats(printed: bool) -> Any:
    """V' with theta or theta_hat in Eqs. (12)-(16)."""
    loop = of_law("known-flow").loop
    rate = decay(loop) if printed else decay_and_known_error(loop)
    return rate_of_V(loop) - rate


def gaussian(printed: bool) -> Any:
    """Curvature of log phi of Eq. (5) along the distance d."""
    d, width = sympy.symbols("d sigma", positive=True)
    kernel = "exponential" if printed else "gaussian"
    center, unit, zero = np.zeros((1, 2)), np.ones(1), np.zeros(1)
    block = flow.flow_basis("basis_x", "x", kernel, center, unit, zero, zero)
    symbols = {("u", "x", (0,)): d, ("p", "widths", (0,)): width}

    def leaf(name: tuple[str, str], shape: Any, index: Any) -> Any:
        return symbols.get((*name, index), 0)

    record = block.array_record("output")
    phi = Symbols(record.operations, leaf, sizes=block.sizes).outputs(record)[0]
    log_phi = sympy.expand_log(sympy.log(phi), force=True)
    return diff(log_phi, d, 2) + 1 / width**2


def converges_to(printed: bool) -> Any:
    """Gradient of V of Eq. (24) at the supposed minimum."""
    paper = of_law("learned-flow")
    learned = paper.theta if printed else -paper.theta
    minimum = dict(zip(paper.alpha.flat, learned.flat, strict=True))
    return [diff(paper.V, a).xreplace(minimum) for a in minimum]


def bounded_z(printed: bool) -> Any:
    """Term that vanishes by the argument for bounded z, proof of Theorem 3.2."""
    paper = of_law("learned-flow")
    if not printed:
        return paper.z - (paper.x - paper.e)
    loop = paper.loop
    adapted = [symbol for port in LEARNED for symbol in loop.states[port].flat]
    slopes = [rate.diff(z) for rate, z in zip(loop.rates["z"], paper.z, strict=True)]
    return [slope.diff(symbol) for slope in slopes for symbol in adapted]


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
        "theta where theta_hat is meant; the text that was read has no hats",
        "theta_hat in (13), theta - theta_hat in (16)",
        "V' of (17) along the traced known-flow loop",
        hats,
    ),
    Misprint(
        "(5)",
        "an exponent called Gaussian; read as -|x - c|/(2 sigma) it is none",
        "exp(-|x - c|^2/(2 sigma^2)), or exp(-|x - c|^2/sigma)",
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
