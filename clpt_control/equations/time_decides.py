"""The times at which time alone decides: a pulse, a gust, a tide that turns.

A run begins anew there.  Where signals decide, machine code finds the crossing as it goes
(`native.decisions`); a pulse of time might begin and end within one of its steps.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from .at_many import rows
from .block import Block
from .record import Operation, Record, Ref, Shape, compact

STEPS = frozenset(
    ("lt", "le", "gt", "ge", "eq", "ne", "floor", "ceil", "trunc", "sign", "floordiv")
)
SIDES: dict[str, Callable[[tuple, Shape], Operation]] = {  # which side of a kink, or which place
    "mod": lambda a, shape: Operation("floordiv", a, shape),
    "minimum": lambda a, shape: Operation("lt", a, shape),
    "maximum": lambda a, shape: Operation("lt", a, shape),
    "fabs": lambda a, shape: Operation("lt", (*a, 0.0), shape),
    "pick": lambda a, shape: Operation("trunc", a[1:], shape),
}
MOST = 2_000  # times at which time decides, in one function
LOOKS = 4_096  # evenly spaced times between which one change is looked for
HALVINGS = 64


def decided_by_time(block: Block) -> list[Record]:
    """Return what time alone decides in a block's functions: constant between changes."""
    found = []
    for role in ("update", "output") if block.update_function is not None else ("output",):
        record = _decided(block.array_record(role))
        if record.outputs:
            found.append(record)
    return found


def _decided(record: Record) -> Record:
    lines, groups, found = list(record.operations), list[set[str]](), list[Ref]()
    for k, (kind, arguments, shape, at) in enumerate(record.operations):
        own = {at[0]} if kind == "leaf" else set()
        groups.append(own.union(*(groups[a] for a in arguments if type(a) is int)))
        if "t" not in groups[k] or groups[k] & {"x", "u"}:
            continue
        if kind in STEPS:
            found.append(k)
        elif kind in SIDES:
            lines.append(SIDES[kind](arguments, shape))
            found.append(len(lines) - 1)
    return compact(lines, found)


def times_of_change(block: Block, record: Record, p: Any, t0: float, t1: float) -> np.ndarray:
    """Return the times in (t0, t1) at which what depends on time alone jumps or bends."""

    def seen_at(t: np.ndarray) -> np.ndarray:
        def leaf(group: str, name: str) -> np.ndarray:
            return t if group == "t" else np.asarray(getattr(p, name), dtype=float)[..., None]

        return rows(record, leaf, block.sizes, len(t))

    times = np.linspace(t0, t1, LOOKS)
    seen = seen_at(times)
    which, at = np.nonzero((seen[:, 1:] != seen[:, :-1]) & ~np.isnan(seen[:, 1:] + seen[:, :-1]))
    if not len(at) or len(at) > MOST:
        return np.zeros(0)
    low, high, before = times[at], times[at + 1], seen[which, at]
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        same = seen_at(middle)[which, np.arange(len(at))] == before
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    found = np.unique([low, high])  # the last time before a change, and the first after
    return found[(found > t0) & (found < t1)]
