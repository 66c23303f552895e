"""Ends of a motion: what goes to zero where V' <= -sum of q^2, and what is left in the end.

    int q^2 dt <= V(0), q' bounded          =>  q -> 0                          (Barbalat's lemma)
    nothing depends on time, V bounds x     =>  x -> where V' = 0 for good:     (LaSalle)
                                                q = 0, q' = 0, q'' = 0, ...

`barbalat` and `lasalle` each begin with their premises.  Source: Khalil, H. K. (2002), Nonlinear
Systems, 3rd ed., Lemma 8.2 and Theorem 4.4.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import product
from typing import Any, NamedTuple

import sympy
from sympy import Expr

from ...engine.diagram.symbol_names import TIME
from ..algebra.decide import never_positive
from ..algebra.decided import decided
from ..algebra.exact import coarse, factored, normal_form, vanishes
from ..algebra.facts import functions_in
from ..algebra.slopes import along, jumps_nowhere
from ..algebra.sums_of_squares import Squares, squares, zero_at, zero_of
from .answers import Definite, Fall
from .conclusions import go
from .outside import ANGLES, Motion
from .steps import Step, exact

MOST_ROUNDS = 12  # of derivatives of what stays zero
MOST_VARIABLES = 7  # of polynomials whose zeros are counted


class Ends(NamedTuple):
    """Forms that go to zero, and the set that runs approach."""

    steps: list[Step]
    of: str  # "x goes"
    still: "Still | None" = None  # what V' = 0 leaves, if LaSalle's premises hold


def ends(candidate: Any, definite: Definite, fall: Fall, motion: Motion) -> Ends:
    """Return what goes to zero of what V' loses, by the way that shows the most."""
    of = fall.of or go(map(candidate.text, fall.losses))
    lost = Squares(sympy.S.Zero, [], [*fall.losses])
    least = definite.least if definite.is_steady else None
    if least and zero_of(lost, [*least]) == least:
        return Ends([exact("V' < 0 but at the rest", True, "", "limit rest")], of)
    still = lasalle(candidate, fall, motion)
    if still is None:
        return Ends([barbalat(candidate, fall, motion, of)], of)
    if still.zero[len(fall.losses) :]:
        of = go(candidate.text(g) for g in still.zero if jumps_nowhere(g))
    if not still.is_rest:
        return Ends([barbalat(candidate, fall, motion, of)], of, still)
    names = ", ".join(f"{candidate.text(g)} = 0" for g in still.zero)
    claim = f"where V' = 0 for good nothing moves: {names}"
    shows = "limit still" + " isolated" * still.comes_to_one
    shows += " rest" * (still.point is not None)
    return Ends([exact(claim, True, "", shows)], of, still)


def barbalat(candidate: Any, fall: Fall, motion: Motion, of: str) -> Step:
    """Return the step that q -> 0 of what V' loses, as the integral of q^2 is finite.

    Premises: q has no step; if q jumps with the states, it does so at the jumps of one block, a
    period apart; q' is bounded where V is.  In discrete time q^2 has a finite sum: it needs none.
    """
    if candidate.eq.discrete:
        return exact("the sum of what V loses is finite", True, "", "limit")
    names = of.rpartition(" ")[0] if of.endswith(("go", "goes")) else ""
    names = names or ", ".join(map(candidate.text, fall.losses))
    claim = f"the rate of {names} is bounded where V is"
    for q in fall.losses:
        if not jumps_nowhere(q):
            return exact(claim, False, f"{candidate.text(q)} may jump")
        jumping = candidate.jumping(q)
        if len(jumping) > 1 or not jumping <= candidate.periodic:
            blocks = " and ".join(sorted(jumping))
            return exact(claim, False, f"it jumps with {blocks}, at times of any kind")
    along_time = {TIME: sympy.S.One, **motion.rates}
    along_time |= {s: motion.still[f.diff(TIME)] for f, s in motion.inputs.items()}
    forms = map(motion.quiet, fall.losses)
    rates = [sympy.expand(along(q, along_time)) for q in forms]
    loose = dict.fromkeys(name for rate in rates for name in motion.not_bounded(rate))
    if loose:
        detail = f"it holds {', '.join(loose)}, not known to be bounded there"
        return exact(claim, False, detail)
    motion.driving |= motion.inputs_of(rates)
    return exact(claim, True, "", "limit")


def lasalle(candidate: Any, fall: Fall, motion: Motion) -> "Still | None":
    """Return what V' = 0 for good leaves; None if a premise fails.

    Premises: nothing depends on time or inputs; V bounds every state; no state jumps; rates and
    what V' loses are continuous, else what V' = 0 leaves may move, and only a point is an end.
    """
    rates = [*motion.rates.values()]
    moves = sympy.Tuple(candidate.V, *rates).has(
        TIME, *candidate.intervals, *motion.inputs.values()
    )
    if moves or motion.free or candidate.eq.jumps:
        return None
    is_continuous = all(map(jumps_nowhere, (*rates, *fall.losses)))
    rounds = MOST_ROUNDS if is_continuous else len(fall.losses)

    def left(number: Callable[[Expr], Expr]) -> Still:
        """Return what V' = 0 leaves of equations with their numbers changed."""
        rates = {s: number(rate) for s, rate in motion.rates.items()}
        still = Still(rates, motion.fixed, candidate.V, candidate.eq.discrete)
        still.find([*map(number, fall.losses)], rounds)
        return still

    still = left(lambda e: e)
    if any(coarse(e) != e for e in (*rates, *fall.losses)):
        # a difference of numbers may be their rounding: no conclusion depends on it
        rough = left(coarse)
        if rough.is_rest < still.is_rest or (rough.point is None and still.point):
            return None
    return still if is_continuous or still.point is not None else None


@dataclass
class Still:
    """The expressions that are zero for good where others are, in the order of their finding."""

    rates: dict[Any, Expr]
    fixed: set
    V: Expr  # which does not rise, so it comes to a level
    discrete: bool = False
    zero: list[Expr] = field(default_factory=list)
    solved: dict[Any, Expr] = field(
        default_factory=dict
    )  # states and sines, by the others

    def find(self, forms: Sequence[Expr], rounds: int) -> None:
        """Differentiate forms along the rates until nothing new is zero."""
        queue = [*forms]
        for _ in range(rounds):
            if not queue:
                break
            g = self.reduced(queue.pop(0))
            if vanishes(g):
                continue
            self.zero.append(g)
            self._solve(g)
            queue.append(
                g.xreplace(self.rates) if self.discrete else along(g, self.rates)
            )

    def reduced(self, expression: Expr) -> Expr:
        """Return an expression where all that was found is zero, without factors that never are."""
        e, before = normal_form(expression), None
        while e != before:
            before, e = e, normal_form(decided(e.xreplace(self.solved)))
        if vanishes(e):
            return sympy.S.Zero
        numerator, _ = sympy.fraction(sympy.together(e))
        factors = sympy.Mul.make_args(factored(numerator))
        kept = [
            zero_at(f.as_base_exp()[0])
            for f in factors
            if not _is_never_zero(f, self.fixed)
        ]
        return sympy.Mul(*dict.fromkeys(kept))

    def _solve(self, g: Expr) -> None:
        """Solve an expression that is zero for a state or a sine, linear in it."""
        atoms = sorted({*self.rates} & g.free_symbols, key=str)
        for a in [*atoms, *sorted(g.atoms(sympy.sin), key=str)]:
            slope = sympy.diff(g, a) if a.is_Symbol else g.coeff(a)
            rest = normal_form(g - slope * a)
            is_free = slope.free_symbols - self.fixed or rest.has(a)
            is_within = a.is_Symbol and rest.has(*_calls_of(rest, a))
            if slope.is_nonzero and not (is_free or is_within):
                self.solved[a] = -rest / slope
                return

    @property
    def changes(self) -> list[Expr]:
        """The rate of each state; in discrete time by how much it changes."""
        return [r - s if self.discrete else r for s, r in self.rates.items()]

    @property
    def is_rest(self) -> bool:
        """True if all rates are zero there."""
        left = map(self.reduced, self.changes)
        return all(vanishes(e) or any(vanishes(e - g) for g in self.zero) for e in left)

    @property
    def comes_to_one(self) -> bool:
        """True if each rest stands alone, or runs are known to come to one of several.

        Polynomials in the free states, and in sines of single ones, have finitely many zeros where
        V has a level, any one.  Of linear rates, and of one state alone, every run that is bounded
        converges; so do free states that only rise, or only fall.
        """
        slopes = sympy.Matrix(self.changes).jacobian([*self.rates])
        is_linear = not slopes.free_symbols - self.fixed and not functions_in(slopes)
        if is_linear or (len(self.rates) == 1 and not self.discrete):
            return True
        forms = [form for form in map(self.in_free_states, self.zero) if form != 0]
        variables = set().union(
            *(self.in_free_states(s).free_symbols for s in self.rates)
        )
        variables -= self.fixed
        changes = dict(zip(self.rates, self.changes, strict=True))
        if all(_has_one_sign(changes[s], self.fixed) for s in variables):
            return True
        angles = {call.args[0] for form in forms for call in form.atoms(*ANGLES)}
        level = sympy.Dummy()
        forms.append(self.in_free_states(self.V) - level)
        for angle in angles:
            turned = {f(angle): sympy.Dummy() for f in ANGLES}
            forms = [form.xreplace(turned) for form in forms]
            forms.append(sympy.Add(*(value**2 for value in turned.values())) - 1)
            if len(angle.free_symbols) == 1 and angle.is_polynomial():
                variables -= angle.free_symbols
            variables |= {*turned.values()}
        parameters = sorted(sympy.Tuple(*forms).free_symbols & self.fixed, key=str)
        symbols = [*variables, level, *parameters]
        forms = [sympy.fraction(sympy.together(form))[0] for form in forms]
        forms = [
            form
            for form in forms
            if form.is_polynomial(*symbols) and form.free_symbols <= {*symbols}
        ]
        if len(symbols) > MOST_VARIABLES:
            return False
        # a state has finitely many values at each level if a power of it leads a form
        basis = sympy.groebner(forms, *symbols)
        leading = {sympy.LM(form, *symbols).as_base_exp()[0] for form in basis.exprs}
        return {*variables} <= leading or 1 in leading

    def in_free_states(self, e: Expr) -> Expr:
        """Return an expression in the states that no other states give."""
        states = {s: value for s, value in self.solved.items() if s.is_Symbol}
        for _ in self.rates:
            e = sympy.expand(e.xreplace(states))
        return e

    @property
    def point(self) -> dict[Any, Expr] | None:
        """The one rest that is left: each state as a number; otherwise None."""
        values = {s: self.in_free_states(s) for s in self.rates}
        numbers = not any(v.free_symbols - self.fixed for v in values.values())
        return values if numbers else None

    def rests(self, low: Any, high: Any) -> list[dict[Any, Expr]]:
        """Return the rests between states: each state a number, or a zero of its sine."""
        choices = []
        for s, a, b in zip(self.rates, low, high, strict=True):
            sines = [g for g in self.solved if isinstance(g, sympy.sin) and g.has(s)]
            if s in self.solved:
                choices.append([self.solved[s]])
                continue
            if not sines or not sympy.Poly(sines[0].args[0], s).is_linear:
                return []
            slope, phase = sympy.Poly(sines[0].args[0], s).all_coeffs()
            turns = sorted((slope * end + phase) / sympy.pi for end in (a, b))
            counts = range(int(sympy.ceiling(turns[0])), int(sympy.floor(turns[1])) + 1)
            choices.append([(k * sympy.pi - phase) / slope for k in counts])
        points = (dict(zip(self.rates, p, strict=True)) for p in product(*choices))
        rests = [{s: v.xreplace(p) for s, v in p.items()} for p in points]
        numbers = all(v.is_number for p in rests for v in p.values())
        return rests if numbers else []


def _has_one_sign(e: Expr, fixed: set) -> bool:
    """Return whether an expression is never positive, or never negative."""
    return never_positive(e, fixed) or never_positive(-e, fixed)


def _calls_of(expression: Expr, state: Any) -> list:
    """Return the functions of an expression that hold a state."""
    return [f for f in expression.atoms(sympy.Function) if f.has(state)] or [
        sympy.Dummy()
    ]


def _is_never_zero(factor: Expr, fixed: set) -> bool:
    """Return whether a factor of an expression that is zero cannot be the one that is."""
    if not factor.free_symbols - fixed:
        return bool(factor.is_nonzero)
    base, exponent = factor.as_base_exp()
    total = squares(base, fixed) if base.is_Add else None
    return bool(exponent.is_negative or base.is_positive) or bool(
        total and total.constant.is_positive
    )
