"""A record with its loops, and the record again: loops expanded turn by turn.

Arguments of a step are values, constants, places in arrays, and tables that `lookup` reads.
Arrays of a block's loops: t, x, u, ("p", field), out, K (constants) and S (what turns
compute and others read).  Expressions are compared as numbers: equal ones are one number.
"""

from collections.abc import Iterable
from math import copysign
from typing import Any, NamedTuple

from ..equations.scalars import Scalars
from .program import Step, Steps, Store


class Place(NamedTuple):
    """A number in an array, at a place affine in the turns of loops."""

    array: Any
    base: int
    steps: Steps = ()


class Constant(NamedTuple):
    """A number; 0.0 is not -0.0."""

    value: float
    sign: float


class Table(NamedTuple):
    """Numbers of a parameter that `lookup` reads, evenly spaced."""

    place: Place
    stride: int
    count: int  # type: ignore[assignment]


class Rolled(NamedTuple):
    """A record with its loops: steps, stores and loops; K; the length of S."""

    items: tuple
    constants: tuple[float, ...]
    room: int


def numbered(record: Scalars, known: dict) -> list[int]:
    """Return the expressions that a record leaves, numbered; `known` grows."""

    def number(*key: Any) -> int:
        return known.setdefault(key, len(known))

    def own(a: Any) -> Any:
        return number("constant", a, copysign(1.0, a)) if type(a) is float else a

    def apply(operation: str, *arguments: Any) -> int:
        return number(operation, *map(own, arguments))

    return [own(value) for value in record.replay(number, apply)]


def expanded(found: Rolled, size: int, known: dict) -> list[int | None]:
    """Return the `size` expressions that items leave, turn by turn, numbered alike."""
    memory: dict[tuple, int] = {}
    values: dict[int, int] = {}

    def number(*key: Any) -> int:
        return known.setdefault(key, len(known))

    def at(place: Place, turns: dict) -> tuple:
        return place.array, place.base + sum(step * turns[level] for level, step in place.steps)

    def argument(a: Any, turns: dict) -> Any:
        if isinstance(a, Constant):
            return number("constant", *a)
        if isinstance(a, Table):
            field, first = at(a.place, turns)
            return field[1], first, a.stride, a.count
        if not isinstance(a, Place):
            return values[a]
        array, place = at(a, turns)
        if array == "K":
            constant = found.constants[place]
            return number("constant", constant, copysign(1.0, constant))
        if array in ("S", "out"):
            return memory[array, place]
        if array == "t":
            return number("t")
        return number(*(array if array[0] == "p" else (array,)), place)

    def run(items: Iterable, turns: dict) -> None:
        for item in items:
            if isinstance(item, Step):
                values[item.value] = number(
                    item.name, *(argument(a, turns) for a in item.arguments)
                )
            elif isinstance(item, Store):
                place = at(Place(item.array, item.base, item.steps), turns)
                memory[place] = argument(item.value, turns)
            else:
                values.update({s.within: argument(s.first, turns) for s in item.sums})
                for k in range(item.count):
                    run(item.body, {**turns, item.level: k})
                    values.update({s.within: values[s.turned] for s in item.sums})
                values.update({s.result: values[s.turned] for s in item.sums})

    run(found.items, {})
    return [memory.get(("out", k)) for k in range(size)]
