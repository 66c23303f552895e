"""The learning model, Eq. (2), its controller, Eq. (6), and the injections.

    dz/dt = F_M(z, t) + v                                               Eq. (2)
    dz/dt = F_M(z, t) + v - d                                           Eq. (2), hedged
    v = -alpha phi(z) - K z + Gamma zc + Psi                            Eq. (6)
    Psi = (theta_hat - alpha_M) phi(x)                                  Eq. (13)
    Psi = -(alpha_M + alpha) phi(x) - (alpha_M - alpha) phi(z)          Eq. (20)

Eq. (2) with Eqs. (4) and (6) is the learner's closed loop, Eq. (8).
z is the predicted position (length).  The known-flow law uses Eq. (13), the learned-flow law
Eq. (20), where alpha converges to -theta.  Eq. (12) is Eq. (13) with theta_hat = theta, the
estimate that is given or estimated by a law.  With hedging, d is the commanded
velocity minus the flown velocity (`speed_limit`).

| block | inputs | output |
|---|---|---|
| learning_model | flow_z[2], v_z[2], hedged unflown[2] (length per time) | z[2] (length), a state |
| learning_controller | z[2], zc[2], phi_z[N], alpha[2N], K[2], Gamma[2], psi[2] | v_z[2] |
| injection | phi_x[N], phi_z[N], alpha[2N] or theta_hat[2N] (length per time) | psi[2] (the same) |
"""

from typing import Any

from ...engine.model.block import Block
from .ports import paper_block


def model(t, x, u, p):
    """z' = F_M + v, Eq. (2), minus d if hedged."""
    rate = u.flow_z + u.v_z
    unflown = getattr(u, "unflown", None)
    return rate if unflown is None else rate - unflown


def controller(t, x, u, p):
    """v = -alpha phi(z) - K z + Gamma zc + Psi, Eq. (6)."""
    return -(u.alpha @ u.phi_z) - u.K * u.z + u.Gamma * u.zc + u.psi


def known_flow_psi(t, x, u, p):
    """Psi = (theta_hat - alpha_M) phi(x), Eq. (13); theta_hat is a signal or a parameter."""
    estimate = getattr(u, "theta_hat", None)
    if estimate is None:
        estimate = p.theta_hat
    return (estimate - p.alpha_M) @ u.phi_x


def learned_flow_psi(t, x, u, p):
    """Psi = -(alpha_M + alpha) phi(x) - (alpha_M - alpha) phi(z), Eq. (20)."""
    return -(p.alpha_M + u.alpha) @ u.phi_x - (p.alpha_M - u.alpha) @ u.phi_z


def learning_model(hedged: bool = False) -> Block:
    """Make the learning model, Eq. (2); with hedging it has the input unflown."""
    ports = "flow_z v_z unflown -> z" if hedged else "flow_z v_z -> z"
    return paper_block("learning_model", ports, update=model)


def learning_controller(N: int) -> Block:
    """Make the learning controller, Eq. (6), of N basis functions."""
    ports = "z zc phi_z alpha K Gamma psi -> v_z"
    return paper_block("learning_controller", ports, N=N, output=controller)


def known_flow_injection(alpha_M: Any, theta_hat: Any = None) -> Block:
    """Make the injection of Eq. (13) of a given estimate, or of the signal theta_hat."""
    parameters = {"alpha_M": alpha_M}
    ports = "phi_x theta_hat -> psi"
    if theta_hat is not None:
        parameters["theta_hat"] = theta_hat
        ports = "phi_x phi_z alpha -> psi"
    return paper_block("injection", ports, parameters, output=known_flow_psi)


def learned_flow_injection(alpha_M: Any) -> Block:
    """Make the injection of the learned-flow law, Eq. (20)."""
    ports = "phi_x phi_z alpha -> psi"
    parameters = {"alpha_M": alpha_M}
    return paper_block("injection", ports, parameters, output=learned_flow_psi)
