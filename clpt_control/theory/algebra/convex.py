"""Functions that are strictly convex and grow without end: each has one least point.

    V = sum of groups g_k that share no state,    g = s^T H s/2 + convex,  H > 0,
    or g of one state with g'' >= 0, and slopes below and above 0

The least point is known to exist, and is none in closed form: of the loss of a logistic regression,
or of log(cosh(s)) - s/2.  Smooth functions here are power series about each point, so g' of one
state that does not fall, and is not the same everywhere, rises.

Source: Boyd, S., Vandenberghe, L. (2004), Convex Optimization, sections 3.1.4, 9.1.2.
"""

from collections.abc import Collection
from typing import Any

from sympy import Add, Dummy, Expr, Matrix, S, hessian, sign, symbols

from .decide import never_positive
from .exact import groups_of, normal_form
from .facts import is_smooth, roots_in

POINTS = [S(10) ** k for k in range(-3, 4)]  # where a slope may have both signs


def has_one_least_point(V: Expr, states: Collection[Any], fixed: set) -> bool:
    """Return whether V is strictly convex, and least at one point; states above 0 stay there."""
    if not (is_smooth(V) and states and V.free_symbols - fixed == {*states}):
        return False
    groups = groups_of(V, {*states})
    return all(_is_bowl(g, fixed) for g in groups if g.has(*states))


def _is_bowl(g: Expr, fixed: set) -> bool:
    """Return whether a group of terms is strictly convex, and least at one point."""
    s = sorted(g.free_symbols - fixed, key=str)
    d = Matrix(symbols(f"d_:{len(s)}", real=True, cls=Dummy))
    of_powers = Add(*(term for term in Add.make_args(g) if term.is_polynomial(*s)))
    H = hessian(of_powers, s).xreplace(dict.fromkeys(s, S.Zero))
    is_above = any(symbol.is_positive for symbol in s)
    points = POINTS if is_above else [*POINTS, *(-n for n in POINTS)]
    signs = {sign(g.diff(s[0]).subs(s[0], n)) for n in points}
    is_least = len(s) == 1 and signs >= {1, -1}
    if H.is_positive_definite:
        g -= (Matrix([s]) * H * Matrix(s))[0] / 2
        is_least |= not is_above

    def is_convex(e: Expr) -> bool:
        bends = (d.T * hessian(e, s) * d)[0]
        has_slopes = all(base.is_positive for base in roots_in(bends))
        return has_slopes and never_positive(normal_form(-bends), fixed)

    return is_least and (is_convex(g) or all(map(is_convex, Add.make_args(g))))
