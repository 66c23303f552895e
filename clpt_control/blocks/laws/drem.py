"""Dynamic regressor extension and mixing (DREM): each flow parameter learns on its own.

The memory of `composite_memory`, b = theta Q, is mixed by the adjugate, which makes one
regression of each parameter.  With A = Q S, S diagonal, S_kk = 1/max(Q_kk, 1/l), and
Delta = det A, between 0 and 1,

    (b + alpha Q) S adj(A) = Delta eta,    eta = theta + alpha
    alpha' = -f eta,    f = g min(1, Delta^2/c^2) >= 0
    w'     = -f w,      w(0) = 1

so eta = w eta(0): the error of each parameter only shrinks, and no other moves it.  CLPE has no
part in alpha', which would break this; K and Gamma follow Eqs. (22)-(23), or are held.
Finite-time readout: what is left of the first error is known, so

    theta_FT = (theta_hat - w theta_hat(0))/(1 - w) = theta,    theta_hat = -alpha

`readout` is theta_FT once w <= 1 - margin, and theta_hat before.
The adjugate is that of Faddeev and LeVerrier, without pivots; for N <= 6 it is exact to 1e-12.
Sources: Aranovskiy, Bobtsov, Ortega, Pyrkin 2017, IEEE Transactions on Automatic Control 62(7),
Performance enhancement of parameter estimators via dynamic regressor extension and mixing;
Ortega, Gerasimov, Barabanov, Nikiforov 2019, Automatica 109, 108521.

V of Eq. (24), with g^2 as the gain of alpha, has
    V' = -e^T KD e + e^T eta phi - f |eta|^2/g^2
as in Theorem 3.1: in the mean square |e| is at most |eta phi| over the least of KD.

Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N] (length
per time), K[2], Gamma[2] (per time), Q[N*N] (time), b[2N] (length), phi_f[N], q[2] (length per
time), w[1], the states, and readout[2N] (length per time).
"""

from typing import Any, NamedTuple

import numpy as np

from ...equations.block import Block
from ...errors import ScenarioError
from ..lyapunov import lyapunov_candidate, weighed
from ..words import maximum, where
from .composite_memory import memory_kept, memory_rates, missed
from .filtered_flow import filter_kept, filter_rates, filter_starts
from .law import Known, Law, Setting, Truth, adapt_feedback, adapt_feedforward
from .scales import FILTER, MEMORY, mean_feedback

MOST = 6  # functions


class DremParameters(NamedTuple):
    """Parameters of dynamic regressor extension and mixing."""

    N: int  # number of basis functions
    rate: float  # g > 0, per time
    excitation: float  # c > 0, Delta from which on alpha learns at g, no unit
    margin: float  # of 1 - w, from which on the readout is theta, no unit
    gain_K: float  # of Eq. (22), per length squared per time squared; 0 holds K
    gain_Gamma: float  # of Eq. (23), the same; 0 holds Gamma
    forgetting: float  # m >= 0 of the memory, per time
    filter: float  # l > 0, per time
    alpha_0: np.ndarray  # shape (2, N), alpha(0), length per time


def mixing(mixed, column, Q, S, n):
    """Fill S adj(Q S), shape (N, N), row by row, and return det(Q S).

    M_1 = I, d_1 = tr A; M_k+1 = d_k I - A M_k, d_k+1 = tr(A M_k+1)/(k + 1) with A = Q S: adj A is
    M_N and det A is d_N (Faddeev and LeVerrier).  S is a diagonal; `column` is for numbers between.
    """
    d = 0.0
    for k in range(n):
        for j in range(n):
            mixed[j * n + k] = 0.0
        mixed[k * n + k] = S[k]
        d += Q[k * n + k] * S[k]
    for turn in range(2, n + 1):
        for k in range(n):
            for j in range(n):
                column[j] = 0.0
                for m in range(n):
                    column[j] -= Q[j * n + m] * mixed[m * n + k]
            column[k] += d
            for j in range(n):
                mixed[j * n + k] = S[j] * column[j]
        d = 0.0
        for j in range(n):
            for m in range(n):
                d += Q[j * n + m] * mixed[m * n + j]
        d = d / turn
    return d


def drem(t, x, u, p, dx):
    """alpha' and w' of the mixed memory, K', Gamma' of Eqs. (22)-(23), Q', b', filter.

    u = e[2], phi_x[N], z[2], zc[2], x[2], v_x[2]; states alpha[2N], K[2], Gamma[2], Q[N*N],
    b[2N], phi_f[N], q[2], w[1].
    """
    n = p.N
    e, phi, z, zc = u[0:2], u[2 : 2 + n], u[2 + n : 4 + n], u[4 + n : 6 + n]
    position, v = u[6 + n : 8 + n], u[8 + n : 10 + n]
    Q, b = 2 * n + 4, 2 * n + 4 + n * n
    at = b + 2 * n
    S, seen_alone = dx[at : at + n], x[Q : b : n + 1]
    for k in range(n):  # S and S adj(A), for now in the places of phi_f' and Q'
        S[k] = 1 / maximum(1 / p.filter, seen_alone[k])
    Delta = mixing(dx[Q:b], dx[b:at], x[Q:b], S, n)
    scale = p.rate / maximum(p.excitation * p.excitation, Delta * Delta)
    for i in range(2):
        alpha, seen = x[i * n : i * n + n], x[b + i * n : b + i * n + n]
        for k in range(n):
            dx[i * n + k] = 0.0
        for j in range(n):
            off = missed(alpha, x[Q:b], seen, j, n)
            for k in range(n):
                dx[i * n + k] -= off * dx[Q + j * n + k]
        for k in range(n):
            dx[i * n + k] = scale * Delta * dx[i * n + k]
        dx[2 * n + i] = adapt_feedback(p.gain_K, e[i], z[i])
        dx[2 * n + 2 + i] = adapt_feedforward(p.gain_Gamma, e[i], zc[i])
    memory_rates(dx, Q, b, at, x, position, p.filter, p.forgetting, n)
    filter_rates(dx, at, x, phi, position, v, p.filter, n)
    dx[at + n + 2] = -scale * Delta * Delta * x[at + n + 2]


def output(t, x, u, p, y):
    """The states, and readout[2N] of theta, Eq. (3): theta_FT once 1 - w >= margin."""
    n = p.N
    size = n * n + 5 * n + 7
    gone = 1 - x[size - 1]
    for k in range(size):
        y[k] = x[k]
    for i in range(2):
        for k in range(n):
            alpha = x[i * n + k]
            first = (alpha - x[size - 1] * p.alpha_0[i, k]) / maximum(p.margin, gone)
            y[size + i * n + k] = where(gone >= p.margin, -first, -alpha)


def drem_law(parameters: DremParameters) -> Block:
    """Make dynamic regressor extension and mixing."""
    N = parameters.N
    states = {"alpha": 2 * N, "K": 2, "Gamma": 2, "Q": N * N, "b": 2 * N, "phi_f": N, "q": 2}
    return Block(
        "adaptation",
        update=drem,
        output=output,
        inputs={"e": 2, "phi_x": N, "z": 2, "zc": 2, "x": 2, "v_x": 2},
        outputs={**states, "w": 1, "readout": 2 * N},
        states={**states, "w": 1},
        feedthrough=False,
        parameters=parameters,
    )


def block(known: Known) -> Block:
    """Make the law of what is known; its scale is k = mean KD."""
    own, k = known.settings, mean_feedback(known)
    if known.N > MOST:
        raise ScenarioError(
            f'learning.law = "drem": the basis has {known.N} functions, and a determinant of more '
            f'than {MOST} says too little; use "composite-least-squares" or "composite-memory"'
        )
    if own["margin"] >= 1:
        raise ScenarioError(f"learning.drem.margin = {own['margin']}: must be less than 1")
    if own["excitation"] > 1:
        raise ScenarioError(
            f"learning.drem.excitation = {own['excitation']}: must be at most 1, a determinant's "
            "largest"
        )
    forgetting = own["forgetting"]
    return drem_law(
        DremParameters(
            known.N,
            own["rate"] or k,
            own["excitation"],
            own["margin"],
            known.gains.feedback,
            known.gains.feedforward,
            0.02 * k if forgetting is None else forgetting,
            own["filter"] or 2 * k,
            known.alpha,
        )
    )


def starts(known: Known) -> dict[str, Any]:
    """Return the filter's start, an empty memory and w(0) = 1."""
    N, pole = known.N, block(known).parameters.filter
    return {
        "Q": np.zeros(N * N),
        "b": np.zeros(2 * N),
        **filter_starts(known, pole),
        "w": np.ones(1),
    }


def V(p: Any, truth: Truth) -> Block:
    """Make V of Eq. (24), g^2 the gain of alpha."""
    return lyapunov_candidate("learned-flow", weighed((p.rate**2, p.gain_K, p.gain_Gamma), *truth))


def keeps(s: Any, p: Any, truth: Truth) -> dict[str, Any]:
    """Return what the states are at all times: those of the memory, and eta = w eta(0)."""
    alpha = s["w"] * (truth.theta + p.alpha_0) - truth.theta
    return {**memory_kept(s, p, truth), **filter_kept(s, p, truth), "alpha": alpha}


LAW = Law(
    "drem",
    promise="each flow parameter's error only shrinks; in the mean, CLPE at most what is left of "
    "the flow's error over the least of KD; a readout of theta in finite time",
    needs=f"the commanded velocity, at most {MOST} functions",
    block=block,
    V=V,
    settings={
        "rate": Setting(None, "positive", "g, 1/time, of each parameter once excited; k"),
        "excitation": Setting(
            0.05, "positive", "c, the determinant from which on the rate is g; at most 1"
        ),
        "margin": Setting(0.5, "positive", "of 1 - w, from which on the readout is theta; below 1"),
        "forgetting": MEMORY,
        "filter": FILTER,
    },
    gain=1.0,
    alpha_by_gain=False,
    starts=starts,
    keeps=keeps,
    cones=("Q",),
    shrinking="w",
    readout="readout",
    says="-e^T KD e + e^T eta phi - f |eta|^2/g^2, eta = w eta(0), w' = -f w <= 0",
    made_of=("vehicle.feedback", "vehicle.position", "learning.parameters"),
)
