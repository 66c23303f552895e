"""Laws of the paper: learned flow, known flow, and known flow with a Kalman filter (Remark 3.2)."""

from typing import Any

import numpy as np

from .law import (
    GAIN_STATES,
    K_GAMMA,
    NOISE,
    PRIOR,
    Law,
    Setting,
    State,
    Truth,
    adapt_gains,
    promised,
)
from .regressions import FILTERED_FLOW, filter_rates, filtered_flow

# --- learned flow ----------------------------------------------------------------------------


def learned_flow(t, x, u, p):
    """The paper's learned-flow law, Eqs. (21)-(23): alpha, K and Gamma adapt.

        alpha' = -gamma e phi(x)^T                    Eq. (21)
        K'     = -gamma z e                           Eq. (22)
        Gamma' =  gamma zc e                          Eq. (23)

    alpha converges to -theta if the track excites the flow.  V of Eq. (24) has V' = -e^T KD e, so e
    goes to zero, Theorem 3.2.  Source: Cho, Zhang, Edwards 2016, section III.

    Ports: e[2] (length), phi_x[N], z[2], zc[2] (length) -> alpha[2N] (length per time), K[2],
    Gamma[2] (per time), the states.  gamma is one number in the paper, or one each.
    """
    return driven_by(u.e, u, p)


def driven_by(e, u, p):
    """Return the rates of Eqs. (21)-(23), driven by e."""
    return {"alpha": np.outer(-p.gain * e, u.phi_x), **adapt_gains(p, e, u)}


LEARNED_FLOW = Law(
    "learned-flow",
    needs="nothing but a gain",
    rates=learned_flow,
    one_gain=True,
    promises=(
        *promised("true spanned exact", "falls", "settles"),
        *promised("true exact", "mean square"),
    ),
)


# --- known flow ------------------------------------------------------------------------------


def known_flow(t, x, u, p):
    """The known-flow law, Eqs. (14)-(15): K and Gamma adapt, an estimate of the flow is given.

        alpha  = alpha_M
        K'     = -gamma z e                           Eq. (14)
        Gamma' =  gamma zc e                          Eq. (15)

    With alpha = alpha_M the rate of CLPE is Eq. (11).  theta_hat, the estimate of theta, is given
    to the injection, Eq. (13); CLPE is as small as theta_hat is good (Remark 3.3).  V of Eq. (17)
    has V' = -e^T KD e + e^T (theta - theta_hat) phi, Theorem 3.1: in the mean square |e| is at most
    |(theta - theta_hat) phi| over the least of KD, and e goes to zero if theta_hat = theta.
    Source: Cho, Zhang, Edwards 2016, section III.

    Ports: e[2] (length), phi_x[N], z[2], zc[2] (length) -> K[2], Gamma[2] (per time), the states,
    and alpha[2N] (length per time), constant.
    """
    return adapt_gains(p, u.e, u)


def known_flow_output(t, x, u, p):
    """alpha = alpha_M, in addition to K and Gamma of Eqs. (14)-(15)."""
    return {"alpha": p.alpha_M}


KNOWN_FLOW = Law(
    "known-flow",
    needs="an estimate of theta, learning.theta_estimate",
    rates=known_flow,
    parameters={**K_GAMMA, "alpha_M": "alpha_M"},
    one_gain=True,
    promises=promised("true exact", "mean square"),
    states=GAIN_STATES,
    output=known_flow_output,
    outputs={"alpha": (2, "N")},
)


# --- known flow, estimated by a filter -------------------------------------------------------


def kalman_flow(t, x, u, p):
    """The known-flow law fed by a Kalman-Bucy filter of theta while it runs, Remark 3.2.

        theta_hat' = P phi_f eps^T / r^2,             eps = F_f - theta_hat phi_f
        P'         = w^2 I - P phi_f phi_f^T P / r^2
        alpha = alpha_M,  K' = -gamma z e,  Gamma' = gamma zc e         Eqs. (14)-(15)

    phi_f and F_f are phi and the flow through one filter (`regressions`), computed from positions
    and the commanded velocity.  theta_hat goes to the injection, Eq. (13).  P is N x N, symmetric,
    one for both axes: it starts at the prior variance, and w is the random walk of each parameter,
    0 for constant parameters.  CLPE is no input of the filter.
    Source: Kalman and Bucy 1961, New results in linear filtering and prediction theory, Journal of
    Basic Engineering 83(1).

    V of Eq. (17) has V' = -e^T KD e + e^T (theta - theta_hat) phi, Theorem 3.1.  The norm of the
    estimate's error d = theta_hat - theta weighted by P^-1 is non-increasing:
        (d P^-1 d^T)' = -|d phi_f|^2/r^2 - w^2 |d P^-1|^2

    Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N],
    constant, theta_hat[2N] (length per time), K[2], Gamma[2] (per time), P[N*N] (length per time,
    squared), phi_f[N], q[2] (length per time), the states.
    """
    P_phi = x.P @ x.phi_f
    eps = filtered_flow(x, u, p) - x.theta_hat @ x.phi_f
    return {
        **adapt_gains(p, u.e, u),
        "theta_hat": np.outer(eps, P_phi) / p.noise**2,
        "P": p.walk**2 * np.eye(len(x.P)) - np.outer(P_phi, P_phi) / p.noise**2,
        **filter_rates(x, u, p),
    }


def error_growth(s: Any, p: Any, truth: Truth) -> Any:
    """Return (d P^-1 d^T)' = -|d phi_f|^2/r^2 - w^2 |d P^-1|^2, both axes together."""
    off = (s["theta_hat"] - truth.theta) @ s["phi_f"]
    return -np.sum(off**2) / p.noise**2 - p.walk**2 * np.sum(s["d P^-1"] ** 2)


KALMAN_FLOW = Law(
    "kalman-flow",
    needs="the commanded velocity; learning.theta_estimate, if given, is where it starts",
    rates=kalman_flow,
    parameters={
        **K_GAMMA,
        "alpha_M": "alpha_M",
        "noise": NOISE,
        "walk": Setting(
            "w of each theta, length/time^1.5; 0.03 of prior, times k^0.5",
            lambda context: 0.03 * context.prior * np.sqrt(context.k),
            "not negative",
        ),
    },
    keys={"prior": PRIOR},
    states={
        **GAIN_STATES,
        "theta_hat": State((2, "N"), lambda context, p: context.theta_estimate),
        "P": State(("N", "N"), lambda context, p: context.prior**2 * np.eye(context.N)),
    },
    output=known_flow_output,
    outputs={"alpha": (2, "N")},
    error_growth=error_growth,
    between_fixes=lambda P, time, p: P + time * p.walk**2 * np.eye(len(P)),
    promises=(
        *promised("true exact", "mean square"),
        *promised("spanned exact", "estimate"),
    ),
    semidefinite=("P",),
    driving_estimate="theta_hat",
    V_rate="-e^T KD e + e^T eta phi, (eta P^-1 eta^T)' <= -|eta phi_f|^2/r^2, "
    "eta = theta - theta_hat",
).with_parts(FILTERED_FLOW)

LAWS = (LEARNED_FLOW, KNOWN_FLOW, KALMAN_FLOW)
