"""The learning model, Eq. (2), its controller, Eq. (6), and the injections.

    dz/dt = F_M(z, t) + v                                               Eq. (2)
    dz/dt = F_M(z, t) + v - d                                           Eq. (2), hedged
    v = -alpha phi(z) - K z + Gamma zc + Psi                            Eq. (6)
    Psi = (theta_hat - alpha_M) phi(x)                                  Eq. (13)
    Psi = -(alpha_M + alpha) phi(x) - (alpha_M - alpha) phi(z)          Eq. (20)

z is the predicted position (length); Eq. (13) belongs to the known-flow law,
Eq. (20) to the learned-flow law, where alpha is driven to -theta.  In Eqs.
(12)-(13) the estimate theta_hat stands where the print lost the hat; it is given, or comes
from a law that estimates it.  d is what the vehicle could not fly of its commanded velocity
(`speed_limit`).

| block | inputs | output |
|---|---|---|
| learning_model | flow_z[2], v_z[2], hedged unflown[2] (length per time) | z[2] (length), a state |
| learning_controller | z[2], zc[2], phi_z[N], alpha[2N], K[2], Gamma[2], psi[2] | v_z[2] |
| injection | phi_x[N], phi_z[N], alpha[2N] or theta_hat[2N] (length per time) | psi[2] (the same) |
"""

from typing import NamedTuple

import numpy as np

from ..equations.block import Block


class LearnerParameters(NamedTuple):
    """The number of basis functions of the learning controller."""

    N: int  # number of basis functions


class KnownFlowInjectionParameters(NamedTuple):
    """What Eq. (13) knows of the flow."""

    N: int  # number of basis functions
    theta_hat: np.ndarray  # shape (2, N), estimate of theta, length per time
    alpha_M: np.ndarray  # shape (2, N), length per time


class EstimatedFlowInjectionParameters(NamedTuple):
    """What Eq. (13) knows beside the estimate, a signal."""

    N: int  # number of basis functions
    alpha_M: np.ndarray  # shape (2, N), length per time


class LearnedFlowInjectionParameters(NamedTuple):
    """What Eq. (20) knows of the flow."""

    N: int  # number of basis functions
    alpha_M: np.ndarray  # shape (2, N), length per time


def model(t, x, u, p, dx):
    """z' = F_M + v, Eq. (2): u = flow_z[2], v_z[2] (length per time), state z[2]."""
    for i in range(2):
        dx[i] = u[i] + u[2 + i]


def hedged_model(t, x, u, p, dx):
    """z' = F_M + v - d, Eq. (2) hedged: u = flow_z[2], v_z[2], unflown[2], state z[2]."""
    model(t, x, u, p, dx)
    for i in range(2):
        dx[i] -= u[4 + i]


def controller(t, x, u, p, y):
    """v = -alpha phi(z) - K z + Gamma zc + Psi, Eq. (6).

    u = z[2], zc[2], phi_z[N], alpha[2N], K[2], Gamma[2], psi[2]; y = v_z[2].
    """
    n = p.N
    z, zc, phi, alpha = u[0:2], u[2:4], u[4 : 4 + n], u[4 + n : 4 + 3 * n]
    K, Gamma, psi = u[4 + 3 * n : 6 + 3 * n], u[6 + 3 * n : 8 + 3 * n], u[8 + 3 * n : 10 + 3 * n]
    for i in range(2):
        cancelled = 0.0
        for k in range(n):
            cancelled += alpha[i * n + k] * phi[k]
        y[i] = -cancelled - K[i] * z[i] + Gamma[i] * zc[i] + psi[i]


def estimate_injected(theta_hat, alpha_M, phi, n):
    """Return (theta_hat - alpha_M) phi(x) of one axis, Eq. (13)."""
    injected = 0.0
    for k in range(n):
        injected += (theta_hat[k] - alpha_M[k]) * phi[k]
    return injected


def known_flow(t, x, u, p, y):
    """Psi = (theta_hat - alpha_M) phi(x), Eq. (13).

    u = phi_x[N], phi_z[N], alpha[2N] (of which phi_x is used); y = psi[2].
    """
    for i in range(2):
        y[i] = estimate_injected(p.theta_hat[i], p.alpha_M[i], u, p.N)


def estimated_flow(t, x, u, p, y):
    """Psi of Eq. (13) with the estimate a signal: u = phi_x[N], theta_hat[2N]; y = psi[2]."""
    n = p.N
    for i in range(2):
        y[i] = estimate_injected(u[n + i * n : 2 * n + i * n], p.alpha_M[i], u, n)


def learned_flow(t, x, u, p, y):
    """Psi = -(alpha_M + alpha) phi(x) - (alpha_M - alpha) phi(z), Eq. (20).

    u = phi_x[N], phi_z[N], alpha[2N]; y = psi[2] (length per time).
    """
    n = p.N
    phi_x, phi_z, alpha = u[0:n], u[n : 2 * n], u[2 * n : 4 * n]
    for i in range(2):
        injected = 0.0
        for k in range(n):
            injected -= (p.alpha_M[i, k] + alpha[i * n + k]) * phi_x[k]
            injected -= (p.alpha_M[i, k] - alpha[i * n + k]) * phi_z[k]
        y[i] = injected


def learning_model(hedged: bool = False) -> Block:
    """Make the learning model, Eq. (2), or with the input unflown, hedged."""
    inputs = {"flow_z": 2, "v_z": 2} | ({"unflown": 2} if hedged else {})
    update = hedged_model if hedged else model
    return Block("learning_model", update=update, inputs=inputs, states={"z": 2})


def learning_controller(N: int) -> Block:
    """Make the learning controller, Eq. (6)."""
    return Block(
        "learning_controller",
        output=controller,
        inputs={"z": 2, "zc": 2, "phi_z": N, "alpha": 2 * N, "K": 2, "Gamma": 2, "psi": 2},
        outputs={"v_z": 2},
        parameters=LearnerParameters(N),
    )


def injection(
    parameters: KnownFlowInjectionParameters
    | EstimatedFlowInjectionParameters
    | LearnedFlowInjectionParameters,
) -> Block:
    """Make the learning injection, Eq. (13) or (20), by the class of its parameters."""
    known = isinstance(parameters, KnownFlowInjectionParameters)
    N = parameters.N
    if isinstance(parameters, EstimatedFlowInjectionParameters):
        return Block(
            "injection",
            output=estimated_flow,
            inputs={"phi_x": N, "theta_hat": 2 * N},
            outputs={"psi": 2},
            parameters=parameters,
        )
    return Block(
        "injection",
        output=known_flow if known else learned_flow,
        inputs={"phi_x": N, "phi_z": N, "alpha": 2 * N},
        outputs={"psi": 2},
        parameters=parameters,
    )
