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

from functools import partial
from typing import Any

import numpy as np

from ..lyapunov import level
from .covariance import (
    KEYS,
    PARAMETERS,
    STATES,
    covariance_kept,
    covariance_losses,
    covariance_rates,
    refuses,
)
from .filtered_flow import TAKES, shared_rates, unexplained
from .known import Truth
from .law import Law, Setting
from .scales import times_k


def least_squares(t, x, u, p):
    """alpha' = -P phi_f eps^T/r^2 in place of Eq. (21), P', rho'."""
    seen = x.P @ x.phi_f
    alpha = -np.outer(unexplained(x, u, p), seen) / p.noise**2
    return {"alpha": alpha, **covariance_rates(x, p, seen), **shared_rates(x, u, p)}


def candidate(t, x, u, p):
    """V of Eq. (24) with r^2 tr(eta P^-1 eta^T)/k for |eta|^2, eta P^-1 = rho eta(0) P(0)^-1."""
    eta, over = p.theta + u.alpha, (p.theta + p.alpha_0) * p.information * u.rho
    return {"V": level(u.e, u, p) + p.noise**2 / (2 * p.rate) * np.sum(eta * over)}


def errors_over_P(s: Any, p: Any, truth: Truth) -> Any:
    """Return eta P^-1 = rho eta(0) P(0)^-1, shape (2, N)."""
    return s["rho"] * (truth.theta + p.alpha_0) * p.information


def keeps(s: Any, p: Any, truth: Truth) -> dict[str, Any]:
    """Return what the states are: P = P^T, eta = rho eta(0) P(0)^-1 P, F_f = theta phi_f."""
    return covariance_kept(s, p, truth, errors_over_P(s, p, truth))


def losses(s: Any, p: Any, truth: Truth) -> list[tuple]:
    """Return |eta phi_f|^2/(2 k), r^2 lambda tr(eta P^-1 eta^T)/(2 k), what K and Gamma lose."""
    return covariance_losses(s, p, truth, errors_over_P(s, p, truth), p.rate)


def push(s: Any, p: Any, truth: Truth) -> Any:
    """Return e^T eta phi."""
    return (s["x"] - s["z"]) @ ((truth.theta + s["alpha"]) @ s["phi_x"])


LAW = Law(
    "least-squares",
    promise="alpha goes to -theta where the track excites, whatever K, Gamma and CLPE do; CLPE is "
    "as small in the mean as the flow is well learned",
    needs="the commanded velocity",
    rates=least_squares,
    parameters={
        **PARAMETERS,
        "forgetting": Setting(None, "not negative", "lambda_0 of P, 1/time; 0.02 k", times_k(0.02)),
        "alpha_0": lambda known: known.alpha,
    },
    keys=KEYS,
    takes=TAKES,
    states=STATES,
    candidate=candidate,
    measures=("e", "alpha", "K", "Gamma", "rho"),
    shares=("rate", "noise", "information", "alpha_0"),
    refuses=partial(refuses, "least_squares"),
    gain=1.0,
    keeps=keeps,
    losses=losses,
    push=push,
    over=errors_over_P,
    cones=("P", "Q_1", "Q_2"),
    says="-e^T KD e + e^T eta phi - |eta phi_f|^2/(2 k) - r^2 lambda tr(eta P^-1 eta^T)/(2 k)",
    comes_to="tr(eta P^-1 eta^T) never rises; in the mean |e| <= |eta phi| over the least of KD",
)
