"""Ways through a function: what each of them gives is joined by the questions that it answers.

A helper that is given numbers, and reaches nothing that can change, is joined where it is called:

    limited(u) = where(u > 1, 1, where(u < -1, -1, u))

so eight thrusters with three ways each are 24 ways, and not 3^8.
"""

import functools
from collections.abc import Callable, Iterator
from types import FunctionType, NoneType
from typing import Any

import numpy as np

from .arrays import Array, Tape, Unread, active, key_of, operand
from .elementwise import chosen

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
