"""A block's equations at many times, states and inputs at once; the times at which time decides.

A run begins anew where time alone decides: a pulse, a gust, a tide that turns.  Where signals
decide, machine code finds the crossing as it goes (`native.decisions`); a pulse of time might begin
and end within one of its steps.
"""

from collections.abc import Callable, Mapping
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..arguments import numbers, public
from ..errors import ArgumentError
from ..progress import warn
from .arrays import COMPARISONS
from .block import Block
from .declaration import places
from .derivative import JUMPS
from .record import Operation, Record, Ref, Shape, compact, computed

STEPS = COMPARISONS | JUMPS
SIDES: dict[str, Callable[[tuple, Shape], Operation]] = {  # which side of a kink, or which place
    "mod": lambda a, shape: Operation("floordiv", a, shape),
    "minimum": lambda a, shape: Operation("lt", a, shape),
    "maximum": lambda a, shape: Operation("lt", a, shape),
    "fabs": lambda a, shape: Operation("lt", (*a, 0.0), shape),
    "pick": lambda a, shape: Operation("trunc", a[1:], shape),
}
LOOKS = 1_024, 4_096  # times between which one change is looked for: both find the same
PARTS, DEEP = 8, 4  # where they do not, parts of the time are looked at by themselves
GOLDEN = (5**0.5 - 1.0) / 2.0
CUTS, MANY = 64, 256  # parts of the piece in which a change is, each time; of many, halves


def leaf_values(block: Block, t: Any, x: Any, u: Any, p: Any) -> Callable[[str, str], np.ndarray]:
    """Return the function (group, name) -> array of a leaf; more axes, such as times, are last."""
    where = {"x": (x, places(block.state_shapes)), "u": (u, places(block.input_shapes))}

    def leaf(group: str, name: str) -> np.ndarray:
        if group in ("t", "p"):
            return np.asarray(t if group == "t" else getattr(p, name), dtype=float)
        values, ports = where[group]
        part, shape = ports[name]
        return values[part].reshape((*shape, *values.shape[1:]))

    return leaf


def on_arrays(block: Block, role: str, t: Any, x: Any, u: Any, p: Any = None) -> np.ndarray:
    """Return what a function gives at each time, state x[k] and input u[k]: (size, ...).

    Its parameters are the block's, or those given; their `interval` may be one for each time.
    """
    shape = np.broadcast_shapes(np.shape(t), np.shape(x)[1:], np.shape(u)[1:])
    count = int(np.prod(shape))
    x, u = (np.broadcast_to(v, (len(v), *shape)).reshape(len(v), count) for v in (x, u))
    times = np.broadcast_to(t, shape).reshape(count)
    leaf = leaf_values(block, times, x, u, block.parameters if p is None else p)

    def at_each_time(group: str, name: str) -> np.ndarray:
        value = leaf(group, name)
        same = group == "p" and not (name == "interval" and value.ndim)
        return value[..., None] if same else value

    return rows(block.array_record(role), at_each_time, block.sizes, count).reshape((-1, *shape))


def rows(record: Record, leaf: Callable, sizes: Mapping[str, int], count: int) -> np.ndarray:
    """Return the outputs of a record as rows of `count`; its leaves have one more axis."""
    outputs = computed(record, leaf, sizes)
    flat = [np.broadcast_to(y, (*y.shape[:-1], count)).reshape(-1, count) for y in outputs]
    return np.concatenate([np.zeros((0, count)), *flat])


@public
def evaluate(block: Block, timepts: ArrayLike, inputs: ArrayLike) -> np.ndarray:
    """Compute a static block's outputs at many times and inputs.

    Parameters
    ----------
    block : Block
        Without states, such as ``basis_x``, Eq. (5), or ``true_flow`` of a gridded field.
    timepts : array_like, shape (n,) or a number
        In the block's unit.
    inputs : array_like, shape (n, ninputs)
        Such as places, in the block's unit.

    Returns
    -------
    ndarray, shape (n, noutputs)
        One row per sample.

    Examples
    --------
    >>> from clpt_control.blocks.flow import flow_basis
    >>> p = np.zeros((1, 2)), np.ones(1), np.zeros(1), np.zeros(1)
    >>> evaluate(flow_basis("basis_x", "x", "gaussian", *p), [0, 5], [[0, 0], [1, 1]]).round(3)
    array([[1.   ],
           [0.368]])
    """
    u, t = np.atleast_2d(numbers("inputs", inputs, block.ninputs)), numbers("timepts", timepts)
    if u.ndim > 2 or t.shape not in ((), (1,), u.shape[:1]):
        raise ArgumentError(
            f"evaluate: timepts has shape {t.shape}, inputs {u.shape}; must be a time, or n "
            f"of them, and (n, {block.ninputs})"
        )
    t = np.broadcast_to(t, len(u))
    return on_arrays(block, "output", t, np.zeros((0, len(t))), u.T).T


def decided_by_time(block: Block) -> list[Record]:
    """Return what time alone decides in a block's functions: constant between changes."""
    roles = ("update", "output") if block.update_function is not None else ("output",)
    records = [_decided(block.array_record(role)) for role in roles]
    return [record for record in records if record.outputs]


def _decided(record: Record) -> Record:
    lines, groups, decisions = list(record.operations), list[set[str]](), list[Ref]()
    for k, (kind, arguments, shape, at) in enumerate(record.operations):
        own = {at[0]} if kind == "leaf" else set()
        groups.append(own.union(*(groups[a] for a in arguments if type(a) is int)))
        if "t" not in groups[k] or groups[k] & {"x", "u"}:
            continue
        if kind in STEPS:
            decisions.append(k)
        elif kind in SIDES:
            lines.append(SIDES[kind](arguments, shape))
            decisions.append(len(lines) - 1)
    return compact(lines, decisions)


class _Dense(Exception):
    """Time decides too often."""


def times_of_change(block: Block, record: Record, p: Any, t0: float, t1: float) -> np.ndarray:
    """Return the times in (t0, t1) at which what depends on time alone jumps or bends."""

    def decided_at(t: np.ndarray) -> np.ndarray:
        def leaf(group: str, name: str) -> np.ndarray:
            return t if group == "t" else np.asarray(getattr(p, name), dtype=float)[..., None]

        return rows(record, leaf, block.sizes, len(t))

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
                f"{block.name}: time decides so often from t = {begin:.9g} on that not every "
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
    while np.any(np.nextafter(low, np.inf) < high):
        cuts = np.linspace(low, high, parts + 1)
        values = decided_at(cuts.ravel()).reshape(-1, *cuts.shape)[which, :, each]
        first = np.argmax(values[:, 1:] != values[:, :1], axis=1)
        low, high = cuts[first, each], cuts[first + 1, each]
    changes = np.unique([low, high])  # the last time before a change, and the first after
    return changes[(changes > t0) & (changes < t1)]
