"""The known-flow law fed by a Kalman-Bucy filter of theta while it runs, Remark 3.2.

    theta_hat' = P phi_f eps^T / r^2,             eps = F_f - theta_hat phi_f
    P'         = w^2 I - P phi_f phi_f^T P / r^2
    alpha = alpha_M,  K' = -gamma z e,  Gamma' = gamma zc e         Eqs. (14)-(15)

phi_f and F_f are phi and the flow through one filter (`filtered_flow`), made of positions and the
commanded velocity.  theta_hat goes to the injection, Eq. (13).  P is N x N, symmetric, one for
both axes: it starts at the prior variance, and w is the walk of each parameter, 0 for a flow
whose parameters stay.  The filter never sees CLPE.
Source: Kalman and Bucy 1961, New results in linear filtering and prediction theory, Journal of
Basic Engineering 83(1).

V of Eq. (17) has V' = -e^T KD e + e^T (theta - theta_hat) phi, Theorem 3.1; the estimate's
error d = theta_hat - theta never grows in the norm that P weighs it by:
    (d P^-1 d^T)' = -|d phi_f|^2/r^2 - w^2 |d P^-1|^2

Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N], constant,
theta_hat[2N] (length per time), K[2], Gamma[2] (per time), P[N*N] (length per time, squared),
phi_f[N], q[2] (length per time), the states.
"""

from typing import Any, NamedTuple

import numpy as np

from ...equations.block import Block
from .commanded_gains import symmetric
from .filtered_flow import filter_kept, filter_rates, filter_starts, filtered_flow
from .known_flow import V
from .law import Known, Law, Setting, Truth, adapt_feedback, adapt_feedforward
from .scales import FILTER, NOISE, PRIOR, mean_feedback, noise, prior


class KalmanFlowParameters(NamedTuple):
    """Parameters of the known-flow law with a filter of theta."""

    N: int  # number of basis functions
    gain_K: float  # of Eq. (14), per length squared per time squared; 0 holds K
    gain_Gamma: float  # of Eq. (15), the same; 0 holds Gamma
    alpha_M: np.ndarray  # shape (2, N), what alpha stays at, length per time
    noise: float  # r > 0, of the regression, length per square root of time
    walk: float  # w >= 0 of each parameter, length per time per square root of time
    filter: float  # l > 0, per time


def kalman_flow(t, x, u, p, dx):
    """K' and Gamma' of Eqs. (14)-(15), theta_hat', P' and the filter.

    u = e[2], phi_x[N], z[2], zc[2], x[2], v_x[2]; states K[2], Gamma[2], theta_hat[2N], P[N*N],
    phi_f[N], q[2].
    """
    n = p.N
    e, phi, z, zc = u[0:2], u[2 : 2 + n], u[2 + n : 4 + n], u[4 + n : 6 + n]
    position, v = u[6 + n : 8 + n], u[8 + n : 10 + n]
    P, at = 4 + 2 * n, 4 + 2 * n + n * n
    phi_f, precision = x[at : at + n], 1 / p.noise**2
    for j in range(n):  # P phi_f, for now in the place of theta_hat'
        seen = 0.0
        for k in range(n):
            seen += x[P + j * n + k] * phi_f[k]
        dx[4 + j] = seen
    for j in range(n):
        for k in range(n):
            dx[P + j * n + k] = -(dx[4 + j] * dx[4 + k]) * precision
        dx[P + j * n + j] += p.walk**2
    first = filtered_flow(position[0], x[at + n], p.filter)
    second = filtered_flow(position[1], x[at + n + 1], p.filter)
    for k in range(n):
        first -= x[4 + k] * phi_f[k]
        second -= x[4 + n + k] * phi_f[k]
    for j in range(n):
        seen = precision * dx[4 + j]
        dx[4 + j] = seen * first
        dx[4 + n + j] = seen * second
    for i in range(2):
        dx[i] = adapt_feedback(p.gain_K, e[i], z[i])
        dx[2 + i] = adapt_feedforward(p.gain_Gamma, e[i], zc[i])
    filter_rates(dx, at, x, phi, position, v, p.filter, n)


def kalman_flow_output(t, x, u, p, y):
    """alpha = alpha_M and the states, Eqs. (13)-(15).

    y = alpha[2N], K[2], Gamma[2], theta_hat[2N], P[N*N], phi_f[N], q[2].
    """
    n = p.N
    for i in range(2):
        for k in range(n):
            y[i * n + k] = p.alpha_M[i, k]
    for j in range(6 + 3 * n + n * n):
        y[2 * n + j] = x[j]


def kalman_flow_law(parameters: KalmanFlowParameters) -> Block:
    """Make the known-flow law with a filter of theta."""
    N = parameters.N
    states = {"K": 2, "Gamma": 2, "theta_hat": 2 * N, "P": N * N, "phi_f": N, "q": 2}
    return Block(
        "adaptation",
        update=kalman_flow,
        output=kalman_flow_output,
        inputs={"e": 2, "phi_x": N, "z": 2, "zc": 2, "x": 2, "v_x": 2},
        outputs={"alpha": 2 * N, **states},
        states=states,
        feedthrough=False,
        parameters=parameters,
    )


def block(known: Known) -> Block:
    """Make the law of what is known; its scales are k = mean KD and R, the reach of the track."""
    own, k = known.settings, mean_feedback(known)
    walk = own["walk"]
    if walk is None:
        walk = 0.03 * prior(known) * np.sqrt(k)
    return kalman_flow_law(
        KalmanFlowParameters(
            known.N,
            known.gains.feedback,
            known.gains.feedforward,
            known.alpha_M,
            noise(known),
            walk,
            own["filter"] or 2 * k,
        )
    )


def starts(known: Known) -> dict[str, Any]:
    """Return theta_hat(0), given or alpha_M, P(0) and the filter's start."""
    return {
        "theta_hat": known.theta_estimate,
        "P": prior(known) ** 2 * np.eye(known.N),
        **filter_starts(known, block(known).parameters.filter),
    }


def keeps(s: Any, p: Any, truth: Truth) -> dict[str, Any]:
    """Return what the states are at all times: P = P^T, F_f = theta phi_f."""
    return {"P": symmetric(s["P"], p.N), **filter_kept(s, p, truth)}


def gains(s: Any, p: Any, truth: Truth) -> Any:
    """Return (d P^-1 d^T)' = -|d phi_f|^2/r^2 - w^2 |d P^-1|^2, both axes together."""
    off = (s["theta_hat"].reshape(2, p.N) - truth.theta) @ s["phi_f"]
    return -sum(off**2) / p.noise**2 - p.walk**2 * sum(s["d P^-1"].ravel() ** 2)


LAW = Law(
    "kalman-flow",
    promise="CLPE as small as the error of the flow that a Kalman filter finds on the way "
    "(Theorem 3.1)",
    needs="the commanded velocity; learning.theta_estimate, if given, is where it starts",
    block=block,
    V=V,
    settings={
        "prior": PRIOR,
        "noise": NOISE,
        "walk": Setting(
            None, "not negative", "w of each theta, length/time^1.5; 0.03 of prior, times k^0.5"
        ),
        "filter": FILTER,
    },
    gain=1.0,
    alpha_by_gain=False,
    makes_estimate=True,
    starts=starts,
    keeps=keeps,
    gains=gains,
    cones=("P",),
    says="(d P^-1 d^T)' <= -|d phi_f|^2/r^2, d = theta_hat - theta",
    made_of=(
        "vehicle.feedback",
        "vehicle.position",
        "learning.theta_estimate",
        "model.parameters",
    ),
)
