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

from ...diagrams.interconnection import Diagram
from ...html import facts, fragment
from .law_case import Case
from .leaks import Bounding
from .proof import Step, as_html, exact, short
from .running_rate import SURE, PointSearch
from .symbolic_loop import Point

FARTHER = (1.0, 10.0, 100.0)
HIDDEN = {"flow_x": "the true flow", "V": "made of the truth"}
TRIED, UNTIL = 300, 1000.0  # points for each jump of a law, and until when jumps are looked for


def refuting_point(case: Case) -> tuple[Point, float] | None:
    """Return a point with V' > 0, and V' of the running blocks there, or None."""
    search = search_of(case)
    for point in search.highest(case.rate, still=False):
        rises, size, V = search.rates_at(point, search.farther(point.x, FARTHER))
        positive = np.all((rises > SURE * size) & (V > 0))
        if positive and rises[-1] / V[-1] >= 0.5 * rises[0] / V[0]:
            return point, float(rises[0])
    return None


def rising_jump(case: Case) -> tuple[Point, Point, float] | None:
    """Return where V of the running blocks rises at a jump, before and after it, and by how much.

    V rises there at all distances, the more the farther off.  It does not at a jump that forgets a
    share of everything: errors stay bounded by that.
    """
    search = search_of(case)
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
            near = [Point(t, s[k * len(FARTHER)], inputs.T[k], {}) for s in (before, after)]
            return near[0], near[1], float(rises[k, 0])
    return None


def search_of(case: Case) -> PointSearch:
    """Return the search for points, about the truth."""
    V = case.loop.signals["V"][0]
    return PointSearch(case.diagram, case.loop, V, "V[0]", case.truth, case.seed)


@dataclass(frozen=True)
class Verdict:
    """What is known of V' under a law.

    Attributes
    ----------
    status : str
        ``"proved"``: V' <= -e^T KD e, or -sum KD_i e_i dV/de_i, or half of it; ``"bounded"``:
        the same and a bounded term, or e comes to dead zones of V; ``"refuted"``: the running
        blocks give V' > 0 at `point`, however far from the
        truth; ``"open"``: none of these is known. ``"proved between jumps"`` and ``"bounded
        between jumps"`` where states jump, and V is not known not to rise there; ``"refuted at a
        jump"`` where the running blocks' V rises from `point`, right before it, to `after`;
        ``"proved as long as s exist"`` where a state that V does not hold may grow without end.
    residual : sympy.Expr
        V' less its fall, V' + e^T KD e, multiplied out.
    steps : tuple of Step
        What was tried.
    diagram : Diagram
        The closed loop with the law, V its last output.
    for_every_N : bool
        Whether it is proved for every number of basis functions.
    point : Point or None
        Where V' > 0: ``diagram.dynamics(*point)`` and ``diagram.output(*point)``.
    after : Point or None
        Of a law refuted at a jump: where it jumps to.
    rate : float or None
        V' there, length squared per time.
    reached : str
        For ``"bounded"``: the set that V comes to, or the mean square of e.
    level : sympy.Expr or None
        V of that set, where there is one, in theta, KD, GammaD and Delta_1, Delta_2, the largest
        disturbance of each axis.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.blocks.laws.table import LAWS
    >>> wrong = LAWS["learned-flow"].of(1, gain=-0.5)
    >>> verdict = clpt.theory.prove(wrong, points=200)
    >>> verdict.status, verdict.rate > 0
    ('refuted', True)
    """

    status: str
    residual: sympy.Expr
    steps: tuple[Step, ...]
    diagram: Diagram
    for_every_N: bool = False
    point: Point | None = None
    after: Point | None = None
    rate: float | None = None
    reached: str = ""
    level: sympy.Expr | None = None

    def __repr__(self) -> str:
        return f"<Verdict {self.status}{self._detail()}>"

    def _repr_html_(self) -> str:
        known = {"reached": self.reached, "V there": self.level, "left over": self.residual}
        more = [(name, short(value)) for name, value in known.items() if value not in (None, "", 0)]
        name = f"{self.status}{self._detail()}"
        return fragment("Verdict", name, as_html(self.steps), facts(more))

    def _detail(self) -> str:
        if self.rate is not None:
            return f": V' = {self.rate:.3g} at `point`"
        left = next((step for step in self.steps if not step.holds), None)
        if self.status == "open" and left is not None:
            return f": not shown: {left.claim}"
        if self.reached:
            return f": {self.reached}"
        return ", for every number of basis functions" if self.for_every_N else ""


def verdict_of(case: Case) -> Verdict:
    """Return the verdict on a law; V' > 0 refutes it only where V was fitted to it."""
    definite, total = case.definite(), case.valued()
    (falls, fall), zones = case.settled(), any(case.zones)
    at = " and the parameters as they are" if case.fixed else ""
    claim = f"V' {'=' if case.residual == 0 else '<='} {fall}, N = {case.N}{at}"
    left = "" if case.residual == 0 else f"left over: {short(case.residual)}"
    left = left if case.rises else "V is not known to rise with |e|"
    steps = [definite, total, exact(claim, falls, left)]
    bound = None
    if definite.holds and not (falls or zones):
        bound = Bounding(case).bound()
    elif falls and zones:
        bound = case.comes_to_zones(fall)
    if definite.holds and total.holds and (falls or bound is not None):
        steps.append(running := case.running())
        if running.holds and bound is not None:
            steps.append(exact(bound.sentence, True))
            return _complete(case, "bounded", steps, reached=bound.sentence, level=bound.level)
        if running.holds:
            every = case.every()
            return _complete(case, "proved", [*steps, every], for_every_N=every.holds)
    if definite.holds and case.refutes:
        found = refuting_point(case)
        claim = "the running blocks give V' > 0, ten and a hundred times as far off as well"
        detail = "no such point was found" if found is None else f"V' = {found[1]:.3g}"
        steps.append(Step(claim, found is not None, "counterexample", detail, False))
        if found is not None:
            return _complete(case, "refuted", steps, point=found[0], rate=found[1])
    return _complete(case, "open", steps)


def _complete(case: Case, status: str, steps: list[Step], **more: Any) -> Verdict:
    """Return a verdict with the steps about its inputs, other states and jumps."""
    known = status in ("proved", "bounded")
    for port in (one for one in HIDDEN if one in case.law.input_ports):
        claim = f"the law reads {port}, {HIDDEN[port]}, which no vehicle measures by itself"
        steps = [*steps, exact(claim, True)]
    if known and case.others:
        steps = [*steps, case.existing()]
        if not steps[-1].holds:
            status = f"{status} as long as {', '.join(case.others)} exist"
    if case.loop.jumps:
        steps = [*steps, case.across_jumps()]
        if known and not steps[-1].holds:
            jump = rising_jump(case) if case.refutes else None
            status = f"{status} between jumps"
            if jump is not None:
                status, more = "refuted at a jump", {"point": jump[0], "after": jump[1]}
                claim = "the running blocks' V rises at a jump, ten and a hundred times as far off"
                steps += [Step(claim, True, "counterexample", f"by {jump[2]:.3g}", False)]
    return Verdict(status, case.residual, tuple(steps), case.diagram, **more)
