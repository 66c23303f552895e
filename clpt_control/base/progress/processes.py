"""Worker processes: they speak through pipes alone, print nothing, and end with their parent.

No socket is opened, so that no other program can reach them.
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

QUIET = "ignore:resource_tracker"  # no warning that multiprocessing tidies after an interrupt


class Pool(ProcessPoolExecutor):
    """Processes that ignore Ctrl-C: their parent takes it, and ends them."""

    def submit(self, *work: Any, **named: Any) -> Future:
        """Submit a function of the package; a process that is started inherits what is blocked."""
        main = sys.modules["__main__"]
        # else it would run the user's script
        sys.modules["__main__"] = ModuleType("__main__")
        try:
            return self._submit(*work, **named)
        finally:
            sys.modules["__main__"] = main

    def _submit(self, *work: Any, **named: Any) -> Future:
        if not hasattr(signal, "pthread_sigmask"):
            return super().submit(*work, **named)
        resource_tracker.ensure_running()  # else it would unblock the signal
        before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        try:
            return super().submit(*work, **named)
        finally:
            signal.pthread_sigmask(signal.SIG_SETMASK, before)


@contextmanager
def processes(count: int) -> Iterator[Pool]:
    """Yield a pool of so many processes, which are killed at the end."""
    if QUIET not in sys.warnoptions:
        sys.warnoptions.append(QUIET)
    pool = Pool(count, get_context("spawn"), _begin)
    before = active_children()
    try:
        yield pool
    finally:
        for one in set(active_children()) - set(before):
            one.kill()
        # its thread must not outlive the pipes that it reads
        pool.shutdown(cancel_futures=True)


def _begin() -> None:
    """Make ready another process."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # where it cannot be blocked
    gc.set_threshold(200_000, 50, 50)  # as in `clpt`: expressions are many objects
    os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
    threading.Thread(target=_end, daemon=True).start()


def _end() -> None:
    parent = parent_process()
    if parent is not None:
        parent.join()
    os._exit(0)  # also amid a piece of work
