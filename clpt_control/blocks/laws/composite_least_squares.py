"""Composite least squares: CLPE and a filtered regression drive one estimate.

    theta_hat' = P (gamma phi e^T + phi_f eps^T / r^2),    theta_hat = -alpha^T
    s'         = -gamma e phi^T - lambda s

phi_f and eps = F_f - theta_hat phi_f are those of `filtered_flow`, P, lambda and rho those of
`covariance`, gamma = w/r^2 with a weight w.  P^-1 is never formed: s, the impulse of CLPE, with
s(0) = alpha(0) P(0)^-1 keeps s + rho theta P(0)^-1 = eta P^-1, eta = theta + alpha.  K and Gamma
are those of `commanded_gains`, or are held.
Source: Slotine and Li 1989, Automatica 25(4), Composite adaptive control of robot manipulators.

    V  = (|e|^2 + tr(eta P^-1 eta^T)/gamma + |K - KD|^2/gamma_K + |Gamma - GammaD|^2/gamma_Gamma)/2
    V' = -e^T KD e - |eta phi_f|^2/(2 w) - lambda tr(eta P^-1 eta^T)/(2 gamma)
         - what K and Gamma lose,    where each held parameter is true

Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N] (length
per time), K[2], Gamma[2] (per time), the states of `filtered_flow` and of `covariance`, and
impulse[2N] (s, time per length).
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
    forgetting,
    priors,
    shared_parameters,
    weigh,
)
from .filtered_flow import MADE_OF, filtered_law, own, shared_rates, shared_starts, unexplained
from .law import Known, Law, Setting, Truth
from .scales import mean_feedback

TABLE = "composite_least_squares"


class CompositeLeastSquaresParameters(NamedTuple):
    """Parameters of composite least squares."""

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
    weight: float  # w > 0 of CLPE beside the regression, per time


class CandidateParameters(NamedTuple):
    """What V measures and its weights."""

    N: int  # number of basis functions
    weight: float  # w, per time
    noise: float  # r, length per square root of time
    information: np.ndarray  # shape (N,), (time per length) squared
    gain_K: np.ndarray  # shape (2,)
    gain_Gamma: np.ndarray  # shape (2,)
    theta: np.ndarray  # shape (2, N), length per time
    KD: np.ndarray  # shape (2,), per time
    GammaD: np.ndarray  # shape (2,), per time


def composite_least_squares(t, x, u, p, dx):
    """alpha' of Eq. (21) with P and the regression, P', rho', s'.

    u = e[2], phi_x[N], z[2], zc[2], x[2], v_x[2] (and v_c[2]); states alpha[2N], K[2], Gamma[2],
    phi_f[N], q[2], Q_1[4], Q_2[4], b_v[4], P[N*N], rho[1], impulse[2N] (s).
    """
    n, P, precision = p.N, own(p.N), 1 / p.noise**2
    e, phi, gamma, s = u[0:2], u[2 : 2 + n], p.weight / p.noise**2, P + n * n + 1
    weigh(dx, x, P, phi, 0, n)  # P phi and P phi_f, for now in the places of alpha'
    weigh(dx, x, P, x[2 * n + 4 : 3 * n + 4], n, n)
    covariance_rates(dx, x, p, P, n)
    first, second = unexplained(x, u, p, 0), unexplained(x, u, p, 1)
    for k in range(n):
        driven, seen = gamma * dx[k], precision * dx[n + k]
        dx[k] = -driven * e[0] - seen * first
        dx[n + k] = -driven * e[1] - seen * second
    forgotten = forgetting(x, p, P)
    for i in range(2):
        for k in range(n):
            dx[s + i * n + k] = -gamma * e[i] * phi[k] - forgotten * x[s + i * n + k]
    shared_rates(x, u, p, dx)


def candidate(t, x, u, p, y):
    """V of Eq. (24) with tr(eta P^-1 eta^T)/gamma, eta P^-1 = s + rho theta P(0)^-1, for |eta|^2.

    u = e[2], alpha[2N], K[2], Gamma[2], rho[1], impulse[2N] (s); y = V[1].
    """
    n = p.N
    known_flow(t, x, u, p, y)
    for i in range(2):
        for k in range(n):
            eta = p.theta[i, k] + u[2 + i * n + k]
            share = u[7 + 2 * n + i * n + k] + u[6 + 2 * n] * p.theta[i, k] * p.information[k]
            y[0] += eta * share * p.noise**2 / (2 * p.weight)


def block(known: Known) -> Block:
    """Make the law of what is known; its scales are k = mean KD and R, the reach of the track."""
    N, own = known.N, known.settings
    p = CompositeLeastSquaresParameters(
        *shared_parameters(known, priors(known, TABLE), own["forgetting"]),
        weight=own["weight"] or 100 * mean_feedback(known),
    )
    return filtered_law(
        composite_least_squares, p, {"P": N * N, "rho": 1, "impulse": 2 * N}, known.limited
    )


def starts(known: Known) -> dict[str, Any]:
    """Return P(0), rho(0), s(0) and the filter's start."""
    p, prior = block(known).parameters, priors(known, TABLE)
    return {
        **covariance_starts(prior),
        "impulse": known.alpha * p.information,
        **shared_starts(known, p.filter),
    }


def V(p: Any, truth: Truth) -> Block:
    """Make V, each error weighed by its own gain."""
    w = weighed((1.0, p.gain_K, p.gain_Gamma), *truth)
    own = (p.N, p.weight, p.noise, p.information)
    return Block(
        "lyapunov",
        output=candidate,
        inputs={"e": 2, "alpha": 2 * p.N, "K": 2, "Gamma": 2, "rho": 1, "impulse": 2 * p.N},
        outputs={"V": 1},
        parameters=CandidateParameters(*own, w.gain_K, w.gain_Gamma, w.theta, w.KD, w.GammaD),
    )


def errors_over_P(s: Any, p: Any, truth: Truth) -> Any:
    """Return eta P^-1 = s + rho theta P(0)^-1, shape (2, N)."""
    return s["impulse"].reshape(2, p.N) + s["rho"][0] * truth.theta * p.information


def keeps(s: Any, p: Any, truth: Truth) -> dict[str, Any]:
    """Return what the states are: P = P^T, eta = (s + rho theta P(0)^-1) P, F_f = theta phi_f."""
    return covariance_kept(s, p, truth, errors_over_P(s, p, truth))


def losses(s: Any, p: Any, truth: Truth) -> list[tuple]:
    """Return |eta phi_f|^2/(2 w), lambda tr(eta P^-1 eta^T)/(2 gamma), what K and Gamma lose."""
    return covariance_losses(s, p, truth, errors_over_P(s, p, truth), p.weight)


LAW = Law(
    "composite-least-squares",
    promise="CLPE goes to zero, and alpha to -theta faster the more the track has shown",
    needs="the commanded velocity",
    block=block,
    V=V,
    settings={
        **SETTINGS,
        "weight": Setting(None, "positive", "w, of CLPE beside the regression, 1/time; 100 k"),
        "forgetting": Setting(0.0, "not negative", "lambda_0 of P, 1/time; 0 forgets nothing"),
    },
    gain=1.0,
    alpha_by_gain=False,
    starts=starts,
    keeps=keeps,
    losses=losses,
    over=errors_over_P,
    cones=("P", "Q_1", "Q_2"),
    says="-e^T KD e - |eta phi_f|^2/(2 w) - lambda tr(eta P^-1 eta^T)/(2 gamma)",
    made_of=(*MADE_OF, "learning.parameters"),
)
