"""Proof or refutation of an adaptive law by V' along the paper's closed loop.

The law is a block that reads any of the diagram's signals and returns alpha, K and Gamma.  V is
that of `default_candidate`, or the user's; `judge` asks the five questions.  A law whose states
have invariants is proved by the steps of `invariants`.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import control
import numpy as np

from ...base.arguments import Count, Seed, check_known, public
from ...base.errors import DiagramError
from ...engine.diagram.interconnection import Diagram
from ...engine.diagram.wiring import read_anew
from ...engine.model.block import Block
from ...paper.laws.law import Law
from ...paper.laws.table import LAWS
from ...paper.scenario.experiment import Scenario
from ...simulation.loops import loop_of
from ...simulation.user_components import functions_of
from ...simulation.user_components import law_block as as_law_block
from ..proofs.conclusions import Condition, for_sizes
from ..proofs.judge import Verdict, judge
from ..proofs.paper_symbols import paper_name
from ..proofs.proof import where_all_hold
from ..proofs.statements import said
from ..proofs.steps import exact_step, first_failure, of_user, worked_out
from .default_candidate import default_V, user_V
from .fixes import CHANGE, LARGEST_W, SIZES_AT_FIXES, fix_steps
from .invariants import Invariants
from .law_candidate import LawCandidate
from .paper_loop import KNOWN_ERROR, PaperLoop, known_flow_steps
from .theorem_loop import law_and_V, theorem_loop

SIZES = (1, 2, 3)  # numbers of functions
MIDDLE = 2  # of `SIZES`: the running blocks are compared for it
MEAN = said("`|e| <= |(theta - theta_hat) phi|` over the least of `KD`")
ANY = "clpt.lyapunov(diagram, V) judges a V of your own on any diagram"


@public
def prove(
    law_block: Block | Diagram | control.NonlinearIOSystem | str,
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
    law_block : Block, control.NonlinearIOSystem, Diagram or str
        The name of a law of the table; or a block with outputs alpha[2N], K[2], Gamma[2] and
        inputs among the diagram's ports, such as e[2], phi_x[N], z[2], zc[2]; or a `closed_loop`
        with such a law, without other parts of your own, a disturbance, noise, fixed gains or a
        speed limit without hedging.
    V : callable, optional
        A function of signals, as of `lyapunov`: ``lambda s: s.e @ s.e / 2 + ...``, which may read
        signals of the loop (``s.e``, ``s.alpha``, ``s.K``, ...), the truth (``s.theta``, ``s.KD``,
        ``s.GammaD``) and the law's parameters. Or a function of the truth, ``V(truth)`` or
        ``V(truth, parameters)``, that returns a Block with the output V[1].
        Default: Eq. (24), each error weighted by the inverse of the gain with which the law adapts
        it, or by the inverse of a matrix of gains.
    points : int, optional
        Random points at which the running blocks are called.
    seed : int, optional
        Seed of the random points.
    invariants : callable, optional
        ``invariants(states, parameters, truth)`` returns state -> its value in terms of other
        states, if they start so; V' is then -e^T KD e less `losses`, and `V` is required.
    start : mapping, optional
        Initial values of the law's states, by name, at which `invariants` hold. Default: 0.
    semidefinite : sequence of str, optional
        States that are symmetric positive semidefinite matrices; one that weights errors in V is
        positive definite at the start.
    losses : callable, optional
        ``losses(states, parameters, truth)`` returns what V' loses: products, as tuples of factors
        that are not negative.

    Returns
    -------
    Verdict
        `status`: ``"proved"``, ``"refuted"`` or ``"open"``; the `conclusion` with its
        `conditions`; `residual`, V' less its negative terms; `point`, at which V' > 0, or from
        which V rises at a jump; and the `steps` that were tried.

    Raises
    ------
    DiagramError
        If the name is unknown, the law does not return alpha[2N], K[2] and Gamma[2], or has the
        name of a block that contains the truth; or the equations of an `nlsys` cannot be traced.
    BlockError
        If the equations of a `Block` cannot be traced.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> clpt.prove("learned-flow", points=200).status
    'proved'
    """
    if isinstance(law_block, str):
        check_known("prove", [law_block], LAWS)
        row = LAWS[law_block]
        return verdict_on_row(row, points, law_and_V(row, MIDDLE)[0], seed)
    if isinstance(law_block, Diagram) and law_block.origin is not None:
        scenario, own_law = _law_of(law_block)
        learner, row = own_law or scenario.law_block, scenario.learning.row
        is_row = own_law is None and V is None and invariants is None
        if is_row and _has_signs_of(row, learner):
            verdict = verdict_on_row(row, points, learner, seed)
        else:
            arguments = V, points, seed, invariants, semidefinite, losses, start
            verdict = prove(learner, *arguments)
        is_limited = scenario.vehicle.max_speed is not None
        if not (is_limited and verdict.status == "proved"):
            return verdict
        conditions = (*verdict.conditions, Condition("slower flow"))
        return replace(verdict, conditions=conditions)
    block = _checked_law(law_block)
    N = functions_of(block)
    theorem_loop(N, "learned-flow", law_block=block)  # rejects other blocks
    with worked_out(block.name):
        if invariants is None:
            law_V = default_V(block, N) if V is None else user_V(V, block)
            return judge(LawCandidate(block, law_V, points, seed))
        if V is None:
            raise DiagramError(
                f"{block.name}: a law whose states keep relations needs its V"
            )
        declared = Law(block.name, rates=block.values, V_rate="-e^T KD e - losses")
        parts = {"semidefinite": semidefinite}
        for name, function in ("invariants", invariants), ("losses", losses):
            parts[name] = of_user(f"{block.name}: {name}", function)
        law = declared.with_parts(parts)
        blocks = block, user_V(V, block).make
        return judge(Invariants(law, N, points, seed, blocks, start or {}))


def verdict_on_row(law: Law, points: int, block: Block, seed: int = 0) -> Verdict:
    """Judge a law of the table with the V and the invariants of its row."""
    if law.at_fixes:  # CLPE does not go to zero between fixes
        where = (Condition("limits"),)
        steps = fix_steps(law, points)
        claim = said(f"V' = 0; at a fix V changes by `{CHANGE}, w = y - eta m`")
        bound = said(f"`({LARGEST_W})^2`")
        proof = where_all_hold(
            claim, steps, "definite", where, SIZES_AT_FIXES, bound=bound
        )
    elif law.given_estimate:
        steps = known_flow_steps(PaperLoop(law.name), points)
        proof = where_all_hold(KNOWN_ERROR, steps, "exists jumps", bound=MEAN)
    elif law.invariants is not None:
        return _judged_for_sizes(law, points, seed)
    else:
        return prove(block, lambda truth, p: law.V(p, truth), points, seed)
    return Verdict(**proof.judged)


def _judged_for_sizes(law: Law, points: int, seed: int) -> Verdict:
    """Judge a law with invariants for one N; its exact steps must hold for each of `SIZES`."""
    verdict = judge(Invariants(law, MIDDLE, points, seed))
    if verdict.status != "proved":
        return verdict
    cases = [Invariants(law, N, points, seed) for N in SIZES if N != MIDDLE]
    claim = "each exact step holds for " + " and ".join(case.sizes for case in cases)

    def missing(case: Invariants) -> str:
        return first_failure(case.exact_steps())

    step = exact_step(cases, claim, missing)
    if not step.holds:
        failed = first_failure([step])
        return Verdict("open", failed, V=verdict.V, rate=verdict.rate, steps=(step,))
    of_N = for_sizes(SIZES)
    conditions = (of_N if c.name == "N" else c for c in verdict.conditions)
    steps = *verdict.steps, step
    return replace(verdict, conditions=tuple(conditions), steps=steps)


def _has_signs_of(law: Law, block: Block) -> bool:
    """Return whether parameters have the signs that the proof of their law's row has."""
    of_row = law_and_V(law, 1)[0].parameters
    if block.parameters._fields != of_row._fields:
        return False  # as of a sampled law
    pairs = zip(block.parameters, of_row, strict=True)
    signs = ([{*np.sign(np.ravel(v)).tolist()} for v in pair] for pair in pairs)
    return all(
        own_signs <= row_signs or len(row_signs) > 1 for own_signs, row_signs in signs
    )


def _law_of(diagram: Diagram) -> tuple[Scenario, Block | None]:
    """Return the scenario and the own law of a closed loop; reject other terms in V'."""
    loop = loop_of(diagram)
    change = loop.changes.description or _changes_of_V(loop.scenario)
    if change:
        raise DiagramError(
            f"{diagram.name}: has {change}, so V' is not its law's alone; a law is judged in "
            f"the paper's own diagram without, or give it as a Block; {ANY}"
        )
    return loop.scenario, loop.changes.law


def _checked_law(law: Block | Diagram | control.NonlinearIOSystem) -> Block:
    """Return a law as a block; reject diagrams and names that the truth has."""
    if isinstance(law, control.NonlinearIOSystem):
        law = as_law_block(law)
    if not isinstance(law, Block):
        raise DiagramError(
            f"{law.name}: is a {type(law).__name__}; a law is judged in the paper's own "
            f"diagram, give it as a Block; {ANY}"
        )
    for field in law.parameters._fields:
        if paper_name(law.name, field) not in (None, "gamma"):
            raise DiagramError(
                f"{law.name}: its parameter {field} would be taken for what the paper's "
                "block of this name holds, which no law knows. Give the parameter, or the "
                "block, another name"
            )
    read_anew(law)
    return law


def _changes_of_V(scenario: Scenario) -> str:
    """Return a part of a scenario that adds a term to V' of its law, or ""."""
    flow, fixes = scenario.flow, scenario.localization
    if flow.disturbance is not None:
        return "a disturbance"
    if flow.parameters is None:
        return "a flow of other functions" if flow.basis else "a measured flow"
    if fixes is not None and fixes.noise > 0:
        return "noise in its positions"
    if scenario.vehicle.max_speed is not None and not scenario.hedged:
        return "a limit of its speed without hedging"
    return "" if scenario.learning.adapt_gains else "K and Gamma that are held"
