"""The code of a diagram and of a method: programs, and their machine code.

Diagrams of one structure have one program.  The formulas of a method have one for each number of
states and of lanes.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from ...base.errors import Uncompiled
from ..codegen.diagram_record import PLAIN, DiagramRecord, Form, Layout
from ..codegen.machine import Machine, once, one_at_a_time
from ..codegen.plan import NO_TABLES, program_of
from ..diagram.wiring import Wiring
from ..methods import Method
from ..record.operations import ELEMENTWISE
from ..record.unread import Unread

# components of a long program, and how much shorter one of loops is
MANY, SHORTER = (1500, 3)
# components of a program that LLVM does not optimise: its time grows as their square, and the
# machine code is a third slower at most
UNOPTIMISED = 2000


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

    `sparsity` is the pattern of df/dx, for an implicit method.
    """

    def __init__(self, structure: Structure, form: Form):
        wiring, layout = structure.wiring, structure.layout
        record = DiagramRecord(wiring, layout, form)
        if form.held:
            from .sliding_rates import slide

            slide(record, form.held)
        if form.directions:
            from ..codegen.directional_derivatives import add_derivatives

            add_derivatives(record, form.directions)
        last = wiring.nodes[-1]
        signals = form.copies * last.outputs.stop
        states = form.copies * last.states.stop

        def sparsity() -> Any:
            from .jacobian_pattern import jacobian

            return jacobian(record, states)

        self.program = program_of(record, signals, layout.inputs(wiring.ninputs))
        self.sparsity = cache(sparsity)
        self._machines: dict[tuple[str, int, int], Machine] = {}

    @one_at_a_time
    def addresses(self, names: Sequence[str], lanes: int, order: int = 0) -> list[int]:
        """Return where functions lie, compiled together when first asked for.

        With an order they are those of a run by Taylor series.
        """
        machines = self._machines
        new = (name for name in names if (name, lanes, order) not in machines)
        missing = tuple(dict.fromkeys(new))
        if missing:
            program = self.program
            text = repr((program._replace(tables=NO_TABLES), missing, lanes, order))
            large = len(program.components) > UNOPTIMISED

            def module() -> Any:
                if order:
                    from ..codegen.series_loop import print_series

                    return print_series(program, lanes, order)
                from ..codegen.llvm_text import print_program  # unless it is cached

                return print_program(program, missing, lanes)

            machine = Machine(missing, text, module, large, 0 if large else 3)
            for name in missing:
                machines[name, lanes, order] = machine
        return [machines[name, lanes, order].addresses[name] for name in names]


def code_of(wiring: Wiring, layout: Layout, form: Form) -> Code:
    """Return the code of a diagram, the same for diagrams of one structure.

    An `Uncompiled` error says what cannot be compiled.
    """
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
    if form != PLAIN:
        return Code(structure, form)
    try:
        code = Code(structure, form)
    except Uncompiled:
        return Code(structure, Form("looped"))
    size = len(code.program.components)
    if size <= MANY or SHORTER * _array_operations(structure) >= size:
        return code
    looped = Code(structure, Form("looped"))
    looped_size = len(looped.program.components)
    return looped if SHORTER * looped_size < size else code


def _array_operations(structure: Structure) -> int:
    """Return how many operations the records have, each of which is a loop's component at least."""
    blocks: list[Any] = [node.system for node in structure.wiring.nodes]
    records = [record for block in blocks for record in block.records.values()]
    return sum(
        line.kind in ELEMENTWISE for record in records for line in record.operations
    )


# --- formulas of a method ---------------------------------------------------------------------


@once(16)
def kernels(n: int, lanes: int, method: Method) -> Machine:
    """Return the formulas of a method for n states as machine code."""
    names = method.names

    def module() -> Any:  # unless it is cached
        from ..codegen.llvm_text import print_program
        from ..methods.formulas import program_of_formulas

        program = program_of_formulas(method.formulas(), n)
        return print_program(program, tuple(names), lanes)

    return Machine(names, f"formulas {n} {lanes} {method.name}", module, plain=True)
