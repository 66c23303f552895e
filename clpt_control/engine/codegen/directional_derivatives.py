"""Derivatives of a diagram's functions along directions: parameters and initial states.

    x' = f(t, x, u, p),     S' = df/dx S + df/dp,     y = h(t, x, u, p),  W = dh/dx S + dh/dp

The record of the whole diagram, wires included, is differentiated.  The derivatives S along each
direction lie behind the states, those of rates behind the rates, and the same for signals and
jumps.  Breakpoints, samples and guards stay as they are.  At a jump in time S is multiplied by the
derivative of the jump.
"""

from math import prod
from typing import Any, NamedTuple

import numpy as np

from ..record.derivative import Direction
from ..record.graph import reached
from ..trace.arrays import operand
from ..trace.elementwise import elementwise, lifted
from .diagram_record import DiagramRecord
from .switching_conditions import Port

Varied = tuple[tuple[int, str, int], ...]  # (block, field, index in it) of varied parameters


class Directions(NamedTuple):
    """Form of a diagram with derivatives: one direction for each tuple of varied parameters."""

    parameters: tuple[Varied, ...]
    form: Any = None  # form of the diagram itself

    @property
    def copies(self) -> int:
        """Number of vectors as long as the state: the state and its derivatives."""
        return 1 + len(self.parameters)


class _FiniteDirection(Direction):
    """Direction along which a root of squares, |x|, has the derivative 0 at x = 0, not 0/0.

    The same goes for a power of |x|, as in |x|^0.5 x.
    """

    def _slope(self, k: int) -> Any:
        slope = super()._slope(k)
        if slope is None or self.tape.operations[k].kind not in ("sqrt", "hypot", "pow"):
            return slope
        undefined = (self.tape.value(k) == 0.0) & (slope != slope)
        return elementwise("where", undefined, 0.0, slope)


def add_derivatives(record: DiagramRecord, form: Directions) -> None:
    """Append the derivatives along each direction to rates, jumps and signals of a record."""
    last = record.wiring.nodes[-1]
    nstates, nsignals = last.states.stop, last.outputs.stop
    values = [(record.rates, nstates), (record.leaps, nstates), (record.signals, nsignals)]
    roots = [port.ref for ports, _ in values for port in ports]
    entries = reached(record.entries, roots)
    loads = [k for k in sorted(entries) if record.entries[k].kind == "load"]
    extended: list[list[Port]] = [[*ports] for ports, _ in values]
    for number, varied in enumerate(form.parameters, 1):
        direction = _direction(record, loads, varied, number * nstates)
        for ports, (original, count) in zip(extended, values, strict=True):
            for port in original:
                slope = operand(direction.of(record.tape.value(port.ref)))
                ports.append(port._replace(first=number * count + port.first, ref=slope))
    record.rates, record.leaps, record.signals = extended


def _direction(
    record: DiagramRecord, loads: list[int], varied: Varied, state_offset: int
) -> Direction:
    """Return the direction of varied parameters and of the derivatives of states in X."""
    tape, layout = record.tape, record.layout
    parameter_slopes = np.zeros(len(layout.P))
    for block, field, index in varied:
        parameter_slopes[layout.slots[block, field].offset + index] = 1.0
    slopes: dict[int, Any] = {}
    for k in loads:
        _, _, shape, (array, offset) = record.entries[k]
        if array == "X":
            slopes[k] = tape.value(record.load("X", state_offset + offset, shape))
        elif array == "P":
            numbers = parameter_slopes[offset : offset + prod(shape)]
            slopes[k] = lifted(tape, numbers.reshape(shape)) if numbers.any() else None
    return _FiniteDirection(tape, slopes)
