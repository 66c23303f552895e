"""Bounds of V where V' is not always negative: ultimate bounds, levels and means.

In: V and V' in its errors (`VInErrors`).  Out: a `Fall` with a claim on V', the level of V, and
conditions.  `WAYS` are tried in turn.  Most complete a square,

    -a s^2 + b s <= -(a/2) s^2 + b^2/(2 a)

for each error s, which gives an upper bound of V' (`RateBound`):

    V' <= -k V + c                        =>  V <= c/k in the end

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
from functools import cached_property
from itertools import chain, takewhile
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


class VInErrors(NamedTuple):
    """V and V' of a diagram; each linear form of V with several states is one state, an error."""

    V: Expr
    rate: Expr  # V'
    least: dict[Any, Expr]  # state -> its value where V is least
    distances: dict[
        Any, Expr
    ]  # state -> its distance from there, in the diagram's states


class RateBound(NamedTuple):
    """An upper bound of V': -decay V + push; or -e^T KD e/2 + push, if decay is zero."""

    decay: Expr  # in what the law does not know: theta, KD and GammaD
    push: Expr


def bounded(claim: str, shows: str, level: Any = None, **fields: Any) -> Fall:
    """Return a bound of V or of the mean of e, and what conclusions require of it.

    `level` is in theta, KD, GammaD and the bounds Delta_1, Delta_2.
    """
    step = exact(claim, True, "", shows)
    return Fall([step], claim, level=level, **fields)


def bound_of_V(case: Any, definite: Definite) -> Fall | None:
    """Return the bound of V of a candidate, if one is known.

    Disturbances push errors, V' = ... + w u s, and have any bound, called as they are.
    """
    in_errors = in_errors_of_V(case, definite) if definite.forms else None
    if in_errors is None or case.where.above:  # forms are those of V at the start
        return None
    fall = UltimateBound(case, in_errors).fall()
    least = in_errors.V.xreplace(in_errors.least)
    if fall is None or least.xreplace(case.eq.values) != 0:
        return None
    if fall.level is not None:
        level = fall.level.xreplace(case.given).xreplace(case.level_values)
        if level != fall.level and not fall.bound:  # the sentence has the number
            case.are_numbers = True
        fall.level = float(at_most(float(level))) if level.is_number else level
    return fall


def in_errors_of_V(case: Any, definite: Definite) -> VInErrors | None:
    """Return V and V' of a candidate in errors; None where V has no one least point."""
    states, forms = errors_of(case, definite.forms, least=2)
    V, rate = (expand(e.xreplace(states)) for e in (case.V, case.rate))
    total = squares(V, case.fixed)
    if total is None:  # linear in states of sets
        V, rate = (expand(e.xreplace(case.where.squared)) for e in (V, rate))
        total, forms = squares(V, case.fixed), case.where.roots
    moving = sorted(V.free_symbols - case.fixed, key=str)
    least = zero_of(total, moving) if total else None
    if least is None:
        return None
    distances = {s: forms.get(s, s) - value for s, value in least.items()}
    return VInErrors(V, rate, least, distances)


# --- V' bounded term by term ----------------------------------------------------------------------


def quadratic_terms(e: Expr, states: Iterable[Any]) -> tuple[dict[Any, tuple], Expr]:
    """Return state -> (a, b) of its terms -a s^2 + b s, and what else an expression has."""
    terms = {s: (-e.coeff(s, 2), e.coeff(s, 1)) for s in states}
    return terms, expand(e - Add(*(b * s - a * s**2 for s, (a, b) in terms.items())))


def _complete_square(term: Expr, s: Symbol, moving: set) -> RateBound | None:
    """Return the bound of -a s^2 + b s by -(a/2) s^2 and a constant."""
    terms, remainder = quadratic_terms(term, [s])
    a, b = terms[s]
    is_flat = a == 0 and b != 0
    if remainder != 0 or not a.is_nonnegative or _moves(Tuple(a, b), moving) or is_flat:
        return None
    return RateBound(a, b**2 / (2 * a) if b != 0 else S.Zero)


def _bound_of_leak(term: Expr, s: Symbol, true: Expr) -> RateBound | None:
    """Return the bound of -f a^2k a (a - a*), a = a* + s, for f between two numbers.

    It is not positive but where |a| < |a*|, and there at most f |a*|^(2k + 2)/4; where f keeps away
    from zero and k is 0 it is -f s^2/2 and at most f |a*|^2/2.
    """
    a = Dummy(real=True)
    of_a = expand(term.xreplace({s: a - true}))
    if not of_a.is_polynomial(a):
        return None
    share, remainder = sympy.div(of_a, expand(-a * (a - true)), a)
    push, decay = S.Zero, S.Zero
    for (power,), f in sympy.Poly(share, a).terms() if remainder == 0 else ():
        low, high = interval(f)
        if power % 2 or not (low.is_extended_nonnegative and high.is_finite):
            return None
        if power == 0 and low.is_positive:
            decay, push = low, push + high * true**2 / 2
        else:
            push += high * true ** (power + 2) / 4
    return RateBound(decay, push) if push != 0 else None


def _moves(expression: Expr, moving: set) -> bool:
    return bool(expression.free_symbols & moving or expression.atoms(sympy.Function))


def lowest_level(
    V: Expr, rates: Sequence[Expr], decays: Iterable[Expr] | None = None
) -> RateBound | None:
    """Return the bound of all rates that has the lowest level, by maxima of rate + k V.

    If no k is given it is that of the lowest max(V + V'/k), convex in 1/k, at random points.
    """
    if decays is None:
        _, size, change = sampled(V, rates)
        best = minimize_scalar(
            lambda k: np.max(size + change / 10**k), bounds=(-2, 9), method="bounded"
        )
        decays = [rational(float(f"{10**best.x:.2g}"))]
    bounds = []
    for k in decays:
        maxima = (maximum_of(expand(e + k * V)) for e in rates)
        tops = [*takewhile(lambda top: top is not None, maxima)]
        if len(tops) == len(rates):
            bounds.append(RateBound(k, Max(*tops)))
    return min(bounds, key=lambda bound: bound.push / bound.decay, default=None)


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


# --- from V' to V ---------------------------------------------------------------------------------


class UltimateBound:
    """The bound of V that follows from V', by the first of `WAYS` that knows one."""

    def __init__(self, case: Any, in_errors: VInErrors):
        self.case, self.KD = case, case.KD
        self.V, self.least = in_errors.V, in_errors.least
        self.moving = {TIME, *case.motion, *case.intervals}
        H = hessian(self.V, list(self.least))
        self.is_diagonal = H.is_diagonal()
        self.weights = {s: H[j, j] for j, s in enumerate(self.least)}  # s^2/2 in V
        # disturbances that push one error each; others stay in V'
        slopes = {self.weights[s] * (s - least): s for s, least in self.least.items()}
        pushed = {f: slopes.get(diff(in_errors.rate, f)) for f in case.disturbances}
        names = {f: s for f, s in pushed.items() if s is not None}
        self.rate = in_errors.rate.xreplace(dict.fromkeys(names, S.Zero))
        # error -> the largest disturbance that pushes it
        self.largest = {s: Symbol(f"{f.func}", positive=True) for f, s in names.items()}
        sizes = ((self.weights[s] * size) ** 2 for s, size in self.largest.items())
        self.push = sqrt(Add(*sizes))  # |Delta|

    def fall(self) -> Fall | None:
        """Return what is known of V, or None."""
        # in discrete time a step may lead from below a level to above it
        ways = WAYS[:1] if self.case.eq.discrete else WAYS
        return next(filter(None, (way(self) for way in ways)), None)

    @cached_property
    def residual(self) -> Expr:
        """V' beyond -e^T KD e."""
        weights = (self.weights.get(e, sympy.nan) for e in self.KD)
        gains = zip(weights, self.KD.items(), strict=True)
        return self.rate + Add(*(w * k * e**2 for w, (e, k) in gains))

    @cached_property
    def has_square(self) -> bool:
        """True if V contains |e|^2/2."""
        weights = {self.weights.get(e) for e in self.KD}
        return weights == {1} and self.is_diagonal

    @cached_property
    def leaks(self) -> list[Leak]:
        """Leaks of a law; none where V' has anything else."""
        return leaks_of(self.residual, self.least, self.moving) if self.KD else []

    def about_least(self, rate: Expr) -> Expr:
        """Return V' in the distances of the states from the least point of V."""
        return expand(rate.xreplace({s: s + at for s, at in self.least.items()}))

    def corners(self) -> list[Expr]:
        """Return V' about the least point of V at each corner of the box of inputs."""
        corners = self.case.where.corners(self.rate)
        return [self.about_least(rate) for _, rate in corners]

    # --- V' <= -decay V + push ------------------------------------------------------------------

    @np.errstate(all="ignore")
    def rate_bound(self) -> RateBound | None:
        """Return the bound of V' at all corners of the box of inputs, or as it is."""
        rates = [at for _, at in self.case.where.corners(self.rate, waves=True)]
        bounds = [*filter(None, map(self.bound_by_terms, rates))]
        if len(bounds) < len(rates):
            if self.largest or Tuple(*rates).free_symbols - self.least.keys():
                return None
            return lowest_level(self.V, rates)
        if len(bounds) < 2:
            return next(iter(bounds), None)
        decays, pushes = zip(*bounds, strict=True)
        lowest = lowest_level(self.V, rates, {*decays} - {S.Zero})
        return lowest or RateBound(Min(*decays), Max(*pushes))

    def bound_by_terms(self, rate: Expr) -> RateBound | None:
        """Return the bound of V' as a sum of bounds, one for each error.

        None where V' is not a sum of a term -a s^2 + b s, a leak or a polynomial for each error s;
        what depends on a state or time is no constant.
        """
        least, moving = self.least, {*self.least, *self.moving}
        groups = groups_of(self.about_least(rate), {*least})
        terms = {tuple(g.free_symbols & {*least}): g for g in groups}
        push, decays = terms.get((), S.Zero), []
        constants = Tuple(push, *self.weights.values())
        are_joint = any(states[1:] for states in terms)
        if not self.is_diagonal or _moves(constants, moving) or are_joint:
            return None
        for s, weight in self.weights.items():
            term = terms.get((s,), S.Zero)
            bound = _complete_square(term, s, moving) or _bound_of_leak(
                term, s, least[s]
            )
            if bound is None and s not in self.largest and term.free_symbols == {s}:
                bound = lowest_level(s**2 / 2, [term])
            if bound is None:
                return None
            if s in self.largest:  # w u s <= a s^2/2 + (w u)^2/(2 a)
                if bound.push != 0 or bound.decay == 0:
                    return None
                share = (weight * self.largest[s]) ** 2 / (2 * bound.decay)
                bound = RateBound(bound.decay, share)
            push += bound.push
            # of the square of a root nothing is needed to complete a square
            share = 2 if s in self.case.where.roots and bound.push == 0 else 1
            decays.append(share * bound.decay / weight)
        return RateBound(Min(*decays), push)

    def by_rate_bound(self) -> Fall | None:
        """Return the level c/k of V' <= -k V + c, or if k is 0 the mean of e^T KD e."""
        bound = self.rate_bound()
        if bound is None:
            return None
        # V of the next time is at most (1 - k) V + c
        is_slow = not self.case.eq.discrete or (1 - bound.decay).is_nonnegative
        return self.claimed(bound) if is_slow else None

    def claimed(self, bound: RateBound, more: str = "") -> Fall | None:
        """Return what a bound of V' says of V, or of the mean of the errors that V' loses."""
        if bound.push == 0 or (bound.decay == 0 and not self.has_decay()):
            return None
        level = bound.push / bound.decay if bound.decay != 0 else None
        decay, push = (e.xreplace(self.case.given) for e in bound)
        is_number = decay.is_number and push.is_number
        push = outward(push)
        if decay == 0:
            c = self.letter("c")
            mean = said("`e^T KD e` is at most 2 {}", c)
            claim = said("V' <= `-e^T KD e/2` + {}, {} = {}{}", c, c, push, more)
            return bounded(claim, "mean", bound=mean)
        decay = outward(decay, up=False)
        if is_number:
            share = "" if decay == 1 else said("{} ", decay)
            claim = said("V' <= -{}V + {}{}", share, push, more)
            return bounded(claim, "pulled", level)
        r, c = map(self.letter, "rc")
        claim = said(
            "V' <= -{} V + {}, {} = {}, {} = {}{}", r, c, c, push, r, decay, more
        )
        return bounded(claim, "pulled", level, bound=said("{}/{}", c, r))

    def has_decay(self) -> bool:
        """Return whether V' has -e^T KD e, or more of it."""
        if any(call.has(*self.KD) for call in self.residual.atoms(AppliedUndef)):
            # how it bends is not known
            return False
        slopes = (diff(self.residual, e, 2) for e in self.KD)
        return self.has_square and all(slope.is_nonpositive for slope in slopes)

    def letter(self, name: str) -> Symbol:
        """Return a letter of the sentence, with a number where the loop has it."""
        while name in self.case.eq.named:
            name += "_1"
        return Symbol(name)

    # --- V' with |e| ----------------------------------------------------------------------------

    def by_error(self) -> Fall | None:
        """Return the level where V' has |e| in it, the largest of all corners."""
        levels = [*map(self.level_by_error, self.corners())]
        if not levels or None in levels:
            return None
        return bounded(f"V' <= 0 {ABOVE}", "ceiling", Max(*levels))

    def level_by_error(self, rate: Expr) -> Expr | None:
        """Return V above which V' = -e^T K e + p^T e - |e| (z^T A z - b^T z - push) falls."""
        states, weights = self.least, self.weights
        sizes = [
            f
            for f in rate.atoms(sympy.Abs, sympy.Pow)
            if (f**2).is_polynomial() and not f.is_polynomial() and f.has(*states)
        ]
        if len(sizes) != 1 or not self.is_diagonal:
            return None
        (size,) = sizes
        decay, leak = rate.as_independent(size, as_Add=True)
        errors = [s for s in states if size.has(s)]
        of_e, left = quadratic_terms(decay, errors)
        of_z, left_in_leak = quadratic_terms(
            expand(leak / size), states.keys() - errors
        )
        is_norm = expand(size**2 - Add(*(e**2 for e in errors))) == 0
        numbers = Tuple(*chain(*of_e.values(), *of_z.values()), *weights.values())
        is_known = left == 0 == left_in_leak and is_norm
        if not is_known or _moves(numbers, {*states, *self.moving}):
            return None
        if not (of_z and all(a.is_positive for a, _ in (of_e | of_z).values())):
            return None
        c = self.push + Add(*(b**2 / (2 * a) for a, b in of_z.values()))
        c += sqrt(Add(*(p**2 for _, p in of_e.values())))
        corners = [weights[s] * c / a for s, (a, _) in of_z.items()]
        heaviest, slowest = (
            Max(*map(weights.get, of_e)),
            Min(*(k for k, _ in of_e.values())),
        )
        return Max(heaviest * c**2 / (2 * slowest**2), *corners)

    # --- V of one state, and inputs -------------------------------------------------------------

    def far_off(self) -> Fall | None:
        """Return the level above which V of one state falls, V' < 0 at each corner there."""
        V, rates = self.about_least(self.V), self.corners()
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

    # --- leaks of laws --------------------------------------------------------------------------

    def size(self, leak: Leak) -> Expr:
        """Return |s*|."""
        return sqrt(Add(*(self.least[s] ** 2 for s in leak.states)))

    def rising(self) -> Fall | None:
        """Return the level where every factor rises with |s|."""
        full, excess, conditions = self.rate, S.Zero, []
        for leak in self.leaks:
            radial = radial_of(leak)
            if radial is None or leak.factor != radial.word:
                return None
            size, R, top = self.size(leak), radial.R, radial.top
            full = full.subs(radial.word, top)
            excess += top * leak.weight * (R**2 + size * R)
            conditions.append(said("{} <= {}", size, at_least(float(radial.M))))
        bound = self.bound_by_terms(expand(full)) if self.leaks else None
        if bound is None:
            return None
        more = said("; where {}, V' <= `-e^T KD e` without `Delta`", listed(conditions))
        return self.claimed(RateBound(bound.decay, bound.push + excess), more)

    def within_balls(self) -> Fall | None:
        """Return the level where what is learned stays within balls."""
        leaking = {s for leak in self.leaks for s in leak.states}
        if not (leaking and self.has_square) or leaking != self.least.keys() - self.KD:
            return None
        level, conditions = self.push**2 / (2 * Min(*self.KD.values()) ** 2), []
        for leak in self.leaks:
            radial = radial_of(leak)
            if (
                radial is None
                or radial.top != 1
                or not stays_within(leak, radial, self.case.motion)
            ):
                return None
            heaviest = Max(*(self.weights[s] for s in leak.states))
            level += heaviest * (radial.R + self.size(leak)) ** 2 / 2
            port = Symbol(leak.states[0].name.partition("_")[0])
            radius = said("|{}| <= {}", port, at_most(float(radial.R)))
            truth = said("{} <= {}", self.size(leak), at_least(float(radial.M)))
            conditions.append((truth, radius))
        truths, radii = map(listed, zip(*conditions, strict=True))
        where = [Condition("start", radii), Condition("truth", truths)]
        claim = said("V' <= `-e^T KD e + e^T Delta`, {} for good", radii)
        return bounded(claim, "pulled", level, conditions=where)


WAYS = (
    UltimateBound.by_rate_bound,  # V' <= -k V + c
    UltimateBound.by_error,  # V' <= -|e| (k |e| + a z^2/2 - c)
    UltimateBound.far_off,  # V' < 0 beyond a distance
    UltimateBound.rising,  # leaks that rise with |s|
    UltimateBound.within_balls,  # leaks that keep |s| <= R
)
