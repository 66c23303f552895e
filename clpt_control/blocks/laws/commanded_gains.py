"""K and Gamma from CLPE, as in the paper, and from the commanded velocity, with memory.

By Eq. (7), y = v + alpha_M phi(x) = -KD x + GammaD zc is known where v is: for each axis i a
regression on w = (-x_i, zc_i), which no flow disturbs, for kappa = (K_i, Gamma_i).

    Q_i'     = -m Q_i + w w^T / (1 + w^T G w/k^2),   b_i' = -m b_i + w y_i / (1 + w^T G w/k^2)
    K_i'     = -gamma_K z_i e_i      + gamma_K (b_i - Q_i kappa)_1
    Gamma_i' =  gamma_Gamma zc_i e_i + gamma_Gamma (b_i - Q_i kappa)_2

are Eqs. (22)-(23) with memory, G = diag(gamma_K, gamma_Gamma), m = 0.1 k.  From Q_i = 0 and
b_i = 0 on, b_i = Q_i kappa_D, and V' loses the sum of (kappa - kappa_D)^T Q_i (kappa - kappa_D).
By CLPE alone K and Gamma come slowly, and alpha meanwhile takes up what they lack.  A gain of 0
holds what it adapts.  Source: Kreisselmeier 1977, as `composite_memory`.

Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2] or v_c[2] (length per time); states K[2],
Gamma[2] (per time), Q_1[4], Q_2[4] (length squared times time), b_v[4] (length squared).
"""

from typing import Any

import numpy as np

from .law import Truth, adapt_feedback, adapt_feedforward

STATES = {"Q_1": 4, "Q_2": 4, "b_v": 4}


def remember(dx, x, at, w, size, forgetting, n):
    """Fill Q' = -m Q + w w^T/size; Q stands from `at` on, row by row."""
    for j in range(n):
        for k in range(n):
            dx[at + j * n + k] = w[j] * w[k] / size - forgetting * x[at + j * n + k]


def gain_rates(dx, x, p, at, e, phi, z, zc, position, v):
    """Fill K', Gamma', and Q_1', Q_2' and b_v', which stand from `at` on; v is that of Eq. (7)."""
    n, m = 2 * p.N, 0.1 * p.rate
    for i in range(2):
        Q, b, w, y = at + 4 * i, at + 8 + 2 * i, (-position[i], zc[i]), v[i]
        for k in range(p.N):
            y += p.alpha_M[i, k] * phi[k]
        size = 1 + (p.gain_K * w[0] ** 2 + p.gain_Gamma * w[1] ** 2) / p.rate**2
        remember(dx, x, Q, w, size, m, 2)
        for j in range(2):
            dx[b + j] = w[j] * y / size - m * x[b + j]
        K, Gamma = x[n + i], x[n + 2 + i]
        missed = x[b] - x[Q] * K - x[Q + 1] * Gamma
        dx[n + i] = adapt_feedback(p.gain_K, e[i], z[i]) + p.gain_K * missed
        missed = x[b + 1] - x[Q + 2] * K - x[Q + 3] * Gamma
        dx[n + 2 + i] = adapt_feedforward(p.gain_Gamma, e[i], zc[i]) + p.gain_Gamma * missed


def symmetric(Q: Any, n: int) -> Any:
    """Return a matrix made of its upper triangle, shape (n, n)."""
    Q = np.triu(np.reshape(Q, (n, n)))
    return Q + np.triu(Q, 1).T


def gains_kept(s: Any, truth: Truth) -> dict[str, Any]:
    """Return what the states are at all times: Q_i = Q_i^T, b_i = Q_i kappa_D."""
    Q = [symmetric(s[f"Q_{i + 1}"], 2) for i in range(2)]
    b = [Q[i] @ np.array([truth.KD[i], truth.GammaD[i]]) for i in range(2)]
    return {"Q_1": Q[0], "Q_2": Q[1], "b_v": np.concatenate(b)}


def gains_losses(s: Any, p: Any, truth: Truth) -> list[tuple]:
    """Return what V' loses: (kappa - kappa_D)^T Q_i (kappa - kappa_D), where they adapt."""
    found = []
    for i in range(2):
        off = [s["K"][i] - truth.KD[i], s["Gamma"][i] - truth.GammaD[i]]
        Q = np.reshape(s[f"Q_{i + 1}"], (2, 2))
        found.append((np.array(off) @ Q @ np.array(off),))
    return found
