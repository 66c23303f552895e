"""`prove`: judge an adaptive law by V' along the paper's closed loop.

The law is a block that takes any of the diagram's signals and makes alpha, K, Gamma.  V is that of
`default_candidate`, or the user's; `judge` asks the five questions.  A law whose states have
invariants is proved by the steps of `invariants`.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import control
import numpy as np

from ...base.arguments import Count, Seed, public
from ...base.errors import DiagramError
from ...engine.diagram.interconnection import Diagram
from ...engine.diagram.wiring import read_anew
from ...engine.model.block import Block
from ...paper.laws.law import Law
from ...paper.scenario.experiment import Scenario
from ...simulation.loops import loop_of
from ...simulation.user_parts import functions_of
from ...simulation.user_parts import law_block as as_law_block
from ..promises import truth_of
from .default_candidate import LawV, default_V, user_V
from .invariant_loop import InvariantLoop
from .invariants import invariant_steps
from .judge import Verdict, judge
from .law_candidate import LawCandidate
from .paper_symbols import paper_name
from .steps import first_failure, worked_out
from .symbolic_loop import flat, symbolic_loop
from .theorem_loop import rate_of_V, theorem_loop, theorem_scenario, tied, truth_in

SLOWER = ", where the flow stays slower than the vehicle (hedging)"
ANY = "clpt.theory.lyapunov(diagram, V) judges a V of your own on any diagram"


@public
def prove(
    law_block: Block | Diagram | control.NonlinearIOSystem,
    V: Callable[..., Any] | None = None,
    points: Count = 10_000,
    seed: Seed = 0,
    invariants: Callable[..., dict] | None = None,
    semidefinite: Sequence[str] = (),
    losses: Callable[..., list[tuple]] | None = None,
    start: Mapping[str, Any] | None = None,
) -> Verdict:
    """Prove or refute an adaptive law by V' along the closed loop.

    Parameters
    ----------
    law_block : Block, control.NonlinearIOSystem or Diagram
        With outputs alpha[2N], K[2], Gamma[2] and inputs among the diagram's ports, such
        as e[2], phi_x[N], z[2], zc[2]; or a `closed_loop` with such a law, and nothing else of
        your own, nor a disturbance, noise, held gains or a limit of the speed without hedging.
    V : callable, optional
        A function of signals, as `lyapunov` takes it: ``lambda s: s.e @ s.e / 2 + ...``, which
        may ask for signals of the loop (``s.e``, ``s.alpha``, ``s.K``, ...), the truth
        (``s.theta``, ``s.KD``, ``s.GammaD``) and the law's parameters. Or a function of the truth,
        ``V(truth)`` or ``V(truth, parameters)``, that makes a Block with the output V[1].
        By default Eq. (24), each error weighed by the gain with which the
        law adapts it, or by the inverse of a matrix of gains.
    points : int, optional
        Random points at which the running blocks are called.
    seed : int, optional
        Of the random points.
    invariants : callable, optional
        ``invariants(states, parameters, truth)``, state -> what it is in the others, where they
        begin so; V' is then -e^T KD e less `losses`, and V has to be given.
    start : mapping, optional
        Initial values of the law's own states, by name, from which `invariants` hold. Default: 0.
    semidefinite : sequence of str, optional
        States that are symmetric positive semidefinite matrices; where V weighs errors by one,
        that it begins positive definite.
    losses : callable, optional
        ``losses(states, parameters, truth)``, what V' loses: products, tuples of factors that are
        not negative.

    Returns
    -------
    Verdict
        `status`: ``"proved"``, ``"bounded"``, ``"refuted"`` or ``"open"``; `residual`, what V'
        has beyond its fall; `point`, where V' > 0; and the `steps` that were tried. A law whose
        states jump is ``"refuted at a jump"`` where V rises there, however far off, and only
        ``"proved between jumps"`` where nothing is known of V there.

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
    >>> from clpt_control.paper.laws.table import LAWS
    >>> clpt.theory.prove(LAWS["learned-flow"].of(2, gain=0.5), points=200).status
    'proved'
    """
    if isinstance(law_block, Diagram) and law_block.origin is not None:
        loop = loop_of(law_block)
        if beside := loop.changes.description or _changes_of_V(loop.scenario):
            raise DiagramError(
                f"{law_block.name}: has {beside}, so V' is not its law's alone; a law is judged in "
                f"the paper's own diagram without, or give it as a Block; {ANY}"
            )
        law_block = loop.changes.law or loop.scenario.law_block
        if loop.scenario.vehicle.max_speed is not None:
            more = (V, points, seed, invariants, semidefinite, losses, start)
            verdict = prove(law_block, *more)
            return replace(verdict, claim=f"{verdict.claim}{SLOWER}")
    if isinstance(law_block, control.NonlinearIOSystem):
        law_block = as_law_block(law_block)
    if not isinstance(law_block, Block):
        raise DiagramError(
            f"{law_block.name}: is a {type(law_block).__name__}; a law is judged in the paper's "
            f"own diagram, give it as a Block; {ANY}"
        )
    for field in law_block.parameters._fields:
        if paper_name(law_block.name, field) not in (None, "gamma"):
            raise DiagramError(
                f"{law_block.name}: its parameter {field} would be taken for what the paper's "
                "block of this name holds, which no law knows; give the law another name"
            )
    read_anew(law_block)
    N = functions_of(law_block)
    theorem_loop(N, "learned-flow", law_block=law_block)  # refuses what is no law
    with worked_out(law_block.name):
        if invariants is None:  # one V that does not fall refutes no law
            law_V = default_V(law_block, N) if V is None else user_V(V, law_block)
            return judge(_candidate(law_block, N, law_V, points, seed))
        if V is None:
            raise DiagramError(
                f"{law_block.name}: a law whose states keep relations needs its V"
            )
        make = user_V(V, law_block).make
        part = {
            "invariants": invariants,
            "semidefinite": semidefinite,
            "losses": losses,
        }
        row = Law(law_block.name, rates=law_block.values, V_rate="-e^T KD e - losses")
        row = row.with_parts(part)
        case = InvariantLoop(row, N, blocks=(law_block, make), start=start or {})
        steps, (apart, existing) = (
            invariant_steps(row, points, case, seed),
            case.existing(),
        )
        failed = first_failure(steps)
        known = "proved" if existing.holds else f"proved {apart}"
        return Verdict(
            "open" if failed else known,
            failed or f"V' = {row.V_rate}",
            case.V,
            rate_of_V(case.loop).xreplace(case.tied),
            steps=(*steps, existing),
            residual=case.beside,
            diagram=case.loop.diagram,
        )


def _changes_of_V(scenario: Scenario) -> str:
    """Return what of a scenario adds to V' of its law, or takes from it, or nothing."""
    flow, fixes, limit = (
        scenario.flow,
        scenario.localization,
        scenario.vehicle.max_speed,
    )
    adds = {
        "a disturbance": flow.disturbance is not None,
        "a measured flow": flow.field is not None,
        "noise in its positions": fixes is not None and fixes.noise > 0,
        "a limit of its speed without hedging": limit is not None
        and not scenario.hedged,
        "K and Gamma that are held": not scenario.learning.adapt_gains,
    }
    return next((what for what, has in adds.items() if has), "")


def _candidate(law: Block, N: int, law_V: LawV, points: int, seed: int) -> LawCandidate:
    """Return a law with its V on the symbols of the theorems' loop."""
    true = truth_of(theorem_scenario(N, "learned-flow"))
    V = law_V.make(true)
    diagram = theorem_loop(N, "learned-flow", law_block=law, candidate=V)
    loop = symbolic_loop(diagram, jumps=True)
    known = tied(loop, V, law_V.make, (true, truth_in(loop)))
    if law_V.gains is not None:
        p = loop.parameters[V.name]
        is_matrix = "inverse" in p._fields
        fields = ("inverse",) if is_matrix else ("gain", "gain_K", "gain_Gamma")
        symbols = [s for field in fields for s in np.ravel(getattr(p, field))]
        weights = law_V.gains(flat(loop.parameters[law.name]))
        known |= zip(symbols, weights, strict=True)
    return LawCandidate(loop, V, law, known, law_V.fitted, points, seed)
