"""A block as plain data, and a block made of such data: records in place of functions.

Plain data are dicts, lists, texts, numbers and truths, as JSON has them: nothing in them is code.
What comes from a file is checked line by line, since machine code trusts a record: a view beside
its array would read what lies there.
"""

from collections.abc import Mapping, Sequence
from functools import partial
from math import prod
from typing import Any

import numpy as np

from ..base.errors import BlockError
from ..engine.codegen.diagram_record import is_read
from ..engine.model.block import Block
from ..engine.model.declaration import Each, Guard
from ..engine.model.ports import sized, sizes_of
from ..engine.model.sampled import Sampled, inner_parameters, other_equations
from ..engine.record.graph import Operation, Record, Shape, bound
from ..engine.record.operations import ELEMENTWISE
from ..engine.trace.arrays import Unread
from ..engine.trace.traced_block import on_arrays

KINDS = ("input", "output", "state")
LARGEST = 10**7  # numbers of one value of a record
MOST = 10**8  # of all values of a record together


def _listed(
    times: np.ndarray, until: float, p: Any, t0: float, t1: float
) -> np.ndarray:
    """Return the breakpoints in (t0, t1] of those that a function gave, up to a time."""
    if t1 > until:
        raise BlockError(
            f"jumps are recorded up to t = {until:g}; t = {t1:g} is asked for"
        )
    return times[(times > t0) & (times <= t1)]


class RecordedBlock(Block):
    """A block whose functions are records."""

    def __init__(self, plain: Mapping[str, Any]):
        name, jumps, policy = plain["name"], plain["jumps"], plain["guard"]
        shapes: dict[str, Any] = {
            f"{kind}s": _shapes(plain[f"{kind}s"]) for kind in KINDS
        }
        sizes = {str(size): _size(number) for size, number in plain["sizes"].items()}
        values = {field: _value(value) for field, value in plain["parameters"].items()}
        self._plain_records = {
            role: _record(lines) for role, lines in plain["records"].items()
        }
        self.fixed, self.of_package = frozenset(plain["fixed"]), plain["package"]
        for kind in KINDS:  # before anything of that size is made
            ports = sized(name, shapes[f"{kind}s"], sizes)
            if sum(sizes_of(ports).values()) != len(plain["labels"][kind]):
                raise BlockError(f"{name}: its {kind}s are not as many as their labels")
        functions: dict[str, Any] = dict.fromkeys(self._plain_records, other_equations)
        if jumps is not None and "period" in jumps:
            jumps = Each(**jumps)
        elif jumps is not None:
            times = np.array([float(t) for t in jumps["times"]])
            jumps = partial(_listed, times, float(jumps["until"]))
        if "output" not in functions:
            shapes["outputs"] = None
        declared = {field: plain[field] for field in ("opaque", "units")}
        declared |= {
            "parameters": values,
            "shapes": _shapes(plain["shapes"]),
            "sizes": sizes,
        }
        functions["guard"] = policy and Guard(
            functions["guard"], policy, partial(_left, name)
        )
        super().__init__(name, **shapes, **declared, breakpoints=jumps, **functions)
        self.dt = plain["dt"]
        self.breakpoints(0.0, 0.0)  # so that it is told here what cannot be asked
        given = self.parameters._asdict().items()
        numbers = {field: np.shape(v) for field, v in given if not isinstance(v, int)}
        leaves = {
            "t": {"t": ()},
            "x": self.state_shapes,
            "u": self.input_shapes,
            "p": numbers,
        }
        for role, record in self._plain_records.items():
            check_record(record, leaves, self.sizes, self._roles[role][1])

    def _try_equations(self) -> None:
        """Leave it to the checks of the record."""

    def _read(self, role: str) -> Record | Unread:
        return self._plain_records[role]

    def _evaluate(
        self, role: str, size: int, t: float, x: Any, u: Any, p: Any
    ) -> np.ndarray:
        return on_arrays(self, role, t, np.asarray(x), np.asarray(u), p)

    def with_values(self, changes: Mapping[str, Any]) -> Any:
        """Return the parameters with some changed, but those whose values the record holds."""
        for field in self.fixed.intersection(changes):
            if not np.array_equal(changes[field], getattr(self.parameters, field)):
                raise BlockError(
                    f"{self.name}.{field}: the record was made with its value, "
                    f"{getattr(self.parameters, field)}, and holds for no other"
                )
        return super().with_values(changes)


def _left(name: str, t: float, u: Any, p: Any) -> str:
    return f"{name} reached the edge of where it may be used at t = {t:.9g}"


# --- a block as plain data ------------------------------------------------------------------------


def plain_block(
    block: Block, name: str, p: Any, begin: float, end: float
) -> dict[str, Any]:
    """Return a block with these parameters as plain data, for runs between two times."""
    labels = {kind: list(getattr(block, f"{kind}_labels")) for kind in KINDS}
    if isinstance(block, Sampled):
        return {
            "sampled": block.period,
            "inner": plain_block(
                block.inner, name, inner_parameters(block, p), begin, end
            ),
            "called": block._inner,
            "labels": labels,
        }
    records = {role: _plain_record(block.array_record(role)) for role in block._roles}
    pinned = {name for found, _ in block.read_with.values() for name in found}
    jumps, listed = block.breakpoints_function, None
    if isinstance(jumps, Each):
        listed = {"period": jumps.period, "part": jumps.part}
    elif jumps is not None:
        until = 3 * abs(end) + 1.0  # beyond what a block asks at once
        times = np.concatenate(
            [
                block.breakpoints(min(begin, 0.0), 0.0, p),
                block.breakpoints(0.0, until, p),
            ]
        )
        listed = {"times": np.unique(times).tolist(), "until": until}
        pinned = set(p._fields)
    return {
        "name": name,
        **block.declared,
        "sizes": block.sizes,
        "parameters": {
            name: _plain_value(value)
            for name, value in p._asdict().items()
            if is_read(block, name)
        },
        "shapes": block.parameter_shapes,
        "records": records,
        "fixed": sorted(pinned),
        "jumps": listed,
        "guard": block.guard and block.guard.policy,
        "opaque": block.opaque,
        "package": block.of_package,
        "units": dict(block.units),
        "dt": block.dt,
        "labels": labels,
    }


def _plain_value(value: Any) -> Any:
    if np.ndim(value):
        return {"shape": list(np.shape(value)), "numbers": np.ravel(value).tolist()}
    return value if isinstance(value, int) else float(value)


def _plain_record(record: Record) -> dict[str, Any]:
    lines = [
        [
            kind,
            arguments,
            shape,
            np.frombuffer(at).tolist() if kind == "constant" else at,
        ]
        for kind, arguments, shape, at in record.operations
    ]
    return {"operations": lines, "outputs": record.outputs, "shapes": record.shapes}


# --- a block of plain data ------------------------------------------------------------------------


def block_of(plain: Mapping[str, Any]) -> Block:
    """Return the block that plain data hold; what they are not is a `BlockError`, or Python's."""
    block = _sampled(plain) if "sampled" in plain else RecordedBlock(plain)
    for kind in KINDS:
        labels, count = plain["labels"][kind], getattr(block, f"n{kind}s")
        if len(labels) != count or not all(isinstance(n, str) for n in labels):
            raise BlockError(f"{block.name}: the labels of its {kind}s are none")
        getattr(block, f"set_{kind}s")(list(labels))
    return block


def _sampled(plain: Mapping[str, Any]) -> Block:
    block = Sampled(block_of(plain["inner"]), plain["sampled"])
    block._name_ports(
        {
            kind: {old: new for new, old in ports.items()}
            for kind, ports in plain["called"].items()
        }
    )
    return block


def _size(value: Any) -> int:
    if type(value) is not int or not 0 <= value <= LARGEST:
        raise BlockError(
            f"a size is {value!r:.40}; must be a whole number up to {LARGEST:g}"
        )
    return value


def _shapes(plain: Mapping[str, Any]) -> dict[str, Shape]:
    return {str(name): _shape(shape) for name, shape in plain.items()}


def _shape(plain: Any) -> Shape:
    return tuple(n if isinstance(n, str) else _size(n) for n in plain)


def _value(plain: Any) -> Any:
    if isinstance(plain, dict):
        return np.array(plain["numbers"], dtype=float).reshape(_shape(plain["shape"]))
    return plain if type(plain) is int else float(plain)


def _record(plain: Mapping[str, Any]) -> Record:
    lines = []
    for kind, arguments, shape, at in plain["operations"]:
        at = np.array(at, dtype=float).tobytes() if kind == "constant" else _fixed(at)
        lines.append(Operation(kind, tuple(arguments), _shape(shape), at))
    return Record(
        tuple(lines), tuple(plain["outputs"]), tuple(map(_shape, plain["shapes"]))
    )


def _fixed(value: Any) -> Any:
    return tuple(map(_fixed, value)) if isinstance(value, list) else value


# --- whether a record is one ----------------------------------------------------------------------


def check_record(
    record: Record,
    leaves: Mapping[str, Mapping[str, Shape]],
    sizes: Mapping[str, int],
    out: Mapping[str, Shape],
) -> None:
    """Refuse what is no record of these leaves and outputs: machine code would run it as it is."""
    shapes: list[tuple[int, ...]] = []
    for k, operation in enumerate(record.operations):
        shape = bound(operation.shape, sizes)
        arguments = [_shape_of(a, shapes) for a in operation.arguments]
        if prod(shape) > LARGEST or not _fits(operation, shape, arguments, leaves):
            raise BlockError(f"line {k} of a record, {operation.kind!s:.20}, is none")
        shapes.append(shape)
    if (count := sum(map(prod, shapes))) > MOST:
        raise BlockError(
            f"a record has {count:.3g} numbers; at most {MOST:g} can be held"
        )
    for outputs in (record.outputs, record.shapes):
        if len(outputs) != len(out):
            raise BlockError(
                f"a record has {len(outputs)} outputs; must have {len(out)}"
            )
    for ref, shape, wanted in zip(
        record.outputs, record.shapes, out.values(), strict=True
    ):
        if bound(shape, sizes) != wanted or not _spreads(
            _shape_of(ref, shapes), wanted
        ):
            raise BlockError("an output of a record has another shape than its port")


def _shape_of(ref: Any, shapes: Sequence[tuple[int, ...]]) -> tuple[int, ...]:
    if type(ref) is float:
        return ()
    if type(ref) is not int or not 0 <= ref < len(shapes):
        raise BlockError(
            f"a record speaks of its value {ref!r:.20}, which is not there yet"
        )
    return shapes[ref]


def _spreads(short: tuple[int, ...], shape: tuple[int, ...]) -> bool:
    """Return whether NumPy broadcasts one shape to another."""
    pairs = zip(short[::-1], shape[::-1], strict=False)
    return len(short) <= len(shape) and all(n in (1, m) for n, m in pairs)


def _fits(
    line: Operation,
    shape: tuple[int, ...],
    arguments: list[tuple[int, ...]],
    leaves: Mapping[str, Mapping[str, Shape]],
) -> bool:
    """Return whether a line has the arguments, given by their shapes, and the shape of its kind."""
    kind, at = line.kind, line.at
    if kind == "leaf":
        group, name = at
        return not arguments and leaves[group][name] == shape
    if kind == "constant":
        return not arguments and len(at) == 8 * prod(shape)
    if kind == "sum":
        (a,) = arguments
        return type(at) is int and 0 <= at < len(a) and a[:at] + a[at + 1 :] == shape
    if kind == "view":
        (a,) = arguments
        return len(at) == len(a) and all(map(_within, at, a, [shape] * len(a)))
    if kind == "part":
        one = len(arguments) == 1 and arguments[0] and type(at) is int
        return bool(one) and 0 <= at <= prod(arguments[0]) - prod(shape)
    if kind == "search":
        row, place = arguments
        return len(row) == 1 and place == shape and at[0] in ("left", "right")
    if at is not None:
        return False
    if kind == "argmin":
        return (
            len(arguments) == 1
            and len(arguments[0]) == 1
            and arguments[0][0] > 0 == len(shape)
        )
    if kind == "fill":
        return arguments == [()]
    if kind == "stack":
        return len(arguments) == shape[0] and all(
            _spreads(a, shape[1:]) for a in arguments
        )
    if kind == "join":
        alike = all(a[1:] == shape[1:] for a in arguments)
        return alike and sum(a[0] for a in arguments) == shape[0]
    if kind == "pick":
        row, place = arguments
        return len(row) == 1 and place == shape
    count = {"where": 3}.get(kind, getattr(ELEMENTWISE[kind], "nin", 1))
    return len(arguments) == count and all(_spreads(a, shape) for a in arguments)


def _within(mapped: Any, length: int, shape: tuple[int, ...]) -> bool:
    """Return whether what a view takes of an axis lies in it."""
    if type(mapped) is int:
        return 0 <= mapped < length
    axis, start, step = mapped
    if not all(type(n) is int for n in mapped) or not 0 <= axis < len(shape):
        return False
    ends = (start, start + step * (shape[axis] - 1))
    return not shape[axis] or all(0 <= end < length for end in ends)
