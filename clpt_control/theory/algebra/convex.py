"""Functions that are strictly convex and grow without end: each has one least point.

    V = sum of groups g_k that share no state,    g = s^T H s/2 + convex,  H > 0,
    or g of one state with g'' >= 0,  g'(-n) < 0 < g'(n)

The least point is known to exist, and is none in closed form: of the loss of a logistic regression,
or of log(cosh(s)) - s/2.  Smooth functions here are power series about each point, so g' of one
state that does not fall, and is not the same everywhere, rises.

Source: Boyd, S., Vandenberghe, L. (2004), Convex Optimization, sections 3.1.4, 9.1.2.
"""

from collections.abc import Collection
from typing import Any

from sympy import Add, Dummy, Expr, Matrix, S, hessian, symbols

from .decide import never_positive
from .exact import groups_of, normal_form
from .facts import is_smooth, roots_in

FAR = [S(10) ** k for k in range(4)]  # where a slope of one state has its sign


def has_one_least_point(V: Expr, states: Collection[Any], fixed: set) -> bool:
    """Return whether a function is known to be strictly convex, and to grow without end."""
    groups = (g for g in groups_of(V, {*states}) if g.has(*states))
    return (
        is_smooth(V)
        and all(base.is_positive for base in roots_in(V))
        and V.free_symbols - fixed == {*states} != set()
        and all(_is_bowl(g, fixed) for g in groups)
    )


def _is_bowl(g: Expr, fixed: set) -> bool:
    """Return whether a group of terms is strictly convex, and grows."""
    s = sorted(g.free_symbols - fixed, key=str)
    z, d = Matrix(s), Matrix(symbols(f"d_:{len(s)}", real=True, cls=Dummy))
    of_powers = Add(*(term for term in Add.make_args(g) if term.is_polynomial(*s)))
    H = hessian(of_powers, s).xreplace(dict.fromkeys(s, S.Zero))
    if is_definite := bool(H.is_positive_definite):
        g -= (z.T * H * z)[0] / 2

    def is_convex(e: Expr) -> bool:
        bends = (d.T * hessian(e, s) * d)[0]
        return never_positive(normal_form(-bends), fixed)

    def rises(side: int) -> bool:
        slopes = (side * g.diff(s[0]).subs(s[0], side * n) for n in FAR)
        return any(slope.is_positive for slope in slopes)

    turns = is_definite or (len(s) == 1 and rises(1) and rises(-1))
    return turns and (is_convex(g) or all(map(is_convex, Add.make_args(g))))
