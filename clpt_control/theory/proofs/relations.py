"""Relations that states keep, h = 0 at the start: each gives one state in terms of the others.

    s = value(other states),  r = s - value,  r' = 0 where all r = 0

If r' is Lipschitz in r, r stays 0: a run that begins there is one of fewer equations, those of the
other states, and V is judged on these.  Rounding leaves r by a little: where a distance r is not
known to shrink, or to stay, or a factor of it in other rates may grow, the relation is not kept in
a run.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Set
from contextlib import suppress
from dataclasses import replace
from itertools import chain, product
from typing import Any

import sympy
from sympy import Add, Dummy, Expr, S, Tuple, expand, sympify
from sympy.core.function import AppliedUndef
from sympy.utilities.iterables import connected_components

from ...base.errors import DiagramError
from ...engine.diagram.symbol_names import TIME
from ...engine.diagram.symbolic_equations import Equations
from ..algebra.decided import decided
from ..algebra.exact import factored, groups_of, normal_form, vanishes
from ..algebra.facts import CLIP, fact_of, functions_in, is_smooth, roots_in
from ..algebra.slopes import along, jumps_nowhere, slope_in
from ..algebra.sums_of_squares import written_forms
from ..algebra.texts import short
from .outside import groups_of_drivers, is_stable
from .signal_functions import expressions_of
from .statements import Statement, joined, said
from .steps import Step, exact


def forks(rate: Expr, fixed: Set[Any]) -> bool:
    """Return whether motions may part where a rate is zero, as those of s' = |s|^(1/2) at 0."""
    smooth = (f for f in functions_in(rate) if fact_of(f).kind == "smooth")
    bases = roots_in(Tuple(rate, *(call.fdiff() for call in smooth)))
    roots = (base for base in bases if not base.is_positive)
    may_be_zero = any(base.free_symbols - fixed for base in roots)
    return may_be_zero or not jumps_nowhere(rate)


def divides(rate: Expr) -> bool:
    """Return whether a rate has no bound at some states, as 1/s and log s at 0."""
    inner = [p.base for p in rate.atoms(sympy.Pow) if p.exp.is_negative]
    inner += [call.args[0] for call in rate.atoms(sympy.log)]
    return not all(e.is_positive for e in inner)


def one_way(candidate: Any) -> dict[Any, Any]:
    """Return states above 0 that never rise -> their start, where V falls with each."""
    eq, at_start = candidate.eq, dict[Any, Any]()
    for s in () if eq.discrete else candidate.where.above:
        jumps = [e[s] - s for e in eq.jumps_at_once() if s in e]
        slope = slope_in(candidate.V, s)
        falls = map(candidate.never_positive, (candidate.motion[s], slope, *jumps))
        if slope != 0 and all(falls):
            at_start[s] = Dummy(f"{s}(0)", positive=True)
    return at_start


class Relations:
    """Relations of states, each solved for one of them.

    `motion` has the rates of all states, `masked` returns an expression with symbols for functions
    of any value.
    """

    def __init__(
        self,
        eq: Equations,
        motion: Mapping[Any, Expr],
        masked: Callable[[Expr], Expr] = sympify,
    ):
        self.eq, self.motion, self.masked = eq, motion, masked
        self.solved = dict[Any, Expr]()  # state -> its value, in states that are left
        self.distances = dict[Any, Expr]()  # state -> the distance from its value

    def add(self, relation: Expr, states: Iterable[Any] = ()) -> None:
        """Solve a relation for one of some states, or for any, and keep it."""
        h = expand(relation.xreplace(self.solved))
        if h == 0:  # it follows from the others
            return
        of_states = () if h.has(TIME, AppliedUndef) else reversed(self.motion)
        for s in states or of_states:
            slope = sympy.diff(h, s)
            if slope.is_nonzero and not slope.has(*self.motion):
                value = expand(s - h / slope)
                before = self.solved.items()
                self.solved = {o: expand(v.xreplace({s: value})) for o, v in before}
                self.solved[s] = value
                self.distances[s] = Dummy(f"({s - value})", real=True)
                return
        raise DiagramError(
            f"{self.eq.name}: the relation {short(h, 60)} = 0 cannot be solved for one state. "
            "Give a function of states alone, in which one has a constant factor that is not 0"
        )

    def read(self, keeps: Callable) -> list[str]:
        """Add what a function of signals returns; return where that may have no value."""
        without_value = list[str]()
        for relation, undefined in expressions_of(self.eq, keeps):
            self.add(relation)
            without_value += [f"keeps{text.removeprefix('V')}" for text in undefined]
        return without_value

    def of(self, expression: Any) -> Expr:
        """Return an expression where the relations hold."""
        return decided(self.masked(sympify(expression)).xreplace(self.solved))

    def beside(self, expression: Expr) -> Expr:
        """Return an expression at distances from the relations."""
        near = {s: value + self.distances[s] for s, value in self.solved.items()}
        return decided(self.masked(expression).xreplace(near))

    def moved(self, changes: Iterable[Expr]) -> dict[Any, Expr]:
        """Return distances -> their rates, or what they are after a change."""
        changed = map(expand, map(self.beside, changes))
        return dict(zip(self.distances.values(), changed, strict=True))

    @property
    def text(self) -> Statement:
        """The relations."""
        return joined(", ", (said("{} = {}", *pair) for pair in self.solved.items()))

    def rate(self, s: Any) -> Expr:
        """Return the rate of s - value, or in discrete time its next value."""
        off = s - self.solved[s]
        if self.eq.discrete:
            return off.xreplace(dict(self.motion))
        return along(off, {TIME: S.One, **self.motion})

    def broken(self) -> str:
        """Return which relation states leave, by their rates or at a jump, or ""."""
        for s, value in self.solved.items():
            rate = self.rate(s)
            if not self.eq.discrete and forks(self.masked(rate), {*self.eq.values}):
                return f"{s} may leave it: its rate may jump, or is steep as |s|^(1/2)"
            for change in (rate, *map((s - value).xreplace, self.eq.jumps_at_once())):
                remainder = self.of(change)
                if not vanishes(remainder):
                    return said("{} leaves it by {}", s, expand(remainder))
        return ""

    def repels(
        self, never_positive: Callable[[Expr], bool], *, alone: bool = False
    ) -> str:
        """Return a sentence unless a distance from the relations is known not to grow.

        Distances of which one drives another are a group, or `alone` those that drive each other,
        with the other distances 0.  In a group the sum of squares does not grow; or it moves by
        itself, and its matrix is stable.  No jump raises the sum of all squares.
        """
        # Step 1: rates
        rates = self.moved(map(self.rate, self.distances))
        drivers = [(d, other) for d in rates for other in rates if rates[d].has(other)]
        joint = connected_components(([*rates], drivers))
        growths = list[Expr]()
        for group in groups_of_drivers(rates) if alone else joint:
            others = dict.fromkeys(rates.keys() - {*group}, S.Zero)
            own = {d: rates[d].xreplace(others) for d in group}
            if self._is_stable(own, alone):
                continue
            discrete = self.eq.discrete
            changes = (e**2 - d**2 if discrete else e * d for d, e in own.items())
            growths.append(Add(*changes))
        # Step 2: jumps
        for after in () if alone else self.eq.jumps_at_once():
            jumped = self.moved((s - v).xreplace(after) for s, v in self.solved.items())
            growths.append(Add(*(e**2 - d**2 for d, e in jumped.items())))
        if all(map(never_positive, growths)):
            return ""
        return said("{}: a distance from it, as rounding leaves, may grow", self.text)

    def _is_stable(self, rates: Mapping[Any, Expr], nearby: bool) -> bool:
        """Return whether distances that move by themselves go to 0, or do so from `nearby`."""
        field = sympy.Matrix([*rates.values()])
        outside = field.free_symbols - rates.keys() - self.eq.values.keys()
        if outside or not all(map(is_smooth, field)):
            return False
        J = field.jacobian([*rates])
        if J.has(*rates) and not nearby:
            return False
        J = J.xreplace(dict.fromkeys(rates, S.Zero))
        return is_stable(J, self.eq.discrete)

    def steps(self, never_positive: Callable[[Expr], bool], motion: Any) -> list[Step]:
        """Return the steps that the relations are kept, and that no distance r grows or acts more.

        What other states do has factors of r, which stays small: that of a jump at 0 is 1/r.
        """
        if not self.solved:
            return []
        broken = self.broken()
        repels = broken or self.repels(never_positive)
        small = {r: CLIP(r, -1, 1) for r in self.distances.values()}
        motion.outside()
        motion.bounded |= small
        motion.near |= small.keys()
        acts = ""
        changes = (e.items() for e in (self.motion, *self.eq.jumps.values()))
        for (s, change), (o, r) in product(chain(*changes), self.distances.items()):
            e = self.beside(change)
            calls = (call for call in functions_in(e) if call.has(r))
            factor = slope_in(e, r) if all(map(jumps_nowhere, calls)) else 1 / r
            if factor == 0 or s in self.solved:
                continue
            motion.driving |= motion.inputs_of([motion.quiet(factor)])
            if motion.not_bounded(factor):
                grows = "{} may grow, and multiplies what rounding leaves"
                acts = said(grows, factor)
            elif not (self.eq.discrete or self.of(change).has(s)) and vanishes(
                self.rate(o)
            ):
                acts = said("{} adds up what rounding leaves", s)
        return [
            exact(said("{} is kept", self.text), not broken, broken),
            exact("a distance from it does not grow", not repels, repels),
            exact(said("{} is kept in a run", self.text), not acts, acts),
        ]

    def reduced(self) -> Equations:
        """Return the equations with the jumps of the states that are left."""
        jumps = {
            block: {s: self.of(e) for s, e in change.items() if s not in self.solved}
            for block, change in self.eq.jumps.items()
        }
        return replace(self.eq, jumps=jumps)


# --- errors -------------------------------------------------------------------------------------


def errors_of(
    case: Any, forms: Iterable[Expr], least: int = 1
) -> tuple[dict[Any, Expr], dict[Any, Expr]]:
    """Return states in errors, linear forms of V such as x - z, and errors -> these forms.

    Each has at least some number of states.
    """
    in_errors, errors = Relations(case.eq, case.motion), dict[Any, Expr]()
    as_they_are = {*forms, *case.where.kept}
    states = [s for s in reversed(case.motion) if s not in as_they_are]
    for form in forms:
        is_error = len(form.free_symbols & case.motion.keys()) >= least
        if is_error and form not in case.motion:
            error = Dummy(f"{form}", real=True)
            with suppress(DiagramError):
                in_errors.add(form - error, states)
                errors[error] = form
    return in_errors.solved, errors


def in_errors(case: Any, e: Expr) -> Iterator[tuple[Expr, Mapping[Any, Expr]]]:
    """Yield an expression as it is and, if that is another one, in errors, and what these are."""
    states, forms = case.errors
    yield e, {}
    if e.has(*states):
        yield normal_form(e.xreplace(states)), forms


def written(case: Any, rate: Expr) -> list[Expr]:
    """Return V' factored, in groups that share no state, or as a sum of squares."""
    found = list[Expr]()
    for e, forms in in_errors(case, decided(normal_form(rate))):
        groups = groups_of(e, e.free_symbols - case.fixed) if forms else []
        in_groups = Add(*map(factored, groups)).xreplace(forms)
        found += [in_groups] if forms else written_forms(e, case.fixed)
    return found
