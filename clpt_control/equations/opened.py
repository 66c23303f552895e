"""Arrays of the record as NumPy's own: as numbers where they depend on nothing, else as objects."""

from collections.abc import Callable
from typing import Any

import numpy as np

from .arrays import Array, Tape, Unread, constant, lifted, numbers_of, objects

MOST_NUMBERS = 20_000  # of an array that is written down


def depends(value: Any) -> bool:
    """Return whether a signal or a parameter is among arguments."""
    if isinstance(value, Array):
        return numbers_of(value) is None
    if isinstance(value, list | tuple):
        return any(map(depends, value))
    return isinstance(value, np.ndarray) and value.dtype == object


def within(value: Any, made: Callable[[Array], Any]) -> Any:
    """Return arguments with all arrays of the record, in lists and tuples too, made something."""
    if isinstance(value, Array):
        return made(value)
    if isinstance(value, dict):
        return {name: within(one, made) for name, one in value.items()}
    return type(value)(within(v, made) for v in value) if type(value) in (list, tuple) else value


def of_numbers(tape: Tape, function: Callable, inputs: Any, more: dict) -> Any:
    """Run NumPy's own function on arguments that depend on nothing."""
    return fresh(tape, function(*within(inputs, numbers_of), **within(more, numbers_of)))


def fresh(tape: Tape, found: Any) -> Any:
    """Return a new array of doubles as one that signals may be written into."""
    if type(found) is np.ndarray and found.dtype == float and found.ndim:
        return constant(tape, found) if found.size < MOST_NUMBERS else found
    return found


def unread(what: str) -> Any:
    """Write that something cannot be read."""
    raise Unread(f"{what} of signals")


def repacked(tape: Tape, found: Any) -> Any:
    """Return what NumPy made of arrays of objects."""
    if isinstance(found, tuple | list):
        return type(found)(repacked(tape, one) for one in found)
    if isinstance(found, np.ndarray) and found.dtype == object:
        return lifted(tape, found)
    return fresh(tape, found)


def exploded(tape: Tape, function: Any, inputs: Any, more: dict) -> Any:
    """Run NumPy's own function on arrays of objects."""
    own = within(inputs, objects)
    try:
        found = function(*own, **within(more, objects))
    except (Unread, IndexError, ValueError):
        raise
    except Exception as error:
        raise Unread(f"np.{function.__name__} of signals ({error})") from None
    if found is None and inputs:  # it wrote into its first argument
        inputs[0][...] = own[0]
    return repacked(tape, found)


def into(out: Any, found: Any) -> Any:
    """Return what was found, written into an array where one is given for it."""
    if out is None or (isinstance(out, Array) and not out.shape):  # a number is replaced
        return found
    if not isinstance(out, Array):
        raise Unread("writes signals into an array made elsewhere; make it where it is filled")
    out[...] = found
    return out


def tape_of(values: Any) -> Any:
    """Return the tape of the first array of the record among values, or None."""
    for value in values:
        if isinstance(value, Array):
            return value._tape
        if isinstance(value, list | tuple) or (
            isinstance(value, np.ndarray) and value.dtype == object and value.ndim
        ):
            found = tape_of(value)
            if found is not None:
                return found
    return None
