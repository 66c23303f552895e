"""The error of a function that cannot be traced, and the tape on which a thread traces."""

from collections.abc import Iterator
from contextlib import contextmanager
from threading import local
from typing import Any


class Unread(Exception):
    """A function cannot be traced: the sentence says why, and what to write instead."""

    def __init__(self, sentence: str, stops: bool = True):
        super().__init__(sentence)
        if stops and (tape := active()) is not None:
            tape.stopped = self  # a function may catch it


_ACTIVE = local()


def active() -> Any:
    """Return the tape on which this thread traces a function now, or None."""
    return getattr(_ACTIVE, "tape", None)


@contextmanager
def reading_on(tape: Any) -> Iterator[None]:
    """Make this thread trace on a tape."""
    before = active()
    _ACTIVE.tape = tape
    try:
        yield
    finally:
        _ACTIVE.tape = before
