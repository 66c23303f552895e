"""The same ensemble by other processes: of this machine, or of a Dask cluster.

Workers receive a scenario's text and a chunk's number; they read its members'
values from the store, which they must be able to reach, and write the chunk
straight into it.  The chunk of a cluster's worker that is lost is given to another one.
"""

from collections.abc import Callable, Iterator
from concurrent.futures import BrokenExecutor, CancelledError, Executor, as_completed
from contextlib import contextmanager
from pathlib import Path

from ..errors import ClptError, DataError, SimulationError
from ..progress.interrupt import check
from ..progress.processes import processes
from .store import Store, open_store
from .worker import Recipe, Worker, worker_of

PATIENCE = 30  # seconds to wait for a scheduler and its first worker
RETRIES = 3  # times a chunk is given to a worker again
KEPT = "what is done is kept"


@contextmanager
def pool_of(address: str, workers: int) -> Iterator[Executor]:
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
            raise ClptError(f"dask = '{address}': the scheduler has no worker") from None
        try:
            yield client.get_executor(pure=False, retries=RETRIES)
        except KilledWorker as error:
            raise BrokenExecutor from error


def run_on_cluster(
    worker: Worker, store: Store, address: str, workers: int, report: Callable[[int], None]
) -> None:
    """Run the chunks that are missing; `report` is called with the number of members done."""
    missing = store.missing()
    done = store.done(missing)
    report(done)
    if not missing:
        return
    work = worker.recipe, worker.code, str(store.path)
    try:
        with pool_of(address, workers) as pool:
            given = {pool.submit(run_chunk, index, *work): index for index in missing}
            for future in as_completed(given):
                check()
                future.result()
                index = given[future]  # ask the store: the worker may be lost by now
                if not store.is_whole(index):
                    raise SimulationError(f"dask: chunk {index} did not reach {store.path}")
                done += store.range(index)[1] - store.range(index)[0]
                report(done)
    except BrokenExecutor:
        raise SimulationError(
            "dask: a worker was lost with its chunk (out of memory? then give a smaller --chunk); "
            f"{KEPT}"
        ) from None
    except CancelledError:
        raise SimulationError(f"dask: the scheduler {address} was lost; {KEPT}") from None


def run_chunk(index: int, recipe: Recipe, code: str, path: str) -> int:
    """Run one chunk on a worker and write it; `code` must be that of the one who asks."""
    worker = worker_of(recipe)
    if worker.code != code:
        raise DataError(
            "dask: a worker has other versions of clpt-control, llvmlite or numpy, or "
            "another Python; its numbers might differ in the last bit"
        )
    store = open_store(Path(path))
    first, last = store.range(index)
    if not store.is_whole(index):  # else its worker was lost after writing it
        store.write(index, worker.chunk(store.values(index)))
    return last - first
