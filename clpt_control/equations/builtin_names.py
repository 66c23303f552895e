"""What stands for built-in functions: max, min, any, all, sorted, isinstance."""

import functools
from collections.abc import Callable
from typing import Any

import numpy as np

from .arrays import single, where
from .numpy_functions import in_order
from .opened import tape_of
from .standing import TYPES, is_a

MOST_SORTED = 16


def of_values(real: Callable, own: Callable[[list], Any]) -> Callable:
    """Return the stand-in of a function of values, given one by one or in one."""

    @functools.wraps(real)
    def function(*given: Any, **more: Any) -> Any:
        values = list(given[0]) if len(given) == 1 else list(given)
        return real(values, **more) if more or tape_of(values) is None else own(values)

    return function


def best(better: Callable, values: list) -> Any:
    """Return the best value: what is better takes the place of what was best."""
    return functools.reduce(lambda a, b: where(better(b, a), b, a), map(single, values))


def ordered(values: list) -> list[Any]:
    """Return values sorted, without a question where they are few."""
    return in_order(values) if len(values) <= MOST_SORTED else sorted(values)


SHADOWS: dict[str, Any] = {  # built-in names that have stand-ins
    "float": TYPES[float],
    "int": TYPES[int],
    "max": of_values(max, functools.partial(best, np.greater)),
    "min": of_values(min, functools.partial(best, np.less)),
    "any": of_values(any, functools.partial(functools.reduce, np.logical_or)),
    "all": of_values(all, functools.partial(functools.reduce, np.logical_and)),
    "sorted": of_values(sorted, ordered),
    "isinstance": is_a,
}
