"""Subsystems of a diagram: blocks and python-control's systems.

A `control.ss`, `tf` or summing junction becomes a block of A, B, C, D.  Diagrams and systems of
functions are not changed.  The labels of a system form its ports: `v_c[0], v_c[1]` is `v_c`.

If all systems have the same discrete time, the diagram is discrete.  Otherwise each discrete system
becomes a block that samples its inputs.
"""

from typing import Any

import control

from ...errors import DiagramError
from ..model.block import Block
from ..model.ports import ports_of
from ..model.sampled import Sampled
from ..model.system import System, linear
from .wiring import Params, Part


def as_part(system: Any, discrete: bool = False) -> Part:
    """Return a system as a part of a diagram; refuse any other object.

    A system of discrete time samples its inputs, unless the whole diagram is `discrete`.
    """
    system = _checked(system)
    return system if discrete or not is_discrete(system) else sampled(system, system.dt)


def is_discrete(*systems: Any) -> bool:
    """Return whether systems have one discrete time, as python-control combines them."""
    times = [dt for dt in (getattr(system, "dt", 0) for system in systems) if dt is not None]
    periods = {dt for dt in times if dt is not True}  # not a difference of sets: True == 1.0
    return bool(times) and 0 not in times and len(periods) < 2


def sampled(system: Part, period: float, params: Params = None) -> Part:
    """Return a discrete system as one of continuous time, a diagram block by block.

    `params` come from the diagram around the system.
    """
    if period is True:
        raise DiagramError(
            f"{system.name}: dt = True does not say how often it samples; give dt a number"
        )
    if isinstance(system, Block):
        return Sampled(system, period)
    params = {**system.params, **(params or {})}
    if isinstance(system, control.InterconnectedSystem):
        diagram = control.InterconnectedSystem(
            [sampled(inner, period, params) for inner in system.syslist],
            inputs=system.input_labels,
            outputs=system.output_labels,
            name=system.name,
        )
        diagram.set_connect_map(system.connect_map)
        diagram.set_input_map(system.input_map)
        diagram.set_output_map(system.output_map)
        return diagram
    if isinstance(system, control.StateSpace):
        return Sampled(linear(system), period)
    return Sampled(System(system, params), period)


def _checked(system: Any) -> Part:
    if isinstance(system, Block):
        return system
    kind = type(system).__name__
    if not isinstance(system, control.NonlinearIOSystem | control.TransferFunction):
        value = f"a {kind}" if hasattr(system, "name") else f"{system!r:.60}"
        raise DiagramError(
            f"{value} is no block: give a clpt.Block, a diagram, or control.ss, tf or nlsys"
        )
    if system.name is None or system._generic_name_check():
        raise DiagramError(
            f"a {kind} without a name: parts and their parameters are called by "
            "name; give it one, such as control.ss(A, B, C, D, name='lag')"
        )
    if None in (system.ninputs, system.noutputs):
        raise DiagramError(
            f"{system.name}: how many inputs and outputs it has is not said; give inputs= and "
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
