"""The flow and the basis through one filter l/(s + l): a regression with no derivative measured.

    phi_f' = l (phi(x) - phi_f),    q' = l (l x + v - q),    F_f = l x - q

By Eq. (1), x' - v = F, so F_f' = l (F - F_f): F_f is the flow through the filter, made of the
position x and the velocity v through the water alone.  With phi_f(0) = 0 and q(0) = l x(0) it is
theta phi_f at all times, whatever theta is, and eps = F_f - theta_hat phi_f = (theta + alpha)
phi_f.  The laws that learn by it have K and Gamma of `commanded_gains`.

Source: Slotine and Li 1989, Automatica 25(4), composite adaptive control.

Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2], and v_c[2] where the speed is limited
(length per time); states phi_f[N], q[2] (length per time).
"""

from typing import Any

import numpy as np

from .commanded_gains import STATES, gain_rates, gains_kept
from .known import Known, Truth
from .law import LEARNED, MOVING, State


def filter_start(known: Known, p: Any) -> Any:
    """Return q(0) = l x(0)."""
    return p.filter * known.position


FILTER_STATES = {"phi_f": State("N"), "q": State(2, filter_start)}
SHARED = {**LEARNED, **FILTER_STATES, **STATES}  # the states of the laws that learn by it
TAKES = {**MOVING, "v_c": 2}  # and what they take


def filter_rates(x, u, p):
    """Return phi_f' and q'."""
    return {"phi_f": p.filter * (u.phi_x - x.phi_f), "q": p.filter * (p.filter * u.x + u.v_x - x.q)}


def filtered_flow(x, u, p):
    """Return F_f = l x - q, length per time."""
    return p.filter * u.x - x.q


def unexplained(x, u, p):
    """Return eps = F_f - theta_hat phi_f, theta_hat = -alpha; length per time."""
    return filtered_flow(x, u, p) + x.alpha @ x.phi_f


def shared_rates(x, u, p):
    """Return the rates of all shared states but alpha."""
    return {**filter_rates(x, u, p), **gain_rates(x, u, p)}


def filter_kept(s: Any, p: Any, truth: Truth) -> dict[str, Any]:
    """Return what the filter's states are at all times: F_f = theta phi_f."""
    return {"q": p.filter * s["x"] - truth.theta @ s["phi_f"]}


def shared_kept(s: Any, p: Any, truth: Truth) -> dict[str, Any]:
    """Return what the shared states are at all times: F_f = theta phi_f, b_i = Q_i kappa_D."""
    return {**filter_kept(s, p, truth), **gains_kept(s, truth)}


def unexplained_square(s: Any, p: Any, truth: Truth) -> Any:
    """Return |eta phi_f|^2, eta = theta + alpha."""
    return np.sum(((truth.theta + s["alpha"]) @ s["phi_f"]) ** 2)
