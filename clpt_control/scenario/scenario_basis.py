"""phi of Eq. (5) as a scenario has it."""

from ..blocks.basis import flow_basis
from ..equations.block import Block
from ..scenario.experiment import Scenario


def scenario_basis(scenario: Scenario, position: str = "x") -> Block:
    """Return the block phi(x, t) of a scenario, Eq. (5)."""
    own = scenario.basis
    functions = (own.centers, own.widths, scenario.frequencies, scenario.phases)
    return flow_basis(f"basis_{position}", position, own.kernel, *functions)
