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

from typing import NamedTuple

from ...equations.block import Block
from ..words import clip, maximum
from .law import Known, Law, Setting
from .leakage import LIMITS, V, law_block, limits
from .learned_flow import learned_flow


class ProjectionParameters(NamedTuple):
    """Parameters of the projection law."""

    N: int  # number of basis functions
    gain: float  # gamma > 0 of alpha, as in Eqs. (21)-(23)
    gain_K: float  # of K, 0 to hold it
    gain_Gamma: float  # of Gamma, 0 to hold it
    largest_flow: float  # M, of alpha over both axes, length per time
    largest_feedback: float  # M of K, per time
    largest_feedforward: float  # M of Gamma, per time
    layer: float  # R/M - 1 > 0


def keep_within(x, first, last, largest, layer, dx):
    """Take away the outward part of the rates of the states from first to last."""
    squares, outward = 0.0, 0.0
    for j in range(first, last):
        squares += x[j] ** 2
        outward += dx[j] * x[j]
    inner = largest**2
    share = clip((squares - inner) / (inner * layer * (2.0 + layer)), 0.0, 1.0)
    taken = share * maximum(outward, 0.0) / maximum(squares, inner)
    for j in range(first, last):
        dx[j] -= taken * x[j]


def update(t, x, u, p, dx):
    """Eqs. (21)-(23), alpha, K and Gamma each kept within a ball.

    u = e[2], phi_x[N], z[2], zc[2]; states alpha[2N], K[2], Gamma[2].
    """
    n = 2 * p.N
    learned_flow(t, x, u, p, dx)
    keep_within(x, 0, n, p.largest_flow, p.layer, dx)
    keep_within(x, n, n + 2, p.largest_feedback, p.layer, dx)
    keep_within(x, n + 2, n + 4, p.largest_feedforward, p.layer, dx)


def projection(known: Known) -> Block:
    """Make the law `projection`."""
    layer = known.settings["layer"]
    p = ProjectionParameters(known.N, *known.gains[:3], *limits(known), layer)
    return law_block(update, p)


LAW = Law(
    "projection",
    promise="what is learned stays within balls whatever happens; without disturbance CLPE goes "
    "to zero where the truth lies within",
    needs="limits of the flow parameters and gains, and a start within them",
    block=projection,
    V=V,
    settings={
        **LIMITS,
        "layer": Setting(0.1, "positive", "how far beyond a limit, as a share of it"),
    },
    made_of=("vehicle.feedback",),
)
