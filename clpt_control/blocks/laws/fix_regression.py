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

Ports: fix[2] (length), taken[1], phi_z[N], v_x[2] (length per time) -> K[2], Gamma[2] (per time)
and the states alpha[2N] (length per time), z[2] (length), information[N*N] (P^-1, time per length,
squared), P[N*N] (length per time, squared), m[N] (time); of the fix under way sent[2] (length),
waiting[1], z_sent[2] (length), m_sent[N] (time).
"""

from typing import Any

import numpy as np

from ...equations.declaration import multiples
from .known import PRIOR, Setting, prior, reach
from .law import Law, State, promised


def predict(t, x, u, p):
    """z' = theta_hat phi(z) + v, m' = phi(z), Eq. (1) with theta_hat; all else keeps its value."""
    return {**dict.fromkeys(STATES, 0.0), "z": u.v_x - x.alpha @ u.phi_z, "m": u.phi_z}


def learn(t, x, u, p):
    """Least squares on x of Eq. (1) at a fix, Ljung 1999: theta_hat, P, P^-1, z and m as above.

    With latency an odd interval begins with a fix that is sent, an even one with its arrival;
    without, every interval begins with both.
    """
    late = p.latency > 0
    arrives = np.where(late, 1 - p.interval % 2, 1.0)
    sends = (1 - arrives) * u.taken
    got = arrives * np.where(late, x.waiting, u.taken)
    m, n = np.where(late, x.m_sent, x.m), np.where(late, x.m, 0.0)
    y = got * np.where(late, x.sent - x.z_sent, u.fix - x.z)
    Pm = x.P @ m
    d = p.noise**2 + m @ Pm
    gain = np.outer(y, Pm) / d
    A = x.P - np.outer(Pm, Pm) / d
    half = np.outer(A @ m, Pm)
    joseph = A - (half + half.T) / (2 * d) + p.noise**2 * np.outer(Pm, Pm) / d**2
    return {
        "alpha": x.alpha - gain,
        "P": (1 - got) * x.P + got * joseph,
        "information": x.information + got * np.outer(m, m) / p.noise**2,
        "z": x.z + y + gain @ n,
        "m": x.m * (1 - np.where(late, sends, got)),
        "sent": u.fix,
        "waiting": np.where(late, sends, 0.0),
        "z_sent": x.z,
        "m_sent": x.m,
    }


def gains(t, x, u, p):
    """K = K_D and Gamma = Gamma_D of Eq. (7), beside the states."""
    return {"K": p.KD, "Gamma": p.GammaD}


def candidate(t, x, u, p):
    """V = r^2 tr(eta P^-1 eta^T)/2, as in Eq. (24)."""
    eta = p.theta + u.alpha
    return {"V": p.noise**2 / 2 * np.sum((eta @ u.information) * eta)}


def events(p: Any, t0: float, t1: float) -> np.ndarray:
    """Return the times in (t0, t1] at which a fix is sent or arrives."""
    sent = multiples(p.between, t0, t1)
    if not p.latency > 0:
        return sent
    arrived = multiples(p.between, t0 - p.latency - p.between, t1) + p.latency
    return np.sort(np.concatenate([sent, arrived[(arrived > t0) & (arrived <= t1)]]))


def usual_noise(known: Any) -> float:
    """Return ((0.1 R)^2 + 2 noise^2)^0.5, length."""
    return float(np.hypot(0.1 * reach(known), np.sqrt(2) * known.fixes.noise))


STATES = {
    "alpha": State((2, "N")),
    "P": State(("N", "N"), lambda known, p: np.eye(known.N) * prior(known) ** 2),
    "information": State(("N", "N"), lambda known, p: np.eye(known.N) / prior(known) ** 2),
    "z": State(2),
    "m": State("N"),
    "sent": State(2),
    "waiting": State(1),
    "z_sent": State(2),
    "m_sent": State("N"),
}
LAW = Law(
    "fix-regression",
    promise="V does not rise at exact fixes, as far as phi at the prediction is phi at the vehicle",
    needs="fixes, localization.interval; steers on the prediction in between",
    rates=predict,
    promises=promised("spanned exact uniform", "falls"),
    parameters={
        "noise": Setting("r of the regression, length; ((0.1 R)^2 + 2 noise^2)^0.5", usual_noise),
        "KD": lambda known: known.KD,
        "GammaD": lambda known: known.GammaD,
        "between": lambda known: known.fixes.between,
        "latency": lambda known: known.fixes.latency,
    },
    keys={"prior": PRIOR},
    takes={"fix": 2, "taken": 1, "phi_z": "N", "v_x": 2},
    states=STATES,
    output=gains,
    makes={"K": 2, "Gamma": 2},
    jump=learn,
    breakpoints=events,
    candidate=candidate,
    measures=("alpha", "information"),
    says="0; at an exact fix V falls by r^2 |eta m|^2/(2 (r^2 + m^T P m))",
)
