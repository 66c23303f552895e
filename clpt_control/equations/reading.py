"""Read a function: run it on arrays without values, and keep the record.

    f(t, x, u, p)  ->  what each port is, as operations on t, the ports of x and u, the fields of p

A question (``if u[0] > 0``) is answered both ways: the function runs again with the other
answer, and what the ways return is joined by `where`.  A way that raises is NaN.  A signal that
Python counts with is asked which whole number it is, up to the first IndexError.  What is read
twice must be the same: else a state or chance hides in the function.
"""

from collections.abc import Callable, Iterable, Mapping
from math import nan, prod
from typing import Any, NamedTuple

import numpy as np

from ..errors import BlockError
from .arrays import (
    Array,
    Tape,
    Unread,
    as_number,
    lifted,
    objects,
    operand,
    reading_on,
    stacked,
    where,
)
from .copies import Copies, borrowed
from .given import Fields, Ports
from .questions import Borrowed, Outside, Reading, located
from .record import Record, Shape, compact

MOST_WAYS = 256
MOST_MODULES = 20  # into which stand-ins are put
RAISED = (ArithmeticError, IndexError, ValueError, AssertionError)  # of numbers; such a way is NaN


class Read(NamedTuple):
    """What reading a function gave."""

    record: Record
    pinned: frozenset[str]  # parameters with whose values it was made
    raised: tuple[str, ...] = ()  # what ways that are NaN raised


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
        leaf._fixed = True
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
        found.append(lifted(tape, part.reshape(shape)))
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
        return lifted(tape, objects(value).reshape(shape))
    raise BlockError(f"{role}: returns {port} of shape {own}; must be {shape}")


def _spread(value: Array, shape: Shape) -> Array:
    return value._tape.add("fill", (value._ref,), shape)
