"""Runs that are ready: a second call of the same need not wire, read and lay out again."""

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from ..native.engines import VARIABLE

MOST = 16
_READY: dict[Any, Any] = {}


@contextmanager
def ready(found: tuple[Any, Any] | None, make: Callable[[], Any]) -> Iterator[Any]:
    """Yield the run of a key, made where there is none; until it is given back it is one's own.

    `found` is a key, with the objects whose places are in it.  Without one a run is made each time,
    and so is what runs in Python, of which a warning tells each time.
    """
    key = found and (found[0], os.environ.get(VARIABLE))
    held, run = _READY.pop(key, (None, None))
    if run is None:
        held, run = found, make()
    yield run
    if found and run.runner.engine == "native":
        _READY[key] = held, run
        for oldest in list(_READY)[:-MOST]:
            _READY.pop(oldest, None)
