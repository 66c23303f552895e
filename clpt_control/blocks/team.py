"""A team learns one flow: Eqs. (21)-(23), and a pull of alpha towards the neighbours'.

    alpha_i' = -gamma e_i phi(x_i)^T + pull_i
    pull_i   = -kappa sum_j (alpha_i - alpha_j)         over the neighbours j of vehicle i
    K_i', Gamma_i' as in Eqs. (22)-(23)

All vehicles swim in one flow, so that each alpha_i belongs at -theta.  With V_i of Eq. (24),

    V  = sum_i V_i
    V' = -sum_i e_i^T KD_i e_i - (kappa/gamma) sum |alpha_i - alpha_j|^2    over the edges (i, j)

CLPE goes to zero and the neighbours agree; alpha_i goes to -theta where the team as a whole
excites, see `theory.excitation.pooled`.  With e = 0 the disagreement alone is left:
alpha' = -kappa L alpha with the graph's Laplacian L, so it falls as exp(-kappa lambda_2 t) or
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
from typing import NamedTuple

from ..equations.block import Block
from ..equations.namespaces import named
from .laws.learned_flow import learned_flow


class ConsensusParameters(NamedTuple):
    """How strongly a vehicle is pulled, and by how many."""

    N: int  # number of basis functions
    neighbours: int  # how many
    coupling: float  # kappa, per time


class TotalParameters(NamedTuple):
    """The vehicles whose V are added."""

    vehicles: int  # how many


def pulled(t, x, u, p, dx):
    """Eqs. (21)-(23) with the pull of the neighbours added to alpha'.

    u = e[2], phi_x[N], z[2], zc[2], pull[2N]; states alpha[2N], K[2], Gamma[2].
    """
    n = p.N
    learned_flow(t, x, u, p, dx)
    pull = u[6 + n : 6 + 3 * n]
    for i in range(2):
        for k in range(n):
            dx[i * n + k] += pull[i * n + k]


def consensus(t, x, u, p, y):
    """pull = -kappa sum_j (alpha - alpha_j), section III in a team.

    u = alpha[2N], then alpha_j[2N] of each neighbour (length per time); y = pull[2N].
    """
    n = p.N
    for i in range(2):
        for k in range(n):
            apart = 0.0
            for j in range(p.neighbours):
                apart += u[i * n + k] - u[2 * n * (j + 1) + i * n + k]
            y[i * n + k] = -p.coupling * apart


def total(t, x, u, p, y):
    """V of the team, the sum of Eq. (24) over its vehicles: u = V of each; y = V[1]."""
    V = 0.0
    for i in range(p.vehicles):
        V += u[i]
    y[0] = V


def pulled_law(law: Block) -> Block:
    """Return the learned-flow law with the pull of neighbours as an input."""
    return Block(
        law.name,
        update=pulled,
        inputs={**law.input_ports, "pull": 2 * law.parameters.N},
        states=law.state_ports,
        parameters=law.parameters,
    )


def consensus_block(vehicle: str, neighbours: Sequence[str], N: int, coupling: float) -> Block:
    """Make the pull on one vehicle, in its namespace."""
    return Block(
        named(vehicle, "consensus"),
        output=consensus,
        inputs={named(one, "alpha"): 2 * N for one in (vehicle, *neighbours)},
        outputs={named(vehicle, "pull"): 2 * N},
        parameters=ConsensusParameters(N, len(neighbours), coupling),
    )


def total_candidate(vehicles: Sequence[str]) -> Block:
    """Make V of the team."""
    return Block(
        "lyapunov",
        output=total,
        inputs={named(one, "V"): 1 for one in vehicles},
        outputs={"V": 1},
        parameters=TotalParameters(len(vehicles)),
    )
