"""A V that is searched for: a guess here, which `lyapunov` then checks as any other.

    V = sum_ij c_ij z_i z_j + sum_k b_k int_0^{z_i} h_k(s) ds,    z = x - x_rest

h_k are the functions of one state that stand in the rates: sin, tanh, odd powers.  V' is linear in
the coefficients, and so is the condition that V and -V' are diagonally dominant sums of squares: a
linear program, of few terms that hold as many states as they can.  What it finds is rounded such
that what cancels in V' cancels exactly.  Where it finds nothing that is proved, V is that of the
linear part, A^T P + P A = -I.

Source: Ahmadi, A. A., Majumdar, A. (2019), DSOS and SDSOS optimization, SIAM Journal on Applied
Algebra and Geometry 3(2), 193-230; Khalil, H. K. (2002), Nonlinear Systems, Theorem 4.6.
"""

from collections import defaultdict
from collections.abc import Iterator
from fractions import Fraction
from itertools import chain, combinations, combinations_with_replacement

import numpy as np
import scipy.optimize
import scipy.sparse
import sympy

from ..base.errors import DiagramError
from ..engine.diagram.symbol_names import TIME
from .proofs.exact import vanishes
from .proofs.facts import ODD, along, decided
from .proofs.steps import short
from .proofs.system_candidate import SystemCandidate

MOST = 16  # states
SHARE = 10**4  # the largest denominator of a coefficient
HELD = 100.0  # what a held state weighs beside a coefficient

Rates = dict[sympy.Symbol, sympy.Expr]
Monomial = tuple[int, ...]


def candidates(case: SystemCandidate) -> Iterator[sympy.Expr]:
    """Yield functions that may be a V of a diagram about its rest, the plainest first.

    First for any inputs, then for inputs of 0.
    """
    rest = case.rest or dict.fromkeys(case.states, sympy.S.Zero)
    zero = dict.fromkeys(case.inputs, sympy.S.Zero)
    rates: Rates = {}
    for s, rate in case.eq.motion.items():
        number = rate.xreplace(case.eq.values)
        slope = number.xreplace(rest).xreplace(zero)
        if slope.is_number and not vanishes(slope):
            value = f"= {short(slope)}" if slope.is_finite else "has no value"
            raise DiagramError(
                f"{case.system.name}: {s}' {value} at the rest: give it (at=)"
            )
        rates[s] = sympy.expand(number.xreplace({q: q + rest[q] for q in rest}))
    if len(rates) > MOST:
        raise DiagramError(
            f"{case.system.name}: has {len(rates)} states; a V is searched for of at most {MOST}: "
            "give one"
        )
    still = {s: rate.xreplace(zero) for s, rate in rates.items()}
    programs = [_of_program(rates), *[_of_program(still)] * bool(case.inputs)]
    found = chain(*programs, _of_linear_part(still))
    for V in dict.fromkeys(found):
        yield V.xreplace({s: s - rest[s] for s in rest})


def _of_linear_part(rates: Rates) -> Iterator[sympy.Expr]:
    """Yield z^T P z with A^T P + P A = -I where A is Hurwitz."""
    states = list(rates)
    zero = dict.fromkeys(states, sympy.S.Zero)
    A = sympy.Matrix(
        [[along(rate, {s: sympy.S.One}) for s in states] for rate in rates.values()]
    )
    A = A.xreplace(zero).applyfunc(decided)
    if not all(one.is_Rational for one in A):
        return
    if np.linalg.eigvals(np.array(A, dtype=float)).real.max() < -1e-9:
        n = len(states)
        places = list(combinations_with_replacement(range(n), 2))
        known = {at: sympy.Symbol("p_{}_{}".format(*at)) for at in places}
        P = sympy.Matrix(n, n, lambda i, j: known[min(i, j), max(i, j)])
        (found,) = sympy.linsolve(list(A.T * P + P * A + sympy.eye(n)), *known.values())
        shares = zip(places, found, strict=True)
        yield sympy.Add(
            *(p * states[i] * states[j] * (1 + (i < j)) for (i, j), p in shares)
        )


def _terms(rates: Rates) -> dict[sympy.Expr, tuple]:
    """Return what V may be made of: term -> its two states, or the one of an integral."""
    states = list(rates)
    terms: dict[sympy.Expr, tuple] = {
        a * b: (a, b) for a, b in combinations_with_replacement(states, 2)
    }
    whole = sympy.Tuple(*rates.values())
    for h in sorted(whole.atoms(sympy.sin, *ODD) | whole.atoms(sympy.Pow), key=str):
        inner, power = (h.base, h.exp) if h.is_Pow else (h.args[0], sympy.S.One)
        for s in (s for s in states if inner.has(s)):
            odd = power.is_Integer and power > 0 and power % 2
            if odd and (inner / s).is_Rational and h != s:
                H = sympy.integrate(h, s)
                terms[H - H.subs(s, 0)] = (s,)
    return terms


def _roots(monomials: dict, gens: list) -> dict[Monomial, Monomial | None]:
    """Return the monomials that are never negative, and their roots; |s|, s tanh(s) have none."""
    rises = {
        frozenset((k, gens.index(g.args[0])))
        for k, g in enumerate(gens)
        if g.func in ODD and g.args[0] in gens
    }
    found = dict[Monomial, Monomial | None]()
    for powers in monomials:
        odd = {k for k, n in enumerate(powers) if n % 2}
        signed = frozenset(
            k for k in odd if not gens[k].is_nonnegative and gens[k] != TIME
        )
        if not odd:
            found[powers] = tuple(n // 2 for n in powers)
        elif not signed or signed in rises:
            found[powers] = None
    return found


def _of_program(rates: Rates) -> Iterator[sympy.Expr]:
    """Yield the V of few terms that holds as many states as it can.

    Unknown are the coefficients c of V and the cross terms q of -V', each the difference of two
    numbers that are not negative, and how far V holds each state: beside half of its cross terms,
    or else by a square alone.
    """
    terms, states = _terms(rates), [*rates]
    slopes = [sympy.expand(along(term, dict(rates))) for term in terms]
    whole = {  # exp(1e8 x) is no power of exp(x)
        e: sympy.Dummy(str(e), positive=True)
        for e in sympy.Tuple(*slopes).atoms(sympy.exp)
    }
    slopes = [one.xreplace(whole) for one in slopes]
    gens = sorted(
        {*rates}.union(*(sympy.Poly(one).gens for one in slopes if one)), key=str
    )
    # -V', monomial by monomial: term -> its share
    falls = defaultdict[Monomial, dict](dict)
    for k, slope in enumerate(slopes):
        for powers, share in sympy.Poly(slope, *gens).terms() if slope else ():
            falls[powers][k] = -share
    if not all(share.is_Rational for row in falls.values() for share in row.values()):
        return
    roots = _roots(falls, gens)
    crossed = list[tuple[Monomial, ...]]()  # a product, and the two that make up for it
    for (a, root), (b, other) in combinations(roots.items(), 2):
        both = tuple(map(int.__add__, root or (), other or ()))
        if both in falls and both not in roots:
            crossed.append((both, a, b))
    products = {both for both, *_ in crossed}

    row = {
        powers: k
        for k, powers in enumerate(
            [*roots, *(one for one in falls if one not in roots)]
        )
    }
    squares, n, total = len(roots), len(terms), len(terms) + len(crossed)
    # -V' less the cross terms, of c and q
    shares = scipy.sparse.lil_array((len(falls), total))
    made_up = scipy.sparse.lil_array((squares, total))  # of their sizes
    for powers, own in falls.items():
        for k, share in own.items():
            shares[row[powers], k] = float(share)
    for k, (both, *two) in enumerate(crossed, n):
        shares[row[both], k] = -1.0
        made_up[[row[one] for one in two], k] = 0.5
    alone, beside = np.zeros((2, len(states), total))
    for k, places in enumerate(terms.values()):
        one, share = (alone, 1.0) if len({*places}) == 1 else (beside, 0.5)
        one[[states.index(s) for s in places], k] = share

    stacked, side_by_side = scipy.sparse.vstack, scipy.sparse.hstack
    shares, holds = shares.tocsr(), 2 * len(states)
    signed = stacked([-shares[:squares], -alone, -alone])
    sizes = stacked([made_up, beside, 0 * beside])
    equal, none = shares[squares:], np.zeros((len(falls) - squares, holds))
    small = np.repeat([1.0, 0.0], [n, total - n])
    found = scipy.optimize.linprog(
        np.concatenate([small, small, np.repeat([-HELD, -(HELD**2)], len(states))]),
        side_by_side(
            [sizes + signed, sizes - signed, np.eye(squares + holds, holds, -squares)]
        ),
        np.zeros(squares + holds),
        side_by_side([equal, -equal, none]),
        np.zeros(len(none)),
        [(0, None)] * (2 * total) + [(0, 0.5)] * holds,
    )
    if found.status == 0:
        exact = [own for one, own in falls.items() if one not in {*roots, *products}]
        c = _rounded(found.x[:n] - found.x[total:][:n], exact)
        yield sympy.Add(*(share * term for share, term in zip(c, terms, strict=True)))


def _rounded(
    values: np.ndarray, exact: list[dict[int, sympy.Expr]]
) -> list[sympy.Expr]:
    """Return rational numbers beside these; each exact row times them is zero."""
    used = [k for k, value in enumerate(values) if abs(value) > 1e-9]
    found = [
        sympy.Rational(Fraction(float(v)).limit_denominator(SHARE)) for v in values
    ]
    numbers = [row.get(k, 0) for row in exact for k in used]
    reduced, pivots = sympy.Matrix(len(exact), len(used), numbers).rref()
    free = [j for j in range(len(used)) if j not in pivots]
    for row, pivot in enumerate(pivots):
        found[used[pivot]] = -sympy.Add(
            *(reduced[row, j] * found[used[j]] for j in free)
        )
    return found
