"""The same ensemble on a Dask cluster.

Workers receive a scenario's text and a chunk's number; they read its members'
values from the store, which they must be able to reach, and write the chunk
straight into it.  The chunk of a worker that is lost is given to another one.
"""

import multiprocessing
import signal
import sys
import uuid
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from multiprocessing import resource_tracker
from pathlib import Path
from typing import Any

from ..errors import ClptError, DataError, SimulationError
from ..progress.interrupt import asked, check, leave
from .store import Store, open_store
from .worker import Recipe, Worker, worker_of

PATIENCE = 30  # seconds to wait for a scheduler and its first worker
RETRIES = 3  # times a chunk is given to a worker again


@contextmanager
def connected(address: str, workers: int) -> Iterator[Any]:
    """Connect to a scheduler, ``"tcp://host:port"``, or start a ``"local"`` cluster.

    The client that it yields has at least one worker.
    """
    from distributed import Client, LocalCluster

    if address == "local":
        with (
            _interrupted_at_once(),
            LocalCluster(
                n_workers=0, threads_per_worker=1, processes=True, dashboard_address=":0"
            ) as cluster,
            Client(cluster) as client,
            _interrupted_at_once(),
        ):
            cluster.sync(_deaf)
            cluster.scale(workers)
            yield client
        return
    try:
        client = Client(address, timeout=PATIENCE)
    except (OSError, ValueError, TimeoutError):
        raise ClptError(
            f"dask = '{address}': no scheduler answers; must be local or tcp://HOST:PORT"
        ) from None
    try:
        try:
            client.wait_for_workers(1, timeout=PATIENCE)
        except TimeoutError:
            raise ClptError(f"dask = '{address}': the scheduler has no worker") from None
        yield client
    finally:
        client.close()


@contextmanager
def _interrupted_at_once() -> Iterator[None]:
    """End the command `clpt` and its workers at an interrupt.

    Dask would wait, and print at length that workers are lost.
    """
    quiet = "ignore:resource_tracker"  # also for the process in which Python tidies up
    sys.warnoptions.append(quiet)
    try:
        yield
    except BaseException:
        if asked():
            for process in multiprocessing.active_children():
                process.kill()
            leave()
        raise
    finally:
        sys.warnoptions.remove(quiet)


async def _deaf() -> None:
    """Make workers, which this thread starts, ignore Ctrl-C: the main process ends them."""
    if hasattr(signal, "pthread_sigmask"):
        resource_tracker.ensure_running()  # else it would unblock the signal later
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})


def run_on_cluster(
    worker: Worker, store: Store, address: str, workers: int, report: Callable[[int], None]
) -> None:
    """Run the chunks that are missing; `report` is called with the number of members done."""
    missing = store.missing()
    done = store.done(missing)
    report(done)
    if not missing:
        return
    with connected(address, workers) as client:
        from distributed import KilledWorker, as_completed

        futures = client.map(
            run_chunk,
            missing,
            recipe=worker.recipe,
            code=worker.code,
            path=str(store.path),
            pure=False,
            retries=RETRIES,
            key=[f"clpt-ensemble-{uuid.uuid4().hex[:12]}-{index}" for index in missing],
        )
        given = dict(zip(futures, missing, strict=True))
        try:
            for future in as_completed(futures):
                check()
                if future.status == "error":
                    raise future.exception(timeout=PATIENCE)
                # ask the store: the worker may be lost by now
                index = given.pop(future)
                if not store.is_whole(index):
                    raise SimulationError(f"dask: chunk {index} did not reach {store.path}")
                done += store.range(index)[1] - store.range(index)[0]
                report(done)
        except KilledWorker:
            raise SimulationError(
                "dask: a chunk was lost with its worker again and again (out of memory?); "
                "what is done is kept, a smaller --chunk may go on from there"
            ) from None
        except BaseException:
            if not asked():
                client.cancel(list(given), force=True)
            raise


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
