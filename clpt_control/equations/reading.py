"""Read a function: run it on arrays without values, and keep the record.

    f(t, x, u, p)  ->  what each port is, as operations on t, the ports of x and u, the fields of p

A question (``if u[0] > 0``) is answered both ways: the function runs again with the other
answer, and what the ways return is joined by `where`.  A way that raises is NaN.  A signal that
Python counts with is asked which whole number it is, up to the first IndexError.  What is read
twice must be the same: else a state or chance hides in the function.
"""

import sys
from collections.abc import Callable, Iterable, Mapping
from math import nan, prod
from types import FrameType
from typing import Any, NamedTuple

import numpy as np

from ..errors import BlockError
from .arrays import (
    Array,
    Tape,
    Unread,
    as_number,
    lifted,
    operand,
    packed,
    reading_on,
    stacked,
    where,
)
from .copies import LIBRARIES, Copies, borrowed
from .record import Record, Ref, Shape, compact, reached
from .stand_ins import BUILTINS
from .ufuncs import objects

MOST_WAYS = 256
MOST_QUESTIONS = 64  # on one way
MOST_PLACES = 64  # which whole numbers a signal is asked for
MOST_MODULES = 20  # into which stand-ins are put
RAISED = (ArithmeticError, IndexError, ValueError, AssertionError)  # of numbers; such a way is NaN


class Read(NamedTuple):
    """What reading a function gave."""

    record: Record
    pinned: frozenset[str]  # parameters with whose values it was made
    raised: tuple[str, ...] = ()  # what ways that are NaN raised


class Borrowed(Exception):
    """A helper that is reached through an object needs stand-ins in its module."""

    def __init__(self, space: dict[str, Any]):
        super().__init__(space.get("__name__", ""))
        self.space = space


class Outside(Exception):
    """A way that no run takes: a place that no row has."""


class Reading(Tape):
    """A tape with the answers that this way through the function takes."""

    def __init__(self, parameters: Mapping[str, Any], spaces: list[dict[str, Any]]) -> None:
        super().__init__()
        self.parameters, self.spaces = parameters, spaces
        self.pinned: set[str] = set()  # parameters whose value Python asked for
        self.way: list[bool] = []
        self.answers: dict[int, bool] = {}
        self.rows: dict[int, int] = {}  # length of the row in which a signal is a place
        self.asked: tuple[int, int] | None = None  # the signal last asked, and the answer

    def question(self, ref: Ref) -> bool:
        """Answer a condition: as this way says, or by the parameters if they decide."""
        if type(ref) is float or not self.free[ref]:
            return bool(self.known(ref).item())
        if ref not in self.answers:
            k = len(self.answers)
            if k >= MOST_QUESTIONS:
                raise Unread(
                    f"asks more than {MOST_QUESTIONS} questions that depend on signals; write "
                    "np.where, and no `while` on a signal"
                )
            self.answers[ref] = self.way[k] if k < len(self.way) else True
        return self.answers[ref]

    def numbers(self, ref: Ref) -> np.ndarray:
        """Return what Python asks for; only parameters have a value."""
        if type(ref) is float or not self.free[ref]:
            return self.known(ref)
        frame = _asking()
        space, where_ = frame.f_globals, f"{frame.f_code.co_name}, line {frame.f_lineno}"
        library = (space.get("__name__") or "").partition(".")[0]
        if library in LIBRARIES:
            raise Unread(
                f"{library} ({where_}) asks for the value of a signal; write what it computes in "
                "NumPy"
            )
        if space.get("__builtins__") is BUILTINS or any(space is one for one in self.spaces):
            raise Unread(
                "needs the value of a signal; write NumPy, and fill arrays where they are made"
            )
        self.stopped = Borrowed(space)
        raise self.stopped

    def known(self, ref: Ref) -> np.ndarray:
        """Return the value of what depends on parameters alone, which are then pinned."""
        if type(ref) is float:
            return np.asarray(ref)
        used = reached(self.operations, [ref])
        leaves = [self.operations[k].at for k in used if self.operations[k].kind == "leaf"]
        self.pinned |= {name for _, name in leaves}
        record = compact(self.operations, [ref])
        return record.values(lambda group, name: self.parameters[name], {})[0]

    def whole(self, number: Array) -> int:
        """Return the whole number that Python counts with; a signal is asked which one it is."""
        ref = number.ref
        if type(ref) is float or not self.free[ref]:
            value = self.known(ref).item()
            if value != int(value):
                raise TypeError("only integers can be used as an index")
            return int(value)
        count = self.rows.get(ref, MOST_PLACES)
        for k in (*range(count + 1), *range(-1, -count - 1, -1)):
            if k == MOST_PLACES:
                raise Unread(
                    "counts with a signal; let a number of the run choose by np.where or lookup"
                )
            self.asked = ref, k
            if number == float(k):
                return k
        self.asked = None
        raise Outside

    def ended(self, error: Exception) -> None:
        """Learn from a way that raised where a row ends."""
        if isinstance(error, IndexError) and self.asked and self.asked[1] >= 0:
            self.rows.setdefault(*self.asked)


def _asking() -> FrameType:
    """Return the frame in which a number is asked for, past NumPy and the record's own."""
    frame = sys._getframe(2)
    while frame.f_back is not None and _own(frame):
        frame = frame.f_back
    return frame


def _own(frame: FrameType) -> bool:
    name = frame.f_globals.get("__name__") or ""
    return name.startswith("numpy") or name.startswith(__package__)


def located(error: Exception, function: Any) -> str:
    """Return function and line in which a reading ended, for a sentence."""
    found, trace = "", error.__traceback__
    while trace is not None:
        frame, trace_line = trace.tb_frame, trace.tb_lineno
        name = frame.f_globals.get("__name__") or ""
        if not _own(frame) and name.partition(".")[0] not in LIBRARIES:
            found = f"{frame.f_code.co_name}, line {trace_line}: "
        trace = trace.tb_next
    return found or f"{getattr(function, '__name__', 'it')}: "


class Ports(Array):
    """States or inputs without values: a vector, with its ports as views."""

    __slots__ = ("_node", "ports")

    def __init__(self, tape: Tape, group: str, shapes: Mapping[str, Shape], fixed: bool = True):
        self.ports = {
            port: tape.add("leaf", (), shape, (group, port)) for port, shape in shapes.items()
        }
        known = all(isinstance(n, int) for shape in shapes.values() for n in shape)
        size: Any = sum(map(prod, shapes.values())) if known else f"len({group})"
        self._node: int | None = None
        super().__init__(tape, -1, (size,))
        self.fixed = fixed
        for leaf in self.ports.values():
            leaf.fixed = True

    @property
    def node(self) -> int:
        """Return the vector of all ports, one behind the other."""
        if self._node is None:
            self.counted()
            rows = [row for leaf in self.ports.values() for row in _rows(leaf)]
            if not rows:
                self._node = self.tape.add("constant", (), (0,), b"").node
            elif len(rows) == 1:
                self._node = rows[0].node
            else:
                refs = [operand(row) for row in rows]
                self._node = self.tape.add("join", refs, self.shape).node
        return self._node

    @node.setter
    def node(self, value: int) -> None:
        pass

    def __getattr__(self, name: str) -> Any:
        if name in self.ports:
            return self.ports[name]
        return super().__getattr__(name)


def _rows(array: Any) -> list[Array]:
    """Return the rows of an array of any number of axes."""
    return [array] if array.ndim == 1 else [row for part in array for row in _rows(part)]


class Fields:
    """Parameters without values, as a function asks for them: p.gain, p["gain"], p.get."""

    def __init__(self, values: dict[str, Any]) -> None:
        self.__dict__.update(values)

    def __getitem__(self, name: Any) -> Any:
        return self.__dict__[name]

    def get(self, name: str, default: Any = None) -> Any:
        """Return a parameter, or the default where there is none."""
        return self.__dict__.get(name, default)

    def __contains__(self, name: str) -> bool:
        return name in self.__dict__

    def keys(self) -> Any:
        """Return the names."""
        return self.__dict__.keys()


def read(
    function: Callable,
    role: str,
    states: Mapping[str, Shape],
    inputs: Mapping[str, Shape],
    parameters: Mapping[str, Any],
    shapes: Mapping[str, Shape],
    out: Mapping[str, Shape],
    given_as: Callable[[dict[str, Any]], Any] = Fields,
) -> Read:
    """Return the record of a function, and the parameters whose values it is made with.

    `shapes` holds those of the parameters that stay open; others are given as they are.  Raises
    `Unread` where it cannot be read.
    """
    spaces: list[dict[str, Any]] = []
    found: list[Read] = []
    before: _Ways | None = None  # the first reading
    try:
        while len(found) < 2:
            try:
                ways = _Ways(function, role, parameters, out, spaces, before)
                found.append(ways.read(states, inputs, shapes, given_as))
            except Borrowed as borrower:
                if len(spaces) >= MOST_MODULES:
                    raise Unread(f"runs helpers of more than {MOST_MODULES} modules") from None
                spaces.append(borrower.space)
                found.clear()
                ways.copies.kept.put_back()
                continue
            before = before or ways
            ways.copies.kept.look()
    finally:
        (before or ways).copies.kept.put_back()
    if found[0].record != found[1].record:
        raise Unread(
            f"{_name(function)} keeps what its next call reads, or draws by chance; make it a state"
        )
    return found[0]


class _Ways:
    """All ways through a function, one after the other."""

    def __init__(
        self,
        function: Callable,
        role: str,
        parameters: Mapping[str, Any],
        out: Mapping[str, Shape],
        spaces: list[dict[str, Any]],
        before: "_Ways | None" = None,
    ):
        self.function, self.role, self.out, self.spaces = function, role, out, spaces
        self.tape = Reading(parameters, spaces)
        self.copies, self.before = Copies(self.tape), before
        self.ways: list[tuple[dict[int, bool], list[Any]]] = []
        self.raised: dict[str, None] = {}

    def read(
        self,
        states: Mapping[str, Shape],
        inputs: Mapping[str, Shape],
        shapes: Mapping[str, Shape],
        given_as: Callable[[dict[str, Any]], Any],
    ) -> Read:
        """Run the function on each of its ways, and join what they return."""
        tape, copied = self.tape, self.copies.of(self.function)
        t = tape.add("leaf", (), (), ("t", "t"))
        fields = {
            name: self._leaf(name, shapes[name]) if name in shapes else self.copies.of(value)
            for name, value in tape.parameters.items()
        }
        while True:
            tape.answers, tape.asked = {}, None
            if self.before is not None:
                self.before.copies.kept.hide(lambda k: tape.add("leaf", (), (), ("t", f"kept {k}")))
            named = given_as is Fields  # else x and u are the function's own, as python-control's
            x, u = Ports(tape, "x", states, named), Ports(tape, "u", inputs, named)
            found = self._way(lambda: copied(t, x, u, given_as(dict(fields))))  # noqa: B023
            self.ways.append((tape.answers, found))
            if len(self.ways) > MOST_WAYS:
                raise Unread(f"{_name(self.function)} has more than {MOST_WAYS} ways through it")
            way = list(tape.answers.values())
            while way and not way[-1]:
                way.pop()
            if not way:
                break
            tape.way = [*way[:-1], False]
        self.copies.check()
        outputs = [operand(one) for one in _joined(tape, self.ways, 0)]
        record = compact(tape.operations, outputs, self.out.values())
        return Read(record, frozenset(tape.pinned), tuple(self.raised))

    def _leaf(self, name: str, shape: Shape) -> Array:
        leaf = self.tape.add("leaf", (), shape, ("p", name))
        leaf.fixed = True
        return leaf

    def _way(self, run: Callable[[], Any]) -> list[Any]:
        """Return what one way gives, for each port; NaN where it raises."""
        tape, found = self.tape, None
        try:
            with borrowed(self.spaces), reading_on(tape):
                found = _by_port(tape, self.role, run(), self.out)
        except (Borrowed, BlockError):
            raise
        except (*RAISED, RuntimeError, Outside) as error:
            if isinstance(error, RecursionError):
                raise Unread(f"{_name(self.function)} calls itself without end") from None
            tape.ended(error)
            sentence = f"{located(error, self.function)}{type(error).__name__}: {error}"
            self.raised[sentence] = None
            if not tape.answers and tape.stopped is None:
                raise Unread(sentence) from None
            found = [_filled(tape, nan, shape) for shape in self.out.values()]
        except Unread as error:
            raise Unread(f"{located(error, self.function)}{error}") from None
        except Exception as error:
            if tape.stopped is None:
                said = f"{type(error).__name__}: {error}"
                raise Unread(f"{located(error, self.function)}{said}") from None
        if tape.stopped is not None:  # and the function went on
            raise tape.stopped
        return found or []


def _name(function: Any) -> str:
    return getattr(function, "__name__", type(function).__name__)


def record_of_states(shapes: Mapping[str, Shape]) -> Record:
    """Return the record of y = x: the outputs are the states."""
    tape = Tape()
    leaves = [tape.add("leaf", (), shape, ("x", port)) for port, shape in shapes.items()]
    return compact(tape.operations, [operand(one) for one in leaves], shapes.values())


def _joined(tape: Tape, ways: list, depth: int) -> list[Any]:
    """Join what the ways return by the questions that tell them apart."""
    if len(ways) == 1:
        return ways[0][1]
    question = list(ways[0][0])[depth]
    yes = [way for way in ways if way[0][question]]
    no = [way for way in ways if not way[0][question]]
    if not no or not yes:
        return _joined(tape, yes or no, depth + 1)
    condition = Array(tape, question, ())
    pairs = zip(_joined(tape, yes, depth + 1), _joined(tape, no, depth + 1), strict=True)
    return [a if operand(a) == operand(b) else where(condition, a, b) for a, b in pairs]


def _filled(tape: Tape, value: float, shape: Shape) -> Any:
    if all(isinstance(n, int) for n in shape):
        return lifted(tape, np.full(shape, value))
    return tape.add("fill", (value,), shape)


def _by_port(tape: Tape, role: str, given: Any, out: Mapping[str, Shape]) -> list[Any]:
    """Return what a function returned, for each port."""
    if isinstance(given, Mapping):
        if given.keys() != out.keys():
            raise BlockError(f"{role}: returns {list(given)}; must return {list(out)}")
        return [_shaped(tape, role, port, given[port], shape) for port, shape in out.items()]
    if isinstance(given, list | tuple):
        numbers = [one for part in given for one in _elements(part)]
    elif len(out) == 1 and getattr(given, "shape", None) == next(iter(out.values())):
        return [as_number(given)]
    else:
        numbers = list(objects(given).ravel())
    size = sum(map(prod, out.values()))
    if len(numbers) != size:
        raise BlockError(f"{role}: returns {len(numbers)} numbers; must return {size}")
    found, at = [], 0
    for shape in out.values():
        if len(shape) == 1 and shape[0]:
            row = numbers[at : at + shape[0]]
            found.append(stacked(tape, [as_number(lifted(tape, one)) for one in row]))
            at += shape[0]
            continue
        part = np.empty(prod(shape), dtype=object)
        part[:] = numbers[at : at + prod(shape)]
        found.append(packed(tape, part.reshape(shape)))
        at += prod(shape)
    return found


def _elements(part: Any) -> Iterable[Any]:
    if isinstance(part, float) or (isinstance(part, Array) and not part.shape):
        return (part,)
    return objects(part).ravel()


def _shaped(tape: Tape, role: str, port: str, given: Any, shape: Shape) -> Any:
    value = as_number(lifted(tape, given))
    own = getattr(value, "shape", ())
    if own == shape:
        return value
    if own == ():
        return _filled(tape, value, shape) if type(value) is float else _spread(value, shape)
    if (
        all(isinstance(n, int) for n in (*own, *shape))
        and prod(own) == prod(shape)
        and own
        in (
            (1,),
            (prod(shape),),
        )
    ):
        return packed(tape, objects(value).reshape(shape))
    raise BlockError(f"{role}: returns {port} of shape {own}; must be {shape}")


def _spread(value: Array, shape: Shape) -> Array:
    return value.tape.add("fill", (value.ref,), shape)
