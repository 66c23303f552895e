"""A diagram's machine code: made once a process for all diagrams of one structure."""

from contextlib import suppress
from dataclasses import dataclass, field
from functools import lru_cache

from ..diagrams.wiring import Wiring
from ..equations.arrays import Unread
from ..equations.block import Block
from ..errors import DiagramError, Uncompiled
from .diagram_record import NAMED, SHORT, DiagramRecord
from .formula import program_of_formulas
from .jacobian import Jacobian, jacobian, reach_of, slopes_of
from .layout import Layout
from .machine import Machine, one_at_a_time
from .method import formulas
from .plan import Program, program_of

ROLES = ("update", "output", "guard", "jump")
# how long an axis without and with a name is that loops; the others are there to be compared
# and whether decisions are locked for a step
FORMS = {
    None: (SHORT + 1, NAMED, True),
    "unrolled": (10**9, 10**9, True),
    "looped": (2, 2, True),
    "free": (SHORT + 1, NAMED, False),
}


@dataclass(frozen=True)
class Structure:
    """All that machine code depends on, but for parameters, and one diagram to make it from.

    `key` holds records, shapes and sizes of the blocks; what feeds each; the order of evaluation,
    the kind of time, which blocks pass inputs on at once and which sample; where parameters lie;
    how many inputs the diagram has.
    """

    key: tuple
    wiring: Wiring = field(compare=False)
    layout: Layout = field(compare=False)


class Code:
    """The program of a structure, and its machine code once it is asked for.

    `linear` is what an implicit method needs of it.
    """

    def __init__(self, program: Program, linear: Jacobian | None = None):
        self.program, self.linear = program, linear or Jacobian()
        self._machines: dict[tuple[str, int], Machine] = {}

    def address(self, name: str, lanes: int) -> int:
        """Return where a function lies, compiled when first asked for."""
        if (name, lanes) not in self._machines:
            self._make(name, lanes)
        return self._machines[name, lanes].addresses[name]

    @one_at_a_time
    def _make(self, name: str, lanes: int) -> None:
        if (name, lanes) in self._machines:  # another thread may have been first
            return
        apart = name in ("margin", "jump", "decide", "slope")  # only some diagrams need them
        together = (name,) if apart else ("derivative", "prepare", "signals")

        def printed() -> object:
            from .nests import print_program

            return print_program(self.program, together, lanes)

        made = Machine(together, repr((self.program, together, lanes)), printed)
        self._machines.update({(one, lanes): made for one in together})


def code_of(
    wiring: Wiring, layout: Layout, form: str | None = None, implicit: bool = False
) -> Code:
    """Return the code of a diagram, the same for diagrams of one structure.

    With `implicit` it is for an implicit method: rates have slopes.  Where `form` is not None, all
    axes are ``"unrolled"`` or ``"looped"``, or decisions are ``"free"``.  What cannot be compiled
    is an `Uncompiled` error.
    """
    if form not in FORMS:
        raise DiagramError(f"form = {form!r}: must be 'unrolled', 'looped' or 'free', or left out")
    blocks = []
    for node in wiring.nodes:
        block = node.system
        if not isinstance(block, Block):
            raise Uncompiled(f"{node.name} is no block and cannot be compiled")
        has = {"update": block.update_function, "output": True, "guard": block.guard}
        has["jump"] = block.jump_function
        try:
            records = tuple(block.array_record(role) for role in ROLES if has[role])
        except Unread as error:
            raise Uncompiled(str(error)) from None
        shapes: list[dict] = [*block.declared.values(), block.sizes]
        blocks.append((*records, *(tuple(own.items()) for own in shapes)))
    wires = tuple((node.states.start, node.outputs.start, node.wires) for node in wiring.nodes)
    own = ((node.system.feedthrough, node.system.kept) for node in wiring.nodes)
    order = (wiring.order, bool(wiring.dt), *own)
    key = tuple(blocks), wires, order, layout.pattern, wiring.ninputs
    return _code(Structure(key, wiring, layout), form, implicit)


@lru_cache(maxsize=64)
@one_at_a_time  # threads that ask at once are given the same code
@lru_cache(maxsize=64)
def _code(structure: Structure, form: str | None, implicit: bool) -> Code:
    wiring, layout = structure.wiring, structure.layout
    record = DiagramRecord(wiring, layout, *FORMS[form])
    room = wiring.nodes[-1].outputs.stop, layout.inputs(wiring.ninputs)
    if not implicit:
        return Code(program_of(record, *room))
    reach = reach_of(record, wiring.nodes[-1].states.stop)
    with suppress(Unread, Uncompiled):  # rates are then differentiated by differences
        return Code(program_of(record, *room, slopes_of(record, len(reach))), jacobian(reach, True))
    return Code(program_of(record, *room), jacobian(reach, False))


@lru_cache(maxsize=16)
@one_at_a_time
@lru_cache(maxsize=16)
def kernels(n: int, lanes: int, method: int) -> Machine:
    """Return the formulas of a method for n states as machine code."""
    own = formulas(method, n)

    def printed() -> object:
        from .nests import print_program

        return print_program(program_of_formulas(own, n), tuple(own), lanes)

    return Machine(own, f"formulas {n} {lanes} {method}", printed)
