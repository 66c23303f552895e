"""The states of a diagram: at t = 0, by a scenario's keys, and at a time of a run."""

from collections.abc import Iterable, Mapping
from operator import attrgetter
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arguments import numbers, public
from ..base.errors import DataError, DiagramError
from ..base.progress import warn
from ..engine.diagram.interconnection import Diagram
from ..engine.diagram.wiring import Part, leaves, output_ports
from ..engine.model.block import Block
from ..engine.model.system import is_linear
from ..engine.solver.schedule import checked_state
from ..paper.blocks.localization import TRUE
from ..paper.scenario.experiment import Scenario
from ..paper.scenario.quantities import STARTS
from ..paper.scenario.team import Team
from .loops import paper_blocks

if TYPE_CHECKING:
    import xarray


def stacked_state(name: str, state: Any, count: int) -> np.ndarray:
    """Return `count` states as python-control takes them.

    A list, ``[x0, 0]``, holds numbers and arrays one after the other; a last zero is repeated.
    """
    if isinstance(state, list | tuple) and state and not all(map(np.isscalar, state)):
        state = np.concatenate([numbers(name, part).ravel() for part in state])
    else:
        state = numbers(name, state)
        state = state.ravel() if state.ndim else state
    if 0 < np.size(state) < count and np.ndim(state) == 1:
        if state[-1] != 0:
            warn(f"{name} is too short: filled with zeros")
        state = np.pad(numbers(name, state), (0, count - len(state)))
    return checked_state(name, state, (count,))


def state_columns(parts: Iterable[Part]) -> dict[str, slice]:
    """Return the columns of each state in the state of a diagram.

    Of several with one name, that which is the signal of this name counts: a scenario starts it.
    """
    signals: dict[str, slice] = {}
    hidden: dict[str, slice] = {}
    end = 0
    for name, part in leaves(parts, "_"):
        ports = (
            part.state_ports
            if isinstance(part, Block)
            else {part.name: part.nstates or 0}
        )
        for port, size in ports.items():
            column = slice(end, end := end + size)
            if _is_signal(part, port, size):
                signals.setdefault(port, column)
            else:
                label = f"{name}.{port}" if port in STARTS.values() else port
                hidden.setdefault(label, column)
    return {**hidden, **signals}


def _is_signal(part: Part, port: str, size: int) -> bool:
    """Return whether a state is a signal of the same name; of x it may be the true position."""
    outputs = output_ports(part)
    signals = outputs.get(port) or (outputs.get(TRUE) if port == "x" else None) or []
    if len(signals) != size:
        return False
    return not is_linear(part) or np.array_equal(part.parameters.C, np.eye(size))


def state_of(
    scenario: Scenario, parts: Iterable[Part], law: Part | None = None
) -> np.ndarray:
    """Return the state of parts at t = 0; what no key of the scenario starts is 0."""
    parts = list(parts)
    columns = state_columns(parts)
    of_law = scenario.learning.row.starts(scenario.known_to_law) if law is None else {}
    state = np.zeros(sum(part.nstates or 0 for part in parts))
    keys = {port: attrgetter(key)(scenario) for key, port in STARTS.items()}
    keys["alpha"] = scenario.learning_parameters
    if scenario.learning.row.alpha_is_constant:  # it is no state
        del keys["alpha"]
    for port, value in {**keys, **of_law}.items():
        if port in columns:
            state[columns[port]] = np.ravel(value)
    return state


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
            f"{system.name}: knows no scenario; one that closed_loop makes does"
        )
    return state_of(system.origin.scenario, system.syslist, system.origin.changes.law)


@public
def state_at(run: "xarray.Dataset", t: float) -> np.ndarray:
    """Return the state of a run's diagram at one of its times.

    Parameters
    ----------
    run : xarray.Dataset
        Of a scenario, a team or a diagram, as `simulate` gives it.
    t : float
        One of the run's times; at a jump the state is the one after it.

    Returns
    -------
    ndarray, shape (nstates,)
        To hand to ``control.linearize(loop, state, inputs, t=t)`` or on to `simulate`.

    Raises
    ------
    DataError
        If the run has no sample at that time, or carries no states.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> clpt.state_at(clpt.simulate(scenario), 20).shape
    (14,)
    """
    if "states" not in run.variables:
        raise DataError("the run carries no states; one that clpt.simulate gives does")
    times = run.time.values
    k = int(np.abs(times - t).argmin()) if len(times) and np.isfinite(t) else -1
    if k < 0 or abs(times[k] - t) > 1e-12 * max(1.0, abs(t)):
        near = f"; the nearest of its times is {times[k]:.9g}" if k >= 0 else ""
        raise DataError(
            f"t = {t}: the run has no sample there{near}; simulate it with timepts that hold t"
        )
    return np.array(run.states.values[k], dtype=float)


def with_solver(system: Any, solver: Mapping[str, Any]) -> Any:
    """Return a scenario or a team with tolerances and method, where these are not None."""
    values = {f"run.{key}": value for key, value in solver.items() if value is not None}
    if values and isinstance(system, Team):
        members = {
            name: one.with_values(values) for name, one in system.members.items()
        }
        return Team(members=members, edges=system.edges, coupling=system.coupling)
    return system.with_values(values) if values else system
