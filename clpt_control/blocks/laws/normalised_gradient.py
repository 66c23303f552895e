"""The normalised gradient: CLPE and the filtered regression of now drive one estimate.

    theta_hat' = gamma phi e^T + gamma_n phi_f eps^T / (1 + |phi_f|^2),    theta_hat = -alpha^T

phi_f and eps are those of `regressions`.  However large the regressor, the second term takes
eps away at a rate of at most gamma_n.  It remembers nothing: what the track does not show now is
not learned now.  K and Gamma are those of `commanded_gains`, or are held.
Sources: Ioannou and Sun 1996, section 4.3; beside CLPE, Slotine and Li 1989.

V of Eq. (24), each error weighed by its own gain, has with eta = theta + alpha
    V' = -e^T KD e - gamma_n |eta phi_f|^2/(gamma (1 + |phi_f|^2)) - what K and Gamma lose

Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N] (length
per time), K[2], Gamma[2] (per time) and the states of `regressions`.
"""

from typing import Any

import numpy as np

from .commanded_gains import COMMANDED_GAINS, gain_rates
from .known import Setting, Truth, scaled
from .law import GAINS, Law, promised
from .regressions import FILTERED_FLOW, filter_rates, unexplained, unexplained_square


def normalised_gradient(t, x, u, p):
    """alpha' of Eq. (21) with the regression, normalised."""
    eps = p.regression_gain * unexplained(x, u, p) / (1 + x.phi_f @ x.phi_f)
    alpha = -p.gain * np.outer(u.e, u.phi_x) - np.outer(eps, x.phi_f)
    return {"alpha": alpha, **filter_rates(x, u, p), **gain_rates(x, u, p)}


def losses(s: Any, p: Any, truth: Truth) -> list[tuple]:
    """Return gamma_n |eta phi_f|^2/(gamma (1 + |phi_f|^2))."""
    size = 1 + s["phi_f"] @ s["phi_f"]
    return [(unexplained_square(s, p, truth), p.regression_gain / p.gain, 1 / size)]


LAW = Law(
    "normalised-gradient",
    promise="CLPE goes to zero, and alpha to -theta as fast as the track of now shows it",
    rates=normalised_gradient,
    promises=promised("true spanned exact", "falls", "settles"),
    parameters={
        **GAINS,
        "regression_gain": Setting("gamma_n, 1/time; 4 k (k mean KD)", scaled(4)),
    },
    losses=losses,
    says="-e^T KD e - gamma_n |eta phi_f|^2/(gamma (1 + |phi_f|^2))",
).with_parts(FILTERED_FLOW, COMMANDED_GAINS)
