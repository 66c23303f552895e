"""Trace a function: run it on tracer arrays and return the record.

    f(t, x, u, p)  ->  each port, as operations on t, the ports of x and u, and the fields of p

A condition (``if u[0] > 0``) has two outcomes: the function runs once for each, and `where` joins
the results (`execution_paths`).  A path that raises gives NaN.  A signal that is an index is
enumerated up to the first IndexError.  A function is traced only if its `fingerprint` shows that it
has no hidden state and no side effects.
"""

from collections.abc import (
    Callable,
    ItemsView,
    Iterator,
    KeysView,
    Mapping,
    Set,
    ValuesView,
)
from functools import partial
from math import nan, prod
from typing import Any, NamedTuple

import numpy as np

from ...base.arguments import attribute_of
from ...base.errors import BlockError
from ..model.declaration import Parameters, Params
from ..model.ports import check_ports, places, shaped
from ..record.graph import Record, Shape, compact, conditions_of, is_known
from ..record.unread import Unread, located, reading_on
from .arrays import REMEMBERS, Array, Tape, objects, operand
from .elementwise import as_number, filled, is_truth, lifted
from .execution_paths import AnsweringTape, Outside, each_path
from .fingerprint import Fingerprint, reachable
from .heaps import decision_tree, joined
from .isolation import isolated
from .rebinding import Rebinding

MOST_PATHS = 256
# errors of numbers, or of variables that this path does not set: the path gives NaN
RAISED = (
    ArithmeticError,
    IndexError,
    ValueError,
    AssertionError,
    UnboundLocalError,
    StopIteration,
    SystemExit,
)
OF_PATHS = (*RAISED, RuntimeError, SystemError, Outside)


def check_distance(block: str, returned: Any) -> None:
    """Refuse truth values of a guard, which are never below 0."""
    values = returned.values() if isinstance(returned, Mapping) else [returned]
    for value in values:
        first = value[0] if isinstance(value, list | tuple) and value else value
        if is_truth(first):
            raise BlockError(
                f"{block}.guard: returns a truth value; must return a distance, positive "
                "inside and negative outside: x[0] - 1 for x[0] > 1"
            )


WITHOUT_ORDER = Iterator, KeysView, ValuesView, ItemsView, Set


class Read(NamedTuple):
    """Result of tracing a function."""

    record: Record
    pinned: frozenset[str]  # parameters whose values the record depends on
    texts: frozenset[Any]  # in the functions
    names: frozenset[Any]  # for which python-control's params were asked
    spreads: bool  # it returns one number for all states or outputs
    conditions: Record  # comparisons on its paths


class Request(NamedTuple):
    """A function to trace, and its arguments."""

    function: Callable
    role: str
    states: Mapping[str, Shape]
    inputs: Mapping[str, Shape]
    parameters: Mapping[str, Any]
    # of the parameters that are leaves; others have their values
    shapes: Mapping[str, Shape]
    out: Mapping[str, Shape]
    # p are python-control's params, else the Parameters of a block
    of_control: bool
    trusted: bool  # a function of this package, without hidden state
    # returns a sentence on a new record that gives other numbers than the function
    confirm: Callable[[Read], str] = lambda result: ""

    @property
    def name(self) -> str:
        """Name of the function, for a sentence."""
        return attribute_of(self.function, "__name__", type(self.function).__name__)


MOST_TRACED = 256  # functions whose records are cached
MOST_VALUES = 16  # of the parameters whose values a record was made with
# by fingerprint and shapes: parameters that decide the result, their values, the result, and
# objects that must stay alive
_TRACED: dict[Any, list[tuple]] = {}


def read(request: Request) -> Read:
    """Return the record of a function, and the parameters whose values the record depends on.

    A function is traced again only if its fingerprint changed.  Raises `Unread` if the function
    cannot be traced.
    """
    fixed = {k: v for k, v in request.parameters.items() if k not in request.shapes}
    reached = reachable(request.function, fixed, trusted=request.trusted)
    if len(_TRACED) > MOST_TRACED:
        _TRACED.clear()
    shapes = request.states, request.inputs, request.shapes, request.out
    kind = request.role, request.of_control, request.trusted
    key = reached.key, kind, *(tuple(shape.items()) for shape in shapes)
    cached = _TRACED.setdefault(key, [])
    matching = (
        result
        for names, values, result, _ in cached
        if values == _values(request.parameters, names)
    )
    result = next(matching, None)
    if result is None:
        try:
            result = _traced(request, reached)
            names = result.pinned
        except (Unread, BlockError) as error:
            result = error
            names = frozenset(request.shapes)
        values = _values(request.parameters, names)
        cached[MOST_VALUES:] = [(names, values, result, reached.referenced)]
    if isinstance(result, Exception):
        raise type(result)(str(result)) from None
    return result


def _values(parameters: Mapping[str, Any], names: frozenset[str]) -> list[Any]:
    """Return the values of some parameters, to be compared."""
    arrays = (
        (type(parameters[name]), np.asarray(parameters[name])) for name in sorted(names)
    )
    return [(kind, array.dtype.str, array.tobytes()) for kind, array in arrays]


def _traced(request: Request, reached: Fingerprint) -> Read:
    """Trace a function, with merged paths if possible, and confirm the record."""
    if request.trusted:
        return _Tracing(request, reached, merging=False).read()
    errors = list[Unread]()
    failed = frozenset[
        Any
    ]()  # regions that cannot be merged: without their tries it is shorter
    for merging in (
        True,
        True,
        False,
    ):  # the following code may not accept merged values
        if merging and errors and not failed:
            continue
        tracing = _Tracing(request, reached, merging, failed)
        try:
            result = tracing.read()
            if sentence := request.confirm(result):
                raise Unread(sentence)
            return result
        except Unread as error:
            errors.append(error)
            failed = frozenset(tracing.tape.failed)
    raise errors[-2]  # of merged paths


class Ports(Array):
    """Tracer array of all states or inputs: a vector, with its ports as views."""

    __slots__ = ("_ports",)

    def __init__(
        self, tape: Tape, group: str, shapes: Mapping[str, Shape], fixed: bool = True
    ):
        self._ports = {
            port: tape.add("leaf", (), shape, (group, port))
            for port, shape in shapes.items()
        }
        has_sizes = all(map(is_known, shapes.values()))
        size = sum(map(prod, shapes.values())) if has_sizes else f"len({group})"
        super().__init__(tape, -1, (size,))
        del self._node  # until it was requested
        self._fixed = fixed
        for leaf in self._ports.values():
            leaf._fixed = True

    @classmethod
    def of(cls, array: Array, ports: Mapping[str, tuple[slice, Shape]]) -> "Ports":
        """Return a vector with its ports as views."""
        new = cls.__new__(cls)
        Array.__init__(new, array._tape, array._node, array.shape)
        new._ports = {
            port: array[portion].reshape(shape)
            for port, (portion, shape) in ports.items()
        }
        new._fixed = True
        return new

    def __getattr__(self, name: str) -> Any:
        if name in self._ports:
            return self._ports[name]
        if name != "_node":
            return super().__getattr__(name)
        self._counted()
        rows = [row._ref for leaf in self._ports.values() for row in _rows(leaf)]
        if len(rows) > 1:  # of the vector of all ports, one behind the other
            rows = [self._tape.add("join", rows, self.shape)._node]
        self._node = (
            rows[0] if rows else self._tape.add("constant", (), (0,), b"")._node
        )
        return self._node


def _rows(array: Any) -> list[Array]:
    """Return the rows of an array of any number of axes."""
    return (
        [array]
        if array.ndim == 1
        else [row for row_block in array for row in _rows(row_block)]
    )


class _Tracing:
    """One tracing of a function: all its execution paths, one after the other."""

    def __init__(
        self,
        request: Request,
        reached: Fingerprint,
        merging: bool,
        unmergeable: frozenset[Any] = frozenset(),
    ) -> None:
        self.request = request
        self.tape = AnsweringTape(request.parameters)
        self.tape.merging = merging
        self.tape.unmergeable = unmergeable
        self.rebinding = Rebinding(self.tape, reached, request.trusted)
        self.paths: list[tuple[dict[int, bool], list[Any]]] = []
        self.spreads = False

    def read(self) -> Read:
        """Run the function on each of its paths, and merge what they return."""
        tape = self.tape
        request = self.request
        rebinding = self.rebinding
        function = rebinding.root(request.function)
        t = tape.add("leaf", (), (), ("t", "t"))
        t._of_python = True
        fields = {
            name: self._leaf(name) if name in request.shapes else rebinding.of(value)
            for name, value in request.parameters.items()
        }
        # x and u are a system's own
        named = not request.of_control
        names_read = set[Any]()
        with isolated():
            for _ in each_path(tape):
                tape.last_asked = None
                tape.texts = None
                x = Ports(tape, "x", request.states, named)
                u = Ports(tape, "u", request.inputs, named)
                p: Any = Parameters(**fields) if named else Params(fields, names_read)
                with rebinding.installed(request.name):
                    outputs = self._path(lambda: function(t, x, u, p))  # noqa: B023
                self.paths.append((tape.answers, outputs))
                if not named and any(
                    v is not fields.get(k, p) for k, v in dict.items(p)
                ):
                    raise Unread(f"{request.name} {REMEMBERS.format('its params')}")
                if len(self.paths) > MOST_PATHS:
                    raise Unread(
                        f"{request.name} has more than {MOST_PATHS} execution paths"
                    )
        answers, values = zip(*self.paths, strict=True)
        tree = decision_tree([*enumerate(answers)])
        ports = zip(*values, strict=True)
        refs = [operand(joined(tape, tree, value)) for value in ports]
        record = compact(tape.operations, refs, request.out.values())
        texts = frozenset(rebinding.texts)
        names = frozenset(names_read)
        conditions = conditions_of(tape.operations, [*refs, *tape.asked])
        pinned = frozenset(tape.pinned)
        return Read(record, pinned, texts, names, self.spreads, conditions)

    def _leaf(self, name: str) -> Array:
        leaf = self.tape.add("leaf", (), self.request.shapes[name], ("p", name))
        value = self.request.parameters[name]
        leaf._fixed, leaf._whole = True, isinstance(value, int | np.int64)
        leaf._of_python = type(value) in (int, float)
        return leaf

    def _path(self, run: Callable[[], Any]) -> list[Any]:
        """Return the value of each port on one path; NaN if the path raises."""
        tape = self.tape
        request = self.request
        outputs = []
        raised = list[BaseException]()
        try:
            with reading_on(tape), np.errstate(all="ignore"):
                returned = run()
                if returned is None and tape.answers:
                    raise ValueError("returns nothing")
                outputs = self._by_port(returned)
                if tape.texts is not None:
                    raise tape.texts
        except BlockError:
            raise
        except (Exception, SystemExit) as error:
            tape.ended(error)
            raised.append(error)
            of_path = tape.answers and isinstance(error, OF_PATHS)
            if tape.stopped is None and (
                isinstance(error, RecursionError) or not of_path
            ):
                text = f"{error}"
                if not isinstance(error, Unread):  # a tracer array is a signal
                    text = f"{type(error).__name__}: {error}"
                    text = text.replace("'Array'", "a signal")
                raise Unread(f"{located(request.function, error)}{text}") from None
            outputs = [filled(tape, nan, shape) for shape in request.out.values()]
        if tape.stopped is not None:  # a function may have gone on
            raise Unread(
                f"{located(request.function, tape.stopped, *raised)}{tape.stopped}"
            )
        return outputs

    def _by_port(self, returned: Any) -> list[Any]:
        """Return the value of each port from the returned value of the function.

        One number is the value of all states or outputs in python-control.
        """
        tape = self.tape
        role, out = self.request.role, self.request.out
        of_control = self.request.of_control
        name, _, of_guard = role.rpartition(".guard")
        if name and not of_guard:
            check_distance(name, returned)
        if of_control and isinstance(returned, WITHOUT_ORDER):
            raise Unread(f"returns {type(returned).__name__}; must return numbers")
        if isinstance(returned, Mapping):
            check_ports(role, returned, out)
            values = {
                port: as_number(lifted(tape, number))
                for port, number in returned.items()
            }
            fill = partial(filled, tape)
            return [
                shaped(role, port, values[port], shape, fill)
                for port, shape in out.items()
            ]
        if len(out) == 1 and getattr(returned, "shape", None) == next(
            iter(out.values())
        ):
            return [as_number(lifted(tape, returned))]
        rows = returned if isinstance(returned, list | tuple) else [returned]
        numbers = [number for row in rows for number in objects(row).ravel()]
        size = sum(map(prod, out.values()))
        if of_control and len(numbers) == 1 and size > 1:
            self.spreads = True
            numbers *= size
        if len(numbers) != size:
            raise BlockError(
                f"{role}: returns {len(numbers)} numbers; must return {size}"
            )
        flat = np.fromiter((as_number(lifted(tape, v)) for v in numbers), object)
        return [
            lifted(tape, flat[item].reshape(shape))
            for item, shape in places(out).values()
        ]
