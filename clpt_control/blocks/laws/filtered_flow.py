"""The flow and the basis through one filter l/(s + l): a regression with no derivative measured.

    phi_f' = l (phi(x) - phi_f),    q' = l (l x + v - q),    F_f = l x - q

By Eq. (1), x' - v = F, so F_f' = l (F - F_f): F_f is the flow through the filter, made of the
position x and the velocity v through the water alone.  With phi_f(0) = 0 and q(0) = l x(0) it is
theta phi_f at all times, whatever theta is, and eps = F_f - theta_hat phi_f = (theta + alpha)
phi_f.  The laws that learn by it have K and Gamma of `commanded_gains`, and a layout:

    alpha[2N], K[2], Gamma[2], phi_f[N], q[2], Q_1[4], Q_2[4], b_v[4], and from `own(N)` on theirs

Source: Slotine and Li 1989, Automatica 25(4), composite adaptive control.

Ports: e[2], z[2], zc[2], x[2] (length), phi_x[N], v_x[2], and v_c[2] where the speed is limited
(length per time); states phi_f[N], q[2] (length per time).
"""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from ...equations.block import Block
from .commanded_gains import STATES, gain_rates, gains_kept
from .law import Known, Truth

MADE_OF = ("vehicle.feedback", "vehicle.position")  # keys of every such law


def filter_rates(dx, at, x, phi, position, v, pole, n):
    """Fill phi_f' and q', which stand from `at` on, after the filter's equations above."""
    for k in range(n):
        dx[at + k] = pole * (phi[k] - x[at + k])
    for i in range(2):
        dx[at + n + i] = pole * (pole * position[i] + v[i] - x[at + n + i])


def filtered_flow(position, q, pole):
    """Return F_f = l x - q of one axis, length per time."""
    return pole * position - q


def own(N):
    """Return where a law's own states begin."""
    return 3 * N + 18


def shared_rates(x, u, p, dx):
    """Fill K', Gamma' and the rates of all states that are not the law's own but alpha'.

    u = e[2], phi_x[N], z[2], zc[2], x[2], v_x[2], and v_c[2] where the speed is limited.
    """
    n = p.N
    e, phi, z, zc = u[0:2], u[2 : 2 + n], u[2 + n : 4 + n], u[4 + n : 6 + n]
    position, v, at = u[6 + n : 8 + n], u[8 + n : 10 + n], 2 * n + 4
    filter_rates(dx, at, x, phi, position, v, p.filter, n)
    gain_rates(dx, x, p, at + n + 2, e, phi, z, zc, position, u[-2:])


def unexplained(x, u, p, i):
    """Return eps = F_f - theta_hat phi_f of axis i, theta_hat = -alpha; length per time."""
    at = 2 * p.N + 4
    eps = filtered_flow(u[6 + p.N + i], x[at + p.N + i], p.filter)
    for k in range(p.N):
        eps += x[i * p.N + k] * x[at + k]
    return eps


def filtered_law(
    update: Callable, parameters: Any, states: Mapping[str, int], limited: bool = False
) -> Block:
    """Make a law that learns by the regression; `states` are its own."""
    N = parameters.N
    shared = {"alpha": 2 * N, "K": 2, "Gamma": 2, "phi_f": N, "q": 2, **STATES}
    return Block(
        "adaptation",
        update=update,
        inputs={
            **{"e": 2, "phi_x": N, "z": 2, "zc": 2, "x": 2, "v_x": 2},
            **({"v_c": 2} if limited else {}),
        },
        states={**shared, **states},
        parameters=parameters,
    )


def filter_starts(known: Known, pole: float) -> dict[str, np.ndarray]:
    """Return phi_f(0) = 0 and q(0) = l x(0)."""
    return {"phi_f": np.zeros(known.N), "q": pole * known.position}


def shared_starts(known: Known, pole: float) -> dict[str, np.ndarray]:
    """Return the filter's start and an empty memory of K and Gamma."""
    empty = {port: np.zeros(size) for port, size in STATES.items()}
    return {**filter_starts(known, pole), **empty}


def filter_kept(s: Any, p: Any, truth: Truth) -> dict[str, Any]:
    """Return what the filter's states are at all times: F_f = theta phi_f."""
    return {"q": p.filter * s["x"] - truth.theta @ s["phi_f"]}


def shared_kept(s: Any, p: Any, truth: Truth) -> dict[str, Any]:
    """Return what the shared states are at all times: F_f = theta phi_f, b_i = Q_i kappa_D."""
    return {**filter_kept(s, p, truth), **gains_kept(s, truth)}


def unexplained_square(s: Any, p: Any, truth: Truth) -> Any:
    """Return |eta phi_f|^2, eta = theta + alpha."""
    return sum(((truth.theta + s["alpha"].reshape(2, p.N)) @ s["phi_f"]) ** 2)
