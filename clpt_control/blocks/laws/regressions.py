"""Regressions y = kappa w that need no derivative: the flow through a filter, and a memory of any.

The flow and the basis go through one filter l/(s + l):

    phi_f' = l (phi(x) - phi_f),    q' = l (l x + v - q),    F_f = l x - q

By Eq. (1), x' - v = F, so F_f' = l (F - F_f): F_f is the flow through the filter, made of the
position x and the velocity v through the water alone.  With phi_f(0) = 0 and q(0) = l x(0) it is
theta phi_f at all times, whatever theta is, and eps = F_f - theta_hat phi_f = (theta + alpha)
phi_f.  The laws that learn by it have K and Gamma of `commanded_gains`.
Source: Slotine and Li 1989, Automatica 25(4), composite adaptive control.

A memory keeps what w has shown:

    n = w - m Q w,    Q' = n n^T/size,    b' = (y - m b w) n^T/size

From Q = 0, b = 0 on, b = kappa Q and Q = M (1 + m M)^-1 with M = int w w^T/size: Q is symmetric,
not negative and below 1/m, and never falls, nor does its least eigenvalue.  What has been seen is
kept, and what is known well takes in less.  A law that adds gamma_c (b - kappa_hat Q) to the rate
of kappa_hat pulls it to kappa, in the end at the rate gamma_c/m.
Sources: Kreisselmeier 1977, IEEE Transactions on Automatic Control 22(1), Adaptive observers
with exponential rate of convergence (the pull); Pan and Yu 2018, Automatica 89, Composite learning
robot control with guaranteed parameter convergence (a memory that does not fall).

Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2], and v_c[2] where the speed is limited
(length per time); states phi_f[N], q[2] (length per time).
"""

from typing import Any

import numpy as np

from .known import FILTER, Truth
from .law import MOVING, Part, State


def filter_rates(x, u, p):
    """Return phi_f' and q'."""
    return {"phi_f": p.filter * (u.phi_x - x.phi_f), "q": p.filter * (p.filter * u.x + u.v_x - x.q)}


def filtered_flow(x, u, p):
    """Return F_f = l x - q, length per time."""
    return p.filter * u.x - x.q


def unexplained(x, u, p):
    """Return eps = F_f - theta_hat phi_f, theta_hat = -alpha; length per time."""
    return filtered_flow(x, u, p) + x.alpha @ x.phi_f


def unexplained_square(s: Any, p: Any, truth: Truth) -> Any:
    """Return |eta phi_f|^2, eta = theta + alpha."""
    return np.sum(((truth.theta + s["alpha"]) @ s["phi_f"]) ** 2)


FILTERED_FLOW: Part = {
    "states": {"phi_f": State("N"), "q": State(2, lambda known, p: p.filter * known.position)},
    "takes": MOVING,
    "parameters": {"filter": FILTER},
    "keeps": lambda s, p, truth: {"q": p.filter * s["x"] - truth.theta @ s["phi_f"]},  # F_f
}


def remembered(Q, b, y, w, known, size):
    """Return Q' and b' of a memory of w; `known` is m w."""
    new = w - Q @ known
    return np.outer(new, new) / size, np.outer(y - b @ known, new) / size


def memory(Q: str, b: str) -> Part:
    """Make a memory of the flow, b = theta Q, of states with these names."""
    return {
        "states": {Q: State(("N", "N")), b: State((2, "N"))},  # empty at first
        "takes": MOVING,
        "keeps": lambda s, p, truth: {b: truth.theta @ s[Q]},
        "cones": (Q,),
    }


def pulled(s: Any, p: Any, truth: Truth, Q: str) -> tuple:
    """Return what V' loses by the pull, gamma_c tr(eta Q eta^T)/gamma, eta = theta + alpha."""
    eta = truth.theta + s["alpha"]
    return p.memory_gain / p.gain, np.sum((eta @ s[Q]) * eta)
