"""The Lyapunov candidates, Eqs. (17) and (24).

    V = (|e|^2 + |K - KD|^2/gamma + |GammaD - Gamma|^2/gamma) / 2               Eq. (17)
    V = Eq. (17) + |theta + alpha|^2 / (2 gamma)                                Eq. (24)

The paper has one gain gamma; here each error is weighted by its own gain.
V is a signal of the diagram: runs record it and proofs differentiate it, both from these functions.

Ports: e[2] (length), alpha[2N] (length per time), K[2], Gamma[2] (per time) -> V[1].
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from ...engine.model.block import Block
from ...engine.model.declaration import Parameters
from .ports import paper_block

PORTS = "e alpha K Gamma -> V"
BY_GAINS = {"gain": (2, "N")}  # shape in addition to `ports`: each alpha has its gain


def weighted(gains: Sequence[float], theta: Any, KD: Any, GammaD: Any) -> Any:
    """Return the parameters of V: the truth, and gains of alpha, K and Gamma for each error.

    With a gain of 0 the error is not part of V.
    """
    theta, KD, GammaD = (np.asarray(v, dtype=float) for v in (theta, KD, GammaD))
    alpha, K, Gamma = (gain if gain > 0 else np.inf for gain in gains)
    return Parameters(
        gain=np.full(theta.shape, alpha),  # (2, N)
        gain_K=np.full(2, K),
        gain_Gamma=np.full(2, Gamma),
        theta=theta,  # (2, N), length per time
        KD=KD,  # per time
        GammaD=GammaD,  # per time
    )


def level(e, u, p):
    """Return V of Eq. (17) of an error e, length squared."""
    K = (u.K - p.KD) ** 2 / p.gain_K
    Gamma = (p.GammaD - u.Gamma) ** 2 / p.gain_Gamma
    return (e @ e + np.sum(K) + np.sum(Gamma)) / 2


def flow_level(u, p):
    """Return the term of Eq. (24) that Eq. (17) does not have."""
    return np.sum((p.theta + u.alpha) ** 2 / p.gain) / 2


def known_flow_V(t, x, u, p):
    """V of Eq. (17)."""
    return {"V": level(u.e, u, p)}


def learned_flow_V(t, x, u, p):
    """V of Eq. (24)."""
    return {"V": level(u.e, u, p) + flow_level(u, p)}


CANDIDATES = {"known-flow": known_flow_V, "learned-flow": learned_flow_V}


def lyapunov_candidate(law: str, parameters: Any) -> Block:
    """Make V: Eq. (17) for the law ``"known-flow"``, Eq. (24) for ``"learned-flow"``."""
    return paper_block(
        "lyapunov", PORTS, parameters._asdict(), output=CANDIDATES[law], shapes=BY_GAINS
    )
