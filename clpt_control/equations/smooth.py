"""Where a record is not smooth: choices that signals make, and the times at which time decides.

A step of the solver that goes over a kink of the rates is off by more than its tolerance between
its ends.  Where states decide (``where``, ``minimum``, ``fabs``, ...) a run ends a step at every
sample; where time alone decides, at the times at which it does.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from .at_many import rows
from .block import Block
from .record import Operation, Record, Ref, Shape, compact

KINKED = frozenset(
    ("minimum", "maximum", "fabs", "sign", "floor", "ceil", "trunc", "mod", "floordiv", "pick")
)
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


def groups_of(record: Record) -> list[set[str]]:
    """Return for each operation the groups of leaves that it depends on."""
    found: list[set[str]] = []
    for kind, arguments, _, at in record.operations:
        own = {at[0]} if kind == "leaf" else set()
        found.append(own.union(*(found[a] for a in arguments if type(a) is int)))
    return found


def who_decides(record: Record) -> set[str]:
    """Return the groups of leaves on which choices and kinks depend: "x", "u", "t", "p"."""
    groups, found = groups_of(record), set[str]()
    for kind, arguments, _, _ in record.operations:
        deciding = arguments[:1] if kind == "where" else arguments if kind in KINKED else ()
        for a in deciding:
            if type(a) is int:
                found |= groups[a]
    return found


def decided_by_time(record: Record) -> Record:
    """Return what is constant in time between changes, where time alone decides."""
    lines, groups, found = list(record.operations), groups_of(record), list[Ref]()
    for k, (kind, arguments, shape, _) in enumerate(record.operations):
        if "t" not in groups[k] or groups[k] & {"x", "u"}:
            continue
        if kind in STEPS:
            found.append(k)
        elif kind in SIDES:
            lines.append(SIDES[kind](arguments, shape))
            found.append(len(lines) - 1)
    return compact(lines, found)


def times_of_change(block: Block, role: str, p: Any, t0: float, t1: float) -> np.ndarray:
    """Return the times in (t0, t1) at which what depends on time alone jumps or bends."""
    record = decided_by_time(block.array_record(role))

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


class Kinks(NamedTuple):
    """What of a block is not smooth: who decides, found once."""

    block: Block
    by_signals: bool  # whether states or inputs decide
    by_time: tuple[str, ...]  # functions in which time does

    def at(self, parameters: Any, t0: float, t1: float) -> np.ndarray:
        """Return the times in (t0, t1) at which time alone decides."""
        times = [times_of_change(self.block, role, parameters, t0, t1) for role in self.by_time]
        return np.unique(np.concatenate([np.zeros(0), *times]))


def kinks_of(block: Block) -> Kinks:
    """Return who decides what a block does."""
    roles = ("update", "output") if block.update_function is not None else ("output",)
    groups = {role: who_decides(block.array_record(role)) for role in roles}
    by_signals = any(own & {"x", "u"} for own in groups.values())
    return Kinks(block, by_signals, tuple(role for role, own in groups.items() if "t" in own))
