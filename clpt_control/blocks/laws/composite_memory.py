"""Composite adaptation with memory: CLPE and all that was seen drive one estimate.

    theta_hat' = gamma phi e^T + gamma_c (b^T - Q theta_hat),    theta_hat = -alpha^T
    Q'         = n n^T / (1 + |phi_f|^2),    n = phi_f - m Q phi_f
    b'         = (F_f - m b phi_f) n^T / (1 + |phi_f|^2)

phi_f and F_f, and the memory, are those of `regressions`: from Q = 0, b = 0 on, b = theta Q, and
Q is N x N, symmetric, not negative and at most 1/m.  It never falls: what the track has shown is
kept, also where it shows nothing more.  K and Gamma are those of `commanded_gains`, or are held.
Sources: Kreisselmeier 1977, IEEE Transactions on Automatic Control 22(1), Adaptive observers
with exponential rate of convergence; Pan and Yu 2018, Automatica 89, Composite learning robot
control with guaranteed parameter convergence.

V of Eq. (24), each error weighed by its own gain, has with eta = theta + alpha
    V' = -e^T KD e - gamma_c tr(eta Q eta^T)/gamma - what K and Gamma lose
so that V falls at least at twice the least of k, the least of KD; gamma_c times the least
eigenvalue of Q; and those of `commanded_gains`: a rate that never falls.

Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N] (length
per time), K[2], Gamma[2] (per time), the states of `regressions`, Q[N*N] (time), b[2N]
(length).
"""

import numpy as np

from .commanded_gains import COMMANDED_GAINS, gain_rates
from .known import MEMORY, Setting, scaled
from .law import GAINS, Law, promised
from .regressions import FILTERED_FLOW, filter_rates, filtered_flow, memory, pulled, remembered


def memory_rates(x, u, p):
    """Return Q' and b'."""
    phi_f, size = x.phi_f, 1 + x.phi_f @ x.phi_f
    Q, b = remembered(x.Q, x.b, filtered_flow(x, u, p), phi_f, p.forgetting * phi_f, size)
    return {"Q": Q, "b": b}


def composite_memory(t, x, u, p):
    """alpha' of Eq. (21) with the memory, Q', b'."""
    missed = x.b + x.alpha @ x.Q.T
    return {
        "alpha": -p.gain * np.outer(u.e, u.phi_x) - p.memory_gain * missed,
        **memory_rates(x, u, p),
        **filter_rates(x, u, p),
        **gain_rates(x, u, p),
    }


LAW = Law(
    "composite-memory",
    promise="CLPE goes to zero, and alpha to -theta exponentially once the track has excited, even "
    "if it never does again",
    rates=composite_memory,
    promises=promised("true spanned exact", "falls", "settles", "exponential"),
    parameters={
        **GAINS,
        "memory_gain": Setting("gamma_c, 1/time^2; 0.8 k^2 (k mean KD)", scaled(0.8, k=2)),
        "forgetting": MEMORY,
    },
    losses=lambda s, p, truth: [pulled(s, p, truth, "Q")],
    says="-e^T KD e - gamma_c tr(eta Q eta^T)/gamma",
).with_parts(FILTERED_FLOW, COMMANDED_GAINS, memory("Q", "b"))
