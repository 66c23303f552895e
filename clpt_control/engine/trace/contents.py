"""Contents of values that code reaches: one table of kinds for the readers of these.

`fingerprint` digests contents, `rebinding` makes values of other items, `heaps` joins contents of
paths, and `Mutable` compares them and writes them back.

    list [a, b]            structure list,    keys 0, 1,     items a, b
    dict {"k": a}          structure dict,    keys "k",      items a
    variable               structure cell,    keys 0,        items a; none if it has no value
    object with slots      structure class,   keys names,    items values
    array of numbers       structure its type and shape,  item its bytes
    method, partial, ...   structure class,   no keys,        items function, object, ...

A content is one level deep: its items are the same objects.

A fingerprint walks over all that functions reference.  If the walk met immutable values alone, and
each of its `Reads` is still the same object, another walk would give the same fingerprint.
"""

import abc
import functools
import pickle
from collections import OrderedDict, deque
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from operator import is_
from types import CellType, FunctionType, MemberDescriptorType, MethodType
from typing import Any, NamedTuple

import numpy as np

from ...base.arguments import attribute_of
from ..record.graph import key_of
from ..record.unread import Unread
from .arrays import Array
from .references import IMMUTABLE, PLAIN_BASES, root_of

UNBOUND = object()  # stands for no value


class Content(NamedTuple):
    """Content of a value; contents of one structure and the same keys differ in items alone."""

    structure: Any
    keys: list[Any]
    items: Sequence[Any]


class Kind(NamedTuple):
    """Reader of a kind of value, its writer, and its maker from other items.

    There is no writer if nothing changes such values.
    """

    read: Callable[[Any], Content]
    write: Callable[[Any, Content], None] | None = None
    make: Callable[..., Any] | None = None


# --- kinds --------------------------------------------------------------------------------------


def _read_row(value: Any) -> Content:
    return Content(type(value), [*range(len(value))], [*value])


def _write_list(value: list, content: Content) -> None:
    value[:] = content.items


def _read_dict(value: dict) -> Content:
    keys = [*value] if isinstance(value, OrderedDict) else [*dict.keys(value)]
    structure = type(value), attribute_of(value, "default_factory")
    return Content(structure, keys, [dict.__getitem__(value, key) for key in keys])


def _write_dict(value: dict, content: Content) -> None:
    kind = OrderedDict if isinstance(value, OrderedDict) else dict
    kind.clear(value)
    for key, item in zip(content.keys, content.items, strict=True):
        kind.__setitem__(value, key, item)


def _read_cell(cell: CellType) -> Content:
    items = [] if cell == CellType() else [cell.cell_contents]
    return Content(CellType, [*range(len(items))], items)


def _write_cell(cell: CellType, content: Content) -> None:
    if content.items:
        cell.cell_contents = content.items[0]
    elif cell != CellType():
        del cell.cell_contents


def _read_array(value: np.ndarray) -> Content:
    address = None if value.base is None else value.__array_interface__["data"]
    structure = value.dtype.str, value.shape, address
    items = [*value.flat] if value.dtype.hasobject else [value.tobytes()]
    return Content(structure, [*range(len(items))], items)


def _write_array(value: np.ndarray, content: Content) -> None:
    if value.dtype.hasobject:
        for index, item in zip(np.ndindex(value.shape), content.items, strict=True):
            value[index] = item
    elif value.flags.writeable:  # else nothing was written into it
        value[...] = np.frombuffer(content.items[0], value.dtype).reshape(value.shape)


def _read_attributes(value: Any) -> Content:
    """Read a class's own data and functions, or what an object holds in slots."""
    if isinstance(value, type):
        attributes = {
            name: item for name, item in vars(value).items() if _is_own(name, item)
        }
    else:
        attributes = slot_values(value)
    return Content(type(value), [*attributes], [*attributes.values()])


def _write_attributes(value: Any, content: Content) -> None:
    owner = type if isinstance(value, type) else object
    now = _read_attributes(value)
    for name in {*now.keys} - {*content.keys}:
        owner.__delattr__(value, name)
    current = dict(zip(now.keys, now.items, strict=True))
    for name, item in zip(content.keys, content.items, strict=False):
        if current.get(name, UNBOUND) is not item:
            owner.__setattr__(value, name, item)


def holding(make: Callable[..., Any] | None, *names: str) -> Kind:
    """Return the kind of a value that holds others, which never change, in attributes."""
    return Kind(
        lambda value: Content(type(value), [], [getattr(value, n) for n in names]),
        make=make,
    )


def _cached_property(function: FunctionType, name: str) -> Any:
    copy = functools.cached_property(fixing_results(function))
    copy.attrname = name
    return copy


def fixing_results(function: FunctionType) -> Any:
    """Return a function of which no result may be changed, as cached ones outlive the call."""

    def fixed(value):
        if isinstance(value, Array):
            value._fixed = True
        elif isinstance(value, tuple):
            deque(map(fixed, value), 0)
        elif type(value) not in IMMUTABLE and not isinstance(value, float | np.generic):
            raise Unread(
                f"caches a {type(value).__name__}; cache numbers, arrays or tuples"
            )
        return value

    return functools.wraps(function)(
        lambda *arguments, **options: fixed(function(*arguments, **options))
    )


LIST = Kind(_read_row, _write_list)
DICT = Kind(_read_dict, _write_dict)
CELL = Kind(_read_cell, _write_cell)
ARRAY = Kind(_read_array, _write_array)
ATTRIBUTES = Kind(_read_attributes, _write_attributes)
PANDAS = Kind(
    lambda value: Content(type(value), [0], [pickle.dumps(value)]),
    lambda value, content: vars(value).update(vars(pickle.loads(content.items[0]))),
)
HOLDERS: dict[type, Kind] = {  # of functions
    MethodType: holding(MethodType, "__func__", "__self__"),
    functools.partial: holding(
        lambda func, args, keywords: functools.partial(func, *args, **keywords),
        "func",
        "args",
        "keywords",
    ),
    functools.cached_property: holding(_cached_property, "func", "attrname"),
    functools._lru_cache_wrapper: holding(fixing_results, "__wrapped__"),
    **dict.fromkeys(
        (property, abc.abstractproperty), holding(property, "fget", "fset", "fdel")
    ),
    **dict.fromkeys(
        (staticmethod, abc.abstractstaticmethod), holding(staticmethod, "__func__")
    ),
    **dict.fromkeys(
        (classmethod, abc.abstractclassmethod), holding(classmethod, "__func__")
    ),
}
MUTABLE = {list: LIST, dict: DICT, np.ndarray: ARRAY, CellType: CELL}


def kind_of_mutable(value: Any) -> Kind:
    """Return the kind of a list, dict, array, variable, class, table or object with slots."""
    for base, kind in MUTABLE.items():
        if isinstance(value, base):
            return kind
    return PANDAS if root_of(type(value)) == "pandas" else ATTRIBUTES


def slot_values(value: Any) -> dict[str, Any]:
    """Return the attributes that an object holds in slots."""
    values = {}
    kind: Any = type(value)
    for name, slot in declared(kind, MemberDescriptorType).items():
        with suppress(AttributeError):  # it is not set
            values[name] = slot.__get__(value)
    return values


@functools.lru_cache(maxsize=256)
def declared(owner: type, kind: type) -> dict[str, Any]:
    """Return the attributes of one kind in a class and its bases, such as its slots."""
    bases = (base for base in owner.__mro__ if base not in PLAIN_BASES)
    attributes = (item for base in bases for item in vars(base).items())
    return {name: value for name, value in attributes if isinstance(value, kind)}


def _is_own(name: str, value: Any) -> bool:
    """Return whether a class attribute is data or a function, and none of Python's own."""
    special = name.startswith("__") and name.endswith("__")
    return isinstance(value, FunctionType) or not (special or name.startswith("_abc_"))


# --- values that outlive a function -------------------------------------------------------------


@dataclass
class Mutable:
    """A value that a function may change, with its content before."""

    value: Any
    words: str = "a value"  # for a sentence
    names: Iterable[str] | None = None  # attributes that the referenced code names
    ignored: frozenset[str] = frozenset()  # attributes that any call may change
    kind: Kind = field(init=False)
    before: Content = field(init=False)

    def __post_init__(self) -> None:
        self.kind = kind_of_mutable(self.value)
        self.before = self.kind.read(self.value)

    def put(self, content: Content) -> None:
        """Replace the content."""
        assert self.kind.write is not None
        self.kind.write(self.value, content)

    def changed(self, expected: Content) -> str:
        """Return words for what differs from a content, "" for nothing."""
        now = self.kind.read(self.value)
        if _is_identical(now, expected):
            return ""
        before = dict(zip(expected.keys, expected.items, strict=True))
        after = dict(zip(now.keys, now.items, strict=True))
        for key in after | before:
            is_unchanged = _is_same(after.get(key, UNBOUND), before.get(key, UNBOUND))
            if not is_unchanged and key not in self.ignored:
                return (
                    f"{key!r} of {self.words}" if isinstance(key, str) else self.words
                )
        return "" if self.ignored or now[:2] == expected[:2] else self.words


def _is_identical(a: Content, b: Content) -> bool:
    return a[:2] == b[:2] and all(map(is_, a.items, b.items))


def _is_same(a: Any, b: Any) -> bool:
    """Return whether values are one object, or equal numbers or texts."""
    is_plain = type(a) is type(b) and type(a) in (float, int, str, bytes)
    return a is b or (is_plain and key_of(a) == key_of(b))


def restore(values: Iterable[Mutable]) -> None:
    """Put back the contents before tracing."""
    for mutable in values:
        if not _is_identical(mutable.kind.read(mutable.value), mutable.before):
            mutable.put(mutable.before)


# --- values that a walk over functions has read -------------------------------------------------

PARTS = ("__code__", "__defaults__", "__kwdefaults__", "__closure__")  # of a function


def variable(cell: CellType) -> Any:
    """Return the value of a variable of a closure, or UNBOUND."""
    return UNBOUND if cell == CellType() else cell.cell_contents


@dataclass
class Reads:
    """Values of names, variables of closures and parts of functions, each with its reader.

    `complete` is false as soon as a walk has read anything else, such as an attribute or a list.
    """

    values: list[tuple[Callable[[], Any], Any]] = field(default_factory=list)
    complete: bool = True

    def value(self, value: Any, read: Callable[..., Any], *arguments: Any) -> None:
        """Note a value; one that is made anew at each access is not compared."""
        self.values.append((functools.partial(read, *arguments), value))
        self.complete = self.complete and read(*arguments) is value

    def function(self, function: FunctionType) -> None:
        """Note a function; one with attributes of its own is not compared."""
        for name in PARTS:
            self.value(getattr(function, name), getattr, function, name)
        self.value(0, lambda: len(vars(function)))

    def unchanged(self) -> bool:
        """Return whether each value is the same object."""
        return self.complete and all(read() is value for read, value in self.values)
