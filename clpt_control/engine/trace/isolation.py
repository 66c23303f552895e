"""Isolation: a function that is traced changes nothing outside of itself.

The allow-list is the first safety net, and isolation is the second.  While a thread traces a
function, the functions by which Python reaches files, processes and sockets refuse that thread, and
its prints, warnings and log records are dropped.  Other threads are not affected.  (An audit hook
sees the same calls, but Python calls it for every `id()` of the process: 3 % of a small run.)

What a function changes of the values that it reaches is put back (`contents`).
"""

import importlib
import os
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import reduce
from typing import Any

from ..record.unread import Unread, active
from .references import OUTSIDE, words

WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND
LOCK = threading.RLock()
_installed: list[
    tuple[Any, str, Any, Any]
] = []  # owner, name, real one and replacement
_depth = 0


class _Silent:
    """A stream that drops what the tracing thread writes, and is the real one for others."""

    def __init__(self, real, path: str):
        self._real = real

    def __getattr__(self, name: str) -> Any:
        return getattr(self._real, name)

    def write(self, text: str) -> int:
        """Write a text, but none of the thread that traces."""
        return self._real.write(text) if active() is None else len(text)

    def writelines(self, lines: Any) -> None:
        """Write lines, but none of the thread that traces."""
        if active() is None:
            self._real.writelines(lines)


def _replaced(real: Callable, traced: Callable) -> Callable:
    """Return a function that calls `traced` in the tracing thread, and otherwise the real one."""

    def replacement(*arguments, **options):
        return (real if active() is None else traced)(*arguments, **options)

    return replacement


def _refusing(real: Callable, path: str) -> Callable:
    label = path.removeprefix("builtins.").removesuffix(".__init__")

    def refuse(*arguments, **options):
        raise Unread(f"calls {label}, {OUTSIDE}")

    return _replaced(real, refuse)


def _read_only(real: Callable, path: str) -> Callable:
    def opened(file, mode="r", *arguments, **options):
        writes = mode & WRITING if isinstance(mode, int) else {*"wax+"} & {*mode}
        if writes:
            raise Unread(f"opens a file to write, {OUTSIDE}")
        return real(file, mode, *arguments, **options)

    return _replaced(real, opened)


def _dropping(real: Callable, path: str) -> Callable:
    return _replaced(real, lambda *arguments, **options: None)


REFUSED = words(
    """
    os.remove os.unlink os.rename os.replace os.mkdir os.rmdir os.link os.symlink
    os.chmod os.chown os.truncate os.utime os.putenv os.unsetenv os.chdir os.umask
    os.kill os.system os.write os.fork os.forkpty os.posix_spawn os.posix_spawnp
    os.execv os.execve os.abort os._exit os.pipe os.mkfifo os.mknod os.nice
    os.startfile builtins.input subprocess.Popen.__init__ socket.socket.__init__
    threading.Thread.start sqlite3.connect ctypes.memmove ctypes.memset
    """
)
DROPPED = words(
    """
    warnings.warn warnings.showwarning logging.basicConfig logging.Logger.handle
    logging.Logger.setLevel
    """
)
REPLACED: dict[str, Callable[[Any, str], Any]] = {  # by path
    **dict.fromkeys(REFUSED, _refusing),
    **dict.fromkeys(words("builtins.open io.open os.open"), _read_only),
    **dict.fromkeys(DROPPED, _dropping),
    **dict.fromkeys(words("sys.stdout sys.stderr"), _Silent),
    "sys.dont_write_bytecode": lambda real, path: True,
}


def _replacements() -> Iterator[tuple[Any, str, Any, Any]]:
    """Yield owner, name, the real function or stream, and its replacement."""
    for path, replace in REPLACED.items():
        module, *inner, name = path.split(".")
        owner = reduce(getattr, inner, importlib.import_module(module))
        if (real := getattr(owner, name, None)) is not None:
            yield owner, name, real, replace(real, path)


@contextmanager
def isolated() -> Iterator[None]:
    """Refuse side effects of the thread that traces a function."""
    global _depth
    with LOCK:
        _depth += 1
        if _depth == 1:
            _installed.extend(_replacements())
            for owner, name, _, new in _installed:
                setattr(owner, name, new)
    try:
        yield
    finally:
        with LOCK:
            _depth -= 1
            for owner, name, real, new in _installed if not _depth else ():
                if vars(owner)[name] is new:
                    setattr(owner, name, real)
            if not _depth:
                _installed.clear()
