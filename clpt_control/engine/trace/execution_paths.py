"""Execution paths through a function, and how their results are merged.

A condition on a signal (``if u[0] > 0``) is answered both ways: the code runs once per execution
path, a row of answers, and `where` joins what the paths return and write.  A called helper, an `if`
statement and a conditional expression are merged as soon as they end,

    limited(u) = where(u > 1, 1, where(u < -1, -1, u))

so eight thrusters with three paths each are 24 paths, and not 3^8.  An item of a list at an index
that is a signal, ``points[argmin(d)]``, is one `pick` and not a path for each item.
"""

import functools
from collections.abc import Callable, Iterable, Iterator
from types import FunctionType
from typing import Any

import numpy as np

from ..record.unread import Unread, active
from .arrays import Array, moves, operand
from .elementwise import (
    chosen,
    common,
    elementwise,
    in_a_try,
    is_of_python,
    is_whole,
    lifted,
)
from .heaps import Entry, Joining, NotMergeable, decision_tree, heap_of, put_back
from .views import tape_of

# paths of one helper or statement, and runs of all together
MOST_MERGED = 32
MOST_RUNS = 10_000
FEW_RUNS = 500  # before regions that cannot be merged are skipped
RAISED = (Exception, SystemExit)


def each_path(tape: Any) -> Iterator[None]:
    """Yield once for each path through the code that runs then, with the answers of this path."""
    before = dict(tape.answers)
    tape.way = [*before.values()]
    while True:
        tape.answers = dict(before)
        yield
        tape.runs += 1
        is_first_try = tape.failed and not tape.unmergeable
        if tape.runs > (FEW_RUNS if is_first_try else MOST_RUNS):
            raise Unread(
                f"has helpers in helpers, of more than {MOST_RUNS} execution paths"
            )
        outcomes = [*tape.answers.values()]
        while len(outcomes) > len(before) and not outcomes[-1]:
            outcomes.pop()
        if len(outcomes) == len(before):
            return
        tape.way = [*outcomes[:-1], False]


# --- one helper, statement or expression --------------------------------------------------------


def merging() -> Any:
    """Return the tape on which this thread traces a function and merges paths, or None."""
    tape: Any = active()
    return tape if tape is not None and tape.merging else None


def run_region(
    tape: Any, run: Callable[[], Any], roots: Iterable[Any], key: Any
) -> Any:
    """Run code on each of its paths; return one result, and leave one heap behind.

    The code may change what it reaches from `roots`, and nothing that outlives the function.  If
    heaps cannot be joined, the paths are those of the code around.  A region whose `key` is among
    the unmergeable ones is not tried.
    """
    if key in tape.unmergeable:
        return run()
    answers, way, texts = tape.answers, tape.way, tape.texts
    before: dict[int, Entry] = {}
    paths = list[Any]()  # of each: answers, result and heap
    try:
        before = heap_of(roots, tape.persistent)
        for _ in each_path(tape):
            if paths:
                put_back(before)
            result = run()
            if len(tape.answers) == len(answers):
                return result
            tape.check()
            left = (entry.value for entry in before.values())
            heap = heap_of((result, *left), tape.persistent)
            paths.append((tape.answers, result, heap))
            if len(paths) > MOST_MERGED:
                raise NotMergeable
        return _joined(tape, paths, len(answers), before)
    except NotMergeable:
        tape.failed.add(key)
    except RAISED:
        if tape.stopped is not None:
            raise
    finally:
        tape.answers, tape.way = answers, way
    tape.texts = texts
    put_back(before)
    return run()


def _joined(tape: Any, paths: Any, depth: int, before: dict) -> Any:
    """Return the result for all paths, and join what they leave behind."""
    answers, results, heaps = zip(*paths, strict=True)
    tree = decision_tree([*enumerate(answers)], depth)
    joining = Joining(tape, tree, before, heaps)
    result = joining.value(results)
    for entry in before.values():
        joining.value([entry.value] * len(paths))
    put_back(joining.contents)
    return result


def merge_calls(function: FunctionType) -> Any:
    """Return a function whose paths are merged at each call while a function is traced."""

    @functools.wraps(function, updated=())
    def helper(*arguments, **options):
        if (tape := merging()) is None:
            return function(*arguments, **options)
        values = (*arguments, *options.values())
        shapes = (getattr(value, "_shape", type(value)) for value in values)
        key = id(function.__code__), *shapes
        run = functools.partial(function, *arguments, **options)
        return run_region(tape, run, (function, *values), key)

    return helper


def merge_paths(run: FunctionType) -> Any:
    """Return the value of an expression, or run a statement, with its paths merged.

    It is a function of no arguments, whose variables are cells.
    """
    if (tape := merging()) is None:
        return _run(run)
    cells = run.__closure__ or ()
    return run_region(tape, lambda: _run(run), cells, id(run.__code__))


def _run(run: FunctionType) -> Any:
    """Run rewritten code, whose variables without a value are still local ones to the function."""
    try:
        return run()
    except NameError as error:
        if error.name in run.__code__.co_freevars and "free variable" in str(error):
            raise UnboundLocalError(
                f"cannot access local variable '{error.name}' where it is not associated with a "
                "value"
            ) from None
        raise


# --- items of lists at an index that is a signal -------------------------------------------------

ITEMS = (int, float, np.float64, np.int64)  # numbers of which a signal picks one


def item_of(values, index, read_only=False):
    """Return values[index]; a row that is read only may be a copy."""
    is_signal = isinstance(index, Array) and not index.shape and index._whole is True
    if (
        not is_signal
        or type(values) not in (list, tuple)
        or not moves(index)
        or in_a_try()
    ):
        return values[index]
    item = picked_from(values, index, (tuple, list) if read_only else (tuple,))
    return values[index] if item is None else item


def picked_from(values: Any, index: Array, rows: tuple[type, ...] = (tuple,)) -> Any:
    """Return the item of a list of numbers, or of rows of numbers; None of other lists."""
    if all((isinstance(v, Array) and not v.shape) or type(v) in ITEMS for v in values):
        return _picked_number(values, index)
    kinds = {
        (type(value), len(value) if hasattr(value, "__len__") else -1)
        for value in values
    }
    kind, length = next(iter(kinds), (None, 0))
    if len(kinds) != 1 or kind not in rows:
        return None
    columns = [
        picked_from([value[j] for value in values], index) for j in range(length)
    ]
    return None if any(column is None for column in columns) else kind(columns)


def _picked_number(values: Any, index: Array) -> Any:
    """Return one of several numbers as one operation; None of truth values."""
    if not values or any(
        isinstance(value, Array) and value._is_condition for value in values
    ):
        return None
    tape = index._tape
    row = lifted(tape, [*values])
    picked = tape.add("pick", (operand(row), index._ref), ())
    picked._whole = common(map(is_whole, values))
    picked._of_python = common(map(is_of_python, values))
    return picked


def index_of(values, value):
    """Return values.index(value): the first item that equals a value."""
    if (
        type(values) not in (list, tuple)
        or active() is None
        or tape_of([*values, value]) is None
    ):
        return values.index(value)
    if in_a_try():  # Python raises if no item is equal
        return values.index(value)
    position: Any = np.nan
    for k in range(len(values) - 1, -1, -1):
        position = chosen(elementwise("eq", values[k], value), k, position)
    if isinstance(position, Array):
        position._whole = True
        position._of_python = True
    return position
