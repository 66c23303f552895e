"""Isolation: a function that is traced changes nothing outside of itself.

The allow-list is the first safety net, and isolation is the second.  While a thread traces a
function, the functions by which Python reaches files, processes and sockets refuse that thread, and
its prints, warnings and log records are dropped.  Other threads are not affected.  (An audit hook
sees the same calls, but Python calls it for every `id()` of the process: 3 % of a small run.)

What a function changes of the values that it reaches is put back (`contents`).
"""

import builtins
import ctypes
import io
import logging
import os
import socket
import sqlite3
import subprocess
import sys
import threading
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from .arrays import Unread, active
from .references import OUTSIDE, words

OF_OS = words(
    """
    remove unlink rename replace mkdir rmdir link symlink chmod chown truncate utime
    putenv unsetenv chdir umask kill system write fork forkpty posix_spawn posix_spawnp
    execv execve abort _exit pipe mkfifo mknod nice startfile
    """
)
REFUSED: tuple[
    tuple[Any, str, str], ...
] = (  # owner and name of a function, and its name in words
    *((os, name, f"os.{name}") for name in OF_OS),
    (builtins, "input", "input"),
    (subprocess.Popen, "__init__", "subprocess.Popen"),
    (socket.socket, "__init__", "socket.socket"),
    (threading.Thread, "start", "threading.Thread.start"),
    (sqlite3, "connect", "sqlite3.connect"),
    *((ctypes, name, f"ctypes.{name}") for name in ("memmove", "memset")),
)
OPENING = (builtins, "open"), (io, "open"), (os, "open")
WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND
DROPPED = (
    (warnings, "warn"),
    (warnings, "showwarning"),
    (logging, "basicConfig"),
    (logging.Logger, "handle"),
    (logging.Logger, "setLevel"),
)
LOCK = threading.RLock()
_installed: list[
    tuple[Any, str, Any, Any]
] = []  # owner, name, real one and replacement
_depth = 0


class _Silent:
    """A stream that drops what the tracing thread writes, and is the real one for others."""

    def __init__(self, real):
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


def _refusing(real: Callable, label: str) -> Callable:
    def refuse(*arguments, **options):
        raise Unread(f"calls {label}, {OUTSIDE}")

    return _replaced(real, refuse)


def _read_only(real: Callable) -> Callable:
    def opened(file, mode="r", *arguments, **options):
        writes = mode & WRITING if isinstance(mode, int) else {*"wax+"} & {*mode}
        if writes:
            raise Unread(f"opens a file to write, {OUTSIDE}")
        return real(file, mode, *arguments, **options)

    return _replaced(real, opened)


def _replacements() -> Iterator[tuple[Any, str, Any, Any]]:
    """Yield owner, name, the real function or stream, and its replacement."""
    for owner, name, label in REFUSED:
        if (real := getattr(owner, name, None)) is not None:
            yield owner, name, real, _refusing(real, label)
    for owner, name in OPENING:
        yield owner, name, vars(owner)[name], _read_only(vars(owner)[name])
    for owner, name in DROPPED:
        yield (
            owner,
            name,
            vars(owner)[name],
            _replaced(vars(owner)[name], lambda *arguments, **options: None),
        )
    for name in ("stdout", "stderr"):
        if (stream := getattr(sys, name)) is not None:
            yield sys, name, stream, _Silent(stream)
    yield sys, "dont_write_bytecode", sys.dont_write_bytecode, True


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
