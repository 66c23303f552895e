"""Sparsity pattern of df/dx for the implicit method: which states reach which rates.

States whose rates have nothing in common share one derivative (Curtis, Powell and Reid, On the
estimation of sparse Jacobian matrices, 1974): a chain of any length takes three.  States are
ordered so that the matrix has a narrow band (Cuthill and McKee).
"""

from functools import reduce
from operator import or_

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

FULL = 0.3  # share of elements from which on a matrix counts as full


def jacobian(record: DiagramRecord, n: int) -> Linear:
    """Return the sparsity of the Jacobian matrix of a record's rates, of n states."""
    return linear_of(reach_of(record, n))


def linear_of(reach: np.ndarray) -> Linear:
    """Return the sparsity of a Jacobian matrix with this reach, as `reach_of` has it."""
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
    of_pattern = (array.astype(np.int64) for array in arrays)
    return Linear(*5 * (None,), (lower, upper), *of_pattern)


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
        place = int(np.ravel_multi_index(index, shape)) if shape else 0
        return 1 << (offset + place)


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
