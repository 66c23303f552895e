"""Which states reach which rates, how rates change along a direction, and what Rodas5P needs of it.

States whose rates have nothing in common are differentiated along together (Curtis, Powell and
Reid, On the estimation of sparse Jacobian matrices, 1974): a chain of any length takes three
derivatives.  The matrix is put in the order that makes its band narrow (Cuthill and McKee).

The record of a diagram is a record as any other, so its rates are differentiated as a whole, wires
and all, along a direction (v, s) that lies behind the states: X = x, v, s.
"""

from functools import reduce
from math import prod
from operator import or_
from typing import Any, NamedTuple

import numpy as np

from ..equations.arrays import CONDITIONS, Unread, operand
from ..equations.derivative import JUMPS, Direction
from ..equations.elements import Elements, Index
from ..equations.record import reached
from .components import deep
from .decisions import Port
from .diagram_record import DiagramRecord

NONE = np.zeros(0, np.int64)
FULL = 0.3  # share of a matrix from which on it is taken as full


class Jacobian(NamedTuple):
    """What the solver is given in `linear`, which says what each is, but for room."""

    band: tuple[int, int, int] = 0, 0, 0
    places: np.ndarray = NONE
    groups: np.ndarray = NONE
    begins: np.ndarray = NONE
    rows: np.ndarray = NONE
    columns: np.ndarray = NONE
    to: np.ndarray = NONE

    @property
    def given(self) -> tuple[Any, ...]:
        """What the solver is given."""
        n = len(self.places)
        return np.zeros(n * n), np.zeros(n * n), np.zeros(n, np.int64), *self


def jacobian(reach: np.ndarray, exact: bool) -> Jacobian:
    """Return the lists for rates that these reach: (n, n + 1), the states and then time.

    `exact` if there is a function `slope`.
    """
    from scipy.optimize._numdiff import group_columns

    n = len(reach)
    places, low, high = _ordered(reach[:, :n])
    groups = group_columns(reach, np.arange(n + 1))
    rows, columns = np.nonzero(reach)
    order = np.argsort(groups[columns], kind="stable")
    rows, columns = rows[order], columns[order]
    begins = np.searchsorted(groups[columns], np.arange(groups.max(initial=-1) + 2))
    to = np.append(places, 0)[columns] * n + places[rows]
    lists = (own.astype(np.int64) for own in (places, groups, begins, rows, columns, to))
    return Jacobian((low, high, int(exact)), *lists)


def _ordered(reach: np.ndarray) -> tuple[np.ndarray, int, int]:
    """Return the place of each state, and how many diagonals lie below and above the main one."""
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import reverse_cuthill_mckee

    n = len(reach)
    own = np.arange(n)
    if reach.mean() > FULL:
        return own, n - 1, n - 1
    moved = np.empty(n, dtype=int)
    moved[reverse_cuthill_mckee(csr_array(reach | reach.T), symmetric_mode=True)] = own
    rows, columns = np.nonzero(reach)
    found = []
    for places in (own, moved):
        below = places[rows] - places[columns]
        found.append((places, int(below.max(initial=0)), int(-below.min(initial=0))))
    return min(found, key=lambda one: one[1] * (one[1] + one[2]))


# --- which states reach which rates -----------------------------------------------------------


class _Reached(Elements):
    """The states that reach each element, and time behind them: bits of a whole number."""

    def __init__(self, record: DiagramRecord, n: int):
        super().__init__(record.entries)
        self.n = n

    def number(self, value: float) -> int:
        """Return nothing."""
        return 0

    def apply(self, ref: int, kind: str, arguments: tuple) -> int:
        """Return all that reaches the arguments; what decides has no slope."""
        if kind in CONDITIONS or kind in JUMPS:
            return 0
        return reduce(or_, arguments[kind in ("where", "pick") :], 0)

    def _element(self, ref: int, index: Index) -> int:
        kind, arguments, shape, at = self.operations[ref]
        if kind == "sum":
            return self._sum(ref, arguments[0], at[0], index)
        if kind not in ("load", "part"):
            return super()._element(ref, index)
        place = sum(i * prod(shape[k + 1 :]) for k, i in enumerate(index))
        if kind == "load":
            array, first = at
            return 1 << (first + place if array == "X" else self.n) if array in "Xt" else 0
        found = np.unravel_index(at + place, self.operations[arguments[0]].shape)
        return self.at(arguments[0], tuple(map(int, found)))


def reach_of(record: DiagramRecord, n: int) -> np.ndarray:
    """Return which of n states, and whether time, reach which rates: truth values (n, n + 1)."""
    found, whole = _Reached(record, n), np.zeros((n, n + 1), dtype=bool)
    try:
        with deep():
            for port in record.rates:
                for place, index in enumerate(np.ndindex(port.shape), port.first):
                    bits = found.at(port.ref, index)
                    whole[place] = [bits >> j & 1 for j in range(n + 1)]
    except Unread:  # too many elements
        whole[:] = True
    return whole


# --- the derivative along a direction ---------------------------------------------------------


def slopes_of(record: DiagramRecord, n: int) -> list[Port]:
    """Return what the rates of n states do along a direction; the record grows by it.

    Where a function has no derivative, as the derivative reading knows it, it is `Unread`.
    """
    direction = Direction(record.tape, {})
    roots = [port.ref for port in record.rates]
    loads = [k for k in sorted(reached(record.entries, roots)) if record.entries[k].kind == "load"]
    for k in loads:
        (array, first), shape = record.entries[k].at, record.entries[k].shape
        moved = {"X": n + first, "t": 2 * n}.get(array)
        own = None if moved is None else direction.value(record.load("X", moved, shape))
        direction.known[k] = own
    slopes = [direction.of(direction.value(ref)) for ref in roots]
    return [port._replace(ref=operand(own)) for port, own in zip(record.rates, slopes, strict=True)]
