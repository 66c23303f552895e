"""Where a record is not smooth: choices that signals make, and the times at which time decides.

A step of the solver that goes over a kink of the rates is off by more than its tolerance between
its ends.  Where states decide (``where``, ``minimum``, ``fabs``, ...) a run ends a step at every
sample; where time alone decides, at the times at which it does.
"""

from typing import Any

import numpy as np

from .block import Block
from .numbers import OPERATIONS, picked
from .record import Record
from .scalars import Scalars

KINKED = frozenset(
    ("minimum", "maximum", "fabs", "sign", "floor", "ceil", "trunc", "mod", "floordiv", "pick")
)
COMPARED = frozenset(("lt", "le", "gt", "ge", "eq", "ne"))
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


def times_of_change(scalars: Scalars, parameters: Any, t0: float, t1: float) -> np.ndarray:
    """Return the times in (t0, t1) at which what depends on time alone jumps or bends."""
    times = np.linspace(t0, t1, LOOKS)
    seen = _decided(scalars, parameters, times)
    if not len(seen):
        return np.zeros(0)
    which, at = np.nonzero((seen[:, 1:] != seen[:, :-1]) & ~np.isnan(seen[:, 1:] + seen[:, :-1]))
    if not len(at) or len(at) > MOST:
        return np.zeros(0)
    low, high, before = times[at], times[at + 1], seen[which, at]
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        same = _decided(scalars, parameters, middle)[which, np.arange(len(at))] == before
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    found = np.unique([low, high])  # the last time before a change, and the first after
    return found[(found > t0) & (found < t1)]


def _decided(scalars: Scalars, parameters: Any, t: np.ndarray) -> np.ndarray:
    """Return what is decided by time alone at times: rows that are constant between changes."""
    values: list[Any] = []
    rows: list[Any] = []
    by_time: list[bool] = []
    with np.errstate(all="ignore"):
        for name, *arguments in scalars.operations:
            if name in ("x", "u", "p", "t"):
                own: Any = t if name == "t" else None
                if name == "p":
                    own = np.ravel(getattr(parameters, arguments[0]))[arguments[1]]
                values.append(own)
                by_time.append(name == "t")
                continue
            given = [values[a] if type(a) is int else a for a in arguments]
            deciding = any(by_time[a] for a in arguments if type(a) is int)
            unknown = any(one is None for one in given)
            by_time.append(deciding and not unknown)
            if unknown:
                values.append(None)
                continue
            if deciding:
                rows += _rows(name, given)
            values.append(_value(name, given, parameters))
    return np.array([np.broadcast_to(row, t.shape) for row in rows], dtype=float)


def _rows(name: str, given: list[Any]) -> list[Any]:
    if name in COMPARED or name in ("floor", "ceil", "trunc", "sign", "floordiv"):
        return [OPERATIONS[name](*given)]
    if name == "mod":
        return [np.floor_divide(*given)]
    if name in ("minimum", "maximum"):
        return [np.less(*given)]
    if name == "fabs":
        return [given[0] < 0]
    return [np.trunc(given[0])] if name in ("pick", "table") else []


def _value(name: str, given: list[Any], parameters: Any) -> Any:
    if name == "pick":
        return picked(np.asarray(given[1:], dtype=float), given[0])
    if name == "table":
        field, first, stride, count = given[1]
        row = np.ravel(getattr(parameters, field))[first : first + stride * count : stride]
        return picked(row, given[0])
    return given[1] if name == "opaque" else OPERATIONS[name](*given)


def kinks_of(block: Block, parameters: Any, t0: float, t1: float) -> tuple[bool, np.ndarray]:
    """Return whether states or inputs decide what a block does, and when time alone decides."""
    times, by_signals = [np.zeros(0)], False
    for role in ("update", "output"):
        if role == "update" and block.update_function is None:
            continue
        groups = who_decides(block.array_record(role))
        by_signals |= bool(groups & {"x", "u"})
        if "t" in groups:
            scalars = block.update_record if role == "update" else block.output_record
            assert scalars is not None
            times.append(times_of_change(scalars, parameters, t0, t1))
    return by_signals, np.unique(np.concatenate(times))
