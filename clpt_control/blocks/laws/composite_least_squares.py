"""Composite least squares: CLPE and a filtered regression drive one estimate.

    theta_hat' = P (gamma phi e^T + phi_f eps^T / r^2),    theta_hat = -alpha^T
    P'         = -P phi_f phi_f^T P / r^2
    s'         = -gamma e phi^T

phi_f and eps = F_f - theta_hat phi_f are those of `filtered_flow`.  P is N x N, symmetric, one
for both axes: P(0) holds the prior variances, and a function whose prior is 0 keeps its
parameter.  P^-1 = P(0)^-1 + int phi_f phi_f^T/r^2 is never formed: s, the impulse of CLPE,
with s(0) = alpha(0) P(0)^-1 keeps s + theta P(0)^-1 = eta P^-1, eta = theta + alpha.
gamma = w/r^2 with a weight w.  K and Gamma follow Eqs. (22)-(23), or are held.
Source: Slotine and Li 1989, Automatica 25(4), Composite adaptive control of robot manipulators.

    V  = (|e|^2 + tr(eta P^-1 eta^T)/gamma + |K - KD|^2/gamma_K + |Gamma - GammaD|^2/gamma_Gamma)/2
    V' = -e^T KD e - |eta phi_f|^2/(2 w),    where each held parameter is true

Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N] (length
per time), K[2], Gamma[2] (per time), impulse[2N] (s, time per length),
P[N*N] (length per time, squared), phi_f[N], q[2] (length per time), the states.
"""

from typing import Any, NamedTuple

import numpy as np

from ...errors import ScenarioError
from ..block import Block
from ..lyapunov import known_flow, weighed
from .filtered_flow import filter_rates, filter_starts, mean_feedback, reach, unexplained
from .law import Known, Law, Setting, Truth, adapt_feedback, adapt_feedforward


class CompositeLeastSquaresParameters(NamedTuple):
    """Parameters of composite least squares."""

    N: int  # number of basis functions
    weight: float  # w > 0 of CLPE beside the regression
    noise: float  # r > 0, of the regression, length per square root of time
    filter: float  # l > 0, per time
    information: np.ndarray  # shape (N,), 1/prior^2, 0 for what is held, (time per length) squared
    gain_K: float  # of Eq. (22), per length squared per time squared; 0 holds K
    gain_Gamma: float  # of Eq. (23), the same; 0 holds Gamma


class CandidateParameters(NamedTuple):
    """What V measures and its weights."""

    N: int  # number of basis functions
    weight: float  # w
    noise: float  # r, length per square root of time
    information: np.ndarray  # shape (N,), (time per length) squared
    gain_K: np.ndarray  # shape (2,)
    gain_Gamma: np.ndarray  # shape (2,)
    theta: np.ndarray  # shape (2, N), length per time
    KD: np.ndarray  # shape (2,), per time
    GammaD: np.ndarray  # shape (2,), per time


def composite_least_squares(t, x, u, p, dx):
    """alpha' of Eq. (21) with P and the regression, K', Gamma' of Eqs. (22)-(23), s', P', filter.

    u = e[2], phi_x[N], z[2], zc[2], x[2], v_x[2]; states alpha[2N], K[2], Gamma[2],
    impulse[2N] (s), P[N*N], phi_f[N], q[2].
    """
    n = p.N
    e, phi, z, zc = u[0:2], u[2 : 2 + n], u[2 + n : 4 + n], u[4 + n : 6 + n]
    position, v = u[6 + n : 8 + n], u[8 + n : 10 + n]
    s, P = 2 * n + 4, 4 * n + 4
    at = P + n * n
    phi_f, precision, gamma = x[at : at + n], 1 / p.noise**2, p.weight / p.noise**2
    for j in range(n):  # P phi and P phi_f, for now in the places of alpha'
        driven, seen = 0.0, 0.0
        for k in range(n):
            driven += x[P + j * n + k] * phi[k]
            seen += x[P + j * n + k] * phi_f[k]
        dx[j] = driven
        dx[n + j] = seen
    for j in range(n):
        for k in range(n):
            dx[P + j * n + k] = -(dx[n + j] * dx[n + k]) * precision
    first = unexplained(x[0:n], phi_f, position[0], x[at + n], p.filter, n)
    second = unexplained(x[n : 2 * n], phi_f, position[1], x[at + n + 1], p.filter, n)
    for j in range(n):
        driven, seen = gamma * dx[j], precision * dx[n + j]
        dx[j] = -driven * e[0] - seen * first
        dx[n + j] = -driven * e[1] - seen * second
    for i in range(2):
        for k in range(n):
            dx[s + i * n + k] = -gamma * e[i] * phi[k]
        dx[2 * n + i] = adapt_feedback(p.gain_K, e[i], z[i])
        dx[2 * n + 2 + i] = adapt_feedforward(p.gain_Gamma, e[i], zc[i])
    filter_rates(dx, at, x, phi, position, v, p.filter, n)


def candidate(t, x, u, p, y):
    """V of Eq. (24) with tr(eta P^-1 eta^T) = sum eta (s + theta P(0)^-1) for |eta|^2.

    u = e[2], alpha[2N], K[2], Gamma[2], impulse[2N] (s); y = V[1].
    """
    n = p.N
    known_flow(t, x, u, p, y)
    for i in range(2):
        for k in range(n):
            eta = p.theta[i, k] + u[2 + i * n + k]
            share = u[6 + 2 * n + i * n + k] + p.theta[i, k] * p.information[k]
            y[0] += eta * share * p.noise**2 / (2 * p.weight)


def composite_least_squares_law(parameters: CompositeLeastSquaresParameters) -> Block:
    """Make composite least squares."""
    N = parameters.N
    return Block(
        "adaptation",
        update=composite_least_squares,
        inputs={"e": 2, "phi_x": N, "z": 2, "zc": 2, "x": 2, "v_x": 2},
        states={
            "alpha": 2 * N,
            "K": 2,
            "Gamma": 2,
            "impulse": 2 * N,
            "P": N * N,
            "phi_f": N,
            "q": 2,
        },
        parameters=parameters,
    )


def _prior(known: Known) -> np.ndarray:
    """Return the prior standard deviation of each parameter, shape (N,), length per time."""
    one, each = known.settings["prior"], known.settings["priors"]
    table = "learning.composite_least_squares"
    if each is None:
        return np.full(known.N, one or 0.3 * mean_feedback(known) * reach(known))
    if one is not None:
        raise ScenarioError(f"{table}.priors: give either prior or priors, one of the two")
    if len(each) != known.N:
        raise ScenarioError(
            f"{table}.priors: has {len(each)} numbers; must be one for each of the {known.N} "
            "functions, 0 to hold its parameter"
        )
    return np.asarray(each, dtype=float)


def block(known: Known) -> Block:
    """Make the law of what is known; its scales are k = mean KD and R, the reach of the track."""
    own, k, prior = known.settings, mean_feedback(known), _prior(known)
    r = own["noise"]
    if r is None:
        r = 0.1 * reach(known) * np.sqrt(k)
    information = np.divide(1.0, prior**2, out=np.zeros(known.N), where=prior > 0)
    return composite_least_squares_law(
        CompositeLeastSquaresParameters(
            known.N,
            own["weight"],
            r,
            own["filter"] or 2 * k,
            information,
            known.gains.feedback,
            known.gains.feedforward,
        )
    )


def starts(known: Known) -> dict[str, Any]:
    """Return P(0), s(0) and the filter's start."""
    p, prior = block(known).parameters, _prior(known)
    return {
        "P": np.diag(prior**2),
        "impulse": known.alpha * p.information,
        **filter_starts(known, p.filter),
    }


def V(p: Any, truth: Truth) -> Block:
    """Make V, each error weighed by its own gain."""
    w = weighed((1.0, p.gain_K, p.gain_Gamma), *truth)
    return Block(
        "lyapunov",
        output=candidate,
        inputs={"e": 2, "alpha": 2 * p.N, "K": 2, "Gamma": 2, "impulse": 2 * p.N},
        outputs={"V": 1},
        parameters=CandidateParameters(
            p.N,
            p.weight,
            p.noise,
            p.information,
            w.gain_K,
            w.gain_Gamma,
            w.theta,
            w.KD,
            w.GammaD,
        ),
    )


def keeps(s: Any, p: Any, theta: Any) -> dict[str, Any]:
    """Return what the states are at all times: P = P^T, eta = (s + theta P(0)^-1) P, F_f."""
    P = np.triu(s["P"].reshape(p.N, p.N))
    P = P + np.triu(P, 1).T
    alpha = (s["impulse"].reshape(2, p.N) + theta * p.information) @ P - theta
    return {"P": P, "alpha": alpha, "q": p.filter * s["x"] - theta @ s["phi_f"]}


def gains(s: Any, p: Any, theta: Any) -> Any:
    """Return V' + e^T KD e = -|eta phi_f|^2/(2 w)."""
    return -sum(((theta + s["alpha"].reshape(2, p.N)) @ s["phi_f"]) ** 2) / (2 * p.weight)


LAW = Law(
    "composite-least-squares",
    promise="CLPE goes to zero, and alpha to -theta faster the more the track has shown",
    needs="the commanded velocity; K and Gamma held: adapted by learning.gain, they delay it",
    block=block,
    V=V,
    settings={
        "prior": Setting(
            None,
            "positive",
            "standard deviation of each theta, length/time; 0.3 k R, mean KD times track's reach",
        ),
        "priors": Setting(None, "row", "in place of prior: one a function, 0 to hold it"),
        "noise": Setting(None, "positive", "r of the regression, length/time^0.5; 0.1 R k^0.5"),
        "filter": Setting(None, "positive", "pole l of the filter, 1/time; 2 k"),
        "weight": Setting(100.0, "positive", "w, of CLPE beside the regression, no unit"),
    },
    gain=1.0,
    alpha_by_gain=False,
    starts=starts,
    keeps=keeps,
    gains=gains,
    cone="P",
    says="-e^T KD e - |eta phi_f|^2/(2 w)",
    made_of=("vehicle.feedback", "vehicle.position", "learning.parameters"),
)
