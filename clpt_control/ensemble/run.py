"""Run an ensemble of a scenario or a diagram on threads, on other processes, or on a cluster.

All arguments are checked, and the store is made or opened, before a member runs.  Compiled
members run without the interpreter, so threads run in parallel.  A chunk is divided into batches,
each a task.  The size of batches depends on threads and memory, the results do not: every member
is integrated and summarised by itself.

Workers in other processes receive the pickled ensemble and the number of a chunk.  They read the
values of its members from the store, which they must be able to reach, and write the chunk into
it.  If a worker of a cluster is lost, another worker runs its chunk.
"""

import os
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent import futures
from contextlib import contextmanager
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any

import control
import numpy as np

from ..base.arguments import Count, Seed, public
from ..base.errors import (
    ClptError,
    DataError,
    ScenarioError,
    SimulationError,
    import_optional,
    refuse_unused,
)
from ..base.files import check_writable
from ..base.progress import interrupt, progress_shown, warn
from ..base.progress.processes import processes
from ..paper.scenario.experiment import Scenario
from ..simulation.loops import loop_of
from .members import Ensemble, Values, concatenated, cut, ensemble_of, verified_ensemble
from .results import (
    COMPLETED,
    STATUS,
    EnsembleResults,
    arrays_of,
    attributes_of,
    begun_or_made,
    open_store,
)
from .sampled_parameters import check_varies, draw_members, grid_count, read_varies
from .varied_diagram import VariedDiagram
from .varied_scenario import VariedScenario

if TYPE_CHECKING:
    import xarray

CHUNK = 1000  # members without trajectories
CHUNK_BYTES = 64_000_000  # trajectories of a chunk
PATIENCE = 30  # seconds to wait for a scheduler and its first worker
RETRIES = 3  # of a chunk whose worker was lost
OF_FILES = (".nc", ".csv", ".mat", ".h5", ".hdf5", ".json", ".html", ".toml")
STORED = "finished members are stored"
Report = Callable[
    [int, int], None
]  # called with numbers of newly done and stored members


@public
def run_ensemble(
    system: Scenario | control.InputOutputSystem,
    vary: str | Iterable[str] | Mapping[str, Any],
    members: Count | None = None,
    design: str | None = None,
    seed: Seed = 0,
    out: str | Path | None = None,
    *,
    timepts: Any = None,
    inputs: Any = None,
    initial_state: Any = None,
    params: Mapping[str, Any] | None = None,
    rtol: float | None = None,
    atol: float | None = None,
    method: str | None = None,
    threads: Count | None = None,
    trajectories: bool = False,
    chunk: Count | None = None,
    times: Sequence[float] | None = None,
    summary: Mapping[str, Callable] | None = None,
    progress: bool | Callable[[int], None] | None = None,
    dask: str | None = None,
) -> "xarray.Dataset":
    """Run many members of one scenario, or of any diagram.

    The result does not depend, to the last bit, on threads, cluster, chunks or interruptions. If
    `out` has the same ensemble, only the missing chunks are run.

    Parameters
    ----------
    system : Scenario or control.InputOutputSystem
        A scenario, or its `closed_loop` with blocks and linear systems of your own, which are
        pickled for other processes; with `timepts` any diagram that `simulate` runs.
    vary : dict, str or several
        ``{"plant.m": np.linspace(1, 2, 5), "c.k": "0.2:2.0", "d": scipy.stats.norm(0, 1)}``:
        a list of values, a range, a distribution; or ``"learning.gain=0.2:2.0"``,
        ``"flow.parameters~normal:0.1"``, ``"learning.gain=[0.5, 1, 2]"``. Keys of a scenario; of a
        diagram the names of parameters in `params`, a parameter of a block, ``"plant.m"``, an
        element, ``"c.K[0]"``, an initial state by its label, or an input, which is constant.
    members : int, optional
        Number of members. Default: every combination, if `vary` has only lists.
    design : str, optional
        ``"lhs"``, ``"grid"`` or ``"random"``. Default: a grid if `vary` is a dict of lists or
        `members` is not given, otherwise lhs.
    seed : int, optional
        Seed of the design.
    out : str or Path, optional
        Folder of a Zarr store. Default: in memory.
    timepts, inputs, initial_state, params, rtol, atol, method : optional
        Of a diagram, as in `simulate`.
    threads : int, optional
        Number of threads. Default: all processors.
    trajectories : bool, optional
        Store the states at the scenario's samples too; of a diagram its outputs at `timepts`.
    chunk : int, optional
        Members written at once; memory grows with it, not with `members`.
    times : sequence of float, optional
        Times of the errors of a scenario. Default: 41 evenly spaced times.
    summary : dict of callables, optional
        Of a diagram, without `out`: ``{"settling": function}``. Each function is called with the
        outputs of a member, an xarray.Dataset at `timepts`, and returns a number. A member that
        failed has NaN.
    progress : bool or callable, optional
        True prints a progress bar on standard error; a function is called with the number
        of members done.
    dask : str, optional
        Address of a Dask scheduler, or ``"local"``; needs `out`.

    Returns
    -------
    xarray.Dataset
        Summaries and, if requested, trajectories. Sampled parameters are coordinates; those of a
        grid of numbers are its index, so that `unstack` makes them dimensions. Arrays are read from
        `out` when used. A diagram has ``y_final``, ``y_rms`` and ``y_max`` (largest
        absolute value) of each output y, at `timepts`, until a guard stops the member.

    Raises
    ------
    ScenarioError
        If an argument is not allowed; the message names a member.
    DataError
        If `out` cannot be written or has another ensemble.
    DiagramError
        If a block does not fit or cannot be pickled.
    SimulationError
        If a cluster could not run a chunk.

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
    # 1. check arguments
    if dask is not None and out is None:
        raise ScenarioError("dask: needs out, a folder that all workers can reach")
    for module in ["zarr"] * (out is not None) + ["distributed"] * (dask is not None):
        import_optional(module)
    varies = read_varies(vary)
    path = None if out is None else Path(out).absolute()
    if path is not None and path.suffix.lower() in OF_FILES:
        raise ScenarioError(
            f"out = {out}: is a folder, a Zarr store. Give a name such as {path.stem}.zarr"
        )
    if summary is not None and path is not None:
        raise ScenarioError(
            "summary: is for a result in memory, since a folder cannot store functions. Leave out "
            "out, or store trajectories"
        )
    if path is not None and not os.path.lexists(path):
        check_writable(path)
    run_options = {
        "inputs": inputs,
        "initial_state": initial_state,
        "params": params,
        "method": method,
        "rtol": rtol,
        "atol": atol,
    }
    if timepts is None or isinstance(system, Scenario):
        remedy = "needs timepts. Give these too"
        if isinstance(system, Scenario):
            remedy = "is for a diagram. Leave it out, or give closed_loop(scenario)"
        refuse_unused(remedy, timepts=timepts, summary=summary, **run_options)
        loop = getattr(system, "origin", None)
        if not isinstance(system, Scenario) and (loop is None or loop.external):
            raise ScenarioError("timepts: is required to run a diagram many times")
        loop = loop_of(system)
        varied: Any = VariedScenario(loop.scenario, loop.changes, times, trajectories)
    else:
        refuse_unused(
            "is for a scenario; a diagram has timepts. Leave it out", times=times
        )
        run_options |= {"trajectories": trajectories, "summary": summary}
        varied = VariedDiagram(system, varies, timepts, **run_options)
    check_varies(varied, varies)
    # 2. sample the parameters
    if design is None:
        has_lists = all(item.kind == "levels" for item in varies)
        is_grid = members is None or (has_lists and isinstance(vary, Mapping))
        design = "grid" if is_grid else "lhs"
    members = grid_count(varies) if members is None else members
    values = draw_members(varied, varies, members, design, seed)
    # 3. compile, and make or open the store
    identity = varied.arguments(path)
    ensemble = verified_ensemble(varied, values)
    recipe = b"" if dask is None else ensemble.recipe
    arrays = arrays_of(varied, values)
    arguments = {
        **identity,
        "vary": [item.text for item in varies],
        "keys": [item.key for item in varies],
        "members": members,
        "design": design,
        "seed": seed,
        "chunk": min(_chunk(chunk, arrays), members),
        "trajectories": trajectories,
    }
    attributes = attributes_of(varied.title, ensemble.code, arguments)
    store = begun_or_made(path, attributes, arrays)
    # 4. run the missing chunks
    missing = store.missing()
    count = threads or available_threads()
    try:
        with progress_shown(progress, members) as show:
            report = _reporter(out, members, show)
            present = members - store.count(missing)
            report(present, present)
            if dask is None:
                _run_here(ensemble, store, missing, count, report)
            elif missing:
                work = recipe, ensemble.code, str(path)
                _run_elsewhere(work, store, missing, dask, count, report)
    except BaseException:
        if dask in (None, "local"):  # workers of a cluster may still write
            store.remove_empty()
        raise
    store.finish()
    data = store.dataset()
    data.encoding = {**varied.encoding, **data.encoding}
    # 5. warn of failed members
    statuses = data["status"].values
    failed = np.flatnonzero(~np.isin(statuses, COMPLETED))
    if len(failed) and isinstance(varied, VariedDiagram):
        m = int(failed[0])
        reason = _failure(ensemble, values, m, int(statuses[m]))
        warn(
            f"{len(failed)} of {members} members did not finish; "
            f"the first is member {m}: {reason}"
        )
    return data


def _reporter(out: Any, members: int, show: Callable[[int], None]) -> Report:
    """Return a function that counts members, shows progress and sets the hint to resume."""
    completed = stored = 0

    def report(newly_done: int, newly_stored: int) -> None:
        nonlocal completed, stored
        completed += newly_done
        stored += newly_stored
        if stored and out is not None:
            interrupt.resume_hint = (
                f"{out} holds {stored} of {members} members; "
                "the same command goes on from there"
            )
        show(completed)

    return report


def _failure(ensemble: Ensemble, values: Values, m: int, number: int) -> str:
    """Run a failed member again and return the reason, which begins with its status."""
    status = STATUS[number].replace("_", " ")
    runner, arguments = ensemble.single(values, m)
    try:
        runner.signals(runner.solve(*arguments), arguments[2])
    except SimulationError as error:
        reason = str(error)
        return reason if reason.startswith(status) else f"{status}: {reason}"
    return status


def available_threads() -> int:
    """Return the number of processors that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _run_here(
    ensemble: Ensemble,
    store: EnsembleResults,
    missing: list[int],
    threads: int,
    report: Report,
) -> None:
    """Run the missing chunks on threads, and write each chunk when its batches are done."""
    members = store.count(missing)
    share = -(-members // (4 * threads))  # some batches for every thread
    size = min(ensemble.batch, max(8, -(-share // 8) * 8))
    batches = (
        (index, values)
        for index in missing
        for values in cut(store.values(index), size)
    )
    summaries = []  # of the oldest chunk that is running
    count = threads if members > size else 1
    for index, batch in _in_order(ensemble.summaries, batches, count):
        summaries.append(batch)
        completed = sum(len(summary["status"]) for summary in summaries)
        written = 0
        if completed == store.count([index]):
            store.write(index, concatenated(summaries))
            summaries, written = [], completed
        report(len(batch["status"]), written)


def _in_order(
    run: Callable[[Values], Values], batches: Iterator[tuple[int, Values]], threads: int
) -> Iterator[tuple[int, Values]]:
    """Run batches on threads, two for each at once; yield chunks and summaries in order."""
    if threads <= 1:
        for index, values in batches:
            yield index, run(values)
        return
    running: deque[tuple[int, futures.Future]] = deque()
    pool = futures.ThreadPoolExecutor(threads)
    try:
        while True:
            for index, values in islice(batches, 2 * threads - len(running)):
                running.append((index, pool.submit(run, values)))
            if not running:
                return
            index, future = running.popleft()
            while not futures.wait([future], timeout=interrupt.SLICE).done:
                interrupt.check()
            interrupt.check()
            yield index, future.result()
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


# --- other processes -----------------------------------------------------------------------------


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
            f"dask = '{address}': no scheduler answers. Give local or tcp://HOST:PORT"
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
    store: EnsembleResults,
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
                index = indices[
                    future
                ]  # check the store: the worker may be lost by now
                if not store.is_complete(index):
                    raise SimulationError(
                        f"dask: chunk {index} did not reach {store.path}"
                    )
                count = store.count([index])
                report(count, count)
    except futures.BrokenExecutor:
        raise SimulationError(
            "dask: a worker was lost with its chunk (if memory is short, give a smaller --chunk); "
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
    if not store.is_complete(index):  # a worker may be lost after writing
        batches = cut(store.values(index), ensemble.batch)
        store.write(index, concatenated([*map(ensemble.summaries, batches)]))


def _chunk(chunk: int | None, arrays: "Mapping[str, xarray.Variable]") -> int:
    """Return the number of members of a chunk."""
    if chunk is None:
        trajectories = (array for array in arrays.values() if "time" in array.dims)
        size = sum(8 * int(np.prod(array.shape[1:])) for array in trajectories)
        chunk = max(1, min(CHUNK, CHUNK_BYTES // size)) if size else CHUNK
    return chunk
