"""The projection law: what is learned stays within a ball.

    a' = r - c a max(r^T a, 0)/max(|a|^2, M^2),    c = clip((|a|^2 - M^2)/(R^2 - M^2), 0, 1)

r is the rate of Eqs. (21)-(23), a each of alpha, K and Gamma, with its own limit M;
R = (1 + layer) M.  Of r only the part that points outward is taken away, more
and more between the norms M and R, so that a' stays continuous; beyond R all of it:

    (|a|^2/2)' = r^T a - max(r^T a, 0) <= 0    where |a| >= R, whatever drives e

so |a| never grows beyond the larger of R and |a(0)|.  With V of Eq. (24), the true value a* and
|a*| <= M, what is taken away never raises V: a^T (a - a*) >= |a| (|a| - |a*|) >= 0 where c > 0.

Source: Ioannou and Sun 1996, section 8.5; the continuous form of Pomet and Praly 1992.

Ports: e[2] (length), phi_x[N], z[2], zc[2] (length) -> alpha[2N] (length per time), K[2],
Gamma[2] (per time), the states.
"""

import numpy as np

from .known import Setting
from .law import GAINS, Law, promised
from .leakage import LIMITS, beyond_limits
from .learned_flow import learned_flow


def kept_within(a, rate, largest, layer):
    """Return the rate of a without the part of it that points outward."""
    squares, inner = np.sum(a * a), largest**2
    share = np.clip((squares - inner) / (inner * layer * (2 + layer)), 0, 1)
    return rate - share * np.maximum(np.sum(rate * a), 0) / np.maximum(squares, inner) * a


def projection(t, x, u, p):
    """Eqs. (21)-(23), alpha, K and Gamma each kept within a ball."""
    r = learned_flow(t, x, u, p)
    return {
        "alpha": kept_within(x.alpha, r["alpha"], p.largest_flow, p.layer),
        "K": kept_within(x.K, r["K"], p.largest_feedback, p.layer),
        "Gamma": kept_within(x.Gamma, r["Gamma"], p.largest_feedforward, p.layer),
    }


LAW = Law(
    "projection",
    promise="what is learned stays within balls whatever happens; without disturbance CLPE goes "
    "to zero where the truth lies within",
    needs="limits of the flow parameters and gains, and a start within them",
    rates=projection,
    promises=(
        *promised("", "balls"),
        *promised("true within spanned exact", "falls", "settles"),
        *promised("true within exact", "mean square"),
    ),
    parameters={
        **GAINS,
        **LIMITS,
        "layer": Setting("how far beyond a limit, as a share of it", 0.1),
    },
    doubt=beyond_limits,
)
