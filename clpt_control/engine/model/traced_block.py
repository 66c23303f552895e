"""Ports and traced functions of a block: one record of array operations for each role.

A function is traced with open sizes, so that one record holds for every N.  If that fails, it is
traced with the sizes of its block.  Records are cached until a parameter, a port or a value that a
function references changes.
"""

from collections.abc import Callable, Mapping
from functools import cached_property, partial
from typing import Any

import control
import numpy as np

from ...base.arguments import attribute_of
from ...base.errors import BlockError
from ..conformance.confirmation import Confirmation
from ..record.graph import Operation, Record, Shape, compact, never_negative
from ..record.unread import Unread
from ..trace.tracing import Read, Request, read
from .declaration import Guard, check_units
from .ports import counts_of, labels, places, port_of, sized, sizes_of

READ = ("_read_records", "feedthrough")  # attributes that cache results of tracing
Shapes = dict[str, Shape]  # of ports or parameters by name


class ReadBlock(control.NonlinearIOSystem):
    """A block's ports, functions and their records; `Block` declares them."""

    update_function: Callable | None
    output_function: Callable | None
    jump_function: Callable | None = None
    breakpoints_function: Callable | None = None
    guard: Guard | None = None
    opaque = False
    declared: dict[str, Shapes]
    parameter_shapes: Mapping[str, Shape] = {}
    units: Mapping[str, str]
    approximation = ""  # what its equations stand for, if not exactly: said by verdicts
    parameters: Any
    _params: Any = None  # of a system of python-control
    _sizes: Mapping[str, int] = {}  # that no parameter has
    _inner: dict[str, dict[str, str]]  # a port's name -> what its equations call it

    # --- ports --------------------------------------------------------------------------

    def _inner_shapes(self, kind: str, shapes: Mapping[str, Any]) -> dict[str, Any]:
        """Return ports by the names that the equations use."""
        names = self._inner.get(kind, {})
        return {names.get(port, port): shape for port, shape in shapes.items()}

    def _bind(self) -> None:
        """Bind the sizes that have names, and lay the ports out."""
        sizes = dict(self._sizes)
        for field, shape in self.parameter_shapes.items():
            if field not in self._parameters._fields:
                raise BlockError(
                    f"{self.name}: `shapes` names {field!r}, which is not a parameter"
                )
            actual = np.shape(getattr(self._parameters, field))
            fits = len(actual) == len(shape) and all(
                sizes.setdefault(n, size) == size if isinstance(n, str) else n == size
                for n, size in zip(shape, actual, strict=True)
            )
            if not fits:
                expected = tuple(sizes.get(n, n) for n in shape)
                raise BlockError(
                    f"{self.name}.{field}: has shape {actual}; must be {expected}"
                )
        self.sizes = sizes
        kinds = ("states", "inputs", "outputs")
        # shapes in numbers
        self._sized = {
            kind: sized(self.name, self.declared[kind], sizes) for kind in kinds
        }
        self.state_shapes = self._sized["states"]
        self.input_shapes = self._sized["inputs"]
        self.output_shapes = self._sized["outputs"]
        # each role's function, and where its results lie
        self._plan = {
            role: (f, places(where)) for role, (f, where) in self._roles.items()
        }
        self._x = places(self._inner_shapes("states", self.state_shapes))
        self._u = places(self._inner_shapes("inputs", self.input_shapes))

    @property
    def input_ports(self) -> dict[str, int]:
        """Return the input ports and their numbers of signals."""
        return counts_of(self.input_labels)

    @property
    def output_ports(self) -> dict[str, int]:
        """Return the output ports and their numbers of signals."""
        return counts_of(self.output_labels)

    @property
    def state_ports(self) -> dict[str, int]:
        """Return the state ports and their numbers of signals."""
        return sizes_of(self.state_shapes)

    def units_of(self, kind: str) -> list[str]:
        """Return the unit of each "input", "output" or "state", "" for none."""
        return [
            self.units.get(port_of(label), "")
            for label in getattr(self, f"{kind}_labels")
        ]

    def declare_units(self, units: Mapping[str, str]) -> None:
        """Declare units of ports, also by their labels, and of parameters."""
        check_units(self.name, units, self._names_with_units())
        self.units = dict(units)

    def _names_with_units(self) -> dict[str, None]:
        """Return the names of ports, of labels and of parameters."""
        kinds = ("input", "output", "state")
        labelled = [counts_of(getattr(self, f"{kind}_labels")) for kind in kinds]
        groups = *labelled, self.parameters._fields
        return dict.fromkeys(name for group in groups for name in group)

    def _name_ports(self, names: Mapping[str, Mapping[str, str]]) -> None:
        """Rename ports, ``{"inputs": {old: new}}``; the equations keep their names."""
        for kind, new_names in names.items():
            old_names = self._inner.get(kind, {})
            ports = self.declared[kind]
            self._inner[kind] = {
                new_names.get(p, p): old_names.get(p, p) for p in ports
            }
            self.declared[kind] = {
                new_names.get(p, p): shape for p, shape in ports.items()
            }
            if len(self.declared[kind]) < len(ports):
                called = ", ".join(new_names.get(p, p) for p in ports)
                raise BlockError(
                    f"{self.name}: its {kind} would be {called}; each needs its own name"
                )
            own_units = {
                new_names[p]: unit for p, unit in self.units.items() if p in new_names
            }
            self.units = {**self.units, **own_units}
        self.parameters = self.parameters
        for kind, rename in (("input", self.set_inputs), ("output", self.set_outputs)):
            new_names = names.get(f"{kind}s", {})
            split_labels = [
                label.partition("[") for label in getattr(self, f"{kind}_labels")
            ]
            rename(
                [
                    "".join((new_names.get(port, port), *index))
                    for port, *index in split_labels
                ]
            )
        self.set_states(labels(self.state_ports) or 0)
        named = self._names_with_units()
        self.units = {name: unit for name, unit in self.units.items() if name in named}

    # --- records ------------------------------------------------------------------------

    @property
    def unsampled(self) -> Any:
        """Return the block, or the inner block of one that samples."""
        return getattr(self, "inner", self)

    @cached_property
    def states_are_outputs(self) -> bool:
        """True if the outputs are the states."""
        return self.output_function is None

    @cached_property
    def feedthrough(self) -> bool:
        """True if inputs reach the outputs directly, by the record."""
        try:
            return bool(self.array_record("output").leaves("u"))
        except Unread:
            return bool(self.ninputs)

    @property
    def _roles(self) -> dict[str, tuple[Callable, dict[str, Shape]]]:
        """Return each role's function and the shapes of what it returns."""
        states = self._inner_shapes("states", self.state_shapes)
        roles = {
            "update": (self.update_function, states),
            "output": (
                self.output_function,
                self._inner_shapes("outputs", self.output_shapes),
            ),
            "guard": (
                None if self.guard is None else self.guard.distance,
                {"distance": ()},
            ),
            "jump": (self.jump_function, states),
        }
        return {
            role: (f, shapes) for role, (f, shapes) in roles.items() if f is not None
        }

    def array_record(self, role: str) -> Record:
        """Return the record of "update", "output", "guard" or "jump".

        Raises `Unread` if the function cannot be traced.  Sizes that have names are open.
        """
        if role not in self._records:
            if role not in (*self._roles, "output"):
                raise BlockError(
                    f"{self.name}: role = {role!r}: must be among {', '.join(self._roles)}"
                )
            self._records[role] = self._read_now(role)
        record = self._records[role]
        if isinstance(record, Unread):
            raise record
        return record

    def _read_now(self, role: str) -> Record | Unread:
        if role == "output" and self.states_are_outputs:
            shapes = self.declared["outputs"]
            states = [
                Operation("leaf", (), shape, ("x", port))
                for port, shape in shapes.items()
            ]
            return compact(states, [*range(len(states))], shapes.values())
        return self._read(role)

    def _read(self, role: str) -> Record | Unread:
        """Trace a function with open sizes; if that fails, with the sizes of this block."""
        function, bound_out = self._roles[role]
        name = f"{self.name}.{role}"
        of_control = self._params is not None
        values = self._parameters._asdict()
        why = ""
        shapes = {f: np.shape(v) for f, v in values.items() if not isinstance(v, int)}
        for stay_open in (True, False) if self.sizes else (False,):
            declared = self.declared if stay_open else self._sized
            x, u, y = (self._inner_shapes(kind, declared[kind]) for kind in self._sized)
            out = {"guard": bound_out, "output": y}.get(role, x)
            p = {**shapes, **self.parameter_shapes} if stay_open else shapes
            try:
                request = Request(
                    function,
                    role if of_control else name,
                    x,
                    u,
                    self._params if of_control else values,
                    p,
                    out,
                    of_control,
                    trusted=self.of_package and not of_control,
                    confirm=partial(self._difference, role),
                )
                result = read(request)
            except (Unread, BlockError) as error:
                if isinstance(error, BlockError) and not stay_open:
                    if of_control:  # a run calls the function, as python-control does
                        return Unread(f"{self.name}.{error}")
                    raise
                why = str(error)
                continue
            (distance, *_) = result.record.outputs or (0.0,)
            is_number = role != "guard" or isinstance(distance, float)
            if not is_number and never_negative(result.record, distance):
                raise BlockError(
                    f"{name}: its distance is never below 0, so no run leaves it. Return a "
                    "number that is negative outside, as 3 - t"
                )
            self.read_with[role] = result.pinned, why
            self._note(role, result)
            return self._outside(result.record)
        return Unread(f"{name}: {why}")

    def _note(self, role: str, result: Read) -> None:
        """Note what else a function of python-control's has read."""

    def _difference(self, role: str, result: Read) -> str:
        """Return a sentence on a new record that Python does not confirm, or ""."""
        given = {**self.parameters._asdict(), **(self._params or {})}
        free = tuple(
            name
            for name in self.parameters._fields
            if name not in (*result.pinned, "interval")
            and not isinstance(given[name], int | np.integer)
        )
        record = self._outside(result.record)
        conditions = self._outside(result.conditions)
        return Confirmation(self, role, record, conditions, free).difference()

    @cached_property
    def of_package(self) -> bool:
        """True if the functions are the package's own."""
        modules = (attribute_of(f, "__module__") or "" for f, _ in self._plan.values())
        return all(
            name.startswith(f"{__package__.partition('.')[0]}.") for name in modules
        )

    def read_anew(self) -> None:
        """Trace the functions again, after a change of their values."""
        if self.of_package:
            return
        for role, old in list(self._records.items()):
            new = self._read_now(role)
            if new != old and str(new) != str(old):
                self._forget()
                return

    def _forget(self) -> None:
        """Clear the cached records."""
        # by role: parameters whose values were read, and why no size is open
        self.read_with: dict[str, tuple[frozenset[str], str]] = {}
        for attribute in READ:
            self.__dict__.pop(attribute, None)

    def _outside(self, record: Record) -> Record:
        """Return a record whose leaves have the names of the ports."""
        names = {
            (group, inner): (group, outer)
            for group, kind in (("x", "states"), ("u", "inputs"))
            for outer, inner in self._inner.get(kind, {}).items()
        }
        return record.renamed(names) if names else record

    @property
    def records(self) -> dict[str, Record]:
        """Return the record of each of its functions, by role."""
        return {
            role: self.array_record(role) for role in {**self._roles, "output": None}
        }

    @property
    def _records(self) -> dict[str, Record | Unread]:
        return self.__dict__.setdefault("_read_records", {})
