"""What a function could keep from one call to the next: objects and containers that it reaches.

A reading leaves them as they were.  What the first reading changed is unknown to the second (a leaf
of its own): a record that depends on it is no function of time, states and inputs.
"""

from types import BuiltinFunctionType, FunctionType, MethodType, ModuleType
from typing import Any

import numpy as np

DEEP = 3  # objects within objects
MOST = 200
_NONE = object()
PLAIN = (int, float, str, bytes, tuple, type, ModuleType, FunctionType, MethodType)


class Kept:
    """The state of objects as it was before a reading."""

    def __init__(self) -> None:
        self._objects: dict[int, tuple[Any, Any]] = {}
        self._changed: list[tuple[Any, Any]] = []  # container and key

    def add(self, value: Any, deep: int = DEEP) -> None:
        """Remember an object, and those within it."""
        if value is None or isinstance(value, (*PLAIN, BuiltinFunctionType, np.ndarray)):
            return
        if id(value) in self._objects or len(self._objects) >= MOST:
            return
        inside = _inside(value)
        if inside is None:
            return
        self._objects[id(value)] = value, inside.copy()
        if deep:
            within = inside.values() if isinstance(inside, dict) else inside
            for one in list(within)[:MOST]:
                self.add(one, deep - 1)

    def look(self) -> bool:
        """Note what changed since; return whether anything did."""
        for value, before in self._objects.values():
            now, first = _inside(value), _entries(before)
            for key, one in _entries(now).items():
                if one is not first.get(key, _NONE):
                    self._changed.append((now, key))
        return bool(self._changed)

    def hide(self, leaf: Any) -> None:
        """Put unknown numbers in the places that changed; what was appended stays."""
        for k, (inside, key) in enumerate(self._changed):
            if isinstance(inside, dict) or key < len(inside):
                inside[key] = leaf(k)

    def put_back(self) -> None:
        """Make all as it was."""
        for value, before in self._objects.values():
            now = _inside(value)
            if isinstance(now, list):
                now[:] = before
            elif (
                isinstance(now, dict)
                and (now.keys() != before.keys() or any(now[k] is not before[k] for k in before))
            ) or isinstance(now, set):
                now.clear()
                now.update(before)


def _inside(value: Any) -> Any:
    """Return the container that holds what an object keeps, or None."""
    if type(value) in (list, dict, set):
        return value
    own = getattr(value, "__dict__", None)
    return own if type(own) is dict else None


def _entries(inside: Any) -> dict:
    """Return what a container holds in places that have keys."""
    if isinstance(inside, list):
        return dict(enumerate(inside))
    return inside if isinstance(inside, dict) else {}
