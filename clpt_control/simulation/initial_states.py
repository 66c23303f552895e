"""Initial states of a diagram: at t = 0 from a scenario, at a time of a run, or the caller's.

`state_columns` maps the name of a state to its columns in the state of the diagram.
"""

from collections.abc import Iterable
from operator import attrgetter
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arguments import public
from ..base.errors import DataError, DiagramError, SimulationError
from ..engine.diagram.interconnection import Diagram
from ..engine.diagram.wiring import Part, leaves, output_ports
from ..engine.model.block import Block
from ..engine.model.system import is_linear
from ..paper.blocks.localization import TRUE
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.quantities import STARTS
from .loop_blocks import paper_blocks

if TYPE_CHECKING:
    import xarray


def state_columns(blocks: Iterable[Part]) -> dict[str, slice]:
    """Return the columns of each state in the state of a diagram.

    If several states have one name, the state that is the signal of this name has priority.
    """
    signals: dict[str, slice] = {}
    hidden: dict[str, slice] = {}
    end = 0
    for name, block in leaves(blocks, "_"):
        ports = {block.name: block.nstates or 0}
        if isinstance(block, Block):
            ports = block.state_ports
        for port, size in ports.items():
            column = slice(end, end + size)
            end += size
            if _is_signal(block, port, size):
                signals.setdefault(port, column)
            else:
                label = f"{name}.{port}" if port in STARTS.values() else port
                hidden.setdefault(label, column)
    return hidden | signals


def _is_signal(block: Part, port: str, size: int) -> bool:
    """Return whether a state is an output of the same name; x may be the true position."""
    outputs = output_ports(block)
    signals = outputs.get(port, [])
    if not signals and port == "x":
        signals = outputs.get(TRUE, [])
    if len(signals) != size:
        return False
    return not is_linear(block) or np.array_equal(block.parameters.C, np.eye(size))


def state_of(
    scenario: Scenario, blocks: Iterable[Part], law: Part | None = None
) -> np.ndarray:
    """Return the state of blocks at t = 0; a state without a key of the scenario is 0."""
    blocks = list(blocks)
    row = scenario.learning.row
    values = {port: attrgetter(key)(scenario) for key, port in STARTS.items()}
    values["alpha"] = scenario.learning_parameters
    if row.alpha_is_constant:  # it is not a state
        del values["alpha"]
    if law is None:
        values |= row.starts(scenario.known_to_law)
    state = np.zeros(sum(block.nstates or 0 for block in blocks))
    for port, column in state_columns(blocks).items():
        if port in values:
            state[column] = np.ravel(values[port])
    return state


def check_initial_alpha(run: Any, state: np.ndarray) -> None:
    """Raise an error if alpha(0) is not the alpha_0 that the readout of a run's law assumes."""
    columns = state_columns(node.system for node in run.wiring.nodes)
    error_columns = columns.get(run.scenario.learning.row.error_left)
    if not error_columns or not np.all(state[error_columns] == 1):
        return
    for p in run.runner.sweep.parameters:
        if "alpha_0" not in p._fields:
            continue
        if np.any(state[columns["alpha"]] != np.ravel(p.alpha_0)):
            raise SimulationError(
                "initial_state: alpha is not adaptation.alpha_0, of which the readout is made. "
                "Give both, or learning.parameters of the scenario"
            )


@public
def initial_state(system: Scenario | Diagram) -> np.ndarray:
    """Return the state at t = 0 of a scenario's `closed_loop`.

    Parameters
    ----------
    system : Scenario or Diagram
        The experiment, or what `closed_loop` made of it; states of your own parts start at 0, but
        for x, z, alpha, K and Gamma.

    Returns
    -------
    ndarray
        x(0), z(0), alpha(0) row by row where it is a state, K(0), Gamma(0), the
        law's own states, and those of inserted parts.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> initial_state(clpt.paper_scenario()).shape
    (14,)
    """
    if isinstance(system, Scenario):
        return state_of(system, paper_blocks(system))
    if system.origin is None:
        raise DiagramError(
            f"{system.name}: has no scenario. Give a diagram made by closed_loop"
        )
    return state_of(system.origin.scenario, system.syslist, system.origin.changes.law)


def state_at(run: "xarray.Dataset", t: float) -> np.ndarray:
    """Return the state of a run's diagram at one of its times; at a jump the one after it."""
    if "states" not in run.variables:
        raise DataError("the run has no states. Give a run made by clpt.simulate")
    times = run.time.values
    nearest = ""
    if len(times) and np.isfinite(t):
        k = int(np.abs(times - t).argmin())
        if abs(times[k] - t) <= 1e-12 * max(1.0, abs(t)):
            return np.array(run.states.values[k], dtype=float)
        nearest = f"; the nearest of its times is {times[k]:.9g}"
    raise DataError(
        f"t = {t}: the run has no sample there{nearest}. Simulate it with timepts that include t"
    )
