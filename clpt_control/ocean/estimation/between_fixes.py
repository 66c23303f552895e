"""Least squares and Kalman filter of theta, Eq. (3), from the position errors between fixes.

Eq. (1) with Eq. (3), integrated over a segment between two fixes, is

    y = x(t2) - x(t1) - int v dt = theta h + n,    h = int phi(x(t), t) dt

with y the position error of the segment and n ~ N(0, r^2 I).  Each row of theta has the prior
N(theta_0, prior^2).

least-squares   theta = theta_0 + (sum y~ h^T/r^2) P,  P^-1 = P_0^-1 + sum h h^T/r^2,
                y~ = y - theta_0 h
kalman          the same segment by segment, by `least_squares_step` of the law fix-regression

P is N x N and serves both axes.  The filter ends at least squares.

Neighbouring segments share a fix: n_s = r_s (a_s + m_s - m_{s-1}), with a_s the noise of this
segment alone and m_s that of the fix at its end; `Segments.shares` are their variances.  The n_s
are a moving average of order 1.  A filter whose only state is the noise of the last fix makes
white innovations of them, of y and of h (`whitened`): generalised least squares.  If the track
itself is read with noise, theta h is as wrong as that noise makes phi (`Segments.blur`).

Sources: R. E. Kalman, "A new approach to linear filtering and prediction problems", 1960; P. J.
Brockwell, R. A. Davis, "Time Series: Theory and Methods", 1991, section 5.3 (innovations).
"""

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np
from scipy.integrate import simpson

from ...engine.model.block import Block, evaluate
from ...paper.currents.least_squares import regularised
from ...paper.laws.memory_laws import least_squares_step

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


def whitened(
    segments: Segments,
    columns: np.ndarray,
    r: np.ndarray,
    blur: Callable[[int], float] = lambda k: 0.0,
) -> Iterator[np.ndarray]:
    """Yield rows of columns (n, c) as innovations over their standard deviation: white, of size 1.

    `blur(k)` is that of segment k, and is called when its row is due.
    """
    alone, fix = segments.shares(r)
    rows = columns / r[:, None]
    fix_noise, variance = np.zeros(columns.shape[1]), fix[0]
    for k, renewed in enumerate(segments.renewed):
        S = renewed * (variance + fix[k]) + alone[k] + fix[k] * blur(k)
        innovation = rows[k] + renewed * fix_noise  # one noise at both ends cancels
        yield innovation / np.sqrt(S)
        if renewed:
            fix_noise = fix[k] / S * innovation
            variance = fix[k] - fix[k] ** 2 / S


def expected_blur(theta: np.ndarray, P: np.ndarray, B: np.ndarray) -> float:
    """Return the expectation of theta B theta^T, of the axis where it is larger."""
    of_mean = np.einsum("kl,ak,al->a", B, theta, theta).max()
    return float(of_mean + np.sum(B * P))


Estimate = tuple[np.ndarray, np.ndarray, np.ndarray]


def kalman(
    segments: Segments, basis: Block, theta: np.ndarray, sd: np.ndarray, r: np.ndarray
) -> Estimate:
    """Return theta after each segment, P after the last one, and h; each step is causal."""
    h, B = segments.integrals(basis), segments.blur(basis)
    P, steps = np.diag(sd**2), []

    def blur(k: int) -> float:
        return expected_blur(theta, P, B[k])

    for row in whitened(segments, np.hstack([h, segments.error]), r, blur):
        m, y = row[:-2], row[-2:]
        change, P = least_squares_step(P, m, y - theta @ m, 1.0)
        theta = theta + change
        steps.append(theta)
    return np.array(steps), P, h


def batch_least_squares(
    segments: Segments, basis: Block, theta: np.ndarray, sd: np.ndarray, r: np.ndarray
) -> Estimate:
    """Return theta, P and h of least squares, by singular values: accurate for any prior."""
    h, B = segments.integrals(basis), segments.blur(basis)
    prior, P = theta, np.diag(sd**2)

    def blur(k: int) -> float:
        return expected_blur(theta, P, B[k])

    for _ in range(3 if segments.noise_period else 1):
        columns = np.hstack([h, segments.error])
        rows = np.array([*whitened(segments, columns, r, blur)])
        theta, P = regularised(rows[:, :-2], rows[:, -2:], prior, sd)
    return theta[None], P, h


METHODS: dict[str, Callable[..., Estimate]] = {
    "least-squares": batch_least_squares,
    "kalman": kalman,
}
