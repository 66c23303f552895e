"""Concurrent learning in integral form: what windows of the track have shown is kept for good.

Over a window from t_1 to t_2 = t_1 + T, Eq. (1) integrated is a regression with no derivative:

    Y = x(t_2) - x(t_1) - int v = theta Phi,    Phi = int phi(x)

The law keeps x - origin = Y and Phi of the window that runs, and at its end passes them on, as
carried and shown; while the next one runs it takes them in, into the memory of `regressions`:

    n = shown - S shown,    d = T (T^2 + |shown|^2)
    S' = n n^T/d,           B' = (carried - B shown) n^T/d
    theta_hat' = gamma phi e^T + gamma_c (B^T - S theta_hat),    theta_hat = -alpha^T

From S = 0, B = 0 on, B = theta S and S = M (1 + M)^-1, M the sum over all windows of
Phi Phi^T/(T^2 + |Phi|^2), each normalised by itself.  S is symmetric, not negative, below 1, and
never falls: a window takes nothing away, whatever it shows.  K and Gamma are those of
`commanded_gains`, or are held.
Sources: Chowdhary and Johnson 2010, 49th IEEE Conference on Decision and Control, Concurrent
learning for convergence in adaptive control without persistency of excitation; Parikh,
Kamalapurkar, Dixon 2019, International Journal of Adaptive Control and Signal Processing 33(12),
Integral concurrent learning.

V of Eq. (24), each error weighed by its own gain, does not jump, and has with eta = theta + alpha
    V' = -e^T KD e - gamma_c tr(eta S eta^T)/gamma - what K and Gamma lose
so that V falls at least at twice the least of k, the least of KD; gamma_c times the least
eigenvalue of S; and those of `commanded_gains`: a rate that never falls.

Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N] (length
per time), K[2], Gamma[2] (per time), S[N*N], B[2N] (length per time), Phi[N], shown[N] (time),
origin[2], carried[2] (length) and those of `commanded_gains`, the states.
"""

import numpy as np

from ...equations.declaration import Each
from .commanded_gains import COMMANDED_GAINS, gain_rates
from .known import Setting, scaled
from .law import GAINS, Law, Part, State, promised
from .regressions import memory, pulled, remembered


def concurrent(t, x, u, p):
    """alpha' of Eq. (21) with the memory, K', Gamma', S', B', Phi', origin'."""
    shown, missed = x.shown, x.B + x.alpha @ x.S.T
    size = p.window * (p.window**2 + shown @ shown)
    S, B = remembered(x.S, x.B, x.carried, shown, shown, size)
    return {
        "alpha": -p.gain * np.outer(u.e, u.phi_x) - p.memory_gain * missed,
        "S": S,
        "B": B,
        "Phi": u.phi_x,
        "origin": u.v_x,
        "shown": 0.0,
        "carried": 0.0,
        **gain_rates(x, u, p),
    }


def next_window(t, x, u, p):
    """Phi and Y of a window of Eq. (1) are passed on; Phi = 0 and origin = x begin the next."""
    kept = {name: getattr(x, name) for name in KEPT}
    return {**kept, "shown": x.Phi, "carried": u.x - x.origin, "Phi": 0.0, "origin": u.x}


KEPT = ("alpha", "K", "Gamma", "S", "B", "Q_1", "Q_2", "b_v")  # where a window ends
WINDOW: Part = {
    "states": {
        "Phi": State("N"),
        "origin": State(2, lambda known, p: known.position),
        "shown": State("N"),
        "carried": State(2),
    },
    "keeps": lambda s, p, truth: {
        "origin": s["x"] - truth.theta @ s["Phi"],
        "carried": truth.theta @ s["shown"],
    },
}
LAW = Law(
    "concurrent",
    promise="CLPE goes to zero, and alpha to -theta exponentially once the track has excited, even "
    "if it never does again",
    rates=concurrent,
    promises=promised("true spanned exact", "falls", "settles", "exponential"),
    parameters={
        **GAINS,
        "memory_gain": Setting("gamma_c, 1/time; k, the mean of KD", scaled(1)),
        "window": Setting("T over which flow and basis are summed, time; 1/k", scaled(1, k=-1)),
    },
    jump=next_window,
    breakpoints=Each("window"),
    losses=lambda s, p, truth: [pulled(s, p, truth, "S")],
    says="-e^T KD e - gamma_c tr(eta S eta^T)/gamma",
).with_parts(memory("S", "B"), WINDOW, COMMANDED_GAINS)
