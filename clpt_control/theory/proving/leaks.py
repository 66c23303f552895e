"""What bounds V where V' does not fall by itself: leaks, and a dead zone in V.

Leaks are what a law has beyond the paper's, where a factor f >= 0 pulls states to zero.

    V' = -e^T KD e - sum over groups of f w s^T (s - s*),    s* the true values, w > 0

is read off V', each f a product of words and roots.  What is known of f then bounds V:

- **f rises with |s|**, zero up to M and h from R on.  It is h but within R, where the difference
  is at most h w (R^2 + |s*| R): V' <= (V' with f = h) + that, whatever s* is.
- **f = |e|**.  s^T (s - s*) >= (|s - s*|^2 - |s*|^2)/2, so with c = w |s*|^2/2 + |Delta|

      V' <= -|e| (k |e| + w |s - s*|^2/2 - c)

  V falls outside a convex set; V is convex in (|e|, |s - s*|^2), so at most that of its corners.
- **f takes the outward part of s' away** beyond R: |s| <= R for good.  Where |s*| <= M as well,
  f > 0 only where s^T (s - s*) >= 0, so V' <= -e^T KD e + e^T Delta.

Delta is the disturbance of Eq. (32), which adds e^T Delta to V'.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import sympy
from sympy.core.function import AppliedUndef

from .signs import Pull, positive_maximum, pulled


class Leak(NamedTuple):
    """A term -factor weight s^T (s - s*) of V', s the states of a group."""

    factor: sympy.Expr  # never negative
    states: tuple[sympy.Symbol, ...]
    weight: sympy.Expr  # positive

    @property
    def square(self) -> sympy.Expr:
        """|s|^2."""
        return sympy.Add(*(s**2 for s in self.states))


class Bound(NamedTuple):
    """What V comes to, and a sentence about it."""

    says: str
    level: sympy.Expr | None = None  # in theta, KD, GammaD and the bounds Delta_1, Delta_2


class Radial(NamedTuple):
    """A factor clip(u, 0, top) whose u rises with |s|: zero up to M, `top` from R on."""

    word: sympy.Expr
    M: sympy.Expr
    R: sympy.Expr
    top: sympy.Expr


def leaks_of(rest: sympy.Expr, truth: dict, moving: set) -> list[Leak]:
    """Return the leaks that V' has beyond -e^T KD e; none where it has anything else."""
    found: dict[sympy.Expr, sympy.Expr] = {}
    for term in sympy.Add.make_args(sympy.expand(rest)):
        own = [f for f in sympy.Mul.make_args(term) if _is_factor(f, moving)]
        factor = sympy.Mul(*own)
        found[factor] = found.get(factor, sympy.Integer(0)) + term / factor
    leaks = []
    for factor, part in found.items():
        states = tuple(s for s in truth if part.has(s))
        if not states or not all(map(_not_negative, sympy.Mul.make_args(factor))):
            return []
        weight = -part.coeff(states[0], 2)
        wanted = sympy.Add(*(-weight * s * (s - truth[s]) for s in states))
        if not weight.is_positive or weight.free_symbols or sympy.expand(part - wanted) != 0:
            return []
        leaks.append(Leak(factor, states, weight))
    return leaks


def _is_factor(f: sympy.Expr, moving: set) -> bool:
    base = f.base if isinstance(f, sympy.Pow) else f
    if isinstance(f, sympy.Pow) and f.exp == sympy.Rational(1, 2):
        return bool(base.free_symbols & moving)
    return isinstance(base, AppliedUndef) and str(base.func) in ("clip", "maximum")


def _not_negative(f: sympy.Expr) -> bool:
    """Return whether a factor is known not to be negative."""
    if isinstance(f, sympy.Pow) and f.exp == -1:
        return positive_maximum(f.base)
    if isinstance(f, AppliedUndef) and str(f.func) == "clip":
        return bool(f.args[1].is_nonnegative and f.args[2].is_nonnegative)
    if isinstance(f, AppliedUndef):
        return any(a.is_nonnegative for a in f.args)
    return bool(f.is_nonnegative) or (isinstance(f, sympy.Pow) and f.exp == sympy.Rational(1, 2))


def _radial(leak: Leak) -> Radial | None:
    """Return the factor clip(u(|s|), 0, top) of a leak, if it has one."""
    r = sympy.Symbol("r", positive=True)
    for word in sympy.Mul.make_args(leak.factor):
        if not isinstance(word, AppliedUndef) or str(word.func) != "clip":
            continue
        u, low, top = word.args
        along = u.subs(dict.fromkeys(leak.states[1:], 0)).subs(leak.states[0], r)
        if along.free_symbols != {r} or along.has(AppliedUndef) or low != 0 or not top.is_positive:
            continue
        same = sympy.expand(u - along.subs(r, sympy.sqrt(leak.square))) == 0
        ends = [sympy.solve(along - at, r) for at in (0, top)]
        if same and sympy.diff(along, r).is_positive and all(len(end) == 1 for end in ends):
            return Radial(word, ends[0][0], ends[1][0], top)
    return None


@dataclass
class Leaking:
    """V' of a law with leaks, at the numbers of its parameters."""

    rate: sympy.Expr
    leaks: list[Leak]
    V: sympy.Expr
    truth: dict
    moving: set
    rates: dict
    KD: list[sympy.Expr]
    disturbed: bool

    def __post_init__(self) -> None:
        H, truth, self.k = sympy.hessian(self.V, list(self.truth)), self.truth, sympy.Min(*self.KD)
        self.weights = {s: H[j, j] for j, s in enumerate(truth)}
        self.errors = list(truth)[:2]  # x, whose truth is z
        square = all(self.weights[s] == 1 for s in self.errors) and H.is_diagonal()
        one_each = [s for leak in self.leaks for s in leak.states]
        self.all_leak = square and sorted(one_each, key=str) == sorted(list(truth)[2:], key=str)
        self.delta = delta_bounds(self.disturbed)
        self.push = sympy.sqrt(sympy.Add(*(d**2 for d in self.delta)))

    def bound(self) -> Bound | None:
        """Return what is known of V, or None."""
        return self.rising() or self.by_error() or self.kept_within()

    def size(self, leak: Leak) -> sympy.Expr:
        """Return |s*|."""
        return sympy.sqrt(sympy.Add(*(self.truth[s] ** 2 for s in leak.states)))

    def rising(self) -> Bound | None:
        """Return the bound where every factor rises with |s|."""
        full, more, within = self.rate, sympy.Integer(0), []
        for leak in self.leaks:
            own = _radial(leak)
            if own is None or leak.factor != own.word:
                return None
            full = full.subs(own.word, own.top)
            more += own.top * leak.weight * (own.R**2 + self.size(leak) * own.R)
            within.append(f"{self.size(leak)} <= {float(own.M):.4g}")
        pull = pulled(sympy.expand(full), self.V, self.truth, {}, self.moving)
        if pull is None:
            return None
        bound = pull_bound(Pull(pull.rate, pull.push + more), self.KD, self.delta)
        said = f"; where {listed(within)}, V' <= -e^T KD e without Delta"
        return Bound(bound.says + said, bound.level)

    def by_error(self) -> Bound | None:
        """Return the bound where the one factor is |e|."""
        if len(self.leaks) != 1 or not self.all_leak:
            return None
        (leak,) = self.leaks
        square = sympy.Add(*((s - self.truth[s]) ** 2 for s in self.errors))
        if leak.factor.func is not sympy.Pow or sympy.expand(leak.factor.base - square) != 0:
            return None
        c = leak.weight * self.size(leak) ** 2 / 2 + self.push
        slowest = sympy.Max(*(self.weights[s] for s in leak.states))
        level = sympy.Max(c**2 / (2 * self.k**2), slowest * c / leak.weight)
        return Bound(f"V' <= 0 where V >= {level.n(4)}, so V never rises above it", level)

    def kept_within(self) -> Bound | None:
        """Return the bound where what is learned stays within balls."""
        if not self.all_leak:
            return None
        level, within = self.push**2 / (2 * self.k**2), []
        for leak in self.leaks:
            own = _radial(leak)
            if own is None or own.top != 1 or not self.stays(leak, own):
                return None
            slowest = sympy.Max(*(self.weights[s] for s in leak.states))
            level += slowest * (own.R + self.size(leak)) ** 2 / 2
            port = leak.states[0].name.partition("_")[0]
            radius, largest = f"|{port}| <= {float(own.R):.4g}", f"{float(own.M):.4g}"
            within.append((f"{self.size(leak)} <= {largest}", radius))
        truths, radii = map(listed, zip(*within, strict=True))
        return Bound(
            f"{radii} for good where it starts so; where {truths}, "
            f"V' <= -e^T KD e + e^T Delta, and V comes down to {level.n(4)}",
            level,
        )

    def stays(self, leak: Leak, own: Radial) -> bool:
        """Return whether |s| never grows where |s| >= R: s^T s' = o - max(o, 0)."""
        outward = [f for f in leak.factor.atoms(AppliedUndef) if f.args[-1] == 0]
        divisor = [f for f in leak.factor.atoms(AppliedUndef) if positive_maximum(f)]
        if len(outward) != 1 or len(divisor) != 1:
            return False
        (taken,), (least,) = outward, divisor
        if leak.factor != own.word * taken / least or str(taken.func) != "maximum":
            return False
        if sympy.expand(least.args[0] - leak.square) != 0 or least.args[1] > own.R**2:
            return False
        n, part, o = sympy.Dummy(nonnegative=True), sympy.Dummy(), taken.args[0]
        beyond = {own.word: own.top, taken: o + n, least: 1 / part}
        power = sympy.expand(sympy.Add(*(s * self.rates[s] for s in leak.states)))
        power = sympy.expand(power.xreplace(beyond))
        rest = power.subs(part, 0) * leak.square + sympy.diff(power, part)
        return sympy.diff(power, part, 2) == 0 and sympy.expand(rest + n * leak.square) == 0


def listed(parts: Sequence[str]) -> str:
    """Return "a, b and c"."""
    return " and ".join(part for part in (", ".join(parts[:-1]), parts[-1]) if part)


def delta_bounds(disturbed: bool) -> tuple[sympy.Expr, sympy.Expr]:
    """Return the bounds of |Delta_1| and |Delta_2|; zero without a disturbance."""
    if not disturbed:
        return sympy.Integer(0), sympy.Integer(0)
    first, second = sympy.symbols("Delta_1 Delta_2", positive=True)
    return first, second


def pull_bound(pull: Pull, KD: list[sympy.Expr], delta: tuple) -> Bound:
    """Return what V or e comes to, with Delta: e Delta <= KD e^2/2 + Delta^2/(2 KD)."""
    push = pull.push + sum(d**2 / (2 * k) for d, k in zip(delta, KD, strict=True))
    shown, rate = push.n(4), pull.rate.n(4)
    if rate == 0:
        said = f"V' <= -e^T KD e/2 + {shown}: in the mean e^T KD e is at most {2 * shown}"
        return Bound(said)
    said = f"V' <= -{rate} V + {shown}: V comes down to {shown / rate}"
    return Bound(said, push / pull.rate)
