"""Arguments of a traced function, and the outcomes of its branch conditions.

Each execution path (`execution_paths`) is a row of outcomes.  Expressions of parameters alone have
values.
"""

from collections.abc import Callable, Mapping
from math import prod
from typing import Any

import numpy as np

from ..model.locations import caller
from ..record.graph import Ref, Shape, compact, is_known, reached
from ..record.unread import Unread
from .arrays import Array, Tape

MOST_QUESTIONS = 64  # conditions of one path
MOST_PLACES = 64  # values of a signal that is an index


class Outside(Exception):
    """No run takes this path: the index would be outside of every row."""


class AnsweringTape(Tape):
    """A tape with the branch outcomes of one execution path."""

    def __init__(self, parameters: Mapping[str, Any]) -> None:
        super().__init__()
        self.parameters = parameters
        self.pinned: set[str] = set()  # parameters whose value Python asked for
        self.way: list[bool] = []
        self.answers: dict[int, bool] = {}
        self.asked: set[int] = set()  # conditions of all paths
        # regions whose paths cannot be merged: known before, and found now
        self.unmergeable: frozenset[Any] = frozenset()
        self.failed: set[Any] = set()
        self.rows: dict[int, int] = {}  # length of the row in which a signal is a place
        self.last_asked: tuple[int, int] | None = None  # a signal, and the answer
        # identities of values that outlive the function
        self.persistent: set[int] = set()
        self.check: Callable[[], None] = lambda: None  # refuses a change of these

    def question(self, ref: Ref) -> bool:
        """Return the outcome of a condition on this path, or by the parameters alone."""
        if type(ref) is float or not self.free[ref]:
            return bool(self.known(ref).item())
        if ref not in self.answers:
            k = len(self.answers)
            if k >= MOST_QUESTIONS:
                raise Unread(
                    f"has more than {MOST_QUESTIONS} branches that depend on signals. Write "
                    "np.where, and no `while` on a signal"
                )
            self.answers[ref] = self.way[k] if k < len(self.way) else True
            self.asked.add(ref)
        return self.answers[ref]

    def numbers(self, ref: Ref) -> np.ndarray:
        """Return the numbers of a value that depends on parameters alone."""
        if type(ref) is float or not self.free[ref]:
            return self.known(ref)
        raise Unread(
            f"{caller()} needs the value of a signal. Write the computation in NumPy, "
            "and fill arrays where they are made"
        )

    def known(self, ref: Ref) -> np.ndarray:
        """Return the value of an expression of parameters, which are then pinned."""
        used = reached(self.operations, [ref])
        leaves = [
            self.operations[k].at for k in used if self.operations[k].kind == "leaf"
        ]
        self.pinned |= {name for _, name in leaves}
        record = compact(self.operations, [ref])
        return record.values(lambda group, name: self.parameters[name], {})[0]

    def parameter(self, ref: int) -> Any:
        """Return the value of a parameter as the user wrote it, which is then pinned."""
        kind, _, _, at = self.operations[ref]
        if kind != "leaf" or self.free[ref]:
            return None
        self.pinned.add(at[1])
        return self.parameters[at[1]]

    def whole(self, number: Array) -> int:
        """Return a whole number for Python; a signal has one on each path."""
        ref = number._ref
        if type(ref) is float or not self.free[ref]:
            value = self.known(ref).item()
            if value != int(value):
                raise TypeError("only integers can be used as an index")
            return int(value)
        if number._below is not None:
            candidates = range(number._below)
            return next(
                (k for k in candidates[:-1] if number == float(k)), candidates[-1]
            )
        count = self.rows.get(ref, MOST_PLACES)
        for k in (*range(count + 1), *range(-1, -count - 1, -1)):
            if k == MOST_PLACES:
                raise Unread(
                    "counts with a signal; let a number of the run choose by np.where or lookup"
                )
            self.last_asked = ref, k
            if number == float(k):
                return k
        self.last_asked = None
        raise Outside

    def ended(self, error: BaseException) -> None:
        """Store the length of a row if the path raised at the end of the row."""
        if (
            isinstance(error, IndexError)
            and self.last_asked
            and self.last_asked[1] >= 0
        ):
            self.rows.setdefault(*self.last_asked)


class Ports(Array):
    """Tracer array of all states or inputs: a vector, with its ports as views."""

    __slots__ = ("_ports",)

    def __init__(
        self, tape: Tape, group: str, shapes: Mapping[str, Shape], fixed: bool = True
    ):
        self._ports = {
            port: tape.add("leaf", (), shape, (group, port))
            for port, shape in shapes.items()
        }
        has_sizes = all(map(is_known, shapes.values()))
        size: Any = sum(map(prod, shapes.values())) if has_sizes else f"len({group})"
        super().__init__(tape, -1, (size,))
        del self._node  # until it was requested
        self._fixed = fixed
        for leaf in self._ports.values():
            leaf._fixed = True

    def __getattr__(self, name: str) -> Any:
        if name in self._ports:
            return self._ports[name]
        if name != "_node":
            return super().__getattr__(name)
        self._counted()
        rows = [row._ref for leaf in self._ports.values() for row in _rows(leaf)]
        if len(rows) > 1:  # of the vector of all ports, one behind the other
            rows = [self._tape.add("join", rows, self.shape)._node]
        self._node = (
            rows[0] if rows else self._tape.add("constant", (), (0,), b"")._node
        )
        return self._node


def _rows(array: Any) -> list[Array]:
    """Return the rows of an array of any number of axes."""
    return (
        [array]
        if array.ndim == 1
        else [row for row_block in array for row in _rows(row_block)]
    )
