"""Parts judged by two processes: this one, and another that is asked part by part.

The other is a Python that reads a part a line and answers with its verdict.  It first
says the digest of what it judges by; where that is not ours, as for equations that were changed in
memory, it is let go.  It ends where this process does, or is interrupted.  This process takes
parts from the front, the other from behind, so that not both compile what the first ones run.
"""

import json
import os
import subprocess
import sys
import threading
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from typing import TYPE_CHECKING

from ...files.user_cache import cache_folder
from ...progress import interrupt

if TYPE_CHECKING:  # the other process starts before all this is imported
    from .judgement import Part, Verdicts

COMMAND = [sys.executable, "-m", "clpt_control.theory.proving.second_process"]


class SecondProcess:
    """A process that judges parts which are left, where there is a core for it."""

    def __init__(self) -> None:
        self.work: subprocess.Popen | None = None
        self.thread, self.taken = threading.Thread(), set["Part"]()

    def start(self) -> None:
        """Start it, unless it was; what it needs takes a while to be imported."""
        if self.work is None and (os.cpu_count() or 1) > 1:
            self.work = subprocess.Popen(
                COMMAND,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                text=True,
                env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))},
            )

    def take(self, left: "deque[Part]", found: "Verdicts", digest: str) -> None:
        """Take parts from what is left, in a thread, if both processes judge by the same."""
        if self.work is not None and digest:
            self.thread = threading.Thread(target=self._ask, args=(left, found, digest))
            self.thread.daemon = True
            self.thread.start()

    def _ask(self, left: "deque[Part]", found: "Verdicts", digest: str) -> None:
        from .judgement import restored

        assert self.work is not None
        asked, told = self.work.stdin, self.work.stdout
        assert asked is not None
        assert told is not None
        with suppress(OSError, ValueError, IndexError):
            if told.readline().strip() != digest:
                return
            while True:
                part = left.pop()
                self.taken.add(part)
                print(json.dumps(part), file=asked, flush=True)
                found[part] = restored(json.loads(told.readline()))

    def __enter__(self) -> "SecondProcess":
        return self

    def __exit__(self, *error: object) -> None:
        if self.work is not None:
            self.work.kill()
            if self.thread.ident is not None:
                self.thread.join()
            with self.work:  # closes the pipes
                self.work = None


def nothing_kept() -> bool:
    """Whether no verdict was ever kept; what is kept of other equations takes long to tell."""
    folder = cache_folder()
    return folder is None or not any(folder.glob("verdicts-*.json"))


def judge(
    parts: "list[Part]",
    digest: str,
    report: Callable[[float], None] = lambda done: None,
    second: SecondProcess | None = None,
) -> "Verdicts":
    """Judge parts; `report` is called with the number done, `second` may run already."""
    left, found = deque(parts), dict["Part", object]()
    with second or SecondProcess() as other:
        if len(left) > 2:
            other.start()
            other.take(left, found, digest)
        while True:
            interrupt.check()
            with suppress(IndexError):
                part = left.popleft()
                found[part] = part.judged()
                report(len(found))
                continue
            if not other.thread.is_alive():
                break
            interrupt.wait(0.05)
            report(len(found))
    for part in other.taken - found.keys():  # what the other left
        found[part] = part.judged()
    return {part: found[part] for part in parts}
