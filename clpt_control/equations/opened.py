"""Arrays of the record as NumPy's own: as numbers where they depend on nothing, else as objects."""

from collections.abc import Callable
from typing import Any

import numpy as np

from .arrays import Array, Tape, Unread, constant, numbers_of, packed


def depends(value: Any) -> bool:
    """Return whether a signal or a parameter is among arguments."""
    if isinstance(value, Array):
        return numbers_of(value) is None
    if isinstance(value, list | tuple):
        return any(map(depends, value))
    return isinstance(value, np.ndarray) and value.dtype == object


def as_numbers(value: Any) -> Any:
    """Return arguments that depend on nothing as numbers."""
    if isinstance(value, Array):
        return numbers_of(value)
    return type(value)(map(as_numbers, value)) if type(value) in (list, tuple) else value


def fresh(tape: Tape, found: Any) -> Any:
    """Return a new array of doubles as one that signals may be written into."""
    if type(found) is np.ndarray and found.dtype == float and found.ndim and found.size < 20_000:
        return constant(tape, found)
    return found


def unread(what: str) -> Any:
    """Write that something cannot be read."""
    raise Unread(f"{what} of signals")


def objects(value: Any) -> np.ndarray:
    """Return an array of objects."""
    return value.elements() if isinstance(value, Array) else np.asarray(value, dtype=object)


def repacked(tape: Tape, found: Any) -> Any:
    """Return what NumPy made of arrays of objects."""
    if isinstance(found, tuple | list):
        return type(found)(repacked(tape, one) for one in found)
    if isinstance(found, np.ndarray) and found.dtype == object:
        return packed(tape, found)
    return fresh(tape, found)


SHARING = frozenset(  # functions of NumPy whose results share what is written into the array
    {np.transpose, np.swapaxes, np.moveaxis, np.rollaxis, np.expand_dims, np.flip, np.fliplr}
    | {np.flipud, np.split, np.array_split, np.hsplit, np.vsplit, np.dsplit}
)


def shared(a: Array, part: Callable[[np.ndarray], np.ndarray]) -> Any:
    """Return a part of an array of objects, which shares what is written into either."""
    if (store := a._written()) is not None:
        return Array(a.tape, -1, part(store).shape, a, part)
    made = packed(a.tape, part(objects(a)))
    if not isinstance(made, Array) or not made.shape:
        return made
    return Array(a.tape, made.node, made.shape, a, part)


def exploded(tape: Tape, function: Any, inputs: Any, more: dict) -> Any:
    """Run NumPy's own function on arrays of objects."""

    def opened(value: Any) -> Any:
        if isinstance(value, Array):
            return objects(value)
        if isinstance(value, list | tuple):
            return type(value)(opened(one) for one in value)
        return value

    first, *rest = inputs
    if function in SHARING and isinstance(first, Array):
        parts = function(objects(first), *rest, **more)
        if not isinstance(parts, list | tuple):
            return shared(first, lambda store: function(store, *rest, **more))

        def one(k: int) -> Callable[[np.ndarray], np.ndarray]:
            return lambda store: function(store, *rest, **more)[k]

        return [shared(first, one(k)) for k in range(len(parts))]
    try:
        found = function(*opened(tuple(inputs)), **{k: opened(v) for k, v in more.items()})
    except (Unread, IndexError, ValueError):
        raise
    except Exception as error:
        raise Unread(f"np.{function.__name__} of signals ({error})") from None
    return repacked(tape, found)


def tape_of(values: Any) -> Any:
    """Return the tape of the first array of the record among values, or None."""
    for value in values:
        if isinstance(value, Array):
            return value.tape
        if isinstance(value, list | tuple) or (
            isinstance(value, np.ndarray) and value.dtype == object and value.ndim
        ):
            found = tape_of(value)
            if found is not None:
                return found
    return None
