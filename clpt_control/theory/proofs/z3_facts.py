"""Facts about functions, as constraints of Z3 on an argument s and a value y.

Each fact holds for every real s: facts of log(s), for example, are implied by s > 0 only.  So the
facts exclude no values of the symbols.  Numbers such as pi are rounded up.
"""

from collections.abc import Callable
from fractions import Fraction
from itertools import combinations
from typing import Any

HALF_PI, PI, ERF_SLOPE = map(Fraction, ("1.5708", "3.1416", "1.1284"))

Values = dict[Any, tuple[Any, Any]]  # argument in SymPy -> argument and value in Z3


def _odd(low: Any = None, high: Any = None, limit: Any = None) -> Callable[..., list]:
    """Return the facts of an odd function: low <= y/s <= high and |y| <= limit."""

    def facts(z3: Any, y: Any, s: Any) -> list:
        up, down = [s > 0, y > 0], [s < 0, y < 0]
        if low is not None:
            up, down = [*up, y >= low * s], [*down, y <= low * s]
        if high is not None:
            up, down = [*up, y <= high * s], [*down, y >= high * s]
        bounds = [] if limit is None else [y <= limit, y >= -limit]
        return [z3.Or(z3.And(up), z3.And(down), z3.And(s == 0, y == 0)), *bounds]

    return facts


def _sin(z3: Any, y: Any, s: Any) -> list:
    within = z3.Or(z3.And(y <= s, y >= -s), z3.And(y >= s, y <= -s))
    return [within, y <= 1, y >= -1]


def _exp(z3: Any, y: Any, s: Any) -> list:
    return [y > 0, y >= 1 + s, y * (1 - s) <= 1, (y == 1) == (s == 0)]


def _log(z3: Any, y: Any, s: Any) -> list:
    facts = [y <= s - 1, y * s >= s - 1, (y == 0) == (s == 1)]
    return [z3.Implies(s > 0, z3.And(facts))]


def _floor(z3: Any, y: Any, s: Any) -> list:
    near = [y <= s, y > s - 1, (s >= 0) == (y >= 0), (s >= 1) == (y >= 1)]
    return [*near, z3.Or(y <= -1, y >= 0), z3.Or(y <= 0, y >= 1)]


def _mod(z3: Any, y: Any, a: Any, b: Any) -> list:
    return [
        z3.Implies(b > 0, z3.And(y >= 0, y < b)),
        z3.Implies(b < 0, z3.And(y <= 0, y > b)),
        z3.Implies(z3.And(a >= 0, a < b), y == a),
    ]


# name in SymPy -> function of (z3, value, arguments) that returns facts
FACTS: dict[str, Callable[..., list]] = {
    "sin": _sin,
    "cos": lambda z3, y, s: [y <= 1, y >= -1, y >= 1 - s * s / 2],
    "tanh": _odd(high=1, limit=1),
    "atan": _odd(high=1, limit=HALF_PI),
    "asinh": _odd(high=1),
    "erf": _odd(high=ERF_SLOPE, limit=1),
    "sinh": _odd(low=1),
    "cosh": lambda z3, y, s: [y >= 1 + s * s / 2],
    "exp": _exp,
    "log": _log,
    "floor": _floor,
    "ceil": lambda z3, y, s: _floor(z3, -y, -s),
    "mod": _mod,
    "atan2": lambda z3, y, a, b: [y < PI, y > -PI],
}
RISING = ("tanh", "atan", "asinh", "erf", "sinh", "exp")
SLOPE_UP_TO_1 = ("tanh", "atan", "asinh")


def facts_of_pairs(z3: Any, calls: dict[str, Values]) -> list:
    """Return facts of a function at two arguments, and of two functions at one argument.

    `calls` has the arguments and values of each function by its name.
    """
    facts = list[Any]()
    for name in RISING:
        for (r, x), (s, y) in combinations(calls.get(name, {}).values(), 2):
            facts.append((r < s) == (x < y))
            if name in SLOPE_UP_TO_1:
                facts.append(z3.Implies(r < s, y - x <= s - r))
                facts.append(z3.Implies(s < r, x - y <= r - s))
    for odd, even, sign in (("sin", "cos", 1), ("sinh", "cosh", -1)):
        others = calls.get(even, {})
        for argument, (_, y) in calls.get(odd, {}).items():
            if argument in others:
                _, x = others[argument]
                facts.append(x * x + sign * y * y == 1)
    return facts
