"""One judge for a function V on the equations of a law's loop or of any system.

`clpt.prove` and `clpt.lyapunov` are two short callers.  A verdict is five questions,
each a step with its evidence:

1. Have V and the equations a value everywhere, and are they what runs?
2. Is V positive definite?
3. Does V' <= 0 hold, or a bound of V?
4. Do the states that V does not contain exist for all times?
5. Does V rise where states jump?

A V that fails is refuted by a point at which the running blocks show it; otherwise it is open.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import sympy

from ...base.html import facts, fragment
from ...engine.diagram.interconnection import Diagram
from ...engine.diagram.symbolic_equations import Equations
from .states_outside_V import states_outside_V
from .steps import Step, exact, first_failure, short
from .symbolic_loop import Point


@dataclass(frozen=True)
class Verdict:
    """Result of a judgement of V' under a law or along a diagram.

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
        ``"open"``: none of these is known. ``"proved but for z"``: V does not contain z, which may
        grow; ``"proved as long as z exist"``: z may grow without end; ``"proved where d = 0"``, of
        an input that V' depends on; ``"proved between jumps"`` where states jump, and V is not
        known not to rise there.
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
    >>> from clpt_control.paper.laws.table import LAWS
    >>> wrong = LAWS["learned-flow"].of(1, gain=-0.5)
    >>> verdict = clpt.prove(wrong, points=200)
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


@dataclass(frozen=True)
class Fall:
    """Proof that V falls along the equations, or is bounded."""

    steps: list[Step]
    status: str = "proved"  # "bounded", "proved where u = 0"
    claim: str = ""
    level: Any = None
    remarks: list[Step] = field(default_factory=list)  # steps that may fail


class Refutation(NamedTuple):
    """A point at which the running blocks show that V fails."""

    claim: str
    step: Step
    point: Point
    value: float | None
    status: str = "refuted"
    after: Point | None = None


class Candidate(ABC):
    """A function V on equations, and what is asked of it."""

    eq: Equations

    @abstractmethod
    def has_values(self) -> Step:
        """Return the step that V and the equations have a value everywhere."""

    @abstractmethod
    def is_definite(self) -> Step:
        """Return the step that V is positive definite."""

    @abstractmethod
    def fall(self) -> Fall:
        """Return what is shown of V'; called after `is_definite`."""

    @abstractmethod
    def same_as_running(self) -> Step:
        """Return the step that the running blocks have the same V and rates."""

    @abstractmethod
    def held(self) -> tuple[list[sympy.Expr], dict]:
        """Return forms that V bounds, and what symbols are."""

    @abstractmethod
    def never_positive(self, expression: sympy.Expr) -> bool:
        """Return whether an expression is known never to be positive."""

    @abstractmethod
    def rises_at_jumps(self) -> list[sympy.Expr]:
        """Return by how much V rises at each set of jumps."""

    @abstractmethod
    def refuted(self, steps: list[Step]) -> Refutation | None:
        """Return a point that refutes V, of the steps that fail."""

    @abstractmethod
    def refuted_at_jump(self, rise: sympy.Expr) -> Refutation | None:
        """Return a point at which V rises at a jump."""

    @abstractmethod
    def verdict(self, status: str, claim: str, **known: Any) -> Verdict:
        """Return a verdict on this candidate."""


def judge(candidate: Candidate, refute: bool = True) -> Verdict:
    """Return the verdict on a candidate V; if `refute`, look for a point that refutes V."""
    steps = [candidate.has_values(), candidate.is_definite()]
    fall = candidate.fall()
    steps += fall.steps
    if not first_failure(steps):
        steps.append(candidate.same_as_running())
    if failed := first_failure(steps):
        refutation = candidate.refuted(steps) if refute else None
        if refutation is not None:
            return refuted(candidate, refutation, steps)
        return candidate.verdict("open", failed, steps=steps)
    steps += fall.remarks
    outside, existence = states_outside_V(*candidate.held(), candidate.eq)
    status = [fall.status, outside]
    steps.append(existence)
    if candidate.eq.jumps:
        step, rise = jumps(candidate)
        steps.append(step)
        refutation = None if step.holds else candidate.refuted_at_jump(rise)
        if refutation is not None:
            return refuted(candidate, refutation, steps)
        status += [] if step.holds else ["between jumps"]
    return candidate.verdict(
        " ".join(filter(None, status)), fall.claim, level=fall.level, steps=steps
    )


def refuted(candidate: Candidate, found: Refutation, steps: list[Step]) -> Verdict:
    """Return the verdict on a candidate that a point refutes."""
    return candidate.verdict(
        found.status,
        found.claim,
        steps=[*steps, found.step],
        point=found.point,
        value=found.value,
        after=found.after,
    )


def jumps(candidate: Candidate) -> tuple[Step, sympy.Expr]:
    """Return the step that V rises at no jump, and by how much it rises where that fails."""
    claim = f"V does not rise where states of {' and '.join(candidate.eq.jumps)} jump"
    for rise in candidate.rises_at_jumps():
        if not candidate.never_positive(rise):
            return exact(claim, False, f"V changes by {short(rise)}"), rise
    return exact(claim, True), sympy.S.Zero
