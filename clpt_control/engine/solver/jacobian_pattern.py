"""Sparsity pattern of df/dx for the implicit method: which states reach which rates.

States whose rates have nothing in common share one derivative (Curtis, Powell and Reid, On the
estimation of sparse Jacobian matrices, 1974): a chain of any length takes three.  States are
ordered so that the matrix has a narrow band (Cuthill and McKee).
"""

from functools import reduce
from math import prod
from operator import or_
from typing import NamedTuple

import numpy as np
from scipy.linalg import bandwidth
from scipy.optimize._numdiff import group_columns
from scipy.sparse import csr_array
from scipy.sparse.csgraph import reverse_cuthill_mckee

from ..codegen.diagram_record import DiagramRecord
from ..record.graph import deep
from ..record.operations import STEPS
from ..record.scalar_graph import Elements, Index
from ..record.unread import Unread
from .solver_layout import Linear

# explicit steps that a change of the method is worth
MANY_STEPS, FEW_STATES = (5_000, 20)
# for each state, so that a factorization is counted in evaluations
OPERATIONS_OF_A_RATE = 10
FULL = 0.3  # share of elements from which on a matrix counts as full


class Jacobian(NamedTuple):
    """Sparsity of the Jacobian matrix, as `solver_layout.Linear` explains it."""

    band: tuple[int, int]
    positions: np.ndarray
    groups: np.ndarray
    begins: np.ndarray
    rows: np.ndarray
    columns: np.ndarray
    to: np.ndarray

    def steps_worth(self, stages: int, explicit_stages: int) -> float:
        """Return the explicit steps ahead for which changing to the implicit method pays.

        Fewer of them for many states, whose explicit steps take longer than preparing the method,
        unless the matrix is full: an implicit step then takes many evaluations.
        """
        n = len(self.positions)
        evaluations = 2 * (len(self.begins) - 1) + stages
        operations = sum(self.band) * (1 + self.band[0])
        work = evaluations + operations / OPERATIONS_OF_A_RATE
        ratio = (
            work / explicit_stages
        )  # of the work of an implicit step and an explicit one
        return MANY_STEPS * min(1.0, ratio / (1 + n / FEW_STATES))

    @property
    def for_solver(self) -> Linear:
        """The solver's argument, with room for matrices and pivots."""
        n = len(self.positions)
        matrix, factors = np.zeros((2, n * n))
        pivots, nonzero, queue = np.zeros((3, n), np.int64)
        return Linear(matrix, factors, pivots, nonzero, queue, *self)


def jacobian(reach: np.ndarray) -> Jacobian:
    """Return the Jacobian of rates that states and time reach: truth values (n, n + 1)."""
    n = len(reach)
    positions, lower, upper = _ordered(reach[:, :n])
    groups = group_columns(reach, np.arange(n + 1))
    rows, columns = np.nonzero(reach)
    order = np.argsort(groups[columns], kind="stable")
    rows = rows[order]
    columns = columns[order]
    begins = np.searchsorted(groups[columns], np.arange(groups.max(initial=-1) + 2))
    to = np.append(positions, 0)[columns] * n + positions[rows]
    arrays = (positions, groups, begins, rows, columns, to)
    return Jacobian((lower, upper), *(array.astype(np.int64) for array in arrays))


def _ordered(reach: np.ndarray) -> tuple[np.ndarray, int, int]:
    """Return the position of each state, and the numbers of diagonals below and above the main."""
    n = len(reach)
    unchanged = np.arange(n)
    if reach.mean() > FULL:
        return unchanged, n - 1, n - 1
    graph = csr_array(reach | reach.T)
    narrow = reverse_cuthill_mckee(graph, symmetric_mode=True)
    bands = []
    for order in (unchanged, narrow):
        lower, upper = bandwidth(reach[np.ix_(order, order)])
        bands.append((np.argsort(order), lower, upper))
    return min(bands, key=lambda band: band[1] * (band[1] + band[2]))


# --- reach of the states ---------------------------------------------------------------------


class _Reached(Elements):
    """The states that reach each element, then time, as the bits of a whole number."""

    def __init__(self, record: DiagramRecord, n: int):
        super().__init__(record.entries)
        self.n = n

    def number(self, value: float) -> int:
        """Return that nothing reaches a constant."""
        return 0

    def apply(self, ref: int, kind: str, arguments: tuple) -> int:
        """Return all that reaches the arguments; a decision has no slope."""
        if kind in STEPS:
            return 0
        return reduce(or_, arguments[kind in ("where", "pick") :], 0)

    def _element(self, ref: int, index: Index) -> int:
        kind, arguments, shape, location = self.operations[ref]
        if kind == "sum":
            return self._sum(ref, arguments[0], location[0], index)
        if kind != "load":
            return super()._element(ref, index)
        array, offset = location
        if array == "t":
            return 1 << self.n
        if array != "X":
            return 0
        for axis, i in enumerate(index):
            offset += i * prod(shape[axis + 1 :])
        return 1 << offset


def reach_of(record: DiagramRecord, n: int) -> np.ndarray:
    """Return which of n states, and whether time, reach which rates: truth values (n, n + 1)."""
    reached_by = _Reached(record, n)
    reach = np.zeros((n, n + 1), dtype=bool)
    try:
        with deep():
            for port in record.rates:
                for row, index in enumerate(np.ndindex(port.shape), port.first):
                    bits = reached_by.at(port.ref, index)
                    reach[row] = [bits >> j & 1 for j in range(n + 1)]
    except Unread:  # too many elements
        reach[:] = True
    return reach
