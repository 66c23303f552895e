"""The dead-zone law: nothing is learned of an error that a disturbance may have made.

    D_i(e) = e_i - clip(e_i, -d, d)
    alpha' = -gamma D phi^T,    K' = -gamma z D,    Gamma' = gamma zc D

are Eqs. (21)-(23) with D in place of e, continuous at d = `zone`.  V is Eq. (24) with D in place
of e.  Since D D' = D e' everywhere, and D_i e_i = |D_i| (|D_i| + d) where D_i is not zero,

    V' = -D^T KD e + D^T Delta <= -D^T KD D    where |Delta_i| <= KD_i d

so V never rises, what is learned stays bounded, and |e_i| comes to at most d.

Source: Ioannou and Sun 1996, section 8.4.3.

Ports: e[2] (length), phi_x[N], z[2], zc[2] (length) -> alpha[2N] (length per time), K[2],
Gamma[2] (per time), the states; of V: e[2], alpha[2N], K[2], Gamma[2] -> V[1].
"""

from typing import Any, NamedTuple

import numpy as np

from ...equations.block import Block
from ..lyapunov import LyapunovParameters, learned_flow, weighed
from ..words import clip
from .law import Known, Law, Setting, Truth
from .leakage import law_block
from .learned_flow import adapt_axis


class DeadZoneParameters(NamedTuple):
    """Parameters of the dead-zone law."""

    N: int  # number of basis functions
    gain: float  # gamma > 0 of alpha, as in Eqs. (21)-(23)
    gain_K: float  # of K, 0 to hold it
    gain_Gamma: float  # of Gamma, 0 to hold it
    zone: float  # d > 0, length: at least |Delta_i|/KD_i


class DeadZoneLyapunov(NamedTuple):
    """The true parameters that V measures the distance to, and the zone."""

    N: int  # number of basis functions
    gain: np.ndarray  # shape (2, N), gamma > 0 of alpha
    gain_K: np.ndarray  # shape (2,), gamma of K
    gain_Gamma: np.ndarray  # shape (2,), gamma of Gamma
    theta: np.ndarray  # shape (2, N), length per time
    KD: np.ndarray  # shape (2,), feedback gains of the vehicle, per time
    GammaD: np.ndarray  # shape (2,), feedforward gains, per time
    zone: float  # d > 0, length


def beyond(e, zone):
    """Return D(e) = e - clip(e, -d, d)."""
    return e - clip(e, -zone, zone)


def update(t, x, u, p, dx):
    """Eqs. (21)-(23) with D(e) in place of e.

    u = e[2], phi_x[N], z[2], zc[2]; states alpha[2N], K[2], Gamma[2].
    """
    for i in range(2):
        adapt_axis(i, beyond(u[i], p.zone), u, p, dx)


def candidate(t, x, u, p, y):
    """V of Eq. (24) with D(e) in place of e: u = e[2], alpha[2N], K[2], Gamma[2]; y = V[1]."""
    learned_flow(t, x, u, p, y)
    for i in range(2):
        y[0] += (beyond(u[i], p.zone) ** 2 - u[i] ** 2) / 2


def dead_zone(known: Known) -> Block:
    """Make the law `dead-zone`."""
    zone = known.setting("zone", known.reach / 50)
    return law_block(update, DeadZoneParameters(known.N, *known.gains[:3], zone))


def V(p: Any, truth: Truth) -> Block:
    """Make V of the dead-zone law."""
    own: LyapunovParameters = weighed((p.gain, p.gain_K, p.gain_Gamma), *truth)
    return Block(
        "lyapunov",
        output=candidate,
        inputs={"e": 2, "alpha": 2 * p.N, "K": 2, "Gamma": 2},
        outputs={"V": 1},
        parameters=DeadZoneLyapunov(*own, p.zone),
    )


LAW = Law(
    "dead-zone",
    promise="where the disturbance is at most KD times the zone, CLPE comes to the zone and V "
    "never rises",
    needs="a zone as large as the disturbance over KD",
    block=dead_zone,
    V=V,
    settings={
        "zone": Setting(
            None,
            "positive",
            "CLPE of which nothing is learned, length; a fiftieth of the "
            "farthest waypoint's distance",
        )
    },
)
