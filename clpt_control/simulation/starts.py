"""Where a scenario's states are at t = 0: what its keys say, and the law's own."""

from collections.abc import Iterable

import numpy as np

from ..blocks import Block
from ..scenario.experiment import Scenario
from ..scenario.keys import STARTS
from .loops import kept_blocks, paper_blocks


def starting_values(scenario: Scenario) -> dict[str, np.ndarray]:
    """Return what the scenario's keys say of states at t = 0, by key."""
    learning = scenario.learning
    values = {
        "vehicle.position": scenario.vehicle.position,
        "learning.position": learning.position,
        "learning.parameters": scenario.learning_parameters,
        "learning.feedback": learning.feedback,
        "learning.feedforward": learning.feedforward,
    }
    if learning.row.keeps_alpha:  # alpha is no state
        del values["learning.parameters"]
    return {key: np.asarray(value, dtype=float) for key, value in values.items()}


def state_columns(blocks: Iterable[Block]) -> dict[str, slice]:
    """Return where each state lies in the state of a diagram of blocks."""
    sizes = [item for block in blocks for item in block.state_ports.items()]
    ends = np.cumsum([size for _, size in sizes], dtype=int).tolist()
    return {port: slice(end - size, end) for (port, size), end in zip(sizes, ends, strict=True)}


def state_of(scenario: Scenario, blocks: Iterable[Block], law: Block | None = None) -> np.ndarray:
    """Return the state of blocks at t = 0; the states of a law of the user's own start at 0."""
    columns = state_columns(blocks)
    own = scenario.learning.row.starts(scenario.known_to_law) if law is None else {}
    state = np.zeros(max((column.stop for column in columns.values()), default=0))
    for key, value in starting_values(scenario).items():
        if STARTS[key] in columns:
            state[columns[STARTS[key]]] = value.ravel()
    for port, value in own.items():
        if port in columns:
            state[columns[port]] = np.ravel(value)
    return state


def initial_state(
    scenario: Scenario, external: Iterable[str] = (), law: Block | None = None
) -> np.ndarray:
    """Return the state at t = 0 of a scenario's `closed_loop`.

    Parameters
    ----------
    scenario : Scenario
        The experiment.
    external : iterable of str, optional
        As given to `closed_loop`.
    law : Block, optional
        As given to `closed_loop`; what it has beside alpha, K and Gamma starts at 0.

    Returns
    -------
    ndarray
        x(0), z(0), alpha(0) row by row where it is a state, K(0), Gamma(0), and the
        law's own states.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> initial_state(clpt.paper_scenario()).shape
    (14,)
    """
    external = [external] if isinstance(external, str) else list(external)
    return state_of(scenario, kept_blocks(paper_blocks(scenario, law), external), law)
