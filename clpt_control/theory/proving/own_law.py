"""Prove an adaptive law of your own, or see where it fails.

The law is a block that takes any of the diagram's signals and makes alpha, K, Gamma.  By default
V is Eq. (24), each error weighed by the gain with which the law adapts it (`law_gains`); what
V' along the closed loop says is judged in `verdict`.
"""

import control
import numpy as np
import sympy

from ...arguments import Seed, public
from ...diagrams.interconnection import Diagram
from ...diagrams.parts import functions_of
from ...diagrams.wiring import read_anew
from ...equations.block import Block
from ...errors import ClptError, DiagramError
from ...simulation.loops import loop_of
from .law_case import Case, flat
from .law_gains import law_alone, law_gains, own_values
from .paper_symbols import paper_name
from .symbolic_loop import symbolic_loop
from .theorem_loop import theorem_candidate, theorem_loop
from .verdict import Verdict, judge


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
        law_block = made.changes.law or made.scenario.learning.row.block(made.scenario.known_to_law)
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
        parts = (np.reshape(numbers[: 2 * N], (2, N)), *np.split(np.array(numbers[2 * N :]), 2))
        candidate = theorem_candidate(N, "learned-flow", 1.0, parts)
        diagram = theorem_loop(N, "learned-flow", law_block=law, candidate=candidate)
    loop = symbolic_loop(diagram, jumps=True)
    if gains:  # in the names of the whole diagram
        here, there = (flat(one.parameters[law.name]) for one in (alone, loop))
        gains = [gain.subs(dict(zip(here, there, strict=True))) for gain in gains]
    return judge(Case(diagram, loop, candidate, law, gains, points, seed), fitted)
