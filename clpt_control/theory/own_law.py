"""Prove an adaptive law of your own, or see where it fails.

    V' = -e^T KD e + residual        along the closed loop with your law in it

The law is a block that takes any of e, phi_x, z, zc and makes alpha, K, Gamma.
If the residual is zero, or a negative semidefinite form in the parameter
errors, V falls and e goes to zero as in Theorem 3.2.  Otherwise points with
V' > 0 are looked for.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy

from ..blocks import Block
from ..errors import DiagramError
from .lyapunov import decay, generic_residual, residual, theorem_loop
from .proof import Step, checked
from .trace import SymbolicLoop


@dataclass(frozen=True)
class Verdict:
    """What is known of V' under a law.

    Attributes
    ----------
    status : str
        ``"proved"``: V' <= -e^T KD e; ``"refuted"``: a point with V' > 0 was
        found; ``"open"``: neither.
    for_every_N : bool
        Whether the residual vanishes with N a symbol.
    residual : sympy.Expr
        V' + e^T KD e, multiplied out.
    point : dict or None
        Symbol -> value, where V' > 0.
    rate : float or None
        V' there.
    steps : tuple of Step
        What was tried.
    """

    status: str
    for_every_N: bool
    residual: sympy.Expr
    point: dict[str, float] | None
    rate: float | None
    steps: tuple[Step, ...]


def prove(
    law_block: Block, V: Block | None = None, samples: int = 20_000, seed: int = 0
) -> Verdict:
    """Judge an adaptive law by V' along the closed loop.

    Parameters
    ----------
    law_block : Block
        With outputs alpha[2N], K[2], Gamma[2] and inputs among the diagram's
        ports, such as e[2], phi_x[N], z[2], zc[2].
    V : Block, optional
        A candidate with the output V[1]; Eq. (24) by default.
    samples : int, optional
        Random points at which V' > 0 is looked for.
    seed : int, optional
        Of the random points.

    Returns
    -------
    Verdict
        A proof, or the residual that does not cancel and a point where V' > 0.

    Raises
    ------
    DiagramError
        If the law does not make alpha[2N], K[2] and Gamma[2].

    Examples
    --------
    >>> from clpt_control.blocks.adaptation import LearnedFlowParameters, adaptation
    >>> prove(adaptation(LearnedFlowParameters(N=2, gain=0.5))).status
    'proved'
    """
    N = _functions(law_block)
    diagram = theorem_loop(N, "learned-flow", law_block=law_block, candidate=V)
    loop, rest = residual(diagram, decay)
    cancels = Step(
        f"V' = -e^T KD e, N = {N}", rest == 0, "symbolic", "" if rest == 0 else f"left over: {rest}"
    )

    def every() -> bool:
        left = generic_residual(diagram, decay)
        return left.base == 0 and left.term == 0

    generic = checked("V' = -e^T KD e, every N", "symbolic", every)
    if rest == 0:
        return Verdict("proved", generic.holds, rest, None, None, (cancels, generic))
    definite = checked(
        "the residual is a negative semidefinite form in the parameter errors",
        "definite form",
        lambda: _negative_form(loop, rest),
    )
    if definite.holds:
        return Verdict("proved", False, rest, None, None, (cancels, definite))
    rate = rest + decay_of(loop)
    point, value = _rising_point(rate, samples, seed)
    found = Step(f"V' > 0 somewhere among {samples} random points", value > 0, "sampled",
                 f"largest V' = {value:.3g}")  # fmt: skip
    steps = (cancels, definite, found)
    if value > 0:
        return Verdict("refuted", False, rest, point, value, steps)
    return Verdict("open", False, rest, None, None, steps)


def decay_of(loop: SymbolicLoop) -> sympy.Expr:
    """Give -e^T KD e of a traced loop."""
    e, KD = loop.signals["e"], loop.parameters["vehicle_controller"].KD
    return -sum(KD[i] * e[i] ** 2 for i in range(2))


def _functions(law: Block) -> int:
    sizes = law.output_ports
    N = sizes.get("alpha", 0) // 2
    if N < 1 or sizes.get("alpha") != 2 * N or sizes.get("K") != 2 or sizes.get("Gamma") != 2:
        raise DiagramError(
            f"{law.name}: a law makes alpha[2N], K[2] and Gamma[2]; it makes "
            + (", ".join(f"{port}[{size}]" for port, size in sizes.items()) or "nothing")
        )
    if law.input_ports.get("phi_x", N) != N:
        raise DiagramError(f"{law.name}: phi_x has {law.input_ports['phi_x']} signals, N is {N}")
    return N


def _negative_form(loop: SymbolicLoop, rest: sympy.Expr) -> bool:
    """Tell whether the residual is a constant form -s^T M s in shifted states."""
    states = [s for symbols in loop.states.values() for s in symbols]
    H = sympy.hessian(rest, states)
    if H.free_symbols & set(states) or H.atoms(sympy.Function):
        return False
    theta = loop.parameters["true_flow"].theta.ravel()
    p = loop.parameters["vehicle_controller"]
    true = dict(zip(loop.states["x"], loop.states["z"], strict=True))
    for port, values in (("alpha", -theta), ("K", p.KD), ("Gamma", p.GammaD)):
        true |= dict(zip(loop.states.get(port, ()), values, strict=True))
    at_truth = [rest, *(sympy.diff(rest, s) for s in states)]
    if any(sympy.expand(value.subs(true, simultaneous=True)) != 0 for value in at_truth):
        return False
    return bool((-H).is_positive_semidefinite)


def _rising_point(rate: sympy.Expr, samples: int, seed: int) -> tuple[dict[str, float], float]:
    """Give the random point with the largest V'."""
    functions = sorted(rate.atoms(sympy.Function), key=str)
    plain = {f: sympy.Symbol(f"{f.func}", real=True) for f in functions}
    rate = rate.subs(plain)
    symbols = sorted(rate.free_symbols, key=str)
    random = np.random.default_rng(seed)
    values: dict[Any, np.ndarray] = {}
    for symbol in symbols:
        draw = random.standard_normal(samples) * 10.0 ** random.uniform(-1, 1, samples)
        values[symbol] = np.abs(draw) if symbol.is_positive else draw
    rates = np.broadcast_to(
        sympy.lambdify(symbols, rate, "numpy")(*(values[s] for s in symbols)), samples
    )
    best = int(np.nanargmax(rates))
    return {str(s): float(values[s][best]) for s in symbols}, float(rates[best])
