"""States that V does not contain: which are bounded, and which exist for all times.

Where V does not rise, each form of V is bounded: a linear form in one state bounds that state.
States that no form bounds are judged by their rates.  Linear ones with a Hurwitz matrix stay
bounded; with rates that grow at most linearly in them they exist for all times (Gronwall's lemma);
s' = 1 + s^2 escapes at t = pi/2.  Inputs are bounded.
"""

from collections.abc import Iterable, Mapping, Set
from dataclasses import dataclass, field
from itertools import zip_longest
from typing import Any

import sympy
from sympy import Dummy, Expr, Matrix, S, Symbol, Tuple, diff, expand, sin
from sympy.utilities.iterables import strongly_connected_components

from ...engine.diagram.symbol_names import TIME
from ...engine.diagram.symbolic_equations import Equations
from ..algebra.facts import CLIP, inputs_in
from ..algebra.slopes import along, degree
from ..algebra.sums_of_squares import squares
from .conclusions import Condition
from .statements import Statement, are, joined, said
from .steps import How, Step, exact

ANGLES = (sin, sympy.cos)
CLOCK = Symbol("t", nonnegative=True)


@dataclass
class Motion:
    """Rates of states with inputs of any bounded value, and what V bounds of the states."""

    eq: Equations
    rates: dict[Any, Expr]  # of the states in which V is written
    fixed: set  # symbols of parameters
    intervals: set  # between breakpoints
    forms: list[Expr]  # that V bounds
    exist: Set[Any] = frozenset()  # states that exist for all times, however they grow
    free: list[Any] = field(default_factory=list)  # states that nothing bounds
    bounded: dict[Any, Expr] = field(
        default_factory=dict
    )  # states, by what bounds them
    conditions: list[Condition] = field(default_factory=list)  # without those on inputs
    driving: set = field(default_factory=set)  # inputs that have to be bounded
    in_box: Set[Any] = frozenset()  # inputs that have bounds
    off_zero: Set[Any] = frozenset()  # states above 0 that V keeps away from it
    near: set = field(default_factory=set)  # bounded states that may come near 0

    def __post_init__(self) -> None:
        functions = {f for port in self.eq.inputs.values() for f in port.flat}
        self.inputs = {f: Dummy(str(f.func), real=True) for f in functions}
        rates = {f.diff(TIME): Dummy(f"{f.func}'", real=True) for f in functions}
        self.input_rates = set(rates.values())
        self.still = rates | self.inputs
        self.rates = {s: self.quiet(rate) for s, rate in self.rates.items()}

    @property
    def where(self) -> list[Condition]:
        """The conditions of what was shown so far."""
        driving = self.driving - self.in_box
        driven = Condition("bounded inputs", self._names_of(driving))
        return self.conditions + [driven] * bool(driving)

    def quiet(self, expression: Expr) -> Expr:
        """Return an expression with a symbol for each input, and for its rate."""
        return expression.xreplace(self.still)

    def rate_of(self, form: Expr) -> Expr:
        """Return the rate of a form of states, inputs and time, expanded."""
        along_time = {TIME: S.One, **self.rates}
        along_time |= {s: self.still[f.diff(TIME)] for f, s in self.inputs.items()}
        return expand(along(self.quiet(form), along_time))

    # --- states that V does not contain ------------------------------------------------------

    def outside(self) -> Step:
        """Return the step that the states that V does not contain exist, with its conditions."""
        forms = _bounded_forms(
            [self.quiet(form) for form in self.forms], self.rates, self.fixed
        )
        bounded, outside = _bounded_states(forms, self.rates, self.fixed)
        self._note(bounded)
        if not outside:
            return exact("V holds every state", True, "", "exists")
        rates = {s: self.rates[s].xreplace(self.bounded) for s in outside}
        jumps = {
            s: self.quiet(after).xreplace(self.bounded)
            for change in self.eq.jumps.values()
            for s, after in change.items()
            if s in outside and after != s
        }
        # nothing is known of an opaque source, not even that it has a value at all times
        sources = inputs_in(Tuple(*rates.values()))
        how: How = "sampled" if sources else "exact"
        condition = said(", if {} bounded", self._names_of(sources)) if sources else ""
        stable = list[Any]()
        self.free = outside
        for states in groups_of_drivers(rates):
            own_rates = [rates[s].xreplace(self.bounded) for s in states]
            if not jumps.keys() & {*states} and self._is_linear_and_stable(
                own_rates, states
            ):
                stable += states
                self.driving |= self.inputs_of(own_rates)
                self.free = [s for s in self.free if s not in states]
                self._note({s: Dummy(str(s), real=True) for s in states})
        if stable:
            names = are(_names(self.eq, stable))
            self.conditions.append(Condition("outside V, bounded", names))
            claim = said("{} stable, driven by what is bounded{}", names, condition)
        # a rate as it is or expanded, which hides roots
        unbounded = [s for s in self.free if s not in self.exist]
        their_rates = [rates[s].xreplace(self.bounded) for s in unbounded]
        written: list[tuple] = [(rate, expand(rate)) for rate in their_rates]
        written += [(jumps[s],) for s in unbounded if s in jumps]
        exist = self.eq.discrete or all(
            min(degree(f, unbounded.__contains__) for f in forms_of_rate) <= 1
            for forms_of_rate in written
        )
        if self.free:
            free = _names(self.eq, self.free)
            listed = joined(", ", map(Symbol, free))
            name, of = ("outside V", are(free)) if exist else ("existence", listed)
            self.conditions.append(Condition(name, of))
            grow = ", may grow, and" if exist else ","
            claim = said(
                "{}: not held by V{} exist for all t{}", listed, grow, condition
            )
        shows, detail = ("exists", "") if exist else ("", "not shown")
        return Step(claim, exist, how if exist else "exact", detail, False, shows)

    def _note(self, bounded: dict[Any, Expr]) -> None:
        """Note bounded states; 1/s of a state s above 0 may grow without end."""
        near = {s for s in bounded if s.is_positive and s not in self.off_zero}
        self.near |= near
        self.bounded |= bounded | {s: CLIP(s, 0, 1) for s in near}

    def inputs_of(self, rates: Iterable[Expr]) -> set:
        """Return the inputs, and opaque sources, that rates depend on."""
        total = Tuple(*rates)
        used = {f for f, s in self.inputs.items() if total.has(s)}
        return used | inputs_in(total)

    def _names_of(self, inputs: Iterable[Any]) -> Statement:
        """Return "u is" or "u, v are", each port of inputs once."""
        ports = [*self.eq.inputs.items()]
        used = {*inputs}
        names = [port for port, symbols in ports if used & {*symbols.flat}]
        free_names = {f for _, symbols in ports for f in symbols.flat}
        return are(names + sorted(str(f.func) for f in used - free_names))

    def _is_linear_and_stable(self, rates: list, states: list) -> bool:
        """Return whether rates are linear in some states, stable, and driven by what is bounded.

        The rate of a single state may be a polynomial, with an odd power that leads: -s^3 + s.
        """
        expanded = Matrix([expand(rate) for rate in rates])
        J = expanded.jacobian(states)
        remainder = expanded - J * Matrix(states)
        powers = None if states[1:] else expanded[0].as_poly(*states)
        if powers and powers.degree() % 2 and not self.eq.discrete:
            leading, *others = powers.all_coeffs()
            is_far = leading.is_negative and not leading.free_symbols - self.fixed
            return is_far and not any(map(self.not_bounded, others))
        if J.free_symbols - self.fixed or remainder.has(*states):
            return False
        if any(self.not_bounded(e) for e in remainder):
            return False
        return is_stable(J, self.eq.discrete)

    def not_bounded(self, expression: Expr) -> list[str]:
        """Return the names of what may take an expression beyond every bound."""
        e = self.quiet(expression).xreplace(self.bounded).xreplace({TIME: CLOCK})
        states = {*self.free, *self.near, *self.intervals, *self.input_rates, CLOCK}
        if degree(e, states.__contains__) == 0:
            return []
        alone = [s for s in states if degree(e, {s}.__contains__) > 0]
        loose = alone or e.free_symbols & states
        return sorted(str(s).removeprefix("_") for s in loose)


def _bounded_forms(forms: list, motion: dict, fixed: set) -> list[Expr]:
    """Return forms that are bounded, of those that V contains, and the forms in them.

    A sine of half an angle bounds the angle up to whole turns, which is all that counts where
    nothing else depends on it.  A form that grows with time bounds nothing.
    """
    expressions = (*motion.values(), *forms)
    turns = {call for e in expressions for call in e.atoms(*ANGLES)}
    # functions of angles that whole turns leave as they are, as th**2 is none
    periodic = {
        call: Dummy()
        for call in turns
        if not any(diff(call.args[0], s).free_symbols - fixed for s in motion)
    }
    without_angles = [e.xreplace(periodic) for e in expressions]
    bounded = []
    for form in forms:
        inner = form.as_coeff_Mul()[1]
        if isinstance(inner, sin):
            states = inner.free_symbols - fixed
            is_read = any(e.has(*states) for e in without_angles)
            form = S.Zero if is_read else inner.args[0]
        if degree(form, lambda s: s == TIME) == 0:
            bounded.append(form)
    sums = filter(None, (squares(form, fixed) for form in bounded))
    return bounded + [form for total in sums for form in total.forms]


def _bounded_states(
    forms: list, motion: dict, fixed: set
) -> tuple[dict[Any, Expr], list]:
    """Return states as what bounds them, in the free states, and the free states.

    A form in one state bounds it; where each form has several states, the state that moves most
    simply is free, and the forms bound the others.
    """
    remaining, bounded, free = list(motion), dict[Any, Any](), list[Any]()
    while remaining:
        solved = (_state_of(form.xreplace(bounded), remaining, fixed) for form in forms)
        state = next(filter(None, solved), None)
        if state is not None:
            bounded |= state
            remaining = [s for s in remaining if s not in state]
            continue
        free.append(_simplest(remaining, free, motion, fixed))
        remaining.remove(free[-1])
    return bounded, free


def _simplest(remaining: list, free: list, motion: dict, fixed: set) -> Any:
    """Return the state that moves most simply, of those that are left."""
    is_state = {*remaining, *free}.__contains__

    def order(s: Any) -> tuple:
        varies = bool(diff(motion[s], s).free_symbols - fixed)
        return varies, degree(motion[s], is_state)

    return min(remaining, key=order)


def _state_of(form: Expr, remaining: list, fixed: set) -> dict[Any, Expr] | None:
    """Return the single state of a form, if it has one, in terms of bounded symbols."""
    states = [s for s in remaining if form.has(s)]
    if len(states) != 1:
        return None
    (s,), bound = states, Dummy("bound", real=True)
    if not form.is_polynomial(s):  # s and what is bounded whatever s is
        shift = expand(form - s)
        return {s: bound} if degree(shift, lambda a: a == s) == 0 else None
    leading, *coefficients = sympy.Poly(form, s).all_coeffs()
    if not leading.is_nonzero or leading.free_symbols - fixed:
        return None
    if len(coefficients) == 1:
        return {s: (bound - coefficients[0]) / leading}
    # of higher degree it bounds s where nothing else in it moves freely
    moving = form.free_symbols - fixed - {s}
    return {s: bound} if all(isinstance(o, Dummy) for o in moving) else None


def _names(eq: Equations, free: list) -> list[str]:
    """Return the names of free states: a port where all of it is free."""
    names = []
    for port, symbols in eq.states.items():
        members = [s for s in symbols.flat if s in free]
        is_whole = len(members) == symbols.size
        names += [port] if is_whole else [str(s) for s in members]
    # a state that is no output has the name block:state
    return [name.rpartition(":")[2] for name in names]


def groups_of_drivers(rates: Mapping[Any, Expr]) -> list[list]:
    """Return groups of states that drive each other, each after those that drive it."""
    drivers = [(s, d) for s in rates for d in rates[s].free_symbols & rates.keys()]
    return strongly_connected_components(([*rates], drivers))


def is_stable(A: Matrix, discrete: bool) -> bool:
    """Return whether a linear motion goes to zero; in discrete time by (A - I)/(A + I)."""
    if not discrete:
        return hurwitz(A)
    identity = sympy.eye(A.rows)
    return (A + identity).det() != 0 and hurwitz((A - identity) * (A + identity).inv())


def hurwitz(A: Matrix) -> bool:
    """Return whether all eigenvalues have a negative real part, by Routh's table, exactly."""
    row, next_row = (A.charpoly().all_coeffs()[k::2] for k in (0, 1))
    while next_row and next_row[0].is_positive:
        share = row[0] / next_row[0]
        pairs = zip_longest(row[1:], next_row[1:], fillvalue=0)
        row, next_row = next_row, [sympy.cancel(a - share * b) for a, b in pairs]
    return not next_row
