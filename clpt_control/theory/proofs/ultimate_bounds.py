"""Ultimate bounds of V from dissipative terms and leaks.

A term that pulls back bounds one that does not:

    -a s^2 + b s <= -(a/2) s^2 + b^2/(2 a)

Leaks are what a law has beyond the paper's, where a factor f >= 0 pulls states to zero.

    V' = -e^T KD e - sum over groups of f w s^T (s - s*),    s* the true values, w > 0

is read off V', each f a product of words and roots.  The kind of f then bounds V:

- **f rises with |s|**, zero up to M and h from R on.  It is h but within R, where the difference
  is at most h w (R^2 + |s*| R): V' <= (V' with f = h) + that, whatever s* is.
- **f = |e|**.  -a z^2 + b z <= -a z^2/2 + b^2/(2 a), z = s - s*, so c = sum b^2/(2 a) + |Delta| and

      V' <= -|e| (k |e| + sum a z^2/2 - c)

  V falls outside a convex set; V is convex in |e| and all z^2, so at most that of its corners.
- **f takes the outward part of s' away** beyond R: |s| <= R for good.  Where |s*| <= M as well,
  f > 0 only where s^T (s - s*) >= 0, so V' <= -e^T KD e + e^T Delta.

Delta is the disturbance of Eq. (32), which adds e^T Delta to V'.
"""

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np
import sympy
from sympy.core.function import AppliedUndef

from ...base.units import at_least, at_most
from ...engine.diagram.symbol_names import TIME
from ...engine.record.symbolic import rational
from ..algebra.decide import groups_of
from ..algebra.facts import interval, is_positive_maximum
from ..algebra.sums_of_squares import squares, zero_of
from ..algebra.texts import bound_text
from .conclusions import Condition
from .judge import Fall
from .steps import exact


class Pull(NamedTuple):
    """V' <= -rate V + push, or -e^T KD e/2 + push where rate is zero."""

    rate: sympy.Expr  # in what the law does not know: theta, KD and GammaD
    push: sympy.Expr


def bounded(claim: str, shows: str, level: Any = None, **fields: Any) -> Fall:
    """Return a bound of V or of the mean of e, and what conclusions require of it.

    `level` is in theta, KD, GammaD and the bounds Delta_1, Delta_2.
    """
    step = exact(claim, True, "", shows)
    return Fall([step], claim, level=level, **fields)


class Leak(NamedTuple):
    """A term -factor weight s^T (s - s*) of V', s the states of a group."""

    factor: sympy.Expr  # never negative
    states: tuple[sympy.Symbol, ...]
    weight: sympy.Expr  # positive

    @property
    def square(self) -> sympy.Expr:
        """|s|^2."""
        return sympy.Add(*(s**2 for s in self.states))


class Radial(NamedTuple):
    """A factor clip(u, 0, top) whose u rises with |s|: zero up to M, `top` from R on."""

    word: sympy.Expr
    M: sympy.Expr
    R: sympy.Expr
    top: sympy.Expr


def leaks_of(residual: sympy.Expr, truth: dict, moving: set) -> list[Leak]:
    """Return the leaks that V' has beyond -e^T KD e; none where it has anything else."""
    residuals: dict[sympy.Expr, sympy.Expr] = {}  # by the factor of the leak
    for term in sympy.Add.make_args(sympy.expand(residual)):
        factor = sympy.Mul(
            *(f for f in sympy.Mul.make_args(term) if _is_factor(f, moving))
        )
        residuals[factor] = residuals.get(factor, sympy.Integer(0)) + term / factor
    leaks = []
    for factor, residual_term in residuals.items():
        states = tuple(s for s in truth if residual_term.has(s))
        if not states or not all(map(_not_negative, sympy.Mul.make_args(factor))):
            return []
        weight = -residual_term.coeff(states[0], 2)
        leak_form = sympy.Add(*(-weight * s * (s - truth[s]) for s in states))
        if (
            not weight.is_positive
            or weight.free_symbols
            or sympy.expand(residual_term - leak_form) != 0
        ):
            return []
        leaks.append(Leak(factor, states, weight))
    return leaks


def _is_factor(f: sympy.Expr, moving: set) -> bool:
    base, power = f.as_base_exp()
    root = power == sympy.S.Half and base.free_symbols & moving
    return bool(root) or str(base.func) in ("clip", "maximum")


def _not_negative(f: sympy.Expr) -> bool:
    """Return whether a factor is known not to be negative; a root is not, where it is a number."""
    return f.as_base_exp()[1] == sympy.S.Half or bool(interval(f)[0].is_nonnegative)


def _radial(leak: Leak) -> Radial | None:
    """Return the factor clip(u(|s|), 0, top) of a leak, if it has one."""
    r = sympy.Symbol("r", positive=True)
    for word in sympy.Mul.make_args(leak.factor):
        if not isinstance(word, AppliedUndef) or str(word.func) != "clip":
            continue
        u, low, top = word.args
        on_axis = u.subs(dict.fromkeys(leak.states[1:], 0)).subs(leak.states[0], r)
        if (
            on_axis.free_symbols != {r}
            or on_axis.has(AppliedUndef)
            or low != 0
            or not top.is_positive
        ):
            continue
        is_radial = sympy.expand(u - on_axis.subs(r, sympy.sqrt(leak.square))) == 0
        ends = [sympy.solve(on_axis - value, r) for value in (0, top)]
        if (
            is_radial
            and sympy.diff(on_axis, r).is_positive
            and all(len(end) == 1 for end in ends)
        ):
            return Radial(word, ends[0][0], ends[1][0], top)
    return None


def _pull_of(quadratic: sympy.Expr, s: sympy.Symbol, moves: set) -> Pull | None:
    """Return a and b^2/(2 a) of -a s^2 + b s."""
    a, b = -quadratic.coeff(s, 2), quadratic.coeff(s, 1)
    if sympy.expand(quadratic + a * s**2 - b * s) != 0:
        return None
    if (
        not a.is_nonnegative
        or _moves(a, moves)
        or _moves(b, moves)
        or (a == 0 and b != 0)
    ):
        return None
    return Pull(a, b**2 / (2 * a) if b != 0 else sympy.S.Zero)


def _leak_of(term: sympy.Expr, s: sympy.Symbol, true: sympy.Expr) -> Pull | None:
    """Return how -f a^2k a (a - a*) pulls, a = a* + s, for f between two numbers.

    It is not positive but where |a| < |a*|, and there at most f |a*|^(2k + 2)/4; where f keeps away
    from zero and k is 0 it is -f s^2/2 and at most f |a*|^2/2.
    """
    a = sympy.Dummy(real=True)
    of_a = sympy.expand(term.xreplace({s: a - true}))
    if not of_a.is_polynomial(a):
        return None
    share, remainder = sympy.div(of_a, sympy.expand(-a * (a - true)), a)
    push, slowest = sympy.S.Zero, sympy.S.Zero
    for (power,), f in sympy.Poly(share, a).terms() if remainder == 0 else ():
        low, high = interval(f)
        if power % 2 or not (low.is_extended_nonnegative and high.is_finite):
            return None
        if power == 0 and low.is_positive:
            slowest, push = low, push + high * true**2 / 2
        else:
            push += high * true ** (power + 2) / 4
    return Pull(slowest, push) if push != 0 else None


def _moves(expression: sympy.Expr, moving: set) -> bool:
    return bool(expression.free_symbols & moving or expression.atoms(sympy.Function))


def pulled(
    V: sympy.Expr, rate: sympy.Expr, rest: Mapping[Any, sympy.Expr], moving: set
) -> Pull | None:
    """Bound V' by what pulls back and a constant, state by state, about the rest.

    None where V' is not a sum of a term -a s^2 + b s, or a leak, for each error s; what depends on
    a state or time is no constant.
    """
    moves, states = {*rest, *moving}, [*rest]
    H = sympy.hessian(V, states)
    weights = {s: H[j, j] for j, s in enumerate(states)}
    rate = sympy.expand(rate.xreplace({s: s + true for s, true in rest.items()}))
    groups = {tuple(g.free_symbols & {*rest}): g for g in groups_of(rate, {*rest})}
    if not H.is_diagonal() or any(len(symbols) > 1 for symbols in groups):
        return None
    if any(_moves(weight, moves) for weight in weights.values()):
        return None
    push, rates = groups.get((), sympy.S.Zero), []
    if _moves(push, moves):
        return None
    for s, weight in weights.items():
        term = groups.get((s,), sympy.S.Zero)
        pull = _pull_of(term, s, moves) or _leak_of(term, s, rest[s])
        if pull is None:
            return None
        push += pull.push
        rates.append(pull.rate / weight)
    return None if push == 0 else Pull(sympy.Min(*rates), push)


def pulled_at_once(
    V: sympy.Expr, rate: sympy.Expr, rest: Mapping[Any, sympy.Expr]
) -> Pull | None:
    """Bound V' = -z^T A z + b^T z + c by V = z^T P z and a constant; numbers alone.

    -z^T (A - r P) z + b^T z <= b^T (A - r P)^-1 b/4, with r half of the largest that A allows.
    """
    states = [*rest]
    polynomials = [
        sympy.Poly(e, *states) for e in (V, rate) if e.is_polynomial(*states)
    ]
    if len(polynomials) < 2 or any(p.total_degree() > 2 for p in polynomials):
        return None
    P, A = (share * sympy.hessian(e, states) / 2 for e, share in ((V, 1), (rate, -1)))
    b = sympy.Matrix([sympy.diff(rate, s).xreplace(rest) for s in states])
    c = rate.xreplace(dict(rest))
    if any(not entry.is_Rational for entry in (*P, *A, *b, c)):
        return None
    if not (P.is_positive_definite and A.is_positive_definite):
        return None
    shares = np.linalg.eigvals(np.array(P.inv() * A, dtype=float)).real
    slowest = rational(float(f"{0.5 * shares.min():.2g}"))
    left = A - slowest * P
    if not left.is_positive_definite:
        return None
    return Pull(slowest, c + (b.T * left.inv() * b)[0] / 4)


class InForms(NamedTuple):
    """V and V' of a diagram in the forms of V, each of them one state."""

    V: sympy.Expr
    rate: sympy.Expr
    rest: dict[Any, sympy.Expr]
    forms: dict[Any, sympy.Expr]  # state -> its error, in the states of the diagram


def in_forms(case: Any) -> InForms | None:
    """Return V and V' of a diagram in the forms of V; None where V has no one least point."""
    coordinates: dict[Any, sympy.Expr] = {}
    forms: dict[Any, sympy.Expr] = {}
    for form in case.forms:
        states = sorted(form.free_symbols & {*case.motion}, key=str)
        if len(states) < 2 or not form.is_polynomial(*states):
            continue
        used = set().union(*(e.free_symbols for e in coordinates.values()), coordinates)
        for s in states:
            slope = sympy.diff(form, s)
            if slope.free_symbols <= case.fixed and s not in used and slope.is_nonzero:
                e = sympy.Dummy(case.text(form), real=True)
                coordinates[s] = sympy.expand((e - form) / slope + s)
                forms[e] = form
                break
    V, rate = (sympy.expand(e.xreplace(coordinates)) for e in (case.V, case.rate))
    total = squares(V, case.fixed)
    states = sorted(V.free_symbols - case.fixed, key=str)
    rest = zero_of(total, states) if total else None
    if rest is None:
        return None
    errors = {s: forms.get(s, s) - true for s, true in rest.items()}
    return InForms(V, rate, rest, errors)


def pulled_forms(case: Any) -> Fall | None:
    """Return the bound of V of a diagram in the forms of V, each of them one state."""
    found = in_forms(case)
    if found is None:
        return None
    V, rate, rest, _ = found
    moving = {TIME, *case.motion, *case.intervals}
    values = case.eq.values
    pull = pulled(V, rate, rest, moving) or pulled_at_once(V, rate, rest)
    if (
        pull is None and case.eq.discrete
    ):  # a step may lead from below a level to above it
        return None
    if pull is None:
        fall = pulled_by_error(V, rate, rest, moving)
    elif pull.rate == 0 or pull.push == 0:
        return None
    else:
        slowest, push = bound_text(pull.rate, up=False), bound_text(pull.push)
        claim = f"V' <= -{slowest} V + {push}"
        fall = bounded(claim, "pulled", pull.push / pull.rate)
    if fall is None or V.xreplace(rest).xreplace(values) != 0:
        return None
    level = fall.level.xreplace(values)
    fall.level = float(at_most(float(level))) if level.is_number else level
    return fall


def pulled_by_error(
    V: sympy.Expr,
    rate: sympy.Expr,
    rest: Mapping[Any, sympy.Expr],
    moving: set,
    push: Any = 0,
) -> Fall | None:
    """Return the bound of V where V' = -e^T K e - |e| (z^T A z - b^T z), K and A diagonal."""
    states = [*rest]
    H = sympy.hessian(V, states)
    rate = sympy.expand(rate.xreplace({s: s + true for s, true in rest.items()}))
    sizes = [f for f in rate.atoms(sympy.Abs, sympy.Pow) if (f**2).is_polynomial()]
    sizes = [f for f in sizes if not f.is_polynomial() and f.has(*states)]
    if len(sizes) != 1 or not H.is_diagonal():
        return None
    (size,) = sizes
    decay, leak = rate.as_independent(size, as_Add=True)
    share = sympy.expand(leak / size)
    K = {e: -decay.coeff(e, 2) for e in states if size.has(e)}
    A = {s: -share.coeff(s, 2) for s in states if s not in K}
    b = {s: share.coeff(s, 1) for s in A}
    left = [size**2, decay, share]
    left[0] -= sympy.Add(*(e**2 for e in K))
    left[1] += sympy.Add(*(k * e**2 for e, k in K.items()))
    left[2] += sympy.Add(*(a * s**2 - b[s] * s for s, a in A.items()))
    numbers = sympy.Tuple(*K.values(), *A.values(), *b.values(), *H)
    if any(map(sympy.expand, left)) or _moves(numbers, {*rest, *moving}):
        return None
    if not (A and all(k.is_positive for k in (*K.values(), *A.values()))):
        return None
    c = push + sympy.Add(*(b[s] ** 2 / (2 * a) for s, a in A.items()))
    weights = dict(zip(states, H.diagonal(), strict=True))
    corners = [weights[s] * c / a for s, a in A.items()]
    heaviest, slowest = sympy.Max(*map(weights.get, K)), sympy.Min(*K.values())
    level = sympy.Max(heaviest * c**2 / (2 * slowest**2), *corners)
    return bounded("V' <= 0 where V >= level", "ceiling", level)


class Bounding:
    """The bounds of V that follow from V' of a law, at the numbers of its parameters."""

    def __init__(self, case: Any):
        """Read a `LawCandidate`."""
        self.case, self.truth = case, case.least
        self.KD = list(case.loop.parameters["vehicle_controller"].KD)
        self.leaks = leaks_of(case.residual, self.truth, case.moving_symbols)
        H, self.k = sympy.hessian(case.V, list(self.truth)), sympy.Min(*self.KD)
        self.weights = {s: H[j, j] for j, s in enumerate(self.truth)}
        self.errors = [s for s in self.truth if s in case.e]
        learned = [s for s in self.truth if s not in case.e]
        self.square = H.is_diagonal() and all(self.weights[s] == 1 for s in self.errors)
        one_each = [s for leak in self.leaks for s in leak.states]
        self.all_leak = self.square and sorted(one_each, key=str) == sorted(
            learned, key=str
        )
        deltas = sympy.symbols("Delta_1:3", positive=True)  # the bounds of |Delta_i|
        self.delta = deltas if case.takes_delta() else (sympy.S.Zero, sympy.S.Zero)
        self.push = sympy.sqrt(sympy.Add(*(d**2 for d in self.delta)))

    def bound(self) -> Fall | None:
        """Return what is known of V, or None."""
        pull = self.pulled(self.case.rate) if self.case.has_decay() else None
        if pull is not None and (pull.rate != 0 or self.square):
            return self.pulled_to(pull)
        if not self.leaks:
            return None
        moving = self.case.moving_symbols
        by_error = partial(pulled_by_error, self.case.V, self.case.rate, self.truth)
        return self.rising() or by_error(moving, self.push) or self.within_balls()

    def pulled(self, rate: sympy.Expr) -> Pull | None:
        """Bound V' by what pulls back and a constant, state by state."""
        return pulled(self.case.V, rate, self.truth, self.case.moving_symbols)

    def pulled_to(self, pull: Pull, more: str = "") -> Fall:
        """Return what V or e comes to, with Delta: e Delta <= KD e^2/2 + Delta^2/(2 KD)."""
        shares = zip(self.errors, self.delta, self.KD, strict=True)
        push = pull.push + sum(self.weights[e] * d**2 / (2 * k) for e, d, k in shares)
        number = f"c, c = {bound_text(push)}"
        if pull.rate == 0:
            mean = "e^T KD e is at most 2 c"
            return bounded(f"V' <= -e^T KD e/2 + {number}{more}", "mean", bound=mean)
        rate = bound_text(pull.rate, up=False)
        claim = f"V' <= -r V + {number}, r = {rate}{more}"
        return bounded(claim, "pulled", push / pull.rate, bound="c/r")

    def size(self, leak: Leak) -> sympy.Expr:
        """Return |s*|."""
        return sympy.sqrt(sympy.Add(*(self.truth[s] ** 2 for s in leak.states)))

    def rising(self) -> Fall | None:
        """Return the bound where every factor rises with |s|."""
        full, excess, conditions = self.case.rate, sympy.Integer(0), []
        for leak in self.leaks:
            radial = _radial(leak)
            if radial is None or leak.factor != radial.word:
                return None
            full = full.subs(radial.word, radial.top)
            excess += (
                radial.top * leak.weight * (radial.R**2 + self.size(leak) * radial.R)
            )
            conditions.append(f"{self.size(leak)} <= {at_least(float(radial.M))}")
        pull = self.pulled(sympy.expand(full))
        if pull is None:
            return None
        more = f"; where {listed(conditions)}, V' <= -e^T KD e without Delta"
        return self.pulled_to(Pull(pull.rate, pull.push + excess), more)

    def within_balls(self) -> Fall | None:
        """Return the bound where what is learned stays within balls."""
        if not self.all_leak:
            return None
        level, conditions = self.push**2 / (2 * self.k**2), []
        for leak in self.leaks:
            radial = _radial(leak)
            if radial is None or radial.top != 1 or not self.stays(leak, radial):
                return None
            slowest = sympy.Max(*(self.weights[s] for s in leak.states))
            level += slowest * (radial.R + self.size(leak)) ** 2 / 2
            port = leak.states[0].name.partition("_")[0]
            radius, largest = (
                f"|{port}| <= {at_most(float(radial.R))}",
                f"{at_least(float(radial.M))}",
            )
            conditions.append((f"{self.size(leak)} <= {largest}", radius))
        truths, radii = map(listed, zip(*conditions, strict=True))
        where = [Condition("start", radii), Condition("truth", truths)]
        claim = f"V' <= -e^T KD e + e^T Delta, {radii} for good"
        return bounded(claim, "pulled", level, conditions=where)

    def stays(self, leak: Leak, radial: Radial) -> bool:
        """Return whether |s| never grows where |s| >= R: s^T s' = o - max(o, 0)."""
        outward = [f for f in leak.factor.atoms(AppliedUndef) if f.args[-1] == 0]
        divisor = [f for f in leak.factor.atoms(AppliedUndef) if is_positive_maximum(f)]
        if len(outward) != 1 or len(divisor) != 1:
            return False
        (outward_part,), (least,) = outward, divisor
        if (
            leak.factor != radial.word * outward_part / least
            or str(outward_part.func) != "maximum"
        ):
            return False
        if (
            sympy.expand(least.args[0] - leak.square) != 0
            or least.args[1] > radial.R**2
        ):
            return False
        n, inverse_square, o = (
            sympy.Dummy(nonnegative=True),
            sympy.Dummy(),
            outward_part.args[0],
        )
        beyond = {
            radial.word: radial.top,
            outward_part: o + n,
            least: 1 / inverse_square,
        }
        power = sympy.Add(*(s * self.case.motion[s] for s in leak.states))
        power = sympy.expand(sympy.expand(power).xreplace(beyond))
        remainder = power.subs(inverse_square, 0) * leak.square + sympy.diff(
            power, inverse_square
        )
        return (
            sympy.diff(power, inverse_square, 2) == 0
            and sympy.expand(remainder + n * leak.square) == 0
        )


def listed(items: Sequence[str]) -> str:
    """Return "a, b and c"."""
    return " and ".join(item for item in (", ".join(items[:-1]), items[-1]) if item)
