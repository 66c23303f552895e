"""Arrays that are put together of parts: many numbers that were made alike are few arrays.

A loop over elements makes one tree of operations again and again, whose leaves follow each other,

    for i in range(1, n - 1):
        dx[i] = k * (x[i + 1] - 2 * x[i] + x[i - 1])        k * (x[2:] - 2 * x[1:-1] + x[:-2])

and what NumPy itself fills, rolls or pads is views of single places.  An array of more than `LONG`
such numbers is written down as operations on arrays, joined; each number is that of the loop.
"""

from collections.abc import Sequence
from itertools import groupby, pairwise
from math import prod
from operator import itemgetter, ne
from typing import Any

import numpy as np

from ..trace.arrays import HOOKS, Tape, objects, operand
from ..trace.elementwise import constant, lifted, stacked
from ..trace.views import LONG, part, tape_of, tape_viewed
from .graph import OPERATIONS, Ref, Shape, deep, key_of

FEW = 8  # numbers that are made alike, fewer stay as they are
IN_TURN = 6  # the most kinds of numbers that follow each other in turn, as x and v of many masses


def stack(parts: Any, axis: int = 0, **more: Any) -> Any:
    """Return np.stack(parts)."""
    tape = tape_of(parts)
    new = stacked(tape, [lifted(tape, p) for p in parts])
    return np.moveaxis(new, 0, axis) if axis else new


def join(parts: Any, axis: Any = 0, **more: Any) -> Any:
    """Return np.concatenate(parts)."""
    tape = tape_of(parts)
    arrays = [p for p in (lifted(tape, p) for p in parts) if p.shape != (0,)]
    known = all(isinstance(n, int) for p in arrays for n in p.shape)
    if known and axis is not None and any(prod(p.shape) > LONG for p in arrays):
        first = [np.moveaxis(p, axis, 0) for p in arrays]
        shape = (sum(p.shape[0] for p in first), *first[0].shape[1:])
        joined = tape.add("join", [operand(p) for p in first], shape)
        return np.moveaxis(joined, 0, axis) if axis else joined
    return lifted(tape, np.concatenate([objects(p) for p in arrays], axis=axis))


def stack_of(tape: Tape, refs: Sequence[Ref], shape: Shape) -> Any:
    """Return the array whose elements are these, each of a shape."""
    if (seen := _following(tape, refs)) is not None:
        return seen
    known = all(isinstance(n, int) for n in shape)
    if known and len(refs) * prod(shape) > LONG:
        with deep():
            return _gathered(tape, refs, shape)
    return _stacked(tape, refs, shape)


def _stacked(tape: Tape, refs: Sequence[Ref], shape: Shape) -> Any:
    return tape.add("stack", refs, (len(refs), *shape))


def _following(tape: Tape, refs: Sequence[Ref]) -> Any:
    """Return the view of an array whose elements follow each other in a stack, or None."""
    lines = [tape.operations[ref] for ref in refs if type(ref) is int]
    views = [line for line in lines if line.kind == "view"]
    if len(views) < max(2, len(refs)) or len({line.arguments for line in views}) > 1:
        return None
    maps = [line.at for line in views]
    varying = [d for d in range(len(maps[0])) if len({m[d] for m in maps}) > 1]
    places = [m[d] for m in maps for d in varying]
    if len(varying) != 1 or not all(isinstance(p, int) for p in places):
        return None
    step = places[1] - places[0]
    if step < 1 or any(b - a != step for a, b in pairwise(places)):
        return None
    mapped = tuple(
        (0, places[0], step) if k in varying else p if isinstance(p, int) else (p[0] + 1, *p[1:])
        for k, p in enumerate(maps[0])
    )
    return tape_viewed(tape, views[0].arguments[0], mapped, (len(refs), *views[0].shape))


def _trees(tape: Tape, refs: Sequence[Ref]) -> list[int]:
    """Return of each value a number that all have which are made alike."""
    trees = tape.trees
    for k in range(len(trees), len(tape.operations)):
        kind, arguments, shape, at = tape.operations[k]
        key: tuple = ("", k)
        if kind in OPERATIONS or kind in ("stack", "sum", "pick", "search"):
            key = kind, shape, at, *(trees[a] if type(a) is int else -1 for a in arguments)
        elif kind == "view":
            key = kind, shape, arguments, *(None if isinstance(m, int) else m for m in at)
        elif kind == "constant":
            key = kind, shape
        trees.append(tape.kinds.setdefault(key, len(tape.kinds)))
    return [trees[ref] if type(ref) is int else -1 for ref in refs]


def _in_turn(trees: list[int]) -> int:
    """Return how many kinds of numbers follow each other in turn; 1 where each follows its own."""
    counts = [n for n in range(1, IN_TURN + 1) if len(trees) % n == 0 and len(trees) >= n * FEW]
    return min(counts, key=lambda n: sum(map(ne, trees, trees[n:])), default=1)


def _gathered(tape: Tape, refs: Sequence[Ref], shape: Shape) -> Any:
    """Return a stack as few arrays, where numbers one behind the other are made alike."""
    trees, pieces = _trees(tape, refs), list[Any]()
    if (count := _in_turn(trees)) > 1:
        rows = _turned(tape, [refs[k::count] for k in range(count)], shape)
        return part(rows, lambda a: np.reshape(a, (len(refs), *shape)))
    alone: list[Ref] = []  # of no array yet

    def flush() -> None:
        if alone:
            pieces.append(_stacked(tape, alone, shape))
            alone.clear()

    for _, group in groupby(zip(trees, refs, strict=True), itemgetter(0)):
        same = [ref for _, ref in group]
        while same:
            count, made = _alike(tape, same, shape) if len(same) >= FEW else (len(same), None)
            if made is None:
                alone += same[:count]
            else:
                flush()
                pieces.append(made)
            del same[:count]
    flush()
    if len(pieces) == 1:
        return pieces[0]
    return tape.add("join", [operand(piece) for piece in pieces], (len(refs), *shape))


def _alike(tape: Tape, refs: list[Ref], shape: Shape) -> tuple[int, Any]:
    """Return how many of these, all made alike, are one array, and that; None if they are none."""
    n, first = len(refs), refs[0]
    if type(first) is float:
        return n, constant(tape, np.array(refs))
    kind, _, _, at = tape.operations[first]
    if kind == "view":
        return _run(tape, refs, shape)
    if refs.count(first) == n:
        return (n, None) if shape or tape.truth[first] else (n, tape.add("fill", (first,), (n,)))
    columns = [*zip(*(tape.operations[ref].arguments for ref in refs), strict=True)]
    if kind == "stack":
        return n, _turned(tape, columns, shape[1:])
    if kind == "constant":
        rows = [np.frombuffer(tape.operations[ref].at).reshape(shape) for ref in refs]
        return n, constant(tape, np.stack(rows))
    own: list[Ref] = []
    for column in columns:
        if len(set(map(key_of, column))) == 1:
            own.append(column[0])
        else:
            of = tape.operations[column[0]].shape if type(column[0]) is int else ()
            if len(of) != len(shape) and kind != "sum":
                return n, None
            own.append(operand(_gathered(tape, column, of)))
    return n, tape.add(kind, own, (n, *shape), at + 1 if kind == "sum" else at)


def _turned(tape: Tape, columns: Sequence[Sequence[Ref]], shape: Shape) -> Any:
    """Return rows of numbers by their columns."""
    gathered = [operand(_gathered(tape, column, shape)) for column in columns]
    left = sum(type(one) is int and tape.operations[one].kind == "stack" for one in gathered)
    make = _stacked if left >= FEW else _gathered  # which would turn these back, without end
    whole = make(tape, gathered, (len(columns[0]), *shape))
    return part(whole, lambda a: np.swapaxes(a, 0, 1))


def _run(tape: Tape, refs: list[Ref], shape: Shape) -> tuple[int, Any]:
    """Return how many of these views follow each other, or are one, and their array, if any."""
    places = [[m for m in tape.operations[ref].at if isinstance(m, int)] for ref in refs]
    steps = [np.subtract(b, a).tolist() for a, b in pairwise(places)]
    count = 1 + next((k for k, step in enumerate(steps) if step != steps[0]), len(steps))
    made = None
    if count >= FEW:
        if any(steps[0]):
            made = _following(tape, refs[:count])
        elif not shape and not tape.truth[refs[0]]:
            made = tape.add("fill", (refs[0],), (count,))
    return count if made is not None else max(1, count - 1), made


HOOKS.update(stack_of=stack_of)
