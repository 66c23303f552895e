"""Interrupts that cannot be lost.

Python makes a KeyboardInterrupt of Ctrl-C, in the main thread, between two of its
own instructions.  In a callback of compiled code that exception is dropped, in an
import it may come out as an ImportError, and within one long call of compiled code it
is not raised at all.  So the handler here also sets a flag; every loop that waits
or runs long calls `check`, which looks at it.  On POSIX the system also writes the signal
into a pipe: a thread reads it and ends a process that still lives some seconds later.
"""

import atexit
import os
import shutil
import signal
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from types import FrameType
from typing import Any, NoReturn

from . import CLEARED, escaped, tell

# ends the sentence where there is no `resume_hint`
NOTHING = "nothing half-written was left"
PATIENCE = 3.0  # seconds that an interrupted process may take to end by itself
SLICE = 0.5  # seconds of a wait between two looks at the flag
SIGNALS = (signal.SIGINT, signal.SIGTERM)  # those that may interrupt
ANSWERED = b"\0"  # to the thread: the interrupt was dealt with

unfinished: set[Path] = set()  # files being written, removed where the process is ended
folders: list[
    Path
] = []  # made for results, the outermost first; removed where they stay empty
# ends the sentence: what is stored by now, and how to go on; work sets it
resume_hint = ""

_pending = False  # whether an interrupt waits for its answer
_ended = False  # whether the command has ended: an interrupt changes nothing any more
_printed = False  # whether the sentence was printed
_writer = -1  # the descriptor by which the thread hears; -1 where there is none


def listen(before: Any) -> None:
    """Take interrupts from here on, from the handler `before`.

    A process that was started with interrupts ignored goes on ignoring them.
    """
    global _pending, _ended, _printed, _writer, resume_hint
    _pending = _ended = _printed = False
    resume_hint = ""
    if signal.getsignal(signal.SIGINT) is not before:
        return
    atexit.register(_last)
    sys.excepthook, sys.unraisablehook = _uncaught, _dropped
    signal.signal(signal.SIGINT, _on_signal)
    if os.name == "posix":
        reader, _writer = os.pipe()
        os.set_blocking(_writer, False)
        signal.set_wakeup_fd(_writer, warn_on_full_buffer=False)
        threading.Thread(target=_watch, args=(reader,), daemon=True).start()


def pending() -> bool:
    """Return whether an interrupt came and has no answer yet."""
    return _pending


def check() -> None:
    """Raise a KeyboardInterrupt if an interrupt came; in any thread."""
    if _pending and not _ended:
        raise KeyboardInterrupt


def wait(seconds: float) -> None:
    """Sleep so many seconds, or raise a KeyboardInterrupt once an interrupt comes."""
    end = time.monotonic() + seconds
    check()
    while (left := end - time.monotonic()) > 0:
        time.sleep(min(SLICE, left))
        check()


def answer() -> None:
    """Take the interrupt for the end of a wait, and go on."""
    global _pending
    _pending = False
    if _writer >= 0:
        os.write(_writer, ANSWERED)


def end() -> None:
    """End the command: an interrupt that comes now changes nothing any more."""
    global _ended
    _ended = True
    _tidy()


def say() -> None:
    """Print on standard error, once, that the process was interrupted."""
    global _printed
    if not _printed:
        _printed = True
        tell(_sentence())


def _sentence() -> str:
    return escaped(f"clpt: interrupted; {resume_hint or NOTHING}")


def _tidy() -> None:
    """Remove what is half-written, and folders in which nothing is."""
    for path in list(unfinished):
        with suppress(OSError):
            remove(path)
    while folders:
        with suppress(OSError):
            folders.pop().rmdir()


def remove(path: Path) -> None:
    """Remove a file or a folder with all that is in it, if it is there."""
    if path.is_dir():
        shutil.rmtree(path, ignore_errors=True)
    else:
        path.unlink(missing_ok=True)


def leave() -> NoReturn:
    """End the process here and now, without half-written files."""
    global _printed
    _tidy()
    with suppress(OSError):
        if os.isatty(2):
            os.write(2, CLEARED.encode())
        if not _printed:
            _printed = True
            os.write(2, f"{_sentence()}\n".encode(errors="backslashreplace"))
    os._exit(130)


@contextmanager
def terminated() -> Iterator[None]:
    """Take SIGTERM, sent by a machine that stops, for an interrupt."""
    before = signal.signal(signal.SIGTERM, _on_signal)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before or signal.SIG_DFL)


def _on_signal(number: int, frame: FrameType | None) -> None:
    global _pending
    first, _pending = not _pending, True
    if first and not _ended:
        raise KeyboardInterrupt


def _uncaught(kind: type[BaseException], error: BaseException, traceback: Any) -> None:
    """End by an interrupt that nothing has caught."""
    if not issubclass(kind, KeyboardInterrupt):
        sys.__excepthook__(kind, error, traceback)
        return
    say()
    os._exit(130)


def _dropped(problem: Any) -> None:
    """Ignore the error where a callback dropped an interrupt: the flag is set."""
    if not (_pending and isinstance(problem.exc_value, KeyboardInterrupt)):
        sys.__unraisablehook__(problem)


def _last() -> None:
    """End with the status of an interrupt, after all else that Python calls at its end.

    Python would take back the handler next, and end by the signal where code that it
    ran from text, as that of a named tuple, had seen the interrupt.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if _printed:
        os._exit(130)


def _watch(reader: int) -> None:
    """End the process where an interrupt is not answered in time."""
    from select import select

    last = None
    while True:
        left = None if last is None else max(0.0, last - time.monotonic())
        if not select([reader], [], [], left)[0]:
            leave()
        for byte in os.read(reader, 64):
            if byte == ANSWERED[0]:
                last = None
            elif byte in SIGNALS and last is None:
                last = time.monotonic() + PATIENCE
