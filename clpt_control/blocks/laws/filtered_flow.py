"""The flow and the basis through one filter l/(s + l): a regression with no derivative measured.

    phi_f' = l (phi(x) - phi_f),    q' = l (l x + v - q),    F_f = l x - q

By Eq. (1), x' - v = F, so F_f' = l (F - F_f): F_f is the flow through the filter, made of the
position x and the commanded velocity v alone.  With phi_f(0) = 0 and q(0) = l x(0) it is
theta phi_f at all times, whatever theta is: the regression of the composite laws.  Where the
speed is limited, v is what is flown, and the same holds.
Source: Slotine and Li 1989, Automatica 25(4), composite adaptive control.

Ports: phi_x[N], x[2] (length), v_x[2] (length per time); states phi_f[N], q[2] (length per time).
"""

import numpy as np

from ...errors import ScenarioError
from .law import Known


def filter_rates(dx, at, x, phi, position, v, pole, n):
    """Fill phi_f' and q', which stand from `at` on, after the filter's equations above."""
    for k in range(n):
        dx[at + k] = pole * (phi[k] - x[at + k])
    for i in range(2):
        dx[at + n + i] = pole * (pole * position[i] + v[i] - x[at + n + i])


def filtered_flow(position, q, pole):
    """Return F_f = l x - q of one axis, length per time."""
    return pole * position - q


def unexplained(alpha, phi_f, position, q, pole, n):
    """Return eps = F_f - theta_hat phi_f of one axis, theta_hat = -alpha; length per time."""
    eps = filtered_flow(position, q, pole)
    for k in range(n):
        eps += alpha[k] * phi_f[k]
    return eps


def filter_starts(known: Known, pole: float) -> dict[str, np.ndarray]:
    """Return phi_f(0) = 0 and q(0) = l x(0)."""
    return {"phi_f": np.zeros(known.N), "q": pole * known.position}


def mean_feedback(known: Known) -> float:
    """Return k, the mean feedback gain of the vehicle, per time: the scale of time."""
    return float(np.mean(known.KD))


def reach(known: Known) -> float:
    """Return R, how far start and waypoints lie from the waypoints' middle: the scale of length."""
    places = np.vstack([known.waypoints, known.position])
    R = float(np.max(np.linalg.norm(places - known.waypoints.mean(axis=0), axis=1)))
    if R == 0:
        raise ScenarioError(
            "learning.composite_least_squares: start and waypoints lie at one place, which has no "
            "scale of length; give prior and noise"
        )
    return R
