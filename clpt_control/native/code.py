"""A diagram's machine code: made once a process for all diagrams of one structure.

Small diagrams are unrolled, so that numbers stay in registers and what is computed
twice is found; larger ones keep their loops.
"""

from functools import lru_cache
from typing import NamedTuple

from ..blocks.tracers import TooLong
from ..diagrams.wiring import Wiring
from ..equations.block import Block
from ..errors import DiagramError, Uncompiled
from . import method
from .formula import kernel
from .layout import Layout, Sources
from .looped import looped_program
from .loops import LEAST
from .machine import Machine
from .object_code import one_at_a_time
from .program import Item, Loop, Program
from .unrolled import unrolled_program

UNROLLED = 3_000  # items of a derivative; a larger one keeps its loops
FORMS = (None, "unrolled", "looped")
MOST = 30_000  # items of a derivative; a larger one is left to Python


class Structure(NamedTuple):
    """All that machine code depends on, but for parameters, which it is given."""

    records: tuple  # update, output, guard and jump of each block
    wires: tuple  # what feeds each block
    order: tuple  # of evaluation, and which blocks pass their inputs on at once
    pattern: str  # which parameter fields share a slot, and where
    ninputs: int  # of the diagram


class Code:
    """The program of a structure, and its machine code once it is asked for."""

    def __init__(self, program: Program):
        self.program = program
        self.unrolled = not any(isinstance(item, Loop) for item in program.derivative)
        self._machines: dict[tuple[str, int], Machine] = {}

    def address(self, name: str, lanes: int) -> int:
        """Return where a function lies, compiled when first asked for."""
        if (name, lanes) not in self._machines:
            self._make(name, lanes)
        return self._machines[name, lanes].addresses[name]

    @one_at_a_time
    def _make(self, name: str, lanes: int) -> None:
        if (name, lanes) not in self._machines:  # another thread may have been first
            apart = name in ("margin", "jump")  # only some diagrams need them
            together = (name,) if apart else ("derivative", "prepare", "signals")
            functions = {one: getattr(self.program, one) for one in together}
            made = Machine(functions, self.program.constants, lanes)
            self._machines.update({(one, lanes): made for one in together})


def code_of(wiring: Wiring, layout: Layout, form: str | None = None, least: int = LEAST) -> Code:
    """Return the code of a diagram, the same for diagrams of one structure.

    `form` is ``"unrolled"``, ``"looped"``, or None: by size; loops of fewer turns than `least`
    are unrolled.  What cannot be compiled is an `Uncompiled` error.
    """
    if form not in FORMS:
        raise DiagramError(f"form = {form!r}: must be 'unrolled' or 'looped', or left out")
    for node in wiring.nodes:
        if not isinstance(node.system, Block):
            raise Uncompiled(f"{node.name} is no block and cannot be compiled")
    try:
        records = tuple(
            (
                node.system.update_record,
                node.system.output_record,
                node.system.guard_record,
                node.system.jump_record,
            )
            for node in wiring.nodes
        )
    except TooLong as error:
        raise Uncompiled(str(error)) from None
    wires = tuple((node.states.start, node.outputs.start, node.wires) for node in wiring.nodes)
    order = (wiring.order, tuple(node.system.feedthrough for node in wiring.nodes))
    structure = Structure(records, wires, order, layout.pattern, wiring.ninputs)
    return _code(structure, form, least, _Hidden(Sources(wiring, layout)))


class _Hidden:
    """What code is made from; always equal, so it is no part of the cache's key."""

    def __init__(self, sources: Sources):
        self.sources = sources

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Hidden)

    def __hash__(self) -> int:
        return 0


@lru_cache(maxsize=64)
@one_at_a_time  # threads that ask at once are given the same code
@lru_cache(maxsize=64)
def _code(structure: Structure, form: str | None, least: int, hidden: _Hidden) -> Code:
    sources = hidden.sources
    operations = sum(len(r.operations) for own in structure.records for r in own if r is not None)
    program = None
    if form == "unrolled" or (form is None and operations <= 2 * UNROLLED):
        program = unrolled_program(sources)
        if form is None and max(len(program.derivative), len(program.jump)) > UNROLLED:
            program = None
    if program is None:
        program = looped_program(sources, least)
    size = max(count(program.derivative), count(program.jump))
    if size > MOST:
        raise Uncompiled(
            f"the diagram takes {size} operations apart from loops, more than {MOST}: write what "
            "repeats as `for i in range(n)` with equal turns"
        )
    return Code(program)


def count(items: tuple[Item, ...]) -> int:
    """Return how many items there are, those of loops once."""
    return sum(1 + (count(item.body) if isinstance(item, Loop) else 0) for item in items)


@lru_cache(maxsize=16)
@one_at_a_time
@lru_cache(maxsize=16)
def kernels(n: int, lanes: int) -> Machine:
    """Return the formulas of the method for n states as machine code."""
    formulas = method.formulas(n)
    return Machine({name: kernel(f, n) for name, f in formulas.items()}, (), lanes)
