"""Which states reach which rates, how rates change along a direction, and what Rodas5P needs of it.

States whose rates have nothing in common are differentiated along together (Curtis, Powell and
Reid, On the estimation of sparse Jacobian matrices, 1974): a chain of any length takes three
derivatives.  The matrix is put in the order that makes its band narrow (Cuthill and McKee).

The record of a diagram is a record as any other, so its rates are differentiated as a whole, wires
and all, along a direction (v, s) that lies behind the states: X = x, v, s.
"""

from functools import reduce
from math import prod
from typing import Any, NamedTuple

import numpy as np

from ..equations.arrays import CONDITIONS, Array, Tape, operand
from ..equations.derivative import JUMPS, Direction
from ..equations.numbers import viewed
from ..equations.record import Operation, reached
from .diagram_record import WIRE, DiagramRecord, Entry, Port

NONE = np.zeros(0, np.int64)
LARGEST = 20_000_000  # numbers; of a larger value all elements are taken to be reached by the same
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


def reach_of(record: DiagramRecord, n: int) -> np.ndarray:
    """Return which of n states, and whether time, reach which rates: truth values (n, n + 1)."""
    found: dict[int, Any] = {}
    for k in sorted(reached(record.entries, [port.ref for port in record.rates])):
        found[k] = _reached(record, k, found, n)
    whole = np.zeros((n, n + 1), dtype=bool)
    for port in record.rates:
        one = found.get(port.ref) if type(port.ref) is int else None
        if one is not None:
            size = prod(port.shape)
            value = np.broadcast_to(one, (*port.shape, n + 1))
            whole[port.first : port.first + size] = value.reshape(size, n + 1)
    return whole


def _reached(record: DiagramRecord, k: int, found: dict[int, Any], n: int) -> Any:
    """Return what reaches each element of a value, along a last axis; None for nothing."""
    kind, arguments, shape, at, _ = record.entries[k]
    if kind == "load":
        if at[0] not in ("X", "t"):
            return None
        first = at[1] if at[0] == "X" else n
        return (first + np.arange(prod(shape)).reshape(*shape, 1)) == np.arange(n + 1)
    own: list[Any] = [found[a] if type(a) is int else None for a in arguments]
    if kind in CONDITIONS or kind in JUMPS:
        return None
    own = own[1:] if kind == "where" else own[:1] if kind == "pick" else own
    some = [one for one in own if one is not None]
    if not some:
        return None
    size = (*shape, n + 1)
    if kind == "pick" or prod(size) > LARGEST:
        every = [one.any(axis=tuple(range(one.ndim - 1))) for one in some]
        return np.broadcast_to(np.any(every, axis=0), size)
    if kind == "sum":
        return own[0].any(axis=at[0])
    if kind == "view":
        return viewed(own[0], (*at, (len(shape), 0, 1)), size)
    if kind == "part":
        return own[0].reshape(-1, n + 1)[at : at + prod(shape)].reshape(size)
    if kind in ("stack", "join"):
        parts = [
            np.broadcast_to(False if one is None else one, (*record.shape_of(a), n + 1))
            for a, one in zip(arguments, own, strict=True)
        ]
        return np.concatenate(parts) if kind == "join" else np.stack(parts)
    return np.broadcast_to(reduce(np.logical_or, some), size)


# --- the derivative along a direction ---------------------------------------------------------


def slopes_of(record: DiagramRecord, n: int) -> list[Port]:
    """Return what the rates of n states do along a direction; the record grows by it.

    Where a function has no derivative, as the derivative reading knows it, it is `Unread`.
    """
    tape, along = Tape(), dict[int, Any]()
    roots = [port.ref for port in record.rates]
    loads = [k for k in sorted(reached(record.entries, roots)) if record.entries[k].kind == "load"]
    for k in loads:
        (array, first), shape = record.entries[k].at, record.entries[k].shape
        moved = {"X": n + first, "t": 2 * n}.get(array)
        along[k] = None if moved is None else Array(tape, record.load("X", moved, shape), shape)
    for entry in record.entries:
        tape.append(Operation(*entry[:4]))
    direction = Direction(tape, along)
    found = []
    for port in record.rates:
        whole = port.ref if type(port.ref) is float else Array(tape, port.ref, port.shape)
        slope = direction.of(whole)
        found.append(port._replace(ref=operand(slope)))
    record.entries += [Entry(*one, WIRE) for one in tape.operations[len(record.entries) :]]
    return found
