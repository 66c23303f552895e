"""The controlled Lagrangian prediction error, Eq. (10), and its systems, Eqs. (27)-(28).

    e    = x - z                                  Eq. (10)
    e'   = -KD e + W^T eta                        Eq. (27)
    eta' = -gamma W e                             Eq. (28), lower rows

e is true position minus predicted position (length).  In the wired diagram e' follows from x' and
z'; the other lines of Eq. (10) are not repeated here.

In the error system and the parameter system, eta = [theta + alpha (row by row), K - KD,
GammaD - Gamma] for each axis; the last two are the ports eta_3 and eta_4.  Column i of the
regressor W is phi(x) in row block i, z_i and zc_i.  The print of Eq. (27) has x where Eqs. (28)
and (31) need z, and the lower rows of A in Eq. (28) miss their transposes; these are the
corrected forms.

Ports: x[2], z[2] (length) -> e[2] (length);
phi_x[N], z[2], zc[2] (length), eta[2N], eta_3[2], eta_4[2] -> e[2] (length), a state;
e[2], phi_x[N], z[2], zc[2] -> eta[2N], eta_3[2], eta_4[2], states.
"""

from typing import Any

import numpy as np

from ...engine.model.block import Block
from .ports import paper_block


def error(t, x, u, p):
    """e' = -KD e + W^T eta, Eq. (27)."""
    return -p.KD * x.e + u.eta @ u.phi_x + u.z * u.eta_3 + u.zc * u.eta_4


def parameter(t, x, u, p):
    """eta' = -gamma W e, the lower rows of Eq. (28)."""
    return {
        "eta": -p.gain * np.outer(u.e, u.phi_x),
        "eta_3": -p.gain * u.z * u.e,
        "eta_4": -p.gain * u.zc * u.e,
    }


def error_system(N: int, KD: Any) -> Block:
    """Make the error system, Eq. (27); the gains KD are per time."""
    ports = "phi_x z zc eta eta_3 eta_4 -> e"
    return paper_block("error_system", ports, {"KD": KD}, N, update=error)


def parameter_system(N: int, gain: float) -> Block:
    """Make the parameter system, the lower rows of Eq. (28), with the gain gamma."""
    ports = "e phi_x z zc -> eta eta_3 eta_4"
    return paper_block("parameter_system", ports, {"gain": gain}, N, update=parameter)


def prediction_error(t, x, u, p):
    """e = x - z, Eq. (10)."""
    return u.x - u.z


def clpe() -> Block:
    """Make the block of the prediction error, Eq. (10)."""
    return paper_block("clpe", "x z -> e", output=prediction_error)
