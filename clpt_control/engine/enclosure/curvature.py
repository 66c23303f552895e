"""Second order in the set: a step by derivatives at the middle, and second ones on the box.

    phi(m + d) = phi(m) + D phi(m) d + d' H d / 2,    H the second derivatives somewhere on the box
    d = L + R,   L = sum g_i r_i of the columns of the first box,   d' H d / 2 = sum over pairs
    i <= j of r_i r_j (g_i' H g_j, half of it if i = j) + L' H R + R' H R / 2

Products r_i r_j have columns of their own: the set is a polynomial zonotope of degree 2 (Kochdumper
and Althoff 2021, IEEE Transactions on Automatic Control 66).  R, of all other columns, is bounded.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy import ndarray

from ..codegen.series import Node
from ..record.graph import deep
from . import balls
from .balls import Ball, exact, matrix
from .set_program import CHOICES, DECIDED, ROWS, SetProgram

MOST_SECOND = 50_000  # values times directions, twice


def tangents(program: SetProgram, along: Sequence[tuple[str, int]]) -> None:
    """Append derivatives of states along states and P as states; not of rates with decisions.

    Derivative j of state i is ("X", n + j n + i).
    """
    kinds = {step.kind for step in program.needed()[1]}
    is_large = len(along) ** 2 * len(program.still) > MOST_SECOND
    if kinds & {*CHOICES, *DECIDED} or program.sources or is_large:
        return
    n, rates = len(program.x), program.results
    loads = {value: key for key, value in program.known.items() if len(key) == 2}
    known: dict[tuple[int, int], int | None] = {}

    def slope(value: int, j: int) -> int | None:
        """Return the derivative of a value, None for 0."""
        if (value, j) not in known:
            known[value, j] = (of_load if value in loads else of_operation)(value, j)
        return known[value, j]

    def of_load(value: int, j: int) -> int | None:
        array, k = loads[value]
        if array == "X":
            return program.load("X", n + j * n + k)
        return program.number(1.0) if (array, k) == along[j] else None

    def of_operation(value: int, j: int) -> int | None:
        kind, operands, _ = program.made.get(value, ("", (), None))
        nodes: list[Any] = [Node(program, a) for a in (*operands, value)]  # type: ignore[arg-type]
        terms = []
        for a, outer in zip(operands, ROWS[kind].slopes if kind else (), strict=True):
            if (inner := slope(a, j)) is not None:
                factor = outer(*nodes)
                terms.append((factor * Node(program, inner)).argument)  # type: ignore[arg-type]
        return program.sum(terms) if terms else None

    with deep():
        found = [slope(rate, j) for j in range(len(along)) for rate in rates]
    program.results = rates + [program.number(0.0) if k is None else k for k in found]
    program.x += [program.load("X", n + k) for k in range(n * len(along))]


def second_derivatives(found: Ball, n: int, N: int) -> Ball:
    """Return second derivatives (state, order, pair of directions) from those of tangents."""
    orders = found.c.shape[1]
    c, r = (
        a[n:].reshape(N, n, orders, N).transpose(1, 2, 0, 3).reshape(n, orders, N * N)
        for a in found
    )
    return Ball(c, r)


def with_tangents(box: Ball, N: int) -> Ball:
    """Return a box of states and of their tangents at the beginning of a step."""
    unit = np.eye(N)[:, : len(box.c)].ravel()
    return Ball(np.append(box.c, unit), np.append(box.r, 0.0 * unit))


def bend(G: Ball, H: Ball, columns: ndarray, r: ndarray, given: int) -> ndarray:
    """Add second derivatives to the columns of pairs of a moved set; return what is left of them.

    `columns` and `r` are those of the set before, the first of these `given`, then those of pairs.
    """
    first, (i, j) = columns[:, :given], np.triu_indices(given)
    pairs = slice(given, given + len(i))
    half = exact(np.where(i == j, 0.5, 1.0))
    for k in range(len(H.c)):
        of_pairs = matrix(matrix(exact(first.T), H[k]), exact(first))[i, j]
        column = balls.add(G[k, pairs], balls.mul(of_pairs, half))
        G.c[k, pairs], G.r[k, pairs] = column
    linear = np.abs(first) @ r[:given]
    rest = np.abs(columns[:, given:]) @ r[given:]
    products = np.outer(rest, linear) + 0.5 * np.outer(rest, rest)
    size = np.maximum(H.size, H.size.transpose(0, 2, 1))
    left = np.sum(size * products, axis=(1, 2))
    return left * (1.0 + 2.0**-30) + balls.TINY
