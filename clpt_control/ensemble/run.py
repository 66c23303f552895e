"""Run an ensemble on the threads of one machine, or hand it to a cluster.

All arguments are checked, and the store is made or opened, before a member runs.  Compiled
members need no interpreter, so threads run side by side.  A chunk is
cut into batches, each a task; batches differ with threads and memory, results do
not: every member is integrated and summarised by itself.
"""

import os
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, wait
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..arguments import Seed, public
from ..diagrams.changes import UNCHANGED
from ..diagrams.interconnection import Diagram
from ..errors import DataError, ScenarioError, needed
from ..files import check_name, check_writable
from ..progress.interrupt import SLICE, check, keep
from ..scenario.experiment import Scenario
from ..scenario.file import scenario_to_text
from ..simulation.loops import loop_of
from .checked_store import check_store
from .drawn_values import draw_members
from .store import CODE, REPEATED, Store, create_store, open_store, remove_empty, software
from .summaries import Array, arrays_of, marks_of, samples_per_cycle
from .varied_keys import Vary, read_varies
from .worker import Recipe, Worker, checked, joined, named, pickled, rows

if TYPE_CHECKING:
    import xarray

CHUNK = 1000  # members, where no trajectories are kept
CHUNK_BYTES = 64_000_000  # trajectories of a chunk


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
    if threads is not None and threads < 1:
        raise ScenarioError(f"threads = {threads}: must be a whole number, at least 1")
    if dask is not None and out is None:
        raise ScenarioError("dask: needs out, a folder that all workers can reach")
    for module in ("zarr", *(["distributed"] if dask is not None else [])):
        needed(module)
    loop = loop_of(system)
    scenario, changes = loop.scenario, checked(loop.changes, loop.scenario)
    varies = read_varies(scenario, vary)
    marks, per_cycle = marks_of(scenario, times), samples_per_cycle(scenario, samples)
    path = None if out is None else Path(out).absolute()
    if path is not None:
        check_name(path)
        if not path.exists():
            check_writable(path)
    values = draw_members(scenario, varies, members, design, seed)
    recipe = Recipe(
        scenario_to_text(scenario),
        str(scenario._folder.absolute()),
        tuple(values),
        per_cycle,
        marks,
        trajectories,
        b"" if changes == UNCHANGED else pickled(changes, dask is not None),
    )
    worker = Worker(recipe)
    arrays = arrays_of(worker.scenario, worker.times, values, trajectories)
    asked = {
        "scenario": scenario_to_text(scenario, None if path is None else path.parent),
        "vary": [one.text for one in varies],
        "keys": [one.key for one in varies],
        "members": members,
        "design": design,
        "seed": seed,
        "chunk": min(_chunk(chunk, arrays), members),
        "trajectories": trajectories,
        "samples": per_cycle,
        "times": list(marks),
        "law": named(changes),
    }
    store = _store(path, worker, asked, arrays)
    count = threads or available_threads()

    def report(done: int) -> None:
        if done and out is not None:
            keep(f"{out} holds {done} of {members} members; the same command goes on from there")
        if progress is not None:
            progress(done)

    try:
        if dask is None:
            _run_here(worker, store, count, report)
        else:
            from .cluster import run_on_cluster

            run_on_cluster(worker, store, dask, count, report)
    except BaseException:
        if dask in (None, "local"):  # far workers may still write
            remove_empty(store)
        raise
    store.finish()
    data = store.dataset()
    data.encoding.setdefault("folder", str(scenario._folder.absolute()))  # of its field
    return data


def available_threads() -> int:
    """Return the number of processors this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _run_here(worker: Worker, store: Store, threads: int, report: Callable[[int], None]) -> None:
    missing = store.missing()
    done = store.done(missing)
    report(done)
    spread = -(-(store.members - done) // (4 * threads))  # some batches for every thread
    size = min(worker.batch, max(8, -(-spread // 8) * 8)) if missing else 0
    batches = _batches(store, missing, size)
    running: deque[tuple[int, Future]] = deque()
    parts: list[dict[str, np.ndarray]] = []  # of the first chunk that runs
    pool = ThreadPoolExecutor(threads)
    try:
        while True:
            while len(running) < 2 * threads and (batch := next(batches, None)) is not None:
                running.append((batch[0], pool.submit(worker.summaries, batch[1])))
            if not running:
                return
            index, future = running.popleft()
            while not wait([future], timeout=SLICE).done:
                check()
            check()
            parts.append(future.result())
            done += len(parts[-1]["status"])
            first, last = store.range(index)
            if sum(len(part["status"]) for part in parts) == last - first:
                store.write(index, joined(parts))
                parts = []
            report(done)
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


def _batches(store: Store, missing: list[int], size: int) -> Iterator[tuple[int, dict]]:
    """Cut chunks into batches: the chunk, and the values."""
    for index in missing:
        values = store.values(index)
        first, last = store.range(index)
        for start in range(0, last - first, size):
            yield index, rows(values, start, min(start + size, last - first))


# --- before it runs -------------------------------------------------------------------------------


def _chunk(chunk: int | None, arrays: Mapping[str, Array]) -> int:
    """Return how many members are written at once."""
    if chunk is None:
        own = sum(8 * int(np.prod(v.shape[1:])) for v in arrays.values() if "time" in v.dims)
        chunk = max(1, min(CHUNK, CHUNK_BYTES // own)) if own else CHUNK
    if chunk < 1:
        raise ScenarioError(f"chunk = {chunk}: must be a whole number, at least 1")
    return chunk


def _store(
    path: Path | None, worker: Worker, asked: dict[str, Any], arrays: Mapping[str, Array]
) -> Store:
    """Make the store, or open one that holds a part of the same ensemble."""
    if path is None or not path.exists() or (path.is_dir() and not any(path.iterdir())):
        attrs = {**_attributes(worker.scenario, asked), CODE: worker.code}
        return create_store(path, asked, arrays, attrs)
    store = open_store(path)
    check_same(store, asked)
    older = check_store(store, arrays)
    if (older or store.group.attrs[CODE] != worker.code) and store.missing():
        raise DataError(
            f"{path}: was begun by other versions of the code ({store.group.attrs['software']})"
            ", whose numbers may differ in the last bit; give another --out"
        )
    return store


def _attributes(scenario: Scenario, arguments: dict[str, Any]) -> dict[str, Any]:
    return {
        "Conventions": "CF-1.11",
        "title": scenario.title,
        "source": f"clpt-control {version('clpt-control')}",
        "software": software(),
        **{name: arguments[name] for name in REPEATED},
    }


def check_same(store: Store, arguments: Mapping[str, Any]) -> None:
    """Refuse a store of another ensemble."""
    for name, value in arguments.items():
        held = store.arguments.get(name)
        if held == value:
            continue
        what = "another scenario" if name == "scenario" else f"{name} = {_shown(held)}"
        wanted = "" if name == "scenario" else f", not {_shown(value)}"
        raise DataError(f"{store.path}: holds an ensemble of {what}{wanted}; give another --out")


def _shown(value: Any) -> str:
    text = ", ".join(map(str, value)) if isinstance(value, list) else str(value)
    return text if len(text) <= 60 else text[:57] + "..."
