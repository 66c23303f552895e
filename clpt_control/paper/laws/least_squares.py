"""Laws of the filtered regression: its gradient, least squares, and least squares with CLPE.

phi_f, eps, P, rho, and the dissipative terms of K and Gamma are those of `regressions`.
"""

from typing import Any

import numpy as np

from .law import GAINS, K_GAMMA, Law, Setting, State, Truth, promised, scaled
from .regressions import (
    COMMANDED_GAINS,
    FILTERED_FLOW,
    covariance,
    covariance_rates,
    filter_rates,
    forgetting,
    gain_rates,
    level_by_P,
    unexplained,
    unexplained_square,
)


def normalised_gradient(t, x, u, p):
    """The normalised gradient: CLPE and the present filtered regression drive one estimate.

        theta_hat' = gamma phi e^T + gamma_n phi_f eps^T / (1 + |phi_f|^2)
        theta_hat = -alpha^T    for Eq. (21)

    phi_f and eps are those of `regressions`.  The second term reduces eps at a rate of at most
    gamma_n for any regressor.  It has no memory: only the present motion teaches.  K and Gamma are
    those of `regressions`, or are fixed.
    Sources: Ioannou and Sun 1996, section 4.3; with CLPE, Slotine and Li 1989.

    V of Eq. (24), each error weighted by its own gain, has with eta = theta + alpha
        V' = -e^T KD e - gamma_n |eta phi_f|^2/(gamma (1 + |phi_f|^2))
             - dissipative terms of K and Gamma

    Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N] (length
    per time), K[2], Gamma[2] (per time) and the states of `regressions`.
    """
    eps = p.regression_gain * unexplained(x, u, p) / (1 + x.phi_f @ x.phi_f)
    alpha = np.outer(-p.gain * u.e, u.phi_x) - np.outer(eps, x.phi_f)
    return {"alpha": alpha, **filter_rates(x, u, p), **gain_rates(x, u, p)}


def regression_losses(s: Any, p: Any, truth: Truth) -> list[tuple]:
    """Return gamma_n |eta phi_f|^2/(gamma (1 + |phi_f|^2))."""
    size = 1 + s["phi_f"] @ s["phi_f"]
    return [(unexplained_square(s, p, truth), p.regression_gain / p.gain, 1 / size)]


NORMALISED_GRADIENT = Law(
    "normalised-gradient",
    rates=normalised_gradient,
    promises=promised("true spanned exact", "falls", "settles"),
    parameters={
        **GAINS,
        "regression_gain": Setting("gamma_n, 1/time; 4 k (k mean KD)", scaled(4)),
    },
    losses=regression_losses,
    V_rate="-e^T KD e - gamma_n |eta phi_f|^2/(gamma (1 + |phi_f|^2))",
).with_parts(FILTERED_FLOW, COMMANDED_GAINS)


# --- least squares ---------------------------------------------------------------------------


def least_squares(t, x, u, p):
    """Recursive least squares on the filtered regression, forgetting with bounded gain.

        theta_hat' = P phi_f eps^T / r^2,    theta_hat = -alpha^T    for Eq. (21)

    phi_f and eps are those of `regressions`, P that of `covariance`.  The flow is learned from
    the motion of the vehicle, not from CLPE; K and Gamma are those of `regressions` and reduce
    CLPE, or are fixed.  With eta = theta + alpha and theta, alpha at t = 0 in eta(0),

        eta P^-1 = rho eta(0) P(0)^-1                                             at all times
        2 V = |e|^2 + r^2 tr(eta P^-1 eta^T)/k + |K - KD|^2/gamma_K + |Gamma - GammaD|^2/gamma_Gamma
        V' = -e^T KD e + e^T eta phi - |eta phi_f|^2/(2 k) - r^2 lambda tr(eta P^-1 eta^T)/(2 k)
             - dissipative terms of K and Gamma

    tr(eta P^-1 eta^T) is non-increasing, so eta is bounded, and the rms of CLPE is at most the
    rms of |eta phi| over the least of KD: CLPE is as small as the error of the learned flow.
    Source: Slotine and Li 1991, Applied Nonlinear Control, section 8.7.

    Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N] (length
    per time), K[2], Gamma[2] (per time), the states of `regressions` and of `covariance`.
    """
    P_phi = x.P @ x.phi_f
    alpha = -np.outer(unexplained(x, u, p), P_phi) / p.noise**2
    return {
        "alpha": alpha,
        **covariance_rates(x, p, P_phi),
        **filter_rates(x, u, p),
        **gain_rates(x, u, p),
    }


def least_squares_level(t, x, u, p):
    """V of Eq. (24) with r^2 tr(eta P^-1 eta^T)/k for |eta|^2, eta P^-1 = rho eta(0) P(0)^-1."""
    return level_by_P(u, p, errors_by_rho({"rho": u.rho}, p, p), p.rate)


def errors_by_rho(s: Any, p: Any, truth: Truth) -> Any:
    """Return eta P^-1 = rho eta(0) P(0)^-1, shape (2, N)."""
    return s["rho"] * (truth.theta + p.alpha_0) * p.information


def forgotten(P: np.ndarray, time: float, p: Any) -> np.ndarray:
    """Return P after P' = lambda P, `covariance_rates` without phi_f: tr P is logistic."""
    trace = np.trace(P)
    growth = np.exp(p.forgetting * time)
    return P * growth / (1 + trace / p.largest * (growth - 1))


LEAST_SQUARES = Law(
    "least-squares",
    rates=least_squares,
    promises=(
        *promised("spanned exact", "estimate"),
        *promised("true spanned exact", "mean square"),
    ),
    parameters={
        **K_GAMMA,
        "forgetting": Setting(
            "lambda_0 of P, 1/time; 0.02 k", scaled(0.02), "not negative"
        ),
        "alpha_0": lambda context: context.alpha,
    },
    candidate=least_squares_level,
    V_inputs=("e", "alpha", "K", "Gamma", "rho"),
    between_fixes=forgotten,
    driving_estimate="alpha",
    V_rate="-e^T KD e + e^T eta phi - |eta phi_f|^2/(2 k) - r^2 lambda tr(eta P^-1 eta^T)/(2 k)",
).with_parts(FILTERED_FLOW, COMMANDED_GAINS, covariance(errors_by_rho, "rate"))


# --- least squares with CLPE -----------------------------------------------------------------


def composite_least_squares(t, x, u, p):
    """Composite least squares: CLPE and a filtered regression drive one estimate.

        theta_hat' = P (gamma phi e^T + phi_f eps^T / r^2),    theta_hat = -alpha^T    for Eq. (21)
        s'         = -gamma e phi^T - lambda s

    phi_f and eps = F_f - theta_hat phi_f are those of `regressions`, P, lambda and rho those of
    `covariance`, gamma = w/r^2 with a weight w.  P^-1 is never formed: s, the impulse of CLPE, with
    s(0) = alpha(0) P(0)^-1 satisfies s + rho theta P(0)^-1 = eta P^-1, eta = theta + alpha.  K and
    Gamma are those of `regressions`, or are fixed.
    Source: Slotine and Li 1989, Automatica 25(4), Composite adaptive control of robot manipulators.

        2 V = |e|^2 + tr(eta P^-1 eta^T)/gamma + |K - KD|^2/gamma_K + |Gamma - GammaD|^2/gamma_Gamma
        V' = -e^T KD e - |eta phi_f|^2/(2 w) - lambda tr(eta P^-1 eta^T)/(2 gamma)
             - dissipative terms of K and Gamma,    if each fixed parameter is true

    Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N] (length
    per time), K[2], Gamma[2] (per time), the states of `regressions` and of `covariance`, and
    impulse[2N] (s, time per length).
    """
    gamma = p.weight / p.noise**2
    P_phi = x.P @ x.phi_f
    by_error = gamma * u.e
    by_flow = unexplained(x, u, p) / p.noise**2
    return {
        "alpha": -np.outer(by_error, x.P @ u.phi_x) - np.outer(by_flow, P_phi),
        "impulse": -np.outer(by_error, u.phi_x) - forgetting(x, p) * x.impulse,
        **covariance_rates(x, p, P_phi),
        **filter_rates(x, u, p),
        **gain_rates(x, u, p),
    }


def composite_level(t, x, u, p):
    """V of Eq. (24) with tr(eta P^-1 eta^T)/gamma for |eta|^2."""
    weighted = errors_by_impulse({"rho": u.rho, "impulse": u.impulse}, p, p)
    return level_by_P(u, p, weighted, p.weight)


def errors_by_impulse(s: Any, p: Any, truth: Truth) -> Any:
    """Return eta P^-1 = s + rho theta P(0)^-1, shape (2, N)."""
    return s["impulse"] + s["rho"] * truth.theta * p.information


COMPOSITE_LEAST_SQUARES = Law(
    "composite-least-squares",
    rates=composite_least_squares,
    promises=promised("true spanned exact", "falls", "settles"),
    parameters={
        **K_GAMMA,
        "weight": Setting(
            "w, of CLPE beside the regression, 1/time; 100 k", scaled(100)
        ),
        "forgetting": Setting(
            "lambda_0 of P, 1/time; 0 forgets nothing", 0.0, "not negative"
        ),
    },
    candidate=composite_level,
    V_inputs=("e", "alpha", "K", "Gamma", "rho", "impulse"),
    V_rate="-e^T KD e - |eta phi_f|^2/(2 w) - lambda tr(eta P^-1 eta^T)/(2 gamma)",
).with_parts(
    FILTERED_FLOW,
    COMMANDED_GAINS,
    covariance(errors_by_impulse, "weight"),
    {
        "states": {
            "impulse": State((2, "N"), lambda context, p: context.alpha * p.information)
        }
    },
)

LAWS = (NORMALISED_GRADIENT, LEAST_SQUARES, COMPOSITE_LEAST_SQUARES)
