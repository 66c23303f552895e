"""Concurrent learning in integral form: what windows of the track have shown is kept for good.

Over a window from t_1 to t_2 = t_1 + T, Eq. (1) integrated is a regression with no derivative:

    Y = x(t_2) - x(t_1) - int v = theta Phi,    Phi = int phi(x)

The law keeps x - origin = Y and Phi of the window that runs, and at its end takes it in:

    sigma+^2 = sigma^2 + |Phi|^2
    S+ = (sigma^2 S + Phi Phi^T)/sigma+^2,    B+ = (sigma^2 B + Y Phi^T)/sigma+^2
    theta_hat' = gamma phi e^T + gamma_c (B^T - S theta_hat),    theta_hat = -alpha^T

From S = 0, B = 0, sigma = T on, B = theta S, and S is symmetric, not negative, its trace below 1:
the mean of all windows, each by what it has shown.  One that shows nothing takes nothing away.
K and Gamma follow Eqs. (22)-(23), or are held.
Sources: Chowdhary and Johnson 2010, 49th IEEE Conference on Decision and Control, Concurrent
learning for convergence in adaptive control without persistency of excitation; Parikh,
Kamalapurkar, Dixon 2019, International Journal of Adaptive Control and Signal Processing 33(12),
Integral concurrent learning.

V of Eq. (24), each error weighed by its own gain, does not jump, and has with eta = theta + alpha
    V' = -e^T KD e - gamma_c tr(eta S eta^T)/gamma
so that, K and Gamma held true, V falls at least at the rate min(2 k, 2 gamma_c lambda), k the least
of KD and lambda the least eigenvalue of S, once some windows have excited.

Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N] (length
per time), K[2], Gamma[2] (per time), S[N*N], B[2N] (length per time), sigma[1] and Phi[N]
(time), origin[2] (length), the states.
"""

import numpy as np

from ...equations.declaration import Each
from .known import Setting, scaled
from .law import GAINS, Law, Part, State, adapt_gains
from .regressions import memory, pulled


def concurrent(t, x, u, p):
    """alpha' of Eq. (21) with the windows, K', Gamma' of Eqs. (22)-(23), Phi', origin'."""
    missed = x.B + x.alpha @ x.S.T
    return {
        "alpha": -p.gain * np.outer(u.e, u.phi_x) - p.memory_gain * missed,
        **adapt_gains(p, u.e, u.z, u.zc),
        "S": 0.0,
        "B": 0.0,
        "sigma": 0.0,
        "Phi": u.phi_x,
        "origin": u.v_x,
    }


def take_in(t, x, u, p):
    """S, B and sigma after a window of Eq. (1); Phi = 0 and origin = x begin the next."""
    before = np.maximum(p.window, x.sigma)  # sigma is never less than T: no divisor is zero
    after = np.maximum(p.window, np.sqrt(before**2 + x.Phi @ x.Phi))
    kept, Phi, Y = (before / after) ** 2, x.Phi / after, (u.x - x.origin) / after
    return {
        "alpha": x.alpha,
        "K": x.K,
        "Gamma": x.Gamma,
        "S": kept * x.S + np.outer(Phi, Phi),
        "B": kept * x.B + np.outer(Y, Phi),
        "sigma": after,
        "Phi": 0.0,
        "origin": u.x,
    }


WINDOW: Part = {
    "states": {
        "sigma": State(1, lambda known, p: np.full(1, p.window)),
        "Phi": State("N"),
        "origin": State(2, lambda known, p: known.position),
    },
    "keeps": lambda s, p, truth: {"origin": s["x"] - truth.theta @ s["Phi"]},
}
LAW = Law(
    "concurrent",
    promise="CLPE goes to zero, and alpha to -theta exponentially once the track has excited, even "
    "if it never does again",
    needs="the commanded velocity",
    rates=concurrent,
    parameters={
        **GAINS,
        "memory_gain": Setting("gamma_c, 1/time; 5 k (k mean KD)", scaled(5)),
        "window": Setting("T over which flow and basis are summed, time; 1/k", scaled(1, k=-1)),
    },
    jump=take_in,
    breakpoints=Each("window"),
    losses=lambda s, p, truth: [pulled(s, p, truth, "S")],
    says="-e^T KD e - gamma_c tr(eta S eta^T)/gamma",
).with_parts(memory("S", "B"), WINDOW)
