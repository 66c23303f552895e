"""Laws that remember the track: composite memory, concurrent learning, DREM, and learning at fixes.

Each law's page is the docstring of its rates; phi_f, F_f, the memory, and the rates of K and Gamma
are those of `regressions`.
"""

from typing import Any

import numpy as np

from ...base.errors import ScenarioError
from ...engine.model.declaration import Each, multiples
from .law import (
    GAINS,
    K_GAMMA,
    MEMORY,
    PRIOR,
    Law,
    Setting,
    State,
    adapt_gains,
    promised,
    scaled,
)
from .regressions import (
    COMMANDED_GAINS,
    FILTERED_FLOW,
    filter_rates,
    filtered_flow,
    gain_rates,
    memory,
    memory_rates,
    pulling_memory,
)

# --- a memory --------------------------------------------------------------------------------


def flow_memory_rates(x, u, p):
    """Return Q' and b'."""
    phi_f = x.phi_f
    size = 1 + phi_f @ phi_f
    F_f = filtered_flow(x, u, p)
    Q, b = memory_rates(x.Q, x.b, F_f, phi_f, p.forgetting * phi_f, size)
    return {"Q": Q, "b": b}


def composite_memory(t, x, u, p):
    """Composite adaptation with memory: CLPE and a memory of the track drive one estimate.

        theta_hat' = gamma phi e^T + gamma_c (b^T - Q theta_hat)
        theta_hat = -alpha^T    for Eq. (21)
        Q'         = n n^T / (1 + |phi_f|^2),    n = phi_f - m Q phi_f
        b'         = (F_f - m b phi_f) n^T / (1 + |phi_f|^2)

    phi_f and F_f, and the memory, are those of `regressions`: with Q(0) = 0 and b(0) = 0,
    b = theta Q, and Q is N x N, symmetric, not negative, at most 1/m and non-decreasing: no
    information of the track is lost.  K and Gamma are those of `regressions`, or are fixed.
    Sources: Kreisselmeier 1977, IEEE Transactions on Automatic Control 22(1), Adaptive observers
    with exponential rate of convergence; Pan and Yu 2018, Automatica 89, Composite learning robot
    control with guaranteed parameter convergence.

    V of Eq. (24), each error weighed by its own gain, has with eta = theta + alpha
        V' = -e^T KD e - gamma_c tr(eta Q eta^T)/gamma - dissipative terms of K and Gamma
    so V decreases at least at twice the smallest of three rates: the least of KD; gamma_c times the
    least eigenvalue of Q; and those of K and Gamma.  This rate is non-decreasing.

    Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N] (length
    per time), K[2], Gamma[2] (per time), the states of `regressions`, Q[N*N] (time), b[2N]
    (length).
    """
    pull = x.b + x.alpha @ x.Q.T
    return {
        "alpha": np.outer(-p.gain * u.e, u.phi_x) - p.memory_gain * pull,
        **flow_memory_rates(x, u, p),
        **filter_rates(x, u, p),
        **gain_rates(x, u, p),
    }


COMPOSITE_MEMORY = Law(
    "composite-memory",
    rates=composite_memory,
    parameters={
        **GAINS,
        "memory_gain": Setting(
            "gamma_c, 1/time^2; 0.8 k^2 (k mean KD)", scaled(0.8, k=2)
        ),
        "forgetting": MEMORY,
    },
).with_parts(FILTERED_FLOW, COMMANDED_GAINS, pulling_memory("Q", "b"))


# --- windows ---------------------------------------------------------------------------------


def concurrent(t, x, u, p):
    """Concurrent learning in integral form: a memory of windows of the track that forgets nothing.

    Over a window from t_1 to t_2 = t_1 + T, Eq. (1) integrated is a regression with no derivative:

        Y = x(t_2) - x(t_1) - int v = theta Phi,    Phi = int phi(x)

    The law integrates x - origin = Y and Phi over a window.  At its end Y and Phi become the states
    carried and shown, which enter the memory of `regressions` during the next window:

        n = shown - S shown,    d = T (T^2 + |shown|^2)
        S' = n n^T/d,           B' = (carried - B shown) n^T/d
        theta_hat' = gamma phi e^T + gamma_c (B^T - S theta_hat)
        theta_hat = -alpha^T    for Eq. (21)

    With S(0) = 0 and B(0) = 0, B = theta S and S = M (1 + M)^-1, M the sum over all windows of Phi
    Phi^T/(T^2 + |Phi|^2), each normalised by itself.  S is symmetric, not negative, below 1 and
    non-decreasing.  K and Gamma are those of `regressions`, or are fixed.
    Sources: Chowdhary and Johnson 2010, 49th IEEE Conference on Decision and Control, Concurrent
    learning for convergence in adaptive control without persistency of excitation; Parikh,
    Kamalapurkar, Dixon 2019, International Journal of Adaptive Control and Signal Processing
    33(12), Integral concurrent learning.

    V of Eq. (24), each error weighed by its own gain, does not jump, and has with eta = theta +
    alpha
        V' = -e^T KD e - gamma_c tr(eta S eta^T)/gamma - dissipative terms of K and Gamma
    so V decreases at least at twice the smallest of three rates: the least of KD; gamma_c times the
    least eigenvalue of S; and those of K and Gamma.  This rate is non-decreasing.

    Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N] (length
    per time), K[2], Gamma[2] (per time), S[N*N], B[2N] (length per time), Phi[N], shown[N] (time),
    origin[2], carried[2] (length) and those of `regressions`, the states.
    """
    Phi = x.shown
    pull = x.B + x.alpha @ x.S.T
    size = p.window * (p.window**2 + Phi @ Phi)
    S, B = memory_rates(x.S, x.B, x.carried, Phi, Phi, size)
    return {
        "alpha": np.outer(-p.gain * u.e, u.phi_x) - p.memory_gain * pull,
        "S": S,
        "B": B,
        "Phi": u.phi_x,
        "origin": u.v_x,
        "shown": 0.0,
        "carried": 0.0,
        **gain_rates(x, u, p),
    }


def next_window(t, x, u, p):
    """End a window of Eq. (1): store its Phi and Y, and set Phi = 0 and origin = x."""
    return {
        **{name: getattr(x, name) for name in CONTINUOUS},
        "shown": x.Phi,
        "carried": u.x - x.origin,
        "Phi": 0.0,
        "origin": u.x,
    }


# states that do not jump when a window ends
CONTINUOUS = ("alpha", "K", "Gamma", "S", "B", "Q_1", "Q_2", "b_v")
WINDOW: dict[str, Any] = {
    "states": {
        "Phi": State("N"),
        "origin": State(2, lambda context, p: context.position),
        "shown": State("N"),
        "carried": State(2),
    },
    "invariants": lambda s, p, truth: {
        "origin": s["x"] - truth.theta @ s["Phi"],
        "carried": truth.theta @ s["shown"],
    },
}
CONCURRENT = Law(
    "concurrent",
    rates=concurrent,
    parameters={
        **GAINS,
        "memory_gain": Setting("gamma_c, 1/time; k, the mean of KD", scaled(1)),
        "window": Setting(
            "T over which flow and basis are summed, time; 1/k", scaled(1, k=-1)
        ),
    },
    jump=next_window,
    breakpoints=Each("window"),
).with_parts(pulling_memory("S", "B"), WINDOW, COMMANDED_GAINS)


# --- mixing ----------------------------------------------------------------------------------


MOST = 6  # functions


def mixing(Q, S):
    """Return S adj(Q S), shape (N, N), and det(Q S); S is a diagonal.

    M_1 = I, d_1 = tr A; M_k+1 = d_k I - A M_k, d_k+1 = tr(A M_k+1)/(k + 1) with A = Q S: adj A is
    M_N and det A is d_N (Faddeev and LeVerrier).
    """
    identity = np.eye(len(S))
    mixed = S[:, None] * identity
    d = np.sum(np.diagonal(Q) * S)
    for k in range(2, len(S) + 1):
        mixed = S[:, None] * (d * identity - Q @ mixed)
        d = np.sum(Q * mixed.T) / k
    return mixed, d


def drem(t, x, u, p):
    """Dynamic regressor extension and mixing (DREM): each flow parameter has its own regression.

    The memory of `composite_memory`, b = theta Q, is mixed by the adjugate, which gives a scalar
    regression for each parameter.  With A = Q S, S diagonal, S_kk = 1/max(Q_kk, 1/l), and
    Delta = det A, between 0 and 1,

        (b + alpha Q) S adj(A) = Delta eta,    eta = theta + alpha
        alpha' = -f eta,    f = g min(1, Delta^2/c^2) >= 0
        w'     = -f w,      w(0) = 1

    so eta = w eta(0): the error of each parameter is non-increasing and independent of the others.
    CLPE would break this, so it is not part of alpha'; K and Gamma follow Eqs. (22)-(23), or are
    fixed.  Finite-time readout: the share w of the initial error is known, so

        theta_FT = (theta_hat - w theta_hat(0))/(1 - w) = theta,    theta_hat = -alpha

    `readout` is theta_FT once w <= 1 - margin, and theta_hat before.
    The adjugate is that of Faddeev and LeVerrier, without pivots; for N <= 6 it is exact to 1e-12.
    Sources: Aranovskiy, Bobtsov, Ortega, Pyrkin 2017, IEEE Transactions on Automatic Control 62(7),
    Performance enhancement of parameter estimators via dynamic regressor extension and mixing;
    Ortega, Gerasimov, Barabanov, Nikiforov 2019, Automatica 109, 108521.

    V of Eq. (24), with g^2 as the gain of alpha, has
        V' = -e^T KD e + e^T eta phi - f |eta|^2/g^2
    as in Theorem 3.1: in the mean square |e| is at most |eta phi| over the least of KD.

    Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N] (length
    per time), K[2], Gamma[2] (per time), Q[N*N] (time), b[2N] (length), phi_f[N], q[2] (length per
    time), w[1], the states, and readout[2N] (length per time).
    """
    mixed, Delta = mixing(x.Q, 1 / np.maximum(1 / p.filter, np.diagonal(x.Q)))
    scale = p.rate / np.maximum(p.excitation**2, Delta * Delta)
    return {
        "alpha": -scale * Delta * ((x.b + x.alpha @ x.Q.T) @ mixed),
        **adapt_gains(p, u.e, u),
        **flow_memory_rates(x, u, p),
        **filter_rates(x, u, p),
        "w": -scale * Delta * Delta * x.w,
    }


def output(t, x, u, p):
    """Return readout[2N] of theta, Eq. (3): theta_FT once 1 - w >= margin."""
    learned = 1 - x.w
    alpha_FT = (x.alpha - x.w * p.alpha_0) / np.maximum(p.margin, learned)
    return {"readout": np.where(learned >= p.margin, -alpha_FT, -x.alpha)}


def check_size(law: Law, context: Any) -> None:
    """Refuse more basis functions than the determinant is accurate for."""
    if context.N > MOST:
        raise ScenarioError(f"drem: takes at most {MOST} functions, not {context.N}")


DREM = Law(
    "drem",
    needs=f"the commanded velocity, at most {MOST} functions",
    rates=drem,
    promises=(
        *promised("spanned exact", "shrinks", "readout"),
        *promised("true spanned exact", "mean square"),
    ),
    parameters={
        "rate": Setting("g, 1/time, of each parameter once excited; k", scaled(1)),
        "excitation": Setting(
            "c, the determinant from which on the rate is g", 0.05, "at most 1"
        ),
        "margin": Setting(
            "of 1 - w, from which on the readout is theta", 0.5, "below 1"
        ),
        **K_GAMMA,
        "forgetting": MEMORY,
        "alpha_0": lambda context: context.alpha,
    },
    output=output,
    outputs={"readout": (2, "N")},
    V_gain=lambda p: p.rate**2,
    check=check_size,
    error_left="w",
    invariants=lambda s, p, truth: {
        "alpha": s["w"] * (truth.theta + p.alpha_0) - truth.theta
    },
    readout="readout",
    driving_estimate="alpha",
    losses=lambda s, p, truth: [  # f, |eta|^2/g^2
        (
            -s["w'"][0] / s["w"][0],
            np.sum((truth.theta + s["alpha"]) ** 2),
            1 / p.rate**2,
        )
    ],
    V_rate="-e^T KD e + e^T eta phi - f |eta|^2/g^2, eta = w eta(0), w' = -f w <= 0",
).with_parts(memory("Q", "b"), FILTERED_FLOW, {"states": {"w": State(1, 1.0)}})


# --- fixes -----------------------------------------------------------------------------------


def predict(t, x, u, p):
    """Learning at fixes: between fixes the vehicle steers by its prediction z.

        z' = theta_hat phi(z) + v,    m' = phi(z),    theta_hat = -alpha,    v as flown

    At a fix f_k of time t_k, y = f_k - z(t_k) = (theta - theta_hat) m if phi(z) = phi(x), with m
    integrated since the previous fix.  Least squares on y, with d = r^2 + m^T P m:

        theta_hat += y (P m)^T / d,    P -= P m (P m)^T / d,    P^-1 += m m^T / r^2
        z += y + (change of theta_hat) n,    m = n,    n = int phi(z) from t_k to now

    A fix arrives `latency` after t_k; n is integrated over the latency, and z becomes the value
    that it would have with theta_hat and the fix known at t_k.  Without latency n = 0.  If a fix is
    missing, no state jumps and m is integrated on.  z(0) is a fix without noise.  P is computed in
    Joseph's form, A - A m (P m)^T/d + r^2 P m (P m)^T/d^2 with A = P - P m (P m)^T/d, which is
    equal and accurate for any r.

        V  = r^2 tr(eta P^-1 eta^T)/2,    eta = theta + alpha
        V' = 0 between fixes;    V_after - V = (|w|^2 - r^2 |y|^2/d)/2    at a fix, w = y - eta m

    w is noise, unmodelled flow, and phi(z) for phi(x), which a shear of the true flow of at most L
    bounds: V is bounded, and V/k in the end, where L T is small, up to 0.65 for 6 functions
    (`fix_bound`).  Beyond, theta_hat may diverge.

    K and Gamma are K_D and Gamma_D of the vehicle, which steers by Eq. (7) at z.
    Source: Ljung 1999, System Identification, section 11.2, recursive least squares.

    Ports: fix[2] (length), taken[1], phi_z[N], v_x[2] (length per time) -> K[2], Gamma[2] (per
    time) and the states alpha[2N] (length per time), z[2] (length), information[N*N] (P^-1, time
    per length, squared), P[N*N] (length per time, squared), m[N] (time); of the fix under way
    sent[2] (length), waiting[1], z_sent[2] (length), m_sent[N] (time).
    """
    return {**dict.fromkeys(STATES, 0.0), "z": u.v_x - x.alpha @ u.phi_z, "m": u.phi_z}


def least_squares_step(P, m, y, noise):
    """Return the change of theta_hat, and P, by y = (theta - theta_hat) m + noise, Ljung 1999."""
    Pm = P @ m
    d = noise**2 + m @ Pm
    # Joseph's form of P, symmetric to the last bit
    A = P - np.outer(Pm, Pm) / d
    product = np.outer(A @ m, Pm)
    joseph = A - (product + product.T) / (2 * d)
    return np.outer(y, Pm) / d, joseph + noise**2 * np.outer(Pm, Pm) / d**2


def learn(t, x, u, p):
    """Least squares on x of Eq. (1) at a fix, Ljung 1999: theta_hat, P, P^-1, z and m as above.

    With latency an odd interval begins when a fix is sent, an even interval when it arrives;
    without latency every interval begins with both.
    """
    late = p.latency > 0
    arrives = np.where(late, 1 - p.interval % 2, 1.0)
    sends = (1 - arrives) * u.taken
    received = arrives * np.where(late, x.waiting, u.taken)
    m = np.where(late, x.m_sent, x.m)
    n = np.where(late, x.m, 0.0)
    y = received * np.where(late, x.sent - x.z_sent, u.fix - x.z)
    change, P = least_squares_step(x.P, m, y, p.noise)
    return {
        "alpha": x.alpha - change,
        "P": (1 - received) * x.P + received * P,
        "information": x.information + received * np.outer(m, m) / p.noise**2,
        "z": x.z + y + change @ n,
        "m": x.m * (1 - np.where(late, sends, received)),
        "sent": u.fix,
        "waiting": np.where(late, sends, 0.0),
        "z_sent": x.z,
        "m_sent": x.m,
    }


def vehicle_gains(t, x, u, p):
    """K = K_D and Gamma = Gamma_D of Eq. (7), outputs that are not states."""
    return {"K": p.KD, "Gamma": p.GammaD}


def fix_level(t, x, u, p):
    """V = r^2 tr(eta P^-1 eta^T)/2, as in Eq. (24)."""
    eta = p.theta + u.alpha
    return {"V": p.noise**2 / 2 * np.sum((eta @ u.information) * eta)}


class FixTimes:
    """Times at which a fix is sent or arrives: multiples of the interval, or rises of `taken`.

    If `taken` is an input of the diagram, each rise of it is a fix, whatever the interval.
    """

    trigger = "taken"

    def __call__(self, p: Any, t0: float, t1: float) -> np.ndarray:
        """Return the times in (t0, t1]."""
        sent = multiples(p.between, t0, t1)
        if not p.latency > 0:
            return sent
        arrived = multiples(p.between, t0 - p.latency - p.between, t1) + p.latency
        arrived = arrived[(arrived > t0) & (arrived <= t1)]
        return np.sort(np.concatenate([sent, arrived]))

    def after(self, p: Any, sent: np.ndarray) -> np.ndarray:
        """Return the times of fixes that are sent at given times."""
        if not p.latency > 0:
            return sent
        if np.any(np.diff(sent) <= p.latency):
            raise ScenarioError(
                f"taken: a fix is sent before the last one has arrived, after the latency "
                f"{p.latency:g}. Give fixes that are further apart, or a smaller latency"
            )
        return np.sort(np.concatenate([sent, sent + p.latency]))


def usual_noise(context: Any) -> float:
    """Return ((0.1 R)^2 + 2 noise^2)^0.5, length."""
    return float(np.hypot(0.1 * context.R, np.sqrt(2) * context.fixes.noise))


STATES = {
    "alpha": State((2, "N")),
    "P": State(("N", "N"), lambda context, p: np.eye(context.N) * context.prior**2),
    "information": State(
        ("N", "N"), lambda context, p: np.eye(context.N) / context.prior**2
    ),
    "z": State(2),
    "m": State("N"),
    "sent": State(2),
    "waiting": State(1),
    "z_sent": State(2),
    "m_sent": State("N"),
}
FIX_REGRESSION = Law(
    "fix-regression",
    needs="fixes, localization.interval; steers on the prediction in between",
    rates=predict,
    promises=promised("spanned exact uniform", "falls"),
    parameters={
        "noise": Setting(
            "r of the regression, length; ((0.1 R)^2 + 2 noise^2)^0.5", usual_noise
        ),
        "KD": lambda context: context.KD,
        "GammaD": lambda context: context.GammaD,
        "between": lambda context: context.fixes.interval,
        "latency": lambda context: context.fixes.latency,
    },
    keys={"prior": PRIOR},
    inputs={"fix": 2, "taken": 1, "phi_z": "N", "v_x": 2},
    states=STATES,
    output=vehicle_gains,
    outputs={"K": 2, "Gamma": 2},
    jump=learn,
    breakpoints=FixTimes(),
    candidate=fix_level,
    V_inputs=("alpha", "information"),
    between_fixes=lambda P, time, p: P,
)

LAWS = (COMPOSITE_MEMORY, CONCURRENT, DREM, FIX_REGRESSION)
