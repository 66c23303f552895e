"""V of a user along a diagram: it falls, and loses forms, or is pulled back."""

from typing import Any

import numpy as np
import sympy

from ...engine.diagram.symbol_names import TIME
from ...engine.diagram.wiring import wiring_of
from ..algebra.decide import never_positive, without_choices, without_fading
from ..algebra.exact import factored, normal_form, vanishes, whole_coefficients
from ..algebra.facts import has_time
from ..algebra.slopes import along
from ..algebra.sums_of_squares import lost_forms
from ..algebra.texts import short
from .certificates import Ways, of_system
from .conclusions import Condition, Status
from .judge import Fall, Verdict, judge
from .steps import Step, exact
from .system_refutation import RefutableSystem
from .ultimate_bounds import pulled_forms


class SystemCandidate(RefutableSystem):
    """A diagram with a V of the user, on symbols, or with parameters as their numbers."""

    # --- the questions --------------------------------------------------------------------------

    def fall(self) -> Fall:
        """Return what is shown of V' <= 0, where inputs that it depends on are 0 if need be."""
        steps, bound, claim = list[Step](), self.rate, f"V' = {self.shown_rate}"
        if self.claim is not None:
            excess = normal_form(self.rate - self.claim)
            holds = vanishes(excess) or self.never_positive(excess)
            bound, claim = self.claim, f"V' <= {self.text(self.claim)}"
            detail = "" if holds else f"left over: {short(excess)}"
            steps.append(exact(claim, holds, detail, "claimed"))
            if not holds:
                return Fall(steps, claim)
        zeroed, inputs = dict[Any, Any](), self.depends_on(bound)
        falls = self.falls(bound)
        if not falls and inputs:
            zeroed = {f: sympy.S.Zero for f in self.inputs if str(f.func) in inputs}
            zeroed |= {sympy.Derivative(f, TIME): sympy.S.Zero for f in zeroed}
            falls = self.never_positive(bound.xreplace(zeroed))
        where = f" where {' = '.join(inputs)} = 0" * bool(zeroed)
        if falls:
            bound = bound.xreplace(zeroed)
            form, states = normal_form(bound), {*self.states}
            lower = without_choices(form, states)
            if lower is None:
                lower = without_fading(form, states) or form
            if lower != form:
                bound, claim = lower, f"V' <= {self.text(factored(lower))}"
            bounded = {*(self.least or (f for f in self.forms if f.is_Symbol))}
            variables = (*self.states, *self.inputs)
            loss = -whole_coefficients(normal_form(bound), variables)
            losses = self.lost = lost_forms(loss, self.fixed, bounded)
            shows = f"falls{' loses' * bool(losses)}"
            steps.append(exact(f"{claim} <= 0{where}", True, "", shows))
            fall = Fall(steps, f"{claim} <= 0", losses, short(self.text(-bound)))
        else:
            fall, zeroed = self._pulled(steps, claim), {}
        fall.conditions += self.conditions(inputs if zeroed else [])
        fall.zeroed = zeroed
        return fall

    def _pulled(self, steps: list[Step], claim: str) -> Fall:
        """Return what is shown of a V' that pulls V back but for a constant."""
        bound = pulled_forms(self) if self.forms else None
        if bound is None:
            failed = [] if self.claim is not None else [exact(f"{claim} <= 0", False)]
            return Fall([*steps, *failed], claim)
        shown = bound.claim if self.claim is None else f"{claim}, and {bound.claim}"
        return Fall([*steps, *bound.steps], shown, level=bound.level)

    def conditions(self, zeroed: list[str]) -> list[Condition]:
        """Return where V' is as shown."""
        found = []
        if has_time(self.V, self.rate):
            found.append(Condition("t >= 0"))
        if zeroed:
            found.append(Condition("zero inputs", " = ".join(zeroed)))
        nodes = wiring_of(self.system).nodes
        stand_ins = [node.system.approximation for node in nodes]
        if any(stand_ins):
            of = ", ".join(filter(None, stand_ins))
            found.append(Condition("approximation", of))
        return found + [Condition("values")] * self.are_numbers

    def ends_at(self, low: np.ndarray, high: np.ndarray) -> list[dict]:
        """Return the rests between states, to one of which every run comes; [] if not known."""
        shown = judge(self, refute=False)
        if shown.conclusion == "asymptotically stable":
            return [dict(self.least or {})]
        if shown.conclusion != "comes to rest":
            return []
        motion = self.moving(dict.fromkeys(self.inputs, sympy.S.Zero))
        motion.outside()
        return motion.still_set(self.lost).rests(low, high)

    def ways(self, fall: Fall) -> Ways:
        """Return the ways to write V' as a sum, for a certificate."""
        return of_system(self, fall)

    # --- V' -------------------------------------------------------------------------------------

    def falls(self, bound: sympy.Expr) -> bool:
        """Return whether V' or a bound is never positive, as it is, reduced, or by states."""
        terms = sympy.Add.make_args(bound)
        if all(bool(term.is_nonpositive) for term in terms) or self.never_positive(
            bound
        ):
            return True
        if self.claim is not None:
            return never_positive(bound, self.fixed)
        self.rate = reduced(bound)
        if self.never_positive(self.rate):
            return True
        return not self.eq.discrete and self._falls_by_state()

    def _falls_by_state(self) -> bool:
        """Return whether V' falls without the terms of rates that go down V, as friction does.

        They are -dV/dx_i times what is not negative.  The other terms may cancel, as forces that do
        no work do.
        """

        def goes_down(rate: sympy.Expr, slope: sympy.Expr) -> bool:
            return self.never_positive(sympy.cancel(rate / slope))

        remaining = list[sympy.Expr]()
        for s, rate in {TIME: sympy.S.One, **self.motion}.items():
            slope = normal_form(along(self.V, {s: sympy.S.One}))
            if slope == 0 or goes_down(rate, slope):
                continue
            terms = sympy.Add.make_args(rate)
            undecided = [g for g in terms if g == rate or not goes_down(g, slope)]
            remaining += [slope * term for term in undecided]
        return self.never_positive(sympy.Add(*remaining))

    def verdict(self, status: Status, claim: str, **fields: Any) -> Verdict:
        """Return a verdict on V, in the diagram's own signals."""
        if status == "open":
            claim = f"V' = {self.shown_rate}; {claim}"
        rate, V = self.readable_rate(), self.in_signals(self.V)
        inputs = tuple(self.depends_on(self.rate))
        return Verdict(status, claim, V=V, rate=rate, inputs=inputs, **fields)


def reduced(rate: sympy.Expr) -> sympy.Expr:
    """Return an expression whose divisors contain angles as one reduced fraction."""
    divisors = (p.base for p in rate.atoms(sympy.Pow) if p.exp.is_negative)
    if not sympy.Mul(*divisors).has(sympy.sin, sympy.cos):
        return rate
    numerator, divisor = map(
        normal_form, sympy.fraction(sympy.together(normal_form(rate)))
    )
    return sympy.cancel(numerator / divisor)
