"""A diagram as arrows between blocks, and those arrows as Mermaid text.

An arrow joins the block (or the outside) that makes a port to a block that
takes it.  A port is a signal label without its index: ``phi_x[0]`` belongs to
``phi_x``.  Where only some signals of a port are taken, they are named.
"""

from typing import NamedTuple

import control

from ...arguments import public
from ..wiring import Node, Wiring, wiring_of


class Arrow(NamedTuple):
    """What one block takes of one port."""

    source: str  # name of the block that makes the port; of the port if external
    target: str  # name of the block that takes it
    port: str  # the port, such as ``"phi_x"``, or some of its signals, ``"y[1]"``
    gain: float  # factor on each signal
    external: bool  # true where the port is an input of the diagram

    @property
    def label(self) -> str:
        """Return the port, with its gain unless that is 1."""
        return self.port if self.gain == 1 else f"{self.gain:g} {self.port}"


def port_of(label: str) -> str:
    """Return the port of a signal's label."""
    return label.partition("[")[0]


def ports(labels: list[str]) -> list[str]:
    """Return the ports of signal labels, each once, in order."""
    return list(dict.fromkeys(map(port_of, labels)))


def arrows(diagram: control.NonlinearIOSystem, wiring: Wiring | None = None) -> list[Arrow]:
    """Return one arrow for each source, target, port and gain, nested diagrams included."""
    wiring = wiring_of(diagram) if wiring is None else wiring
    made = [(n.name, label) for n in wiring.nodes for label in n.system.output_labels]
    given = [(port, label) for label in diagram.input_labels for port in ports([label])]
    return [arrow for node in wiring.nodes for arrow in _into(node, made, given)]


def _into(node: Node, made: list[tuple[str, str]], given: list[tuple[str, str]]) -> list[Arrow]:
    """Return the arrows into a node; where a port is not taken whole, its signals are named."""
    taken: dict[tuple[bool, str, str, float], list[str]] = {}
    for wire in sorted(node.wires):
        origins = given if wire.external else made
        for source, label in origins[wire.source : wire.source + wire.size]:
            key = (wire.external, source, ports([label])[0], wire.gain)
            taken.setdefault(key, []).append(label)
    result = []
    for (external, source, port, gain), signals in taken.items():
        origins = given if external else made
        whole = {label for owner, label in origins if owner == source and ports([label]) == [port]}
        names = [port] if whole == set(signals) else dict.fromkeys(signals)
        result += [Arrow(source, node.name, name, gain, external) for name in names]
    return result


@public
def mermaid(diagram: control.NonlinearIOSystem) -> str:
    """Write a diagram as a Mermaid flowchart.

    Parameters
    ----------
    diagram : control.NonlinearIOSystem
        An interconnected system; blocks of nested ones are drawn one by one.

    Returns
    -------
    str
        Text that Mermaid, and every page that knows it, shows as a picture:
        a box for each block with the ports that it makes, a rounded box for
        each input of the diagram.

    Raises
    ------
    DiagramError
        If blocks feed each other at once in a circle.

    Examples
    --------
    >>> from clpt_control import connect
    >>> from clpt_control.blocks import clpe, vehicle
    >>> loop = connect([vehicle.vehicle(), clpe.clpe()], external=["flow_x", "v_x", "z"])
    >>> print(mermaid(loop), end="")
    flowchart LR
        in0(["flow_x"])
        in1(["v_x"])
        in2(["z"])
        b0["vehicle<br/>x"]
        b1["clpe<br/>e"]
        in0 -->|"flow_x"| b0
        in1 -->|"v_x"| b0
        b0 -->|"x"| b1
        in2 -->|"z"| b1
    """
    wiring = wiring_of(diagram)
    outside = {port: f"in{k}" for k, port in enumerate(ports(diagram.input_labels))}
    inside = {node.name: f"b{k}" for k, node in enumerate(wiring.nodes)}
    lines = ["flowchart LR"]
    lines += [f'    {key}(["{_quoted(port)}"])' for port, key in outside.items()]
    for node in wiring.nodes:
        signals = _quoted(", ".join(ports(node.system.output_labels)))
        lines.append(f'    {inside[node.name]}["{_quoted(node.name)}<br/>{signals}"]')
    carried: dict[tuple[str, str], list[str]] = {}
    for arrow in arrows(diagram, wiring):
        start = outside[arrow.source] if arrow.external else inside[arrow.source]
        carried.setdefault((start, inside[arrow.target]), []).append(arrow.label)
    for (start, end), names in carried.items():
        lines.append(f'    {start} -->|"{_quoted(", ".join(names))}"| {end}')
    return "\n".join(lines) + "\n"


def _quoted(text: str) -> str:
    return text.replace("#", "#35;").replace('"', "#quot;").replace("<", "#lt;")
