"""A diagram's machine code: made once a process for all diagrams of one structure.

Small diagrams are unrolled, so that numbers stay in registers and what is computed
twice is found; larger ones keep their loops.
"""

from functools import lru_cache
from typing import NamedTuple

from numba.core.compiler_lock import global_compiler_lock

from ..blocks import Block
from ..blocks.tracers import TooLong
from ..diagrams.wiring import Wiring
from ..errors import Uncompiled
from . import method
from .flat import flat_program
from .layout import Layout
from .looped import looped_program
from .loops import LEAST
from .machine import Machine
from .printing import LANES
from .program import Item, Loop, Program
from .sources import Sources

UNROLLED = 3_000  # items of a derivative; a larger one keeps its loops
MOST = 30_000  # items of a derivative; a larger one is left to Python


class Structure(NamedTuple):
    """All that machine code depends on; it is given parameters.

    Attributes
    ----------
    records : tuple
        Update, output and guard of each block.
    wires : tuple
        What feeds each block.
    order : tuple
        In which blocks are evaluated, and which pass their inputs on at once.
    pattern : str
        Which parameter fields share a place, and where.
    ninputs : int
        Inputs of the diagram.
    """

    records: tuple
    wires: tuple
    order: tuple
    pattern: str
    ninputs: int


class Code:
    """The program of a structure, and its code once it is asked for.

    Attributes
    ----------
    program : Program
        As printed.
    nstates : int
        Number of states.
    unrolled : bool
        Whether no loop is left.
    """

    def __init__(self, program: Program, nstates: int):
        self.program, self.nstates = program, nstates
        self.unrolled = not any(isinstance(item, Loop) for item in program.derivative)
        self._machines: dict[tuple[str, int], Machine] = {}

    def address(self, name: str, lanes: int) -> int:
        """Return where a function lies, compiled when first asked for."""
        if (name, lanes) not in self._machines:
            self._make(name, lanes)
        return self._machines[name, lanes].addresses[name]

    @global_compiler_lock
    def _make(self, name: str, lanes: int) -> None:
        if (name, lanes) not in self._machines:  # another thread may have been first
            together = ("margin",) if name == "margin" else ("derivative", "prepare", "signals")
            functions = {one: getattr(self.program, one) for one in together}
            made = Machine(functions, self.program.constants, lanes)
            self._machines.update({(one, lanes): made for one in together})


def code_of(wiring: Wiring, layout: Layout, form: str | None = None, least: int = LEAST) -> Code:
    """Return the machine code of a diagram.

    Parameters
    ----------
    wiring : Wiring
        The diagram.
    layout : Layout
        Places of its parameters.
    form : str, optional
        ``"unrolled"`` or ``"looped"``; by size without.
    least : int, optional
        Loops of fewer turns are unrolled.

    Returns
    -------
    Code
        The same for diagrams of one structure.

    Raises
    ------
    Uncompiled
        If a system is no block, or the diagram is too large.
    """
    for node in wiring.nodes:
        if not isinstance(node.system, Block):
            raise Uncompiled(f"{node.name} is no block and cannot be compiled")
    try:
        records = tuple(
            (node.system.update_record, node.system.output_record, node.system.guard_record)
            for node in wiring.nodes
        )
    except TooLong as error:
        raise Uncompiled(str(error)) from None
    wires = tuple((node.states.start, node.outputs.start, node.wires) for node in wiring.nodes)
    order = (wiring.order, tuple(node.system.feedthrough for node in wiring.nodes))
    structure = Structure(records, wires, order, layout.pattern, wiring.ninputs)
    return _code(structure, form, least, _Hidden(Sources(wiring, layout, wiring.ninputs)))


class _Hidden:
    """What makes the code, but does not tell one structure from another."""

    def __init__(self, sources: Sources):
        self.sources = sources

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Hidden)

    def __hash__(self) -> int:
        return 0


@lru_cache(maxsize=64)
@global_compiler_lock  # threads that ask at once are given the same code
@lru_cache(maxsize=64)
def _code(structure: Structure, form: str | None, least: int, hidden: _Hidden) -> Code:
    sources, nodes = hidden.sources, hidden.sources.wiring.nodes
    operations = sum(len(r.operations) for own in structure.records for r in own if r is not None)
    program = None
    if form == "unrolled" or (form is None and operations <= 2 * UNROLLED):
        program = flat_program(sources)
        if form is None and len(program.derivative) > UNROLLED:
            program = None
    if program is None:
        program = looped_program(sources, least)
    size = count(program.derivative)
    if size > MOST:
        raise Uncompiled(
            f"the diagram takes {size} operations apart from loops, more than {MOST}: write what "
            "repeats as `for i in range(n)` with equal turns"
        )
    return Code(program, nodes[-1].states.stop)


def count(items: tuple[Item, ...]) -> int:
    """Return how many items there are, those of loops once."""
    return sum(1 + (count(item.body) if isinstance(item, Loop) else 0) for item in items)


@lru_cache(maxsize=16)
@global_compiler_lock
@lru_cache(maxsize=16)
def kernels(n: int, lanes: int) -> Machine:
    """Return the formulas of the method for n states as machine code."""
    formulas = method.formulas(n)
    return Machine({name: method.kernel(f, n) for name, f in formulas.items()}, (), lanes)


__all__ = ["LANES", "Code", "code_of", "kernels"]
