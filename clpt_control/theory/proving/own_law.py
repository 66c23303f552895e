"""Prove an adaptive law of your own, or see where it fails.

The law is a block that takes any of the diagram's signals and makes alpha, K, Gamma.  By default
V is Eq. (24), each error weighed by the inverse of the gain with which the law adapts it, so that
the terms with e cancel; gains are read off the law's equations,

    alpha' = -gain e phi + rest,    K' = -gain z e + rest,    Gamma' = gain zc e + rest

What V' along the closed loop says is judged in `verdict`.
"""

import control
import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ...arguments import Seed, public
from ...diagrams.interconnection import Diagram, connect
from ...diagrams.parts import functions_of
from ...diagrams.wiring import read_anew
from ...equations.block import Block
from ...errors import ClptError, DiagramError
from ...simulation.loops import loop_of
from .array_loop import TIME
from .law_case import Case, flat
from .signs import tidied
from .symbolic_loop import SymbolicLoop, own_values, refuse_no_value, symbolic_loop
from .symbols import paper_name
from .theorem_loop import theorem_candidate, theorem_loop, theorem_scenario
from .verdict import Verdict, judge


def law_alone(law: Block) -> SymbolicLoop:
    """Return a law on symbols, all that feeds it an input."""
    return symbolic_loop(connect([law], external=list(law.input_ports)), jumps=True)


def law_gains(law: Block, N: int) -> tuple[list[sympy.Expr], bool]:
    """Return the gains with which a law adapts alpha, K and Gamma, and whether V fits it.

    For alpha, row by row, K and Gamma they are the factors of -e phi, -e z and e zc in the rates,
    without their sign, in the symbols of the law's parameters; 1 where there is none.  V fits
    where each that is not held has one, and a V of squares can judge what is beside it; else V
    is no more than a guess, and refutes nothing.
    """
    loop = law_alone(law)
    values = own_values(loop, [law])
    refuse_no_value(loop, law.name)
    nothing = np.zeros(2 * N, dtype=object)
    e, apart = np.array([sympy.Function(f"e_{i}", real=True)(TIME) for i in (1, 2)]), {}
    if {"x", "z"} <= set(loop.inputs):  # e may be written x - z
        apart = dict(zip(loop.inputs["x"], e + loop.inputs["z"], strict=True))
    gains: list[sympy.Expr] = []
    rests: dict[sympy.Expr, sympy.Expr] = {}
    fitted = True
    for port, signal, size in (("alpha", "phi_x", N), ("K", "z", 1), ("Gamma", "zc", 1)):
        with_ = loop.inputs.get(signal, nothing)
        states = np.ravel(loop.states.get(port, nothing[: 2 * size]))
        for j, state in enumerate(states):
            i, k = (divmod(j, N)) if port == "alpha" else (j, j)
            product, rate = e[i] * with_[k], sympy.Integer(0)
            if state != 0:
                rate = tidied(loop.motion[state].xreplace(apart))
            factor = _factor(rate, product, set(values)) if product != 0 else product
            number = sympy.sympify(factor).xreplace(values)
            positive, negative = number.is_positive, number.is_negative
            fitted &= bool(positive or negative or rate == 0)
            gains.append(factor if positive else -factor if negative else sympy.Integer(1))
            rests[state] = sympy.expand(rate - factor * product) / gains[-1]
    rests.pop(sympy.Integer(0), None)
    given = [s for port, symbols in loop.inputs.items() if port != "e" for s in symbols.flat]
    held = {s: sympy.Dummy(real=True) for s in given}
    rests = {s: rest.xreplace(held) for s, rest in rests.items()}
    return gains, fitted and _judged_by_squares(rests, {*values, *held.values()})


def _judged_by_squares(rests: dict, known: set) -> bool:
    """Return whether a V of squares can judge what a law has beside its gains.

    It cannot where that holds e or time, as gains that change do, or states of the law's
    own, which need not come to every value, or where it weighs the errors in another way.
    """
    if any(rest.free_symbols - set(rests) - known for rest in rests.values()):
        return False
    slopes = {(a, b): sympy.diff(rest, b) for a, rest in rests.items() for b in rests}
    return all(sympy.expand(slope - slopes[b, a]) == 0 for (a, b), slope in slopes.items())


def _factor(rate: sympy.Expr, product: sympy.Expr, parameters: set) -> sympy.Expr:
    terms = (term / product for term in sympy.Add.make_args(rate))
    return sympy.Add(
        *(q for q in terms if not q.atoms(AppliedUndef) and q.free_symbols <= parameters)
    )


@public
def prove(
    law_block: Block | Diagram, V: Block | None = None, points: int = 10_000, seed: Seed = 0
) -> Verdict:
    """Judge an adaptive law by V' along the closed loop.

    Parameters
    ----------
    law_block : Block or Diagram
        With outputs alpha[2N], K[2], Gamma[2] and inputs among the diagram's ports, such
        as e[2], phi_x[N], z[2], zc[2]; or a `closed_loop` with such a law, and nothing else of
        your own.
    V : Block, optional
        A candidate with the output V[1]; by default Eq. (24), each error weighed by the
        gain with which the law adapts it.
    points : int, optional
        Random points at which the running blocks are called.
    seed : int, optional
        Of the random points.

    Returns
    -------
    Verdict
        `status`: ``"proved"``, ``"bounded"``, ``"refuted"`` or ``"open"``; `residual`, what V'
        has beyond -e^T KD e; `point`, where V' > 0; and the `steps` that were tried. A law whose
        states jump is only ``"proved between jumps"`` where V may rise at a jump.

    Raises
    ------
    DiagramError
        If the law does not make alpha[2N], K[2] and Gamma[2], or has the name of a block that
        holds the truth.
    BlockError
        If its equations cannot be read.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.blocks.laws.table import LAWS
    >>> clpt.theory.prove(LAWS["learned-flow"].of(2, gain=0.5), points=200).status
    'proved'
    """
    if V is not None and V.output_ports != {"V": 1}:
        raise DiagramError(f"{V.name}: a candidate makes V[1] and nothing else")
    if isinstance(law_block, Diagram) and law_block.made_of is not None:
        made = loop_of(law_block)
        if made.changes.in_words:
            raise DiagramError(
                f"{law_block.name}: has parts of your own, {made.changes.in_words}; a law is "
                "judged in the paper's own diagram, with no other part replaced or inserted"
            )
        law_block = made.changes.law or made.scenario.law_block
    if isinstance(law_block, control.InputOutputSystem) and not isinstance(law_block, Block):
        raise DiagramError(
            f"{law_block.name}: is a {type(law_block).__name__}; a law is judged in the paper's "
            "own diagram, give it as a Block; other parts, replaced or inserted, are not judged"
        )
    for field in law_block.parameters._fields:
        if paper_name(law_block.name, field) not in (None, "gamma"):
            raise DiagramError(
                f"{law_block.name}: its parameter {field} would be taken for what the paper's "
                "block of this name holds, which no law knows; give the law another name"
            )
    for block in filter(None, (law_block, V)):
        read_anew(block)
    N = functions_of(law_block)
    diagram = theorem_loop(N, "learned-flow", law_block=law_block, candidate=V)
    try:
        return _judged(diagram, law_block, V, N, points, seed)
    except ClptError:
        raise
    except Exception as error:  # whatever SymPy says of these equations
        kind = type(error).__name__
        raise DiagramError(f"{law_block.name}: V' cannot be worked out: {kind}: {error}") from None


def _judged(
    diagram: Diagram, law: Block, V: Block | None, N: int, points: int, seed: int
) -> Verdict:
    candidate, fitted = V, False  # one V that does not fall refutes no law
    gains: list[sympy.Expr] = []
    if candidate is None:
        alone = law_alone(law)
        own = own_values(alone, [law])
        gains, fitted = law_gains(law, N)
        numbers = [float(gain.subs(own)) for gain in gains]
        alpha, (K, Gamma) = np.reshape(numbers[:-4], (2, N)), np.reshape(numbers[-4:], (2, 2))
        scenario = theorem_scenario(N, "learned-flow")
        candidate = theorem_candidate(scenario, gain=alpha, gain_K=K, gain_Gamma=Gamma)
        diagram = theorem_loop(N, "learned-flow", law_block=law, candidate=candidate)
    loop = symbolic_loop(diagram, jumps=True)
    if gains:  # in the names of the whole diagram
        here, there = (flat(one.parameters[law.name]) for one in (alone, loop))
        gains = [gain.subs(dict(zip(here, there, strict=True))) for gain in gains]
    return judge(Case(diagram, loop, candidate, law, gains, fitted, points, seed))
