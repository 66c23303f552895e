"""Parts judged by two processes: this one, and another that is asked part by part.

The other is a Python that reads a part a line and answers with its verdict.  It first
says the digest of what it judges by; where that is not ours, as for equations that were changed in
memory, it is let go.  It ends where this process does, or is interrupted.
"""

import json
import os
import subprocess
import sys
import threading
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress

from ...progress import interrupt
from .judgement import Part, Verdicts, restored

COMMAND = [sys.executable, "-m", "clpt_control.theory.proving.second_process"]


def judge(
    parts: list[Part], digest: str, report: Callable[[float], None] = lambda done: None
) -> Verdicts:
    """Judge parts, the long ones first; `report` is called with the number done."""
    left, found = deque(parts), Verdicts()
    with _second_process(left, found, digest) as (thread, taken):
        while True:
            interrupt.check()
            with suppress(IndexError):
                part = left.popleft()
                found[part] = part.judged()
                report(len(found))
                continue
            if not thread.is_alive():
                break
            interrupt.wait(0.05)
            report(len(found))
    for part in taken - found.keys():  # what the other left
        found[part] = part.judged()
    return {part: found[part] for part in parts}


@contextmanager
def _second_process(
    left: deque, found: Verdicts, digest: str
) -> Iterator[tuple[threading.Thread, set]]:
    """Start a process that takes parts from what is left, in a thread; yield it and its parts."""
    taken: set[Part] = set()
    if (os.cpu_count() or 1) < 2 or len(left) < 3 or not digest:
        yield threading.Thread(), taken
        return
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    work = subprocess.Popen(
        COMMAND,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        env=environment,
    )

    def ask() -> None:
        assert work.stdin is not None
        assert work.stdout is not None
        with suppress(OSError, ValueError, IndexError):
            if work.stdout.readline().strip() != digest:
                return
            while True:
                part = left.popleft()
                taken.add(part)
                print(json.dumps(part), file=work.stdin, flush=True)
                found[part] = restored(json.loads(work.stdout.readline()))

    thread = threading.Thread(target=ask, daemon=True)
    thread.start()
    try:
        yield thread, taken
    finally:
        work.kill()
        thread.join()
        with work:  # closes the pipes
            pass
