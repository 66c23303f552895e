"""Learning at fixes: between them the vehicle steers on its own prediction z.

    z' = theta_hat phi(z) + v,    m' = phi(z),    theta_hat = -alpha,    v as it was flown

At a fix f_k of t_k, y = f_k - z(t_k) is (theta - theta_hat) m, m being taken since the fix before,
as far as phi(z) is phi(x).  Least squares on it, with d = r^2 + m^T P m:

    theta_hat += y (P m)^T / d,    P -= P m (P m)^T / d,    P^-1 += m m^T / r^2
    z += y + (change of theta_hat) n,    m = n,    n = int phi(z) from t_k to now

A fix arrives `latency` after t_k; n is then what was integrated in between, and z is where it had
been if theta_hat and the fix had been known at t_k.  Without latency n = 0.  Where a fix is
missing nothing changes and m goes on.  z(0) counts as a fix without noise.  P is computed in
Joseph's form, A - A m (P m)^T/d + r^2 P m (P m)^T/d^2 with A = P - P m (P m)^T/d, which is the
same and stays right however small r is.

    V  = r^2 tr(eta P^-1 eta^T)/2,    eta = theta + alpha
    V' = 0 between fixes;    V_after - V = -r^2 |eta m|^2/(2 d) <= 0    at a fix with y = eta m

K and Gamma are those of the vehicle, K_D and Gamma_D: Eq. (7) steers, at z.
Source: Ljung 1999, System Identification, section 11.2, recursive least squares.

Ports: fix[2] (length), taken[1], phi_z[N], v_x[2] (length per time) -> alpha[2N] (length per
time), K[2], Gamma[2] (per time), z[2] (length), information[N*N] (P^-1, time per length, squared).
States beside these: P[N*N] (length per time, squared), m[N] (time); of the fix under way
sent[2] (length), waiting[1], z_sent[2] (length), m_sent[N] (time).
"""

from typing import Any, NamedTuple

import numpy as np

from ...equations.block import Block
from ...errors import ScenarioError
from ..reference import multiples
from ..words import where
from .law import Known, Law, Setting, Truth
from .scales import PRIOR, prior, reach


class FixRegressionParameters(NamedTuple):
    """Parameters of the regression, and when fixes are."""

    N: int  # number of basis functions
    noise: float  # r > 0, of y, length
    KD: np.ndarray  # shape (2,), what K is, per time
    GammaD: np.ndarray  # shape (2,), what Gamma is, per time
    between: float  # from one fix to the next, time
    latency: float  # from a fix to its arrival, time
    interval: float = -1.0  # how many were sent and arrived, kept by the integrator


class FixCandidateParameters(NamedTuple):
    """What V measures."""

    N: int  # number of basis functions
    noise: float  # r, length
    theta: np.ndarray  # shape (2, N), length per time


def places(n):
    """Return where P, information, z, m, sent, waiting, z_sent and m_sent begin."""
    P = 2 * n
    z = P + 2 * n * n
    return P, P + n * n, z, z + 2, z + 2 + n, z + 4 + n, z + 5 + n, z + 7 + n


def predict(t, x, u, p, dx):
    """z' = theta_hat phi(z) + v, m' = phi(z), Eq. (1) with theta_hat; all else keeps its value.

    u = fix[2], taken[1], phi_z[N], v_x[2]; states as in `learn`.
    """
    n = p.N
    _, _, z, m, sent, _, _, _ = places(n)
    phi, v = u[3 : 3 + n], u[3 + n : 5 + n]
    for k in range(z):
        dx[k] = 0.0
    for i in range(2):
        dx[z + i] = v[i]
        for k in range(n):
            dx[z + i] -= x[i * n + k] * phi[k]
    for k in range(n):
        dx[m + k] = phi[k]
    for k in range(sent, sent + 5 + n):
        dx[k] = 0.0


def learn(t, x, u, p, new):
    """Least squares on x of Eq. (1) at a fix, Ljung 1999: theta_hat, P, P^-1, z and m as above.

    With latency an odd interval begins with a fix that is sent, an even one with its arrival;
    without, every interval begins with both.  u = fix[2], taken[1], phi_z[N], v_x[2]; states
    alpha[2N], P[N*N], information[N*N], z[2], m[N], sent[2], waiting[1], z_sent[2], m_sent[N].
    """
    n = p.N
    P, information, z, m, sent, waiting, z_sent, m_sent = places(n)
    late = p.latency > 0
    arrives = where(late, 1 - p.interval % 2, 1.0)
    sends = (1 - arrives) * u[2]
    got = arrives * where(late, x[waiting], u[2])
    d = p.noise**2
    for j in range(n):  # P m, for now in the place of the new m
        seen = 0.0
        for k in range(n):
            seen += x[P + j * n + k] * where(late, x[m_sent + k], x[m + k])
        new[m + j] = seen
        d += seen * where(late, x[m_sent + j], x[m + j])
    for i in range(2):
        y = got * where(late, x[sent + i] - x[z_sent + i], u[i] - x[z + i])
        moved = y
        for k in range(n):
            step = y * new[m + k] / d
            new[i * n + k] = x[i * n + k] - step
            moved += step * where(late, x[m + k], 0.0)
        new[z + i] = x[z + i] + moved
    for j in range(n):  # A m, for now in the place of the new m_sent; A = P - P m (P m)^T / d
        left = 0.0
        for k in range(n):
            A = x[P + j * n + k] - new[m + j] * new[m + k] / d
            left += A * where(late, x[m_sent + k], x[m + k])
        new[m_sent + j] = left
    for j in range(n):
        for k in range(n):
            at = j * n + k
            Pm = new[m + j] * new[m + k] / d
            half = new[m_sent + j] * new[m + k] + new[m_sent + k] * new[m + j]
            joseph = (x[P + at] - Pm) - half / (2 * d) + p.noise**2 * Pm / d
            mm = where(late, x[m_sent + j] * x[m_sent + k], x[m + j] * x[m + k])
            new[P + at] = (1 - got) * x[P + at] + got * joseph
            new[information + at] = x[information + at] + got * mm / p.noise**2
    new[waiting] = where(late, sends, 0.0)
    for i in range(2):
        new[sent + i] = u[i]
        new[z_sent + i] = x[z + i]
    for k in range(n):
        new[m_sent + k] = x[m + k]
        new[m + k] = x[m + k] * (1 - where(late, sends, got))


def estimate(t, x, u, p, y):
    """The states alpha and z, K = K_D and Gamma = Gamma_D of Eq. (7), and P^-1.

    y = alpha[2N], K[2], Gamma[2], z[2], information[N*N].
    """
    n = p.N
    _, information, z, _, _, _, _, _ = places(n)
    for k in range(2 * n):
        y[k] = x[k]
    for i in range(2):
        y[2 * n + i] = p.KD[i]
        y[2 * n + 2 + i] = p.GammaD[i]
        y[2 * n + 4 + i] = x[z + i]
    for k in range(n * n):
        y[2 * n + 6 + k] = x[information + k]


def candidate(t, x, u, p, y):
    """V = r^2 tr(eta P^-1 eta^T)/2, as in Eq. (24): u = alpha[2N], information[N*N], y = V[1]."""
    n = p.N
    for i in range(2):
        for j in range(n):
            for k in range(n):
                first, second = p.theta[i, j] + u[i * n + j], p.theta[i, k] + u[i * n + k]
                y[0] += first * u[2 * n + j * n + k] * second * p.noise**2 / 2


def events(p: FixRegressionParameters, t0: float, t1: float) -> np.ndarray:
    """Return the times in (t0, t1] at which a fix is sent or arrives."""
    sent = multiples(p.between, t0, t1)
    if not p.latency > 0:
        return sent
    arrived = multiples(p.between, t0 - p.latency - p.between, t1) + p.latency
    return np.sort(np.concatenate([sent, arrived[(arrived > t0) & (arrived <= t1)]]))


def fix_regression_law(parameters: FixRegressionParameters) -> Block:
    """Make the law."""
    N = parameters.N
    learned = {"alpha": 2 * N, "P": N * N, "information": N * N, "z": 2, "m": N}
    return Block(
        "adaptation",
        update=predict,
        output=estimate,
        jump=learn,
        breakpoints=events,
        inputs={"fix": 2, "taken": 1, "phi_z": N, "v_x": 2},
        outputs={"alpha": 2 * N, "K": 2, "Gamma": 2, "z": 2, "information": N * N},
        states={**learned, "sent": 2, "waiting": 1, "z_sent": 2, "m_sent": N},
        feedthrough=False,
        parameters=parameters,
    )


def block(known: Known) -> Block:
    """Make the law of what is known; its scales are k = mean KD and R, the reach of the track."""
    if known.fixes is None:
        raise ScenarioError(
            'learning.law = "fix-regression": learns at fixes; give localization.interval, the '
            "time from one fix to the next"
        )
    r = known.settings["noise"]
    if r is None:
        r = float(np.hypot(0.1 * reach(known), np.sqrt(2) * known.fixes.noise))
    fixes = (known.fixes.between, known.fixes.latency)
    return fix_regression_law(FixRegressionParameters(known.N, r, known.KD, known.GammaD, *fixes))


def starts(known: Known) -> dict[str, Any]:
    """Return P(0) and its inverse."""
    one, variance = np.eye(known.N), prior(known) ** 2
    return {"P": one * variance, "information": one / variance}


def V(p: Any, truth: Truth) -> Block:
    """Make V."""
    return Block(
        "lyapunov",
        output=candidate,
        inputs={"alpha": 2 * p.N, "information": p.N * p.N},
        outputs={"V": 1},
        parameters=FixCandidateParameters(p.N, p.noise, truth.theta),
    )


LAW = Law(
    "fix-regression",
    promise="V does not rise at exact fixes, as far as phi at the prediction is phi at the vehicle",
    needs="fixes, localization.interval; steers on the prediction in between",
    block=block,
    V=V,
    settings={
        "prior": PRIOR,
        "noise": Setting(
            None, "positive", "r of the regression, length; ((0.1 R)^2 + 2 noise^2)^0.5"
        ),
    },
    alpha_by_gain=False,
    starts=starts,
    made_of=(
        "vehicle.feedback",
        "vehicle.feedforward",
        "vehicle.position",
        "localization.interval",
        "localization.latency",
        "localization.noise",
    ),
    at_fixes=True,
    says="0; at an exact fix V falls by r^2 |eta m|^2/(2 (r^2 + m^T P m))",
)
