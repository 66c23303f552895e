"""The derivative reading of a diagram's record: df/dx v + df/dt s along a direction (v, s).

The record of a diagram is a record as any other, so its rates are differentiated as a whole, wires
and all.  The direction lies behind the states: X = x, v, s.
"""

from typing import Any

from ..equations.arrays import Array, Tape, operand
from ..equations.derivative import Direction
from ..equations.record import Operation, reached
from .diagram_record import WIRE, DiagramRecord, Entry, Port


def slopes_of(record: DiagramRecord, n: int) -> list[Port]:
    """Return what the rates of n states do along a direction; the record grows by it.

    Where a function has no derivative, as the derivative reading knows it, it is `Unread`.
    """
    tape, along = Tape(), dict[int, Any]()
    roots = [port.ref for port in record.rates]
    loads = [k for k in sorted(reached(record.entries, roots)) if record.entries[k].kind == "load"]
    for k in loads:
        array, first = record.entries[k].at
        moved = {"X": n + first, "t": 2 * n}.get(array)
        along[k] = None if moved is None else record.load("X", moved, record.entries[k].shape)
    for entry in record.entries:
        tape.append(Operation(*entry[:4]))
    known = {
        k: None if ref is None else Array(tape, ref, record.entries[ref].shape)
        for k, ref in along.items()
    }
    direction = Direction(tape, known)
    found = []
    for port in record.rates:
        whole = port.ref if type(port.ref) is float else Array(tape, port.ref, port.shape)
        slope = direction.of(whole)
        found.append(port._replace(ref=operand(slope)))
    record.entries += [Entry(*one, WIRE) for one in tape.operations[len(record.entries) :]]
    return found
