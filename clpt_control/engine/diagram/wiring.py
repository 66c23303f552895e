"""Wiring of an interconnected system: a diagram as an ordered list of blocks.

python-control stores a diagram as matrices: `connect_map` (block outputs to block inputs),
`input_map` and `output_map`.  `wiring_of` returns them as a list of blocks.  In its order
(`evaluation_order`) one pass computes every signal once.  The engine, the proofs and the drawing
all use this list.

`as_part` converts a system to a part of a diagram: a `control.ss`, `tf` or summing junction becomes
a block of A, B, C, D.  If all systems have the same discrete time, the diagram is discrete.
Otherwise each discrete system becomes a block that samples its inputs.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import control
import numpy as np

from ...base.arguments import attribute_of, has, known, vector_of
from ...base.errors import ArgumentError, DiagramError
from ...base.labelled import Labelled, axes_of, check_complete, labelled
from ..model.block import Block
from ..model.ports import indices_by_name, port_of, ports_of
from ..model.sampled import Sampled
from ..model.system import System, linear
from .block_numbers import (
    Given,
    Params,
    Part,
    Sizes,
    blocks_of,
    check_params,
    check_unit,
    values_of,
)
from .evaluation_order import order_of

# a sum of signals: block output k, or diagram input ~k -> its gain
Row = dict[int, float]


class Wire(NamedTuple):
    """Connection of consecutive signals, ``u += gain * source``."""

    to: int  # first of the block's inputs
    source: int  # first signal among all block outputs, or among the diagram's inputs
    size: int  # number of consecutive signals
    gain: float
    external: bool  # true if the source is an input of the diagram


@dataclass(frozen=True)
class Node:
    """A block and the indices of its signals in the diagram."""

    system: Part
    name: str  # inside a nested diagram ``"outer.inner"``
    states: slice  # among the states of the diagram
    inputs: slice  # among all block inputs
    outputs: slice  # among all block outputs
    rows: tuple[Row, ...]  # sources of each input

    def fed(self, external: bool = False) -> Iterator[tuple[int, int, float]]:
        """Yield (input, source, gain) for sources in blocks, or for the diagram's inputs."""
        for to, row in enumerate(self.rows):
            for k, gain in row.items():
                if (k < 0) is external:
                    yield to, ~k if external else k, gain

    def external_input(self, port: str) -> int | None:
        """Return the input of the diagram that alone feeds a port of one signal, or None."""
        fed = zip(self.system.input_labels, self.rows, strict=False)
        rows = (row for label, row in fed if port_of(label) == port)
        sources = [*next(rows, {}).items()]
        if len(sources) == 1 and sources[0][0] < 0 and sources[0][1] == 1.0:
            return ~sources[0][0]
        return None

    @cached_property
    def wires(self) -> tuple[Wire, ...]:
        """Wires to the block's inputs; wires from the diagram's inputs are the last."""
        wires: list[Wire] = []
        for external in (False, True):
            # the signal that would continue a wire -> the index of the wire
            continuing: dict[tuple, int] = {}
            for to, source, gain in sorted(self.fed(external)):
                k = continuing.pop((to, source, gain), len(wires))
                if k == len(wires):
                    wires.append(Wire(to, source, 0, gain, external))
                wires[k] = wires[k]._replace(size=wires[k].size + 1)
                continuing[to + 1, source + 1, gain] = k
        return tuple(wires)


@dataclass(frozen=True)
class Wiring:
    """A diagram as an ordered list of blocks."""

    nodes: tuple[Node, ...]  # in the diagram's own order
    order: tuple[int, ...]  # indices into `nodes`, in the order of evaluation
    ninputs: int
    outputs: tuple[Row, ...]
    dt: Any  # 0, the period of a discrete diagram, or True

    @property
    def blocks(self) -> list[tuple[str, Any]]:
        """The blocks with their names."""
        return [(node.name, node.system) for node in self.nodes]

    def parameters(self, params: Params = None) -> list[Any]:
        """Return the parameters of each block, changed by the params of a call."""
        check_params(Given("params", 0, params or {}), self.blocks)
        return [
            block.with_values(values_of(name, block, params or {}))
            for name, block in self.blocks
        ]

    def outputs_of(self, signals: Any, inputs: Any) -> np.ndarray:
        """Return the diagram's outputs; signals of blocks and inputs are on last axes."""
        y = np.zeros((*np.shape(signals)[:-1], len(self.outputs)))
        for to, row in enumerate(self.outputs):
            terms = [
                gain * (signals[..., k] if k >= 0 else inputs[..., ~k])
                for k, gain in row.items()
            ]
            if terms:  # added in their order, for equal rounding; the first keeps its sign of zero
                y[..., to] = sum(terms[1:], terms[0])
        return y


# --- nested diagrams as one list of blocks -------------------------------------------------------


def _flatten(system: Part, name: str) -> tuple[list[Row], list[Row]]:
    """Return the rows of the inputs of a system's blocks, and the rows of its outputs."""
    if not isinstance(system, control.NonlinearIOSystem):
        raise DiagramError(
            f"{name} is a {type(system).__name__}: must be a diagram of blocks, or a "
            "system with states, "
            "such as control.ss(...)"
        )
    if not isinstance(system, control.InterconnectedSystem):
        inputs = [{~k: 1.0} for k in range(system.ninputs or 0)]
        return inputs, [{k: 1.0} for k in range(system.noutputs or 0)]

    # rows inside the subsystems; k is an output of a block, ~k an input of a subsystem
    block_inputs = []
    outputs = []
    first_output = first_input = 0
    for subsystem in system.syslist:
        inner_inputs, inner_outputs = _flatten(subsystem, subsystem.name)
        block_inputs += [
            _shifted(row, first_output, first_input) for row in inner_inputs
        ]
        outputs += [_shifted(row, first_output, first_input) for row in inner_outputs]
        first_output += sum(int(leaf.noutputs or 0) for _, leaf in leaves([subsystem]))
        first_input += int(subsystem.ninputs or 0)

    connections = _entries(system.connect_map)
    external = _entries(system.input_map)
    resolved: dict[int, Row | None] = {}

    def input_row(k: int) -> Row:
        """Return the row of an input of a subsystem."""
        if k not in resolved:
            resolved[k] = None  # while its sources are resolved
            sources = [
                (resolve(outputs[j]), gain) for j, gain in connections.get(k, ())
            ]
            outer = {~j: gain for j, gain in external.get(k, ())}
            resolved[k] = _sum([(outer, 1.0), *sources])
        row = resolved[k]
        if row is None:
            raise DiagramError(
                f"{name}: nested diagrams feed each other without a block"
            )
        return row

    def resolve(row: Row) -> Row:
        """Return a row of the subsystems as a row of the whole system."""
        return _sum(
            [({k: 1.0} if k >= 0 else input_row(~k), gain) for k, gain in row.items()]
        )

    # an output of the system is a sum of outputs and, after them, inputs of subsystems
    n = len(outputs)
    sources = _entries(system.output_map)
    output_rows = [
        _sum(
            [
                (resolve(outputs[k]) if k < n else input_row(k - n), g)
                for k, g in sources.get(to, ())
            ]
        )
        for to in range(len(system.output_map))
    ]
    return [resolve(row) for row in block_inputs], output_rows


def _shifted(row: Row, outputs: int, inputs: int) -> Row:
    return {k + outputs if k >= 0 else k - inputs: gain for k, gain in row.items()}


def _sum(terms: Iterable[tuple[Row, float]]) -> Row:
    """Return the sum of rows, each with its factor."""
    total: Row = {}
    for row, factor in terms:
        for k, gain in row.items():
            total[k] = total.get(k, 0.0) + factor * gain
    return total


def _entries(matrix: np.ndarray) -> dict[int, list[tuple[int, float]]]:
    """Return the rows of a matrix: (column, number) of each entry that is not 0."""
    rows: dict[int, list[tuple[int, float]]] = {}
    for i, j in np.argwhere(matrix).tolist():
        rows.setdefault(i, []).append((j, float(matrix[i, j])))
    return rows


def leaves(
    systems: Iterable[Part], separator: str = ".", path: str = ""
) -> Iterator[tuple[str, Part]]:
    """Yield the systems of a diagram and of nested diagrams with their names."""
    for system in systems:
        if isinstance(system, control.InterconnectedSystem):
            yield from leaves(
                system.syslist, separator, f"{path}{system.name}{separator}"
            )
        else:
            yield path + system.name, system


def units_of(wiring: Wiring) -> tuple[list[str], list[str]]:
    """Return the units of all block outputs, and of the diagram's inputs; "" if there is none.

    A signal without a unit of its own has the unit of a block input that reads it.
    """
    outputs = [unit for node in wiring.nodes for unit in node.system.units_of("output")]
    inputs = [""] * wiring.ninputs
    for node in wiring.nodes:
        input_units = node.system.units_of("input")
        for units, external in ((outputs, False), (inputs, True)):
            for to, source, gain in node.fed(external):
                if gain == 1.0:
                    units[source] = units[source] or input_units[to]
    return outputs, inputs


def wiring_of(
    diagram: Part,
    params: Params = None,
    sizes: Sizes = (None, None),
    complete: bool = True,
) -> Wiring:
    """Return the wiring of a diagram, nested ones included, of blocks alone.

    The arguments are those of `blocks_of`.  An algebraic loop is refused.
    """
    inputs, outputs = _flatten(diagram, getattr(diagram, "name", repr(diagram)))
    blocks = blocks_of(diagram, params, sizes, complete)
    if not blocks:
        raise DiagramError(f"{diagram.name}: has no blocks. Give at least one")
    if None in (diagram.nstates, diagram.ninputs, diagram.noutputs):
        # its block knows the sizes
        ((name, diagram),) = blocks
        inputs, outputs = _flatten(diagram, name)
    return ordered_wiring(
        blocks, inputs, int(diagram.ninputs or 0), outputs, diagram.dt or 0
    )


def read_anew(system: Any) -> None:
    """Trace the functions of a diagram's blocks again: objects that they use may have changed."""
    for subsystem in getattr(system, "syslist", [system]):
        if isinstance(subsystem, control.InterconnectedSystem):
            read_anew(subsystem)
        elif isinstance(subsystem, Block):
            subsystem.read_anew()


def ordered_wiring(
    blocks: Sequence[tuple[str, Part]],
    inputs: Sequence[Row],
    ninputs: int,
    outputs: Iterable[Row],
    dt: Any = 0,
    order: tuple[int, ...] = (),
) -> Wiring:
    """Return the wiring of named blocks; `inputs` has the row of each block input, in order.

    Without `order`, the order of evaluation is computed.
    """
    nodes, x, u, y = [], 0, 0, 0
    for name, block in blocks:
        states = slice(x, x := x + block.nstates)
        own_inputs = slice(u, u := u + block.ninputs)
        own_outputs = slice(y, y := y + block.noutputs)
        rows = [
            {k: gain for k, gain in row.items() if gain} for row in inputs[own_inputs]
        ]
        nodes.append(Node(block, name, states, own_inputs, own_outputs, tuple(rows)))
    order = order or order_of(nodes)
    return Wiring(tuple(nodes), order, ninputs, tuple(outputs), dt)


# --- parts of a diagram ------------------------------------------------------------------------


def as_part(system: Any, discrete: bool = False) -> Part:
    """Return a system as a part of a diagram; refuse any other object.

    A system of discrete time samples its inputs, unless the whole diagram is `discrete`.
    """
    system = _checked(system)
    return system if discrete or not is_discrete(system) else sampled(system, system.dt)


def is_discrete(*systems: Any) -> bool:
    """Return whether systems have one discrete time, as python-control combines them."""
    times = [
        dt for dt in (getattr(system, "dt", 0) for system in systems) if dt is not None
    ]
    # not a difference of sets: True == 1.0
    periods = {dt for dt in times if dt is not True}
    return bool(times) and 0 not in times and len(periods) < 2


def sampled(system: Part, period: float, params: Params = None) -> Part:
    """Return a discrete system as one of continuous time, a diagram block by block.

    `params` come from the diagram around the system.
    """
    if period is True:
        raise DiagramError(
            f"{system.name}: dt = True is not a sampling time. Give dt a number"
        )
    params = {**system.params, **(params or {})}
    if isinstance(system, control.InterconnectedSystem):
        diagram = control.InterconnectedSystem(
            [sampled(inner, period, params) for inner in system.syslist],
            inputs=system.input_labels,
            outputs=system.output_labels,
            name=system.name,
            params=system.params,
        )
        diagram.set_connect_map(system.connect_map)
        diagram.set_input_map(system.input_map)
        diagram.set_output_map(system.output_map)
        return diagram
    if not isinstance(system, Block):
        is_linear = isinstance(system, control.StateSpace)
        system = linear(system) if is_linear else System(system, params)
    return Sampled(system, period)


def _checked(system: Any) -> Part:
    if isinstance(system, Block):
        return system
    kind = type(system).__name__
    if not isinstance(system, control.NonlinearIOSystem | control.TransferFunction):
        value = f"a {kind}" if has(system, "name") else f"{system!r:.60}"
        raise DiagramError(
            f"{value} is not a block. Give a clpt.Block, a diagram, or control.ss, tf or nlsys"
        )
    if system.name is None or system._generic_name_check():
        raise DiagramError(
            f"a {kind} without a name: parts and their parameters are called by "
            "name. Give it one, such as control.ss(A, B, C, D, name='lag')"
        )
    if None in (system.ninputs, system.noutputs):
        raise DiagramError(
            f"{system.name}: the numbers of inputs and outputs are unknown. Give inputs= and "
            "outputs= to control.nlsys"
        )
    if isinstance(system, control.InterconnectedSystem):
        return system
    is_linear = isinstance(system, control.StateSpace | control.TransferFunction)
    return linear(system) if is_linear else system


def input_ports(system: Part) -> dict[str, list[int]]:
    """Return the input ports of a system, each with the indices of its signals."""
    return ports_of(system.input_labels)


def output_ports(system: Part) -> dict[str, list[int]]:
    """Return the output ports of a system, each with the indices of its signals."""
    return ports_of(system.output_labels)


# --- signals of a system by name: {"angle": 0.5}, of labels or ports ------------------------------


def columns_of(system: Any, kind: str, labels: Sequence[str], name: Any) -> list[int]:
    """Return the columns of a label or port; refuse an unknown name."""
    names = indices_by_name(labels)
    key = name if name in names else str(name).replace(".", "_")  # of plant.angle
    if key not in names:
        raise ArgumentError(
            f"{system.name}: has no {kind} '{name}'. {known(key, ports_of(labels))}"
        )
    return names[key]


def signals_by_name(
    argument: str, system: Any, kind: str, value: Any, given: Mapping[str, Labelled]
) -> Iterator[tuple[str, list[int], Labelled]]:
    """Yield argument, columns and values of each name; refuse other names and units.

    `value` is what was given: a dict may leave out signals.
    """
    labels = getattr(system, f"{kind}_labels")
    if len(labels) != getattr(system, f"n{kind}s"):
        raise ArgumentError(
            f"{argument}: {system.name} has {kind}s of one name. Give an array"
        )
    names = indices_by_name(labels)
    found: set[str] = set()
    for name, signal in given.items():
        if isinstance(value, control.TimeResponseData) and name not in names:
            continue
        columns = columns_of(system, kind, labels, name)
        words = f"{argument}['{name}']"
        own_labels = [labels[k] for k in columns]
        if isinstance(value, dict) and has(value[name], "signal_labels"):
            check_positions(words, value[name], own_labels)
        signal = signal._replace(values=signal.ordered(words, own_labels))
        if not found.isdisjoint(own_labels):
            raise ArgumentError(f"{words}: is given twice. Leave out one")
        found |= {*own_labels}
        if signal.units:
            wiring = wiring_of(system)
            units = state_units(wiring) if kind == "state" else units_of(wiring)[1]
            check_unit(words, signal.units, [units[k] for k in columns])
        yield words, columns, signal
    if has(value, "coords") or not isinstance(value, Mapping):
        check_complete(argument, labels, found, given)


def state_units(wiring: Wiring) -> list[str]:
    """Return the unit of each state, "" for none."""
    return [unit for node in wiring.nodes for unit in node.system.units_of("state")]


def check_rows(argument: str, values: Any, count: int) -> None:
    """Refuse values of other signals than `count`."""
    if len(values) != count:
        raise ArgumentError(
            f"{argument}: has {len(values)} rows. Give {count}, one per signal"
        )


def check_positions(argument: str, value: Any, labels: Sequence[str]) -> None:
    """Refuse values in a list, or one for all, whose own name is that of another signal.

    Names of python-control's rows stay in their order when rows are selected.
    """
    if axes_of(value) == []:
        value = [value] * len(labels)
    own = attribute_of(value, "signal_labels")
    if isinstance(value, list | tuple):
        own = [attribute_of(item, "name") for item in value]
    if own and len(own) == len(value):
        names = indices_by_name(labels)
        for k, name in enumerate(own[: len(labels)]):
            if names.get(name, [k]) != [k]:
                raise ArgumentError(
                    f"{argument}: has '{name}' in place of another signal. "
                    "Give a dict by name"
                )


def vector_by_name(
    argument: str, system: Any, kind: str, value: Any, default: Any = None
) -> Any:
    """Return states or inputs given by name as a vector, others in it the default or 0."""
    if value is None:
        return 0.0 if default is None else default
    given = labelled(argument, value)
    labels = getattr(system, f"{kind}_labels")
    if not isinstance(given, dict):
        check_positions(argument, value, labels)
        return given
    vector = np.zeros(len(labels))
    vector += 0.0 if default is None else default
    signals = signals_by_name(argument, system, kind, value, given)
    for words, columns, signal in signals:
        values = signal.values.ravel()
        values = values[0] if len(values) == 1 else values
        vector[columns] = vector_of(words, values, len(columns))
    return vector
