"""A V that is searched for: a guess here, which `lyapunov` then checks as any other.

    V = sum_ij c_ij z_i z_j + sum_k b_k int_0^{z_i} h_k(s) ds,    z = x - x_rest

h_k are the functions of one state that stand in the rates: sin, tanh, odd powers.  V' is linear in
the coefficients, and so is the condition that V and -V' are diagonally dominant sums of squares: a
linear program.  What it finds is rounded such that what cancels in V' cancels exactly.  Where it
finds nothing, V is that of the linear part, A^T P + P A = -I.

Source: Ahmadi, A. A., Majumdar, A. (2019), DSOS and SDSOS optimization, SIAM Journal on Applied
Algebra and Geometry 3(2), 193-230; Khalil, H. K. (2002), Nonlinear Systems, Theorem 4.6.
"""

from collections import defaultdict
from collections.abc import Iterator
from fractions import Fraction
from itertools import chain, combinations, combinations_with_replacement, product

import numpy as np
import scipy.optimize
import scipy.sparse
import sympy

from ..diagrams.symbol_names import TIME
from ..errors import DiagramError
from .proving.proof import short
from .proving.signs import vanishes
from .proving.words import ODD, along, decided
from .v_on_symbols import SystemWithV

MOST = 16  # states
SHARE = 10**4  # the largest denominator of a coefficient
LARGEST = 100.0  # of the sum of the coefficients

Rates = dict[sympy.Symbol, sympy.Expr]
Monomial = tuple[int, ...]


def candidates(case: SystemWithV) -> Iterator[sympy.Expr]:
    """Yield functions that may be a V of a diagram about its rest, the plainest first."""
    rest = case.rest or dict.fromkeys(case.states, sympy.S.Zero)
    zero = dict.fromkeys(case.inputs, sympy.S.Zero)
    rates: Rates = {}
    for s, rate in case.eq.motion.items():
        number = rate.xreplace(case.eq.values)
        slope = number.xreplace(rest).xreplace(zero)
        if slope.is_number and not vanishes(slope):
            value = f"= {short(slope)}" if slope.is_finite else "has no value"
            raise DiagramError(f"{case.system.name}: {s}' {value} at the rest: give it (at=)")
        rates[s] = sympy.expand(number.xreplace({q: q + rest[q] for q in rest}))
    if len(rates) > MOST:
        raise DiagramError(
            f"{case.system.name}: has {len(rates)} states; a V is searched for of at most {MOST}: "
            "give one"
        )
    found = chain(
        _of_program(rates, _ahead(rates, case.inputs)), _of_linear_part(rates, case.inputs)
    )
    for V in dict.fromkeys(found):
        yield V.xreplace({s: s - rest[s] for s in rest})


def _ahead(rates: Rates, inputs: list) -> set:
    """Return states that inputs and linear equations alone move, as a reference model's.

    Of states that move one another so, the first: what follows them is not ahead.
    """
    movers, known = dict[sympy.Symbol, set](), [*rates, *inputs]
    for s in rates:
        reached, more = movers.setdefault(s, set()), {s}
        while more - reached:
            reached |= more
            more = set().union(*(rates[q].free_symbols & rates.keys() for q in reached))

    def is_linear(rate: sympy.Expr) -> bool:
        return rate.is_polynomial(*known) and sympy.Poly(rate, *known).is_linear

    return {
        s
        for s, group in movers.items()
        if all(movers[q] == group and is_linear(rates[q]) for q in group)
        and any(rates[q].has(*inputs) for q in group if inputs)
    }


def _of_linear_part(rates: Rates, inputs: list) -> Iterator[sympy.Expr]:
    """Yield z^T P z with A^T P + P A = -I where A is Hurwitz."""
    states = list(rates)
    zero = dict.fromkeys([*states, *inputs], sympy.S.Zero)
    A = sympy.Matrix([[along(rate, {s: sympy.S.One}) for s in states] for rate in rates.values()])
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
        yield sympy.Add(*(p * states[i] * states[j] * (1 + (i < j)) for (i, j), p in shares))


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
        signed = frozenset(k for k in odd if not gens[k].is_nonnegative and gens[k] != TIME)
        if not odd:
            found[powers] = tuple(n // 2 for n in powers)
        elif not signed or signed in rises:
            found[powers] = None
    return found


def _of_program(rates: Rates, ahead: set) -> Iterator[sympy.Expr]:
    """Yield V of few terms, then V of a wide margin.

    Unknown are the coefficients of V, the cross terms of -V', the sizes of both, and the margin.
    V is to hold every state; or else only to have a square of every state that is not ahead.
    """
    terms = _terms(rates)
    slopes = [sympy.expand(along(term, dict(rates))) for term in terms]
    whole = {  # exp(1e8 x) is no power of exp(x)
        e: sympy.Dummy(str(e), positive=True) for e in sympy.Tuple(*slopes).atoms(sympy.exp)
    }
    slopes = [one.xreplace(whole) for one in slopes]
    gens = sorted({*rates}.union(*(sympy.Poly(one).gens for one in slopes if one)), key=str)
    falls = defaultdict[Monomial, dict](dict)  # -V', monomial by monomial: term -> its share
    for k, slope in enumerate(slopes):
        for powers, c in sympy.Poly(slope, *gens).terms() if slope else ():
            falls[powers][k] = -c
    if not all(c.is_Rational for row in falls.values() for c in row.values()):
        return
    roots = _roots(falls, gens)
    products, squares = defaultdict[Monomial, dict](dict), defaultdict[Monomial, dict](dict)
    n, m = len(terms), 0  # terms, and products that two squares can make up for
    for (a, root), (b, other) in combinations(roots.items(), 2):
        both = tuple(map(int.__add__, root or (), other or ()))
        if both in falls and both not in roots:
            products[both][n + m] = -1
            for powers in (a, b):
                squares[powers][m] = 0.5
            m += 1
    exact = [row for one, row in falls.items() if one not in roots and one not in products]

    size, margin, places = n + m, 2 * (n + m), [*terms.values()]
    made_up = [falls[powers] | crossed for powers, crossed in products.items()]
    below = list[tuple[dict, float]]()
    below += [({k: one, size + k: -1}, 0.0) for k in range(n + m) for one in (1, -1)]
    for powers in roots:  # each square of -V' beside half of the cross terms that it is in
        row = {k: -c for k, c in falls[powers].items()}
        row |= {size + n + q: half for q, half in squares[powers].items()}
        below.append(({**row, margin: 1}, 0.0))
    below.append(({size + k: 1 for k in range(n)}, LARGEST))
    every, some = list[tuple[dict, float]](), list[tuple[dict, float]]()
    for s in rates:  # and each of V
        square = {k: -1.0 for k in range(n) if places[k] == (s, s)}
        whole = {k: -1.0 for k in range(n) if places[k] == (s,)}
        cross = {size + k: 0.5 for k in range(n) if s in places[k] and len({*places[k]}) == 2}
        below += [({**square, **cross}, 0.0), *(({k: -1}, 0.0) for k in whole)]
        every.append(({**square, **cross, **whole}, -0.5))
        some += [({**square, **whole}, -0.5)] * (s not in ahead)

    def matrix(rows: list[dict]) -> scipy.sparse.csr_array:
        at = [k for k, row in enumerate(rows) for _ in row]
        columns = [column for row in rows for column in row]
        values = [float(value) for row in rows for value in row.values()]
        return scipy.sparse.csr_array((values, (at, columns)), (len(rows), margin + 1))

    few, wide = matrix([{size + k: 1 for k in range(n)}, {margin: -1}]).toarray()
    equal = matrix(exact + made_up)
    goals = (few, 0.0), (wide, 1.0)
    for held, (goal, most) in product((every, some), goals):
        upper, limits = matrix([row for row, _ in below + held]), [end for _, end in below + held]
        within = [(None, None)] * size + [(0, None)] * size + [(0, most)]
        found = scipy.optimize.linprog(goal, upper, limits, equal, np.zeros(equal.shape[0]), within)
        if found.status == 0:
            c = _rounded(found.x[:n], exact)
            yield sympy.Add(*(share * term for share, term in zip(c, terms, strict=True)))


def _rounded(values: np.ndarray, exact: list[dict[int, sympy.Expr]]) -> list[sympy.Expr]:
    """Return rational numbers beside these; each exact row times them is zero."""
    used = [k for k, value in enumerate(values) if abs(value) > 1e-9]
    found = [sympy.Rational(Fraction(float(v)).limit_denominator(SHARE)) for v in values]
    numbers = [row.get(k, 0) for row in exact for k in used]
    reduced, pivots = sympy.Matrix(len(exact), len(used), numbers).rref()
    free = [j for j in range(len(used)) if j not in pivots]
    for row, pivot in enumerate(pivots):
        found[used[pivot]] = -sympy.Add(*(reduced[row, j] * found[used[j]] for j in free))
    return found
