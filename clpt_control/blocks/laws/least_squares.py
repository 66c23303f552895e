"""Recursive least squares on the filtered regression, forgetting with bounded gain.

    theta_hat' = P phi_f eps^T / r^2,    theta_hat = -alpha^T

phi_f and eps are those of `regressions`, P that of `covariance`.  The flow is learned from
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
per time), K[2], Gamma[2] (per time), the states of `regressions` and of `covariance`.
"""

from typing import Any

import numpy as np

from .commanded_gains import COMMANDED_GAINS, gain_rates
from .covariance import covariance, covariance_rates, level_over_P
from .known import Setting, Truth, scaled
from .law import HELD, Law, promised
from .regressions import FILTERED_FLOW, filter_rates, unexplained


def least_squares(t, x, u, p):
    """alpha' = -P phi_f eps^T/r^2 in place of Eq. (21), P', rho'."""
    seen = x.P @ x.phi_f
    alpha = -np.outer(unexplained(x, u, p), seen) / p.noise**2
    return {
        "alpha": alpha,
        **covariance_rates(x, p, seen),
        **filter_rates(x, u, p),
        **gain_rates(x, u, p),
    }


def candidate(t, x, u, p):
    """V of Eq. (24) with r^2 tr(eta P^-1 eta^T)/k for |eta|^2, eta P^-1 = rho eta(0) P(0)^-1."""
    return level_over_P(u, p, errors_over_P({"rho": u.rho}, p, p), p.rate)


def errors_over_P(s: Any, p: Any, truth: Truth) -> Any:
    """Return eta P^-1 = rho eta(0) P(0)^-1, shape (2, N)."""
    return s["rho"] * (truth.theta + p.alpha_0) * p.information


LAW = Law(
    "least-squares",
    promise="alpha goes to -theta where the track excites, whatever K, Gamma and CLPE do; CLPE is "
    "as small in the mean as the flow is well learned",
    rates=least_squares,
    promises=(
        *promised("spanned exact", "estimate"),
        *promised("true spanned exact", "mean square"),
    ),
    parameters={
        **HELD,
        "forgetting": Setting("lambda_0 of P, 1/time; 0.02 k", scaled(0.02), "not negative"),
        "alpha_0": lambda known: known.alpha,
    },
    candidate=candidate,
    measures=("e", "alpha", "K", "Gamma", "rho"),
    push=lambda s, p, truth: (s["x"] - s["z"]) @ ((truth.theta + s["alpha"]) @ s["phi_x"]),
    says="-e^T KD e + e^T eta phi - |eta phi_f|^2/(2 k) - r^2 lambda tr(eta P^-1 eta^T)/(2 k)",
    comes_to="tr(eta P^-1 eta^T) never rises; in the mean |e| <= |eta phi| over the least of KD",
).with_parts(FILTERED_FLOW, COMMANDED_GAINS, covariance(errors_over_P, "rate"))
