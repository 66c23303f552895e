"""Recursive least squares on the filtered regression, forgetting with bounded gain.

    theta_hat' = P phi_f eps^T / r^2,    theta_hat = -alpha^T

phi_f and eps are those of `filtered_flow`, P that of `covariance`.  The flow is learned from
where the vehicle was carried, not from CLPE; K and Gamma, of `commanded_gains`, or held, bring
CLPE down beside it.  With eta = theta + alpha and theta, alpha at t = 0 in eta(0),

    eta P^-1 = rho eta(0) P(0)^-1                                             at all times
    V  = (|e|^2 + r^2 tr(eta P^-1 eta^T)/k + |K - KD|^2/gamma_K + |Gamma - GammaD|^2/gamma_Gamma)/2
    V' = -e^T KD e + e^T eta phi - |eta phi_f|^2/(2 k) - r^2 lambda tr(eta P^-1 eta^T)/(2 k)
         - what K and Gamma lose

tr(eta P^-1 eta^T) never rises, so eta is bounded, and in the mean |e| is at most |eta phi| over
the least of KD: CLPE is as small as the flow is well learned.
Source: Slotine and Li 1991, Applied Nonlinear Control, section 8.7.

Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N] (length
per time), K[2], Gamma[2] (per time), the states of `filtered_flow` and of `covariance`.
"""

from typing import Any, NamedTuple

import numpy as np

from ...equations.block import Block
from ..lyapunov import known_flow, weighed
from .covariance import (
    SETTINGS,
    covariance_kept,
    covariance_losses,
    covariance_rates,
    covariance_starts,
    priors,
    shared_parameters,
    weigh,
)
from .filtered_flow import MADE_OF, filtered_law, own, shared_rates, shared_starts, unexplained
from .law import Known, Law, Setting, Truth
from .scales import mean_feedback

TABLE = "least_squares"


class LeastSquaresParameters(NamedTuple):
    """Parameters of least squares."""

    N: int  # number of basis functions
    gain_K: float  # of Eq. (22), per length squared per time squared; 0 holds K
    gain_Gamma: float  # of Eq. (23), the same; 0 holds Gamma
    alpha_M: np.ndarray  # shape (2, N), the modelled flow, length per time
    rate: float  # k, mean feedback gain, per time
    filter: float  # l > 0, per time
    noise: float  # r > 0, of the regression, length per square root of time
    forgetting: float  # lambda_0 >= 0, per time
    largest: float  # k_0 = tr P(0), length per time, squared
    information: np.ndarray  # shape (N,), 1/prior^2, 0 for what is held, (time per length) squared
    first: np.ndarray  # shape (2, N), alpha(0), length per time


class CandidateParameters(NamedTuple):
    """What V measures and its weights."""

    N: int  # number of basis functions
    rate: float  # k, per time
    noise: float  # r, length per square root of time
    information: np.ndarray  # shape (N,), (time per length) squared
    first: np.ndarray  # shape (2, N), alpha(0), length per time
    gain_K: np.ndarray  # shape (2,)
    gain_Gamma: np.ndarray  # shape (2,)
    theta: np.ndarray  # shape (2, N), length per time
    KD: np.ndarray  # shape (2,), per time
    GammaD: np.ndarray  # shape (2,), per time


def least_squares(t, x, u, p, dx):
    """alpha' = -P phi_f eps^T/r^2 in place of Eq. (21), P', rho'.

    u = e[2], phi_x[N], z[2], zc[2], x[2], v_x[2] (and v_c[2]); states alpha[2N], K[2], Gamma[2],
    phi_f[N], q[2], Q_1[4], Q_2[4], b_v[4], P[N*N], rho[1].
    """
    n, P, precision = p.N, own(p.N), 1 / p.noise**2
    weigh(dx, x, P, x[2 * n + 4 : 3 * n + 4], 0, n)  # for now in the place of alpha_1'
    covariance_rates(dx, x, p, P, 0)
    first, second = unexplained(x, u, p, 0), unexplained(x, u, p, 1)
    for k in range(n):
        seen = dx[k] * precision
        dx[k] = -seen * first
        dx[n + k] = -seen * second
    shared_rates(x, u, p, dx)


def candidate(t, x, u, p, y):
    """V of Eq. (24) with r^2 tr(eta P^-1 eta^T)/k = r^2 sum eta rho eta(0) P(0)^-1/k for |eta|^2.

    u = e[2], alpha[2N], K[2], Gamma[2], rho[1]; y = V[1].
    """
    n = p.N
    known_flow(t, x, u, p, y)
    for i in range(2):
        for k in range(n):
            share = (p.theta[i, k] + p.first[i, k]) * p.information[k] * u[6 + 2 * n]
            y[0] += (p.theta[i, k] + u[2 + i * n + k]) * share * p.noise**2 / (2 * p.rate)


def block(known: Known) -> Block:
    """Make the law of what is known; its scales are k = mean KD and R, the reach of the track."""
    forgotten = known.setting("forgetting", 0.02 * mean_feedback(known))
    shared = shared_parameters(known, priors(known, TABLE), forgotten)
    p = LeastSquaresParameters(*shared, first=known.alpha)
    return filtered_law(least_squares, p, {"P": known.N**2, "rho": 1}, known.limited)


def starts(known: Known) -> dict[str, Any]:
    """Return P(0), rho(0) and the filter's start."""
    pole = block(known).parameters.filter
    return {**covariance_starts(priors(known, TABLE)), **shared_starts(known, pole)}


def V(p: Any, truth: Truth) -> Block:
    """Make V, each error weighed by its own gain."""
    w = weighed((1.0, p.gain_K, p.gain_Gamma), *truth)
    own = (p.N, p.rate, p.noise, p.information, p.first)
    return Block(
        "lyapunov",
        output=candidate,
        inputs={"e": 2, "alpha": 2 * p.N, "K": 2, "Gamma": 2, "rho": 1},
        outputs={"V": 1},
        parameters=CandidateParameters(*own, w.gain_K, w.gain_Gamma, w.theta, w.KD, w.GammaD),
    )


def errors_over_P(s: Any, p: Any, truth: Truth) -> Any:
    """Return eta P^-1 = rho eta(0) P(0)^-1, shape (2, N)."""
    return s["rho"][0] * (truth.theta + p.first) * p.information


def keeps(s: Any, p: Any, truth: Truth) -> dict[str, Any]:
    """Return what the states are: P = P^T, eta = rho eta(0) P(0)^-1 P, F_f = theta phi_f."""
    return covariance_kept(s, p, truth, errors_over_P(s, p, truth))


def losses(s: Any, p: Any, truth: Truth) -> list[tuple]:
    """Return |eta phi_f|^2/(2 k), r^2 lambda tr(eta P^-1 eta^T)/(2 k), what K and Gamma lose."""
    return covariance_losses(s, p, truth, errors_over_P(s, p, truth), p.rate)


def push(s: Any, p: Any, truth: Truth) -> Any:
    """Return e^T eta phi."""
    eta = truth.theta + s["alpha"].reshape(2, p.N)
    return (s["x"] - s["z"]) @ (eta @ s["phi_x"])


LAW = Law(
    "least-squares",
    promise="alpha goes to -theta where the track excites, whatever K, Gamma and CLPE do; CLPE is "
    "as small in the mean as the flow is well learned",
    needs="the commanded velocity",
    block=block,
    V=V,
    settings={
        **SETTINGS,
        "forgetting": Setting(None, "not negative", "lambda_0 of P, 1/time; 0.02 k"),
    },
    gain=1.0,
    alpha_by_gain=False,
    starts=starts,
    keeps=keeps,
    losses=losses,
    push=push,
    over=errors_over_P,
    cones=("P", "Q_1", "Q_2"),
    says="-e^T KD e + e^T eta phi - |eta phi_f|^2/(2 k) - r^2 lambda tr(eta P^-1 eta^T)/(2 k)",
    comes_to="tr(eta P^-1 eta^T) never rises; in the mean |e| <= |eta phi| over the least of KD",
    made_of=(*MADE_OF, "learning.parameters"),
)
