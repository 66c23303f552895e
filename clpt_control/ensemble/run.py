"""Run an ensemble on the threads of one machine, on other processes of it, or on a cluster.

What is run many times is a scenario (`of_scenarios`), or any diagram (`of_diagrams`).

All arguments are checked, and the store is made or opened, before a member runs.  Compiled
members need no interpreter, so threads run side by side.  A chunk is
cut into batches, each a task; batches differ with threads and memory, results do
not: every member is integrated and summarised by itself.

Workers of other processes receive what varies and a chunk's number; they read its members'
values from the store, which they must be able to reach, and write the chunk
straight into it.  The chunk of a cluster's worker that is lost is given to another one.
"""

import os
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent import futures
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import control
import numpy as np

from ..base.arguments import Seed, public
from ..base.errors import ClptError, DataError, ScenarioError, SimulationError, needed
from ..base.files import check_writable
from ..base.progress import interrupt, progress_shown, warn
from ..base.progress.processes import processes
from ..paper.scenario.experiment import Scenario
from ..simulation.loops import loop_of
from .drawn_values import check_varies, draw_members, grid_count, read_varies
from .members import Ensemble, checked_ensemble, concatenated, cut, ensemble_of
from .of_diagrams import VariedDiagram
from .of_scenarios import VariedScenario
from .store import Store, begun_or_made, open_store, remove_empty
from .summaries import STATUS, Arrays

if TYPE_CHECKING:
    import xarray

CHUNK = 1000  # members, where no trajectories are kept
CHUNK_BYTES = 64_000_000  # trajectories of a chunk
PATIENCE = 30  # seconds to wait for a scheduler and its first worker
RETRIES = 3  # times a chunk is given to a worker again
STORED = "what is done is kept"
Report = Callable[[int, int], None]  # of how many more members are done, and are stored


@public
def run_ensemble(
    system: Scenario | control.InputOutputSystem,
    vary: str | Iterable[str] | Mapping[str, Any],
    members: int | None = None,
    design: str | None = None,
    seed: Seed = 0,
    out: str | Path | None = None,
    *,
    timepts: Sequence[float] | np.ndarray | None = None,
    inputs: Any = None,
    initial_state: Any = None,
    params: Mapping[str, Any] | None = None,
    rtol: float | None = None,
    atol: float | None = None,
    method: str | None = None,
    threads: int | None = None,
    trajectories: bool = False,
    chunk: int | None = None,
    times: Sequence[float] | None = None,
    progress: bool | Callable[[int], None] | None = None,
    dask: str | None = None,
) -> "xarray.Dataset":
    """Run many members of one scenario, or of any diagram.

    The result does not depend, to the last bit, on threads, cluster, chunks
    or interruptions. Where `out` holds the same ensemble, only the chunks
    that are missing are run.

    Parameters
    ----------
    system : Scenario or control.InputOutputSystem
        The base: a scenario, or its `closed_loop` with blocks and linear systems of your own, which
        other processes get pickled; with `timepts` any diagram that `simulate` takes.
    vary : dict, str or several
        ``{"plant.m": np.linspace(1, 2, 5), "c.k": "0.2:2.0", "d": scipy.stats.norm(0, 1)}``:
        a list of values, a range, a distribution; or ``"learning.gain=0.2:2.0"``,
        ``"flow.parameters~normal:0.1"``, ``"learning.gain=[0.5, 1, 2]"``. Of a scenario its keys;
        of a diagram parameters as `params` calls them, one of a block, ``"plant.m"``, an element,
        ``"c.K[0]"``, an initial state by its label, an input, which is held at its value.
    members : int, optional
        How many; where `vary` has lists alone, every combination of them without.
    design : str, optional
        ``"lhs"``, ``"grid"`` or ``"random"``; a grid where `vary` is a dict of lists or `members`
        is not given, else lhs.
    seed : int, optional
        Of the design.
    out : str or Path, optional
        Folder of a Zarr store; in memory without.
    timepts, inputs, initial_state, params, rtol, atol, method : optional
        Of a diagram, as `simulate` takes them.
    threads : int, optional
        At most so many at once; all processors without.
    trajectories : bool, optional
        Keep the states at the scenario's own samples too; of a diagram its outputs at `timepts`.
    chunk : int, optional
        Members written at once; memory grows with it, not with `members`.
    times : sequence of float, optional
        Of a scenario: when errors are kept; 41 evenly spaced times without.
    progress : bool or callable, optional
        True prints a progress bar on standard error; a function is called with the number
        of members done.
    dask : str, optional
        Address of a Dask scheduler, or ``"local"``; needs `out`.

    Returns
    -------
    xarray.Dataset
        Summaries and, if asked for, trajectories; what varies are coordinates, of a grid of
        numbers its index, so that `unstack` makes them dimensions. Read from `out` when used. Of
        each output y of a diagram ``y_final``, ``y_rms`` and ``y_max``, at `timepts`.

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
    >>> import control
    >>> lag = control.nlsys(lambda t, x, u, p: (u - x) / p["tau"], None, inputs=1, states=1,
    ...                     outputs=1, params={"tau": 1.0}, name="lag")
    >>> data = run_ensemble(lag, {"tau": [0.5, 1, 2]}, timepts=[0.0, 1.0], inputs=1.0)
    >>> data.unstack()["y_final"].values.round(3)
    array([0.865, 0.632, 0.393])
    """
    if threads is not None and threads < 1:
        raise ScenarioError(f"threads = {threads}: must be a whole number, at least 1")
    if dask is not None and out is None:
        raise ScenarioError("dask: needs out, a folder that all workers can reach")
    for module in ("zarr", *(["distributed"] if dask is not None else [])):
        needed(module)
    varies = read_varies(vary)
    path = None if out is None else Path(out).absolute()
    if path is not None and not os.path.lexists(path):
        check_writable(path)
    of_diagram = {
        "inputs": inputs,
        "initial_state": initial_state,
        "params": params,
        "method": method,
        "rtol": rtol,
        "atol": atol,
    }
    if timepts is None or isinstance(system, Scenario):
        _refuse("is for a diagram, with timepts", timepts=timepts, **of_diagram)
        loop = getattr(system, "origin", None)
        if not isinstance(system, Scenario) and (loop is None or loop.external):
            raise ScenarioError("timepts: is required to run a diagram many times")
        loop = loop_of(system)
        varied: Any = VariedScenario(loop.scenario, loop.changes, times, trajectories)
    else:
        _refuse("is for a scenario; a diagram has timepts", times=times)
        varied = VariedDiagram(
            system, varies, timepts, trajectories=trajectories, **of_diagram
        )
    check_varies(varied, varies)
    if design is None:
        listed = all(one.kind == "levels" for one in varies)
        design = (
            "grid"
            if members is None or (listed and isinstance(vary, Mapping))
            else "lhs"
        )
    members = grid_count(varies) if members is None else members
    values = draw_members(varied, varies, members, design, seed)
    of_system = varied.arguments(path)
    ensemble = checked_ensemble(varied, values)
    recipe = b"" if dask is None else ensemble.recipe
    arrays = varied.arrays(values)
    arguments = {
        **of_system,
        "vary": [one.text for one in varies],
        "keys": [one.key for one in varies],
        "members": members,
        "design": design,
        "seed": seed,
        "chunk": min(_chunk(chunk, arrays), members),
        "trajectories": trajectories,
    }
    store = begun_or_made(path, varied.title, ensemble.code, arguments, arrays)
    missing, done, stored = store.missing(), 0, 0

    def report(more: int, written: int) -> None:
        nonlocal done, stored
        done, stored = done + more, stored + written
        if stored and out is not None:
            interrupt.resume_hint = (
                f"{out} holds {stored} of {members} members; "
                "the same command goes on from there"
            )
        shown(done)

    count = threads or available_threads()
    try:
        with progress_shown(progress, "ensemble", members) as shown:
            there = members - store.count(missing)
            report(there, there)
            if dask is None:
                _run_here(ensemble, store, missing, count, report)
            elif missing:
                work = recipe, ensemble.code, str(path)
                _run_elsewhere(work, store, missing, dask, count, report)
    except BaseException:
        if dask in (None, "local"):  # far workers may still write
            remove_empty(store)
        raise
    store.finish()
    data = store.dataset()
    data.encoding = {**varied.encoding, **data.encoding}
    failed = np.flatnonzero(data["status"].values != 1)
    if len(failed) and isinstance(varied, VariedDiagram):
        first = int(failed[0])
        why = status = STATUS[int(data["status"][first])].replace("_", " ")
        runner, at, options = ensemble.single(values, first)
        try:
            runner.signals(runner.run(*at, **options), options["inputs"])
        except SimulationError as error:
            why = str(error) if str(error).startswith(status) else f"{status}: {error}"
        some = f"{len(failed)} of {members} members did not finish"
        warn(f"{some}; the first is member {first}: {why}")
    return data


def _refuse(why: str, **unused: Any) -> None:
    """Refuse arguments that are of no use here."""
    for name, value in unused.items():
        if value is not None:
            raise ScenarioError(f"{name}: {why}; leave it out")


def available_threads() -> int:
    """Return the number of processors this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _run_here(
    ensemble: Ensemble, store: Store, missing: list[int], threads: int, report: Report
) -> None:
    spread = -(-store.count(missing) // (4 * threads))  # some batches for every thread
    size = min(ensemble.batch, max(8, -(-spread // 8) * 8))
    batches = (
        (index, part) for index in missing for part in cut(store.values(index), size)
    )
    running: deque[tuple[int, futures.Future]] = deque()
    parts = []  # of the first chunk that runs
    pool = futures.ThreadPoolExecutor(threads)
    try:
        while True:
            while (
                len(running) < 2 * threads
                and (batch := next(batches, None)) is not None
            ):
                running.append((batch[0], pool.submit(ensemble.summaries, batch[1])))
            if not running:
                return
            index, future = running.popleft()
            while not futures.wait([future], timeout=interrupt.SLICE).done:
                interrupt.check()
            interrupt.check()
            parts.append(future.result())
            done, written = sum(len(part["status"]) for part in parts), 0
            if done == store.count([index]):
                store.write(index, concatenated(parts))
                parts, written = [], done
            report(len(future.result()["status"]), written)
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


# --- by other processes --------------------------------------------------------------------------


@contextmanager
def pool_of(address: str, workers: int) -> Iterator[futures.Executor]:
    """Yield a ``"local"`` pool of processes, or that of a scheduler, ``"tcp://host:port"``."""
    if address == "local":
        with processes(workers) as pool:
            yield pool
        return
    from distributed import Client, KilledWorker

    try:
        client = Client(address, timeout=PATIENCE)
    except (OSError, ValueError, TimeoutError):
        raise ClptError(
            f"dask = '{address}': no scheduler answers; must be local or tcp://HOST:PORT"
        ) from None
    with client:
        try:
            client.wait_for_workers(1, timeout=PATIENCE)
        except TimeoutError:
            raise ClptError(
                f"dask = '{address}': the scheduler has no worker"
            ) from None
        try:
            yield client.get_executor(pure=False, retries=RETRIES)
        except KilledWorker as error:
            raise futures.BrokenExecutor from error


def _run_elsewhere(
    work: tuple,
    store: Store,
    missing: list[int],
    address: str,
    workers: int,
    report: Report,
) -> None:
    try:
        with pool_of(address, workers) as pool:
            indices = {pool.submit(run_chunk, index, *work): index for index in missing}
            for future in futures.as_completed(indices):
                interrupt.check()
                future.result()
                index = indices[future]  # ask the store: the worker may be lost by now
                if not store.is_whole(index):
                    raise SimulationError(
                        f"dask: chunk {index} did not reach {store.path}"
                    )
                count = store.count([index])
                report(count, count)
    except futures.BrokenExecutor:
        raise SimulationError(
            "dask: a worker was lost with its chunk (out of memory? then give a smaller --chunk); "
            f"{STORED}"
        ) from None
    except futures.CancelledError:
        raise SimulationError(
            f"dask: the scheduler {address} was lost; {STORED}"
        ) from None


def run_chunk(index: int, recipe: bytes, code: str, path: str) -> None:
    """Run one chunk on a worker and write it; `code` must be that of the caller."""
    ensemble = ensemble_of(recipe)
    if ensemble.code != code:
        raise DataError(
            "dask: a worker has other versions of clpt-control, llvmlite or numpy, or "
            "another Python; its numbers might differ in the last bit"
        )
    store = open_store(Path(path))
    if not store.is_whole(index):  # else its worker was lost after writing it
        parts = cut(store.values(index), ensemble.batch)
        store.write(index, concatenated([*map(ensemble.summaries, parts)]))


# --- before it runs -------------------------------------------------------------------------------


def _chunk(chunk: int | None, arrays: Arrays) -> int:
    """Return how many members are written at once."""
    if chunk is None:
        each = sum(
            8 * int(np.prod(v.shape[1:])) for v in arrays.values() if "time" in v.dims
        )
        chunk = max(1, min(CHUNK, CHUNK_BYTES // each)) if each else CHUNK
    if chunk < 1:
        raise ScenarioError(f"chunk = {chunk}: must be a whole number, at least 1")
    return chunk
