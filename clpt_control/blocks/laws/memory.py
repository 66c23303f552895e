"""A memory of regressions y = kappa w, and what is learned from it.

    Q' = -m Q + w w^T / size,    b' = -m b + y w^T / size

From Q = 0, b = 0 on, b = kappa Q: Q is symmetric, not negative, and has seen what w has shown.
A law that adds gamma_c (b - kappa_hat Q) to the rate of kappa_hat pulls it to kappa.
Source: Kreisselmeier 1977, IEEE Transactions on Automatic Control 22(1), Adaptive observers
with exponential rate of convergence.
"""

from typing import Any

import numpy as np

from .known import Truth
from .law import MOVING, Part, State


def remembered(b, y, w, size, forgetting):
    """Return b' = -m b + y w^T/size, and Q' where y is w."""
    return np.outer(y, w) / size - forgetting * b


def memory(Q: str, b: str) -> Part:
    """Make a memory of the flow, b = theta Q, of states with these names."""
    return {
        "states": {Q: State(("N", "N")), b: State((2, "N"))},  # empty at first
        "takes": MOVING,
        "keeps": lambda s, p, truth: {b: truth.theta @ s[Q]},
        "cones": (Q,),
    }


def pulled(s: Any, p: Any, truth: Truth, Q: str) -> tuple:
    """Return what V' loses by the pull, gamma_c tr(eta Q eta^T)/gamma, eta = theta + alpha."""
    eta = truth.theta + s["alpha"]
    return p.memory_gain / p.gain, np.sum((eta @ s[Q]) * eta)
