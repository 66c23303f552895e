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

import numpy as np

from .. import lyapunov
from .known import Setting
from .law import GAINS, Law, promised
from .learned_flow import driven_by


def beyond(e, zone):
    """Return D(e) = e - clip(e, -d, d)."""
    return e - np.clip(e, -zone, zone)


def dead_zone(t, x, u, p):
    """Eqs. (21)-(23) with D(e) in place of e."""
    return driven_by(beyond(u.e, p.zone), u, p)


def candidate(t, x, u, p):
    """V of Eq. (24) with D(e) in place of e."""
    return {"V": lyapunov.level(beyond(u.e, p.zone), u, p) + lyapunov.flow_level(u, p)}


LAW = Law(
    "dead-zone",
    promise="where the disturbance is at most KD times the zone, CLPE comes to the zone and V "
    "never rises",
    needs="a zone as large as the disturbance over KD",
    rates=dead_zone,
    parameters={
        **GAINS,
        "zone": Setting(
            "CLPE of which nothing is learned, length; a fiftieth of the farthest waypoint's "
            "distance",
            lambda known: known.reach / 50,
        ),
    },
    candidate=candidate,
    promises=promised("true small exact", "falls", "zone"),
)
