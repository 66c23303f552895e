"""The code of a diagram: a program for all diagrams of one structure, and its machine code."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from ...base.errors import DiagramError, Uncompiled
from ..codegen.diagram_record import FORMS, DiagramRecord, Layout
from ..codegen.directional_derivatives import Directions, add_derivatives
from ..codegen.machine import Machine, once, one_at_a_time
from ..codegen.plan import NO_TABLES, Program, program_of
from ..diagram.wiring import Wiring
from ..record.operations import ELEMENTWISE
from ..record.unread import Unread
from .jacobian_pattern import Jacobian, jacobian, reach_of
from .kinks import PassedKinks
from .sliding_rates import HeldSwitches, slide

# components of a long program, and how much shorter one of loops is
MANY, SHORTER = (1500, 3)
# components of a program that LLVM does not optimise: its time grows as their square, and the
# machine code is a third slower at most
UNOPTIMISED = 2000
Form = str | HeldSwitches | PassedKinks | Directions | None


@dataclass(frozen=True)
class Structure:
    """All that machine code depends on, without parameters, and a diagram of that structure.

    `key` holds records, shapes and sizes of the blocks; what feeds each; the order of evaluation,
    the kind of time, which blocks pass inputs on at once and which sample; where parameters lie;
    how many inputs the diagram has.
    """

    key: tuple
    wiring: Wiring = field(compare=False)
    layout: Layout = field(compare=False)


class Code:
    """The program of a structure, and its machine code once it was requested.

    `sparsity` is the pattern of df/dx, for an implicit method; `decided_operations` the first
    decision of each operation that decides.
    """

    def __init__(
        self,
        program: Program,
        sparsity: Callable[[], Jacobian],
        decided_operations: tuple[int, ...],
    ):
        self.program, self.sparsity = program, cache(sparsity)
        self.decided_operations = decided_operations
        self._machines: dict[tuple[str, int], Machine] = {}

    @one_at_a_time
    def addresses(self, names: Sequence[str], lanes: int) -> list[int]:
        """Return where functions lie, compiled together when first asked for."""
        new = (name for name in names if (name, lanes) not in self._machines)
        missing = tuple(dict.fromkeys(new))
        if missing:
            program = self.program
            text = repr((program._replace(tables=NO_TABLES), missing, lanes))
            large = len(program.components) > UNOPTIMISED

            def module() -> Any:
                from ..codegen.llvm_text import print_program  # unless it is cached

                return print_program(program, missing, lanes)

            machine = Machine(missing, text, module, large, 0 if large else 3)
            for name in missing:
                self._machines[name, lanes] = machine
        return [self._machines[name, lanes].addresses[name] for name in names]

    @one_at_a_time
    def series(self, lanes: int, order: int) -> Machine:
        """Return the Taylor series of the rates, up to an order, as machine code."""
        key = f"series {order}", lanes
        if key not in self._machines:
            program = self.program
            text = repr((program._replace(tables=NO_TABLES), key))

            def module() -> Any:
                from ..codegen.series_loop import print_series

                return print_series(program, lanes, order)

            self._machines[key] = Machine(["series"], text, module)
        return self._machines[key]


def code_of(wiring: Wiring, layout: Layout, form: Form = None) -> Code:
    """Return the code of a diagram, the same for diagrams of one structure.

    `form` says whether all axes are ``"unrolled"`` or ``"looped"``, or decisions ``"free"``,
    held on switches, or free where kinks are passed.  An `Uncompiled` error says what cannot be
    compiled.
    """
    if form not in FORMS and not isinstance(
        form, HeldSwitches | PassedKinks | Directions
    ):
        raise DiagramError(
            f"form = {form!r}: must be 'unrolled', 'looped' or 'free', or left out"
        )
    blocks: list[Any] = [node.system for node in wiring.nodes]
    try:
        records = tuple(tuple(block.records.items()) for block in blocks)
    except Unread as error:
        raise Uncompiled(str(error)) from None
    shapes = tuple(
        tuple(tuple(sizes.items()) for sizes in (*block.declared.values(), block.sizes))
        for block in blocks
    )
    wires = tuple(
        (node.states.start, node.outputs.start, node.wires) for node in wiring.nodes
    )
    key = (
        records,
        shapes,
        wires,
        wiring.order,
        tuple((block.feedthrough, block.first_held) for block in blocks),
        bool(wiring.dt),
        layout.pattern,
        wiring.ninputs,
    )
    return _code(Structure(key, wiring, layout), form)


@once(64)
def _code(structure: Structure, form: Form) -> Code:
    """Return the code; that with short axes looped where it is far shorter, as of matrices."""
    try:
        code = _planned(structure, form)
    except Uncompiled:
        if form is not None:
            raise
        return _planned(structure, "looped")
    size = len(code.program.components)
    if (
        form is not None
        or size <= MANY
        or SHORTER * _array_operations(structure) >= size
    ):
        return code
    looped = _planned(structure, "looped")
    looped_size = len(looped.program.components)
    return looped if SHORTER * looped_size < size else code


def _array_operations(structure: Structure) -> int:
    """Return how many operations the records have, each of which is a loop's component at least."""
    blocks: list[Any] = [node.system for node in structure.wiring.nodes]
    records = [record for block in blocks for record in block.records.values()]
    return sum(
        line.kind in ELEMENTWISE for record in records for line in record.operations
    )


def _planned(structure: Structure, form: Form) -> Code:
    wiring = structure.wiring
    layout = structure.layout
    plain_form: Any = form.form if isinstance(form, Directions) else form
    if isinstance(plain_form, HeldSwitches):
        record = DiagramRecord(wiring, layout, passed=None)
        slide(record, plain_form)
    elif isinstance(plain_form, PassedKinks):
        record = DiagramRecord(wiring, layout, None, plain_form.operations)
    else:
        record = DiagramRecord(wiring, layout, plain_form)
    if isinstance(form, Directions):
        add_derivatives(record, form)
    last = wiring.nodes[-1]
    copies = copies_of(form)
    signals = copies * last.outputs.stop
    states = copies * last.states.stop
    program = program_of(record, signals, layout.inputs(wiring.ninputs))
    operations = tuple(record.decisions.operations)
    return Code(program, lambda: jacobian(reach_of(record, states)), operations)


def copies_of(form: Form) -> int:
    """Return the number of vectors as long as the state: 1, or more with derivatives."""
    return form.copies if isinstance(form, Directions) else 1
