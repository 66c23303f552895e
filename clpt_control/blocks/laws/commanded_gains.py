"""K and Gamma from CLPE, as in the paper, and from the commanded velocity, with memory.

By Eq. (7), y = v + alpha_M phi(x) = -KD x + GammaD zc is known where v is: for each axis i a
regression on w = (-x_i, zc_i), which no flow disturbs, for kappa = (K_i, Gamma_i).

    Q_i'     = n n^T / (1 + w^T G w),   b_i' = (y_i - m b_i^T G w) n / (1 + w^T G w)
    K_i'     = -gamma_K z_i e_i      + gamma_K (b_i - Q_i kappa)_1
    Gamma_i' =  gamma_Gamma zc_i e_i + gamma_Gamma (b_i - Q_i kappa)_2

are Eqs. (22)-(23) with the memory of `regressions`, n = w - m Q_i G w, G = diag(gamma_K,
gamma_Gamma)/k^2, m = 0.1 k.  From Q_i = 0 and b_i = 0 on, b_i = Q_i kappa_D, and V' loses the sum
of (kappa - kappa_D)^T Q_i (kappa - kappa_D); Q_i never falls.  By CLPE alone K and Gamma come
slowly, and alpha meanwhile takes up what they lack.  A gain of 0 holds what it adapts.
Source: Kreisselmeier 1977, as `composite_memory`.

Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] or v_c[2] (length per time); states K[2],
Gamma[2] (per time), Q_1[4], Q_2[4] (length squared times time), b_v[4] (length squared).
"""

from typing import Any

import numpy as np

from .known import Truth, mean_feedback
from .law import MOVING, Part, State, adapt_gains
from .regressions import remembered


def gain_rates(x, u, p):
    """Return K', Gamma', Q_1', Q_2' and b_v'; v is that of Eq. (7)."""
    y = getattr(u, "v_c", u.v_x) + p.alpha_M @ u.phi_x
    w, kappa = np.stack([-u.x, u.zc]).T, np.stack([x.K, x.Gamma]).T  # a row for each axis
    weighed = w * np.stack([p.gain_K, p.gain_Gamma]) / p.rate**2  # G w
    size, known = 1 + np.sum(weighed * w, axis=1), 0.1 * p.rate * weighed
    Q_1, b_1 = remembered(x.Q_1, x.b_v[0], y[0], w[0], known[0], size[0])
    Q_2, b_2 = remembered(x.Q_2, x.b_v[1], y[1], w[1], known[1], size[1])
    missed = x.b_v - np.stack([x.Q_1 @ kappa[0], x.Q_2 @ kappa[1]])
    by_error = adapt_gains(p, u.e, u.z, u.zc)
    return {
        "K": by_error["K"] + p.gain_K * missed[:, 0],
        "Gamma": by_error["Gamma"] + p.gain_Gamma * missed[:, 1],
        "Q_1": Q_1,
        "Q_2": Q_2,
        "b_v": np.concatenate([b_1, b_2]),
    }


def keeps(s: Any, p: Any, truth: Truth) -> dict[str, Any]:
    """Return what the states are at all times: b_i = Q_i kappa_D."""
    kappa = np.stack([truth.KD, truth.GammaD]).T
    return {"b_v": np.stack([s["Q_1"] @ kappa[0], s["Q_2"] @ kappa[1]])}


def losses(s: Any, p: Any, truth: Truth) -> list[tuple]:
    """Return what V' loses: (kappa - kappa_D)^T Q_i (kappa - kappa_D), where they adapt."""
    off = np.stack([s["K"] - truth.KD, s["Gamma"] - truth.GammaD]).T
    return [(off[0] @ s["Q_1"] @ off[0],), (off[1] @ s["Q_2"] @ off[1],)]


COMMANDED_GAINS: Part = {
    "needs": "the commanded velocity",
    "states": dict.fromkeys(("Q_1", "Q_2", "b_v"), State((2, 2))),  # empty at first
    "takes": {**MOVING, "v_c": 2},
    "parameters": {"alpha_M": "alpha_M", "rate": mean_feedback},
    "keeps": keeps,
    "losses": losses,
    "cones": ("Q_1", "Q_2"),
}
