"""Fingerprint of a function: a cache key of its code and of every value that it references.

    key = (code, defaults, closure, globals by name, attributes by name, ...)

A function is traced only if everything that it references is on the allow-list (`references`):
numbers, texts, arrays, plain Python classes and functions, and library functions without side
effects.  Any other value, such as ``os.remove``, a file or a lock, raises `Unread`, and Python runs
the function.  Objects, classes and modules count by the attributes that the referenced code names.

A traced function may change nothing but lists, dicts, arrays and attributes: their `contents` are
copied, compared after tracing and put back.
"""

import functools
import importlib
import logging
import marshal
from collections import defaultdict
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from enum import Enum
from io import IOBase
from itertools import chain
from types import (
    BuiltinFunctionType,
    FunctionType,
    MemberDescriptorType,
    MethodWrapperType,
    ModuleType,
)
from typing import Any

import control
import numpy as np

from ...base.arguments import attribute_of
from ..model.declaration import Parameters
from ..record.unread import Unread, reading_on
from .arrays import Tape
from .contents import (
    HOLDERS,
    UNBOUND,
    Content,
    Mutable,
    Reads,
    declared,
    slot_values,
    variable,
)
from .interpolators import is_table
from .isolation import isolated
from .references import (
    CALLABLE,
    CHANCE,
    CLOCK,
    CLOCKS,
    IMMUTABLE,
    OUTSIDE,
    PACKAGE,
    PLAIN_BASES,
    STREAMS,
    UNSEEDED,
    Reference,
    attributes_of,
    code_names,
    code_texts,
    is_library,
    is_plain,
    is_pure,
    module_of,
    reason,
    references,
    root_of,
    words,
)

TABLE_FIELDS = words(  # data of an interpolator of SciPy
    "x y c points grid values method fill_value extrapolate bounds_error"
)
CONSTRUCTORS = ("__init__", "__new__", "__post_init__")
NOT_CALLED = ("__repr__", "__del__", "__annotate__", "__annotate_func__", *CONSTRUCTORS)
# attributes by text
DYNAMIC = words("getattr setattr delattr hasattr attrgetter methodcaller __dict__")
INTERNALS = words("__code__ __defaults__ __kwdefaults__ __closure__ __globals__")
BOUND = (BuiltinFunctionType, MethodWrapperType)
NUMBERS = frozenset((int, float, bool))
OF_CALLS = frozenset(("_current_params",))  # attributes of a system that each call sets


@dataclass(frozen=True)
class Fingerprint:
    """Key of functions, and the values that they may change."""

    key: tuple  # functions of equal keys are traced alike
    mutables: tuple[Mutable, ...]  # what the functions may change
    # objects whose identities are in the key; they must stay alive
    referenced: tuple[Any, ...]
    reads: Reads | None  # names of which equal values give this fingerprint


def reachable(*values: Any, trusted: bool = False) -> Fingerprint:
    """Return the fingerprint of functions or values.

    Raises `Unread` with function, line and cause if something referenced is not known to be pure;
    of `trusted` functions, those of this package, such things are passed over.
    """
    walk = _Walk(trusted)
    key = [walk.key_of(value) for value in values]
    key += walk.attributes()
    immutable = walk.reads.complete and not walk.mutables and not walk.owners
    reads = walk.reads if immutable else None
    return Fingerprint(tuple(key), tuple(walk.mutables), tuple(walk.alive), reads)


@dataclass
class _Owner:
    """An object, class or module whose attributes count as soon as referenced code names them."""

    number: int
    value: Any
    namespace: Callable[[], dict[str, Any]]
    names: dict[str, None] = field(default_factory=dict)  # counted so far
    constructed: bool = False  # a class that the code may call

    @property
    def of_control(self) -> bool:
        """True for a class of python-control, whose methods have no state of their own."""
        return isinstance(self.value, type) and root_of(self.value) == "control"


class _Walk:
    """One walk over everything that functions reference; it makes the key on its way."""

    def __init__(self, trusted: bool):
        self.trusted = trusted
        self.mutables: list[Mutable] = []
        self.names: dict[str, None] = {}  # attributes that referenced code names
        self.texts: dict[str, None] = {}  # texts, by which getattr may name attributes
        self.alive: list[Any] = []
        self.owners: dict[int, _Owner] = {}
        self.calls_classes = False  # type(self)(...)
        self.where = ""  # function and line
        self.label = ""  # what the code there references
        self._numbers: dict[int, int] = {}  # identity of each object -> its number
        self.reads = Reads()

    # --- values -----------------------------------------------------------------------------

    def key_of(self, value):
        """Return the key of a value; refuse one that is not known to be pure."""
        kind = type(value)
        if kind is float or kind is np.float64:
            return kind, value.hex()  # 0.0 is not -0.0
        if kind in IMMUTABLE:
            if kind is str:
                self.texts[value] = None
            # Python 3.11 has no hash of a slice
            return kind, value.__reduce__() if kind is slice else value
        if isinstance(value, np.generic):
            return kind, value.dtype.str, value.tobytes()
        if isinstance(value, Parameters):
            return self.identity(value)
        if id(value) in self._numbers:  # also of one that holds itself
            return "seen", self._numbers[id(value)]
        self._numbers[id(value)] = len(self._numbers)
        self.alive.append(value)
        return self._new_key(kind, value)

    def identity(self, value: Any) -> int:
        """Return the identity of an object, which stays alive with the fingerprint."""
        self.alive.append(value)
        return id(value)

    def _new_key(self, kind: type, value: Any) -> Any:
        """Return the key of an object that the walk has not met."""
        if kind is FunctionType:
            return self._function(value)
        if isinstance(value, tuple) and is_library(root_of(kind)):  # or sys.float_info
            return kind, *self._items(value)
        if isinstance(value, np.ndarray):
            return self._array(value)
        if holder := HOLDERS.get(kind):
            self.reads.complete = False
            return kind, *map(self.key_of, holder.read(value).items)
        if isinstance(value, type):
            return self._class(value, constructed=True)
        if isinstance(value, ModuleType):
            return self._module(value)
        if isinstance(value, Enum):
            self._attributes(value)
            return "enum", self._class(kind), self.key_of(value._value_)
        holder = attribute_of(value, "__self__") if isinstance(value, BOUND) else None
        if holder is not None and not isinstance(holder, ModuleType | type):
            return "method", value.__name__, self.key_of(holder)
        if is_pure(value):
            return "pure", id(value)
        if isinstance(value, CALLABLE) or kind.__name__ == "cython_function_or_method":
            self._refuse(reason(self.label or value.__name__, value))
            return id(value)
        if isinstance(value, logging.Logger | logging.LoggerAdapter):
            return "logger", id(value)
        if isinstance(value, CHANCE):
            self._refuse(UNSEEDED)
        if isinstance(value, IOBase):
            self._refuse(f"calls {self.label}, {OUTSIDE}")
        if isinstance(value, Iterator):
            self._refuse(
                "reads an iterator, which goes on at the next call. Make it a list"
            )
        if is_table(value):
            return id(value), *[
                self.key_of(getattr(value, name, None)) for name in TABLE_FIELDS
            ]
        if isinstance(value, control.InputOutputSystem):
            return self._system(value)
        if root_of(kind) == "numba":
            self.reads.complete = False
            return kind, self.key_of(value.py_func)
        if root_of(kind) == "pandas" and kind.__name__ in ("Series", "DataFrame"):
            return kind, *self._note(value).items
        return self._container(kind, value)

    def _container(self, kind: type, value: Any) -> Any:
        """Return the key of a tuple, list, dict or frozenset, or of an object of a plain class."""
        if not is_plain(kind):
            self._refuse_object(kind)
            return id(value)
        if root_of(kind) == PACKAGE:
            return id(value)
        key = [self._class(kind)]
        if isinstance(value, tuple):
            return *key, *self._items(value)
        if isinstance(value, frozenset):
            return *key, frozenset(map(self.key_of, value))
        if isinstance(value, list | dict):
            content = self._note(value)
            keys = content.keys if isinstance(value, dict) else ()
            key += [*self._items(keys), *self._items(content.items)]
            if isinstance(value, defaultdict):
                key.append(self.key_of(value.default_factory))
        self._attributes(value)
        return tuple(key)

    def _attributes(self, value: Any) -> None:
        """Note the attributes of an object, in its dict and in slots."""
        kind: Any = type(value)
        attributes = attributes_of(value)
        owner = self._owner(value, lambda: {**(attributes or {}), **slot_values(value)})
        if attributes is not None:
            computed = frozenset(declared(kind, functools.cached_property))
            self._note(attributes, kind, owner.names, computed)
        if declared(kind, MemberDescriptorType):
            if isinstance(value, list | dict | np.ndarray):
                self._refuse_object(kind)
            self._note(value, kind, owner.names)

    def _note(self, value: Any, owner: type | None = None, *fields: Any) -> Content:
        """Note a value that a function may change, unless it is trusted; return the content."""
        words = owner.__name__ if owner else f"a {type(value).__name__}"
        mutable = Mutable(value, words, *fields)
        if not self.trusted:
            self.mutables.append(mutable)
        return mutable.before

    def _items(self, values: Any) -> Iterator[Any]:
        """Yield the keys of items; numbers, or tuples of numbers, are one key."""
        kinds = {*map(type, values)}
        inner = {*map(type, chain(*values))} if kinds == {tuple} else kinds
        if inner and inner <= NUMBERS:
            yield marshal.dumps(values if type(values) is tuple else list(values), 2)
        else:
            yield from map(self.key_of, values)

    def _array(self, value: np.ndarray) -> Any:
        """Return the key of an array, by its bytes."""
        content = self._note(value)
        if type(value) is not np.ndarray:
            self._attributes(value)
        return type(value), *content.structure[:2], *map(self.key_of, content.items)

    def _system(self, system):
        """Return the key of a system of python-control, by its attributes."""
        fields = {
            name: value
            for name, value in vars(system).items()
            if not name.endswith(("_labels", "_prefix", *OF_CALLS))
        }
        if "_parameters" in fields:  # a block of this package
            functions = [function for function, _ in system._roles.values()]
            return (
                id(system),
                self.identity(system.parameters),
                *map(self.key_of, functions),
            )
        self._note(vars(system), type(system), fields, OF_CALLS)
        keys = [(name, self.key_of(value)) for name, value in fields.items()]
        return self._class(type(system)), *keys

    # --- functions --------------------------------------------------------------------------

    def _function(self, function: FunctionType) -> Any:
        """Return the key of a function: its code, and the values that it references."""
        if is_library(root_of(function)):
            if registry := attribute_of(function, "registry"):  # of singledispatch
                self.reads.complete = False
                return id(function), *map(self.key_of, registry.values())
            if not is_pure(function):
                self._refuse(reason(self.label or function.__qualname__, function))
            return id(function)
        code = function.__code__
        key = list[Any]()
        self.identity(code)
        before = self.where, self.label
        own_package = root_of(function) == PACKAGE
        self.reads.function(function)
        self.reads.complete &= not own_package
        trusted, self.trusted = self.trusted, self.trusted or own_package
        names = () if own_package else code_names(code)
        self.names |= dict.fromkeys(names)
        self.texts |= dict.fromkeys(() if own_package else code_texts(code))
        for name in INTERNALS.intersection(names):
            self._refuse(f"uses {name}. Call the function as it is")
        generated = code.co_filename == "<string>"  # of a dataclass
        self.calls_classes |= not generated and not {"type", "__class__"}.isdisjoint(
            names
        )
        closure = function.__closure__ or ()
        cells = dict(zip(code.co_freevars, closure, strict=True))
        variables = {name: variable(cell) for name, cell in cells.items()}
        spaces = {"global": function.__globals__, "cell": variables}
        for item in references(code):
            self.where = f"{code.co_name}, line {item.line}: "
            if own_package and item.space != "cell":
                # of the package's own only functions
                value = function.__globals__.get(item.name)
                key += [self.key_of(value)] if type(value) is FunctionType else []
            elif item.space in spaces:
                if item.space == "cell":
                    value = variables[item.name]
                    self.reads.value(value, variable, cells[item.name])
                key.append(self._referenced(item, spaces[item.space]))
            else:
                self.reads.complete = False
                key.append(self._imported(item, function.__globals__))
        self.where = f"{code.co_name}: "
        self.label = ""
        key += map(self.key_of, (function.__defaults__, function.__kwdefaults__))
        key += [(name, self.key_of(item)) for name, item in vars(function).items()]
        (self.where, self.label), self.trusted = before, trusted
        return id(code), *key

    def _referenced(self, reference: Reference, space: dict[str, Any]) -> Any:
        """Return the key of a referenced value, ``os.path.join`` by its attributes."""
        value = space.get(reference.name, UNBOUND)
        label = reference.name
        if reference.space == "global":
            self.reads.value(value, space.get, reference.name, UNBOUND)
        if value is UNBOUND:
            if reference.space == "cell" or reference.name not in BUILTINS:
                # an error of the function, or not bound yet
                return ("unbound", reference.name)
            value = BUILTINS[reference.name]
            self.reads.value(value, BUILTINS.get, reference.name)
        attributes = list(reference.attributes)
        while isinstance(value, ModuleType) and attributes:
            label = f"{label}.{attributes[0]}"
            module, name = value, attributes.pop(0)
            value = getattr(module, name, UNBOUND)
            self.reads.value(value, vars(module).get, name, UNBOUND)
            if value is UNBOUND:
                return "unbound", label
        self.label = ".".join([label, *attributes])
        if label in STREAMS:
            return label
        if attributes and attributes[0] in CLOCKS and module_of(value) == "datetime":
            self._refuse(CLOCK)
        return label, self.key_of(value)

    def _imported(self, reference: Reference, space: dict[str, Any]) -> Any:
        """Return the key of a module that a function imports by itself."""
        try:
            with isolated(), reading_on(Tape()):
                module = importlib.import_module(
                    reference.name, space.get("__package__")
                )
        except ImportError:
            return "unbound", reference.name
        except Unread as error:
            self._refuse(f"imports {reference.name}, which {error}")
            return reference.name
        return self.key_of(module)

    # --- attributes -------------------------------------------------------------------------

    def _owner(self, value: Any, namespace: Callable[[], dict[str, Any]]) -> _Owner:
        """Return the owner of attributes, which count as soon as code names them."""
        owner = _Owner(len(self.owners), value, namespace)
        self.owners[id(value)] = owner
        return owner

    def attributes(self) -> Iterator[Any]:
        """Yield the keys of the attributes of all owners that the referenced code names."""
        counted: Any = None
        growing: list[Any] = [self.names, self.owners, self._numbers]
        while counted != (count := [*map(len, growing)]):
            counted = count
            for owner in [*self.owners.values()]:
                for name, value in owner.namespace().items():
                    if name not in owner.names and self._is_named(owner, name, value):
                        owner.names[name] = None
                        kind = type(owner.value).__name__
                        owner_name = attribute_of(owner.value, "__name__", kind)
                        self.where, self.label = f"{owner_name}.{name}: ", name
                        trusted, self.trusted = (
                            self.trusted,
                            self.trusted or owner.of_control,
                        )
                        yield owner.number, name, self.key_of(value)
                        self.trusted = trusted

    def _is_named(self, owner: _Owner, name: str, value: Any) -> bool:
        """Return whether the referenced code may reach an attribute."""
        special = name.startswith("__") and name.endswith("__")
        if isinstance(owner.value, type) and special:
            if owner.of_control:
                return False
            called = owner.constructed or self.calls_classes
            reached = name in CONSTRUCTORS and called
            return isinstance(value, FunctionType) and (
                reached or name not in NOT_CALLED
            )
        dynamic = name in self.texts and not DYNAMIC.isdisjoint(self.names)
        return name in self.names or dynamic

    def _class(self, kind: type, constructed: bool = False) -> int:
        """Note a class whose functions count by name; return its identity."""
        if id(kind) in self.owners:
            self.owners[id(kind)].constructed |= constructed
            return id(kind)
        self._numbers.setdefault(id(kind), len(self._numbers))
        self.identity(kind)
        is_error = issubclass(kind, BaseException) and is_library(root_of(kind))
        if is_pure(kind) or kind in PLAIN_BASES or is_error:
            return id(kind)
        if is_library(root_of(kind)):
            self._refuse(reason(self.label or kind.__qualname__, kind))
            return id(kind)
        owner = self._owner(kind, lambda: dict(vars(kind)))
        owner.constructed = constructed
        self._note(kind, kind, owner.names)
        for base in kind.__bases__:
            self._class(base, constructed and not owner.of_control)
        if type(kind) is not type and not is_library(root_of(type(kind))):
            self._class(type(kind))
        return id(kind)

    def _module(self, module: ModuleType) -> Any:
        """Return the key of a module that is passed on as a value, or imported."""
        self._owner(
            module,
            lambda: {k: getattr(module, k) for k in self.names if hasattr(module, k)},
        )
        return "module", module.__name__

    # --- refusals ---------------------------------------------------------------------------

    def _refuse_object(self, kind: type) -> None:
        name = (
            f"{self.label}, a {kind.__name__}" if self.label else f"a {kind.__name__}"
        )
        self._refuse(
            f"uses {name}, where calls may store or change data. Pass its numbers as "
            "parameters or arrays"
        )

    def _refuse(self, sentence: str) -> None:
        if not self.trusted:
            raise Unread(f"{self.where}{sentence}")


BUILTINS: dict[str, Any] = vars(__import__("builtins"))
