"""The law of a team that learns one flow: Eqs. (21)-(23) and a pull towards the neighbours' alpha.

    alpha_i' = -gamma e_i phi(x_i)^T + pull_i
    pull_i   = -kappa sum_j (alpha_i - alpha_j)         over the neighbours j of vehicle i
    K_i', Gamma_i' as in Eqs. (22)-(23)

All vehicles swim in one flow, so the true value of each alpha_i is -theta.  With V_i of Eq. (24),

    V  = sum_i V_i
    V' = -sum_i e_i^T KD_i e_i - (kappa/gamma) sum |alpha_i - alpha_j|^2    over the edges (i, j)

CLPE goes to zero and the neighbours agree; alpha_i goes to -theta if the tracks of the team
together excite the flow, see `theory.excitation.gramian`.  With e = 0 only the disagreement is
left: alpha' = -kappa L alpha with the graph's Laplacian L.  It falls as exp(-kappa lambda_2 t) or
faster.
Source: the gradient law of section III with the consensus of Olfati-Saber, Fax and Murray 2007,
Proceedings of the IEEE 95(1), Consensus and cooperation in networked multi-agent systems.

| block | inputs | outputs |
|---|---|---|
| adaptation | those of the learned-flow law, pull[2N] (length per time squared) | its states |
| consensus | alpha[2N] of the vehicle, then of each neighbour (length per time) | pull[2N] |
| lyapunov | V[1] of each vehicle (length squared) | V[1], their sum |
"""

from collections.abc import Sequence

import numpy as np

from ...engine.model.block import Block
from ...engine.model.ports import named, renamed
from .paper import learned_flow


def pulled(t, x, u, p):
    """Eqs. (21)-(23) with the pull of the neighbours added to alpha'."""
    rates = learned_flow(t, x, u, p)
    return {**rates, "alpha": rates["alpha"] + u.pull}


def consensus(t, x, u, p):
    """pull = -kappa sum_j (alpha - alpha_j), section III in a team."""
    disagreement = sum(u.alpha - getattr(u, f"alpha_{j}") for j in range(p.neighbours))
    return {"pull": -p.coupling * disagreement}


def total(t, x, u, p):
    """V of the team, the sum of Eq. (24) over its vehicles."""
    return [np.sum(u)]


def pulled_law(law: Block) -> Block:
    """Return the learned-flow law with the pull of neighbours as an input."""
    return Block(
        law.name,
        update=pulled,
        inputs={**law.declared["inputs"], "pull": (2, "N")},
        states=law.declared["states"],
        parameters=law.parameters,
        sizes=law.sizes,
    )


def consensus_block(
    vehicle: str, neighbours: Sequence[str], N: int, coupling: float
) -> Block:
    """Make the block of the pull on a vehicle, in its namespace; the coupling kappa is per time."""
    sources = {"alpha": vehicle}
    sources |= {f"alpha_{j}": neighbour for j, neighbour in enumerate(neighbours)}
    block = Block(
        "consensus",
        output=consensus,
        inputs=dict.fromkeys(sources, (2, "N")),
        outputs={"pull": (2, "N")},
        parameters={"neighbours": len(neighbours), "coupling": float(coupling)},
        sizes={"N": N},
    )
    inputs = {port: named(source, "alpha") for port, source in sources.items()}
    return renamed(
        block, named(vehicle, "consensus"), inputs, {"pull": named(vehicle, "pull")}
    )


def total_candidate(vehicles: Sequence[str]) -> Block:
    """Make the block of the team's V."""
    return Block(
        "lyapunov",
        output=total,
        inputs={named(vehicle, "V"): 1 for vehicle in vehicles},
        outputs={"V": 1},
    )
