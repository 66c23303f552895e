"""Where each number of a diagram lies in the arrays of its program.

    x[i] of a block -> X          p.field[k] -> P, or T where runs share it
    u[j]            -> what the wiring brings there: a sum of gains times signals

Fields that hold the same values share a slot: a basis at the vehicle and at its
prediction then share widths and tides, and the compiler sees that their cosines are one.
A signal that is a state lies in X, other signals in W.  An input of the diagram is a
straight line in time, of which P holds the beginning, the value there and the slope.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from ..diagrams.wiring import Node, Wiring
from ..equations.block import Block
from ..equations.declaration import states_as_outputs

LARGE = 512  # numbers: a larger array is a table that runs share
SIGNED = {"div", "atan2", "pow", "floordiv", "mod"}  # that tell -0.0 from 0.0


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
    T: np.ndarray = field(default_factory=lambda: np.zeros(0))
    pattern: str = ""  # which fields share a slot: part of the key of compiled code

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
    own: list[np.ndarray] = []
    tables: list[np.ndarray] = []
    known: dict[tuple[str, tuple[int, ...], bytes], Slot] = {}
    names = []
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
                large = array.size > LARGE
                stack = tables if large else own
                offset = sum(part.size for part in stack)
                stack.append(array.ravel())
                known[key] = Slot("T" if large else "P", offset)
            slot = layout.slots[k, name] = known[key]
            names.append(f"{k}.{name}:{slot.array}{slot.offset}{array.shape}")
            if name == "interval" and node.system.breakpoints_function is not None:
                layout.intervals[k] = slot.offset
        if node.system.jump_function is not None:
            layout.jumps[k] = sum(part.size for part in own)
            own.append(np.zeros(1))
            names.append(f"{k} jumps:P{layout.jumps[k]}")
    layout.P = np.concatenate([np.zeros(0), *own])
    layout.T = np.concatenate([np.zeros(0), *tables])
    layout.pattern = " ".join(names)
    return layout


class Term(NamedTuple):
    """gain times a signal, or times an input of the diagram."""

    gain: float
    external: bool
    source: int


class Sources:
    """Where the numbers that blocks read come from.

    `signals` holds array and place of each; the diagram's inputs begin in P at `ramp`
    (time, values, slopes), what is prepared at `prepared`.
    """

    def __init__(self, wiring: Wiring, layout: Layout):
        self.wiring, self.layout, self.ninputs = wiring, layout, wiring.ninputs
        self.ramp = len(layout.P)
        self.prepared = self.ramp + 1 + 2 * self.ninputs
        self.signals: list[tuple[str, int]] = []
        for k, node in enumerate(wiring.nodes):
            first = node.states.start if self.direct(k) else node.outputs.start
            array = "X" if self.direct(k) else "W"
            self.signals += [(array, first + i) for i in range(node.system.noutputs)]

    def direct(self, k: int) -> bool:
        """Whether the outputs of block k are its states."""
        return self.wiring.nodes[k].system.output_function is states_as_outputs

    def signed(self, node: Node) -> bool:
        """Whether a block tells -0.0 from 0.0: sums in Python begin at 0.0, are never -0.0."""
        block = node.system
        records = (
            block.update_record,
            block.output_record,
            block.guard_record,
            block.jump_record,
        )
        return any(o[0] in SIGNED for r in records if r is not None for o in r.operations)

    def inputs(self, node: Node) -> list[list[Term]]:
        """Return the terms that each input of a block is the sum of."""
        terms: list[list[Term]] = [[] for _ in range(node.system.ninputs)]
        for wire in node.wires:
            for j in range(wire.size):
                terms[wire.to + j].append(Term(wire.gain, wire.external, wire.source + j))
        return terms

    def parameter(self, k: int, name: str) -> tuple[str, int]:
        """Return array and first place of a parameter field of block k."""
        return self.layout.slots[k, name]

    def external(self, place: int) -> tuple[int, int, int]:
        """Return where an input's beginning, value and slope lie in P."""
        return self.ramp, self.ramp + 1 + place, self.ramp + 1 + self.ninputs + place
