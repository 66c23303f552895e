"""What `math` does with arrays of the record."""

import functools
import sys
from collections.abc import Callable
from typing import Any

import numpy as np

from .arrays import Array, active, elementwise
from .opened import tape_of

READ = "__read__"  # among the built-in names of a copy that is read

NAMED_AS = {
    **{"asin": "arcsin", "acos": "arccos", "atan": "arctan", "atan2": "arctan2", "pow": "power"},
    **{"asinh": "arcsinh", "acosh": "arccosh", "atanh": "arctanh"},
}
OF_NUMPY = (
    *("sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "expm1", "exp2", "cbrt", "log1p", "log2"),
    *("log10", "sqrt", "fabs", "floor", "ceil", "trunc", "copysign", "fmod", "radians", "degrees"),
    *("isnan", "isinf", "isfinite", "modf", *NAMED_AS),
)


def logarithm(a: Any, base: Any = None) -> Any:
    """Return math.log(a, base)."""
    return np.log(a) if base is None else np.log(a) / np.log(base)


def whole_rest(a: Any, b: Any) -> Any:
    """Return math.remainder(a, b)."""
    return a - b * np.rint(a / b)


def about(a: Any, b: Any, *, rel_tol: float = 1e-9, abs_tol: float = 0.0) -> Any:
    """Return math.isclose(a, b)."""
    size = np.maximum(np.fabs(a), np.fabs(b))
    return (np.fabs(a - b) <= rel_tol * size) | (np.fabs(a - b) <= abs_tol)


def total_of(values: Any, start: Any = 0) -> Any:
    """Return the sum of numbers, one after the other."""
    return functools.reduce(lambda v, w: v + w, values, start)


DOMAINS: dict[str, Callable] = {  # outside, `math` raises
    "sqrt": lambda a: a < 0,
    "log": lambda a, *base: a <= 0,
    "log2": lambda a: a <= 0,
    "log10": lambda a: a <= 0,
    "asin": lambda a: np.fabs(a) > 1,
    "acos": lambda a: np.fabs(a) > 1,
}


READ = "__read__"  # among the built-in names of a function that is read


def in_a_try() -> bool:
    """Return whether a function that is read may catch what is raised now."""
    frame = sys._getframe(2)
    while frame is not None and frame.f_globals.get("__name__") != f"{__package__}.reading":
        names = frame.f_globals.get("__builtins__")
        if isinstance(names, dict) and READ in names and frame.f_code.co_exceptiontable:
            return True
        frame = frame.f_back  # type: ignore[assignment]
    return False


MATH: dict[str, Callable] = {
    **{name: getattr(np, NAMED_AS.get(name, name)) for name in OF_NUMPY},
    "erf": lambda a: elementwise("erf", a),
    "erfc": lambda a: elementwise("erfc", a),
    "log": logarithm,
    "remainder": whole_rest,
    "hypot": lambda *a: np.hypot(*a) if len(a) == 2 else np.sqrt(total_of(v * v for v in a)),
    "dist": lambda a, b: np.sqrt(total_of((v - w) ** 2 for v, w in zip(a, b, strict=True))),
    "isclose": about,
    "fsum": total_of,
    "prod": lambda a, start=1: functools.reduce(lambda v, w: v * w, a, start),
    "ldexp": lambda a, k: a * 2.0**k,
}


def single(value: Any) -> Any:
    """Return the number in an array of one, which `math` and float take."""
    if isinstance(value, Array) and value.shape and value.size == 1:
        return value[(0,) * value.ndim]
    return value


def of_math(name: str, real: Any) -> Callable:
    """Return the stand-in of a function of `math`."""

    @functools.wraps(real)
    def function(*given: Any, **more: Any) -> Any:
        if active() is None or tape_of(given) is None:
            return real(*given, **more)
        own = tuple(map(single, given))
        if name in DOMAINS and in_a_try() and DOMAINS[name](*own):
            raise ValueError("math domain error")
        return MATH[name](*own, **more)

    return function
