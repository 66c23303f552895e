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

import numpy as np

from ...errors import ScenarioError
from .composite_memory import memory_rates
from .known import MEMORY, Known, Setting, mean_feedback
from .law import HELD, Law, State, adapt_gains, promised
from .regressions import FILTERED_FLOW, filter_rates, memory

MOST = 6  # functions


def mixing(Q, S):
    """Return S adj(Q S), shape (N, N), and det(Q S); S is a diagonal.

    M_1 = I, d_1 = tr A; M_k+1 = d_k I - A M_k, d_k+1 = tr(A M_k+1)/(k + 1) with A = Q S: adj A is
    M_N and det A is d_N (Faddeev and LeVerrier).
    """
    one = np.eye(len(S))
    mixed, d = S[:, None] * one, np.sum(np.diagonal(Q) * S)
    for turn in range(2, len(S) + 1):
        mixed = S[:, None] * (d * one - Q @ mixed)
        d = np.sum(Q * mixed.T) / turn
    return mixed, d


def drem(t, x, u, p):
    """alpha' and w' of the mixed memory, K', Gamma' of Eqs. (22)-(23), Q', b', filter."""
    mixed, Delta = mixing(x.Q, 1 / np.maximum(1 / p.filter, np.diagonal(x.Q)))
    scale = p.rate / np.maximum(p.excitation**2, Delta * Delta)
    return {
        "alpha": -scale * Delta * ((x.b + x.alpha @ x.Q.T) @ mixed),
        **adapt_gains(p, u.e, u.z, u.zc),
        **memory_rates(x, u, p),
        **filter_rates(x, u, p),
        "w": -scale * Delta * Delta * x.w,
    }


def output(t, x, u, p):
    """Return readout[2N] of theta, Eq. (3): theta_FT once 1 - w >= margin."""
    gone = 1 - x.w
    first = (x.alpha - x.w * p.alpha_0) / np.maximum(p.margin, gone)
    return {"readout": np.where(gone >= p.margin, -first, -x.alpha)}


def refuses(law: Law, known: Known) -> None:
    """Refuse more functions than a determinant is good for."""
    if known.N > MOST:
        raise ScenarioError(
            f'learning.law = "drem": the basis has {known.N} functions, and a determinant of more '
            f'than {MOST} says too little; use "composite-least-squares" or "composite-memory"'
        )


LAW = Law(
    "drem",
    promise="each flow parameter's error only shrinks; in the mean, CLPE at most what is left of "
    "the flow's error over the least of KD; a readout of theta in finite time",
    needs=f"the commanded velocity, at most {MOST} functions",
    rates=drem,
    promises=(
        *promised("spanned exact", "shrinks", "readout"),
        *promised("true spanned exact", "mean square"),
    ),
    parameters={
        "rate": Setting("g, 1/time, of each parameter once excited; k", mean_feedback),
        "excitation": Setting("c, the determinant from which on the rate is g", 0.05, "at most 1"),
        "margin": Setting("of 1 - w, from which on the readout is theta", 0.5, "below 1"),
        **HELD,
        "forgetting": MEMORY,
        "alpha_0": lambda known: known.alpha,
    },
    output=output,
    makes={"readout": (2, "N")},
    weighs=lambda p: p.rate**2,
    refuses=refuses,
    shrinking="w",
    keeps=lambda s, p, truth: {"alpha": s["w"] * (truth.theta + p.alpha_0) - truth.theta},
    readout="readout",
    says="-e^T KD e + e^T eta phi - f |eta|^2/g^2, eta = w eta(0), w' = -f w <= 0",
).with_parts(memory("Q", "b"), FILTERED_FLOW, {"states": {"w": State(1, 1.0)}})
