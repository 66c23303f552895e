"""The paper's learned-flow law, Eqs. (21)-(23): alpha, K and Gamma adapt.

    alpha' = -gamma e phi(x)^T                    Eq. (21)
    K'     = -gamma z e                           Eq. (22)
    Gamma' =  gamma zc e                          Eq. (23)

alpha is driven to -theta where the track excites.  V of Eq. (24) has V' = -e^T KD e, so e goes
to zero, Theorem 3.2.  Source: Cho, Zhang, Edwards 2016, section III.

Ports: e[2] (length), phi_x[N], z[2], zc[2] (length) -> alpha[2N] (length per time), K[2],
Gamma[2] (per time), the states.  gamma is one number in the paper, or one each.
"""

import numpy as np

from .law import Law, adapt_gains, promised


def learned_flow(t, x, u, p):
    """alpha', K', Gamma' of Eq. (21), Eq. (22), Eq. (23)."""
    return driven_by(u.e, u, p)


def driven_by(e, u, p):
    """Return the rates of Eqs. (21)-(23), driven by e."""
    return {"alpha": -p.gain * np.outer(e, u.phi_x), **adapt_gains(p, e, u.z, u.zc)}


LAW = Law(
    "learned-flow",
    promise="CLPE goes to zero (Theorem 3.2); alpha to -theta where the track excites",
    needs="nothing but a gain",
    rates=learned_flow,
    one_gain=True,
    promises=(
        *promised("true spanned exact", "falls", "settles"),
        *promised("true exact", "mean square"),
    ),
)
