"""Where the numbers that a block reads lie in the arrays of a program.

    x[i] of a block -> X          p.field[k] -> P, or T where runs share it
    u[j]            -> what the wiring brings there: a sum of gains times signals

A signal that is a state lies in X, other signals in W.  An input of the diagram
is a straight line in time, of which P holds the beginning, the value there and
the slope.
"""

from typing import NamedTuple

from ..blocks.ports import states_as_outputs
from ..diagrams.wiring import Node, Wiring
from .layout import Layout

SIGNED = {"div", "atan2", "pow", "floordiv", "mod"}  # that tell -0.0 from 0.0


class Term(NamedTuple):
    """gain times a signal, or times an input of the diagram."""

    gain: float
    external: bool
    source: int


class Sources:
    """The places of a diagram's numbers.

    Parameters
    ----------
    wiring : Wiring
        The diagram.
    layout : Layout
        Places of the parameters.
    ninputs : int
        Inputs of the diagram.

    Attributes
    ----------
    ramp : int
        Place in P of the diagram's inputs: time, values, slopes.
    prepared : int
        First place in P of what is prepared.
    """

    def __init__(self, wiring: Wiring, layout: Layout, ninputs: int):
        self.wiring, self.layout, self.ninputs = wiring, layout, ninputs
        self.ramp = len(layout.P)
        self.prepared = self.ramp + 1 + 2 * ninputs
        self.signals: list[tuple[str, int]] = []  # array and place of each
        for k, node in enumerate(wiring.nodes):
            first = node.states.start if self.direct(k) else node.outputs.start
            array = "X" if self.direct(k) else "W"
            self.signals += [(array, first + k) for k in range(node.system.noutputs)]

    def direct(self, k: int) -> bool:
        """Whether the outputs of block k are its states."""
        return self.wiring.nodes[k].system.output_function is states_as_outputs

    def signed(self, node: Node) -> bool:
        """Whether a block tells -0.0 from 0.0.

        Sums in Python begin at 0.0 and are never -0.0.
        """
        block = node.system
        records = (block.update_record, block.output_record, block.guard_record)
        return any(o[0] in SIGNED for r in records if r is not None for o in r.operations)

    def inputs(self, node: Node) -> list[list[Term]]:
        """Return the terms that each input of a block is the sum of."""
        terms: list[list[Term]] = [[] for _ in range(node.system.ninputs)]
        for wire in node.wires:
            for j in range(wire.size):
                terms[wire.to + j].append(Term(wire.gain, wire.external, wire.source + j))
        return terms

    def parameter(self, k: int, field: str) -> tuple[str, int]:
        """Return array and first place of a parameter field of block k."""
        place = self.layout.places[(k, field)]
        return place.array, place.offset

    def external(self, place: int) -> tuple[int, int, int]:
        """Return where an input's beginning, value and slope lie in P."""
        return self.ramp, self.ramp + 1 + place, self.ramp + 1 + self.ninputs + place
