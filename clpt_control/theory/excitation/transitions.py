"""Transition matrix of e' = A e + W eta, eta' = -W^T e by the Gauss method, piece by piece.

The implicit Runge-Kutta method of order 2 K, with K nodes in a piece of length h, is reduced to e
at the nodes, E, because eta moves along W; with entries of a and G = W W^T multiplied block by
block in a*G

    (I - h a A + h^2 a (a*G)) E = e + h a W eta
    e   -> e + h b (W eta + A E - h (a*G) E)
    eta -> eta - h sum_j b_j W_j^T E_j

In these coordinates V is half a sum of squares.  A step of the method does not raise V either, so
the errors of steps add up to at least that of Phi.
"""

from collections.abc import Callable
from functools import cache
from itertools import accumulate
from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre

FEW = 4  # nodes of a piece of W
SETTLED = 1e-10  # change of Phi by all pieces that are not divided
JUMP = 1e-3  # of the largest W, by which it may differ at an end of a piece
OUTSIDE = 0.02  # share of a piece before its first node
DEEPEST = 22  # times that a piece is divided by four
LEAST, MOST = 500, 100_000  # pieces at once
OfTime = Callable[[np.ndarray], np.ndarray]  # times (n,) -> W (n, m, n), states (n, nx)


class Gauss(NamedTuple):
    """Gauss-Legendre nodes and weights on [-1, 1], values -> coefficients, and stages."""

    node: np.ndarray
    weight: np.ndarray
    coefficients: np.ndarray  # of the polynomial through values at the nodes
    stages: np.ndarray  # a, on a step of length 1


@cache
def gauss(nodes: int) -> Gauss:
    """Return the method with some nodes."""
    node, weight = legendre.leggauss(nodes)
    coefficients = np.linalg.inv(legendre.legvander(node, nodes - 1))
    # integrals of P_j from -1 to each node, halved
    integrals = legendre.legval(node, legendre.legint(np.eye(nodes), lbnd=-1)).T
    return Gauss(node, weight, coefficients, integrals @ coefficients / 2)


# values at the nodes of a piece -> those of the polynomial through them at its ends
AT_ENDS = legendre.legvander(np.array([-1.0, 1.0]), FEW - 1) @ gauss(FEW).coefficients


def steps_of(
    W: np.ndarray, A: np.ndarray, lengths: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return e at the nodes (..., pieces, nodes m, m + n) and steps (..., pieces, m + n, m + n).

    W (..., pieces, nodes, m, n) is given at the Gauss-Legendre nodes of pieces with these lengths;
    A (..., m, m); each piece starts at I.
    """
    *_, nodes, m, n = W.shape
    _, weight, _, stages = gauss(nodes)
    h = lengths[:, None, None]
    W = W.reshape(*W.shape[:-3], nodes * m, n)
    a, b = np.kron(stages, np.eye(m)), np.kron(weight / 2, np.eye(m))
    A = np.einsum("jl,...pq->...jplq", np.eye(nodes), A)
    A = A.reshape(*A.shape[:-4], 1, nodes * m, nodes * m)
    damping = h * np.kron(stages, np.ones((m, m))) * (W @ W.mT) - A
    start = np.eye(m + n)
    forcing = W @ start[m:]
    first = np.tile(start[:m], (nodes, 1)) + h * a @ forcing
    E = np.linalg.solve(np.eye(nodes * m) + h * a @ damping, first)
    e = start[:m] + h * b @ (forcing - damping @ E)
    eta = start[m:] - h * (W.mT * np.repeat(weight / 2, m)) @ E
    return E, np.concatenate([e, eta], axis=-2)


def propagate(
    W: np.ndarray, A: np.ndarray, lengths: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the rows of e in Phi at the nodes, (..., pieces, nodes m, m + n), and the last Phi."""
    E, steps = steps_of(W, A, lengths)
    along = np.moveaxis(steps, -3, 0)
    *starts, end = accumulate(
        along, lambda Phi, step: step @ Phi, initial=np.eye(E.shape[-1])
    )
    starts[0] = np.broadcast_to(starts[0], end.shape)
    return E @ np.stack(starts, axis=-3), end


class Pieces(NamedTuple):
    """Pieces of time, W at their nodes, and their steps."""

    begin: np.ndarray  # (pieces,)
    end: np.ndarray
    W: np.ndarray  # (pieces, nodes, m, n)
    steps: np.ndarray  # (pieces, m + n, m + n)

    def where(self, chosen: np.ndarray) -> "Pieces":
        """Return some of the pieces."""
        return Pieces(*(values[chosen] for values in self))

    def divided(self, W_at: OfTime, A: np.ndarray, parts: int) -> "Pieces":
        """Return equal parts of each piece, one after the other."""
        edges = np.linspace(self.begin, self.end, parts + 1)
        return pieces_of(W_at, A, edges[:-1].T.ravel(), edges[1:].T.ravel())

    def off(self, quarters: "Pieces", W_at: OfTime) -> np.ndarray:
        """Return the errors of steps: differences from their quarters, and jumps at the ends."""
        one, two, three, four = (quarters.steps[k::4] for k in range(4))
        product = four @ three @ two @ one
        ends = W_at(np.append(self.begin, self.end)).reshape(2, *self.W[:, 0].shape)
        beyond = np.abs(ends - np.einsum("ek,pkij->epij", AT_ENDS, self.W))
        jump = beyond.max(axis=(0, 2, 3))
        jump *= jump > JUMP * np.abs(self.W).max()
        change = np.linalg.norm(self.steps - product, 2, axis=(1, 2))
        return change + OUTSIDE * jump * (self.end - self.begin)


def pieces_of(
    W_at: OfTime, A: np.ndarray, begin: np.ndarray, end: np.ndarray
) -> Pieces:
    """Return pieces with W at their nodes."""
    t = begin[:, None] + (end - begin)[:, None] * (1 + gauss(FEW).node) / 2
    W = W_at(t.ravel())
    W = W.reshape(*t.shape, *W.shape[1:])
    return Pieces(begin, end, W, steps_of(W, A, end - begin)[1])


def settled(
    W_at: OfTime, cuts: np.ndarray, A: np.ndarray
) -> tuple[np.ndarray, np.ndarray, float]:
    """Return cuts, W at the nodes (pieces, nodes, m, n), and by how much Phi may change.

    A piece is divided by four until its step is that of its quarters, and W at its ends that of
    the polynomial through its nodes.
    """
    pieces = pieces_of(W_at, A, cuts[:-1], cuts[1:])
    pieces = pieces.divided(W_at, A, -(-LEAST // len(pieces.begin)))
    least, kept, change = SETTLED / len(pieces.begin), list[Pieces](), 0.0
    for depth in range(DEEPEST + 1):
        quarters = pieces.divided(W_at, A, 4)
        off = pieces.off(quarters, W_at)
        rough = off > least
        if depth == DEEPEST or 4 * rough.sum() > MOST:
            rough[:] = False
        kept.append(pieces.where(~rough))
        change += float(off[~rough].sum())
        if not rough.any():
            break
        pieces = quarters.where(np.repeat(rough, 4))
    begin, _, W, _ = (np.concatenate(values) for values in zip(*kept, strict=True))
    order = np.argsort(begin)
    return np.append(begin[order], cuts[-1]), W[order], change
