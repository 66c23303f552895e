"""Wire blocks by the names of their ports, with `control.interconnect`.

python-control adds two outputs of one name, warns of an input that nothing
feeds, and passes over a mistyped parameter; here all three are errors that
name the block and the port.
"""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import control

from .blocks import Block
from .blocks.ports import labels
from .errors import BlockError, DiagramError
from .wiring import read


class Diagram(control.InterconnectedSystem):
    """A python-control diagram whose parameter names are checked.

    Made by `connect`; everything else is python-control's own.

    Examples
    --------
    >>> import clpt_control as clpt
    >>> clpt.closed_loop(clpt.paper_scenario()).nstates
    14
    """

    def _update_params(self, params: Mapping[str, Any] | None) -> None:
        inside_another = bool(self.params) and set(self.params) <= set(params or {})
        if params and not inside_another:
            self._check_names(params)
        super()._update_params(params)

    def _check_names(self, params: Mapping[str, Any]) -> None:
        leaves = [node.system for node in read(self).nodes]
        known: set[str] = set()
        for system in leaves:
            if isinstance(system, Block):
                known |= {f"{system.name}.{field}" for field in system.parameters._fields}
            else:
                known |= set(system.params)
        for key in params:
            if key not in known:
                names = ", ".join(sorted(known))
                raise BlockError(f"unknown parameter '{key}': this diagram knows {names}")


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
        differ, or an external port is made or not used.

    Examples
    --------
    >>> from clpt_control.blocks import clpe, vehicle
    >>> diagram = connect([vehicle.vehicle(), clpe.clpe()], external=["flow_x", "v_x", "z"])
    >>> diagram.output_labels
    ['x[0]', 'x[1]', 'e[0]', 'e[1]']
    """
    external = list(external)
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
    feeds: dict[str, list[str]] = {}
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
            feeds.setdefault(port, []).append(block.name)
    for port in external:
        if port in makers:
            raise DiagramError(f"'{port}' cannot come from outside: {makers[port][0]} makes it")
        if port not in feeds:
            raise DiagramError(
                f"'{port}' cannot come from outside: no block takes it; blocks take "
                f"{', '.join(sorted(feeds))}"
            )
    made = [(port, *makers[port]) for port in makers]
    wired = control.interconnect(
        list(blocks),
        connections=[
            [f"{user}.{port}[{k}]", f"{maker}.{port}[{k}]"]
            for port, maker, size in made
            for user in feeds.get(port, ())
            for k in range(size)
        ]
        or False,
        inplist=[
            [f"{user}.{port}[{k}]" for user in feeds[port]]
            for port in external
            for k in range(sizes[port])
        ],
        outlist=[f"{maker}.{port}[{k}]" for port, maker, size in made for k in range(size)],
        inputs=labels({port: sizes[port] for port in external}),
        outputs=labels({port: size for port, _, size in made}),
        name=name,
        check_unused=False,
    )
    wired.__class__ = Diagram
    return wired
