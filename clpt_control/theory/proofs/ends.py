"""Ends of a motion: what goes to zero where V' <= -sum of q^2, and what is left in the end.

    int q^2 dt <= V(0), q' bounded          =>  q -> 0                          (Barbalat's lemma)
    q -> 0, q' = r + z, z -> 0, r' bounded  =>  r -> 0                          (Barbalat again)
    nothing depends on time, V bounds x     =>  x -> where V' = 0 for good:     (LaSalle)
                                                q = 0, q' = 0, q'' = 0, ...

`barbalat` and `lasalle` each begin with their premises.  Source: Khalil, H. K. (2002), Nonlinear
Systems, 3rd ed., Lemma 8.2 and Theorem 4.4.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from itertools import product
from typing import Any, NamedTuple

import sympy
from sympy import Dummy, Expr, Mul, Poly, S, Tuple, diff, fraction, pi, sin, together

from ...engine.diagram.symbol_names import TIME
from ..algebra.decide import never_positive
from ..algebra.decided import decided
from ..algebra.exact import coarse, factored, normal_form, terms_of, vanishes
from ..algebra.facts import RISING, functions_in, side_of, stays_off_zero
from ..algebra.slopes import along, jumps_nowhere, of_same_sign, slope_in
from ..algebra.sums_of_squares import Squares, rising_in, squares, zero_of
from .answers import Definite, Fall
from .outside import ANGLES, Motion
from .statements import Statement, joined, said
from .steps import Step, exact
from .where import Where

MOST_FORMS = 80  # that are factored, in all cases together
MOST_ROUNDS = 12  # forms of one case that are differentiated
MOST_OPERATIONS = 100  # of a rate; longer ones are left out
MOST_VARIABLES = 7  # of polynomials whose zeros are counted


class Ends(NamedTuple):
    """Forms that go to zero, and the set that runs approach."""

    steps: list[Step]
    of: Statement | str  # "x goes"
    # the states that V' = 0 leaves, by cases; none if LaSalle's premises do not hold
    cases: "Sequence[Still]" = ()


def ends(candidate: Any, definite: Definite, fall: Fall, motion: Motion) -> Ends:
    """Return what goes to zero of what V' loses, by the way that shows the most."""
    least = definite.least if definite.is_steady else None
    # on the way, a loss that has a step or depends on time may fade off the rest
    fading = TIME, *candidate.intervals
    lost = [
        q for q in (fall.losses or fall.slow) if jumps_nowhere(q) and not q.has(*fading)
    ]
    of = fall.of or candidate.go(fall.losses)
    if least and zero_of(Squares(S.Zero, [], lost), [*least]) == least:
        claim = "V' < 0 but at the rest"
        claim += ", or at times: its integral is infinite off the rest" * bool(
            fall.slow
        )
        return Ends([exact(claim, True, "", "limit rest")], of)
    if fall.slow:
        return Ends([], of)
    cases = lasalle(candidate, fall, motion)
    # of a friction at one side of g = s', s rises for good to a limit, where V is as before
    sides = [side_of(q) for q in lost]
    rising = {g for rate in motion.rates.values() for g in (rate, -rate)}
    if rising & {*sides} and not candidate.eq.discrete:
        stopped = [
            q if g not in rising else g for q, g in zip(lost, sides, strict=True)
        ]
        limit = lasalle(candidate, replace(fall, losses=stopped), motion)
        cases = limit if least and point_of(limit) == least else cases
    zero = [g for g in zero_in_all(cases, fall.losses) if jumps_nowhere(g)]
    if len(zero) > len(fall.losses) or (zero and not fall.of):
        of = candidate.go(zero)
    if not (cases and all(case.is_rest for case in cases)):
        return barbalat(candidate, fall, motion, of, cases)
    zeros = ((said("{} = 0", candidate.text(g)) for g in case.zero) for case in cases)
    found = joined(" or ", (joined(", ", of_case) for of_case in zeros))
    claim = said("where V' = 0 for good nothing moves: {}", found)
    shows = "limit still" + " isolated" * all(case.comes_to_one for case in cases)
    convex_in = definite.forms if definite.is_convex else ()
    slopes = [slope_in(candidate.V, s) for s in convex_in]
    is_least = slopes and not any(c.reduced(g) for c in cases for g in slopes)
    shows += " rest" * bool(is_least or point_of(cases) is not None)
    return Ends([exact(claim, True, "", shows)], of, cases)


def barbalat(
    candidate: Any, fall: Fall, motion: Motion, of: str, cases: "Sequence[Still]"
) -> Ends:
    """Return the forms q that go to zero, as V' loses q^2 and so its integral is finite.

    Premises, form by form: q has no step; if q jumps with the states, it does so at the jumps of
    one block, a period apart; q' is bounded where V is.  In discrete time q^2 has a finite sum and
    needs no premise.  If LaSalle's principle leaves no `cases`, the lemma is applied to rates too.
    """
    if candidate.eq.discrete:
        step = exact("the sum of what V loses is finite", True, "", "limit")
        return Ends([step], of, cases)
    claim = "the rate of {} is bounded where V is"
    unmet = {q: _unmet_premise(candidate, motion, q) for q in fall.losses}
    failed = [
        replace(exact(said(claim, candidate.text(q)), False, premise), needed=False)
        for q, premise in unmet.items()
        if premise
    ]
    zero = [q for q, premise in unmet.items() if not premise]
    if failed and zero:
        of = candidate.go(zero)
    *names, verb = getattr(of, "parts", (of,))
    if verb.strip() not in ("go", "goes"):
        names = [candidate.text(q) for q in fall.losses]
    names = joined(", ", names)
    if not zero:
        missing = replace(failed[0], claim=said(claim, names), needed=True)
        return Ends([missing], of, cases)
    # others than what V loses, where V' = 0 for good
    has_others = not failed and of != (fall.of or candidate.go(zero))
    shows = "limit" + " rates" * has_others
    steps = [exact(said(claim, names), True, "", shows)]
    more = [] if cases or fall.of else zero_by_rates(candidate, motion, zero)
    if more:
        added = candidate.go(more)
        steps.append(
            exact(
                said("{} to zero, as rates of {} do", added, names),
                True,
                "",
                "limit rates",
            )
        )
        of = candidate.go([*zero, *more])
    return Ends(steps + failed, of, cases)


def _unmet_premise(candidate: Any, motion: Motion, q: Expr) -> str:
    """Return the premise of Barbalat's lemma that a form does not meet, or ""."""
    if not jumps_nowhere(q):
        return said("{} may jump", candidate.text(q))
    jumping = candidate.jumping(q)
    if len(jumping) > 1 or not jumping <= candidate.periodic:
        return f"it jumps with {' and '.join(sorted(jumping))}, at times of any kind"
    rate = motion.rate_of(q)
    if loose := motion.not_bounded(rate):
        return f"it holds {', '.join(loose)}, not known to be bounded there"
    motion.driving |= motion.inputs_of([rate])
    return ""


def zero_by_rates(candidate: Any, motion: Motion, zero: Sequence[Expr]) -> list[Expr]:
    """Return forms that go to zero because they are left of the rates of forms that do.

    q' = r + z, where r is q' with zero in place of what goes to zero.  q' is continuous, and its
    slopes in those states are bounded, so z goes to zero; then r does, if r' is bounded, and the
    one factor of r that may.  Premise: states do not jump, and V bounds them all.
    """
    if motion.free or motion.near or candidate.eq.jumps:
        return []
    case = Still(motion.rates, motion.fixed, candidate.V)
    for q in zero:
        case.add(motion.quiet(q))
    for q in case.zero:  # grows
        rate, moved = motion.rate_of(q), {s: Dummy() for s in case.solved}
        slopes = [along(e, moved) for e in (rate, *case.solved.values())]
        is_short = rate.count_ops() <= MOST_OPERATIONS
        is_known = is_short and len(case.zero) < MOST_ROUNDS and jumps_nowhere(rate)
        if not is_known or any(map(motion.not_bounded, slopes)):
            continue
        form = case.in_free_states(rate)
        factors = Mul.make_args(factored(form))
        loose = Mul(*(f for f in factors if not case.is_never_zero(f)))
        base, power = loose.as_base_exp()
        is_one = base.has(*motion.rates) and not base.is_Mul and power.is_positive
        if is_one and not _unmet_premise(candidate, motion, form):
            case.add(case.plain(base))
    return case.zero[len(zero) :]


# --- LaSalle --------------------------------------------------------------------------------------


def lasalle(candidate: Any, fall: Fall, motion: Motion) -> "list[Still]":
    """Return the cases that V' = 0 for good leaves; none if a premise fails.

    Premises: nothing depends on time or inputs; V bounds every state; no state jumps; rates and
    what V' loses are continuous.  If only one of the two is continuous, a single point is an end,
    and nothing else.  If none is, as of x' = -x where(y > 0, 0, 1)^2, y' = -y, a run may come to
    rest where V' < 0.
    """
    rates = [*motion.rates.values()]
    moves = Tuple(candidate.V, *rates).has(
        TIME, *candidate.intervals, *motion.inputs.values()
    )
    if moves or motion.free or motion.near or candidate.eq.jumps:
        return []
    continuous = [all(map(jumps_nowhere, of)) for of in (rates, fall.losses)]
    if not any(continuous):
        return []

    def cases_with(number: Callable[[Expr], Expr]) -> list[Still]:
        """Return what V' = 0 leaves of equations with their numbers changed."""
        rates = {s: number(rate) for s, rate in motion.rates.items()}
        eq, where = candidate.eq, candidate.where
        start = Still(rates, motion.fixed, candidate.V, eq.discrete, where)
        return cases_of(start, [*map(number, fall.losses)], all(continuous))

    cases = cases_with(lambda e: e)
    if any(coarse(e) != e for e in (*rates, *fall.losses)):
        # a difference of numbers may be their rounding: no conclusion depends on it
        rough = cases_with(coarse)
        if all(case.is_rest for case in cases) > all(case.is_rest for case in rough):
            return []
        if point_of(rough) is None and point_of(cases) is not None:
            return []
    return cases if all(continuous) or point_of(cases) is not None else []


def cases_of(start: "Still", forms: Sequence[Expr], moving: bool) -> "list[Still]":
    """Return the cases in which forms, and if moving their rates, are zero for good.

    If a product of continuous factors is zero for good, one factor is zero on some interval of
    time, and such intervals lie dense.  So each factor is a case; if nothing moves in each case,
    nothing moves at all.  In discrete time another factor may be zero at each step: a product is
    one form.
    """
    cases, unfinished = list[Still](), [(start, [*forms])]
    for _ in range(MOST_FORMS):
        if not unfinished:
            break
        case, queue = unfinished.pop()
        if not queue:
            cases.append(case)
            continue
        form, *queue = queue
        factors = case.factors(form)
        if not factors:  # the form is never zero: no run stays in this case
            continue
        product = Mul(*factors)
        if factors[1:] and not case.discrete:
            case.zero.append(product)
            unfinished += [(case.copy(), [f, *queue]) for f in reversed(factors)]
            continue
        if product != 0:
            case.add(product)
            queue += case.squares_in(product) or case.rates_of(product) * moving
        unfinished.append((case, queue))
    return cases + [case for case, _ in unfinished]


def zero_in_all(cases: "Sequence[Still]", losses: Sequence[Expr]) -> list[Expr]:
    """Return forms that are zero in all cases, without those that follow from others."""
    if not cases:
        return []
    start, *further = cases
    shared = replace(start, zero=[], solved={})
    for g in sorted((*start.zero, *losses), key=lambda g: g.is_Mul):
        if all(case.reduced(g) == 0 for case in further) and shared.reduced(g) != 0:
            shared.add(g)
    return shared.zero


def point_of(cases: "Sequence[Still]") -> dict[Any, Expr] | None:
    """Return the one rest that all cases leave, each state as a number; otherwise None."""
    points: list[Any] = [case.point for case in cases]
    if not points or None in points:
        return None
    common = points[0]
    agree = (vanishes(point[s] - common[s]) for point in points for s in common)
    return common if all(agree) else None


@dataclass
class Still:
    """A case: the expressions that are zero for good where others are, as they are found."""

    rates: dict[Any, Expr]
    fixed: set
    V: Expr  # which does not rise, so it comes to a level
    discrete: bool = False
    where: Where = field(default_factory=Where)  # sets of states
    zero: list[Expr] = field(default_factory=list)
    solved: dict[Any, Expr] = field(
        default_factory=dict
    )  # states and sines, by the others

    def copy(self) -> "Still":
        """Return the same case, to which other expressions can be added."""
        return replace(self, zero=[*self.zero], solved={**self.solved})

    def add(self, g: Expr) -> None:
        """Add an expression that is zero."""
        self.zero.append(g)
        self._solve(g)

    def squares_in(self, g: Expr) -> list[Expr]:
        """Return the forms of a sum of squares, which are zero where it is; [] for other sums."""
        positive = g.xreplace(self.where.squared)
        for e in (g, positive, -positive) if g.is_Add else ():
            total = squares(e, self.fixed)
            if total and total.forms[1:] and total.constant == 0:
                return self.where.in_states(total.forms)
        return []

    def rates_of(self, g: Expr) -> list[Expr]:
        """Return the rate of an expression, or its next value; [] if that is long."""
        if len(self.zero) > MOST_ROUNDS:
            return []
        rate = g.xreplace(self.rates) if self.discrete else along(g, self.rates)
        is_short = max(rate.count_ops(), terms_of(rate)) <= MOST_OPERATIONS
        return [rate] if is_short else []

    def reduced(self, expression: Expr) -> Expr:
        """Return 0, or the product of the factors of an expression that may be zero."""
        return Mul(*self.factors(expression))

    def factors(self, expression: Expr) -> list[Expr]:
        """Return the factors that may be zero of an expression where all that was found is zero."""
        e, before = normal_form(expression), None
        while e != before:
            before, e = e, normal_form(decided(e.xreplace(self.solved)))
        if vanishes(e):
            return [S.Zero]
        numerator, _ = fraction(together(e))
        factors = dict[Expr, None]()
        for factor in Mul.make_args(factored(numerator)):
            base = factor.as_base_exp()[0]
            if self.is_never_zero(factor):
                continue
            plain = self.plain(base)
            factors |= dict.fromkeys([base] if plain == base else self.factors(plain))
        signed = {*factors, *(-f for f in factors)}
        is_zero = any(signed >= {*Mul.make_args(g)} for g in self.zero)
        if is_zero or S.Zero in factors:
            return [S.Zero]
        return [*factors]

    def is_never_zero(self, factor: Expr) -> bool:
        """Return whether a factor of an expression that is zero cannot be the one that is.

        One that depends on time does not go to zero either.
        """
        if factor.has(TIME):
            return stays_off_zero(factor)
        if not factor.free_symbols - self.fixed:
            return bool(factor.is_nonzero)
        base, exponent = factor.as_base_exp()
        if isinstance(base, sympy.cos):
            sine = self.solved.get(sin(*base.args))
            return sine is not None and bool((1 - sine**2).is_nonzero)
        total = squares(base, self.fixed) if base.is_Add else None
        return bool(
            exponent.is_negative
            or stays_off_zero(base)
            or base.is_positive
            or (total and total.constant.is_positive)
        )

    def plain(self, h: Expr) -> Expr:
        """Return s, zero where a form is: of |s|, tanh(s), s + tanh(s), exp(s) - 1."""
        if isinstance(h, sympy.Abs):
            return h.args[0]
        h = of_same_sign(h)
        states = h.free_symbols - self.fixed
        if h.is_Add and functions_in(h) and len(states) == 1:
            (s,) = states
            if any(rising_in(e * h, s) for e in (s, -s)):
                return s
        if len(calls := h.atoms(*RISING)) == 1:
            (call,), word = calls, Dummy()
            slope = diff(h.xreplace({call: word}), word)
            value = -normal_form(h - slope * call) / slope
            is_number = not Tuple(slope, value).free_symbols - self.fixed
            inverse = call.inverse()(value)
            if is_number and inverse.is_real:
                return call.args[0] - inverse
        return h

    def _solve(self, g: Expr) -> None:
        """Solve an expression that is zero for a state or a sine, linear in it."""
        atoms = sorted({*self.rates} & g.free_symbols, key=str)
        for a in [*atoms, *sorted(g.atoms(sin), key=str)]:
            slope = diff(g, a) if a.is_Symbol else g.coeff(a)
            if slope.free_symbols - self.fixed or not slope.is_nonzero:
                continue
            remainder = normal_form(g - slope * a)
            if not remainder.has(a):
                self.solved[a] = -remainder / slope
                return

    @property
    def changes(self) -> list[Expr]:
        """The rate of each state; in discrete time by how much it changes."""
        return [r - s if self.discrete else r for s, r in self.rates.items()]

    @property
    def is_rest(self) -> bool:
        """True if all rates are zero there."""
        return all(self.reduced(change) == 0 for change in self.changes)

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
        if all(
            any(never_positive(sign * changes[s], self.fixed) for sign in (1, -1))
            for s in variables
        ):
            return True
        angles = {call.args[0] for form in forms for call in form.atoms(*ANGLES)}
        level = Dummy()
        forms.append(self.in_free_states(self.V) - level)
        for angle in angles:
            turned = {f(angle): Dummy() for f in ANGLES}
            forms = [form.xreplace(turned) for form in forms]
            forms.append(sympy.Add(*(value**2 for value in turned.values())) - 1)
            if len(angle.free_symbols) == 1 and angle.is_polynomial():
                variables -= angle.free_symbols
            variables |= {*turned.values()}
        parameters = sorted(Tuple(*forms).free_symbols & self.fixed, key=str)
        symbols = [*variables, level, *parameters]
        forms = [fraction(together(form))[0] for form in forms]
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
            sines = [g for g in self.solved if isinstance(g, sin) and g.has(s)]
            if s in self.solved:
                choices.append([self.solved[s]])
                continue
            if not sines or not Poly(sines[0].args[0], s).is_linear:
                return []
            slope, phase = Poly(sines[0].args[0], s).all_coeffs()
            turns = sorted((slope * end + phase) / pi for end in (a, b))
            counts = range(int(sympy.ceiling(turns[0])), int(sympy.floor(turns[1])) + 1)
            choices.append([(k * pi - phase) / slope for k in counts])
        points = (dict(zip(self.rates, p, strict=True)) for p in product(*choices))
        rests = [{s: v.xreplace(p) for s, v in p.items()} for p in points]
        numbers = all(v.is_number for p in rests for v in p.values())
        return rests if numbers else []
