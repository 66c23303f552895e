"""Composite adaptation with memory: CLPE and all that was seen drive one estimate.

    theta_hat' = gamma phi e^T + gamma_c (b^T - Q theta_hat),    theta_hat = -alpha^T
    Q'         = -m Q + phi_f phi_f^T / (1 + |phi_f|^2)
    b'         = -m b + F_f phi_f^T / (1 + |phi_f|^2)

phi_f and F_f are those of `filtered_flow`.  From Q = 0, b = 0 on, b = theta Q, and Q is N x N,
symmetric, not negative and at most 1/m.  K and Gamma are those of `commanded_gains`, or are held.
Source: Kreisselmeier 1977, IEEE Transactions on Automatic Control 22(1), Adaptive observers
with exponential rate of convergence.

V of Eq. (24), each error weighed by its own gain, has with eta = theta + alpha
    V' = -e^T KD e - gamma_c tr(eta Q eta^T)/gamma - what K and Gamma lose

Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N] (length
per time), K[2], Gamma[2] (per time), the states of `filtered_flow`, Q[N*N] (time), b[2N]
(length).
"""

from typing import Any

import numpy as np

from .commanded_gains import gains_losses, remembered, symmetric
from .filtered_flow import SHARED, TAKES, filtered_flow, shared_kept, shared_rates
from .known import Truth
from .law import GAINS, Law, Setting, State
from .scales import FILTER, MEMORY, mean_feedback, times_k

STATES = {"Q": State(("N", "N")), "b": State((2, "N"))}  # an empty memory


def memory_rates(x, u, p):
    """Return Q' and b'."""
    size = 1 + x.phi_f @ x.phi_f
    seen = np.outer(filtered_flow(x, u, p), x.phi_f)
    return {
        "Q": remembered(x.Q, x.phi_f, size, p.forgetting),
        "b": seen / size - p.forgetting * x.b,
    }


def composite_memory(t, x, u, p):
    """alpha' of Eq. (21) with the memory, Q', b'."""
    missed = x.b + x.alpha @ x.Q.T
    alpha = -p.gain * np.outer(u.e, u.phi_x) - p.memory_gain * missed
    return {"alpha": alpha, **memory_rates(x, u, p), **shared_rates(x, u, p)}


def memory_kept(s: Any, truth: Truth) -> dict[str, Any]:
    """Return what the memory is at all times: Q = Q^T, b = theta Q."""
    Q = symmetric(s["Q"])
    return {"Q": Q, "b": truth.theta @ Q}


def keeps(s: Any, p: Any, truth: Truth) -> dict[str, Any]:
    """Return what the states are at all times: those of the memory, F_f = theta phi_f."""
    return {**memory_kept(s, truth), **shared_kept(s, p, truth)}


def losses(s: Any, p: Any, truth: Truth) -> list[tuple]:
    """Return gamma_c tr(eta Q eta^T)/gamma, and what K and Gamma lose."""
    eta = truth.theta + s["alpha"]
    return [(p.memory_gain / p.gain, np.sum((eta @ s["Q"]) * eta)), *gains_losses(s, p, truth)]


LAW = Law(
    "composite-memory",
    promise="CLPE goes to zero, and alpha to -theta exponentially once the track has excited",
    needs="the commanded velocity",
    rates=composite_memory,
    parameters={
        **GAINS,
        "alpha_M": "alpha_M",
        "rate": mean_feedback,
        "memory_gain": Setting(
            None, "positive", "gamma_c, 1/time^2; 0.8 k^2 (k mean KD)", times_k(0.8, 2)
        ),
        "forgetting": MEMORY,
        "filter": FILTER,
    },
    takes=TAKES,
    states={**SHARED, **STATES},
    gain=1.0,
    keeps=keeps,
    losses=losses,
    cones=("Q", "Q_1", "Q_2"),
    says="-e^T KD e - gamma_c tr(eta Q eta^T)/gamma",
)
