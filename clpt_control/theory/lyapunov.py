"""V' along the equations that run, for N = 1, 2, 3 and for every N.

    V' = sum_i dV/ds_i * s_i'        over all states s of the closed loop

V is a block of the diagram (`blocks.lyapunov`), s' comes from the traced
update functions.  What a theorem claims V' to be is stated once, over the
paper's symbols, and compared with what the blocks give: for N = 1, 2, 3 term by
term, for generic N as base + sum over k of a summand.
"""

from collections.abc import Callable
from functools import partial
from typing import Any, NamedTuple

import numpy as np
import sympy

from ..blocks import Block
from ..blocks.lyapunov import LyapunovParameters, lyapunov_candidate
from ..diagram import paper_blocks
from ..errors import DiagramError
from ..interconnection import Diagram, connect
from ..paper import paper_scenario
from ..scenario import Scenario
from .generic import K, Summed, element_symbol
from .generic_trace import GenericLoop, generic_trace
from .proof import Step, checked
from .trace import SymbolicLoop, trace

PHI = ("basis_x", "basis_z")


def theorem_scenario(N: int, law: str, disturbed: bool = False) -> Scenario:
    """Give a scenario of section II with N functions.

    Parameters
    ----------
    N : int
        Number of basis functions.
    law : str
        ``"known-flow"`` or ``"learned-flow"``.
    disturbed : bool, optional
        Whether Delta of Eq. (32) is there.

    Returns
    -------
    Scenario
        Every number becomes a symbol when it is traced.

    Examples
    --------
    >>> theorem_scenario(2, "learned-flow").basis.N
    2
    """
    rows = [[0.1 * (k + 1) for k in range(N)], [0.2 * (k + 1) for k in range(N)]]
    known = law == "known-flow"
    push = {"kind": "constant", "amplitude": [0.1, 0.1]}
    return paper_scenario().with_values(
        {
            "basis.centers": [[float(k), float(-k)] for k in range(N)],
            "basis.widths": [1.0 + k for k in range(N)],
            "basis.periods": [2.0 + k for k in range(N)],
            "basis.phases": [0.0] * N,
            "flow.parameters": rows,
            "flow.disturbance": push if disturbed else None,
            "model.parameters": [[0.3 * (k + 1) for k in range(N)]] * 2,
            "learning.law": law,
            "learning.parameters": None,
            "learning.theta_estimate": [[0.4] * N] * 2 if known else None,
        }
    )


def theorem_loop(
    N: int,
    law: str,
    disturbed: bool = False,
    law_block: Block | None = None,
    candidate: Block | None = None,
) -> Diagram:
    """Wire the closed loop of a theorem, with its V as a block.

    Parameters
    ----------
    N : int
        Number of basis functions.
    law : str
        ``"known-flow"``: V of Eq. (17); ``"learned-flow"``: V of Eq. (24).
    disturbed : bool, optional
        Whether Delta of Eq. (32) is there.
    law_block : Block, optional
        An adaptation block in place of the paper's.
    candidate : Block, optional
        A block with the output V[1] in place of the paper's V.

    Returns
    -------
    Diagram
        The paper's blocks and V.

    Examples
    --------
    >>> theorem_loop(1, "learned-flow").output_labels[-1]
    'V[0]'
    """
    scenario = theorem_scenario(N, law, disturbed)
    blocks = paper_blocks(scenario)
    if law_block is not None:
        blocks = [law_block if block.name == "adaptation" else block for block in blocks]
    gain = getattr(getattr(law_block, "parameters", None), "gain", scenario.learning.gain)
    if candidate is None:
        candidate = lyapunov_candidate(
            law,
            LyapunovParameters(
                N,
                gain,
                np.array(scenario.flow.parameters),
                np.array(scenario.vehicle.feedback),
                np.array(scenario.vehicle.feedforward),
            ),
        )
    return connect([*blocks, candidate], name="theorem")


class Terms(NamedTuple):
    """The paper's symbols, for one N or for every N.

    Attributes
    ----------
    e, KD, delta : callable
        ``e(i)``, ``KD(i)``, ``delta(i)`` for the axes i = 0, 1.
    theta, theta_hat : callable
        ``theta(i, k)``.
    phi : callable
        ``phi(k)``, at the vehicle.
    """

    e: Callable
    KD: Callable
    delta: Callable
    theta: Callable
    theta_hat: Callable
    phi: Callable


def concrete_terms(loop: SymbolicLoop) -> Terms:
    """Give the paper's symbols of a loop traced for one N."""
    p = loop.parameters
    return Terms(
        e=lambda i: loop.signals["e"][i],
        KD=lambda i: p["vehicle_controller"].KD[i],
        delta=lambda i: loop.signals["delta"][i],
        theta=lambda i, k: p["true_flow"].theta[i, k],
        theta_hat=lambda i, k: p["injection"].theta_hat[i, k],
        phi=lambda k: loop.signals["phi_x"][k],
    )


def generic_terms(loop: GenericLoop) -> Terms:
    """Give the paper's symbols of a loop traced for every N."""
    array = lambda name: lambda i, k: element_symbol(name, i, k)  # noqa: E731
    return Terms(
        e=lambda i: loop.signals[("e", None, i)].base,
        KD=lambda i: sympy.Symbol(f"KD_{i + 1}", positive=True),
        delta=lambda i: loop.signals[("delta", None, i)].base,
        theta=array("theta"),
        theta_hat=array("theta_hat"),
        phi=lambda k: element_symbol("phi_x", 0, k),
    )


Claim = Callable[[Terms, Any], tuple[sympy.Expr, sympy.Expr]]


def lyapunov_derivative(diagram: Diagram) -> tuple[SymbolicLoop, sympy.Expr]:
    """Differentiate the diagram's V along its equations.

    Parameters
    ----------
    diagram : Diagram
        With one block that makes V[1], as `theorem_loop` gives it.

    Returns
    -------
    loop : SymbolicLoop
        The traced diagram, phi left undefined.
    rate : sympy.Expr
        V', multiplied out.

    Raises
    ------
    DiagramError
        If no block makes V.

    Examples
    --------
    >>> loop, rate = lyapunov_derivative(theorem_loop(1, "learned-flow"))
    >>> e, KD = loop.signals["e"], loop.parameters["vehicle_controller"].KD
    >>> sympy.expand(rate + KD[0] * e[0] ** 2 + KD[1] * e[1] ** 2)
    0
    """
    loop = trace(diagram, PHI)
    if "V" not in loop.signals:
        raise DiagramError("no block makes V; wire a candidate such as blocks.lyapunov")
    return loop, sympy.expand(loop.derivative(loop.signals["V"][0]))


def residual(diagram: Diagram, claim: Claim) -> tuple[SymbolicLoop, sympy.Expr]:
    """Give what V' has beyond a claim, for the diagram's own N.

    Parameters
    ----------
    diagram : Diagram
        As `theorem_loop` gives it.
    claim : callable
        ``claim(terms, k)`` -> (base, summand over k): what V' should be.

    Returns
    -------
    loop : SymbolicLoop
        The traced diagram.
    residual : sympy.Expr
        Zero where the claim holds.
    """
    loop, rate = lyapunov_derivative(diagram)
    terms = concrete_terms(loop)
    base, _ = claim(terms, 0)
    summands = sum((claim(terms, k)[1] for k in range(loop.N or 0)), sympy.Integer(0))
    return loop, sympy.expand(rate - base - summands)


def generic_residual(diagram: Diagram, claim: Claim) -> Summed:
    """Give what V' has beyond a claim, for every N.

    Parameters
    ----------
    diagram : Diagram
        As `theorem_loop` gives it.
    claim : callable
        As for `residual`.

    Returns
    -------
    Summed
        Base and summand; both zero where the claim holds.
    """
    loop = generic_trace(diagram, PHI)
    rate = loop.derivative(loop.signals[("V", None, 0)])
    base, summand = claim(generic_terms(loop), K)
    return Summed(sympy.expand(rate.base - base), sympy.expand(rate.term - summand))


def identity_steps(text: str, law: str, claim: Claim, disturbed: bool = False) -> list[Step]:
    """Check V' for N = 1, 2, 3 and for every N.

    Parameters
    ----------
    text : str
        The claim in words, such as ``"V' = -e^T KD e"``.
    law : str
        The adaptive law.
    claim : callable
        As for `residual`.
    disturbed : bool, optional
        Whether Delta of Eq. (32) is there.

    Returns
    -------
    list of Step
        Four symbolic steps; a failed one says what does not cancel.

    Examples
    --------
    >>> steps = identity_steps("V' = -e^T KD e", "learned-flow", decay)
    >>> [step.holds for step in steps]
    [True, True, True, True]
    """

    def one(N: int) -> tuple[bool, str]:
        _, rest = residual(theorem_loop(N, law, disturbed), claim)
        return rest == 0, "" if rest == 0 else f"left over: {_short(rest)}"

    def every() -> tuple[bool, str]:
        rest = generic_residual(theorem_loop(3, law, disturbed), claim)
        done = rest.base == 0 and rest.term == 0
        left = f"left over: {_short(rest.base)}; summand {_short(rest.term)}"
        return done, "" if done else left

    steps = [checked(f"{text}, N = {N}", "symbolic", partial(one, N)) for N in (1, 2, 3)]
    claimed = f"{text}, every N: base and summand over k cancel"
    return [*steps, checked(claimed, "symbolic", every)]


def decay(terms: Terms, k: Any) -> tuple[sympy.Expr, sympy.Expr]:
    """V' = -e^T KD e, Eq. (26)."""
    return -sum(terms.KD(i) * terms.e(i) ** 2 for i in range(2)), sympy.Integer(0)


def decay_and_known_error(terms: Terms, k: Any) -> tuple[sympy.Expr, sympy.Expr]:
    """V' = -e^T KD e + e^T (theta - theta_hat) phi, Theorem 3.1."""
    summand = sum(
        terms.e(i) * (terms.theta(i, k) - terms.theta_hat(i, k)) * terms.phi(k) for i in range(2)
    )
    return decay(terms, k)[0], summand


def decay_and_disturbance(terms: Terms, k: Any) -> tuple[sympy.Expr, sympy.Expr]:
    """V' = -e^T KD e + e^T Delta, Eq. (35)."""
    push = sum(terms.e(i) * terms.delta(i) for i in range(2))
    return decay(terms, k)[0] + push, sympy.Integer(0)


def _short(expression: sympy.Expr, most: int = 160) -> str:
    text = str(expression)
    return text if len(text) <= most else text[:most] + " ..."
