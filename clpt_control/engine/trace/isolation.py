"""Isolation: a function that is traced changes nothing outside of itself.

The allow-list is the first safety net, and isolation is the second.  While a thread traces a
function, the functions by which Python reaches files, processes and sockets refuse that thread, and
its prints, warnings and log records are dropped.  Other threads are not affected.  (An audit hook
sees the same calls, but Python calls it for every `id()` of the process: 3 % of a small run.)

Tracing runs a function more than once, on each of its execution paths.  The contents of lists,
dicts, arrays, variables, objects and classes that it may change are copied before, compared
afterwards and put back.  A content is one level deep: items are the same objects.
"""

import builtins
import ctypes
import io
import logging
import os
import pickle
import socket
import sqlite3
import subprocess
import sys
import threading
import warnings
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from math import copysign
from types import CellType, FunctionType, MemberDescriptorType
from typing import Any

import numpy as np

from .arrays import Array, Unread, active
from .references import OUTSIDE, PLAIN_BASES, root_of, words

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


def _dropping(real: Callable) -> Callable:
    return _replaced(real, lambda *arguments, **options: None)


def _replacements() -> Iterator[tuple[Any, str, Any, Any]]:
    """Yield owner, name, the real function or stream, and its replacement."""
    for owner, name, label in REFUSED:
        if (real := getattr(owner, name, None)) is not None:
            yield owner, name, real, _refusing(real, label)
    for owner, name in OPENING:
        yield owner, name, vars(owner)[name], _read_only(vars(owner)[name])
    for owner, name in DROPPED:
        yield owner, name, vars(owner)[name], _dropping(vars(owner)[name])
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


# --- contents: copied, compared and put back ----------------------------------------------------

UNBOUND = object()  # the value of a variable that has none


@dataclass
class Content:
    """A value that code may change, with its content before."""

    value: (
        Any  # a list, dict, array, cell, class, object with slots, or table of pandas
    )
    words: str = "a value"  # for a sentence
    names: Iterable[str] | None = None  # attributes that the referenced code names
    ignored: frozenset[str] = frozenset()  # attributes that any call may change
    before: Any = field(init=False)

    def __post_init__(self) -> None:
        self.before = copied(self.value)

    def changed(self, expected: Any, strictly: bool = False) -> str:
        """Return words for what differs from another content, "" for nothing.

        Attributes that any call may change are passed over, unless `strictly`.
        """
        now = copied(self.value)
        if self.ignored and not strictly:
            now, expected = (
                {
                    name: item
                    for name, item in content.items()
                    if name not in self.ignored
                }
                for content in (now, expected)
            )
        if isinstance(now, bytes):
            return "" if now == expected else self.words
        if isinstance(now, np.ndarray) and not now.dtype.hasobject:
            same = now.dtype == expected.dtype and now.tobytes() == expected.tobytes()
            return "" if same else self.words
        if isinstance(now, dict):
            for name in {**now, **expected}:
                if not _is_same(now.get(name, UNBOUND), expected.get(name, UNBOUND)):
                    return f"{name!r} of {self.words}"
            return "" if [*now] == [*expected] else f"the order of {self.words}"
        items = items_of(now)
        expected_items = items_of(expected)
        same = len(items) == len(expected_items) and all(
            map(_is_same, items, expected_items)
        )
        return "" if same else self.words

    def put_back(self) -> None:
        """Replace the content by that before."""
        put(self.value, self.before)


def _is_same(a: Any, b: Any) -> bool:
    """Return whether values are one object, or equal numbers or texts."""
    if a is b:
        return True
    if type(a) is not type(b) or type(a) not in (float, int, str):
        return False
    return a == b and (type(a) is not float or copysign(1.0, a) == copysign(1.0, b))


def restore(contents: Iterable[Content]) -> None:
    """Put back the content before tracing."""
    for content in contents:
        if content.changed(content.before, strictly=True):
            content.put_back()


def copied(value):
    """Return a copy of a content; None of a tracer array into which nothing was written."""
    if isinstance(value, list | dict):
        return list(value) if isinstance(value, list) else dict(value)
    if isinstance(value, CellType):
        return [UNBOUND if value == CellType() else value.cell_contents]
    if isinstance(value, np.ndarray):
        return np.array(value)
    if isinstance(value, Array):
        return None if value._store is None else value._store.copy()
    if isinstance(value, type):
        return {
            name: attribute
            for name, attribute in vars(value).items()
            if _is_own(name, attribute)
        }
    if root_of(type(value)) == "pandas":
        return pickle.dumps(value)
    return slot_values(value)


def put(value: Any, content: Any) -> None:
    """Replace a content."""
    if isinstance(value, list):
        value[:] = content
    elif isinstance(value, np.ndarray):
        if value.flags.writeable:  # else nothing was written into it
            value[...] = content
    elif isinstance(value, dict):
        value.clear()
        value.update(content)
    elif isinstance(value, CellType):
        if content[0] is not UNBOUND:
            value.cell_contents = content[0]
        elif value != CellType():
            del value.cell_contents
    elif isinstance(value, Array):
        if content is not None or value._store is not None:
            content = elements_of(value) if content is None else content
            value._keep()
            value._store[...] = content  # type: ignore[index]
    elif isinstance(content, bytes):
        vars(value).update(vars(pickle.loads(content)))
    else:
        owner = type if isinstance(value, type) else object
        now = copied(value)
        for name in now.keys() - content.keys():
            owner.__delattr__(value, name)
        for name, attribute in content.items():
            if now.get(name, UNBOUND) is not attribute:
                owner.__setattr__(value, name, attribute)


def items_of(content: Any) -> list[Any]:
    """Return the items of a content in one row."""
    if isinstance(content, dict):
        return [*content.values()]
    return [*content.flat] if isinstance(content, np.ndarray) else content


def elements_of(array: Array) -> np.ndarray:
    """Return the elements of a tracer array as they were before anything was written."""
    return Array(array._tape, array._node, array.shape)._elements()


def slot_values(value: Any) -> dict[str, Any]:
    """Return the attributes that an object holds in slots."""
    values = {}
    for name, slot in slots_of(type(value)).items():
        with suppress(AttributeError):  # it is not set
            values[name] = slot.__get__(value)
    return values


def slots_of(kind: type) -> dict[str, Any]:
    """Return the slots of a class, in which its objects hold attributes."""
    bases = (base for base in kind.__mro__ if base not in PLAIN_BASES)
    attributes = (item for base in bases for item in vars(base).items())
    return {
        name: slot
        for name, slot in attributes
        if isinstance(slot, MemberDescriptorType)
    }


def _is_own(name: str, value: Any) -> bool:
    """Return whether a class attribute is data or a function, and none of Python's own."""
    special = name.startswith("__") and name.endswith("__")
    return isinstance(value, FunctionType) or not (special or name.startswith("_abc_"))
