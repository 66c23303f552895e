"""Composite least squares: CLPE and a filtered regression drive one estimate.

    theta_hat' = P (gamma phi e^T + phi_f eps^T / r^2),    theta_hat = -alpha^T
    s'         = -gamma e phi^T - lambda s

phi_f and eps = F_f - theta_hat phi_f are those of `regressions`, P, lambda and rho those of
`covariance`, gamma = w/r^2 with a weight w.  P^-1 is never formed: s, the impulse of CLPE, with
s(0) = alpha(0) P(0)^-1 keeps s + rho theta P(0)^-1 = eta P^-1, eta = theta + alpha.  K and Gamma
are those of `commanded_gains`, or are held.
Source: Slotine and Li 1989, Automatica 25(4), Composite adaptive control of robot manipulators.

    V  = (|e|^2 + tr(eta P^-1 eta^T)/gamma + |K - KD|^2/gamma_K + |Gamma - GammaD|^2/gamma_Gamma)/2
    V' = -e^T KD e - |eta phi_f|^2/(2 w) - lambda tr(eta P^-1 eta^T)/(2 gamma)
         - what K and Gamma lose,    where each held parameter is true

Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N] (length
per time), K[2], Gamma[2] (per time), the states of `regressions` and of `covariance`, and
impulse[2N] (s, time per length).
"""

from typing import Any

import numpy as np

from .commanded_gains import COMMANDED_GAINS, gain_rates
from .covariance import covariance, covariance_rates, forgetting, level_over_P
from .known import Setting, Truth, scaled
from .law import HELD, Law, State, promised
from .regressions import FILTERED_FLOW, filter_rates, unexplained


def composite_least_squares(t, x, u, p):
    """alpha' of Eq. (21) with P and the regression, P', rho', s'."""
    gamma, seen = p.weight / p.noise**2, x.P @ x.phi_f
    by_error, by_flow = gamma * u.e, unexplained(x, u, p) / p.noise**2
    return {
        "alpha": -np.outer(by_error, x.P @ u.phi_x) - np.outer(by_flow, seen),
        "impulse": -np.outer(by_error, u.phi_x) - forgetting(x, p) * x.impulse,
        **covariance_rates(x, p, seen),
        **filter_rates(x, u, p),
        **gain_rates(x, u, p),
    }


def candidate(t, x, u, p):
    """V of Eq. (24) with tr(eta P^-1 eta^T)/gamma for |eta|^2."""
    over = errors_over_P({"rho": u.rho, "impulse": u.impulse}, p, p)
    return level_over_P(u, p, over, p.weight)


def errors_over_P(s: Any, p: Any, truth: Truth) -> Any:
    """Return eta P^-1 = s + rho theta P(0)^-1, shape (2, N)."""
    return s["impulse"] + s["rho"] * truth.theta * p.information


LAW = Law(
    "composite-least-squares",
    promise="CLPE goes to zero, and alpha to -theta faster the more the track has shown",
    rates=composite_least_squares,
    promises=promised("true spanned exact", "falls", "settles"),
    parameters={
        **HELD,
        "weight": Setting("w, of CLPE beside the regression, 1/time; 100 k", scaled(100)),
        "forgetting": Setting("lambda_0 of P, 1/time; 0 forgets nothing", 0.0, "not negative"),
    },
    candidate=candidate,
    measures=("e", "alpha", "K", "Gamma", "rho", "impulse"),
    says="-e^T KD e - |eta phi_f|^2/(2 w) - lambda tr(eta P^-1 eta^T)/(2 gamma)",
).with_parts(
    FILTERED_FLOW,
    COMMANDED_GAINS,
    covariance(errors_over_P, "weight"),
    {"states": {"impulse": State((2, "N"), lambda known, p: known.alpha * p.information)}},
)
