"""Execution paths through a function, and how their results are merged.

A condition on a signal (``if u[0] > 0``) is answered both ways: the code runs once per execution
path, a row of answers, and `where` joins what the paths return and write.  A called helper, an `if`
statement and a conditional expression are merged as soon as they end,

    limited(u) = where(u > 1, 1, where(u < -1, -1, u))

so eight thrusters with three paths each are 24 paths, and not 3^8.  An item of a list at an index
that is a signal, ``points[argmin(d)]``, is one `pick` and not a path for each item.  Conditions on
parameters alone have values.
"""

import functools
from collections.abc import Callable, Iterable, Iterator, Mapping
from types import FunctionType
from typing import Any

import numpy as np

from ..record.graph import Ref, compact, evaluated
from ..record.unread import Unread, active, caller
from .arrays import Array, Tape, moves
from .elementwise import chosen, common, elementwise, in_a_try, is_of_python, is_whole
from .heaps import Joining, NotMergeable, decision_tree, heap_of, put_back
from .interpolators import lookup
from .views import tape_of

# paths of one helper or statement, and runs of all together
MOST_MERGED = 32
MOST_RUNS = 10_000
FEW_RUNS = 500  # before regions that cannot be merged are skipped
MOST_QUESTIONS = 64  # conditions of one path
MOST_PLACES = 64  # values of a signal that is an index
RAISED = (Exception, SystemExit)


class Outside(Exception):
    """No run takes this path: the index would be outside of every row."""


class AnsweringTape(Tape):
    """A tape with the branch outcomes of one execution path."""

    def __init__(self, parameters: Mapping[str, Any]):
        super().__init__()
        self.parameters = parameters
        self.pinned: set[str] = set()  # parameters whose value Python asked for
        self.way: list[bool] = []
        self.answers: dict[int, bool] = {}
        self.asked: set[int] = set()  # conditions of all paths
        # regions whose paths cannot be merged: known before, and found now
        self.unmergeable: frozenset[Any] = frozenset()
        self.failed: set[Any] = set()
        self.rows: dict[int, int] = {}  # length of the row in which a signal is a place
        self.last_asked: tuple[int, int] | None = None  # a signal, and the answer
        # identities of values that outlive the function
        self.persistent: set[int] = set()
        self.check: Callable[[], None] = lambda: None  # refuses a change of these

    def question(self, ref: Ref) -> bool:
        """Return the outcome of a condition on this path, or by the parameters alone."""
        if type(ref) is float or not self.free[ref]:
            return bool(self.known(ref).item())
        if ref not in self.answers:
            k = len(self.answers)
            if k >= MOST_QUESTIONS:
                raise Unread(
                    f"has more than {MOST_QUESTIONS} branches that depend on signals. Write "
                    "np.where, and no `while` on a signal"
                )
            self.answers[ref] = self.way[k] if k < len(self.way) else True
            self.asked.add(ref)
        return self.answers[ref]

    def numbers(self, ref: Ref) -> np.ndarray:
        """Return the numbers of a value that depends on parameters alone."""
        if type(ref) is float or not self.free[ref]:
            return self.known(ref)
        raise Unread(
            f"{caller()} needs the value of a signal. Write the computation in NumPy, "
            "and fill arrays where they are made"
        )

    def known(self, ref: Ref) -> np.ndarray:
        """Return the value of an expression of parameters, which are then pinned."""
        record = compact(self.operations, [ref])
        self.pinned.update(record.leaves("p"))
        rows = evaluated(
            record, lambda group, name: np.asarray(self.parameters[name])[..., None]
        )
        return rows.reshape(record.shapes[0])

    def parameter(self, ref: int) -> Any:
        """Return the value of a parameter as the user wrote it, which is then pinned."""
        kind, _, _, label = self.operations[ref]
        if kind != "leaf" or self.free[ref]:
            return None
        self.pinned.add(label[1])
        return self.parameters[label[1]]

    def whole(self, number: Array) -> int:
        """Return a whole number for Python; a signal has one on each path."""
        ref = number._ref
        if type(ref) is float or not self.free[ref]:
            value = self.known(ref).item()
            if value != int(value):
                raise TypeError("only integers can be used as an index")
            return int(value)
        if number._below is not None:
            candidates = range(number._below)
            return next(
                (k for k in candidates[:-1] if number == float(k)), candidates[-1]
            )
        count = self.rows.get(ref, MOST_PLACES)
        for k in (*range(count + 1), *range(-1, -count - 1, -1)):
            if k == MOST_PLACES:
                raise Unread(
                    "counts with a signal; let a number of the run choose by np.where or lookup"
                )
            self.last_asked = ref, k
            if number == float(k):
                return k
        self.last_asked = None
        raise Outside

    def ended(self, error: BaseException) -> None:
        """Store the length of a row if the path raised at the end of the row."""
        if (
            isinstance(error, IndexError)
            and self.last_asked
            and self.last_asked[1] >= 0
        ):
            self.rows.setdefault(*self.last_asked)


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
    tape = active()
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
    answers, decisions, texts = tape.answers, tape.way, tape.texts
    before = {}
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
            values_before = (entry.value for entry in before.values())
            heap = heap_of((result, *values_before), tape.persistent)
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
        tape.answers, tape.way = answers, decisions
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
    picked = lookup([*values], index)
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
    position = np.nan
    for k in range(len(values) - 1, -1, -1):
        position = chosen(elementwise("eq", values[k], value), k, position)
    if isinstance(position, Array):
        position._whole = True
        position._of_python = True
    return position
