"""Leaks of an adaptive law: terms of V' where a factor f >= 0 pulls states to zero.

    V' = -e^T KD e - sum over groups of f w s^T (s - s*),    s* the true values, w > 0

is read off V', each f a product of words and roots.  `ultimate_bounds` bounds V by them.
"""

from collections.abc import Mapping
from typing import NamedTuple

import sympy
from sympy import Add, Dummy, Expr, Mul, Symbol, diff, expand
from sympy.core.function import AppliedUndef

from ..algebra.facts import interval, is_positive_maximum


class Leak(NamedTuple):
    """A term -factor weight s^T (s - s*) of V', s the states of a group."""

    factor: Expr  # never negative
    states: tuple[Symbol, ...]
    weight: Expr  # positive

    @property
    def square(self) -> Expr:
        """|s|^2."""
        return Add(*(s**2 for s in self.states))


class Radial(NamedTuple):
    """A factor clip(u, 0, top) whose u rises with |s|: zero up to M, `top` from R on."""

    word: Expr
    M: Expr
    R: Expr
    top: Expr


def leaks_of(residual: Expr, truth: dict, moving: set) -> list[Leak]:
    """Return the leaks that V' has beyond -e^T KD e; none where it has anything else."""
    residuals: dict[Expr, Expr] = {}  # by the factor of the leak
    for term in Add.make_args(expand(residual)):
        factor = Mul(*(f for f in Mul.make_args(term) if _is_factor(f, moving)))
        residuals[factor] = residuals.get(factor, sympy.Integer(0)) + term / factor
    leaks = []
    for factor, residual_term in residuals.items():
        states = tuple(s for s in truth if residual_term.has(s))
        if not states or not all(
            interval(f)[0].is_nonnegative for f in Mul.make_args(factor)
        ):
            return []
        weight = -residual_term.coeff(states[0], 2)
        leak_form = Add(*(-weight * s * (s - truth[s]) for s in states))
        if (
            not weight.is_positive
            or weight.free_symbols
            or expand(residual_term - leak_form) != 0
        ):
            return []
        leaks.append(Leak(factor, states, weight))
    return leaks


def _is_factor(f: Expr, moving: set) -> bool:
    base, power = f.as_base_exp()
    root = power == sympy.S.Half and base.free_symbols & moving
    return bool(root) or str(base.func) in ("clip", "maximum")


def radial_of(leak: Leak) -> Radial | None:
    """Return the factor clip(u(|s|), 0, top) of a leak, if it has one."""
    r = Symbol("r", positive=True)
    for word in Mul.make_args(leak.factor):
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
        is_radial = expand(u - on_axis.subs(r, sympy.sqrt(leak.square))) == 0
        ends = [sympy.solve(on_axis - value, r) for value in (0, top)]
        if (
            is_radial
            and diff(on_axis, r).is_positive
            and all(len(end) == 1 for end in ends)
        ):
            return Radial(word, ends[0][0], ends[1][0], top)
    return None


def stays_within(leak: Leak, radial: Radial, motion: Mapping) -> bool:
    """Return whether |s| never grows where |s| >= R: s^T s' = o - max(o, 0)."""
    if not motion.keys() >= {*leak.states}:
        return False
    calls = leak.factor.atoms(AppliedUndef)
    outward = [f for f in calls if f.args[-1] == 0]
    divisor = [f for f in calls if is_positive_maximum(f)]
    if len(outward) != 1 or len(divisor) != 1:
        return False
    (outward_part,), (least,) = outward, divisor
    if (
        leak.factor != radial.word * outward_part / least
        or str(outward_part.func) != "maximum"
        or expand(least.args[0] - leak.square) != 0
        or least.args[1] > radial.R**2
    ):
        return False
    n, inverse_square, o = (Dummy(nonnegative=True), Dummy(), outward_part.args[0])
    beyond = {radial.word: radial.top, outward_part: o + n, least: 1 / inverse_square}
    power = Add(*(s * motion[s] for s in leak.states))
    power = expand(expand(power).xreplace(beyond))
    remainder = power.subs(inverse_square, 0) * leak.square + diff(
        power, inverse_square
    )
    return (
        diff(power, inverse_square, 2) == 0 and expand(remainder + n * leak.square) == 0
    )
