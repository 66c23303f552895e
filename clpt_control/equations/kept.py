"""What objects keep from one call of a function to the next.

A function is read as all is, and again from each state in which a way through it left an object
that it reaches.  There signals are unknown, leaves of their own, and so are numbers that took the
place of others; all else is as the way left it.  If all these readings are the same, and no way
leaves another state, what is kept does not matter: a cache, a log, what is written before it is
read.  Else it is a state of the function, which its record would not hold.

Objects, containers, arrays, texts in memory, classes, names of a user's modules and of functions
around one, and generators of chance are watched; each reading leaves them as they were.
"""

import functools
import pickle
import random
import sys
import threading
from array import array
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from contextvars import ContextVar
from enum import Enum
from io import BytesIO, IOBase, StringIO
from operator import is_
from types import (
    BuiltinFunctionType,
    CellType,
    FunctionType,
    MethodType,
    ModuleType,
    NoneType,
    SimpleNamespace,
)
from typing import Any

import numpy as np

from .answers import LIBRARIES
from .arrays import Array, Unread
from .record import MOST_NUMBERS
from .unchanged import names_in

LOCK = threading.RLock()  # while stand-ins are in a module
DEEP = 6  # objects within objects
MOST = 200  # objects that are watched
OWN = __package__.partition(".")[0]
AS_THEY_ARE = frozenset(  # packages into which no stand-ins are put
    (OWN, *LIBRARIES, "pandas", "xarray", "sympy", *sys.stdlib_module_names)
)
GONE, UNKNOWN = object(), object()
GROWN = 1000, 1_000_000  # unknown numbers behind what was appended, in one reading and another
CONTAINERS: Any = (list, deque, dict, set)
UNWATCHED = (bytearray, memoryview, ContextVar)  # keep what is not looked at
SIMPLE = (int, float, complex, str, bytes, frozenset, np.generic, Enum, NoneType)
NUMBERS = (int, float, complex, np.generic, np.ndarray)
PLAIN = (int, float, str, bytes, tuple, Array, BuiltinFunctionType, NoneType)
CHANCE = (np.random.Generator, np.random.RandomState, random.Random)
OF_ALL: tuple[Any, ...] = (  # whose numbers the functions of these modules draw
    vars(random)["random"].__self__,
    vars(np.random)["random"].__self__,
)


class Snapshot:
    """What objects kept before a reading, and in which states the ways through it left them."""

    def __init__(self, chance: Iterable[Any]) -> None:
        self._watched: dict[int, tuple[Any, Any]] = {}  # an object, and what it kept before
        # by what tells it apart, each state: of every object that differs what it keeps
        self.left: dict[Any, dict[int, Any]] = {}
        # modules of functions, and the names in them by which these functions reach more
        self.spaces: dict[int, tuple[dict[str, Any], set[str]]] = {}
        self.attributes: dict[int, dict[str, Any]] = {}  # of users' objects
        self._chance = {id(one): (one, _chance_of(one)) for one in chance}

    def add(self, value: Any, deep: int = DEEP) -> None:
        """Watch an object, and those within it."""
        for one in _bound_to(value):
            self.add(one, deep)
        value = getattr(value, "__func__", getattr(value, "fget", value))  # of a method, property
        self._borrow(value)
        if isinstance(value, PLAIN) or id(value) in self._watched or len(self._watched) >= MOST:
            return
        if isinstance(value, CHANCE):
            self._chance.setdefault(id(value), (value, _chance_of(value)))
        if (kept := kept_by(value)) is None:
            refuse_unwatched(value)
            return
        self._watched[id(value)] = value, kept
        for kind in () if isinstance(value, type) else type(value).__mro__:
            self._borrow(*vars(kind).values())
        if isinstance(value, CellType):  # no depth of its own
            deep += 1
        own = getattr(value, "__dict__", None)
        plain = type(value) is SimpleNamespace
        if type(own) is dict and (plain or not _is_library(type(value).__module__.split(".")[0])):
            self.attributes[id(own)] = own
        if not deep or not isinstance(kept, list | dict):
            return
        for one in [*(kept.values() if isinstance(kept, dict) else kept)][:MOST]:
            self.add(one, deep - 1)
        if isinstance(value, type):
            for one in vars(value).values():
                self.add(one, deep - 1)
        elif not isinstance(value, (*CONTAINERS, ModuleType, FunctionType)):
            self.add(type(value), deep)

    def _borrow(self, *values: Any) -> None:
        """Note the modules of functions, into which stand-ins are put while these are read."""
        for one in (one for one in values if isinstance(one, FunctionType)):
            if (one.__module__ or "").partition(".")[0] not in AS_THEY_ARE:
                _, names = self.spaces.setdefault(id(one.__globals__), (one.__globals__, set()))
                names.update(names_in(one.__code__))

    def restore(self) -> None:
        """Make all as it was; note the state in which a way left it."""
        left, keys = dict[int, Any](), []
        for place, (value, before) in self._watched.items():
            now = kept_by(value)
            if not same(now, before):
                left[place] = _unknown_in(now, before)
                keys.append((place, _key(left[place], before)))
                _put(value, before)
        if left:
            self.left.setdefault(tuple(keys), left)

    def drew(self) -> bool:
        """Make generators of chance as they were; return whether one was drawn from."""
        drawn = [(one, was) for one, was in self._chance.values() if _chance_of(one) != was]
        for one, was in drawn:
            if one not in OF_ALL:  # from which other threads draw
                getattr(one, "bit_generator", one).__setstate__(pickle.loads(was))
        return bool(drawn)

    def begin(self, state: dict[int, Any], grown: int, leaf: Callable[[str], Any]) -> None:
        """Put all as a way left it; numbers may then be any, and a list is longer."""
        for place, kept in state.items():
            value, before = self._watched[place]
            if isinstance(kept, dict):
                kept = {
                    name: leaf(f"{place} {name}") if one is UNKNOWN else one
                    for name, one in kept.items()
                }
                for one in kept.values():
                    self.add(one)
            if kept is UNKNOWN:
                more = 0 if isinstance(value, np.ndarray) else grown
                kept = [leaf(f"{place}")] * (len(before) + more)
            _put(value, kept)


def _chance_of(one: Any) -> Any:
    """Return the state of a generator of chance."""
    return pickle.dumps(getattr(one, "bit_generator", one).__getstate__())


def _bound_to(value: Any) -> list[Any]:
    """Return what a function has at each call: its object, its cells, arguments of a partial.

    Of a tuple, which itself keeps nothing, they are its items.
    """
    if isinstance(value, tuple):
        return [*value[:MOST]]
    if isinstance(value, functools.partial):
        return [value.func, *value.args, *value.keywords.values()]
    if isinstance(value, FunctionType | MethodType | BuiltinFunctionType):
        return [getattr(value, "__self__", None), *(getattr(value, "__closure__", None) or ())]
    return []


def refuse_unwatched(value: Any) -> None:
    """Refuse what no reading could leave as it was."""
    if isinstance(value, Iterator) and not isinstance(value, IOBase):
        raise Unread("reads an iterator, which goes on at the next call; make it a list")
    if isinstance(value, UNWATCHED):
        raise Unread(
            f"reads a {type(value).__name__}, where calls may keep things; make it an array"
        )


def same(now: Any, before: Any) -> bool:
    """Return whether a thing keeps the very same."""
    if isinstance(now, dict):
        alike = len(now) == len(before) and all(map(is_, now.values(), before.values()))
        return alike and now.keys() == before.keys()
    if isinstance(now, list):
        return len(now) == len(before) and all(map(is_, now, before))
    return now == before


def _unknown_in(now: Any, before: Any) -> Any:
    """Return what a way left: signals, and numbers in the place of others, are unknown."""
    if isinstance(now, list):
        return UNKNOWN if any(isinstance(one, (Array, *NUMBERS)) for one in now) else now
    if not isinstance(now, dict):
        return now
    return {
        name: UNKNOWN
        if isinstance(one, Array)
        or (isinstance(one, NUMBERS) and before.get(name) is not None and one is not before[name])
        else one
        for name, one in now.items()
    }


def _key(kept: Any, before: Any = None) -> Any:
    """Return what tells apart what is kept; of an object its type does."""
    if isinstance(kept, dict):
        was = before or {}
        return tuple((name, one is was.get(name) or _key(one)) for name, one in kept.items())
    if isinstance(kept, list | tuple):
        return tuple(map(_key, kept))
    if isinstance(kept, np.ndarray):
        return kept.tobytes()
    return (type(kept), kept) if isinstance(kept, SIMPLE) else type(kept)


def kept_by(value: Any) -> Any:
    """Return what a thing keeps: a row, things by name, or what no signal is in; None: nothing."""
    if isinstance(value, list | deque):
        return [*value]
    if isinstance(value, dict):
        return dict(value)
    if isinstance(value, set):
        return frozenset(value)
    if isinstance(value, StringIO | BytesIO):
        return value.getvalue(), value.tell()
    of_numbers = isinstance(value, np.ndarray | array) or hasattr(type(value), "to_numpy")
    if of_numbers and np.size(value) <= MOST_NUMBERS:
        numbers = np.asarray(value)
        if not numbers.dtype.hasobject:
            return numbers.tobytes()
        if numbers is value:
            return [*value.flat]
    attributes = getattr(value, "__dict__", None)
    if type(attributes) is dict and not isinstance(value, FunctionType | ModuleType):
        return dict(attributes)
    with LOCK:  # no other thread's stand-ins are in a module
        owner, names = _attributes(value)
        return None if names is None else {k: getattr(owner, k) for k in names if hasattr(owner, k)}


def _put(value: Any, kept: Any) -> None:
    """Make a thing keep this."""
    if isinstance(value, CONTAINERS):
        value.clear()
        (value.extend if isinstance(kept, list) else value.update)(kept)
    elif isinstance(value, array):  # which may have grown
        value[:] = array(value.typecode, kept)
    elif isinstance(value, StringIO | BytesIO):
        value.seek(0)
        value.truncate()
        value.write(kept[0])
        value.seek(kept[1])
    elif isinstance(value, np.ndarray) and isinstance(kept, list):
        value[...] = np.fromiter(kept, object).reshape(value.shape)
    elif isinstance(kept, bytes):
        numbers = np.asarray(value)
        before = np.frombuffer(kept, numbers.dtype).reshape(numbers.shape)
        if hasattr(type(value), "to_numpy"):
            value[:] = before
        else:
            np.copyto(numbers, before)
    else:
        owner, _ = _attributes(value)
        own, kind = getattr(owner, "__dict__", None), type if isinstance(owner, type) else object
        gone = kept_by(value).keys() - kept.keys()
        if type(own) is dict:
            own.update(kept)
            for name in gone:
                del own[name]
        else:
            for name, one in kept.items():
                kind.__setattr__(owner, name, one)
            for name in gone:
                kind.__delattr__(owner, name)


def _attributes(value: Any) -> tuple[Any, Iterable[str] | None]:
    """Return whose attributes keep something, and which; no names where nothing does.

    Of a user's function they are the names of its module that it reads.
    """
    if isinstance(value, FunctionType | ModuleType | type):
        name = value.__name__ if isinstance(value, ModuleType) else value.__module__
        if _is_library((name or "").partition(".")[0]):
            return value, None
        if isinstance(value, FunctionType):
            module = sys.modules.get(name)
            return module, module and vars(module).keys() & names_in(value.__code__)
        own = vars(value).items()
        return value, [k for k, one in own if k[:2] != "__" and not hasattr(one, "__get__")]
    if isinstance(value, CellType):  # what a function of a function names
        return value, None if value == CellType() else ["cell_contents"]
    slots = [vars(kind).get("__slots__", ()) for kind in type(value).__mro__]
    names = [name for one in slots for name in ([one] if isinstance(one, str) else one)]
    return value, names or None


@functools.lru_cache(maxsize=256)
def _is_library(root: str) -> bool:
    """Return whether a package is no user's: what its classes and modules keep are caches."""
    if root == "__main__":
        return False
    file = getattr(sys.modules.get(root), "__file__", None) or ""
    return root in (OWN, *sys.stdlib_module_names) or "-packages" in file
