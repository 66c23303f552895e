"""V' of verdicts as sums of terms that are not negative, for their files of Coq.

    V' = -e^T KD e - losses                                          a law that falls
    V' = -k e^2 + e d = -(k/2) e^2 - (k/2)(e - d/k)^2 + d^2/(2 k)    a law that is pushed
    V' = -sum of a s^2 - b s over errors s of V                      a law or a diagram with leaks
    V' = -(sum of squares)                                           any other diagram

Relations of a law's states, such as b = theta Q, are put in before.  `invariants` proves that they
are kept.
"""

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from itertools import product
from typing import Any, NamedTuple

import sympy
from sympy import (
    Abs,
    Add,
    Dummy,
    Expr,
    Mul,
    Rational,
    S,
    Symbol,
    Tuple,
    cos,
    cosh,
    exp,
    expand,
)
from sympy.core.function import AppliedUndef

from ...engine.diagram.symbol_names import TIME
from ..algebra.exact import factored, vanishes, with_tanh
from ..algebra.exact import terms_of as count_terms
from ..algebra.facts import (
    IN_COQ,
    ODD,
    RANGED,
    facts_of,
    functions_in,
    has_time,
    interval,
)
from ..algebra.gram import sum_of_squares
from ..algebra.slopes import along
from ..algebra.sums_of_squares import squares
from ..algebra.texts import short
from .answers import Definite, Fall
from .outside import CLOCK
from .ultimate_bounds import UltimateBound, in_errors_of_V


class NotASum(Exception):
    """V' is not written as a sum; the message is the reason."""


FORM = Symbol("s", real=True)
# positive but at 0 (1 - cos at whole turns too), with their texts in Coq
SHAPES: dict[Expr, str] = {
    sympy.sympify(text, {"s": FORM, "Rabs": Abs}): text
    for text in (
        "(1 - cos(s))",
        "(s * tanh(s))",
        "(Rabs(s) * s^2)",
        "(Rabs(s) - ln(1 + Rabs(s)))",
        "(sqrt(s^2 + 1) - 1)",
        "(cosh(s) - 1)",
        "(s * sinh(s))",
        "(s * atan(s))",
        "(exp(s) - s - 1)",
    )
}


class Term(NamedTuple):
    """A term weight factor g(form) that is not negative, g of `SHAPES` or an even power."""

    weight: Expr  # a positive parameter
    form: Expr
    shape: Expr = FORM**2
    factor: Expr = S.One  # not negative

    @property
    def value(self) -> Expr:
        """The term as an expression."""
        return self.weight * self.factor * self.shape.subs(FORM, self.form)

    def text(self, text: Callable[[Expr], str]) -> str:
        """Return the term in Coq, its weight times the shape of its form."""
        factor = f" * ({text(self.factor)})" * (self.factor != 1)
        if self.form == 1:
            return f"(({text(self.weight)}){factor})"
        return f"(({text(self.weight)}){factor} * {self.shape_at(text(self.form))})"

    def shape_at(self, form: str) -> str:
        """Return the shape of a form in Coq."""
        shape = SHAPES.get(self.shape) or f"{self.shape}".replace("**", "^")
        return re.sub(r"\(s\)|\bs\b", f"({form})", shape)

    @property
    def is_periodic(self) -> bool:
        """True of 1 - cos(s), which bounds no form."""
        return self.shape.has(cos)

    @property
    def function(self) -> str:
        """The shape as a function of Coq."""
        return f"(fun x => {self.shape_at('x')})"


def total(terms: Iterable[Term], text: Callable[[Expr], str]) -> str:
    """Return a sum of terms in Coq."""
    return " + ".join(term.text(text) for term in terms) or "0"


@dataclass
class Case:
    """Equations with V, and V' as a sum: V' + decay V + losses - push = 0."""

    motion: dict[Any, Expr]
    fixed: set  # symbols of parameters
    V: Expr
    rate: Expr  # V'
    terms: list[Term] = field(default_factory=list)  # of V
    losses: list[Term] = field(default_factory=list)
    push: Expr = S.Zero
    decay: Expr = S.Zero
    below: Expr | None = None  # V of a run begins below this level
    rest: Mapping[Any, Expr] = field(default_factory=dict)  # where V is least, if known
    lost: Iterable[Expr] = ()  # forms that go to zero by the verdict
    box: Mapping[Any, tuple] = field(default_factory=dict)  # input -> its bounds
    given: Mapping[Any, Expr] = field(default_factory=dict)  # margin -> its meaning

    @property
    def falls(self) -> bool:
        """True if V' = -losses."""
        return self.push == 0 and self.decay == 0


LEAST_DIVISOR = Rational(1, 100)  # that the tactic `bnd` tries
NOT_COMPUTED = {*IN_COQ} - {exp, cosh, Abs}  # in Coq, of numbers
PARTS = tuple(Rational(n, 20) for n in (20, 19, 16, 10))  # of a level, tried in turn
WEIGHTS = (S.Zero, S.Half, S.One, S(2))  # of what is left to the level, times squares
LEAST = Rational(1, 1000)  # of the squares of states, which V' loses
MOST_TERMS = 200  # of V, of V' and of rates
Ways = list[Callable[[], Case]]


# --- sums of squares -----------------------------------------------------------------------------


def terms_of(expression: Expr, fixed: set) -> list[Term]:
    """Return an expression as a sum of terms that are not negative."""
    if vanishes(expression):
        return []
    total = squares(expression, fixed)
    if total is not None and total.constant.is_nonnegative:
        summands = [*total.terms, total.constant]
    else:
        summands = [*Add.make_args(expand(expression))]
        if not all(map(is_nonnegative, summands)):
            summands = [factored(expression)]
        if not is_nonnegative(summands[0]):
            return by_facts(expression)
    summands = [part for summand in summands for part in apart(summand, fixed)]
    return [term_of(summand, fixed) for summand in summands if summand != 0]


def by_facts(expression: Expr) -> list[Term]:
    """Return an expression as squares times what is known of its functions."""
    calls = sorted(functions_in(expression), key=str)
    names = {call: Dummy("call", real=True) for call in calls}
    facts = [fact.xreplace(names) for fact in facts_of(calls)]
    found = sum_of_squares(expand(expression.xreplace(names)), facts)
    if found is None:
        raise NotASum(f"{short(expression)} is not known as a sum of squares")
    back = {name: call for call, name in names.items()}
    return [
        Term(weight, form.xreplace(back), factor=factored(fact.xreplace(back)))
        for weight, fact, form in found.terms
    ]


def is_nonnegative(term: Expr) -> bool:
    """Return whether the factors of a term show that it is not negative, such as s tanh(s)."""
    term = term.xreplace({TIME: CLOCK})
    for call in term.atoms(*ODD):
        powers = term.as_powers_dict()
        if powers[call] % 2 and powers[call.args[0]] % 2:
            term = term / (call * call.args[0])
    factors = Mul.make_args(term)
    return all(
        f.is_nonnegative or least(f.as_base_exp()[0]) >= 0 for f in factors
    ) or bool(term.is_nonnegative)


def apart(term: Expr, fixed: set) -> Iterable[Expr]:
    """Return the parts of a term whose weight is a sum with even powers: (1 + b^2) x^2."""
    if not (is_nonnegative(term) or has_time(term)):  # a weight of several fractions
        term = factored(sympy.together(term))
    weight, form = term.as_independent(*(term.free_symbols - fixed), as_Add=False)
    has_signs = all(s.is_positive or s.is_negative for s in weight.free_symbols)
    return (term,) if has_signs else (w * form for w in Add.make_args(weight.expand()))


def term_of(summand: Expr, fixed: set) -> Term:
    """Return a summand by the shape that it has."""
    moving = summand.free_symbols - fixed
    common = sympy.factor_terms(summand)  # a (1 - cos(s)) of a - a cos(s)
    weight, varying = common.as_independent(*moving, as_Add=False)
    if weight.is_negative:
        weight, varying = -weight, expand(-varying)
    calls = varying.atoms(sympy.Function)
    arguments = {a for call in calls for a in call.args} | moving
    for shape in SHAPES:
        for form in sorted(arguments, key=str):
            if expand(varying - shape.subs(FORM, form)) == 0:
                return Term(weight, form, shape)
    base, power = varying.as_base_exp()
    if power.is_Integer and power.is_positive and power.is_even and weight.is_positive:
        return Term(weight, base, FORM**power)
    if summand.is_Add:
        raise NotASum(f"{short(summand)} is no product")
    kinds = [(c.args[0], FORM * c.func(FORM)) for c in varying.atoms(*ODD)]
    powers = (factor.as_base_exp() for factor in Mul.make_args(varying))
    kinds += [(base, FORM**n) for base, n in powers if n.is_even and n.is_positive]
    for form, shape in kinds if weight.is_positive else ():
        factor = varying / shape.subs(FORM, form)
        if is_nonnegative(factor):
            return Term(weight, form, shape, factor)
    weight, factor = summand.as_coeff_Mul()
    return Term(weight, S.One, factor=factor)


# --- V' as a sum ---------------------------------------------------------------------------------


def pulled(case: Case, V: Expr, rate: Expr, rest: Mapping, forms: Mapping) -> Case:
    """Complete the squares of V' in the errors of V, whose squares V is a sum of; as `forms`."""
    V_rate = expand(rate.xreplace({s: s + true for s, true in rest.items()}))
    shares = {s: sympy.diff(V, s, 2) / 2 for s in rest}
    pairs = {s: (-V_rate.coeff(s, 2), V_rate.coeff(s, 1)) for s in rest}
    rates = {s: a / (2 * shares[s]) for s, (a, _) in pairs.items() if a.is_positive}
    if not rates or len(rates) < len(rest):
        raise NotASum("V' does not pull all errors of V back")
    is_number = all(r.is_Rational for r in rates.values())
    decay = min(rates.values()) if is_number else Dummy("rate", positive=True)
    push = V_rate.xreplace(dict.fromkeys(rest, S.Zero))
    losses = []
    for s, (a, b) in pairs.items():
        spare = rates[s] - decay
        losses += [Term(shares[s], forms[s], factor=spare)] * (spare != 0)
        losses.append(Term(a / 2, forms[s] - b / a))
        push += b**2 / (2 * a)
    fixed = case.fixed | decay.free_symbols
    return replace(case, losses=losses, push=push, decay=decay, fixed=fixed)


def of_system(case: Any, definite: Definite, fall: Fall) -> Ways:
    """Return the ways to write V' of a `SystemCandidate`."""

    def read(e: Expr) -> Expr:
        return without_calls(e.xreplace(fall.zeroed))

    def system() -> Case:
        refuse(case)
        motion = {s: read(rate) for s, rate in case.motion.items()}
        V, rate, lost = (
            read(case.V),
            with_tanh(read(case.rate)),
            [*map(read, fall.losses)],
        )
        moves = Tuple(*(definite.least or {}).values()).has(TIME)
        terms = terms_of(V, case.fixed)
        box = {read(d): case.where.box[d] for d in case.where.bounded}
        written = Case(motion, case.fixed, V, rate, terms, lost=lost, box=box)
        written.given = case.given
        return written if moves else replace(written, rest=definite.least or {})

    def falls() -> Case:
        written, most = system(), case.where.largest(case.rate, case.never_positive)
        if most is None:
            return replace(written, losses=terms_of(-written.rate, case.fixed))
        losses = terms_of(read(-most), case.fixed) + within(most)
        return replace(written, losses=losses)

    def within(most: Expr, waves: bool = False) -> list[Term]:
        """Return a bound of V' less V' as a sum of what that is at the corners of inputs."""
        terms = []
        if any(not vanishes(case.rate.diff(d, 2)) for d in case.where.box):
            raise NotASum("V' is not affine in an input")
        for shares, at in case.where.corners(case.rate, waves):
            for term in terms_of(read(most - at), case.fixed):
                # unevaluated, such that each factor keeps its sign
                factors = [f for f in (*map(read, shares), term.factor) if f != 1]
                terms.append(term._replace(factor=Mul(*factors, evaluate=False)))
        return terms

    def pulls() -> Case:
        terms, written = in_errors_of_V(case, definite), system()
        pull = terms and UltimateBound(case, terms).rate_bound()
        if terms is None or pull is None:
            raise NotASum("V' is no push less a rate times V")
        if not (case.where.box or all(n.is_Rational for n in pull)):
            return pulled(written, *terms._replace(rate=without_calls(terms.rate)))
        losses = within(pull.push - pull.decay * case.V, True)
        return replace(written, losses=losses, push=pull.push, decay=pull.decay)

    return [partial(checked, falls if fall.level is None else pulls)]


def in_region(region: Any, case: Any, level: float) -> Ways:
    """Return the way to write V' below a level, or part of it: -squares - squares (level - V)."""

    def below() -> Case:
        refuse(case)
        if region.V_at_rest != 0 or region.held:
            raise NotASum("V is not zero at the rest, or inputs are between bounds")
        motion = dict(zip(region.states, region.motion, strict=True))
        V, rate = expand(region.V), expand(along(region.V, motion))
        offs = [s - region.rest[s] for s in region.states]
        for part, weight in product(PARTS, WEIGHTS):
            top = part * Rational(f"{level:.4g}")
            room = expand(top - V)
            losses = [Term(LEAST, off) for off in offs]
            losses += [Term(weight, off, factor=room) for off in offs if weight]
            known = Add(*(term.value for term in losses))
            found = sum_of_squares(expand(-rate - known), [room])
            if found is not None:
                losses += [Term(w, form, factor=g) for w, g, form in found.terms]
                written = Case(motion, set(), V, rate, terms_of(V, set()), losses)
                return replace(written, below=top, rest=region.rest)
        raise NotASum("V' below the level is not known as a sum of squares")

    return [partial(checked, below)]


def checked(way: Callable[[], Case]) -> Case:
    """Return a case whose sum is V', in exact arithmetic."""
    case = way()
    for term in (*case.terms, *case.losses):
        if term.weight.has(*NOT_COMPUTED):
            raise NotASum(f"the sign of {term.weight} is not known to Coq")
    if any(t.value.has(Abs) and t.shape not in SHAPES for t in case.terms):
        raise NotASum(f"{short(case.V)} has |.|, whose rate is not printed")
    total = Add(*(term.value for term in case.losses), case.decay * case.V, case.rate)
    if not vanishes(total - case.push):
        raise NotASum("V' is less than the sum")
    # in the order of V, so that shares are compared in turn
    order = [(t.form, t.shape) for t in (*case.terms, *case.losses)]
    losses = sorted(case.losses, key=lambda t: order.index((t.form, t.shape)))
    return replace(case, losses=losses)


def refuse(case: Any) -> None:
    """Refuse what has no file: states that jump, sampled parts, guards, discrete time, sets."""
    written = Tuple(case.V, case.rate, *case.motion.values())
    for call in sorted(functions_in(written), key=str):
        if not isinstance(call, IN_COQ) and call.args != (TIME,):
            raise NotASum(f"{short(call)} has pieces, or no lemma in Runs.v")
    if case.eq.discrete:
        raise NotASum("time is discrete")
    if case.eq.jumps or written.has(*case.intervals):
        names = " and ".join(case.eq.jumps) or "a sampled part"
        raise NotASum(f"states of {names} jump")
    if case.where.kept:
        raise NotASum("V' falls in a set of states")
    powers = [power.exp for power in written.atoms(sympy.Pow) if power.exp.is_Integer]
    if max(*map(count_terms, written), *powers) > MOST_TERMS:
        raise NotASum("V' or a rate is too long to print")


# --- as symbols -------------------------------------------------------------------------------


def without_calls(e: Expr) -> Expr:
    """Return an expression with functions of time as symbols."""
    symbols = {
        f: Symbol(f"{f.func}", real=True, positive=f.is_positive)
        for f in e.atoms(AppliedUndef)
    }
    return e.xreplace(symbols)


def least(e: Expr) -> Expr:
    """Return the least value of a number plus multiples of t, sines and tanh; else -oo."""
    terms = (term.as_coeff_Mul()[1] for term in Add.make_args(e))
    is_known = all(f in (1, TIME) or isinstance(f, RANGED) for f in terms)
    return interval(e)[0] if is_known else -sympy.oo


def is_above_zero(base: Expr, fixed: set) -> bool:
    """Return whether a divisor has a positive least value, or is a parameter with a sign."""
    if not base.free_symbols - fixed:
        return bool(base.is_nonzero) and not base.has(*NOT_COMPUTED)
    if base.is_Pow and base.base != sympy.E:
        return is_above_zero(base.base, fixed)
    if isinstance(base, (exp, cosh)) or least(base) >= LEAST_DIVISOR:
        return True
    constant, rest = base.as_independent(*(base.free_symbols - fixed), as_Add=True)
    has_signs = all(term.is_nonnegative for term in Add.make_args(rest))
    return bool(constant.is_positive and has_signs)
