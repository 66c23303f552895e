"""A block's functions as code: names they read, effects, helpers, other words.

The text of a function gives better sentences (`rules`); the code is what runs.  So a
function made by `exec` or at a prompt is read as safely as one in a file.

One function gets several readings because `substituted` gives the same code other
meanings of `math`, of the words and of its helpers, and leaves the function as it is.
"""

import builtins
import dis
from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache
from types import CodeType, FunctionType
from typing import Any

from .words import WORDS

EFFECTS = {
    "STORE_GLOBAL": ("`global`", "put the number into the block's parameters"),
    "DELETE_GLOBAL": ("`global`", "put the number into the block's parameters"),
    "IMPORT_NAME": ("`import`", "import at the top of the module"),
    "MAKE_FUNCTION": (
        "a function or a comprehension inside a function",
        "define it at the top of the module, or use `for i in range(n)`",
    ),
    "LOAD_BUILD_CLASS": ("a class inside a function", "a block computes numbers only"),
    "RAISE_VARARGS": ("`raise` or `assert`", "check parameters before the block is made"),
    "YIELD_VALUE": ("`yield`", "fill the output array"),
    **dict.fromkeys(
        ("STORE_ATTR", "DELETE_ATTR"), ("setting an attribute", "fill the output array")
    ),
    **dict.fromkeys(("IS_OP", "CONTAINS_OP"), ("`is` or `in`", "compare with <, <=, >, >=")),
    **dict.fromkeys(
        ("MATCH_CLASS", "MATCH_SEQUENCE", "MATCH_MAPPING"),
        ("`match`", "use where(condition, a, b)"),
    ),
    **dict.fromkeys(
        ("FORMAT_VALUE", "FORMAT_SIMPLE", "FORMAT_WITH_SPEC", "BUILD_STRING"),
        ("a string", "a block computes numbers only"),
    ),
    "RETURN_GENERATOR": ("`async` or `yield`", "fill the output array"),
    "PUSH_EXC_INFO": ("`try` or `with`", "keep the arguments in range with where or clip"),
}


def names_read(function: FunctionType) -> Iterator[tuple[int, str]]:
    """Return the names of the module that code reads, with their lines."""
    for line, operation, value in _instructions(function.__code__):
        if operation == "LOAD_GLOBAL":
            yield line, value


def effects(function: FunctionType) -> Iterator[tuple[int, str, str]]:
    """Return line, effect and replacement of what code does other than calculate."""
    for line, operation, value in _instructions(function.__code__):
        if operation in EFFECTS:
            yield line, *EFFECTS[operation]
        elif operation == "LOAD_CONST" and isinstance(value, str | bytes):
            yield line, *EFFECTS["BUILD_STRING"]


@lru_cache(maxsize=1024)
def _instructions(code: CodeType) -> tuple[tuple[int, str, Any], ...]:
    """Return line, name and argument of each instruction."""
    return tuple(
        ((one.positions and one.positions.lineno) or code.co_firstlineno, one.opname, one.argval)
        for one in dis.get_instructions(code)
    )


def _is_word(value: Any) -> bool:
    """Return whether a value is a word or a function of `math`."""
    called = getattr(value, "__name__", "")
    return WORDS.get(called) is value is not None or getattr(value, "__module__", None) == "math"


def helpers_of(function: FunctionType) -> dict[str, FunctionType]:
    """Return the plain functions that a function calls by name."""
    names = dict.fromkeys(name for _, name in names_read(function))
    found = {name: function.__globals__.get(name) for name in names}
    return {
        name: value
        for name, value in found.items()
        if isinstance(value, FunctionType) and WORDS.get(value.__name__) is not value
    }


def substituted(
    function: FunctionType,
    substitutes: Mapping[str, Any],
    wrap: Callable[[FunctionType, FunctionType], Any] = lambda copy, original: copy,
) -> Any:
    """Return the same code with other meanings of ``math``, words and builtins such as ``range``.

    ``wrap(copy, helper)`` is what stands for a helper.
    """
    return _copied(function, substitutes, wrap, {})


def _copied(function: FunctionType, substitutes: Mapping, wrap: Callable, made: dict) -> Any:
    if function in made:  # a helper of several, or one that calls itself
        return made[function]
    space = dict(function.__globals__)
    made[function] = copy = FunctionType(
        function.__code__, space, function.__name__, function.__defaults__, function.__closure__
    )
    copy.__kwdefaults__, copy.__module__ = function.__kwdefaults__, function.__module__
    for name in function.__code__.co_names:
        value = space.get(name)
        word = getattr(value, "__name__", "")
        if value is None and name in substitutes and hasattr(builtins, name):
            space[name] = substitutes[name]
        elif word in substitutes and (WORDS.get(word) is value or word == "math"):
            space[name] = substitutes[word]
        elif getattr(value, "__module__", None) == "math" and "math" in substitutes:
            space[name] = getattr(substitutes["math"], word)
    for name, helper in helpers_of(function).items():
        space[name] = wrap(_copied(helper, substitutes, wrap, made), helper)
    return copy


def with_helpers(function: FunctionType) -> list[FunctionType]:
    """Return a function and the helpers that it reaches, each once."""
    found = [function]
    for one in found:
        found += [h for h in helpers_of(one).values() if h not in found]
    return found


def fingerprint(function: FunctionType) -> tuple:
    """Return what a reading depends on: code, numbers, words."""
    parts = []
    found = with_helpers(function)
    for one in found:
        space = one.__globals__
        used = [(name, space.get(name)) for name in one.__code__.co_names]
        numbers = [(name, repr(value)) for name, value in used if isinstance(value, int | float)]
        words = [(name, value) for name, value in used if _is_word(value)]
        defaults = repr((one.__defaults__, one.__kwdefaults__))
        helpers = [(name, found.index(helper)) for name, helper in helpers_of(one).items()]
        marked = getattr(one, "opaque", False)
        parts.append((one.__code__, defaults, (*numbers, *words, *helpers), marked))
    return tuple(parts)
