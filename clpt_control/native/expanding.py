"""Loops that were found, expanded again turn by turn: they must give the record.

Expressions are compared as numbers: equal ones are one number in both.
"""

from collections.abc import Iterable
from math import copysign
from typing import Any

from ..blocks.record import Record
from .places import Constant, Place, Rolled, Run
from .program import Step, Store


def recorded(record: Record, known: dict) -> list:
    """Return the expressions that a record leaves, numbered."""

    def name(*key: Any) -> int:
        return known.setdefault(key, len(known))

    def told(a: Any) -> Any:
        return name("constant", a, copysign(1.0, a)) if type(a) is float else a

    def apply(operation: str, *arguments: Any) -> int:
        return name(operation, *map(told, arguments))

    return [told(value) for value in record.replay(name, apply)]


def expanded(found: Rolled, size: int, known: dict) -> list:
    """Return the expressions that items leave, turn by turn."""
    memory: dict[tuple, int] = {}
    values: dict[int, int] = {}

    def name(*key: Any) -> int:
        return known.setdefault(key, len(known))

    def at(place: Place, turns: dict) -> tuple:
        return place.array, place.base + sum(step * turns[level] for level, step in place.steps)

    def told(a: Any, turns: dict) -> Any:
        if isinstance(a, Constant):
            return name("constant", *a)
        if isinstance(a, Run):
            field, first = at(a.place, turns)
            return field[1], first, a.stride, a.count
        if not isinstance(a, Place):
            return values[a]
        array, place = at(a, turns)
        if array == "K":
            number = found.constants[place]
            return name("constant", number, copysign(1.0, number))
        if array in ("S", "out"):
            return memory[array, place]
        return name("t") if array == "t" else name(*(array if array[0] == "p" else (array,)), place)

    def run(items: Iterable, turns: dict) -> None:
        for item in items:
            if isinstance(item, Step):
                values[item.value] = name(item.name, *(told(a, turns) for a in item.arguments))
            elif isinstance(item, Store):
                place = at(Place(item.array, item.base, item.steps), turns)
                memory[place] = told(item.value, turns)
            else:
                values.update({s.within: told(s.first, turns) for s in item.sums})
                for k in range(item.count):
                    run(item.body, {**turns, item.level: k})
                    values.update({s.within: values[s.turned] for s in item.sums})
                values.update({s.result: values[s.turned] for s in item.sums})

    run(found.items, {})
    return [memory.get(("out", k)) for k in range(size)]
