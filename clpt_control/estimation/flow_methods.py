"""theta of Eq. (3) from segments: three ways to one number.

    y_s = theta h_s + n_s,    n_s ~ r_s^2 I,    each row of theta ~ prior^2    (`segments`)

least-squares   theta = theta_0 + (sum y~ h^T/r^2) P,  P^-1 = P_0^-1 + sum h h^T/r^2,
                y~ = y - theta_0 h, with h along the track that is known
kalman          the same one by one, P <- P + w^2 dt I before each: k = P h/(r^2 + h^T P h),
                theta <- theta + (y - theta h) k^T, P <- P - k h^T P
tomography      the track is not known: h along the track that theta predicts, least squares for
                theta, and again until it settles.  Then y is what the predicted track misses by

P is N x N and serves both axes.  Without a walk w the filter ends at least squares.
Sources: R. E. Kalman, "A new approach to linear filtering and prediction problems", 1960; D.
Chang, W. Wu, C. R. Edwards, F. Zhang, "Motion tomography: mapping flow fields using autonomous
underwater vehicles", International Journal of Robotics Research 36, 320-336, 2017.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from ..errors import DataError
from ..progress.interrupt import check

MOST = 100  # turns of the tomography
SETTLED = 1e-9  # of the prior


def fitted(h, y, theta, sd, r) -> tuple[np.ndarray, np.ndarray]:
    """Return theta and P of regularised least squares: h (n, N), y (n, 2)."""
    if not np.all(np.isfinite(h)):
        raise DataError(
            "phi along the tracks is not finite; where they are predicted, give fixes more often "
            "or a smaller prior"
        )
    weighed = h * sd / r[:, None]  # in units of the prior
    if not np.all(np.isfinite(weighed)):
        raise DataError("the prior is too large for the noise; give a smaller prior or more noise")
    U, s, Vt = np.linalg.svd(weighed, full_matrices=len(h) < len(sd))
    left = (y - h @ theta.T) / r[:, None]
    moved = Vt[: len(s)].T @ ((s / (1 + s**2))[:, None] * (U.T @ left))
    share = np.ones(len(sd))  # of the prior that is left along each row of Vt
    share[: len(s)] = 1 / (1 + s**2)
    return theta + (sd[:, None] * moved).T, sd[:, None] * ((Vt.T * share) @ Vt) * sd


def least_squares(segments, basis, theta, sd, r, w):
    """Return theta, P, the steps and h of batch least squares."""
    h = segments.integrals(basis, segments.seen)
    theta, P = fitted(h, segments.miss, theta, sd, r)
    return theta, P, theta[None], h


def kalman(segments, basis, theta, sd, r, w):
    """Return theta, P, the steps and h of the filter, causal: each segment after its end."""
    h, y = segments.integrals(basis, segments.seen), segments.miss
    P, steps, before = np.diag(sd**2), [], segments.time[0, -1]
    for k in range(len(y)):
        P = P + np.diag(w**2 * max(segments.time[k, -1] - before, 0.0))
        before = segments.time[k, -1]
        gain = P @ h[k] / (r[k] ** 2 + h[k] @ P @ h[k])
        theta = theta + np.outer(y[k] - theta @ h[k], gain)
        rest = np.eye(len(sd)) - np.outer(gain, h[k])
        P = rest @ P @ rest.T + r[k] ** 2 * np.outer(gain, gain)
        steps.append(theta)
    return theta, P, np.array(steps), h


def tomography(segments, basis, theta, sd, r, w):
    """Return theta, P, the steps and h where tracks are predicted, until theta settles."""
    first, steps = theta, []
    for _ in range(MOST):
        check()
        h = segments.integrals(basis, segments.predicted(basis, theta))
        before, (theta, P) = theta, fitted(h, segments.miss, first, sd, r)
        steps.append(theta)
        if np.max(np.abs(theta - before) / sd) < SETTLED:
            return theta, P, np.array(steps), h
    raise DataError(
        f"the tomography does not settle in {MOST} turns: its last moved theta by "
        f"{np.abs(theta - before).max():.2g}; give fixes more often, a smaller prior or fewer "
        "functions"
    )


METHODS: dict[str, Callable[..., Any]] = {
    "least-squares": least_squares,
    "kalman": kalman,
    "tomography": tomography,
}
