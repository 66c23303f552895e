"""Many runs of one scenario that differ in numbers, not in shape.

A member is the scenario with some values changed.  Which places of P and of the
initial state a value goes to is found by probing: where a changed value turns
up as it is, members are filled in whole columns; what is computed from values,
such as frequencies from periods, is made member by member.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..diagram import closed_loop, initial_state
from ..errors import ScenarioError
from ..scenario import Scenario
from .compiled import lane_module_or_none
from .engine import NativeDiagram


@dataclass
class Members:
    """Parameters and initial states of many runs.

    Attributes
    ----------
    native : NativeDiagram
        The compiled diagram.
    P : ndarray, shape (m, nP)
        Parameters of each member.
    x0 : ndarray, shape (m, nstates)
        Initial states.
    group : ndarray of int, shape (m,)
        Which row of the schedules a member follows.
    edges, counts, values : ndarray
        Ends of pieces, how many there are, and what each piece sets, by group.
    places : ndarray of int
        Where in P.
    """

    native: NativeDiagram
    P: np.ndarray
    x0: np.ndarray
    group: np.ndarray
    edges: np.ndarray = field(repr=False)
    counts: np.ndarray = field(repr=False)
    values: np.ndarray = field(repr=False)
    places: np.ndarray = field(repr=False)


class Ensemble:
    """One scenario, compiled, from which members are made.

    Parameters
    ----------
    scenario : Scenario
        The base.
    keys : mapping of str to tuple of int
        What varies: dotted key -> shape of its value, ``()`` for a number.
    lanes : bool, optional
        Eight members at once where the processor and the diagram allow it.

    Raises
    ------
    ScenarioError
        If a key is unknown or its value has another shape.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> ensemble = Ensemble(clpt.paper_scenario(), {"learning.gain": ()})
    >>> members = ensemble.members({"learning.gain": np.array([0.5, 2.0])}, 20.0)
    >>> ensemble.run(members, np.array([0.0, 20.0])).states.shape
    (2, 2, 14)
    """

    def __init__(self, scenario: Scenario, keys: Mapping[str, tuple[int, ...]], lanes: bool = True):
        self.scenario, self.keys = scenario, dict(keys)
        spread = {key: _probe(_base(scenario, key, shape)) for key, shape in self.keys.items()}
        self.native = NativeDiagram(closed_loop(scenario.with_values(spread)))
        self.lanes = lane_module_or_none(self.native.fused) if lanes else None
        self.copied: dict[str, tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]] = {}
        self.computed: list[str] = []
        self._schedules: dict[bytes, int] = {}
        base = self._packed(scenario)
        for key, shape in self.keys.items():
            found = self._places(key, shape, base)
            if found is None:
                self.computed.append(key)
            else:
                self.copied[key] = found
        self.base = base

    def _packed(self, scenario: Scenario) -> tuple[np.ndarray, np.ndarray, list[Any]]:
        """Give P, the initial state and the blocks' parameters of a scenario."""
        blocks = [block.parameters for block in _blocks(scenario)]
        own = self.native.fused.layout.packed(blocks)
        P = np.append(own, np.zeros(self.native.fused.size - len(own)))
        return P, initial_state(scenario), blocks

    def _places(self, key: str, shape: tuple[int, ...], base) -> Any:
        """Find where a value is copied to; None where it is computed."""
        value = _base(self.scenario, key, shape)
        other = _probe(value)
        P, x0, _ = self._packed(self.scenario.with_values({key: other}))
        flat = np.ravel(other)
        spots = []
        for new, old in ((P, base[0]), (x0, base[1])):
            at = np.flatnonzero(new != old)
            which = np.array([np.argmin(np.abs(flat - v)) for v in new[at]], dtype=int)
            if not np.array_equal(flat[which], new[at]):
                return None
            spots += [at, which]
        if key.split(".")[-1] in ("dwell", "period", "duration"):
            return None
        return tuple(spots)

    def members(self, values: Mapping[str, np.ndarray], duration: float) -> Members:
        """Make members of arrays of values.

        Parameters
        ----------
        values : mapping
            Key -> array, shape (m,) + the key's shape.
        duration : float
            Length of the runs, units.time.

        Returns
        -------
        Members
            Ready to run.

        Raises
        ------
        ScenarioError
            If a value is not allowed; the member is named.
        """
        count = len(next(iter(values.values())))
        P, x0 = np.tile(self.base[0], (count, 1)), np.tile(self.base[1], (count, 1))
        group = np.zeros(count, dtype=np.int64)
        schedules = [self._schedule(self.base[2], duration)]
        if self.computed:
            known: dict[tuple, int] = {}
            for m in range(count):
                own = {key: values[key][m] for key in self.computed}
                P[m], x0[m], blocks = self._packed(self.scenario.with_values(own))
                schedule = self._schedule(blocks, duration)
                name = (schedule[0].tobytes(), schedule[2].tobytes())
                if name not in known:
                    known[name] = len(schedules)
                    schedules.append(schedule)
                group[m] = known[name]
        for key, (p_at, p_of, x_at, x_of) in self.copied.items():
            flat = np.reshape(values[key], (count, -1))
            P[:, p_at] = flat[:, p_of]
            x0[:, x_at] = flat[:, x_of]
        longest = max(len(edges) for edges, _, _ in schedules)
        edges = np.full((len(schedules), longest), np.inf)
        rows = np.zeros((len(schedules), longest + 1, len(schedules[0][1])))
        for g, (ends, _, sets) in enumerate(schedules):
            edges[g, : len(ends)] = ends
            rows[g, : len(sets)] = sets
        counts = np.array([len(ends) for ends, _, _ in schedules])
        return Members(self.native, P, x0, group, edges, counts, rows, schedules[0][1])

    def _schedule(self, blocks: list[Any], duration: float):
        self.native.sweep.use(blocks)
        return self.native.pieces(0.0, duration, None)

    def run(
        self,
        members: Members,
        times: np.ndarray,
        rtol: float = 1e-8,
        atol: float = 1e-10,
        step: float | None = None,
    ) -> "States":
        """Run members, each by itself, in the calling thread.

        Parameters
        ----------
        members : Members
            As `members` gives them; their duration is ``times[-1]``.
        times : ndarray
            Increasing, from 0; times at which states are wanted.
        rtol, atol : float, optional
            Tolerances.
        step : float, optional
            A fixed step: Runge and Kutta's classical method in place of
            DOP853.

        Returns
        -------
        States
            NaN after the time a failed member reached.
        """
        m, nx = members.x0.shape
        out = np.full((m, len(times), nx), np.nan)
        status, reached = np.zeros(m, dtype=np.int64), np.zeros(m, dtype=np.int64)
        counts = np.zeros((m, 4), dtype=np.int64)
        shared: tuple[Any, ...] = (
            0, m, members.x0, members.P, self.native.fused.layout.T, members.group, members.edges,
            members.counts, members.places, members.values, np.asarray(times, float), out, status,
            reached, counts,
        )  # fmt: skip
        if step is not None:
            self.native.module.many_rk4(*shared, float(step))
            return States(out, status, reached, counts)
        shared = (*shared, rtol, atol)
        if self.lanes is None:
            self.native.module.many(*shared)
        else:
            fused = self.native.fused
            sizes = (18 * nx, members.P.shape[1], max(fused.nsignals, 1), 7 * nx, 6)
            self.lanes.many(*shared, *(np.zeros((size, 8)) for size in sizes))
        return States(out, status, reached, counts)


@dataclass(frozen=True)
class States:
    """States of many runs.

    Attributes
    ----------
    states : ndarray, shape (m, ntimes, nstates)
        NaN where a run did not come.
    status : ndarray of int, shape (m,)
        1 finished, 2 step too small, 3 not finite, 4 left the field, 5 too
        many steps.
    reached : ndarray of int, shape (m,)
        Samples reached.
    counts : ndarray of int, shape (m, 4)
        Steps, evaluations, restarts, rejected steps.
    """

    states: np.ndarray
    status: np.ndarray
    reached: np.ndarray
    counts: np.ndarray


def _blocks(scenario: Scenario) -> list[Any]:
    from ..diagram import paper_blocks

    return paper_blocks(scenario)


def _base(scenario: Scenario, key: str, shape: tuple[int, ...]) -> np.ndarray:
    """Give a key's value in the scenario; zeros where it was left out."""
    from ..scenario import scenario_tables

    place: Any = scenario_tables(scenario)
    for name in key.split("."):
        place = place.get(name) if isinstance(place, dict) else None
    value = np.zeros(shape) if place is None else np.asarray(place, dtype=float)
    if value.shape != tuple(shape):
        raise ScenarioError(f"{key}: has shape {value.shape}, not {tuple(shape)}")
    return value


def _probe(value: np.ndarray) -> Any:
    """Give other numbers of the same shape, all different from each other."""
    steps = np.arange(1, value.size + 1).reshape(value.shape)
    other = np.abs(value) * (1 + 0.0137 * steps) + 0.00731 * steps
    return float(other) if other.ndim == 0 else other.tolist()
