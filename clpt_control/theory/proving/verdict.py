"""The verdict on an adaptive law, of V' along the closed loop with the law in it.

    V' = -e^T KD e + residual

If the residual is never positive, V falls and e goes to zero as in Theorem 3.2.  Where the residual
pulls back but for a constant, V' is bounded.  Else a search looks for points at which the running
blocks themselves have V' > 0.  A law that is right but for a bounded term has V' > 0 near
the truth; one that is wrong has it however far off.  So a point counts where V' > 0 also ten and a
hundred times as far from the truth, and V' grows with V.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy

from ...engine.diagram.interconnection import Diagram
from ...html import facts, fragment
from .law_case import Case
from .leaks import Bounding
from .proof import Step, exact, first_failure, short
from .running_rate import FARTHER, SURE, running_step, search_of
from .symbolic_loop import Point

HIDDEN = {"flow_x": "the true flow", "V": "made of the truth"}
# points for each jump of a law, and until when jumps are looked for
TRIED, UNTIL = (300, 1000.0)


def refuting_point(case: Case) -> tuple[Point, float] | None:
    """Return a point with V' > 0, and V' of the running blocks there, or None."""
    search = search_of(case.loop, case.truth, case.seed)
    held = np.array([s not in search.rest for s in search.states])
    return next(search.rises_far_off(case.rate, held), None)


def point_below_truth(case: Case) -> tuple[Point, float] | None:
    """Return a point at which V of the blocks is below V at the truth, and by how much."""
    search = search_of(case.loop, case.truth, case.seed)
    for point in search.highest(case.Vs.xreplace(case.truth) - case.Vs, still=True):
        _, _, V = search.rates_at(point, search.farther(point.x, (1.0, 0.0)))
        if V[1] - V[0] > SURE * np.abs(V).max():
            return point, float(V[1] - V[0])
    return None


def rising_jump(case: Case) -> tuple[Point, Point, float] | None:
    """Return where V of the running blocks rises at a jump, before and after it, and by how much.

    V rises there at all distances, the more the farther off.  It does not at a jump that forgets a
    share of everything: errors stay bounded by that.
    """
    search = search_of(case.loop, case.truth, case.seed)
    sweep = search.blocks.sweep
    for t in sweep.breakpoints(0.0, UNTIL)[: len(FARTHER)].tolist():
        sweep.enter(t)
        _, states, inputs = search.draw(TRIED, still=False)
        before = np.concatenate([search.farther(x, FARTHER) for x in states.T])
        fed, at = np.repeat(inputs.T, len(FARTHER), axis=0), np.full(len(before), t)
        pairs = zip(before, fed, strict=True)
        after = np.array([sweep.jump(t, one, u, sweep.jumping) for one, u in pairs])
        V = [search.blocks.by_records(at, s, fed)[1] for s in (before, after)]
        rises = np.reshape(V[1] - V[0], (TRIED, -1))
        sure = np.all(rises > SURE * np.abs(V[0]).reshape(rises.shape), axis=1)
        for k in np.flatnonzero(sure & (rises[:, -1] >= 10 * rises[:, 0]))[:1]:
            near = [Point(t, s[k * len(FARTHER)], inputs.T[k]) for s in (before, after)]
            return near[0], near[1], float(rises[k, 0])
    return None


@dataclass(frozen=True)
class Verdict:
    """What is known of V' under a law or along a diagram.

    Attributes
    ----------
    status : str
        Of a law ``"proved"``: V' <= -e^T KD e, or -sum KD_i e_i dV/de_i, or half of it;
        ``"bounded"``: the same and a bounded term, or e comes to dead zones of V; ``"refuted"``:
        the running blocks give V' > 0 at `point`, however far from the truth; ``"refuted at a
        jump"``: V of the running blocks rises from `point`, right before it, to `after`.
        Of a V ``"proved"``: V holds the states and V' <= 0; ``"proved in a region"``: V' < 0 below
        `level`; ``"refuted"``: there is a `point` at which V' > 0, V' is not as claimed, or V is no
        least value.
        ``"open"``: none of these is known. With what is beside it: ``"proved but for z"``, where V
        does not hold z, which may grow; ``"proved as long as z exist"``, where z may grow without
        end; ``"proved where d = 0"``, of an input that V' depends on; ``"proved between jumps"``
        where states jump, and V is not known not to rise there.
    claim : str
        What is shown of V', or the set that V or e comes to, or where it fails.
    V, rate : sympy.Expr or None
        V, and V'; of a diagram in its own signals. None where no V was found.
    inputs : tuple of str
        Inputs that V' depends on.
    steps : tuple of Step
        What was tried, and how.
    point : Point or None
        Of a refutation: ``system.dynamics(*point)``, of a law ``diagram.dynamics(*point)``.
    value : float or None
        What V', or what fails, is there.
    level : sympy.Expr, float or None
        Of a region: what begins in the box where V, less its value at rest, is below comes to rest.
        Of a law that is bounded: V of the set that it comes to, where there is one, in theta, KD,
        GammaD and Delta_1, Delta_2, the largest disturbance of each axis.
    residual : sympy.Expr
        Of a law: V' less its fall, V' + e^T KD e, multiplied out.
    diagram : Diagram or None
        The closed loop with the law, V its last output.
    for_every_N : bool
        Whether it is proved for every number of basis functions.
    after : Point or None
        Of a law refuted at a jump: where it jumps to.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.blocks.laws.table import LAWS
    >>> wrong = LAWS["learned-flow"].of(1, gain=-0.5)
    >>> verdict = clpt.theory.prove(wrong, points=200)
    >>> verdict.status, verdict.value > 0
    ('refuted', True)
    """

    status: str
    claim: str
    V: sympy.Expr | None
    rate: sympy.Expr | None
    inputs: tuple[str, ...] = ()
    steps: tuple[Step, ...] = ()
    point: Point | None = None
    value: float | None = None
    level: Any = None
    residual: sympy.Expr = sympy.S.Zero
    diagram: Diagram | None = None
    for_every_N: bool = False
    after: Point | None = None

    def __repr__(self) -> str:
        return f"<Verdict {self.status}: {self.claim}>"

    def _repr_html_(self) -> str:
        rows = [
            (s.claim, "holds" if s.holds else "not shown", s.how, s.detail)
            for s in self.steps
        ]
        table = facts(rows, ("claim", "", "how", "detail"))
        return fragment("Verdict", f"{self.status}: {self.claim}", table)


def verdict_of(case: Case) -> Verdict:
    """Return the verdict on a law; V' > 0 refutes it only where V was fitted to it."""
    definite, total = case.definite(), case.valued()
    (falls, fall), zones = case.settled(), any(case.zones)
    below = f"V' {'=' if case.residual == 0 else '<='} {fall}"
    left = "" if case.residual == 0 else f"left over: {short(case.residual)}"
    left = left if case.rises else "V is not known to rise with |e|"
    sizes = f"N = {case.N} and the parameters as they are"
    steps = [definite, total, exact(f"{below}, {sizes}", falls, left)]
    bound = None
    if definite.holds and not (falls or zones):
        bound = Bounding(case).bound()
    elif falls and zones:
        bound = case.comes_to_zones(fall)
    if definite.holds and total.holds and (falls or bound is not None):
        steps.append(
            running := running_step(lambda: case.loop, case.points, seed=case.seed)
        )
        if running.holds and bound is not None:
            steps.append(exact(bound.sentence, True))
            return _complete(case, "bounded", bound.sentence, steps, level=bound.level)
        if running.holds:
            steps.append(every := case.every())
            claim = f"{below}, so CLPE goes to zero"
            return _complete(case, "proved", claim, steps, for_every_N=every.holds)
    failed = first_failure(steps)
    if definite.holds and case.refutes:
        found = refuting_point(case)
        claim = (
            "the running blocks give V' > 0, ten and a hundred times as far off as well"
        )
        detail = "no such point was found" if found is None else f"V' = {found[1]:.3g}"
        steps.append(Step(claim, found is not None, "counterexample", detail, False))
        if found is not None:
            where = {"point": found[0], "value": found[1]}
            return _complete(case, "refuted", f"{detail} at `point`", steps, **where)
    below = None if definite.holds else point_below_truth(case)
    if below is not None:
        claim = f"V is {below[1]:.3g} below its value at the truth at `point`"
        steps.append(Step(claim, True, "counterexample", "", False))
        where = {"point": below[0], "value": -below[1]}
        return _complete(case, "refuted", claim, steps, **where)
    return _complete(case, "open", failed, steps)


def _complete(
    case: Case, status: str, claim: str, steps: list[Step], **more: Any
) -> Verdict:
    """Return a verdict with the steps about its inputs, other states and jumps."""
    known = status in ("proved", "bounded")
    for port in (one for one in HIDDEN if one in case.law.input_ports):
        hidden = (
            f"the law reads {port}, {HIDDEN[port]}, which no vehicle measures by itself"
        )
        steps = [*steps, exact(hidden, True)]
    if known and case.others:
        apart, existing = case.existing()
        steps = [*steps, existing]
        status = f"{status} {apart}" if apart else status
    if case.loop.jumps:
        steps = [*steps, case.across_jumps()]
        if known and not steps[-1].holds:
            jump = rising_jump(case) if case.refutes else None
            status = f"{status} between jumps"
            if jump is not None:
                status, more = "refuted at a jump", {"point": jump[0], "after": jump[1]}
                claim = "the running blocks' V rises at a jump, ten and a hundred times as far off"
                steps += [
                    Step(claim, True, "counterexample", f"by {jump[2]:.3g}", False)
                ]
    law: dict[str, Any] = {
        "residual": case.residual,
        "diagram": case.loop.diagram,
        **more,
    }
    return Verdict(status, claim, case.Vs, case.rate, steps=tuple(steps), **law)
