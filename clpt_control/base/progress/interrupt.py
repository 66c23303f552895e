"""Reliable handling of interrupts (Ctrl-C).

Python raises a KeyboardInterrupt in the main thread, between two of its instructions.  In a
callback of compiled code the exception is dropped, in an import it may become an ImportError, and
in a long call of compiled code it is not raised.  Therefore the handler here also sets a flag, and
loops that wait or make long calls test it by `check`.  On POSIX the system also writes the signal
into a pipe; a thread reads it and ends a process that is still running some seconds later.
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

# end of the message without a `resume_hint`
NOTHING = "nothing half-written was left"
PATIENCE = 3.0  # seconds until an interrupted process is killed
SLICE = 0.5  # seconds of a wait between two tests of the flag
SIGNALS = (signal.SIGINT, signal.SIGTERM)  # signals that interrupt
ANSWERED = b"\0"  # to the thread: the interrupt was handled

unfinished: set[Path] = set()  # files being written, removed if the process is ended
# folders created for results, the outermost first; removed if they stay empty
folders: list[Path] = []
# end of the message: what has been stored, and how to resume; set by the work
resume_hint = ""

_pending = False  # True if an interrupt was not handled yet
_ended = False  # True if the command has ended: an interrupt has no effect
_printed = False  # True if the message was printed
_writer = -1  # the thread's descriptor to write to; -1 without a thread


def listen(before: Any) -> None:
    """Install the handler for interrupts in place of the handler `before`.

    A process that was started with interrupts ignored continues to ignore them.
    """
    global _pending, _ended, _printed, _writer, resume_hint
    _pending = _ended = _printed = False
    resume_hint = ""
    if signal.getsignal(signal.SIGINT) is not before:
        return
    atexit.register(_exit_as_interrupted)
    sys.excepthook, sys.unraisablehook = _uncaught, _dropped
    signal.signal(signal.SIGINT, _on_signal)
    if os.name == "posix":
        reader, _writer = os.pipe()
        os.set_blocking(_writer, False)
        signal.set_wakeup_fd(_writer, warn_on_full_buffer=False)
        threading.Thread(target=_watch, args=(reader,), daemon=True).start()


def pending() -> bool:
    """Return True if an interrupt came and was not handled yet."""
    return _pending


def check() -> None:
    """Raise a KeyboardInterrupt if an interrupt came; in any thread."""
    if _pending and not _ended:
        raise KeyboardInterrupt


def wait(seconds: float) -> None:
    """Sleep for some seconds, or raise a KeyboardInterrupt after an interrupt."""
    end = time.monotonic() + seconds
    check()
    while (remaining := end - time.monotonic()) > 0:
        time.sleep(min(SLICE, remaining))
        check()


def answer() -> None:
    """Handle an interrupt as the end of a wait, and go on."""
    global _pending
    _pending = False
    if _writer >= 0:
        os.write(_writer, ANSWERED)


def end() -> None:
    """End the command: later interrupts have no effect."""
    global _ended
    _ended = True
    _tidy()


def say() -> None:
    """Print the message of an interrupted process on standard error, once."""
    global _printed
    if not _printed:
        _printed = True
        tell(_sentence())


def _sentence() -> str:
    return escaped(f"clpt: interrupted; {resume_hint or NOTHING}")


def _tidy() -> None:
    """Remove unfinished files and empty folders."""
    for path in list(unfinished):
        with suppress(OSError):
            remove(path)
    while folders:
        with suppress(OSError):
            folders.pop().rmdir()


def remove(path: Path) -> None:
    """Remove a file, or a folder with its content, if it exists."""
    if path.is_dir():
        shutil.rmtree(path, ignore_errors=True)
    else:
        path.unlink(missing_ok=True)


def leave() -> NoReturn:
    """End the process at once, and remove unfinished files."""
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
    """Handle SIGTERM, which a machine sends at its shutdown, as an interrupt."""
    before = signal.signal(signal.SIGTERM, _on_signal)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before or signal.SIG_DFL)


def _on_signal(number: int, frame: FrameType | None) -> None:
    global _pending
    is_new, _pending = not _pending, True
    if is_new and not _ended:
        raise KeyboardInterrupt


def _uncaught(kind: type[BaseException], error: BaseException, traceback: Any) -> None:
    """End the process after an interrupt that was not caught."""
    if not issubclass(kind, KeyboardInterrupt):
        sys.__excepthook__(kind, error, traceback)
        return
    say()
    os._exit(130)


def _dropped(problem: Any) -> None:
    """Ignore an interrupt that a callback dropped: the flag is set."""
    if not (_pending and isinstance(problem.exc_value, KeyboardInterrupt)):
        sys.__unraisablehook__(problem)


def _exit_as_interrupted() -> None:
    """Exit with the status of an interrupt, as the last function that Python calls at its end.

    Python would restore the default handler next, and end by the signal if code that it compiled
    from a text, such as that of a named tuple, was interrupted.
    """
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    if _printed:
        os._exit(130)


def _watch(reader: int) -> None:
    """End the process if an interrupt is not handled in time."""
    from select import select

    deadline = None
    while True:
        remaining = None if deadline is None else max(0.0, deadline - time.monotonic())
        if not select([reader], [], [], remaining)[0]:
            leave()
        for byte in os.read(reader, 64):
            if byte == ANSWERED[0]:
                deadline = None
            elif byte in SIGNALS and deadline is None:
                deadline = time.monotonic() + PATIENCE
