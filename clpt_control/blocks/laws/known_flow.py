"""The known-flow law, Eqs. (14)-(15): K and Gamma adapt, the flow is known by other means.

    alpha  = alpha_M
    K'     = -gamma z e                           Eq. (14)
    Gamma' =  gamma zc e                          Eq. (15)

theta_hat, the estimate of theta, is given to the injection, Eq. (13).  V of Eq. (17) then has
V' = -e^T KD e + e^T (theta - theta_hat) phi, Theorem 3.1: in the mean square |e| is at most
|(theta - theta_hat) phi| over the least of KD, and goes to zero where theta_hat is theta.
Source: Cho, Zhang, Edwards 2016, section III.

Ports: e[2] (length), phi_x[N], z[2], zc[2] (length) -> K[2], Gamma[2] (per time), the states,
and alpha[2N] (length per time), constant.
"""

from .law import HELD, Law, State, adapt_gains, promised


def known_flow(t, x, u, p):
    """K' and Gamma' of Eqs. (14)-(15)."""
    return adapt_gains(p, u.e, u.z, u.zc)


def known_flow_output(t, x, u, p):
    """alpha = alpha_M, beside K and Gamma of Eqs. (14)-(15)."""
    return {"alpha": p.alpha_M}


LAW = Law(
    "known-flow",
    promise="in the mean, CLPE at most the error of the given flow over the least of KD "
    "(Theorem 3.1)",
    needs="an estimate of theta, learning.theta_estimate",
    rates=known_flow,
    parameters={**HELD, "alpha_M": "alpha_M"},
    one_gain=True,
    promises=promised("true exact", "mean square"),
    states={"K": State(2), "Gamma": State(2)},
    output=known_flow_output,
    makes={"alpha": (2, "N")},
)
