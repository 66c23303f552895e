"""Exact runs of the error system where its data are piecewise constant.

    d/dt [e, eta] = A(W) [e, eta] + [Delta, 0]            Eqs. (28) and (32)

A is read off the blocks by `transition.error_matrices`, axis by axis; Delta
adds to e' as in Eq. (32).  While W and
Delta stand still, the matrix exponential of [[A, Delta], [0, 0]] carries the
state on without error of integration.
"""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from .transition import error_matrices


class Piece(NamedTuple):
    """A stretch of time in which nothing but the state moves.

    Attributes
    ----------
    duration : float
        Length of the stretch, time.
    A : ndarray, shape (..., n, n)
        Matrix of the linear system; leading axes are members of an ensemble.
    drive : ndarray, shape (..., n)
        What is added to the derivative.
    samples : int
        States recorded in it, evenly spaced, the last at its end.
    """

    duration: float
    A: np.ndarray
    drive: np.ndarray
    samples: int


def scalar_matrix(w: float, k: float = 1.0, gain: float = 1.0) -> np.ndarray:
    """Return A of the scalar system, one axis with w = phi alone.

    Parameters
    ----------
    w : float
        Regressor, the one basis function.
    k : float
        Feedback gain, per time.
    gain : float
        Adaptation gain gamma.

    Returns
    -------
    ndarray, shape (2, 2)
        Acts on e and eta of axis 1 with N = 1, z = zc = 0.

    Examples
    --------
    >>> scalar_matrix(1.0, k=2.0, gain=100.0).astype(int).tolist()
    [[-2, 1], [-100, 0]]
    """
    nothing = np.zeros(2)
    return error_matrices(np.array([w]), nothing, nothing, np.array([k, k]), gain)[0, :2, :2]


def exact_run(pieces: Iterable[Piece], start: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Carry a state through pieces, by the matrix exponential.

    Parameters
    ----------
    pieces : iterable of Piece
        One after the other.
    start : ndarray, shape (..., n)
        State at time 0.

    Returns
    -------
    times : ndarray, shape (nt,)
        0 and the sample times.
    states : ndarray, shape (nt, ..., n)
        State at each of them.

    Examples
    --------
    >>> piece = Piece(1.0, np.array([[-1.0]]), np.array([0.0]), 2)
    >>> times, states = exact_run([piece], np.array([1.0]))
    >>> times, states[:, 0].round(4)
    (array([0. , 0.5, 1. ]), array([1.    , 0.6065, 0.3679]))
    """
    from scipy.linalg import expm

    state = np.asarray(start, dtype=float)
    times, states = [np.zeros(1)], [state[None]]
    n = state.shape[-1]
    for piece in pieces:
        extended = np.zeros((*state.shape[:-1], n + 1, n + 1))
        extended[..., :n, :n] = piece.A
        extended[..., :n, n] = piece.drive
        step = expm(extended * (piece.duration / piece.samples))
        reached = np.empty((piece.samples, *state.shape))
        for j in range(piece.samples):
            state = np.einsum("...ij,...j->...i", step[..., :n, :n], state) + step[..., :n, n]
            reached[j] = state
        share = np.arange(1, piece.samples + 1) / piece.samples
        times.append(times[-1][-1] + piece.duration * share)
        states.append(reached)
    return np.concatenate(times), np.concatenate(states)
