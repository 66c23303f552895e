"""One judge for a function V on the equations of a law's loop or of any system.

`clpt.prove` and `clpt.lyapunov` are two short callers.  A verdict is a few questions, each a step
with its evidence:

1. Have V and the equations a value everywhere, and are they what runs?
2. Is V positive definite?
3. Does V' <= 0 hold, and what does V' lose; or is V bounded?
4. Do the states that V does not contain exist for all times?
5. Are the rates bounded of what V' loses; and what is left where V' = 0 for good?
6. Does V rise where states jump?

The conclusion is the first of `CONCLUSIONS` that the steps show.  A V that fails is refuted by a
point at which the running blocks show it; otherwise it is open.  In discrete time V' stands for
V(x+) - V(x).
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence, Set
from dataclasses import dataclass, field
from functools import cached_property, partial
from typing import Any, NamedTuple

import sympy

from ...base.html import facts, fragment
from ...engine.diagram.interconnection import Diagram
from ...engine.diagram.symbol_names import TIME
from ...engine.diagram.symbolic_equations import Equations
from ..algebra.decide import never_positive
from ..algebra.exact import normal_form, vanishes
from ..algebra.facts import is_continuous
from ..algebra.slopes import meets_smoothly
from ..algebra.sums_of_squares import Squares, contains_all, squares, zero_of
from ..algebra.texts import short
from .certified import written
from .conclusions import Condition, Judged, Status, concluded, go, theorem_and_proof
from .limits import Motion
from .steps import Step, exact, first_failure
from .symbolic_loop import Point


@dataclass(frozen=True)
class Verdict(Judged):
    """Result of a judgement of V' under a law or along a diagram.

    Attributes
    ----------
    status : str
        ``"proved"``: `conclusion` holds under `conditions`; ``"refuted"``: the running blocks show
        at `point` that V' > 0, that V' is above the claim, or that V is no least value; or V rises
        at a jump from `point` to `after`; ``"open"``: none of these is known.
    conclusion : str
        Of a proof: "goes to zero", "ultimately bounded", ...: a row of the table of docs/theory.md.
    conditions : tuple of Condition
        Where it holds: "for t >= 0", "where u = 0", "x is not in V, and bounded", ...
    claim : str
        What is shown of V', where it fails, or which step is missing.
    sentence : str
        The verdict in words, made of its fields.
    V, rate : sympy.Expr or None
        V, and V'; of a diagram in its own signals. In discrete time `rate` is by how much V
        changes. None where no V was found.
    inputs : tuple of str
        Inputs that V' depends on.
    steps : tuple of Step
        What was tried, and how.
    point : Point or None
        Of a refutation: ``system.dynamics(*point)``, of a law ``diagram.dynamics(*point)``.
    value : float or None
        V', or what fails, at the point.
    level : sympy.Expr, float or None
        V of the set that is reached, in theta, KD, GammaD and Delta_1, Delta_2, the largest
        disturbance of each axis; or a number below which what begins in the box comes to rest.
    residual : sympy.Expr
        Of a law: V' less its fall, V' + e^T KD e, multiplied out.
    diagram : Diagram or None
        The closed loop with the law, V its last output.
    for_every_N : bool
        Whether it is proved for every number of basis functions.
    after : Point or None
        Of a V that rises at a jump: where it jumps to.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.paper.laws.table import LAWS
    >>> wrong = LAWS["learned-flow"].of(1, gain=-0.5)
    >>> verdict = clpt.prove(wrong, points=200)
    >>> verdict.status, verdict.value > 0
    ('refuted', True)
    """

    V: sympy.Expr | None = None
    rate: sympy.Expr | None = None
    inputs: tuple[str, ...] = ()
    point: Point | None = None
    value: float | None = None
    residual: sympy.Expr = sympy.S.Zero
    diagram: Diagram | None = None
    after: Point | None = None
    ways: Callable[[], Any] = field(default=tuple, repr=False, compare=False)

    def certificate(self) -> dict | None:
        """Return what an outsider needs to check a proof, in exact rational numbers, or None.

        `tools/check_certificate.py` checks it; docs/certificates.md describes it.
        """
        return written(self.ways(), self.conditions)[0]

    def why_no_certificate(self) -> str:
        """Return the reason for which `certificate` is None, or ""."""
        return written(self.ways(), self.conditions)[1]

    def latex(self) -> str:
        r"""Return the verdict as a theorem and a proof in LaTeX.

        V, V', the conclusion, its conditions as assumptions, and the steps, for a paper.

        Examples
        --------
        >>> import clpt_control as clpt
        >>> lag = clpt.Block("lag", update=lambda t, x, u, p: {"x": -x.x}, states={"x": 1})
        >>> print(clpt.lyapunov(lag, lambda s: s.x**2 / 2).latex()[:45])
        \begin{theorem}
        Let
        \[ V = \frac{x^{2}}{2} \]
        """
        return theorem_and_proof(self, self.V, self.rate)

    def __repr__(self) -> str:
        return f"<Verdict {self.status}: {self.sentence}>"

    def _repr_html_(self) -> str:
        rows = [
            (s.claim, "holds" if s.holds else "not shown", s.how, s.detail)
            for s in self.steps
        ]
        table = facts(rows, ("claim", "", "how", "detail"))
        return fragment("Verdict", f"{self.status}: {self.sentence}", table)


@dataclass
class Fall:
    """Claims on V': it falls, and loses squares of forms; or V is bounded."""

    steps: list[Step]
    claim: str = ""  # V' <= -e^T KD e
    losses: Sequence[sympy.Expr] = ()  # forms of which V' loses multiples of squares
    bound: str = ""  # what is lost, as text: e^T KD e
    of: str = ""  # what goes to zero, as text: CLPE goes
    level: Any = None
    zeroed: Mapping[Any, Any] = field(default_factory=dict)  # inputs that are 0
    conditions: list[Condition] = field(default_factory=list)
    remarks: list[Step] = field(default_factory=list)  # steps that may fail


class Refutation(NamedTuple):
    """A point at which the running blocks show that V fails."""

    claim: str
    step: Step
    point: Point
    value: float | None
    after: Point | None = None


class LyapunovCandidate(ABC):
    """A function V on equations, and what is asked of it."""

    eq: Equations
    V: sympy.Expr
    rate: sympy.Expr  # V'
    motion: Mapping[Any, sympy.Expr]  # rates of the states that V is written in
    fixed: set  # symbols of parameters
    numbers: set | None = None  # those that signs may depend on; None: all
    rest: Mapping[Any, sympy.Expr] | None = (
        None  # where V is to be least, if that is given
    )
    undefined: list[str]  # sentences on where there may be no value
    forms: Sequence[sympy.Expr] = ()  # that V bounds
    least: Mapping[Any, sympy.Expr] | None = None  # the one point at which V is least
    exist: Set[Any] = frozenset()  # states that exist for all times, however they grow

    # --- the questions --------------------------------------------------------------------------

    def has_values(self) -> Step:
        """Return the step that V and the equations have a value everywhere."""
        claim = "V and the equations have a value everywhere"
        return exact(claim, not self.undefined, "".join(self.undefined[:1]), "values")

    def is_definite(self) -> Step:
        """Return the step that V is positive definite in forms of the states."""
        claim = "V is positive definite"
        expressions = self.V, *self.motion.values()
        bends = not meets_smoothly(self.V) and not all(map(is_continuous, expressions))
        if bends or self.V.free_symbols & self.intervals:
            return exact(claim, False, "V may jump or bend")
        rest_state = self.rest or {}
        moved = self.V.xreplace({s: s + v for s, v in rest_state.items()})
        total = squares(moved, self.fixed) or squares(moved, self.fixed, False)
        states = [*self.motion]
        if total and self.rest is not None:
            zero = dict.fromkeys(states, 0)
            total = total if all(vanishes(f.subs(zero)) for f in total.forms) else None
        if not total or not total.forms:
            return exact(claim, False, "not shown")
        back = {s: s - v for s, v in rest_state.items()}
        self.forms = [form.xreplace(back) for form in total.forms]
        contained = [s for s in states if any(form.has(s) for form in self.forms)]
        self.least = zero_of(total._replace(forms=self.forms), contained)
        names = ", ".join(dict.fromkeys(self.text(form) for form in self.forms))
        level = self.V.xreplace({s: sympy.Dummy(real=True) for s in states})
        holds_all = self.least is not None and len(contained) == len(states)
        holds_all = holds_all and not self.moving({}).not_bounded(level)
        holds_all = holds_all and not sympy.Tuple(*(self.least or {}).values()).has(
            TIME
        )
        shows = "definite all" if holds_all else "definite"
        return exact(f"{claim} in {names}", True, "", shows)

    @abstractmethod
    def fall(self) -> Fall:
        """Return what is shown of V'; called after `is_definite`."""

    @abstractmethod
    def same_as_running(self) -> Step:
        """Return the step that the running blocks have the same V and rates."""

    def ends(self, motion: Motion, fall: Fall) -> tuple[list[Step], str]:
        """Return the steps on what goes to zero, and its names."""
        of, forms = fall.of or go(map(self.text, fall.losses)), [*fall.losses]
        states = [*self.motion]
        lost = Squares(sympy.S.Zero, [], forms)
        at_least = self.least or {}
        if (
            at_least
            and not sympy.Tuple(*at_least.values()).has(TIME)
            and contains_all(lost, states)
            and all(vanishes(form.xreplace(at_least)) for form in forms)
        ):
            return [exact("V' < 0 but at the rest", True, "", "limit rest")], of
        names = of.rpartition(" ")[0] if of.endswith(("go", "goes")) else ""
        steps = [motion.limit(forms, names or ", ".join(map(self.text, forms)))]
        if self.eq.discrete:
            steps = [exact("the sum of what V loses is finite", True, "", "limit")]
        expressions = sympy.Tuple(self.V, *motion.rates.values())
        moves = expressions.has(TIME, *self.intervals, *motion.inputs.values())
        if moves or motion.free or self.eq.jumps:
            return steps, of
        found = motion.still_set(forms)
        if found.is_rest:
            names = ", ".join(f"{self.text(g)} = 0" for g in found.zero)
            shows = "still limit" + " rest" * (found.point is not None)
            steps = [
                exact(f"where V' = 0 for good nothing moves: {names}", True, "", shows)
            ]
        return steps, go(map(self.text, found.zero)) if found.zero[len(forms) :] else of

    def jumps(self) -> tuple[Step, sympy.Expr]:
        """Return the step that V rises at no jump, and by how much it rises where that fails."""
        claim = f"V does not rise where states of {' and '.join(self.eq.jumps)} jump"
        for rise in self.rises_at_jumps():
            if not self.never_positive(rise):
                return exact(claim, False, f"V changes by {short(rise)}"), rise
        return exact(claim, True, "", "jumps"), sympy.S.Zero

    def rises_at_jumps(self) -> list[sympy.Expr]:
        """Return by how much V rises at each set of jumps."""
        after = self.eq.jumps_at_once()
        return [normal_form(self.V.xreplace(change) - self.V) for change in after]

    def never_positive(self, expression: sympy.Expr) -> bool:
        """Return whether an expression is known never to be positive, for t >= 0."""
        parameters = self.fixed if self.numbers is None else self.numbers
        return never_positive(normal_form(expression), parameters)

    def refuted(self, steps: list[Step]) -> Refutation | None:
        """Return a point that refutes V, of the steps that fail, if one is searched for."""
        return None

    def refuted_at_jump(self, rise: sympy.Expr) -> Refutation | None:
        """Return a point at which V rises at a jump, if one is searched for."""
        return None

    @abstractmethod
    def ways(self, fall: Fall) -> Sequence[Callable[[], Any]]:
        """Return the ways to write V' as a sum, for a certificate."""

    def text(self, expression: sympy.Expr) -> str:
        """Return an expression as the user writes it, in a line."""
        return short(expression)

    @abstractmethod
    def verdict(self, status: Status, claim: str, **known: Any) -> Verdict:
        """Return a verdict on this candidate."""

    # --- its motion -----------------------------------------------------------------------------

    @cached_property
    def intervals(self) -> set:
        """Symbols of intervals between breakpoints, which are no constants."""
        parameters = self.eq.parameters.values()
        return {p.interval for p in parameters if "interval" in p._fields}

    def moving(self, zeroed: Mapping[Any, Any]) -> Motion:
        """Return the motion of the states, with some inputs zero."""
        rates = {s: rate.xreplace(zeroed) for s, rate in self.motion.items()}
        return Motion(self.eq, rates, self.fixed, [*self.forms], self.exist)


def judge(candidate: LyapunovCandidate, refute: bool = True) -> Verdict:
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
        return candidate.verdict("open", failed, steps=tuple(steps))
    steps += fall.remarks
    motion, of = candidate.moving(fall.zeroed), fall.of
    steps.append(motion.outside())
    if fall.losses:
        last, of = candidate.ends(motion, fall)
        steps += last
    conditions = [*fall.conditions, *motion.where]
    given = "jumps"
    if candidate.eq.jumps:
        given = ""
        step, rise = candidate.jumps()
        steps.append(step)
        refutation = None if step.holds else candidate.refuted_at_jump(rise)
        if refutation is not None:
            return refuted(candidate, refutation, steps)
        conditions += [] if step.holds else [Condition("between jumps", "jumps")]
    return candidate.verdict(
        "proved",
        fall.claim,
        conclusion=concluded(steps, given),
        of=of,
        bound=fall.bound,
        level=fall.level,
        conditions=tuple(conditions),
        steps=tuple(steps),
        ways=partial(candidate.ways, fall),
    )


def refuted(
    candidate: LyapunovCandidate, found: Refutation, steps: list[Step]
) -> Verdict:
    """Return the verdict on a candidate that a point refutes."""
    return candidate.verdict(
        "refuted",
        found.claim,
        steps=(*steps, found.step),
        point=found.point,
        value=found.value,
        after=found.after,
    )
