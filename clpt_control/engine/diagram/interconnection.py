"""Wire blocks by the names of their ports, with `control.interconnect`.

python-control adds two outputs of one name, warns of an input that nothing
feeds, gives systems whose params have one name the value of the last, and passes over a mistyped
parameter; here all four are errors that name the block and the port.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import control
import numpy as np

from ...arguments import brief, nearest, public
from ...base.notebook_display import diagram_html
from ...errors import BlockError, DiagramError
from ...html import shortened
from ..model.block import Block
from ..model.declaration import Guard, Parameters, check_names, ports_line, same_unit
from ..model.ports import counts_of, labels, whole_labels
from ..model.sampled import Sampled
from ..model.system import System
from .subsystems import as_part, input_ports, is_discrete, output_ports
from .wiring import (
    Params,
    Part,
    Wiring,
    blocks_of,
    call_names,
    ordered_wiring,
    own_params,
    spaces_of,
    wiring_of,
)

# functions that return a sentence on an unknown parameter, by its name and the known names, or ""
PARAMETER_HINTS: list[Callable[[str, set[str]], str]] = []
MOST_BYTES = 10**9  # of python-control's matrices


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
    recorded: Any = None  # the run of a diagram that a run's file holds

    def __repr__(self) -> str:
        ports = (self.input_labels, self.output_labels)
        flows = " -> ".join(ports_line(counts_of(labels)) for labels in ports)
        size = f"{len(self.syslist)} blocks, {self.nstates or 0} states"
        return f"<Diagram {shortened(self.name, 60)}: {size}; {flows}>"

    def _repr_html_(self) -> str | None:
        return diagram_html(self)

    def _repr_markdown_(self) -> None:
        """Return nothing in place of python-control's, which would repeat the drawing."""

    def linearize(self, *point: Any, **more: Any) -> control.StateSpace:
        """Linearize as python-control does; refuse sampled blocks."""
        names = [name for name, block in blocks_of(self) if isinstance(block, Sampled)]
        if names:
            raise DiagramError(
                f"{self.name}: {names[0]} samples its inputs, which control.linearize does not "
                "see; call clpt.linearize, which gives the discrete system of the loop"
            )
        return super().linearize(*point, **more)

    def _update_params(self, params: Params) -> None:
        given, own = dict(params or {}), f"{self.name}."
        inside_another = any(hasattr(value, "_fields") for value in given.values())
        inside_another |= bool(self.params) and set(self.params) <= set(given)
        if given and not inside_another:
            changed_parameters(blocks_of(self), given)
        given |= {key.removeprefix(own): given[key] for key in given if key.startswith(own)}
        super()._update_params(given)
        for part in self.syslist:
            of_part = any(key.startswith(f"{part.name}.") for key in given)
            if of_part and not isinstance(part, Block):
                part._update_params({**self.params, **own_params(part.name, given)})


def changed_parameters(blocks: Iterable[tuple[str, Any]], params: Params) -> list[Any]:
    """Return each block's parameters, changed by ``{"block.field": value}``.

    Of nested diagrams ``"a.adaptation.gain"`` reaches one, ``"adaptation.gain"`` all; of
    python-control's systems ``"m"`` reaches all, too, and ``"plant.m"`` one.
    """
    params = {} if params is None else params
    if not isinstance(params, Mapping):
        raise BlockError(f"params = {params!r}: must be a dict, such as {{'adaptation.gain': 2.0}}")
    known: set[str] = set()
    names: set[str] = set()
    found: list[Any] = []
    asking: list[tuple[System, list[str]]] = []  # with what may stand before a param of theirs
    for name, block in blocks:
        keys = call_names(name, block)
        changes = {keys[key]: params[key] for key in keys if key in params}  # the longest counts
        if isinstance(block, System):
            asking.append((block, spaces_of(name)))
            found.append(block.with_params(changes))
            continue
        found.append(block.with_values(changes))
        known |= set(keys)
        names |= {f"{name}.{field}" for field in block.parameters._fields}
    for key in params:
        own = [(system, key.removeprefix(space)) for system, to in asking for space in to]
        if key in known or any(system.mentions(name) for system, name in own):
            continue
        for hint_of in PARAMETER_HINTS:
            if hint := hint_of(key, known):
                raise BlockError(hint)
        names = names.union(*(system.names for system, _ in asking))
        known_here = ", ".join(sorted(names)) or "none"
        close = nearest(key, names)
        hint = f"; did you mean {close}? This" if close else ": this"
        raise BlockError(f"unknown parameter '{key}'{hint} diagram knows {known_here}")
    return found


Makers = dict[str, tuple[int, list[int]]]  # port -> the block that makes it, its outputs
Users = dict[str, list[tuple[int, list[int]]]]  # port -> blocks that take it, their inputs


def match_ports(
    blocks: Sequence[Part], external: Iterable[str]
) -> tuple[Makers, Users, dict[str, int]]:
    """Match the ports of parts; refuse one that is made twice, missing or of another size.

    Return who makes and who takes each, and the sizes of those that come from outside.
    """
    external, names = list(external), [block.name for block in blocks]
    if not blocks:
        raise DiagramError("a diagram of no blocks: give at least one")
    for name in names:
        if names.count(name) > 1:
            raise DiagramError(f"two blocks are called '{name}': rename one")
    makers: Makers = {}
    users: Users = {}
    for k, block in enumerate(blocks):
        for port, places in output_ports(block).items():
            if port in makers:
                raise DiagramError(
                    f"'{port}' is made by both {names[makers[port][0]]} and {block.name}: "
                    "python-control would add them; rename one port, or wire diagrams by "
                    "control.interconnect"
                )
            makers[port] = k, places
        for port, places in input_ports(block).items():
            users.setdefault(port, []).append((k, places))
    for port, taken in users.items():
        ends = [makers[port], *taken] if port in makers else taken
        if port not in makers and port not in external:
            known = sorted({*makers, *external})
            close = nearest(port, known)
            raise DiagramError(
                f"'{port}', an input of {names[taken[0][0]]}, is made by no block"
                f"{f'; did you mean {close}?' if close else ''}; there are {', '.join(known)}; "
                f"external='{port}' takes it from outside"
            )
        size = len(ends[0][1])
        for k, places in ends:
            if len(places) != size:
                raise DiagramError(
                    f"'{port}' has {size} signals, but {names[k]} takes {len(places)}; both must "
                    f"have one size: label them {port}[0], {port}[1], or give a part signals="
                )
        units = [(getattr(blocks[k], "units", {}).get(port), names[k]) for k, _ in ends]
        said = [(unit, name) for unit, name in units if unit]
        for unit, name in said[1:]:
            if not same_unit(unit, said[0][0]):
                raise DiagramError(
                    f"'{port}' is in '{said[0][0]}' at {said[0][1]} and in '{unit}' at {name}; "
                    "give it one unit, or put a block between that converts it"
                )
    for port in external:
        if port in makers or port not in users:
            why = f"{names[makers[port][0]]} makes it" if port in makers else "no block takes it"
            raise DiagramError(
                f"'{port}' cannot come from outside: {why}; blocks take {', '.join(sorted(users))}"
            )
    return makers, users, {port: len(users[port][0][1]) for port in external}


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
    >>> from clpt_control.blocks import clpe, vehicle
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
    parts = [as_part(block, discrete) for block in blocks]
    check_names(name)
    makers, users, outside = match_ports(parts, external)
    _check_params(parts)
    fed, makes = (sum(part.ninputs for part in parts), sum(part.noutputs for part in parts))
    size = 8 * (2 * fed + makes) * makes  # bytes of python-control's full matrices
    if size > MOST_BYTES:
        raise DiagramError(
            f"{name or 'the diagram'}: has {makes} signals, for which python-control needs "
            f"{size / 1e9:.1f} GB; at most {MOST_BYTES / 1e9:g} GB: take fewer basis functions, or "
            "simulate the scenario itself"
        )
    diagram = control.interconnect(
        parts,
        connections=[
            [(user, to), (maker, source)]
            for port, (maker, places) in makers.items()
            for user, takes in users.get(port, ())
            for to, source in zip(takes, places, strict=True)
        ]
        or False,
        inplist=[
            [(user, takes[k]) for user, takes in users[port]]
            for port, size in outside.items()
            for k in range(size)
        ],
        outlist=[(k, place) for k, places in makers.values() for place in places],
        inputs=labels(outside),
        outputs=labels({port: len(places) for port, (_, places) in makers.items()}),
        name=name,
        check_unused=False,
    )
    diagram.__class__ = Diagram
    return diagram


def _check_params(parts: Sequence[Part]) -> None:
    """Refuse a name with two values: python-control gives all systems the last one's."""
    owners: dict[str, Part] = {}
    for part in parts:
        for key, value in part.params.items():
            other = owners.setdefault(key, part)
            if not isinstance(value, Parameters) and not np.array_equal(other.params[key], value):
                raise DiagramError(
                    f"{key} = {brief(value)} of {part.name} is {brief(other.params[key])} of "
                    f"{other.name}: python-control would give both the last; rename one, or give "
                    f"both one value and call with params={{'{other.name}.{key}': ...}}"
                )


def wiring_of_blocks(blocks: Sequence[Part], external: Iterable[str] = ()) -> Wiring:
    """Return `wiring_of(connect(blocks, external))`; if all are blocks, without its matrices."""
    if not all(isinstance(block, Block) for block in blocks):
        return wiring_of(connect(blocks, external))
    *_, outside = match_ports(blocks, external)
    outputs = [label for block in blocks for label in whole_labels(block.output_labels)]
    external, systems = labels(outside), [(block.name, block) for block in blocks]
    place = {one: k for k, one in enumerate(outputs)} | {one: ~k for k, one in enumerate(external)}
    inputs = [label for block in blocks for label in whole_labels(block.input_labels)]
    rows = ({k: 1.0} for k in range(len(outputs)))
    return ordered_wiring(systems, [{place[one]: 1.0} for one in inputs], len(external), rows)


# --- a condition that ends a run: stop(t, y, u) > 0 goes on, the run ends where it falls to 0 -----


NAME = "stop"


def with_stop(wiring: Wiring, stop: Callable[[float, Any, Any], Any]) -> Wiring:
    """Return the wiring with a block that reads outputs and inputs, and ends the run."""
    if not callable(stop):
        raise DiagramError(f"stop = {brief(stop)}: must be a function of t, outputs and inputs")
    if wiring.dt:
        raise DiagramError(
            f"stop: a diagram of discrete time (dt = {wiring.dt}) has nothing between its samples "
            "to cross; look at the samples of a whole run"
        )

    def distance(t, x, u, p):
        found = stop(t, u.y, u.u)
        truth = isinstance(found, bool) or getattr(found, "dtype", None) == np.bool_
        return np.where(found, 1.0, -1.0) if truth else found

    def sentence(t: float, u: np.ndarray, p: Any) -> str:
        return f"`{getattr(stop, '__name__', 'stop')}` fell to 0 at t = {t:.9g}"

    m, outputs = wiring.ninputs, wiring.outputs
    block = Block(
        NAME,
        output=lambda t, x, u, p: {},
        inputs={"y": len(outputs), "u": m},
        outputs={},
        guard=Guard(distance, "stop", sentence),
    )
    fed = [row for node in wiring.nodes for row in node.rows]
    fed += [*outputs, *({~j: 1.0} for j in range(m))]
    order = (*wiring.order, len(wiring.nodes))
    return ordered_wiring([*wiring.blocks, (NAME, block)], fed, m, outputs, order=order)
