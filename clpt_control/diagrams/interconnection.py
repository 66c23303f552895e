"""Wire blocks by the names of their ports, with `control.interconnect`.

python-control adds two outputs of one name, warns of an input that nothing
feeds, and passes over a mistyped parameter; here all three are errors that
name the block and the port.
"""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

import control

from ..blocks import Block
from ..blocks.declaration import labels
from ..errors import BlockError, DiagramError
from ..scenario.keys import call_time_name_of
from .wiring import Wiring, ordered_wiring, wiring_of

MOST_BYTES = 10**9  # of python-control's matrices


class Diagram(control.InterconnectedSystem):
    """A python-control diagram whose parameter names are checked.

    Made by `connect`; everything else is python-control's own.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> clpt.closed_loop(clpt.paper_scenario()).nstates
    14
    """

    def __repr__(self) -> str:
        from .drawing.shown import diagram_line

        return diagram_line(self)

    def _repr_html_(self) -> str:
        from .drawing.shown import diagram_html

        return diagram_html(self)

    def _repr_markdown_(self) -> None:
        """Leave python-control's, which would be the same again."""

    def _update_params(self, params: Mapping[str, Any] | None) -> None:
        inside_another = bool(self.params) and set(self.params) <= set(params or {})
        if params and not inside_another:
            changed_parameters(wiring_of(self), params)
        super()._update_params(params)


def changed_parameters(wiring: Wiring, params: Mapping[str, Any] | None) -> list[Any]:
    """Return each system's parameters, changed by ``{"block.field": value}``."""
    params = {} if params is None else params
    if not isinstance(params, Mapping):
        raise BlockError(f"params = {params!r}: must be a dict, such as {{'adaptation.gain': 2.0}}")
    known: set[str] = set()
    found: list[Any] = []
    for node in wiring.nodes:
        system = node.system
        if isinstance(system, Block):
            own = {f"{system.name}.{field}": field for field in system.parameters._fields}
            changes = {own[key]: value for key, value in params.items() if key in own}
            found.append(system.with_values(changes))
            known |= set(own)
        else:
            found.append({key: params.get(key, value) for key, value in system.params.items()})
            known |= set(system.params)
    for key in params:
        if key not in known:
            if other := call_time_name_of(key, known):
                raise BlockError(other)
            names = ", ".join(sorted(known)) or "none"
            raise BlockError(f"unknown parameter '{key}': this diagram knows {names}")
    return found


class Matched(NamedTuple):
    """Ports of blocks that fit together by their names."""

    makers: dict[str, tuple[str, int]]  # port -> the block that makes it and its size
    users: dict[str, list[str]]  # port -> the blocks that take it
    outside: dict[str, int]  # port that comes from outside -> its size


def match_ports(blocks: Sequence[Block], external: Iterable[str] = ()) -> Matched:
    """Check that blocks fit together; a port that is doubled, missing or mis-sized is named."""
    external = list(external)
    if not blocks:
        raise DiagramError("a diagram of no blocks: give at least one")
    for block in blocks:
        if not hasattr(block, "output_ports"):
            raise DiagramError(f"{block!r:.60} is no block: give a list of clpt.Block")
    names = [block.name for block in blocks]
    for name_ in names:
        if names.count(name_) > 1:
            raise DiagramError(f"two blocks are called '{name_}': rename one")
    makers: dict[str, tuple[str, int]] = {}
    for block in blocks:
        for port, size in block.output_ports.items():
            if port in makers:
                raise DiagramError(
                    f"'{port}' is made by both {makers[port][0]} and {block.name}: "
                    "python-control would add them; rename one port"
                )
            makers[port] = (block.name, size)
    users: dict[str, list[str]] = {}
    sizes: dict[str, int] = {}
    for block in blocks:
        for port, size in block.input_ports.items():
            if port not in makers and port not in external:
                raise DiagramError(
                    f"'{port}', an input of {block.name}, is made by no block; blocks make "
                    f"{', '.join(sorted(makers))}"
                )
            wanted = makers[port][1] if port in makers else sizes.setdefault(port, size)
            if wanted != size:
                raise DiagramError(f"'{port}' has {wanted} signals, but {block.name} takes {size}")
            users.setdefault(port, []).append(block.name)
    for port in external:
        if port in makers:
            raise DiagramError(f"'{port}' cannot come from outside: {makers[port][0]} makes it")
        if port not in users:
            raise DiagramError(
                f"'{port}' cannot come from outside: no block takes it; blocks take "
                f"{', '.join(sorted(users))}"
            )
    return Matched(makers, users, {port: sizes[port] for port in external})


def connect(
    blocks: Sequence[Block], external: Iterable[str] = (), name: str = "diagram"
) -> Diagram:
    """Wire blocks by the names of their ports, and check the fit.

    Parameters
    ----------
    blocks : sequence of Block
        Each output port feeds every input port of the same name.
    external : iterable of str, optional
        Ports that come from outside: they become the diagram's inputs.
    name : str, optional
        Name of the diagram.

    Returns
    -------
    Diagram
        With every output port of every block as outputs.

    Raises
    ------
    DiagramError
        If two blocks make the same port, a port is fed by nothing, sizes
        differ, an external port is made or not used, or the diagram is larger
        than python-control can hold.

    Examples
    --------
    >>> from clpt_control.blocks import clpe, vehicle
    >>> diagram = connect([vehicle.vehicle(), clpe.clpe()], external=["flow_x", "v_x", "z"])
    >>> diagram.output_labels
    ['x[0]', 'x[1]', 'e[0]', 'e[1]']
    """
    matched = match_ports(blocks, external)
    made = [(port, *maker) for port, maker in matched.makers.items()]
    fed, makes = (sum(block.ninputs for block in blocks), sum(block.noutputs for block in blocks))
    size = 8 * (2 * fed + makes) * makes  # bytes of its full matrices of connections and outputs
    if size > MOST_BYTES:
        raise DiagramError(
            f"{name or 'the diagram'}: has {makes} signals, for which python-control needs "
            f"{size / 1e9:.1f} GB; at most {MOST_BYTES / 1e9:g} GB: take fewer basis functions, or "
            "simulate the scenario itself"
        )
    diagram = control.interconnect(
        list(blocks),
        connections=[
            [f"{user}.{port}[{k}]", f"{maker}.{port}[{k}]"]
            for port, maker, size in made
            for user in matched.users.get(port, ())
            for k in range(size)
        ]
        or False,
        inplist=[
            [f"{user}.{port}[{k}]" for user in matched.users[port]]
            for port, size in matched.outside.items()
            for k in range(size)
        ],
        outlist=[f"{maker}.{port}[{k}]" for port, maker, size in made for k in range(size)],
        inputs=labels(matched.outside),
        outputs=labels({port: size for port, _, size in made}),
        name=name,
        check_unused=False,
    )
    diagram.__class__ = Diagram
    return diagram


def wiring_of_blocks(blocks: Sequence[Block], external: Iterable[str] = ()) -> Wiring:
    """Return `wiring_of(connect(blocks, external))` without python-control's matrices."""
    from scipy.sparse import eye_array

    matched = match_ports(blocks, external)
    made = [label for block in blocks for label in labels(block.output_ports)]
    given = labels(matched.outside)
    taken = [label for block in blocks for label in labels(block.input_ports)]
    from_outputs, from_inputs = (
        {to: [(place[label], 1.0)] for to, label in enumerate(taken) if label in place}
        for place in ({label: k for k, label in enumerate(own)} for own in (made, given))
    )
    output_map = eye_array(len(made), len(made) + len(given), format="csr")
    systems = [(block.name, block) for block in blocks]
    return ordered_wiring(systems, from_outputs, from_inputs, len(given), output_map)
