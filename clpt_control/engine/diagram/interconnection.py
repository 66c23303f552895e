"""Interconnection of blocks by the names of their ports, with `control.interconnect`.

python-control adds two outputs of the same name, warns about an input without a source, gives
systems whose params share a name the value of the last system, and ignores an unknown parameter.
Here all four are errors that name the block and the port.
"""

from collections.abc import Callable, Iterable, Sequence
from typing import Any, NamedTuple

import control
import numpy as np

from ...base.arguments import attribute_of, brief, has, nearest, public
from ...base.errors import DiagramError
from ..model.block import Block
from ..model.declaration import Guard, Parameters, check_names, ports_line, same_unit
from ..model.ports import Vector, counts_of, labels, spans_of, vector, whole_labels
from ..model.sampled import Sampled
from ..record.unread import check_call
from ..trace.arrays import Array
from ..trace.tracing import Ports
from .block_numbers import blocks_of, own_params, parts_of
from .wiring import (
    Params,
    Part,
    Wiring,
    as_part,
    input_ports,
    is_discrete,
    ordered_wiring,
    output_ports,
    wiring_of,
)

# attributes that plots of python-control read first
OF_PLOTS = ("plot_phase", "response", "frdata")
MOST_BYTES = 10**9  # bytes of python-control's matrices


class Diagram(control.InterconnectedSystem):
    """A python-control diagram whose parameter names are checked.

    Made by `connect`; everything else is python-control's own.

    Attributes
    ----------
    origin : object or None
        The arguments of `closed_loop`: its scenario, and the user's own parts.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> clpt.closed_loop(clpt.paper_scenario()).nstates
    14
    """

    origin: Any = None

    def __repr__(self) -> str:
        from ...base.html import shortened

        ports = (self.input_labels, self.output_labels)
        flows = " -> ".join(ports_line(counts_of(labels)) for labels in ports)
        size = f"{len(self.syslist)} blocks, {self.nstates or 0} states"
        return f"<Diagram {shortened(self.name, 60)}: {size}; {flows}>"

    def _repr_html_(self) -> str | None:
        from ...base.notebook_display import diagram_html

        return diagram_html(self)

    def _repr_markdown_(self) -> None:
        """Return nothing in place of python-control's, which would repeat the drawing."""

    def __getattr__(self, name: str) -> Any:
        """Name the remedy if python-control needs a linear system, as for a Bode plot."""
        reason = "not an attribute"
        if name in OF_PLOTS or hasattr(control.StateSpace, name):
            reason = (
                "of linear systems. Give python-control clpt.linearize(diagram, x, u)"
            )
        raise AttributeError(f"Diagram.{name}: is {reason}", name=name, obj=self)

    def linearize(self, *point: Any, **options: Any) -> control.StateSpace:
        """Linearize as python-control does; refuse sampled blocks."""
        for name, block in blocks_of(self):
            if isinstance(block, Sampled):
                raise DiagramError(
                    f"{self.name}: {name} samples its inputs, which control.linearize does not "
                    "see. Call clpt.linearize, which gives the discrete system of the loop"
                )
        return super().linearize(*point, **options)

    def _update_params(self, params: Params) -> None:
        params = dict(params or {})
        # a diagram around this one has checked the names
        is_nested = any(has(value, "_fields") for value in params.values())
        is_nested |= bool(self.params) and set(self.params) <= set(params)
        if params and not is_nested:
            blocks_of(self, params)
        for _, part, values, _ in parts_of(self, own_params(self.name, params)):
            if isinstance(part, Block):  # whose names begin with its own
                values = {f"{part.name}.{key}": v for key, v in values.items()}
            part._update_params(values)


class Port(NamedTuple):
    """A port of one of the blocks that are connected."""

    block: int  # index of the block
    # indices of the port's signals among the block's inputs or outputs
    signals: list[int]


class MatchedPorts(NamedTuple):
    """The ports of blocks, matched by name."""

    sources: dict[str, Port]  # outputs
    users: dict[str, list[Port]]  # inputs
    external: dict[str, int]  # name -> number of signals of each input of the diagram


def match_ports(blocks: Sequence[Part], external: Iterable[str]) -> MatchedPorts:
    """Match the ports of blocks; refuse duplicate sources, missing sources and different sizes."""
    external, names = list(external), [block.name for block in blocks]
    if not blocks:
        raise DiagramError("diagram: no blocks. Give at least one")
    for name in names:
        if names.count(name) > 1:
            raise DiagramError(f"two blocks are called '{name}'. Rename one")
    sources: dict[str, Port] = {}
    users: dict[str, list[Port]] = {}
    for k, block in enumerate(blocks):
        for name, signals in output_ports(block).items():
            if name in sources:
                raise DiagramError(
                    f"'{name}' is made by both {names[sources[name].block]} and {block.name}: "
                    "python-control would add them. Rename one port, or wire diagrams by "
                    "control.interconnect"
                )
            sources[name] = Port(k, signals)
        for name, signals in input_ports(block).items():
            users.setdefault(name, []).append(Port(k, signals))

    for name, ports in users.items():
        if name in sources:
            ports = [sources[name], *ports]
        elif name not in external:
            available = sorted({*sources, *external})
            close = nearest(name, available)
            suggestion = f"; did you mean {close}?" if close else ""
            user = blocks[ports[0].block]
            breaks = attribute_of(user, "breakpoints_function")
            rises = attribute_of(breaks, "trigger") == name
            raise DiagramError(
                f"'{name}', an input of {names[ports[0].block]}, is made by no block"
                f"{suggestion}; there are {', '.join(available)}. Give it one of these names (a "
                "linear system, or the plant of an observer: control.ss(plant, inputs=[...], "
                f"outputs=[...])); or external='{name}' supplies it from outside"
                + ", where each rise above 1/2 is an event"
                * rises
            )
        _check_fit(name, ports, blocks)

    for name in external:
        if name in sources or name not in users:
            is_output = name in sources
            why = (
                f"{names[sources[name].block]} makes it"
                if is_output
                else "no block takes it"
            )
            raise DiagramError(
                f"'{name}' cannot come from outside: {why}; blocks take {', '.join(sorted(users))}"
            )
    return MatchedPorts(
        sources, users, {name: len(users[name][0].signals) for name in external}
    )


def _check_fit(name: str, ports: Sequence[Port], blocks: Sequence[Part]) -> None:
    """Refuse ports of one name that have different sizes or units."""
    size, declared_unit = len(ports[0].signals), ""
    for port in ports:
        block = blocks[port.block]
        if len(port.signals) != size:
            raise DiagramError(
                f"'{name}' has {size} signals, but {block.name} takes {len(port.signals)}; both "
                f"must have one size: label them {name}[0], {name}[1], or give a part signals="
            )
        unit = getattr(block, "units", {}).get(name)
        if unit and not declared_unit:
            declared_unit, owner = unit, block.name
        elif unit and not same_unit(unit, declared_unit):
            raise DiagramError(
                f"'{name}' is in '{declared_unit}' at {owner} and in '{unit}' at {block.name}. "
                "Give it one unit, or put a block between that converts it"
            )


@public
def connect(
    blocks: Sequence[Any], external: str | Iterable[str] = (), name: str = "diagram"
) -> Diagram:
    """Wire blocks by the names of their ports, and check the fit.

    Parameters
    ----------
    blocks : sequence of Block or control.InputOutputSystem
        Blocks; diagrams; python-control's ``ss``, ``tf``, ``summing_junction`` and ``nlsys``.
        Each output port feeds every input port of the same name; the labels ``v_c[0], v_c[1]``
        of a system are its port ``v_c``, another label is a port of one signal.
    external : str or iterable of str, optional
        Ports that come from outside: they become the diagram's inputs.
    name : str, optional
        Name of the diagram.

    Returns
    -------
    Diagram
        With every output port of every block as outputs. A linear system is a block with the
        parameters A, B, C, D, as ``"lag.A"``. Systems of one discrete time make a diagram of
        it; beside others such a system samples its inputs at each multiple of its ``dt`` and
        holds its outputs between.

    Raises
    ------
    DiagramError
        If two blocks make the same port, a port is fed by nothing, sizes, units or values of one
        param differ, an external port is made or not used, a system has no name, or
        the diagram is larger than python-control can hold.

    Examples
    --------
    >>> import control
    >>> from clpt_control.paper.blocks import clpe, vehicle
    >>> diagram = connect([vehicle.vehicle(), clpe.clpe()], external=["flow_x", "v_x", "z"])
    >>> diagram.output_labels
    ['x[0]', 'x[1]', 'e[0]', 'e[1]']
    >>> error = control.summing_junction(["r", "-y"], "e", name="error")
    >>> plant = control.tf(1, [1, 0], inputs="e", outputs="y", name="plant")
    >>> float(control.linearize(connect([error, plant], external="r"), [0], [0]).A[0, 0].round(3))
    -1.0
    """
    external = [external] if isinstance(external, str) else external
    discrete = is_discrete(*blocks)
    systems = [as_part(block, discrete) for block in blocks]
    check_names(name)
    sources, users, outside = match_ports(systems, external)
    _check_params(systems)
    _check_size(name, systems)
    connections = [
        [(user.block, to), (source.block, signal)]
        for port, source in sources.items()
        for user in users.get(port, ())
        for to, signal in zip(user.signals, source.signals, strict=True)
    ]
    inputs = [
        [(user.block, user.signals[k]) for user in users[port]]
        for port, size in outside.items()
        for k in range(size)
    ]
    diagram = control.interconnect(
        systems,
        connections=connections or False,
        inplist=inputs,
        outlist=[
            (source.block, k) for source in sources.values() for k in source.signals
        ],
        inputs=labels(outside),
        outputs=labels({port: len(source.signals) for port, source in sources.items()}),
        name=name,
        check_unused=False,
    )
    diagram.__class__ = Diagram
    return diagram


def _check_params(systems: Sequence[Part]) -> None:
    """Refuse a param with two values, of which python-control would use the last."""
    owners: dict[str, Part] = {}
    for system in systems:
        for key, value in system.params.items():
            owner = owners.setdefault(key, system)
            if not isinstance(value, Parameters) and not np.array_equal(
                owner.params[key], value
            ):
                raise DiagramError(
                    f"{key} = {brief(value)} of {system.name} is {brief(owner.params[key])} of "
                    f"{owner.name}: python-control would use the last value for both. "
                    "Rename one, or give "
                    f"both one value and call with params={{'{owner.name}.{key}': ...}}"
                )


def _check_size(name: str, systems: Sequence[Part]) -> None:
    """Refuse a diagram for which python-control's full matrices are too large."""
    ninputs = sum(system.ninputs for system in systems)
    noutputs = sum(system.noutputs for system in systems)
    size = 8 * (2 * ninputs + noutputs) * noutputs  # bytes
    if size > MOST_BYTES:
        raise DiagramError(
            f"{name or 'the diagram'}: has {noutputs} signals, for which python-control needs "
            f"{size / 1e9:.1f} GB; at most {MOST_BYTES / 1e9:g} GB: take fewer basis functions, or "
            "simulate the scenario itself"
        )


def wiring_of_blocks(blocks: Sequence[Part], external: Iterable[str] = ()) -> Wiring:
    """Return `wiring_of(connect(blocks, external))`; if all are blocks, without its matrices."""
    if not all(isinstance(block, Block) for block in blocks):
        return wiring_of(connect(blocks, external))
    inputs = labels(match_ports(blocks, external).external)
    outputs = [label for block in blocks for label in whole_labels(block.output_labels)]
    signals = {label: k for k, label in enumerate(outputs)}
    signals |= {label: ~k for k, label in enumerate(inputs)}
    rows = [
        {signals[label]: 1.0}
        for block in blocks
        for label in whole_labels(block.input_labels)
    ]
    named = [(block.name, block) for block in blocks]
    return ordered_wiring(
        named, rows, len(inputs), [{k: 1.0} for k in range(len(outputs))]
    )


# --- a condition that ends a run: stop(t, y, u) > 0 continues it, it ends at the fall to 0 --------


STOP = "stop"  # name of the block


class _ByLabel:
    """Access to the ports of a vector by ``y["angle"]``, as by ``y.angle``."""

    def __getattribute__(self: Any, name: str) -> Any:
        if name in super().__getattribute__("_ports"):  # even if arrays have it: y.size
            return self.__getattr__(name)
        return super().__getattribute__(name)

    def __getitem__(self: Any, index: Any) -> Any:
        if isinstance(index, str):
            return self.__getattr__(index)
        return super().__getitem__(index)  # type: ignore[misc]


class _Numbers(_ByLabel, Vector):
    """Numbers with ports."""


class _Tracers(_ByLabel, Ports):
    """Tracer array with ports."""


def by_name(values: Any, ports: Any) -> Any:
    """Return a vector with ports, slices and shapes by name."""
    if isinstance(values, Array):
        return _Tracers.of(values, ports)
    named = vector(values, ports).view(_Numbers)
    named._ports = ports
    return named


def with_stop(
    wiring: Wiring,
    stop: Callable[[float, Any, Any], Any],
    outputs: Sequence[str],
    inputs: Sequence[str],
) -> Wiring:
    """Return the wiring with a block that reads labelled outputs and inputs, and ends the run."""
    if not callable(stop):
        raise DiagramError(
            f"stop = {brief(stop)}: must be a function of t, outputs and inputs"
        )
    needs = "stop: must take t, outputs and inputs, as lambda t, y, u: y[0] - 1"
    check_call(stop, DiagramError, 3, needs)
    if wiring.dt:
        raise DiagramError(
            f"stop: a diagram of discrete time (dt = {wiring.dt}) has no values between "
            "its samples "
            "to cross. Look at the samples of a whole run"
        )

    # a port of one signal is a number
    ports = [
        {
            name: (span, (size,) if (size := span.stop - span.start) > 1 else ())
            for name, span in spans_of(labels).items()
        }
        for labels in (outputs, inputs)
    ]

    def distance(t, x, u, p):
        value = stop(t, *map(by_name, (u.y, u.u), ports))
        is_truth = isinstance(value, bool) or attribute_of(value, "dtype") == np.bool_
        return np.where(value, 1.0, -1.0) if is_truth else value

    def sentence(t: float, u: np.ndarray, p: Any) -> str:
        return f"`{attribute_of(stop, '__name__', 'stop')}` fell to 0 at t = {t:.9g}"

    ninputs = wiring.ninputs
    block = Block(
        STOP,
        output=lambda t, x, u, p: {},
        inputs={"y": len(wiring.outputs), "u": ninputs},
        outputs={},
        guard=Guard(distance, "stop", sentence),
    )
    rows = [row for node in wiring.nodes for row in node.rows]
    rows += [*wiring.outputs, *({~k: 1.0} for k in range(ninputs))]
    order = (*wiring.order, len(wiring.nodes))
    return ordered_wiring(
        [*wiring.blocks, (STOP, block)], rows, ninputs, wiring.outputs, order=order
    )
