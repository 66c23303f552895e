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
from functools import cache
from itertools import combinations, combinations_with_replacement, product
from typing import Any, NamedTuple

import numpy as np
import scipy.linalg
import sympy
from sympy import QQ, Expr
from sympy.polys.matrices import DomainMatrix
from sympy.polys.polyerrors import CoercionFailed
from sympy.polys.rings import PolyElement, PolyRing

MOST_MONOMIALS = 40  # of a matrix
MOST_SYMBOLS = 8
MOST_DEGREE = 12
ROUNDS = 1500  # of reflections
CLOSE = 1e-7  # of the coefficients: the equations hold in floating point
LARGEST = 10**100  # a coefficient of a polynomial that is not divided by it
MARGIN = 1e-3  # the least eigenvalue that is looked for
SINGULAR = 1e-4  # of the largest eigenvalue
DENOMINATOR = 10**5


class Block(NamedTuple):
    """A condition g >= 0, and polynomials m of which g m^T G m is made."""

    condition: PolyElement
    basis: list[PolyElement]

    def products(self) -> list[PolyElement]:
        """Return g m_i m_j, i <= j, twice where they differ."""
        return [
            self.condition * a * b * (1 if a == b else 2)
            for a, b in combinations_with_replacement(self.basis, 2)
        ]


class Sum(NamedTuple):
    """A sum of weight g form^2, weight > 0, and forms whose squares it is larger than."""

    terms: list[tuple[Expr, Expr, Expr]]  # a weight, a condition and a form
    forms: list[Expr]  # up to a positive factor


def sum_of_squares(p: Expr, conditions: Sequence[Expr] = ()) -> Sum | None:
    """Return p as a sum of weight g form^2, weight > 0; None if none is found.

    Conditions are polynomials that are not negative; each g is one, a product of two, or 1.
    """
    expressions = sympy.Tuple(p, *conditions)
    symbols = sorted(expressions.free_symbols, key=str)
    if not 0 < len(symbols) <= MOST_SYMBOLS or expressions.has(sympy.Float):
        return None
    ring = PolyRing(symbols, QQ)
    try:
        target, *assumed = (ring.from_expr(sympy.expand(e)) for e in expressions)
    except (ValueError, CoercionFailed):  # no polynomial with rational numbers
        return None
    if not target or max(map(sum, target)) > MOST_DEGREE:
        return None
    most = max(map(abs, target.values()))
    scale = most if max(most, 1 / most) > LARGEST else QQ(1)
    target = target.mul_ground(1 / scale)
    nonnegative = [g for g in assumed if g]
    nonnegative += [a * b for a, b in combinations(nonnegative, 2)]
    blocks = _blocks(target, [ring.one, *nonnegative])
    for _ in range(3):
        if any(len(block.basis) > MOST_MONOMIALS for block in blocks):
            return None
        matrices = _meeting(target, blocks)
        if matrices is None:
            return None
        squares = _exact(target, blocks, matrices)
        if squares is not None:
            terms = [
                (QQ.to_sympy(weight * scale), condition.as_expr(), form.as_expr())
                for weight, condition, form in squares
            ]
            basis = blocks[0].basis
            is_definite = sum(g == sympy.S.One for _, g, _ in terms) == len(basis)
            forms = [m.as_expr() for m in basis] if is_definite else []
            return Sum(terms, [form.as_base_exp()[0] for form in forms])
        blocks = _regular(blocks, matrices)
    return None


# --- polynomials ----------------------------------------------------------------------------


def _blocks(target: PolyElement, conditions: list[PolyElement]) -> list[Block]:
    """Return for each condition the monomials that may stand in its squares."""
    powers = np.array([*target])
    most, total = powers.max(axis=0), powers.sum(axis=1)
    blocks = []
    for condition in conditions:
        highest = np.array([*condition]).max(axis=0)
        if (highest > most).any():
            continue
        room = (most - highest) // 2
        monomials = [
            m
            for m in product(*(range(n + 1) for n in room))
            if 2 * sum(m) <= total.max() - min(map(sum, condition))
            and (len(conditions) > 1 or 2 * sum(m) >= total.min())
        ]
        basis = [target.ring.from_dict({m: QQ(1)}) for m in monomials]
        blocks.append(Block(condition, basis))
    return _pruned(target, blocks)


def _pruned(target: PolyElement, blocks: list[Block]) -> list[Block]:
    """Drop monomials of the first block whose square nothing else can make or take away."""
    leading, *further = blocks
    reached = {m for block in further for p in block.products() for m in p} | {*target}
    basis, before = leading.basis, None
    while basis != before:
        before = basis
        fixed = reached.union(*(a * b for a, b in combinations(basis, 2)))
        basis = [m for m in basis if {*m**2} <= fixed]
    return [leading._replace(basis=basis), *further]


# --- floating point -------------------------------------------------------------------------


def _meeting(target: PolyElement, blocks: list[Block]) -> list[np.ndarray] | None:
    """Return matrices near both the equations of the coefficients and the positive ones."""
    products = [p for block in blocks for p in block.products()]
    rows = {m: k for k, m in enumerate({m for p in products for m in p} | {*target})}
    A, b = np.zeros((len(rows), len(products))), np.zeros(len(rows))
    for column, p in enumerate(products):
        for m, c in p.items():
            A[rows[m], column] = float(c)
    for m, c in target.items():
        b[rows[m]] = float(c)
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
            gap = np.abs(A @ inside - b).max()
            if gap < CLOSE:
                break
            y = y + inside - on_plane
        if gap < CLOSE:
            break
    return _matrices(inside * scale / off, sizes) if gap < 1e-3 else None


def _off_diagonal(n: int) -> np.ndarray:
    """Return 1 on the diagonal and sqrt(2) off it, of the upper triangle."""
    return np.where(np.equal(*_upper(n)), 1.0, np.sqrt(2))


@cache
def _upper(n: int) -> tuple[np.ndarray, np.ndarray]:
    """Return rows and columns of the upper triangle."""
    return np.triu_indices(n)


def _matrices(y: np.ndarray, sizes: list[int]) -> list[np.ndarray]:
    matrices, start = [], 0
    for n in sizes:
        rows, columns = _upper(n)
        G = np.empty((n, n))
        G[rows, columns] = G[columns, rows] = y[start : start + len(rows)]
        matrices.append(G)
        start += len(rows)
    return matrices


def _positive(
    y: np.ndarray, sizes: list[int], off: np.ndarray, margin: float
) -> np.ndarray:
    """Return the nearest matrices whose eigenvalues are at least a margin."""
    nearest = []
    for G in _matrices(y / off, sizes):
        values, vectors = np.linalg.eigh(G)
        G = (vectors * np.maximum(values, margin)) @ vectors.T
        nearest.append(G[_upper(len(G))])
    return np.concatenate(nearest) * off


def _regular(blocks: list[Block], matrices: list[np.ndarray]) -> list[Block]:
    """Return blocks without the directions in which a matrix is zero."""
    smaller = []
    for block, G in zip(blocks, matrices, strict=True):
        values, vectors = np.linalg.eigh(G) if len(G) else (np.ones(0), G)
        most = max(float(np.abs(G).max()) for G in matrices if len(G))
        directions = vectors[:, values > SINGULAR * most].T
        if len(directions) == len(G):
            smaller.append(block)
            continue
        if len(directions):
            rows = _echelon(directions)
            basis = [_combined(row, block.basis) for row in rows]
            smaller.append(block._replace(basis=basis))
    return smaller


def _echelon(rows: np.ndarray) -> list[list[Any]]:
    """Return rows that span the same space, reduced and rounded to plain numbers."""
    _, order = scipy.linalg.qr(rows, mode="r", pivoting=True)
    reduced = np.linalg.solve(rows[:, sorted(order[: len(rows)])], rows)
    return [[_rounded(v, 1000) for v in row] for row in reduced]


def _rounded(number: float, denominator: int) -> Any:
    """Return a rational number near a float."""
    fraction = Fraction(float(number)).limit_denominator(denominator)
    return QQ(fraction.numerator, fraction.denominator)


def _combined(row: list[Any], basis: list[PolyElement]) -> PolyElement:
    return sum(share * m for share, m in zip(row, basis, strict=True))


# --- exact ----------------------------------------------------------------------------------


def _exact(
    target: PolyElement, blocks: list[Block], matrices: list[np.ndarray]
) -> list[tuple[Any, PolyElement, PolyElement]] | None:
    """Round matrices to rational ones that meet the equations; None if one is not positive."""
    products = [p for block in blocks for p in block.products()]
    numbers = np.concatenate([G[_upper(len(G))] for G in matrices])
    y = [_rounded(number, DENOMINATOR) for number in numbers]
    change = _solved(products, target - _combined(y, products))
    if change is None:
        return None
    corrected = (a + b for a, b in zip(y, change, strict=True))
    squares = []
    for block in blocks:
        n = len(block.basis)
        G = {
            pair: next(corrected) for pair in combinations_with_replacement(range(n), 2)
        }
        rows = _factors(G, n)
        if rows is None:
            return None
        squares += [
            (weight, block.condition, _combined(row, block.basis))
            for weight, row in rows
        ]
    return squares


def _solved(products: list[PolyElement], target: PolyElement) -> list[Any] | None:
    """Return changes of the matrices that make up for what is left of each coefficient."""
    rows = {m: k for k, m in enumerate({*target}.union(*products))}
    entries: dict[int, dict[int, Any]] = {}
    for column, p in enumerate([*products, target]):
        for m, c in p.items():
            entries.setdefault(rows[m], {})[column] = c
    last = len(products)
    reduced, pivots = DomainMatrix(entries, (len(rows), last + 1), QQ).rref()
    if last in pivots:
        return None
    change = [QQ(0)] * last
    for row, pivot in enumerate(pivots):
        change[pivot] = reduced[row, last].element
    return change


def _factors(G: dict[tuple[int, int], Any], n: int) -> list | None:
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
