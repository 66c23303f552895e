"""Worker processes that use pipes only, print nothing, and end with their parent.

No socket is opened, so other programs cannot connect to them.
"""

import gc
import os
import signal
import sys
import threading
from collections.abc import Iterator
from concurrent.futures import Future, ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing import (
    active_children,
    get_context,
    parent_process,
    resource_tracker,
)
from types import ModuleType
from typing import Any

QUIET = "ignore:resource_tracker"  # multiprocessing would warn of its cleanup after an interrupt


class Pool(ProcessPoolExecutor):
    """Processes that ignore Ctrl-C: their parent handles it and ends them."""

    def submit(self, *work: Any, **named: Any) -> Future:
        """Submit a function of the package; a started process inherits blocked signals."""
        main = sys.modules["__main__"]
        # with the user's module a started process would run the user's script
        sys.modules["__main__"] = ModuleType("__main__")
        try:
            return self._submit(*work, **named)
        finally:
            sys.modules["__main__"] = main

    def _submit(self, *work: Any, **named: Any) -> Future:
        if not hasattr(signal, "pthread_sigmask"):
            return super().submit(*work, **named)
        resource_tracker.ensure_running()  # started later, it would unblock the signal
        before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        try:
            return super().submit(*work, **named)
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)


@contextmanager
def processes(count: int) -> Iterator[Pool]:
    """Yield a pool of processes, which are killed at the end."""
    if QUIET not in sys.warnoptions:
        sys.warnoptions.append(QUIET)
    pool = Pool(count, get_context("spawn"), _start_worker)
    before = active_children()
    try:
        yield pool
    finally:
        for process in set(active_children()) - set(before):
            process.kill()
        # its thread must not outlive the pipes that it reads
        pool.shutdown(cancel_futures=True)


def _start_worker() -> None:
    """Initialize a worker process."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # for systems that cannot block it
    gc.set_threshold(200_000, 50, 50)  # as in `clpt`: expressions are many objects
    os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
    threading.Thread(target=_exit_with_parent, daemon=True).start()


def _exit_with_parent() -> None:
    parent = parent_process()
    if parent is not None:
        parent.join()
    os._exit(0)  # also during work
