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

from typing import Any

from ..equations.block import Block

ROWS = (2, "N")  # the shape of alpha, alpha_M and theta_hat


def model(t, x, u, p):
    """z' = F_M + v, Eq. (2)."""
    return u.flow_z + u.v_z


def hedged_model(t, x, u, p):
    """z' = F_M + v - d, Eq. (2) hedged."""
    return model(t, x, u, p) - u.unflown


def controller(t, x, u, p):
    """v = -alpha phi(z) - K z + Gamma zc + Psi, Eq. (6)."""
    return -(u.alpha @ u.phi_z) - u.K * u.z + u.Gamma * u.zc + u.psi


def known_flow_psi(t, x, u, p):
    """Psi = (theta_hat - alpha_M) phi(x), Eq. (13)."""
    return (p.theta_hat - p.alpha_M) @ u.phi_x


def estimated_flow_psi(t, x, u, p):
    """Psi of Eq. (13) with the estimate a signal."""
    return (u.theta_hat - p.alpha_M) @ u.phi_x


def learned_flow_psi(t, x, u, p):
    """Psi = -(alpha_M + alpha) phi(x) - (alpha_M - alpha) phi(z), Eq. (20)."""
    return -(p.alpha_M + u.alpha) @ u.phi_x - (p.alpha_M - u.alpha) @ u.phi_z


def learning_model(hedged: bool = False) -> Block:
    """Make the learning model, Eq. (2), or with the input unflown, hedged."""
    inputs = {"flow_z": 2, "v_z": 2} | ({"unflown": 2} if hedged else {})
    update = hedged_model if hedged else model
    return Block("learning_model", update=update, inputs=inputs, states={"z": 2})


def learning_controller(N: int) -> Block:
    """Make the learning controller, Eq. (6), of N basis functions."""
    return Block(
        "learning_controller",
        output=controller,
        inputs={"z": 2, "zc": 2, "phi_z": "N", "alpha": ROWS, "K": 2, "Gamma": 2, "psi": 2},
        outputs={"v_z": 2},
        sizes={"N": N},
    )


LEARNED = {"phi_x": "N", "phi_z": "N", "alpha": ROWS}


def known_flow_injection(theta_hat: Any, alpha_M: Any) -> Block:
    """Make the injection of a given estimate, Eq. (13)."""
    return _injection(known_flow_psi, LEARNED, theta_hat=theta_hat, alpha_M=alpha_M)


def estimated_flow_injection(alpha_M: Any) -> Block:
    """Make the injection of an estimate that a law makes, Eq. (13)."""
    return _injection(estimated_flow_psi, {"phi_x": "N", "theta_hat": ROWS}, alpha_M=alpha_M)


def learned_flow_injection(alpha_M: Any) -> Block:
    """Make the injection of the learned-flow law, Eq. (20)."""
    return _injection(learned_flow_psi, LEARNED, alpha_M=alpha_M)


def _injection(output: Any, inputs: dict[str, Any], **parameters: Any) -> Block:
    return Block(
        "injection",
        output=output,
        inputs=inputs,
        outputs={"psi": 2},
        parameters=parameters,
        shapes=dict.fromkeys(parameters, ROWS),
    )
