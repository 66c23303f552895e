"""Laws of the user's own for tests: what a module of theirs would hold.

u = e[2], phi_x[N], z[2], zc[2]; states alpha[2N], K[2], Gamma[2], section III.
"""

import numpy as np

from clpt_control.equations import Block

EACH = {"parameters": 0.8, "feedback": 0.3, "feedforward": 0.5}  # a gain for each part
TRUE_GAINS = {"learning.feedback": [1, 1], "learning.feedforward": [1, 1]}
HELD = {"learning.adapt_gains": False, **TRUE_GAINS}


def remembering(t, x, u, p):
    """alpha' = -gamma e phi^T, K and Gamma held, and a count m' = p.start, section III."""
    return {"alpha": -p.gain * np.outer(u.e, u.phi_x), "K": 0.0, "Gamma": 0.0, "m": p.start}


def remembering_law(N=3, gain=0.8, start=0.5):
    return Block(
        "mine",
        update=remembering,
        inputs={"e": 2, "phi_x": "N"},
        states={"alpha": (2, "N"), "K": 2, "Gamma": 2, "m": 1},
        parameters={"gain": gain, "start": start},
        sizes={"N": N},
    )


def papers(t, x, u, p):
    """Eqs. (21)-(23), one gain for all."""
    return {
        "alpha": -p.gain * np.outer(u.e, u.phi_x),
        "K": -p.gain * u.z * u.e,
        "Gamma": p.gain * u.zc * u.e,
    }


def papers_law(N=3, gain=0.8, name="mine"):
    """The paper's own, as a block that no table knows."""
    return Block(
        name,
        update=papers,
        inputs={"e": 2, "phi_x": "N", "z": 2, "zc": 2},
        states={"alpha": (2, "N"), "K": 2, "Gamma": 2},
        parameters={"gain": gain},
        sizes={"N": N},
    )
