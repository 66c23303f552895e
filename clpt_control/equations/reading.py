"""Read a function: run it on arrays without values, and keep the record.

    f(t, x, u, p)  ->  what each port is, as operations on t, the ports of x and u, the fields of p

A question (``if u[0] > 0``) is answered both ways: the function runs again with the other
answer, and what the ways return is joined by `where`.  A way that raises is NaN.  A signal that
Python counts with is asked which whole number it is, up to the first IndexError.  What is read
twice, and from each state in which a way left what the function reaches (`kept`), must be the
same: else a state or chance hides in the function.  The package's own functions are read once.
"""

from collections.abc import Callable, Mapping
from functools import partial
from itertools import product
from math import nan, prod
from typing import Any, NamedTuple

import numpy as np

from ..errors import BlockError
from .answers import AnsweringTape, Outside, Ports, each_way, located, merged
from .arrays import Array, Tape, Unread, objects, operand, reading_on
from .copies import Copies, borrowed
from .declaration import Parameters
from .elementwise import as_number, filled, lifted, where
from .kept import GROWN, OF_ALL, Snapshot
from .ports import check_ports, places, shaped
from .record import Record, Shape, compact
from .stand_ins import UNSEEDED

MOST_WAYS = 256
MOST_READINGS = 16  # one for each state in which something is left
# of numbers, or of what this way leaves out; such a way is NaN
RAISED = (
    *(ArithmeticError, IndexError, ValueError, AssertionError),
    *(UnboundLocalError, StopIteration),
)
OF_WAYS = (*RAISED, RuntimeError, SystemError, Outside)


class Read(NamedTuple):
    """What reading a function gave."""

    record: Record
    pinned: frozenset[str]  # parameters with whose values it was made
    texts: frozenset[Any] = frozenset()  # in the functions
    names: frozenset[Any] = frozenset()  # for which python-control's params were asked


class Request(NamedTuple):
    """What to read: a function and its arguments."""

    function: Callable
    role: str
    states: Mapping[str, Shape]
    inputs: Mapping[str, Shape]
    parameters: Mapping[str, Any]
    shapes: Mapping[str, Shape]  # of the parameters that are leaves; others have their values
    out: Mapping[str, Shape]
    wrap: Callable[[dict[str, Any]], Any] | None = None  # else as the Parameters of a block
    known: bool = False  # to keep nothing and to draw nothing, as the package's own functions

    @property
    def name(self) -> str:
        """Name of the function, for a sentence."""
        return getattr(self.function, "__name__", type(self.function).__name__)


def read(*arguments: Any, **more: Any) -> Read:
    """Return the record of a function, and the parameters whose values it is made with.

    It takes the fields of `Request`.  Raises `Unread` where it cannot be read.
    """
    request = Request(*arguments, **more)
    reads: list[Read] = []
    snapshot = Snapshot(() if request.known else OF_ALL)
    try:
        while len(reads) < max(1 if request.known else 2, 1 + 2 * len(snapshot.left)):
            states = [({}, 0), *product(snapshot.left.values(), GROWN)]
            state = states[min(len(reads), len(states) - 1)]
            reads.append(_Ways(request, snapshot, *state).read())
            first, last = reads[0].record, reads[-1].record
            alike = last == first or str(last) == str(first)  # NaN differs from itself
            if not alike or len(snapshot.left) > MOST_READINGS:
                raise Unread(
                    f"{request.name} keeps what its next call reads, or draws by chance; make it "
                    "a state"
                )
    finally:
        snapshot.restore()
        drawn = snapshot.drew()
    if drawn:
        raise Unread(f"{request.name} {UNSEEDED}")
    return reads[0]


class _Ways:
    """All ways through a function, one after the other."""

    def __init__(self, request: Request, snapshot: Snapshot, state: dict, grown: int) -> None:
        self.request = request
        self.snapshot, self.state = snapshot, (state, grown)  # in which a way left all
        self.tape = AnsweringTape(request.parameters)
        self.copies = Copies(self.tape, snapshot)
        self.ways: list[tuple[dict[int, bool], list[Any]]] = []

    def read(self) -> Read:
        """Run the function on each of its ways, and join what they return."""
        tape, request, copied = self.tape, self.request, self.copies.of(self.request.function)
        t = tape.add("leaf", (), (), ("t", "t"))
        fields = {
            name: self._leaf(name) if name in request.shapes else self.copies.of(value)
            for name, value in request.parameters.items()
        }
        named = request.wrap is None  # else x and u are the function's own
        for _ in each_way(tape):
            tape.last_asked = tape.texts = None
            self.snapshot.begin(*self.state, self._unknown)
            x, u = Ports(tape, "x", request.states, named), Ports(tape, "u", request.inputs, named)
            p = request.wrap(dict(fields)) if request.wrap else Parameters(**fields)
            outputs = self._way(lambda: copied(t, x, u, p))  # noqa: B023
            self.ways.append((tape.answers, outputs))
            self.snapshot.restore()
            self.copies.check(request.name)
            if isinstance(p, dict) and any(v is not fields.get(k, p) for k, v in dict.items(p)):
                raise Unread(f"{request.name} changes its params; make what it keeps a state")
            if len(self.ways) > MOST_WAYS:
                raise Unread(f"{request.name} has more than {MOST_WAYS} ways through it")
        refs = [operand(one) for one in merged(tape, self.ways, where)]
        record = compact(tape.operations, refs, request.out.values())
        return Read(record, frozenset(tape.pinned), frozenset(self.copies.texts))

    def _unknown(self, name: Any) -> Array:
        """Return what stands for what the first reading changed."""
        return self.tape.add("leaf", (), (), ("t", f"changed {name}"))

    def _leaf(self, name: str) -> Array:
        leaf = self.tape.add("leaf", (), self.request.shapes[name], ("p", name))
        value = self.request.parameters[name]
        leaf._fixed, leaf._whole = True, isinstance(value, int | np.int64)
        leaf._of_python = type(value) in (int, float)
        return leaf

    def _way(self, run: Callable[[], Any]) -> list[Any]:
        """Return what one way gives, for each port; NaN where it raises."""
        tape, request, outputs, raised = self.tape, self.request, [], list[Exception]()
        try:
            with borrowed(self.copies), reading_on(tape):
                returned = run()
                if returned is None and tape.answers:
                    raise ValueError("returns nothing")
                outputs = _by_port(tape, request.role, returned, request.out)
                if tape.texts is not None:
                    raise tape.texts
        except BlockError:
            raise
        except Exception as error:
            tape.ended(error)
            raised.append(error)
            of_way = tape.answers and isinstance(error, OF_WAYS)
            if tape.stopped is None and (isinstance(error, RecursionError) or not of_way):
                text = error if isinstance(error, Unread) else f"{type(error).__name__}: {error}"
                raise Unread(f"{located(request.function, error)}{text}") from None
            outputs = [filled(tape, nan, shape) for shape in request.out.values()]
        if tape.stopped is not None:  # a function may have gone on
            raise Unread(f"{located(request.function, tape.stopped, *raised)}{tape.stopped}")
        return outputs


def record_of_states(shapes: Mapping[str, Shape]) -> Record:
    """Return the record of y = x: the outputs are the states."""
    tape = Tape()
    leaves = [tape.add("leaf", (), shape, ("x", port)) for port, shape in shapes.items()]
    return compact(tape.operations, [operand(one) for one in leaves], shapes.values())


def _by_port(tape: Tape, role: str, returned: Any, out: Mapping[str, Shape]) -> list[Any]:
    """Return what a function returned, for each port."""
    if isinstance(returned, Mapping):
        check_ports(role, returned, out)
        values = {port: as_number(lifted(tape, one)) for port, one in returned.items()}
        fill = partial(filled, tape)
        return [shaped(role, port, values[port], shape, fill) for port, shape in out.items()]
    if len(out) == 1 and getattr(returned, "shape", None) == next(iter(out.values())):
        return [as_number(lifted(tape, returned))]
    parts = returned if isinstance(returned, list | tuple) else [returned]
    numbers = [one for part in parts for one in objects(part).ravel()]
    size = sum(map(prod, out.values()))
    if len(numbers) != size:
        raise BlockError(f"{role}: returns {len(numbers)} numbers; must return {size}")
    flat = np.empty(size, dtype=object)
    for k, one in enumerate(numbers):
        flat[k] = as_number(lifted(tape, one))
    return [lifted(tape, flat[part].reshape(shape)) for part, shape in places(out).values()]
