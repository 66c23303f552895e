"""The same code with other words: how one function gets several readings.

A reading rebinds the names that a function finds in its module (`math`, the
words, its helpers) and leaves the function's own code as it is.
"""

import builtins
from collections.abc import Callable, Mapping
from types import FunctionType
from typing import Any

from .bytecode import names_read
from .words import WORDS


def is_word(value: Any) -> bool:
    """Whether a value is a word or a function of `math`."""
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


def rebind(
    function: FunctionType,
    substitutes: Mapping[str, Any],
    wrap: Callable[[FunctionType, FunctionType], Any] = lambda rebound, original: rebound,
) -> Any:
    """Make the same code read other words."""
    return _rebound(function, substitutes, wrap, {})


def _rebound(function: FunctionType, substitutes: Mapping, wrap: Callable, made: dict) -> Any:
    if function in made:  # a helper of several, or one that calls itself
        return made[function]
    space = dict(function.__globals__)
    made[function] = rebound = FunctionType(
        function.__code__, space, function.__name__, function.__defaults__, function.__closure__
    )
    rebound.__kwdefaults__, rebound.__module__ = function.__kwdefaults__, function.__module__
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
        space[name] = wrap(_rebound(helper, substitutes, wrap, made), helper)
    return rebound


def reached(function: FunctionType) -> list[FunctionType]:
    """Return a function and the helpers that it reaches, each once."""
    found = [function]
    for one in found:
        found += [h for h in helpers_of(one).values() if h not in found]
    return found


def fingerprint(function: FunctionType) -> tuple:
    """Return what a reading depends on: code, numbers, words."""
    parts = []
    found = reached(function)
    for one in found:
        space = one.__globals__
        used = [(name, space.get(name)) for name in one.__code__.co_names]
        numbers = [(name, repr(value)) for name, value in used if isinstance(value, int | float)]
        words = [(name, value) for name, value in used if is_word(value)]
        defaults = repr((one.__defaults__, one.__kwdefaults__))
        helpers = [(name, found.index(helper)) for name, helper in helpers_of(one).items()]
        marked = getattr(one, "opaque", False)
        parts.append((one.__code__, defaults, (*numbers, *words, *helpers), marked))
    return tuple(parts)
