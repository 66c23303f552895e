"""A V that is searched for: a guess here, which `lyapunov` then checks as any other.

    V = sum_ij c_ij z_i z_j + sum_k b_k int_0^{z_i} h_k(s) ds,    z = x - x_rest

h_k are the functions of one state that stand in the rates: sin, tanh, odd powers.  V' is linear in
the coefficients, and so is the condition that V and -V' are diagonally dominant sums of squares: a
linear program, of few terms that hold as many states as they can.  What it finds is rounded such
that what cancels in V' cancels exactly.  Where it finds nothing that is proved, V is that of the
linear part, A^T P + P A = -I.  In discrete time V is of squares and products alone, V' stands for
V(x+) - V(x), and the linear part has A^T P A - P = -I.

Source: Ahmadi, A. A., Majumdar, A. (2019), DSOS and SDSOS optimization, SIAM Journal on Applied
Algebra and Geometry 3(2), 193-230; Khalil, H. K. (2002), Nonlinear Systems, Theorem 4.6.
"""

from collections import defaultdict
from collections.abc import Iterator
from itertools import chain, combinations, combinations_with_replacement

import numpy as np
import scipy.optimize
import scipy.sparse
import sympy
from sympy import Add, Expr, Matrix, Poly, Rational, S, Tuple, expand

from ...base.errors import DiagramError
from ...engine.diagram.symbol_names import TIME
from ..algebra.decided import decided
from ..algebra.facts import ODD
from ..algebra.slopes import along, slope_in
from .outside import is_stable
from .symbolic_loop import moving_at
from .system_candidate import SystemCandidate

MOST = 16  # states
SHARE = 10**4  # the largest denominator of a coefficient
LONGEST = 10**30  # denominator of an entry of P
ROUNDED = 1e-6  # of an eigenvalue
HELD = 100.0  # what a held state weighs beside a coefficient

Rates = dict[sympy.Symbol, Expr]
Monomial = tuple[int, ...]


def candidates(case: SystemCandidate) -> Iterator[Expr]:
    """Yield functions that may be a V of a diagram about its rest, the plainest first.

    First for any inputs, then for inputs of 0.
    """
    rest_state, discrete = case.origin, case.eq.discrete
    if moving := moving_at(case.eq, rest_state):
        of_user = "this at=, which is no rest. Give another"
        where = of_user if case.rest else "the rest: give it (at=)"
        raise DiagramError(f"{case.system.name}: {moving} at {where}")
    rates, still = _about_rest(case)
    if len(rates) > MOST:
        raise DiagramError(
            f"{case.system.name}: has {len(rates)} states; a V is searched for of at most {MOST}: "
            "give one"
        )
    tried = [rates, still] if case.inputs else [rates]
    programs = [_of_program(each, discrete) for each in tried]
    functions = chain(*programs, _of_linear_part(still, discrete))
    for V in dict.fromkeys(functions):
        yield V.xreplace({s: s - rest_state[s] for s in rest_state})


def growing_eigenvalue(case: SystemCandidate) -> complex | None:
    """Return an eigenvalue of the linear part that makes the rest unstable, or None."""
    A = _linear_part(_about_rest(case)[1])
    if not all(entry.is_number and entry.is_finite for entry in A):
        return None
    entries = np.array(A, dtype=float)
    eigenvalues = np.linalg.eigvals(entries)
    growth = np.abs(eigenvalues) - 1 if case.eq.discrete else eigenvalues.real
    grows = growth.max() > ROUNDED * (1 + np.abs(entries).max())
    return complex(eigenvalues[growth.argmax()]) if grows else None


def _about_rest(case: SystemCandidate) -> tuple[Rates, Rates]:
    """Return the rates, or in discrete time next values, of s - rest; and with inputs of 0."""
    rest_state, zero = case.origin, dict.fromkeys(case.inputs, S.Zero)
    rates = {}
    for s, rate in case.eq.motion.items():
        number = rate.xreplace(case.eq.values)
        kept = rest_state[s] if case.eq.discrete else S.Zero
        shifted = number.xreplace({q: q + rest_state[q] for q in rest_state})
        rates[s] = expand(shifted - kept)
    return rates, {s: rate.xreplace(zero) for s, rate in rates.items()}


def _linear_part(rates: Rates) -> Matrix:
    """Return the slopes of rates at 0."""
    states = list(rates)
    A = Matrix([[slope_in(rate, s) for s in states] for rate in rates.values()])
    return A.xreplace(dict.fromkeys(states, S.Zero)).applyfunc(decided)


def _of_linear_part(rates: Rates, discrete: bool) -> Iterator[Expr]:
    """Yield z^T P z with A^T P + P A = -I, or A^T P A - P = -I, of a stable linear part."""
    states, A = list(rates), _linear_part(rates)
    if not all(entry.is_Rational for entry in A):
        return
    if is_stable(A, discrete):
        n, z = len(states), Matrix(states)
        P = Matrix(n, n, sympy.symbols(f"p_:{n * n}"))
        change = A.T * P * A - P if discrete else A.T * P + P * A
        (solution,) = sympy.linsolve([*change + sympy.eye(n)], *P)
        # many digits cost minutes, and doubles are as good a V
        entries = [p if p.q < LONGEST else Rational(float(p)) for p in solution]
        yield expand(z.dot(Matrix(n, n, entries) * z))


def _terms(rates: Rates, discrete: bool) -> dict[Expr, tuple]:
    """Return what V may be made of: term -> its two states, or the one of an integral."""
    states = list(rates)
    terms: dict[Expr, tuple] = {
        a * b: (a, b) for a, b in combinations_with_replacement(states, 2)
    }
    functions = Tuple(*rates.values()).atoms(sympy.sin, *ODD, sympy.Pow)
    for h in [] if discrete else sorted(functions, key=str):
        inner, power = (h.base, h.exp) if h.is_Pow else (h.args[0], S.One)
        for state in (state for state in states if inner.has(state)):
            odd = power.is_Integer and power > 0 and power % 2
            if odd and (inner / state).is_Rational and h != state:
                H = sympy.integrate(h, state)
                terms[H - H.subs(state, 0)] = (state,)
    return terms


def _roots(monomials: dict, gens: list) -> dict[Monomial, Monomial | None]:
    """Return the monomials that are never negative, and their roots; |s|, s tanh(s) have none."""
    rises = {
        frozenset((k, gens.index(g.args[0])))
        for k, g in enumerate(gens)
        if g.func in ODD and g.args[0] in gens
    }
    roots = dict[Monomial, Monomial | None]()
    for powers in monomials:
        odd = {k for k, n in enumerate(powers) if n % 2}
        signed = frozenset(
            k for k in odd if not gens[k].is_nonnegative and gens[k] != TIME
        )
        if not odd:
            roots[powers] = tuple(n // 2 for n in powers)
        elif not signed or signed in rises:
            roots[powers] = None
    return roots


def _of_program(rates: Rates, discrete: bool) -> Iterator[Expr]:
    """Yield the V of few terms that holds as many states as it can.

    Unknown are the coefficients c of V and the cross terms q of -V', each the difference of two
    numbers that are not negative, and how far V holds each state: beside half of its cross terms,
    or else by a square alone.
    """
    terms, states = _terms(rates, discrete), [*rates]
    changes = [
        term.xreplace(rates) - term if discrete else along(term, rates)
        for term in terms
    ]
    slopes = [*map(expand, changes)]
    exponentials = {  # exp(1e8 x) is no power of exp(x)
        e: sympy.Dummy(str(e), positive=True) for e in Tuple(*slopes).atoms(sympy.exp)
    }
    slopes = [item.xreplace(exponentials) for item in slopes]
    gens = sorted(
        {*rates}.union(*(Poly(item).gens for item in slopes if item)), key=str
    )
    # -V', monomial by monomial: term -> its share
    falls = defaultdict[Monomial, dict](dict)
    for k, slope in enumerate(slopes):
        for powers, share in Poly(slope, *gens).terms() if slope else ():
            falls[powers][k] = -share
    if not all(share.is_Rational for row in falls.values() for share in row.values()):
        return
    roots = _roots(falls, gens)
    crossed = list[tuple[Monomial, ...]]()  # a product, and the two that make up for it
    for (a, root), (b, second_root) in combinations(roots.items(), 2):
        product_powers = tuple(map(int.__add__, root or (), second_root or ()))
        if product_powers in falls and product_powers not in roots:
            crossed.append((product_powers, a, b))
    products = {product_powers for product_powers, *_ in crossed}

    row = {powers: k for k, powers in enumerate(dict.fromkeys([*roots, *falls]))}
    squares, n, total = len(roots), len(terms), len(terms) + len(crossed)
    # -V' less the cross terms, of c and q
    shares = scipy.sparse.lil_array((len(falls), total))
    made_up = scipy.sparse.lil_array((squares, total))  # of their sizes
    for powers, shares_by_term in falls.items():
        for k, share in shares_by_term.items():
            shares[row[powers], k] = float(share)
    for k, (product_powers, *two) in enumerate(crossed, n):
        shares[row[product_powers], k] = -1.0
        made_up[[row[item] for item in two], k] = 0.5
    square_states, crossed_states = np.zeros((2, len(states), total))
    for k, states_of_term in enumerate(terms.values()):
        item, share = (
            (square_states, 1.0)
            if len({*states_of_term}) == 1
            else (crossed_states, 0.5)
        )
        item[[states.index(s) for s in states_of_term], k] = share

    stacked, side_by_side = scipy.sparse.vstack, scipy.sparse.hstack
    shares, holds = shares.tocsr(), 2 * len(states)
    signed = stacked([-shares[:squares], -square_states, -square_states])
    sizes = stacked([made_up, crossed_states, 0 * crossed_states])
    equal, no_equalities = shares[squares:], np.zeros((len(falls) - squares, holds))
    small = np.repeat([1.0, 0.0], [n, total - n])
    solution = scipy.optimize.linprog(
        np.concatenate([small, small, np.repeat([-HELD, -(HELD**2)], len(states))]),
        side_by_side(
            [sizes + signed, sizes - signed, np.eye(squares + holds, holds, -squares)]
        ),
        np.zeros(squares + holds),
        side_by_side([equal, -equal, no_equalities]),
        np.zeros(len(no_equalities)),
        [(0, None)] * (2 * total) + [(0, 0.5)] * holds,
    )
    if solution.status == 0:
        exact = [
            shares_by_term
            for item, shares_by_term in falls.items()
            if item not in {*roots, *products}
        ]
        c = _rounded(solution.x[:n] - solution.x[total:][:n], exact)
        yield Add(*(share * term for share, term in zip(c, terms, strict=True)))


def _rounded(values: np.ndarray, exact: list[dict[int, Expr]]) -> list[Expr]:
    """Return rational numbers beside these; each exact row times them is zero."""
    used = [k for k, value in enumerate(values) if abs(value) > 1e-9]
    rationals = [Rational(float(v)).limit_denominator(SHARE) for v in values]
    numbers = [row.get(k, 0) for row in exact for k in used]
    reduced, pivots = Matrix(len(exact), len(used), numbers).rref()
    free = [j for j in range(len(used)) if j not in pivots]
    for row, pivot in enumerate(pivots):
        rationals[used[pivot]] = -Add(
            *(reduced[row, j] * rationals[used[j]] for j in free)
        )
    return rationals
