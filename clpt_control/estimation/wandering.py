"""How a current wanders between dives: a walk, a trend, an eddying part.

    du = a dt + q dw,  da = -a/FADING dt + s dw,  s^2 = 2 A^2 / FADING
    dv = -v/tau dt + sqrt(2/tau) S dw,            flow = u + v

Three kinds of current, each on a grid of sizes.  A random walk, q alone.  A
trend a that fades, A besides: a manoeuvring target (R. A. Singer, "Estimating
optimal tracking filter performance for manned maneuvering targets", IEEE Trans.
Aerospace and Electronic Systems 6, 473-483, 1970), as a vehicle sees it that
crosses an eddy or a jet.  And an eddying part v of size S that is forgotten in
tau and returns to the steady current.  Over a time t, with x = t/FADING,
r = exp(-x) and b = exp(-t/tau),

    a <- r a,  u <- u + FADING (1 - r) a,  v <- b v
    var a  += A^2 (1 - r^2)
    cov ua += A^2 FADING (1 - r)^2
    var u  += A^2 FADING^2 (2x - 3 + 4r - r^2) + q^2 t
    var v  += S^2 (1 - b^2)

The state of one filter is (a_east, a_north, v_east, v_north, u_east, u_north).
"""

import math
from typing import NamedTuple

import numpy as np

QUARTER_DAY = 21600.0  # s, the time that walks and trends are given for
TREND_FADING = 43200.0  # s, of a trend: half a day, some dives
WALKS = (0.003, 0.01, 0.03, 0.06, 0.12, 0.25)  # q, m/s per sqrt(6 h)
TRENDS = (0.01, 0.03, 0.1)  # A, m/s per 6 h
EDDIES = (0.05, 0.1, 0.2)  # S, m/s
MEMORIES = (21600.0, 86400.0)  # tau, s
USUAL, SPREAD = (0.04, 0.03, 0.1), 1.5  # usual q, A and S; spread of their logarithms
SHARES = (0.4, 0.3, 0.3)  # of currents that walk, that have a trend, that eddy


class Kinds(NamedTuple):
    """Ways of wandering, k of them.

    `walk` q (m/s per sqrt(6 h)), `trend` A (m/s per 6 h), `eddy` S (m/s),
    `memory` tau (s) and `log_prior`, each of shape (k,).
    """

    walk: np.ndarray
    trend: np.ndarray
    eddy: np.ndarray
    memory: np.ndarray
    log_prior: np.ndarray


def kinds() -> Kinds:
    """Return the ways of wandering that a bank compares.

    Returns
    -------
    Kinds

    Examples
    --------
    >>> len(kinds().walk), kinds().trend.max()
    (15, np.float64(0.1))
    """
    least, tau = WALKS[0], MEMORIES[0]
    rows = [(q, 0.0, 0.0, tau, 0, q) for q in WALKS]
    rows += [(least, A, 0.0, tau, 1, A) for A in TRENDS]
    rows += [(least, 0.0, S, memory, 2, S) for S in EDDIES for memory in MEMORIES]
    walk, trend, eddy, memory, kind, size = np.array(rows).T
    which = kind.astype(int)
    weight = np.exp(-0.5 * (np.log(size / np.array(USUAL)[which]) / SPREAD) ** 2)
    share = np.array(SHARES)[which] * weight / np.bincount(which, weight)[which]
    return Kinds(walk, trend, eddy, memory, np.log(share))


def wander(dt: float, kinds: Kinds) -> tuple[np.ndarray, np.ndarray]:
    """Return how trend, eddies and current go on, and what chance adds.

    Parameters
    ----------
    dt : float
        Time, s, not negative.
    kinds : Kinds
        One per filter, m of them.

    Returns
    -------
    F : ndarray, shape (m, 6, 6)
    Q : ndarray, shape (m, 6, 6)
        Of (a, v, u), m/s^2 and m/s.

    Examples
    --------
    >>> F, Q = wander(21600.0, kinds())
    >>> round(float(Q[2, 4, 4]), 6)
    0.0009
    """
    x, r = dt / TREND_FADING, math.exp(-dt / TREND_FADING)
    b = np.exp(-dt / kinds.memory)
    A2 = (kinds.trend / QUARTER_DAY) ** 2
    m = len(b)
    F, Q = np.tile(np.eye(6), (m, 1, 1)), np.zeros((m, 6, 6))
    for a, v, u in ((0, 2, 4), (1, 3, 5)):
        F[:, a, a], F[:, v, v] = r, b
        F[:, u, a] = TREND_FADING * (1 - r)
        Q[:, a, a] = A2 * (1 - r**2)
        Q[:, a, u] = Q[:, u, a] = A2 * TREND_FADING * (1 - r) ** 2
        Q[:, u, u] = (
            A2 * TREND_FADING**2 * max(0.0, 2 * x - 3 + 4 * r - r**2)
            + kinds.walk**2 * dt / QUARTER_DAY
        )
        Q[:, v, v] = kinds.eddy**2 * (1 - b**2)
    return F, Q
