"""Sums of squares by Gram matrices, found in floating point and made exact.

    p = sum_k g_k m_k^T G_k m_k,    G_k >= 0,    g_0 = 1, g_k >= 0 conditions and their products

m_k are monomials.  The matrices are looked for where the linear equations of the coefficients meet
the positive definite ones, by reflections (Douglas and Rachford).  A matrix that is singular at the
end has fewer monomials: it is looked for again in the space of the others.  Rounded to rational
numbers, and corrected such that each coefficient is exact, G = L D L^T with D >= 0 in rational
arithmetic is the proof: nothing of the floating point remains in it.

Source: Peyrl, H., Parrilo, P. A. (2008), Computing sum of squares decompositions with rational
coefficients, Theoretical Computer Science 409(2), 269-281.
"""

from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations, combinations_with_replacement, product
from typing import NamedTuple

import numpy as np
import sympy
from sympy import Expr, Poly

MOST_MONOMIALS = 40  # of a matrix
MOST_SYMBOLS = 8
MOST_DEGREE = 12
ROUNDS = 1500  # of reflections
CLOSE = 1e-7  # of the coefficients: the equations hold in floating point
MARGIN = 1e-3  # the least eigenvalue that is looked for
SINGULAR = 1e-4  # of the largest eigenvalue
DENOMINATOR = 10**5
Terms = dict[tuple[int, ...], Fraction]  # exponents -> coefficient


class Block(NamedTuple):
    """A condition g >= 0, and polynomials m of which g m^T G m is made."""

    condition: Terms
    basis: list[Terms]

    def products(self) -> list[Terms]:
        """Return g m_i m_j, i <= j, twice where they differ."""
        pairs = combinations_with_replacement(range(len(self.basis)), 2)
        factor = {True: Fraction(1), False: Fraction(2)}
        return [
            _times(_times(self.basis[i], self.basis[j], factor[i == j]), self.condition)
            for i, j in pairs
        ]


class Sum(NamedTuple):
    """A sum of weight g form^2, weight > 0, and forms whose squares it is larger than."""

    terms: list[tuple[Expr, Expr, Expr]]  # a weight, a condition and a form
    forms: list[Expr]  # up to a positive factor


def sum_of_squares(p: Expr, conditions: Sequence[Expr] = ()) -> Sum | None:
    """Return p as a sum of weight g form^2, weight > 0; None if none is found.

    Conditions are polynomials that are not negative; each g is one, a product of two, or 1.
    """
    symbols = sorted(sympy.Tuple(p, *conditions).free_symbols, key=str)
    expressions = [sympy.expand(e) for e in (p, *conditions)]
    if not 0 < len(symbols) <= MOST_SYMBOLS:
        return None
    if not all(e.is_polynomial(*symbols) for e in expressions):
        return None
    polynomials = [Poly(e, *symbols) for e in expressions]
    if not all(q.domain.is_ZZ or q.domain.is_QQ for q in polynomials):
        return None
    target, *known = map(_terms, polynomials)
    if not target or polynomials[0].total_degree() > MOST_DEGREE:
        return None
    known = [*filter(None, known)]
    known += [_times(a, b) for a, b in combinations(known, 2)]
    blocks = _blocks(target, [{(0,) * len(symbols): Fraction(1)}, *known])
    for _ in range(3):
        if any(len(block.basis) > MOST_MONOMIALS for block in blocks):
            return None
        matrices = _meeting(target, blocks)
        if matrices is None:
            return None
        squares = _exact(target, blocks, matrices)
        if squares is not None:
            terms = [
                (sympy.Rational(weight.numerator, weight.denominator), *pair)
                for weight, *two in squares
                for pair in [tuple(_expr(q, symbols) for q in two)]
            ]
            basis = blocks[0].basis
            is_definite = sum(g == sympy.S.One for _, g, _ in terms) == len(basis)
            forms = [_expr(m, symbols) for m in basis] if is_definite else []
            return Sum(terms, [form.as_base_exp()[0] for form in forms])
        blocks = _regular(blocks, matrices)
    return None


# --- polynomials ----------------------------------------------------------------------------


def _terms(polynomial: Poly) -> Terms:
    return {
        powers: Fraction(int(c.p), int(c.q)) for powers, c in polynomial.terms() if c
    }


def _times(a: Terms, b: Terms, factor: Fraction = Fraction(1)) -> Terms:
    total: Terms = {}
    for (m, c), (n, d) in product(a.items(), b.items()):
        powers = tuple(map(int.__add__, m, n))
        total[powers] = total.get(powers, Fraction(0)) + factor * c * d
    return total


def _expr(terms: Terms, symbols: list) -> Expr:
    return sympy.Add(
        *(
            sympy.Rational(c.numerator, c.denominator)
            * sympy.Mul(*(s**n for s, n in zip(symbols, powers, strict=True)))
            for powers, c in terms.items()
        )
    )


def _blocks(target: Terms, conditions: list[Terms]) -> list[Block]:
    """Return for each condition the monomials that may stand in its squares."""
    powers = np.array([*target])
    most, total = powers.max(axis=0), powers.sum(axis=1)
    blocks = []
    for condition in conditions:
        own = np.array([*condition]).max(axis=0)
        if (own > most).any():
            continue
        room = (most - own) // 2
        monomials = [
            m
            for m in product(*(range(n + 1) for n in room))
            if 2 * sum(m) <= total.max() - min(map(sum, condition))
            and (len(conditions) > 1 or 2 * sum(m) >= total.min())
        ]
        blocks.append(Block(condition, [{m: Fraction(1)} for m in monomials]))
    return _pruned(target, blocks)


def _pruned(target: Terms, blocks: list[Block]) -> list[Block]:
    """Drop monomials of the first block whose square nothing else can make or take away."""
    first, *others = blocks
    reached = {m for block in others for p in block.products() for m in p} | {*target}
    basis = [next(iter(m)) for m in first.basis]
    while True:
        sums = [tuple(map(int.__add__, a, b)) for a, b in combinations(basis, 2)]
        fixed = reached | {*sums}
        kept = [m for m in basis if tuple(2 * n for n in m) in fixed]
        if len(kept) == len(basis):
            return [first._replace(basis=[{m: Fraction(1)} for m in kept]), *others]
        basis = kept


# --- floating point -------------------------------------------------------------------------


def _meeting(target: Terms, blocks: list[Block]) -> list[np.ndarray] | None:
    """Return matrices near both the equations of the coefficients and the positive ones."""
    products = [p for block in blocks for p in block.products()]
    rows = {m: k for k, m in enumerate({m for p in products for m in p} | {*target})}
    A, b = np.zeros((len(rows), len(products))), np.zeros(len(rows))
    for column, p in enumerate(products):
        for m, c in p.items():
            A[rows[m], column] = c
    for m, c in target.items():
        b[rows[m]] = c
    scale = np.abs(b).max()
    sizes = [len(block.basis) for block in blocks]
    off = np.concatenate([_off_diagonal(n) for n in sizes])
    A = A / off  # a pair stands twice in the norm of a matrix
    inverse, b = np.linalg.pinv(A, rcond=1e-10), b / scale
    if np.abs(A @ (inverse @ b) - b).max() > CLOSE:
        return None
    start = np.zeros(len(products))
    for margin in (MARGIN, 0.0):
        y = start
        for _ in range(ROUNDS):
            on_plane = y - inverse @ (A @ y - b)
            inside = _positive(2 * on_plane - y, sizes, off, margin)
            if np.abs(A @ inside - b).max() < CLOSE:
                return _matrices(inside * scale / off, sizes)
            y = y + inside - on_plane
    return (
        _matrices(inside * scale / off, sizes)
        if np.abs(A @ inside - b).max() < 1e-3
        else None
    )


def _off_diagonal(n: int) -> np.ndarray:
    return np.array(
        [
            1.0 if i == j else np.sqrt(2)
            for i, j in combinations_with_replacement(range(n), 2)
        ]
    )


def _matrices(y: np.ndarray, sizes: list[int]) -> list[np.ndarray]:
    matrices, start = [], 0
    for n in sizes:
        count = n * (n + 1) // 2
        G = np.zeros((n, n))
        G[np.triu_indices(n)] = y[start : start + count]
        matrices.append(G + np.triu(G, 1).T)
        start += count
    return matrices


def _positive(
    y: np.ndarray, sizes: list[int], off: np.ndarray, margin: float
) -> np.ndarray:
    """Return the nearest matrices whose eigenvalues are at least a margin."""
    nearest = []
    for G in _matrices(y / off, sizes):
        values, vectors = np.linalg.eigh(G)
        G = (vectors * np.maximum(values, margin)) @ vectors.T
        nearest.append(G[np.triu_indices(len(G))])
    return np.concatenate(nearest) * off


def _regular(blocks: list[Block], matrices: list[np.ndarray]) -> list[Block]:
    """Return blocks without the directions in which a matrix is zero."""
    smaller = []
    for block, G in zip(blocks, matrices, strict=True):
        values, vectors = np.linalg.eigh(G) if len(G) else (np.ones(0), G)
        most = max(float(np.abs(G).max()) for G in matrices if len(G))
        kept = vectors[:, values > SINGULAR * most].T
        if len(kept) == len(G):
            smaller.append(block)
            continue
        rows = _echelon(kept)
        basis = [_combined(row, block.basis) for row in rows]
        if basis:
            smaller.append(block._replace(basis=basis))
    return smaller


def _echelon(rows: np.ndarray) -> list[list[Fraction]]:
    """Return rows that span the same space, reduced and rounded to plain numbers."""
    rows, pivot = rows.copy(), 0
    for column in range(rows.shape[1] if len(rows) else 0):
        if pivot == len(rows):
            break
        k = pivot + int(np.argmax(np.abs(rows[pivot:, column])))
        if abs(rows[k, column]) < 1e-3:
            continue
        rows[[pivot, k]] = rows[[k, pivot]]
        rows[pivot] /= rows[pivot, column]
        for j in range(len(rows)):
            if j != pivot:
                rows[j] -= rows[j, column] * rows[pivot]
        pivot += 1
    return [[Fraction(float(v)).limit_denominator(1000) for v in row] for row in rows]


def _combined(row: list[Fraction], basis: list[Terms]) -> Terms:
    total: Terms = {}
    for share, terms in zip(row, basis, strict=True):
        for m, c in terms.items():
            total[m] = total.get(m, Fraction(0)) + share * c
    return {m: c for m, c in total.items() if c}


# --- exact ----------------------------------------------------------------------------------


def _exact(
    target: Terms, blocks: list[Block], matrices: list[np.ndarray]
) -> list[tuple[Fraction, Terms, Terms]] | None:
    """Round matrices to rational ones that meet the equations; None if one is not positive."""
    products = [p for block in blocks for p in block.products()]
    numbers = np.concatenate([G[np.triu_indices(len(G))] for G in matrices])
    y = [Fraction(float(v)).limit_denominator(DENOMINATOR) for v in numbers]
    left = dict(target)
    for share, p in zip(y, products, strict=True):
        for m, c in p.items():
            left[m] = left.get(m, Fraction(0)) - share * c
    change = _solved(products, left)
    if change is None:
        return None
    y = [a + b for a, b in zip(y, change, strict=True)]
    squares, start = [], 0
    for block in blocks:
        n = len(block.basis)
        count = n * (n + 1) // 2
        pairs = combinations_with_replacement(range(n), 2)
        G = dict(zip(pairs, y[start : start + count], strict=True))
        start += count
        rows = _factors(G, n)
        if rows is None:
            return None
        squares += [
            (weight, block.condition, _combined(row, block.basis))
            for weight, row in rows
        ]
    return squares


def _solved(products: list[Terms], left: Terms) -> list[Fraction] | None:
    """Return small changes of the matrices that make up for what is left of each coefficient."""
    change = [Fraction(0)] * len(products)
    rows: dict[tuple, dict[int, Fraction]] = {m: {} for m in left}
    for column, p in enumerate(products):
        for m, c in p.items():
            rows.setdefault(m, {})[column] = c
    equations = [(row, left.get(m, Fraction(0))) for m, row in rows.items()]
    solved: list[tuple[int, dict[int, Fraction], Fraction]] = []
    for row, value in equations:
        row = dict(row)
        for pivot, known, known_value in solved:
            share = row.pop(pivot, Fraction(0))
            if share:
                for column, c in known.items():
                    row[column] = row.get(column, Fraction(0)) - share * c
                value -= share * known_value
        row = {column: c for column, c in row.items() if c}
        if not row:
            if value:
                return None
            continue
        pivot = max(row, key=lambda column: abs(row[column]))
        scale = row.pop(pivot)
        solved.append(
            (pivot, {column: c / scale for column, c in row.items()}, value / scale)
        )
    for pivot, row, value in reversed(solved):
        change[pivot] = value - sum(c * change[column] for column, c in row.items())
    return change


def _factors(G: dict[tuple[int, int], Fraction], n: int) -> list | None:
    """Return weights > 0 and rows with G = sum weight row^T row, or None."""
    M = [[G[min(i, j), max(i, j)] for j in range(n)] for i in range(n)]
    rows = []
    for k in range(n):
        weight = M[k][k]
        if weight < 0 or (weight == 0 and any(M[k][j] for j in range(k, n))):
            return None
        if weight == 0:
            continue
        row = [M[k][j] / weight for j in range(n)]
        rows.append((weight, row))
        for i in range(k, n):
            for j in range(k, n):
                M[i][j] -= weight * row[i] * row[j]
    return rows
