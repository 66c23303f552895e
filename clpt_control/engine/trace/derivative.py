"""Derivative of a record: forward mode along a direction, written on the same tape.

    (f(a))' = sum over arguments of df/da a'

The derivative is a record like any other: V' along the rates, a column of a Jacobian, a
sensitivity.  Where a and b are equal, minimum(a, b), maximum(a, b) and |a| have the slope of one
side.  Operations that jump (`where`, floor, sign, an index in a table) have a slope on each side
and none across: if `smooth`, a direction that reaches their condition is refused.
"""

from collections.abc import Callable, Mapping
from functools import reduce
from operator import add
from typing import Any

import numpy as np

from ..record.graph import Ref, reached
from ..record.operations import NO_ROW, STEPS, TABLE
from ..record.unread import Unread
from .arrays import Tape, operand
from .elementwise import elementwise, spread


def _times(factor, slope):
    return slope if isinstance(factor, float) and factor == 1.0 else factor * slope


def _chosen(condition, a, b):
    slopes = [0.0 if slope is None else slope for slope in (a, b)]
    return elementwise("where", condition, *slopes)


# where the derivative of an operation is 0, not 0/0 or 0 inf; by operation, of result and arguments
# of a / b where b overflows, as in a steep logistic function, 1 / (1 + exp(3000))
OF_OVERFLOW = {"div": lambda f, a, b: (np.fabs(b) == np.inf) & (f == 0.0)}
# of a root of squares, |x|, at x = 0, and of a power of |x|, as in |x|^0.5 x
OF_ROOTS = dict.fromkeys(("sqrt", "hypot", "pow"), lambda f, *_: f == 0.0)


class Direction:
    """Derivatives along a direction.

    `slope_of` returns the derivative of a leaf or load, by its place: an array or a number, None
    where it does not change.  A derivative that is NaN is 0 where `undefined` says so.
    """

    def __init__(
        self,
        tape: Tape,
        slope_of: Callable[[int], Any],
        smooth: bool = False,
        bound: bool = False,
        undefined: Mapping[str, Any] = {},
    ):
        self.tape = tape
        self.undefined = undefined
        self.smooth = smooth
        self.bound = bound  # add the sizes of all terms: by how much a value may change
        self.slope_of = slope_of
        self.known: dict[int, Any] = {}

    def of(self, value):
        """Return the derivative of a value of the tape, of its shape; 0.0 where it is zero."""
        ref = operand(value)
        if type(ref) is float:
            return 0.0
        new = reached(self.tape.operations, [ref], self.known)
        for k in sorted(new):
            self.known[k] = self._finite(k, self._slope(k))
        slope = self.known[ref]
        if slope is None:
            return 0.0
        return spread(self.tape, slope, self.tape.operations[ref].shape)

    def _finite(self, k: int, slope: Any) -> Any:
        """Return a derivative, 0 where it is undefined."""
        kind, arguments, *_ = self.tape.operations[k]
        if slope is None or kind not in self.undefined:
            return slope
        values = map(self.tape.value, (k, *arguments))
        is_undefined = self.undefined[kind](*values) & (slope != slope)
        return elementwise("where", is_undefined, 0.0, slope)

    def _slope(self, k: int) -> Any:
        kind, arguments, shape, at = self.tape.operations[k]
        if kind in ("leaf", "load"):
            return self.slope_of(k)
        slopes = [self.known.get(a) if type(a) is int else None for a in arguments]
        if all(slope is None for slope in slopes):
            return None
        values = [self.tape.value(a) for a in arguments]
        if kind in STEPS:
            return self._refused(kind) if self.smooth else None
        row = TABLE.get(kind, NO_ROW)
        if row.slopes:
            if kind == "mod" and self.smooth:
                self._refused(kind)
            numbers = [np.float64(v) if type(v) is float else v for v in values]
            result = self.tape.value(k)
            with np.errstate(all="ignore"):  # of a path that may not be taken
                terms = []
                for derivative, slope in zip(row.slopes, slopes, strict=True):
                    if slope is not None:
                        factor = derivative(*numbers, result)
                        if self.bound:
                            factor = np.fabs(factor)
                        terms.append(_times(factor, slope))
            return reduce(add, terms)
        if row.chosen:
            return _chosen(row.chosen(*values), *slopes)
        if kind == "where":
            return _chosen(values[0], *slopes[1:])
        if kind in ("sum", "view", "fill", "stack", "join", "part"):
            refs = [
                self._argument(a, s) for a, s in zip(arguments, slopes, strict=True)
            ]
            return self.tape.add(kind, refs, shape, at)
        if kind == "pick" and (slopes[1] is None or not self.smooth):
            if slopes[0] is None:
                return None
            row_slopes = self._argument(arguments[0], slopes[0])
            return self.tape.add(kind, [row_slopes, arguments[1]], shape)
        return self._refused(kind)

    def _argument(self, ref: Ref, slope: Any) -> Ref:
        shape = () if type(ref) is float else self.tape.operations[ref].shape
        return operand(spread(self.tape, 0.0 if slope is None else slope, shape))

    def _refused(self, kind: str) -> Any:
        raise Unread(f"the derivative of `{kind}`, which jumps or is not known")
