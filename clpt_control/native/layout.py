"""Where each number of a diagram lies in the arrays of its program.

    x[i] of a block -> X          p.field[k] -> P, or T where runs share it

Fields that hold the same values share a slot: a basis at the vehicle and at its
prediction then share widths and tides, and the compiler sees that their cosines are one.
An input of the diagram is a straight line in time, of which P holds, behind the fields, the
beginning, then all values there and all slopes; what is prepared comes last.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from ..diagrams.wiring import Wiring
from ..equations.block import Block

LARGE = 512  # numbers: a larger array is a table that runs share


class Slot(NamedTuple):
    """Where a parameter field lies: in P, own to a run, or in T; its first number."""

    array: str
    offset: int


@dataclass
class Layout:
    """The slots of all parameters of a diagram, and the diagram's own values of P and T."""

    slots: dict[tuple[int, str], Slot] = field(default_factory=dict)  # of (block, field)
    intervals: dict[int, int] = field(default_factory=dict)  # block -> its `interval` in P
    jumps: dict[int, int] = field(default_factory=dict)  # block -> place in P: 1 where it jumps
    P: np.ndarray = field(default_factory=lambda: np.zeros(0))
    T: np.ndarray = field(default_factory=lambda: np.zeros(1))  # never empty

    @property
    def pattern(self) -> tuple:
        """Where all lies, and so which fields share a slot: part of the key of compiled code."""
        return *self.slots.items(), *self.jumps.items(), len(self.P)

    def inputs(self, count: int) -> int:
        """Return the length of P with so many inputs of the diagram."""
        return len(self.P) + 1 + 2 * count

    def packed(self, parameters: Sequence[Any]) -> np.ndarray:
        """Return P for other parameters of the same blocks; fields that share stay equal."""
        P = self.P.copy()
        seen: dict[int, Any] = {}
        for (k, name), slot in self.slots.items():
            value = np.asarray(getattr(parameters[k], name), dtype=float).ravel()
            if slot.array == "T":
                continue
            if slot.offset in seen and not np.array_equal(seen[slot.offset], value):
                raise ValueError(f"{name} of block {k} no longer equals the field it stands with")
            seen[slot.offset] = value
            P[slot.offset : slot.offset + len(value)] = value
        return P


def lay_out(wiring: Wiring, parameters: Sequence[Any]) -> Layout:
    """Return slots for the parameters of a diagram's blocks; None is a system that is none."""
    layout = Layout()
    own: dict[str, list[np.ndarray]] = {"P": [], "T": []}
    known: dict[tuple[str, tuple[int, ...], bytes], Slot] = {}
    for k, (node, p) in enumerate(zip(wiring.nodes, parameters, strict=True)):
        if not isinstance(node.system, Block):
            continue
        for name, value in zip(p._fields, p, strict=True):
            if isinstance(value, int):
                continue
            array = np.asarray(value, dtype=float)
            key = (name, array.shape, array.tobytes())
            if name == "interval":
                key = (f"{name} {k}", (), b"")
            if key not in known:
                place = "T" if array.size > LARGE else "P"
                known[key] = Slot(place, sum(part.size for part in own[place]))
                own[place].append(array.ravel())
            slot = layout.slots[k, name] = known[key]
            if name == "interval" and node.system.breakpoints_function is not None:
                layout.intervals[k] = slot.offset
        if node.system.jump_function is not None:
            layout.jumps[k] = sum(part.size for part in own["P"])
            own["P"].append(np.zeros(1))
    layout.P = np.concatenate([np.zeros(0), *own["P"]])
    layout.T = np.concatenate([*own["T"], np.zeros(1)])
    return layout
