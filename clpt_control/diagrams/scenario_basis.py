"""phi of Eq. (5) as a scenario has it."""

import numpy as np

from ..blocks.basis import BasisParameters, flow_basis
from ..equations.block import Block
from ..scenario.experiment import Scenario


def scenario_basis(scenario: Scenario, position: str = "x") -> Block:
    """Return the block phi(x, t) of a scenario, Eq. (5)."""
    functions = BasisParameters(
        scenario.basis.N,
        np.array(scenario.basis.centers),
        np.array(scenario.basis.widths),
        scenario.frequencies,
        np.array(scenario.phases),
    )
    return flow_basis(f"basis_{position}", position, scenario.basis.kernel, functions)
