"""A block's typed parameters: a NamedTuple of numbers and arrays.

Whole numbers (int) are structure, such as the number of basis functions: all
readers keep them as they are.  Everything else is a float or an array of
floats, which SymPy reads as symbols and which may differ per run.
"""

from typing import Any, NamedTuple

import numpy as np

from ..errors import BlockError


class NoParameters(NamedTuple):
    """The parameters of a block that has none."""


def checked_parameters(name: str, parameters: Any, like: Any = None) -> Any:
    """Make a block's parameters numbers and arrays of one kind each."""
    if not (isinstance(parameters, tuple) and hasattr(parameters, "_fields")):
        raise BlockError(
            f"{name}: parameters must be a NamedTuple, not {type(parameters).__name__}"
        )
    values: dict[str, Any] = {}
    for field, value in zip(parameters._fields, parameters, strict=True):
        old = getattr(like, field) if like is not None else value
        try:
            shape = np.shape(old)
        except ValueError:
            raise BlockError(f"{name}.{field}: its rows differ in length; give an array") from None
        try:
            if isinstance(old, int | np.integer) and not isinstance(old, bool):
                values[field] = int(value) if int(value) == value else None
            elif not shape:
                values[field] = np.float64(value)
            else:
                values[field] = np.array(value, dtype=float)
        except (TypeError, ValueError, OverflowError):
            values[field] = None
        if values[field] is None or np.shape(values[field]) != shape:
            kind = f"an array of shape {shape}" if shape else type(old).__name__
            raise BlockError(f"{name}.{field} = {value!r}: must be {kind}")
        if not isinstance(values[field], int) and np.any(np.isnan(values[field])):
            raise BlockError(f"{name}.{field} = {value!r}: NaN is not allowed")
    return type(parameters)(**values)
