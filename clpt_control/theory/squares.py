"""An expression as a sum of terms that are not negative: what a V holds, and whether V' <= 0.

    V = c + sum_k a_k f_k^2 + sum_i g_i(s_i)        a_k > 0,  g_i convex or rising away from 0

Forms f are taken as the user wrote them, or squares are completed, symbol by symbol.  V holds every
form: where V does not rise, no f leaves a bound, but one of the kind sin(s/2), of 1 - cos(s).
"""

from collections.abc import Mapping
from itertools import chain, zip_longest
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ..engine.diagram.symbol_names import TIME
from ..engine.diagram.symbolic_equations import Equations
from ..errors import DiagramError
from .proving.facts import along, decided, degree, interval, is_input, meets_smoothly
from .proving.proof import How, Step, exact
from .proving.signs import (
    MOST_TERMS,
    factored,
    nonpositive,
    rising_in,
    terms_of,
    tidied,
    vanishes,
)
from .proving.symbolic_loop import Numbers

TURNS = (sympy.sin, sympy.cos)
TRIED = 500  # points at which a sign is looked at before it is proved
SMALL = 1e-6  # of the largest value there; less may be rounding
NOTHING = MappingProxyType[Any, sympy.Expr]({})


class Squares(NamedTuple):
    """Terms that are not negative, and forms that are bounded where they are."""

    constant: sympy.Expr
    terms: list[sympy.Expr]
    forms: list[sympy.Expr]


def squares(V: sympy.Expr, fixed: set, words_are_free: bool = True) -> Squares | None:
    """Return an expression as a sum of terms that are not negative; None where none is known.

    Words with kinks stand for any number, or only those of time and not of states.
    """
    free = (f for f in V.atoms(AppliedUndef) if words_are_free or is_input(f))
    words = {f: sympy.Dummy(str(f.func), real=True) for f in free}
    back = {dummy: f for f, dummy in words.items()}
    inner = [f.args[0] for f in V.atoms(sympy.Function) if f.args[0].is_Add]
    sums = {
        a: sympy.Dummy("sum", real=True)
        for a in inner
        if len(a.free_symbols - fixed) > 1
    }
    back |= {dummy: a for a, dummy in sums.items()}
    V = V.xreplace(words).xreplace(sums)
    moving = sorted(V.free_symbols - fixed, key=str)
    form_of = dict[Any, Any]()  # term -> the form that it holds
    low, more = list[Any](), list[Any]()
    others = dict[frozenset, list]()
    parts = [sympy.expand_mul(one, deep=False) for one in sympy.Add.make_args(V)]
    for term in sympy.Add.make_args(sympy.Add(*parts)):
        factor, rest = term.as_independent(*moving, as_Add=False)
        base, power = rest.as_base_exp()
        if (
            _positive(factor)
            and power.is_Integer
            and power.is_even
            and power.is_positive
        ):
            form_of[term] = base
        elif rest.is_polynomial(*moving):
            low.append(term)
        elif term.is_nonnegative and len(rest.free_symbols & set(moving)) > 1:
            # it holds no form
            more.append(term)
        else:
            others.setdefault(frozenset(rest.free_symbols & set(moving)), []).append(
                term
            )
    for symbols, terms in others.items():
        if len(symbols) != 1:
            return None
        (s,) = symbols
        rising = _rising(sympy.Add(*terms), s)
        if rising is None:  # with all that s is in alone
            same = [term for term in low if term.free_symbols & set(moving) == {s}]
            terms, low = terms + same, [term for term in low if term not in same]
            rising = _rising(sympy.Add(*terms), s)
        if rising is None:
            return None
        low.append(rising[0])
        form_of[sympy.Add(*terms) - rising[0]] = rising[1]
    if any(term.free_symbols & set(moving) for term in low):
        # squares are completed with them
        plain = [term for term in form_of if term.is_polynomial(*moving)]
        low += plain
        form_of = {term: form for term, form in form_of.items() if term not in plain}
    whole = _completed(sympy.expand(sympy.Add(*low)), moving)
    if whole is None:
        return None
    both = [*form_of, *more, *whole.terms], [*form_of.values(), *whole.forms]
    return Squares(
        whole.constant, *([one.xreplace(back) for one in terms] for terms in both)
    )


def _completed(p: sympy.Expr, moving: list) -> Squares | None:
    """Complete the squares of a polynomial, in one order of its symbols or another."""
    symbols = [s for s in moving if p.has(s)]
    if not symbols:
        return Squares(p, [], [])
    poly = sympy.Poly(p, *symbols)
    if any(poly.degree(s) % 2 for s in symbols):  # which has no least value
        return None
    high = Squares(sympy.S.Zero, [], [])
    for powers, c in poly.terms():
        even, holds = any(powers) and not any(n % 2 for n in powers), _positive(c)
        if even and (holds or c.is_nonnegative) and (sum(powers) > 2 or not holds):
            root = sympy.Mul(
                *(s ** (n // 2) for s, n in zip(symbols, powers, strict=True))
            )
            high.terms.append(c * root**2)
            high.forms.extend([root.as_base_exp()[0]] * holds)
    for s in symbols:
        a, b, c = (p.coeff(s, n) for n in (2, 1, 0))
        if poly.degree(s) != 2 or a.has(*symbols) or not _positive(a):
            continue
        form = s + sympy.expand(b / (2 * a))
        below = c - b**2 / (4 * a)
        below = sympy.expand(below if a.is_number else sympy.cancel(below))
        rest = _completed(below, moving)
        if rest is not None:
            return Squares(
                rest.constant, [a * form**2, *rest.terms], [form, *rest.forms]
            )
        break
    if not high.terms:
        return None
    rest = _completed(sympy.expand(p - sympy.Add(*high.terms)), moving)
    if rest is None:
        return None
    return Squares(rest.constant, high.terms + rest.terms, high.forms + rest.forms)


def _positive(a: sympy.Expr) -> bool:
    """Return whether a factor is positive, and stays away from zero, which exp(-t) does not."""
    alone = not a.has(TIME) and (a.is_positive or factored(a).is_positive)
    return bool(alone or interval(a)[0].is_positive)


def _rising(g: sympy.Expr, s: sympy.Symbol) -> tuple[sympy.Expr, sympy.Expr] | None:
    """Return g(0), and a form that is zero where g - g(0) >= 0 is, of a function of one symbol."""
    least = decided(g.subs(s, 0))
    k, m = sympy.Wild("k", exclude=[s, 0]), sympy.Wild("m", exclude=[s, 0])
    cosine = g.match(-k * sympy.cos(m * s))
    if cosine is not None and cosine[k].is_positive:
        return least, sympy.sin(cosine[m] * s / 2)
    slope = along(g, {s: sympy.S.One})
    if least.is_finite and any(
        rising_in(one(s * slope), s) for one in (tidied, factored)
    ):
        return least, s
    if g.atoms(AppliedUndef) or g.has(TIME):
        return None
    bend = factored(sympy.diff(slope, s))
    bends = (
        least.is_finite
        and vanishes(slope.subs(s, 0))
        and bend != 0
        and bend.is_nonnegative
    )
    return (least, s) if bends else None  # so that g rises without bound


def positive_definite(V: sympy.Expr, states: list) -> bool:
    """Return whether V is known to be positive definite in its states, without end.

    V is zero at zero, as the forms are that it holds, and the linear ones of these hold each state.
    """
    least = least_place(V, states)
    return least is not None and not any(least.values())


def least_place(V: sympy.Expr, states: list) -> dict[Any, sympy.Expr] | None:
    """Return where V is zero, if it is positive elsewhere and holds each state; else None."""
    if not meets_smoothly(V):
        return None
    total = squares(V, V.free_symbols - set(states), words_are_free=False)
    if total is None or not vanishes(total.constant) or not holds_all(total, states):
        return None
    linear = [f for f in total.forms if f.is_polynomial(*states)]
    linear = [f for f in linear if sympy.Poly(f, *states).is_linear]
    places = [*sympy.linsolve(linear, *states)]
    if not places:
        return None
    least = dict(zip(states, places[0], strict=True))
    return least if all(vanishes(f.xreplace(least)) for f in total.forms) else None


def holds_all(total: Squares, states: list) -> bool:
    """Return whether the linear forms of a sum of squares hold each state."""
    J = sympy.Matrix(total.forms).jacobian(states) if total.forms else sympy.Matrix()
    linear = [row for row in J.tolist() if all(slope.is_Rational for slope in row)]
    return sympy.Matrix(linear).rank() == len(states)


def positive_somewhere(expression: sympy.Expr) -> bool:
    """Return whether an expression is positive at a random point: no proof is tried then.

    Slopes of inputs may be anything.
    """
    slopes = {d: sympy.Dummy(real=True) for d in expression.atoms(sympy.Derivative)}
    try:
        numbers = Numbers(expression.xreplace(slopes))
    except DiagramError:
        return False
    random = np.random.default_rng(0)
    drawn = random.standard_normal((len(numbers.symbols), TRIED))
    drawn *= 10.0 ** random.uniform(-1, 1, (1, TRIED))
    for row, s in zip(drawn, numbers.symbols, strict=True):
        if s.is_nonnegative or s.is_nonpositive or s == TIME:
            row[:] = np.abs(row) * (-1 if s.is_nonpositive else 1)
    (values,) = numbers.at(dict(zip(numbers.symbols, drawn, strict=True)), TRIED)
    values = values[np.isfinite(values)]
    return bool(values.size and values.max() > SMALL * np.abs(values).max())


def never_positive(e: sympy.Expr, fixed: set, ways: tuple = (None,)) -> bool:
    """Return whether an expression is known never to be positive, t >= 0.

    Symbols that are `fixed` are parameters; `ways` are symbols by which terms are examined apart.
    Nothing is tried where it is positive at a random point.
    """
    if terms_of(e) > MOST_TERMS or positive_somewhere(e):
        return False
    free = e.free_symbols - {TIME, *fixed}
    e = e.xreplace({TIME: sympy.Symbol("t", nonnegative=True)})
    if vanishes(e) or any(nonpositive(e, free, by=by) for by in ways):
        return True
    terms = sympy.Add.make_args(e)
    left = (f for f in terms if f.is_polynomial(*free) or not f.is_nonpositive)
    signals = {f: sympy.Dummy(real=True) for f in e.atoms(AppliedUndef) if is_input(f)}
    for rest in dict.fromkeys((e, sympy.Add(*left))):
        totals = [squares(-rest, fixed)]
        if signals:
            # a quadratic form whose coefficients are made of inputs
            coefficients = fixed | {*signals.values()}
            totals.append(squares(-rest.xreplace(signals), coefficients))
        if any(total and total.constant.is_nonnegative for total in totals):
            return True
    if _by_common_factor(e, free):
        return True
    return any(
        interval(one)[1].is_nonpositive for one in (factored(e), sympy.factor_terms(e))
    )


def _by_common_factor(e: sympy.Expr, free: set) -> bool:
    """Return whether e = sum_k f_k p_k, f_k > 0 no polynomial and each p_k never positive."""
    polynomials: dict[sympy.Expr, sympy.Expr] = {}
    for term in sympy.Add.make_args(sympy.expand(e)):
        factors = sympy.Mul.make_args(term)
        common = sympy.Mul(*(f for f in factors if not f.is_polynomial(*free)))
        polynomials[common] = polynomials.get(common, sympy.S.Zero) + term / common
    if len(polynomials) < 2 and sympy.S.One in polynomials:
        return False
    return all(
        all(map(_is_above_zero, sympy.Mul.make_args(common)))
        and nonpositive(sympy.expand(p), free)
        for common, p in polynomials.items()
    )


def _is_above_zero(factor: sympy.Expr) -> bool:
    """Return whether a factor is never negative; of a power also by the squares in its base."""
    if factor.is_nonnegative:
        return True
    base, _ = factor.as_base_exp()
    total = squares(base, set()) if base.is_Add else None
    return total is not None and bool(total.constant.is_positive)


# --- states that V does not hold ----------------------------------------------------------------


def states_beside(
    forms: list[sympy.Expr], eq: Equations, known: Mapping[Any, sympy.Expr] = NOTHING
) -> tuple[str, Step]:
    """Return what a verdict adds of the states that V does not hold, and the step.

    A form in one state holds it; where each has several, the one that moves most simply is not
    held, and the forms hold the others beside it.  Inputs are bounded; a form that grows with time
    holds nothing.  `known` is what symbols are.
    """
    still = {
        f: sympy.Dummy(real=True) for port in eq.inputs.values() for f in port.flat
    }
    motion = {s: rate.xreplace(known).xreplace(still) for s, rate in eq.motion.items()}
    intervals = {p.interval for p in eq.parameters.values() if "interval" in p._fields}
    fixed = set(eq.values) - intervals
    forms = [form.xreplace(still) for form in forms]
    turns = {w for r in (*motion.values(), *forms) for w in r.atoms(*TURNS)}
    turning = {  # angles that whole turns leave as they are, as th**2 is none
        w: sympy.Dummy()
        for w in turns
        if not any(sympy.diff(w.args[0], s).free_symbols - fixed for s in motion)
    }
    unturned = [r.xreplace(turning) for r in (*motion.values(), *forms)]
    for k, form in enumerate(one.as_coeff_Mul()[1] for one in forms):
        if isinstance(form, sympy.sin):
            # its angle up to whole turns, which is all that counts
            seen = any(one.has(*form.free_symbols - fixed) for one in unturned)
            forms[k] = sympy.S.Zero if seen else form.args[0]
    forms = [form for form in forms if degree(form, lambda s: s == TIME) == 0]
    inner = filter(None, (squares(form, fixed) for form in forms))
    forms += [form for inner_squares in inner for form in inner_squares.forms]
    left, at, free = list(motion), dict[Any, Any](), list[Any]()
    while left:
        one = next(
            filter(None, (_state_of(f.xreplace(at), left, fixed) for f in forms)), None
        )
        if one is not None:
            at |= one
            left = [s for s in left if s not in one]
        else:
            varies = {
                s: bool(sympy.diff(motion[s], s).free_symbols - fixed) for s in left
            }
            degrees = {s: degree(motion[s], (left + free).__contains__) for s in left}
            free.append(min(left, key=lambda s: (varies[s], degrees[s])))
            left.remove(free[-1])
    unheld = [
        (port, [s for s in own.flat if s in free]) for port, own in eq.states.items()
    ]
    whole = ([port] if len(of) == eq.states[port].size else of for port, of in unheld)
    # a state that is no output has the name block:state
    symbols = map(str, chain.from_iterable(whole))
    names = ", ".join(name.rpartition(":")[2] for name in symbols)
    if not free:
        return "", exact("V holds every state", True)
    plain = [motion[s].xreplace(at) for s in free]
    functions = sympy.Tuple(*plain).atoms(AppliedUndef)
    sources = sorted({str(f.func) for f in functions if is_input(f)})
    # nothing is known of an opaque source, not even that it has a value at all times
    verb = "are" if sources[1:] else "is"
    given = f", if {' and '.join(sources)} {verb} bounded" if sources else ""
    how: How = "sampled" if sources else "exact"
    rates = sympy.Matrix([sympy.expand(rate) for rate in plain])
    after = [change for jump in eq.jumps.values() for change in jump.items()]
    jumps = [
        new.xreplace(known).xreplace(at) for s, new in after if s in free and new != s
    ]
    J = rates.jacobian(free)
    rest = rates - J * sympy.Matrix(free)
    varies = rest.has(TIME, *intervals, *free)
    if not (jumps or J.free_symbols - fixed or varies) and hurwitz(J):
        inputs = " and bounded inputs" if rest.has(*still.values()) else ""
        stable = f"{names}: linear and stable, driven by what V holds{inputs}{given}"
        return "", Step(stable, True, how, every_N=False)
    # expansion hides roots
    both = [*zip(plain, rates, strict=True), *((new,) for new in jumps)]
    if all(min(degree(f, free.__contains__) for f in one) <= 1 for one in both):
        grows = f"{names}: not held by V, may grow, and exist for all t{given}"
        return f"but for {names}", Step(grows, True, how, every_N=False)
    faster = exact(f"{names}: not held by V, exist for all t", False, "not shown")
    return f"as long as {names} exist", faster


def hurwitz(A: sympy.Matrix) -> bool:
    """Return whether all eigenvalues have a negative real part, by Routh's table, exactly."""
    one, next_one = (A.charpoly().all_coeffs()[k::2] for k in (0, 1))
    while next_one and next_one[0].is_positive:
        share = one[0] / next_one[0]
        pairs = zip_longest(one[1:], next_one[1:], fillvalue=0)
        rest = [sympy.cancel(a - share * b) for a, b in pairs]
        one, next_one = next_one, rest
    return not next_one


def _state_of(form: sympy.Expr, left: list, fixed: set) -> dict[Any, sympy.Expr] | None:
    """Return the one state of these that a form holds, as an expression of the others."""
    states = [s for s in left if form.has(s)]
    if len(states) != 1 or not form.is_polynomial(*states):
        return None
    (s,), bounded = states, sympy.Dummy("held", real=True)
    a, *rest = sympy.Poly(form, s).all_coeffs()
    if not a.is_nonzero or a.free_symbols - fixed:
        return None
    if len(rest) > 1:
        # of higher degree it holds s where nothing else in it moves freely
        alone = all(
            isinstance(one, sympy.Dummy) for one in form.free_symbols - fixed - {s}
        )
        return {s: bounded} if alone else None
    return {s: (bounded - rest[0]) / a}
