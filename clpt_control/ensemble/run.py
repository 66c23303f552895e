"""Run an ensemble on the threads of one machine, or hand it to a cluster.

Compiled members need no interpreter, so threads run side by side.  A chunk is
cut into batches, each a task; batches differ with threads and memory, results do
not: every member is integrated and summarised by itself.
"""

import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ..arguments import Seed, public
from ..diagrams.interconnection import Diagram
from ..errors import ScenarioError, needed
from ..progress.interrupt import SLICE, check
from ..scenario.experiment import Scenario
from ..simulation.loops import loop_of
from .plan import Plan, Request, make_plan
from .store import remove_empty
from .varied_keys import Vary
from .worker import joined, rows

if TYPE_CHECKING:
    import xarray


@public
def run_ensemble(
    system: Scenario | Diagram,
    vary: "str | Vary | Iterable[str | Vary]",
    members: int,
    design: str = "lhs",
    seed: Seed = 0,
    out: str | Path | None = None,
    *,
    threads: int | None = None,
    trajectories: bool = False,
    chunk: int | None = None,
    samples: int | None = None,
    times: Sequence[float] | None = None,
    progress: Callable[[int], None] | None = None,
    dask: str | None = None,
) -> "xarray.Dataset":
    """Run many members of one scenario.

    The result does not depend, to the last bit, on threads, cluster, chunks
    or interruptions. Where `out` holds the same ensemble, only the chunks
    that are missing are run.

    Parameters
    ----------
    system : Scenario or Diagram
        The base: a scenario, or its `closed_loop` with blocks and linear systems of your own, which
        workers get pickled.
    vary : str, Vary or several
        ``"learning.gain=0.2:2.0"``, ``"flow.parameters~normal:0.1"``,
        ``"learning.gain=[0.5, 1, 2]"``.
    members : int
        How many; for a grid the number of combinations.
    design : str, optional
        ``"lhs"``, ``"grid"`` or ``"random"``.
    seed : int, optional
        Of the design.
    out : str or Path, optional
        Folder of a Zarr store; in memory without.
    threads : int, optional
        At most so many at once; all processors without.
    trajectories : bool, optional
        Keep the states at the scenario's own samples too.
    chunk : int, optional
        Members written at once; memory grows with it, not with `members`.
    samples : int, optional
        Samples a cycle for mean squares; 2000, as `clpt run`, up to ten
        cycles, and at least 200 in longer runs.
    times : sequence of float, optional
        When errors are kept; 41 evenly spaced times without.
    progress : callable, optional
        Called with the number of members done.
    dask : str, optional
        Address of a Dask scheduler, or ``"local"``; needs `out`.

    Returns
    -------
    xarray.Dataset
        Summaries, values and, if asked for, trajectories; read from `out`
        when used.

    Raises
    ------
    ScenarioError
        If an argument is not allowed; a member is named.
    DataError
        If `out` cannot be written or holds another ensemble.
    DiagramError
        If a part does not fit or cannot be pickled.
    SimulationError
        If a cluster gives up on a chunk.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> scenario = clpt.paper_scenario().with_values({"run.duration": 20})
    >>> data = run_ensemble(scenario, "learning.gain=0.2:2.0", 3, seed=1)
    >>> data["gain_error"].dims, data["status"].values
    (('member', 'mark'), array([1, 1, 1], dtype=int8))
    """
    if threads is not None and (not isinstance(threads, int) or threads < 1):
        raise ScenarioError(f"threads = {threads}: must be a whole number, at least 1")
    if dask is not None and out is None:
        raise ScenarioError("dask: needs out, a folder that all workers can reach")
    for module in ("zarr", *(["distributed"] if dask is not None else [])):
        needed(module)
    loop, cluster = loop_of(system), dask is not None
    asked = (design, seed, out, trajectories, chunk, samples, times, cluster)
    plan = make_plan(Request(loop, vary, members, *asked))
    report = progress or (lambda done: None)
    count = threads or available_threads()
    if dask is not None:
        from .cluster import run_on_cluster

        run_on_cluster(plan, dask, count, report)
    else:
        try:
            _run_here(plan, count, report)
        except Exception:
            remove_empty(plan.store)
            raise
    plan.store.finish()
    data = plan.store.dataset()
    data.encoding.setdefault("folder", str(loop.scenario._folder.absolute()))  # of its field
    return data


def available_threads() -> int:
    """Return the number of processors this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _batches(plan: Plan, missing: list[int], size: int) -> Iterator[tuple[int, int, dict]]:
    """Cut chunks into batches: chunk, first row in it, and the values."""
    for index in missing:
        values = plan.store.values(index)
        first, last = plan.store.range(index)
        for start in range(0, last - first, size):
            yield index, start, rows(values, start, min(start + size, last - first))


def _run_here(plan: Plan, threads: int, report: Callable[[int], None]) -> None:
    missing = plan.store.missing()
    done = plan.store.done(missing)
    report(done)
    if not missing:
        return
    spread = -(-(plan.store.members - done) // (4 * threads))  # some batches for every thread
    size = min(plan.worker.batch, max(8, -(-spread // 8) * 8))
    batches = _batches(plan, missing, size)
    parts: dict[int, dict[int, dict[str, np.ndarray]]] = {}
    running: dict[Future, tuple[int, int]] = {}
    pool = ThreadPoolExecutor(threads)
    try:
        while True:
            while len(running) < 2 * threads and (batch := next(batches, None)) is not None:
                index, start, values = batch
                running[pool.submit(plan.worker.summaries, values)] = index, start
            if not running:
                return
            finished = wait(running, timeout=SLICE, return_when=FIRST_COMPLETED).done
            check()
            for future in finished:
                index, start = running.pop(future)
                own = parts.setdefault(index, {})
                own[start] = future.result()
                done += len(own[start]["status"])
                first, last = plan.store.range(index)
                if sum(len(part["status"]) for part in own.values()) == last - first:
                    plan.store.write(index, joined([own[key] for key in sorted(own)]))
                    del parts[index]
                report(done)
    finally:
        pool.shutdown(wait=True, cancel_futures=True)
