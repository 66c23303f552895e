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
from types import CellType, FunctionType
from typing import Any

import numpy as np

from .arrays import Array, Tape, Unread, active, key_of, moves, operand
from .elementwise import (
    chosen,
    common,
    elementwise,
    in_a_try,
    is_of_python,
    is_truth,
    is_whole,
    lifted,
    where,
)
from .isolation import Content, copied, elements_of, items_of, put
from .references import attributes_of, is_library, root_of
from .views import tape_of

# paths of one helper or statement, and runs of all together
MOST_MERGED = 32
MOST_RUNS = 10_000
NUMBERS = (int, float, np.float64)
RAISED = (Exception, SystemExit)


def each_path(tape: Any) -> Iterator[None]:
    """Yield once for each path through the code that runs then, with the answers of this path."""
    before = dict(tape.answers)
    tape.way = [*before.values()]
    while True:
        tape.answers = dict(before)
        yield
        tape.runs += 1
        if tape.runs > MOST_RUNS:
            raise Unread(
                f"has helpers in helpers, of more than {MOST_RUNS} execution paths"
            )
        outcomes = [*tape.answers.values()]
        while len(outcomes) > len(before) and not outcomes[-1]:
            outcomes.pop()
        if len(outcomes) == len(before):
            return
        tape.way = [*outcomes[:-1], False]


def merged(
    tape: Tape,
    paths: list[tuple[dict[int, bool], list[Any]]],
    choose: Callable,
    depth: int = 0,
) -> list[Any]:
    """Join the results of paths by the conditions, from that at `depth` on, which differ."""
    if len(paths) == 1:
        return paths[0][1]
    condition = list(paths[0][0])[depth]
    yes = [path for path in paths if path[0].get(condition) is True]
    no = [path for path in paths if path[0].get(condition) is False]
    if not yes or not no or len(yes) + len(no) < len(paths):
        raise Unread(
            "takes other branches from call to call. Make what it stores a state"
        )
    branches = (merged(tape, subset, choose, depth + 1) for subset in (yes, no))
    return [
        a
        if key_of(operand(a)) == key_of(operand(b))
        else choose(Array(tape, condition, ()), a, b)
        for a, b in zip(*branches, strict=True)
    ]


class NotMergeable(Exception):
    """The results of paths have no common form: these paths are those of the caller."""


# --- one helper, statement or expression --------------------------------------------------------


class Region:
    """Code whose paths are merged when it ends: the variables and values that it may change."""

    def __init__(self, tape: Any, run: Callable[[], Any], roots: Iterable[Any]):
        self.tape = tape
        self.run = run
        self.content: list[Content] = []
        self._seen: set[int] = set(tape.persistent)
        for root in roots:
            self._add(root)

    def _add(self, value: Any) -> None:
        """Add the lists, dicts, arrays and objects that code reaches through a value."""
        if isinstance(value, Array):
            value = value._root
            if value._fixed or value._is_condition:
                return
        elif not isinstance(value, list | dict | tuple | np.ndarray | CellType):
            attributes = attributes_of(value)
            if type(attributes) is not dict or isinstance(value, type | FunctionType):
                return
            if is_library(root_of(type(value))):
                return
            value = attributes
        if id(value) in self._seen:
            return
        self._seen.add(id(value))
        if not isinstance(value, tuple):
            self.content.append(Content(value))
        if isinstance(value, CellType):
            self._add(self.content[-1].before[0])
        elif isinstance(value, list | tuple):
            for item in value:
                self._add(item)
        elif isinstance(value, dict):
            for item in value.values():
                self._add(item)

    def merged(self, dead: Iterable[CellType] = ()) -> Any:
        """Run the code on each path; return its result, and leave merged content behind.

        Variables in `dead` are not read afterwards.  If paths cannot be merged, the code runs once
        more, and its paths are those of the code around it.
        """
        tape, before = self.tape, (self.tape.answers, self.tape.way, self.tape.texts)
        paths = list[tuple[dict[int, bool], list[Any]]]()
        try:
            for _ in each_path(tape):
                if paths:
                    self.restore()
                result = self.run()
                contents = [copied(content.value) for content in self.content]
                paths.append((tape.answers, [result, *contents]))
                if len(paths) > 1:
                    tape.check()
                if len(paths) > MOST_MERGED:
                    raise NotMergeable
            if len(paths) == 1:
                return result
            return self._merge(paths, len(before[0]), {*map(id, dead)})
        except NotMergeable:
            pass
        except RAISED:
            if tape.stopped is not None:
                raise
        finally:
            tape.answers, tape.way = before[:2]
        tape.texts = before[2]
        self.restore()
        return self.run()

    def restore(self) -> None:
        """Put back the content with which the code began."""
        try:
            for content in self.content:
                content.put_back()
        except Exception as error:  # not one of the function, whose path would be NaN
            raise Unread(f"its paths cannot be traced: {error}") from None

    def _merge(self, paths: list[Any], depth: int, dead: set[int]) -> Any:
        answers = [outcomes for outcomes, _ in paths]
        columns = [*zip(*(row for _, row in paths), strict=True)]
        merge = functools.partial(_merged_values, self.tape, answers, depth, self._seen)
        result = merge(columns[0])
        contents = list[Any]()
        for changed, column in zip(self.content, columns[1:], strict=True):
            if id(changed.value) in dead:
                contents.append(column[0])
            else:
                contents.append(_merged_contents(changed.value, column, merge))
        for changed, content in zip(self.content, contents, strict=True):
            if id(changed.value) not in dead:
                put(changed.value, content)
        return result


def _merged_contents(value: Any, contents: Any, merge: Callable) -> Any:
    """Return the merged content of a list, dict, array or variable, one for all paths."""
    first = contents[0]
    if isinstance(value, Array):  # None is what nothing was written into
        contents = [
            elements_of(value) if content is None else content for content in contents
        ]
    if isinstance(value, np.ndarray) and not all(
        np.array_equal(content, first) for content in contents
    ):
        raise NotMergeable  # it holds no signals
    if isinstance(value, dict) and any(
        content.keys() != first.keys() for content in contents
    ):
        raise NotMergeable
    rows = [items_of(content) for content in contents]
    if len({len(row) for row in rows}) > 1:
        raise NotMergeable
    items = [merge(column) for column in zip(*rows, strict=True)]
    if isinstance(value, dict):
        return dict(zip(first, items, strict=True))
    if isinstance(value, list | CellType):
        return items
    if isinstance(value, np.ndarray):
        return first
    elements = np.empty(len(items), dtype=object)
    elements[:] = items
    return elements.reshape(value.shape)


def _merged_values(
    tape: Tape, answers: list[dict], depth: int, earlier: set[int], values: tuple
) -> Any:
    """Return the merged value of paths; `earlier` are identities of values before the paths."""
    first = values[0]
    if all(value is first for value in values):
        return first
    if type(first) in (int, str, bool) and all(
        type(value) is type(first) and value == first for value in values
    ):
        return first
    rows = [
        (outcomes, [value]) for outcomes, value in zip(answers, values, strict=True)
    ]
    if all(map(is_truth, values)) and not any(np.ndim(value) for value in values):
        return merged(tape, rows, where, depth)[0]
    if all(map(_is_number, values)) and not all(type(value) is int for value in values):
        return merged(tape, rows, chosen, depth)[0]
    shapes = {isinstance(value, Array) and value.shape for value in values}
    if len(shapes) == 1 and all(shapes):
        new = merged(tape, rows, where, depth)[0]
        # writing into it would write into one of the paths' arrays
        new._fixed = any(value._fixed or id(value._root) in earlier for value in values)
        return new
    kinds = {type(value) for value in values}
    if (
        len(kinds) == 1
        and kinds <= {tuple, list}
        and len({len(value) for value in values}) == 1
    ):
        columns = zip(*values, strict=True)
        return type(first)(
            _merged_values(tape, answers, depth, earlier, outcomes)
            for outcomes in columns
        )
    raise NotMergeable


def _is_number(value: Any) -> bool:
    if isinstance(value, Array):
        return not (value.shape or value._boxed or value._is_condition)
    return type(value) in NUMBERS


# --- where regions begin --------------------------------------------------------------------------


def merging() -> Any:
    """Return the tape on which this thread traces a function and merges paths, or None."""
    tape: Any = active()
    return tape if tape is not None and tape.merging else None


def merge_calls(function: FunctionType) -> Any:
    """Return a function whose paths are merged at each call while a function is traced."""

    @functools.wraps(function, updated=())
    def helper(*arguments, **options):
        if (tape := merging()) is None:
            return function(*arguments, **options)
        roots = (*arguments, *options.values(), *(function.__closure__ or ()))
        return Region(tape, lambda: function(*arguments, **options), roots).merged()

    return helper


def merge_value(run: FunctionType) -> Any:
    """Return the value of a conditional expression, its paths merged."""
    if (tape := merging()) is None:
        return run()
    return Region(tape, run, run.__closure__ or ()).merged()


def merge_statement(run: FunctionType, read_later: tuple[str, ...]) -> None:
    """Run an `if` statement, a function of no arguments, and merge what its paths leave behind.

    Variables that are not `read_later` may be left as one path has them.
    """
    if (tape := merging()) is None:
        run()
        return
    cells = dict(zip(run.__code__.co_freevars, run.__closure__ or (), strict=True))
    dead = [cell for name, cell in cells.items() if name not in read_later]
    Region(tape, run, cells.values()).merged(dead)


# --- items of lists at an index that is a signal -------------------------------------------------

ITEMS = (*NUMBERS, np.int64)  # numbers of which a signal picks one


def item_of(values, index):
    """Return values[index]."""
    is_signal = isinstance(index, Array) and not index.shape and index._whole is True
    if (
        not is_signal
        or type(values) not in (list, tuple)
        or not moves(index)
        or in_a_try()
    ):
        return values[index]
    item = picked_from(values, index)
    return values[index] if item is None else item


def picked_from(values: Any, index: Array) -> Any:
    """Return the item of a list of numbers, or of rows of numbers; None of other lists."""
    if all(map(_is_item, values)):
        return _picked_number(values, index)
    kinds = {
        (type(value), len(value) if hasattr(value, "__len__") else -1)
        for value in values
    }
    kind, length = next(iter(kinds), (None, 0))
    if len(kinds) != 1 or kind not in (list, tuple):
        return None
    columns = [
        picked_from([value[j] for value in values], index) for j in range(length)
    ]
    return None if any(column is None for column in columns) else kind(columns)


def _is_item(value: Any) -> bool:
    return (isinstance(value, Array) and not value.shape) or type(value) in ITEMS


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
