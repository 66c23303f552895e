"""How a current wanders between dives: a walk, a trend, an eddying part.

    du = a dt + q dw,  da = -a/F dt + s dw,  s^2 = 2 A^2 / F
    dv = -v/tau dt + sqrt(2/tau) S dw,       flow = u + v

q alone is a random walk.  A trend a fades in F: a manoeuvring target (R. A.
Singer, "Estimating optimal tracking filter performance for manned maneuvering
targets", IEEE Trans. Aerospace and Electronic Systems 6, 473-483, 1970), as a
vehicle sees it that crosses an eddy or a jet.  An eddying part v of size S is
forgotten in tau and returns to the steady current.  Over a time t, with x = t/F,
r = exp(-x) and b = exp(-t/tau),

    a <- r a,  u <- u + F (1 - r) a,  v <- b v
    var a  += A^2 (1 - r^2)
    cov ua += A^2 F (1 - r)^2
    var u  += A^2 F^2 (2x - 3 + 4r - r^2) + q^2 t
    var v  += S^2 (1 - b^2)

The state of one filter is (a_east, a_north, v_east, v_north, u_east, u_north).
"""

import math

import numpy as np

from .priors import QUARTER_DAY, Kind, Priors


def wander(dt: float, kinds: Kind, priors: Priors) -> tuple[np.ndarray, np.ndarray]:
    """Return F and Q of (a, v, u) over `dt` s, (m, 6, 6) each, for m kinds."""
    fading = priors.trend_fading
    x, r = dt / fading, math.exp(-dt / fading)
    b = math.exp(-dt / priors.eddy_memory)
    A2 = (kinds.trend / QUARTER_DAY) ** 2
    m = len(kinds.walk)
    F, Q = np.tile(np.eye(6), (m, 1, 1)), np.zeros((m, 6, 6))
    for a, v, u in ((0, 2, 4), (1, 3, 5)):
        F[:, a, a], F[:, v, v] = r, b
        F[:, u, a] = fading * (1 - r)
        Q[:, a, a] = A2 * (1 - r**2)
        Q[:, a, u] = Q[:, u, a] = A2 * fading * (1 - r) ** 2
        Q[:, u, u] = (
            A2 * fading**2 * max(0.0, 2 * x - 3 + 4 * r - r**2) + kinds.walk**2 * dt / QUARTER_DAY
        )
        Q[:, v, v] = kinds.eddy**2 * (1 - b**2)
    return F, Q
