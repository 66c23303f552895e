"""Arguments of a function while it is read, answers to its questions, and ways through it.

Each way through a function is a row of answers; what depends on parameters alone has a value.  What
ways give is joined by the questions.  A helper that is given numbers, and reaches nothing that can
change, is joined where it is called:

    limited(u) = where(u > 1, 1, where(u < -1, -1, u))

so eight thrusters with three ways each are 24 ways, and not 3^8.
"""

import functools
import sys
from collections.abc import Callable, Iterator, Mapping
from math import prod
from traceback import walk_tb
from types import FrameType, FunctionType, NoneType
from typing import Any

import numpy as np

from .arrays import Array, Tape, Unread, active, key_of, operand
from .elementwise import chosen
from .record import Ref, Shape, compact, reached

LIBRARIES = ("numpy", "scipy", "matplotlib")  # run as they are
MOST_QUESTIONS = 64  # on one way
MOST_PLACES = 64  # which whole numbers a signal is asked for
SIDES = {"gt": (1, True), "ge": (1, False), "lt": (-1, True), "le": (-1, False)}  # above, open


class Outside(Exception):
    """No run takes this way: the signal would be a place that no row has."""


EVERY = object()  # stands for all names
FOR_ONE = ("__getitem__", "__contains__", "get", "pop", "setdefault")
FOR_ALL = (
    *("__iter__", "__reversed__", "__eq__", "__or__", "__ror__"),
    *("keys", "values", "items", "copy", "popitem"),
)


def _noted(method: str) -> Callable:
    """Return a method of dict that notes the name that it asks for, or EVERY."""
    real = getattr(dict, method)

    def noting(self: "Params", *arguments: Any) -> Any:
        self.names.add(arguments[0] if method in FOR_ONE else EVERY)
        return real(self, *arguments)

    return noting


class Params(dict):
    """The params of python-control; they note the names that a function asks for."""

    def __init__(self, params: Mapping[str, Any], names: set[Any]) -> None:
        super().__init__(params)
        self.names = names

    vars().update({method: _noted(method) for method in (*FOR_ONE, *FOR_ALL)})


class AnsweringTape(Tape):
    """A tape that answers questions as this way through the function takes them."""

    def __init__(self, parameters: Mapping[str, Any]) -> None:
        super().__init__()
        self.parameters = parameters
        self.pinned: set[str] = set()  # parameters whose value Python asked for
        self.way: list[bool] = []
        self.answers: dict[int, bool] = {}
        self.rows: dict[int, int] = {}  # length of the row in which a signal is a place
        self.last_asked: tuple[int, int] | None = None  # a signal, and the answer

    def question(self, ref: Ref) -> bool:
        """Answer a condition: as this way says, or by the parameters if they decide."""
        if type(ref) is float or not self.free[ref]:
            return bool(self.known(ref).item())
        if ref not in self.answers:
            if (known := self._implied(ref)) is not None:
                return known
            k = len(self.answers)
            if k >= MOST_QUESTIONS:
                raise Unread(
                    f"asks more than {MOST_QUESTIONS} questions that depend on signals; write "
                    "np.where, and no `while` on a signal"
                )
            self.answers[ref] = self.way[k] if k < len(self.way) else True
        return self.answers[ref]

    def _side(self, ref: Ref) -> tuple[Ref, int, list[float]]:
        """Return what a comparison with a constant asks: signal, way, where this half line ends."""
        kind, arguments, *_ = self.operations[ref]
        if kind not in SIDES:
            return ref, 0, []
        (a, b), (way, open_end) = arguments, SIDES[kind]
        signal, end, way = (b, a, -way) if type(a) is float else (a, b, way)
        return (signal, way, [way * end, open_end]) if type(end) is float else (ref, 0, [])

    def _implied(self, ref: Ref) -> bool | None:
        """Return what answers say of another comparison of their signal; NaN is on no side."""
        signal, way, end = self._side(ref)
        for asked, yes in self.answers.items():
            own, other_way, other = self._side(asked)
            if own != signal or not way * other_way:
                continue
            if other_way == way and (other >= end if yes else end >= other):
                return yes
            apart = [a + b for a, b in zip(end, other, strict=True)] > [0, 0]
            if other_way != way and yes and apart:
                return False
        return None

    def numbers(self, ref: Ref) -> np.ndarray:
        """Return the numbers that Python asks for; only parameters have any."""
        if type(ref) is float or not self.free[ref]:
            return self.known(ref)
        raise Unread(
            f"{_asking()} asks for the value of a signal; write what it computes in NumPy, "
            "and fill arrays where they are made"
        )

    def known(self, ref: Ref) -> np.ndarray:
        """Return the value of what depends on parameters alone, which are then pinned."""
        used = reached(self.operations, [ref])
        leaves = [self.operations[k].at for k in used if self.operations[k].kind == "leaf"]
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
        """Return the whole number that Python counts with; a signal is asked which one it is."""
        ref = number._ref
        if type(ref) is float or not self.free[ref]:
            value = self.known(ref).item()
            if value != int(value):
                raise TypeError("only integers can be used as an index")
            return int(value)
        if number._below is not None:
            places = range(number._below)
            return next((k for k in places[:-1] if number == float(k)), places[-1])
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

    def ended(self, error: Exception) -> None:
        """Note the length of a row, where a way raised at its end."""
        if isinstance(error, IndexError) and self.last_asked and self.last_asked[1] >= 0:
            self.rows.setdefault(*self.last_asked)


def _asking() -> str:
    """Return what asks for a number: a library's function that a user's calls, or Python."""
    frame, word = sys._getframe(2), "Python"
    while (module := _not_users(frame)) and frame.f_back is not None:
        if not module.startswith(__package__):
            word = f"{module.partition('.')[0]}'s {frame.f_code.co_qualname}"
        frame = frame.f_back
    return word


def _not_users(frame: FrameType) -> str:
    """Return the module of a frame of this package or of a library; "" of a user's."""
    module = frame.f_globals.get("__name__") or ""
    return module if module.startswith((*LIBRARIES, __package__)) else ""


def located(function: Any, *errors: Exception) -> str:
    """Return function and line in which a reading ended, for a sentence.

    Of several errors the first counts that came by a line: a library may swallow one.
    """
    for error in errors:
        lines = [
            f"{frame.f_code.co_name}, line {line}: "
            for frame, line in walk_tb(error.__traceback__)
            if not _not_users(frame)
        ]
        if lines:
            return lines[-1]
    return f"{getattr(function, '__name__', 'it')}: "


class Ports(Array):
    """States or inputs without values: a vector, with its ports as views."""

    __slots__ = ("_ports",)

    def __init__(self, tape: Tape, group: str, shapes: Mapping[str, Shape], fixed: bool = True):
        self._ports = {
            port: tape.add("leaf", (), shape, (group, port)) for port, shape in shapes.items()
        }
        known = all(isinstance(n, int) for shape in shapes.values() for n in shape)
        size: Any = sum(map(prod, shapes.values())) if known else f"len({group})"
        super().__init__(tape, -1, (size,))
        del self._node  # until it is asked for
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
        self._node = rows[0] if rows else self._tape.add("constant", (), (0,), b"")._node
        return self._node


def _rows(array: Any) -> list[Array]:
    """Return the rows of an array of any number of axes."""
    return [array] if array.ndim == 1 else [row for part in array for row in _rows(part)]


# --- ways -------------------------------------------------------------------------------------

MOST_OF_HELPER, MOST_RUNS = 32, 10_000
NUMBERS = (int, float, np.float64)
PLAIN = (*NUMBERS, bool, str, NoneType)


def each_way(tape: Any) -> Iterator[None]:
    """Yield once for each way through what runs then, with the answers of this way."""
    before = dict(tape.answers)
    tape.way = [*before.values()]
    while True:
        tape.answers = dict(before)
        yield
        tape.runs += 1
        if tape.runs > MOST_RUNS:
            raise Unread(f"has helpers in helpers, of more than {MOST_RUNS} ways")
        way = [*tape.answers.values()]
        while len(way) > len(before) and not way[-1]:
            way.pop()
        if len(way) == len(before):
            return
        tape.way = [*way[:-1], False]


def merged(
    tape: Tape, ways: list[tuple[dict[int, bool], list[Any]]], choose: Callable, depth: int = 0
) -> list[Any]:
    """Join what ways return by the questions, from the one at `depth` on, that tell them apart."""
    if len(ways) == 1:
        return ways[0][1]
    question = list(ways[0][0])[depth]
    yes, no = ([way for way in ways if way[0].get(question) is one] for one in (True, False))
    if not yes or not no or len(yes) + len(no) < len(ways):
        raise Unread("asks otherwise from call to call; make what it keeps a state")
    condition = Array(tape, question, ())
    sides = (merged(tape, some, choose, depth + 1) for some in (yes, no))
    return [
        a if key_of(operand(a)) == key_of(operand(b)) else choose(condition, a, b)
        for a, b in zip(*sides, strict=True)
    ]


def joined(function: FunctionType) -> Callable:
    """Return a helper whose ways are joined where it is called, if they give numbers."""

    @functools.wraps(function)
    def helper(*arguments: Any, **more: Any) -> Any:
        tape: Any = active()
        if tape is None or not all(map(_is_plain, (*arguments, *more.values()))):
            return function(*arguments, **more)
        before, ways = (tape.answers, tape.way), list[tuple[dict[int, bool], Any]]()
        texts = tape.texts
        try:
            for _ in each_way(tape):
                result = function(*arguments, **more)
                ways.append((tape.answers, result))
                if len(ways) > MOST_OF_HELPER:
                    break
            else:
                if len(ways) == 1:
                    return result
                several = type(result) is tuple
                rows = [(own, [*one] if several else [one]) for own, one in ways]
                if _are_numbers([row for _, row in rows]):
                    parts = merged(tape, rows, chosen, len(before[0]))
                    return tuple(parts) if several else parts[0]
        except Exception:
            if tape.stopped is not None:
                raise
        finally:
            tape.answers, tape.way = before
        tape.texts = texts
        return function(*arguments, **more)  # its ways are those of the function that calls it

    return helper


def _are_numbers(rows: list[list[Any]]) -> bool:
    """Return whether ways give numbers; whole ones alone may be places, of which one counts."""
    if len({len(row) for row in rows}) > 1:
        return False
    return all(
        all(map(_is_number, own)) and not all(type(one) is int for one in own)
        for own in zip(*rows, strict=True)
    )


def _is_number(value: Any) -> bool:
    if isinstance(value, Array):
        return not (value.shape or value._boxed or value._is_condition)
    return type(value) in NUMBERS


def _is_plain(value: Any) -> bool:
    return type(value) in PLAIN or _is_number(value)
