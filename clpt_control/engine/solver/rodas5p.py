"""Rodas5P, the method for stiff equations: its table, and the sparsity pattern of df/dx.

A Rosenbrock method of order 5,

    (I / (h g) - f_x) U_s = f(t + c_s h, x + sum_j a_sj U_j) + sum_j C_sj / h U_j + d_s h f_t
    new state = the last argument + U_8, whose error U_8 estimates

Eight stages, stiffly accurate, A- and L-stable, with dense output of order 4, which is far less
exact than the ends of steps where the equations are very stiff; so steps end at samples.  The
matrix is factored by `implicit`, where each U_s takes the place of the rate of its stage.

Steinebach, Construction of Rosenbrock-Wanner method Rodas5P and numerical benchmarks within the
Julia Differential Equations package, BIT Numerical Mathematics 63, 2023, 27; the form above is
that of Hairer and Wanner, Solving Ordinary Differential Equations II, 1996, section IV.7.

The sparsity pattern of df/dx says which states reach which rates.  States whose rates have nothing
in common share one derivative (Curtis, Powell and Reid, On the estimation of sparse Jacobian
matrices, 1974): a chain of any length takes three.  States are ordered so that the matrix has a
narrow band (Cuthill and McKee).
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
from ..trace.arrays import Unread
from .solver_layout import DOP853, RODAS5P, Linear

GAMMA = 0.21193756319429014
# fmt: off
A = (
    (),
    (3.0,),
    (2.849394379747939, 0.45842242204463923),
    (-6.954028509809101, 2.489845061869568, -10.358996098473584),
    (2.8029986275628964, 0.5072464736228206, -0.3988312541770524, -0.04721187230404641),
    (-7.502846399306121, 2.561846144803919, -11.627539656261098, -0.18268767659942256,
     0.030198172008377946),
)  # a stage behind these has the argument of the one before it, and 1
C = (
    (),
    (-14.155112264123755,),
    (-17.97296035885952, -2.859693295451294),
    (147.12150275711716, -1.41221402718213, 71.68940251302358),
    (165.43517024871676, -0.4592823456491126, 42.90938336958603, -5.961986721573306),
    (24.854864614690072, -3.0009227002832186, 47.4931110020768, 5.5814197821558125,
     -0.6610691825249471),
    (30.91273214028599, -3.1208243349937974, 77.79954646070892, 34.28646028294783,
     -19.097331116725623, -28.087943162872662),
    (37.80277123390563, -3.2571969029072276, 112.26918849496327, 66.9347231244047,
     -40.06618937091002, -54.66780262877968, -9.48861652309627),
)
TIMES = (  # c
    0.0, 0.6358126895828704, 0.4095798393397535, 0.9769306725060716, 0.4288403609558664,
    1.0, 1.0, 1.0,
)
OF_TIME = (  # d
    GAMMA, -0.42387512638858027, -0.3384627126235924, 1.8046452872882734, 2.325825639765069,
    0.0, 0.0, 0.0,
)
BETWEEN = (  # terms of the interpolant: y0 + s (y1 - y0 + (1 - s) (k_1 + s (k_2 + s k_3)))
    (25.948786856663858, -2.5579724845846235, 10.433815404888879, -2.3679251022685204,
     0.524948541321073, 1.1241088310450404, 0.4272876194431874, -0.17202221070155493),
    (-9.91568850695171, -0.9689944594115154, 3.0438037242978453, -24.495224566215796,
     20.176138334709044, 15.98066361424651, -6.789040303419874, -6.710236069923372),
    (11.419903575922262, 2.8879645146136994, 72.92137995996029, 80.12511834622643,
     -52.072871366152654, -59.78993625266729, -0.15582684282751913, 4.883087185713722),
)
# fmt: on


def weights(s: int) -> tuple[float, ...]:
    """Return a_sj of a stage, counted from 0; of stage 8 they make the new state."""
    return A[s] if s < len(A) else (*A[-1], *(1.0,) * (s - len(A) + 1))


# --- sparsity pattern of the Jacobian matrix ----------------------------------------------------

NONE = np.zeros(0, np.int64)
# explicit steps that a change of the method is worth
MANY_STEPS, FEW_STATES = (5_000, 20)
# for each state, so that a factorization is counted in evaluations
OPERATIONS_OF_A_RATE = 10
FULL = 0.3  # share of elements from which on a matrix counts as full


class Jacobian(NamedTuple):
    """Sparsity of the Jacobian matrix, as `solver_layout.Linear` explains it."""

    band: tuple[int, int] = 0, 0
    positions: np.ndarray = NONE
    groups: np.ndarray = NONE
    begins: np.ndarray = NONE
    rows: np.ndarray = NONE
    columns: np.ndarray = NONE
    to: np.ndarray = NONE

    @property
    def steps_worth(self) -> float:
        """Explicit steps ahead for which changing to the implicit method pays.

        Fewer of them for many states, whose explicit steps take longer than preparing the method,
        unless the matrix is full: an implicit step then takes many evaluations.
        """
        n = len(self.positions)
        evaluations = 2 * (len(self.begins) - 1) + RODAS5P
        operations = sum(self.band) * (1 + self.band[0])
        work = evaluations + operations / OPERATIONS_OF_A_RATE
        ratio = work / DOP853  # of the work of an implicit step and an explicit one
        return MANY_STEPS * min(1.0, ratio / (1 + n / FEW_STATES))

    @property
    def for_solver(self) -> Linear:
        """The solver's argument, with room for matrices and pivots."""
        n = len(self.positions)
        if not n:
            return NO_LINEAR
        matrix = np.zeros(n * n)
        factors = np.zeros(n * n)
        pivots = np.zeros(n, np.int64)
        return Linear(matrix, factors, pivots, *self)


NO_LINEAR = Linear(np.zeros(0), np.zeros(0), NONE, *Jacobian())  # of explicit methods


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
    return Jacobian(
        (lower, upper),
        positions.astype(np.int64),
        groups.astype(np.int64),
        begins.astype(np.int64),
        rows.astype(np.int64),
        columns.astype(np.int64),
        to.astype(np.int64),
    )


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
