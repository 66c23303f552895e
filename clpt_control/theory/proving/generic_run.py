"""Run a block's function once for every number N of basis functions.

A loop `for k in range(p.N)` takes three turns with an index that nobody can ask for its
value.  At the start of the second turn, of the third and at the end the function must
stand in the same state: the same local variables, each what the turn before made of it.
Then every further turn does what the third did, and three stand for N; fewer turns are
the first of them.  What the turns compute is compared in the record (`native.loops`).
"""

import dis
import sys
from collections.abc import Iterator
from types import CodeType, FrameType
from typing import Any

from ...blocks.rebinding import rebind
from ...blocks.record import Record
from ...blocks.trace import SUBSTITUTES, stand_in_for_opaque
from ...blocks.tracers import Condition, Number, Refused, Tape
from .whole import TURNS, Cells, Held, Turn, Whole


def run(function: Any, tape: Tape, given: tuple, written: dict) -> Record:
    """Run a function with N any, and return the record.

    Parameters
    ----------
    function : function
        A block's update or output.
    tape : Tape
        Where to write; the arguments belong to it.
    given : tuple
        t, x, u, p and out for every N (`theory.whole`).
    written : dict
        What the function leaves in `out`, by `Whole.key`; filled.

    Returns
    -------
    Record
        Its outputs are the written numbers, in the order of `written`.

    Raises
    ------
    Refused
        If something is not the same for every N.
    """
    loops = _Loops(function.__code__, tape, written)
    length = lambda array: array.length if isinstance(array, Cells) else len(array)  # noqa: E731
    substitutes = {**SUBSTITUTES, "range": loops.over, "len": length}
    if rebind(function, substitutes, stand_in_for_opaque)(*given) is not None:
        raise Refused("returning a value", "fill the last argument: out[0] = ...")
    refs = tuple(number.ref for number in written.values())
    return Record(tuple(tape.operations), refs, tuple(tape.marks))


class _Loops:
    """`range` of a run for every N."""

    def __init__(self, top: CodeType, tape: Tape, written: dict):
        self.top, self.tape, self.written = top, tape, written
        self.open = False

    def over(self, *bounds: Any) -> Iterator[Any]:
        """Stand for `range`: of N, or of a number of turns that is known."""
        if all(type(bound) is int for bound in bounds):
            return self.tape.turns(*bounds)
        first, last = (0, *bounds) if len(bounds) == 1 else bounds[:2]
        N = Whole.of(last)
        if len(bounds) > 2 or type(first) is not int or first or (N.c, N.n, N.m) != (0, 1, 0):
            raise Refused("a loop over a part or a multiple of the functions", "use range(p.N)")
        return self._all()

    def _all(self) -> Iterator[Whole]:
        if self.open:
            raise Refused("a loop over all functions inside another", "keep sums apart")
        marks, tape = self.tape.marks, self.tape
        marks.append((len(tape.operations), "every"))
        self.open, starts, states = True, [len(tape.operations)], []
        for number in range(TURNS):
            turn = Turn(number)
            marks.append((len(tape.operations), "turn"))
            yield Whole(0, 0, 1, turn)
            turn.over = True
            frame = sys._getframe(1)
            if dis.opname[frame.f_code.co_code[frame.f_lasti]] != "FOR_ITER":
                raise Refused("`range` without a loop", "use `for k in range(p.N)`")
            states.append(self._state(frame, starts))
            starts.append(len(tape.operations))
            if states[-1] != states[0]:
                raise Refused("turns that differ", "let every function be treated alike")
        self.open = False
        marks.append((len(tape.operations), "leave"))

    def _state(self, frame: FrameType | None, starts: list[int]) -> list:
        """Return what all later turns depend on, as seen from the turn that ended."""
        found: list[Any] = [len(self.tape.operations) - starts[-1]]

        def seen(value: Any) -> Any:
            if isinstance(value, Number | Condition):
                ref = value.ref
                if type(ref) is float:
                    return "constant", repr(ref)
                return ("before", ref) if ref < starts[0] else ("turn", ref - starts[-1])
            if isinstance(value, Whole):
                return "whole", value.c, value.n, value.m, value.turn is not None
            if isinstance(value, Cells):
                return value.name, *map(seen, (value.start, value.length))
            if isinstance(value, Held):
                return value.field, *map(seen, value.before)
            if isinstance(value, int | float | bool | None):
                return type(value).__name__, repr(value)
            if type(value) is tuple:
                return tuple(map(seen, value))
            if hasattr(value, "_fields"):
                return type(value).__name__
            raise Refused(f"a {type(value).__name__} kept from turn to turn", "keep numbers")

        while frame is not None:
            found.append({name: seen(value) for name, value in frame.f_locals.items()})
            if frame.f_code is self.top:
                break
            frame = frame.f_back
        found.append({key: seen(v) for key, v in self.written.items() if key[2] is None})
        return found
