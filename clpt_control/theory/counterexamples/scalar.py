"""Scalar counterexamples to Eqs. (16) and (33), run exactly.

    d/dt [e, eta] = A(w) [e, eta] + [Delta, 0]            Eqs. (28) and (32)

One axis, one basis function w = phi, z = zc = 0.  A is read off the blocks.  While w and
Delta stand still, the matrix exponential of [[A, Delta], [0, 0]] carries the state on without
error of integration.  Delta may as well be the residual (theta - theta_hat) phi of Eq. (16).

- A square wave at the resonance sqrt(gamma): limsup|e| -> 4/pi as gamma grows, the first
  harmonic of the wave passed on in full.
- Drift, then burst: a faint regressor eps lets the parameter error drift to -Delta/eps; a
  regressor of 1 then turns it into an error of about 0.55/eps.
"""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from ..excitation.transition import error_matrices
from .printed_bounds import PrintedBound

CLAIM = "|e| <= max|Delta|/beta for any beta < k"


class Piece(NamedTuple):
    """A stretch of time in which only the state moves."""

    duration: float
    A: np.ndarray  # (..., n, n); leading axes are members of an ensemble
    drive: np.ndarray  # (..., n), added to the derivative
    samples: int  # states recorded, evenly spaced, the last at its end


def scalar_matrix(w: float, k: float = 1.0, gain: float = 1.0) -> np.ndarray:
    """Return A of the scalar system, [[-k, w], [-gain w, 0]], on (e, eta)."""
    nothing = np.zeros(2)
    return error_matrices(np.array([w]), nothing, nothing, np.array([k, k]), gain)[0, :2, :2]


def exact_run(pieces: Iterable[Piece], start: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return times (nt,), 0 and those sampled, and states (nt, ..., n) from a start (..., n)."""
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


def square_wave_counterexample(
    k: float = 1.0, gain: float = 100.0, periods: int = 60, samples: int = 200
) -> PrintedBound:
    """Run Delta = +1, -1 in turn at sqrt(gamma), phi = 1, from e = eta = 0.

    There are `samples` per half period; the last quarter of the run is measured.
    """
    A, half = scalar_matrix(1.0, k, gain), np.pi / np.sqrt(gain)
    pieces = [
        Piece(half, A, np.array([sign, 0.0]), samples)
        for _ in range(periods)
        for sign in (1.0, -1.0)
    ]
    return _beside_the_bound(pieces, k, 1.5 * periods * half)


def burst_counterexample(
    faint: float = 0.2,
    quiet: float = 250.0,
    burst: float = 20.0,
    cycles: int = 4,
    k: float = 1.0,
    gain: float = 1.0,
) -> PrintedBound:
    """Run Delta = 1 with a regressor that is faint, then 1, from e = eta = 0.

    The regressor is periodic and so persistently exciting.  `quiet` and `burst` are the
    lengths of both stretches, quiet well above 1/(gamma faint^2).  Peaks come back in every
    cycle, near 0.55 (1/faint - 1); the second half of the cycles is measured.
    """
    drive = np.array([1.0, 0.0])
    cycle = [
        Piece(quiet, scalar_matrix(faint, k, gain), drive, 400),
        Piece(burst, scalar_matrix(1.0, k, gain), drive, 1000),
    ]
    return _beside_the_bound(cycle * cycles, k, cycles // 2 * (quiet + burst))


def _beside_the_bound(pieces: list[Piece], k: float, start: float) -> PrintedBound:
    times, states = exact_run(pieces, np.zeros(2))
    return PrintedBound("(33)", CLAIM, k, times, np.abs(states[:, 0]), np.ones_like(times), start)
