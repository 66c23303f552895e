"""Ends of a motion: what goes to zero where V' <= -sum of q^2, and what is left in the end.

    int q^2 dt <= V(0), q' bounded          =>  q -> 0                          (Barbalat's lemma)
    nothing depends on time, V bounds x     =>  x -> where V' = 0 for good:     (LaSalle)
                                                q = 0, q' = 0, q'' = 0, ...

Source: Khalil, H. K. (2002), Nonlinear Systems, 3rd ed., Lemma 8.2 and Theorem 4.4.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field
from itertools import product
from typing import Any, NamedTuple

import sympy
from sympy import Expr

from ...engine.diagram.symbol_names import TIME
from ..algebra.exact import factored, normal_form, vanishes
from ..algebra.slopes import along
from ..algebra.sums_of_squares import Squares, contains_all, squares
from .answers import Definite, Fall
from .conclusions import go
from .outside import Motion
from .steps import Step, exact

MOST_ROUNDS = 12  # of derivatives of what stays zero


class Ends(NamedTuple):
    """What goes to zero, and where runs end."""

    steps: list[Step]
    of: str  # "x goes"
    still: "Still | None" = None  # what V' = 0 leaves, if that is asked


def ends(candidate: Any, definite: Definite, fall: Fall, motion: Motion) -> Ends:
    """Return what goes to zero of what V' loses, by the first way that shows the most."""
    of = fall.of or go(map(candidate.text, fall.losses))
    if _falls_but_at_the_rest(definite, fall, [*motion.rates]):
        return Ends([exact("V' < 0 but at the rest", True, "", "limit rest")], of)
    found = lasalle(candidate, fall, motion, of)
    if found is not None and found.steps:
        return found
    return Ends([barbalat(candidate, fall, motion, of)], found.of if found else of)


def _falls_but_at_the_rest(definite: Definite, fall: Fall, states: list) -> bool:
    """Return whether what V' loses determines each state, and vanishes where V is least."""
    lost, least = Squares(sympy.S.Zero, [], [*fall.losses]), definite.least
    return bool(
        least
        and not sympy.Tuple(*least.values()).has(TIME)
        and contains_all(lost, states)
        and all(vanishes(form.xreplace(least)) for form in lost.forms)
    )


def barbalat(candidate: Any, fall: Fall, motion: Motion, of: str) -> Step:
    """Return the step that what V' loses goes to zero."""
    if candidate.eq.discrete:
        return exact("the sum of what V loses is finite", True, "", "limit")
    names = of.rpartition(" ")[0] if of.endswith(("go", "goes")) else ""
    names = names or ", ".join(map(candidate.text, fall.losses))
    claim = f"the rate of {names} is bounded where V is"
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


def lasalle(candidate: Any, fall: Fall, motion: Motion, of: str) -> Ends | None:
    """Return what is left where V' = 0 for good; None if a premise fails."""
    expressions = sympy.Tuple(candidate.V, *motion.rates.values())
    moves = expressions.has(TIME, *candidate.intervals, *motion.inputs.values())
    if moves or motion.free or candidate.eq.jumps:
        return None
    still = Still(motion.rates, motion.fixed, candidate.eq.discrete).found(fall.losses)
    more = still.zero[len(fall.losses) :]
    of = go(map(candidate.text, still.zero)) if more else of
    if not still.is_rest:
        return Ends([], of)
    names = ", ".join(f"{candidate.text(g)} = 0" for g in still.zero)
    shows = "still limit" + " rest" * (still.point is not None)
    claim = f"where V' = 0 for good nothing moves: {names}"
    return Ends([exact(claim, True, "", shows)], of, still)


@dataclass
class Still:
    """The expressions that are zero for good where others are, in the order of their finding."""

    rates: dict[Any, Expr]
    fixed: set
    discrete: bool = False
    zero: list[Expr] = field(default_factory=list)
    solved: dict[Any, Expr] = field(
        default_factory=dict
    )  # states and sines, by the others

    def found(self, forms: Iterable[Expr]) -> "Still":
        """Differentiate forms along the rates until nothing new is zero."""
        queue = [*forms]
        for _ in range(MOST_ROUNDS):
            if not queue:
                break
            g = self.reduced(queue.pop(0))
            if vanishes(g):
                continue
            self.zero.append(g)
            self._solve(g)
            queue.append(self.moved(g))
        return self

    def moved(self, g: Expr) -> Expr:
        """Return the rate of an expression; in discrete time its next value."""
        if self.discrete:
            return g.xreplace(self.rates)
        return along(g, self.rates)

    def reduced(self, expression: Expr) -> Expr:
        """Return an expression where all that was found is zero, without factors that never are."""
        e, before = normal_form(expression), None
        while e != before:
            before, e = e, normal_form(e.xreplace(self.solved))
        if vanishes(e):
            return sympy.S.Zero
        numerator, _ = sympy.fraction(sympy.together(e))
        factors = sympy.Mul.make_args(factored(numerator))
        kept = [
            f.as_base_exp()[0] for f in factors if not _is_never_zero(f, self.fixed)
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
            if slope and not (is_free or is_within):
                self.solved[a] = -rest / slope
                return

    @property
    def is_rest(self) -> bool:
        """True if all rates are zero there."""
        values = (
            rate if not self.discrete else rate - s for s, rate in self.rates.items()
        )
        left = (self.reduced(value) for value in values)
        return all(vanishes(e) or any(vanishes(e - g) for g in self.zero) for e in left)

    @property
    def point(self) -> dict[Any, Expr] | None:
        """The one rest that is left: each state as a number; otherwise None."""
        values = {s: s for s in self.rates}
        for _ in values:
            values = {
                s: sympy.expand(v.xreplace(self.solved)) for s, v in values.items()
            }
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


def _calls_of(expression: Expr, state: Any) -> list:
    """Return the functions of an expression that hold a state."""
    return [f for f in expression.atoms(sympy.Function) if f.has(state)] or [
        sympy.Dummy()
    ]


def _is_never_zero(factor: Expr, fixed: set) -> bool:
    """Return whether a factor of an expression that is zero cannot be the one that is."""
    if not factor.free_symbols - fixed:
        return bool(factor.is_nonzero or factor.is_number)
    base, exponent = factor.as_base_exp()
    total = squares(base, fixed) if base.is_Add else None
    return bool(exponent.is_negative or base.is_positive) or bool(
        total and total.constant.is_positive
    )
