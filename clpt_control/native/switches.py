"""Switches: the times at which time alone decides, found before a run.

A run begins anew where time alone decides: a pulse, a gust, a tide that turns, a carrier that
another block compares.  Where states decide, machine code finds the crossing as it goes
(`decisions`); a pulse of time might begin and end within one of its steps.
"""

from itertools import pairwise
from math import prod
from typing import Any

import numpy as np

from ..equations.at_many import rows
from ..equations.derivative import STEPS
from ..equations.record import Operation, Record, Ref, compact, reached
from ..progress import warn
from .decisions import LOCKED, QUESTIONS, operands

LOOKS = 1_024, 4_096  # times between which one change is looked for: both find the same
PARTS, DEEP = 8, 4  # where they do not, parts of the time are looked at by themselves
GOLDEN = (5**0.5 - 1.0) / 2.0
LEAST = 2.0**-80  # of the span: from t = 0 on there are a thousand powers of 2 to the next number
CUTS, MANY = 64, 256  # parts of the piece in which a change is, each time; of many, halves


def timed_decisions(record: Any) -> dict[int, Record]:
    """Return what time alone decides in a diagram's rates, by block: constant between changes.

    `record` is a `DiagramRecord` whose decisions are not locked yet; leaves of what is returned are
    (array, (first place, shape)).
    """
    layout, groups = record.layout, list[set[str]]()  # what each entry depends on
    pieces = {*layout.intervals.values(), *layout.jumps.values()}  # of P, other in other pieces
    lines, decisions = list[Operation](), dict[int, list[Ref]]()
    for kind, arguments, shape, at in record.entries:
        own = set[str]()
        if kind == "load":
            array, first = at
            piece = array == "P" and (first in pieces or first >= len(layout.P))
            kind, at, own = "leaf", (array, (first, shape)), {"X" if piece else array}
        groups.append(own.union(*(groups[a] for a in arguments if type(a) is int)))
        lines.append(Operation(kind, arguments, shape, at[0] if kind == "sum" else at))
    for k in sorted(reached(record.entries, [port.ref for port in record.rates])):
        kind, arguments, shape, _ = lines[k]
        timed = "t" in groups[k] and "X" not in groups[k]
        if timed and kind in (STEPS | LOCKED):
            for name in (asked := QUESTIONS.get(kind, ())):
                lines.append(Operation(name, operands(kind, name, arguments), shape))
            places = range(len(lines) - len(asked), len(lines)) if asked else [k]
            decisions.setdefault(record.owners[k], []).extend(places)
    return {owner: compact(lines, places) for owner, places in decisions.items()}


class _Dense(Exception):
    """Time decides too often."""


def times_of_change(
    name: str, record: Record, arrays: dict[str, np.ndarray], t0: float, t1: float
) -> np.ndarray:
    """Return the times in (t0, t1) at which what a block decides by time alone jumps or bends."""

    def decided_at(t: np.ndarray) -> np.ndarray:
        def leaf(array: str, where: tuple[int, tuple[int, ...]]) -> np.ndarray:
            first, shape = where
            if array == "t":
                return t
            return arrays[array][first : first + prod(shape)].reshape(*shape, 1)

        return rows(record, leaf, {}, len(t))

    def seen(count: int, begin: float, end: float) -> tuple[np.ndarray, ...]:
        """Return which decisions change between two times, and these; no period divides them."""
        k = np.arange(count)
        times = begin + (end - begin) * (k + 0.5 * (k * GOLDEN % 1.0) * (k < count - 1)) / k[-1]
        values = decided_at(times)
        old, new = values[:, :-1], values[:, 1:]
        which, at = np.nonzero((new != old) & ~np.isnan(new + old))
        return which, times[at], times[at + 1]

    def found(begin: float, end: float, depth: int) -> list[tuple[np.ndarray, ...]]:
        few, many = (seen(count, begin, end) for count in LOOKS)
        if len(few[0]) == len(many[0]):
            return [many]
        if not depth:
            warn(
                f"{name}: time decides so often from t = {begin:.9g} on that not every "
                "switch is met; run a shorter time"
            )
            raise _Dense
        edges = np.linspace(begin, end, PARTS + 1)
        return [one for a, b in pairwise(edges) for one in found(a, b, depth - 1)]

    try:
        which, low, high = map(np.concatenate, zip(*found(t0, t1, DEEP), strict=True))
    except _Dense:
        return np.zeros(0)
    each, parts = np.arange(len(which)), CUTS if len(which) < MANY else 2
    while np.any(np.maximum(np.nextafter(low, np.inf), low + LEAST * (t1 - t0)) < high):
        cuts = np.linspace(low, high, parts + 1)
        values = decided_at(cuts.ravel()).reshape(-1, *cuts.shape)[which, :, each]
        first = np.argmax(values[:, 1:] != values[:, :1], axis=1)
        low, high = cuts[first, each], cuts[first + 1, each]
    changes = np.unique([low, high])  # the last time before a change, and the first after
    return changes[(changes > t0) & (changes < t1)]
