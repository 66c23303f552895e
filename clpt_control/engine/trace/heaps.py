"""Heap of a piece of code: the mutable values within its reach, and one heap for all its paths.

A region, such as an `if` statement, runs once for each of its paths.  Each path leaves a heap: the
contents of every list, dict, array, object and variable that the region reaches.  Heaps of paths
that differ in numbers alone are joined into one:

    y = [1, x] if x > 0,  y = [2, 0] otherwise  ->  y = [where(x > 0, 1, 2), where(x > 0, x, 0)]

Heaps are walked in step.  An object on one path corresponds to one object on each other path, so
names of one object stay names of one object.  An object that is older than the region corresponds
to itself alone.  Values of a kind that is not listed here, such as sets and iterators, are never
joined.
"""

import functools
from collections import Counter, OrderedDict, defaultdict, deque
from collections.abc import Iterable, Sequence
from enum import Enum
from itertools import zip_longest
from types import (
    BuiltinFunctionType,
    FunctionType,
    MemberDescriptorType,
    MethodType,
    ModuleType,
    SimpleNamespace,
)
from typing import Any, NamedTuple

import control
import numpy as np

from ..model.declaration import Params
from ..record.unread import Unread
from .arrays import Array, Tape, key_of, operand
from .contents import (
    ATTRIBUTES,
    HOLDERS,
    MUTABLE,
    Content,
    Kind,
    declared,
    holding,
    slot_values,
)
from .elementwise import common, is_of_python, is_truth, is_whole, lifted, where
from .references import IMMUTABLE, PACKAGE, attributes_of, is_library, is_plain, root_of

Answers = dict[int, bool]  # conditions of a path in their order, with their outcomes
Tree = Any  # of decisions: the number of a path, or (condition, tree if true, tree if false)
NUMBERS = frozenset((int, float, bool, np.float64, np.bool_))
PLAIN = (int, bool, str, bytes)  # equal ones are the same


class NotMergeable(Exception):
    """Heaps of paths have no common form: these paths are those of the code around the region."""


def decision_tree(paths: Sequence[tuple[int, Answers]], depth: int = 0) -> Tree:
    """Return the tree of the decisions by which numbered paths differ, from `depth` on."""
    (number, answers), *further = paths
    if not further:
        return number
    condition = [*answers][depth]
    branches = {
        outcome: [path for path in paths if path[1].get(condition) is outcome]
        for outcome in (True, False, None)
    }
    if branches[None] or not (branches[True] and branches[False]):
        raise Unread("takes other branches from call to call")
    yes, no = (decision_tree(branches[outcome], depth + 1) for outcome in (True, False))
    return condition, yes, no


def joined(tape: Tape, tree: Tree, values: Sequence[Any]) -> Any:
    """Return one value for those of all paths, chosen by the decisions."""
    if type(tree) is int:
        return values[tree]
    condition, yes, no = tree
    a = joined(tape, yes, values)
    b = joined(tape, no, values)
    if key_of(operand(a)) == key_of(operand(b)):
        return a
    return where(Array(tape, condition, ()), a, b)


# --- kinds of values ------------------------------------------------------------------------------


def _read_function(value: FunctionType) -> Content:
    cells = value.__closure__ or ()
    defaults = value.__defaults__, value.__kwdefaults__
    return Content(value.__code__, [], [*cells, *defaults, vars(value)])


def _read_object(value: Any) -> Content:
    slots = slot_values(value)
    items = [*slots.values(), type(value), attributes_of(value)]
    return Content(type(value), [*slots], items)


def _is_number(value: Any) -> bool:
    """Return whether a value is one number, or one truth value, which nothing changes."""
    if isinstance(value, Array):
        return not (value.shape or value._boxed)
    return type(value) in NUMBERS


def _read_elements(array: Array) -> Content:
    """Read the elements of a tracer array; None if nothing was written into it."""
    store: Any = None if array._store is None else array._store.copy()
    return Content(array.shape, [], store)


def _write_elements(array: Array, content: Content) -> None:
    elements = content.items
    if elements is None and array._store is None:
        return
    if elements is None:
        elements = Array(array._tape, array._node, array.shape)._elements()
    array._keep()
    array._store[...] = elements  # type: ignore[index]  # in place: views share it


TUPLE = Kind(MUTABLE[list].read)
OBJECT = Kind(_read_object, ATTRIBUTES.write)
ELEMENTS = Kind(_read_elements, _write_elements)
KINDS: dict[Any, Kind | None] = {  # None: nothing changes such a value
    **dict.fromkeys(IMMUTABLE | NUMBERS | {np.int64, type(np.sum)}),
    **MUTABLE,
    **dict.fromkeys((OrderedDict, defaultdict, Counter, Params), MUTABLE[dict]),
    tuple: TUPLE,
    FunctionType: Kind(_read_function),
    BuiltinFunctionType: holding(None, "__self__", "__name__"),
    **{kind: HOLDERS[kind] for kind in (MethodType, functools.partial)},
    SimpleNamespace: OBJECT,
}
UNCHANGING = (
    np.generic,
    np.dtype,
    np.ufunc,
    ModuleType,
    Enum,
    control.InputOutputSystem,
)
CONTAINERS = (
    list,
    tuple,
    dict,
    set,
    frozenset,
    deque,
    np.ndarray,
    str,
    bytes,
    int,
    float,
)
UNLISTED = object()


def kind_of(value: Any) -> Kind | None:
    """Return the kind of a value; None if nothing changes it."""
    if isinstance(value, Array):
        is_fixed = value._fixed or value._is_condition or _is_number(value)
        return None if is_fixed else ELEMENTS
    kind = KINDS.get(type(value), UNLISTED)
    if kind is not UNLISTED:
        return kind  # type: ignore[return-value]
    if isinstance(value, tuple) and not attributes_of(value):
        return TUPLE
    if isinstance(value, UNCHANGING) or root_of(type(value)) == PACKAGE:
        return None
    if isinstance(value, type):
        if is_library(root_of(value)) or root_of(value) == PACKAGE:
            return None
        raise NotMergeable  # a class that is made anew at each call
    of_user: Any = type(value)
    if isinstance(value, CONTAINERS) or not is_plain(of_user):
        raise NotMergeable
    has_slots = declared(of_user, MemberDescriptorType)
    return OBJECT if has_slots or attributes_of(value) is not None else None


class Entry(NamedTuple):
    """A value that code may change, or which holds such values, with its content."""

    value: Any
    kind: Kind
    content: Content  # of a tracer array: items are its elements, or None


def heap_of(roots: Iterable[Any], persistent: set[int]) -> dict[int, Entry]:
    """Return the contents that code reaches from roots, by identity.

    Values in `persistent` outlive the function and are left out: they must not change at all.
    """
    heap = {}
    stack = [*roots]
    while stack:
        value = stack.pop()
        if isinstance(value, Array):
            value = value._root
        if id(value) in heap or id(value) in persistent:
            continue
        kind = kind_of(value)
        if kind is None:
            continue
        content = kind.read(value)
        heap[id(value)] = Entry(value, kind, content)
        if kind is not ELEMENTS:
            stack += content.items
    return heap


def put_back(heap: dict[int, Entry]) -> None:
    """Write the contents of a heap into its values."""
    for value, kind, content in heap.values():
        if kind.write is not None:
            kind.write(value, content)


def _all_alike(entries: Sequence[Any]) -> bool:
    """Return whether contents differ in items alone."""
    leading = entries[0]
    return leading is not None and all(
        entry is not None
        and entry.kind is leading.kind
        and entry.content.structure == leading.content.structure
        and entry.content.keys == leading.content.keys
        for entry in entries
    )


def _all_equal(values: Sequence[Any]) -> bool:
    leading = values[0]
    return all(type(value) is type(leading) and value == leading for value in values)


# --- one heap for all paths -----------------------------------------------------------------------


class Joining:
    """The heaps of all paths, walked in step, and one heap for all, `contents`.

    `before` is the heap with which each path began.
    """

    def __init__(
        self,
        tape: Tape,
        tree: Tree,
        before: dict[int, Entry],
        heaps: Sequence[dict[int, Entry]],
    ):
        self.tape = tape
        self.tree = tree
        self.before = before
        self.heaps = heaps
        self._joined: dict[tuple[int, ...], Any] = {}
        # of each path: which values an object corresponds to
        self._partners: list[dict[int, tuple[int, ...]]] = [{} for _ in heaps]
        self.contents: dict[int, Entry] = {}  # of all paths

    def value(self, values: Sequence[Any]) -> Any:
        """Return one value for those of all paths; note the contents that it gets."""
        leading = values[0]
        key = (*map(id, values),)
        if key in self._joined:
            return self._joined[key]
        if all(value is leading for value in values):
            root = leading._root if isinstance(leading, Array) else leading
            if root is leading:
                return self._contents(key, leading)
            self.value([root] * len(values))
            return leading
        if all(map(_is_number, values)):
            return self._number(values)
        if all(isinstance(value, Array) for value in values):
            return self._array(key, values)
        if type(leading) in PLAIN and _all_equal(values):
            return leading
        return self._contents(key, leading)

    def _contents(self, key: tuple[int, ...], leading: Any) -> Any:
        """Return the value of the first path for all; note the content that it gets."""
        is_same = len({*key}) == 1
        entries = [heap.get(k) for heap, k in zip(self.heaps, key, strict=True)]
        if is_same and entries[0] is None:
            return leading  # nothing changes it
        if not _all_alike(entries):
            raise NotMergeable
        entry: Any = entries[0]
        _, kind, content = entry
        if kind.write is not None:
            if not is_same and not self.before.keys().isdisjoint(key):
                raise NotMergeable
            self._pair(key)
        self._joined[key] = leading  # of a value that holds itself
        contents = [
            path_entry.content.items for path_entry in entries if path_entry is not None
        ]
        if kind is ELEMENTS:
            items = self._elements(leading, contents)
        else:
            items = [*map(self.value, zip(*contents, strict=True))]
        if kind.write is not None:
            new = content._replace(items=items)
            self.contents[key[0]] = Entry(leading, kind, new)
        elif any(a is not b for a, b in zip(items, content.items, strict=True)):
            if kind is not TUPLE:
                raise NotMergeable
            make = getattr(content.structure, "_make", content.structure)
            self._joined[key] = make(items)
        return self._joined[key]

    def _pair(self, key: tuple[int, ...], fixed: Iterable[bool] = ()) -> None:
        """Note that objects correspond to each other, and to no others, unless they are fixed."""
        triples: Any = zip_longest(self._partners, key, fixed, fillvalue=False)
        for partners, k, is_fixed in triples:
            if not is_fixed and partners.setdefault(k, key) != key:
                raise NotMergeable

    def _number(self, values: Sequence[Any]) -> Any:
        """Return one number, or one truth value, with the type that all have in common."""
        if all(type(value) is int for value in values) and not _all_equal(values):
            raise NotMergeable  # they may count, or be indices
        truths = {*map(is_truth, values)}
        if len(truths) > 1:
            raise NotMergeable
        new = joined(self.tape, self.tree, values)
        of_python = common(map(is_of_python, values))
        is_integer = common(map(is_whole, values))
        ref = operand(new)
        if type(ref) is float:
            if of_python is None or is_integer is None:
                raise NotMergeable
            return new
        number = Array(self.tape, ref, ())
        number._of_python = of_python
        number._whole = is_integer and truths == {False}
        return number

    def _elements(self, array: Array, stores: Sequence[Any]) -> Any:
        """Return the elements of an array after all paths; None if none was written."""
        if all(store is None for store in stores):
            return None
        old = Array(array._tape, array._node, array.shape)._elements
        rows = [(old() if store is None else store).ravel() for store in stores]
        columns = zip(*rows, strict=True)
        elements = (joined(self.tape, self.tree, values) for values in columns)
        return np.fromiter(elements, object).reshape(array.shape)

    def _array(self, key: tuple[int, ...], values: Sequence[Array]) -> Array:
        """Return one array for arrays that are read-only, or were made on their paths."""
        leading = values[0]
        facts = {(value.shape, value._is_condition, value._boxed) for value in values}
        fixed = [bool(value._root._fixed) or value._is_condition for value in values]
        older = [id(value._root) in self.before for value in values]
        views = [value is not value._root for value in values]
        if len(facts) > 1 or any(
            not is_fixed and (is_older or is_view)
            for is_fixed, is_older, is_view in zip(fixed, older, views, strict=True)
        ):
            raise NotMergeable
        self._pair(key, fixed)
        nodes = [
            operand(lifted(self.tape, entry.content.items))
            if (entry := heap.get(id(value))) is not None
            and entry.content.items is not None
            else value._ref
            for heap, value in zip(self.heaps, values, strict=True)
        ]
        ends = [Array(self.tape, node, leading.shape) for node in nodes]
        new = Array(
            self.tape, operand(joined(self.tape, self.tree, ends)), leading.shape
        )
        new._boxed = leading._boxed
        new._whole = common(value._root._whole for value in values)
        new._fixed = any(fixed)
        self._joined[key] = new
        return new
