"""What tells a misprint from its correction, on the blocks.

Each function takes `printed` and says whether that form agrees with what the
blocks that run give; the table of `misprints` names them.
"""

from collections.abc import Callable
from functools import cache

import numpy as np
import sympy

from ...blocks import basis
from ...blocks.symbolic import expressions
from .observability import ErrorDynamics, error_dynamics, eta_of
from .symbolic_loop import SymbolicLoop, symbolic_loop
from .theorem_loop import theorem_loop


@cache
def _loop(law: str, disturbed: bool = False) -> SymbolicLoop:
    return symbolic_loop(theorem_loop(2, law, disturbed), ["injection"])


@cache
def _dynamics() -> ErrorDynamics:
    return error_dynamics(2)


def _free_rate(law: str, disturbed: bool = False) -> tuple[sympy.Expr, dict]:
    """V' before a law or an injection is chosen: rates of alpha, K, Gamma are free."""
    loop = _loop(law, disturbed)
    V, rate, free = loop.signals["V"][0], sympy.Integer(0), {}
    for port, states in loop.states.items():
        own = list(loop.rates[port])
        if port in ("alpha", "K", "Gamma"):
            own = [sympy.Symbol(f"{s}'", real=True) for s in states]
            free[port] = own
        rate += sum(sympy.diff(V, s) * r for s, r in zip(states, own, strict=True))
    return rate, free


def _pieces(law: str, disturbed: bool = False):
    loop = _loop(law, disturbed)
    p, signals = loop.parameters, loop.signals
    theta, alpha_M = p["true_flow"].theta, p["vehicle_controller"].alpha_M
    return (
        loop,
        p["vehicle_controller"].KD,
        p["adaptation"].gain,
        theta,
        alpha_M,
        signals["e"],
        loop.inputs["phi_x"],
        loop.inputs["phi_z"],
        signals["psi"],
    )


def _gain_terms(law: str, before_K: sympy.Expr, disturbed: bool = False) -> sympy.Expr:
    """(K - KD)^T(before K' + z e) + (GammaD - Gamma)^T(zc e - Gamma'/gamma)."""
    loop, KD, gamma, *_, e, _, _, _ = _pieces(law, disturbed)
    _, free = _free_rate(law, disturbed)
    GammaD, z, zc = (
        loop.parameters["vehicle_controller"].GammaD,
        loop.states["z"],
        loop.inputs["zc"],
    )
    K, Gamma = loop.states["K"], loop.states["Gamma"]
    return sum(
        (K[i] - KD[i]) * (before_K * free["K"][i] + z[i] * e[i])
        + (GammaD[i] - Gamma[i]) * (zc[i] * e[i] - free["Gamma"][i] / gamma)
        for i in range(2)
    )


def equation_18(printed: bool) -> bool:
    """Check V' of Eq. (18)."""
    _, KD, gamma, theta, alpha_M, e, phi, _, psi = _pieces("known-flow")
    rate, _ = _free_rate("known-flow")
    form = _gain_terms("known-flow", sympy.Integer(1) if printed else 1 / gamma)
    for i in range(2):
        flow = sum((theta[i, k] - alpha_M[i, k]) * phi[k] for k in range(2))
        form += e[i] * (-KD[i] * e[i] + flow - psi[i])
    return sympy.expand(rate - form) == 0


def _learned(gamma_K, gamma_alpha, rest, disturbed: bool) -> bool:
    """Compare V' with -e^T KD e + e^T(...) + the law's brackets."""
    loop, KD, _, theta, _, e, phi, _, psi = _pieces("learned-flow", disturbed)
    rate, free = _free_rate("learned-flow", disturbed)
    form, alpha = _gain_terms("learned-flow", gamma_K, disturbed), loop.states["alpha"]
    for i in range(2):
        push = loop.inputs["delta"][i] if disturbed else 0
        form += e[i] * (-KD[i] * e[i] + push - psi[i] + rest(i))
        for k in range(2):
            error = theta[i, k] + alpha[2 * i + k]
            form += error * (gamma_alpha * free["alpha"][2 * i + k] + e[i] * phi[k])
    return sympy.expand(rate - form) == 0


def _left_of_injection(disturbed: bool = False) -> Callable[[int], sympy.Expr]:
    """-(alpha_M + alpha) phi(x) - (alpha_M - alpha) phi(z), as in Eq. (19)."""
    loop, _, _, _, alpha_M, _, phi_x, phi_z, _ = _pieces("learned-flow", disturbed)
    alpha = loop.states["alpha"]
    return lambda i: (
        -sum(
            (alpha_M[i, k] + alpha[2 * i + k]) * phi_x[k]
            + (alpha_M[i, k] - alpha[2 * i + k]) * phi_z[k]
            for k in range(2)
        )
    )


def _twice_model(disturbed: bool = False) -> Callable[[int], sympy.Expr]:
    """-2 alpha_M phi(x), as printed."""
    *_, alpha_M, _, phi_x, _, _ = _pieces("learned-flow", disturbed)
    return lambda i: -2 * sum(alpha_M[i, k] * phi_x[k] for k in range(2))


def equation_25_gains(printed: bool) -> bool:
    """Check the factors 1/gamma of Eq. (25)."""
    gamma = _pieces("learned-flow")[2]
    inverse = sympy.Integer(1) if printed else 1 / gamma
    return _learned(inverse, inverse, _left_of_injection(), False)


def equation_25_flow(printed: bool) -> bool:
    """Check the flow terms of Eq. (25)."""
    gamma = _pieces("learned-flow")[2]
    rest = _twice_model() if printed else _left_of_injection()
    return _learned(1 / gamma, 1 / gamma, rest, False)


def equation_34(printed: bool) -> bool:
    """Check the factor 1/gamma of Eq. (34)."""
    gamma = _pieces("learned-flow", True)[2]
    before = sympy.Integer(1) if printed else 1 / gamma
    return _learned(before, 1 / gamma, _left_of_injection(True), True)


def second_derivative(printed: bool) -> bool:
    """Check e' as V'' after Eq. (26) has it."""
    loop, KD, _, _, _, e, phi, _, psi = _pieces("learned-flow")
    eta, z, zc = eta_of(loop), loop.states["z"], loop.inputs["zc"]
    rest = _twice_model() if printed else _left_of_injection()
    for i in range(2):
        form = sum(phi[k] * eta[2 * i + k] for k in range(2)) - KD[i] * e[i]
        form += z[i] * eta[4 + i] + zc[i] * eta[6 + i] - psi[i] + rest(i)
        if sympy.expand(loop.derivative(e[i]) - form) != 0:
            return False
    return True


def equation_27(printed: bool) -> bool:
    """Check e' of Eq. (27)."""
    loop = symbolic_loop(theorem_loop(2, "learned-flow"))
    eta, e, phi = eta_of(loop), loop.signals["e"], loop.inputs["phi_x"]
    KD, zc = loop.parameters["vehicle_controller"].KD, loop.inputs["zc"]
    third = loop.states["x"] if printed else loop.states["z"]
    return all(
        sympy.expand(
            loop.derivative(e[i])
            - sum(phi[k] * eta[2 * i + k] for k in range(2))
            - third[i] * eta[4 + i]
            - zc[i] * eta[6 + i]
            + KD[i] * e[i]
        )
        == 0
        for i in range(2)
    )


def equation_28_rows(printed: bool) -> bool:
    """Check the lower rows of A, Eq. (28)."""
    A, _, W, _, gamma = _dynamics()
    blocks = [W[0:2, :], W[2:4, :], W[4:6, :], W[6:8, :]]
    rows = [block.T if printed else block for block in blocks]
    return A[2:, :2] == -gamma * sympy.Matrix.vstack(*rows)


def equation_28_P(printed: bool) -> bool:
    """Check P of Eq. (28)."""
    A, _, _, KD, gamma = _dynamics()
    inverse = KD.inv()
    P = sympy.diag(inverse / 2, *[inverse / (2 * gamma)] * 4)
    if not printed:
        P = sympy.diag(sympy.eye(2) / 2, sympy.eye(8) / (2 * gamma))
    Q = sympy.simplify(A.T * P + P * A)
    return Q[:2, 2:] == sympy.zeros(2, 8) and Q[2:, 2:] == sympy.zeros(8, 8)


def output_injection(printed: bool) -> bool:
    """Check L before Eq. (30)."""
    A, C, W, KD, gamma = _dynamics()
    L = (KD if printed else sympy.zeros(2, 2)).col_join(gamma * W)
    return sympy.expand((A + L * C)[:2, :2] + KD) == sympy.zeros(2, 2)


def hats(printed: bool) -> bool:
    """Check which theta Eqs. (12)-(16) mean."""
    loop = symbolic_loop(theorem_loop(2, "known-flow"))
    p, e, phi = loop.parameters, loop.signals["e"], loop.inputs["phi_x"]
    theta = p["true_flow"].theta
    known = theta if printed else p["injection"].theta_hat
    rate = loop.derivative(loop.signals["V"][0])
    for i in range(2):
        rate += p["vehicle_controller"].KD[i] * e[i] ** 2
        rate -= e[i] * sum((theta[i, k] - known[i, k]) * phi[k] for k in range(2))
    return sympy.expand(rate) == 0


def gaussian(printed: bool) -> bool:
    """Check whether log phi of Eq. (5) is quadratic in distance."""
    d, width = sympy.symbols("d sigma", positive=True)
    one = basis.BasisParameters(1, np.zeros((1, 2)), np.ones(1), np.zeros(1), np.zeros(1))
    block = basis.flow_basis("basis_x", "x", "exponential" if printed else "gaussian", one)
    known = {("u", 0): d, ("p", "widths", 0): width}  # the centre, frequency and phase are zero
    phi = expressions(block.output_record, lambda *where: known.get(where, sympy.Integer(0)))[0]
    bend = sympy.simplify(sympy.diff(sympy.expand_log(sympy.log(phi), force=True), d, 2))
    return bend != 0 and not bend.has(d)


def converges_to(printed: bool) -> bool:
    """Check where V of Eq. (24) has its minimum."""
    loop = symbolic_loop(theorem_loop(2, "learned-flow"))
    alpha, theta = loop.states["alpha"], loop.parameters["true_flow"].theta.ravel()
    place = dict(zip(alpha, theta if printed else -theta, strict=True))
    V = loop.signals["V"][0]
    return all(sympy.expand(sympy.diff(V, a).subs(place, simultaneous=True)) == 0 for a in alpha)


def bounded_z(printed: bool) -> bool:
    """Check the argument for bounded z, proof of Theorem 3.2."""
    loop = symbolic_loop(theorem_loop(2, "learned-flow"))
    z, rates, e, x = loop.states["z"], loop.rates["z"], loop.signals["e"], loop.states["x"]
    if not printed:
        return all(sympy.expand(z[i] - (x[i] - e[i])) == 0 for i in range(2))
    adapting = {s for port in ("alpha", "K", "Gamma") for s in loop.states[port]}
    return not any(sympy.diff(rates[i], z[i]).free_symbols & adapting for i in range(2))


def forget() -> None:
    """Forget the loops read, as after a change of the blocks."""
    _loop.cache_clear()
    _dynamics.cache_clear()
