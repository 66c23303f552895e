"""Read a function: run it on arrays without values, and keep the record.

    f(t, x, u, p)  ->  what each port is, as operations on t, the ports of x and u, the fields of p

A question (``if u[0] > 0``) is answered both ways: the function runs again with the other
answer, and what the ways return is joined by `where`.  A way that raises is NaN.
"""

from collections.abc import Callable, Mapping
from math import nan, prod
from typing import Any

import numpy as np

from ..errors import BlockError
from .arrays import Array, Tape, Unread, as_number, lifted, operand, packed, where
from .numpy_functions import objects
from .record import Record, Ref, Shape, compact, reached

MOST_WAYS = 256
RAISED = (ArithmeticError, IndexError, ValueError, AssertionError)  # of numbers; such a way is NaN


class Reading(Tape):
    """A tape with the answers that this way through the function takes."""

    def __init__(self, parameters: Mapping[str, Any]) -> None:
        super().__init__()
        self.parameters = parameters
        self.pinned: set[str] = set()  # parameters whose value Python asked for
        self.way: list[bool] = []
        self.answers: dict[int, bool] = {}

    def question(self, ref: Ref) -> bool:
        """Answer a condition: as this way says, or by the parameters if they decide."""
        if type(ref) is float:
            return bool(ref)
        known = self.value_of(ref)
        if known is not None:
            return bool(known)
        if ref not in self.answers:
            k = len(self.answers)
            self.answers[ref] = self.way[k] if k < len(self.way) else True
        return self.answers[ref]

    def number(self, ref: Ref) -> float:
        """Return what Python asks for; only parameters have a value."""
        known = self.value_of(ref)
        if known is None:
            raise Unread("asking for the value of a signal")
        return float(known)

    def value_of(self, ref: Ref) -> Any:
        """Return the value of what depends on parameters alone, which are then pinned."""
        if type(ref) is float:
            return ref
        used = reached(self.operations, [ref])
        leaves = [self.operations[k].at for k in used if self.operations[k].kind == "leaf"]
        if any(group != "p" for group, _ in leaves):
            return None
        self.pinned |= {name for _, name in leaves}
        record = compact(self.operations, [ref])
        return record.values(lambda group, name: self.parameters[name], {})[0]


class Ports(Array):
    """States or inputs without values: a vector, with its ports as views."""

    __slots__ = ("_node", "ports")

    def __init__(self, tape: Tape, group: str, shapes: Mapping[str, Shape]):
        self.ports = {
            port: tape.add("leaf", (), shape, (group, port)) for port, shape in shapes.items()
        }
        known = all(isinstance(n, int) for shape in shapes.values() for n in shape)
        size: Any = sum(map(prod, shapes.values())) if known else f"len({group})"
        self._node: int | None = None
        super().__init__(tape, -1, (size,))

    @property
    def node(self) -> int:  # type: ignore[override]
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
) -> tuple[Record, set[str]]:
    """Return the record of a function and the parameters whose values it is made with.

    Raises `Unread` where it cannot be read.
    """
    tape = Reading(parameters)
    t = tape.add("leaf", (), (), ("t", "t"))
    fields = {
        name: tape.add("leaf", (), shapes[name], ("p", name)) if name in shapes else value
        for name, value in parameters.items()
    }
    ways: list[tuple[dict[int, bool], list[Any]]] = []
    while True:
        tape.answers = {}
        x, u = Ports(tape, "x", states), Ports(tape, "u", inputs)
        try:
            given = function(t, x, u, Fields(fields))
            found = _by_port(tape, role, given, out)
        except RAISED as error:
            if not tape.answers:
                raise Unread(f"{type(error).__name__}: {error}") from error
            found = [_filled(tape, nan, shape) for shape in out.values()]
        ways.append((tape.answers, found))
        if len(ways) > MOST_WAYS:
            raise Unread(f"more than {MOST_WAYS} ways through its questions")
        way = list(tape.answers.values())
        while way and not way[-1]:
            way.pop()
        if not way:
            break
        tape.way = [*way[:-1], False]
    outputs = [operand(one) for one in _joined(tape, ways, 0)]
    return compact(tape.operations, outputs, out.values()), tape.pinned


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
        numbers = [one for part in given for one in objects(part).ravel()]
    elif len(out) == 1 and getattr(given, "shape", None) == next(iter(out.values())):
        return [given]
    else:
        numbers = list(objects(given).ravel())
    size = sum(map(prod, out.values()))
    if len(numbers) != size:
        raise BlockError(f"{role}: returns {len(numbers)} numbers; must return {size}")
    found, at = [], 0
    for shape in out.values():
        part = np.empty(prod(shape), dtype=object)
        part[:] = numbers[at : at + prod(shape)]
        found.append(packed(tape, part.reshape(shape)))
        at += prod(shape)
    return found


def _shaped(tape: Tape, role: str, port: str, given: Any, shape: Shape) -> Any:
    value = as_number(lifted(tape, given))
    own = getattr(value, "shape", ())
    if own == shape:
        return value
    if own == ():
        return _filled(tape, value, shape) if type(value) is float else _spread(value, shape)
    if all(isinstance(n, int) for n in (*own, *shape)) and prod(own) == prod(shape) and own in (
        (1,),
        (prod(shape),),
    ):
        return packed(tape, objects(value).reshape(shape))
    raise BlockError(f"{role}: returns {port} of shape {own}; must be {shape}")


def _spread(value: Array, shape: Shape) -> Array:
    return value.tape.add("fill", (value.ref,), shape)
