"""The normalised gradient: CLPE and the filtered regression of now drive one estimate.

    theta_hat' = gamma phi e^T + gamma_n phi_f eps^T / (1 + |phi_f|^2),    theta_hat = -alpha^T

phi_f and eps are those of `filtered_flow`.  However large the regressor, the second term takes
eps away at a rate of at most gamma_n.  It remembers nothing: what the track does not show now is
not learned now.  K and Gamma are those of `commanded_gains`, or are held.
Sources: Ioannou and Sun 1996, section 4.3; beside CLPE, Slotine and Li 1989.

V of Eq. (24), each error weighed by its own gain, has with eta = theta + alpha
    V' = -e^T KD e - gamma_n |eta phi_f|^2/(gamma (1 + |phi_f|^2)) - what K and Gamma lose

Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] (length per time) -> alpha[2N] (length
per time), K[2], Gamma[2] (per time) and the states of `filtered_flow`.
"""

from typing import Any, NamedTuple

import numpy as np

from ...equations.block import Block
from .commanded_gains import gains_losses
from .filtered_flow import (
    MADE_OF,
    filtered_law,
    shared_kept,
    shared_rates,
    shared_starts,
    unexplained,
    unexplained_square,
)
from .law import Known, Law, Setting, Truth
from .learned_flow import V
from .scales import FILTER, mean_feedback


class NormalisedGradientParameters(NamedTuple):
    """Parameters of the normalised gradient."""

    N: int  # number of basis functions
    gain: float  # gamma > 0 of alpha, per time squared
    gain_K: float  # of Eq. (22), per length squared per time squared; 0 holds K
    gain_Gamma: float  # of Eq. (23), the same; 0 holds Gamma
    alpha_M: np.ndarray  # shape (2, N), the modelled flow, length per time
    rate: float  # k, mean feedback gain, per time
    filter: float  # l > 0, per time
    regression_gain: float  # gamma_n > 0, per time


def normalised_gradient(t, x, u, p, dx):
    """alpha' of Eq. (21) with the regression, normalised.

    u = e[2], phi_x[N], z[2], zc[2], x[2], v_x[2] (and v_c[2]); states alpha[2N], K[2], Gamma[2],
    phi_f[N], q[2], Q_1[4], Q_2[4], b_v[4].
    """
    n, size = p.N, 1.0
    e, phi, phi_f = u[0:2], u[2 : 2 + n], x[2 * n + 4 : 3 * n + 4]
    for k in range(n):
        size += phi_f[k] * phi_f[k]
    for i in range(2):
        taken = p.regression_gain * unexplained(x, u, p, i) / size
        for k in range(n):
            dx[i * n + k] = -p.gain * e[i] * phi[k] - taken * phi_f[k]
    shared_rates(x, u, p, dx)


def block(known: Known) -> Block:
    """Make the law of what is known; its scale is k = mean KD."""
    own, k = known.settings, mean_feedback(known)
    return filtered_law(
        normalised_gradient,
        NormalisedGradientParameters(
            known.N,
            *known.gains[:3],
            known.alpha_M,
            k,
            own["filter"] or 2 * k,
            own["regression_gain"] or 4 * k,
        ),
        {},
        known.limited,
    )


def starts(known: Known) -> dict[str, Any]:
    """Return the filter's start."""
    return shared_starts(known, block(known).parameters.filter)


def losses(s: Any, p: Any, truth: Truth) -> list[tuple]:
    """Return gamma_n |eta phi_f|^2/(gamma (1 + |phi_f|^2)), and what K and Gamma lose."""
    size = 1 + sum(s["phi_f"] ** 2)
    own = (unexplained_square(s, p, truth), p.regression_gain / p.gain, 1 / size)
    return [own, *gains_losses(s, p, truth)]


LAW = Law(
    "normalised-gradient",
    promise="CLPE goes to zero, and alpha to -theta as fast as the track of now shows it",
    needs="the commanded velocity",
    block=block,
    V=V,
    settings={
        "regression_gain": Setting(None, "positive", "gamma_n, 1/time; 4 k (k mean KD)"),
        "filter": FILTER,
    },
    gain=1.0,
    starts=starts,
    keeps=shared_kept,
    losses=losses,
    cones=("Q_1", "Q_2"),
    says="-e^T KD e - gamma_n |eta phi_f|^2/(gamma (1 + |phi_f|^2))",
    made_of=MADE_OF,
)
