"""What functions of `math` and built-in ones do with arrays of the record: max, sorted, any, ..."""

import functools
import math
import sys
from collections.abc import Callable
from typing import Any

import numpy as np

from .arrays import Tape, elementwise, single, where
from .numpy_functions import in_order
from .opened import tape_of
from .standing import TYPES, StandIn, is_a

MOST_SORTED = 16
READ = "__read__"  # among the built-in names of a copy that is read


def about(a: Any, b: Any, *, rel_tol: float = 1e-9, abs_tol: float = 0.0) -> Any:
    """Return math.isclose(a, b)."""
    size = np.maximum(np.fabs(a), np.fabs(b))
    return (np.fabs(a - b) <= rel_tol * size) | (np.fabs(a - b) <= abs_tol)


def total_of(values: Any, start: Any = 0) -> Any:
    """Return the sum of numbers, one after the other."""
    return functools.reduce(lambda v, w: v + w, values, start)


DOMAINS: dict[str, Callable] = {  # outside, `math` raises
    "sqrt": lambda a: a < 0,
    **dict.fromkeys(("log", "log2", "log10"), lambda a, *base: a <= 0),
    **dict.fromkeys(("asin", "acos"), lambda a: np.fabs(a) > 1),
}


def in_a_try() -> bool:
    """Return whether a function that is read may catch what is raised now."""
    frame = sys._getframe(1)
    while frame is not None and frame.f_globals.get("__name__") != f"{__package__}.reading":
        names = frame.f_globals.get("__builtins__")
        if isinstance(names, dict) and READ in names and frame.f_code.co_exceptiontable:
            return True
        frame = frame.f_back  # type: ignore[assignment]
    return False


MATH: dict[str, Callable] = {
    **{name: f for name in vars(math) if isinstance(f := getattr(np, name, None), np.ufunc)},
    **{name: functools.partial(elementwise, name) for name in ("erf", "erfc")},
    "log": lambda a, base=None: np.log(a) if base is None else np.log(a) / np.log(base),
    "remainder": lambda a, b: a - b * np.rint(a / b),
    "hypot": lambda *a: np.hypot(*a) if len(a) == 2 else np.sqrt(total_of(v * v for v in a)),
    "dist": lambda a, b: np.sqrt(total_of((v - w) ** 2 for v, w in zip(a, b, strict=True))),
    "isclose": about,
    "fsum": total_of,
    "prod": lambda a, start=1: functools.reduce(lambda v, w: v * w, a, start),
    "ldexp": lambda a, k: a * 2.0**k,
}


def of_math(name: str, tape: Tape, *given: Any, **more: Any) -> Any:
    """Write down a function of `math`."""
    own = tuple(map(single, given))
    if name in DOMAINS and in_a_try() and DOMAINS[name](*own):
        raise ValueError("math domain error")
    return MATH[name](*own, **more)


OF_MATH = [StandIn(getattr(math, name), functools.partial(of_math, name)) for name in MATH]


# --- built-in functions ------------------------------------------------------------------------


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
