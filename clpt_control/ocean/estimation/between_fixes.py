"""Least squares and Kalman filter of theta, Eq. (3), from the position errors between fixes.

Eq. (1) with Eq. (3), integrated over a segment between two fixes, is

    y = x(t2) - x(t1) - int v dt = theta h + n,    h = int phi(x(t), t) dt

with y the position error of the segment and n ~ N(0, r^2 I).  Each row of theta has the prior
N(theta_0, prior^2).

least-squares   theta = theta_0 + (sum y~ h^T/r^2) P,  P^-1 = P_0^-1 + sum h h^T/r^2,
                y~ = y - theta_0 h
kalman          the same recursively: k = P h/(r^2 + h^T P h),
                theta <- theta + (y - theta h) k^T,  P <- P - k h^T P

P is N x N and serves both axes.  The filter ends at least squares.

Neighbouring segments share a fix: n_s = r_s (a_s + m_s - m_{s-1}), with a_s the noise of this
segment alone and m_s that of the fix at its end; `Segments.shares` are their variances.  The n_s
are a moving average of order 1.  A filter whose only state is the noise of the last fix makes
white innovations of them, of y and of h (`whitened`): generalised least squares.  The filter of
theta has that noise as one more state.  If the track itself is read with noise, theta h is as
wrong as that noise makes phi (`Segments.blur`).

Sources: R. E. Kalman, "A new approach to linear filtering and prediction problems", 1960; P. J.
Brockwell, R. A. Davis, "Time Series: Theory and Methods", 1991, section 5.3 (innovations).
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from scipy.integrate import simpson

from ...base.errors import DataError
from ...engine.model.block import Block, evaluate

GRADIENT_STEP = 1e-4  # of the track's size: step of the differences of phi


class Segments(NamedTuple):
    """n segments between fixes, each at m times.

    Attributes
    ----------
    time : ndarray, shape (n, m)
        From fix to fix.
    track : ndarray, shape (n, m, 2)
        x(t), length.
    error : ndarray, shape (n, 2)
        y, length.
    alone : float
        Largest noise that a segment has alone, length; what is beyond belongs to its fixes.
    noise_period : float
        Time over which one noise of the track lasts; 0 without noise.
    """

    time: np.ndarray
    track: np.ndarray
    error: np.ndarray
    alone: float = np.inf
    noise_period: float = 0.0

    @property
    def duration(self) -> np.ndarray:
        """Time between the fixes, (n,)."""
        return self.time[:, -1] - self.time[:, 0]

    @property
    def renewed(self) -> np.ndarray:
        """True where the noise at the end differs from that at the start, (n,)."""
        if not self.noise_period:
            return np.ones(len(self.time), dtype=bool)
        return np.ptp(self._noise_numbers(), axis=1) > 0

    def _noise_numbers(self) -> np.ndarray:
        """Return the number of the noise at each time, (n, m); a last one of no length is not."""
        slack = 1e-9 * self.noise_period
        time = np.minimum(self.time + slack, self.time[-1, -1] - slack)
        return time // self.noise_period

    def integrals(self, basis: Block) -> np.ndarray:
        """Return h = int phi(x(t), t) dt, shape (n, N), time."""
        n, m = self.time.shape
        phi = evaluate(basis, self.time.ravel(), self.track.reshape(-1, 2))
        return simpson(phi.reshape(n, m, -1), dx=1.0, axis=1) * (
            self.duration[:, None] / (m - 1)
        )

    def shares(self, r: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the shares of r^2 of a segment alone and of each of its fixes, (n,)."""
        alone = np.minimum(1.0, self.alone / r) ** 2
        return alone, (1 - alone) / 2

    def blur(self, basis: Block) -> np.ndarray:
        """Return B, (n, N, N): read with noise s, theta h has the variance s^2 theta B theta^T.

        B = sum over axes i and noises of g g^T/l, g = int dphi/dx_i dt while one noise lasts, l
        the share of its samples that are in this segment.  One noise in several segments is one
        error of all of them; B as if each had its own bounds it, as (sum a)^2 <= sum a^2/l.
        """
        n, m = self.time.shape
        if not self.noise_period:
            return np.zeros((n, *2 * [sum(basis.output_ports.values())]))
        slope = self._gradients(basis)
        slope *= np.repeat(self.duration / m, m)[:, None, None]
        # sum the gradients over the samples of each noise in each segment
        numbers = self._noise_numbers()
        begins = np.diff(numbers, axis=1, prepend=-1.0) != 0
        starts = np.flatnonzero(begins)
        g = np.add.reduceat(slope, starts, axis=0)
        samples = np.diff(starts, append=n * m)
        # weight each by the share of its noise that lies in the segment
        noise_index = np.unique(numbers[begins], return_inverse=True)[1]
        samples_of_noise = np.bincount(noise_index, samples)[noise_index]
        g *= np.sqrt(samples_of_noise / samples)[:, None, None]
        B = np.zeros((n, g.shape[-1], g.shape[-1]))
        np.add.at(B, np.nonzero(begins)[0], np.einsum("gik,gil->gkl", g, g))
        return B

    def _gradients(self, basis: Block) -> np.ndarray:
        """Return dphi/dx_i along the tracks by central differences, (n m, 2, N)."""
        size = GRADIENT_STEP * np.ptp(self.track)
        times, points = self.time.ravel(), self.track.reshape(-1, 2)
        differences = [
            evaluate(basis, times, points + step)
            - evaluate(basis, times, points - step)
            for step in size * np.eye(2)
        ]
        return np.stack(differences, axis=1) / (2 * size)


def regularised(h, y, theta, sd) -> tuple[np.ndarray, np.ndarray]:
    """Return theta and P of regularised least squares: h (n, N), y (n, 2), of unit noise."""
    scaled = h * sd  # in units of the prior
    if not np.all(np.isfinite(scaled)):
        raise DataError(
            "phi along the tracks is not finite in units of prior and noise. Give a smaller prior, "
            "more noise, or fixes more often"
        )
    U, s, Vt = np.linalg.svd(scaled, full_matrices=len(h) < len(sd))
    moved = Vt[: len(s)].T @ ((s / (1 + s**2))[:, None] * (U.T @ (y - h @ theta.T)))
    share = np.ones(len(sd))  # of the prior that remains along each row of Vt
    share[: len(s)] = 1 / (1 + s**2)
    return theta + (sd[:, None] * moved).T, sd[:, None] * ((Vt.T * share) @ Vt) * sd


def whitened(segments, columns, r, blur=0.0):
    """Return columns (n, c) as innovations over their standard deviation: white, of size 1."""
    alone, fix = segments.shares(r)
    alone = alone + fix * blur
    white = columns / r[:, None]
    fix_noise, variance = np.zeros(columns.shape[1]), fix[0]
    for k, renewed in enumerate(segments.renewed):
        S = renewed * (variance + fix[k]) + alone[k]
        innovation = white[k] + renewed * fix_noise  # one noise at both ends cancels
        white[k] = innovation / np.sqrt(S)
        if renewed:
            fix_noise = fix[k] / S * innovation
            variance = fix[k] - fix[k] ** 2 / S
    return white


def expected_blur(theta, P, B):
    """Return the expectation of theta B theta^T, of the axis where it is larger."""
    of_mean = np.einsum("...kl,ak,al->...a", B, theta, theta).max(axis=-1)
    return of_mean + np.einsum("...kl,kl->...", B, P)


def generalised(segments, h, theta, sd, r, blur=0.0) -> tuple[np.ndarray, np.ndarray]:
    """Return theta and P of generalised least squares along a track."""
    white = whitened(segments, np.hstack([h, segments.error]), r, blur)
    return regularised(white[:, :-2], white[:, -2:], theta, sd)


def batch_least_squares(segments, basis, theta, sd, r):
    """Return the steps of theta, P and h of batch least squares."""
    h, B = segments.integrals(basis), segments.blur(basis)
    prior, P = theta, np.diag(sd**2)
    for _ in range(3 if segments.noise_period else 1):
        theta, P = generalised(segments, h, prior, sd, r, expected_blur(theta, P, B))
    return theta[None], P, h


def kalman(segments, basis, theta, sd, r):
    """Return the steps of theta, P and h of the filter, causal: each segment after its end."""
    h, B, N = segments.integrals(basis), segments.blur(basis), len(sd)
    alone, fix = segments.shares(r)
    # states: theta, and in units of r the noise of the fixes at start and end
    x, P = np.pad(theta, ((0, 0), (0, 2))), np.diag([*sd**2, fix[0], 0.0])
    steps = []
    for k, renewed in enumerate(segments.renewed):
        variance = alone[k] + fix[k] * expected_blur(x[:, :N], P[:N, :N], B[k])
        P[N + 1, N + 1] = fix[k]
        row = np.append(h[k] / r[k], [-1.0, 1.0] if renewed else [0.0, 0.0])
        gain = P @ row / (variance + row @ P @ row)
        x = x + np.outer(segments.error[k] / r[k] - x @ row, gain)
        remainder = np.eye(N + 2) - np.outer(gain, row)
        P = remainder @ P @ remainder.T + variance * np.outer(gain, gain)
        steps.append(x[:, :N])
        # the end is the start of the next segment
        kept_states = [*range(N), N + 1 if renewed else N]
        x = np.pad(x[:, kept_states], ((0, 0), (0, 1)))
        P = np.pad(P[np.ix_(kept_states, kept_states)], (0, 1))
    return np.array(steps), P[:N, :N], h


METHODS: dict[str, Callable[..., Any]] = {
    "least-squares": batch_least_squares,
    "kalman": kalman,
}
