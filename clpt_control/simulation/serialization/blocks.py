"""Blocks as plain data, and blocks whose functions are the records of plain data.

`plain_block` writes the records of a block, its ports, parameters, breakpoints and guard.
`block_of` returns the block of such data; errors of the data are `BlockError` or Python's own.
"""

from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np

from ...base.errors import BlockError
from ...engine.codegen.diagram_record import is_read
from ...engine.model.block import Block
from ...engine.model.declaration import Each, Guard
from ...engine.model.on_arrays import on_arrays
from ...engine.model.ports import sized, sizes_of
from ...engine.model.sampled import Sampled, inner_parameters, other_equations
from ...engine.record.graph import Record, Shape
from ...engine.record.unread import Unread
from .records import check_record, record_of, shape_of, size_of

KINDS = ("input", "output", "state")


def plain_block(
    block: Block,
    name: str,
    p: Any,
    begin: float,
    end: float,
    triggered: np.ndarray | None = None,
) -> dict[str, Any]:
    """Return a block with parameters p as plain data, for runs between two times.

    `triggered` are its breakpoints, if an input of its diagram makes them.
    """
    labels = {kind: getattr(block, f"{kind}_labels") for kind in KINDS}
    if isinstance(block, Sampled):
        inner_p = inner_parameters(block, p)
        return {
            "sampled": block.period,
            "inner": plain_block(block.inner, name, inner_p, begin, end),
            "called": block._inner,
            "labels": labels,
        }
    fixed = {field for fields, _ in block.read_with.values() for field in fields}
    jumps = _plain_jumps(block, p, begin, end, triggered)
    if jumps is not None and "times" in jumps:
        fixed = set(p._fields)
    parameters = {
        field: _plain_value(value)
        for field, value in p._asdict().items()
        if is_read(block, field)
    }
    return {
        "name": name,
        **block.declared,
        "sizes": block.sizes,
        "parameters": parameters,
        "shapes": block.parameter_shapes,
        "records": {role: block.array_record(role) for role in block._roles},
        "fixed": sorted(fixed),
        "jumps": jumps,
        "guard": block.guard and block.guard.policy,
        "opaque": block.opaque,
        "package": block.of_package,
        "units": dict(block.units),
        "dt": block.dt,
        "labels": labels,
    }


def _plain_jumps(
    block: Block, p: Any, begin: float, end: float, triggered: np.ndarray | None
) -> dict[str, Any] | None:
    """Return the breakpoints of a block: its period, or the list of its times."""
    jumps = block.breakpoints_function
    if jumps is None:
        return None
    if isinstance(jumps, Each):
        return {"period": jumps.period, "part": jumps.part}
    until = 3 * abs(end) + 1.0  # the engine looks ahead of the end
    if triggered is not None:
        return {"times": triggered, "until": until}
    times = [*block.breakpoints(min(begin, 0.0), 0.0, p)]
    times += [*block.breakpoints(0.0, until, p)]
    return {"times": np.unique(times), "until": until}


def _plain_value(value: Any) -> Any:
    if np.ndim(value):
        return {"shape": np.shape(value), "numbers": np.ravel(value)}
    return value if isinstance(value, int) else float(value)


def block_of(plain: Mapping[str, Any]) -> Block:
    """Return the block of plain data."""
    block = _sampled_block(plain) if "sampled" in plain else RecordedBlock(plain)
    for kind in KINDS:
        labels = plain["labels"][kind]
        count = getattr(block, f"n{kind}s")
        if len(labels) != count or not all(isinstance(n, str) for n in labels):
            raise BlockError(f"{block.name}: the labels of its {kind}s are missing")
        getattr(block, f"set_{kind}s")(list(labels))
    if "units" in plain:
        block.declare_units(plain["units"])
    return block


def _sampled_block(plain: Mapping[str, Any]) -> Block:
    block = Sampled(block_of(plain["inner"]), plain["sampled"])
    inner_names = {
        kind: {inner: outer for outer, inner in ports.items()}
        for kind, ports in plain["called"].items()
    }
    block._name_ports(inner_names)
    return block


class RecordedBlock(Block):
    """A block whose functions are records."""

    def __init__(self, plain: Mapping[str, Any]):
        name = plain["name"]
        shapes: dict[str, Any] = {
            f"{kind}s": _shapes(plain[f"{kind}s"]) for kind in KINDS
        }
        sizes = {str(size): size_of(number) for size, number in plain["sizes"].items()}
        self._role_records = {
            role: record_of(record) for role, record in plain["records"].items()
        }
        self.fixed = frozenset(plain["fixed"])
        self.of_package = plain["package"]
        # sizes are checked before arrays are allocated
        for kind in KINDS:
            ports = sized(name, shapes[f"{kind}s"], sizes)
            if sum(sizes_of(ports).values()) != len(plain["labels"][kind]):
                raise BlockError(f"{name}: its {kind}s are not as many as their labels")
        # functions are placeholders: `_read` and `_evaluate` use the records
        functions: dict[str, Any] = dict.fromkeys(self._role_records, other_equations)
        if "output" not in functions:
            shapes["outputs"] = None
        policy = plain["guard"]
        functions["guard"] = policy and Guard(
            functions["guard"], policy, partial(_guard_message, name)
        )
        super().__init__(
            name,
            **shapes,
            parameters={k: _value(value) for k, value in plain["parameters"].items()},
            shapes=_shapes(plain["shapes"]),
            sizes=sizes,
            opaque=plain["opaque"],
            breakpoints=_breakpoints(plain["jumps"]),
            **functions,
        )
        self.dt = plain["dt"]
        self.breakpoints(0.0, 0.0)  # raises for damaged breakpoints
        self._check_records()

    def _check_records(self) -> None:
        p = self.parameters._asdict()
        leaves = {
            "t": {"t": ()},
            "x": self.state_shapes,
            "u": self.input_shapes,
            "p": {k: np.shape(v) for k, v in p.items() if not isinstance(v, int)},
        }
        for role, record in self._role_records.items():
            check_record(record, leaves, self.sizes, self._roles[role][1])

    def _try_equations(self) -> None:
        """Do nothing: the records are checked instead."""

    def _read(self, role: str) -> Record | Unread:
        return self._role_records[role]

    def _evaluate(
        self, role: str, size: int, t: float, x: Any, u: Any, p: Any
    ) -> np.ndarray:
        return on_arrays(self, role, t, np.asarray(x), np.asarray(u), p)

    def with_values(self, changes: Mapping[str, Any]) -> Any:
        """Return changed parameters; raise `BlockError` for values that a record contains."""
        for field in self.fixed.intersection(changes):
            value = getattr(self.parameters, field)
            if not np.array_equal(changes[field], value):
                raise BlockError(
                    f"{self.name}.{field}: the record was made with its value, "
                    f"{value}, and is valid for no other"
                )
        return super().with_values(changes)


def _breakpoints(jumps: Mapping[str, Any] | None) -> Any:
    """Return the breakpoints of plain data as a block declares them."""
    if jumps is None:
        return None
    if "period" in jumps:
        return Each(**jumps)
    times = np.array([float(t) for t in jumps["times"]])
    return partial(_listed_breakpoints, times, float(jumps["until"]))


def _listed_breakpoints(
    times: np.ndarray, until: float, p: Any, t0: float, t1: float
) -> np.ndarray:
    """Return the listed breakpoints in (t0, t1]; the list ends at `until`."""
    if t1 > until:
        raise BlockError(
            f"jumps are recorded up to t = {until:g}; t = {t1:g} was requested"
        )
    return times[(times > t0) & (times <= t1)]


def _guard_message(name: str, t: float, u: Any, p: Any) -> str:
    return f"{name} reached the edge of where it may be used at t = {t:.9g}"


def _shapes(plain: Mapping[str, Any]) -> dict[str, Shape]:
    return {str(name): shape_of(shape) for name, shape in plain.items()}


def _value(plain: Any) -> Any:
    if isinstance(plain, dict):
        return np.array(plain["numbers"], dtype=float).reshape(shape_of(plain["shape"]))
    return plain if type(plain) is int else float(plain)
