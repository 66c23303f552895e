"""Items of lists and tuples at an index that is a signal: one `pick`, not a path for each item.

row[k],  points[argmin(d)],  legs[int(x[0])],  d.index(min(d))
"""

from typing import Any

import numpy as np

from .arrays import Array, active, moves, operand
from .elementwise import chosen, elementwise, in_a_try, is_of_python, is_whole, lifted
from .views import tape_of

NUMBERS = (int, float, np.float64, np.int64)


def item_of(values: Any, index: Any) -> Any:
    """Return values[index]."""
    is_signal = isinstance(index, Array) and not index.shape and index._whole is True
    if (
        not is_signal
        or type(values) not in (list, tuple)
        or not moves(index)
        or in_a_try()
    ):
        return values[index]
    item = picked_from(values, index)
    return values[index] if item is None else item


def picked_from(values: Any, index: Array) -> Any:
    """Return the item of a list of numbers, or of rows of numbers; None of other lists."""
    if all(map(_is_number, values)):
        return _picked_number(values, index)
    kinds = {
        (type(value), len(value) if hasattr(value, "__len__") else -1)
        for value in values
    }
    kind, length = next(iter(kinds), (None, 0))
    if len(kinds) != 1 or kind not in (list, tuple):
        return None
    columns = [
        picked_from([value[j] for value in values], index) for j in range(length)
    ]
    return None if any(column is None for column in columns) else kind(columns)


def _is_number(value: Any) -> bool:
    return (isinstance(value, Array) and not value.shape) or type(value) in NUMBERS


def _picked_number(values: Any, index: Array) -> Any:
    """Return one of several numbers as one operation; None of truth values."""
    if not values or any(
        isinstance(value, Array) and value._is_condition for value in values
    ):
        return None
    tape = index._tape
    row = lifted(tape, [*values])
    picked = tape.add("pick", (operand(row), index._ref), ())
    picked._whole = _common(map(is_whole, values))
    picked._of_python = _common(map(is_of_python, values))
    return picked


def _common(kinds: Any) -> bool | None:
    """Return the common kind of all items; None if they differ."""
    distinct = {*kinds}
    return distinct.pop() if len(distinct) == 1 else None


def index_of(values: Any, value: Any) -> Any:
    """Return values.index(value): the first item that equals a value."""
    if (
        type(values) not in (list, tuple)
        or active() is None
        or tape_of([*values, value]) is None
    ):
        return values.index(value)
    if in_a_try():  # Python raises if no item is equal
        return values.index(value)
    position: Any = np.nan
    for k in range(len(values) - 1, -1, -1):
        position = chosen(elementwise("eq", values[k], value), k, position)
    if isinstance(position, Array):
        position._whole = True
        position._of_python = True
    return position
