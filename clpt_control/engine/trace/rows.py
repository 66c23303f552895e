"""Items of lists and arrays at an index that is a signal: one `pick`, not a path for each item.

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
    signal = isinstance(index, Array) and not index.shape and index._whole is True
    if not signal or type(values) not in (list, tuple) or not moves(index) or in_a_try():
        return values[index]
    if (item := picked_from(values, index)) is None:
        return values[index]  # each of its paths has one item
    return item


def picked_from(values: Any, index: Array) -> Any:
    """Return the item of a list or tuple of numbers, or of rows of numbers; None of others."""
    if all(
        (isinstance(value, Array) and not value.shape) or type(value) in NUMBERS for value in values
    ):
        if any(isinstance(value, Array) and value._is_condition for value in values) or not values:
            return None
        tape = index._tape
        picked = tape.add("pick", (operand(lifted(tape, [*values])), index._ref), ())
        picked._whole = _common(map(is_whole, values))
        picked._of_python = _common(map(is_of_python, values))
        return picked
    kinds = {(type(value), len(value) if hasattr(value, "__len__") else -1) for value in values}
    kind, length = next(iter(kinds), (None, 0))
    if len(kinds) != 1 or kind not in (list, tuple):
        return None
    items = [picked_from([value[j] for value in values], index) for j in range(length)]
    return None if any(value is None for value in items) else kind(items)


def _common(kinds: Any) -> bool | None:
    """Return what all items are; None where they differ."""
    distinct = {*kinds}
    return distinct.pop() if len(distinct) == 1 else None


def index_of(values: Any, value: Any) -> Any:
    """Return values.index(value): the first item that equals a value."""
    if type(values) not in (list, tuple) or active() is None or tape_of([*values, value]) is None:
        return values.index(value)
    if in_a_try():  # where no item is equal
        return values.index(value)
    position: Any = np.nan
    for k in range(len(values) - 1, -1, -1):
        position = chosen(elementwise("eq", values[k], value), k, position)
    if isinstance(position, Array):
        position._whole = True
        position._of_python = True
    return position
