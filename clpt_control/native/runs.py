"""Runs under way: the solver's arrays, and how runs are watched and ended.

The solver takes some steps at a call, for about `PAUSE` seconds, so that Python can
look in between: at the time reached, and whether the end can be reached at all.
"""

import time
from collections.abc import Callable
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np

from ..errors import SimulationError
from ..progress.interrupt import check
from . import method
from .schedule import Schedule
from .status import Status

PAUSE = 0.05  # seconds of a call
MEMBER_STEPS = 5_000_000  # tries of a run among many


class Callee(NamedTuple):
    """What the solver calls, and the room that takes.

    Attributes
    ----------
    solver : module
        `solver` as it stands, or compiled.
    functions : sequence
        In the solver's order: functions, or their addresses.
    lanes : int
        Runs that are taken at once.
    nstates, room : int
        Numbers of states, and of places in W.
    tables : ndarray
        T.
    guarded : bool
        Whether guards are watched.
    most : int
        Tries that a single run may take.
    code : tuple
        What must live for as long as addresses are used.
    """

    solver: ModuleType
    functions: Any
    lanes: int
    nstates: int
    room: int
    tables: np.ndarray
    guarded: bool
    most: int
    code: tuple = ()


class Runs:
    """Some runs of one diagram.

    Parameters
    ----------
    callee : Callee
        The diagram.
    starts : ndarray, shape (m, n)
        Initial states.
    parameters : ndarray, shape (m, nP)
        P of each run.
    times : ndarray, shape (nt,)
        When states are wanted; runs start at the first.
    schedules : list of Schedule
        With the same places.
    group : ndarray of int, shape (m,), optional
        Which schedule a run follows; the first without.

    Attributes
    ----------
    out : ndarray, shape (m, nt, n)
        States; NaN where a run did not come.
    status, reached : ndarray of int, shape (m,)
        How runs ended (`Status`), and samples done.
    counts : ndarray of int, shape (m, 4)
        Steps, evaluations, restarts, rejected steps.
    """

    def __init__(
        self,
        callee: Callee,
        starts: np.ndarray,
        parameters: np.ndarray,
        times: np.ndarray,
        schedules: list[Schedule],
        group: np.ndarray | None = None,
    ):
        self.callee, self.times = callee, times
        m, n = starts.shape
        lanes, size = callee.lanes, parameters.shape[1]
        self.shape = (lanes, n, size)
        group = np.zeros(m, dtype=np.int64) if group is None else group
        self.runs = (np.ascontiguousarray(starts), np.ascontiguousarray(parameters), group)
        self.schedule = _together(schedules)
        self.out = np.full((m, len(times), n), np.nan)
        self.status, self.reached = (np.zeros(m, dtype=np.int64) for _ in range(2))
        self.counts = np.zeros((m, 4), dtype=np.int64)
        self.numbers = np.zeros((method.NUMBERS, lanes))
        self.whole = np.full((3, lanes), -1, dtype=np.int64)
        self.queue = np.array([0, m, 0], dtype=np.int64)
        self.Z = np.zeros(method.ROWS * n * lanes)
        self.room = (
            np.zeros(max(size, 1) * lanes),
            np.append(callee.tables, 0.0),
            np.zeros(max(callee.room, 1) * lanes),
            np.zeros(max(n, 2) * lanes),
        )

    @property
    def now(self) -> float:
        """Time reached by the first lane."""
        return float(self.numbers[method.TIME, 0])

    def adaptive(
        self,
        rtol: float,
        atol: float,
        watch: Callable[["Runs"], None] = lambda runs: None,
        most: int = MEMBER_STEPS,
    ) -> None:
        """Run to the end with steps chosen by tolerance.

        Parameters
        ----------
        rtol, atol : float
            Tolerances on the local error of each state.
        watch : callable, optional
            Called between the solver's calls.
        most : int, optional
            Tries after which a run is given up.
        """
        tolerances = np.array([max(rtol, 2.3e-14), atol])
        active, budget = 1, 64
        while active:
            check()
            begin = time.perf_counter()
            with np.errstate(all="ignore"):
                active = self.callee.solver.advance(
                    self.callee.functions,
                    self.shape,
                    tolerances,
                    self.runs,
                    self.schedule,
                    self.times,
                    self.out,
                    self.status,
                    self.reached,
                    self.counts,
                    self.numbers,
                    self.whole,
                    self.queue,
                    self.Z,
                    *self.room,
                    budget,
                    most,
                    self.callee.guarded,
                )
            spent = time.perf_counter() - begin
            budget = int(np.clip(budget * PAUSE / max(spent, 1e-6), budget / 2 + 1, 4 * budget))
            watch(self)

    def fixed(self, step: float) -> None:
        """Run to the end with steps of one length, of order 4."""
        if not step > 0:
            raise SimulationError(f"step = {step}: must be positive")
        check()
        with np.errstate(all="ignore"):
            self.callee.solver.advance_fixed(
                self.callee.functions,
                self.shape,
                float(step),
                self.runs,
                self.schedule,
                self.times,
                self.out,
                self.status,
                self.reached,
                self.counts,
                self.numbers,
                self.whole,
                self.Z,
                *self.room,
                self.callee.guarded,
            )


def _together(schedules: list[Schedule]) -> tuple[np.ndarray, ...]:
    """Return ends of pieces, how many, places and values of schedules of one kind."""
    longest = max(len(one.edges) for one in schedules)
    edges = np.full((len(schedules), longest), np.inf)
    values = np.zeros((len(schedules), longest + 1, len(schedules[0].places)))
    for g, one in enumerate(schedules):
        edges[g, : len(one.edges)] = one.edges
        values[g, : len(one.values)] = one.values
    ends = np.array([len(one.edges) for one in schedules])
    return edges, ends, schedules[0].places, values


def pace(most: int, span: float, started: float) -> Callable[[Runs], None]:
    """Return a watch that gives up a run whose end is out of reach.

    Parameters
    ----------
    most : int
        Tries that a run may take.
    span : float
        Time from its start to its end.
    started : float
        Its start.

    Returns
    -------
    callable
        For `Runs.adaptive`; raises SimulationError.
    """
    looked = [0, started]

    def watch(runs: Runs) -> None:
        tries, now = int(runs.counts[0, 0] + runs.counts[0, 3]), runs.now
        if tries - looked[0] < most // 500:
            return
        ahead = (now - looked[1]) / (tries - looked[0])
        if runs.status[0] == Status.RUNNING and ahead * most < span:
            needed = span / ahead if ahead > 0 else np.inf
            raise SimulationError(
                f"too many steps: {tries:,} by t = {now:.9g}, at which pace the run would take "
                f"{needed:.0e}; the equations are stiff there: lower the gains, or loosen rtol and "
                "atol"
            )
        looked[:] = [tries, now]

    return watch
