"""Identity of traced values: `is` and ``case True``.

Python calls no method of a value for `is`: functions are rewritten to call `is_same` (`rewriting`).
A signal is no constant, such as None, and is True or False only if it is a truth value of Python's
own.  Whether two numbers are one object is not recorded, so such a comparison is refused.
"""

from typing import Any

from ..record.unread import Unread, active
from .arrays import Array
from .elementwise import definite

COPIED = (
    int,
    float,
    complex,
    str,
    bytes,
    tuple,
    frozenset,
)  # which merged paths replace


def is_same(a: Any, b: Any) -> bool:
    """Return `a is b`."""
    tape: Any = active()
    if tape is None:
        return a is b
    for value, other in ((a, b), (b, a)):
        if isinstance(value, Array):
            if isinstance(other, bool):
                is_truth = value._is_condition and not value.shape
                return is_truth and definite(value._of_python) and bool(value) is other
            if isinstance(other, Array | float | int):
                raise Unread("compares signals by `is`. Write ==")
            return False
    if tape.merging and type(a) in COPIED and type(b) in COPIED:
        raise Unread("compares constants by `is`. Write ==")
    return a is b


class Truth:
    """True or False as a pattern of `match`, which is equal to the object itself alone."""

    __array_ufunc__ = None  # NumPy's values leave the comparison to this class

    def __init__(self, truth: bool):
        self.truth = truth
        self.value = self

    def __eq__(self, other: object) -> bool:
        return is_same(other, self.truth)


TRUTHS = {truth: Truth(truth) for truth in (True, False)}
