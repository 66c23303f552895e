"""Least squares, the Kalman filter and motion tomography of theta, Eq. (3), from fix to fix.

What a segment between two fixes shows (`segments`), and three ways to one number:

    y_s = theta h_s + n_s,    n_s ~ r_s^2 I,    each row of theta ~ prior^2

least-squares   theta = theta_0 + (sum y~ h^T/r^2) P,  P^-1 = P_0^-1 + sum h h^T/r^2,
                y~ = y - theta_0 h, with h along the track that is known
kalman          the same one by one, P <- P + w^2 dt I before each: k = P h/(r^2 + h^T P h),
                theta <- theta + (y - theta h) k^T, P <- P - k h^T P
tomography      the track is not known: h along the track that theta predicts, least squares for
                theta, and again until it settles.  Then y is what the predicted track misses by

P is N x N and serves both axes.  Without a walk w the filter ends at least squares.

Neighbouring misses of a run share a fix: n_s = r_s (a_s + m_s - m_{s-1}), a_s of this miss alone
and m_s of the fix at the end of s; their variances are `Segments.shares`.  The n_s are a moving
average of order 1; where a_s = 0 their covariance is r^2, and -r^2/2 beside the diagonal.  A
filter whose only state is the last fix's noise makes white innovations of them, of y and of h
(`whitened`): generalised least squares; the filter of theta has that noise as one more state.
Where the track itself is read with noise, theta h is as wrong as that noise makes phi
(`Segments.blur`).

Sources: R. E. Kalman, "A new approach to linear filtering and prediction problems", 1960; P. J.
Brockwell, R. A. Davis, "Time Series: Theory and Methods", 1991, section 5.3 (innovations); D.
Chang, W. Wu, C. R. Edwards, F. Zhang, "Motion tomography: mapping flow fields using autonomous
underwater vehicles", International Journal of Robotics Research 36, 320-336, 2017.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from ...base.errors import DataError
from ...base.progress.interrupt import check

MOST = 100  # iterations of the tomography
SETTLED = 1e-9  # of the prior


def regularised(h, y, theta, sd) -> tuple[np.ndarray, np.ndarray]:
    """Return theta and P of regularised least squares: h (n, N), y (n, 2), of unit noise."""
    scaled = h * sd  # in units of the prior
    if not np.all(np.isfinite(scaled)):
        raise DataError(
            "phi along the tracks is not finite in units of prior and noise; give a smaller prior, "
            "more noise, or fixes more often"
        )
    U, s, Vt = np.linalg.svd(scaled, full_matrices=len(h) < len(sd))
    moved = Vt[: len(s)].T @ ((s / (1 + s**2))[:, None] * (U.T @ (y - h @ theta.T)))
    share = np.ones(len(sd))  # of the prior that is left along each row of Vt
    share[: len(s)] = 1 / (1 + s**2)
    return theta + (sd[:, None] * moved).T, sd[:, None] * ((Vt.T * share) @ Vt) * sd


def whitened(segments, columns, r, blur=0.0):
    """Return columns (n, c) as innovations over their standard deviation: white, of size 1."""
    alone, fix = segments.shares(r)
    alone = alone + fix * blur
    white, last, p = columns / r[:, None], np.zeros(columns.shape[1]), fix[0]
    for k, new in enumerate(segments.renewed):
        S = new * (p + fix[k]) + alone[k]
        innovation = white[k] + new * last  # one noise read twice leaves no trace
        white[k] = innovation / np.sqrt(S)
        if new:
            last, p = fix[k] / S * innovation, fix[k] - fix[k] ** 2 / S
    return white


def expected_blur(theta, P, B):
    """Return what is expected of theta B theta^T, of the axis where it is larger."""
    known = np.einsum("...kl,ak,al->...a", B, theta, theta).max(axis=-1)
    return known + np.einsum("...kl,kl->...", B, P)


def generalised(segments, h, theta, sd, r, blur=0.0) -> tuple[np.ndarray, np.ndarray]:
    """Return theta and P of generalised least squares along a track."""
    white = whitened(segments, np.hstack([h, segments.miss]), r, blur)
    return regularised(white[:, :-2], white[:, -2:], theta, sd)


def batch_least_squares(segments, basis, theta, sd, r, w):
    """Return the steps of theta, P and h of batch least squares."""
    h, B = segments.integrals(basis, segments.known_track), segments.blur(basis)
    first, P = theta, np.diag(sd**2)
    for _ in range(3 if segments.noise_period else 1):
        theta, P = generalised(segments, h, first, sd, r, expected_blur(theta, P, B))
    return theta[None], P, h


def kalman(segments, basis, theta, sd, r, w):
    """Return the steps of theta, P and h of the filter, causal: each segment after its end."""
    h, B, N = (
        segments.integrals(basis, segments.known_track),
        segments.blur(basis),
        len(sd),
    )
    alone, fix = segments.shares(r)
    x, P = np.pad(theta, ((0, 0), (0, 2))), np.diag([*sd**2, fix[0], 0.0])
    steps, before = [], segments.time[0, -1]
    for k, new in enumerate(segments.renewed):
        P[:N, :N] += np.diag(w**2 * max(segments.time[k, -1] - before, 0.0))
        before = segments.time[k, -1]
        variance = alone[k] + fix[k] * expected_blur(x[:, :N], P[:N, :N], B[k])
        # the states: theta, and of r the fixes' noise at start and end
        P[N + 1, N + 1] = fix[k]
        row = np.append(h[k] / r[k], [-1.0, 1.0] if new else [0.0, 0.0])
        gain = P @ row / (variance + row @ P @ row)
        x = x + np.outer(segments.miss[k] / r[k] - x @ row, gain)
        rest = np.eye(N + 2) - np.outer(gain, row)
        P = rest @ P @ rest.T + variance * np.outer(gain, gain)
        steps.append(x[:, :N])
        last = [*range(N), N + 1 if new else N]  # the end is the next one's start
        x, P = (
            np.pad(x[:, last], ((0, 0), (0, 1))),
            np.pad(P[np.ix_(last, last)], (0, 1)),
        )
    return np.array(steps), P[:N, :N], h


def tomography(segments, basis, theta, sd, r, w):
    """Return the steps of theta, P and h where tracks are predicted, until theta settles."""
    first, steps = theta, []
    for _ in range(MOST):
        check()
        h = segments.integrals(basis, segments.predicted(basis, theta))
        before, (theta, P) = theta, generalised(segments, h, first, sd, r)
        steps.append(theta)
        if np.max(np.abs(theta - before) / sd) < SETTLED:
            return np.array(steps), P, h
    raise DataError(
        f"the tomography does not settle in {MOST} iterations: its last moved theta by "
        f"{np.abs(theta - before).max():.2g}; give fixes more often, a smaller prior or fewer "
        "functions"
    )


METHODS: dict[str, Callable[..., Any]] = {
    "least-squares": batch_least_squares,
    "kalman": kalman,
    "tomography": tomography,
}
