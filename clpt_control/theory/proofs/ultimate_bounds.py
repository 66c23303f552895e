"""Ultimate bounds of V from dissipative terms and leaks.

A term that pulls back bounds one that does not:

    -a s^2 + b s <= -(a/2) s^2 + b^2/(2 a)

Of a law V' = -e^T KD e - sum over leaks of f w s^T (s - s*) is read as `leaks` describes.  The kind
of f then bounds V:

- **f rises with |s|**, zero up to M and h from R on.  It is h but within R, where the difference
  is at most h w (R^2 + |s*| R): V' <= (V' with f = h) + that, whatever s* is.
- **f = |e|**.  -a z^2 + b z <= -a z^2/2 + b^2/(2 a), z = s - s*, so c = sum b^2/(2 a) + |Delta| and

      V' <= -|e| (k |e| + sum a z^2/2 - c)

  V falls outside a convex set; V is convex in |e| and all z^2, so at most that of its corners.
- **f takes the outward part of s' away** beyond R: |s| <= R for good.  Where |s*| <= M as well,
  f > 0 only where s^T (s - s*) >= 0, so V' <= -e^T KD e + e^T Delta.

Delta is the disturbance of Eq. (32), which adds e^T Delta to V'.
"""

from collections.abc import Iterable, Sequence
from itertools import takewhile
from typing import Any, NamedTuple

import numpy as np
import sympy
from scipy.optimize import minimize, minimize_scalar
from sympy import (
    Add,
    Dummy,
    Expr,
    Max,
    Min,
    S,
    Symbol,
    Tuple,
    diff,
    expand,
    hessian,
    sqrt,
)
from sympy.core.function import AppliedUndef

from ...base.units import at_least, at_most
from ...engine.diagram.symbol_names import TIME
from ...engine.record.symbolic import rational
from ..algebra.decide import never_positive, random_points
from ..algebra.exact import groups_of
from ..algebra.facts import interval
from ..algebra.numeric_values import NumericValues
from ..algebra.sums_of_squares import squares, zero_of
from ..algebra.texts import outward
from .answers import Definite, Fall
from .conclusions import Condition
from .leaks import Leak, leaks_of, radial_of, stays_within
from .relations import errors_of
from .statements import listed, said
from .steps import exact

SAMPLES = 50_000  # random points at which V and V' are computed
ABOVE = "where V is above a level"
FAR = 1e9  # larger maxima are none


class Pull(NamedTuple):
    """V' <= -rate V + push, or -e^T KD e/2 + push where rate is zero."""

    rate: Expr  # in what the law does not know: theta, KD and GammaD
    push: Expr


def bounded(claim: str, shows: str, level: Any = None, **fields: Any) -> Fall:
    """Return a bound of V or of the mean of e, and what conclusions require of it.

    `level` is in theta, KD, GammaD and the bounds Delta_1, Delta_2.
    """
    step = exact(claim, True, "", shows)
    return Fall([step], claim, level=level, **fields)


def _pull_of(quadratic: Expr, s: Symbol, moves: set) -> Pull | None:
    """Return a and b^2/(2 a) of -a s^2 + b s."""
    a, b = -quadratic.coeff(s, 2), quadratic.coeff(s, 1)
    if expand(quadratic + a * s**2 - b * s) != 0:
        return None
    is_flat = a == 0 and b != 0
    if not a.is_nonnegative or _moves(Tuple(a, b), moves) or is_flat:
        return None
    return Pull(a, b**2 / (2 * a) if b != 0 else S.Zero)


def _leak_of(term: Expr, s: Symbol, true: Expr) -> Pull | None:
    """Return how -f a^2k a (a - a*) pulls, a = a* + s, for f between two numbers.

    It is not positive but where |a| < |a*|, and there at most f |a*|^(2k + 2)/4; where f keeps away
    from zero and k is 0 it is -f s^2/2 and at most f |a*|^2/2.
    """
    a = Dummy(real=True)
    of_a = expand(term.xreplace({s: a - true}))
    if not of_a.is_polynomial(a):
        return None
    share, remainder = sympy.div(of_a, expand(-a * (a - true)), a)
    push, slowest = S.Zero, S.Zero
    for (power,), f in sympy.Poly(share, a).terms() if remainder == 0 else ():
        low, high = interval(f)
        if power % 2 or not (low.is_extended_nonnegative and high.is_finite):
            return None
        if power == 0 and low.is_positive:
            slowest, push = low, push + high * true**2 / 2
        else:
            push += high * true ** (power + 2) / 4
    return Pull(slowest, push) if push != 0 else None


def _moves(expression: Expr, moving: set) -> bool:
    return bool(expression.free_symbols & moving or expression.atoms(sympy.Function))


def shared(V: Expr, rates: Sequence[Expr], pulls: Sequence[Pull]) -> Pull:
    """Return the pull of the lowest level that all rates have."""
    slowest, pushes = zip(*pulls, strict=True)
    found = lowest(V, rates, {*slowest} - {S.Zero})
    return found or Pull(Min(*slowest), Max(*pushes))


def lowest(
    V: Expr, rates: Sequence[Expr], shares: Iterable[Expr] | None = None
) -> Pull | None:
    """Return the pull of the lowest level by the maxima of all rates and a share of V.

    If no share is given it is that of the lowest max(V + V'/k), convex in 1/k, at random points.
    """
    if shares is None:
        _, size, change = sampled(V, rates)
        found = minimize_scalar(
            lambda k: np.max(size + change / 10**k), bounds=(-2, 9), method="bounded"
        )
        shares = [rational(float(f"{10**found.x:.2g}"))]
    found = []
    for k in shares:
        maxima = (maximum_of(expand(e + k * V)) for e in rates)
        tops = [*takewhile(lambda top: top is not None, maxima)]
        if len(tops) == len(rates):
            found.append(Pull(k, Max(*tops)))
    return min(found, key=lambda pull: pull.push / pull.rate, default=None)


def sampled(V: Expr, rates: Sequence[Expr]) -> tuple:
    """Return random points of all sizes, V and the largest rate there."""
    numbers = NumericValues(V, *rates)
    points = random_points(numbers.symbols, SAMPLES, 3)
    size, *changes = numbers.at(
        dict(zip(numbers.symbols, points, strict=True)), SAMPLES
    )
    return points, size, np.max(changes, axis=0)


def maximum_of(e: Expr) -> Expr | None:
    """Return the maximum of concave squares, or one found by numbers, rounded up."""
    states = sorted(e.free_symbols, key=str)
    if not states:
        return e if e.is_Rational else None
    terms = e.as_poly(*states)
    square = terms and terms.total_degree() < 3
    if square and all(number.is_Rational for number in terms.coeffs()):
        H = -hessian(e, states)
        if not H.is_positive_definite:
            return None
        at_zero = dict.fromkeys(states, S.Zero)
        b = sympy.Matrix([e]).jacobian(states).xreplace(at_zero)
        return e.xreplace(at_zero) + (b * H.inv() * b.T)[0] / 2
    numbers = NumericValues(-e)
    points, size, _ = sampled(e, [e])
    found = minimize(
        lambda x: numbers.at(dict(zip(numbers.symbols, x, strict=True)), 1)[0, 0],
        points[:, np.nanargmax(size)],
    )
    most = -found.fun
    for text in (f"{most:.4g}", at_most(1.001 * most)) if abs(most) < FAR else ():
        c = rational(float(text))
        if never_positive(e - c, set()):
            return c
    return None


class InForms(NamedTuple):
    """V and V' of a diagram in the forms of V, each of them one state."""

    V: Expr
    rate: Expr
    rest: dict[Any, Expr]
    forms: dict[Any, Expr]  # state -> its error, in the states of the diagram


def in_forms(case: Any, definite: Definite) -> InForms | None:
    """Return V and V' of a diagram in the forms of V; None where V has no one least point."""
    states, forms = errors_of(case, definite.forms, least=2)
    V, rate = (expand(e.xreplace(states)) for e in (case.V, case.rate))
    total = squares(V, case.fixed)
    if total is None:  # linear in states of sets
        V, rate = (expand(e.xreplace(case.where.squared)) for e in (V, rate))
        total, forms = squares(V, case.fixed), case.where.roots
    moving = sorted(V.free_symbols - case.fixed, key=str)
    rest = zero_of(total, moving) if total else None
    if rest is None:
        return None
    errors = {s: forms.get(s, s) - true for s, true in rest.items()}
    return InForms(V, rate, rest, errors)


def pulled_forms(case: Any, definite: Definite) -> Fall | None:
    """Return the bound of V of a diagram in the forms of V, each of them one state.

    Disturbances push errors, V' = ... + w u s, and have any bound, called as they are.
    """
    found = in_forms(case, definite) if definite.forms else None
    if found is None or case.where.above:  # forms are those of V at the start
        return None
    fall = Bounding(case, found).bound()
    if fall is None or found.V.xreplace(found.rest).xreplace(case.eq.values) != 0:
        return None
    if fall.level is not None:
        level = fall.level.xreplace(case.given).xreplace(case.level_values)
        if level != fall.level and not fall.bound:  # the sentence has the number
            case.are_numbers = True
        fall.level = float(at_most(float(level))) if level.is_number else level
    return fall


class Bounding:
    """The bounds of V that follow from V', about its least point."""

    def __init__(self, case: Any, found: InForms):
        self.case, self.KD = case, case.KD
        self.V, self.truth = found.V, found.rest
        self.moving = {TIME, *case.motion, *case.intervals}
        H = hessian(self.V, list(self.truth))
        self.is_diagonal = H.is_diagonal()
        self.weights = {s: H[j, j] for j, s in enumerate(self.truth)}
        # disturbances that push one error each; others stay in V'
        slopes = {self.weights[s] * (s - true): s for s, true in self.truth.items()}
        pushed = {f: slopes.get(diff(found.rate, f)) for f in case.disturbances}
        names = {f: s for f, s in pushed.items() if s is not None}
        self.rate = found.rate.xreplace(dict.fromkeys(names, S.Zero))
        self.pushes = {s: Symbol(f"{f.func}", positive=True) for f, s in names.items()}
        sizes = ((self.weights[s] * size) ** 2 for s, size in self.pushes.items())
        self.push = sqrt(Add(*sizes))
        weights = [self.weights.get(e, sympy.nan) for e in self.KD]
        shares = zip(weights, self.KD.items(), strict=True)
        self.residual = self.rate + Add(*(w * k * e**2 for w, (e, k) in shares))
        self.square = {*weights} == {1} and self.is_diagonal  # V contains |e|^2/2
        self.leaks = leaks_of(self.residual, self.truth, self.moving) if self.KD else []

    def bound(self) -> Fall | None:
        """Return what is known of V, or None."""
        pull = self.pull()
        discrete = self.case.eq.discrete
        # V of the next time is at most (1 - rate) V + push
        is_slow = pull and (not discrete or (1 - pull.rate).is_nonnegative)
        if pull and is_slow and (fall := self.pulled_to(pull)):
            return fall
        # in discrete time a step may lead from below a level to above it
        if discrete:
            return None
        fall = self.by_error() or self.far_off()
        if fall is None and self.leaks:
            return self.rising() or self.within_balls()
        return fall

    @np.errstate(all="ignore")
    def pull(self) -> Pull | None:
        """Return how V' pulls V back at each corner of the box of inputs, or as it is."""
        rates = [at for _, at in self.case.where.corners(self.rate, waves=True)]
        found = [*filter(None, map(self.pulled, rates))]
        if len(found) < len(rates):
            if self.pushes or Tuple(*rates).free_symbols - self.truth.keys():
                return None
            return lowest(self.V, rates)
        return shared(self.V, rates, found) if found[1:] else next(iter(found), None)

    def has_decay(self) -> bool:
        """Return whether V' has -e^T KD e, or more of it."""
        if any(call.has(*self.KD) for call in self.residual.atoms(AppliedUndef)):
            # how it bends is not known
            return False
        slopes = (diff(self.residual, e, 2) for e in self.KD)
        return self.square and all(slope.is_nonpositive for slope in slopes)

    def pulled(self, rate: Expr) -> Pull | None:
        """Bound V' by what pulls back and a constant, state by state, about the rest.

        None where V' is not a sum of a term -a s^2 + b s, a leak or a polynomial for each error s;
        what depends on a state or time is no constant.
        """
        rest, moves = self.truth, {*self.truth, *self.moving}
        groups = groups_of(self.about_the_rest(rate), {*rest})
        terms = {tuple(g.free_symbols & {*rest}): g for g in groups}
        push, rates = terms.get((), S.Zero), []
        constants = Tuple(push, *self.weights.values())
        if (
            not self.is_diagonal
            or _moves(constants, moves)
            or any(key[1:] for key in terms)
        ):
            return None
        for s, weight in self.weights.items():
            term = terms.get((s,), S.Zero)
            pull = _pull_of(term, s, moves) or _leak_of(term, s, rest[s])
            if pull is None and s not in self.pushes and term.free_symbols == {s}:
                pull = lowest(s**2 / 2, [term])
            if pull is None:
                return None
            if s in self.pushes:  # w u s <= a s^2/2 + (w u)^2/(2 a)
                if pull.push != 0 or pull.rate == 0:
                    return None
                share = (weight * self.pushes[s]) ** 2 / (2 * pull.rate)
                pull = Pull(pull.rate, share)
            push += pull.push
            # of the square of a root nothing is needed to complete a square
            share = 2 if s in self.case.where.roots and pull.push == 0 else 1
            rates.append(share * pull.rate / weight)
        return Pull(Min(*rates), push)

    def about_the_rest(self, rate: Expr) -> Expr:
        """Return V' in the errors of the states."""
        shift = {s: s + true for s, true in self.truth.items()}
        return expand(rate.xreplace(shift))

    def corners(self) -> list[Expr]:
        """Return V' in the errors of the states at each corner of the box of inputs."""
        corners = self.case.where.corners(self.rate)
        return [self.about_the_rest(rate) for _, rate in corners]

    def by_error(self) -> Fall | None:
        """Return the bound where V' has |e| in it, the largest of all corners."""
        levels = [*map(self.level_by_error, self.corners())]
        if not levels or None in levels:
            return None
        return bounded(f"V' <= 0 {ABOVE}", "ceiling", Max(*levels))

    def level_by_error(self, rate: Expr) -> Expr | None:
        """Return V above which V' = -e^T K e + p^T e - |e| (z^T A z - b^T z - push) falls."""
        states, weights = self.truth, self.weights
        sizes = [
            f
            for f in rate.atoms(sympy.Abs, sympy.Pow)
            if (f**2).is_polynomial() and not f.is_polynomial() and f.has(*states)
        ]
        if len(sizes) != 1 or not self.is_diagonal:
            return None
        (size,) = sizes
        decay, leak = rate.as_independent(size, as_Add=True)
        share = expand(leak / size)
        K = {e: -decay.coeff(e, 2) for e in states if size.has(e)}
        A = {s: -share.coeff(s, 2) for s in states if s not in K}
        b = {s: share.coeff(s, 1) for s in A}
        p = {e: decay.coeff(e, 1) for e in K}

        def total(of: dict, power: int) -> Expr:
            return Add(*(factor * s**power for s, factor in of.items()))

        known = total(p, 1) - total(K, 2) + size * (total(b, 1) - total(A, 2))
        excess = rate - known, size**2 - total(dict.fromkeys(K, 1), 2)
        numbers = Tuple(*(n for of in (K, A, b, p, weights) for n in of.values()))
        if any(map(expand, excess)) or _moves(numbers, {*states, *self.moving}):
            return None
        if not (A and all(k.is_positive for k in (*K.values(), *A.values()))):
            return None
        c = self.push + Add(*(b[s] ** 2 / (2 * a) for s, a in A.items()))
        c += sqrt(Add(*(of_e**2 for of_e in p.values())))
        corners = [weights[s] * c / a for s, a in A.items()]
        heaviest, slowest = Max(*map(weights.get, K)), Min(*K.values())
        return Max(heaviest * c**2 / (2 * slowest**2), *corners)

    def far_off(self) -> Fall | None:
        """Return the level above which V of one state falls, V' < 0 at each corner there."""
        V, rates = self.about_the_rest(self.V), self.corners()
        states = Tuple(V, *rates).free_symbols
        if not (self.case.where.box and rates) or len(states) != 1:
            return None
        # Step 1: by numbers, the distance beyond which V' < 0
        points, _, change = sampled(V, rates)
        farthest = np.abs(points[0][change >= 0]).max(initial=0.0)
        start = rational(float(at_most(1.005 * farthest)))
        # Step 2: V rises, and V' <= -margin dV/d|s|, from there on
        (s,), more, level = states, Dummy(positive=True), S.Zero
        for side in (1, -1):
            rise = sympy.factor(side * V.diff(s).xreplace({s: side * more}))
            beyond = {s: side * (start + more)}
            for e in rates:
                share = e.xreplace(beyond) / rise.xreplace({more: start + more})
                share = sympy.cancel(share)
                (least,) = -NumericValues(share).at({more: 0.0}, 1)[0]
                if not (rise.is_positive and least > 0):
                    return None
                margin = rational(float(f"{least / 2:.1g}"))
                if not never_positive(share + margin, set()):
                    return None
            level = Max(level, V.xreplace({s: side * start}))
        return bounded(f"V' < 0 {ABOVE}", "pulled", level)

    def pulled_to(self, pull: Pull, more: str = "") -> Fall | None:
        """Return what V comes to, or the mean of the errors that V' loses."""
        if pull.push == 0 or (pull.rate == 0 and not self.has_decay()):
            return None
        level = pull.push / pull.rate if pull.rate != 0 else None
        pull = Pull(*(e.xreplace(self.case.given) for e in pull))
        push = outward(pull.push)
        if pull.rate == 0:
            c = self.letter("c")
            mean = said("`e^T KD e` is at most 2 {}", c)
            claim = said("V' <= `-e^T KD e/2` + {}, {} = {}{}", c, c, push, more)
            return bounded(claim, "mean", bound=mean)
        rate = outward(pull.rate, up=False)
        if pull.rate.is_number and pull.push.is_number:
            share = "" if rate == 1 else said("{} ", rate)
            claim = said("V' <= -{}V + {}{}", share, push, more)
            return bounded(claim, "pulled", level)
        r, c = map(self.letter, "rc")
        claim = said(
            "V' <= -{} V + {}, {} = {}, {} = {}{}", r, c, c, push, r, rate, more
        )
        return bounded(claim, "pulled", level, bound=said("{}/{}", c, r))

    def letter(self, name: str) -> Symbol:
        """Return a letter of the sentence, with a number where the loop has it."""
        while name in self.case.eq.named:
            name += "_1"
        return Symbol(name)

    def size(self, leak: Leak) -> Expr:
        """Return |s*|."""
        return sqrt(Add(*(self.truth[s] ** 2 for s in leak.states)))

    def rising(self) -> Fall | None:
        """Return the bound where every factor rises with |s|."""
        full, excess, conditions = self.rate, sympy.Integer(0), []
        for leak in self.leaks:
            radial = radial_of(leak)
            if radial is None or leak.factor != radial.word:
                return None
            full = full.subs(radial.word, radial.top)
            excess += (
                radial.top * leak.weight * (radial.R**2 + self.size(leak) * radial.R)
            )
            conditions.append(
                said("{} <= {}", self.size(leak), at_least(float(radial.M)))
            )
        pull = self.pulled(expand(full))
        if pull is None:
            return None
        more = said("; where {}, V' <= `-e^T KD e` without `Delta`", listed(conditions))
        return self.pulled_to(Pull(pull.rate, pull.push + excess), more)

    def within_balls(self) -> Fall | None:
        """Return the bound where what is learned stays within balls."""
        leaking = [s for leak in self.leaks for s in leak.states]
        learned = self.truth.keys() - self.KD.keys()
        if not self.square or sorted(leaking, key=str) != sorted(learned, key=str):
            return None
        k = Min(*self.KD.values())
        level, conditions = self.push**2 / (2 * k**2), []
        for leak in self.leaks:
            radial = radial_of(leak)
            if (
                radial is None
                or radial.top != 1
                or not stays_within(leak, radial, self.case.motion)
            ):
                return None
            slowest = Max(*(self.weights[s] for s in leak.states))
            level += slowest * (radial.R + self.size(leak)) ** 2 / 2
            port = Symbol(leak.states[0].name.partition("_")[0])
            radius = said("|{}| <= {}", port, at_most(float(radial.R)))
            truth = said("{} <= {}", self.size(leak), at_least(float(radial.M)))
            conditions.append((truth, radius))
        truths, radii = map(listed, zip(*conditions, strict=True))
        where = [Condition("start", radii), Condition("truth", truths)]
        claim = said("V' <= `-e^T KD e + e^T Delta`, {} for good", radii)
        return bounded(claim, "pulled", level, conditions=where)
