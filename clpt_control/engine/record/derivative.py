"""The derivative reading of a record: forward along a direction, on the record itself.

    (f(a))' = sum over arguments of df/da a'

The tape grows by what the derivative takes, so it is a record as any other: V' along the rates, a
column of a Jacobian, a sensitivity.  Where a and b tie, minimum(a, b), maximum(a, b) and |a| have
the slope of one side.  What jumps (`where`, floor, sign, a place in a table) has a slope of its own
on each side, and none across: a direction that reaches its condition is refused if `smooth`.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import reduce
from math import pi, sqrt
from operator import add
from typing import Any

import numpy as np

from ..trace.arrays import COMPARISONS, CONDITIONS, Tape, Unread, operand
from ..trace.elementwise import elementwise, spread
from .graph import Ref, reached

# constant but for jumps
JUMPS = frozenset({"sign", "floor", "ceil", "trunc", "floordiv", "search", "argmin"})
STEPS = COMPARISONS | JUMPS
Slope = Callable[..., Any]

# of one argument: d f(a)/da, given a and f(a)
OF_ONE: dict[str, Slope] = {
    "neg": lambda a, f: -1.0,
    "fabs": lambda a, f: np.where(a < 0.0, -1.0, 1.0),
    "exp": lambda a, f: f,
    "expm1": lambda a, f: f + 1.0,
    "log": lambda a, f: 1.0 / a,
    "log1p": lambda a, f: 1.0 / (1.0 + a),
    "log2": lambda a, f: 1.0 / (a * np.log(2.0)),
    "log10": lambda a, f: 1.0 / (a * np.log(10.0)),
    "sqrt": lambda a, f: 1.0 / (2.0 * f),
    "sin": lambda a, f: np.cos(a),
    "cos": lambda a, f: -np.sin(a),
    "tan": lambda a, f: 1.0 + f * f,
    "asin": lambda a, f: 1.0 / np.sqrt(1.0 - a * a),
    "acos": lambda a, f: -1.0 / np.sqrt(1.0 - a * a),
    "atan": lambda a, f: 1.0 / (1.0 + a * a),
    "sinh": lambda a, f: np.cosh(a),
    "cosh": lambda a, f: np.sinh(a),
    "tanh": lambda a, f: 1.0 - f * f,
    "asinh": lambda a, f: 1.0 / np.sqrt(1.0 + a * a),
    "acosh": lambda a, f: 1.0 / np.sqrt(a * a - 1.0),
    "atanh": lambda a, f: 1.0 / (1.0 - a * a),
    "erf": lambda a, f: 2.0 / sqrt(pi) * np.exp(-a * a),
    "erfc": lambda a, f: -2.0 / sqrt(pi) * np.exp(-a * a),
}
# of each argument: a slope, given the arguments and f
SLOPES: dict[str, Sequence[Slope]] = {
    **{kind: [slope] for kind, slope in OF_ONE.items()},
    "add": [lambda a, b, f: 1.0, lambda a, b, f: 1.0],
    "sub": [lambda a, b, f: 1.0, lambda a, b, f: -1.0],
    "mul": [lambda a, b, f: b, lambda a, b, f: a],
    "div": [lambda a, b, f: 1.0 / b, lambda a, b, f: -1.0 * f / b],
    "pow": [lambda a, b, f: b * a ** (b - 1.0), lambda a, b, f: f * np.log(a)],
    "hypot": [lambda a, b, f: a / f, lambda a, b, f: b / f],
    "atan2": [lambda a, b, f: b / (a * a + b * b), lambda a, b, f: -a / (a * a + b * b)],
    "mod": [lambda a, b, f: 1.0, lambda a, b, f: -np.floor(a / b)],
}
CHOOSING = {"minimum": np.less_equal, "maximum": np.greater_equal}  # whose slope is one side's


def _times(factor: Any, slope: Any) -> Any:
    return slope if isinstance(factor, float) and factor == 1.0 else factor * slope


def _chosen(condition: Any, a: Any, b: Any) -> Any:
    return elementwise("where", condition, 0.0 if a is None else a, 0.0 if b is None else b)


class Direction:
    """Derivatives along a direction: leaf -> its derivative, an array or a number.

    What is not named does not change.
    """

    def __init__(self, tape: Tape, along: Mapping[int, Any], smooth: bool = False):
        self.tape, self.smooth = tape, smooth
        self.known: dict[int, Any] = dict(along)

    def of(self, value: Any) -> Any:
        """Return the derivative of a value of the tape, of its shape; 0.0 where it is zero."""
        ref = operand(value)
        if type(ref) is float:
            return 0.0
        for k in sorted(reached(self.tape.operations, [ref]) - self.known.keys()):
            self.known[k] = self._along(k)
        if (slope := self.known[ref]) is None:
            return 0.0
        return spread(self.tape, slope, self.tape.operations[ref].shape)

    def _along(self, k: int) -> Any:
        kind, arguments, shape, at = self.tape.operations[k]
        slopes = [self.known.get(a) if type(a) is int else None for a in arguments]
        if all(slope is None for slope in slopes):
            return None
        values = [self.tape.value(a) for a in arguments]
        if kind in CONDITIONS or kind in JUMPS:
            return self._refused(kind) if self.smooth else None
        if kind in SLOPES:
            if kind == "mod" and self.smooth:
                self._refused(kind)
            given = *(np.float64(v) if type(v) is float else v for v in values), self.tape.value(k)
            each = zip(SLOPES[kind], slopes, strict=True)
            with np.errstate(all="ignore"):  # of a path that may not be taken
                return reduce(add, [_times(of(*given), s) for of, s in each if s is not None])
        if kind in CHOOSING:
            return _chosen(CHOOSING[kind](*values), *slopes)
        if kind == "where":
            return _chosen(values[0], *slopes[1:])
        if kind in ("sum", "view", "fill", "stack", "join", "part"):
            refs = [self._argument(a, s) for a, s in zip(arguments, slopes, strict=True)]
            return self.tape.add(kind, refs, shape, at)
        if kind == "pick" and (slopes[1] is None or not self.smooth):
            if slopes[0] is None:
                return None
            return self.tape.add(
                kind, [self._argument(arguments[0], slopes[0]), arguments[1]], shape
            )
        return self._refused(kind)

    def _argument(self, ref: Ref, slope: Any) -> Ref:
        shape = () if type(ref) is float else self.tape.operations[ref].shape
        return operand(spread(self.tape, 0.0 if slope is None else slope, shape))

    def _refused(self, kind: str) -> Any:
        raise Unread(f"the derivative of `{kind}`, which jumps or is not known")
