"""One judge for a function V on the equations of a law's loop or of any system.

`clpt.prove` and `clpt.lyapunov` are two short callers.  `asked` asks the questions in their order;
each is a function of the candidate and earlier answers, and its answer has a step:

    values    have V and the equations a value everywhere?
    definite  in which forms is V positive definite?
    falls     is V' <= 0, and what does V' lose?        bounds   if not, is V bounded?
    running   have the running blocks the same V'?      every N  is it the same for every N?
    outside   do the states that V does not contain exist for all times?
    ends      what goes to zero of what V' loses (Barbalat), what is left in the end (LaSalle)?
    jumps     does V rise where states jump?

The conclusion is the first of `CONCLUSIONS` that the steps show.  A V that fails is refuted by a
point at which the running blocks show it; otherwise it is open.  In discrete time V' stands for
V(x+) - V(x).
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from pathlib import Path
from types import MappingProxyType
from typing import Any

import sympy
from sympy import Dummy, Expr, log

from ...base.errors import DiagramError
from ...base.files import write_file
from ...base.html import facts, fragment
from ...engine.diagram.interconnection import Diagram
from ...engine.diagram.symbol_names import TIME
from ...engine.diagram.symbolic_equations import Equations
from ...engine.diagram.wiring import wiring_of
from ...engine.model.declaration import Each
from ..algebra.convex import has_one_least_point
from ..algebra.decide import never_positive
from ..algebra.exact import normal_form, vanishes
from ..algebra.facts import is_continuous
from ..algebra.slopes import meets_smoothly
from ..algebra.sums_of_squares import simplest, squares, zero_of
from .answers import Definite, Fall, Jumps, Refutation
from .conclusions import CONCLUSIONS, Condition, Judged, Status, concluded
from .ends import Ends, ends
from .in_coq import File
from .in_latex import verdict_in_latex
from .outside import Motion
from .rate_as_sum import NotASum
from .relations import in_errors, one_way
from .statements import Statement, go, joined, said
from .steps import Step, exact, first_failure
from .symbolic_loop import Point
from .where import Where


@dataclass(frozen=True)
class Verdict(Judged):
    """Result of a judgement of V' under a law or along a diagram.

    Attributes
    ----------
    status : str
        ``"proved"``: `conclusion` holds under `conditions`; ``"refuted"``: the running blocks show
        at `point` that V' > 0, that V' is above the claim, or that V is no least value; or V rises
        at a jump from `point` to `after`; ``"open"``: none of these is known.
    conclusions : tuple of str
        Of a proof: "goes to zero", "ultimately bounded", ...: rows of the table of docs/theory.md
        that follow, the strongest first, `conclusion`: ``verdict.implies("goes to zero")``.
    conditions : tuple of Condition
        Where it holds: "for t >= 0", "where u = 0", "x is not held by V, and bounded", ...
    claim : str
        What is shown of V', where it fails, or which step is missing.
    sentence : str
        The verdict in words, made of its fields.
    V, rate : sympy.Expr or None
        V, and V'; of a diagram in its own signals; of a proof "where u = 0" V' there. In discrete
        time `rate` is by how much V changes. None where no V was found.
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
    decay : sympy.Expr or None
        V(0) e^(-k t), which V stays below, if V' <= -k V is shown.
    residual : sympy.Expr
        Of a law: V' less its fall, V' + e^T KD e, multiplied out.
    diagram : Diagram or None
        The closed loop with the law, V its last output.
    for_every_N : bool
        Whether it is proved for every number of basis functions.
    after : Point or None
        Of a V that rises at a jump: where it jumps to.
    claimed : sympy.Expr or None
        The upper bound of V' that `lyapunov` was given as its `claim`.
    equations : Equations or None
        The equations in which V' was judged.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> from clpt_control.paper.laws.table import LAWS
    >>> wrong = LAWS["learned-flow"].of(1, gain=-0.5)
    >>> verdict = clpt.prove(wrong, points=200)
    >>> verdict.status, verdict.value > 0
    ('refuted', True)
    """

    V: Expr | None = None
    rate: Expr | None = None
    inputs: tuple[str, ...] = ()
    point: Point | None = None
    value: float | None = None
    residual: Expr = sympy.S.Zero
    diagram: Diagram | None = None
    after: Point | None = None
    claimed: Expr | None = None
    equations: Equations | None = field(default=None, compare=False)
    ways: Callable[[], Any] = field(default=tuple, repr=False, compare=False)

    def coq(self, path: str | None = None) -> str:
        """Return the proof as a file that Coq checks alone; write it to a path."""
        text = f"{self._file()}"
        if path is not None:
            write_file(Path(path), text)
        return text

    def beyond_coq(self) -> tuple[Step, ...]:
        """Return the steps by which the verdict is stronger than the file's last theorem."""
        missing = self._file().missing
        return tuple(s for s in self.steps if missing & {*s.shows.split()})

    def _file(self) -> File:
        """Return the file of the first way to write V' as a sum."""
        reasons = list[str]()
        if self.status != "proved":
            reasons.append("nothing is proved of V'")
        elif self.ways is tuple:
            reasons.append("its proof is not about one V' that is a sum")
        for way in () if reasons else self.ways():
            try:
                return File(way(), self)
            except (NotASum, DiagramError) as reason:
                reasons.append(f"{reason}")
        reasons.append("states keep relations, which are not printed")
        raise DiagramError(f"coq: the verdict has no file, as {reasons[0]}")

    def latex(self) -> str:
        r"""Return the verdict in LaTeX, for a paper.

        A proof is a theorem with its steps, a refutation a proposition with its point, an open
        verdict a conjecture. Each has the equations, V and V'. The environments are those of
        amsthm and amsmath.

        Examples
        --------
        >>> import clpt_control as clpt
        >>> lag = clpt.Block("lag", update=lambda t, x, u, p: {"x": -x.x**3}, states={"x": 1})
        >>> print(clpt.lyapunov(lag, lambda s: s.x**2 / 2).latex()[:230])
        \begin{theorem}
        Let \[ \begin{aligned}\dot{x} &= - x^{3}\end{aligned} \]
        and $\displaystyle V = \frac{x^{2}}{2}$.
        Then $\displaystyle \dot V = - x^{4}$.
        Conclusion: the rest is asymptotically stable from every start.
        \end{theorem}
        """
        return verdict_in_latex(self)

    def __repr__(self) -> str:
        return f"<Verdict {self.status}: {self.sentence}>"

    def _repr_html_(self) -> str:
        rows = [
            (s.claim, "holds" if s.holds else "not shown", s.how, s.detail)
            for s in self.steps
        ]
        table = facts(rows, ("claim", "", "how", "detail"))
        return fragment("Verdict", f"{self.status}: {self.sentence}", table)


class LyapunovCandidate(ABC):
    """A function V on equations, and the questions that are asked of it.

    In: equations, V, and V' along them.  Out: answers (`answers`), each with its step, and in the
    end a verdict.  Each question is a function of the candidate and of earlier answers.
    """

    system: Any
    eq: Equations
    V: Expr
    rate: Expr  # V'
    motion: Mapping[Any, Expr]  # rates of the states that V is written in
    fixed: set  # symbols of parameters
    numbers: set | None = None  # those that signs may depend on; None: all
    rest: Mapping[Any, Expr] | None = None  # where V is to be least, if that is given
    where = Where()  # sets of states, and bounds of inputs
    given: Mapping[Any, Expr] = MappingProxyType(
        {}
    )  # symbol of a margin -> what it stands for
    errors: Any = ({}, {})  # states in errors of V, and what these are
    driving: Any = frozenset()  # inputs that have to be bounded
    is_whole = True  # whether V is judged at all states, and not on a relation
    undefined: list[str]  # sentences on where there may be no value
    search: Any  # points at which it may fail

    # --- the questions --------------------------------------------------------------------------

    def has_values(self) -> Step:
        """Return the step that V and the equations have a value everywhere."""
        claim = "V and the equations have a value everywhere"
        return exact(claim, not self.undefined, "".join(self.undefined[:1]), "values")

    def kept(self, definite: Definite, fall: Fall) -> list[Step]:
        """Return the steps that relations and sets of states are kept."""
        return []

    def definite(self) -> Definite:
        """Return the forms of the states in which V is positive definite."""
        claim = "V is positive definite"
        expressions = self.V, *self.motion.values()
        bends = not meets_smoothly(self.V) and not all(map(is_continuous, expressions))
        if bends or self.V.free_symbols & self.intervals:
            return Definite(exact(claim, False, "V may jump or bend"))
        at_start, rest_state = one_way(self), self.rest or {}
        # a state above 0 is not above its rest
        off = {s: Dummy(f"{s}", real=True) for s in rest_state}
        moved = sympy.expand_log(self.V.xreplace(at_start))
        # log(s) of a state above 0 is any number
        at_rest = [(s, d, rest_state[s]) for s, d in off.items()]
        exps = {
            s: r * sympy.exp(d)
            for s, d, r in at_rest
            if s.is_positive and r > 0 and moved.has(log(s))
        }
        shift = {s: d + r for s, d, r in at_rest} | exps
        moved = sympy.expand_log(moved.xreplace(shift))
        fixed = self.fixed | {*at_start.values()}
        total = squares(moved, fixed) or squares(moved, fixed, False)
        if not total and self.where.roots and self.rest is None:
            total = squares(self.V.xreplace(self.where.squared), self.fixed)
            forms = self.where.in_states(total.forms) if total else []
            total = total and total._replace(forms=forms)
        states = [*self.motion]
        if total and self.rest is not None:
            zero = dict.fromkeys(off.values(), 0)
            total = total if all(vanishes(f.subs(zero)) for f in total.forms) else None
        if not total or not total.forms:
            return self.convex() or Definite(exact(claim, False, "not shown"))
        back = {d: s - r for s, d, r in at_rest}
        logs = {d: log(s) - log(r) for s, d, r in at_rest if s in exps}
        forms = [back.get(form) or form.xreplace(back | logs) for form in total.forms]
        contained = [s for s in states if any(form.has(s) for form in forms)]
        names = joined(", ", dict.fromkeys(map(self.text, forms)))
        step = exact(said("{} in {}", claim, names), True, "", "definite")
        off_zero = {s for s in exps if off[s] in total.forms}
        lost = "V(0)"
        if not total.constant.is_nonnegative:
            lost = self.text(sympy.Symbol("V(0)") - total.constant)
        if total.constant.free_symbols - self.fixed:
            lost = "a number"
        if {*self.where.above} - off_zero:  # nothing is known of the end of an open set
            return Definite(step, [*forms, *at_start], most_lost=lost)
        least = zero_of(total._replace(forms=forms), contained)
        if least is None and (convex := self.convex()):
            return convex
        answer = Definite(step, forms, least, off_zero=off_zero, most_lost=lost)
        motion, numbers = self.moving(answer, {}), (least or {}).values()
        motion.outside()
        level = self.V.xreplace({s: Dummy(real=True) for s in states})
        is_bounded = {*contained} <= motion.bounded.keys()
        if not (least and is_bounded) or sympy.Tuple(*numbers).has(TIME):
            return answer
        # a rest may be stable on a relation, and not beside it
        holds_all = self.is_whole and len(contained) == len(states)
        shows = "definite all" if holds_all else "definite"
        is_steady = not motion.not_bounded(level)
        step = replace(step, shows=shows if is_steady else "definite")
        return answer._replace(step=step, is_steady=is_steady)

    def convex(self) -> Definite | None:
        """Return that V has one least point, of no closed form, as it is convex; or None."""
        states = [s for s in self.motion if self.V.has(s)]
        has_end = len(self.where.roots) > len(self.where.above)  # V may be least there
        if has_end or not has_one_least_point(self.V, states, self.fixed):
            return None
        if self.rest and any(self.V.diff(s).subs(self.rest) != 0 for s in states):
            return None
        names = joined(", ", map(self.text, states))
        claim = said("V is strictly convex in {}, and least at one point", names)
        holds_all = self.is_whole and len(states) == len(self.motion)
        step = exact(claim, True, "", "definite" + " all" * holds_all)
        answer = Definite(step, states, is_steady=True, is_convex=True)
        # where their rates, of themselves alone, are positive near 0
        off_zero = {
            s
            for s in self.where.above
            if self.motion[s].free_symbols <= {s, *self.fixed}
            and sympy.limit(self.motion[s], s, 0).is_extended_positive
            and not (self.eq.jumps or self.eq.discrete)
        }
        return answer._replace(off_zero=off_zero, most_lost="a number")

    @abstractmethod
    def falls(self, definite: Definite) -> Fall:
        """Return what is shown of V' <= 0."""

    def bounds(self, definite: Definite, fall: Fall) -> Fall:
        """Return a bound of V where V' <= 0 is not shown; `fall` if none is known."""
        return fall

    @abstractmethod
    def same_as_running(self) -> Step:
        """Return the step that the running blocks have the same V and rates."""

    def every_N(self, definite: Definite, fall: Fall) -> Step | None:
        """Return the step that the same holds for every number of functions, if that is asked."""
        return None

    def jumps(self) -> Jumps:
        """Return the step that V rises at no jump, and by how much it rises where that fails."""
        claim = f"V does not rise where states of {' and '.join(self.eq.jumps)} jump"
        for rise in self.rises_at_jumps():
            if not self.never_positive(rise):
                return Jumps(exact(claim, False, said("V changes by {}", rise)), rise)
        return Jumps(exact(claim, True, "", "jumps"))

    def rises_at_jumps(self) -> list[Expr]:
        """Return by how much V rises at each set of jumps."""
        after = self.eq.jumps_at_once()
        return [normal_form(self.V.xreplace(change) - self.V) for change in after]

    def never_positive(self, expression: Expr) -> bool:
        """Return whether an expression is never positive for t >= 0, states in their sets."""
        parameters = self.fixed if self.numbers is None else self.numbers
        inside = (e.xreplace(self.where.inside) for e, _ in in_errors(self, expression))
        return any(never_positive(normal_form(e), parameters) for e in inside)

    def refuted(
        self, definite: Definite, fall: Fall
    ) -> tuple[Refutation | None, list[Step]]:
        """Return a point that refutes V, if one is found, and the searches without one."""
        return None, []

    def refuted_at_jump(self, rise: Expr) -> Refutation | None:
        """Return a point at which V rises at a jump, if one is searched for."""
        return None

    @abstractmethod
    def ways(self, definite: Definite, fall: Fall) -> Sequence[Callable[[], Any]]:
        """Return the ways to write V' as a sum, for a file of Coq."""

    def text(self, expression: Expr) -> Statement:
        """Return an expression as the user writes it."""
        return said("{}", expression)

    def go(self, forms: Sequence[Expr]) -> Statement:
        """Return "x, y go" of forms, or of shorter ones that span the same."""
        return go(map(self.text, simplest(forms, self.fixed - self.intervals)))

    def at_z(self, expression: Expr) -> Expr:
        """Return an expression in the states of the diagram."""
        return expression

    @abstractmethod
    def verdict(self, status: Status, claim: str, fall: Fall, **known: Any) -> Verdict:
        """Return a verdict on this candidate."""

    # --- its motion -----------------------------------------------------------------------------

    def jumping(self, expression: Expr) -> set[str]:
        """Return the blocks at whose jumps an expression changes."""
        before = self.at_z(expression)
        after = {name: before.xreplace(jump) for name, jump in self.eq.jumps.items()}
        return {name for name, e in after.items() if not vanishes(e - before)}

    @property
    def periodic(self) -> set[str]:
        """Blocks that jump a period apart."""
        nodes = wiring_of(self.system).nodes
        times = {node.name: node.system.breakpoints_function for node in nodes}
        return {name for name, each in times.items() if isinstance(each, Each)}

    @cached_property
    def intervals(self) -> set:
        """Symbols of intervals between breakpoints, which are no constants."""
        parameters = self.eq.parameters.values()
        return {p.interval for p in parameters if "interval" in p._fields}

    def moving(self, definite: Definite, zeroed: Mapping[Any, Any]) -> Motion:
        """Return the motion of the states, with some inputs zero."""
        rates = {s: rate.xreplace(zeroed) for s, rate in self.motion.items()}
        fixed, forms = self.fixed - self.intervals, [*definite.forms]
        given = fixed, self.intervals, forms, definite.exist
        return Motion(
            self.eq,
            rates,
            *given,
            in_box={*self.where.bounded, *self.where.values},
            driving={*self.driving},
            off_zero=definite.off_zero,
        )


@dataclass
class Answers:
    """The answers on a candidate, as far as they were asked; the verdict is made of them."""

    candidate: LyapunovCandidate
    definite: Definite
    fall: Fall
    steps: list[Step]
    failed: str  # the first step that does not hold
    for_every_N: bool = False
    ends: Ends | None = None  # what V' loses
    where: Sequence[Condition] = ()
    jumps: Jumps | None = None

    @cached_property
    def verdict(self) -> Verdict:
        """The verdict: the first conclusion whose requirements are shown, or none."""
        fall, steps, failed = self.fall, tuple(self.steps), self.failed
        verdict = partial(self.candidate.verdict, fall=fall, steps=steps)
        if self.jumps and not self.jumps.step.holds:
            found = self.candidate.refuted_at_jump(self.jumps.rise)
            if found is not None:
                return refuted(self.candidate, found, fall, steps)
            failed = first_failure([self.jumps.step])
        follow = () if failed else concluded(steps, "" if self.jumps else "jumps")
        if not follow:
            needed = first_failure(step for step in steps if step.needed)
            return verdict("open", failed or said("{}; {}", fall.claim, needed))
        of = self.ends.of if self.ends else fall.of
        if CONCLUSIONS[follow[0]].is_of_loss:
            of = self.definite.most_lost
        return verdict(
            "proved",
            fall.claim,
            conclusions=follow,
            of=of,
            bound=fall.bound,
            level=fall.level,
            decay=fall.decay,
            conditions=(*fall.conditions, *self.where),
            for_every_N=self.for_every_N,
            ways=partial(self.candidate.ways, self.definite, fall),
        )


def asked(candidate: LyapunovCandidate) -> Answers:
    """Return the answers on a candidate, each found with those before it."""
    values, definite = candidate.has_values(), candidate.definite()
    fall = candidate.falls(definite)
    if not fall.holds:
        fall = candidate.bounds(definite, fall)
    steps = [values, *candidate.kept(definite, fall), definite.step, *fall.steps]
    if not first_failure(steps):
        steps.append(candidate.same_as_running())
    answers = Answers(candidate, definite, fall, steps, first_failure(steps))
    if answers.failed:
        return answers
    if every_N := candidate.every_N(definite, fall):
        steps.append(every_N)
        answers.for_every_N = every_N.holds
    motion = candidate.moving(definite, fall.zeroed)
    steps.append(motion.outside())
    if fall.losses or fall.slow:
        answers.ends = ends(candidate, definite, fall, motion)
        steps += answers.ends.steps
    answers.where = motion.where
    if candidate.eq.jumps:
        answers.jumps = candidate.jumps()
        steps.append(answers.jumps.step)
    return answers


def judge(candidate: LyapunovCandidate) -> Verdict:
    """Return the verdict on a candidate V; where it is open, look for a point that refutes V."""
    return with_refutation(candidate, asked(candidate))


def with_refutation(candidate: LyapunovCandidate, answers: Answers) -> Verdict:
    """Return the verdict, or where it is open and a point refutes V that refutation."""
    verdict = answers.verdict
    if verdict.status != "open":
        return verdict
    found, searches = candidate.refuted(answers.definite, answers.fall)
    steps = (*verdict.steps, *searches)
    if found is None:
        return replace(verdict, steps=steps)
    return refuted(candidate, found, answers.fall, steps)


def refuted(
    candidate: LyapunovCandidate, found: Refutation, fall: Fall, steps: Iterable[Step]
) -> Verdict:
    """Return the verdict on a candidate that a point refutes."""
    known = {"point": found.point, "value": found.value, "after": found.after}
    at = candidate.search.text_of(found.point)
    steps = (*steps, replace(found.step, detail=at))
    return candidate.verdict("refuted", found.claim, fall, steps=steps, **known)
