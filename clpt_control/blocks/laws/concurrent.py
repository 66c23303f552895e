"""Concurrent learning in integral form: what windows of the track have shown is kept for good.

Over a window from t_1 to t_2 = t_1 + T, Eq. (1) integrated is a regression with no derivative:

    Y = x(t_2) - x(t_1) - int v = theta Phi,    Phi = int phi(x)

The law keeps x - origin = Y and Phi of the window that runs, and at its end takes it in:

    sigma+^2 = sigma^2 + |Phi|^2
    S+ = (sigma^2 S + Phi Phi^T)/sigma+^2,    B+ = (sigma^2 B + Y Phi^T)/sigma+^2
    theta_hat' = gamma phi e^T + gamma_c (B^T - S theta_hat),    theta_hat = -alpha^T

From S = 0, B = 0, sigma = T on, B = theta S, and S is symmetric, not negative, its trace below 1:
the mean of all windows, each by what it has shown.  One that shows nothing takes nothing away.
K and Gamma follow Eqs. (22)-(23), or are held.
Sources: Chowdhary and Johnson 2010, 49th IEEE Conference on Decision and Control, Concurrent
learning for convergence in adaptive control without persistency of excitation; Parikh,
Kamalapurkar, Dixon 2019, International Journal of Adaptive Control and Signal Processing 33(12),
Integral concurrent learning.

V of Eq. (24), each error weighed by its own gain, does not jump, and has with eta = theta + alpha
    V' = -e^T KD e - gamma_c tr(eta S eta^T)/gamma
so that, K and Gamma held true, V falls at least at the rate min(2 k, 2 gamma_c lambda), k the least
of KD and lambda the least eigenvalue of S, once some windows have excited.

Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N] (length
per time), K[2], Gamma[2] (per time), S[N*N], B[2N] (length per time), sigma[1] and Phi[N]
(time), origin[2] (length), the states.
"""

import math
from typing import Any, NamedTuple

import numpy as np

from ...equations.block import Block
from ..reference import multiples
from ..words import maximum
from .commanded_gains import symmetric
from .composite_memory import missed
from .law import Known, Law, Setting, Truth, adapt_feedback, adapt_feedforward
from .learned_flow import V
from .scales import mean_feedback


class ConcurrentParameters(NamedTuple):
    """Parameters of concurrent learning in integral form."""

    N: int  # number of basis functions
    gain: float  # gamma > 0 of alpha, per time squared
    gain_K: float  # of Eq. (22), per length squared per time squared; 0 holds K
    gain_Gamma: float  # of Eq. (23), the same; 0 holds Gamma
    memory_gain: float  # gamma_c > 0, per time
    window: float  # T > 0, time
    interval: float = -1.0  # number of the window, kept by the integrator; -1: found from t


def concurrent(t, x, u, p, dx):
    """alpha' of Eq. (21) with the windows, K', Gamma' of Eqs. (22)-(23), Phi', origin'.

    u = e[2], phi_x[N], z[2], zc[2], x[2], v_x[2]; states alpha[2N], K[2], Gamma[2], S[N*N],
    B[2N], sigma[1], Phi[N], origin[2].
    """
    n = p.N
    e, phi, z, zc = u[0:2], u[2 : 2 + n], u[2 + n : 4 + n], u[4 + n : 6 + n]
    v = u[8 + n : 10 + n]
    S, B = 2 * n + 4, 2 * n + 4 + n * n
    sigma = B + 2 * n
    for k in range(S, sigma + 1):
        dx[k] = 0.0
    for i in range(2):
        alpha, seen = x[i * n : i * n + n], x[B + i * n : B + i * n + n]
        for j in range(n):
            off = missed(alpha, x[S:B], seen, j, n)
            dx[i * n + j] = -p.gain * e[i] * phi[j] - p.memory_gain * off
        dx[2 * n + i] = adapt_feedback(p.gain_K, e[i], z[i])
        dx[2 * n + 2 + i] = adapt_feedforward(p.gain_Gamma, e[i], zc[i])
        dx[sigma + n + 1 + i] = v[i]
    for k in range(n):
        dx[sigma + 1 + k] = phi[k]


def take_in(t, x, u, p, new):
    """S, B and sigma after a window of Eq. (1); Phi = 0 and origin = x begin the next.

    u = e[2], phi_x[N], z[2], zc[2], x[2], v_x[2]; the states are those of Eqs. (21)-(23).
    """
    n = p.N
    position = u[6 + n : 8 + n]
    S, B = 2 * n + 4, 2 * n + 4 + n * n
    sigma = B + 2 * n
    Phi, origin = x[sigma + 1 : sigma + 1 + n], x[sigma + n + 1 : sigma + n + 3]
    before = maximum(p.window, x[sigma])  # sigma is never less than T: no divisor is zero
    after = before
    for k in range(n):
        after = math.hypot(after, Phi[k])
    after = maximum(p.window, after)
    kept = before / after
    for k in range(S):
        new[k] = x[k]
    for j in range(n):
        for k in range(n):
            shown = (Phi[j] / after) * (Phi[k] / after)
            new[S + j * n + k] = kept * kept * x[S + j * n + k] + shown
    for i in range(2):
        Y = position[i] - origin[i]
        for k in range(n):
            shown = (Y / after) * (Phi[k] / after)
            new[B + i * n + k] = kept * kept * x[B + i * n + k] + shown
        new[sigma + n + 1 + i] = position[i]
    new[sigma] = after
    for k in range(n):
        new[sigma + 1 + k] = 0.0


def windows(p: ConcurrentParameters, t0: float, t1: float) -> np.ndarray:
    """Return the times in (t0, t1] at which a window ends."""
    return multiples(p.window, t0, t1)


def concurrent_law(parameters: ConcurrentParameters) -> Block:
    """Make concurrent learning in integral form."""
    N = parameters.N
    return Block(
        "adaptation",
        update=concurrent,
        inputs={"e": 2, "phi_x": N, "z": 2, "zc": 2, "x": 2, "v_x": 2},
        states={
            "alpha": 2 * N,
            "K": 2,
            "Gamma": 2,
            "S": N * N,
            "B": 2 * N,
            "sigma": 1,
            "Phi": N,
            "origin": 2,
        },
        parameters=parameters,
        breakpoints=windows,
        jump=take_in,
    )


def block(known: Known) -> Block:
    """Make the law of what is known; its scale is k = mean KD."""
    own, k = known.settings, mean_feedback(known)
    return concurrent_law(
        ConcurrentParameters(
            known.N,
            *known.gains[:3],
            own["memory_gain"] or 5 * k,
            own["window"] or 1 / k,
        )
    )


def starts(known: Known) -> dict[str, Any]:
    """Return an empty memory, and the first window's start."""
    N, T = known.N, block(known).parameters.window
    return {
        "S": np.zeros(N * N),
        "B": np.zeros(2 * N),
        "sigma": np.full(1, T),
        "Phi": np.zeros(N),
        "origin": known.position,
    }


def keeps(s: Any, p: Any, truth: Truth) -> dict[str, Any]:
    """Return what the states are at all times: S = S^T, B = theta S, x - origin = theta Phi."""
    S = symmetric(s["S"], p.N)
    return {"S": S, "B": truth.theta @ S, "origin": s["x"] - truth.theta @ s["Phi"]}


def losses(s: Any, p: Any, truth: Truth) -> list[tuple]:
    """Return gamma_c tr(eta S eta^T)/gamma."""
    eta, S = truth.theta + s["alpha"].reshape(2, p.N), s["S"].reshape(p.N, p.N)
    return [(p.memory_gain / p.gain, np.sum((eta @ S) * eta))]


LAW = Law(
    "concurrent",
    promise="CLPE goes to zero, and alpha to -theta exponentially once the track has excited, even "
    "if it never does again",
    needs="the commanded velocity",
    block=block,
    V=V,
    settings={
        "memory_gain": Setting(None, "positive", "gamma_c, 1/time; 5 k (k mean KD)"),
        "window": Setting(None, "positive", "T over which flow and basis are summed, time; 1/k"),
    },
    gain=1.0,
    starts=starts,
    keeps=keeps,
    losses=losses,
    cones=("S",),
    says="-e^T KD e - gamma_c tr(eta S eta^T)/gamma",
    made_of=("vehicle.feedback", "vehicle.position"),
)
