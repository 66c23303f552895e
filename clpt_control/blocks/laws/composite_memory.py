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

from typing import Any, NamedTuple

import numpy as np

from ...equations.block import Block
from .commanded_gains import gains_losses, remember, symmetric
from .filtered_flow import (
    MADE_OF,
    filtered_flow,
    filtered_law,
    own,
    shared_kept,
    shared_rates,
    shared_starts,
)
from .law import Known, Law, Setting, Truth
from .learned_flow import V
from .scales import FILTER, MEMORY, mean_feedback


class CompositeMemoryParameters(NamedTuple):
    """Parameters of composite adaptation with memory."""

    N: int  # number of basis functions
    gain: float  # gamma > 0 of alpha, per time squared
    gain_K: float  # of Eq. (22), per length squared per time squared; 0 holds K
    gain_Gamma: float  # of Eq. (23), the same; 0 holds Gamma
    alpha_M: np.ndarray  # shape (2, N), the modelled flow, length per time
    rate: float  # k, mean feedback gain, per time
    memory_gain: float  # gamma_c > 0, per time squared
    forgetting: float  # m >= 0, per time
    filter: float  # l > 0, per time


def memory_rates(dx, Q, b, at, x, position, pole, forgetting, n):
    """Fill Q' and b', which stand from Q and b on; phi_f and q stand from `at` on."""
    phi_f, size = x[at : at + n], 1.0
    for k in range(n):
        size += phi_f[k] * phi_f[k]
    remember(dx, x, Q, phi_f, size, forgetting, n)
    for i in range(2):
        flow = filtered_flow(position[i], x[at + n + i], pole)
        for j in range(n):
            dx[b + i * n + j] = flow * phi_f[j] / size - forgetting * x[b + i * n + j]


def missed(alpha, Q, b, j, n):
    """Return entry j of b + alpha Q = eta Q of one axis, length."""
    found = b[j]
    for k in range(n):
        found += Q[j * n + k] * alpha[k]
    return found


def composite_memory(t, x, u, p, dx):
    """alpha' of Eq. (21) with the memory, Q', b'.

    u = e[2], phi_x[N], z[2], zc[2], x[2], v_x[2] (and v_c[2]); states alpha[2N], K[2], Gamma[2],
    phi_f[N], q[2], Q_1[4], Q_2[4], b_v[4], Q[N*N], b[2N].
    """
    n, Q = p.N, own(p.N)
    e, phi, b = u[0:2], u[2 : 2 + n], Q + n * n
    for i in range(2):
        alpha, seen = x[i * n : i * n + n], x[b + i * n : b + i * n + n]
        for j in range(n):
            off = missed(alpha, x[Q:b], seen, j, n)
            dx[i * n + j] = -p.gain * e[i] * phi[j] - p.memory_gain * off
    memory_rates(dx, Q, b, 2 * n + 4, x, u[6 + n : 8 + n], p.filter, p.forgetting, n)
    shared_rates(x, u, p, dx)


def block(known: Known) -> Block:
    """Make the law of what is known; its scale is k = mean KD."""
    settings, N, k = known.settings, known.N, mean_feedback(known)
    p = CompositeMemoryParameters(
        N,
        *known.gains[:3],
        known.alpha_M,
        k,
        settings["memory_gain"] or 0.8 * k**2,
        known.setting("forgetting", 0.02 * k),
        settings["filter"] or 2 * k,
    )
    return filtered_law(composite_memory, p, {"Q": N * N, "b": 2 * N}, known.limited)


def starts(known: Known) -> dict[str, Any]:
    """Return the filter's start and an empty memory."""
    N, pole = known.N, block(known).parameters.filter
    return {"Q": np.zeros(N * N), "b": np.zeros(2 * N), **shared_starts(known, pole)}


def memory_kept(s: Any, p: Any, truth: Truth) -> dict[str, Any]:
    """Return what the memory is at all times: Q = Q^T, b = theta Q."""
    Q = symmetric(s["Q"], p.N)
    return {"Q": Q, "b": truth.theta @ Q}


def keeps(s: Any, p: Any, truth: Truth) -> dict[str, Any]:
    """Return what the states are at all times: those of the memory, F_f = theta phi_f."""
    return {**memory_kept(s, p, truth), **shared_kept(s, p, truth)}


def losses(s: Any, p: Any, truth: Truth) -> list[tuple]:
    """Return gamma_c tr(eta Q eta^T)/gamma, and what K and Gamma lose."""
    eta, Q = truth.theta + s["alpha"].reshape(2, p.N), s["Q"].reshape(p.N, p.N)
    return [(p.memory_gain / p.gain, np.sum((eta @ Q) * eta)), *gains_losses(s, p, truth)]


LAW = Law(
    "composite-memory",
    promise="CLPE goes to zero, and alpha to -theta exponentially once the track has excited",
    needs="the commanded velocity",
    block=block,
    V=V,
    settings={
        "memory_gain": Setting(None, "positive", "gamma_c, 1/time^2; 0.8 k^2 (k mean KD)"),
        "forgetting": MEMORY,
        "filter": FILTER,
    },
    gain=1.0,
    starts=starts,
    keeps=keeps,
    losses=losses,
    cones=("Q", "Q_1", "Q_2"),
    says="-e^T KD e - gamma_c tr(eta Q eta^T)/gamma",
    made_of=MADE_OF,
)
