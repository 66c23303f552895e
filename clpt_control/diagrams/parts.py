"""What can be a part of a diagram: a block, and python-control's systems beside it.

A `control.ss`, `tf` or summing junction becomes a block of A, B, C, D; diagrams and systems by
functions stay as they are.  The labels of a system form its ports: `v_c[0], v_c[1]` is v_c.
Parts of one discrete time stay as they are; beside others each samples what it takes.
"""

from collections.abc import Mapping
from typing import Any

import control

from ..equations.block import Block
from ..equations.declaration import labels, ports_of, renamed
from ..equations.sampled import Sampled
from ..equations.system import System, linear
from ..errors import DiagramError


def as_part(system: Any, discrete: bool = False) -> control.NonlinearIOSystem:
    """Return what can be wired; refuse in a sentence what cannot.

    What is of discrete time samples, but in a diagram that is `discrete` throughout.
    """
    part = _wired(system)
    return part if discrete or not is_discrete(part) else sampled(part, part.dt)


def is_discrete(*systems: Any) -> bool:
    """Return whether systems are of one discrete time, as python-control wires them."""
    times = {getattr(system, "dt", 0) for system in systems} - {None}
    return bool(times) and 0 not in times and len(times - {True}) < 2


def sampled(
    part: control.NonlinearIOSystem, period: float, params: Mapping[str, Any] | None = None
) -> control.NonlinearIOSystem:
    """Return a part of discrete time as one of continuous time, a diagram block by block.

    `params` are those that a diagram hands down.
    """
    if period is True:
        raise DiagramError(
            f"{part.name}: dt = True does not say how often it samples; give dt a number"
        )
    if isinstance(part, Block):
        return Sampled(part, period)
    own = {**part.params, **(params or {})}
    if not isinstance(part, control.InterconnectedSystem):
        linear_alone = isinstance(part, control.StateSpace)
        return Sampled(linear(part) if linear_alone else System(part, own), period)
    made = control.InterconnectedSystem(
        [sampled(one, period, own) for one in part.syslist],
        inputs=part.input_labels,
        outputs=part.output_labels,
        name=part.name,
    )
    made.set_connect_map(part.connect_map)
    made.set_input_map(part.input_map)
    made.set_output_map(part.output_map)
    return made


def _wired(system: Any) -> control.NonlinearIOSystem:
    if isinstance(system, Block):
        return system
    by_equations = isinstance(system, control.NonlinearIOSystem | control.TransferFunction)
    if not by_equations:
        what = f"a {type(system).__name__}" if hasattr(system, "name") else f"{system!r:.60}"
        raise DiagramError(
            f"{what} is no block: give a clpt.Block, a diagram, or control.ss, tf or nlsys"
        )
    if system.name is None or system._generic_name_check():
        raise DiagramError(
            f"a {type(system).__name__} without a name: parts and their parameters are called by "
            "name; give it one, such as control.ss(A, B, C, D, name='lag')"
        )
    if None in (system.ninputs, system.noutputs):
        raise DiagramError(
            f"{system.name}: how many inputs and outputs it has is not said; give inputs= and "
            "outputs= to control.nlsys"
        )
    linear_alone = isinstance(system, control.StateSpace | control.TransferFunction)
    if linear_alone and not isinstance(system, control.InterconnectedSystem):
        return linear(system)
    return system


def input_ports(part: control.NonlinearIOSystem) -> dict[str, list[int]]:
    """Return the ports that a part takes, each with the places of its signals."""
    return ports_of(part.input_labels)


def output_ports(part: control.NonlinearIOSystem) -> dict[str, list[int]]:
    """Return the ports that a part makes, each with the places of its signals."""
    return ports_of(part.output_labels)


def sizes(ports: Mapping[str, list[int]]) -> str:
    """Return ports in words, as `alpha[6], K[2]`."""
    return ", ".join(f"{port}[{len(at)}]" for port, at in ports.items()) or "nothing"


def functions_of(law: control.NonlinearIOSystem) -> int:
    """Return the N of a law; refuse a part that does not make alpha[2N], K[2] and Gamma[2]."""
    if not isinstance(law, control.NonlinearIOSystem):
        what = f"a {type(law).__name__}" if hasattr(law, "name") else f"{law!r:.60}"
        raise DiagramError(f"{what} is no law: give a Block")
    made = {port: len(places) for port, places in output_ports(law).items()}
    N = made.get("alpha", 0) // 2
    if N < 1 or {"alpha": 2 * N, "K": 2, "Gamma": 2}.items() - made.items():
        raise DiagramError(
            f"{law.name}: a law makes alpha[2N], K[2] and Gamma[2]; it makes "
            f"{sizes(output_ports(law))}; clpt.theory.lyapunov judges a V on any diagram"
        )
    taken = len(input_ports(law).get("phi_x", range(N)))
    if taken != N:
        raise DiagramError(f"{law.name}: phi_x has {taken} signals, N is {N}")
    return N


def with_ports(
    part: control.NonlinearIOSystem, inputs: Mapping[str, str], outputs: Mapping[str, str]
) -> control.NonlinearIOSystem:
    """Return a part that takes and makes signals of other names: {old: new}."""
    if isinstance(part, Block):
        return renamed(part, part.name, inputs, outputs)
    found = part.copy(name=part.name)
    for old, ports, put in (
        (inputs, input_ports(part), found.set_inputs),
        (outputs, output_ports(part), found.set_outputs),
    ):
        names: dict[int, str] = {}
        for port, places in ports.items():
            own = labels({old.get(port, port): len(places)})
            names |= dict(zip(places, own, strict=True))
        put([names[place] for place in range(len(names))])
    return found
