"""Composite adaptation with memory: CLPE and all that was seen drive one estimate.

    theta_hat' = gamma phi e^T + gamma_c (b^T - Q theta_hat),    theta_hat = -alpha^T
    Q'         = -m Q + phi_f phi_f^T / (1 + |phi_f|^2)
    b'         = -m b + F_f phi_f^T / (1 + |phi_f|^2)

phi_f and F_f are those of `filtered_flow`.  From Q = 0, b = 0 on, b = theta Q, and Q is N x N,
symmetric, not negative and at most 1/m.  K and Gamma follow Eqs. (22)-(23), or are held.
Source: Kreisselmeier 1977, IEEE Transactions on Automatic Control 22(1), Adaptive observers
with exponential rate of convergence.

V of Eq. (24), each error weighed by its own gain, has with eta = theta + alpha
    V' = -e^T KD e - gamma_c tr(eta Q eta^T)/gamma

Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N] (length
per time), K[2], Gamma[2] (per time), Q[N*N] (time), b[2N] (length),
phi_f[N], q[2] (length per time), the states.
"""

from typing import Any, NamedTuple

import numpy as np

from ..block import Block
from ..lyapunov import lyapunov_candidate, weighed
from .filtered_flow import filter_rates, filter_starts, filtered_flow, mean_feedback
from .law import Known, Law, Setting, Truth, adapt_feedback, adapt_feedforward


class CompositeMemoryParameters(NamedTuple):
    """Parameters of composite adaptation with memory."""

    N: int  # number of basis functions
    gain: float  # gamma > 0 of alpha, per time squared
    gain_K: float  # of Eq. (22), per length squared per time squared; 0 holds K
    gain_Gamma: float  # of Eq. (23), the same; 0 holds Gamma
    memory_gain: float  # gamma_c > 0, per time squared
    forgetting: float  # m >= 0, per time
    filter: float  # l > 0, per time


def memory_rates(dx, Q, b, x, position, pole, forgetting, n):
    """Fill Q' and b', which stand from Q and b on; phi_f and q come after b."""
    at = b + 2 * n
    phi_f, size = x[at : at + n], 1.0
    for k in range(n):
        size += phi_f[k] * phi_f[k]
    for j in range(n):
        for k in range(n):
            seen = phi_f[j] * phi_f[k] / size
            dx[Q + j * n + k] = seen - forgetting * x[Q + j * n + k]
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
    """alpha' of Eq. (21) with the memory, K', Gamma' of Eqs. (22)-(23), Q', b', filter.

    u = e[2], phi_x[N], z[2], zc[2], x[2], v_x[2]; states alpha[2N], K[2], Gamma[2], Q[N*N],
    b[2N], phi_f[N], q[2].
    """
    n = p.N
    e, phi, z, zc = u[0:2], u[2 : 2 + n], u[2 + n : 4 + n], u[4 + n : 6 + n]
    position, v = u[6 + n : 8 + n], u[8 + n : 10 + n]
    Q, b = 2 * n + 4, 2 * n + 4 + n * n
    for i in range(2):
        alpha, seen = x[i * n : i * n + n], x[b + i * n : b + i * n + n]
        for j in range(n):
            off = missed(alpha, x[Q:b], seen, j, n)
            dx[i * n + j] = -p.gain * e[i] * phi[j] - p.memory_gain * off
        dx[2 * n + i] = adapt_feedback(p.gain_K, e[i], z[i])
        dx[2 * n + 2 + i] = adapt_feedforward(p.gain_Gamma, e[i], zc[i])
    memory_rates(dx, Q, b, x, position, p.filter, p.forgetting, n)
    filter_rates(dx, b + 2 * n, x, phi, position, v, p.filter, n)


def composite_memory_law(parameters: CompositeMemoryParameters) -> Block:
    """Make composite adaptation with memory."""
    N = parameters.N
    return Block(
        "adaptation",
        update=composite_memory,
        inputs={"e": 2, "phi_x": N, "z": 2, "zc": 2, "x": 2, "v_x": 2},
        states={"alpha": 2 * N, "K": 2, "Gamma": 2, "Q": N * N, "b": 2 * N, "phi_f": N, "q": 2},
        parameters=parameters,
    )


def block(known: Known) -> Block:
    """Make the law of what is known; its scale is k = mean KD."""
    own, gains, k = known.settings, known.gains, mean_feedback(known)
    forgetting = own["forgetting"]
    return composite_memory_law(
        CompositeMemoryParameters(
            known.N,
            gains.parameters,
            gains.feedback,
            gains.feedforward,
            own["memory_gain"] or 0.8 * k**2,
            0.02 * k if forgetting is None else forgetting,
            own["filter"] or 2 * k,
        )
    )


def starts(known: Known) -> dict[str, Any]:
    """Return the filter's start and an empty memory."""
    N, pole = known.N, block(known).parameters.filter
    return {"Q": np.zeros(N * N), "b": np.zeros(2 * N), **filter_starts(known, pole)}


def V(p: Any, truth: Truth) -> Block:
    """Make V of Eq. (24), each error weighed by its own gain."""
    return lyapunov_candidate("learned-flow", weighed((p.gain, p.gain_K, p.gain_Gamma), *truth))


def keeps(s: Any, p: Any, theta: Any) -> dict[str, Any]:
    """Return what the states are at all times: Q = Q^T, b = theta Q, F_f = theta phi_f."""
    Q = np.triu(s["Q"].reshape(p.N, p.N))
    Q = Q + np.triu(Q, 1).T
    return {"Q": Q, "b": theta @ Q, "q": p.filter * s["x"] - theta @ s["phi_f"]}


def gains(s: Any, p: Any, theta: Any) -> Any:
    """Return V' + e^T KD e = -gamma_c tr(eta Q eta^T)/gamma."""
    eta, Q = theta + s["alpha"].reshape(2, p.N), s["Q"].reshape(p.N, p.N)
    return -p.memory_gain * np.sum((eta @ Q) * eta) / p.gain


LAW = Law(
    "composite-memory",
    promise="CLPE goes to zero, and alpha to -theta exponentially once the track has excited",
    needs="the commanded velocity",
    block=block,
    V=V,
    settings={
        "memory_gain": Setting(None, "positive", "gamma_c, 1/time^2; 0.8 k^2 (k mean KD)"),
        "forgetting": Setting(None, "not negative", "m of the memory, 1/time; 0.02 k"),
        "filter": Setting(None, "positive", "pole l of the filter, 1/time; 2 k"),
    },
    gain=1.0,
    starts=starts,
    keeps=keeps,
    gains=gains,
    cone="Q",
    says="-e^T KD e - gamma_c tr(eta Q eta^T)/gamma",
    made_of=("vehicle.feedback", "vehicle.position"),
)
