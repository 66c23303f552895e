"""Regressions y = kappa w without derivatives, shared by laws: filtered flow, memory, covariance.

The flow and the basis go through one filter l/(s + l):

    phi_f' = l (phi(x) - phi_f),    q' = l (l x + v - q),    F_f = l x - q

By Eq. (1), x' - v = F, so F_f' = l (F - F_f): F_f is the filtered flow, computed from the
position x and the velocity v through the water.  With phi_f(0) = 0 and q(0) = l x(0),
F_f = theta phi_f at all times for any theta, and eps = F_f - theta_hat phi_f = (theta + alpha)
phi_f.
Source: Slotine and Li 1989, Automatica 25(4), composite adaptive control.

A memory stores the information of w:

    n = w - m Q w,    Q' = n n^T/size,    b' = (y - m b w) n^T/size

With Q(0) = 0 and b(0) = 0, b = kappa Q and Q = M (1 + m M)^-1 with M = int w w^T/size: Q is
symmetric, not negative, below 1/m and non-decreasing, and so is its least eigenvalue.  No
information is lost, and well known directions grow more slowly.  A law that adds
gamma_c (b - kappa_hat Q) to the rate of kappa_hat pulls it to kappa, in the end at the rate
gamma_c/m.
Sources: Kreisselmeier 1977, IEEE Transactions on Automatic Control 22(1), Adaptive observers
with exponential rate of convergence (the pull); Pan and Yu 2018, Automatica 89, Composite learning
robot control with guaranteed parameter convergence (a memory that does not fall).

Laws with a regression adapt K and Gamma by CLPE, as in the paper, and by a memory of the commanded
velocity.  By Eq. (7), y = v + alpha_M phi(x) = -KD x + GammaD zc is known if v is known: a
regression of each axis i on w = (-x_i, zc_i) for kappa = (K_i, Gamma_i), which no flow disturbs.

    Q_i'     = n n^T / (1 + w^T G w),   b_i' = (y_i - m b_i^T G w) n / (1 + w^T G w)
    K_i'     = -gamma_K z_i e_i      + gamma_K (b_i - Q_i kappa)_1
    Gamma_i' =  gamma_Gamma zc_i e_i + gamma_Gamma (b_i - Q_i kappa)_2

are Eqs. (22)-(23) with a memory, n = w - m Q_i G w, G = diag(gamma_K,
gamma_Gamma)/k^2, m = 0.1 k.  With Q_i(0) = 0 and b_i(0) = 0, b_i = Q_i kappa_D, and V' has the
dissipative terms (kappa - kappa_D)^T Q_i (kappa - kappa_D); Q_i is non-decreasing.  By CLPE alone K
and Gamma converge slowly, and alpha compensates their error meanwhile.  A gain of 0 fixes K or
Gamma.
Source: Kreisselmeier 1977, as the memory.

`covariance` is P of least squares, forgetting with bounded gain:

    P'   = lambda P - P phi_f phi_f^T P / r^2,    lambda = lambda_0 (1 - tr P/k_0),  k_0 = tr P(0)
    rho' = -lambda rho,                           rho(0) = 1: the share of the prior that is left

P is N x N, symmetric, one for both axes.  P(0) is the diagonal of prior variances; the parameter
of a function whose prior is 0 is fixed.  tr P, a norm of matrices P >= 0, is at most k_0.
Therefore lambda >= 0, and forgetting stops before P winds up; with lambda_0 = 0 nothing is
forgotten.  Then

    (P(0)^-1 + int phi_f phi_f^T/r^2)^-1 <= P <= P(0)/rho  and  P <= k_0 I

Source: Slotine and Li 1991, Applied Nonlinear Control, section 8.7.6 (bounded-gain forgetting).

Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2], and v_c[2] with a speed limit
(length per time); states phi_f[N], q[2] (length per time), K[2], Gamma[2] (per time), Q_1[4],
Q_2[4] (length squared times time), b_v[4] (length squared), P[N*N] (length per time, squared),
rho[1].
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from ...base.errors import ScenarioError
from ..blocks.lyapunov import level
from .law import (
    FILTER,
    MOVING,
    NOISE,
    PRIOR,
    Law,
    LawContext,
    Part,
    Setting,
    State,
    Truth,
    adapt_gains,
    promised,
)


def filter_rates(x, u, p):
    """Return phi_f' and q'."""
    return {
        "phi_f": p.filter * (u.phi_x - x.phi_f),
        "q": p.filter * (p.filter * u.x + u.v_x - x.q),
    }


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
    "states": {
        "phi_f": State("N"),
        "q": State(2, lambda context, p: p.filter * context.position),
    },
    "inputs": MOVING,
    "parameters": {"filter": FILTER},
    "invariants": lambda s, p, truth: {
        "q": p.filter * s["x"] - truth.theta @ s["phi_f"]
    },  # F_f
}


def memory_rates(Q, b, y, w, m_w, size):
    """Return Q' and b' of a memory of w; `m_w` is m w."""
    n = w - Q @ m_w
    return np.outer(n, n) / size, np.outer(y - b @ m_w, n) / size


def memory(Q: str, b: str) -> Part:
    """Return the fields of a memory of the flow, b = theta Q; Q and b are names of states."""
    return {
        "states": {Q: State(("N", "N")), b: State((2, "N"))},  # zero at t = 0
        "inputs": MOVING,
        "invariants": lambda s, p, truth: {b: truth.theta @ s[Q]},
        "semidefinite": (Q,),
    }


def pulling_memory(Q: str, b: str) -> Part:
    """Return the fields of a memory that pulls alpha: V' has -gamma_c tr(eta Q eta^T)/gamma."""

    def losses(s: Any, p: Any, truth: Truth) -> list[tuple]:
        eta = truth.theta + s["alpha"]
        return [(p.memory_gain / p.gain, np.sum((eta @ s[Q]) * eta))]

    return memory(Q, b) | {
        "losses": losses,
        "V_rate": f"-e^T KD e - gamma_c tr(eta {Q} eta^T)/gamma",
        "promises": promised("true spanned exact", "falls", "settles", "exponential"),
    }


# --- K and Gamma ------------------------------------------------------------------------------


def gain_rates(x, u, p):
    """Return K', Gamma', Q_1', Q_2' and b_v'; v is that of Eq. (7)."""
    y = getattr(u, "v_c", u.v_x) + p.alpha_M @ u.phi_x
    # w, kappa and what follows have a row for each axis
    w = np.stack([-u.x, u.zc]).T
    kappa = np.stack([x.K, x.Gamma]).T
    G_w = w * np.stack([p.gain_K, p.gain_Gamma]) / p.rate**2
    size = 1 + np.sum(G_w * w, axis=1)
    m_w = 0.1 * p.rate * G_w
    Q_1, b_1 = memory_rates(x.Q_1, x.b_v[0], y[0], w[0], m_w[0], size[0])
    Q_2, b_2 = memory_rates(x.Q_2, x.b_v[1], y[1], w[1], m_w[1], size[1])
    pull = x.b_v - np.stack([x.Q_1 @ kappa[0], x.Q_2 @ kappa[1]])
    by_error = adapt_gains(p, u.e, u)
    return {
        "K": by_error["K"] + p.gain_K * pull[:, 0],
        "Gamma": by_error["Gamma"] + p.gain_Gamma * pull[:, 1],
        "Q_1": Q_1,
        "Q_2": Q_2,
        "b_v": np.concatenate([b_1, b_2]),
    }


def gain_invariants(s: Any, p: Any, truth: Truth) -> dict[str, Any]:
    """Return the invariant b_i = Q_i kappa_D."""
    kappa = np.stack([truth.KD, truth.GammaD]).T
    return {"b_v": np.stack([s["Q_1"] @ kappa[0], s["Q_2"] @ kappa[1]])}


def gain_losses(s: Any, p: Any, truth: Truth) -> list[tuple]:
    """Return the dissipative terms (kappa - kappa_D)^T Q_i (kappa - kappa_D) of adapted gains."""
    error = np.stack([s["K"] - truth.KD, s["Gamma"] - truth.GammaD]).T
    return [(error[0] @ s["Q_1"] @ error[0],), (error[1] @ s["Q_2"] @ error[1],)]


COMMANDED_GAINS: Part = {
    "needs": "the commanded velocity",
    "states": dict.fromkeys(("Q_1", "Q_2", "b_v"), State((2, 2))),  # zero at t = 0
    "inputs": {**MOVING, "v_c": 2},
    "parameters": {"alpha_M": "alpha_M", "rate": "k"},
    "invariants": gain_invariants,
    "losses": gain_losses,
    "semidefinite": ("Q_1", "Q_2"),
}


# --- the covariance ---------------------------------------------------------------------------


def forgetting(x, p):
    """Return lambda, per time."""
    return p.forgetting * (1 - np.trace(x.P) / p.largest)


def covariance_rates(x, p, P_phi):
    """Return P' and rho', given P phi_f."""
    forgotten = forgetting(x, p)
    return {
        "P": forgotten * x.P - np.outer(P_phi, P_phi) / p.noise**2,
        "rho": -forgotten * x.rho,
    }


def level_by_P(u, p, weighted, w):
    """Return V of Eq. (24) with r^2 tr(eta P^-1 eta^T)/w for |eta|^2; eta P^-1 is `weighted`."""
    eta_P_eta = np.sum((p.theta + u.alpha) * weighted)
    return {"V": level(u.e, u, p) + p.noise**2 / (2 * w) * eta_P_eta}


def error_by_P(p: Any, alpha: np.ndarray, P: np.ndarray) -> np.ndarray:
    """Return eta P^-1 along a run, shape (time, 2, N); 0 for fixed parameters."""
    free = np.flatnonzero(p.information)
    eta = np.swapaxes(p.theta + alpha, 1, 2)[:, free]
    free_P = P[:, free][..., free]
    weighted = np.zeros_like(alpha)
    weighted[..., free] = np.swapaxes(np.linalg.solve(free_P, eta), 1, 2)
    return weighted


def priors(context: LawContext) -> np.ndarray:
    """Return the prior standard deviation of each parameter, shape (N,), length per time."""
    per_function = context.settings["priors"]
    if per_function is None:
        return np.full(context.N, context.prior)
    return np.asarray(per_function, dtype=float)


def check_priors(law: Law, context: LawContext) -> None:
    """Refuse priors that do not fit the functions."""
    prior, per_function = context.settings["prior"], context.settings["priors"]
    if per_function is None:
        return
    fits = prior is None and len(per_function) == context.N
    if not fits or not any(per_function):
        raise ScenarioError(
            f"learning.{law.table}.priors: must be {context.N} numbers, one for each function, "
            "not all 0, in place of prior"
        )


def information(context: LawContext) -> np.ndarray:
    """Return P(0)^-1, (time per length) squared; 0 for fixed parameters."""
    return np.array([1 / s**2 if s > 0 else 0.0 for s in priors(context)])


def covariance(weighted_error: Callable[..., Any], weight: str) -> Part:
    """Return the fields of a law with this P, given its eta P^-1 and the parameter that is w."""

    def invariants(s: Any, p: Any, truth: Truth) -> dict[str, Any]:
        """Return alpha computed from eta P^-1."""
        return {"alpha": weighted_error(s, p, truth) @ s["P"] - truth.theta}

    def losses(s: Any, p: Any, truth: Truth) -> list[tuple]:
        """Return |eta phi_f|^2/(2 w) and r^2 lambda tr(eta P^-1 eta^T)/(2 w)."""
        w, weighted = getattr(p, weight), weighted_error(s, p, truth)
        rate = p.forgetting, 1 - np.trace(s["P"]) / p.largest
        eta_P_eta = np.sum((weighted @ s["P"]) * weighted)
        return [
            (unexplained_square(s, p, truth), 1 / (2 * w)),
            (*rate, eta_P_eta, p.noise**2 / (2 * w)),
        ]

    return {
        "keys": {
            "prior": PRIOR,
            "priors": Setting(
                "in place of prior: one a function, 0 to hold it", None, "row"
            ),
        },
        "parameters": {
            "noise": NOISE,
            "largest": lambda context: float(
                np.sum(priors(context) ** 2)
            ),  # k_0 = tr P(0)
            "information": information,
        },
        "states": {
            "P": State(("N", "N"), lambda context, p: np.diag(priors(context) ** 2)),
            "rho": State(1, 1.0),
        },
        "check": check_priors,
        "invariants": invariants,
        "losses": losses,
        "weighted_error": weighted_error,
        "candidate_by_P": lambda t, x, u, p: level_by_P(
            u, p, u.weighted, getattr(p, weight)
        ),
        "semidefinite": ("P",),
    }
